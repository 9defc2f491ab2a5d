import { expectAccessible } from '../support/accessible';
import { expect, open, test } from '../support/page';

test('the guide opens from the map, is searched, and every link of it leads somewhere', async ({ page, context, request }) => {
  await open(page);
  await page.getByRole('button', { name: 'Use the dark theme' }).click();
  await page.getByRole('button', { name: 'Help and settings (?)' }).click();
  const opened = context.waitForEvent('page');
  await page.getByRole('dialog').getByRole('link', { name: 'Guide', exact: true }).click();
  const guide = await opened;
  await expect(guide).toHaveTitle('Floeplan guide');
  await expect(guide.locator('html')).toHaveAttribute('data-theme', 'dark');
  await expectAccessible(guide);

  await guide.getByRole('searchbox', { name: 'Search the guide' }).fill('max-sighting-age');
  await expect(guide.getByRole('status')).toHaveText(/places?$/);
  await expectAccessible(guide);
  await guide.getByRole('region', { name: 'Search results' }).getByRole('link', { name: 'Planning routes: Icebergs' }).click();
  await expect(guide).toHaveURL(/\/guide\/planning#icebergs$/);
  await expect(guide.getByRole('heading', { name: 'Icebergs', exact: true })).toBeInViewport();
  await guide.getByRole('searchbox').fill('zzzz');
  await expect(guide.getByRole('status')).toHaveText('Nothing is found for “zzzz”.');
  await guide.keyboard.press('Escape');
  await expect(guide.getByRole('article')).toBeVisible();

  const pages = await guide.getByRole('navigation').getByRole('link').evaluateAll((links) => links.map((link) => (link as HTMLAnchorElement).pathname));
  const anchors = new Map<string, Set<string>>();
  const links = new Set<string>();
  for (const path of new Set(pages)) {
    const answer = await request.get(path);
    expect(answer.status(), path).toBe(200);
    const html = await answer.text();
    anchors.set(path, new Set([...html.matchAll(/ id="([^"]+)"/g)].map(([, id = '']) => id)));
    for (const [, address = ''] of html.matchAll(/ (?:href|src)="([^"]+)"/g)) links.add(new URL(address, new URL(path, guide.url())).href);
  }
  for (const link of links) {
    const { origin, pathname, hash } = new URL(link);
    if (origin !== new URL(guide.url()).origin) continue; // where a reader may go, and the guide does not
    const known = anchors.get(pathname);
    if (!known) expect((await request.get(pathname)).status(), link).toBe(200);
    else if (hash !== '') expect([...known], link).toContain(hash.slice(1));
  }
  await page.bringToFront();
  await page.keyboard.press('Escape');
  await page.getByRole('button', { name: 'Use the light theme' }).click();
});

test('the guide is read on a phone', async ({ page }) => {
  await page.setViewportSize({ width: 390, height: 844 });
  await page.goto('/guide/data');
  expect(await page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth)).toBeLessThanOrEqual(0);
  await expect(page.getByRole('navigation')).toBeHidden();
  await page.getByRole('button', { name: 'Pages' }).click();
  await expectAccessible(page);
  await page.getByRole('navigation').getByRole('link', { name: 'The map' }).click();
  await expect(page.getByRole('heading', { level: 1 })).toHaveText('The map');
});
