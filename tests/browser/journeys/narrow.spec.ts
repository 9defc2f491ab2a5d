import { expect, open, planByTyping, test, typed, untilRefused } from '../support/page';
import { findPlaces } from '../support/places';

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

test('on a narrow screen the drawer makes way for the plan that was asked for, and stays for what stands in its way', { tag: '@long' }, async ({ page, request }) => {
  const { start, goal, land } = await findPlaces(request);
  await page.setViewportSize({ width: 390, height: 844 });
  await open(page);
  await page.getByRole('button', { name: 'Set-up and plans' }).click();
  const field = page.getByLabel('Start', { exact: true });
  await field.fill(typed(start));
  await page.getByLabel('Goal', { exact: true }).fill(typed(land));
  await page.getByRole('button', { name: /^Plan / }).click();
  await expect(page.getByRole('alert', { name: 'No plan is possible' })).toBeVisible(untilRefused);
  await planByTyping(page, start, goal);
  await expect(field).toBeHidden();
});
