import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { expect, planAndWait, settled, test as base, typed, type LonLat } from '../support/page';
import { startServer, type Server } from '../support/server';

const folder = join(__dirname, '../../../../shared/data/env');
const files = ['currents/arctic20km_polarstereo_sub.nc', 'bathymetry/topo_30min.nc', 'icebergs/IIP_2014IcebergSeason_a.csv'];

/** A server whose store holds nothing yet. */
const test = base.extend<object, { emptyServer: Server }>({
  emptyServer: [
    async ({}, use) => {
      const server = await startServer({ empty: true });
      await use(server);
      await server.stop();
    },
    { scope: 'worker' },
  ],
  baseURL: async ({ emptyServer }, use) => use(emptyServer.url),
});

/** In the Greenland Sea, within the currents of all three days and far from any coast. */
const start: LonLat = [3, 72];
const goal: LonLat = [3.4, 72.1];

test('from an empty store to a mission with files that real sources publish', async ({ page }) => {
  const missing = files.filter((name) => !existsSync(join(folder, name)));
  test.skip(missing.length > 0, `not there: ${missing.join(', ')}`);
  await page.goto('/');
  await expect(page.getByRole('region', { name: 'Empty store' })).toBeVisible();
  await page.getByLabel('Files to add').setInputFiles(files.map((name) => join(folder, name)));
  const report = page.getByRole('region', { name: /^Import of/ });
  await expect(report.getByText('Stored', { exact: true })).toHaveCount(files.length, { timeout: 120_000 });
  await settled(page);
  await expect(page.locator('#map')).toHaveAttribute('data-currents', 'shown');

  await page.getByRole('button', { name: 'Set-up', exact: true }).click();
  await page.getByLabel('Start', { exact: true }).fill(typed(start));
  await page.getByLabel('Goal', { exact: true }).fill(typed(goal));
  await planAndWait(page);
  await page.getByRole('button', { name: 'Export mission' }).click();
  await expect(page.getByRole('dialog').locator('pre')).toContainText('<start:waypoints>');
});
