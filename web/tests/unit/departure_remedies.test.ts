import { expect, it } from 'vitest';
import { datasets } from '../../src/model/datasets';
import { departureRemedies } from '../../src/model/setup/departure_remedies';
import type { Dataset } from '../../src/contract/data_types';

it('offers the begin of the currents, steady currents and none where the departure lies outside their period', () => {
  datasets.value = [{ id: 'currents-1', kind: 'currents', time_start: '2026-11-22T00:00:00Z', time_end: '2026-11-28T00:00:00Z' } as Dataset];

  const parts = (depart: string): unknown[] => departureRemedies({ depart }).map(({ part }) => part);
  for (const outside of ['2026-11-21T23:59:59Z', '2026-11-28T00:00:01Z']) {
    expect(parts(outside)).toEqual([{ depart: '2026-11-22 00:00' }, { steady: true }, { currents: 'none' }]);
  }
  for (const within of ['2026-11-22T00:00:00Z', '2026-11-28T00:00:00Z']) expect(parts(within)).toEqual([]);

  datasets.value = [];
  expect(parts('2026-12-01T00:00:00Z')).toEqual([]);
});
