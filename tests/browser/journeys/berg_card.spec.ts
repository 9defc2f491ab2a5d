import type { APIRequestContext } from '@playwright/test';
import { expectAccessible } from '../support/accessible';
import { expect, mapAtRest, open, pixelOf, planByTyping, test, type LonLat } from '../support/page';
import { findPlaces } from '../support/places';

interface Berg {
  geometry: { coordinates: LonLat };
  properties: { berg_id: string };
}

/** One that lies apart, so that no other is hit. */
async function loneBerg(request: APIRequestContext): Promise<Berg> {
  const { features } = (await (await request.get('/collections/icebergs/items?limit=200')).json()) as { features: Berg[] };
  const away = (a: LonLat, b: LonLat): number => Math.hypot((a[0] - b[0]) * 0.36, a[1] - b[1]);
  const nearest = (berg: Berg): number => Math.min(...features.filter((other) => other !== berg).map((other) => away(berg.geometry.coordinates, other.geometry.coordinates)));
  const [berg] = [...features].sort((a, b) => nearest(b) - nearest(a));
  if (!berg) throw new Error('The store has no icebergs.');
  return berg;
}

test('a click on an iceberg opens its card with source, size, keel, history and forecast', async ({ page, request }) => {
  const berg = await loneBerg(request);
  await open(page);
  const { x, y } = await pixelOf(page, berg.geometry.coordinates);
  await page.mouse.click(x, y);
  const card = page.getByRole('region', { name: `Iceberg ${berg.properties.berg_id}` });
  await expect(card).toContainText('icebergs');
  for (const word of ['Seen', 'Size', 'Keel', 'History', 'Expected now', 'Forecast to']) await expect(card).toContainText(word);
  await expect(card).toContainText(/\d sighting/);
  await expectAccessible(page);
  const legend = page.locator('.legend');
  const gap = async (): Promise<number> => {
    const [above, below] = [await card.boundingBox(), await legend.boundingBox()];
    return (below?.y ?? NaN) - (above?.y ?? NaN) - (above?.height ?? NaN);
  };
  await expect.poll(gap).toBeGreaterThan(0);
  await page.locator('#map').focus();
  await page.keyboard.press('Escape');
  await expect(card).toHaveCount(0);
  await expect(legend).toHaveAttribute('open');
});

test('the figure of the nearest iceberg names it and leads to its card', async ({ page, request }) => {
  const { start, goal } = await findPlaces(request);
  await open(page);
  await planByTyping(page, start, goal);
  const before = await page.locator('#map').getAttribute('data-view');
  const figure = page.getByRole('complementary', { name: 'Waypoints' }).getByTitle(/^Show iceberg /);
  const name = await figure.locator('small').innerText();
  await figure.click();
  const card = page.getByRole('region', { name: `Iceberg ${name}` });
  await expect(card).toContainText('forecast error ±');
  await expect(card).toContainText('Kept clear');
  await mapAtRest(page);
  expect(await page.locator('#map').getAttribute('data-view')).not.toBe(before);
  await expectAccessible(page);
});

test('the probe leads to the keel of the nearest iceberg', async ({ page, request }) => {
  const berg = await loneBerg(request);
  await open(page);
  await page.getByRole('button', { name: /^Probe/ }).click();
  const { x, y } = await pixelOf(page, berg.geometry.coordinates);
  await page.mouse.click(x, y);
  const probe = page.getByRole('region', { name: 'Probe' });
  await probe.getByRole('button', { name: berg.properties.berg_id }).focus();
  await page.keyboard.press('Enter');
  await expect(page.getByRole('region', { name: `Iceberg ${berg.properties.berg_id}` })).toContainText('Keel');
  await expect(probe).toBeHidden();
});
