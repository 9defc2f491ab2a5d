import { beforeEach, describe, expect, it } from 'vitest';
import type { Alternative, Plan } from '../../src/contract/types';
import { alternativesTo, bestOf, laterThan, showBesideAlternatives, whyNoAlternatives } from '../../src/model/plan/alternatives';
import { areaOf, areasInputs, isSameArea, newArea } from '../../src/model/area';
import { emptyDraft } from '../../src/model/setup/draft';
import { inputsOf } from '../../src/model/setup/draft_request';
import { add, baselineId, forget, inOrder, plans, select, selectedId, shown } from '../../src/model/plan/plans';
import { makePlan } from './make_plan';

const other = makePlan('other', [[-53, 69], [-52.5, 69.2], [-52, 69]]);
const third = makePlan('third', [[-53, 69], [-52.5, 68.8], [-52.2, 68.9], [-52, 69]]);
const said = ({ plan_id, name, arrival, travel_time_s, distance_m, energy_j }: Plan): Alternative => ({
  plan_id, name, arrival, travel_time_s, distance_m, energy_j,
  message: { code: 'alternative', rank: 'note', place: { lon: -52.5, lat: 69.1 }, values: {}, text: 'this route passes north of the land' },
});
const best: Plan = { ...makePlan('best', [[-53, 69], [-52, 69]]), alternatives: [said(other), said(third)] };

describe('alternatives', () => {
  beforeEach(() => {
    plans.value = [];
    shown.value = [];
    select(undefined);
  });

  it('come onto the map with their plan, which stays the selected one', () => {
    add(best, [other, third]);

    expect(plans.value.map(({ plan_id }) => plan_id)).toEqual(['best', 'other', 'third']);
    expect(shown.value).toEqual(['best', 'other', 'third']);
    expect(selectedId.value).toBe('best');
    expect(bestOf(third)?.best.plan_id).toBe('best');
    expect(bestOf(best)).toBeUndefined();
  });

  it('are left out once they have been deleted', () => {
    add(best, [other, third]);
    forget('other');

    expect(alternativesTo(best).map(({ plan }) => plan.plan_id)).toEqual(['third']);
    forget('best');
    expect(bestOf(third)).toBeUndefined();
  });

  it('stand below their plan in the list, the best first, whatever the server lists first', () => {
    const older = makePlan('older', [[-53, 69], [-52, 69]]);
    const created = (plan: Plan, when: string): Plan => ({ ...plan, created: when });
    const [now, before] = ['2026-11-20T00:00:01Z', '2026-11-20T00:00:00Z'];

    const listed = inOrder([created(older, before), created(other, now), created(third, now), created(best, now)]);

    expect(listed.map(({ plan_id }) => plan_id)).toEqual(['best', 'other', 'third', 'older']);
  });

  it('stand once where two plans have the same', () => {
    const second = { ...best, plan_id: 'second' };
    expect(inOrder([other, best, second]).map(({ plan_id }) => plan_id).sort()).toEqual(['best', 'other', 'second']);
  });

  it('tell how much later than their plan they arrive', () => {
    expect(laterThan(best, said(third))).toBe('2 h 00 min later');
    expect(laterThan(third, said(best))).toBe('2 h 00 min earlier');
    expect(laterThan(best, said(best))).toBe('at the same time');
  });

  it('are compared with their plan alone', () => {
    add(makePlan('unrelated', [[-53, 69], [-52, 69]]));
    add(best, [other, third]);
    select('third');
    showBesideAlternatives(best);

    expect(shown.value).toEqual(['best', 'other', 'third']);
    expect(baselineId.value).toBe('best');
  });

  it('are asked for with one departure and a search alone', () => {
    const form = { ...emptyDraft, from: '69, -53', to: '69, -52', depart: '2026-11-20 06:00', alternatives: '2' };
    const asked = (part: Partial<typeof form>): unknown => {
      const made = inputsOf({ ...form, ...part });
      return 'inputs' in made ? made.inputs.alternatives : made.faults;
    };

    expect(asked({})).toBe(2);
    expect(asked({ alternatives: '' })).toBeUndefined();
    for (const part of [{ depart_until: '2026-11-20 12:00' }, { arrive_by: '2026-11-22 12:00' }, { method: 'direct' as const }]) {
      expect(asked(part)).toBeUndefined();
      expect(whyNoAlternatives({ ...form, ...part })).toBeDefined();
    }
    expect(whyNoAlternatives(form)).toBeUndefined();
  });
});

describe('areas of a plan', () => {
  it('are the same as those of the set-up that they were made from, after the way to the server and back', () => {
    const area = { ...newArea([[-52.1234567, 69], [-52, 69], [-52, 69.1]], 1), from: '2026-11-20 06:00', bottom_m: '50' };
    const [stated] = areasInputs([area]).features;
    const echoed = stated && areaOf({ ...stated, properties: { ...stated.properties, top_m: 0 } });

    expect(echoed && isSameArea(area, echoed)).toBe(true);
    expect(echoed && isSameArea({ ...area, kind: 'stay_in' }, echoed)).toBe(false);
  });

  it('have neither times nor depths where the server states null', () => {
    const area = areaOf({
      geometry: { coordinates: [[[0, 0], [1, 0], [1, 1], [0, 0]]] },
      properties: { kind: 'no_go', name: null, from: null, until: null, top_m: null, bottom_m: null },
    });
    expect(area).toEqual({ kind: 'no_go', name: '', corners: [[0, 0], [1, 0], [1, 1]], from: '', until: '' });
  });
});
