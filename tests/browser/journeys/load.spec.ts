import { expect, mapAtRest, pixelOf, settled, test as base, type LonLat } from '../support/page';
import { currentFile } from '../support/current_file';
import { crowdOfBergs } from '../support/files';
import { findPlaces } from '../support/places';
import { now } from '../support/now';
import { startServer, type Server } from '../support/server';

/** Ten days of hourly currents on a grid of 1/12 degree, 300 icebergs, 20 plans. */
const hours = 241;
const step_deg = 1 / 12;
const bergs = 300;
const plans = 20;
/** Waypoints of the route that is dragged, as in a mission of some days. */
const waypoints = 17;

const test = base.extend<object, { loadedServer: Server }>({
  loadedServer: [
    async ({}, use) => {
      const server = await startServer();
      await use(server);
      await server.stop();
    },
    { scope: 'worker' },
  ],
  baseURL: async ({ loadedServer }, use) => use(loadedServer.url),
});

const quantile = (values: number[], part: number): number => [...values].sort((a, b) => a - b)[Math.floor(part * values.length)] ?? NaN;
const median = (values: number[]): number => quantile(values, 0.5);

const evaluations = '**/processes/evaluate-route/execution';

/** Distance on a sphere, within 1 % of that on the ellipsoid. */
function metres([lon1, lat1]: LonLat, [lon2, lat2]: LonLat): number {
  const rad = Math.PI / 180;
  const s = Math.sin(((lat2 - lat1) * rad) / 2) ** 2 + Math.cos(lat1 * rad) * Math.cos(lat2 * rad) * Math.sin(((lon2 - lon1) * rad) / 2) ** 2;
  return 2 * 6_371_008.8 * Math.asin(Math.sqrt(s));
}

interface Plan {
  waypoints: { lon: number; lat: number }[];
}

// What the figures are depends on the machine, so they are measured on a quiet one: FLOEPLAN_LOAD=1 tests/browser/run.sh BINARY load
test.skip(!process.env['FLOEPLAN_LOAD'], 'measured on request only');
test('a loaded desk stays quick', async ({ page, request }) => {
  const { start, goal } = await findPlaces(request);
  const midnight = new Date(Math.floor(now() / 86_400_000) * 86_400_000);
  await page.goto('/');
  await settled(page);
  await page.getByRole('button', { name: 'Data', exact: true }).click();
  const currents = currentFile([-60, 65, -48, 72], step_deg, midnight, hours);
  await page.getByLabel('Files to add').setInputFiles([{ name: 'ten_days.nc', mimeType: 'application/x-netcdf', buffer: currents }]);
  await expect(page.getByRole('region', { name: 'Import of ten_days.nc' }).getByText('Stored', { exact: true })).toBeVisible({ timeout: 120_000 });
  const more = bergs - Number(await page.locator('#map').getAttribute('data-icebergs'));
  await page.getByLabel('Files to add').setInputFiles([crowdOfBergs(start, more)]);
  await expect(page.getByRole('region', { name: 'Import of crowd.geojson' })).toContainText(`${more} accepted`);
  const store = async (inputs: object): Promise<Plan> => {
    const answer = await request.post('/processes/plan-route/execution', {
      data: { inputs: { from: start, to: goal, method: 'direct', refine: false, icebergs: 'none', ...inputs } },
      headers: { Prefer: 'respond-sync' },
    });
    expect(answer.ok(), await answer.text()).toBe(true);
    return ((await answer.json()) as { plan: Plan }).plan;
  };
  const depart = (i: number): string => new Date(midnight.getTime() + (6 + 3 * i) * 3_600_000).toISOString();
  for (let i = 1; i < plans; ++i) await store({ depart: depart(i), name: `Load ${i}` });
  const max_leg_m = (1.02 * metres(start, goal)) / (waypoints - 1);
  const long = await store({ depart: depart(0), name: `Load ${plans}`, max_leg_m });
  expect(long.waypoints.length).toBe(waypoints);

  const opened_ms = Date.now();
  await page.goto('/');
  await expect(page.getByRole('heading', { name: 'Floeplan' })).toBeVisible();
  const shell_ms = Date.now() - opened_ms;
  await settled(page);
  const map_ms = Date.now() - opened_ms;
  const map = page.locator('#map');
  await expect(map).toHaveAttribute('data-icebergs', String(bergs));
  await page.getByRole('button', { name: /^Plans/ }).click();
  for (const tick of await page.getByRole('checkbox', { name: /^Show Load/ }).all()) await tick.check();
  await expect(map).toHaveAttribute('data-plans', String(plans));
  await settled(page);

  await map.focus();
  const step = (): Promise<number[]> => page.evaluate(async () => {
    const taken: number[] = [];
    for (let i = 0; i < 40; ++i) {
      const began = performance.now();
      document.activeElement?.dispatchEvent(new KeyboardEvent('keydown', { key: '.', bubbles: true }));
      taken.push(performance.now() - began);
      await new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve)));
    }
    return taken;
  });
  const steps_ms = await step();
  const session = await page.context().newCDPSession(page);
  await session.send('Emulation.setCPUThrottlingRate', { rate: 4 });
  const slow_ms = await step();
  await session.send('Emulation.setCPUThrottlingRate', { rate: 1 });
  await settled(page);

  const projections: number[] = [];
  for (const code of ['EPSG:3995', 'EPSG:3413', 'EPSG:3857', 'EPSG:3413']) {
    projections.push(await page.evaluate((wanted) => {
      const choice = document.querySelector<HTMLSelectElement>('header select');
      if (!choice) return NaN;
      choice.value = wanted;
      const began = performance.now();
      choice.dispatchEvent(new Event('change', { bubbles: true }));
      return performance.now() - began;
    }, code));
    await settled(page);
  }

  await page.locator('.plan-list').getByRole('button').filter({ hasText: `Load ${plans}` }).click();
  const prepared = page.waitForResponse(evaluations);
  await page.getByRole('button', { name: 'Edit copy' }).click();
  await prepared;
  await mapAtRest(page);
  const grip = long.waypoints[Math.floor(waypoints / 2)];
  if (!grip) throw new Error('The plan has no waypoint in its middle.');
  const at = await pixelOf(page, [grip.lon, grip.lat]);
  await page.evaluate(() => {
    const taken: number[] = [];
    Object.assign(globalThis, { toDrawnFrame_ms: taken });
    addEventListener('pointermove', () => {
      const began = performance.now();
      requestAnimationFrame(() => setTimeout(() => taken.push(performance.now() - began)));
    }, { capture: true });
  });
  const trips: number[] = [];
  await page.mouse.move(at.x, at.y);
  for (let i = 0; i < 100; ++i) {
    await page.mouse.down();
    await page.mouse.move(at.x + (i % 2 === 0 ? 20 : 0), at.y + i % 5, { steps: 4 });
    const answered = page.waitForResponse(evaluations);
    const began = performance.now();
    await page.mouse.up();
    await answered;
    await expect(page.locator('.figures-grid')).toHaveAttribute('aria-busy', 'false');
    trips.push(performance.now() - began);
  }
  const ghost_ms = await page.evaluate(() => (globalThis as unknown as { toDrawnFrame_ms: number[] }).toDrawnFrame_ms);
  await session.send('HeapProfiler.collectGarbage');
  const heap = (await session.send('Runtime.getHeapUsage')).usedSize;
  const figures: [what: string, value: number, budget: number, unit: string][] = [
    ['shell visible', shell_ms, 1000, 'ms'],
    ['map usable', map_ms, 2500, 'ms'],
    ['clock step, median', median(steps_ms), 16, 'ms'],
    ['clock step with a processor four times slower, median', median(slow_ms), 60, 'ms'],
    ['projection switch, longest', Math.max(...projections), 400, 'ms'],
    ['drag to the frame that shows it, median', median(ghost_ms), 34, 'ms'],
    ['drag to evaluated figures, p95', quantile(trips, 0.95), 200, 'ms'],
    ['heap', heap / 1e6, 150, 'MB'],
  ];
  for (const [what, value, budget, unit] of figures) {
    console.log(`${what} ${value.toFixed(0)} ${unit} (${budget})`);
    expect.soft(value, what).toBeLessThanOrEqual(budget);
  }
});
