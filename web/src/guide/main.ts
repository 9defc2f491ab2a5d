import MiniSearch from 'minisearch';

/** A piece of a page, as tools/guide writes it. */
interface Section {
  id: number;
  page: string;
  heading: string;
  text: string;
  address: string;
}

/** Key under which the map stores the user's settings (model/settings). */
const settingsKey = 'floeplan.settings';
const mostResults = 30;
const excerptLength = 160;

function chosenTheme(): unknown {
  try {
    return (JSON.parse(localStorage.getItem(settingsKey) ?? '{}') as { theme?: unknown }).theme;
  } catch {
    return undefined;
  }
}

/** Applies the theme chosen in the map, or else the system's. */
function followTheme(): void {
  const system = window.matchMedia('(prefers-color-scheme: dark)');
  const show = (): void => {
    const chosen = chosenTheme();
    const dark = chosen === 'dark' || (chosen !== 'light' && system.matches);
    document.documentElement.dataset['theme'] = dark ? 'dark' : 'light';
  };
  system.addEventListener('change', show);
  window.addEventListener('storage', show);
  show();
}

async function readIndex(): Promise<MiniSearch<Section>> {
  const answer = await fetch('/guide/search.json');
  if (!answer.ok) throw new Error(`The server answers ${answer.status}.`);
  const index = new MiniSearch<Section>({
    fields: ['heading', 'page', 'text'],
    storeFields: ['page', 'heading', 'text', 'address'],
    // A flag or a code is indexed as a whole and by its parts.
    tokenize: (text) => text.split(/[^\p{L}\p{N}_-]+/u).flatMap((word) => [word, ...(word.includes('-') ? word.split('-') : [])]).filter(Boolean),
    searchOptions: {
      boost: { heading: 3, page: 2 },
      // Troubleshooting counts less, because many of its messages mention a subject that another page explains.
      boostDocument: (_id, _term, stored) => (stored?.['page'] === 'Troubleshooting' ? 0.3 : 1),
      prefix: true,
      fuzzy: 0.2,
      combineWith: 'AND',
    },
  });
  index.addAll((await answer.json()) as Section[]);
  return index;
}

/** The text around the first term found. */
function excerpt(text: string, terms: readonly string[]): string {
  const flat = text.replaceAll(/\s+/g, ' ').trim();
  const at = Math.max(0, ...terms.map((term) => flat.toLowerCase().indexOf(term)).filter((place) => place >= 0).slice(0, 1));
  const from = at < excerptLength / 2 ? 0 : flat.indexOf(' ', at - excerptLength / 2) + 1;
  const part = flat.slice(from, from + excerptLength);
  return `${from > 0 ? '… ' : ''}${part}${from + excerptLength < flat.length ? ' …' : ''}`;
}

function line({ page, heading, text, address }: Section, terms: readonly string[]): HTMLLIElement {
  const link = document.createElement('a');
  link.href = address;
  link.textContent = heading === page ? page : `${page}: ${heading}`;
  const words = document.createElement('p');
  words.textContent = excerpt(text, terms);
  const item = document.createElement('li');
  item.append(link, words);
  return item;
}

/** Search in the field above the page: results replace the page until the field is empty. */
function search(form: HTMLFormElement): void {
  const field = form.querySelector('input');
  const results = document.getElementById('results');
  const article = document.querySelector('article');
  const status = results?.querySelector('p');
  const list = results?.querySelector('ol');
  if (!field || !results || !article || !status || !list) return;

  let index: Promise<MiniSearch<Section>> | undefined;
  const show = async (): Promise<void> => {
    const words = field.value.trim();
    results.hidden = words === '';
    article.hidden = words !== '';
    if (words === '') return;
    try {
      index ??= readIndex();
      const found = (await index).search(words);
      if (field.value.trim() !== words) return; // the user has typed on
      status.textContent = found.length === 0 ? `Nothing is found for “${words}”.` : found.length === 1 ? '1 place' : `${found.length} places`;
      list.replaceChildren(...found.slice(0, mostResults).map((one) => line(one as unknown as Section, one.terms)));
    } catch {
      index = undefined;
      status.textContent = 'The search does not work: the server does not answer. The list of pages does.';
    }
  };
  const clear = (): void => {
    field.value = '';
    void show();
  };
  field.addEventListener('input', () => void show());
  field.addEventListener('keydown', ({ key }) => {
    if (key === 'Escape') clear();
  });
  // The result is on the page that is already shown.
  list.addEventListener('click', ({ target }) => {
    if (target instanceof HTMLAnchorElement && target.pathname === location.pathname) clear();
  });
  form.addEventListener('submit', (event) => {
    event.preventDefault();
    list.querySelector('a')?.focus();
  });
  form.hidden = false;
}

followTheme();
document.addEventListener('DOMContentLoaded', () => {
  const form = document.querySelector<HTMLFormElement>('form.search');
  if (form) search(form);
});
