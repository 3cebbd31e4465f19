// Time until the page is usable, and its smoothness: `node benches/load.mjs` on the existing dist/, in the system's Chromium with
// the processor slowed four times and a line of 10 Mbit/s. Each figure is a line `summary: …`. `RUNS=9` takes more loads, `PARTS=load,minute`
// only some parts of load, path, minute, lighthouse.
import { readFileSync } from 'node:fs';
import { createServer } from 'node:net';
import { brotliCompressSync } from 'node:zlib';
import { DIST, openPanel, ready, start } from '../tests/e2e/page.mjs';
import { scores } from './lighthouse.mjs';

const SLOWED = 4;
const LINE = { offline: false, latency: 40, downloadThroughput: (10 * 1e6) / 8, uploadThroughput: (10 * 1e6) / 8 };
const RUNS = Number(process.env.RUNS ?? 5);
const PARTS = (process.env.PARTS ?? 'load,path,minute,lighthouse').split(',');
// Milliseconds above which a task of the page's thread blocks, and above which a frame is long.
const BLOCKS = 50;
const LONG = 33;

// Chromium's trace of the tasks of its threads.
const TASKS = { categories: ['-*', 'disabled-by-default-devtools.timeline', 'loading', '__metadata'] };

const median = (values) => values.sort((a, b) => a - b)[values.length >> 1];

function summary(what, value, unit, asked, least = false) {
  // As Lighthouse does: labels of the time axis move by a ten thousandth.
  const shown = Number(value.toFixed(3));
  const met = least ? shown >= asked : shown <= asked;
  console.log(`summary: ${what}: ${shown}${unit}, ${asked} asked: ${met ? 'met' : 'MISSED'}`);
}

// Runs before any script of the page: records performance entries, and when the drawing of the machine is first painted.
function watch() {
  const seen = { first: 0, picture: 0, answered: 0, shifts: [], frames: [] };
  window.seen = seen;
  const told = (type, act) => new PerformanceObserver((list) => list.getEntries().forEach(act)).observe({ type, buffered: true });
  told('paint', (entry) => entry.name === 'first-contentful-paint' && (seen.first = entry.startTime));
  told('layout-shift', ({ value, hadRecentInput, startTime, sources }) =>
    seen.shifts.push({ value, hadRecentInput, startTime, parts: sources.map(({ node }) => node?.className || node?.id || node?.nodeName) }),
  );
  // The still gets its size without a change of the document: it is looked for in each frame, and is painted when the next one begins.
  const look = () => {
    const drawing = document.querySelector('svg.scene');
    const there = drawing && drawing.getBoundingClientRect().height >= 100;
    requestAnimationFrame(there ? (at) => (seen.picture = at) : look);
  };
  requestAnimationFrame(look);
}

// Runs before any script of the page: types into the form as soon as it exists, and records the paint of the new verdicts.
function type() {
  const timer = setInterval(() => {
    const [input, verdicts] = [document.querySelector('input#pitch'), document.querySelector('main .cards')];
    if (!input || !verdicts) return;
    clearInterval(timer);
    const look = new MutationObserver(() => {
      look.disconnect();
      requestAnimationFrame(() => requestAnimationFrame(() => (window.seen.answered = performance.now())));
    });
    look.observe(verdicts, { subtree: true, childList: true, characterData: true });
    input.value = '9';
    input.dispatchEvent(new Event('input', { bubbles: true }));
  }, 5);
}

// A page in a fresh profile on a slow processor, given to `act` with the tasks of its thread since the beginning.
async function slowly(app, options, scripts, act) {
  const context = await app.browser.newContext({ viewport: { width: 1440, height: 900 }, ...options });
  // A slow processor on a busy machine.
  context.setDefaultTimeout(120_000);
  for (const script of scripts) await context.addInitScript(script);
  const page = await context.newPage();
  const devtools = await context.newCDPSession(page);
  await devtools.send('Network.enable');
  await devtools.send('Network.emulateNetworkConditions', LINE);
  await devtools.send('Emulation.setCPUThrottlingRate', { rate: SLOWED });
  await app.browser.startTracing(page, TASKS);
  await page.goto(app.url, { waitUntil: 'commit' });
  await ready(page);
  const tasks = async () => tasksOf(JSON.parse(await app.browser.stopTracing()).traceEvents);
  await act(page, tasks);
  await context.close();
}

// Milliseconds of each task of the page's own thread from the first paint on (before it nobody waits for an answer, and the tools of the
// browser's driver run there), in processor time: unlike time by the clock it does not depend on what else the machine does.
function tasksOf(events) {
  const threads = events.filter(({ name, args }) => name === 'thread_name' && args.name === 'CrRendererMain');
  const painted = Math.max(...events.filter(({ name }) => name === 'firstContentfulPaint').map(({ ts }) => ts));
  const tasks = events.filter(({ name, ph, ts, tdur }) => name === 'RunTask' && ph === 'X' && tdur !== undefined && ts >= painted);
  const spent = threads.map(({ pid, tid }) => tasks.filter((task) => task.pid === pid && task.tid === tid).map((task) => task.tdur / 1000));
  // Of all renderers the page's is the busiest.
  return spent.sort((a, b) => sum(b) - sum(a))[0] ?? [];
}

const sum = (values) => values.reduce((all, value) => all + value, 0);
const blocked = (tasks) => sum(tasks.map((task) => Math.max(0, task - BLOCKS)));

async function load(app) {
  const figures = { first: [], picture: [], blocked: [], longest: [], answered: [] };
  for (let run = 0; run < RUNS; run++) {
    await slowly(app, {}, [watch], async (page, tasks) => {
      await page.waitForTimeout(4000);
      const { first, picture } = await page.evaluate(() => window.seen);
      const spent = await tasks();
      figures.first.push(first);
      figures.picture.push(picture);
      figures.blocked.push(blocked(spent));
      figures.longest.push(Math.max(...spent));
    });
    await slowly(app, {}, [watch, type], async (page, tasks) => {
      await page.waitForFunction(() => window.seen.answered > 0);
      figures.answered.push(await page.evaluate(() => window.seen.answered));
      await tasks();
    });
  }
  for (const [name, values] of Object.entries(figures)) console.log(`  ${name}: ${values.map((value) => value.toFixed(0)).join(' ')}`);
  summary('first contentful paint', median(figures.first), ' ms', 1000);
  summary('picture of the machine', median(figures.picture), ' ms', 1000);
  summary('form answers', median(figures.answered), ' ms', 1500);
  summary('blocking time while loading, processor time', median(figures.blocked), ' ms', 300);
}

// Tour of all views of the page, and the frames during it.
async function path(app) {
  await slowly(app, { reducedMotion: 'reduce' }, [watch], async (page, tasks) => {
    await page.waitForTimeout(1000);
    await page.fill('#pitch', '9');
    await page.click('#play');
    await page.waitForTimeout(2000);
    await openPanel(page);
    await page.waitForTimeout(500);
    for (const key of ['ArrowRight', 'ArrowRight', 'ArrowLeft']) await page.locator('#spindle-knob').press(key);
    await page.waitForTimeout(500);
    for (const tab of ['results', 'variables', 'parameters', 'plc', 'program']) {
      await page.click(`#tab-${tab}`);
      await page.waitForTimeout(700);
    }
    await page.waitForTimeout(1000);
    const { shifts } = await page.evaluate(() => window.seen);
    for (const { value, hadRecentInput, startTime, parts } of shifts) {
      console.log(`  shift ${value.toFixed(4)} at ${startTime.toFixed(0)} ms${hadRecentInput ? ' after an input' : ''}: ${parts.join(', ')}`);
    }
    summary('layout shift from load over edit, play, knob and tabs', sum(shifts.filter((one) => !one.hadRecentInput).map((one) => one.value)), '', 0);
    await tasks();
  });
}

// A minute in which the machine moves as it does at first sight.
async function minute(app) {
  await slowly(app, {}, [watch], async (page, tasks) => {
    await page.waitForTimeout(2000);
    await tasks();
    await app.browser.startTracing(page, TASKS);
    const late = await page.evaluate(
      (long) =>
        new Promise((done) => {
          const begun = performance.now();
          const late = [];
          let [last, frames] = [begun, 0];
          const frame = (now) => {
            frames++;
            if (now - last > long) late.push(now - last);
            last = now;
            if (now - begun < 60_000) requestAnimationFrame(frame);
            else done({ late, frames });
          };
          requestAnimationFrame(frame);
        }),
      1.5 * (1000 / 60),
    );
    const spent = await tasks();
    console.log(`  ${late.frames} frames, ${late.late.length} later than 25 ms by the clock, the latest after ${Math.max(0, ...late.late).toFixed(0)} ms`);
    console.log(`  longest tasks: ${spent.sort((a, b) => b - a).slice(0, 8).map((task) => task.toFixed(1)).join(' ')} ms`);
    summary(`tasks over ${LONG} ms in a minute of running, processor time`, spent.filter((task) => task > LONG).length, '', 0);
  });
}

// The files of dist/ as a good host sends them.
function packed(folder) {
  const kept = new Map();
  return (file) => {
    if (!kept.has(file)) kept.set(file, brotliCompressSync(readFileSync(file)));
    return kept.get(file);
  };
}

// A port that is free now.
const freePort = () =>
  new Promise((done) => {
    const server = createServer().listen(0, '127.0.0.1', () => {
      const { port } = server.address();
      server.close(() => done(port));
    });
  });

const port = await freePort();
const app = await start({ packed: packed(DIST), args: [`--remote-debugging-port=${port}`] });
if (PARTS.includes('load')) await load(app);
if (PARTS.includes('path')) await path(app);
if (PARTS.includes('minute')) await minute(app);
if (PARTS.includes('lighthouse')) {
  for (const { what, score, asked, short } of await scores(app.url, port)) {
    short.forEach((audit) => console.log(`  ${audit}`));
    summary(what, score, '', asked, true);
  }
}
await app.close();
