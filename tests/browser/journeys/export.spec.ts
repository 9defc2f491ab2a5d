import { readFile } from 'node:fs/promises';
import { expectAccessible } from '../support/accessible';
import { expect, mapAtRest, open, pixelOf, planByTyping, test, type LonLat } from '../support/page';
import { findPlaces } from '../support/places';

/** In open water of the demonstration data, north of its drift ice. */
const west: LonLat = [-52.6, 69.15];
const east: LonLat = [-52.2, 69.13];

test('a plan is previewed as the glider will read it, and downloaded', async ({ page, request }) => {
  const { start, goal } = await findPlaces(request);
  await open(page);
  await planByTyping(page, start, goal);

  const labels = await page.getByRole('region', { name: 'Waypoints' }).locator('.row-choose').allInnerTexts();
  expect(labels).toEqual(labels.map((_, i) => (i === 0 ? 'S' : String(i))));

  await page.getByRole('button', { name: 'Export mission' }).click();
  const dialog = page.getByRole('dialog');
  await expect(dialog.getByText('goto_l10.ma').first()).toBeVisible();
  await expect(dialog.locator('pre')).toContainText('<start:waypoints>');
  await dialog.getByLabel(/^Number of the waypoint list/).fill('27');
  await expect(dialog.getByText('goto_l27.ma').first()).toBeVisible();

  const asked: string[] = [];
  page.on('request', (one) => {
    if (one.url().includes('/mission?')) asked.push(one.url());
  });
  await dialog.getByLabel('Files for the vehicle').selectOption('full');
  await dialog.getByLabel(/^Mission name/).pressSequentially('kangia');
  await expect(dialog.getByRole('button', { name: 'kangia.mi' })).toBeVisible();
  expect(asked.length, 'one for the choice of files, few for what is typed').toBeLessThanOrEqual(3);
  await dialog.getByLabel('Files for the vehicle').selectOption('lists');
  await expect(dialog.getByText('goto_l27.ma').first()).toBeVisible();

  for (const [button, ending] of [['Mission files (.zip)', 'zip'], ['GPX', 'gpx'], ['KML', 'kml'], ['GeoJSON', 'geojson'], ['CSV', 'csv'], ['Brief (PDF)', 'pdf']] as const) {
    const waiting = page.waitForEvent('download');
    await dialog.getByRole('link', { name: button, exact: true }).click();
    const download = await waiting;
    expect(download.suggestedFilename()).toMatch(new RegExp(`\\.${ending}$`));
    const file = await readFile(await download.path());
    expect(file.length).toBeGreaterThan(20);
    if (ending === 'gpx') expect([...file.toString().matchAll(/<name>([^<]*)<\/name><\/rtept>/g)].map(([, name]) => name)).toEqual(labels);
  }
  await dialog.getByText('Waypoints and rows of the files').click();
  const rows = dialog.getByRole('region', { name: 'Rows of the files' });
  await expect(rows.getByRole('rowheader')).toHaveText(labels);
  await expect(rows.getByRole('row').nth(2)).toHaveText(/^11goto_l27\.ma0$/);
  await page.keyboard.press('Escape');
  await expect(dialog).toBeHidden();

  const brief = page.waitForEvent('download');
  await page.getByRole('link', { name: 'Brief', exact: true }).click();
  expect((await brief).suggestedFilename()).toMatch(/\.html$/);
});

test('a plan is exported with the keyboard alone', { tag: '@long' }, async ({ page, request }) => {
  const { start, goal } = await findPlaces(request);
  await open(page);
  await planByTyping(page, start, goal);
  const button = page.getByRole('button', { name: 'Export mission' });
  await button.focus();
  await page.keyboard.press('Enter');
  await expect(page.getByRole('dialog').locator('pre')).toBeVisible();
  const waiting = page.waitForEvent('download');
  await page.getByRole('link', { name: 'Mission files (.zip)' }).focus();
  await page.keyboard.press('Enter');
  expect((await waiting).suggestedFilename()).toMatch(/\.zip$/);
  await page.keyboard.press('Escape');
  await expect(button).toBeFocused();
});

test('a refused export lists every fault that the server names', async ({ page, request }) => {
  const { start, goal } = await findPlaces(request);
  await open(page);
  await planByTyping(page, start, goal);
  const refusal = {
    title: 'Invalid request',
    status: 400,
    detail: 'The request has faults; each is listed under "errors".',
    errors: [
      { pointer: '/waypoints', detail: 'must not be so many below ice or icebergs: waypoints 4 to 14 lie there' },
      { pointer: '/waypoints', detail: 'must not be so many below ice or icebergs: waypoints 17 to 25 lie there' },
    ],
  };
  await page.route('**/mission?number=*', (route) => route.fulfill({ status: 400, json: refusal, contentType: 'application/problem+json' }));

  await page.getByRole('button', { name: 'Export mission' }).click();
  const refused = page.getByRole('dialog').getByRole('alert');
  await expect(refused).toContainText('No mission files are written');
  await expect(refused.getByRole('listitem')).toHaveText(refusal.errors.map(({ detail }) => `Waypoints ${detail}.`));
  await expect(page.getByRole('dialog').locator('pre')).toBeHidden();
});

test('the browser asks for all files that the command line writes', async ({ page, request }) => {
  const { datasets } = (await (await request.get('/datasets')).json()) as { datasets: { kind: string; time_start: string }[] };
  const depart = datasets.find(({ kind }) => kind === 'currents')?.time_start;
  const inputs = { from: west, to: east, depart, name: 'All files', spacing_m: 3000, refine: false, icebergs: 'none' };
  const answer = await request.post('/processes/plan-route/execution', { data: { inputs }, headers: { Prefer: 'respond-sync' } });
  expect(answer.status(), await answer.text()).toBe(200);
  const { plan_id } = ((await answer.json()) as { plan: { plan_id: string } }).plan;
  await open(page);
  await page.getByRole('button', { name: /^Plans/ }).click();
  await page.locator('.plan-choose', { hasText: 'All files' }).click();
  await page.getByRole('button', { name: 'Export mission' }).click();
  const dialog = page.getByRole('dialog');
  const downloaded = async (name: string): Promise<string> => {
    const waiting = page.waitForEvent('download');
    await dialog.getByRole('link', { name, exact: true }).click();
    return (await readFile(await (await waiting).path())).toString('latin1');
  };
  const files = dialog.getByRole('group', { name: 'Files', exact: true });

  await dialog.getByLabel('Files for the vehicle').selectOption('full');
  await dialog.getByLabel(/^Mission name/).fill('disko');
  await dialog.getByLabel(/^Glider/).fill('amadeus');
  await expect(files.getByRole('button', { name: 'disko.mi' })).toBeVisible();
  await expect(files.getByRole('button', { name: 'yo10.ma' })).toBeVisible();
  await expectAccessible(page);
  expect(await downloaded('Mission files (.zip)')).toContain('gliders/amadeus/to-glider/disko.mi');

  await dialog.getByLabel(/^Safe places/).fill('nowhere');
  await expect(dialog.getByLabel(/^Safe places/)).toHaveAccessibleDescription(/^Line 1/);
  await expect(dialog.getByRole('button', { name: 'Mission files (.zip)' })).toBeDisabled();
  await dialog.getByLabel(/^Safe places/).fill('');
  await dialog.getByRole('button', { name: 'Pick a safe place on the map' }).click();
  await expect(dialog).toBeHidden();
  await mapAtRest(page);
  await page.keyboard.press('Escape');
  await expect(dialog.getByLabel(/^Mission name/)).toHaveValue('disko');
  await dialog.getByRole('button', { name: 'Pick a safe place on the map' }).click();
  await expect(dialog).toBeHidden();
  const { x, y } = await pixelOf(page, west);
  await page.mouse.click(x, y);
  await expect(dialog.getByLabel(/^Mission name/)).toHaveValue('disko');
  await expect(files.getByRole('button', { name: 'goto_l98.ma' })).toBeVisible();

  await expect(page.locator('#map')).toHaveAttribute('data-safe-places', '1');
  await dialog.getByLabel(/^Deepest iceberg/).fill('900');
  await expect(dialog.getByRole('alert')).toContainText('Deepest iceberg must be');
  await dialog.getByLabel(/^Deepest iceberg/).fill('');

  await dialog.getByText('Difference to another list').click();
  await files.getByRole('button', { name: 'goto_l10.ma' }).click();
  const there = '# on board\nbehavior_name=goto_list\n<start:waypoints>\n-5236.0000 6909.0000\n<end:waypoints>\n';
  await dialog.getByLabel('File to compare with').setInputFiles({ name: 'goto_l10.ma', mimeType: 'text/plain', buffer: Buffer.from(there) });
  const lines = dialog.getByLabel('Difference of goto_l10.ma to goto_l10.ma');
  await expect(lines).toContainText('− -5236.0000 6909.0000');
  await expect(lines).toContainText(/\+ -5212\.0000 6907\.8000/);
  await expect(lines).not.toContainText('on board');
  await expectAccessible(page);

  await dialog.getByLabel('Files for the vehicle').selectOption('seaglider');
  await dialog.getByLabel(/^Science bands/).fill('20:5:1110:60');
  await expect(files.getByRole('button', { name: 'science' })).toBeVisible();
  expect(await downloaded('NMEA')).toContain('WPL,');
  expect(JSON.parse(await downloaded('IMC'))).toBeTruthy();
  await request.delete(`/collections/plans/items/${plan_id}`);
});
