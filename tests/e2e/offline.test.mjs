// The page without its host: complete after the first visit; a newer version is announced, taken on request, and never mixed with the
// running one.
import assert from 'node:assert/strict';
import { cpSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { finish } from '../../scripts/finish.mjs';
import { serve } from '../../scripts/serve.mjs';
import { DIST, FIREFOX, enter, ready, saved, start, withPage } from './page.mjs';
import { words } from './words.mjs';

let browser, folder, rest;
before(async () => {
  ({ browser, ...rest } = await start());
  folder = mkdtempSync(join(tmpdir(), 'macroline-'));
});
after(async () => {
  await rest?.close();
  rmSync(folder, { recursive: true, force: true });
});

const SAY = words('en');
const READY = SAY('page.version-ready');
const NEW = 'Export it';
let count = 0;

// A copy of dist/ on a host of its own that stops and starts at the same address.
async function host() {
  const files = join(folder, String(count++));
  cpSync(DIST, files, { recursive: true });
  let site = await serve(files);
  const port = Number(new URL(site.url).port);
  return { files, browser, url: site.url, stop: () => site.close(), start: async () => (site = await serve(files, port)) };
}

// Publishes another build in place of the present one: the button of the export has another name.
function publish({ files }) {
  const change = (name, act) => writeFileSync(join(files, name), act(readFileSync(join(files, name), 'utf8')));
  const [, build] = readFileSync(join(files, 'index.html'), 'utf8').match(/data-build="(\w+)"/);
  change('index.html', (text) => text.replaceAll(build, '@build@'));
  change('en.properties', (text) => text.replace(/^page\.export-short=.*$/m, `page.export-short=${NEW}`));
  cpSync(fileURLToPath(new URL('../../src/ui/files/service_worker.js', import.meta.url)), join(files, 'service_worker.js'));
  finish(files);
}

const withHost = async (act, options = {}) => {
  const at = await host();
  try {
    await withPage(at, { serviceWorkers: 'allow', ...options }, (opened) => act({ ...opened, at }));
  } finally {
    await at.stop();
  }
};

// All files are there, and the page is answered from them.
const isKept = (page) => page.waitForFunction(() => navigator.serviceWorker.controller?.state === 'activated');
const reload = async (page) => {
  await page.reload();
  await ready(page);
};
const notice = (page) => page.locator('.notice', { hasText: READY });
const take = (page) => notice(page).getByRole('button', { name: SAY('page.version-take') });
const exportNamed = (page, name) => page.getByRole('button', { name, exact: true });
const OLD = SAY('page.export-short');

test('after the first visit everything works without the host', () =>
  withHost(async ({ page, at }) => {
    await isKept(page);
    await at.stop();
    await page.getByRole('button', { name: 'Edit', exact: true }).click();
    await page.locator('.editor .cm-content').waitFor();
    await reload(page);
    await enter(page.locator('#pitch'), '8');
    await page.click('#tab-sizing');
    await page.locator('.sizing[aria-busy="false"] .section').first().waitFor();
    await page.click('#export');
    const zip = await saved(page, () => page.click('#save-all'));
    assert.equal(String(zip.subarray(0, 2)), 'PK');
    await page.keyboard.press('Escape');
    await page.getByRole('button', { name: '中文' }).click();
    await page.waitForFunction(() => document.documentElement.lang === 'zh');
    await ready(page);
    assert.equal(await page.locator('#pitch').inputValue(), '8');
    await at.start();
  }));

test('newer version is announced, waits, and keeps the project', () =>
  withHost(async ({ page, context, at }) => {
    await isKept(page);
    publish(at);
    for (let turn = 0; turn < 2; turn++) {
      await reload(page);
      await notice(page).waitFor();
      assert.ok(await exportNamed(page, OLD).isVisible(), 'the version that runs stays');
    }
    await enter(page.locator('#pitch'), '9.5');
    await take(page).click();
    await exportNamed(page, NEW).waitFor();
    await ready(page);
    assert.equal(await page.locator('#pitch').inputValue(), '9.5');
    assert.equal(await notice(page).count(), 0);
    // When no page is open any more, the files of the version before go.
    await page.goto('about:blank');
    const next = await context.newPage();
    await next.goto(at.url);
    await next.waitForFunction(async () => (await caches.keys()).length === 1, null, { polling: 100 });
  }));

test('another tab keeps its version until it asks for a newer one', () =>
  withHost(async ({ page, context, at }) => {
    await isKept(page);
    const other = await context.newPage();
    await other.goto(at.url);
    await ready(other);
    publish(at);
    await reload(page);
    await take(page).click();
    await exportNamed(page, NEW).waitFor();
    await ready(page);
    const sentences = () => other.evaluate(async () => (await fetch(macroline.address('en.properties'))).text());
    assert.ok((await sentences()).includes(`page.export-short=${OLD}\n`), 'its files are those of its own version');
    assert.ok(await exportNamed(other, OLD).isVisible());
    await take(other).click();
    await exportNamed(other, NEW).waitFor();
    await ready(other);
  }));

test('a newer version that does not come whole changes nothing', () =>
  withHost(async ({ page, at }) => {
    await isKept(page);
    publish(at);
    writeFileSync(join(at.files, 'en.properties'), 'page.export-short=Cut off\n');
    await page.reload();
    await ready(page);
    await page.evaluate(async () => {
      const registration = await navigator.serviceWorker.getRegistration();
      await registration.update();
      const { installing } = registration;
      if (installing) await new Promise((done) => installing.addEventListener('statechange', () => installing.state === 'redundant' && done()));
    });
    assert.equal(await notice(page).count(), 0);
    await at.stop();
    await reload(page);
    assert.ok(await exportNamed(page, OLD).isVisible());
    await at.start();
  }));

test('page works in a browser without service workers', async () => {
  const refused = () => (ServiceWorkerContainer.prototype.register = () => Promise.reject(new DOMException('refused', 'SecurityError')));
  const absent = () => Reflect.deleteProperty(Navigator.prototype, 'serviceWorker');
  for (const without of [refused, absent]) {
    await withHost(async ({ page, context }) => {
      await context.addInitScript(without);
      await reload(page);
      assert.ok(await exportNamed(page, OLD).isVisible());
      assert.equal(await page.locator('.notice').count(), 0);
    });
  }
});

test('a page for which there is no room works as it does without', { skip: FIREFOX && 'Firefox has no switch for it' }, () =>
  withHost(async ({ page, context, at }) => {
    await page.evaluate(async () => {
      await (await navigator.serviceWorker.ready).unregister();
      await Promise.all((await caches.keys()).map((name) => caches.delete(name)));
    });
    const devtools = await context.newCDPSession(page);
    await devtools.send('Storage.overrideQuotaForOrigin', { origin: new URL(at.url).origin, quotaSize: 1_000_000 });
    await reload(page);
    await page.waitForTimeout(1000);
    await page.waitForFunction(async () => !(await navigator.serviceWorker.getRegistration())?.installing, null, { polling: 100 });
    assert.deepEqual(await page.evaluate(() => caches.keys()), []);
    assert.equal(await page.locator('.notice').count(), 0);
    await page.getByRole('button', { name: 'Edit', exact: true }).click();
    await page.locator('.editor .cm-content').waitFor();
  }));
