// The page as one file that opens from a disk: the files of a build with their texts and modules inside (src/ui/one_file.js unpacks them).
import { buildSync } from 'esbuild';
import { createHash } from 'node:crypto';
import { readFileSync } from 'node:fs';
import { extname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';
import { TYPES } from './serve.mjs';

// Files that the page does not request by address: they are in the document itself, or only of use beside it.
const NO_PART = /^(index\.html|service_worker\.js|offline\.js|manifest\.webmanifest|icon\.svg|.*\.css|app-.*|snippets\/.*)$/;

const hashes = (texts) => texts.map((text) => `'sha256-${createHash('sha256').update(text).digest('base64')}'`).join(' ');

// `folder` is the build, `files` are the names of its files.
export function oneFile(folder, files) {
  const read = (name) => readFileSync(join(folder, name));
  const page = String(read('index.html'));
  const attribute = (name) => page.match(new RegExp(`${name}="\\./([^"]+)"`))[1];
  // The glue imports files beside it, which a module without a folder cannot.
  const bundled = (name) => buildSync({ entryPoints: [join(folder, name)], bundle: true, format: 'esm', minify: true, target: 'es2022', write: false, logLevel: 'error' }).outputFiles[0].contents;
  const parts = [
    ['app.js', 'text/javascript', bundled(attribute('data-js'))],
    ['app_bg.wasm', 'application/wasm', read(attribute('data-wasm'))],
    ...files.filter((name) => !NO_PART.test(name)).map((name) => [name, TYPES[extname(name)] ?? 'text/plain', read(name)]),
  ];
  const part = ([name, type, bytes]) => `<script type="text/plain" data-part="${name}" data-type="${type}">${gzipSync(bytes, { level: 9 }).toString('base64')}</script>\n`;
  const loader = readFileSync(fileURLToPath(new URL('../src/ui/one_file.js', import.meta.url)), 'utf8');
  const sheets = [];
  const sheet = (_, name, rest) => {
    sheets.push(String(read(name)));
    return `<style${rest}>${sheets.at(-1)}</style>`;
  };
  const icon = `data:image/svg+xml;base64,${read('icon.svg').toString('base64')}`;
  const replace = (text, from, to) => {
    if (text.search(from) < 0) throw new Error(`one file: index.html has no ${from}`);
    return text.replace(from, to);
  };
  return [
    [/ *<base [^>]*>\n/, ''],
    [/ *<link rel="manifest"[^>]*>\n/, ''],
    [/<link rel="(?:modulepreload|preload)"[^>]*>/g, ''],
    [/<link rel="icon"[^>]*>/, `<link rel="icon" href="${icon}">`],
    [/<link rel="stylesheet" href="\.\/([^"]+)"([^>]*?)\/?>/g, sheet],
    [/<script type="module"[^>]*><\/script>/, ''],
    [/<\/body>/, () => `${parts.map(part).join('')}<script type="module" data-js data-wasm data-words="en.properties">${loader}</script>\n  </body>`],
    [
      /content="default-src[^"]*"/,
      () =>
        `content="default-src 'none'; script-src ${hashes([loader])} blob: 'wasm-unsafe-eval'; style-src ${hashes(sheets)}; ` +
        `img-src data: blob:; connect-src data: blob:; worker-src blob:; base-uri 'none'; form-action 'none'"`,
    ],
  ].reduce((text, [from, to]) => replace(text, from, to), page);
}
