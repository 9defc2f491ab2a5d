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
  return new RegExp(`^0?${degrees} ${minutes.toFixed(3).padStart(6, '0')} [NSEW]$`);
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
  expectRows(found((await pdfOf(request, plan)).join('\n'), /^(S|\d+)\t(\d+ [\d.]+ [NS])\t(\d+ [\d.]+ [EW])\t([^\t]+Z)/gm), plan);

  const lonLat = ([lon, lat]: LonLat): string => `${lon},${lat}`;
  const printed = server.run('plan', `--from=${lonLat(start)}`, `--to=${lonLat(goal)}`, '--depart', depart, '--spacing', '2500', '--max-leg', '4000', '--no-refine', '--verbose');
  expectRows(found(printed, /^(S|\d+)\s+(\d+ [\d.]+ [NS])\s+(\d+ [\d.]+ [EW])\s+(\S+Z)/gm), plan);

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
