import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { dirname, join, posix } from 'node:path';
import { fileURLToPath } from 'node:url';
import GithubSlugger from 'github-slugger';
import createMarkdown, { type Token } from 'markdown-it';
import { describe, expect, test } from 'vitest';

const root = fileURLToPath(new URL('../../..', import.meta.url));

/** Every Markdown file of the tree, from its top. */
function markdownFiles(folder = ''): string[] {
  const foreign = new Set(['build', 'node_modules', 'dist']);
  return readdirSync(join(root, folder), { withFileTypes: true }).flatMap((entry) => {
    const path = posix.join(folder, entry.name);
    if (entry.isDirectory()) return entry.name.startsWith('.') || foreign.has(entry.name) ? [] : markdownFiles(path);
    return entry.name.endsWith('.md') ? [path] : [];
  });
}

interface Links {
  addresses: string[]; // of links and pictures
  anchors: Set<string>; // of headings, as a repository host names them
}

function linksOf(text: string): Links {
  const slugger = new GithubSlugger();
  const links: Links = { addresses: [], anchors: new Set() };
  const visit = (tokens: readonly Token[]): void => {
    tokens.forEach((token, i) => {
      if (token.type === 'heading_open') {
        const words = (tokens[i + 1]?.children ?? []).map(({ content }) => content).join('');
        links.anchors.add(slugger.slug(words));
      }
      for (const name of ['href', 'src']) {
        const address = token.attrGet(name);
        if (address !== null) links.addresses.push(decodeURI(String(address)));
      }
      if (token.children) visit(token.children);
    });
  };
  visit(createMarkdown({ html: true }).parse(text, {}));
  return links;
}

/** The links of a file that lead nowhere on a repository host: the file or the heading is not there. Addresses of other hosts are not asked. */
function brokenLinks(file: string, text: string): string[] {
  return linksOf(text).addresses.filter((address) => {
    if (/^(https?|mailto):/.test(address)) return false;
    const [path = '', anchor = ''] = address.split('#');
    const target = path === '' ? file : posix.normalize(posix.join(dirname(file), path));
    if (path.startsWith('/') || target.startsWith('..') || !existsSync(join(root, target))) return true;
    if (anchor === '') return false;
    const there = target === file ? text : readFileSync(join(root, target), 'utf8');
    return !target.endsWith('.md') || !linksOf(there).anchors.has(anchor);
  });
}

describe('the links of Markdown on a repository host', () => {
  const files = markdownFiles();

  test.each(files)('of %s lead to files and headings that are there', (file) => {
    expect(brokenLinks(file, readFileSync(join(root, file), 'utf8'))).toEqual([]);
  });

  test('are looked at in the texts for newcomers and in the guide', () => {
    expect(files).toEqual(expect.arrayContaining(['README.md', 'CONTRIBUTING.md', 'SECURITY.md', 'web/guide/README.md', 'web/guide/planning.md']));
  });

  test('are found out where a file or a heading is not there', () => {
    const text = '# Title\n\n[a](LICENSE) [b](nowhere.md) [c](#title) [d](#none) [e](web/guide/planning.md#none) ![f](none.png) [g](/guide) [h](https://x.org)\n';
    expect(brokenLinks('README.md', text)).toEqual(['nowhere.md', '#none', 'web/guide/planning.md#none', 'none.png', '/guide']);
  });
});
