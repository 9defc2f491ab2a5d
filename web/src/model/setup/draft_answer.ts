import type { Position } from '../../contract/data_types';
import type { Change, Violation } from '../../contract/types';
import { exactPosition } from '../../geo/coordinates';
import { emptyDraft, hasGoalsFile, type Draft, type Faults, type Field } from './draft';
import { factorOf, numberFields, timeFields, type NumberField } from '../fields';
import { inPageWords } from '../page_words';
import { fieldOf, isoOf } from '../time';

const fieldNames = Object.keys(emptyDraft) as Field[];
const aliases: Record<string, Field> = { departure: 'depart', start: 'from', goal: 'to', iceberg_margin: 'margin_m', uncertainty: 'uncertainty.members' };

/** The field that a JSON pointer, or the name of an input, belongs to. */
function fieldAt(pointer: string): Field | undefined {
  const words = pointer.split('/').filter((word) => word !== '' && word !== 'inputs');
  const [outer = '', inner = ''] = words;
  return fieldNames.find((name) => name === `${outer}.${inner}`) ?? fieldNames.find((name) => name === outer) ?? aliases[outer];
}

/** Puts the server's violations beside the fields their JSON pointers name. */
export function sortViolations(violations: Violation[]): { faults: Faults; general: string[] } {
  const sorted: Faults = {};
  const general: string[] = [];
  for (const { pointer, detail } of violations) {
    const field = fieldAt(pointer);
    const said = inPageWords(detail);
    const text = said.charAt(0).toUpperCase() + said.slice(1);
    const word = pointer.replace(/^\/?(inputs\/)?/, '');
    if (field) sorted[field] = sorted[field] ? `${sorted[field].replace(/\.$/, '')}. ${text}` : text;
    else general.push(word ? `${word}: ${text}` : text);
  }
  return { faults: sorted, general };
}

/** A change that the server proposes, with those that belong to it, as an edit of the set-up; undefined where the set-up has no field for one. */
export function editFor(change: Change, form: Draft): Partial<Draft> | undefined {
  return [...(change.with ?? []), change].reduce<Partial<Draft> | undefined>((made, one) => {
    const more = made && editOfOne(one, { ...form, ...made });
    return more && { ...made, ...more };
  }, {});
}

function editOfOne({ input, to }: Change, form: Draft): Partial<Draft> | undefined {
  const field = fieldAt(input);
  if (!field) return undefined;
  const isInFile = hasGoalsFile(form) && (field === 'to' || field === 'via' || (field === 'from' && form.from.trim() === ''));
  if (isInFile) return undefined;
  if (field === 'via') return viaEdit(input, to, form);
  if (field === 'spacing_m') return spacingEdit(to);
  if (field === 'areas') return areasEdit(input, form);
  if (isPosition(to)) return { [field]: exactPosition(to, textIn(field, form)) };
  if (typeof to === 'number') return isNumber(field) ? { [field]: String(Number((to / factorOf(field)).toPrecision(8))) } : undefined;
  if (typeof to === 'boolean' && typeof emptyDraft[field] === 'boolean') return { [field]: to };
  if (typeof to !== 'string' || typeof emptyDraft[field] !== 'string') return undefined;
  const time_ms = (timeFields as readonly Field[]).includes(field) ? Date.parse(to) : undefined;
  return { [field]: time_ms === undefined ? to : time_ms % 60_000 === 0 ? fieldOf(time_ms) : isoOf(time_ms) };
}

function viaEdit(input: string, to: unknown, form: Draft): Partial<Draft> | undefined {
  const lines = form.via.split('\n').filter((line) => line.trim() !== '');
  const index = Number(input.split('/')[1]);
  if (!isPosition(to) || !(index in lines)) return undefined;
  return { via: lines.map((line, i) => (i === index ? exactPosition(to, line) : line)).join('\n') };
}

/** The areas without the one that the input names, or none if it names them all; undefined if there is no such area. */
function areasEdit(input: string, form: Draft): Partial<Draft> | undefined {
  if (input === 'areas') return { areas: [] };
  const index = Number(input.split('/')[2]);
  return index in form.areas ? { areas: form.areas.filter((_, i) => i !== index) } : undefined;
}

/** The change of the draft for a grid spacing: one number, or two as "along × across". */
function spacingEdit(to: unknown): Partial<Draft> | undefined {
  const spacings = Array.isArray(to) ? to : [to];
  return spacings.every((each) => typeof each === 'number') ? { spacing_m: spacings.join(' × ') } : undefined;
}

const isNumber = (field: Field): field is NumberField => (numberFields as readonly Field[]).includes(field);

const isPosition = (value: unknown): value is Position =>
  Array.isArray(value) && value.length === 2 && value.every((part) => typeof part === 'number');

/** What somebody typed into a field. */
function textIn(field: Field, form: Draft): string {
  const typed = form[field];
  return typeof typed === 'string' ? typed : '';
}
