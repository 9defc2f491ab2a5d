import type { VNode } from 'preact';
import type { DatasetKind } from '../../api/types';
import { ofKind } from '../../model/datasets';
import { draft } from '../../model/draft';
import { SelectField, type Choice } from './field';
import { Part } from './part';

/** Which data are used. Kinds that few stores hold are offered where there are any. */
export function DataPart(): VNode {
  return (
    <Part title="Data" fields={['currents', 'tides', 'bathymetry', 'ice', 'icebergs', 'wind', 'coastline', 'zones']}>
      <DataField kind="currents" label="Currents" />
      <DataField kind="tides" label="Tidal currents" />
      {draft.value.tides !== 'none' && (
        <SelectField name="tides_mode" label="Tides are" choices={[{ value: 'add', title: 'added to the currents' }, { value: 'only', title: 'the only currents' }]} />
      )}
      <DataField kind="bathymetry" label="Depths" />
      <DataField kind="ice" label="Sea ice" />
      <DataField kind="icebergs" label="Icebergs" />
      <DataField kind="wind" label="Wind on icebergs" />
      <DataField kind="coastline" label="Coastline" />
      <DataField kind="zones" label="Zones" all />
    </Part>
  );
}

function DataField({ kind, label, all = false }: { kind: DatasetKind; label: string; all?: boolean }): VNode | null {
  const stored: Choice[] = ofKind(kind).map(({ id, name }) => ({ value: id, title: name }));
  const isRare = kind === 'tides' || kind === 'wind' || kind === 'zones';
  if (isRare && stored.length === 0) return null;
  const usual: Choice = all
    ? { value: 'all', title: stored.length === 1 ? 'The stored one' : `All ${stored.length} stored` }
    : { value: 'newest', title: stored[0] ? `Newest (${stored[0].title})` : 'Newest (none stored)' };
  return <SelectField name={kind} label={label} choices={[usual, ...stored, { value: 'none', title: 'None' }]} />;
}
