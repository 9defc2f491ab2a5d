import { computed, signal } from '@preact/signals';
import type { Position } from '../../contract/data_types';
import { placesIn } from '../setup/draft';
import { selectedId, waypointLabel } from './plans';
import { remember } from '../undo';
import { exportLabels } from './export_labels';

/** The mission files that the user has chosen. */
export type FileSet = 'lists' | 'full' | 'seaglider';

/** The options of the mission files, as texts of the form. For an empty one the server's default is used. */
export interface ExportOptions {
  set: FileSet;
  number: string;
  mission: string;
  firmware: string;
  glider: string;
  safe: string; // one place on each line
  iceberg_depth_m: string;
  science: string; // bands between semicolons
}

export const usualExport: ExportOptions = { set: 'lists', number: '10', mission: '', firmware: '', glider: '', safe: '', iceberg_depth_m: '', science: '' };

/** The options of the plan whose export was opened last. They are kept here because the dialog closes while a place is picked on the map. */
export const exportOptions = signal<{ plan_id: string; options: ExportOptions }>({ plan_id: '', options: usualExport });

export const exportOptionsOf = (plan_id: string): ExportOptions => (exportOptions.value.plan_id === plan_id ? exportOptions.value.options : usualExport);

/** The safe places that are typed or picked so far for a plan. */
export function safePlacesOf(plan_id: string): Position[] {
  const { set, safe } = exportOptionsOf(plan_id);
  return set === 'full' ? placesIn(safe).places : [];
}

/** Those of the selected plan, for the map. */
export const safePlaces = computed<Position[]>(() => (selectedId.value === undefined ? [] : safePlacesOf(selectedId.value)));

/** Adds a safe place to those of the export under way. */
export function addSafePlace(place: string): void {
  const before = exportOptions.peek();
  const { plan_id, options } = before;
  const after = { plan_id, options: { ...options, safe: [...options.safe.split('\n').filter((line) => line.trim() !== ''), place].join('\n') } };
  const put = (wanted: typeof before): void => {
    exportOptions.value = wanted;
  };
  put(after);
  remember({ title: 'picking a safe place', back: () => put(before), again: () => put(after) });
}

/** The labels of the fields that a refusal may name, by the server's names. */
const labels: Partial<Record<string, string>> = {
  ...exportLabels,
  under_ice: 'A full mission for work under ice', format: exportLabels.set, plan_id: 'This plan', waypoints: 'Waypoints', dive_depth_m: 'The dive depth of the vehicle',
};

/** “Safe place 2” for safe/1, “Waypoint 4” for waypoints/4, else the label of the field. */
export function exportLabelOf(place: string): string {
  const [name = '', index] = place.split('/');
  if (index !== undefined && name === 'safe') return `Safe place ${Number(index) + 1}`;
  if (index !== undefined && name === 'waypoints') return `Waypoint ${waypointLabel(Number(index))}`;
  if (index !== undefined && name === 'science') return `Science band ${Number(index) + 1}`;
  return labels[name] ?? place;
}

/** Larger numbers are reserved for the vehicle's firmware. */
export const lastList = 97;

export type ExportQuery = Record<string, string | number | boolean | undefined>;

export interface ExportWish {
  query: ExportQuery; // options that change the text of the files
  folder: ExportQuery; // further options of the archive
  faults: Partial<Record<keyof ExportOptions, string>>;
}

/** "lon,lat;lon,lat", to a decimetre. */
export const pairs = (places: Position[]): string => places.map(([lon, lat]) => `${lon.toFixed(6)},${lat.toFixed(6)}`).join(';');

const stated = (text: string): string | undefined => (text.trim() === '' ? undefined : text.trim());

/** The query parameters that the chosen files use. The server refuses wrong values. */
export function exportWish({ set, number, mission, firmware, glider, safe, iceberg_depth_m, science }: ExportOptions): ExportWish {
  const faults: ExportWish['faults'] = {};
  const folder = { glider: stated(glider) };
  if (set === 'seaglider') return { query: { format: 'seaglider', science: stated(science) }, folder, faults };

  const first = Number(number);
  if (number.trim() === '' || !Number.isInteger(first) || first < 0 || first > lastList) faults.number = `must be a whole number from 0 to ${lastList}`;
  if (set === 'lists') return { query: { number: first }, folder, faults };

  const { places, fault } = placesIn(safe);
  if (fault !== undefined) faults.safe = fault;
  const depth_m = stated(iceberg_depth_m);
  if (depth_m !== undefined && !(Number(depth_m) > 0)) faults.iceberg_depth_m = 'must be a depth in metres';
  if (depth_m !== undefined && places.length === 0) faults.iceberg_depth_m = 'is for work under ice, which needs safe places too';
  const safePlaces = places.length > 0 ? pairs(places) : undefined;
  return { query: { number: first, full: true, mission: stated(mission), firmware: stated(firmware), safe: safePlaces, iceberg_depth_m: depth_m }, folder, faults };
}
