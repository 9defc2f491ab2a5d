import { expect, open, settled, test } from '../support/page';

test('icebergs have ghosts where they are expected, and the layer puts them away', async ({ page }) => {
  await open(page);
  const map = page.locator('#map');
  await expect(map).not.toHaveAttribute('data-drifts', '0');
  expect(await map.getAttribute('data-drifts')).toBe(await map.getAttribute('data-icebergs'));
  await expect(page.getByText('expected, within the ring')).toBeVisible();

  const drift = page.getByRole('button', { name: 'Show iceberg drift' });
  await drift.focus();
  await page.keyboard.press('Enter');
  await expect(map).toHaveAttribute('data-drifts', '0');
  await page.keyboard.press('Enter');
  await settled(page);
  await expect(map).not.toHaveAttribute('data-drifts', '0');
});

test('a server that cannot forecast the drift is asked once', async ({ page }) => {
  let asked = 0;
  await page.route('**/map/drift?**', async (route) => {
    ++asked;
    await route.fulfill({ status: 400, contentType: 'application/problem+json', body: '{"title":"no","status":400,"detail":"no"}' });
  });
  await open(page);
  await expect(page.locator('#map')).toHaveAttribute('data-drifts', '0');
  const before = asked;
  await page.getByRole('button', { name: 'One hour on (.)' }).click();
  await settled(page);
  expect(asked - before).toBeLessThanOrEqual(1);
});
