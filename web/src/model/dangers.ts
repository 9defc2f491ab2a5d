/** What an answer of the server says to the pilot: every sentence among the warnings, the dangers among them named again. */
interface Told {
  dangers?: string[];
  warnings: string[];
}

/** How the server marks a danger where nothing else shows the rank. */
const mark = /^Danger: /;

/** What may cost the vehicle. Answers that were stored before dangers were told apart name none. */
export const dangersOf = ({ dangers = [] }: Told): string[] => dangers.map((text) => text.replace(mark, ''));

/** The other warnings. */
export const cautionsOf = ({ warnings }: Pick<Told, 'warnings'>): string[] => warnings.filter((text) => !mark.test(text));

/** To be read out after a result: " 1 danger. 2 warnings."; empty where there are none. */
export function warnedOf(told: Told): string {
  const count = (texts: string[], word: string): string => (texts.length > 0 ? ` ${texts.length} ${word}${texts.length === 1 ? '' : 's'}.` : '');
  return count(dangersOf(told), 'danger') + count(cautionsOf(told), 'warning');
}
