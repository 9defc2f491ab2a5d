import { expect, open, planByTyping, settled, test } from '../support/page';
import { findPlaces } from '../support/places';

test('the clock plays with the mouse, and the table marks the leg under way', async ({ page, request }) => {
  const { start, goal } = await findPlaces(request);
  await open(page);
  await planByTyping(page, start, goal);
  await expect(page.locator('tr.under-way')).toHaveCount(1);
  const slider = page.getByRole('slider', { name: 'Time' });
  await page.getByRole('button', { name: 'To the start (Home)' }).click();
  const first = Number(await slider.inputValue());
  await page.getByRole('button', { name: 'Play (Space)' }).click();
  await expect.poll(async () => Number(await slider.inputValue())).toBeGreaterThan(first + 3_600_000);
  const spoken = page.getByRole('contentinfo', { name: 'Clock' }).getByRole('status');
  await expect(spoken).toHaveAttribute('aria-live', 'off');
  await page.getByRole('button', { name: 'Pause (Space)' }).click();
  await expect(spoken).not.toHaveAttribute('aria-live');
  const paused = Number(await slider.inputValue());
  const back = page.getByRole('button', { name: 'One hour back (,)' });
  await back.click(); // to the hour before, which the slider may show already: it shows tens of minutes
  await back.click();
  await expect.poll(async () => Number(await slider.inputValue())).toBeLessThan(paused);
});

test('where motion is not wanted the clock plays in whole hours', { tag: '@long' }, async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await open(page);
  const slider = page.getByRole('slider', { name: 'Time' });
  await page.locator('#map').focus();
  await page.keyboard.press('Home');
  const first = Number(await slider.inputValue());
  await page.keyboard.press('Space');
  await expect.poll(async () => Number(await slider.inputValue())).toBeGreaterThan(first);
  await page.keyboard.press('Space');
  expect((Number(await slider.inputValue()) - first) % 3_600_000).toBe(0);
});

test('the vehicles of two plans follow the clock, by mouse and by keyboard', { tag: '@long' }, async ({ page, request }) => {
  const { start, goal } = await findPlaces(request);
  await open(page);
  await planByTyping(page, start, goal);
  await planByTyping(page, goal, start);
  const map = page.locator('#map');
  const vehicles = async (): Promise<string[]> => {
    await settled(page);
    return ((await map.getAttribute('data-vehicles')) ?? '').split(' ');
  };
  const slider = page.getByRole('slider', { name: 'Time' });
  const move = async (step: () => Promise<void>): Promise<void> => {
    const before = await vehicles();
    expect(before.length).toBeGreaterThanOrEqual(2); // a plan made before may be shown, too
    await step();
    await expect.poll(async () => (await vehicles()).filter((place, i) => place !== before[i]).length).toBeGreaterThanOrEqual(2);
  };
  await move(() => page.getByRole('button', { name: 'One hour on (.)' }).click());
  await move(async () => {
    const box = await slider.boundingBox();
    const [now, first, last] = [Number(await slider.inputValue()), Number(await slider.getAttribute('min')), Number(await slider.getAttribute('max'))];
    if (!box) throw new Error('The clock has no place on the screen.');
    const x = box.x + (box.width * (now + 5 * 3_600_000 - first)) / (last - first);
    await page.mouse.click(x, box.y + box.height / 2);
  });
  await move(async () => {
    await slider.focus();
    await page.keyboard.press('ArrowRight');
    await page.keyboard.press('ArrowRight');
  });
});

test('what is drawn over what follows the rule', async ({ page }) => {
  await open(page);
  const drawn = ((await page.locator('#map').getAttribute('data-layers')) ?? '').split(' ');
  const rule = ['bathymetry', 'currents', 'coast', 'graticule', 'areas', 'keepOut', 'plans', 'icebergs', 'vehicles', 'edit'];
  expect(drawn.filter((name) => rule.includes(name))).toEqual(rule);
});

test('the time bar spans a month of years at most, and zooms by button and wheel', async ({ page }) => {
  await page.route('**/datasets', async (route) => {
    const answer = await route.fetch();
    const stored = (await answer.json()) as { datasets: { kind: string; times?: string[]; time_start: string | null }[] };
    const long_ago = '2023-01-01T00:00:00Z';
    const datasets = stored.datasets.map((dataset) => (dataset.kind === 'currents' ? { ...dataset, times: [long_ago, ...(dataset.times ?? [])], time_start: long_ago } : dataset));
    await route.fulfill({ response: answer, json: { ...stored, datasets } });
  });
  await open(page);
  const slider = page.getByRole('slider', { name: 'Time' });
  const span_h = async (): Promise<number> => (Number(await slider.getAttribute('max')) - Number(await slider.getAttribute('min'))) / 3_600_000;
  expect(await span_h()).toBe(31 * 24);

  const less = page.getByRole('button', { name: 'Less time on the slider' });
  await less.click();
  await less.click();
  await expect.poll(span_h).toBe(186);
  const now = await slider.inputValue();
  await slider.hover();
  await page.mouse.wheel(0, -100);
  await expect.poll(span_h).toBeLessThan(186);
  expect(await slider.inputValue()).toBe(now);

  await page.locator('#map').focus();
  await page.keyboard.press('Home');
  await expect.poll(async () => Number(await slider.inputValue())).toBe(Date.parse('2023-01-01T00:00:00Z'));
  expect(await span_h()).toBeLessThan(186);
});
