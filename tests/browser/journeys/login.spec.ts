import { expectAccessible } from '../support/accessible';
import { bergFile } from '../support/files';
import { expect, planByTyping, settled, test as base, typed } from '../support/page';
import { findPlaces } from '../support/places';
import { startServer, type Server } from '../support/server';
import type { Page } from '@playwright/test';

/** A server that asks for tokens, with one of each role. */
const test = base.extend<object, { guarded_server: Server & Record<'viewer' | 'pilot' | 'admin', string> }>({
  guarded_server: [
    async ({}, use) => {
      const server = await startServer();
      const tokenOf = (role: string): string => server.run('token', 'add', `the-${role}`, '--role', role).trim();
      await use({ ...server, viewer: tokenOf('viewer'), pilot: tokenOf('pilot'), admin: tokenOf('admin') });
      await server.stop();
    },
    { scope: 'worker' },
  ],
  baseURL: async ({ guarded_server }, use) => use(guarded_server.url),
});

const form = (page: Page) => page.getByRole('dialog', { name: 'Sign in' });

async function signIn(page: Page, token: string): Promise<void> {
  await page.goto('/');
  await form(page).getByLabel('Token').fill(token);
  await form(page).getByRole('button', { name: 'Sign in' }).click();
  await expect(form(page)).toBeHidden();
  await settled(page);
}

test('a pilot signs in with the mouse, plans, uploads, and signs out', { tag: '@long' }, async ({ page, guarded_server, request }) => {
  await page.goto('/');
  await expect(form(page)).toBeVisible();
  await expectAccessible(page);
  await form(page).getByLabel('Token').fill(`${guarded_server.pilot}x`);
  await form(page).getByRole('button', { name: 'Sign in' }).click();
  await expect(form(page).getByRole('alert')).toContainText('The token is not known');
  await expect(form(page).getByLabel('Token')).toHaveAttribute('aria-invalid', 'true');
  await expectAccessible(page);
  await form(page).getByLabel('Token').fill(` ${guarded_server.pilot} `);
  await form(page).getByRole('button', { name: 'Sign in' }).click();
  await expect(form(page)).toBeHidden();
  await settled(page);
  await expect(page.locator('#map')).toHaveAttribute('data-currents', 'shown');
  await expect(page.locator('#map')).not.toHaveAttribute('data-coast', '0');
  const account = page.getByRole('button', { name: 'Signed in as the-pilot, pilot' });
  await expect(account).toBeVisible();
  expect(await page.evaluate(() => document.cookie)).toBe('');

  const { start, goal } = await findPlaces(page.request);
  await planByTyping(page, start, goal);
  const events = await page.evaluate(() => new Promise((resolve) => {
    const stream = new EventSource('/events');
    stream.onopen = () => {
      stream.close();
      resolve('open');
    };
    stream.onerror = () => resolve('refused');
  }));
  expect(events).toBe('open');

  await account.click();
  const who = page.getByRole('dialog', { name: 'Signed in' });
  await expect(who).toContainText('the-pilot, role pilot: may look, plan, simulate and add data');
  await expectAccessible(page);
  await who.getByRole('button', { name: 'Sign out' }).click();
  await expect(form(page)).toBeVisible();
  await expect(page.locator('#map')).toHaveAttribute('data-plans', '0');
  expect((await page.request.get('/datasets')).status()).toBe(401);
  expect((await request.get('/datasets')).status()).toBe(401);
});

test('the login is made and ended with the keyboard alone, by day and by night', async ({ page, guarded_server }) => {
  await page.emulateMedia({ colorScheme: 'dark' });
  await page.goto('/');
  await expect(form(page).getByLabel('Token')).toBeFocused();
  await page.keyboard.press('Enter');
  await expect(form(page).getByRole('alert')).toContainText('Type or paste your token');
  await expectAccessible(page);
  await page.keyboard.press('Escape');
  const aside = page.getByRole('region', { name: 'Not signed in' });
  await expect(aside).toBeVisible();
  await expectAccessible(page);
  await aside.getByRole('button', { name: 'Sign in' }).focus();
  await page.keyboard.press('Enter');
  await expect(form(page).getByLabel('Token')).toBeFocused();
  await page.keyboard.type(guarded_server.admin);
  await page.keyboard.press('Enter');
  await settled(page);
  await page.getByRole('button', { name: 'Signed in as the-admin, admin' }).focus();
  await page.keyboard.press('Enter');
  await page.getByRole('button', { name: 'Sign out' }).focus();
  await page.keyboard.press('Enter');
  await expect(form(page).getByLabel('Token')).toBeFocused();
});

test('what a viewer may not do is said before it is tried', { tag: '@long' }, async ({ page, guarded_server }) => {
  await signIn(page, guarded_server.pilot);
  const { start, goal } = await findPlaces(page.request);
  await planByTyping(page, start, goal);
  await page.context().clearCookies();

  await signIn(page, guarded_server.viewer);
  await expect(page.getByText('Planning needs the role pilot; you are signed in as the-viewer, viewer.')).toBeVisible();
  await expect(page.getByRole('button', { name: /^Plan / })).toBeDisabled();
  await expect(page.getByRole('button', { name: 'Edit copy' })).toBeDisabled();
  await expect(page.getByRole('button', { name: 'Delete this plan' })).toBeDisabled();
  await page.locator('#map').focus();
  await page.keyboard.press('d');
  await expect(page.locator('.notice')).toContainText('Changing a plan needs the role pilot');
  await page.getByRole('button', { name: 'Flights', exact: true }).click();
  await expect(page.getByRole('button', { name: 'Simulate this plan' })).toBeDisabled();
  await page.getByRole('button', { name: 'Data', exact: true }).click();
  await expect(page.getByText(/^Adding data needs the role pilot/)).toBeVisible();
  await expect(page.getByRole('button', { name: /^Remove disko/ }).first()).toBeDisabled();
  await expectAccessible(page);
  await page.getByRole('button', { name: 'Export mission' }).click();
  await expect(page.getByRole('dialog').locator('pre')).toContainText('<start:waypoints>');
});

test('a login that ends does not take along what was typed', async ({ page, guarded_server }) => {
  await signIn(page, guarded_server.pilot);
  const { start, goal } = await findPlaces(page.request);
  await page.getByLabel('Start', { exact: true }).fill(typed(start));
  await page.getByLabel('Goal', { exact: true }).fill(typed(goal));
  await page.context().clearCookies();
  await page.getByRole('button', { name: /^Plan / }).click();
  await expect(form(page)).toContainText('Your login has ended');
  await form(page).getByLabel('Token').fill(guarded_server.pilot);
  await page.keyboard.press('Enter');
  await expect(form(page)).toBeHidden();
  await expect(page.getByLabel('Start', { exact: true })).toHaveValue(typed(start));
  await page.getByRole('button', { name: /^Plan / }).click();
  await expect(page.locator('#map')).not.toHaveAttribute('data-plans', '0', { timeout: 120_000 });
});

test('files that a login which ended kept from the server are sent again', { tag: '@long' }, async ({ page, guarded_server }) => {
  await signIn(page, guarded_server.pilot);
  const { start } = await findPlaces(page.request);
  await page.getByRole('button', { name: 'Data', exact: true }).click();
  await page.context().clearCookies();
  const { name, text } = bergFile(start);
  await page.getByLabel('Files to add').setInputFiles([{ name, mimeType: 'application/geo+json', buffer: Buffer.from(text) }]);
  await expect(form(page)).toContainText('Your login has ended');
  await form(page).getByLabel('Token').fill(guarded_server.pilot);
  await page.keyboard.press('Enter');
  await expect(form(page)).toBeHidden();
  const card = page.getByRole('region', { name: `Import of ${name}` });
  await expect(card).toContainText('None of the files could be sent');
  await expectAccessible(page);
  await card.getByRole('button', { name: 'Send again' }).click();
  await expect(card).toContainText('2 accepted, 1 refused');
  await expect(card.getByRole('button', { name: 'Send again' })).toBeHidden();
});

test('the login fits on a narrow screen', async ({ page, guarded_server }) => {
  await page.setViewportSize({ width: 320, height: 640 });
  await page.goto('/');
  await expect(form(page)).toBeVisible();
  const overflow = (): Promise<number> => page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
  expect(await overflow()).toBeLessThanOrEqual(0);
  await form(page).getByLabel('Token').fill(guarded_server.pilot);
  await page.keyboard.press('Enter');
  await settled(page);
  await expect(page.getByRole('button', { name: 'Signed in as the-pilot, pilot' })).toBeVisible();
  expect(await overflow()).toBeLessThanOrEqual(0);
});
