import { expect, open, test } from '../support/page';

test('on a narrow screen the panels are drawers and the page does not scroll sideways', async ({ page }) => {
  await page.setViewportSize({ width: 320, height: 640 });
  await open(page);
  const start = page.getByLabel('Start', { exact: true });
  await expect(start).toBeHidden();
  await page.getByRole('button', { name: 'Set-up and plans' }).click();
  await expect(start).toBeVisible();
  await page.keyboard.press('Escape');
  await expect(start).toBeHidden();
  const overflow = await page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
  expect(overflow).toBeLessThanOrEqual(0);
});
