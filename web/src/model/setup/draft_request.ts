import type { Position } from '../../contract/data_types';
import type { PlanInputs } from '../../contract/types';
import { readPosition } from '../position';
import { whyNoAlternatives } from '../plan/alternatives';
import { areasInputs, faultOfAreas } from '../area';
import { choiceInputs, severalIn } from './data_choice';
import { emptyDraft, hasGoalsFile, isEnsemble, numberIn, placesIn, type Draft, type Faults, type Field } from './draft';
import { checkFields, factorOf, numberFields, timeFields } from '../fields';
import { isoOf, parseTime } from '../time';

/** Fields that are sent only if they differ from the server's default. */
const sentWhenChanged: Field[] = ['via_order', 'objective', 'thruster', 'wind', ...checkFields.filter((name) => name !== 'refine' && name !== 'steady')];

/** Fields in which several datasets may be named. */
const severalFields = ['currents', 'tides', 'bathymetry', 'icebergs', 'zones'] as const;

/** The request of a draft, or all faults that prevent it. */
export function inputsOf(form: Draft): { inputs: PlanInputs } | { faults: Faults } {
  const found: Faults = {};
  const places = placesOf(form, found);
  const areaFault = faultOfAreas(form.areas);
  if (areaFault) found.areas = areaFault;

  const values: Partial<Record<Field, number | string | boolean>> = {};
  for (const field of timeFields) {
    if (form[field].trim() === '' || isLeftOut(field, form)) continue;
    const time_ms = parseTime(form[field]);
    if (time_ms === undefined) found[field] = 'Write the time in UTC as 2026-11-20 06:00.';
    else values[field] = isoOf(time_ms);
  }
  if (form.depart.trim() === '' && form.arrive_by.trim() === '') found.depart = 'Write the time in UTC as 2026-11-20 06:00.';

  for (const field of numberFields) {
    if (form[field].trim() === '' || isLeftOut(field, form)) continue;
    const value = numberIn(form[field]);
    if (value === undefined) found[field] = 'Write a number.';
    else values[field] = Number((value * factorOf(field)).toPrecision(12));
  }
  const spacing_m = spacingIn(form.spacing_m);
  if (spacing_m === null) found.spacing_m = 'Write a distance, or two: along × across.';
  if (form.depart_until.trim() !== '') {
    const step_h = numberIn(form.depart_step);
    if (step_h === undefined || step_h <= 0) found.depart_step = 'Write a number of hours.';
    else values.depart_step = `PT${Math.round(60 * step_h)}M`;
  }
  if (form.tides !== 'none') values.tides_mode = form.tides_mode;
  for (const field of sentWhenChanged) {
    const isPlain = !(field === 'objective' && form.objective === 'both');
    if (isPlain && form[field] !== emptyDraft[field]) values[field] = form[field] as string | boolean;
  }
  const aim = form['uncertainty.objective'];
  if (aim !== 'first' && !isLeftOut('uncertainty.objective', form)) values['uncertainty.objective'] = aim;
  for (const field of severalFields) {
    if (severalIn(form[field])?.length === 0) found[field] = 'Tick one dataset or more.';
  }
  const aims = form['uncertainty.objective'] !== 'first' || form['uncertainty.arrive_before'].trim() !== '';
  if (aims && !isEnsemble(form) && form['uncertainty.members'].trim() === '') found['uncertainty.members'] = 'Write how many members the plan is judged in, such as 16.';
  if (!places || spacing_m === null || Object.keys(found).length > 0) return { faults: found };

  const { vehicle, ...others } = nested(values);
  return {
    inputs: {
      ...places,
      ...(vehicle ? { vehicle: { ...vehicle, ...(form.vehicle ? { profile: form.vehicle } : {}) } } : form.vehicle ? { vehicle: form.vehicle } : {}),
      ...(form.name.trim() ? { name: form.name.trim() } : {}),
      ...others,
      ...(spacing_m === undefined ? {} : { spacing_m }),
      ...(form.areas.length > 0 ? { areas: areasInputs(form.areas) } : {}),
      method: form.method,
      refine: form.refine,
      steady: form.steady,
      ...dataInputs(form),
    },
  };
}

/** Start, goal and via points, typed or from a file. Where one cannot be read: undefined, and the faults are noted. */
function placesOf(form: Draft, found: Faults): Pick<PlanInputs, 'from' | 'to' | 'via' | 'goals_file' | 'route_name'> | undefined {
  const isFromFile = hasGoalsFile(form);
  const from = readPosition(form.from);
  const startsInFile = isFromFile && form.from.trim() === '';
  if (!from.ok && !startsInFile) found.from = from.fault;
  const start = from.ok ? { from: rounded(from.value) } : {};
  if (isFromFile) {
    const chosen = form.route_name.trim() === '' ? {} : { route_name: form.route_name.trim() };
    return from.ok || startsInFile ? { ...start, goals_file: form.goals_file, ...chosen } : undefined;
  }

  const to = readPosition(form.to);
  if (!to.ok) found.to = to.fault;
  const via = placesIn(form.via);
  if (via.fault) found.via = via.fault;
  if (!from.ok || !to.ok) return undefined;
  return { ...start, to: rounded(to.value), ...(via.places.length > 0 ? { via: via.places.map(rounded) } : {}) };
}

/** Whether a field has no effect on the request. */
function isLeftOut(field: Field, form: Draft): boolean {
  if (field === 'alternatives') return whyNoAlternatives(form) !== undefined;
  if (field.startsWith('objective.')) return form.objective !== 'both';
  if (!field.startsWith('uncertainty.')) return false;
  const isAim = field === 'uncertainty.objective' || field === 'uncertainty.quantile' || field === 'uncertainty.arrive_before';
  if (field === 'uncertainty.quantile' && form['uncertainty.objective'] !== 'quantile') return true;
  return isEnsemble(form) ? !isAim : form['uncertainty.members'].trim() === '';
}

/** The choices of data. Rare kinds are stated only where they were chosen. */
function dataInputs(form: Draft): Partial<PlanInputs> {
  return {
    currents: choiceInputs(form.currents),
    bathymetry: choiceInputs(form.bathymetry),
    icebergs: choiceInputs(form.icebergs),
    ice: form.ice,
    coastline: form.coastline,
    ...(form.tides === emptyDraft.tides ? {} : { tides: choiceInputs(form.tides) }),
    ...(form.zones === emptyDraft.zones ? {} : { zones: choiceInputs(form.zones) }),
  };
}

/** A distance, or two with × between them; undefined where the field is empty, null where it cannot be read. */
function spacingIn(text: string): PlanInputs['spacing_m'] | null {
  if (text.trim() === '') return undefined;
  const [along, across, ...rest] = text.split(/[x×]/).map(numberIn);
  if (along === undefined || rest.length > 0) return null;
  if (!/[x×]/.test(text)) return along;
  return across === undefined ? null : [along, across];
}

/** Puts fields with a dot in their name into the objects that they belong to. */
function nested(values: Partial<Record<Field, number | string | boolean>>): Record<string, unknown> {
  const inputs: Record<string, unknown> = {};
  for (const [field, value] of Object.entries(values)) {
    const [outer = '', inner] = field.split('.');
    inputs[outer] = inner === undefined ? value : { ...(inputs[outer] as object | undefined), [inner]: value };
  }
  return inputs;
}

/** Rounds to seven decimals, a centimetre. */
function rounded([lon, lat]: Position): Position {
  return [Math.round(lon * 1e7) / 1e7, Math.round(lat * 1e7) / 1e7];
}
