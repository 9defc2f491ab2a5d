import { mkdtempSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { APIRequestContext, Locator, Page } from '@playwright/test';
import { expect, mapAtRest, open, planByTyping, settled, test as base, typed, type LonLat } from '../support/page';
import { startServer, type Server } from '../support/server';

// The pictures of the guide, in web/guide/pictures. Each is compared with the page of today. `tests/browser/run.sh BINARY --update`
// writes those anew that differ. Look at each before you commit it.

/** Every picture has a server of its own, so that none shows what another has planned. */
const test = base.extend<{ scenario: 'disko' | 'pack-ice'; own: Server }>({
  scenario: ['disko', { option: true }],
  own: async ({ scenario }, use) => {
    const server = await startServer({ empty: scenario === 'pack-ice' });
    if (scenario === 'pack-ice') addPackIce(server);
    await use(server);
    await server.stop();
  },
  baseURL: async ({ own }, use) => use(own.url),
});

test.use({ viewport: { width: 1200, height: 750 }, contextOptions: { reducedMotion: 'reduce' } });

function addPackIce(server: Server): void {
  const folder = mkdtempSync(join(tmpdir(), 'floeplan-pack-ice-'));
  server.run('demo', folder, '--scenario', 'pack-ice', '--start', '2026-11-22');
  server.run('ingest', ...readdirSync(folder).filter((name) => name.startsWith('pack-ice')).map((name) => join(folder, name)));
  rmSync(folder, { recursive: true });
}

/** Start and goal of the first mission in the guide. */
const start: LonLat = [-53.2, 69.2];
const goal: LonLat = [-51.8, 69.15];

async function plan(request: APIRequestContext, inputs: object): Promise<void> {
  const answer = await request.post('/processes/plan-route/execution', { data: { inputs }, headers: { Prefer: 'respond-sync' } });
  expect(answer.status(), await answer.text()).toBe(200);
}

async function select(page: Page, name: string): Promise<void> {
  await page.getByRole('button', { name: /^Plans/ }).click();
  await page.locator('.plan-choose', { hasText: name }).click();
  await settled(page);
}

/** Compares what is shown with the picture of this name, once the map stands still and the pointer is out of the way. */
async function expectPicture(page: Page, name: string, part: Page | Locator = page): Promise<void> {
  await page.mouse.move(0, 0);
  await mapAtRest(page);
  await settled(page);
  const picture = { maxDiffPixelRatio: 0.003 };
  await ('goto' in part ? expect(part).toHaveScreenshot(`${name}.png`, picture) : expect(part).toHaveScreenshot(`${name}.png`, picture));
}

test('the first mission is pictured as it is planned', async ({ page }) => {
  await open(page);
  await page.getByRole('textbox', { name: /^Departure/ }).fill('2026-11-22 06:00');
  await planByTyping(page, start, goal);
  await expectPicture(page, 'first-mission');

  await page.getByRole('button', { name: 'Export mission' }).click();
  const dialog = page.getByRole('dialog');
  await expect(dialog.locator('pre')).toContainText('<start:waypoints>');
  await expectPicture(page, 'export', dialog);
});

test('the panel of planning is pictured with a part of it unfolded', async ({ page }) => {
  await page.setViewportSize({ width: 1200, height: 1280 });
  await open(page);
  await page.getByRole('textbox', { name: /^Departure/ }).fill('2026-11-22 06:00');
  await page.getByLabel('Start', { exact: true }).fill(typed(start));
  await page.getByLabel('Goal', { exact: true }).fill(typed(goal));
  await page.getByText('Departure window', { exact: true }).click();
  await expectPicture(page, 'set-up', page.locator('.left'));
});

test('a window of departures and a comparison are pictured', async ({ page, request }) => {
  const inputs = { from: start, to: [-52.9, 69.2] };
  await page.setViewportSize({ width: 1200, height: 1150 });
  await plan(request, { ...inputs, name: 'In the evening', depart: '2026-11-22T18:00:00Z' });
  await plan(request, { ...inputs, name: 'Best of the day', depart: '2026-11-22T06:00:00Z', depart_until: '2026-11-23T00:00:00Z', depart_step: 'PT3H' });
  await open(page);
  await page.getByRole('button', { name: 'Departures', exact: true }).click();
  await page.getByText('Departures in figures').click();
  await expectPicture(page, 'departures', page.locator('.right'));
  await page.getByRole('button', { name: /^Plans/ }).click();
  await page.getByRole('checkbox', { name: 'Show In the evening on the map' }).check();
  await page.getByRole('button', { name: /^Compare/ }).click();
  await expectPicture(page, 'compare', page.getByRole('dialog'));
});

test('flights in the test bed are pictured', async ({ page, request }) => {
  await plan(request, { from: start, to: [-53.1, 69.22], name: 'A short leg', depart: '2026-11-22T06:00:00Z' });
  await open(page);
  await select(page, 'A short leg');
  await page.getByRole('button', { name: 'Flights', exact: true }).click();
  await page.getByLabel('Flights', { exact: true }).fill('5');
  await page.getByLabel('Obstacle avoidance on board').uncheck();
  await page.getByRole('button', { name: 'Simulate this plan' }).click();
  await expect(page.locator('#map')).toHaveAttribute('data-flight', '0', { timeout: 120_000 });
  await page.getByRole('button', { name: 'Fit the map to this plan' }).click();
  await page.getByRole('region', { name: 'Statistics' }).evaluate((part) => {
    const panel = part.closest('aside');
    panel?.scrollBy(0, part.getBoundingClientRect().top - panel.getBoundingClientRect().top - 60);
  });
  await expectPicture(page, 'test-bed');
});

test.describe('under pack ice', () => {
  test.use({ scenario: 'pack-ice' });

  test('a plan from lead to lead is pictured', { tag: '@long' }, async ({ page, request }) => {
    const under_ice = { max_time_without_surfacing_s: 43_200, escape_plan: true };
    await plan(request, { from: [-65.5, 73], to: [-62.5, 73], name: 'From lead to lead', depart: '2026-11-22T06:00:00Z', under_ice });
    await open(page);
    await select(page, 'From lead to lead');
    await page.getByRole('button', { name: 'Fit the map to this plan' }).click();
    // The hour at which the vehicle passes the icebergs.
    await page.getByLabel('Time', { exact: true }).fill(String(Date.parse('2026-11-23T17:00:00Z')));
    await expectPicture(page, 'under-ice');
  });
});
