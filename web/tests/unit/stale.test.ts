import { describe, expect, it } from 'vitest';
import type { Dataset } from '../../src/contract/data_types';
import { newerThan, sightingsFor } from '../../src/model/stale';
import { makePlan } from './make_plan';

const dataset = (part: Partial<Dataset>): Dataset => ({
  id: 'new', kind: 'icebergs', name: 'bergs', variables: [], bbox: [-53, 68, -50, 70], time_start: null, time_end: null, rows_accepted: 1,
  rows_refused: 0, warnings: [], file_name: '', file_size_bytes: 0, sha256: '', ingested: '2026-11-21T00:00:00Z', tool_version: '', ...part,
});
const plan = {
  ...makePlan('one', [[-52, 69], [-51, 69.1]]), created: '2026-11-20T12:00:00Z',
  datasets: [{ id: 'old', kind: 'icebergs' as const, name: 'bergs', sha256: '' }],
};

describe('a plan is stale', () => {
  it('when data of a kind it used came in later and cover its way', () => {
    expect(newerThan(plan, [dataset({})]).map(({ id }) => id)).toEqual(['new']);
  });

  it('not for older data, another kind or another sea', () => {
    expect(newerThan(plan, [dataset({ ingested: '2026-11-20T00:00:00Z' })])).toEqual([]);
    expect(newerThan(plan, [dataset({ kind: 'currents' })])).toEqual([]);
    expect(newerThan(plan, [dataset({ kind: 'bathymetry' })])).toEqual([]);
    expect(newerThan(plan, [dataset({ bbox: [-10, 68, 0, 70] })])).toEqual([]);
  });

  it('when currents of its hours came in, and not for those of another year', () => {
    const sailed = { ...plan, datasets: [{ id: 'old', kind: 'currents' as const, name: '', sha256: '' }] };
    const of = (time_start: string, time_end: string): Dataset => dataset({ kind: 'currents', time_start, time_end });
    expect(newerThan(sailed, [of(sailed.departure, sailed.arrival)])).toHaveLength(1);
    expect(newerThan(sailed, [of('2019-02-23T00:00:00Z', '2019-02-23T00:00:00Z')])).toEqual([]);
    expect(newerThan(sailed, [of('2030-01-01T00:00:00Z', '2030-01-05T00:00:00Z')])).toEqual([]);
  });

  it('when icebergs may drift into its way from beside it, or are the first that are known', () => {
    expect(newerThan(plan, [dataset({ bbox: [-50, 69, -49, 69.2] })])).toHaveLength(1);
    expect(newerThan({ ...plan, datasets: [] }, [dataset({})])).toHaveLength(1);
  });

  it('when sightings came in that it would heed, of every file, and not for those too old or later than it left', () => {
    const sighted = (id: string, at: string): Dataset => dataset({ id, time_start: at, time_end: at });
    const stored = [sighted('one', '2026-11-19T20:00:00Z'), sighted('two', '2026-11-17T01:00:00Z'), sighted('old', '2026-11-16T20:00:00Z'), sighted('later', '2026-11-20T02:00:00Z')];
    expect(newerThan(plan, stored).map(({ id }) => id)).toEqual(['one', 'two']);
  });

  it('of a plan under way also when something was sighted since it left', () => {
    const [depart_ms, arrive_ms] = [Date.parse(plan.departure), Date.parse(plan.arrival)];
    expect(sightingsFor(plan, depart_ms - 1)[1]).toBe(depart_ms);
    expect(sightingsFor(plan, depart_ms + 1000)[1]).toBe(depart_ms + 1000);
    expect(sightingsFor(plan, arrive_ms + 1000)[1]).toBe(depart_ms);
  });

  it('when icebergs or zones made by hand have changed since, also the first ones', () => {
    const reported = dataset({ id: 'icebergs-by-hand', sha256: 'a' });
    expect(newerThan(plan, [dataset({}), reported]).map(({ id }) => id)).toEqual(['new', 'icebergs-by-hand']);
    const knew = { ...plan, datasets: [...plan.datasets, { id: 'icebergs-by-hand', kind: 'icebergs' as const, name: '', sha256: 'a' }] };
    expect(newerThan(knew, [reported])).toEqual([]);
    expect(newerThan(knew, [{ ...reported, sha256: 'b' }])).toHaveLength(1);
    expect(newerThan(plan, [{ ...reported, bbox: [-51.5, 69.05, -51.5, 69.05] }])).toHaveLength(1);
    expect(newerThan(plan, [{ ...reported, bbox: [-40, 65, -40, 65] }])).toEqual([]);
    expect(newerThan(plan, [dataset({ id: 'zones-by-hand', kind: 'zones' })])).toHaveLength(1);
  });
});
