import { namesOfConditions, namesOfReach, requestFields } from '../contract/request_fields';

type Told = typeof requestFields;

/** The fields of a request with this type of value that are shown in the set-up, which are those with a label. */
type NameOf<Kind extends string> = { [Name in keyof Told]: Told[Name] extends { kind: Kind; label: string } ? Name : never }[keyof Told];
export type NumberField = NameOf<'number' | 'whole_number'>;
export type CheckField = NameOf<'boolean'>;
export type TimeField = NameOf<'time'>;

interface Telling {
  kind: string;
  usual?: number | string | boolean;
  flag?: string;
  group?: string; // the part of the set-up with the field
  label?: string;
  unit?: string;
  factor?: number; // the number of units of the request in one unit of the form
  blank?: string; // what an empty field means
  hint?: string;
}
const fields: Record<string, Telling> = requestFields;

function namesOf(...kinds: string[]): string[] {
  return Object.keys(fields).filter((name) => kinds.includes(fields[name]?.kind ?? '') && fields[name]?.label);
}
export const numberFields = namesOf('number', 'whole_number') as NumberField[];
export const checkFields = namesOf('boolean') as CheckField[];
export const timeFields = namesOf('time') as TimeField[];

/** The number of units of the request in one unit of the form. */
export const factorOf = (name: NumberField): number => fields[name]?.factor ?? 1;

/** Whether the table of request fields has the name. */
export const isField = (name: string): boolean => name in fields;

/** The value that the server uses if a request leaves the field out. Fields of the vehicle have the value of its profile. */
export const usualValue = (name: string): number | string | boolean | undefined => fields[name]?.usual;

/** Whether a switch is on by default. */
export const isUsual = (name: CheckField): boolean => fields[name]?.usual === true;

export interface FormTexts {
  label: string;
  unit?: string;
  placeholder?: string;
  hint?: string;
  inputMode: 'text' | 'decimal' | 'numeric';
}

/** The presentation of a field in a form: its label, unit and hint. The placeholder says what an empty input means. */
export function formOf(name: string): FormTexts {
  const { kind, usual, label = '', unit, factor = 1, blank, hint } = fields[name] ?? { kind: 'text' };
  const usualText = typeof usual === 'number' ? String(Number((usual / factor).toPrecision(12))) : undefined;
  const inputMode = kind === 'number' ? 'decimal' : kind === 'whole_number' ? 'numeric' : 'text';
  return { label, unit, placeholder: blank ?? usualText, hint, inputMode };
}

/** The fields of a part of the set-up. */
export const namesInGroup = (group: string): string[] => Object.keys(fields).filter((name) => fields[name]?.group === group);

/** Labels of the fields that flags of the command line ask for. A flag that turns something off has none. */
export const labelsOfFlags: Record<string, string> = Object.fromEntries(
  Object.values(fields).flatMap(({ flag, label }) => (flag && label && !flag.startsWith('no-') ? [[`--${flag}`, label]] : [])),
);

const ofConditions = new Set<string>(namesOfConditions.map((name) => name.split('.')[0] ?? ''));
const ofReach = new Set<string>(namesOfReach);

/** Whether a field of a request for a plan is also a field of a request that evaluates a route. */
export const isCondition = (name: string): boolean => ofConditions.has(name) && name !== 'name';

/** Whether a request for isochrones has the field. */
export const isOfReach = (name: string): boolean => ofReach.has(name);
