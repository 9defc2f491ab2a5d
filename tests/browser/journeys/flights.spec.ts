import type { Page } from '@playwright/test';
import { expectAccessible } from '../support/accessible';
import { expect, open, planByTyping, test, type LonLat } from '../support/page';
import { findPlaces } from '../support/places';

/** A short way over open water: flown in the test bed within a moment. */
async function shortPlan(page: Page, start: LonLat): Promise<void> {
  await page.getByText('Data', { exact: true }).last().click();
  await page.getByLabel('Sea ice', { exact: true }).selectOption('none');
  await planByTyping(page, start, [start[0] + 0.06, start[1] + 0.02]);
}

test('a plan is flown many times, and a flight is played back by the clock', { tag: '@long' }, async ({ page, request }) => {
  const { start } = await findPlaces(request);
  await open(page);
  await shortPlan(page, start);
  await page.getByRole('button', { name: 'Flights', exact: true }).click();
  await expect(page.getByText('Not flown yet.')).toBeVisible();
  await page.getByLabel('Flights', { exact: true }).fill('3');
  await page.getByLabel('Obstacle avoidance on board').uncheck();
  await page.getByRole('button', { name: 'Simulate this plan' }).click();

  const map = page.locator('#map');
  await expect(map).toHaveAttribute('data-flight', '0', { timeout: 120_000 });
  await expect(page.getByRole('region', { name: 'Statistics' })).toContainText('Worst position error');
  await expect(page.getByRole('list', { name: 'How the flights ended' })).toContainText('of 3');
  const flight = page.getByRole('region', { name: 'Flight 1', exact: true });
  await expect(flight.locator('.uplot').first()).toBeVisible();

  const depth = flight.locator('.flight-now div', { hasText: 'Depth' }).locator('dd');
  await page.getByRole('button', { name: 'To the start (Home)' }).click();
  await flight.locator('.u-over').first().click({ position: { x: 60, y: 20 } });
  await expect(depth).toContainText(/m$/);
  // Where plans have their vehicles at the clock's time, then where this flight's believed to be, and where it was.
  const vehicles = async (): Promise<string[]> => ((await map.getAttribute('data-vehicles')) ?? '').split(' ');
  await expect.poll(async () => (await vehicles()).length).toBeGreaterThanOrEqual(3);
  const earlier = await vehicles();
  await flight.locator('.u-over').first().click({ position: { x: 120, y: 20 } });
  await expect.poll(async () => (await vehicles()).at(-1)).not.toBe(earlier.at(-1));
  await expect.poll(async () => (await vehicles()).slice(0, -2).join(' ')).not.toBe(earlier.slice(0, -2).join(' '));
  await expect(flight.locator('.flight-now div', { hasText: 'Cross-track' }).locator('dd')).toContainText(/left|right/);
  await flight.getByText('What happened').click();
  await expect(flight.getByText(/^Surfaced|Waypoint reached/).first()).toBeVisible();

  await page.getByRole('button', { name: 'Play flight 2' }).focus();
  await page.keyboard.press('Enter');
  await expect(map).toHaveAttribute('data-flight', '1');
  const waiting = page.waitForEvent('download');
  await page.getByRole('link', { name: 'GeoJSON' }).click();
  expect((await waiting).suggestedFilename()).toMatch(/\.geojson$/);
  await expectAccessible(page);

  const withFlight = await vehicles();
  const remove = page.getByRole('button', { name: 'Remove this simulation' });
  await remove.click();
  await expect(map).toHaveAttribute('data-flight', 'none');
  await page.keyboard.press('Control+z');
  await expect(page.locator('.notice')).toHaveText('Undone: deleting the simulation.');
  await expect(map).toHaveAttribute('data-flight', '1');
  await remove.click();
  await expect(map).toHaveAttribute('data-flight', 'none');
  await expect.poll(async () => (await vehicles()).join(' ')).toBe(withFlight.slice(0, -2).join(' '));
  await expect(page.getByText('Not flown yet.')).toBeVisible();
});

test('what cannot be flown is explained', async ({ page, request }) => {
  const { start } = await findPlaces(request);
  await open(page);
  await shortPlan(page, start);
  await page.getByRole('button', { name: 'Flights', exact: true }).focus();
  await page.keyboard.press('Enter');
  const runs = page.getByLabel('Flights', { exact: true });
  await runs.fill('many');
  await page.keyboard.press('Enter');
  await expect(page.getByRole('alert').filter({ hasText: 'must be numbers' })).toBeVisible();
  await runs.fill('0');
  await page.keyboard.press('Enter');
  await expect(page.getByRole('alert').filter({ hasText: 'runs' })).toBeVisible();
});
