import { expect, test as base, type Locator, type Page } from '@playwright/test';
import proj4 from 'proj4';
import { setClock } from './now';
import { startServer, type Server } from './server';

proj4.defs('EPSG:3413', '+proj=stere +lat_0=90 +lat_ts=70 +lon_0=-45 +datum=WGS84 +units=m');

export type LonLat = [lon: number, lat: number];

/** Every test fails on an error in the console, on an error of the page and on a request to a foreign host. */
export const test = base.extend<{ guarded: undefined }, { server: Server; emptyServer: Server }>({
  /** One for all tests of a worker; whoever changes its store puts back what was there. */
  server: [
    async ({}, use) => {
      const server = await startServer();
      await use(server);
      await server.stop();
    },
    { scope: 'worker' },
  ],
  /** One whose store holds nothing yet. */
  emptyServer: [
    async ({}, use) => {
      const server = await startServer({ empty: true });
      await use(server);
      await server.stop();
    },
    { scope: 'worker' },
  ],
  baseURL: async ({ server }, use) => use(server.url),
  guarded: [
    async ({ page, baseURL }, use) => {
      await setClock(page.context());
      const faults: string[] = [];
      page.on('console', (message) => {
        if (message.type() === 'error') faults.push(`console: ${message.text()}`);
      });
      page.on('pageerror', (error) => faults.push(`page: ${error.message}`));
      page.on('request', (request) => {
        const { protocol, origin } = new URL(request.url());
        if (protocol.startsWith('http') && origin !== new URL(baseURL ?? '').origin) faults.push(`foreign host: ${request.url()}`);
      });
      await use(undefined);
      expect(faults.filter((fault) => !isExpected(fault))).toEqual([]);
    },
    { auto: true },
  ],
});

/** A refused request is reported by the browser as an error of the console, and some journeys provoke one. */
const isExpected = (fault: string): boolean => /status of 4(00|01|03|04|09|12|22|29)|net::ERR_(FAILED|INTERNET_DISCONNECTED)/.test(fault);

export { expect };

/** Opens the client and waits until the map shows all it has to show. */
export async function open(page: Page): Promise<void> {
  await page.goto('/');
  await settled(page);
}

export async function settled(page: Page): Promise<void> {
  await expect(page.locator('#map')).toHaveAttribute('data-ready', 'true');
}

/** Waits until the map has stopped moving. It publishes its view only at rest, so that one that stays the same may still be under
 * way; and an answer to a key moves it only with a later frame. */
export async function mapAtRest(page: Page): Promise<void> {
  const map = page.locator('#map');
  let before: string | null = null;
  await expect
    .poll(async () => {
      await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
      const now = await map.getAttribute('data-view');
      const rests = now === before && (await map.getAttribute('data-moving')) === 'false';
      before = now;
      return rests;
    })
    .toBe(true);
}

/** Where a place is on the screen, from the view that the map publishes. */
export async function pixelOf(page: Page, place: LonLat): Promise<{ x: number; y: number }> {
  const map = page.locator('#map');
  const view = JSON.parse((await map.getAttribute('data-view')) ?? '{}') as { centre: LonLat; resolution: number };
  const box = await map.boundingBox();
  if (!box) throw new Error('The map has no place on the screen.');
  const [x = NaN, y = NaN] = proj4('EPSG:4326', 'EPSG:3413', [...place]);
  return {
    x: box.x + box.width / 2 + (x - view.centre[0]) / view.resolution,
    y: box.y + box.height / 2 - (y - view.centre[1]) / view.resolution,
  };
}

export const typed = ([lon, lat]: LonLat): string => `${lat.toFixed(5)}, ${lon.toFixed(5)}`;

/** For what a refusal shows: the planner looks through changes that would help before it refuses, for minutes where the machine is busy. */
export const untilRefused = { timeout: 240_000 };

/** Presses the button and waits until one more plan is on the map. */
export async function planAndWait(page: Page): Promise<void> {
  const before = Number(await page.locator('#map').getAttribute('data-plans'));
  await page.getByRole('button', { name: /^Plan / }).click();
  await expect(page.locator('#map')).toHaveAttribute('data-plans', String(before + 1), { timeout: 120_000 });
  await settled(page);
}

/** Writes into a field as somebody without a mouse does: in place of what it holds, key by key. */
export async function typeInto(page: Page, field: Locator, text: string): Promise<void> {
  await field.focus();
  await page.keyboard.press('Control+A');
  await page.keyboard.type(text);
}

/** Start and goal by key, Enter, and the plan is waited for. */
export async function planByKeyboard(page: Page, from: LonLat, to: LonLat): Promise<void> {
  const before = Number(await page.locator('#map').getAttribute('data-plans'));
  await typeInto(page, page.getByLabel('Start', { exact: true }), typed(from));
  await typeInto(page, page.getByLabel('Goal', { exact: true }), typed(to));
  await page.keyboard.press('Enter');
  await expect(page.locator('#map')).toHaveAttribute('data-plans', String(before + 1), { timeout: 120_000 });
  await settled(page);
}

/** Types the set-up and waits for its plan. */
export async function planByTyping(page: Page, from: LonLat, to: LonLat): Promise<void> {
  await page.getByLabel('Start', { exact: true }).fill(typed(from));
  await page.getByLabel('Goal', { exact: true }).fill(typed(to));
  await planAndWait(page);
}
