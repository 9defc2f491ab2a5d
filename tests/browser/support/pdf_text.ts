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

/** (text)Tj, or [(te)-3(xt)]TJ where letters are moved: what is moved far is a cell of its own, behind a tab. */
const textsIn = (commands: string): string[] =>
  [...commands.matchAll(/((?:\((?:[^()\\]|\\.)*\)|[\s\d.[\]-])*)T[jJ]/g)].map(([, parts = '']) =>
    [...parts.matchAll(/\(((?:[^()\\]|\\.)*)\)|(-?[\d.]+)/g)]
      .map(([, text, moved]) => (text === undefined ? (Math.abs(Number(moved)) > betweenCells ? '\t' : '') : text.replace(/\\(.)/g, '$1')))
      .join('')
      .trim(),
  );
