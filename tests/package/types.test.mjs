// The published types match the answers: real answers are written as literals of their types, in which TypeScript finds every field that is
// missing, too many or of another type.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { PACKAGE, macroline } from './package.mjs';

const FOLDER = join(PACKAGE, '../npm-types');
const TSC = fileURLToPath(new URL('../../node_modules/.bin/tsc', import.meta.url));

let core;
before(async () => (core = await macroline()));

// Type-checks files as a program that uses the package; returns the messages of the compiler.
function compiled(files) {
  mkdirSync(FOLDER, { recursive: true });
  for (const [name, text] of Object.entries(files)) writeFileSync(join(FOLDER, name), text);
  const paths = { macroline: [join(PACKAGE, 'index.d.ts')] };
  const compilerOptions = {
    strict: true, noEmit: true, allowJs: true, checkJs: true, target: 'es2022', module: 'esnext', moduleResolution: 'bundler',
    exactOptionalPropertyTypes: true, lib: ['es2022', 'dom'], types: [], paths,
  };
  writeFileSync(join(FOLDER, 'tsconfig.json'), JSON.stringify({ compilerOptions, files: Object.keys(files) }));
  try {
    execFileSync(TSC, ['--project', FOLDER, '--pretty', 'false'], { encoding: 'utf8' });
    return '';
  } catch (failed) {
    return failed.stdout;
  }
}

// One item of each shape is enough of a list.
function shortened(value) {
  if (Array.isArray(value)) {
    const shapes = new Map(value.map((item) => [shape(item), item]));
    return [...shapes.values()].map(shortened);
  }
  if (value === null || typeof value !== 'object') return value;
  return Object.fromEntries(Object.entries(value).map(([key, item]) => [key, shortened(item)]));
}

const shape = (value) => {
  if (value === null || typeof value !== 'object') return value === null ? 'null' : typeof value;
  return Array.isArray(value) ? `[${[...new Set(value.map(shape))]}]` : `{${Object.entries(value).map(([key, item]) => `${key}:${shape(item)}`)}}`;
};

// Answers of every function, by the name of their type.
function* answers() {
  const listing = core.list();
  yield ['Listing', listing];
  for (const { id, controls, examples } of listing.machines) {
    for (const example of examples) {
      const project = core.newProject(id, { control: controls[0], example: example.id });
      yield ['Project', project];
      yield ['Design', core.design(project)];
      yield ['Size', core.size(project, { draws: 20 })];
      yield ['Export', core.export(project, { date: '2026-01-31' })];
      yield ['Check', core.check(project)];
      yield ['Run', core.run(project)];
      yield ['Run', core.run(project, { canon: false })];
      yield ['Interpretation', core.interpret(project)];
      const session = core.step(project);
      yield ['Stop', session.first];
      yield ['Stop', session.into()];
      session.free();
    }
  }
  const bad = { control: 'mitsubishi-e60', files: [{ name: 'bad.nc', text: 'O1\nG01 X8 Y1 F100\n#100=[1+2\n#1=SQRT[-1]\nM30\n' }] };
  yield ['Check', core.check(bad)];
  yield ['Run', core.run(bad)];
  yield ['Interpretation', core.interpret(bad)];
  const text = 'O1\n#100=1\nG65P2A3.\nM98P3L2\nM00\nG01X-8.F100\n#100=0\nM30\nO2\n#101=#1\nM99\nO3\n#102=#102+1\nM99\n';
  const session = core.step({ control: 'mitsubishi-e60', files: [{ name: 'O1.nc', text }] });
  yield ['Stop', session.first];
  yield ['{ number: number }', session.watch('1/#100')];
  yield ['{ number: number }', session.breakAt('10')];
  yield ['{ number: number }', session.breakAt('13', '#102 GT 1')];
  yield ['{ number: number }', session.breakAt('7', '1/#103 GT 1')];
  yield ['{ breakpoints: Breakpoint[] }', session.breakpoints()];
  yield ['Stop', session.continue()];
  yield ['{ variables: Record<string, number> }', session.variables()];
  yield ['Stop', session.out()];
  yield ['Stop', session.over()];
  yield ['Stop', session.back()];
  yield ['Stop', session.to('5')];
  yield ['{ value: number | null }', session.evaluate('#100+1')];
  yield ['{ value: number | null }', session.evaluate('#149')];
  yield ['{ value: number }', session.set('#103', 0)];
  yield ['Stop', session.continue()];
  yield ['Stop', session.start()];
  yield ['Stop', session.continue()];
  yield ['{ removed: boolean }', session.clear()];
  yield ['{ removed: boolean }', session.unwatch(1)];
  yield ['Stop', session.reset()];
  session.free();
  yield ['Refusal', session.into()];
  yield ['Refusal', core.design('{}')];
}

test('answers have their types, field by field', () => {
  const all = new Map();
  for (const [type, answer] of answers()) {
    assert.equal('error' in answer, type === 'Refusal', `${type}: ${JSON.stringify(answer).slice(0, 300)}`);
    all.set(`${type} ${shape(shortened(answer))}`, { type, answer: shortened(answer) });
  }
  const names = [...readFileSync(join(PACKAGE, 'index.d.ts'), 'utf8').matchAll(/^export (?:interface|type) (\w+)/gm)].map(([, name]) => name);
  const lines = [...all.values()].map(({ type, answer }, at) => `export const answer${at}: ${type} = ${JSON.stringify(answer)};`);
  const text = `import type { ${names.join(', ')} } from 'macroline';\n${lines.join('\n')}\n`;
  assert.equal(compiled({ 'answers.ts': text }), '');

  // Counter-check: a removed field, a field too many and a field of another type are errors.
  const [found] = [...all.values()].filter(({ type }) => type === 'Stop');
  const wrong = [{ ...found.answer, more: 1 }, { ...found.answer, time_s: '1' }, { ...found.answer, block: undefined }];
  const literals = wrong.map((answer, at) => `export const answer${at}: Stop = ${JSON.stringify(answer)};`);
  const said = compiled({ 'wrong.ts': `import type { Stop } from 'macroline';\n${literals.join('\n')}\n` });
  assert.equal(said.match(/wrong\.ts\(\d+/g)?.length, 3, said);
});

test('a program that uses every function type-checks', () => {
  const text = `
import * as macroline from 'macroline';
import { exportFiles, export as files } from 'macroline';
await macroline.init();
await macroline.init(new URL('core_bg.wasm', 'https://example.org'));
const listing = macroline.list({ language: 'zh' });
if ('error' in listing) throw new Error(listing.error);
const project = macroline.newProject(listing.machines[0]!.id, { control: 'mitsubishi-e60', example: 'paper' });
if ('error' in project) throw new Error(project.error);
project.values['pitch'] = 10;
const design: macroline.Answer<macroline.Design> = macroline.design(JSON.stringify(project));
const sized = macroline.size(project, { draws: 100, seed: 2 });
const exported = [exportFiles(project), files(project, { date: '' }), macroline.export(project)];
const programs: macroline.Programs = { control: 'gsk-980tdc', files: [{ name: 'O1.nc', text: 'O1' }] };
const checked = macroline.check(programs, { switches: { modulo: 'read' }, silence: ['lint.unreachable'] });
const ran = macroline.run(programs, { plant: project, panel: [{ t: 1, spindle_override: 80 }], start: 'O1', set: { '#100': 1 }, blocks: 10, seconds: 1, continue: true, canon: false });
const read = macroline.interpret(programs, { positions: { X: 1 }, set: { '#100': 1 }, start: 'O1', blocks: 5 });
const session = macroline.step(project, { start: 'O9101', language: 'en' });
if ('error' in session) throw new Error(session.error);
const stop: macroline.Answer<macroline.Stop> = session.into();
session.free();
export { design, sized, exported, checked, ran, read, stop };
`;
  assert.equal(compiled({ 'use.ts': text }), '');
  // @ts-expect-error fails where there is no error.
  const wrong = ["newProject(5)", "run({ control: 'x' })", "check('', { language: 'de' })", "step('', { canon: true })", "design({})"];
  const lines = wrong.map((call) => `// @ts-expect-error\nmacroline.${call};`);
  assert.equal(compiled({ 'wrong-use.ts': `import * as macroline from 'macroline';\n${lines.join('\n')}\n` }), '');
});

test('the example type-checks', () => {
  const text = readFileSync(join(PACKAGE, 'example/example.js'), 'utf8');
  assert.equal(compiled({ 'example.js': text.replace('../index.js', 'macroline') }), '');
});
