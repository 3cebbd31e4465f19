// The page in inches: chosen by the user, typed and shown everywhere; the program stays in millimetres.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { MACHINES, accessible, enter, listing, openGroups, openPanel, ready, saved, start, withPage } from './page.mjs';
import { words } from './words.mjs';

let app;
before(async () => (app = await start()));
after(() => app?.close());

// Values of the control stay in millimetres: its variables and parameters, and the sentence about the word X in the program.
const OF_THE_CONTROL = ['tab-variables', 'tab-parameters'];

// Opens the page anew in the other units.
async function turnTo(page, name) {
  await Promise.all([page.waitForEvent('load'), page.locator('.doing .lengths', { hasText: name }).click()]);
  await ready(page);
}

// A header that has room for the choice of units; in a shorter one it is in help.
const WIDE = { width: 1600, height: 900 };

// Texts on the page with a number of millimetres or metres, except in programs and in values of the control (positions name their unit).
const metric = (page) =>
  page.evaluate(() => {
    const found = new Set();
    const texts = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    const control = '.listing, .lengths, .now, option, .panel, script, style, noscript';
    for (let text; (text = texts.nextNode()); ) {
      const place = text.parentElement;
      if (place.closest(control)) continue;
      const said = text.textContent.trim();
      if (said.includes('X20')) continue;
      if (/(\d[\s ]?|^)(mm|µm|m\/min|mm²|mm\/(min|rev|s|h))$/.test(said) || /\d[\s ](mm|µm|m\/min)\b/.test(said)) found.add(`${place.className?.baseVal ?? place.className}: ${said}`);
    }
    return [...found];
  });

test('inches chosen and typed leave the program in millimetres', () =>
  withPage(app, { viewport: WIDE }, async ({ page }) => {
    const field = page.locator('#pitch');
    const unit = page.locator('.field', { has: field }).locator('.unit');
    await enter(field, '25.4');
    await page.getByRole('button', { name: 'O9102.nc' }).click();
    await page.locator('.listing', { hasText: '#107=25.4' }).first().waitFor();
    const before = await listing(page);
    await turnTo(page, 'inch');
    assert.deepEqual([await field.inputValue(), await unit.textContent()], ['1', 'in']);
    await page.getByRole('button', { name: 'O9102.nc' }).click();
    assert.equal(await listing(page), before);
    await page.locator('.scene text', { hasText: 'every 1 in' }).first().waitFor({ state: 'attached' });
    await enter(field, '0.5');
    await page.locator('.scene text', { hasText: 'every 0.5 in' }).first().waitFor({ state: 'attached' });
    await page.locator('.listing', { hasText: '#107=12.7' }).first().waitFor();
    assert.match(await page.locator('.cards').innerText(), /in\/min/);
    await enter(field, '500');
    assert.match(await page.locator('#pitch-note').textContent(), /500 is too large.*393\.7008 in/);
    await enter(field, '0.5');
    await page.reload();
    await ready(page);
    assert.deepEqual([await field.inputValue(), await unit.textContent()], ['0.5', 'in']);
    const project = JSON.parse(await saved(page, () => page.getByRole('button', { name: 'Save', exact: true }).click()));
    assert.equal(project.values.pitch, 12.7);
    await turnTo(page, 'mm');
    assert.deepEqual([await field.inputValue(), await unit.textContent()], ['12.7', 'mm']);
  }));

for (const language of ['en', 'zh']) {
  const say = words(language);
  for (const name of MACHINES) {
    test(`no millimetre is left in inches (${name}, ${language})`, () =>
      withPage(app, { locale: language, viewport: WIDE }, async ({ page }) => {
        await page.getByRole('button', { name: say(name), exact: true }).click();
        await turnTo(page, say('page.inches'));
        await openGroups(page);
        await openPanel(page);
        for (const tab of await page.locator('[role=tab]:not(.gone)').all()) {
          if (OF_THE_CONTROL.includes(await tab.getAttribute('id'))) continue;
          await tab.click();
          await page.waitForTimeout(600);
          assert.deepEqual(await metric(page), [], await tab.textContent());
        }
        await accessible(page);
      }));
  }
}

test('the header has room for its buttons at every width', () =>
  withPage(app, {}, async ({ page }) => {
    for (const width of [1600, 1501, 1500, 1440, 1301, 1300, 1241, 1240, 1181, 1180, 1024, 390]) {
      await page.setViewportSize({ width, height: 800 });
      const right = await page.evaluate(() => Math.max(...[...document.querySelectorAll('.top button')].map((button) => button.getBoundingClientRect().right)));
      assert.ok(right <= width, `${right} of ${width}`);
    }
  }));
