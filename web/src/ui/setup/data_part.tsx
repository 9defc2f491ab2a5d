import type { VNode } from 'preact';
import type { PlanningKind } from '../../contract/data_types';
import { severalIn, severalOf, ticked } from '../../model/setup/data_choice';
import { chosenAll, ofKind } from '../../model/datasets';
import { draft, edit } from '../../model/setup/draft';
import { formOf } from '../../model/fields';
import { SelectField, type Choice } from './field';
import { Part } from './part';

/** The choice of data. Rare kinds are offered only where the store holds some. */
export function DataPart(): VNode {
  return (
    <Part title="Data">
      <DataField kind="currents" several="members of an ensemble" />
      <DataField kind="tides" several="completing each other" />
      {draft.value.tides !== 'none' && (
        <SelectField name="tides_mode" choices={[{ value: 'add', title: 'added to the currents' }, { value: 'only', title: 'the only currents' }]} />
      )}
      <DataField kind="bathymetry" several="the first has priority" />
      <DataField kind="ice" />
      <DataField kind="icebergs" several="all avoided" />
      <DataField kind="wind" />
      <DataField kind="coastline" />
      <DataField kind="zones" all several="all obeyed" />
    </Part>
  );
}

interface DataFieldProps {
  kind: PlanningKind;
  all?: boolean; // by default all stored datasets count
  several?: string; // what several chosen datasets mean
}

function DataField({ kind, all = false, several }: DataFieldProps): VNode | null {
  const stored: Choice[] = ofKind(kind).map(({ id, name }) => ({ value: id, title: name }));
  const isRare = kind === 'tides' || kind === 'wind' || kind === 'zones';
  if (isRare && stored.length === 0) return null;
  const usual = usualOf(kind, stored, all);
  const none = { value: 'none', title: 'None' };
  if (!several || stored.length < 2) return <SelectField name={kind} choices={[usual, ...stored, none]} />;
  const isSeveral = severalIn(draft.value[kind]) !== undefined;
  // A new choice of several begins with the datasets that were in use.
  const begin = severalOf(chosenAll(kind).slice(0, kind === 'icebergs' ? undefined : 1).map(({ id }) => id));
  const choices = [usual, ...stored, { value: isSeveral ? draft.value[kind] : begin, title: `Several: ${several}` }, none];
  return (
    <>
      <SelectField name={kind} choices={choices} />
      {isSeveral && <Ticks kind={kind} stored={stored} />}
    </>
  );
}

/** The default choice, with its word in the request. */
function usualOf(kind: PlanningKind, stored: Choice[], all: boolean): Choice {
  if (all) return { value: 'all', title: stored.length === 1 ? 'The stored one' : `All ${stored.length} stored` };
  const [first] = stored;
  if (!first) return { value: 'newest', title: 'Newest (none stored)' };
  if (kind === 'bathymetry' && stored.length > 1) return { value: 'newest', title: `Finest at each place (${stored.length} stored)` };
  const isJoined = kind === 'icebergs' && stored.length > 1;
  return { value: 'newest', title: isJoined ? `Newest of each berg (${stored.length} stored)` : `Newest (${first.title})` };
}

/** The stored datasets of a kind with boxes to tick. A number shows the priority of each. */
function Ticks({ kind, stored }: { kind: PlanningKind; stored: Choice[] }): VNode {
  const choice = draft.value[kind];
  const ids = severalIn(choice) ?? [];
  return (
    <fieldset class="ticks">
      <legend class="visually-hidden">{formOf(kind).label} used together</legend>
      {stored.map(({ value, title }) => {
        const rank = ids.indexOf(value);
        return (
          <label class="check" key={value}>
            <input type="checkbox" checked={rank >= 0} onChange={(event) => edit({ [kind]: ticked(choice, value, event.currentTarget.checked) })} />
            <span class="tick-title">{title}</span>
            {rank >= 0 && <span class="count" title="Rank">{rank + 1}</span>}
          </label>
        );
      })}
    </fieldset>
  );
}
