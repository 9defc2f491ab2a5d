import type { AreaProperties, Areas, Position } from '../contract/data_types';
import { editablePosition } from '../geo/coordinates';
import { readPosition } from './position';
import { fieldOf, isoOf, parseTime } from './time';

/** An area to keep out of or to stay in, as a person types it. The first corner is not repeated at the end. */
export interface Area {
  kind: AreaProperties['kind'];
  name: string;
  corners: Position[];
  from: string;
  until: string;
  top_m?: string; // empty: from the surface
  bottom_m?: string; // empty: to the sea bed
}

/** An area as the server states it. */
interface StatedArea {
  geometry: { coordinates: Position[][] };
  properties: Pick<AreaProperties, 'kind'> & { [Name in Exclude<keyof AreaProperties, 'kind'>]?: AreaProperties[Name] | null };
}

/** A stated area as a form shows it, without its holes. */
export function areaOf({ geometry, properties }: StatedArea): Area {
  const { bottom_m, from, kind, name, top_m, until } = properties;
  const time = (text: string | null | undefined): string => (text ? fieldOf(Date.parse(text)) : '');
  return {
    kind, name: name ?? '', corners: (geometry.coordinates[0] ?? []).slice(0, -1), from: time(from), until: time(until),
    ...(top_m ? { top_m: String(top_m) } : {}), ...(typeof bottom_m === 'number' ? { bottom_m: String(bottom_m) } : {}),
  };
}

const inWords = ({ kind, name, corners, from, until, top_m = '', bottom_m = '' }: Area): string =>
  [kind, name, cornersText(corners), from, until, top_m, bottom_m].join('\n');

/** Whether two areas are equal in every field, with the accuracy of their corners as text. */
export const isSameArea = (a: Area, b: Area): boolean => inWords(a) === inWords(b);

export const newArea = (corners: Position[], number: number): Area => ({
  kind: 'no_go', name: `Area ${number}`, corners, from: '', until: '',
});

/** Writes corners as text, one on each line, and reads them back. */
export const cornersText = (corners: Position[]): string => corners.map(editablePosition).join('\n');

export function cornersIn(text: string): { corners: Position[] } | { fault: string } {
  const corners: Position[] = [];
  const lines = text.split('\n').filter((line) => line.trim() !== '');
  for (const [i, line] of lines.entries()) {
    const parsed = readPosition(line);
    if (!parsed.ok) return { fault: `Line ${i + 1}: ${parsed.fault}` };
    corners.push(parsed.value);
  }
  return corners.length < 3 ? { fault: 'An area needs three corners or more.' } : { corners };
}

/** Faults of the times or depths of areas, in sentences that name the area. */
export function faultOfAreas(areas: Area[]): string | undefined {
  const faulty = areas.find(({ from, until }) => [from, until].some((text) => text.trim() !== '' && parseTime(text) === undefined));
  if (faulty) return `${faulty.name}: write its times in UTC as 2026-11-20 06:00.`;
  const deep = areas.find(({ top_m = '', bottom_m = '' }) => [top_m, bottom_m].some((text) => !Number.isFinite(depthIn(text))));
  return deep && `${deep.name}: write its depths in metres.`;
}

const depthIn = (text: string): number => Number(text.trim().replace(',', '.'));

/** The areas in the form of the request. */
export function areasInputs(areas: Area[]): Areas {
  const time = (text: string): string | undefined => {
    const at_ms = parseTime(text);
    return at_ms === undefined ? undefined : isoOf(at_ms);
  };
  const depth = (name: 'top_m' | 'bottom_m', text = ''): Partial<AreaProperties> => (text.trim() === '' ? {} : { [name]: depthIn(text) });
  return {
    type: 'FeatureCollection',
    features: areas.map(({ kind, name, corners, from, until, top_m, bottom_m }) => {
      const [first] = corners;
      const [start, end] = [time(from), time(until)];
      return {
        type: 'Feature',
        properties: {
          kind, name, ...(start ? { from: start } : {}), ...(end ? { until: end } : {}),
          ...depth('top_m', top_m), ...depth('bottom_m', bottom_m),
        },
        geometry: { type: 'Polygon', coordinates: [first ? [...corners, first] : corners] },
      };
    }),
  };
}
