// Legibility: no word and no figure is cut off or covered, at every size, in every language.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { covered } from './covered.mjs';
import { MACHINES, PAPER, openGroups, openSizing, openPanel, ready, start, takeExample, withPage } from './page.mjs';
import { words } from './words.mjs';

let app;
before(async () => (app = await start()));
after(() => app?.close());

const SIZES = {
  en: [[1440, 900], [1366, 768], [1280, 720], [1024, 768], [720, 450], [390, 844], [320, 640]],
  zh: [[1366, 768], [1024, 768], [390, 844], [320, 640]],
};
// In inches figures are a digit or two longer.
const IN_INCHES = { en: [[1440, 900], [1024, 768], [390, 844], [320, 640]], zh: [[1366, 768], [390, 844]] };

// Words that reach beyond a clipping element: box, button, window. Exempt are the running block and the name of the project, which may be
// longer than their places, the title of a chart, which is on its chip too, and elements that scroll sideways.
const cutOff = (page, places = '.top, .product, .cards, .keys, .chart, .now, .panel, .mode') =>
  page.evaluate((places) => {
    const free = '.hidden, h1, .where, .project, select, .percents, figcaption > span:first-child, .listing, .tabs, .told thead, :is(.ways, .variants) .scroll';
    const faults = [];
    const texts = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    for (let text; (text = texts.nextNode()); ) {
      const parent = text.parentElement;
      if (!text.textContent.trim() || !parent.closest(places) || parent.closest(free) || !parent.checkVisibility()) continue;
      const range = document.createRange();
      range.selectNodeContents(text);
      const own = range.getBoundingClientRect();
      for (let box = parent; box && own.width > 0; box = box.parentElement) {
        const clips = box.tagName === 'BUTTON' || box === document.documentElement || getComputedStyle(box).overflowX !== 'visible';
        const { left, right } = box.getBoundingClientRect();
        if (!clips || (own.left >= left - 1 && own.right <= right + 1)) continue;
        faults.push(`“${text.textContent.trim()}” in ${box.className || box.tagName}`);
        break;
      }
    }
    // A list shows only its chosen word: compare it with the width of a list of that word alone.
    for (const list of document.querySelectorAll('select.speed, select.control')) {
      const alone = list.cloneNode();
      alone.append(list.selectedOptions[0].cloneNode(true));
      alone.style.setProperty('position', 'absolute');
      alone.style.setProperty('width', 'max-content');
      alone.style.setProperty('max-width', 'none');
      list.parentElement.append(alone);
      const { left, right, width } = list.getBoundingClientRect();
      if (alone.getBoundingClientRect().width > width + 1 || left < 0 || right > innerWidth) faults.push(`“${list.selectedOptions[0].text}”`);
      alone.remove();
    }
    return faults;
  }, places);

async function legible(page, about) {
  await page.waitForTimeout(300);
  assert.deepEqual([...(await cutOff(page)), ...(await covered(page))], [], about);
}

const atEnd = async (page) => {
  await page.waitForFunction(() => !document.querySelector('.film progress') && Number(document.getElementById('head').max) > 5000);
  await page.locator('#head').evaluate((head) => {
    head.value = head.max;
    head.dispatchEvent(new Event('input', { bubbles: true }));
  });
};

const each = (lengths, all) => Object.entries(all).flatMap(([locale, sizes]) => sizes.map(([width, height]) => ({ lengths, locale, width, height })));

for (const { lengths, locale, width, height } of [...each('mm', SIZES), ...each('inch', IN_INCHES)]) {
  test(`no cut text (${locale}, ${lengths}, ${width} × ${height})`, () =>
    withPage(app, { viewport: { width, height }, locale }, async ({ page }) => {
      if (lengths === 'inch') {
        await page.evaluate(() => localStorage.setItem('macroline.lengths', 'inch'));
        await page.reload();
        await ready(page);
      }
      for (const name of MACHINES.map(words(locale))) {
        await page.getByRole('button', { name, exact: true }).click();
        await legible(page, name);
        await atEnd(page);
        await legible(page, `${name} at the end`);
        await openPanel(page);
        await legible(page, `${name} with the panel`);
        await page.click('#panel-fold');
      }
    }));
}

// Parts beside the drawing whose content is wider than they are: clipped content counts too.
const scrollsSideways = (page) =>
  page.evaluate(() => [...document.querySelectorAll('.form, .side > .body')].filter((part) => part.checkVisibility() && part.scrollWidth > part.clientWidth).map((part) => `${part.className}: ${part.scrollWidth}`));

const BESIDE = { en: [[1440, 900], [1366, 768], [1280, 720], [1024, 768], [390, 844]], zh: [[1366, 768], [390, 844]] };
for (const { locale, width, height } of each('mm', BESIDE)) {
  test(`form and tabs are whole (${locale}, ${width} × ${height})`, () =>
    withPage(app, { viewport: { width, height }, locale }, async ({ page }) => {
      for (const name of MACHINES.map(words(locale))) {
        await page.getByRole('button', { name, exact: true }).click();
        for (const tab of ['results', 'sizing', 'explore', 'variables', 'parameters', 'plc']) {
          if (!(await page.locator(`#tab-${tab}`).isVisible())) continue;
          await page.click(`#tab-${tab}`);
          await page.waitForTimeout(300);
          await openGroups(page);
          if (tab === 'sizing') await openSizing(page);
          await page.waitForTimeout(300);
          assert.deepEqual([...(await cutOff(page, '.side, .form')), ...(await scrollsSideways(page))], [], `${name}, ${tab}`);
        }
      }
    }));
}

for (const [width, height] of [[1440, 900], [1366, 768], [1024, 768], [390, 844]]) {
  test(`repairs leave their verdicts legible (${width} × ${height})`, () =>
    withPage(app, { viewport: { width, height } }, async ({ page }) => {
      await takeExample(page, PAPER);
      await page.locator('.repair').first().waitFor();
      await legible(page, 'E60');
      await page.selectOption('select.control', 'gsk-980tdc');
      await page.locator('.alarm-screen').waitFor();
      assert.deepEqual(await cutOff(page), []);
      // A drawing that pans fills its room; any other leaves the band of the alarm free.
      if (!(await page.locator('.stage.pans').count())) await legible(page, '980TDc');
    }));
}

test('page uses one letter family and one figure family', () =>
  withPage(app, {}, async ({ page }) => {
    for (const tab of ['program', 'results', 'variables', 'parameters', 'plc']) {
      await page.click(`#tab-${tab}`);
      const families = await page.evaluate(() => [
        ...new Set([...document.querySelectorAll('body *:not(svg *)')].filter((one) => one.checkVisibility()).map((one) => getComputedStyle(one).fontFamily)),
      ]);
      assert.ok(families.length <= 2, families.join('\n'));
    }
  }));
