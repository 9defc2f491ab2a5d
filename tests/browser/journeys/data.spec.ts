import { drop } from '../support/dropping';
import { expect, open, planByTyping, test } from '../support/page';
import { bergFile, signlessDepths, zoneFile } from '../support/files';
import { findPlaces } from '../support/places';
import type { Page } from '@playwright/test';

const card = (page: Page, name: string) => page.getByRole('region', { name: `Import of ${name}` });
const choose = (page: Page) => page.getByLabel('Files to add');
const data = (page: Page) => page.getByRole('button', { name: 'Data', exact: true });

/** Takes the newest dataset that carries a name out of the store again, so that the next test finds the store as it was. */
async function remove(page: Page, name: string): Promise<void> {
  page.once('dialog', (dialog) => void dialog.accept());
  await page.getByRole('button', { name: `Remove ${name}`, exact: true }).first().click();
  await expect(page.getByRole('button', { name: `Remove ${name}`, exact: true })).toHaveCount(0);
}

test('a new file of icebergs is dropped, checked and summed up, and plans made before are marked', async ({ page, request }) => {
  const { start, goal } = await findPlaces(request);
  await open(page);
  await planByTyping(page, start, goal);
  await drop(page, [bergFile(start)]);
  const done = card(page, 'sighted-today.geojson');
  await expect(done).toContainText('2 accepted, 1 refused');
  await expect(done.getByText('Messages')).toBeVisible();
  await expect(page.getByRole('region', { name: 'Stale data' })).toContainText('sighted-today');
  await done.getByRole('button', { name: 'Dismiss the import of sighted-today.geojson' }).click();
  await expect(done).toBeHidden();
  await remove(page, 'sighted-today');
  await expect(page.getByRole('region', { name: 'Stale data' })).toBeHidden();
});

test('what a file leaves open is asked back, and it is read again without being sent twice', async ({ page }) => {
  await open(page);
  await data(page).focus();
  await page.keyboard.press('Enter');
  let sent = 0;
  page.on('request', (request) => {
    if (request.url().includes('/uploads?')) ++sent;
  });
  await choose(page).setInputFiles([signlessDepths()]);
  const refused = card(page, 'levels.asc');
  await expect(refused).toContainText('Refused');
  await expect(refused).toContainText('State “Positive” up');
  const again = refused.getByRole('button', { name: 'Read again with this' });
  await expect(again).toBeDisabled();
  await refused.getByLabel('Positive').selectOption('up');
  await refused.getByText('More options').click();
  await refused.getByLabel('Reference system').fill('EPSG:4326');
  await again.focus();
  await page.keyboard.press('Enter');
  await expect(refused.getByText('Stored', { exact: true })).toBeVisible();
  expect(sent).toBe(1);

  const map = page.locator('#map');
  await page.getByRole('button', { name: 'Show the coverage of levels' }).focus();
  await page.keyboard.press('Enter');
  await expect(map).toHaveAttribute('data-coverage', '1');
  await remove(page, 'levels');
  await expect(map).toHaveAttribute('data-coverage', '0');
});

test('files are taken for what a person says, and for nothing else', async ({ page }) => {
  await open(page);
  await data(page).click();
  await page.getByLabel('Take the files as').selectOption('zones');
  await choose(page).setInputFiles([zoneFile()]);
  const refused = card(page, 'closed.geojson');
  await expect(refused).toContainText('Refused');
  await refused.getByLabel('Rule of the zones').selectOption('no_go');
  await refused.getByRole('button', { name: 'Read again with this' }).click();
  await expect(refused.getByText('Stored', { exact: true })).toBeVisible();
  await page.getByLabel('Take the files as').selectOption('');
  await remove(page, 'closed');
});

test('the coverage of a dataset in time stands on the clock', async ({ page }) => {
  await open(page);
  await data(page).click();
  const currents = page.getByRole('button', { name: /^Show the coverage of .*currents/ });
  await currents.click();
  await expect(currents).toHaveAttribute('aria-pressed', 'true');
  await expect(page.locator('.timeline .coverage')).toHaveCount(1);
  await currents.click();
  await expect(page.locator('.timeline .coverage')).toHaveCount(0);
});

test('a file that arrives damaged, and a server that is gone, are said so beside the file', async ({ page }) => {
  await open(page);
  await data(page).click();
  await page.route('**/uploads?**', (route) => route.abort());
  await choose(page).setInputFiles([signlessDepths()]);
  await expect(card(page, 'levels.asc').getByRole('alert').first()).toContainText('does not answer');
  await page.unroute('**/uploads?**');
  await page.route('**/uploads?**', (route) => route.continue({ url: route.request().url().replace(/sha256=\w{8}/, 'sha256=00000000') }));
  await choose(page).setInputFiles([{ ...signlessDepths(), name: 'other.asc' }]);
  await expect(card(page, 'other.asc').getByRole('alert').first()).toContainText('damaged in transfer');
});

test('sending is cancelled', async ({ page }) => {
  await open(page);
  await data(page).click();
  let held: (() => void) | undefined;
  await page.route('**/uploads?**', async (route) => {
    await new Promise<void>((resolve) => {
      held = resolve;
    });
    await route.abort();
  });
  await choose(page).setInputFiles([signlessDepths()]);
  const sending = card(page, 'levels.asc');
  await expect(sending).toHaveAttribute('aria-busy', 'true');
  await sending.getByRole('button', { name: 'Cancel' }).click();
  await expect(sending).toContainText('Cancelled; nothing was stored.');
  held?.();
});

test('a dataset that a better one replaces says so and leads to it', async ({ page }) => {
  await page.route('**/datasets', async (route) => {
    const answer = await route.fetch();
    const document = (await answer.json()) as { datasets: { id: string; kind: string }[] };
    const old = document.datasets.find(({ kind }) => kind === 'currents');
    const better = { ...old, id: 'currents-0badcafe' };
    const marked = { ...old, stale: 'resampled by an earlier version: currents-0badcafe has the values at the file\'s own points', better_id: better.id };
    await route.fulfill({ response: answer, json: { ...document, datasets: [better, ...document.datasets.map((one) => (one === old ? marked : one))] } });
  });
  await open(page);
  await data(page).click();
  const list = page.getByRole('list', { name: 'Datasets' });
  const stale = list.getByRole('listitem').filter({ hasText: 'Resampled by an earlier version' });
  await expect(stale).toHaveCount(1);
  await stale.getByRole('button', { name: 'Show it' }).click();
  await expect(page.locator('#dataset-currents-0badcafe')).toBeFocused();
});
