// The page opens, loads only what is counted as its first load, and is accessible.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { firstLoad } from '../../scripts/sizes.mjs';
import { DIST, accessible, ready, start, withPage } from './page.mjs';

let app;
before(async () => (app = await start()));
after(() => app?.close());

test('the page opens', () =>
  withPage(app, {}, async ({ page }) => {
    assert.equal(await page.title(), 'macroline');
    assert.ok(await page.getByRole('heading', { level: 1 }).isVisible());
  }));

test('before anything is touched the browser loads what scripts/sizes.mjs counts, once, and nothing else', () =>
  withPage(app, {}, async ({ page, requests }) => {
    await page.waitForLoadState('networkidle');
    // Whether and when a tab's icon is asked for is the browser's own affair.
    const noIcon = (name) => !name.startsWith('icon');
    assert.deepEqual(requests.map((name) => name || 'index.html').filter(noIcon).sort(), firstLoad(DIST).filter(noIcon));
  }));

test('the modules are asked for by the page itself, not by a file that has to be loaded first; whoever needs the whole one loads it alone', () =>
  withPage(app, {}, async ({ page, requests }) => {
    const parents = async () => {
      const client = await page.context().newCDPSession(page);
      const from = [];
      await client.send('Network.enable');
      client.on('Network.requestWillBeSent', ({ request, initiator }) => {
        if (/wasm|\.js|en\.txt/.test(request.url)) from.push((initiator.stack?.callFrames[0]?.url ?? initiator.url).replace(app.url, ''));
      });
      await page.reload();
      await ready(page);
      return from;
    };
    assert.deepEqual(new Set(await parents()), new Set(['']));
    await page.evaluate(() => localStorage.setItem('macroline.module', 'whole'));
    requests.length = 0;
    assert.deepEqual(new Set(await parents()), new Set(['']));
    assert.deepEqual(requests.filter((name) => name.endsWith('.wasm')), ['whole_bg.wasm']);
  }));

test('sentences of another version are told, not shown', async () => {
  const foreign = async ({ page }) => {
    await page.route(/en\.txt/, (route) => route.fulfill({ body: 'page.title another' }));
    await page.reload();
    await page.locator('#boot', { hasText: 'could not start in this browser: the file en.txt' }).waitFor();
  };
  await assert.rejects(withPage(app, {}, foreign), ({ actual }) => actual.some((text) => text.startsWith('uncaught: the file en.txt')));
});

test('a host that does not know what a module is will do', () =>
  withPage(app, {}, async ({ page }) => {
    await page.route(/\.wasm/, async (route) => {
      const answer = await route.fetch();
      await route.fulfill({ response: answer, headers: { ...answer.headers(), 'content-type': 'application/octet-stream' } });
    });
    await page.reload();
    await ready(page);
    assert.ok(await page.getByRole('heading', { level: 1 }).isVisible());
  }));

for (const colorScheme of ['light', 'dark']) {
  test(`the page is accessible (${colorScheme})`, () => withPage(app, { colorScheme }, ({ page }) => accessible(page)));
}

test('whatever the browser complains about fails a test', async () => {
  const faults = {
    'console error: no': () => console.error('no'),
    'uncaught: no': () => setTimeout(() => { throw new Error('no'); }),
    'content security policy: style-src-attr': () => document.body.setAttribute('style', 'color: red'),
    'content security policy: connect-src': () => fetch('https://example.org').catch(() => {}),
    'status 404': () => fetch('missing'),
  };
  for (const [complaint, fault] of Object.entries(faults)) {
    const told = ({ actual }) => actual?.some((text) => text.startsWith(complaint));
    await assert.rejects(withPage(app, {}, ({ page }) => page.evaluate(fault)), told, complaint);
  }
});

test('a file of the site and nothing above it is served', async () => {
  assert.equal((await fetch(app.url)).status, 200);
  for (const path of ['missing', '..%2fCargo.toml', '%2e%2e/Cargo.toml', '%']) {
    assert.equal((await fetch(app.url + path)).status, 404, path);
  }
});
