import { expect, open, pixelOf, planAndWait, test } from '../support/page';
import { findPlaces } from '../support/places';

test('a first plan is made with the mouse alone', async ({ page, request }) => {
  const { start, goal } = await findPlaces(request);
  await open(page);
  await expect(page.locator('#map')).toHaveAttribute('data-currents', 'shown');

  await page.getByRole('button', { name: 'Pick the start on the map' }).click();
  const from = await pixelOf(page, start);
  await page.mouse.click(from.x, from.y);
  await expect(page.getByLabel('Start', { exact: true })).toHaveValue(/\d+°\d+\.\d+′[NS] \d+°\d+\.\d+′[EW]/);
  // The map asks for the goal by itself; who presses its button all the same is not taken to give up.
  const pick = page.getByRole('button', { name: 'Pick the goal on the map' });
  await expect(pick).toHaveAttribute('aria-pressed', 'true');
  await pick.click();
  const to = await pixelOf(page, goal);
  await page.mouse.click(to.x, to.y);
  await expect(page.getByLabel('Goal', { exact: true })).toHaveValue(/\d+°/);

  await planAndWait(page);
  const table = page.getByRole('region', { name: 'Waypoints' });
  expect(await table.getByRole('row').count()).toBeGreaterThan(2);
  for (const place of [start, goal]) {
    const pixel = await pixelOf(page, place);
    const box = await page.locator('#map').boundingBox();
    expect(pixel.x).toBeGreaterThan(box?.x ?? 0);
    expect(pixel.x).toBeLessThan((box?.x ?? 0) + (box?.width ?? 0));
  }
});

test('the probe tells what is known at a place', async ({ page, request }) => {
  const { start } = await findPlaces(request);
  await open(page);
  await page.getByRole('button', { name: /^Probe/ }).click();
  const pixel = await pixelOf(page, start);
  await page.mouse.click(pixel.x, pixel.y);
  const card = page.getByRole('region', { name: 'Probe' });
  await expect(card.getByText('Sea bed')).toBeVisible();
  await expect(card).toContainText(/m\/s to \d+°/);
});
