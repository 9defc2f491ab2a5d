import { formatPosition } from '../geo/coordinates';
import { formOf, labelsOfFlags } from './fields';
import { exportLabels } from './plan/export_labels';
import { settings } from './settings';
import { duration, shortTime } from './time';

const instant = /\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ/g;

/** What the server says of the order of the numbers in a position. On this page latitude comes first. */
const orderOfNumbers = /; longitude comes first$/;

/** A place as a flag gives it. */
const placeOfFlag = /--(?:from|to|via)=(-?\d+(?:\.\d+)?),(-?\d+(?:\.\d+)?)/g;

/** Makes a sentence of the server's words: a full stop at the end and, unless it begins with the name of a file, a capital. */
export const asSentence = (text: string): string => {
  const words = inPageWords(text);
  const isOpen = words !== '' && !/[.!?…]$/.test(words);
  const begun = /^\w+\.\w/.test(words) ? words : words.charAt(0).toUpperCase() + words.slice(1);
  return begun + (isOpen ? '.' : '');
};

/** A position in the server's sentences: longitude and latitude to four decimals. */
const placeInText = /(-?\d{1,3}\.\d{4}), (-?\d{1,2}\.\d{4})/g;

/** The field that a sentence of the server begins with, as a JSON pointer. */
const pointerOfField = /^\/(?:inputs\/)?([a-z_]+)(?:\/([a-z_]+))?(?= )/;

/** “Departure” for /depart; a pointer to what the page has no field for stays. */
function labelOfPointer(pointer: string, outer: string, inner?: string): string {
  return formOf(inner ? `${outer}.${inner}` : outer).label || pointer;
}

/** The name of an input, which has two words or more, inside a sentence. */
const nameOfInput = /\b[a-z]+(?:_[a-z0-9]+)+\b/g;

/** A time in hours in the server's sentences: "57.1 h", "57 h 05 min". */
const hoursInText = /\b(\d+(?:\.\d+)?) h\b(?: (\d\d) min\b)?(?! \d)/g;

/** As the figures of the page have it: "2 d 09 h"; whole hours of a day stay as they are. */
const hoursInWords = (_: string, figure: string, minutes?: string): string => {
  const hours = Number(figure);
  return minutes === undefined && hours < 24 && Number.isInteger(hours) ? `${hours} h` : duration(3600 * hours + 60 * Number(minutes ?? 0));
};

/** The label of the field of the set-up or of the export that a flag of the command line is for. */
const labelOfFlag = (flag: string): string | undefined => labelsOfFlags[flag] ?? (exportLabels as Record<string, string | undefined>)[flag.slice(2)];

/**
 * A sentence of the server in the terms of this page: “Longest hold” for --max-hold, “2 d 09 h” for 57.1 h, and positions in the
 * page's notation.
 */
export const inPageWords = (text: string): string =>
  text
    .replace(pointerOfField, labelOfPointer)
    .replace(orderOfNumbers, '')
    .replace(placeOfFlag, (_, lon: string, lat: string) => formatPosition([Number(lon), Number(lat)], settings.value.coordinates))
    .replace(placeInText, (_, lon: string, lat: string) => formatPosition([Number(lon), Number(lat)], settings.value.coordinates))
    .replace(hoursInText, hoursInWords)
    .replace(instant, (time) => shortTime(Date.parse(time)))
    .replace(nameOfInput, (name) => (formOf(name).label ? `“${formOf(name).label}”` : name))
    .replace(/--[a-z]+(-[a-z]+)*/g, (flag) => (labelOfFlag(flag) ? `“${labelOfFlag(flag)}”` : flag));
