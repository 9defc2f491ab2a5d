import AxeBuilder from '@axe-core/playwright';
import { expect, mapAtRest, open, planByTyping, settled, test, typed } from '../support/page';
import { setClock } from '../support/now';
import { findPlaces } from '../support/places';
import type { Locator } from '@playwright/test';

test('a colleague opens the same view from the address', { tag: '@long' }, async ({ page, request }) => {
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
  if (!other) throw new Error('no second browser');
  await setClock(other);
  const theirs = await other.newPage();
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

  // Put into the address of a page that is open, a link is followed, too.
  const page_url = new URL(theirs.url());
  page_url.hash = page_url.hash.replace('crs=3995', 'crs=3857');
  await theirs.goto(page_url.href);
  await expect(theirs.getByLabel('Projection')).toHaveValue('EPSG:3857');
  await settled(theirs);
  await other.close();
});

test('how far the vehicle comes is drawn and taken off again, with the keyboard alone', { tag: '@long' }, async ({ page, request }) => {
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

test('a plan on older data is marked, and checked on the newest', { tag: '@long' }, async ({ page, request }) => {
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
  await page.getByRole('button', { name: 'Refresh' }).click();
  const stale = page.getByRole('region', { name: 'Stale data' });
  await expect(stale).toContainText('a newer chart');
  await stale.getByRole('button', { name: 'Re-check' }).click();
  await expect(stale).toContainText('The route holds.');
  await page.getByRole('button', { name: /^Plans/ }).click();
  await expect(page.getByText('stale data').first()).toBeVisible();
});

/** A figure of the table of comparison without its unit; a time in minutes. */
function figureIn(text: string): number {
  const time = /^[+−]?(?:(\d+) h )?(\d+) min/.exec(text);
  const size = time ? 60 * Number(time[1] ?? 0) + Number(time[2]) : Number.parseFloat(text.replace(/^[+−±]/, ''));
  return text.startsWith('−') ? -size : size;
}

/** Every difference to the first plan is that of the two figures on the screen; of the arrival it is not, which has a date. */
async function expectDifferencesOfWhatIsShown(table: Locator): Promise<void> {
  const cells = (row: number): Promise<string[][]> =>
    table.getByRole('row').nth(row).locator('td').evaluateAll((all) => all.map((cell) => [...cell.childNodes].map(({ textContent }) => textContent ?? '')));
  const [base, other] = [await cells(1), await cells(2)];
  const told = other.flatMap(([value = '', difference], i) => (i > 1 && difference && /^[+−±]/.test(difference) ? [[figureIn(value) - figureIn(base[i]?.[0] ?? ''), figureIn(difference)]] : []));
  expect(told.length).toBeGreaterThan(5);
  for (const [actual = NaN, stated] of told) expect(stated).toBeCloseTo(actual, 6);
}

test('plans are compared, and one of them is the baseline', async ({ page, request }) => {
  const { start, goal } = await findPlaces(request);
  await open(page);
  await planByTyping(page, start, goal);
  const depart = page.getByRole('textbox', { name: /^Departure/ });
  const later = new Date(Date.parse(`${(await depart.inputValue()).replace(' ', 'T')}:00Z`) + 6 * 3_600_000);
  await depart.fill(later.toISOString().slice(0, 16).replace('T', ' '));
  await page.getByLabel('Iceberg margin').fill('800');
  await planByTyping(page, start, goal);
  await page.getByRole('button', { name: /^Plans/ }).click();
  await page.getByRole('button', { name: /^Compare/ }).click();
  const settings = page.getByRole('region', { name: 'Settings that differ, a row each' });
  await expect(settings.getByRole('row')).toHaveText([/^Setting/, /^Iceberg margin(500 m)+800 m$/]);
  const table = page.getByRole('region', { name: 'Comparison table' });
  await expect(table.locator('.difference').first()).toBeVisible();
  await expectDifferencesOfWhatIsShown(table);
  await table.getByRole('radio').last().check();
  await expect(table.getByRole('row').last()).toHaveClass(/selected/);
  await table.getByRole('button', { name: 'Travel time' }).click();
  await expect(table.getByRole('columnheader', { name: /Travel time/ })).toHaveAttribute('aria-sort', 'ascending');
});

test('the jobs of the server are listed, and one that found no route is not called successful', { tag: '@long' }, async ({ page, request }) => {
  const { start, goal } = await findPlaces(request);
  const inputs = { from: start, to: goal, depart: '2026-11-22T12:00:00Z', arrive_by: '2026-11-22T12:01:00Z', method: 'direct' };
  await request.post('/processes/plan-route/execution', { data: { inputs }, headers: { Prefer: 'respond-sync' } });
  await open(page);
  await planByTyping(page, start, goal);
  await page.getByRole('button', { name: 'Jobs', exact: true }).focus();
  await page.keyboard.press('Enter');
  const jobs = page.getByRole('region', { name: 'Jobs' });
  await expect(jobs).toContainText('plan route');
  await expect(jobs).toContainText('successful');
  const refused = jobs.getByRole('row', { name: /no route/ });
  await expect(refused).toContainText(/No route: .*arriv/);
  await expect(refused).not.toContainText('successful');
  const { violations } = await new AxeBuilder({ page }).analyze();
  expect(violations.filter(({ impact }) => impact === 'serious' || impact === 'critical')).toEqual([]);
});

test('a server that falls silent is said so, and asked again', async ({ page }) => {
  await page.route('**/datasets', (route) => route.abort());
  await page.goto('/');
  await expect(page.getByText('The server does not answer')).toBeVisible();
  await page.unroute('**/datasets');
  await page.getByRole('button', { name: 'Refresh' }).click();
  await settled(page);
  await expect(page.getByText('The server does not answer')).toBeHidden();
});

test('a plan under way when the page is reloaded is waited for and shown', { tag: '@long' }, async ({ page, request }) => {
  const { start, goal } = await findPlaces(request);
  await open(page);
  const countOf = async (): Promise<number> => ((await (await request.get('/collections/plans/items')).json()) as { numberMatched: number }).numberMatched;
  const before = await countOf();
  await page.getByLabel('Start', { exact: true }).fill(typed(start));
  await page.getByLabel('Goal', { exact: true }).fill(typed(goal));
  const handedIn = page.waitForResponse('**/processes/plan-route/execution');
  await page.getByRole('button', { name: /^Plan / }).click();
  await handedIn;
  await expect(page.getByRole('group', { name: 'Planning' })).toBeVisible();
  await page.reload();
  await expect(page.getByRole('button', { name: `Plans (${before + 1})` })).toBeVisible({ timeout: 120_000 });
  await expect(page.getByRole('group', { name: 'Planning' })).toBeHidden();
  const { features } = (await (await request.get('/collections/plans/items')).json()) as { features: { properties: { name: string } }[] };
  const name = features.at(-1)?.properties.name ?? '';
  await expect(page.getByRole('complementary', { name: 'Waypoints' }).getByRole('heading', { level: 2 }).first()).toContainText(name);
  expect(await page.evaluate(() => sessionStorage.length)).toBe(0);
});

test('a plan is found among many, over the pages of a long list', { tag: '@long' }, async ({ page, request }) => {
  const { start, goal } = await findPlaces(request);
  await open(page);
  await planByTyping(page, start, goal);
  const most = 60;
  const longName = 'The survey along the ice edge that nobody could agree on a shorter name for, and its many second thoughts';
  const { features } = (await (await request.get('/collections/plans/items')).json()) as { features: { properties: object }[] };
  const [one] = features;
  if (!one) throw new Error('The store has no plan.');
  await page.route('**/collections/plans/items?**', async (route) => {
    const after = Number(new URL(route.request().url()).searchParams.get('after') ?? 0);
    const numbers = Array.from({ length: most }, (_, i) => after + i);
    const copies = numbers.map((i) => ({ ...one, id: `copy-${i}`, properties: { ...one.properties, plan_id: `copy-${i}`, name: i === 7 ? longName : `Copy ${i}` } }));
    const links = after < most ? [{ rel: 'next', href: `/collections/plans/items?limit=500&after=${most}` }] : [];
    await route.fulfill({ json: { type: 'FeatureCollection', features: copies, numberMatched: 2 * most, numberReturned: most, links } });
  });
  await page.reload();
  await settled(page);
  await page.getByRole('button', { name: `Plans (${2 * most})` }).click();
  await page.getByLabel('Find a plan').fill('survey');
  const list = page.locator('.plan-list');
  await expect(list.getByRole('listitem').filter({ hasText: longName })).toBeVisible();
  await expect(list.getByRole('listitem')).toHaveCount(2); // and the one on the map
  await list.getByRole('checkbox', { name: `Show ${longName} on the map` }).check();
  await page.getByRole('button', { name: 'Compare 2 plans' }).click();
  await expect(page.getByRole('region', { name: 'Comparison table' }).getByRole('row')).toHaveCount(3);
  const { violations } = await new AxeBuilder({ page }).analyze();
  expect(violations.filter(({ impact }) => impact === 'serious' || impact === 'critical').map(({ id }) => id)).toEqual([]);
});
