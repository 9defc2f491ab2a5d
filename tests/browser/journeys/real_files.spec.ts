import { existsSync, readFileSync } from 'node:fs';
import { basename, join } from 'node:path';
import { drop } from '../support/dropping';
import { expect, mapAtRest, open, pixelOf, planAndWait, settled, test as base, typed, untilRefused, type LonLat } from '../support/page';
import { startServer, type Server } from '../support/server';
import type { Page } from '@playwright/test';

const folder = join(__dirname, '../../../../shared/data/env');
const real = (name: string): string => join(folder, name);
const sea = ['currents/arctic20km_polarstereo_sub.nc', 'bathymetry/topo_30min.nc'];
const sightings = 'icebergs/IIP_2014IcebergSeason_a.csv';
const beacon = 'icebergs/cis_beacon_1997_12995.csv';
const files = [...sea, sightings];

/** A server whose store knows the sea but no icebergs. */
const test = base.extend<object, { stockedServer: Server }>({
  stockedServer: [
    async ({}, use) => {
      const server = await startServer({ empty: true });
      server.run('ingest', ...sea.map(real));
      await use(server);
      await server.stop();
    },
    { scope: 'worker' },
  ],
});

const missing = [...files, beacon].filter((name) => !existsSync(real(name)));
test.skip(missing.length > 0, `not there: ${missing.join(', ')}`);

/** In the Greenland Sea, within the currents of all three days and far from any coast. */
const start: LonLat = [3, 72];
const goal: LonLat = [3.4, 72.1];
/** In the mountains of northern Norway. */
const ashore: LonLat = [20, 68.5];

const field = (page: Page, name: string) => page.getByLabel(name, { exact: true });

async function planByMouse(page: Page): Promise<void> {
  await field(page, 'Start').fill(typed(start));
  await field(page, 'Goal').fill(typed(goal));
  await planAndWait(page);
}

test.describe('into an empty store', () => {
  test.use({ baseURL: async ({ emptyServer }, use) => use(emptyServer.url) });

  test('from an empty store to a mission with files that real sources publish', async ({ page }) => {
    await page.goto('/');
    await expect(page.getByRole('region', { name: 'Empty store' })).toBeVisible();
    await page.getByLabel('Files to add').setInputFiles(files.map(real));
    const report = page.getByRole('region', { name: /^Import of/ });
    await expect(report.getByText('Stored', { exact: true })).toHaveCount(files.length, { timeout: 120_000 });
    await settled(page);
    await expect(page.locator('#map')).toHaveAttribute('data-currents', 'shown');

    await page.getByRole('button', { name: 'Set-up', exact: true }).click();
    await planByMouse(page);
    await page.getByRole('button', { name: 'Export mission' }).click();
    await expect(page.getByRole('dialog').locator('pre')).toContainText('<start:waypoints>');
  });
});

test.describe('in a store of real files', () => {
  test.use({ baseURL: async ({ stockedServer }, use) => use(stockedServer.url) });

  test('a goal in the mountains is explained and answered with a suggestion', { tag: '@long' }, async ({ page }) => {
    await open(page);
    await field(page, 'Start').fill(typed(start));
    await field(page, 'Goal').fill(typed(ashore));
    await page.getByRole('button', { name: /^Plan / }).click();
    const failure = page.getByRole('alert', { name: 'No plan is possible' });
    await expect(failure).toContainText(/goal/i, untilRefused);
    await expect(failure.getByRole('group', { name: 'Changes that help' }).getByRole('button').first()).toBeEnabled();
  });

  test('two departures are compared', async ({ page }) => {
    await open(page);
    await planByMouse(page);
    const depart = page.getByRole('textbox', { name: /^Departure/ });
    const later = new Date(Date.parse(`${(await depart.inputValue()).replace(' ', 'T')}:00Z`) + 6 * 3_600_000);
    await depart.fill(later.toISOString().slice(0, 16).replace('T', ' '));
    await planAndWait(page);
    await page.getByRole('button', { name: /^Plans/ }).click();
    await page.getByRole('button', { name: /^Compare/ }).click();
    const table = page.getByRole('region', { name: 'Comparison table' });
    await expect(table.locator('.difference').first()).toBeVisible();
    await table.getByRole('radio').last().check();
    await expect(table.getByRole('row').last()).toHaveClass(/selected/);
  });

  test('a copy is dragged, judged anew and stored', async ({ page }) => {
    await open(page);
    await planByMouse(page);
    const map = page.locator('#map');
    await page.getByRole('button', { name: 'Edit copy' }).click();
    const handles = Number(await map.getAttribute('data-handles'));
    await page.getByRole('button', { name: 'Insert a waypoint after 1' }).click();
    await expect(map).toHaveAttribute('data-handles', String(handles + 1));
    const position = page.getByLabel('Position of waypoint 1', { exact: true });
    const middle: LonLat = [3.2, 72.06];
    await position.fill(typed(middle));
    await page.keyboard.press('Enter');
    const figures = page.locator('.figures-grid');
    await expect(figures).toHaveAttribute('aria-busy', 'false');
    await mapAtRest(page);
    const [before, text] = [await figures.innerText(), await position.inputValue()];
    const { x, y } = await pixelOf(page, middle);
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 10, y - 30, { steps: 4 });
    await page.mouse.up();
    await expect(position).not.toHaveValue(text);
    await expect(figures).toHaveAttribute('aria-busy', 'false');
    expect(await figures.innerText()).not.toBe(before);
    const plans = Number(await map.getAttribute('data-plans'));
    await page.getByRole('button', { name: 'Store as a plan' }).click();
    await expect(map).toHaveAttribute('data-plans', String(plans + 1));
  });

  test('sightings of a season are dropped, checked and summed up, and a plan made before is judged on them', async ({ page }) => {
    await open(page);
    await page.getByText('Data', { exact: true }).last().click();
    await field(page, 'Currents').selectOption('none'); // nobody published those of that summer here
    await field(page, 'Start').fill('48, -49');
    await field(page, 'Goal').fill('48.1, -48.7');
    await page.getByRole('textbox', { name: /^Departure/ }).fill('2014-06-15 00:00');
    await planAndWait(page);
    const contents = (name: string): { name: string; text: string } => ({ name: basename(name), text: readFileSync(real(name), 'utf8') });
    await drop(page, [contents(sightings)]);
    await expect(page.getByRole('region', { name: `Import of ${basename(sightings)}` })).toContainText('10,146 accepted', { timeout: 120_000 });
    const stale = page.getByRole('region', { name: 'Stale data' });
    await expect(stale).toContainText('IIP_2014IcebergSeason_a');
    await stale.getByRole('button', { name: 'Re-check' }).click();
    await expect(stale).toContainText('The route holds.');

    await drop(page, [contents(beacon)]);
    const report = page.getByRole('region', { name: `Import of ${basename(beacon)}` });
    await expect(report).toContainText('639 accepted, 1 refused');
    await expect(report).toContainText(/line 641 was left out/i);
    await expect(stale).not.toContainText('cis_beacon');
  });

  test('a plan is flown and its flight played back', async ({ page }) => {
    await open(page);
    await planByMouse(page);
    await page.getByRole('button', { name: 'Flights', exact: true }).click();
    await page.getByRole('button', { name: 'Simulate this plan' }).click();
    await expect(page.locator('#map')).toHaveAttribute('data-flight', '0', { timeout: 120_000 });
    const flight = page.getByRole('region', { name: 'Flight 1', exact: true });
    await expect(flight.getByRole('heading', { level: 3 })).toContainText('arrived');
    await flight.locator('.u-over').first().click({ position: { x: 60, y: 20 } });
    await expect(flight.locator('.flight-now div', { hasText: 'Depth' }).locator('dd')).toHaveText(/m$|surface/);
  });

  test('a colleague opens the same view from the address', async ({ page }) => {
    await open(page);
    await planByMouse(page);
    await mapAtRest(page);
    await page.getByRole('button', { name: 'One hour on (.)' }).click();
    const time = await page.getByRole('slider', { name: 'Time' }).inputValue();
    const written = new Date(Number(time)).toISOString().replace('.000', '');
    await expect.poll(() => page.url()).toMatch(new RegExp(`time=${written}.*plan=`));
    const theirs = await page.context().newPage();
    await theirs.goto(page.url());
    await settled(theirs);
    await expect(theirs.getByRole('slider', { name: 'Time' })).toHaveValue(time);
    await expect(theirs.getByRole('complementary', { name: 'Waypoints' }).getByRole('heading', { level: 2 }).first()).toHaveText(
      await page.getByRole('complementary', { name: 'Waypoints' }).getByRole('heading', { level: 2 }).first().innerText(),
    );
  });
});
