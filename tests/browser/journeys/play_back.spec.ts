import { expect, open, planByTyping, test } from '../support/page';
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
  await page.getByRole('button', { name: 'Pause (Space)' }).click();
  const paused = Number(await slider.inputValue());
  const back = page.getByRole('button', { name: 'One hour back (,)' });
  await back.click(); // to the hour before, which the slider may show already: it shows tens of minutes
  await back.click();
  await expect.poll(async () => Number(await slider.inputValue())).toBeLessThan(paused);
});

test('where motion is not wanted the clock plays in whole hours', async ({ page }) => {
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
