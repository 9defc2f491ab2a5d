import { expectAccessible } from '../support/accessible';
import { expect, open, planByTyping, settled, test } from '../support/page';
import { findPlaces } from '../support/places';

test('every state can be used by everyone', { tag: '@long' }, async ({ page, request }) => {
  const { start, goal } = await findPlaces(request);
  await open(page);
  await expectAccessible(page);
  for (const part of await page.locator('.parts summary').all()) await part.click();
  await expectAccessible(page);
  await planByTyping(page, start, goal);
  await settled(page);
  await expectAccessible(page);
  await page.getByRole('button', { name: 'Profile', exact: true }).click();
  await expect(page.locator('.uplot').first()).toBeVisible();
  await expectAccessible(page);
  await page.getByRole('button', { name: 'Edit copy' }).click();
  await expectAccessible(page);
  await page.getByRole('button', { name: 'Discard the changes' }).click();
  await page.getByRole('button', { name: 'Export mission' }).click();
  await expect(page.getByRole('dialog').locator('pre')).toBeVisible();
  await expectAccessible(page);
  await page.keyboard.press('Escape');
  await page.getByRole('button', { name: /^Use the dark theme|^Use the light theme/ }).click();
  await expectAccessible(page);
  await page.getByRole('button', { name: /^Plans/ }).click();
  await expectAccessible(page);
});

test('the page carries the strict policy and every projection draws under it', async ({ page }) => {
  const answer = await page.goto('/');
  expect(answer?.headers()['content-security-policy']).toContain("default-src 'self'");
  await settled(page);
  for (const code of ['EPSG:3995', 'EPSG:3996', 'EPSG:3857', 'EPSG:3413']) {
    await page.getByLabel('Projection').selectOption(code);
    await expect(page.locator('#map')).toHaveAttribute('data-view', new RegExp(code));
    await settled(page);
    await expect(page.locator('#map')).toHaveAttribute('data-currents', 'shown');
  }
});

test('units, theme and projection are remembered', async ({ page }) => {
  await open(page);
  await page.getByRole('button', { name: 'NM', exact: true }).click();
  await page.getByRole('button', { name: 'kn', exact: true }).click();
  await page.reload();
  await settled(page);
  await expect(page.getByRole('button', { name: 'NM', exact: true })).toHaveAttribute('aria-pressed', 'true');
  await expect(page.getByRole('img', { name: /^Scale: .* NM/ })).toBeVisible();
});
