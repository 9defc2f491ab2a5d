import { expect, mapAtRest, open, planByKeyboard, settled, test, typed, typeInto, untilRefused } from '../support/page';
import { bergFile } from '../support/files';
import { findPlaces } from '../support/places';
import type { Locator, Page } from '@playwright/test';

async function press(page: Page, control: Locator): Promise<void> {
  await control.focus();
  await page.keyboard.press('Enter');
}

test('plans are compared and one made the baseline with the keyboard alone', { tag: '@long' }, async ({ page, request }) => {
  const { start, goal } = await findPlaces(request);
  await open(page);
  await planByKeyboard(page, start, goal);
  const depart = page.getByRole('textbox', { name: /^Departure/ });
  const later = new Date(Date.parse(`${(await depart.inputValue()).replace(' ', 'T')}:00Z`) + 3 * 3_600_000);
  await typeInto(page, depart, later.toISOString().slice(0, 16).replace('T', ' '));
  const before = Number(await page.locator('#map').getAttribute('data-plans'));
  await depart.press('Enter');
  await expect(page.locator('#map')).toHaveAttribute('data-plans', String(before + 1), { timeout: 120_000 });

  await press(page, page.getByRole('button', { name: /^Plans/ }));
  await press(page, page.getByRole('button', { name: /^Compare/ }));
  const table = page.getByRole('region', { name: 'Comparison table' });
  await expect(table.locator('.difference').first()).toBeVisible();
  await press(page, table.getByRole('button', { name: 'Travel time' }));
  await expect(table.getByRole('columnheader', { name: /Travel time/ })).toHaveAttribute('aria-sort', 'ascending');
  const first = table.getByRole('radio').first();
  await first.focus();
  await page.keyboard.press('ArrowDown');
  await expect(first).not.toBeChecked();
  await page.keyboard.press('Escape');
  await expect(table).toBeHidden();

  await page.locator('#map').focus();
  await page.keyboard.press('1');
  await expect(page.getByRole('complementary', { name: 'Waypoints' }).getByRole('heading', { level: 2 }).first()).toContainText('A');
  await page.keyboard.press('2');
  await expect(page.getByRole('complementary', { name: 'Waypoints' }).getByRole('heading', { level: 2 }).first()).toContainText('B');
});

test('new ice is checked and a plan made before judged on it with the keyboard alone', { tag: '@long' }, async ({ page, request }) => {
  const { start, goal } = await findPlaces(request);
  await open(page);
  await planByKeyboard(page, start, goal);
  await press(page, page.getByRole('button', { name: 'Data', exact: true }));
  const opened = page.waitForEvent('filechooser');
  await press(page, page.getByRole('button', { name: 'Add files …' }));
  const { name, text } = bergFile(start);
  await (await opened).setFiles([{ name, mimeType: 'application/geo+json', buffer: Buffer.from(text) }]);
  await expect(page.getByRole('region', { name: `Import of ${name}` })).toContainText('2 accepted, 1 refused');
  const stale = page.getByRole('region', { name: 'Stale data' });
  await press(page, stale.getByRole('button', { name: 'Re-check' }));
  await expect(stale).toContainText(/The route holds|Show the place/, { timeout: 60_000 });

  page.once('dialog', (dialog) => void dialog.accept());
  await press(page, page.getByRole('button', { name: 'Remove sighted-today', exact: true }));
  await expect(page.getByRole('button', { name: 'Remove sighted-today', exact: true })).toHaveCount(0);
});

test('the view is handed over and a draft taken up again with the keyboard alone', { tag: '@long' }, async ({ page, context, request }) => {
  const { start } = await findPlaces(request);
  await context.grantPermissions(['clipboard-read', 'clipboard-write']);
  await open(page);
  await typeInto(page, page.getByLabel('Start', { exact: true }), typed(start));
  await page.locator('#map').focus();
  await page.keyboard.press(']');
  const time = await page.getByRole('slider', { name: 'Time' }).inputValue();
  await press(page, page.getByRole('button', { name: 'Copy a link to this view' }));
  await expect(page.locator('.notice')).toContainText(/link to this view/);
  const link = await page.evaluate(() => navigator.clipboard.readText());
  expect(new URL(link).origin).toBe(new URL(page.url()).origin);

  const theirs = await context.newPage();
  await theirs.goto(link);
  await settled(theirs);
  await expect(theirs.getByRole('slider', { name: 'Time' })).toHaveValue(time);
  await expect(theirs.getByLabel('Start', { exact: true })).toHaveValue(typed(start));
});

test('a plan that fails is explained, and a change that helps taken, with the keyboard alone', { tag: '@long' }, async ({ page, request }) => {
  const { start, land } = await findPlaces(request);
  await open(page);
  await typeInto(page, page.getByLabel('Start', { exact: true }), typed(start));
  const goal = page.getByLabel('Goal', { exact: true });
  await typeInto(page, goal, typed(land));
  await page.keyboard.press('Enter');
  const failure = page.getByRole('alert', { name: 'No plan is possible' });
  await expect(failure).toContainText(/goal/i, untilRefused);
  await mapAtRest(page);
  const view = await page.locator('#map').getAttribute('data-view');
  await press(page, failure.locator('.failure-place').getByRole('button'));
  await expect(page.locator('#map')).not.toHaveAttribute('data-view', view ?? '');
  await press(page, page.getByRole('group', { name: 'Changes that help' }).getByRole('button').first());
  await expect(goal).not.toHaveValue(typed(land));
});

test('a plan is flown and its flight played back with the keyboard alone', { tag: '@long' }, async ({ page, request }) => {
  const { start } = await findPlaces(request);
  await open(page);
  await press(page, page.getByText('Data', { exact: true }).last());
  const ice = page.getByLabel('Sea ice', { exact: true });
  await ice.focus();
  await page.keyboard.type('None');
  await expect(ice).toHaveValue('none');
  await planByKeyboard(page, start, [start[0] + 0.06, start[1] + 0.02]);
  await press(page, page.getByRole('button', { name: 'Flights', exact: true }));
  await page.getByRole('form', { name: 'Simulate' }).getByLabel('Seed').focus();
  await page.keyboard.press('Enter');
  await expect(page.locator('#map')).toHaveAttribute('data-flight', '0', { timeout: 120_000 });

  const flight = page.getByRole('region', { name: 'Flight 1', exact: true });
  const depth = flight.locator('.flight-now div', { hasText: 'Depth' }).locator('dd');
  await page.locator('#map').focus();
  await page.keyboard.press('.'); // an hour after the departure, where the clock stands
  await expect(depth).toHaveText(/m$|surface/);
  await press(page, flight.getByText('What happened'));
  const surfaced = flight.getByRole('listitem').filter({ hasText: /Surfaced/ }).first();
  await press(page, surfaced.getByRole('button'));
  await expect(depth).toHaveText(/^(surface|\d m)$/); // rows of the track are a minute apart

  await press(page, page.getByRole('button', { name: 'Remove this simulation' }));
  await expect(page.locator('#map')).toHaveAttribute('data-flight', 'none');
});
