import { labelsOfFlags } from './fields';
import { shortTime } from './time';

const instant = /\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ/g;

/** What the server says of the order of the numbers in a position. On this page latitude comes first. */
const orderOfNumbers = /; longitude comes first$/;

/** Makes a sentence of the server's words: a capital at the beginning, a full stop at the end. */
export const asSentence = (text: string): string => {
  const words = inPageWords(text);
  const isOpen = words !== '' && !/[.!?…]$/.test(words);
  return words.charAt(0).toUpperCase() + words.slice(1) + (isOpen ? '.' : '');
};

/** A sentence of the server in the words of this page: “Longest hold” where it says --max-hold. */
export const inPageWords = (text: string): string =>
  text
    .replace(orderOfNumbers, '')
    .replace(instant, (time) => shortTime(Date.parse(time)))
    .replace(/--[a-z]+(-[a-z]+)*/g, (flag) => (labelsOfFlags[flag] ? `“${labelsOfFlags[flag]}”` : flag));
