import { expect, mapAtRest, open, pixelOf, test, type LonLat } from '../support/page';
import type { Page } from '@playwright/test';

/** Far apart from west to east, so that a plan is as wide as the map has room for. */
const west: LonLat = [-52.6, 69.15];
const east: LonLat = [-52.2, 69.13];

/** The plan fitted to the map with the legend unfolded; the places of its ends on the screen. */
async function fitBesideLegend(page: Page): Promise<{ x: number; y: number }[]> {
  const legend = page.locator('.legend');
  if ((await legend.getAttribute('open')) === null) await legend.getByText('Legend').click();
  await expect(legend).toHaveAttribute('open');
  await mapAtRest(page);
  await page.getByRole('button', { name: /^Fit the selected plan/ }).click();
  await mapAtRest(page);
  return Promise.all([west, east].map((place) => pixelOf(page, place)));
}

for (const [width, height] of [[1440, 900], [1280, 800], [390, 844]] as const) {
  test(`no plan lies below the unfolded legend at ${width} by ${height}`, async ({ page, request }) => {
    const { datasets } = (await (await request.get('/datasets')).json()) as { datasets: { kind: string; time_start: string }[] };
    const depart = datasets.find(({ kind }) => kind === 'currents')?.time_start;
    const inputs = { from: west, to: east, depart, name: 'Beside the legend', spacing_m: 3000, refine: false, icebergs: 'none' };
    const answer = await request.post('/processes/plan-route/execution', { data: { inputs }, headers: { Prefer: 'respond-sync' } });
    const { plan_id } = ((await answer.json()) as { plan: { plan_id: string } }).plan;
    await page.setViewportSize({ width, height });
    await page.goto(`/#plans=${plan_id}&plan=${plan_id}`);
    await expect(page.locator('#map')).toHaveAttribute('data-ready', 'true');
    await expect(page.locator('#map')).toHaveAttribute('data-plans', '1');

    const ends = await fitBesideLegend(page);
    const legend = await page.locator('.legend').boundingBox();
    const map = await page.locator('#map').boundingBox();
    if (!legend || !map) throw new Error('No legend or no map is on the screen.');
    for (const { x, y } of ends) {
      expect(x).toBeGreaterThan(map.x);
      expect(x).toBeLessThan(map.x + map.width);
      expect(x < legend.x || y < legend.y, `${x}, ${y} beside ${legend.x}, ${legend.y}`).toBe(true);
    }
    await request.delete(`/collections/plans/items/${plan_id}`);
  });
}

test('at 200 % zoom all tools of the map can be reached, and the help has what the bar has no room for', async ({ page }) => {
  await page.setViewportSize({ width: 640, height: 400 }); // a screen of 1280 by 800 at 200 %
  await open(page);
  const map = await page.locator('#map').boundingBox();
  const note = await page.locator('.map-disclaimer').boundingBox();
  if (!map || !note) throw new Error('No map or no note is on the screen.');
  for (const tool of await page.getByRole('toolbar', { name: 'Map tools' }).getByRole('button').all()) {
    const box = await tool.boundingBox();
    expect(box && box.y + box.height, await tool.getAttribute('aria-label') ?? '').toBeLessThan(note.y);
  }
  expect(await page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth)).toBeLessThanOrEqual(0);

  await page.getByRole('button', { name: /^Help and settings/ }).click();
  const help = page.getByRole('dialog');
  await help.getByRole('group', { name: 'Distances' }).getByRole('button', { name: 'NM' }).click();
  await expect(page.locator('.scale-bar')).toContainText('NM');
  await expect(help.getByRole('button', { name: 'Copy a link to this view' })).toBeVisible();
  await help.getByRole('button', { name: 'Jobs' }).click();
  await expect(page.getByRole('dialog', { name: 'Jobs' })).toBeVisible();
});
