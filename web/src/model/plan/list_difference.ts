import { diffLines } from 'diff';

/** A line of one list beside another: in both, in the other alone, in this one alone. */
export interface DifferenceLine {
  side: 'both' | 'other' | 'this';
  text: string;
}

/** Without comments, which name the plan and the time of writing, and with one blank between words, whatever stood there. */
const asRead = (text: string): string =>
  text.split(/\r?\n/).map((line) => line.replace(/#.*/, '').trim().replace(/\s+/g, ' ')).filter((line) => line !== '').join('\n') + '\n';

/** What a vehicle would read otherwise in `text` than in `other`. */
export function differenceOf(text: string, other: string): DifferenceLine[] {
  return diffLines(asRead(other), asRead(text)).flatMap(({ value, added, removed }) =>
    value.trimEnd().split('\n').map((line): DifferenceLine => ({ side: added ? 'this' : removed ? 'other' : 'both', text: line })),
  );
}
