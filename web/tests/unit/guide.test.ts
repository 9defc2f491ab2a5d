import { readdirSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { describe, expect, test } from 'vitest';
import { framed, readGuide, searchText } from '../../tools/guide/guide';
import { guidePages, guidePagesOfParts } from '../../src/model/guide_pages';
import { listedLinks, readPage } from '../../tools/guide/page';

const root = fileURLToPath(new URL('../../..', import.meta.url));
const asItIs = (address: string): string => address;

describe('a page', () => {
  test('gives its headings the anchors of a repository host', () => {
    const { title, sections, html } = readPage('# Data in\n\nWords.\n\n## Sea ice & `icebergs`\n\nMore *words*.\n\n## Sea ice & icebergs\n', asItIs);
    expect(title).toBe('Data in');
    expect(sections).toEqual([
      { heading: 'Data in', anchor: '', level: 1, text: 'Words.\n' },
      { heading: 'Sea ice & icebergs', anchor: 'sea-ice--icebergs', level: 2, text: 'More words.\n' },
      { heading: 'Sea ice & icebergs', anchor: 'sea-ice--icebergs-1', level: 2, text: '' },
    ]);
    expect(html).toContain('<h2 id="sea-ice--icebergs">');
  });

  test('asks where its links and pictures lead', () => {
    const asked: string[] = [];
    const { html } = readPage('# A\n\n[b](b.md#c) ![d](d.svg)\n', (address) => {
      asked.push(address);
      return `/there/${address}`;
    });
    expect(asked).toEqual(['b.md#c', 'd.svg']);
    expect(html).toContain('href="/there/b.md#c"');
    expect(html).toContain('src="/there/d.svg"');
  });

  test('holds no HTML but comments, which nobody sees', () => {
    expect(() => readPage('# A\n\n<b>bold</b>\n', asItIs)).toThrow('HTML');
    expect(readPage('# A\n\n<!-- for writers -->\n', asItIs).html).not.toContain('writers');
  });

  test('has one title, at its beginning', () => {
    expect(() => readPage('Words.\n', asItIs)).toThrow('title');
    expect(() => readPage('# A\n\n# B\n', asItIs)).toThrow('title');
  });

  test('may list others under its headings', () => {
    expect(listedLinks('# A\n\n[not this](x.md)\n\n## Start\n\n- [The map](map.md): panels\n')).toEqual([
      { group: 'Start', address: 'map.md' },
    ]);
  });
});

describe('the guide', () => {
  const guide = readGuide(root);

  test('has every page of its folder, once', () => {
    const files = readdirSync(new URL('../../guide', import.meta.url)).filter((name) => name.endsWith('.md'));
    expect(guide.pages.map(({ file }) => file).filter((file) => file.startsWith('web/guide/')).sort()).toEqual(files.map((name) => `web/guide/${name}`).sort());
  });

  test('names each page in the list of the front page as the page names itself', () => {
    const [front] = guide.pages;
    for (const page of guide.pages.slice(1)) expect(front?.html).toContain(`>${page.title}</a>`);
  });

  test('is served without a script or style of its own in any page', () => {
    for (const page of guide.pages) {
      const html = framed('<title>{{title}}</title>{{pages}}{{article}}{{neighbours}}', guide, page);
      expect(html).not.toMatch(/<script|<style|\sstyle=|\son\w+=/);
      expect(html).not.toContain('{{');
    }
  });

  test('shows every picture of its folder, and says in words what each shows', () => {
    const made = readdirSync(new URL('../../guide/pictures', import.meta.url));
    expect([...guide.pictures.keys()]).toEqual(expect.arrayContaining(made));
    for (const { html, name } of guide.pages) {
      for (const [picture] of html.matchAll(/<img [^>]*>/g)) expect(/ alt="([^"]*)"/.exec(picture)?.[1]?.split(' ').length, `${name}: ${picture}`).toBeGreaterThan(4);
    }
  });

  test('has the pages that the map leads to', () => {
    const addresses = guide.pages.flatMap(({ name, sections }) => sections.map(({ anchor }) => `${name}${anchor === '' ? '' : `#${anchor}`}`));
    for (const { address } of [...Object.values(guidePages), ...Object.values(guidePagesOfParts)]) expect(addresses).toContain(address);
  });

  test('can be searched for all of it', () => {
    const sections = JSON.parse(searchText(guide)) as { address: string; text: string }[];
    expect(new Set(sections.map(({ address }) => address)).size).toBe(sections.length);
    expect(sections.some(({ address }) => address === '/guide/data#zones')).toBe(true);
    const anchors = new Map(guide.pages.map(({ name, html }) => [name, new Set([...html.matchAll(/ id="([^"]+)"/g)].map(([, id = '']) => id))]));
    for (const { address } of sections) {
      const [, name = '', anchor] = /^\/guide(?:\/([a-z-]+))?(?:#(.+))?$/.exec(address) ?? [];
      expect(anchors.has(name) && (anchor === undefined || anchors.get(name)?.has(anchor)), address).toBe(true);
    }
  });
});
