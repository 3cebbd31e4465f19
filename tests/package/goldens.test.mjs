// The package under Node gives the goldens: canonical logs, alarms at their places, and the programs of machines.
import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { basename, dirname, join } from 'node:path';
import { before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { macroline } from './package.mjs';

const DATA = fileURLToPath(new URL('../data', import.meta.url));

let core;
before(async () => (core = await macroline()));

const read = (path) => readFileSync(path, 'utf8');
const files = (folder, ending) =>
  readdirSync(folder, { recursive: true })
    .filter((name) => name.endsWith(ending))
    .map((name) => join(folder, name))
    .sort();

// A fixture as tests/it/programs.rs runs it: its switches are comments, X is at 12.5 mm, the second axis at 2 mm, the override knob at 100 %.
function interpreted(path) {
  const text = read(path);
  const control = basename(dirname(dirname(path)));
  const switches = Object.fromEntries([...text.matchAll(/^[(;]SET (\S+) ([^\r\n)]*)/gm)].map(([, id, value]) => [id, value]));
  const { axes } = core.list().controls.find(({ id }) => id === control).bench;
  const positions = { [axes[0].axis]: 12.5, [axes[1].axis]: 2 };
  const ask = (set) => core.interpret({ control, files: [{ name: 'test.nc', text }] }, { switches, positions, set, blocks: 100_000 });
  // Not every control has this input.
  let found = ask({ '#1033': 100 });
  if (found.error?.includes('#1033')) found = ask({});
  assert.equal(found.error, undefined, path);
  return { text, ...found };
}

const place = ({ alarm, line, column }) => `${alarm ?? 'none'} ${line}:${column}`;

// The golden's text of a run.
function log({ diagnostics, canon, remarks, ended, alarm }) {
  const noted = (found) => `(${place(found)} ${found.message})`;
  const lines = [...diagnostics.filter(({ severity }) => severity === 'error').map(noted), ...canon, ...remarks.map(noted)];
  if (ended === 'blocks') lines.push('= budget');
  if (alarm) lines.push(`= ${place(alarm)} ${alarm.message}`, ...alarm.hints.map((hint) => `  ${hint}`));
  return lines.map((line) => `${line}\n`).join('');
}

test('good programs give their canonical log', () => {
  const all = files(join(DATA, 'programs'), '.nc').filter((path) => basename(dirname(path)) === 'ok');
  assert.ok(all.length > 100, `${all.length} programs`);
  for (const path of all) assert.equal(log(interpreted(path)), read(path.replace(/nc$/, 'canon')), path);
});

test('bad programs raise the alarm of their first line', () => {
  const all = files(join(DATA, 'programs'), '.nc').filter((path) => basename(dirname(path)) === 'bad');
  assert.ok(all.length > 100, `${all.length} programs`);
  for (const path of all) {
    const { text, diagnostics, alarm } = interpreted(path);
    const raised = diagnostics.find(({ severity }) => severity === 'error') ?? alarm;
    assert.equal(raised && place(raised), text.match(/^[(;]([^)\r\n]*)/)[1], path);
  }
});

test('machines export the programs of their goldens', () => {
  const all = files(join(DATA, 'machines'), 'project.json');
  assert.ok(all.length >= 24, `${all.length} projects`);
  for (const path of all) {
    const exported = core.export(read(path)).files;
    for (const name of readdirSync(dirname(path))) {
      // Goldens end their lines in LF, whatever the form chooses.
      const text = exported.find((file) => file.name === name)?.text.replaceAll('\r\n', '\n');
      assert.equal(text, read(join(dirname(path), name)), join(dirname(path), name));
    }
  }
});
