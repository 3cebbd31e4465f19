// Direct answers of the page: words show their meaning, results their cause, numbers are dragged, the chart zooms; drawings keep their
// labels at every size.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { measureInk } from './covered.mjs';
import { FIREFOX, PAPER, accessible, doubleClick, saved, showSteps, start, takeExample, withPage } from './page.mjs';

let app;
before(async () => (app = await start()));
after(() => app?.close());

const box = (page, selector) => page.locator(selector).first().boundingBox();
const open = (page) => page.locator('#meaning:popover-open');
const THEMES = ['light', 'dark'];

test('listing word shows meaning, value and source, moves nothing', () =>
  withPage(app, {}, async ({ page }) => {
    await page.getByRole('button', { name: 'O9101.nc' }).click();
    const before = await Promise.all(['#play', '.listing', '#export'].map((selector) => box(page, selector)));
    await page.locator('.listing .t-g', { hasText: 'G01' }).first().hover();
    await open(page).waitFor();
    assert.match(await open(page).textContent(), /^G1 .*linear|interpolation/i);
    assert.match(await page.locator('#meaning .source').textContent(), / · /);
    assert.deepEqual(await Promise.all(['#play', '.listing', '#export'].map((selector) => box(page, selector))), before);
    await page.keyboard.press('Escape');
    await open(page).waitFor({ state: 'detached' });
    await page.locator('.listing li', { hasText: 'N44 G01' }).click();
    await page.locator('.listing').focus();
    await page.keyboard.press('Enter');
    await page.keyboard.press('ArrowRight');
    await page.keyboard.press('ArrowRight');
    assert.match(await open(page).textContent(), /^X/);
    await accessible(page);
  }));

test('a variable and a position have their meaning by a tap', { skip: FIREFOX && 'its driver has no touch' }, () =>
  withPage(app, { hasTouch: true, viewport: { width: 390, height: 844 } }, async ({ page }) => {
    await page.locator('.now dt').first().tap();
    await open(page).waitFor();
    assert.match(await open(page).textContent(), /^X.*Position along axis X/);
  }));

test('a result shows the parts and fields that it depends on', () =>
  withPage(app, {}, async ({ page }) => {
    await page.getByRole('button', { name: /Line speed/ }).hover();
    await page.locator('.scene .cause[data-field="press-roller-diameter"]').first().waitFor();
    const fields = await page.locator('.field.cause').evaluateAll((rows) => rows.map((row) => row.querySelector('input[id], select').id));
    assert.ok(fields.includes('press-roller-diameter') && !fields.includes('loop-capacity'), `${fields}`);
    await page.mouse.move(5, 400);
    await page.locator('.scene .cause').first().waitFor({ state: 'detached' });
  }));

test('repair makes failing results hold, one undo restores them', () =>
  withPage(app, {}, async ({ page }) => {
    await takeExample(page, PAPER);
    await page.getByRole('tab', { name: /Results/ }).click();
    const failing = page.locator('.result.fail');
    await page.locator('.repairs').getByText('9 results fail').waitFor();
    assert.equal(await failing.count(), 9);
    await page.locator('.repairs').getByRole('button', { name: 'Repair', exact: true }).click();
    // Several ways, each with its consequences.
    const way = page.locator('.ways-out li', { hasText: 'Set Print heads to 47' }).first();
    await way.getByText(/Roller : ribbon speed 7\.850 → 1\.00/).waitFor();
    assert.ok((await page.locator('.ways-out li').count()) > 1);
    await accessible(page);
    await way.getByRole('button').click();
    await page.locator('.notices', { hasText: 'No result fails now: Add a dancer; Set Loop capacity to 1710 mm' }).waitFor();
    await page.locator('.repairs').waitFor({ state: 'detached' });
    assert.equal(await failing.count(), 0);
    assert.equal(await page.locator('#pitch').inputValue(), '8');
    await page.getByRole('button', { name: /^Undo/ }).click();
    await page.locator('.repairs').waitFor();
    assert.equal(await failing.count(), 9);
  }));

test('dragging a name changes its number, one undo restores it', () =>
  withPage(app, {}, async ({ page }) => {
    const { x, y } = await box(page, 'label[for=pitch]');
    await page.mouse.move(x + 10, y + 8);
    await page.mouse.down();
    await page.mouse.move(x + 20, y + 8, { steps: 3 });
    await page.mouse.move(x + 90, y + 8, { steps: 12 });
    await page.mouse.up();
    assert.ok(Number(await page.inputValue('#pitch')) > 11, await page.inputValue('#pitch'));
    await page.keyboard.press('Control+z');
    assert.equal(await page.inputValue('#pitch'), '10');
  }));

test('chart zooms about the pointer and marks milestones', () =>
  withPage(app, {}, async ({ page }) => {
    await page.locator('.event', { hasText: 'first dot' }).waitFor();
    const span = () => page.locator('#head').evaluate((head) => head.max - head.min);
    const whole = await span();
    const { x, y, width } = await box(page, '.plot');
    await page.mouse.move(x + width / 2, y + 40);
    await page.mouse.wheel(0, -200);
    await page.waitForFunction((whole) => document.querySelector('#head').max - document.querySelector('#head').min < 0.7 * whole, whole);
    await doubleClick(page.locator('.plot'));
    await page.waitForFunction((whole) => document.querySelector('#head').max - document.querySelector('#head').min === whole, whole);
  }));

// Visible labels and marks, with their boxes.
async function texts(page, selector) {
  await measureInk(page);
  return page.locator(selector).evaluateAll((all) =>
    all
      .filter((text) => text.textContent.trim() && text.checkVisibility({ visibilityProperty: true, opacityProperty: true }))
      .map((text) => ({ words: text.textContent, ...inked(text) })),
  );
}

function apart(all, about) {
  for (const [at, a] of all.entries()) {
    for (const b of all.slice(at + 1)) {
      const meet = a.left < b.right - 1 && b.left < a.right - 1 && a.top < b.bottom - 1 && b.top < a.bottom - 1;
      assert.ok(!meet, `${about}: ${JSON.stringify(a)} lies on ${JSON.stringify(b)}`);
    }
  }
}

for (const [width, height] of [[1440, 900], [1366, 768], [1024, 768], [720, 450], [390, 844]]) {
  test(`labels are 13 px, apart and whole (${width} × ${height})`, () =>
    withPage(app, { viewport: { width, height } }, async ({ page }) => {
      for (const machine of ['Ribbon line', 'Turning spindle', 'Polygon lathe']) {
        await page.getByRole('button', { name: machine, exact: true }).click();
        await page.locator('.event').first().waitFor({ state: 'attached' });
        await page.evaluate(() => {
          dispatchEvent(new Event('resize'));
          return new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
        });
        const labels = await texts(page, '.stage .label, .stage .value');
        assert.ok(labels.length >= 8, `${machine}: ${labels.map(({ words }) => words)}`);
        for (const { words, size } of labels) assert.ok(Math.abs(size - 13) < 0.2, `${machine}: ${words} has ${size} px`);
        apart(labels, machine);
        apart(await texts(page, '.event'), machine);
        assert.ok(await page.locator('.plots .plot').isVisible(), 'the chart');
        const wide = await page.evaluate(() => document.documentElement.scrollWidth);
        assert.ok(wide <= width, `${machine}: the page is ${wide} px wide`);
        if (width < 500) {
          const header = await box(page, '.top');
          assert.ok(header.height <= 92, `the header is ${header.height} px high`);
          const last = page.locator('.stations .chip').last();
          await last.click();
          assert.ok(await page.locator('.stage').evaluate((stage) => stage.scrollLeft > 0));
        }
      }
    }));
}

test('play is reached within ten tabs on a fresh page', () =>
  withPage(app, {}, async ({ page }) => {
    for (let presses = 1; presses <= 10; presses += 1) {
      await page.keyboard.press('Tab');
      const at = await page.evaluate(() => document.activeElement.id || document.activeElement.className);
      if (at === 'skip') await page.keyboard.press('Enter');
      if (at === 'play') return;
    }
    assert.fail('play is further than ten tabs');
  }));

test('drawing is recorded as a clip, recording can be cancelled', () =>
  withPage(app, {}, async ({ page }) => {
    const begin = async () => {
      await page.getByRole('button', { name: 'Save the drawing' }).click();
      await page.getByRole('button', { name: /^Clip/ }).click();
      await page.getByRole('progressbar', { name: 'Recording the clip' }).waitFor();
    };
    await begin();
    await page.getByRole('button', { name: 'Cancel', exact: true }).click();
    await page.locator('.clip').waitFor({ state: 'detached' });
    const bytes = await saved(page, begin);
    assert.equal(bytes.subarray(0, 4).toString('hex'), '1a45dfa3');
    assert.ok(bytes.length > 10_000, `${bytes.length} bytes`);
  }));

for (const colorScheme of THEMES) {
  test(`popovers, menus and editor are accessible (${colorScheme})`, () =>
    withPage(app, { colorScheme }, async ({ page }) => {
      await page.locator('.about').first().click();
      await accessible(page);
      await page.keyboard.press('Escape');
      await page.getByRole('button', { name: 'Save the drawing' }).click();
      await accessible(page);
      await page.keyboard.press('Escape');
      await showSteps(page);
      await accessible(page);
      await page.getByRole('button', { name: 'Edit', exact: true }).click();
      await page.locator('.cm-content').waitFor();
      await page.locator('.cm-content').click();
      await page.keyboard.press('Control+f');
      await accessible(page);
      await page.keyboard.press('Escape');
      await page.keyboard.press('Control+End');
      await page.keyboard.type('\nG999 X1 (');
      await page.locator('.cm-lintRange').first().waitFor();
      await page.locator('.cm-lintRange').first().hover();
      await page.locator('.cm-tooltip').first().waitFor();
      await accessible(page);
    }));
}
