import { describe, expect, it } from 'vitest';
import { editablePosition, exactPosition, formatPosition, parsePosition } from '../../src/geo/coordinates';

const read = (text: string): [number, number] | string => {
  const parsed = parsePosition(text);
  return parsed.ok ? parsed.value : parsed.fault;
};

describe('positions', () => {
  it.each([
    '69°10.2′N 51°21.0′W', "69 10.2 N 51 21 W", "69°10.2'N, 51°21.0'W", '69.17, -51.35', '69.17 -51.35', '69.17N 51.35W',
    'N69 10.2 W51 21.0', '51°21.0′W 69°10.2′N', '69 10 12 N 51 21 0 W', '69.17; -51.35', '  69.17,-51.35 ',
    '69,17 -51,35', '69,17; -51,35', '69,17, -51,35', '69,17,-51,35', '69,17N 51,35W', '69°10,2′N 51°21,0′W', '69 10,2 N 51 21 W',
    '6910.2 -5121.0', '6910.2, -5121', '6910.2N 05121.0W', '6910,2 -5121,0',
  ])('reads %s', (text) => {
    const value = read(text);
    expect(value[0]).toBeCloseTo(-51.35, 9);
    expect(value[1]).toBeCloseTo(69.17, 9);
  });

  it.each(['', 'abc', '69', '69 70 N 51 W', '91, 10', '10, 181', '69N 51S', '1,2,3', '69.5 10 N 51 W', '-69 N, 51 W',
    '69,17', '69,1 51', '69,1,51,7', '6970.0 -5121.0', '45.0 -5121.0', '123, 10'])('refuses "%s" with a reason', (text) => {
    expect(parsePosition(text).ok).toBe(false);
  });

  it('says how far minutes and seconds go', () => {
    expect(read('69 72.0 N 51 21 W')).toBe('The minutes go from 0 to 59.9, not to 72.0.');
    expect(read('69 10 72 N 51 21 0 W')).toBe('The seconds go from 0 to 59.9, not to 72.');
  });

  it('writes a place to the centimetre in the form of the text that it replaces', () => {
    const place: [number, number] = [-51.3512345, 69.1712345];
    expect(exactPosition(place, '69.17, -51.35')).toBe('69.1712345, -51.3512345');
    for (const text of ['69°10.2′N 51°21.0′W', '69 10.2 N 51 21 W']) {
      expect(exactPosition(place, text)).toMatch(/^69°10\.\d+′N 51°21\.\d+′W$/);
      const value = read(exactPosition(place, text));
      expect(value[0]).toBeCloseTo(place[0], 7);
      expect(value[1]).toBeCloseTo(place[1], 7);
    }
    expect(exactPosition([10, -70], '70 S 10 E')).toBe('70°0′S 10°0′E');
  });

  it('asks where figures seem to stand in the wrong order, and takes letters at their word', () => {
    const isNear = ([lon, lat]: [number, number]): boolean => lon > -55 && lon < -50 && lat > 68 && lat < 70;
    const swapped = parsePosition('-51.35, 69.17', isNear);
    expect(swapped).toMatchObject({ ok: false, fault: expect.stringContaining('did you mean 69.17, -51.35?') as string });
    expect(parsePosition('-5121.0 6910.2', isNear)).toMatchObject({ ok: false, fault: expect.stringContaining('did you mean 69.17') as string });
    expect(parsePosition('51.35S 69.17E', isNear)).toEqual({ ok: true, value: [69.17, -51.35] });
    expect(parsePosition('40, 10', isNear).ok).toBe(true);
    expect(parsePosition('-151.35, 69.17')).toMatchObject({ ok: false, fault: expect.stringContaining('did you mean 69.17, -151.35?') as string });
  });

  it('writes degrees and decimal minutes, carrying sixty minutes over', () => {
    expect(formatPosition([-51.35, 69.17], 'dm')).toBe('69°10.2′N 051°21.0′W');
    expect(formatPosition([10.99999, 59.99999], 'dm')).toBe('60°00.0′N 011°00.0′E');
    expect(formatPosition([-51.35, 69.17], 'decimal')).toBe('69.17000° N 051.35000° W');
  });

  it('reads back what it puts into a field, to two metres', () => {
    for (const place of [[-51.123456, 69.654321], [179.99999, -0.00001], [0, 89.9]] as [number, number][]) {
      const value = read(editablePosition(place));
      expect(value[0]).toBeCloseTo(place[0], 4);
      expect(value[1]).toBeCloseTo(place[1], 4);
    }
  });
});
