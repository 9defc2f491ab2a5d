import { describe, expect, it } from 'vitest';
import { emptyDraft, inputsOf, sortViolations } from '../../src/model/draft';

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
      { pointer: '/inputs/objective', detail: 'must be "time"' },
    ]);
    expect(faults.depart).toBe('Must be covered by the currents');
    expect(faults.via).toBe('Must be a position');
    expect(general).toEqual(['objective: Must be "time"']);
  });
});
