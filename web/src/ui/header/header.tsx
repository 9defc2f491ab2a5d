import type { VNode } from 'preact';
import type { Dataset } from '../../contract/data_types';
import { projectionCodes, projections, type ProjectionCode } from '../../geo/projections';
import { chosenBathymetry, chosenCoastline, chosenCurrents, chosenSeaIce, connectionFault, datasets, isSynthetic, lastSighted } from '../../model/datasets';
import { locked, signedIn } from '../../model/login';
import { dialog, drawer, leftTab, tell } from '../../model/screen';
import { change, settings } from '../../model/settings';
import { addressOfView } from '../../model/shared_view';
import { age, shortTime } from '../../model/time';
import { Icon, IconButton } from '../common/icon';

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
        <Switch label="Distances" now={now.distance} choices={[['km', 'km'], ['nm', 'NM']]} choose={(distance) => change({ distance })} />
        <Switch label="Speeds" now={now.speed} choices={[['m/s', 'm/s'], ['kn', 'kn']]} choose={(speed) => change({ speed })} />
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

/** Shown if the clipboard cannot be used: the link is copied from the address bar. */
async function copyLink(): Promise<void> {
  try {
    await navigator.clipboard.writeText(addressOfView());
    tell('The link to this view was copied.');
  } catch {
    tell('The address bar holds the link to this view; copy it from there.');
  }
}

function Switch<T extends string>({ label, now, choices, choose }: { label: string; now: T; choices: [T, string][]; choose: (value: T) => void }): VNode {
  return (
    <div class="switch" role="group" aria-label={label}>
      {choices.map(([value, title]) => (
        <button type="button" key={value} aria-pressed={now === value} onClick={() => choose(value)}>{title}</button>
      ))}
    </div>
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

function spanOf({ time_start, time_end }: Dataset): string | undefined {
  if (!time_start || !time_end) return undefined;
  return time_start === time_end ? hourOf(time_start) : `${hourOf(time_start)} – ${hourOf(time_end)}`;
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
