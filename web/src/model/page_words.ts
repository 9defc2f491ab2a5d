import { labelsOfFlags } from './fields';
import { shortTime } from './time';

const instant = /\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ/g;

/** What the server says of the order of the numbers in a position. On this page latitude comes first. */
const orderOfNumbers = /; longitude comes first$/;

/** Makes a sentence of the server's words: a full stop at the end and, unless it begins with the name of a file, a capital. */
export const asSentence = (text: string): string => {
  const words = inPageWords(text);
  const isOpen = words !== '' && !/[.!?…]$/.test(words);
  const begun = /^\w+\.\w/.test(words) ? words : words.charAt(0).toUpperCase() + words.slice(1);
  return begun + (isOpen ? '.' : '');
};

/** A sentence of the server in the words of this page: “Longest hold” where it says --max-hold. */
export const inPageWords = (text: string): string =>
  text
    .replace(orderOfNumbers, '')
    .replace(instant, (time) => shortTime(Date.parse(time)))
    .replace(/--[a-z]+(-[a-z]+)*/g, (flag) => (labelsOfFlags[flag] ? `“${labelsOfFlags[flag]}”` : flag));
