import { expectAccessible } from '../support/accessible';
import { signlessDepths } from '../support/files';
import { expect, open, planByTyping, test, typed } from '../support/page';
import { findPlaces } from '../support/places';

test('an empty store offers to take files, for everyone', async ({ page }) => {
  await page.route('**/datasets', (route) => route.fulfill({ json: { datasets: [] } }));
  await page.goto('/');
  const empty = page.getByRole('region', { name: 'Empty store' });
  await expect(empty.getByRole('button', { name: 'Add files …' })).toBeVisible();
  await expectAccessible(page);
  await page.getByRole('button', { name: 'Data', exact: true }).click();
  await expect(page.getByText('Nothing yet.')).toBeVisible();
  await expectAccessible(page);
});

test('a page that still waits, and a server that is gone, are plain to everyone', async ({ page }) => {
  let answer: (() => void) | undefined;
  await page.route('**/datasets', async (route) => {
    await new Promise<void>((resolve) => {
      answer = resolve;
    });
    await route.abort();
  });
  await page.goto('/');
  await expect(page.getByText('Reading the store …')).toBeVisible();
  await expect(page.getByRole('button', { name: 'Plan route' })).toBeDisabled();
  await expectAccessible(page);
  answer?.();
  await expect(page.getByText('The server does not answer')).toBeVisible();
  await expect(page.getByLabel('Vehicle')).toContainText('Not known');
  await expectAccessible(page);
  await page.getByRole('button', { name: 'Data', exact: true }).click();
  await expect(page.getByText('What the store holds is not known')).toBeVisible();
});

test('without a connection planning says so and what was typed stays', { tag: '@long' }, async ({ page, context, request }) => {
  const { start, goal } = await findPlaces(request);
  await open(page);
  await page.getByLabel('Start', { exact: true }).fill(typed(start));
  await page.getByLabel('Goal', { exact: true }).fill(typed(goal));
  await context.setOffline(true);
  await page.getByRole('button', { name: /^Plan / }).click();
  await expect(page.getByRole('alert').filter({ hasText: 'does not answer' })).toBeVisible();
  await expect(page.getByLabel('Start', { exact: true })).toHaveValue(typed(start));
  await expectAccessible(page);
  await context.setOffline(false);
  await page.getByRole('button', { name: /^Plan / }).click();
  await expect(page.locator('#map')).not.toHaveAttribute('data-plans', '0', { timeout: 120_000 });
});

test('sending, a refusal, coverage and playback can be used by everyone, by day and by night', { tag: '@long' }, async ({ page, request }) => {
  const { start, goal } = await findPlaces(request);
  await open(page);
  await planByTyping(page, start, goal);
  await page.getByRole('button', { name: 'Data', exact: true }).click();
  let send: (() => void) | undefined;
  await page.route('**/uploads?**', async (route) => {
    await new Promise<void>((resolve) => {
      send = resolve;
    });
    await route.continue();
  });
  await page.getByLabel('Files to add').setInputFiles([signlessDepths()]);
  const card = page.getByRole('region', { name: 'Import of levels.asc' });
  await expect(card.getByRole('progressbar', { name: /sending/ })).toBeVisible();
  await expectAccessible(page);
  send?.();
  await expect(card).toContainText('Refused');
  await page.getByRole('button', { name: /^Show the coverage of/ }).first().click();
  await expectAccessible(page);
  await page.getByRole('button', { name: /^Use the dark theme/ }).click();
  await expectAccessible(page);
  await page.getByRole('button', { name: 'Play (Space)' }).click();
  await expectAccessible(page);
  await page.getByRole('button', { name: 'Pause (Space)' }).click();
});

test('the middle of the map is probed with the keyboard alone', { tag: '@long' }, async ({ page }) => {
  await open(page);
  await page.locator('#map').focus();
  await page.keyboard.press('i');
  const card = page.getByRole('region', { name: 'Probe' });
  await expect(card.getByText('Sea bed')).toBeVisible();
  await expectAccessible(page);
  await card.getByRole('button', { name: 'Close the probe' }).focus();
  await page.keyboard.press('Enter');
  await expect(card).toBeHidden();
});
