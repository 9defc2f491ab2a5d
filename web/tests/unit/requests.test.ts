import { describe, expect, it } from 'vitest';
import type { DatasetRef } from '../../src/contract/types';
import { datasets } from '../../src/model/datasets';
import { dataOf } from '../../src/model/setup/requests';
import { makePlan } from './make_plan';

const used = (kind: DatasetRef['kind'], id: string, part: Partial<DatasetRef> = {}): DatasetRef => ({ id, kind, name: id, sha256: '', ...part });
const planOn = (...refs: DatasetRef[]) => ({ ...makePlan('one', [[-52, 69], [-51, 69.1]]), created: '2026-11-20T12:00:00Z', datasets: refs });

describe('the data of a plan, to judge a route on', () => {
  it('are those it was made with, of depths all that were put together', () => {
    const plan = planOn(used('currents', 'c'), used('bathymetry', 'fine'), used('bathymetry', 'coarse'));
    expect(dataOf(plan)).toMatchObject({ currents: 'c', bathymetry: ['fine', 'coarse'], ice: 'none', coastline: 'none' });
  });

  it('are the members of an ensemble by name, but not the runs that were joined in time', () => {
    expect(dataOf(planOn(used('currents', 'a'), used('currents', 'b'))).currents).toEqual(['a', 'b']);
    const part = { from: '2026-11-20T00:00:00Z', until: '2026-11-21T00:00:00Z' };
    expect(dataOf(planOn(used('currents', 'a', part), used('currents', 'b', part))).currents).toBe('newest');
  });

  it('are the icebergs that the server joins, as long as none are newer', () => {
    const plan = planOn(used('icebergs', 'list'));
    datasets.value = [];
    expect(dataOf(plan).icebergs).toBe('newest');
    expect(dataOf(plan, ['list']).icebergs).toBe('list');
    datasets.value = [{
      id: 'newer', kind: 'icebergs', name: '', variables: [], bbox: [-53, 68, -50, 70], time_start: null, time_end: null, rows_accepted: 1,
      rows_refused: 0, warnings: [], file_name: '', file_size_bytes: 0, sha256: '', ingested: '2026-11-21T00:00:00Z', tool_version: '',
    }];
    expect(dataOf(plan).icebergs).toBe('list');
    datasets.value = undefined;
  });
});
