// Sizing a polygon lathe: the preset, the run in which flats appear, the explorer, the drawings of an export.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { accessible, goTo, line, openGroups, saved, start, withPage } from './page.mjs';

let app;
before(async () => (app = await start()));
after(() => app?.close());

const named = (page, within, label) => page.locator(`${within} .card`).filter({ has: page.locator('.k', { hasText: label }) });
const card = async (page, label) => (await named(page, '.cards', label).textContent()).replace(/\s/g, '');
const lathe = (act, options = {}) =>
  withPage(app, options, async ({ page }) => {
    await page.getByRole('button', { name: 'Polygon lathe' }).click();
    await line(page, 'G512').waitFor();
    await openGroups(page);
    await act(page);
  });
// Elements wider than their place in the tab, by name.
const tooWide = (page) =>
  page.locator('#side .scroll').evaluateAll((all) => all.filter((each) => each.scrollWidth > each.clientWidth).map((each) => each.ariaLabel));
const drag = (page, id, value) =>
  page.locator(`#explore-${id}`).evaluate((slider, value) => {
    slider.value = value;
    slider.dispatchEvent(new Event('input', { bubbles: true }));
  }, value);
const drop = (page, id) => page.locator(`#explore-${id}`).dispatchEvent('change');

test('paper square: B200 D1 Q2, two inserts; presets change shape', () =>
  lathe(async (page) => {
    await line(page, 'G512 B200. D1 Q2').waitFor();
    assert.match(await card(page, 'Sides'), /Sides4/);
    assert.match(await card(page, 'Across flats'), /20\.00mm/);
    assert.match(await card(page, 'Flatness'), /0\.0284mm/);
    await page.selectOption('#shape', 'hexagon');
    await page.waitForFunction(() => /Sides6/.test(document.querySelector('.cards').textContent.replace(/\s/g, '')));
    await page.selectOption('#shape', 'triangle');
    await line(page, 'D2 Q3').waitFor();
    await accessible(page);
  }));

test('work and tool keep their ratio, flats appear pass by pass', () =>
  lathe(async (page) => {
    const outline = () => page.locator('.stage [data-n="0"]').getAttribute('d');
    const at = async (t) => {
      const before = await outline();
      await goTo(page, t);
      await page.waitForFunction((d) => document.querySelector('.stage [data-n="0"]').getAttribute('d') !== d, before);
      return outline();
    };
    const round = await outline();
    assert.notEqual(await at(6), round, 'the first pass cuts');
    const texts = await page.locator('.stage text').allTextContents();
    assert.ok(texts.includes('200.0 r/min') && texts.includes('400.0 r/min'), String(texts));
    await at(50);
    assert.ok((await page.locator('.stage text').allTextContents()).includes('4 / 4'));
    // The end is reported over the lower edge of the stage: no control moves.
    const play = await page.locator('#play').boundingBox();
    await goTo(page, 500);
    const why = page.locator('.why', { hasText: /./ });
    await why.waitFor();
    const [told, stage] = [await why.boundingBox(), await page.locator('.drawing').boundingBox()];
    assert.ok(told.y >= stage.y + 0.8 * stage.height && told.y + told.height <= stage.y + stage.height, JSON.stringify({ told, stage }));
    assert.deepEqual(await page.locator('#play').boundingBox(), play);
  }));

test('drag previews the shape, release sets it, click takes a way', () =>
  lathe(async (page) => {
    await page.click('#tab-explore');
    await page.locator('.shape svg').waitFor();
    const section = () => page.locator('.shape svg').innerHTML();
    const sides = () => named(page, '#side', 'Sides').textContent();
    const square = await section();
    await drag(page, 'inserts', 3);
    assert.notEqual(await section(), square);
    assert.match(await sides(), /6.*exactly 4/);
    // The form has not changed yet.
    assert.equal(await page.locator('#shape').inputValue(), 'square');
    await drop(page, 'inserts');
    await page.waitForFunction(() => document.querySelector('#shape').value === 'own');
    assert.equal(await page.locator('#inserts').inputValue(), '3');
    assert.match(await card(page, 'Sides'), /Sides6.*exactly4/);
    await drag(page, 'sides', 6);
    await drop(page, 'sides');
    const best = page.locator('[data-entries*="sides=6"]', { hasText: 'none' }).first();
    await best.waitFor();
    await accessible(page);
    // The other ways show their drawbacks.
    await page.locator('[data-entries*="sides=6"]', { hasText: 'the sides are not flat enough' }).first().waitFor();
    // The best way is already set: choose another one.
    const other = page.locator('[data-entries*="sides=6"]:not([data-entries*="inserts=3;"])').first();
    const [, inserts] = /inserts=(\d+)/.exec(await other.getAttribute('data-entries'));
    await other.getByRole('button').click();
    await page.waitForFunction((inserts) => document.querySelector('#inserts').value === inserts, inserts);
    assert.match(await card(page, 'Sides'), /Sides6.*exactly6/);
    await page.keyboard.press('Control+z');
    await page.keyboard.press('Control+z');
    await page.keyboard.press('Control+z');
    assert.equal(await page.locator('#shape').inputValue(), 'square');
  }));

test('sheets, ladder, native part are shown; export has drawings', () =>
  lathe(async (page) => {
    await page.click('#tab-plc');
    for (const text of ['G360.6', 'Sequence from G512 to G502', 'G51.2']) await page.locator('#side', { hasText: text }).waitFor();
    // The drawings are above their lists.
    for (const name of [/Sequence from G512 .* reconstructed/, /PMC program .* reconstructed/]) {
      const drawn = page.getByRole('img', { name });
      await drawn.waitFor();
      const [inner, side] = [await drawn.locator('svg').boundingBox(), await page.locator('#side').boundingBox()];
      assert.ok(inner.width <= side.width && inner.width > 0.9 * side.width, `${inner.width} of ${side.width}`);
    }
    await accessible(page);
    await page.locator('#side summary').click();
    await page.getByRole('cell', { name: 'WRT G360.6' }).waitFor();
    assert.deepEqual(await tooWide(page), []);
    await page.click('#tab-parameters');
    await page.locator('#side', { hasText: '4120' }).waitFor();
    assert.deepEqual(await tooWide(page), []);
    await accessible(page);
    await page.click('#export');
    const file = async (name) => {
      const row = page.getByRole('row', { name });
      return (await saved(page, () => row.getByRole('button').click())).toString('utf8');
    };
    assert.match(await file(/section\.svg/), /<svg[^]*mm/);
    assert.match(await file(/section\.dxf/), /SECTION[^]*PART/);
    assert.match(await file(/sequence\.svg/), /polygon turning on/);
  }));

test('another machine has no explorer, and the tab is left', () =>
  lathe(async (page) => {
    await page.click('#tab-explore');
    await page.getByRole('button', { name: 'Ribbon line' }).click();
    await page.locator('#pitch').waitFor();
    assert.equal(await page.locator('#tab-explore').isVisible(), false);
    assert.equal(await page.locator('#tab-program').getAttribute('aria-selected'), 'true');
  }));
