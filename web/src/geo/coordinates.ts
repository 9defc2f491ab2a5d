import type { Position } from '../contract/data_types';

/** How positions are written on the screen. */
export type CoordinateStyle = 'dm' | 'decimal';

function part(value: number, width: number, letters: string, style: CoordinateStyle): string {
  const letter = value < 0 ? letters[1] : letters[0];
  const size = Math.abs(value);
  if (style === 'decimal') return `${size.toFixed(5).padStart(width + 6, '0')}° ${letter ?? ''}`;
  const tenthsOfMinutes = Math.round(size * 600);
  const degrees = Math.floor(tenthsOfMinutes / 600);
  const minutes = (tenthsOfMinutes - degrees * 600) / 10;
  return `${String(degrees).padStart(width, '0')}°${minutes.toFixed(1).padStart(4, '0')}′${letter ?? ''}`;
}

export const formatLat = (lat: number, style: CoordinateStyle): string => part(lat, 2, 'NS', style);
export const formatLon = (lon: number, style: CoordinateStyle): string => part(lon, 3, 'EW', style);

export const formatPosition = ([lon, lat]: Position, style: CoordinateStyle): string =>
  `${formatLat(lat, style)} ${formatLon(lon, style)}`;

/**
 * The text of a position for a field: thousandths of a minute (2 m), so that a picked place stays the same when edited.
 */
export function editablePosition([lon, lat]: Position): string {
  const one = (value: number, letters: string): string => {
    const thousandths = Math.round(Math.abs(value) * 60_000);
    const degrees = Math.floor(thousandths / 60_000);
    const minutes = (thousandths - degrees * 60_000) / 1000;
    return `${degrees}°${minutes.toFixed(3).padStart(6, '0')}′${(value < 0 ? letters[1] : letters[0]) ?? ''}`;
  };
  return `${one(lat, 'NS')} ${one(lon, 'EW')}`;
}

/**
 * The text of a place to the centimetre: a place that was moved out of an obstacle must not be rounded back into it. Decimal degrees if `before`
 * consists of figures alone, otherwise degrees and minutes.
 */
export function exactPosition([lon, lat]: Position, before: string): string {
  if (/^[\d\s.,;+-]+$/.test(before)) return `${Number(lat.toFixed(7))}, ${Number(lon.toFixed(7))}`;
  const one = (value: number, letters: string): string => {
    const fine = Math.round(Math.abs(value) * 60_000_000);
    const degrees = Math.floor(fine / 60_000_000);
    const minutes = (fine - degrees * 60_000_000) / 1_000_000;
    return `${degrees}°${minutes}′${(value < 0 ? letters[1] : letters[0]) ?? ''}`;
  };
  return `${one(lat, 'NS')} ${one(lon, 'EW')}`;
}

export type Parsed<T> = { ok: true; value: T } | { ok: false; fault: string };

const fail = (fault: string): { ok: false; fault: string } => ({ ok: false, fault });

interface Angle {
  value: number;
  letter: string | undefined;
}

/**
 * Reads one angle: degrees, optional minutes and seconds, a sign or a letter of the compass. If it is no angle, returns the reason as a text, or
 * undefined if none is known.
 */
function parseAngle(text: string): Angle | string | undefined {
  const letters = text.match(/[NSEW]/gi) ?? [];
  if (letters.length > 1) return undefined;
  const letter = letters[0]?.toUpperCase();
  const bare = text.replace(/[NSEW]/gi, ' ').replace(/[°ºd'′"″]/gi, ' ').trim();
  const words = bare.split(/\s+/);
  if (words.length < 1 || words.length > 3 || !words.every((word) => /^[+-]?\d+(\.\d+)?$/.test(word))) return undefined;
  const [degrees, minutes, seconds] = words.map(Number);
  if (degrees === undefined) return undefined;
  if (words.slice(0, -1).some((word) => word.includes('.'))) return undefined;
  const isSixtieth = (part = 0): boolean => part >= 0 && part < 60;
  if (!isSixtieth(minutes)) return `The minutes go from 0 to 59.9, not to ${words[1] ?? ''}.`;
  if (!isSixtieth(seconds)) return `The seconds go from 0 to 59.9, not to ${words[2] ?? ''}.`;
  const negative = bare.startsWith('-');
  if (negative && letter) return undefined;
  const size = Math.abs(degrees) + (minutes ?? 0) / 60 + (seconds ?? 0) / 3600;
  return { value: negative || letter === 'S' || letter === 'W' ? -size : size, letter };
}

/** Cuts "69 10.2 N 51 21.0 W", "69.17, -51.35" and the like into its two angles. */
function halves(text: string): [string, string] | undefined {
  const tidy = text.trim().replace(/\s+/g, ' ');
  const byComma = tidy.split(/[,;]/);
  if (byComma.length === 2) return [byComma[0] ?? '', byComma[1] ?? ''];
  if (byComma.length > 2) return undefined;
  const after = /^(.*?[NSEW])\s*([^NSEW]*[NSEW])$/i.exec(tidy);
  if (after && !/^[NSEW]/i.test(tidy)) return [after[1] ?? '', after[2] ?? ''];
  const before = /^([NSEW][^NSEW]*)([NSEW][^NSEW]*)$/i.exec(tidy);
  if (before) return [before[1] ?? '', before[2] ?? ''];
  const words = tidy.split(' ');
  if (words.length % 2 !== 0) return undefined;
  return [words.slice(0, words.length / 2).join(' '), words.slice(words.length / 2).join(' ')];
}

const plain = ({ value, letter }: Angle): boolean => letter === undefined && Number.isFinite(value);

/** Splits DDMM.mm of a glider into degrees and minutes; undefined if the minutes exceed 59. */
function fromGlider({ value, letter }: Angle): Angle | undefined {
  const size = Math.abs(value);
  const degrees = Math.floor(size / 100);
  const minutes = size - 100 * degrees;
  return minutes < 60 ? { value: Math.sign(value) * (degrees + minutes / 60), letter } : undefined;
}

/** Whether the numbers are DDMM.mm: only then can a latitude be in the thousands. */
const areGliders = (lat: Angle, lon: Angle): boolean => Math.abs(lat.value) >= 1000 && Math.abs(lon.value) >= 100;

/** Reads the text with points as decimal signs and commas as separators. */
function readAs(text: string, isNear: (place: Position) => boolean): Parsed<Position> {
  const pieces = halves(text);
  const first = pieces && parseAngle(pieces[0]);
  const second = pieces && parseAngle(pieces[1]);
  const why = [first, second].find((angle) => typeof angle === 'string');
  if (why !== undefined) return fail(why);
  if (!first || !second || typeof first === 'string' || typeof second === 'string') return fail('Not understood. Write 69°10.2′N 51°21.0′W or 69.17, -51.35.');

  const firstIsLon = first.letter === 'E' || first.letter === 'W' || second.letter === 'N' || second.letter === 'S';
  let [lat, lon] = firstIsLon ? [second, first] : [first, second];
  if (lat.letter === 'E' || lat.letter === 'W' || lon.letter === 'N' || lon.letter === 'S') {
    return fail('One latitude (N or S) and one longitude (E or W) are needed.');
  }
  if (areGliders(lat, lon)) {
    const [gliderLat, gliderLon] = [fromGlider(lat), fromGlider(lon)];
    if (!gliderLat || !gliderLon) return fail('Read as DDMM.mm, the minutes must be below 60. Write 6910.2, -5121.0 or 69.17, -51.35.');
    [lat, lon] = [gliderLat, gliderLon];
  }
  const isPlain = plain(lat) && plain(lon);
  const swapped = `${lon.value}, ${lat.value}`;
  const canSwap = isPlain && Math.abs(lon.value) <= 90 && Math.abs(lat.value) <= 180;
  if (Math.abs(lat.value) > 90) return fail(`Latitude must lie between 90° S and 90° N.${canSwap ? ` It comes first: did you mean ${swapped}?` : ''}`);
  if (Math.abs(lon.value) > 180) return fail('Longitude must lie between 180° W and 180° E.');
  if (canSwap && !isNear([lon.value, lat.value]) && isNear([lat.value, lon.value])) {
    return fail(`That is far from all data. Latitude comes first: did you mean ${swapped}? Else write the letters N, S, E and W.`);
  }
  return { ok: true, value: [lon.value, lat.value] };
}

/**
 * A position as people write it: degrees and decimal minutes, decimal degrees with points or commas,
 * degrees-minutes-seconds, or a glider's DDMM.mm; latitude first unless letters say otherwise; west and south by letter
 * or by minus. A text with two possible readings is refused.
 * @param isNear whether a place is near the data; shows numbers in the wrong order
 */
export function parsePosition(text: string, isNear: (place: Position) => boolean = () => true): Parsed<Position> {
  if (text.trim() === '') return fail('Give a position, as 69°10.2′N 51°21.0′W or 69.17, -51.35.');
  const asWritten = readAs(text, isNear);
  const inFigures = /(?<=\d),(?=\d)/g;
  if (text.includes('.') || !inFigures.test(text)) return asWritten;
  const withPoints = text.replace(inFigures, '.');
  const decimal = readAs(withPoints, isNear);
  const isOneNumber = /^[+-]?\d+\.\d+$/.test(withPoints.trim());
  if (asWritten.ok && (decimal.ok || isOneNumber)) {
    return fail('Does the comma mark decimals, or does it separate latitude and longitude? Write 69.17, -51.35 with points, and a space after the comma.');
  }
  return asWritten.ok ? asWritten : decimal;
}
