import { afterEach, describe, expect, it } from 'vitest';
import { setSpan, setTime } from '../../src/model/clock';
import { emptyDraft, fill } from '../../src/model/setup/draft';
import { choiceInWords, icebergChoice } from '../../src/model/setup/iceberg_choice';
import { add, forget } from '../../src/model/plan/plans';
import { oldestThatCounts_ms } from '../../src/model/setup/sighting_age';
import { makePlan } from './make_plan';

afterEach(() => {
  fill(emptyDraft);
  forget('one');
  setSpan('test', undefined);
});

const at = (time: string): void => setTime(Date.parse(time));

describe('the icebergs on the map', () => {
  it('are those of all datasets unless the set-up says otherwise', () => {
    expect(icebergChoice.value).toEqual({ datasets: undefined, max_sighting_age_days: undefined });
    expect(choiceInWords.value).toBeUndefined();
  });

  it('are those of the datasets and of the age that the set-up asks for, and that is said', () => {
    fill({ icebergs: 'several b a', max_sighting_age_days: '1,5' });
    expect(icebergChoice.value).toEqual({ datasets: ['b', 'a'], max_sighting_age_days: 1.5 });
    expect(choiceInWords.value).toBe('of the 2 datasets chosen, seen within 1.5 d');
    fill({ icebergs: 'none' });
    expect(icebergChoice.value).toBeUndefined();
    expect(choiceInWords.value).toBe('left out by the set-up');
  });
});

describe('the icebergs that a plan under way obeys', () => {
  const plan = {
    ...makePlan('one', Array.from({ length: 40 }, (_, i) => [-52 + 0.01 * i, 69])), // from 20 Nov 00:00, 39 h
    datasets: [{ id: 'b', kind: 'icebergs' as const, name: 'bergs', sha256: '' }],
    sightings: { as_of: '2026-11-20T00:00:00Z', max_age_days: 5, oldest: '2026-11-15T00:00:00Z' },
  };

  it('stay on the map past the day boundary: their ages are counted at its departure', () => {
    setSpan('test', { start_ms: Date.parse('2026-11-19T00:00:00Z'), end_ms: Date.parse('2026-11-25T00:00:00Z') });
    add(plan);
    at('2026-11-19T12:00:00Z');
    expect(icebergChoice.value?.departure).toBeUndefined();
    at('2026-11-21T01:00:00Z');
    expect(icebergChoice.value).toEqual({ datasets: undefined, max_sighting_age_days: 5, departure: plan.departure });
    expect(choiceInWords.value).toBe('seen within 5 d, as the plan under way obeys them');
    at('2026-11-22T12:00:00Z'); // it has arrived
    expect(icebergChoice.value?.departure).toBeUndefined();
  });

  it('are drawn though the set-up leaves icebergs out or names others', () => {
    setSpan('test', { start_ms: Date.parse('2026-11-19T00:00:00Z'), end_ms: Date.parse('2026-11-25T00:00:00Z') });
    add(plan);
    at('2026-11-20T01:00:00Z');
    fill({ icebergs: 'none' });
    expect(icebergChoice.value?.datasets).toEqual(['b']);
    fill({ icebergs: 'several a' });
    expect(icebergChoice.value?.datasets).toEqual(['a', 'b']);
  });
});

describe('the age of a sighting', () => {
  it('is counted by whole days', () => {
    expect(oldestThatCounts_ms(Date.parse('2026-11-20T23:59:00Z'), 3)).toBe(Date.parse('2026-11-17T00:00:00Z'));
    expect(oldestThatCounts_ms(Date.parse('2026-11-21T00:00:00Z'), 3)).toBe(Date.parse('2026-11-18T00:00:00Z'));
    expect(oldestThatCounts_ms(Date.parse('2026-11-20T18:00:00Z'), 1.5)).toBe(Date.parse('2026-11-19T00:00:00Z'));
  });
});
