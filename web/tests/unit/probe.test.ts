import { afterEach, expect, it } from 'vitest';
import type { Dataset, DatasetKind } from '../../src/contract/data_types';
import { datasets } from '../../src/model/datasets';
import { emptyDraft, fill } from '../../src/model/setup/draft';
import { isLeftOut, probedDatasets } from '../../src/model/probe';

const dataset = (id: string, kind: DatasetKind): Dataset => ({
  id, kind, name: id, variables: [], bbox: [-55, 68, -50, 70], time_start: null, time_end: null, rows_accepted: 4, rows_refused: 0, warnings: [],
  file_name: '', file_size_bytes: 0, sha256: '', ingested: '2026-11-21T00:00:00Z', tool_version: '',
});

afterEach(() => {
  fill(emptyDraft);
  datasets.value = undefined;
});

it('a probe asks the datasets that the set-up names, and leaves the others to the server', () => {
  datasets.value = [dataset('new', 'currents'), dataset('old', 'currents'), dataset('bay', 'bathymetry'), dataset('list', 'icebergs')];
  expect(probedDatasets.value).toEqual([]);
  fill({ currents: 'old' });
  expect(probedDatasets.value).toEqual(['old']);
  fill({ currents: 'several old new', icebergs: 'list' });
  expect(probedDatasets.value).toEqual(['old', 'new', 'list']);
});

it('a kind that the set-up leaves out is not asked for, and is told to be left out', () => {
  datasets.value = [dataset('new', 'currents')];
  expect(isLeftOut('currents')).toBe(false);
  fill({ currents: 'none' });
  expect(isLeftOut('currents')).toBe(true);
  expect(probedDatasets.value).toEqual([]);
});
