import { describe, expect, it } from 'vitest';
import type { Dataset } from '../../src/contract/data_types';
import type { Infeasible, JobStatus } from '../../src/contract/types';
import { attempted, causeIn, isFailureOld, mayHelpWithoutCurrents, outcomeTitle, progressInWords, stageTitle } from '../../src/model/job';
import { datasets } from '../../src/model/datasets';
import { draft, edit } from '../../src/model/setup/draft';
import { undo } from '../../src/model/undo';

const job = (part: Partial<JobStatus>): JobStatus => ({
  jobID: 'a', type: 'process', processID: 'plan-route', status: 'running', message: '', progress: 10, stage: 'search', created: '', updated: '', links: [], ...part,
});

describe('a job in words', () => {
  it('tells why its route is not possible while it looks for what would help', () => {
    const refused = job({ stage: 'not possible as asked: the goal lies on land' });
    expect(causeIn(refused)).toBe('The goal lies on land.');
    expect(stageTitle(refused)).toBe('Not possible as asked. Looking for what would help');
    expect(causeIn(job({}))).toBeUndefined();
    expect(progressInWords(job({ progress: 45 }))).toBe('Searching the route, 45 %.');
  });

  it('is not called successful in a list where it found no route', () => {
    expect(outcomeTitle(job({ status: 'successful', message: 'no route: the goal lies on land' }))).toBe('no route');
    expect(outcomeTitle(job({ status: 'successful' }))).toBe('successful');
    expect(outcomeTitle(job({ status: 'failed', message: 'no route: to the server' }))).toBe('failed');
  });

  it('has an old failure as long as the set-up differs from that of the attempt', () => {
    edit({ to: '69 N 52 W' });
    attempted.value = draft.peek();
    expect(isFailureOld.value).toBe(false);
    edit({ to: '69 N 53 W' });
    expect(isFailureOld.value).toBe(true);
    undo();
    expect(isFailureOld.value).toBe(false);
  });

  it('is not advised to plan without currents where the bathymetry ends, too', () => {
    const bathymetry = { id: 'depths', kind: 'bathymetry', bbox: [-54, 68, -50, 70] } as unknown as Dataset;
    datasets.value = [bathymetry];
    const refused = (lon: number, binding_constraint = 'data_area'): Infeasible =>
      ({ at: { lon, lat: 69 }, binding_constraint, datasets: [{ id: 'depths', kind: 'bathymetry', name: '', sha256: '' }] }) as unknown as Infeasible;
    expect(mayHelpWithoutCurrents(refused(-52))).toBe(true);
    expect(mayHelpWithoutCurrents(refused(-49.9))).toBe(false);
    expect(mayHelpWithoutCurrents(refused(-49.9, 'current'))).toBe(true);
    expect(mayHelpWithoutCurrents(refused(-52, 'land'))).toBe(false);
    datasets.value = undefined;
  });
});
