// Sizes of the files that the browser loads, compressed with brotli, against the limit of the first load: `node scripts/sizes.mjs
// [folder]`. A size over the limit is reported; one over the ceiling fails, so that no large file is added unnoticed.
import { readdirSync, readFileSync, statSync } from 'node:fs';
import { extname, join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { brotliCompressSync, constants } from 'node:zlib';
import { ONE_FILE } from './finish.mjs';

const KB = 1000;
const ASKED = { module: 700 * KB, 'first load': 760 * KB };
const CEILING = 1280 * KB;

// The files that opening the page loads: index.html, the files that it names, and their static imports. The end-to-end tests compare
// this list with the requests of a browser (tests/e2e/smoke.test.mjs).
export function firstLoad(folder) {
  const found = new Set(['index.html']);
  for (const name of found) {
    const text = ['.html', '.js'].includes(extname(name)) ? readFileSync(join(folder, name), 'utf8') : '';
    const names = name.endsWith('.html') ? /(?:href|src|data-js|data-wasm|data-words)="([^"]+)"/g : /^(?:import|export)\b[^;'"(]*['"]([^'"]+)['"]/gm;
    for (const [, at] of text.matchAll(names)) {
      const path = new URL(at, `http://site/${name}`).pathname.slice(1);
      if (path !== '') found.add(path);
    }
  }
  return [...found].sort();
}

// Size (bytes) of a file compressed with brotli, as a good host sends it.
function brotli(file) {
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
  const sizes = { module: 0, 'first load': 0 };
  for (const name of first) {
    const bytes = brotli(join(folder, name));
    sizes['first load'] += bytes;
    if (name.endsWith('.wasm')) sizes.module += bytes;
    row(bytes, name);
  }
  for (const [name, bytes] of Object.entries(sizes)) {
    row(bytes, `${name}, ${ASKED[name] / KB} KB asked: ${bytes <= ASKED[name] ? 'met' : 'MISSED'}`);
  }
  for (const name of later.filter((name) => name === ONE_FILE)) row(statSync(join(folder, name)).size, `${name} (the page as one file, as it is)`);
  for (const name of later.filter((name) => name !== ONE_FILE)) row(brotli(join(folder, name)), `${name} (only when asked for)`);
  if (sizes['first load'] > CEILING) {
    console.error(`the first load is beyond ${CEILING / KB} KB`);
    process.exit(1);
  }
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) main(process.argv[2] ?? 'dist');
