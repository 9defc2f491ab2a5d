import { expect, mapAtRest, open, pixelOf, test, type LonLat } from '../support/page';

const west: LonLat = [-52.6, 69.15];
const east: LonLat = [-52.2, 69.13];

test('what was done last is taken back by key and by button, whatever it was', async ({ page }) => {
  await open(page);
  await mapAtRest(page);
  const at = async (place: LonLat): Promise<void> => {
    const { x, y } = await pixelOf(page, place);
    await page.mouse.click(x, y);
  };
  const start = page.getByLabel('Start', { exact: true });
  const goal = page.getByLabel('Goal', { exact: true });
  await page.getByRole('button', { name: 'Pick the start on the map' }).click();
  await at(west);
  await at(east);
  await expect(goal).not.toHaveValue('');
  await page.getByText('Places and areas', { exact: true }).click();
  await page.getByRole('button', { name: 'Type one' }).click();
  await expect(page.locator('#map')).toHaveAttribute('data-areas', '1');
  await page.getByRole('button', { name: 'Remove area 1' }).click();
  await expect(page.locator('#map')).toHaveAttribute('data-areas', '0');

  const tools = page.getByRole('toolbar', { name: 'Map tools' });
  await tools.getByTitle('Undo (Ctrl+Z): removing an area').click();
  await expect(page.locator('#map')).toHaveAttribute('data-areas', '1');
  await expect(page.locator('.notice')).toHaveText('Undone: removing an area.');
  await page.locator('#map').focus();
  await page.keyboard.press('Control+z');
  await expect(page.locator('#map')).toHaveAttribute('data-areas', '0');
  await page.keyboard.press('Control+z');
  await expect(goal).toHaveValue('');
  await page.keyboard.press('Control+z');
  await expect(start).toHaveValue('');
  await expect(tools.getByRole('button', { name: 'Undo' })).toBeDisabled();
  await page.keyboard.press('Control+Shift+Z');
  await page.keyboard.press('Control+y');
  await expect(goal).not.toHaveValue('');

  await goal.focus();
  await page.keyboard.press('Control+A');
  await page.keyboard.type('69');
  await page.keyboard.press('Control+z');
  await expect(goal).not.toHaveValue('69');
});

test('a deleted plan comes back with undo, and leaves the store with the page', async ({ page, request }) => {
  const { datasets } = (await (await request.get('/datasets')).json()) as { datasets: { kind: string; time_start: string }[] };
  const depart = datasets.find(({ kind }) => kind === 'currents')?.time_start;
  const inputs = { from: west, to: east, depart, name: 'To delete', spacing_m: 3000, refine: false, icebergs: 'none' };
  const answer = await request.post('/processes/plan-route/execution', { data: { inputs }, headers: { Prefer: 'respond-sync' } });
  const { plan_id } = ((await answer.json()) as { plan: { plan_id: string } }).plan;
  const stored = async (): Promise<number> => (await request.get(`/collections/plans/items/${plan_id}`)).status();
  await open(page);
  await page.getByRole('button', { name: /^Plans/ }).click();
  const row = page.locator('.plan-choose', { hasText: 'To delete' });
  await row.click();

  await page.getByRole('button', { name: 'Delete this plan' }).click();
  await expect(row).toBeHidden();
  expect(await stored()).toBe(200);
  await page.keyboard.press('Control+z');
  await expect(row).toHaveAttribute('aria-pressed', 'true');

  await page.keyboard.press('Control+Shift+Z');
  await expect(row).toBeHidden();
  await page.goto('/guide');
  await expect.poll(stored).toBe(404);
});
