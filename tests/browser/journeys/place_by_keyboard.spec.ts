import { expectAccessible } from '../support/accessible';
import { expect, mapAtRest, open, test } from '../support/page';

test('start, goal, area and via points are set on the map with the keyboard alone', async ({ page }) => {
  await open(page);
  await page.keyboard.press('s');
  const map = page.locator('#map');
  await expect(map).toBeFocused();
  await expect(page.locator('.map-cross')).toBeVisible();
  await expect(page.locator('.prompt .by-key')).toBeVisible();
  await expectAccessible(page);
  await page.keyboard.press('Space');
  const start = page.getByLabel('Start', { exact: true });
  const goal = page.getByLabel('Goal', { exact: true });
  await expect(start).toHaveValue(/N .*W/);

  await page.keyboard.press('ArrowRight');
  await mapAtRest(page);
  await expect(page.locator('[aria-live=polite]')).toHaveText(/N .*W/);
  await page.keyboard.press('Shift+ArrowUp');
  await mapAtRest(page);
  await page.keyboard.press('Enter');
  await expect(goal).toHaveValue(/N .*W/);
  await expect(page.locator('.map-cross')).toHaveCount(0);

  await page.getByText('Places and areas', { exact: true }).focus();
  await page.keyboard.press('Enter');
  await page.getByRole('button', { name: 'Draw an area' }).focus();
  await page.keyboard.press('Enter');
  await expect(map).toBeFocused();
  for (const key of ['ArrowUp', 'ArrowRight', 'ArrowDown']) {
    await page.keyboard.press('Space');
    await page.keyboard.press(key);
    await mapAtRest(page);
  }
  await expect(page.locator('.prompt')).toContainText('Enter');
  await page.keyboard.press('Space');
  await page.keyboard.press('Backspace');
  await page.keyboard.press('Enter');
  await expect(map).toHaveAttribute('data-areas', '1');
  await expect(page.getByText('3 corners', { exact: true })).toBeVisible();

  await page.getByRole('button', { name: 'Pick via points on the map' }).focus();
  await page.keyboard.press('Enter');
  await page.keyboard.press('Space');
  await expect(page.getByLabel('Via point 1', { exact: true })).toHaveValue(/N .*W/);
  await page.keyboard.press('Escape');
  await page.keyboard.press('Control+z');
  await expect(page.getByLabel('Via point 1', { exact: true })).toHaveCount(0);
});
