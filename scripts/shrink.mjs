// Makes what was built smaller: the modules by Binaryen, the names by which module and glue know one another, the glue and the styles by
// esbuild; and puts what starts the page into it. Trunk runs it on what will be dist/ (Trunk.toml).
import { execFile } from 'node:child_process';
import { createHash } from 'node:crypto';
import { readFileSync, readdirSync, renameSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { promisify } from 'node:util';
import { transform } from 'esbuild';

const FOLDER = process.env.TRUNK_STAGING_DIR;

// What rustc uses of wasm. The stripped modules do not say it.
const FEATURES = ['bulk-memory', 'multivalue', 'mutable-globals', 'nontrapping-float-to-int', 'reference-types', 'sign-ext'];

// Some passes make a module smaller and what is loaded of it larger: brotli lives on what recurs, and on neighbours that are alike.
const SKIPPED = ['reorder-functions', 'inlining-optimizing', 'local-cse', 'simplify-locals', 'code-pushing'];

// Exports of Leptos' server functions, which the page has not, and the classes around them.
const UNUSED = '*intounderlying*';
const CLASSES = /^export class [^]*?^if \(Symbol\.dispose\).*$/gm;

// Shrinks a module and its glue, and gives both the same short names for what they import and export.
async function shrink(name) {
  const [module, glue] = [join(FOLDER, `${name}_bg.wasm`), join(FOLDER, `${name}.js`)];
  const options = [...FEATURES.map((name) => `--enable-${name}`), ...SKIPPED.map((name) => `--skip-pass=${name}`)];
  options.push(`--remove-exports=${UNUSED}`, '-Os', '--minify-imports-and-exports-and-modules', module, '-o', module);
  const { stdout } = await promisify(execFile)('wasm-opt', options, { maxBuffer: 1 << 24 });
  const { imports, exports } = JSON.parse(stdout);
  const shorter = new Map([...imports.map(([, long, short]) => [long, short]), ...imports.map(([from]) => [from, 'a'])]);
  const called = new Map(exports);
  const missing = new Set(shorter.keys());
  const text = readFileSync(glue, 'utf8')
    .replace(CLASSES, '')
    .replace(/\bwasm\.(\w+)/g, (old, long) => (called.has(long) ? `wasm.${called.get(long)}` : old))
    .replace(/^( +)"?([\w./]+)"?: /gm, (old, indent, long) => (missing.delete(long) ? `${indent}"${shorter.get(long)}": ` : old));
  if (missing.size > 0) throw new Error(`${glue} does not have what ${module} imports: ${[...missing].join(', ')}`);
  writeFileSync(glue, (await transform(text, { minify: true, format: 'esm', target: 'es2022' })).code);
}

const names = () => readdirSync(FOLDER).filter((name) => /\.(js|wasm|css|txt)$/.test(name));
const ending = '_bg.wasm';
await Promise.all(names().filter((name) => name.endsWith(ending)).map((name) => shrink(name.slice(0, -ending.length))));
for (const style of names().filter((name) => name.endsWith('.css'))) {
  const file = join(FOLDER, style);
  writeFileSync(file, (await transform(readFileSync(file, 'utf8'), { minify: true, loader: 'css', target: 'es2022' })).code);
}

// All of them are of one build: the page's module is named after all, and the others are asked for by its name.
const all = createHash('sha256');
for (const name of names().sort()) all.update(readFileSync(join(FOLDER, name)));
const hash = all.digest('hex').slice(0, 16);
const index = join(FOLDER, 'index.html');
const page = readFileSync(index, 'utf8');
const [, old] = /data-wasm="[^"]*-([0-9a-f]+)_bg\.wasm"/.exec(page);

// What starts the page stands in it: the module is asked for a round trip sooner. The content security policy allows this script by its hash.
const BOOT = /(<script type="module") src="[^"]*(boot\.js)"([^>]*>)/;
const [, , file] = BOOT.exec(page);
const { code } = await transform(readFileSync(join(FOLDER, file), 'utf8'), { minify: true, format: 'esm', target: 'es2022' });
const script = `\n${code}`;
const known = createHash('sha256').update(script).digest('base64');
const started = page
  .replace(BOOT, (all, begin, file, rest) => begin + rest + script)
  .replace("script-src 'self'", `script-src 'self' 'sha256-${known}'`)
  .replaceAll(`-${old}`, `-${hash}`);
rmSync(join(FOLDER, file));
writeFileSync(index, started);
for (const name of names().filter((name) => name.includes(`-${old}`))) {
  renameSync(join(FOLDER, name), join(FOLDER, name.replace(old, hash)));
}
