import { expect, mapAtRest, open, settled, test } from '../support/page';
import { expectAccessible } from '../support/accessible';

test('alternatives are asked for, looked at, compared, deleted and brought back', { tag: '@long' }, async ({ page, request }) => {
  await open(page);
  const map = page.locator('#map');
  const field = page.getByRole('combobox', { name: 'Alternatives' });
  await page.getByLabel('Start', { exact: true }).fill('69.20, -53.20');
  await page.getByLabel('Goal', { exact: true }).fill('69.15, -51.80');
  await page.getByRole('textbox', { name: /^Departure/ }).fill('2026-11-22 06:00');
  await field.selectOption('2');

  // Not beside a window, which the server would refuse; the choice is there again afterwards.
  await page.getByText('Departure window', { exact: true }).click();
  await page.getByLabel(/^Latest departure/).fill('2026-11-22 12:00');
  await expect(field).toBeDisabled();
  await expect(field).toHaveAccessibleDescription(/one departure/);
  await page.getByLabel(/^Latest departure/).fill('');
  await expect(field).toHaveValue('2');

  const before = Number(await map.getAttribute('data-plans'));
  await page.getByRole('button', { name: /^Plan / }).click();
  await expect(map).toHaveAttribute('data-plans', String(before + 3), { timeout: 240_000 });
  await settled(page);
  const { features } = (await (await request.get('/collections/plans/items')).json()) as {
    features: { properties: { name: string; alternatives?: { name: string; message: { text: string } }[]; messages: { rank: string }[] } }[];
  };
  const best = features.at(-1)?.properties;
  const [first, second] = best?.alternatives ?? [];
  if (!best || !first || !second) throw new Error('The plan has no two alternatives.');

  const list = page.getByRole('region', { name: 'Alternatives' });
  await expect(list.getByRole('listitem')).toHaveCount(2);
  await expect(list.getByRole('listitem').first()).toContainText(/\d+ h \d\d min later/);
  await expect(list.getByRole('listitem').first()).toContainText('icebergs');
  await expect(list.getByRole('link', { name: /Guide/ })).toHaveAttribute('href', '/guide/planning#alternatives');
  for (const [index, { name }] of [first, second].entries()) { // also of plans that are not selected
    const messages = features.find(({ properties }) => properties.name === name)?.properties.messages ?? [];
    for (const rank of ['danger', 'caution']) {
      const count = messages.filter((message) => message.rank === rank).length;
      await expect(list.getByRole('listitem').nth(index).getByText(new RegExp(`${count} ${rank}`))).toHaveCount(count > 0 ? 1 : 0);
    }
  }
  await expect(map).toHaveAttribute('data-plan-areas', '0');
  await expectAccessible(page);

  const viewBefore = await map.getAttribute('data-view');
  await list.getByRole('button', { name: /on the map$/ }).first().click();
  await mapAtRest(page);
  expect(await map.getAttribute('data-view')).not.toBe(viewBefore);

  // With the keyboard: the alternative with the areas that it obeys, and back to the plan.
  await list.getByRole('button', { name: `Show ${first.name}` }).focus();
  await page.keyboard.press('Enter');
  const heading = page.getByRole('complementary', { name: 'Waypoints' }).getByRole('heading', { level: 2 }).first();
  await expect(heading).toContainText(first.name);
  await expect(map).not.toHaveAttribute('data-plan-areas', '0');
  await expect(list).toContainText(`Alternative to ${best.name}`);
  await expectAccessible(page);
  await list.getByRole('button', { name: `Show ${best.name}`, exact: true }).focus();
  await page.keyboard.press('Enter');
  await expect(heading).toContainText(best.name);
  await expect(map).toHaveAttribute('data-plan-areas', '0');

  await list.getByRole('button', { name: /^Compare/ }).click();
  const table = page.getByRole('region', { name: 'Comparison table' });
  await expect(table.getByRole('row')).toHaveCount(4);
  await expect(table.getByRole('row', { name: new RegExp(`${best.name}(?!,)`) }).getByRole('radio')).toBeChecked();
  await page.keyboard.press('Escape');

  await list.getByRole('button', { name: `Show ${second.name}` }).click();
  await page.getByRole('button', { name: 'Delete this plan' }).click();
  await page.getByRole('button', { name: /^Plans/ }).click();
  await page.getByRole('button', { name: new RegExp(`${best.name}(?!,)`) }).first().click();
  await expect(list.getByRole('listitem')).toHaveCount(1);
  await page.keyboard.press('Control+Z');
  await expect(heading).toContainText(second.name); // selected, as it was when it was deleted
  await list.getByRole('button', { name: `Show ${best.name}`, exact: true }).click();
  await expect(list.getByRole('listitem')).toHaveCount(2);
});

test('the brief names the alternatives of a plan', { tag: '@long' }, async ({ request }) => {
  const inputs = { from: [-53.2, 69.2], to: [-51.8, 69.15], depart: '2026-11-22T06:00:00Z', alternatives: 2, name: 'brief' };
  const answer = await request.post('/processes/plan-route/execution', { data: { inputs }, headers: { Prefer: 'respond-sync' }, timeout: 240_000 });
  const { plan } = (await answer.json()) as { plan: { plan_id: string } };
  const brief = await (await request.get(`/collections/plans/items/${plan.plan_id}/mission.html`)).text();
  expect(brief.match(/brief, alternative \d/g)).toHaveLength(2);
});
