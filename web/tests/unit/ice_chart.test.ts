import { beforeEach, describe, expect, it } from 'vitest';
import type { Dataset, IceChart, IceEgg, Position } from '../../src/contract/data_types';
import { setSpan, setTime } from '../../src/model/clock';
import { datasets } from '../../src/model/datasets';
import { chosenChart, drawnChart, eggAt, iceChart, partInWords, shortTotal } from '../../src/model/ice/ice_chart';

const hour_ms = 3_600_000;
const drawn_ms = Date.parse('2026-11-20T18:00:00Z');

const dataset = (id: string, time: string, variables: string[] = ['CT', 'SA']): Dataset => ({
  id, kind: 'ice', name: id, variables, bbox: [-60, 60, -50, 70], time_start: time, time_end: time, rows_accepted: 1, rows_refused: 0, warnings: [],
  file_name: id, file_size_bytes: 1, sha256: id, ingested: time, tool_version: '1',
});
const egg = (codes: Record<string, string>): IceEgg => ({ codes, total: null, parts: [] });
const square = (west: number, side: number): Position[] => [[west, 65], [west + side, 65], [west + side, 66], [west, 66], [west, 65]];
const chart = (dataset_id: string, ...coordinates: Position[][][]): IceChart => ({
  dataset_id, dataset_name: dataset_id, time: null, complete: true,
  features: coordinates.map((rings, i) => ({ type: 'Feature', properties: egg({ CT: `${i + 1}0` }), geometry: { type: 'Polygon', coordinates: rings } })),
});

describe('an ice chart', () => {
  beforeEach(() => {
    setSpan('test', { start_ms: drawn_ms - 240 * hour_ms, end_ms: drawn_ms + 240 * hour_ms });
    datasets.value = [dataset('older', '2026-11-13T18:00:00Z'), dataset('chart', '2026-11-20T18:00:00Z'), dataset('model', '2026-11-20T19:00:00Z', ['siconc'])];
    iceChart.value = chart('chart', [square(-59, 1)]);
  });

  it('is the newest that was drawn by the clock’s time', () => {
    setTime(drawn_ms + 2 * hour_ms);
    expect(chosenChart.value?.id).toBe('chart');
    setTime(drawn_ms - 2 * hour_ms);
    expect(chosenChart.value?.id).toBe('older');
    expect(drawnChart.value).toBeUndefined();
    setTime(drawn_ms - 200 * hour_ms);
    expect(chosenChart.value).toBeUndefined();
  });

  it('grows old with the clock, and says when plans no longer hold its ice', () => {
    setTime(drawn_ms + 30 * hour_ms);
    expect(drawnChart.value).toMatchObject({ age_ms: 30 * hour_ms, isHeld: true });
    setTime(drawn_ms + 73 * hour_ms);
    expect(drawnChart.value?.isHeld).toBe(false);
  });

  it('tells the egg of a place, leaves holes out and knows longitudes beyond 180', () => {
    iceChart.value = chart('chart', [square(-59, 4), square(-58, 1)], [square(179, 2)]);
    expect(eggAt([-57.5, 65.5])).toBeUndefined();
    expect(eggAt([-56.5, 65.5])?.codes['CT']).toBe('10');
    expect(eggAt([-179.5, 65.5])?.codes['CT']).toBe('20');
    expect(eggAt([0, 65.5])).toBeUndefined();
  });

  it('is labelled in tenths as charts are', () => {
    expect(['91', '92', '80', '46', '81', '01', '55', '99'].map((CT) => shortTotal(egg({ CT })))).toEqual(['9+', '10', '8', '4–6', '8–10', '', '', '']);
    expect(partInWords({ concentration: '6 tenths', stage: 'grey ice, 10 to 15 cm', form: null })).toBe('6 tenths grey ice, 10 to 15 cm');
  });
});
