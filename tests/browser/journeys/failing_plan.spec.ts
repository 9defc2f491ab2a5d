import { expectAccessible } from '../support/accessible';
import { expect, open, test, typed, untilRefused } from '../support/page';
import { findPlaces } from '../support/places';

test('a goal on land is explained, marked on the map and answered with a suggestion', { tag: '@long' }, async ({ page, request }) => {
  const { start, land } = await findPlaces(request);
  await open(page);
  await page.getByLabel('Start', { exact: true }).fill(typed(start));
  await page.getByLabel('Goal', { exact: true }).fill(typed(land));
  await page.getByRole('button', { name: /^Plan / }).click();

  const failure = page.getByRole('alert', { name: 'No plan is possible' });
  await expect(failure).toBeVisible(untilRefused);
  await expect(failure).toContainText(/goal/i);
  await expect(failure.getByRole('group', { name: 'Changes that help' }).getByRole('button').first()).toBeEnabled();
  await expect(page.getByRole('button', { name: /^Plan / })).toBeEnabled();
  await failure.getByRole('button', { name: 'Dismiss this message' }).click();
  await expect(failure).toBeHidden();
});

test('the cause is told while the server still looks for what would help', async ({ page, request }) => {
  const { start, land } = await findPlaces(request);
  let isHeld = true;
  await page.route('**/jobs/*', async (route) => {
    const answer = await route.fetch();
    const job = (await answer.json()) as { stage: string };
    const looking = { ...job, status: 'running', progress: 95, stage: 'not possible as asked: the goal lies on land' };
    await route.fulfill({ response: answer, json: isHeld ? looking : job });
  });
  await open(page);
  await page.getByLabel('Start', { exact: true }).fill(typed(start));
  await page.getByLabel('Goal', { exact: true }).fill(typed(land));
  await page.getByRole('textbox', { name: /^Departure/ }).fill('2026-11-22 13:00'); // a request of its own: of a shared one the answer is there at once
  await page.getByRole('button', { name: /^Plan / }).click();
  const job = page.getByRole('group', { name: 'Planning' });
  await expect(job).toContainText('Not possible as asked. Looking for what would help');
  await expect(job.getByRole('status')).toHaveText('The goal lies on land.');
  isHeld = false;
  await expect(page.getByRole('alert', { name: 'No plan is possible' })).toBeVisible(untilRefused);
  await expect(job).toBeHidden();
});

test('a change that the server proposes is made by its button', { tag: '@long' }, async ({ page, request }) => {
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

test('where the currents end before the route does, a plan without them is one press away, and undone by key', async ({ page, request }) => {
  const { datasets } = (await (await request.get('/datasets')).json()) as { datasets: { kind: string; time_end: string }[] };
  const end_ms = Date.parse(datasets.find(({ kind }) => kind === 'currents')?.time_end ?? '');
  const late = new Date(end_ms - 4 * 3_600_000).toISOString().slice(0, 16).replace('T', ' ');
  await open(page);
  await page.getByLabel('Start', { exact: true }).fill(typed([-52.6, 69.15]));
  await page.getByLabel('Goal', { exact: true }).fill(typed([-52.2, 69.13]));
  await page.getByRole('textbox', { name: /^Departure/ }).fill(late);
  await page.getByRole('button', { name: /^Plan / }).click();
  const failure = page.getByRole('alert', { name: 'No plan is possible' });
  await expect(failure.getByRole('heading').first()).toHaveText('Outside the area or time of the data', untilRefused);
  await expect(failure).toContainText('the stored currents end at');
  await expectAccessible(page);
  const withoutCurrents = failure.getByRole('button', { name: 'Plan without currents' });
  await page.getByLabel('Goal', { exact: true }).fill(typed([-52.2, 69.14]));
  await expect(failure).toContainText('The set-up has changed since.');
  await expect(withoutCurrents).toBeHidden();
  await page.keyboard.press('Control+z');
  const before = Number(await page.locator('#map').getAttribute('data-plans'));
  await withoutCurrents.click();
  await expect(page.locator('#map')).toHaveAttribute('data-plans', String(before + 1));
  await expect(page.getByLabel('Currents', { exact: true })).toHaveValue('none');
  await page.keyboard.press('Control+z');
  await expect(page.locator('#map')).toHaveAttribute('data-plans', String(before));
  await page.keyboard.press('Control+z');
  await expect(page.getByLabel('Currents', { exact: true })).toHaveValue('newest');
});

test('a departure after the end of the currents is explained in the words of the page, with what a pilot would try first', async ({ page, request }) => {
  const { start, goal } = await findPlaces(request);
  await open(page);
  await page.getByLabel('Start', { exact: true }).fill(typed(start));
  await page.getByLabel('Goal', { exact: true }).fill(typed(goal));
  const departure = page.getByRole('textbox', { name: /^Departure/ });
  await departure.fill('2026-12-20 00:00');
  await page.getByRole('button', { name: /^Plan / }).click();
  const failure = page.getByRole('alert', { name: 'Planning failed' });
  await expect(failure).toContainText('Departure 20 Dec 00:00Z is outside the period of the currents');
  await expect(failure).not.toContainText(/--|T00:00:00Z|\/depart/);
  const remedies = failure.getByRole('group', { name: 'Changes that may help' }).getByRole('button');
  await expect(remedies).toHaveText(['Depart when the currents begin, 22 Nov 00:00Z', 'Hold the currents at departure', 'Plan without currents']);
  await expectAccessible(page);
  const plans = Number(await page.locator('#map').getAttribute('data-plans'));
  await remedies.first().focus();
  await page.keyboard.press('Enter');
  await expect(page.locator('#map')).toHaveAttribute('data-plans', String(plans + 1), { timeout: 120_000 });
  await expect(failure).toBeHidden();
  await expect(departure).toHaveValue('2026-11-22 00:00');
});
