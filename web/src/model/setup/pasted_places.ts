import { readPosition } from '../position';

/** Labels before a position in lists: "Start: ", "WP 3 = ", "2) ". */
const label = /^\s*(?:[A-Za-z][\w .-]*[:=]|\d{1,3}[.):])\s+/;

/** Start, via points and goal of a list of positions, one a line; undefined for any other text. */
export function placesOfText(text: string): { from: string; via: string; to: string } | undefined {
  const lines = text.split(/\r?\n/).map((line) => line.replace(label, '').trim()).filter((line) => line !== '');
  const [from, ...others] = lines;
  const to = others.pop();
  if (from === undefined || to === undefined || !lines.every((line) => readPosition(line).ok)) return undefined;
  return { from, via: others.join('\n'), to };
}
