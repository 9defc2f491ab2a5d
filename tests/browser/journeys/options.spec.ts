import { expect, open, pixelOf, planAndWait, settled, test, typed, typeInto, type LonLat } from '../support/page';
import { expectAccessible } from '../support/accessible';
import { currentFile } from '../support/current_file';
import { routeFile } from '../support/files';
import { findPlaces } from '../support/places';

const chartDrawn = '.uplot canvas';

test('a window of departures is swept, and another departure chosen on the chart', { tag: '@long' }, async ({ page, request }) => {
  const { start, goal } = await findPlaces(request);
  await open(page);
  await page.getByLabel('Start', { exact: true }).fill(typed(start));
  await page.getByLabel('Goal', { exact: true }).fill(typed(goal));
  await page.getByText('Departure window', { exact: true }).click();
  const depart = await page.getByRole('textbox', { name: /^Departure/ }).inputValue();
  const until = new Date(Date.parse(`${depart.replace(' ', 'T')}:00Z`) + 12 * 3_600_000).toISOString().slice(0, 16).replace('T', ' ');
  await page.getByLabel(/^Latest departure/).fill(until);
  await page.getByLabel(/^Every/).fill('6');
  await planAndWait(page);

  const window = page.getByRole('region', { name: 'Departure window' });
  await expect(window.locator(chartDrawn)).toBeVisible();
  const plot = window.locator('.u-over');
  const box = await plot.boundingBox();
  const chosen = window.getByRole('button', { name: 'Plan this departure' });
  // At one end of the window at least stands a departure that is not the one planned.
  await plot.click({ position: { x: (box?.width ?? 4) - 3, y: 20 } });
  if (!(await chosen.isVisible())) await plot.click({ position: { x: 3, y: 20 } });
  const plans = Number(await page.locator('#map').getAttribute('data-plans'));
  await chosen.click();
  await expect(page.locator('#map')).toHaveAttribute('data-plans', String(plans + 1), { timeout: 120_000 });
});

test('the profile follows the clock, and the clock the profile; its figures can be read without the chart', async ({ page, request }) => {
  const { start, goal } = await findPlaces(request);
  await open(page);
  await page.getByLabel('Start', { exact: true }).fill(typed(start));
  await page.getByLabel('Goal', { exact: true }).fill(typed(goal));
  await planAndWait(page);
  await page.getByRole('button', { name: 'Profile', exact: true }).click();
  await expect(page.locator(chartDrawn).first()).toBeVisible();
  const slider = page.getByRole('slider', { name: 'Time' });
  const before = await slider.inputValue();
  const plot = page.locator('.u-over').first();
  const box = await plot.boundingBox();
  await plot.click({ position: { x: (box?.width ?? 0) / 2, y: 30 } });
  await expect(slider).not.toHaveValue(before);
  await expect(page.locator('.chart-marker').first()).toBeVisible();

  await page.getByText('Profile in figures').focus();
  await page.keyboard.press('Enter');
  const table = page.getByRole('region', { name: 'Profile' });
  expect(await table.getByRole('row').count()).toBeGreaterThan(10);
  const now = await slider.inputValue();
  await table.getByRole('button').last().focus();
  await page.keyboard.press('Enter');
  await expect(slider).not.toHaveValue(now);
});

test('an area is drawn on the map, and the way keeps out of it', async ({ page, request }) => {
  const { start, goal } = await findPlaces(request);
  await open(page);
  await page.getByText('Places and areas', { exact: true }).click();
  await page.getByRole('button', { name: 'Draw an area' }).click();
  const around = ([lon, lat]: LonLat, dx: number, dy: number): LonLat => [lon + dx, lat + dy];
  for (const [dx, dy] of [[-0.12, -0.03], [0.12, -0.03], [0.12, 0.03]] as const) {
    const corner = await pixelOf(page, around(goal, dx, dy));
    await page.mouse.click(corner.x, corner.y);
  }
  const last = await pixelOf(page, around(goal, -0.12, 0.03));
  // A double click of a hand: its clicks lie 8 pixels apart.
  await page.mouse.click(last.x, last.y);
  await page.mouse.click(last.x + 7, last.y + 4);
  await expect(page.locator('#map')).toHaveAttribute('data-areas', '1');
  await expect(page.getByLabel('Name of area 1')).toHaveValue('Area 1');

  await page.getByLabel('Start', { exact: true }).fill(typed(start));
  await page.getByLabel('Goal', { exact: true }).fill(typed(goal));
  await page.getByRole('button', { name: /^Plan / }).click();
  const failure = page.getByRole('alert', { name: 'No plan is possible' });
  await expect(failure).toContainText('The goal lies in a closed area', { timeout: 120_000 });

  await page.getByRole('form', { name: 'Set-up' }).getByRole('button', { name: /^Undo/ }).click();
  await page.getByRole('form', { name: 'Set-up' }).getByRole('button', { name: /^Undo/ }).click();
  await page.getByRole('form', { name: 'Set-up' }).getByRole('button', { name: /^Undo/ }).click();
  await expect(page.locator('#map')).toHaveAttribute('data-areas', '0');
});

test('an area is closed with Enter, and nothing is planned while it is drawn', async ({ page, request }) => {
  const { start, goal } = await findPlaces(request);
  await open(page);
  await page.getByLabel('Start', { exact: true }).fill(typed(start));
  await page.getByLabel('Goal', { exact: true }).fill(typed(goal));
  await page.getByText('Places and areas', { exact: true }).click();
  await page.getByRole('button', { name: 'Draw an area' }).click();
  const click = async (dx: number, dy: number): Promise<void> => {
    const corner = await pixelOf(page, [goal[0] + dx, goal[1] + dy]);
    await page.mouse.click(corner.x, corner.y);
    await page.mouse.move(corner.x + 25, corner.y - 25);
  };
  await click(-0.3, -0.05);
  await click(-0.1, -0.05);
  await page.getByRole('button', { name: /^Plan / }).click();
  await expect(page.locator('.notice')).toContainText('An area is being drawn');
  await page.locator('#map').focus();
  await page.keyboard.press('Enter'); // two corners have no inside
  await expect(page.locator('#map')).toHaveAttribute('data-areas', '0');
  await click(-0.1, 0.05);
  await expect(page.locator('.prompt')).toContainText('Enter, a double click or the first corner closes it');
  await click(-0.4, 0.15);
  await page.locator('#map').focus();
  await page.keyboard.press('Backspace'); // takes the last corner back
  await page.keyboard.press('Enter');
  await expect(page.locator('#map')).toHaveAttribute('data-areas', '1');
  await expect(page.locator('.area-row summary')).toHaveText('3 corners');
  await expect(page.locator('.prompt')).toHaveCount(0);

  await page.getByRole('button', { name: 'Draw an area' }).click();
  for (const [dx, dy] of [[0.1, -0.05], [0.3, -0.05], [0.2, 0.05], [0.1, -0.05]] as const) await click(dx, dy);
  await expect(page.locator('#map')).toHaveAttribute('data-areas', '2');
});

test('an area and via points are typed with the keyboard alone', { tag: '@long' }, async ({ page, request }) => {
  const { start, goal } = await findPlaces(request);
  await open(page);
  await page.getByText('Places and areas', { exact: true }).focus();
  await page.keyboard.press('Enter');
  await page.getByRole('button', { name: 'Type one' }).focus();
  await page.keyboard.press('Enter');
  await expect(page.locator('#map')).toHaveAttribute('data-areas', '1');
  await page.getByText('4 corners').focus();
  await page.keyboard.press('Enter');
  await typeInto(page, page.getByLabel('Corners, one on each line'), '69, -52\nnowhere');
  await expect(page.getByText(/^Line 2:/)).toBeVisible();
  await page.getByRole('button', { name: 'Remove area 1' }).focus();
  await page.keyboard.press('Enter');
  await expect(page.locator('#map')).toHaveAttribute('data-areas', '0');

  await page.getByRole('button', { name: 'Add a via point' }).focus();
  await page.keyboard.press('Enter');
  const middle: LonLat = [(start[0] + goal[0]) / 2, (start[1] + goal[1]) / 2];
  await typeInto(page, page.getByLabel('Via point 1', { exact: true }), typed(middle));
  await typeInto(page, page.getByLabel('Start', { exact: true }), typed(start));
  await typeInto(page, page.getByLabel('Goal', { exact: true }), typed(goal));
  const before = Number(await page.locator('#map').getAttribute('data-plans'));
  await page.keyboard.press('Enter');
  await expect(page.locator('#map')).toHaveAttribute('data-plans', String(before + 1), { timeout: 120_000 });
});

test('the set-up is there again after a reload', async ({ page }) => {
  await open(page);
  await page.getByLabel('Start', { exact: true }).fill('69.05, -52.5');
  await page.getByLabel('Iceberg margin').fill('750');
  await page.reload();
  await settled(page);
  await expect(page.getByLabel('Start', { exact: true })).toHaveValue('69.05, -52.5');
  await expect(page.getByLabel('Iceberg margin')).toHaveValue('750');
});

test('the server understands every option of the set-up', { tag: '@long' }, async ({ page, request }) => {
  const { start, goal } = await findPlaces(request);
  const ice = {
    max_inflation_m: '4000', max_sighting_age_days: '2', pass_under_icebergs: true, keel_clearance_m: '25', draft_uncertainty: '30',
    encounter_weight_s: '0.5', 'under_ice.surfacing_interval_s': '12', 'under_ice.dead_reckoning_share': '5',
    'under_ice.current_uncertainty_m_s': '0.04',
  };
  const others = {
    objective: 'both', 'objective.time': '1', 'objective.energy': '0.01', battery_j: '8', battery_start_share: '90', max_loiter_s: '2',
    refine_seconds: '0.2', optimality_gap: false, ice: 'none', zones: 'none', 'vehicle.depth_rating_m': '190', 'vehicle.hotel_w': '1.5',
    'vehicle.minimum_working_depth_m': '25', 'vehicle.buoyancy_cm3': '225', 'vehicle.surfacing_interval_s': '4', 'vehicle.surfacing_j': '4',
    'vehicle.battery_reserve_share': '15', 'vehicle.max_waypoints_per_list': '6', spacing_m: '1000 × 800',
  };
  await page.addInitScript((stored) => localStorage.setItem('floeplan.draft', stored), JSON.stringify({ ...ice, ...others }));
  await open(page);
  await page.getByLabel('Start', { exact: true }).fill(typed(start));
  await page.getByLabel('Goal', { exact: true }).fill(typed(goal));
  await planAndWait(page);

  await page.getByText('Uncertainty of currents', { exact: true }).click();
  await page.getByLabel('Members').fill('2');
  await page.getByLabel('Plan for').selectOption('quantile');
  await page.getByLabel('Quantile').fill('200');
  await page.getByRole('button', { name: /^Plan / }).click();
  await expect(page.getByLabel('Quantile')).toHaveAttribute('aria-invalid', 'true');
  await page.getByLabel('Quantile').fill('80');
  await planAndWait(page);
  await expect(page.getByText('Travel time, p10–p90')).toBeVisible();
});

test('goals are taken from a mission file, and a file that is none is refused beside its field', { tag: '@long' }, async ({ page, request }) => {
  const { start, goal } = await findPlaces(request);
  const middle: LonLat = [(start[0] + goal[0]) / 2, (start[1] + goal[1]) / 2];
  await open(page);
  // Waited for before anything else: the browser takes a moment to hand its choosers over.
  const opened = page.waitForEvent('filechooser');
  await page.getByRole('button', { name: 'Take the goals from a mission file' }).focus();
  await page.keyboard.press('Enter');
  await (await opened).setFiles([routeFile('survey.csv', [middle, goal])]);
  const goals = page.getByLabel('Goals', { exact: true });
  await expect(goals).toHaveValue('survey.csv');
  await page.getByLabel('Start', { exact: true }).fill(typed(start));
  await planAndWait(page);
  const first = page.getByRole('region', { name: 'Waypoints' }).getByRole('row').nth(1).getByRole('cell').nth(1);
  const begins = await first.innerText();

  // With no start of its own the plan begins at the first of the places.
  await page.getByLabel('Start', { exact: true }).fill('');
  await planAndWait(page);
  await expect(first).not.toHaveText(begins);

  const chooser = page.waitForEvent('filechooser');
  await page.getByRole('button', { name: 'Take the goals from a mission file' }).click();
  await (await chooser).setFiles([{ name: 'letter.txt', mimeType: 'text/plain', buffer: Buffer.from('Dear pilot,\n') }]);
  await page.getByRole('button', { name: /^Plan / }).click();
  await expect(goals).toHaveAttribute('aria-invalid', 'true');
  await expect(goals).toBeFocused();
  await page.getByRole('button', { name: 'Remove letter.txt' }).click();
  await expect(page.getByLabel('Goal', { exact: true })).toBeVisible();
});

test('stored currents are the members of an ensemble, until one of them is removed', { tag: '@long' }, async ({ page, request }) => {
  const { start, goal } = await findPlaces(request);
  const { datasets } = (await (await request.get('/datasets')).json()) as { datasets: { kind: string; time_start: string; bbox: [number, number, number, number] }[] };
  const known = datasets.find(({ kind }) => kind === 'currents');
  if (!known) throw new Error('The store has no currents.');
  await open(page);
  await page.getByRole('button', { name: 'Data', exact: true }).click();
  const file = currentFile(known.bbox, 0.25, new Date(known.time_start), 120);
  await page.getByLabel('Files to add').setInputFiles([{ name: 'second_member.nc', mimeType: 'application/x-netcdf', buffer: file }]);
  await expect(page.getByRole('region', { name: 'Import of second_member.nc' }).getByText('Stored', { exact: true })).toBeVisible();
  await page.getByRole('button', { name: 'Set-up', exact: true }).click();
  await page.getByLabel('Start', { exact: true }).fill(typed(start));
  await page.getByLabel('Goal', { exact: true }).fill(typed(goal));
  await page.locator('summary', { hasText: /^Data/ }).click();
  const currents = page.getByLabel('Currents', { exact: true });
  await currents.selectOption({ label: 'Several: members of an ensemble' });
  const members = page.getByRole('group', { name: 'Currents used together' }).getByRole('checkbox');
  for (const member of await members.all()) await member.check();
  await page.getByText('Uncertainty of currents', { exact: true }).click();
  await expect(page.getByText('The members are the 2 currents chosen under Data')).toBeVisible();
  await page.getByLabel('Plan for').selectOption('mean');
  await page.getByLabel(/^Chance to arrive before/).fill('2026-11-24 00:00');
  await expectAccessible(page);
  await planAndWait(page);
  await expect(page.getByText('Travel time, p10–p90')).toBeVisible();
  await expect(page.locator('.figures-grid div', { hasText: 'Chance to arrive in time' }).locator('dd')).toHaveText(/^\d+ %$/);

  await page.getByRole('button', { name: 'Data', exact: true }).click();
  page.once('dialog', (dialog) => void dialog.accept());
  await page.getByRole('button', { name: 'Remove second_member', exact: true }).click();
  await expect(page.locator('.notice')).toContainText('gone from the store: currents');
  await page.getByRole('button', { name: 'Set-up', exact: true }).click();
  await page.locator('summary', { hasText: 'Uncertainty of currents' }).click();
  await expect(page.getByLabel('Members')).toBeVisible();
});
