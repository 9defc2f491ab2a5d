import { beforeEach, describe, expect, it } from 'vitest';
import { conditionsIn } from '../../src/model/setup/requests';
import {
  closeSavedEdit, deliver, discardEdit, insertAfter, moveWaypoint, removeWaypoint, routeEdit, startEdit, whyNotSaved,
} from '../../src/model/plan/route_edit';
import { lastDone, redo, undo } from '../../src/model/undo';
import { makePlan } from './make_plan';

const origin = makePlan('one', [[-52, 69], [-51.5, 69], [-51, 69.1]]);
const edit = (): NonNullable<typeof routeEdit.value> => {
  if (!routeEdit.value) throw new Error('nothing is edited');
  return routeEdit.value;
};

describe('the edit of a route', () => {
  beforeEach(() => {
    closeSavedEdit();
    startEdit(origin);
  });

  it('leaves the plan as it is', () => {
    const before = structuredClone(origin);
    moveWaypoint(1, [-51.4, 69.05]);
    removeWaypoint(0);
    expect(origin).toEqual(before);
  });

  it('is pending after each change, also after undo and redo', () => {
    moveWaypoint(1, [-51.4, 69.05]);
    deliver(1, { state: 'ok', plan: origin });
    undo();
    expect(edit().verdict.state).toBe('pending');
    redo();
    expect(edit().verdict.state).toBe('pending');
    expect(edit().route[1]).toEqual([-51.4, 69.05]);
  });

  it('comes back when its changes were discarded by mistake', () => {
    moveWaypoint(1, [-51.4, 69.05]);
    discardEdit();
    expect(undo()?.title).toBe('discarding the changes of Plan one');
    expect(edit().route[1]).toEqual([-51.4, 69.05]);
    expect(undo()?.title).toBe('moving waypoint 1');
    expect(edit().route[1]).toEqual([-51.5, 69]);
  });

  it('leaves nothing to undo when it is discarded after all its changes were undone', () => {
    const before = lastDone.value;
    moveWaypoint(1, [-51.4, 69.05]);
    undo();
    discardEdit();
    expect(lastDone.value).toBe(before);
    expect(redo()).toBeUndefined();
  });

  it('has no changes to take back once it is a plan', () => {
    moveWaypoint(1, [-51.4, 69.05]);
    closeSavedEdit();
    expect(lastDone.value?.title ?? '').not.toContain('waypoint');
  });

  it('never lets a late answer replace a newer state', () => {
    moveWaypoint(1, [-51.4, 69.05]);
    const asked = edit().number;
    moveWaypoint(1, [-51.3, 69.05]);
    expect(deliver(asked, { state: 'ok', plan: { ...origin, name: 'late' } })).toBe(false);
    expect(edit().verdict.state).toBe('pending');
    expect(edit().figures.name).not.toBe('late');
  });

  it('keeps at least two waypoints', () => {
    removeWaypoint(1);
    removeWaypoint(1);
    expect(edit().route).toHaveLength(2);
  });

  it('inserts half-way along the leg, the last leg where there is none after', () => {
    insertAfter(2);
    expect(edit().route).toHaveLength(4);
    expect(edit().route[2]?.[0]).toBeCloseTo(-51.25, 2);
  });

  it('can be saved only when it was changed and evaluated', () => {
    expect(whyNotSaved(edit())).toMatch(/changed/);
    moveWaypoint(1, [-51.4, 69.05]);
    expect(whyNotSaved(edit())).toBeDefined();
    deliver(1, { state: 'failed', detail: 'no' });
    expect(whyNotSaved(edit())).toBeDefined();
    moveWaypoint(1, [-51.3, 69.05]);
    deliver(2, { state: 'ok', plan: origin });
    expect(whyNotSaved(edit())).toBeUndefined();
  });
});

describe('the conditions of a request', () => {
  it('are all of it but the way', () => {
    expect(conditionsIn({ from: [0, 70], to: [1, 70], via: [], depart: 't', margin_m: 300, method: 'tve', vehicle: 'v' })).toEqual({
      depart: 't', margin_m: 300, vehicle: 'v',
    });
  });
});
