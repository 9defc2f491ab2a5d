import { settings } from './settings';

/** Numbers with their unit; "–" if there is no value, never 0. */

const metresPerNauticalMile = 1852;
const knotsPerMetreSecond = 3600 / 1852;
export const none = '–';

const present = (value: number | null | undefined): value is number => typeof value === 'number' && Number.isFinite(value);

/**
 * A distance of any size: metres below 1 km. In a column, where all have one unit and the same decimals, `greatest_m` is its greatest
 * value.
 */
export function distance(metres: number | null | undefined, greatest_m?: number): string {
  if (!present(metres)) return none;
  const scale_m = Math.abs(greatest_m ?? metres);
  if (settings.value.distance === 'nm') {
    const miles = metres / metresPerNauticalMile;
    return `${miles.toFixed(scale_m < 10 * metresPerNauticalMile ? 2 : 1)} NM`;
  }
  if (Math.round(scale_m) < 1000) return `${Math.round(metres)} m`;
  return `${(metres / 1000).toFixed(scale_m < 1e5 ? 1 : 0)} km`;
}

/** The distance that the text of `distance` states, to its last digit. */
export function shownDistance_m(metres: number, greatest_m: number): number {
  const inMiles = settings.value.distance === 'nm';
  const miles_m = metresPerNauticalMile / (greatest_m < 10 * metresPerNauticalMile ? 100 : 10);
  const metric_m = greatest_m < 1000 ? 1 : greatest_m < 1e5 ? 100 : 1000;
  return toStep(metres, inMiles ? miles_m : metric_m);
}

/** The multiple of a step that is nearest. */
export const toStep = (value: number, step: number): number => step * Math.round(value / step);

/** The bare number of a table column headed by `distanceUnit`. */
export function distanceFigure(metres: number | null | undefined): string {
  if (!present(metres)) return none;
  return settings.value.distance === 'nm' ? (metres / metresPerNauticalMile).toFixed(2) : (metres / 1000).toFixed(2);
}
export const distanceUnit = (): string => (settings.value.distance === 'nm' ? 'NM' : 'km');

export function speedFigure(metres_s: number | null | undefined): string {
  if (!present(metres_s)) return none;
  return settings.value.speed === 'kn' ? (metres_s * knotsPerMetreSecond).toFixed(2) : metres_s.toFixed(2);
}
export const speedUnit = (): string => settings.value.speed;
export const speed = (metres_s: number | null | undefined): string =>
  present(metres_s) ? `${speedFigure(metres_s)} ${speedUnit()}` : none;

/** The bare number of a table column of metres. Halves go to the even number, as in the brief and on the command line. */
export function wholeMetres(metres: number | null | undefined): string {
  if (!present(metres)) return none;
  const nearest = Math.round(metres);
  return String(Math.abs(metres % 1) === 0.5 && nearest % 2 !== 0 ? nearest - 1 : nearest);
}

/** Sea depth: always metres. */
export const depth = (metres: number | null | undefined): string => (present(metres) ? `${wholeMetres(metres)} m` : none);

export const course = (degrees: number | null | undefined): string =>
  present(degrees) ? `${String(Math.round(degrees) % 360).padStart(3, '0')}°` : none;

/** `greatest_j`: as in `distance`. */
export const energy = (joules: number | null | undefined, greatest_j?: number): string =>
  present(joules) ? ((greatest_j ?? joules) >= 1e6 ? `${(joules / 1e6).toFixed(2)} MJ` : `${(joules / 1e3).toFixed(0)} kJ`) : none;

/** The energy that the text of `energy` states, to its last digit. */
export const shownEnergy_j = (joules: number, greatest_j: number): number => toStep(joules, greatest_j >= 1e6 ? 1e4 : 1e3);

const sizes = ['bytes', 'kB', 'MB', 'GB'] as const;

export function fileSize(bytes: number): string {
  const step = bytes < 1000 ? 0 : Math.min(sizes.length - 1, Math.floor(Math.log10(bytes) / 3));
  const value = bytes / 1000 ** step;
  return `${step === 0 ? value : value.toPrecision(3)} ${sizes[step] ?? ''}`;
}
