// The page opens, loads only the files counted as its first load, and is accessible.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { firstLoad } from '../../scripts/sizes.mjs';
import { DIST, accessible, ready, start, withPage } from './page.mjs';

let app;
before(async () => (app = await start()));
after(() => app?.close());

test('the page opens', () =>
  withPage(app, {}, async ({ page }) => {
    assert.match(await page.title(), /^.+ – macroline$/);
    assert.ok(await page.getByRole('heading', { level: 1 }).isVisible());
  }));

test('first load is what scripts/sizes.mjs counts, each file once', () =>
  withPage(app, {}, async ({ page, requests }) => {
    await page.waitForLoadState('networkidle');
    // The browser decides whether and when to load icon and manifest; the offline module comes after everything else.
    const asked = (name) => !['icon.svg', 'manifest.webmanifest', 'offline.js'].includes(name);
    assert.deepEqual(requests.map((name) => name || 'index.html').filter(asked).sort(), firstLoad(DIST).filter(asked));
  }));

test('page opens from a host without the content type of wasm', async () => {
  const foreign = async ({ page }) => {
    await page.route(/\.wasm/, async (route) => {
      const answer = await route.fetch();
      await route.fulfill({ response: answer, headers: { ...answer.headers(), 'content-type': 'application/octet-stream' } });
    });
    await page.reload();
    await ready(page);
    assert.ok(await page.getByRole('heading', { level: 1 }).isVisible());
  };
  // The glue of wasm-bindgen warns about it; there is no other complaint.
  const remarked = ({ actual }) => actual?.length === 1 && actual[0].startsWith('console warning: `WebAssembly.instantiateStreaming` failed');
  await assert.rejects(withPage(app, {}, foreign), remarked);
});

for (const [what, address] of [['a module', /\.wasm/], ['a catalog of sentences', /en\.properties/]]) {
  test(`${what} that does not load is reported in its place`, async () => {
    const broken = async ({ page }) => {
      await page.route(address, (route) => route.fulfill({ status: 404, body: '' }));
      await page.reload();
      await page.locator('#boot', { hasText: 'could not start in this browser' }).waitFor();
    };
    await assert.rejects(withPage(app, {}, broken), ({ actual }) => actual?.some((text) => text.startsWith('status 404')));
  });
}

for (const colorScheme of ['light', 'dark']) {
  test(`the page is accessible (${colorScheme})`, () => withPage(app, { colorScheme }, ({ page }) => accessible(page)));
}

test('every complaint of the browser fails a test', async () => {
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
