import { describe, expect, it } from 'vitest';
import { requestFields } from '../../src/contract/request_fields';
import type { PlanInputs } from '../../src/contract/types';
import type { Vehicle } from '../../src/contract/data_types';
import { vehicles } from '../../src/model/datasets';
import { settingRows } from '../../src/model/plan/settings_difference';

const request = (more: Partial<PlanInputs>): PlanInputs => ({ from: [-52, 69], to: [-51, 69], ...more });

describe('settings in which plans differ', () => {
  it('have the labels and units of the set-up, and what the server takes where nothing is asked', () => {
    const rows = settingRows([
      request({ margin_m: 800, under_ice: { max_time_without_surfacing_s: 7200 }, name: 'first' }),
      request({ under_ice: { max_time_without_surfacing_s: 14400 }, name: 'second' }),
    ]);

    expect(rows).toEqual([
      { name: 'margin_m', label: 'Iceberg margin', values: ['800 m', '500 m'] },
      { name: 'under_ice.max_time_without_surfacing_s', label: 'Max. time without surfacing', values: ['2 h', '4 h'] },
    ]);
  });

  it('have places as degrees and minutes, and lists as their number', () => {
    const rows = settingRows([request({ from: [-52.5, 69.25], via: [[-52, 69]] }), request({ from: [-52, 69], via: [[-52, 69], [-51.5, 69]] })]);

    expect(rows.map(({ label, values }) => [label, ...values])).toEqual([
      ['Start', '69°15.0′N 052°30.0′W', '69°00.0′N 052°00.0′W'], ['Via points', '1', '2'],
    ]);
  });

  it('have those of the vehicle by their own names', () => {
    const rows = settingRows([request({ vehicle: { profile: 'slocum-g3-200', dive_depth_m: 150 } }), request({ vehicle: 'slocum-g3-200' })]);

    expect(rows).toEqual([{ name: 'dive_depth_m', label: 'Dive depth', values: ['150 m', '–'] }]);
  });

  it('have the labels of the figures of a vehicle that the set-up keeps apart', () => {
    const rows = settingRows([request({ vehicle: { profile: 'slocum-g3-200', hotel_w: 2 } }), request({ vehicle: 'slocum-g3-200' })]);

    expect(rows).toEqual([{ name: 'vehicle.hotel_w', label: 'Hotel load', values: ['2 W', '–'] }]);
  });

  it('are not told where one states the usual value that the other leaves out, whatever the field', () => {
    for (const [name, { usual }] of Object.entries(requestFields as Record<string, { usual?: unknown }>)) {
      if (usual === undefined) continue;
      const [object, member] = name.split('.');
      const stated = member === undefined ? { [name]: usual } : { [object ?? '']: { [member]: usual } };
      expect(settingRows([request(stated as Partial<PlanInputs>), request({})]), name).toEqual([]);
    }
  });

  it('are not told where one states what the vehicle of the other has', () => {
    vehicles.value = [{ name: 'slocum-g3-200', dive_depth_m: 200 } as Vehicle];

    expect(settingRows([request({ vehicle: { profile: 'slocum-g3-200', dive_depth_m: 200 }, objective: 'time' }), request({ vehicle: 'slocum-g3-200' })])).toEqual([]);
    expect(settingRows([request({ vehicle: { profile: 'slocum-g3-200', dive_depth_m: 150 } }), request({ vehicle: 'slocum-g3-200' })])[0]?.values).toEqual(['150 m', '200 m']);
    vehicles.value = [];
  });

  it('take what is null as not asked for', () => {
    const none = { via: null, margin_m: null } as unknown as Partial<PlanInputs>;

    expect(settingRows([request(none), request({})])).toEqual([]);
    expect(settingRows([request(none), request({ margin_m: 800 })]).map(({ values }) => values)).toEqual([['500 m', '800 m']]);
  });

  it('are not told where all plans have the same', () => {
    expect(settingRows([request({ margin_m: 800 }), request({ margin_m: 800 }), request({ margin_m: 800 })])).toEqual([]);
    expect(settingRows([request({ margin_m: 800 }), request({ margin_m: 900 }), request({ margin_m: 800 })])).toHaveLength(1);
  });
});
