import type { Page } from '@playwright/test';
import { expectAccessible } from '../support/accessible';
import { expect, mapAtRest, open, pixelOf, settled, test, typed, type LonLat } from '../support/page';

const west: LonLat = [-52.6, 69.15];
const east: LonLat = [-52.2, 69.13];

/** The texts that a screen reader speaks by itself. */
const spoken = (page: Page) => page.locator('[aria-live=polite]');

const widerThanScreen = (page: Page): Promise<number> => page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);

async function planned(page: Page, act: () => Promise<void>): Promise<void> {
  const before = Number(await page.locator('#map').getAttribute('data-plans'));
  await act();
  await expect(page.locator('#map')).toHaveAttribute('data-plans', String(before + 1), { timeout: 120_000 });
  await settled(page);
}

test('a mission is planned, read and exported by what a screen reader is told', { tag: '@long' }, async ({ page }) => {
  await open(page);
  const setup = page.getByRole('form', { name: 'Set-up' });
  await setup.getByRole('textbox', { name: 'Start', exact: true }).fill(typed(west));
  await setup.getByRole('textbox', { name: 'Goal', exact: true }).fill('nowhere');
  await setup.getByRole('button', { name: /^Plan / }).click();
  await expect(spoken(page)).toContainText('The set-up has faults');
  await expect(setup.getByRole('textbox', { name: 'Goal', exact: true })).toBeFocused();
  await expect(setup.getByRole('textbox', { name: 'Goal', exact: true })).toHaveAccessibleDescription(/.+/);
  await setup.getByRole('textbox', { name: 'Goal', exact: true }).fill(typed(east));
  await planned(page, async () => {
    await page.keyboard.press('Enter');
    await expect(spoken(page)).toHaveText(/^Planning has begun|^Plan ready/);
  });
  await expect(spoken(page)).toContainText(/^Plan ready: \d+ h \d\d min, \d+ waypoints\./);

  const result = page.getByRole('complementary', { name: 'Waypoints' });
  await expect(result.getByRole('heading', { level: 2 })).toBeVisible();
  const table = result.getByRole('table');
  await expect(table.getByRole('columnheader', { name: 'Position' })).toBeVisible();
  const first = table.getByRole('button', { name: 'Waypoint 1', exact: true });
  await first.focus();
  await page.keyboard.press('Enter');
  await expect(first).toHaveAttribute('aria-pressed', 'true');
  await expect(page.getByRole('slider', { name: 'Time' })).toHaveAttribute('aria-valuetext', /UTC/);
  await expectAccessible(page);

  const exporting = result.getByRole('button', { name: 'Export mission' });
  await exporting.focus();
  await page.keyboard.press('Enter');
  const dialog = page.getByRole('dialog', { name: /^Export / });
  await expect(dialog.getByRole('combobox', { name: 'Files for the vehicle' })).toBeVisible();
  await expect(dialog.getByLabel('Text of goto_l10.ma')).toContainText('<start:waypoints>');
  await expectAccessible(page);
  await page.keyboard.press('Escape');
  await expect(exporting).toBeFocused();
  await page.keyboard.press('Control+z');
  await expect(spoken(page)).toHaveText(/^Undone: /);
});

test.describe('at 200 % on a screen of 1280 × 800', () => {
  test.use({ viewport: { width: 640, height: 400 }, deviceScaleFactor: 2 });

  test('a mission is planned, read and exported without scrolling sideways', { tag: '@long' }, async ({ page }) => {
    await open(page);
    expect(await widerThanScreen(page)).toBeLessThanOrEqual(0);
    await page.getByRole('button', { name: 'Set-up and plans' }).click();
    await page.getByLabel('Start', { exact: true }).fill(typed(west));
    await page.getByLabel('Goal', { exact: true }).fill(typed(east));
    await planned(page, () => page.getByRole('button', { name: /^Plan / }).click());
    await page.getByRole('button', { name: 'Waypoints', exact: true }).first().click();
    const result = page.getByRole('complementary', { name: 'Waypoints' });
    await result.getByRole('button', { name: 'Waypoint 1', exact: true }).scrollIntoViewIfNeeded();
    await expect(result.getByRole('button', { name: 'Waypoint 1', exact: true })).toBeInViewport();
    expect(await widerThanScreen(page)).toBeLessThanOrEqual(0);
    await expectAccessible(page);
    await result.getByRole('button', { name: 'Export mission' }).click();
    await expect(page.getByRole('dialog').locator('pre')).toBeVisible();
    expect(await widerThanScreen(page)).toBeLessThanOrEqual(0);
    await expectAccessible(page);
  });
});

test.describe('with a finger', () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true });

  test('start and goal are tapped on the map, the route is planned and a tap undone', { tag: '@long' }, async ({ page }) => {
    await open(page);
    await page.getByRole('button', { name: 'Set-up and plans' }).tap();
    await page.getByRole('button', { name: 'Pick the start on the map' }).tap();
    await mapAtRest(page);
    const tap = async (place: LonLat): Promise<void> => {
      const { x, y } = await pixelOf(page, place);
      await page.touchscreen.tap(x, y);
    };
    await tap(west);
    await expect(page.locator('.prompt')).toContainText('goal');
    await tap(east);
    await expect(page.locator('.prompt')).toBeHidden();
    await page.getByRole('button', { name: 'Set-up and plans' }).tap();
    await expect(page.getByLabel('Goal', { exact: true })).not.toHaveValue('');
    await planned(page, () => page.getByRole('button', { name: /^Plan / }).tap());
    await page.getByRole('toolbar', { name: 'Map tools' }).getByRole('button', { name: 'Undo' }).tap();
    await expect(page.locator('.notice')).toHaveText(/^Undone: planning Plan \d+, which stays in the list\.$/);
    await page.getByRole('toolbar', { name: 'Map tools' }).getByRole('button', { name: 'Undo' }).tap();
    await expect(page.locator('.notice')).toHaveText('Undone: changing “Goal”.');
    await expectAccessible(page);
  });
});
