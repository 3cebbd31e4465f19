// The functions answer any argument: an error is a sentence in the answer, and nothing is thrown.
import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { INDEX, macroline } from './package.mjs';

let core;
before(async () => (core = await macroline()));

const cyclic = {};
cyclic.self = cyclic;
let deep = [];
for (let at = 0; at < 5000; at++) deep = [deep];
const throwing = { get version() { throw new Error('no'); } };
const written = { toJSON() { throw new Error('no'); } };
const WRONG = [undefined, null, true, 5, NaN, 5n, '', '{', 'x'.repeat(1_000_000), [], {}, () => 1, Symbol('x'), new Date(NaN), cyclic, deep, throwing, written];
const CALLS = ['newProject', 'design', 'size', 'export', 'check', 'run', 'interpret', 'step'];

const refused = (answer, about) => {
  assert.equal(typeof answer.error, 'string', about);
  assert.ok(answer.error.length > 5 && Array.isArray(answer.diagnostics), about);
};

test('wrong arguments are refused in words', () => {
  for (const call of CALLS) {
    for (const wrong of WRONG) refused(core[call](wrong), `${call}(${typeof wrong})`);
  }
});

test('wrong options are refused in words', () => {
  const project = core.newProject('ribbon-line');
  const programs = { control: 'gsk-980tdc', files: [{ name: 'O1.nc', text: 'O1\nM30\n' }] };
  for (const wrong of [null, 5, 'x', [], cyclic, { language: 'xx' }, { language: 5 }, { unknown: 1 }]) {
    for (const call of CALLS.slice(1)) refused(core[call](project, wrong), `${call} ${JSON.stringify(Object.keys(wrong ?? {}))}`);
  }
  const runs = [{ set: { '#100': 'x' } }, { set: 5 }, { seconds: -1 }, { switches: { none: 'x' } }, { silence: 'x' }, { start: 5 }, { panel: '[' }, { plant: {} }];
  for (const wrong of runs) {
    const answer = core.run(programs, wrong);
    assert.ok(answer.error ?? answer.diagnostics.some(({ severity }) => severity === 'error'), JSON.stringify(wrong));
  }
});

test('too large a request is refused and the next one answered', () => {
  refused(core.check('x'.repeat(65 * 2 ** 20)), 'too large');
  assert.equal(core.list().error, undefined);
});

test('an error speaks the language of its call', () => {
  assert.match(core.newProject('x').error, /^no machine “x”/);
  assert.match(core.newProject('x', { language: 'zh' }).error, /^没有机床“x”/);
  assert.match(core.newProject('x').error, /^no machine/);
  assert.match(core.list({ language: 'de' }).error, /^No language|language “de”/i);
  assert.doesNotMatch(core.list({ language: 'de' }).error, /\p{Script=Han}|^request\./u);
  assert.match(core.list({ language: 'zh' }).machines[0].name, /\p{Script=Han}/u);
});

test('a session answers wrong commands, and after it is freed', () => {
  const session = core.step(core.newProject('ribbon-line'), { language: 'zh' });
  for (const wrong of WRONG) {
    refused(session.to(wrong), 'to');
    refused(session.breakAt(wrong), 'breakAt');
    refused(session.set(wrong, wrong), 'set');
    if (wrong !== undefined && wrong !== null) refused(session.watch(wrong), `watch ${typeof wrong}`);
  }
  assert.match(session.to('N9999').error, /\p{Script=Han}/u);
  assert.equal(session.into().stop, 'block');
  session.free();
  session.free();
  refused(session.into(), 'freed');
});

test('sessions do not disturb one another', () => {
  const project = core.newProject('ribbon-line');
  const [one, other] = [core.step(project), core.step(project, { language: 'zh' })];
  one.into();
  const line = one.into().block.line;
  assert.equal(other.into().block.line < line, true);
  one.free();
  assert.equal(other.into().block.line, line);
  other.free();
});

test('a call before init says so', async () => {
  // A second instance of the module, under an address of its own.
  const fresh = await import(`${INDEX}?fresh`);
  assert.throws(() => fresh.list(), /await init\(\)/);
  await Promise.all([fresh.init(), fresh.init()]);
  assert.ok(fresh.list().machines.length > 0);
});
