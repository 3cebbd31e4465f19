// Last step of a build: writes the build's number into the page, the list of its files into the service worker, and the page as one file
// beside them. `node scripts/finish.mjs FOLDER`, called by Trunk (Trunk.toml).
import { createHash } from 'node:crypto';
import { readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { join, relative, sep } from 'node:path';
import { pathToFileURL } from 'node:url';
import { oneFile } from './one_file.mjs';

// Placeholder of the build's number.
const PLACE = /@build@/g;
const WORKER = 'service_worker.js';
export const ONE_FILE = 'macroline.html';

const sha256 = (bytes, encoding) => createHash('sha256').update(bytes).digest(encoding);

export function finish(folder) {
  const files = readdirSync(folder, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile() && ![WORKER, ONE_FILE].includes(entry.name))
    .map((entry) => relative(folder, join(entry.parentPath, entry.name)).split(sep).join('/'))
    .sort();
  const read = (name) => readFileSync(join(folder, name));
  // Number of the build: differs when any file differs.
  const build = sha256(files.map((name) => `${name} ${sha256(read(name), 'hex')}\n`).join(''), 'hex').slice(0, 16);
  writeFileSync(join(folder, 'index.html'), String(read('index.html')).replace(PLACE, build));
  // A host may redirect `index.html` to its folder.
  const list = Object.fromEntries(files.map((name) => [name === 'index.html' ? './' : name, sha256(read(name), 'base64')]));
  const worker = `const BUILD = ${JSON.stringify(build)};\nconst FILES = ${JSON.stringify(list, null, 1)};\n${read(WORKER)}`;
  writeFileSync(join(folder, WORKER), worker);
  writeFileSync(join(folder, ONE_FILE), oneFile(folder, files));
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) finish(process.argv[2]);
