import { expect, open, test, typed } from '../support/page';
import { findPlaces } from '../support/places';

test('a goal on land is explained, marked on the map and answered with a suggestion', { tag: '@long' }, async ({ page, request }) => {
  const { start, land } = await findPlaces(request);
  await open(page);
  await page.getByLabel('Start', { exact: true }).fill(typed(start));
  await page.getByLabel('Goal', { exact: true }).fill(typed(land));
  await page.getByRole('button', { name: /^Plan / }).click();

  const failure = page.getByRole('alert', { name: 'No plan is possible' });
  await expect(failure).toBeVisible();
  await expect(failure).toContainText(/goal/i);
  await expect(failure.getByRole('group', { name: 'Changes that help' }).getByRole('button').first()).toBeEnabled();
  await expect(page.getByRole('button', { name: /^Plan / })).toBeEnabled();
  await failure.getByRole('button', { name: 'Dismiss this message' }).click();
  await expect(failure).toBeHidden();
});

test('a change that the server proposes is made by its button', async ({ page, request }) => {
  const { start, land } = await findPlaces(request);
  await open(page);
  await page.getByLabel('Start', { exact: true }).fill(typed(start));
  await page.getByLabel('Goal', { exact: true }).fill(typed(land));
  await page.getByRole('button', { name: /^Plan / }).click();
  const change = page.getByRole('group', { name: 'Changes that help' }).getByRole('button').first();
  await change.focus();
  await page.keyboard.press('Enter');
  await expect(page.getByLabel('Goal', { exact: true })).not.toHaveValue(typed(land));
});
