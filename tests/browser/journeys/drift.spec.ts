import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { bergFile } from '../support/files';
import { expect, open, planByTyping, settled, test } from '../support/page';
import { findPlaces } from '../support/places';
import type { Page } from '@playwright/test';

/** The moment that the page's clock shows. */
const clockOf = async (page: Page): Promise<string> => new Date(Number(await page.getByLabel('Time', { exact: true }).inputValue())).toISOString();

test('icebergs have ghosts where they are expected, and the layer puts them away', async ({ page }) => {
  await open(page);
  const map = page.locator('#map');
  await expect(map).not.toHaveAttribute('data-drifts', '0');
  expect(await map.getAttribute('data-drifts')).toBe(await map.getAttribute('data-icebergs'));
  await expect(page.getByText('expected, in its keep-out ring')).toBeVisible();

  const drift = page.getByRole('button', { name: 'Show iceberg drift' });
  await drift.focus();
  await page.keyboard.press('Enter');
  await expect(map).toHaveAttribute('data-drifts', '0');
  await page.keyboard.press('Enter');
  await settled(page);
  await expect(map).not.toHaveAttribute('data-drifts', '0');
});

test('the map shows the icebergs of every file that a plan joins, and those of the chosen ones alone', { tag: '@long' }, async ({ page, request, server }) => {
  const { start, goal } = await findPlaces(request);
  const map = page.locator('#map');
  // What a plan under way obeys is drawn, too: none may be left of another journey.
  const left = (await (await request.get('/collections/plans/items?limit=500')).json()) as { features: { id: string }[] };
  for (const { id } of left.features) await request.delete(`/collections/plans/items/${id}`);
  await open(page);
  const before = Number(await map.getAttribute('data-icebergs'));
  expect(before).toBeGreaterThan(0);
  const folder = mkdtempSync(join(tmpdir(), 'floeplan-bergs-'));
  const { name, text } = bergFile(start);
  writeFileSync(join(folder, name), text.replaceAll(/"observed":"[^"]*"/g, `"observed":"${await clockOf(page)}"`));
  server.run('ingest', join(folder, name));
  rmSync(folder, { recursive: true });

  await open(page);
  await expect(map).toHaveAttribute('data-icebergs', String(before + 2));
  await expect(map).toHaveAttribute('data-drifts', String(before + 2));
  await page.getByText('Advanced', { exact: true }).click();
  await page.getByText('Data', { exact: true }).last().click();
  const ice = page.getByLabel('Icebergs', { exact: true });
  await ice.selectOption({ label: 'sighted-today' });
  await expect(map).toHaveAttribute('data-icebergs', '2');
  await expect(map).toHaveAttribute('data-drifts', '2');
  await expect(page.getByText('of the dataset chosen')).toBeVisible();
  await ice.selectOption({ label: 'None' });
  await expect(map).toHaveAttribute('data-icebergs', '0');

  await ice.selectOption('newest');
  await expect(map).toHaveAttribute('data-icebergs', String(before + 2));
  await planByTyping(page, start, goal);
  const { features } = (await (await request.get('/collections/plans/items?limit=500')).json()) as { features: { properties: { datasets: { kind: string }[] } }[] };
  expect(features.at(-1)?.properties.datasets.filter(({ kind }) => kind === 'icebergs')).toHaveLength(2);
  // What a plan under way obeys is drawn, whatever the set-up chooses for the next one.
  await ice.selectOption({ label: 'sighted-today' });
  await expect(map).toHaveAttribute('data-icebergs', String(before + 2));

  const { datasets } = (await (await request.get('/datasets')).json()) as { datasets: { id: string; name: string }[] };
  for (const { id } of datasets.filter((one) => one.name === 'sighted-today')) await request.delete(`/datasets/${id}`);
});

test('a server that cannot forecast the drift is asked once', async ({ page }) => {
  let asked = 0;
  await page.route('**/map/drift?**', async (route) => {
    ++asked;
    await route.fulfill({ status: 400, contentType: 'application/problem+json', body: '{"title":"no","status":400,"detail":"no"}' });
  });
  await open(page);
  await expect(page.locator('#map')).toHaveAttribute('data-drifts', '0');
  const before = asked;
  await page.getByRole('button', { name: 'One hour on (.)' }).click();
  await settled(page);
  expect(asked - before).toBeLessThanOrEqual(1);
});
