import type { APIRequestContext } from '@playwright/test';
import { expect, open, settled, test, type LonLat } from '../support/page';
import { textsOf } from '../support/pdf_text';
import { findPlaces } from '../support/places';

interface Waypoint {
  index: number;
  lon: number;
  lat: number;
  eta: string;
}

interface Plan {
  plan_id: string;
  waypoints: Waypoint[];
  messages: { text: string; place?: { lon: number; lat: number } }[];
}

const depart = '2026-11-22T12:00:00Z';
const nameOf = ({ index }: Waypoint): string => (index === 0 ? 'S' : String(index));

/** Degrees and minutes as the brief and the command line write them. */
function minutesOf(value: number): RegExp {
  const thousandths = Math.round(Math.abs(value) * 60_000);
  const [degrees, minutes] = [Math.floor(thousandths / 60_000), (thousandths % 60_000) / 1000];
  return new RegExp(`^0*${degrees}°${minutes.toFixed(3).padStart(6, '0')}′[NSEW]$`);
}

const found = (text: string, row: RegExp): string[][] => [...text.matchAll(row)].map(([, ...parts]) => parts.map((part) => part.trim()));

test('a waypoint has one name on the map, in the table, GPX, KML, both briefs and on the command line', async ({ page, request, server }) => {
  const { start, goal } = await findPlaces(request);
  const inputs = { from: start, to: goal, depart, spacing_m: 2500, max_leg_m: 4000, refine: false, name: 'Named' };
  const answer = await request.post('/processes/plan-route/execution', { data: { inputs }, headers: { Prefer: 'respond-sync' } });
  expect(answer.status(), await answer.text()).toBe(200);
  const { plan } = (await answer.json()) as { plan: Plan };
  const names = plan.waypoints.map(nameOf);
  expect(names.length).toBeGreaterThan(3);
  expect(names.slice(0, 3)).toEqual(['S', '1', '2']);

  await open(page);
  await page.getByRole('button', { name: /^Plans/ }).click();
  await page.locator('.plan-choose', { hasText: 'Named' }).click();
  await settled(page);
  await expect(page.locator('#map')).toHaveAttribute('data-waypoints', names.join(' '));
  const table = page.getByRole('region', { name: 'Waypoints' });
  await expect(table.locator('.row-choose')).toHaveText(names);

  const file = async (format: string): Promise<string> => (await request.get(`/collections/plans/items/${plan.plan_id}/mission.${format}?accept_dangers=true`)).text();
  const routePoints = found(await file('gpx'), /<rtept lat="([^"]+)" lon="([^"]+)"><time>([^<]+)<\/time><name>([^<]+)<\/name>/g);
  expect(routePoints.map(([, , time, name]) => [name, time])).toEqual(plan.waypoints.map((waypoint) => [nameOf(waypoint), waypoint.eta]));
  routePoints.forEach(([lat, lon], i) => {
    expect(Number(lat)).toBeCloseTo(plan.waypoints[i]?.lat ?? NaN, 5);
    expect(Number(lon)).toBeCloseTo(plan.waypoints[i]?.lon ?? NaN, 5);
  });
  const marks = found(await file('kml'), /<Placemark><name>([^<]+)<\/name><TimeStamp><when>([^<]+)</g);
  expect(marks).toEqual(plan.waypoints.map((waypoint) => [nameOf(waypoint), waypoint.eta]));
  const html = await file('html');
  expectRows(found(html, /<tr><td>(S|\d+)<\/td><td>([^<]+)<\/td><td>([^<]+)<\/td><td>([^<]+)<\/td>/g), plan);
  const depths = [...html.matchAll(/<tr><td>(?:S|\d+)<\/td>(?:<td>[^<]*<\/td>){6}<td>([^<]+)<\/td>/g)].map(([, depth]) => depth);
  await expect(table.locator('tbody tr td:nth-child(6)')).toHaveText(depths as string[]);
  expectRows(found((await pdfOf(request, plan)).join('\n'), /^(S|\d+)\t(\d+°[\d.]+′[NS])\t(\d+°[\d.]+′[EW])\t([^\t]+Z)/gm), plan);

  const lonLat = ([lon, lat]: LonLat): string => `${lon},${lat}`;
  const printed = server.run('plan', `--from=${lonLat(start)}`, `--to=${lonLat(goal)}`, '--depart', depart, '--spacing', '2500', '--max-leg', '4000', '--no-refine', '--verbose');
  expectRows(found(printed, /^(S|\d+)\s+(\d+°[\d.]+′[NS])\s+(\d+°[\d.]+′[EW])\s+(\S+Z)/gm), plan);

  await request.delete(`/collections/plans/items/${plan.plan_id}`);
});

test('files for vehicles and tables hold the same waypoints in the same order, and the export shows each name with its index and row', async ({ page, request }) => {
  const { start, goal } = await findPlaces(request);
  const inputs = { from: start, to: goal, depart, spacing_m: 2500, max_leg_m: 4000, refine: false, icebergs: 'none', name: 'In files' };
  const answer = await request.post('/processes/plan-route/execution', { data: { inputs }, headers: { Prefer: 'respond-sync' } });
  const { plan } = (await answer.json()) as { plan: Plan };
  const { waypoints } = plan;
  expect(waypoints.map(({ index }) => index)).toEqual(waypoints.map((_, i) => i));
  const flown = waypoints.slice(1);
  const mission = `/collections/plans/items/${plan.plan_id}/mission`;
  const file = async (name: string): Promise<string> => {
    const got = await request.get(`${mission}${name}?accept_dangers=true`);
    expect(got.status(), `${name} ${await got.text()}`).toBe(200);
    return got.text();
  };

  const table = found(await file('.csv'), /^(\d+),([^,]+),([^,]+),([^,]+),/gm);
  expect(table.map(([index, , , eta]) => [index, eta])).toEqual(waypoints.map(({ index, eta }) => [String(index), eta]));
  table.forEach(([, lon, lat], i) => expectNear([Number(lon), Number(lat)], waypoints[i]));

  const sentences = await file('.nmea');
  const marks = found(sentences, /^\$GPWPL,(\d+\.\d+),N,(\d+\.\d+),W,(\w+)\*/gm);
  expect(marks.map(([, , name]) => name)).toEqual(waypoints.map(nameOf));
  marks.forEach(([lat, lon], i) => expectNear([-degreesOf(lon), degreesOf(lat)], waypoints[i]));
  expect(/^\$GPRTE,1,1,c,[^,]+,([^*]+)\*/m.exec(sentences)?.[1]).toBe(waypoints.map(nameOf).join());

  const { maneuvers } = JSON.parse(await file('.imc')) as { maneuvers: { maneuver_id: string; data: { lat: number; lon: number } }[] };
  expect(maneuvers.map(({ maneuver_id }) => maneuver_id)).toEqual(flown.map((waypoint) => `Goto${nameOf(waypoint)}`));
  const degrees = (radians: number): number => (radians * 180) / Math.PI;
  maneuvers.forEach(({ data }, i) => expectNear([degrees(data.lon), degrees(data.lat)], flown[i]));

  const targets = found(await file('.targets'), /^WP(\w+) lat=(\S+) lon=(\S+) .*goto=(\S+)$/gm);
  expect(targets.map(([name]) => name)).toEqual(flown.map(nameOf));
  expect(targets.map(([, , , next]) => next)).toEqual([...flown.slice(1), ...flown.slice(-1)].map((waypoint) => `WP${nameOf(waypoint)}`));
  targets.forEach(([, lat, lon], i) => expectNear([degreesOf(lon), degreesOf(lat)], flown[i]));

  const { features } = JSON.parse(await file('.geojson')) as { features: { geometry: { type: string; coordinates: LonLat }; properties: Waypoint }[] };
  const points = features.filter(({ geometry }) => geometry.type === 'Point');
  expect(points.map(({ properties }) => properties.index)).toEqual(waypoints.map(({ index }) => index));
  points.forEach(({ geometry }, i) => expectNear(geometry.coordinates, waypoints[i]));

  const { files } = JSON.parse(await file('')) as { files: { name: string; text: string }[] };
  const lists = files.flatMap(({ name, text }) => {
    const [, first = '', last = ''] = /^# .*: waypoints (\d+) to (\d+) of \d+$/m.exec(text) ?? [];
    const places = found(text, /^(-?\d+\.\d{4})\s+(-?\d+\.\d{4})$/gm);
    expect(places.length, text).toBe(Number(last) - Number(first) + 1);
    return places.map(([lon, lat], row) => ({ name, row, waypoint: Number(first) + row, place: [degreesOf(lon), degreesOf(lat)] as LonLat }));
  });
  expect(lists.map(({ waypoint }) => waypoint)).toEqual(flown.map(({ index }) => index));
  for (const { waypoint, place } of lists) expectNear(place, waypoints[waypoint]);

  await open(page);
  await page.getByRole('button', { name: /^Plans/ }).click();
  await page.locator('.plan-choose', { hasText: 'In files' }).click();
  await page.getByRole('button', { name: 'Export mission' }).click();
  const dialog = page.getByRole('dialog');
  await expect(dialog.locator('pre').first()).toContainText('<start:waypoints>');
  await dialog.getByText('Waypoints and rows of the files').click();
  const rows = dialog.getByRole('region', { name: 'Rows of the files' }).locator('tbody tr');
  await expect(rows).toHaveText([/^S0/, ...lists.map(({ name, row, waypoint }) => new RegExp(`^${waypoint}${waypoint}${name}${row}$`))]);
  await page.keyboard.press('Escape');
  await request.delete(`/collections/plans/items/${plan.plan_id}`);
});

test('a message names a waypoint as the map, the panel and the brief do', async ({ page, request }) => {
  const inputs = {
    from: [-53.1, 68.96], to: [-51.85, 68.96], depart: '2026-11-22T00:00:00Z', spacing_m: 2500, refine: false, icebergs: 'none', name: 'Below ice',
    under_ice: { escape_plan: true, surfacing_interval_s: 7200 },
  };
  const answer = await request.post('/processes/plan-route/execution', { data: { inputs }, headers: { Prefer: 'respond-sync' } });
  const { plan } = (await answer.json()) as { plan: Plan };
  const message = plan.messages.find(({ text, place }) => place && /\bwaypoint \d+/.test(text));
  const [, name = ''] = /\bwaypoint (\d+)/.exec(message?.text ?? '') ?? [];
  const named = plan.waypoints.find((waypoint) => nameOf(waypoint) === name);
  expect(message?.place?.lon, JSON.stringify(plan.messages)).toBeCloseTo(named?.lon ?? NaN, 5);
  expect(message?.place?.lat).toBeCloseTo(named?.lat ?? NaN, 5);

  expect((await pdfOf(request, plan)).join(' ')).toContain(`waypoint ${name}`);
  await open(page);
  await page.getByRole('button', { name: /^Plans/ }).click();
  await page.locator('.plan-choose', { hasText: 'Below ice' }).click();
  await expect(page.getByRole('region', { name: 'Cautions' })).toContainText(`waypoint ${name}`);
  await expect(page.locator('#map')).toHaveAttribute('data-waypoints', plan.waypoints.map(nameOf).join(' '));
  await request.delete(`/collections/plans/items/${plan.plan_id}`);
});

test('figures of a plan are the same in the panel, in its messages, in both briefs and on the command line', async ({ page, request, server }) => {
  const inputs = {
    from: [-53.1, 68.96], to: [-51.85, 68.96], depart: '2026-11-22T00:00:00Z', spacing_m: 2500, icebergs: 'none', name: 'In figures',
    under_ice: { escape_plan: true, surfacing_interval_s: 7200 },
  };
  const answer = await request.post('/processes/plan-route/execution', { data: { inputs }, headers: { Prefer: 'respond-sync' } });
  const { plan } = (await answer.json()) as { plan: Plan };
  await open(page);
  await page.getByRole('button', { name: /^Plans/ }).click();
  await page.locator('.plan-choose', { hasText: 'In figures' }).click();
  const figure = (label: string): Promise<string> =>
    page.locator('.figures-grid div').filter({ has: page.getByText(label, { exact: true }) }).locator('dd').innerText();
  const [longest, below, land, distance] = [
    await figure('Longest without a place to surface'), await figure('Below ice'), await figure('Nearest land'), await figure('Distance'),
  ];
  expect(longest).toMatch(/^\d+ h \d\d min$/);
  for (const length of [below, land, distance]) expect(length).toMatch(/^\d+\.\d km$/);

  await expect(page.getByRole('region', { name: 'Dangers' })).toContainText(`below ice for ${longest} without a place to surface`);
  const html = await (await request.get(`/collections/plans/items/${plan.plan_id}/mission.html`)).text();
  for (const brief of [html, (await pdfOf(request, plan)).join(' ')]) {
    expect(brief).toContain(`Longest time without a place to surface: ${longest}`);
    expect(brief).toContain(`Below ice or icebergs: ${below}`);
    expect(brief).toContain(`to land ${land}`);
    expect(brief).toMatch(new RegExp(`, ${distance}\\.`));
  }
  const printed = server.run(
    'plan', '--from=-53.1,68.96', '--to=-51.85,68.96', '--depart', inputs.depart, '--spacing', '2500', '--icebergs', 'none',
    '--surfacing-interval', 'PT2H', '--escape-plan',
  );
  expect(printed).toContain(`longest time between places to surface ${longest}`);
  expect(printed).toContain(`below ice or icebergs for ${below}`);
  expect(printed).toContain(`least distance to land ${land}`);
  expect(printed).toContain(distance);
  await request.delete(`/collections/plans/items/${plan.plan_id}`);
});

async function pdfOf(request: APIRequestContext, { plan_id }: Plan): Promise<string[]> {
  const answer = await request.get(`/collections/plans/items/${plan_id}/mission.pdf?accept_dangers=true`);
  return textsOf(await answer.body());
}

/** Rows of name, latitude, longitude and ETA are those of the plan. */
function expectRows(rows: string[][], { waypoints }: Plan): void {
  expect(rows.map(([name, , , eta]) => [name, eta])).toEqual(waypoints.map((waypoint) => [nameOf(waypoint), waypoint.eta]));
  rows.forEach(([, lat, lon], i) => {
    expect(lat).toMatch(minutesOf(waypoints[i]?.lat ?? NaN));
    expect(lon).toMatch(minutesOf(waypoints[i]?.lon ?? NaN));
  });
}

/** Degrees of "6912.3456", which are degrees and minutes as the vehicle writes them. */
function degreesOf(written = ''): number {
  const value = Math.abs(Number(written));
  const degrees = Math.floor(value / 100);
  return Math.sign(Number(written)) * (degrees + (value - 100 * degrees) / 60);
}

function expectNear([lon, lat]: LonLat, waypoint: Waypoint | undefined): void {
  expect(lon).toBeCloseTo(waypoint?.lon ?? NaN, 5);
  expect(lat).toBeCloseTo(waypoint?.lat ?? NaN, 5);
}
