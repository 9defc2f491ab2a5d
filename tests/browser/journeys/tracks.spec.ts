import { expectAccessible } from '../support/accessible';
import { trackLog } from '../support/files';
import { expect, mapAtRest, open, pixelOf, settled, test, type LonLat } from '../support/page';
import type { Locator, Page } from '@playwright/test';

const from: LonLat = [-52.5, 69];
const to: LonLat = [-52.4, 69.02];
/** 0.1 m/s along the vehicle's own x axis, which bears 55.6 degrees there in 2014: 90 - 33.0 of declination - 1.4 of convergence. */
const mean_current = 'mean current 0.10 m/s to 056°';

const slider = (page: Page): Locator => page.getByRole('slider', { name: 'Time' });
const clock = async (page: Page): Promise<string> => new Date(Number(await slider(page).inputValue())).toISOString();
const tracks = (page: Page): Locator => page.getByRole('list', { name: 'Tracks of went_here_nav' });

async function add(page: Page): Promise<void> {
  await page.getByLabel('Files to add').setInputFiles([trackLog([from, to])]);
  await expect(page.getByRole('region', { name: 'Import of went_here_nav.csv' }).getByText('Stored', { exact: true })).toBeVisible();
  await expect(page.locator('#map')).toHaveAttribute('data-tracks', '1');
}

test.describe('in a store that holds nothing else', () => {
  test.use({ baseURL: async ({ emptyServer }, use) => use(emptyServer.url) });

  test('the clock covers the track of a glider', async ({ page }) => {
    await page.goto('/');
    await add(page);
    expect(await clock(page)).toBe('2014-07-24T17:00:00.000Z');
    await page.locator('#map').focus();
    await page.keyboard.press('End');
    expect(await clock(page)).toBe('2014-07-24T19:00:00.000Z');

    await open(page);
    expect(await clock(page)).toBe('2014-07-24T17:00:00.000Z');
    await mapAtRest(page);
    const { x, y } = await pixelOf(page, [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2]);
    await page.mouse.move(x, y);
    await expect(page.locator('.readout')).toContainText('to 120 m');
    await expect(page.locator('.readout')).toContainText(mean_current);
  });
});

test('what the map tells of a track is read, and the clock brought to it, with the keyboard alone', { tag: '@long' }, async ({ page }) => {
  await open(page);
  await page.getByRole('button', { name: 'Data', exact: true }).click();
  await add(page);
  const first = await slider(page).getAttribute('min');
  await expect(tracks(page)).toContainText('to 120 m');
  await expect(tracks(page)).toContainText(mean_current);

  const choice = tracks(page).getByRole('button');
  await choice.focus();
  await page.keyboard.press('Enter');
  await expect(choice).toHaveAttribute('aria-pressed', 'true');
  expect(await clock(page)).toBe('2014-07-24T17:00:00.000Z');
  await settled(page);
  await expectAccessible(page);
  await choice.focus();
  await page.keyboard.press('Enter');
  await expect(choice).toHaveAttribute('aria-pressed', 'false');
  await expect(slider(page)).toHaveAttribute('min', first ?? '');

  page.once('dialog', (dialog) => void dialog.accept());
  const remove = page.getByRole('button', { name: 'Remove went_here_nav', exact: true });
  await remove.focus();
  await page.keyboard.press('Enter');
  await expect(page.locator('#map')).toHaveAttribute('data-tracks', '0');
});

test('a track south of where the polar projections end is shown in Mercator', { tag: '@long' }, async ({ page }) => {
  await open(page);
  await page.getByRole('button', { name: 'Data', exact: true }).click();
  await page.getByLabel('Files to add').setInputFiles([trackLog([[-70.2, 35.0], [-70.0, 35.1]])]);
  await expect(page.locator('#map')).toHaveAttribute('data-tracks', '1');
  await tracks(page).getByRole('button').click();
  await expect(page.locator('#map')).toHaveAttribute('data-view', /"projection":"EPSG:3857"/);
  await mapAtRest(page);
  const view = JSON.parse((await page.locator('#map').getAttribute('data-view')) ?? '{}') as { centre: [number, number] };
  const metres_per_degree = (Math.PI * 6_378_137) / 180;
  expect(Math.abs(view.centre[0] / metres_per_degree + 70.1)).toBeLessThan(0.5);

  page.once('dialog', (dialog) => void dialog.accept());
  await page.getByRole('button', { name: 'Remove went_here_nav', exact: true }).click();
  await expect(page.locator('#map')).toHaveAttribute('data-tracks', '0');
});
