import { expect, open, test, typed, typeInto } from '../support/page';
import { findPlaces } from '../support/places';

test('a first plan is made, read and played back with the keyboard alone', { tag: '@long' }, async ({ page, request }) => {
  const { start, goal } = await findPlaces(request);
  await open(page);

  await page.keyboard.press('g');
  await expect(page.getByLabel('Start', { exact: true })).toBeFocused();
  await page.keyboard.type(typed(start));
  await page.keyboard.press('Tab');
  await page.keyboard.press('Tab');
  await expect(page.getByLabel('Goal', { exact: true })).toBeFocused();
  await page.keyboard.type(typed(goal));
  const before = Number(await page.locator('#map').getAttribute('data-plans'));
  await page.keyboard.press('Enter');
  await expect(page.locator('#map')).toHaveAttribute('data-plans', String(before + 1), { timeout: 120_000 });

  const table = page.getByRole('region', { name: 'Waypoints' });
  const second = table.getByRole('button', { name: 'Waypoint 1', exact: true });
  await expect(second).toBeVisible();
  await second.focus();
  await page.keyboard.press('Enter');
  await expect(second).toHaveAttribute('aria-pressed', 'true');

  const slider = page.getByRole('slider', { name: 'Time' });
  await page.getByRole('main').locator('#map').focus();
  await page.keyboard.press('Home');
  const first = Number(await slider.inputValue());
  await page.keyboard.press('.');
  expect(Number(await slider.inputValue())).toBe(first + 3_600_000);
  await expect(slider).toHaveAttribute('aria-valuetext', /UTC/);
  await page.keyboard.press('Space');
  await expect.poll(async () => Number(await slider.inputValue())).toBeGreaterThan(first + 3_600_000);
  await page.keyboard.press('Space');
});

test('faults are shown beside their fields, all at once', async ({ page }) => {
  await open(page);
  await typeInto(page, page.getByLabel('Start', { exact: true }), 'somewhere');
  await typeInto(page, page.getByRole('textbox', { name: /^Departure/ }), 'tomorrow');
  await page.keyboard.press('Enter');
  for (const name of ['Start', 'Goal']) {
    await expect(page.getByLabel(name, { exact: true })).toHaveAttribute('aria-invalid', 'true');
  }
  await expect(page.getByRole('textbox', { name: /^Departure/ })).toHaveAttribute('aria-invalid', 'true');
  await expect(page.getByLabel('Start', { exact: true })).toBeFocused();
});

test('a position with too many minutes stays in its field, which says so when it is left', async ({ page }) => {
  await open(page);
  const start = page.getByLabel('Start', { exact: true });
  await typeInto(page, start, '69 72.0 N 51 21 W');
  await page.keyboard.press('Tab');
  await expect(start).toHaveAttribute('aria-invalid', 'true');
  await expect(page.locator('#fault-from')).toHaveText('The minutes go from 0 to 59.9, not to 72.0.');
  await expect(start).toHaveValue('69 72.0 N 51 21 W');
});

test('what the server refuses is shown beside its field', async ({ page, request }) => {
  const { start, goal } = await findPlaces(request);
  await open(page);
  await page.getByLabel('Start', { exact: true }).fill(typed(start));
  await page.getByLabel('Goal', { exact: true }).fill(typed(goal));
  await page.getByLabel('Iceberg margin').fill('-5');
  await page.getByRole('button', { name: /^Plan / }).click();
  await expect(page.getByLabel('Iceberg margin')).toHaveAttribute('aria-invalid', 'true');
  await expect(page.locator('#fault-margin_m')).not.toBeEmpty();
});
