import { expect, open, planByTyping, settled, test } from '../support/page';
import { crowdOfBergs } from '../support/files';
import { findPlaces } from '../support/places';

const heapLimit_bytes = 150e6;
const plansLoaded = 20;

/** Requests the page may make from its address to a map that shows everything, in the order of a full page and its data. */
const openingLimit = 22;

test('the page asks the server for little, and for nothing more while nothing is done', async ({ page }) => {
  const asked: string[] = [];
  page.on('request', (request) => {
    const path = new URL(request.url()).pathname;
    if (path !== '/app/favicon.svg') asked.push(path); // the browser asks for it itself, whenever it pleases
  });
  await open(page);
  expect(asked.length, asked.join('\n')).toBeLessThanOrEqual(openingLimit);
  expect(new Set(asked.filter((path) => path.startsWith('/app/assets/'))).size).toBe(asked.filter((path) => path.startsWith('/app/assets/')).length);

  await page.getByRole('button', { name: 'One hour on (.)' }).click();
  await settled(page);
  await page.getByRole('button', { name: 'One hour back (,)' }).click();
  await settled(page);
  const before = asked.length;
  await page.getByRole('button', { name: 'One hour on (.)' }).click();
  await page.getByRole('button', { name: 'One hour back (,)' }).click();
  await settled(page);
  expect(asked.slice(before)).toEqual([]);
});

test('three hundred icebergs and twenty plans played through stay within the memory allowed', { tag: '@long' }, async ({ page, request }) => {
  const { start, goal } = await findPlaces(request);
  await open(page);
  await planByTyping(page, start, goal);
  const map = page.locator('#map');
  const more = 300 - Number(await map.getAttribute('data-icebergs'));
  await page.getByRole('button', { name: 'Data', exact: true }).click();
  await page.getByLabel('Files to add').setInputFiles([crowdOfBergs(start, more)]);
  await expect(page.getByRole('region', { name: 'Import of crowd.geojson' })).toContainText(`${more} accepted`);

  await page.route('**/collections/plans/items?**', async (route) => {
    const answer = await route.fetch();
    const { features } = (await answer.json()) as { features: { id: string; properties: { plan_id: string; name: string } }[] };
    const [one] = features;
    if (!one) throw new Error('The store has no plan.');
    const many = Array.from({ length: plansLoaded }, (_, i) => ({
      ...one, id: `copy-${i}`, properties: { ...one.properties, plan_id: `copy-${i}`, name: `Copy ${i}` },
    }));
    await route.fulfill({ json: { type: 'FeatureCollection', features: many, numberMatched: many.length, numberReturned: many.length, links: [] } });
  });
  await page.reload();
  await settled(page);
  await expect(map).toHaveAttribute('data-icebergs', '300');
  await page.getByRole('button', { name: /^Plans/ }).click();
  for (const tick of await page.getByRole('checkbox', { name: /^Show Copy/ }).all()) await tick.check();
  await expect(map).toHaveAttribute('data-plans', String(plansLoaded));

  const session = await page.context().newCDPSession(page);
  const heap_bytes = async (): Promise<number> => {
    await session.send('HeapProfiler.collectGarbage');
    return (await session.send('Runtime.getHeapUsage')).usedSize;
  };
  const playThrough = async (): Promise<void> => {
    await page.locator('#map').focus();
    await page.keyboard.press('Home');
    for (let i = 0; i < 24; ++i) await page.keyboard.press(']');
    await settled(page);
  };
  await playThrough();
  const once = await heap_bytes();
  await playThrough();
  const twice = await heap_bytes();
  expect(twice).toBeLessThan(heapLimit_bytes);
  expect(twice - once).toBeLessThan(0.1 * heapLimit_bytes);

  await page.getByRole('button', { name: 'Data', exact: true }).click();
  page.once('dialog', (dialog) => void dialog.accept());
  await page.getByRole('button', { name: 'Remove crowd', exact: true }).click();
  await expect(page.getByRole('button', { name: 'Remove crowd', exact: true })).toHaveCount(0);
});
