import type { VNode } from 'preact';
import type { Dataset } from '../../contract/data_types';
import { projectionCodes, projections, type ProjectionCode } from '../../geo/projections';
import { chosenBathymetry, chosenCoastline, chosenCurrents, chosenSeaIce, connectionFault, datasets, isSynthetic, lastSighted } from '../../model/datasets';
import { locked, signedIn } from '../../model/login';
import { dialog, drawer, leftTab } from '../../model/screen';
import { change, settings } from '../../model/settings';
import { age, shortTime } from '../../model/time';
import { copyLink } from '../common/copy_link';
import { Icon, IconButton } from '../common/icon';
import { UnitSwitches } from '../common/unit_switches';

/** The bar at the top: data in use, projection, units. */
export function Header(): VNode {
  const now = settings.value;
  return (
    <header class="bar">
      <IconButton icon="settings" label="Set-up and plans" class="only-narrow" onClick={() => { drawer.value = drawer.value === 'left' ? undefined : 'left'; }} />
      <h1>Floeplan</h1>
      <DataBar />
      <div class="bar-controls">
        <label>
          <span class="visually-hidden">Projection</span>
          <select value={now.projection} onChange={(event) => change({ projection: event.currentTarget.value as ProjectionCode })}>
            {projectionCodes.map((code) => <option key={code} value={code}>{code.slice(5)}: {projections[code].title}</option>)}
          </select>
        </label>
        <UnitSwitches />
        <IconButton icon="share" label="Copy a link to this view" class="only-wide" onClick={() => void copyLink()} />
        <IconButton icon="list" label="Jobs" class="only-wide" onClick={() => { dialog.value = 'jobs'; }} />
        <ThemeButton />
        <AccountButton />
        <IconButton icon="help" label="Help and settings (?)" onClick={() => { dialog.value = 'help'; }} />
      </div>
      <IconButton icon="list" label="Waypoints" class="only-narrow" onClick={() => { drawer.value = drawer.value === 'right' ? undefined : 'right'; }} />
    </header>
  );
}

function ThemeButton(): VNode {
  const isDark = document.documentElement.dataset['theme'] === 'dark';
  const wanted = settings.value.theme === 'system' ? (isDark ? 'light' : 'dark') : settings.value.theme === 'dark' ? 'light' : 'dark';
  return <IconButton icon={wanted === 'dark' ? 'moon' : 'sun'} label={`Use the ${wanted} theme`} onClick={() => change({ theme: wanted })} />;
}

/** The user who is signed in; empty if no login is needed. */
function AccountButton(): VNode | null {
  const who = signedIn.value;
  if (!who && !locked.value) return null;
  const label = who && !locked.value ? `Signed in as ${who.name}, ${who.role}` : 'Sign in';
  return (
    <button type="button" class="account" aria-label={label} title={label} onClick={() => { dialog.value = 'login'; }}>
      <Icon name="user" /> <span>{who && !locked.value ? <><b>{who.name}</b><small>{who.role}</small></> : 'Sign in'}</span>
    </button>
  );
}

function openData(): void {
  leftTab.value = 'data';
  drawer.value = 'left';
}

/** The data in use with names and times; the panel on the left shows them all. */
function DataBar(): VNode {
  const currents = chosenCurrents.value;
  const ice = chosenSeaIce.value;
  const bergs = lastSighted.value;
  return (
    <div class="data-bar">
      <button type="button" class="data-button" onClick={openData} title="All data in the store">
        <Icon name="database" />
        {datasets.value === undefined ? (
          <span>{locked.value ? 'Not signed in' : connectionFault.value ? 'No connection' : 'Reading the store …'}</span>
        ) : datasets.value.length === 0 ? (
          <span>No data in the store</span>
        ) : (
          <>
            <Item title="Currents" dataset={currents} detail={currents && spanOf(currents)} />
            <Item title="Sea ice" dataset={ice} detail={ice && spanOf(ice)} />
            <Item title="Icebergs" dataset={bergs} detail={bergs?.time_end ? sightedAt(bergs.time_end) : undefined} />
            <Item title="Depths" dataset={chosenBathymetry.value} />
            <Item title="Coast" dataset={chosenCoastline.value} />
          </>
        )}
      </button>
      {isSynthetic.value && <span class="synthetic" title="The data in use call themselves synthetic: not for navigation">Synthetic data</span>}
    </div>
  );
}

const hourOf = (time: string): string => shortTime(Date.parse(time)).replace(':00Z', 'Z');

/** The first and last time of a dataset; "22–28 Nov 00Z" where they differ in the day alone. */
function spanOf({ time_start, time_end }: Dataset): string | undefined {
  if (!time_start || !time_end) return undefined;
  const [first, last] = [hourOf(time_start), hourOf(time_end)];
  if (first === last) return first;
  const [day = '', ...rest] = first.split(' ');
  return last.endsWith(` ${rest.join(' ')}`) ? `${day}–${last}` : `${first} – ${last}`;
}

/**
 * The age and the time of the newest sighting, or only its time if that is in the future; the age comes first, because
 * it stays visible if there is little room.
 */
function sightedAt(time: string): string {
  const age_s = (Date.now() - Date.parse(time)) / 1000;
  return age_s > 0 ? `${age(age_s)}, ${hourOf(time)}` : `to ${hourOf(time)}`;
}

function Item({ title, dataset, detail }: { title: string; dataset: Dataset | undefined; detail?: string | undefined }): VNode {
  return (
    <span class={dataset ? 'data-item' : 'data-item missing'} title={dataset?.name}>
      <span class="data-head"><b>{title}</b> {dataset ? detail : 'none'}</span>
      <span class="data-name">{dataset ? dataset.name : 'add a file'}</span>
    </span>
  );
}
