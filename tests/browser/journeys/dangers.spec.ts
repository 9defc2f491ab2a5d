import { expect, mapAtRest, open, pixelOf, test } from '../support/page';
import { findPlaces } from '../support/places';

test('a plan that ignores icebergs for their age says so as a danger, and is exported once that is confirmed', async ({ page, request }) => {
  const { start, goal } = await findPlaces(request);
  const { datasets } = (await (await request.get('/datasets')).json()) as { datasets: { kind: string; time_end: string | null }[] };
  const until = datasets.find(({ kind }) => kind === 'currents')?.time_end ?? '';
  const depart = new Date(Date.parse(until) - 36 * 3_600_000).toISOString().replace('.000', '');
  const answer = await request.post('/processes/plan-route/execution', {
    data: { inputs: { from: start, to: goal, depart, max_sighting_age_days: 0, name: 'Ignores bergs' } },
  });
  expect(answer.status(), await answer.text()).toBe(200);
  const { plan } = (await answer.json()) as { plan: { plan_id: string; dangers: string[] } };
  expect(plan.dangers.join(' ')).toMatch(/ignored, not seen since/);
  await open(page);

  await page.getByRole('button', { name: /^Plans/ }).click();
  await page.locator('.plan-choose', { hasText: 'Ignores bergs' }).click();
  const panel = page.getByRole('region', { name: 'Dangers' });
  await expect(panel).toContainText(/ignored, not seen since/);
  await expect(panel.getByRole('listitem')).toHaveCount(1);

  await page.getByRole('button', { name: 'Export mission' }).click();
  const dialog = page.getByRole('dialog');
  const closed = dialog.getByRole('button', { name: 'Mission files (.zip)' });
  await expect(closed).toBeDisabled();
  await expect(dialog.getByRole('region', { name: 'Dangers' }).getByRole('listitem')).toHaveCount(1);
  await expect(dialog.getByRole('checkbox')).toHaveCount(1);
  await expect(dialog.locator('pre')).toHaveCount(0);
  await dialog.getByLabel('I have read this; export all the same').check();
  await expect(dialog.locator('pre').first()).toContainText('<start:waypoints>');
  const waiting = page.waitForEvent('download');
  await dialog.getByRole('link', { name: 'Mission files (.zip)' }).click();
  expect((await waiting).suggestedFilename()).toMatch(/\.zip$/);
  await page.keyboard.press('Escape');

  // Once for a plan: the dialog also gives way while a safe place is picked on the map.
  await page.getByRole('button', { name: 'Export mission' }).click();
  await dialog.getByLabel('Files for the vehicle').selectOption('full');
  await dialog.getByRole('button', { name: 'Pick a safe place on the map' }).click();
  await expect(dialog).toBeHidden();
  await mapAtRest(page);
  const { x, y } = await pixelOf(page, start);
  await page.mouse.click(x, y);
  await expect(dialog.getByLabel('Safe places under ice')).not.toHaveValue('');
  await expect(dialog.getByLabel('I have read this; export all the same')).toBeChecked();
  await page.keyboard.press('Escape');
  await request.delete(`/collections/plans/items/${plan.plan_id}`);
});
