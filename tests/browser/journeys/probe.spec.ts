import type { Page } from '@playwright/test';
import { currentFile } from '../support/current_file';
import { expect, mapAtRest, open, pixelOf, settled, test, type LonLat } from '../support/page';

/** In the field of drift ice of the demonstration data. */
const inIce: LonLat = [-52.7, 68.96];

/** What the pointer and the probe tell of a place. */
async function toldAt(page: Page, place: LonLat): Promise<{ read: string; card: string }> {
  const { x, y } = await pixelOf(page, place);
  await page.mouse.move(x + 40, y);
  await page.mouse.move(x, y);
  await expect(page.locator('.readout')).not.toHaveClass(/late/);
  await page.mouse.click(x, y);
  const card = page.getByRole('region', { name: 'Probe' });
  await expect(card).toContainText('Nearest iceberg');
  return { read: await page.locator('.readout').innerText(), card: await card.innerText() };
}

const currentIn = (text: string): string | undefined => /\d\.\d\d m\/s to \d{3}°/.exec(text)?.[0];
const depthIn = (text: string): string | undefined => /\d+ m(?=\n)/.exec(text)?.[0];
const iceIn = (text: string): string | undefined => /\d+ %, \d\.\d m thick/.exec(text)?.[0];

test('pointer and probe tell the same of a place on maps of every scale', async ({ page }) => {
  await open(page);
  await page.getByRole('button', { name: 'Show icebergs' }).click(); // which the pointer would tell of instead
  await page.getByRole('button', { name: /^Probe/ }).click();
  for (let zoom = 0; zoom < 3; ++zoom) {
    const { read, card } = await toldAt(page, inIce);
    for (const figure of [currentIn, depthIn, iceIn]) {
      expect(figure(read), read).toBeDefined();
      expect(figure(card), card).toBe(figure(read));
    }
    await page.getByRole('button', { name: 'Zoom out (−)' }).click();
    await mapAtRest(page);
    await settled(page);
  }
});

test('pointer and probe read the data that the set-up names, and none that it leaves out', async ({ page, request }) => {
  const stored = async (): Promise<{ id: string; kind: string; name: string; time_start: string; bbox: [number, number, number, number] }[]> =>
    ((await (await request.get('/datasets')).json()) as { datasets: never[] }).datasets;
  const demo = (await stored()).find(({ kind }) => kind === 'currents');
  if (!demo) throw new Error('The store has no currents.');
  await open(page);
  await page.getByRole('button', { name: 'Data', exact: true }).click();
  const file = currentFile(demo.bbox, 0.25, new Date(demo.time_start), 120);
  await page.getByLabel('Files to add').setInputFiles([{ name: 'other_model.nc', mimeType: 'application/x-netcdf', buffer: file }]);
  await expect(page.getByRole('region', { name: 'Import of other_model.nc' }).getByText('Stored', { exact: true })).toBeVisible();
  await page.getByRole('button', { name: 'Set-up', exact: true }).click();
  await page.locator('summary', { hasText: /^Data/ }).click();
  await page.getByRole('button', { name: /^Probe/ }).click();

  const told: Record<string, string | undefined> = {};
  for (const name of ['other_model', demo.name]) {
    await page.getByLabel('Currents', { exact: true }).selectOption({ label: name });
    await settled(page);
    const { read, card } = await toldAt(page, inIce);
    expect(card).toContain(name);
    told[name] = currentIn(card);
    expect(currentIn(read)).toBe(told[name]);
  }
  expect(told['other_model']).not.toBe(told[demo.name]);

  await page.getByLabel('Sea ice', { exact: true }).selectOption({ label: 'None' });
  await settled(page);
  const { read, card } = await toldAt(page, inIce);
  expect(read).not.toContain('sea ice');
  expect(card).toMatch(/Sea ice\s+–\s*left out by the set-up/);

  const added = (await stored()).find(({ name }) => name === 'other_model');
  expect((await request.delete(`/datasets/${added?.id ?? ''}`)).ok()).toBe(true);
});
