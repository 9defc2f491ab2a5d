import { describe, expect, it } from 'vitest';
import { textOf } from '../../src/model/file_text';

const utf16 = (text: string, isLittle: boolean): number[] =>
  Array.from(text).flatMap((c) => [c.charCodeAt(0) >> 8, c.charCodeAt(0) & 0xff]).flatMap((_, i, all) => [all[isLittle ? i ^ 1 : i] ?? 0]);
const buffer = (bytes: number[]): ArrayBuffer => new Uint8Array(bytes).buffer;

describe('the text of a file', () => {
  it('is the same in every encoding of Unicode, with a mark and without', () => {
    const text = '<gpx>Kangerluk \u00e5</gpx>';
    const utf8 = [...new TextEncoder().encode(text)];
    const forms = [utf8, [0xef, 0xbb, 0xbf, ...utf8]];
    for (const isLittle of [true, false]) forms.push(utf16(text, isLittle), utf16(`\ufeff${text}`, isLittle));
    for (const form of forms) expect(textOf(buffer(form))).toBe(text);
  });

  it('may be empty', () => {
    expect(textOf(buffer([]))).toBe('');
  });
});
