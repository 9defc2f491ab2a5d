import { expectAccessible } from '../support/accessible';
import { now } from '../support/now';
import { expect, mapAtRest, open, pixelOf, planByTyping, settled, test, typed, typeInto, type LonLat } from '../support/page';
import { findPlaces } from '../support/places';
import type { APIRequestContext, Page } from '@playwright/test';

const part = (page: Page) => page.getByRole('region', { name: 'Manual entries' });
const data = (page: Page) => page.getByRole('button', { name: 'Data', exact: true });
const list = (page: Page) => part(page).getByRole('list', { name: 'Manual entries' });

/** Takes away what a test has reported, so that the next one finds the store as it was. */
async function clear(request: APIRequestContext): Promise<void> {
  for (const [collection, query] of [['icebergs', '?dataset=icebergs-by-hand'], ['nogo-zones', '']] as const) {
    const answer = await request.get(`/collections/${collection}/items${query}`);
    if (!answer.ok()) continue;
    const { features } = (await answer.json()) as { features: { id: number }[] };
    for (const { id } of features) await request.delete(`/collections/${collection}/items/${id}`);
  }
}
test.afterEach(async ({ request }) => clear(request));

test('an iceberg is reported, moved and retired with the mouse, and a plan made before is marked', { tag: '@long' }, async ({ page, request }) => {
  const { start, goal } = await findPlaces(request);
  await open(page);
  await planByTyping(page, start, goal);
  const bergs = Number(await page.locator('#map').getAttribute('data-icebergs'));
  await data(page).click();
  await part(page).getByRole('button', { name: 'Report an iceberg' }).click();
  const middle: LonLat = [(start[0] + goal[0]) / 2, (start[1] + goal[1]) / 2];
  await mapAtRest(page);
  const at = await pixelOf(page, middle);
  await page.mouse.click(at.x, at.y);
  await expect(part(page).getByLabel('Position', { exact: true })).toHaveValue(/\d+°/);
  await part(page).getByLabel('Name of the berg').fill('seen from the bridge');
  await expectAccessible(page);
  await part(page).getByRole('button', { name: 'Store' }).click();
  await expect(list(page)).toContainText('seen from the bridge');
  await expect(page.locator('#map')).toHaveAttribute('data-icebergs', String(bergs + 1));
  const stale = page.getByRole('region', { name: 'Stale data' });
  await expect(stale).toContainText('newer icebergs: Manual entries');
  await stale.getByRole('button', { name: 'Re-check' }).click();
  await expect(stale.getByRole('alert')).toContainText(/ice/i);

  const place = list(page).locator('.dataset-figures span').first();
  const reported = await place.innerText();
  await part(page).getByRole('button', { name: 'Change seen from the bridge' }).click();
  await part(page).getByRole('button', { name: 'Pick the position of the berg on the map' }).click();
  await mapAtRest(page);
  const aside = await pixelOf(page, [middle[0] + 0.06, middle[1] + 0.01]);
  await page.mouse.click(aside.x, aside.y);
  await part(page).getByRole('button', { name: 'Store' }).click();
  await expect(part(page).getByRole('form')).toBeHidden();
  await expect(place).not.toHaveText(reported);
  const moved = await place.innerText();

  await part(page).getByRole('button', { name: 'Retire seen from the bridge' }).click();
  await expect(list(page)).toBeHidden();
  await expect(page.locator('#map')).toHaveAttribute('data-icebergs', String(bergs));
  await part(page).getByTitle('Undo (Ctrl+Z): retiring seen from the bridge').click();
  await expect(place).toHaveText(moved);
  await part(page).getByTitle('Undo (Ctrl+Z): changing seen from the bridge').click();
  await expect(place).toHaveText(reported);
  await part(page).getByTitle('Redo (Ctrl+Shift+Z): changing seen from the bridge').click();
  await expect(place).toHaveText(moved);
  await part(page).getByTitle('Undo (Ctrl+Z): changing seen from the bridge').click();
  await part(page).getByTitle('Undo (Ctrl+Z): adding seen from the bridge').click();
  await expect(list(page)).toBeHidden();
  await expect(page.locator('#map')).toHaveAttribute('data-icebergs', String(bergs));
});

test('an iceberg is reported with the keyboard alone, and what another changed meanwhile is not overwritten unasked', { tag: '@long' }, async ({ page, request }) => {
  const { start } = await findPlaces(request);
  await open(page);
  await data(page).focus();
  await page.keyboard.press('Enter');
  await part(page).getByRole('button', { name: 'Report an iceberg' }).focus();
  await page.keyboard.press('Enter');
  await typeInto(page, part(page).getByLabel('Seen at'), 'yesterday');
  await page.keyboard.press('Enter');
  await expect(part(page).getByLabel('Position', { exact: true })).toHaveAttribute('aria-invalid', 'true');
  await expect(part(page).getByLabel('Seen at')).toHaveAttribute('aria-invalid', 'true');
  await expectAccessible(page);
  await typeInto(page, part(page).getByLabel('Position', { exact: true }), typed(start));
  await typeInto(page, part(page).getByLabel('Seen at'), '2026-11-22 00:30');
  await part(page).getByLabel('Size class').selectOption('large');
  await part(page).getByLabel('Position', { exact: true }).focus();
  await page.keyboard.press('Enter');
  await expect(list(page)).toContainText('sighted-1');

  const change = part(page).getByRole('button', { name: 'Change sighted-1' });
  await change.focus();
  await page.keyboard.press('Enter');
  const length = part(page).getByLabel('Length');
  await typeInto(page, length, '180');
  const answer = await request.get('/collections/icebergs/items?dataset=icebergs-by-hand');
  const { features } = (await answer.json()) as { features: { id: number }[] };
  const theirs = await request.patch(`/collections/icebergs/items/${features[0]?.id ?? 0}`, { data: { properties: { length_m: 150 } } });
  expect(theirs.status()).toBe(204);
  await length.focus();
  await page.keyboard.press('Enter');
  const conflict = part(page).getByRole('alert');
  await expect(conflict).toContainText('Somebody else has changed it');
  await expectAccessible(page);
  await conflict.getByRole('button', { name: 'Take theirs' }).focus();
  await page.keyboard.press('Enter');
  await expect(length).toHaveValue('150');
  await typeInto(page, length, '170');
  await page.keyboard.press('Enter');
  await expect(part(page).getByRole('form')).toBeHidden();
  await change.focus();
  await page.keyboard.press('Enter');
  await expect(length).toHaveValue('170');
  await part(page).getByRole('button', { name: 'Cancel' }).focus();
  await page.keyboard.press('Enter');

  await request.patch(`/collections/icebergs/items/${features[0]?.id ?? 0}`, { data: { properties: { length_m: 190 } } });
  await part(page).getByTitle('Undo (Ctrl+Z): changing sighted-1').focus();
  await page.keyboard.press('Enter');
  await expect(part(page).getByRole('alert')).toContainText('cannot be undone: somebody else has changed it since');
});

test('a zone is drawn into the store, obeyed by plans, changed and retired, by day and by night', { tag: '@long' }, async ({ page, request }) => {
  const { start, goal } = await findPlaces(request);
  await open(page);
  await data(page).click();
  await part(page).getByRole('button', { name: 'Draw a zone' }).click();
  const around = ([lon, lat]: LonLat, dx: number, dy: number): LonLat => [lon + dx, lat + dy];
  for (const [dx, dy] of [[-0.12, -0.03], [0.12, -0.03], [0.12, 0.03]] as const) {
    const corner = await pixelOf(page, around(goal, dx, dy));
    await page.mouse.click(corner.x, corner.y);
  }
  const last = await pixelOf(page, around(goal, -0.12, 0.03));
  await page.mouse.dblclick(last.x, last.y);
  await part(page).getByLabel('Name of the zone').fill('Survey closed');
  await part(page).getByRole('button', { name: 'Store' }).click();
  await expect(list(page)).toContainText('Survey closed');
  await expect(page.locator('#map')).toHaveAttribute('data-zones', '1');
  await page.getByRole('button', { name: /^Use the dark theme/ }).click();
  await expectAccessible(page);

  await page.getByRole('button', { name: 'Set-up', exact: true }).click();
  await page.getByLabel('Start', { exact: true }).fill(typed(start));
  await page.getByLabel('Goal', { exact: true }).fill(typed(goal));
  await page.getByRole('button', { name: /^Plan / }).click();
  await expect(page.getByRole('alert', { name: 'No plan is possible' })).toContainText('The goal lies in a closed area', { timeout: 120_000 });

  await data(page).click();
  await part(page).getByRole('button', { name: 'Change Survey closed' }).focus();
  await page.keyboard.press('Enter');
  await part(page).getByText('4 corners').focus();
  await page.keyboard.press('Enter');
  await part(page).getByLabel('Below').fill('deep');
  await part(page).getByRole('button', { name: 'Store' }).focus();
  await page.keyboard.press('Enter');
  await expect(part(page).getByRole('alert')).toContainText('write its depths in metres');
  await part(page).getByLabel('Below').fill('600');
  await page.keyboard.press('Enter');
  await expect(list(page)).toContainText('600 m – sea bed');
  await page.reload();
  await settled(page);
  await data(page).click();
  await expect(list(page)).toContainText('600 m – sea bed');
  await part(page).getByRole('button', { name: 'Retire Survey closed' }).focus();
  await page.keyboard.press('Enter');
  await expect(page.locator('#map')).toHaveAttribute('data-zones', '0');
  await part(page).getByTitle('Undo (Ctrl+Z): retiring Survey closed').focus();
  await page.keyboard.press('Enter');
  await expect(page.locator('#map')).toHaveAttribute('data-zones', '1');
});

test('what another changed meanwhile gives way when a person says so', { tag: '@long' }, async ({ page, request }) => {
  const { start } = await findPlaces(request);
  const items = '/collections/icebergs/items';
  const properties = { berg_id: 'watched', observed: new Date(now() - 3_600_000).toISOString(), length_m: 100 };
  const made = await request.post(items, { data: { type: 'Feature', geometry: { type: 'Point', coordinates: start }, properties } });
  expect(made.status(), await made.text()).toBe(201);
  const id = made.headers()['location']?.split('/').at(-1) ?? '';
  await open(page);
  await data(page).click();
  await part(page).getByRole('button', { name: 'Change watched' }).click();
  await part(page).getByLabel('Length').fill('180');
  const theirs = await request.patch(`${items}/${id}`, { data: { properties: { length_m: 150 } } });
  expect(theirs.status()).toBe(204);
  await part(page).getByRole('button', { name: 'Store' }).click();
  await part(page).getByRole('alert').getByRole('button', { name: 'Put mine in its place' }).click();
  await expect(part(page).getByRole('form')).toBeHidden();
  const { features } = (await (await request.get(`${items}?dataset=icebergs-by-hand`)).json()) as { features: { properties: { length_m: number } }[] };
  expect(features.map((one) => one.properties.length_m)).toEqual([180]);
});
