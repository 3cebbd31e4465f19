// The one screen: machine, play and emergency stop at every size; no message moves a control; the page opens playing.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { FIREFOX, PAPER, clock, doubleClick, openPanel, ready, saved, start, takeExample, withPage } from './page.mjs';

let app;
before(async () => (app = await start()));
after(() => app?.close());

const box = (page, selector) => page.locator(selector).boundingBox();

// The last two are 1366 × 768 and 1440 × 900 at a zoom of 200 %.
for (const [width, height] of [[1366, 768], [1920, 1080], [1440, 900], [1024, 768], [390, 844], [683, 384], [720, 450]]) {
  test(`machine, play, stop on first screen (${width} × ${height})`, () =>
    withPage(app, { viewport: { width, height } }, async ({ page }) => {
      for (const selector of ['#machine', '#play', '.mushroom']) {
        const { x, y, width: w, height: h } = await box(page, selector);
        assert.ok(x >= 0 && y >= 0 && x + w <= width && y + h <= height, `${selector}: ${JSON.stringify({ x, y, w, h })}`);
      }
      if (width > 760) {
        const [stage, centre] = [await box(page, '#machine'), await box(page, '.centre')];
        assert.ok(stage.height >= 0.55 * centre.height, `${stage.height} of ${centre.height}`);
      }
    }));
}

for (const [width, height] of [[800, 600], [800, 900], [1024, 480], [780, 1000], [390, 844]]) {
  test(`drawing fills its stage (${width} × ${height})`, () =>
    withPage(app, { viewport: { width, height } }, async ({ page }) => {
      for (const name of ['Ribbon line', 'Turning spindle', 'Polygon lathe']) {
        await page.getByRole('button', { name }).click();
        await page.waitForFunction(() => {
          const [stage, scene] = ['.stage', '.stage svg.scene'].map((part) => document.querySelector(part).getBoundingClientRect());
          return scene.left <= stage.left + 1 && scene.right >= stage.right - 1 && scene.height <= stage.height + 1;
        });
      }
    }));
}

test('verdicts on a phone are between the drawing and the chart', () =>
  withPage(app, { viewport: { width: 390, height: 844 } }, async ({ page }) => {
    const [drawing, plot, cards] = [await box(page, '#machine'), await box(page, '.film .plot'), await box(page, '.cards')];
    assert.ok(drawing.y + drawing.height <= cards.y && cards.y + cards.height <= plot.y, JSON.stringify({ drawing, plot, cards }));
  }));

test('page opens playing, or at rest if motion is reduced', { skip: FIREFOX }, async () => {
  await withPage(app, { reducedMotion: 'no-preference' }, async ({ page }) => {
    await page.waitForFunction(() => document.querySelector('#clock').textContent > '00:00.0500');
    assert.equal(await page.locator('#play').getAttribute('aria-label'), 'Pause');
    assert.equal(await page.locator('.repeat').getAttribute('aria-pressed'), 'true');
  });
  await withPage(app, {}, async ({ page }) => {
    await page.evaluate(() => new Promise((done) => setTimeout(done, 300)));
    assert.equal(await clock(page), '00:00.0000');
    assert.equal(await page.locator('span.mode').textContent(), 'Ready');
  });
});

test('no message moves a control', () =>
  withPage(app, {}, async ({ page }) => {
    await openPanel(page);
    const next = '.field:has(#spindle-speed) + .field';
    const controls = ['#play', '#spindle-knob', '.lit.start', '.lit.hold', '#export', '#spindle-speed', next, '.chart-bar .chip'];
    const boxes = () => Promise.all(controls.map((selector) => page.locator(selector).first().boundingBox()));
    await page.locator('.panel').evaluate((panel) => Promise.all(panel.getAnimations().map((animation) => animation.finished)));
    const before = await boxes();
    for (const name of ['Spindle override −', 'Spindle override −', 'Feed override +', 'Feed hold']) {
      await page.getByRole('button', { name }).click();
      assert.deepEqual(await boxes(), before, name);
    }
    await page.fill('#spindle-speed', 'fast');
    await page.setInputFiles('#open', { name: 'a.json', mimeType: 'text/plain', buffer: Buffer.from('{"version":1,') });
    await page.locator('.notice').first().waitFor();
    assert.deepEqual(await boxes(), before);
    // The reason of a wrong entry covers the elements below it while its field has the focus or the pointer.
    await page.locator('#spindle-speed').focus();
    assert.ok(await page.locator('#spindle-speed-note').isVisible());
    await page.locator('#play').focus();
    await page.mouse.move(0, 0);
    assert.ok(!(await page.locator('#spindle-speed-note').isVisible()));
  }));

test('click on a block shows its time, second click goes there', () =>
  withPage(app, {}, async ({ page }) => {
    await page.getByRole('button', { name: 'O9101.nc' }).click();
    await page.locator('.listing li[data-l]', { hasText: 'N44 G01' }).click();
    assert.equal(await clock(page), '00:00.0000');
    await page.locator('.begins').click();
    await page.locator('.listing li[aria-current="step"]', { hasText: 'N44 G01' }).waitFor();
    const first = await clock(page);
    assert.ok(first > '00:00.5', first);
    await doubleClick(page.locator('.listing li[data-l]', { hasText: 'N50 M5' }));
    await page.waitForFunction((first) => document.querySelector('#clock').textContent > first, first);
  }));

test('a divider is moved by its keys and remembered', () =>
  withPage(app, {}, async ({ page }) => {
    const width = async () => Math.round((await box(page, '#form')).width);
    const before = await width();
    const divider = page.getByRole('separator', { name: 'Width of the form' });
    for (const _ of [1, 2, 3]) await divider.press('ArrowRight');
    assert.equal(await width(), before + 48);
    await page.reload();
    await ready(page);
    assert.equal(await width(), before + 48);
  }));

test('chart reads values at the pointer, press sets play head', () =>
  withPage(app, {}, async ({ page }) => {
    await page.locator('.plot .over').waitFor();
    await page.getByRole('button', { name: 'Axis speeds' }).click();
    await page.locator('.legend', { hasText: 'Y' }).waitFor();
    const { x, y, width } = await box(page, '.plot');
    await page.mouse.move(x + width / 2, y + 30);
    const [, told] = /^(\d+\.\d+) s {2}X 7.57[78] mm\/min {2}Y 7.57[78] mm\/min$/.exec(await page.locator('.pointed').textContent());
    await page.mouse.down();
    await page.mouse.up();
    // The readout has three decimals, the clock four.
    await page.waitForFunction((told) => Math.abs(document.querySelector('#clock').textContent.slice(3) - told) <= 0.0006, told);
  }));

test('the drawing is saved as SVG and as PNG', () =>
  withPage(app, {}, async ({ page }) => {
    for (const [kind, begins] of [['SVG', '<svg xmlns'], ['PNG', '\x89PNG']]) {
      await page.getByRole('button', { name: 'Save the drawing' }).click();
      const picture = await saved(page, () => page.getByRole('button', { name: kind, exact: true }).click());
      assert.ok(picture.toString('latin1').startsWith(begins), kind);
      await page.keyboard.press('Escape');
    }
  }));

test('a part of the drawing leads to its field', () =>
  withPage(app, {}, async ({ page }) => {
    const part = page.locator('.stage [data-field]').first();
    const field = await part.getAttribute('data-field');
    await part.dispatchEvent('click');
    await page.waitForFunction((field) => document.activeElement.id === field, field);
  }));

// Width and height in CSS pixels of a sheet without the margins of `@page` in style/report.css: of the first one, and of the others.
const pixels = (mm) => Math.floor((mm * 96) / 25.4);
const SHEETS = Object.entries({ A4: [210, 297], Letter: [215.9, 279.4] }).map(([format, [width, height]]) => ({
  format,
  first: { width: pixels(width), height: pixels(height - 8) },
  others: { width: pixels(width - 8 - 13 - 13 - 1), height: 900 },
}));

// Words of tables that break over two lines, except very long names and words with a hyphen; tables and drawings wider than the sheet.
function faultsOfTables() {
  const broken = [...document.querySelectorAll('td, th')].flatMap((cell) => {
    const texts = document.createTreeWalker(cell, NodeFilter.SHOW_TEXT);
    const found = [];
    for (let text; (text = texts.nextNode()); ) {
      for (const word of text.data.matchAll(/[A-Za-z0-9.,]+/g)) {
        const range = document.createRange();
        range.setStart(text, word.index);
        range.setEnd(text, word.index + word[0].length);
        const lines = new Set([...range.getClientRects()].map((box) => Math.round(box.top)));
        if (lines.size > 1 && word[0].length < 24 && !text.parentElement.matches('.name')) found.push(word[0]);
      }
    }
    return found;
  });
  const wide = [...document.querySelectorAll('.flow > *')].filter((part) => part.getBoundingClientRect().right > innerWidth + 1);
  return [...broken, ...wide.map((part) => `${part.tagName} ${part.className}`)];
}

test('report prints whole on A4 and Letter, wraps on a phone', () =>
  withPage(app, {}, async ({ page, context }) => {
    for (const name of [PAPER, 'Polygon lathe', 'Turning spindle']) {
      await (name === PAPER ? takeExample(page, name) : page.locator('.segments button', { hasText: name }).click());
      await page.click('#export');
      const row = page.getByRole('row', { name: /report\.html/ });
      const html = (await saved(page, () => row.getByRole('button').click())).toString('utf8');
      await page.keyboard.press('Escape');
      const report = await context.newPage();
      await report.setContent(html);
      await report.emulateMedia({ media: 'print' });
      for (const { format, first, others } of SHEETS) {
        await report.setViewportSize(first);
        const [needed, there] = await report.locator('.sheet').evaluate((sheet) => [sheet.scrollHeight, sheet.clientHeight]);
        assert.ok(needed <= there, `${name}, ${format}: ${needed} of ${there}`);
        assert.ok((await report.locator('.drawing').boundingBox()).height > 150, `${name}, ${format}`);
        await report.setViewportSize(others);
        assert.deepEqual(await report.evaluate(faultsOfTables), [], `${name}, ${format}`);
      }
      await report.emulateMedia({ media: 'screen' });
      await report.setViewportSize({ width: 390, height: 844 });
      const sheet = await report.locator('.sheet').evaluate((sheet) => [sheet.scrollWidth, sheet.clientWidth]);
      assert.ok(sheet[0] <= sheet[1], `${name}: ${sheet}`);
      for (const cell of await report.locator('.verdicts td:nth-child(2)').all()) assert.ok((await cell.boundingBox()).width > 120, name);
      await report.close();
    }
  }));
