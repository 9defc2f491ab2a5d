import { expect, open, test, typed, typeInto } from '../support/page';
import { findPlaces } from '../support/places';

test('a position is understood as people write it, and what can be read in two ways is asked back', { tag: '@long' }, async ({ page, request }) => {
  const { start, goal } = await findPlaces(request);
  await open(page);
  const asked: [number, number][] = [];
  await page.route('**/processes/plan-route/execution', async (route) => {
    asked.push((route.request().postDataJSON() as { inputs: { from: [number, number] } }).inputs.from);
    await route.abort();
  });
  const field = page.getByLabel('Start', { exact: true });
  await typeInto(page, page.getByLabel('Goal', { exact: true }), typed(goal));

  const size = Math.abs(start[0]);
  const [lat, lon] = [Math.floor(start[1]), Math.floor(size)];
  const [latMinutes, lonMinutes] = [60 * (start[1] - lat), 60 * (size - lon)].map((minutes) => minutes.toFixed(3).padStart(6, '0')) as [string, string];
  const seconds = (minutes: string): string => `${Math.floor(Number(minutes))}′${(60 * (Number(minutes) % 1)).toFixed(2)}″`;
  const written = [
    typed(start).replace(', ', ' ').replaceAll('.', ','), `${lat}${latMinutes} -${lon}${lonMinutes}`,
    `${lat}°${seconds(latMinutes)}N ${lon}°${seconds(lonMinutes)}W`,
  ];
  for (const [i, text] of written.entries()) {
    await typeInto(page, field, text);
    await page.keyboard.press('Enter');
    await expect.poll(() => asked.length, text).toBe(i + 1);
    expect(asked[i]?.[0]).toBeCloseTo(start[0], 4);
    expect(asked[i]?.[1]).toBeCloseTo(start[1], 4);
  }

  await typeInto(page, field, `${start[0].toFixed(5)}, ${start[1].toFixed(5)}`);
  await page.keyboard.press('Enter');
  await expect(page.getByText(/did you mean/)).toBeVisible();
  await typeInto(page, field, '69,17');
  await page.getByRole('button', { name: /^Plan / }).click();
  await expect(page.getByText(/Does the comma mark decimals/)).toBeVisible();
  expect(asked).toHaveLength(written.length);
});
