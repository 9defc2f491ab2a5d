import { expectAccessible } from '../support/accessible';
import { expect, mapAtRest, open, pixelOf, planByTyping, test, type LonLat } from '../support/page';
import { findPlaces } from '../support/places';
import type { Page } from '@playwright/test';

const evaluated = async (page: Page): Promise<void> => {
  await expect(page.getByRole('complementary', { name: 'Waypoints' }).getByText(/^Evaluated/)).toBeVisible({ timeout: 30_000 });
};
/** All of them: a small change may leave the minutes of the travel time as they were. */
const figures = (page: Page): Promise<string> => page.locator('.figures-grid').innerText();
const save = (page: Page) => page.getByRole('button', { name: 'Store as a plan' });

const evaluations = '**/processes/evaluate-route/execution';

/** Keeps the server's verdicts back until the function that is returned is called: else they may come before a look at
 * what is shown meanwhile. */
async function holdVerdicts(page: Page): Promise<() => Promise<void>> {
  let release = (): void => undefined;
  const released = new Promise<void>((resolve) => (release = resolve));
  await page.route(evaluations, async (route) => {
    await released;
    await route.continue().catch(() => undefined); // taken back meanwhile by a later change
  });
  return async () => {
    release();
    await page.unroute(evaluations);
  };
}

test('a copy of a plan is changed with the mouse, judged anew, taken back and stored', { tag: '@long' }, async ({ page, request }) => {
  const { start, goal } = await findPlaces(request);
  await open(page);
  await planByTyping(page, start, goal);
  await page.getByRole('button', { name: 'Edit copy' }).click();
  const map = page.locator('#map');
  const handles = Number(await map.getAttribute('data-handles'));
  expect(handles).toBeGreaterThan(1);
  await expect(save(page)).toBeDisabled();

  const middle: LonLat = [(start[0] + goal[0]) / 2, (start[1] + goal[1]) / 2];
  if (handles === 2) {
    await page.getByRole('button', { name: 'Insert a waypoint after 1' }).click();
  }
  await expect(map).toHaveAttribute('data-handles', String(Math.max(3, handles)));
  await page.getByRole('button', { name: 'Waypoint 1', exact: true }).click();
  const typed = await page.getByLabel('Position of waypoint 1', { exact: true }).inputValue();
  const judgeTyped = await holdVerdicts(page);
  await page.getByLabel('Position of waypoint 1', { exact: true }).fill(`${middle[1].toFixed(5)}, ${middle[0].toFixed(5)}`);
  await page.keyboard.press('Enter');
  await expect(save(page)).toBeDisabled();
  await judgeTyped();
  await evaluated(page);
  await expect(page.getByLabel('Position of waypoint 1', { exact: true })).not.toHaveValue(typed);

  const before = await figures(page);
  await mapAtRest(page);
  const from = await pixelOf(page, middle);
  const judgeDragged = await holdVerdicts(page);
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(from.x + 12, from.y + 20, { steps: 4 });
  await page.mouse.up();
  await expect(page.locator('.figures-grid')).toHaveAttribute('aria-busy', 'true');
  await expect(save(page)).toBeDisabled();
  await judgeDragged();
  await expect(page.locator('.figures-grid')).toHaveAttribute('aria-busy', 'false');
  expect(await figures(page)).not.toBe(before);

  await page.getByRole('complementary', { name: 'Waypoints' }).getByTitle('Undo (Ctrl+Z): moving waypoint 1').click();
  await evaluated(page);
  expect(await figures(page)).toBe(before);

  const plans = Number(await map.getAttribute('data-plans'));
  await save(page).click();
  await expect(map).toHaveAttribute('data-plans', String(plans + 1));
  await expect(page.getByRole('button', { name: 'Export mission' })).toBeVisible();
  await expect(page.getByRole('heading', { name: /\(edited\)/ })).toBeVisible();
});

test('a plan from another browser is judged by its own rules', async ({ page, request }) => {
  const inputs = { from: [-52.6, 69.15], to: [-52.2, 69.13], depart: '2026-11-22T12:00:00Z', name: 'From elsewhere', margin_m: 870, dive_depth_m: 120 };
  const answer = await request.post('/processes/plan-route/execution', { data: { inputs }, headers: { Prefer: 'respond-sync' } });
  const { plan } = (await answer.json()) as { plan: { plan_id: string } };
  await open(page);
  await page.getByRole('button', { name: /^Plans/ }).click();
  await page.locator('.plan-choose', { hasText: 'From elsewhere' }).click();
  const asked = page.waitForRequest(evaluations);
  await page.getByRole('button', { name: 'Edit copy' }).click();
  expect((await asked).postDataJSON()).toMatchObject({ inputs: { margin_m: 870, dive_depth_m: 120 } });
  await expect(page.getByText('The server did not say what this plan was asked for')).toBeHidden();
  await page.getByRole('button', { name: 'Insert a waypoint after S' }).click();
  await evaluated(page);
  await page.keyboard.press('Escape');
  await request.delete(`/collections/plans/items/${plan.plan_id}`);
});

test('a copy of a plan is changed with the keyboard alone', { tag: '@long' }, async ({ page, request }) => {
  const { start, goal } = await findPlaces(request);
  await open(page);
  await planByTyping(page, start, goal);
  const map = page.locator('#map');
  await map.focus();
  await page.keyboard.press('d');
  const handles = Number(await map.getAttribute('data-handles'));
  await page.getByRole('button', { name: 'Waypoint S', exact: true }).focus();
  await page.keyboard.press('Enter');
  await map.focus();
  await page.keyboard.press('Insert');
  await expect(map).toHaveAttribute('data-handles', String(handles + 1));
  await evaluated(page);
  await mapAtRest(page); // picking a waypoint moves the map to it
  const view = await map.getAttribute('data-view');
  const position = page.getByLabel('Position of waypoint 1', { exact: true });
  const before = await position.inputValue();
  await page.keyboard.press('ArrowUp');
  await expect(position).not.toHaveValue(before);
  await page.keyboard.press('Shift+ArrowLeft');
  await page.keyboard.press('Alt+ArrowDown');
  await evaluated(page);
  expect(await map.getAttribute('data-view')).toBe(view);

  for (let i = 0; i < 3; ++i) await page.keyboard.press('Control+z');
  await expect(position).toHaveValue(before);
  await page.keyboard.press('Control+Shift+Z');
  await expect(position).not.toHaveValue(before);
  await page.keyboard.press('Tab');
  await expect(page.getByRole('button', { name: 'Waypoint 2', exact: true })).toHaveAttribute('aria-pressed', 'true');
  await page.keyboard.press('Shift+Tab');
  await page.keyboard.press('Delete');
  await expect(map).toHaveAttribute('data-handles', String(handles));
});

test('a route that cannot be flown or judged cannot be stored', { tag: '@long' }, async ({ page, request }) => {
  const { start, goal, land } = await findPlaces(request);
  await open(page);
  await planByTyping(page, start, goal);
  await page.getByRole('button', { name: 'Edit copy' }).click();
  const last = page.getByLabel(/^Position of waypoint/).last();
  await last.fill(`${land[1].toFixed(5)}, ${land[0].toFixed(5)}`);
  await page.keyboard.press('Enter');
  await expect(page.getByRole('region', { name: 'The route cannot be flown' })).toBeVisible({ timeout: 30_000 });
  await expect(page.locator('.figures-grid')).toBeHidden(); // they were of the route before
  await expectAccessible(page);
  await expect(save(page)).toBeDisabled();

  await page.route(evaluations, (route) => route.abort());
  await last.fill(`${goal[1].toFixed(5)}, ${goal[0].toFixed(5)}`);
  await page.keyboard.press('Enter');
  await expect(page.getByRole('region', { name: 'The route could not be evaluated' })).toBeVisible();
  await expect(save(page)).toBeDisabled();
  await page.unroute(evaluations);
});
