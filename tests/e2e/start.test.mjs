// Start of the page: the machine is visible before the module is loaded, and keeps its place when the module takes over.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { covered } from './covered.mjs';
import { FIREFOX, ready, start, withPage } from './page.mjs';

let app;
before(async () => (app = await start()));
after(() => app?.close());

// Reloads the page with its module held back; calls `look`, then releases the module.
async function held(page, look) {
  let release;
  const wait = new Promise((done) => (release = done));
  await page.route(/app.*\.wasm/, async (route) => {
    await wait;
    await route.continue();
  });
  await page.reload({ waitUntil: 'commit' });
  // boot.js has shown the still, which some browsers paint before.
  await page.waitForFunction(() => {
    const painted = performance.getEntriesByName('first-contentful-paint').length > 0;
    return painted && document.documentElement.dataset.theme !== undefined;
  });
  const seen = await look();
  release();
  await ready(page);
  return seen;
}

// Place of the drawing, and the drawing units per pixel of its labels.
const drawing = (page) =>
  page.locator('svg.scene').evaluate((svg) => {
    const { x, y, width, height } = svg.getBoundingClientRect();
    return { x, y, width, height, unit: getComputedStyle(svg).getPropertyValue('--u') };
  });

// A slow phone paints more of the states on the way.
const SLOWED = FIREFOX ? [] : [[390, 844, 10]];
for (const [width, height, slowed = 1] of [[1366, 768], [1440, 900], [1920, 1080], [1024, 768], [390, 844], ...SLOWED]) {
  test(`drawing precedes module, in place (${width} × ${height}, slowed ${slowed} times)`, () =>
    withPage(app, { viewport: { width, height } }, async ({ page }) => {
      if (slowed > 1) {
        const devtools = await page.context().newCDPSession(page);
        await devtools.send('Emulation.setCPUThrottlingRate', { rate: slowed });
      }
      await page.addInitScript(() => {
        window.shifts = 0;
        const add = (list) => list.getEntries().forEach(({ value }) => (window.shifts += value));
        // Only Chromium counts them.
        const counts = PerformanceObserver.supportedEntryTypes.includes('layout-shift');
        if (counts) new PerformanceObserver(add).observe({ type: 'layout-shift', buffered: true });
      });
      const still = await held(page, async () => {
        assert.ok((await page.locator('#boot').textContent()).includes('loading'));
        assert.equal(await page.locator('.listing').count(), 0);
        assert.ok(await page.locator('svg.scene').isVisible());
        // On a phone the names of parts wait for their places.
        assert.equal(await page.getByText('Print roller').first().isVisible(), width > 760);
        assert.ok(await page.locator('.waits').first().isVisible());
        assert.deepEqual(await covered(page), []);
        return drawing(page);
      });
      assert.deepEqual(await drawing(page), still);
      assert.equal(await page.locator('#still, #boot').count(), 0);
      assert.equal(await page.locator('svg.scene').count(), 1);
      assert.equal((await page.evaluate(() => window.shifts)).toFixed(3), '0.000');
    }));
}

test('the still goes on as the drawing, and leads to its fields', () =>
  withPage(app, {}, async ({ page }) => {
    await held(page, () => page.locator('svg.scene').evaluate((svg) => (svg.kept = true)));
    assert.equal(await page.locator('svg.scene').evaluate((svg) => svg.kept), true);
    await page.locator('svg.scene [data-field="press-roller-diameter"]').first().dispatchEvent('click');
    await page.waitForFunction(() => document.activeElement.id === 'press-roller-diameter');
  }));

test('a machine of one’s own is not preceded by another', () =>
  withPage(app, {}, async ({ page }) => {
    await page.getByRole('button', { name: 'Turning spindle' }).click();
    await page.waitForFunction(() => localStorage.getItem('macroline.project')?.includes('turning-spindle'));
    const still = () => page.locator('#still .scene').count();
    assert.equal(await held(page, still), 0);
    assert.equal(await page.locator('.segments [aria-pressed="true"]').textContent(), 'Turning spindle');
  }));

test('the still has the theme of the last visit', () =>
  withPage(app, { colorScheme: 'light' }, async ({ page }) => {
    for (const _ of [1, 2]) await page.locator('.theme').click();
    const paper = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
    const dark = await paper();
    assert.notEqual(dark, 'rgb(255, 255, 255)');
    assert.equal(await held(page, paper), dark);
  }));
