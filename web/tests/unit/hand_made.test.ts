import { describe, expect, it } from 'vitest';
import type { IcebergFeature, ZoneFeature } from '../../src/contract/data_types';
import type { Area } from '../../src/model/area';
import { featureOf, formOf, newBerg, newZone, renumber, type BergForm, type HandChange, type OpenForm } from '../../src/model/hand_made';

const berg: IcebergFeature = {
  type: 'Feature', id: 7, geometry: { type: 'Point', coordinates: [-51.1234567, 69.1234567] },
  properties: {
    berg_id: 'north', observed: '2026-11-21T06:00:42Z', size: 'medium', length_m: 90, safe_length_m: 90, draft_m: null, position_uncertainty_m: 200,
    shape: 'TAB', method: 'ship', dataset_id: 'icebergs-by-hand',
  },
};
const ring: [number, number][] = [[-52, 69], [-51, 69], [-51, 69.5], [-52, 69.5], [-52, 69]];
const hole: [number, number][] = [[-51.6, 69.1], [-51.4, 69.1], [-51.4, 69.2], [-51.6, 69.1]];
const zone: ZoneFeature = {
  type: 'Feature', id: 3, geometry: { type: 'Polygon', coordinates: [ring, hole] },
  properties: { kind: 'no_go', name: 'Closed', from: '2026-11-21T06:00:00Z', until: null, top_m: 0, bottom_m: 100, dataset_id: 'zones-by-hand' },
};

const withBerg = (form: OpenForm, part: Partial<BergForm>): OpenForm => (form.berg ? { ...form, berg: { ...form.berg, ...part } } : form);
const withZone = (form: OpenForm, part: Partial<Area>): OpenForm => (form.zone ? { ...form, zone: { ...form.zone, ...part } } : form);

describe('a berg reported by hand', () => {
  it('keeps to the digit what was not touched', () => {
    const form = formOf('icebergs', berg, '"tag"');
    const made = featureOf(withBerg(form, { size: 'large' }));
    if (!('feature' in made)) throw new Error('It has faults.');
    expect(made.feature.geometry).toEqual(berg.geometry);
    expect(made.feature.properties).toEqual({
      berg_id: 'north', observed: '2026-11-21T06:00:42Z', size: 'large', length_m: 90, position_uncertainty_m: 200, shape: 'TAB', method: 'ship',
    });
  });

  it('goes where it is put', () => {
    const form = formOf('icebergs', berg, undefined);
    const made = featureOf(withBerg(form, { place: '69.5, -52', observed: '2026-11-22 01:00' }));
    expect(made).toMatchObject({ feature: { geometry: { coordinates: [-52, 69.5] }, properties: { observed: '2026-11-22T01:00:00Z' } } });
  });

  it('is refused with every fault beside its field', () => {
    const form = newBerg('nowhere');
    const made = featureOf(withBerg(form, { berg_id: ' ', observed: 'today', length_m: '-4', draft_m: 'deep' }));
    expect('faults' in made && Object.keys(made.faults).sort()).toEqual(['berg_id', 'draft_m', 'length_m', 'observed', 'place']);
  });
});

describe('a zone made by hand', () => {
  it('keeps its holes as long as its corners stay', () => {
    const form = formOf('zones', zone, undefined);
    expect(featureOf(withZone(form, { name: 'Renamed' }))).toMatchObject({
      feature: { geometry: { coordinates: [ring, hole] }, properties: { kind: 'no_go', name: 'Renamed', from: '2026-11-21T06:00:00Z', bottom_m: 100 } },
    });
    const moved = featureOf(withZone(form, { corners: [[-53, 69], [-52, 69], [-52, 70]] }));
    expect(moved).toMatchObject({ feature: { geometry: { coordinates: [[[-53, 69], [-52, 69], [-52, 70], [-53, 69]]] } } });
  });

  it('of all times and depths asks for none', () => {
    const always = formOf('zones', { ...zone, properties: { ...zone.properties, name: null, from: null, bottom_m: null } }, undefined);
    const made = featureOf(always);
    expect('feature' in made && made.feature.properties).toEqual({ kind: 'no_go', name: '' });
  });

  it('needs three corners', () => {
    expect(featureOf(newZone([[-52, 69], [-51, 69]]))).toHaveProperty('faults.zone');
  });
});

it('changes follow a feature that was stored anew', () => {
  const changes: HandChange[] = [{ kind: 'icebergs', id: '7', tag: 'a', title: '' }, { kind: 'zones', id: '7', tag: 'b', title: '' }];
  expect(renumber(changes, '7', '9', 'icebergs', 'c')).toEqual([{ kind: 'icebergs', id: '9', tag: 'c', title: '' }, changes[1]]);
});
