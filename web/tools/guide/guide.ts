import { existsSync, readFileSync } from 'node:fs';
import { basename, dirname, join, posix } from 'node:path';
import { listedLinks, readPage, type Page } from './page.ts';

/** The front page, from the top of the tree; it lists all the others. */
const front = 'web/guide/README.md';

export interface GuidePage extends Page {
  name: string; // the last part of its address; empty: the front page
  file: string; // from the top of the tree
  group: string; // the heading that the front page lists it under
}

export interface Guide {
  pages: GuidePage[]; // the front page, and the others in its order
  pictures: Map<string, string>; // by their names: the files, from the top of the tree
}

const nameOf = (file: string): string => (file === front ? '' : basename(file, '.md').toLowerCase());
const addressOf = (name: string): string => (name === '' ? '/guide' : `/guide/${name}`);
const isForeign = (address: string): boolean => /^(https?|mailto):/.test(address);

/** Reads the guide of the tree whose top is `root`.
 * Errors   throws naming the page and the link where one names no page, picture or heading */
export function readGuide(root: string): Guide {
  const text = (file: string): string => readFileSync(join(root, file), 'utf8');
  const fileAt = (page: string, path: string): string => posix.normalize(posix.join(dirname(page), path));
  const listed = listedLinks(text(front)).map(({ group, address }) => ({ group, file: fileAt(front, address) }));
  const files = new Set([front, ...listed.map(({ file }) => file)]);
  const pictures = new Map<string, string>();
  const wanted: { page: string; target: string; anchor: string }[] = [];

  const resolve = (page: string, address: string): string => {
    if (isForeign(address)) return address;
    const [path = '', anchor = ''] = address.split('#');
    const target = path === '' ? page : fileAt(page, path);
    if (/\.(svg|png)$/.test(target)) {
      if (!existsSync(join(root, target))) throw new Error(`${page} shows ${address}, which is not there.`);
      pictures.set(basename(target), target);
      return `/guide/pictures/${basename(target)}`;
    }
    if (!files.has(target)) throw new Error(`${page} links to ${address}, which is no page that ${front} lists.`);
    wanted.push({ page, target, anchor });
    return `${path === '' ? '' : addressOf(nameOf(target))}${anchor === '' ? '' : `#${anchor}`}`;
  };

  const pages = [{ group: '', file: front }, ...listed].map(({ group, file }): GuidePage => {
    const page = readPage(text(file), (address) => resolve(file, address));
    return { ...page, name: nameOf(file), file, group };
  });
  for (const { page, target, anchor } of wanted) {
    const found = pages.find(({ file }) => file === target);
    if (anchor !== '' && !found?.sections.some((section) => section.anchor === anchor)) {
      throw new Error(`${page} links to #${anchor} of ${target}, which has no such heading.`);
    }
  }
  return { pages, pictures };
}

const escaped = (text: string): string => text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;').replaceAll('"', '&quot;');

function link({ name, title }: GuidePage, attributes = ''): string {
  return `<a href="${addressOf(name)}"${attributes}>${escaped(title)}</a>`;
}

/** The side bar: all pages below their headings, and the headings of the page that is shown. */
function sideBar(guide: Guide, shown: GuidePage): string {
  const item = (page: GuidePage): string => {
    if (page !== shown) return `<li>${link(page)}</li>`;
    const parts = page.sections
      .filter(({ level }) => level === 2)
      .map(({ heading, anchor }) => `<li><a href="#${anchor}">${escaped(heading)}</a></li>`);
    return `<li>${link(page, ' aria-current="page"')}${parts.length > 0 ? `<ul>${parts.join('')}</ul>` : ''}</li>`;
  };
  const groups = [...new Set(guide.pages.map(({ group }) => group))];
  return groups
    .map((group) => {
      const items = guide.pages.filter((page) => page.group === group).map(item).join('');
      return `${group === '' ? '' : `<h2>${escaped(group)}</h2>`}<ul>${items}</ul>`;
    })
    .join('\n      ');
}

function neighbours({ pages }: Guide, shown: GuidePage): string {
  const at = pages.indexOf(shown);
  const before = pages[at - 1];
  const after = pages[at + 1];
  const links = [before ? `<span>Before: ${link(before)}</span>` : '', after ? `<span>Next: ${link(after)}</span>` : ''];
  return `<p class="neighbours">${links.join('')}</p>`;
}

/** A page as it is served, in the frame that was built for all of them. */
export function framed(frame: string, guide: Guide, page: GuidePage): string {
  const parts: Record<string, string> = {
    title: page.name === '' ? escaped(page.title) : `${escaped(page.title)} – Floeplan guide`,
    pages: sideBar(guide, page),
    article: page.html,
    neighbours: neighbours(guide, page),
  };
  // The theme is chosen by the script: nothing is to be drawn before it.
  return frame
    .replace('<script type="module"', '<script blocking="render" type="module"')
    .replaceAll(/\{\{(\w+)\}\}/g, (_, name: string) => parts[name] ?? '');
}

/** What the search of the pages looks through, as JSON. */
export function searchText({ pages }: Guide): string {
  const sections = pages.flatMap(({ name, title, sections: parts }) =>
    parts.map(({ heading, anchor, text }) => ({ page: title, heading, text, address: `${addressOf(name)}${anchor === '' ? '' : `#${anchor}`}` })),
  );
  return JSON.stringify(sections.map((section, id) => ({ id, ...section })));
}
