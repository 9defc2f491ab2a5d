import type { Position } from '../../contract/data_types';
import type { PlanInputs } from '../../contract/types';
import { formatPosition } from '../../geo/coordinates';
import { vehicles } from '../datasets';
import { factorOf, formOf, isField, numberFields, timeFields, usualValue, type NumberField } from '../fields';
import { settings } from '../settings';
import { shortTime } from '../time';
import { none } from '../units';

/** A setting in which plans differ: its name in the set-up, and what each plan was made with. */
export interface SettingRow {
  name: string;
  label: string;
  values: string[]; // one for each request, in their order
}

/** Settings that the comparison shows elsewhere, or that have no effect on the route. */
const leftOut = new Set(['name', 'remarks', 'vehicle', 'profile', 'depart', 'depart_until', 'depart_step', 'alternatives', 'currents', 'ice', 'icebergs']);

/**
 * The name of a member of an object in the table of request fields: both names with a dot. The table names the common
 * figures of the vehicle without it.
 */
function nameOf(object: string, member: string): string {
  const name = `${object}.${member}`;
  return object === 'vehicle' && !isField(name) ? member : name;
}

/** The members of a request by their names in the table of request fields. */
function flat(inputs: PlanInputs): Map<string, unknown> {
  const members = new Map<string, unknown>();
  for (const [name, value] of Object.entries(inputs)) {
    const isGroup = typeof value === 'object' && value !== null && !Array.isArray(value) && name !== 'areas' && name !== 'goals_file';
    const inner = isGroup ? Object.entries(value as object) : [];
    if (inner.length === 0) members.set(name, value);
    for (const [member, of] of inner) members.set(nameOf(name, member), of);
  }
  return members;
}

const isNumberField = (name: string): name is NumberField => (numberFields as readonly string[]).includes(name);

/** A value in the words and the unit of the form. If the request leaves it out, the value that the server uses. */
function shown(name: string, value: unknown): string {
  const { unit, placeholder } = formOf(name);
  const hasUnit = unit !== undefined && !/\d/.test(unit); // some units state the range beside the field
  const withUnit = (text: string): string => (hasUnit && /^[\d.]/.test(text) ? `${text} ${unit}` : text);
  if (value === undefined || value === null) return placeholder ? withUnit(placeholder) : none;
  if (typeof value === 'boolean') return value ? 'yes' : 'no';
  if (typeof value === 'number') return withUnit(String(Number((value / (isNumberField(name) ? factorOf(name) : 1)).toPrecision(8))));
  if (typeof value === 'string') return (timeFields as readonly string[]).includes(name) ? shortTime(Date.parse(value)) : value;
  if (isPosition(name, value)) return formatPosition(value, settings.value.coordinates);
  if (Array.isArray(value)) return value.every((each) => typeof each !== 'object') ? value.join(' × ') : String(value.length);
  const { features, name: called } = value as { features?: unknown[]; name?: string };
  return features ? String(features.length) : (called ?? 'given');
}

const isPosition = (name: string, value: unknown): value is Position => (name === 'from' || name === 'to') && Array.isArray(value);

/** Settings without a label in the table of request fields. */
const own: Record<string, string> = { areas: 'Areas', goals_file: 'File with the goals' };

const isEmpty = (value: unknown): boolean =>
  value === undefined || value === null || value === '' || (typeof value === 'object' && Object.keys(value).length === 0);

/** The vehicle of a request, whose own figures count where the request states none. The server takes the first of its list. */
function vehicleOf({ vehicle }: PlanInputs): Partial<Record<string, unknown>> {
  const profile = typeof vehicle === 'string' ? vehicle : vehicle?.profile;
  return { ...(vehicles.value.find(({ name }) => name === profile) ?? (profile ? {} : vehicles.value[0])) };
}

/** What a plan was made with: a field that its request leaves out has the usual value of the table, or the vehicle's. */
function effective(name: string, value: unknown, request: PlanInputs): unknown {
  if (!isEmpty(value)) return value;
  return usualValue(name) ?? vehicleOf(request)[name.replace('vehicle.', '')];
}

/** One row for each setting that is not the same in all requests. */
export function settingRows(requests: PlanInputs[]): SettingRow[] {
  const all = requests.map(flat);
  const names = [...new Set(all.flatMap((members) => [...members.keys()]))].filter((name) => !leftOut.has(name));
  return names.flatMap((name) => {
    const values = all.map((members, i) => effective(name, members.get(name), requests[i] ?? {}));
    if (new Set(values.map((value) => JSON.stringify(value ?? null))).size < 2) return [];
    const texts = values.map((value) => shown(name, value));
    return [{ name, label: formOf(name).label || own[name] || name, values: texts }];
  });
}
