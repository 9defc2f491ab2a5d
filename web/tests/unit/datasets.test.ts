import { expect, it } from 'vitest';
import type { Box, Dataset } from '../../src/contract/data_types';
import { chosen, chosenAll, damagedDatasets, datasets, forgetMissing, isEmptyStore, isInUse, takeStored } from '../../src/model/datasets';
import { draft, fill } from '../../src/model/setup/draft';

const depths = (id: string, bbox: Box, rows_accepted: number): Dataset => ({
  id, kind: 'bathymetry', name: id, variables: [], bbox, time_start: null, time_end: null, rows_accepted, rows_refused: 0, warnings: [],
  file_name: '', file_size_bytes: 0, sha256: '', ingested: '2026-11-21T00:00:00Z', tool_version: '',
});

it('depths are those of the finest grid first, whichever came in last, unless one is named', () => {
  const [world, bay, across] = [depths('world', [-180, -90, 180, 90], 259_200), depths('bay', [-55, 68, -50, 70], 276_480), depths('across', [175, 60, -175, 70], 40_000)];
  datasets.value = [world, across, bay];
  expect(chosenAll('bathymetry').map(({ id }) => id)).toEqual(['bay', 'across', 'world']);
  expect(chosen('bathymetry')).toBe(bay);
  expect(isInUse(world)).toBe(true);
  fill({ bathymetry: 'world' });
  expect(chosenAll('bathymetry')).toEqual([world]);
  expect(isInUse(bay)).toBe(false);
  fill({ bathymetry: 'newest' });
  datasets.value = undefined;
});

it('a damaged dataset is told of, and stays chosen until the person chooses another', () => {
  fill({ bathymetry: 'bay' });
  takeStored({ datasets: [], damaged: [{ type: '/problems/store-damaged', kind: 'dataset', id: 'bay', detail: 'It is damaged.' }] });
  expect(damagedDatasets.value.map(({ id }) => id)).toEqual(['bay']);
  expect(isEmptyStore.value).toBe(false);
  expect(forgetMissing()).toEqual([]);
  expect(draft.value.bathymetry).toBe('bay');

  takeStored({ datasets: [] });
  expect(damagedDatasets.value).toEqual([]);
  expect(forgetMissing()).toEqual(['bathymetry']);
  datasets.value = undefined;
});
