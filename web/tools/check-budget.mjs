// Fails the build when what a browser must load first, or what it loads later on, grows past its budget (gzip, kB = 1000 bytes).
import { readFileSync, readdirSync } from 'node:fs';
import { gzipSync } from 'node:zlib';

// What is loaded first may take 230 kB together; scripts and styles are bounded besides, so that neither eats the other's room.
const budget_kb = { js: 215, css: 12, total: 230, charts: 30, panels: 50, guide: 15 };
const dist = new URL('../dist/', import.meta.url);
const page = readFileSync(new URL('index.html', dist), 'utf8');
const guide = readFileSync(new URL('guide/index.html', dist), 'utf8');

const size_kb = { js: 0, css: 0, total: 0, charts: 0, panels: 0, guide: 0 };
for (const name of readdirSync(new URL('assets/', dist))) {
  const kb = gzipSync(readFileSync(new URL(`assets/${name}`, dist)), { level: 9 }).length / 1000;
  if (guide.includes(name)) size_kb.guide += kb;
  if (!page.includes(name)) {
    if (guide.includes(name)) continue;
    size_kb[name.startsWith('plot-') ? 'charts' : 'panels'] += kb;
    continue;
  }
  if (name.endsWith('.js')) size_kb.js += kb;
  if (name.endsWith('.css')) size_kb.css += kb;
  size_kb.total += kb;
}

let failed = false;
for (const [what, limit] of Object.entries(budget_kb)) {
  const over = size_kb[what] > limit;
  failed ||= over;
  console.log(`${what.padEnd(7)} ${size_kb[what].toFixed(1).padStart(6)} kB gzip of ${limit}${over ? '  OVER BUDGET' : ''}`);
}
process.exit(failed ? 1 : 0);
