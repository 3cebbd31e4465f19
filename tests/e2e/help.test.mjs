// Help: the meaning of an alarm within two clicks, search, links from the page, both languages, the phone, and the tour.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { PAPER, accessible, start, takeExample, withPage } from './page.mjs';
import { words } from './words.mjs';

let app;
before(async () => (app = await start()));
after(() => app?.close());

const say = words('en');
const focused = (page) => page.evaluate(() => document.activeElement.id);
const arrives = (page, id) => page.waitForFunction((id) => document.activeElement.id === `help-${id}`, id);

test('the meaning of an alarm on the screen of the control is one click away', () =>
  withPage(app, {}, async ({ page, requests }) => {
    assert.ok(!requests.some((request) => request.includes('help-')), 'help is loaded at the opening of the page');
    await page.selectOption('select.control', 'gsk-980tdc');
    await takeExample(page, PAPER);
    await page.locator('.alarm-screen .more').click();
    await arrives(page, 'alarm.5900');
    assert.match(await page.locator('#help-alarm\\.5900').innerText(), /The program raises this alarm itself/);
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

test('the help of a field leads to its entry, and from there to a result and back', () =>
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

test('the manual of the machine has its drawing, its parts and its steps', () =>
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
