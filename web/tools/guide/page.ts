import GithubSlugger from 'github-slugger';
import createMarkdown, { type MarkdownIt, type Token } from 'markdown-it';

/** A piece of a page under one heading, as the search knows it. */
export interface Section {
  heading: string;
  anchor: string; // empty: the top of the page
  level: number;
  text: string;
}

/** A page of the guide, read from Markdown. */
export interface Page {
  title: string;
  sections: Section[];
  html: string;
}

/** What becomes of the address that a link or a picture of a page names. Throws where it names nothing. */
export type Resolve = (address: string) => string;

/** Comments mark what is written out by tests; anything else of HTML would look different on a repository host. */
const isComment = (text: string): boolean => /^\s*<!--[^]*-->\s*$/.test(text);

/** What an inline token says, without its marks. */
function wordsOf(tokens: readonly Token[]): string {
  return tokens
    .map(({ type, content, children }) => (type === 'softbreak' ? ' ' : children && children.length > 0 ? wordsOf(children) : type === 'html_inline' ? '' : content))
    .join('');
}

/** Gives every heading the anchor that repository hosts give it, and divides the page at its headings. */
function divide(tokens: Token[]): Section[] {
  const slugger = new GithubSlugger();
  const sections: Section[] = [];
  tokens.forEach((token, i) => {
    const inline = tokens[i + 1];
    if (token.type === 'heading_open' && inline) {
      const heading = wordsOf([inline]);
      const anchor = slugger.slug(heading);
      token.attrSet('id', anchor);
      sections.push({ heading, anchor: token.tag === 'h1' ? '' : anchor, level: Number(token.tag.slice(1)), text: '' });
      return;
    }
    const isHeading = tokens[i - 1]?.type === 'heading_open';
    const section = sections.at(-1);
    if (section && !isHeading && (token.type === 'inline' || token.type === 'fence')) section.text += `${wordsOf([token])}\n`;
  });
  return sections;
}

/** Tables wider than the screen scroll in a box of their own, which has to take the focus for that. */
function boxTables(markdown: MarkdownIt): void {
  markdown.renderer.rules['table_open'] = () => '<div class="table" role="group" aria-label="Table" tabindex="0"><table>\n';
  markdown.renderer.rules['table_close'] = () => '</table></div>\n';
}

function rewrite(tokens: readonly Token[], resolve: Resolve): void {
  for (const token of tokens) {
    if (/^html_/.test(token.type) && !isComment(token.content)) throw new Error(`HTML is not for the guide: ${token.content.trim()}`);
    for (const name of ['href', 'src']) {
      const address = token.attrGet(name);
      if (address !== null) token.attrSet(name, resolve(String(address)));
    }
    if (token.children) rewrite(token.children, resolve);
  }
}

/** Reads a page.
 * Errors   throws where it does not begin with its one title, holds HTML, or `resolve` throws */
export function readPage(text: string, resolve: Resolve): Page {
  const markdown = createMarkdown({ html: true });
  boxTables(markdown);
  const tokens = markdown.parse(text, {});
  const sections = divide(tokens);
  const [first] = sections;
  if (tokens[0]?.tag !== 'h1' || first === undefined || sections.filter(({ level }) => level === 1).length !== 1) {
    throw new Error('A page begins with its title, # and words, and has no other.');
  }
  rewrite(tokens, resolve);
  const html = markdown.renderer.render(tokens, markdown.options, {}).replaceAll(/<!--[^]*?-->\n?/g, '');
  return { title: first.heading, sections, html };
}

/** A link in a list of a page, and the heading above it. */
export interface Entry {
  group: string;
  address: string;
}

/** The links that the items of a page's lists begin with: the front page orders the others. */
export function listedLinks(text: string): Entry[] {
  let group = '';
  const entries: Entry[] = [];
  const tokens = createMarkdown({ html: true }).parse(text, {});
  tokens.forEach((token, i) => {
    if (token.type === 'inline' && tokens[i - 1]?.tag === 'h2') group = wordsOf([token]);
    const isItem = tokens[i - 2]?.type === 'list_item_open';
    const link = token.children?.[0];
    if (isItem && link?.type === 'link_open') entries.push({ group, address: String(link.attrGet('href')) });
  });
  return entries;
}
