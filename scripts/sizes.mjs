// What the browser has to load, brotli, against the limits: `node scripts/sizes.mjs [folder]`.
import { readdirSync, readFileSync } from 'node:fs';
import { extname, join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { brotliCompressSync, constants } from 'node:zlib';

const KB = 1000;
const LIMITS = { wasm: 250 * KB, total: 300 * KB };

// The module that has every control and machine.
const WHOLE = { name: 'whole_bg.wasm', limit: 330 * KB };

// What the module does without, by a text that it would bring along (of the standard library a file that its panics name), and what
// takes its place. Without this one line of code would bring back what took days to find.
const UNWANTED = {
  'The sentences in English': 'the catalog of sentences: text::catalog::load',
  'form.report.': 'sheets, report and export: the worker makes them, ui::papers',
  'core/src/num/flt2dec': 'printing of floats ({} of an f64): text::number and text::double',
  'core/src/num/dec2flt': 'reading of floats (parse::<f64>): text::number::read',
  'core/src/unicode/printable': 'a text that is sliced, split_at or searched for a text: get(..), text::find',
  'alloc/src/collections/btree': 'BTreeMap: order::Map',
  'core/src/slice/sort': 'sort: order::by_key',
  '/serde_json-': 'serde_json: project::json',
};

// The files that opening the page loads: index.html, what it names, and what those modules import at once. The end-to-end
// tests hold this against what a browser really asks for (tests/e2e/smoke.test.mjs).
export function firstLoad(folder) {
  const found = new Set(['index.html']);
  for (const name of found) {
    const text = ['.html', '.js'].includes(extname(name)) ? readFileSync(join(folder, name), 'utf8') : '';
    const names = name.endsWith('.html') ? /(?:href|src|data-js|data-wasm|data-words)="([^"]+)"/g : /^(?:import|export)\b[^;'"]*['"]([^'"]+)['"]/gm;
    for (const [, at] of text.matchAll(names)) {
      const path = new URL(at, `http://site/${name}`).pathname.slice(1);
      if (path !== '') found.add(path);
    }
  }
  return [...found].sort();
}

// Size of a file as a good host sends it.
export function brotli(file) {
  return brotliCompressSync(readFileSync(file), { params: { [constants.BROTLI_PARAM_QUALITY]: 11 } }).length;
}

function main(folder) {
  const first = firstLoad(folder);
  const later = readdirSync(folder, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) => join(entry.parentPath, entry.name).slice(join(folder, '/').length))
    .filter((name) => !first.includes(name))
    .sort();
  const row = (bytes, name) => console.log(`${(bytes / KB).toFixed(1).padStart(8)} KB  ${name}`);
  const sum = { wasm: 0, total: 0 };
  for (const name of first) {
    const bytes = brotli(join(folder, name));
    sum.total += bytes;
    if (name.endsWith('.wasm')) sum.wasm += bytes;
    row(bytes, name);
  }
  for (const [what, limit] of Object.entries(LIMITS)) row(sum[what], `${what} on first load, limit ${limit / KB} KB`);
  for (const name of later) {
    const bytes = brotli(join(folder, name));
    if (name === WHOLE.name) sum.whole = bytes;
    row(bytes, `${name} (only when asked for)${name === WHOLE.name ? `, limit ${WHOLE.limit / KB} KB` : ''}`);
  }
  const module = first.filter((name) => name.endsWith('.wasm')).map((name) => readFileSync(join(folder, name), 'latin1')).join('');
  const back = Object.entries(UNWANTED).filter(([file]) => module.includes(file));
  for (const [file, instead] of back) console.error(`the module has ${file} again, ${instead}`);
  const over = Object.entries({ ...LIMITS, whole: WHOLE.limit }).filter(([what, limit]) => !(sum[what] < limit)).map(([what]) => what);
  if (over.length > 0) {
    console.error(`too big: ${over.join(', ')}`);
  }
  if (over.length > 0 || back.length > 0) process.exit(1);
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) main(process.argv[2] ?? 'dist');
