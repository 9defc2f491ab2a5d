import { beforeEach, describe, expect, it } from 'vitest';
import type { Dataset } from '../../src/contract/data_types';
import { range, spans, time_ms } from '../../src/model/clock';
import { chosenSeaIce, datasets } from '../../src/model/datasets';
import { draft, edit } from '../../src/model/setup/draft';
import { goToSeaIce, nearestSeaIceStep_ms, seaIceInWords, surfacingLimit } from '../../src/model/ice/sea_ice';
import { hour_ms, isoOf } from '../../src/model/time';

const start_ms = Date.UTC(2026, 10, 20);

const chart = (id: string, ...hours: number[]): Dataset => {
  const times = hours.map((hour) => isoOf(start_ms + hour * hour_ms));
  return {
    id, kind: 'ice', name: id, variables: [], bbox: [-60, 60, -50, 70], time_start: times[0] ?? null, time_end: times.at(-1) ?? null, times, rows_accepted: 1, rows_refused: 0,
    warnings: [], file_name: '', file_size_bytes: 0, sha256: '', ingested: isoOf(start_ms), tool_version: '',
  };
};

describe('the sea ice shown', () => {
  beforeEach(() => {
    spans.value = {};
    edit({ ice: 'newest', 'under_ice.max_concentration_to_surface': '' });
    datasets.value = [chart('forecast', 48, 72), chart('analysis', 0, 24)];
  });

  it('is the newest that tells of the clock’s time, and between them the nearer one', () => {
    time_ms.value = start_ms + 12 * hour_ms;
    expect(chosenSeaIce.value?.id).toBe('analysis');
    time_ms.value = start_ms + 60 * hour_ms;
    expect(chosenSeaIce.value?.id).toBe('forecast');
    time_ms.value = start_ms + 30 * hour_ms;
    expect(chosenSeaIce.value?.id).toBe('analysis');
    time_ms.value = start_ms + 40 * hour_ms;
    expect(chosenSeaIce.value?.id).toBe('forecast');
    edit({ ice: 'analysis' });
    expect(chosenSeaIce.value?.id).toBe('analysis');
    edit({ ice: 'none' });
    expect(chosenSeaIce.value).toBeUndefined();
  });

  it('can be gone to where the clock is beyond it', () => {
    edit({ ice: 'analysis' });
    time_ms.value = start_ms + 100 * hour_ms;
    expect(nearestSeaIceStep_ms.value).toBe(start_ms + 24 * hour_ms);
    goToSeaIce();
    expect(time_ms.value).toBe(start_ms + 24 * hour_ms);
    expect(range.value.start_ms).toBeLessThanOrEqual(start_ms + 24 * hour_ms);
  });

  it('closes the surface from the limit of the set-up on, the server’s where it names none', () => {
    expect(surfacingLimit.value).toBe(0.1);
    edit({ 'under_ice.max_concentration_to_surface': '25' });
    expect(surfacingLimit.value).toBe(0.25);
    edit({ 'under_ice.max_concentration_to_surface': '400' });
    expect(surfacingLimit.value).toBe(0.1);
    expect(draft.value.ice).toBe('newest');
  });

  it('has words for what is known, and a dash for what is not', () => {
    expect(seaIceInWords(0.704, 1.25)).toBe('70 %, 1.3 m thick');
    expect(seaIceInWords(0.7, undefined)).toBe('70 %, thickness not known');
    expect(seaIceInWords(0, 0)).toBe('none');
    expect(seaIceInWords(undefined, 1)).toBe('–');
    expect(seaIceInWords(null, null)).toBe('–');
  });
});
