import { diffLines } from 'diff';

/** A line of two compared lists: in both, only in the other, or only in this one. */
export interface DifferenceLine {
  side: 'both' | 'other' | 'this';
  text: string;
}

/** The list without comments and with single blanks, because only the rest matters to the vehicle. */
const asRead = (text: string): string =>
  text.split(/\r?\n/).map((line) => line.replace(/#.*/, '').trim().replace(/\s+/g, ' ')).filter((line) => line !== '').join('\n') + '\n';

/** The lines in which a vehicle would read `text` differently from `other`. */
export function differenceOf(text: string, other: string): DifferenceLine[] {
  return diffLines(asRead(other), asRead(text)).flatMap(({ value, added, removed }) =>
    value.trimEnd().split('\n').map((line): DifferenceLine => ({ side: added ? 'this' : removed ? 'other' : 'both', text: line })),
  );
}
