// Speed of the wasm as the page ships it, beside native code: one bench (benches/both.rs), built for both, run in turns. The best round of
// each counts, because other load of the machine only slows, on a shared core by half. `node scripts/both.mjs`; its last lines are the figures.
import { spawnSync } from 'node:child_process';

const ROUNDS = 6;
const BUILDS = [
  { name: 'native', args: [] },
  { name: 'wasm', args: ['--target', 'wasm32-unknown-unknown', '--profile', 'web'] },
];
// Least share of the native speed, by figure.
const PARTS = { 'flat blocks, text to canon': 0.5, 'O9100 passes, text to canon': 0.5, 'flat blocks, planned': 0.45 };

function cargo(args) {
  const done = spawnSync('cargo', ['bench', '--locked', '--quiet', '--bench', 'both', ...args], {
    encoding: 'utf8',
    stdio: ['ignore', 'pipe', 'inherit'],
    maxBuffer: 1 << 26,
  });
  if (done.status !== 0) {
    process.stderr.write(done.stdout ?? '');
    process.exit(1);
  }
  return done.stdout;
}

// Rates of each figure, one a round, by build.
const rates = new Map();
// Least rates that the bench states, by figure and build.
const leasts = new Map();
for (const { args } of BUILDS) cargo([...args, '--no-run']);
for (let round = 0; round < ROUNDS; round++) {
  for (const { name, args } of BUILDS) {
    for (const [, figure, rate, unit, least] of cargo(args).matchAll(/^summary: (.+): (\d+) (\w+\/s),.*?(?:; at least (\d+) asked.*)?$/gm)) {
      const key = JSON.stringify([figure, unit]);
      if (!rates.has(key)) rates.set(key, Object.fromEntries(BUILDS.map((build) => [build.name, []])));
      rates.get(key)[name].push(Number(rate));
      if (least) leasts.set(key + name, Number(least));
    }
  }
}

if (rates.size === 0) throw new Error('the bench printed no figure');
for (const [key, of] of rates) {
  const [figure, unit] = JSON.parse(key);
  for (const { name } of BUILDS) {
    const rate = Math.max(...of[name]);
    const part = rate / Math.max(...of.native);
    const least = leasts.get(key + name);
    const itself = least ? `, at least ${least} asked: ${rate >= least ? 'met' : 'MISSED'}` : '';
    const asked = PARTS[figure];
    const verdict = asked ? `; ${asked} asked: ${part >= asked ? 'met' : 'MISSED'}` : '';
    const share = name === 'native' ? '' : `, ${part.toFixed(2)} of native${verdict}`;
    console.log(`summary: ${figure}, ${name}: ${rate} ${unit}${itself}${share}`);
  }
}
