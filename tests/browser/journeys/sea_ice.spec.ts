import type { APIRequestContext, Page } from '@playwright/test';
import { expectAccessible } from '../support/accessible';
import { expect, mapAtRest, open, pixelOf, settled, test, type LonLat } from '../support/page';

/** In the field of drift ice of the demonstration data, and on either side of it. */
const inIce: LonLat = [-52.7, 68.96];
const west: LonLat = [-53.1, 68.96];
const east: LonLat = [-51.85, 68.96];

/** The map around a place, as it is painted. */
async function paintedAround(page: Page, place: LonLat): Promise<Buffer> {
  const { x, y } = await pixelOf(page, place);
  return page.screenshot({ clip: { x: x - 30, y: y - 30, width: 60, height: 60 } });
}

async function planBelowIce(request: APIRequestContext, name: string): Promise<string> {
  const { datasets } = (await (await request.get('/datasets')).json()) as { datasets: { kind: string; time_start: string }[] };
  const depart = datasets.find(({ kind }) => kind === 'ice')?.time_start;
  const inputs = { from: west, to: east, depart, name, spacing_m: 2500, refine: false, icebergs: 'none', under_ice: { escape_plan: true, surfacing_interval_s: 7200 } };
  const answer = await request.post('/processes/plan-route/execution', { data: { inputs }, headers: { Prefer: 'respond-sync' } });
  expect(answer.status(), await answer.text()).toBe(200);
  return ((await answer.json()) as { plan: { plan_id: string } }).plan.plan_id;
}

test('sea ice is seen on the map and told by pointer, probe, legend and header', async ({ page }) => {
  await open(page);
  await expect(page.locator('#map')).toHaveAttribute('data-sea-ice', 'shown');
  await expect(page.locator('.data-item', { hasText: 'Sea ice' })).toContainText(/\d+–\d+ Nov 00Z/);
  await expect(page.locator('.legend')).toContainText('may surface up to 10 %');

  const { x, y } = await pixelOf(page, inIce);
  await page.mouse.move(x, y);
  await expect(page.locator('.readout')).toContainText(/sea ice \d\d %, \d\.\d m thick/);
  await page.getByRole('button', { name: /^Probe/ }).click();
  await page.mouse.click(x, y);
  const card = page.getByRole('region', { name: 'Probe' });
  await expect(card).toContainText(/Sea ice\d\d %, \d\.\d m thick.*-ice/);
  await expect(card).toContainText('Nearest iceberg');
  await expectAccessible(page);
  await page.getByRole('button', { name: 'Close the probe' }).click();
  await page.keyboard.press('Escape');

  await page.mouse.move(5, 5);
  const withIce = await paintedAround(page, inIce);
  await page.getByRole('button', { name: 'Show sea ice' }).click();
  await settled(page);
  expect(withIce.equals(await paintedAround(page, inIce))).toBe(false);
});

test('after the end of the data no sea ice is held, and the legend leads back', async ({ page }) => {
  await page.route('**/datasets', async (route) => {
    const answer = await route.fetch();
    const stored = (await answer.json()) as { datasets: { kind: string; times?: string[]; time_end: string | null }[] };
    const datasets = stored.datasets.map((dataset) => {
      const times = dataset.times?.slice(0, 2) ?? [];
      return dataset.kind === 'ice' ? { ...dataset, times, time_end: times.at(-1) ?? null } : dataset;
    });
    await route.fulfill({ response: answer, json: { ...stored, datasets } });
  });
  await page.route('**/probe?**', async (route) => {
    const answer = await route.fetch();
    await route.fulfill({ response: answer, json: { ...(await answer.json()) as object, ice_concentration: null } });
  });
  await open(page);
  const map = page.locator('#map');
  await expect(map).toHaveAttribute('data-sea-ice', 'shown');

  await map.focus();
  await page.keyboard.press('End');
  await expect(map).toHaveAttribute('data-sea-ice', 'none');
  await expect(page.locator('.legend')).toContainText('No sea ice data at this time');
  const { x, y } = await pixelOf(page, inIce);
  await page.mouse.move(x, y);
  await expect(page.locator('.readout')).toContainText('sea ice –');

  await page.getByRole('button', { name: /^Go to / }).click();
  await expect(map).toHaveAttribute('data-sea-ice', 'shown');
});

test('a plan below ice says where it may not surface, and its messages lead to their places', async ({ page, request }) => {
  const plan = await planBelowIce(request, 'Below the field');
  await open(page);
  await page.getByRole('button', { name: /^Plans/ }).click();
  const row = page.locator('.plan-choose', { hasText: 'Below the field' });
  await row.click();
  const result = page.locator('.result');
  await expect(result.locator('div', { hasText: /^Below ice\d/ })).toBeVisible();
  await expect(result.locator('div', { hasText: /^Longest without a place to surface\d+ [dh]/ })).toBeVisible();
  await expect(page.getByRole('region', { name: 'Waypoints' }).getByRole('cell', { name: /^no/ }).first()).toBeVisible();
  await expect(row.locator('.badge.bad')).toContainText('1 danger');
  await expect(page.getByRole('region', { name: 'Dangers' })).toContainText(/without a place to surface/);

  await mapAtRest(page);
  const map = page.locator('#map');
  const before = await map.getAttribute('data-view');
  await page.getByRole('region', { name: /Dangers|Cautions/ }).getByTitle('Show on the map').first().click();
  await expect(map).not.toHaveAttribute('data-view', before ?? '');
  await mapAtRest(page);
  await expectAccessible(page);

  await page.getByRole('button', { name: 'Profile' }).click();
  const below = page.getByRole('figure').filter({ hasText: 'Below the ice' });
  await expect(below).toContainText('deepest keel');
  await expect(below).toContainText('upper turn, leg');
  await request.delete(`/collections/plans/items/${plan}`);
});

test('a file that the server refuses is not saved; the export says why', async ({ page, request }) => {
  const plan_id = await planBelowIce(request, 'No Seaglider');
  await open(page);
  await page.getByRole('button', { name: /^Plans/ }).click();
  await page.locator('.plan-choose', { hasText: 'No Seaglider' }).click();
  await page.getByRole('button', { name: 'Export mission' }).click();
  const dialog = page.getByRole('dialog');
  const confirm = dialog.getByLabel('I have read this; export all the same');
  await expect(confirm.or(dialog.locator('pre').first())).toBeVisible();
  if (await confirm.isVisible()) await confirm.check();
  let saved = 0;
  page.on('download', () => (saved += 1));
  await dialog.getByRole('link', { name: 'Seaglider targets' }).click();
  const refusal = dialog.getByRole('alert').filter({ hasText: 'Seaglider targets: no file is written' });
  await expect(refusal).toContainText('passes below ice');
  await expectAccessible(page);
  const waiting = page.waitForEvent('download');
  await dialog.getByRole('link', { name: 'GPX' }).click();
  expect((await waiting).suggestedFilename()).toMatch(/\.gpx$/);
  await expect(refusal).toBeHidden();
  expect(saved).toBe(1);
  await page.keyboard.press('Escape');
  await request.delete(`/collections/plans/items/${plan_id}`);
});
