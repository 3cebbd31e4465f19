// The npm package of the core, ready for `npm pack`: `node scripts/package.mjs WASM FOLDER [--optimise]`. WASM is the module as cargo has built it.
import { execFileSync } from 'node:child_process';
import { cpSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

const [wasm, folder, optimise] = process.argv.slice(2);
rmSync(folder, { recursive: true, force: true });
mkdirSync(folder, { recursive: true });

execFileSync('wasm-bindgen', [wasm, '--target', 'web', '--no-typescript', '--out-dir', folder, '--out-name', 'core'], { stdio: 'inherit' });
if (optimise) {
  const module = join(folder, 'core_bg.wasm');
  const features = ['--enable-bulk-memory', '--enable-nontrapping-float-to-int', '--enable-sign-ext', '--enable-mutable-globals', '--enable-reference-types', '--enable-multivalue'];
  execFileSync('wasm-opt', ['-O1', '--rse', '--vacuum', '--reorder-functions-by-name', ...features, module, '-o', module], { stdio: 'inherit' });
}

for (const file of ['index.js', 'index.d.ts', 'example']) cpSync(join('package', file), join(folder, file), { recursive: true });
for (const file of ['LICENSE-MIT', 'LICENSE-APACHE']) cpSync(file, join(folder, file));
cpSync('docs/package.md', join(folder, 'README.md'));

const cargo = readFileSync('Cargo.toml', 'utf8');
const fact = (key) => cargo.match(new RegExp(`^${key} = "(.*)"$`, 'm'))[1];
const about = {
  name: fact('name'),
  version: fact('version'),
  description: fact('description'),
  license: fact('license').replace(/^(.* OR .*)$/, '($1)'),
  type: 'module',
  sideEffects: false,
  engines: { node: '>=20' },
  exports: { '.': { types: './index.d.ts', default: './index.js' }, './core_bg.wasm': './core_bg.wasm', './package.json': './package.json' },
  types: './index.d.ts',
  files: ['core.js', 'core_bg.wasm', 'example', 'index.d.ts', 'index.js', 'LICENSE-APACHE', 'LICENSE-MIT', 'README.md'],
};
writeFileSync(join(folder, 'package.json'), `${JSON.stringify(about, null, 2)}\n`);
