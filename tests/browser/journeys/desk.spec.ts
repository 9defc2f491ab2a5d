import AxeBuilder from '@axe-core/playwright';
import { expect, mapAtRest, open, planByTyping, settled, test, typed } from '../support/page';
import { findPlaces } from '../support/places';

test('a colleague opens the same view from the address', async ({ page, request }) => {
  const { start, goal } = await findPlaces(request);
  await open(page);
  await planByTyping(page, start, goal);
  await page.getByLabel('Projection').selectOption('EPSG:3995');
  await page.getByRole('button', { name: 'Show graticule' }).click();
  await page.getByRole('button', { name: 'Zoom in (+)' }).click();
  await page.getByRole('button', { name: 'One hour on (.)' }).click();
  await mapAtRest(page);
  const time = await page.getByRole('slider', { name: 'Time' }).inputValue();
  const written = new Date(Number(time)).toISOString().replace('.000', '');
  await expect.poll(() => page.url()).toMatch(new RegExp(`crs=3995.*time=${written}.*hide=graticule.*plan=`));
  const before = page.url();

  const other = await page.context().browser()?.newContext();
  const theirs = await other?.newPage();
  if (!theirs) throw new Error('no second browser');
  await theirs.goto(before);
  await settled(theirs);
  await expect(theirs.getByLabel('Projection')).toHaveValue('EPSG:3995');
  await expect(theirs.getByRole('button', { name: 'Show graticule' })).toHaveAttribute('aria-pressed', 'false');
  await expect(theirs.getByRole('slider', { name: 'Time' })).toHaveValue(time);
  await expect(theirs.locator('#map')).toHaveAttribute('data-plans', (await page.locator('#map').getAttribute('data-plans')) ?? '');
  const at = (url: string): string => /at=([^&]*)/.exec(url)?.[1] ?? '';
  await expect.poll(() => at(theirs.url()).split(',').slice(0, 2).map((word) => Number(word).toFixed(2))).toEqual(
    at(before).split(',').slice(0, 2).map((word) => Number(word).toFixed(2)),
  );
  await other?.close();
});

test('how far the vehicle comes is drawn and taken off again, with the keyboard alone', async ({ page, request }) => {
  const { start } = await findPlaces(request);
  await open(page);
  await page.getByLabel('Start', { exact: true }).fill(typed(start));
  await page.getByText('Reach from the start').focus();
  await page.keyboard.press('Enter');
  const hours = page.getByLabel('Hours after departure');
  await hours.fill('three');
  await page.getByRole('button', { name: 'Draw reach' }).focus();
  await page.keyboard.press('Enter');
  await expect(page.getByText('Write the hours as 6, 12, 24.')).toBeVisible();
  await hours.fill('2, 4');
  await page.getByRole('button', { name: 'Draw reach' }).focus();
  await page.keyboard.press('Enter');
  await expect(page.locator('#map')).toHaveAttribute('data-reach', 'ok', { timeout: 120_000 });
  await expect(page.getByRole('list', { name: 'Areas within reach' }).getByRole('listitem')).toHaveCount(2);
  await page.getByRole('button', { name: 'Remove', exact: true }).focus();
  await page.keyboard.press('Enter');
  await expect(page.locator('#map')).toHaveAttribute('data-reach', 'none');
});

test('a plan on older data is marked, and checked on the newest', async ({ page, request }) => {
  const { start, goal } = await findPlaces(request);
  await open(page);
  await planByTyping(page, start, goal);
  await expect(page.getByRole('region', { name: 'Stale data' })).toBeHidden();

  await page.route('**/datasets', async (route) => {
    const answer = await route.fetch();
    const { datasets } = (await answer.json()) as { datasets: { id: string; kind: string; ingested: string }[] };
    const bergs = datasets.find(({ kind }) => kind === 'icebergs');
    const newer = { ...bergs, id: 'icebergs-newer', name: 'a newer chart', ingested: '2100-01-01T00:00:00Z' };
    await route.fulfill({ response: answer, json: { datasets: [newer, ...datasets] } });
  });
  await page.getByTitle('All data in the store').click();
  await page.getByRole('button', { name: 'Look again' }).click();
  const stale = page.getByRole('region', { name: 'Stale data' });
  await expect(stale).toContainText('a newer chart');
  await stale.getByRole('button', { name: 'Re-check' }).click();
  await expect(stale).toContainText('The route holds.');
  await page.getByRole('button', { name: /^Plans/ }).click();
  await expect(page.getByText('stale data').first()).toBeVisible();
});

test('plans are compared, and one of them is the baseline', async ({ page, request }) => {
  const { start, goal } = await findPlaces(request);
  await open(page);
  await planByTyping(page, start, goal);
  const depart = page.getByRole('textbox', { name: /^Departure/ });
  const later = new Date(Date.parse(`${(await depart.inputValue()).replace(' ', 'T')}:00Z`) + 6 * 3_600_000);
  await depart.fill(later.toISOString().slice(0, 16).replace('T', ' '));
  await planByTyping(page, start, goal);
  await page.getByRole('button', { name: /^Plans/ }).click();
  await page.getByRole('button', { name: /^Compare/ }).click();
  const table = page.getByRole('region', { name: 'Comparison table' });
  await expect(table.locator('.difference').first()).toBeVisible();
  await table.getByRole('radio').last().check();
  await expect(table.getByRole('row').last()).toHaveClass(/selected/);
  await table.getByRole('button', { name: 'Travel time' }).click();
  await expect(table.getByRole('columnheader', { name: /Travel time/ })).toHaveAttribute('aria-sort', 'ascending');
});

test('the jobs of the server are listed', async ({ page, request }) => {
  const { start, goal } = await findPlaces(request);
  await open(page);
  await planByTyping(page, start, goal);
  await page.getByRole('button', { name: 'Jobs', exact: true }).focus();
  await page.keyboard.press('Enter');
  const jobs = page.getByRole('region', { name: 'Jobs' });
  await expect(jobs).toContainText('plan route');
  await expect(jobs).toContainText('successful');
  const { violations } = await new AxeBuilder({ page }).analyze();
  expect(violations.filter(({ impact }) => impact === 'serious' || impact === 'critical')).toEqual([]);
});

test('a server that falls silent is said so, and asked again', async ({ page }) => {
  await page.route('**/datasets', (route) => route.abort());
  await page.goto('/');
  await expect(page.getByText('The server does not answer')).toBeVisible();
  await page.unroute('**/datasets');
  await page.getByRole('button', { name: 'Look again' }).click();
  await settled(page);
  await expect(page.getByText('The server does not answer')).toBeHidden();
});
