import { expectAccessible } from '../support/accessible';
import { expect, open, settled, test } from '../support/page';

test('the holds of a plan are in its table, its figures and its brief', async ({ page, request }) => {
  const { datasets } = (await (await request.get('/datasets')).json()) as { datasets: { kind: string; time_start: string }[] };
  const begin_ms = Date.parse(datasets.find(({ kind }) => kind === 'currents')?.time_start ?? '');
  const after = (hours: number): string => new Date(begin_ms + hours * 3_600_000).toISOString().replace('.000', '');
  const [west, south, east, north] = [-52.3, 69.05, -52.1, 69.2];
  const ring = [[west, south], [east, south], [east, north], [west, north], [west, south]];
  const closed = { type: 'Feature', properties: { name: 'closed till evening', kind: 'no_go', from: after(48), until: after(70) }, geometry: { type: 'Polygon', coordinates: [ring] } };
  const inputs = {
    from: [-52.6, 69.15], to: [-52.2, 69.13], depart: after(54), name: 'Holding', spacing_m: 3000, refine: false, icebergs: 'none', ice: 'none',
    max_loiter_s: 43_200, areas: { type: 'FeatureCollection', features: [closed] },
  };
  const answer = await request.post('/processes/plan-route/execution', { data: { inputs }, headers: { Prefer: 'respond-sync' } });
  const { plan_id } = ((await answer.json()) as { plan: { plan_id: string } }).plan;
  await open(page);
  await page.getByRole('button', { name: /^Plans/ }).click();
  await page.locator('.plan-choose', { hasText: 'Holding' }).click();
  await settled(page);

  const hold = /hold \d h \d\d min at waypoint (S|\d+)/;
  await expect(page.getByRole('region', { name: 'Waypoints' }).getByText(hold)).toBeVisible();
  await expect(page.locator('.figures-grid div', { hasText: 'Holds' })).toHaveAttribute('title', hold);
  await expectAccessible(page);
  const brief = await request.get(`/collections/plans/items/${plan_id}/mission.html`);
  expect(await brief.text()).toMatch(/Hold \d h \d\d min at waypoint (S|\d+)\./);
  await request.delete(`/collections/plans/items/${plan_id}`);
});
