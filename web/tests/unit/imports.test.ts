import { describe, expect, it } from 'vitest';
import type { FileReport, Upload } from '../../src/contract/data_types';
import { beginImport, changeFile, changeImport, distinct, forgetImport, importing, importOf, uploadsOf } from '../../src/model/imports';

const upload = (name: string): Upload => ({ id: `id of ${name}`, name, bytes: 1, sha256: '', created: '', expires: '' });

describe('imports', () => {
  it('are live until they have come to an end, and change only while they are listed', () => {
    const { number } = beginImport([{ name: 'a.nc', size: 10 }, { name: 'b.nc', size: 20 }]);
    expect(importing.value).toBe(true);
    changeFile(number, 1, { stage: 'sending', bytes: 7 });
    expect(importOf(number)?.files.map(({ bytes }) => bytes)).toEqual([0, 7]);
    changeImport(number, { state: { stage: 'cancelled' } });
    expect(importing.value).toBe(false);
    forgetImport(number);
    changeFile(number, 0, { bytes: 3 });
    expect(importOf(number)).toBeUndefined();
  });

  it('know the uploads that a report speaks of', () => {
    const files = ['u.nc', 'v.nc', 'other.nc'].map((name) => ({ name, size: 1, stage: 'sent' as const, bytes: 1, upload: upload(name) }));
    const report: FileReport = { file: 'u.nc + v.nc', status: 'refused', dataset_id: null, warnings: [], errors: ['why'] };
    expect(uploadsOf(report, files).map(({ name }) => name)).toEqual(['u.nc', 'v.nc']);
  });

  it('tell files of one name apart', () => {
    expect(distinct(['a.nc', 'b.nc', 'a.nc', 'a.nc'])).toEqual(['a.nc', 'b.nc', '2-a.nc', '3-a.nc']);
  });
});
