// Help: the meaning of an alarm within two clicks, search, links from the page, both languages, the phone, and the tour.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { FIREFOX, PAPER, accessible, start, takeExample, withPage } from './page.mjs';
import { words } from './words.mjs';

let app;
before(async () => (app = await start()));
after(() => app?.close());

const say = words('en');
const focused = (page) => page.evaluate(() => document.activeElement.id);
const arrives = (page, id) => page.waitForFunction((id) => document.activeElement.id === `help-${id}`, id);

test('alarm on the control screen leads to help', () =>
  withPage(app, {}, async ({ page, requests }) => {
    assert.ok(!requests.some((request) => request.includes('help-')), 'help is loaded at the opening of the page');
    await page.selectOption('select.control', 'gsk-980tdc');
    await takeExample(page, PAPER);
    const [, number, text] = (await page.locator('.alarm-screen h2').innerText()).match(/(\d+) (.+)/);
    await page.locator('.alarm-screen .unfold').click();
    await page.locator('.alarm-screen .more').click();
    await arrives(page, `alarm.${number}`);
    const entry = await page.locator(`#help-alarm\\.${number}`).innerText();
    assert.ok(entry.includes(text) && entry.includes(`#3000=${Number(number) - 5900}(`), entry);
  }));

test('search finds an alarm by its number, and Enter opens it', () =>
  withPage(app, {}, async ({ page }) => {
    await page.keyboard.press('F1');
    await page.waitForFunction(() => document.querySelector('#help-page h3'));
    assert.equal(await focused(page), 'help-search');
    await page.keyboard.type('P283');
    await page.locator('.hits b', { hasText: 'P283' }).first().waitFor();
    await accessible(page);
    await page.keyboard.press('Enter');
    await arrives(page, 'alarm.P283');
    await accessible(page);
    await page.locator('.find .back').click();
    await page.locator('#help-use').waitFor();
  }));

test('field help leads to its entry, to a result and back', () =>
  withPage(app, {}, async ({ page }) => {
    await page.locator('.about').first().click();
    await page.locator('#about').getByRole('button', { name: say('help.more') }).click();
    await page.waitForFunction(() => document.activeElement.id.startsWith('help-field.'));
    const field = await focused(page);
    await page.locator(`[id="${field}"] [data-help*="result."]`).first().click();
    await page.waitForFunction(() => document.activeElement.id.startsWith('help-result.'));
    await page.locator('.find .back').click();
    await page.waitForFunction((field) => document.activeElement.id === field, field);
  }));

test('machine manual has its drawing, parts and steps', () =>
  withPage(app, {}, async ({ page }) => {
    await page.keyboard.press('?');
    await page.locator('.help-body nav button').first().click();
    const drawing = page.locator('#help-parts img');
    await drawing.waitFor();
    assert.ok(await drawing.evaluate(async (image) => (await image.decode(), image.naturalWidth > 0)));
    assert.ok((await page.locator('#help-parts .parts li').count()) > 5);
    assert.ok((await page.locator('#help-commissioning .steps li').count()) > 5);
  }));

test('Chinese help is found by Chinese words', () =>
  withPage(app, { locale: 'zh-CN' }, async ({ page }) => {
    const chinese = words('zh');
    await page.keyboard.press('/');
    await page.locator('#help-search').fill('活套');
    await page.locator('.hits b', { hasText: '活套' }).first().waitFor();
    await page.locator('.hits button').first().click();
    await page.getByRole('dialog').getByRole('button', { name: chinese('page.close') }).click();
    assert.equal(await page.locator('dialog[open]').count(), 0);
  }));

// Pages of a document, each with its width in points.
const papers = (pdf) => [...pdf.toString('latin1').matchAll(/\/Type\s*\/Page\b[^]*?\/MediaBox\s*\[0 0 ([\d.]+)/g)].map(([, width]) => Math.round(width));

for (const [locale, colorScheme] of [['en', 'dark'], ['zh-CN', 'light']])
  test(`open help page prints alone and whole, ${locale}`, () =>
    withPage(app, { locale, colorScheme }, async ({ page }) => {
      const said = words(locale.slice(0, 2));
      await page.evaluate(() => (window.print = () => (document.title = 'printed')));
      await page.keyboard.press('?');
      await page.locator('.help-body nav button').first().click();
      await page.locator('#help-parts .parts').waitFor();
      await page.getByRole('dialog').getByRole('button', { name: said('help.print'), exact: true }).click();
      assert.equal(await page.title(), 'printed');
      if (FIREFOX) return;
      await page.emulateMedia({ media: 'print' });
      const shown = (selector) => page.locator(selector).filter({ visible: true }).count();
      assert.equal(await shown('main, .top, dialog > header, .find, .help-body nav, .help-page .contents, .choices'), 0);
      assert.equal(await shown('#help-parts img'), 1);
      assert.ok((await shown('#help-page-title, #help-page h3, #help-page article, .source')) > 100);
      const cut = await page.evaluate(() => [...document.querySelectorAll('dialog.help, #help-page')].filter((one) => one.scrollHeight > one.clientHeight + 1).length);
      assert.equal(cut, 0, 'a part of help is cut off');
      assert.equal(await page.evaluate(() => getComputedStyle(document.documentElement).colorScheme), 'light');
      for (const [format, width] of [['A4', 595], ['Letter', 612]]) {
        const found = papers(await page.pdf({ format }));
        assert.ok(found.length > 10 && found.every((one) => Math.abs(one - width) <= 1), `${format}: ${found}`);
      }
    }));

test('help fits a phone', () =>
  withPage(app, { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true }, async ({ page }) => {
    await page.getByRole('button', { name: say('page.help'), exact: true }).click();
    await page.locator('#help-rules').waitFor();
    const wide = await page.evaluate(() => [...document.querySelectorAll('dialog.help, #help-page')].map((one) => one.scrollWidth - one.clientWidth));
    assert.ok(wide.every((more) => more <= 1), `wider than its place: ${wide}`);
    await accessible(page);
  }));

test('the tour has three steps, by keys alone', () =>
  withPage(app, {}, async ({ page }) => {
    await page.keyboard.press('?');
    await page.locator('.tour-start').click();
    for (const part of ['centre', 'form', 'side']) {
      await page.locator(`.${part}[data-tour]`).waitFor();
      await accessible(page);
      await page.keyboard.press('Enter');
    }
    assert.equal(await page.locator('.tour, [data-tour], [data-new]').count(), 0);
  }));
