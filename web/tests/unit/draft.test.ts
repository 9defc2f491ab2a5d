import { describe, expect, it } from 'vitest';
import { newArea } from '../../src/model/area';
import { draft, edit, emptyDraft } from '../../src/model/setup/draft';
import { redo, undo } from '../../src/model/undo';
import { editFor, sortViolations } from '../../src/model/setup/draft_answer';
import { inputsOf } from '../../src/model/setup/draft_request';

const good = { ...emptyDraft, from: '69 08 N 51 42 W', to: '68.55, -54.6', depart: '2026-11-21 01:00', vehicle: 'slocum-g3-200' };

describe('the set-up', () => {
  it('becomes the request of the contract, leaving empty fields out', () => {
    const result = inputsOf({ ...good, speed_m_s: '0,4' });
    if ('faults' in result) throw new Error('refused');
    expect(result.inputs).toMatchObject({
      from: [-51.7, 69.1333333], to: [-54.6, 68.55], depart: '2026-11-21T01:00:00Z', speed_m_s: 0.4, margin_m: 500, currents: 'newest',
    });
    expect(result.inputs).not.toHaveProperty('dive_depth_m');
    expect(result.inputs).not.toHaveProperty('via');
    expect(result.inputs).not.toHaveProperty('icebergs_as_of');
  });

  it('names every fault at once', () => {
    const result = inputsOf({ ...emptyDraft, margin_m: 'wide', via: '69, -52\nnowhere' });
    expect(Object.keys('faults' in result ? result.faults : {}).sort()).toEqual(['depart', 'from', 'margin_m', 'to', 'via']);
  });

  it('puts the violations of the server beside their fields', () => {
    const { faults, general } = sortViolations([
      { pointer: '/inputs/departure', detail: 'must be covered by the currents' },
      { pointer: '/inputs/via/1', detail: 'must be a position' },
      { pointer: '/inputs/under_ice/margin_below_ice_m', detail: 'must be a number' },
      { pointer: '/inputs/secret', detail: 'is not known' },
    ]);
    expect(faults.depart).toBe('Must be covered by the currents');
    expect(faults.via).toBe('Must be a position');
    expect(faults['under_ice.margin_below_ice_m']).toBe('Must be a number');
    expect(general).toEqual(['secret: Is not known']);
  });

  it('turns hours, kilometres and percent into the units of the request', () => {
    const result = inputsOf({
      ...good, depart_until: '2026-11-22', depart_step: '1.5', max_leg_m: '12', battery_start_share: '90',
      'under_ice.max_time_without_surfacing_s': '6', 'uncertainty.members': '8', objective: 'energy',
    });
    if ('faults' in result) throw new Error('refused');
    expect(result.inputs).toMatchObject({
      depart_until: '2026-11-22T00:00:00Z', depart_step: 'PT90M', max_leg_m: 12_000, battery_start_share: 0.9, objective: 'energy',
      under_ice: { max_time_without_surfacing_s: 21_600 },
      uncertainty: { members: 8, current_error_m_s: 0.05, length_scale_m: 30_000, time_scale_s: 86_400 },
    });
  });

  it('sends what is about two aims or about members only with them', () => {
    const plain = inputsOf({ ...good, 'objective.time': '3', 'uncertainty.quantile': '90' });
    if ('faults' in plain) throw new Error('refused');
    expect(plain.inputs).not.toHaveProperty('objective');
    expect(plain.inputs).not.toHaveProperty('uncertainty');
    const all = inputsOf({
      ...good, objective: 'both', 'objective.energy': '0.5', 'uncertainty.members': '4', 'uncertainty.objective': 'quantile',
      'uncertainty.quantile': '90', 'uncertainty.arrive_before': '2026-11-23',
    });
    if ('faults' in all) throw new Error('refused');
    expect(all.inputs).toMatchObject({
      objective: { time: 1, energy: 0.5 },
      uncertainty: { members: 4, objective: 'quantile', quantile: 0.9, arrive_before: '2026-11-23T00:00:00Z' },
    });
  });

  it('asks for members where something is wanted of them', () => {
    for (const wish of [{ 'uncertainty.arrive_before': '2026-11-23' }, { 'uncertainty.objective': 'mean' as const }]) {
      const result = inputsOf({ ...good, ...wish });
      expect('faults' in result && Object.keys(result.faults)).toEqual(['uncertainty.members']);
    }
  });

  it('takes its goals from a file, and its start too where none is typed', () => {
    const goals_file = { name: 'goto_l10.ma', text: '<start:waypoints>' };
    const all = inputsOf({ ...good, from: '', to: 'unread', via: 'unread', goals_file });
    if ('faults' in all) throw new Error('refused');
    expect(all.inputs).toMatchObject({ goals_file });
    expect(['from', 'to', 'via'].filter((name) => name in all.inputs)).toEqual([]);
    expect(all.inputs).not.toHaveProperty('route_name');
    expect(inputsOf({ ...good, goals_file, route_name: ' out ' })).toMatchObject({ inputs: { route_name: 'out' } });
    const started = inputsOf({ ...good, goals_file });
    expect('inputs' in started && started.inputs.from).toEqual([-51.7, 69.1333333]);
    expect(inputsOf({ ...good, from: 'nowhere', goals_file })).toHaveProperty('faults.from');
    expect(editFor({ input: 'to', from: null, to: [-51, 69], text: '' }, { ...good, goals_file })).toBeUndefined();
  });

  it('names several currents as the members of an ensemble, without the model of errors', () => {
    const result = inputsOf({ ...good, currents: 'several a b', 'uncertainty.members': '8', 'uncertainty.objective': 'mean', zones: 'several z' });
    expect('inputs' in result && result.inputs).toMatchObject({ currents: ['a', 'b'], zones: 'z', uncertainty: { objective: 'mean' } });
    expect('inputs' in result && result.inputs.uncertainty).not.toHaveProperty('members');
    expect(inputsOf({ ...good, currents: 'several' })).toEqual({ faults: { currents: 'Tick one dataset or more.' } });
  });

  it('changes a vehicle in what was given, and keeps the rest of it', () => {
    const result = inputsOf({ ...good, 'vehicle.hotel_w': '2.5', 'vehicle.battery_reserve_share': '20', spacing_m: '500 × 250' });
    expect('inputs' in result && result.inputs).toMatchObject({
      vehicle: { profile: 'slocum-g3-200', hotel_w: 2.5, battery_reserve_share: 0.2 }, spacing_m: [500, 250],
    });
    expect(inputsOf({ ...good, spacing_m: '500 by 250' })).toHaveProperty('faults.spacing_m');
  });

  it('states tides with what they are to the currents, and rare data only where they were chosen', () => {
    const usual = inputsOf(good);
    expect('inputs' in usual && ['tides', 'tides_mode', 'wind', 'zones'].filter((name) => name in usual.inputs)).toEqual([]);
    const result = inputsOf({ ...good, tides: 'newest', tides_mode: 'only', zones: 'none', max_loiter_s: '6', pass_under_icebergs: true });
    expect('inputs' in result && result.inputs).toMatchObject({
      tides: 'newest', tides_mode: 'only', zones: 'none', max_loiter_s: 21_600, pass_under_icebergs: true,
    });
  });

  it('names an area whose depths cannot be read', () => {
    const corners: [number, number][] = [[-52, 69], [-51, 69], [-51, 69.2]];
    const area = { kind: 'no_go' as const, name: 'cable', corners, from: '', until: '', top_m: '20', bottom_m: 'deep' };
    expect(inputsOf({ ...good, areas: [area] })).toEqual({ faults: { areas: 'cable: write its depths in metres.' } });
    const result = inputsOf({ ...good, areas: [{ ...area, bottom_m: '' }] });
    expect('inputs' in result && result.inputs.areas?.features[0]?.properties).toEqual({ kind: 'no_go', name: 'cable', top_m: 20 });
  });

  it('states areas as closed rings with their times', () => {
    const corners: [number, number][] = [[-52, 69], [-51, 69], [-51, 69.2]];
    const result = inputsOf({ ...good, areas: [{ kind: 'no_go', name: 'ice camp', corners, from: '2026-11-21', until: '' }] });
    if ('faults' in result) throw new Error('refused');
    expect(result.inputs.areas?.features[0]).toEqual({
      type: 'Feature', properties: { kind: 'no_go', name: 'ice camp', from: '2026-11-21T00:00:00Z' },
      geometry: { type: 'Polygon', coordinates: [[...corners, corners[0]]] },
    });
  });

  it('takes in a change that the server proposes', () => {
    const form = { ...good, via: '69, -52\n69.1, -52' };
    expect(editFor({ input: 'to', from: null, to: [-51.985903, 68.6469793], text: '' }, form)).toEqual({ to: '68.6469793, -51.985903' });
    expect(editFor({ input: 'via/1', from: null, to: [-51, 69], text: '' }, form)).toEqual({ via: '69, -52\n69, -51' });
    expect(editFor({ input: 'margin_m', from: 500, to: 320, text: '' }, form)).toEqual({ margin_m: '320' });
    expect(editFor({ input: 'arrive_by', from: null, to: '2026-11-22T05:00:00Z', text: '' }, form)).toEqual({ arrive_by: '2026-11-22 05:00' });
    expect(editFor({ input: 'spacing_m', from: 9000, to: 4500, text: '' }, form)).toEqual({ spacing_m: '4500' });
    expect(editFor({ input: 'spacing_m', from: [9000, 7000], to: [4500, 3500], text: '' }, form)).toEqual({ spacing_m: '4500 × 3500' });
    expect(editFor({ input: 'zones', from: 'range', to: 'none', text: '' }, form)).toEqual({ zones: 'none' });
    expect(editFor({ input: 'under_ice/margin_below_ice_m', from: 10, to: 4, text: '' }, form)).toEqual({ 'under_ice.margin_below_ice_m': '4' });
    expect(editFor({ input: 'vehicle/thruster/speed_m_s', from: 0.5, to: 0.6, text: '' }, form)).toBeUndefined();
    expect(editFor({ input: 'nothing_known', from: 0, to: 1, text: '' }, form)).toBeUndefined();
  });

  it('leaves out the area that a change names', () => {
    const form = { ...good, areas: ['bank', 'reef'].map((name, i) => ({ ...newArea([[-52, 69], [-51, 69], [-51, 69.5]], i), name })) };
    expect(editFor({ input: 'areas/features/0', from: 'bank', to: '', text: '' }, form)).toEqual({ areas: [form.areas[1]] });
    expect(editFor({ input: 'areas', from: '2 areas', to: null, text: '' }, form)).toEqual({ areas: [] });
    expect(editFor({ input: 'areas/features/2', from: '', to: '', text: '' }, form)).toBeUndefined();
  });

  it('takes in a change with another that belongs to it, or neither', () => {
    const margin = { input: 'margin_m', from: 500, to: 320, text: '' };
    const depth = { input: 'altimeter_margin_m', from: 20, to: 12, text: '' };
    expect(editFor({ ...margin, with: [depth] }, good)).toEqual({ margin_m: '320', altimeter_margin_m: '12' });
    expect(editFor({ ...margin, with: [{ ...depth, input: 'nothing_known' }] }, good)).toBeUndefined();
  });

  it('is undone field by field', () => {
    edit({ from: '6' }, 'from');
    edit({ from: '69' }, 'from');
    edit({ to: '68' }, 'to');
    undo();
    expect(draft.value).toMatchObject({ from: '69', to: '' });
    undo();
    expect(draft.value.from).toBe('');
    redo();
    expect(draft.value.from).toBe('69');
  });

  it('takes each area that is removed back by itself', () => {
    const area = newArea([[-52, 69], [-51, 69], [-51, 70]], 1);
    edit({ areas: [area, { ...area, name: 'second' }] });
    edit({ areas: [area] });
    edit({ areas: [] });
    expect(undo()?.title).toBe('removing an area');
    expect(draft.value.areas).toHaveLength(1);
    undo();
    expect(draft.value.areas).toHaveLength(2);
    undo();
  });
});
