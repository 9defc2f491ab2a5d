import { inflateSync } from 'node:zlib';

/** The texts of a PDF as Cairo writes it, in the order of writing: a line of a paragraph or a cell of a table each. */
export function textsOf(pdf: Buffer): string[] {
  const source = pdf.toString('latin1');
  return [...source.matchAll(/stream\r?\n/g)].flatMap(({ index, 0: word }) => {
    if (source.slice(index - 3, index) === 'end') return [];
    const begin = index + word.length;
    return textsIn(inflated(pdf.subarray(begin, source.indexOf('endstream', begin))));
  });
}

/** Pictures, which are no compressed text, have none. */
function inflated(bytes: Buffer): string {
  try {
    return inflateSync(bytes).toString('latin1');
  } catch {
    return '';
  }
}

/** Cells of a row are apart by more than letters ever are, in thousandths of the size of the font. */
const betweenCells = 300;

/** A sign that is no Latin letter, such as the prime, comes by its number from a second part of the font, amid a text. */
const fromSecondPart = /\]?\s*T[jJ]\n\/\S+ 1 Tf\n<[\da-f]+>Tj\n\/\S+ 1 Tf\n\[?/g;

const unescaped = (text: string): string =>
  text.replace(/\\([0-7]{3}|.)/g, (_, sign: string) => (sign.length === 3 ? String.fromCharCode(parseInt(sign, 8)) : sign));

/** (text)Tj, or [(te)-3(xt)]TJ where letters are moved: what is moved far is a cell of its own, behind a tab. */
const textsIn = (commands: string): string[] =>
  [...commands.replace(fromSecondPart, '(′)').matchAll(/((?:\((?:[^()\\]|\\.)*\)|[\s\d.[\]-])*)T[jJ]/g)].map(([, parts = '']) =>
    [...parts.matchAll(/\(((?:[^()\\]|\\.)*)\)|(-?[\d.]+)/g)]
      .map(([, text, moved]) => (text === undefined ? (Math.abs(Number(moved)) > betweenCells ? '\t' : '') : unescaped(text)))
      .join('')
      .trim(),
  );
