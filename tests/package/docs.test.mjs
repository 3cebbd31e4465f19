// The example of docs/package.md runs, and prints the output shown below it.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { INDEX, PACKAGE } from './package.mjs';

const DOC = new URL('../../docs/package.md', import.meta.url);

test('the example of the documentation prints its output', () => {
  const doc = readFileSync(DOC, 'utf8');
  const [, code] = doc.match(/```js\n(.*?)```/s);
  const [, expected] = doc.match(/```text\n(.*?)```/s);
  const file = join(PACKAGE, 'of-the-documentation.mjs');
  writeFileSync(file, code.replace("'macroline'", JSON.stringify(INDEX)));
  assert.equal(execFileSync(process.execPath, [file], { encoding: 'utf8' }), expected);
});

test('the packed files are those that the package needs', () => {
  const [{ files }] = JSON.parse(execFileSync('npm', ['pack', '--dry-run', '--json'], { cwd: PACKAGE, encoding: 'utf8' }));
  const names = files.map(({ path }) => path);
  for (const name of ['index.js', 'index.d.ts', 'core.js', 'core_bg.wasm', 'README.md', 'LICENSE-MIT', 'LICENSE-APACHE', 'example/index.html']) {
    assert.ok(names.includes(name), name);
  }
  const about = JSON.parse(readFileSync(join(PACKAGE, 'package.json'), 'utf8'));
  const cargo = readFileSync(new URL('../../Cargo.toml', import.meta.url), 'utf8');
  assert.equal(about.version, cargo.match(/^version = "(.*)"/m)[1]);
});
