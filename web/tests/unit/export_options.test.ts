import { describe, expect, it } from 'vitest';
import { addSafePlace, exportLabelOf, exportOptions, exportOptionsOf, exportWish, usualExport } from '../../src/model/plan/export_options';

describe('the options of an export', () => {
  it('ask for the lists alone at first', () => {
    expect(exportWish(usualExport)).toEqual({ query: { number: 10 }, folder: { glider: undefined }, faults: {} });
  });

  it('send safe places longitude first, and the depth of icebergs with them', () => {
    const { query, faults } = exportWish({ ...usualExport, set: 'full', safe: '69.2, -53.2\n68°54.0′N 53°36.0′W', iceberg_depth_m: '150' });
    expect(query).toMatchObject({ full: true, safe: '-53.200000,69.200000;-53.600000,68.900000', iceberg_depth_m: '150' });
    expect(faults).toEqual({});
  });

  it('leave out what the chosen files have no room for', () => {
    const all = { ...usualExport, mission: 'disko', firmware: '10.5', safe: '69.2, -53.2', science: '20:5:1110:60', glider: 'amadeus' };
    expect(exportWish({ ...all, set: 'lists' }).query).toEqual({ number: 10 });
    expect(exportWish({ ...all, set: 'seaglider' })).toEqual({ query: { format: 'seaglider', science: '20:5:1110:60' }, folder: { glider: 'amadeus' }, faults: {} });
    expect(exportWish({ ...all, set: 'full' }).query).toMatchObject({ mission: 'disko', firmware: '10.5', safe: '-53.200000,69.200000' });
  });

  it.each(['', '-1', '98', '1.5', 'ten'])('refuse %j as the number of a list', (number) => {
    expect(exportWish({ ...usualExport, number }).faults.number).toBeDefined();
  });

  it('name what is wrong with the safe places and with a depth without them', () => {
    expect(exportWish({ ...usualExport, set: 'full', safe: 'nowhere' }).faults.safe).toContain('Line 1');
    expect(exportWish({ ...usualExport, set: 'full', iceberg_depth_m: '150' }).faults.iceberg_depth_m).toContain('safe places');
  });

  it('take picked places below those that stand there, and are those of one plan', () => {
    exportOptions.value = { plan_id: 'p1', options: { ...usualExport, safe: '69.2, -53.2\n' } };
    addSafePlace('69.3, -53.3');
    expect(exportOptionsOf('p1').safe).toBe('69.2, -53.2\n69.3, -53.3');
    expect(exportOptionsOf('p2')).toEqual(usualExport);
  });
});

describe('a refusal of the server', () => {
  it.each([
    ['safe/0', 'Safe place 1'], ['safe', 'Safe places under ice'], ['waypoints/0', 'Waypoint S'], ['waypoints/12', 'Waypoint 12'], ['waypoints', 'Waypoints'],
    ['iceberg_depth_m', 'Deepest iceberg'], ['under_ice', 'A full mission for work under ice'], ['science/1', 'Science band 2'],
  ])('calls %s by the label of the dialog', (place, label) => {
    expect(exportLabelOf(place)).toBe(label);
  });
});
