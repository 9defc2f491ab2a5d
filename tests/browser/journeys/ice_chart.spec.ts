import { expectAccessible } from '../support/accessible';
import { iceChart } from '../support/files';
import { expect, open, pixelOf, settled, test, type LonLat } from '../support/page';

/** In the drift ice of the demonstration data; the chart's border runs through it. */
const middle: LonLat = [-52.6, 68.96];
const west: LonLat = [middle[0] - 0.3, middle[1]];

test('an ice chart is drawn with its tenths, and tells its egg code and its age', async ({ page, request }) => {
  await open(page);
  const map = page.locator('#map');
  await expect(map).toHaveAttribute('data-ice-chart', 'none');
  await page.getByRole('button', { name: 'Data', exact: true }).click();
  await page.getByLabel('Files to add').setInputFiles([iceChart('chart_20261122T0600Z.geojson', middle)]);
  await expect(page.getByRole('region', { name: 'Import of chart_20261122T0600Z.geojson' }).getByText('Stored', { exact: true })).toBeVisible();
  await expect(map).toHaveAttribute('data-ice-chart', '2');
  await settled(page);

  const legend = page.locator('.legend');
  await expect(legend).toContainText(/Ice chart tenths.*22 Nov 06:00Z, \d+ h old/s);
  await page.getByRole('button', { name: 'Set-up', exact: true }).click();
  await page.locator('summary', { hasText: /^Data/ }).click();
  await page.getByLabel('Sea ice', { exact: true }).selectOption({ label: 'chart_20261122T0600Z' });
  await expect(legend).toContainText('held as of 22 Nov 06:00Z');
  await settled(page);
  const { x, y } = await pixelOf(page, west);
  await page.mouse.move(x, y);
  await expect(page.locator('.readout')).toContainText('sea ice 100 %');
  await page.getByRole('button', { name: /^Probe/ }).click();
  await page.mouse.click(x, y);
  const card = page.getByRole('region', { name: 'Probe' });
  await expect(card.getByRole('img', { name: 'Egg code' })).toHaveText('9160 3087 8405 04');
  await expect(card).toContainText('9 to 10 tenths');
  await expect(card).toContainText('6 tenths thin first-year ice, 30 to 70 cm; big floes, 500 m to 2 km');
  await expect(card).toContainText(/chart_20261122T0600Z, 22 Nov 06:00Z, \d+ h old/);
  await expectAccessible(page);

  const { datasets } = (await (await request.get('/datasets')).json()) as { datasets: { id: string; variables: string[] }[] };
  const chart = datasets.find(({ variables }) => variables.includes('CT'));
  expect((await request.delete(`/datasets/${chart?.id ?? ''}`)).status()).toBe(204);
});
