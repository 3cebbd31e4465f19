// Opens the page like a user, in the system's Chromium or with BROWSER=firefox in its Firefox ESR, and fails the test on every complaint of
// the browser.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, readdirSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { setTimeout as sleep } from 'node:timers/promises';
import { fileURLToPath } from 'node:url';
import { chromium, firefox } from 'playwright-core';
import { serve } from '../../scripts/serve.mjs';
import { words } from './words.mjs';

export const DIST = process.env.DIST ?? fileURLToPath(new URL('../../dist', import.meta.url));
const AXE = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

const installed = (command) => execFileSync('sh', ['-c', `command -v ${command}`], { encoding: 'utf8' }).trim();

// Firefox lacks functions of Chromium's developer tools, and settings of reduced motion for a single page.
export const FIREFOX = process.env.BROWSER === 'firefox';
const FOLDER = FIREFOX && mkdtempSync(join(tmpdir(), 'macroline-'));

// Starts the browser.
export function launch(args = []) {
  if (FIREFOX) {
    const firefoxUserPrefs = { 'ui.prefersReducedMotion': 1 };
    return firefox.launch({ channel: 'moz-firefox', executablePath: installed('firefox-esr'), downloadsPath: FOLDER, firefoxUserPrefs });
  }
  // As root Chromium refuses its sandbox, and a container has a small /dev/shm.
  return chromium.launch({ executablePath: installed('chromium'), args: ['--no-sandbox', '--disable-dev-shm-usage', ...args] });
}

// Serves dist/ and starts the browser; both end with `close`. One per test file, in `before` and `after`. For measurements: `packed` as in
// scripts/serve.mjs, and further arguments of the browser.
export async function start({ packed = null, args = [] } = {}) {
  assert.ok(existsSync(DIST), 'there is no dist/: run `make dist` first');
  const site = await serve(DIST, 0, packed);
  const browser = await launch(args);
  return {
    url: site.url,
    browser,
    close: async () => {
      await browser.close();
      await site.close();
      if (FOLDER) rmSync(FOLDER, { recursive: true });
    },
  };
}

// Message of the driver about a service worker that a page cannot register, in every context except those with `serviceWorkers: 'allow'`: a
// test sees the page itself, not the browser's copy of it.
const NO_WORKER = 'Service Worker registration blocked by Playwright';

// Opens the page in a fresh profile, waits until the app is ready, calls `act`, and then checks that the browser had no complaint:
// `withPage(app, { viewport: … }, async ({ page, requests }) => …)`.
export async function withPage(app, options, act) {
  const context = await app.browser.newContext({ viewport: { width: 1440, height: 900 }, locale: 'en', acceptDownloads: true, reducedMotion: 'reduce', serviceWorkers: 'block', ...options });
  const complaints = [];
  const requests = [];
  try {
    context.on('console', (message) => {
      if (['error', 'warning'].includes(message.type()) && message.text() !== NO_WORKER) complaints.push(`console ${message.type()}: ${message.text()}`);
    });
    context.on('weberror', (fault) => complaints.push(`uncaught: ${fault.error().message}`));
    context.on('request', (request) => requests.push(request.url().replace(app.url, '').replace(/\?.*/, '')));
    // Firefox reports requests that the next page ends.
    const ended = (request) => FIREFOX && request.failure()?.errorText === 'NS_BINDING_ABORTED';
    context.on('requestfailed', (request) => ended(request) || complaints.push(`failed: ${request.url()} ${request.failure()?.errorText}`));
    context.on('response', (response) => {
      if (response.status() >= 400) complaints.push(`status ${response.status()}: ${response.url()}`);
    });
    // Not every violation of the content security policy reaches the console.
    await context.exposeBinding('complain', (_, text) => complaints.push(text));
    await context.addInitScript(() => {
      addEventListener('securitypolicyviolation', (event) =>
        window.complain(`content security policy: ${event.violatedDirective} ${event.blockedURI} ${event.sourceFile}:${event.lineNumber}`),
      );
    });
    const page = await context.newPage();
    await page.goto(app.url);
    await ready(page);
    await act({ page, context, requests });
    // Messages already on their way to the console arrive before this.
    await page.evaluate(() => new Promise((done) => setTimeout(done)));
    assert.deepEqual(complaints, [], 'the browser complained');
  } finally {
    await context.close();
  }
}

// The app is ready when all of it is built, or when boot.js has put its error into its notice.
export async function ready(page) {
  await page.waitForFunction(() => {
    const notice = document.getElementById('boot');
    return notice ? !notice.textContent.includes('loading') : document.querySelector('main')?.getAttribute('aria-busy') === 'false';
  });
  const failed = await page.locator('#boot').allTextContents();
  assert.deepEqual(failed, [], 'the app did not start');
}

// The content of the file that an action saves.
export async function saved(page, act) {
  if (!FIREFOX) {
    const [download] = await Promise.all([page.waitForEvent('download', { timeout: 60_000 }), act()]);
    return readFileSync(await download.path());
  }
  const files = () => readdirSync(FOLDER).filter((name) => !name.endsWith('.part'));
  const before = files();
  await act();
  for (let turn = 0; turn < 600; turn++) {
    const name = files().find((name) => !before.includes(name));
    const content = name && readFileSync(join(FOLDER, name));
    if (content?.length > 0) return content;
    await sleep(100);
  }
  throw new Error('nothing was saved');
}

// Types a text and confirms it like a user: Firefox does not count a text set by a script as a change.
export async function enter(input, text) {
  await input.fill('');
  await input.pressSequentially(text);
  await input.press('Enter');
}

// Replaces the project by an example of the gallery, by its name.
export async function takeExample(page, name) {
  await page.getByRole('button', { name: 'New', exact: true }).click();
  await page.getByRole('dialog').getByRole('button', { name, exact: true }).click();
}

// The published machine of the ribbon line, whose faults several paths need.
export const PAPER = 'The paper’s machine';

// Names of the machines in the catalog.
export const MACHINES = ['ribbon.name', 'turning.name', 'polygon.name'];

// A field of the form, a line of the program, the clock of the run; a click on a button by its whole name.
export const field = (page, id) => page.locator(`#${id}`);
export const line = (page, text) => page.locator('.listing li', { hasText: text }).first();
export const clock = (page) => page.locator('#clock').textContent();
export const press = (page, name) => page.getByRole('button', { name, exact: true }).click();

// Puts the play head at a time in seconds.
export const goTo = (page, seconds) => enter(page.locator('#go-to'), String(seconds));

// Firefox counts clicks that come from outside one by one.
export async function doubleClick(target) {
  if (!FIREFOX) return target.dblclick();
  await target.click();
  await target.click();
  await target.dispatchEvent('dblclick');
}

// Processor time (s) of the page's own thread so far: unlike clock time it does not depend on other load of the machine. 0 in Firefox,
// which has no such figure.
export async function processorTime(page) {
  if (FIREFOX) return async () => 0;
  const devtools = await page.context().newCDPSession(page);
  await devtools.send('Performance.enable', { timeDomain: 'threadTicks' });
  return async () => (await devtools.send('Performance.getMetrics')).metrics.find(({ name }) => name === 'TaskDuration').value;
}

// Checks that axe-core finds nothing in the present page (WCAG 2.2 A and AA, with the size of targets, which axe checks only on request,
// and axe's best practices), or nothing by the given rules.
export async function accessible(page, rules) {
  // Evaluated by the test, so that the page's content security policy stays in force.
  await page.evaluate(AXE);
  const options = { resultTypes: ['violations'], runOnly: rules, rules: { 'target-size': { enabled: !rules } } };
  const { violations } = await page.evaluate((options) => window.axe.run(document, options), options);
  const told = violations.map(({ id, help, nodes }) => `${id}: ${help}\n    ${nodes.map((node) => node.html).join('\n    ')}`);
  assert.deepEqual(told, [], `not accessible:\n  ${told.join('\n  ')}\n`);
}

// Unfolds the operator's panel.
export async function openPanel(page) {
  if ((await page.locator('#panel-fold').getAttribute('aria-expanded')) === 'false') await page.click('#panel-fold');
}

// Waits for the sizing of the present project, and opens its sections except the draw of machines.
export async function openSizing(page) {
  await page.locator('#tab-sizing').click();
  await page.locator('.sizing[aria-busy="false"] .section').first().waitFor();
  await page.evaluate(() => document.querySelectorAll('.section:not(#sizing-chance)').forEach((section) => (section.open = true)));
  await page.locator('#sizing-terminals table').waitFor();
}

// The text of the listing, lines out of sight too: the browser draws them when they come into it, and their inner text is empty until then.
export const listing = async (page) => (await page.locator('.listing li[data-l] code').allTextContents()).join('\n');

// Shows the commands that step through the program.
export const showSteps = (page, say = words('en')) => page.getByRole('button', { name: say('page.stepping-short'), exact: true }).click();

// Unfolds all groups of the form.
export async function openGroups(page) {
  await page.evaluate(() => document.querySelectorAll('details').forEach((group) => (group.open = true)));
  // A group of the form builds its fields when it is opened.
  await page.waitForFunction(() => [...document.querySelectorAll('.form .group')].every((group) => group.querySelector('.field')));
}
