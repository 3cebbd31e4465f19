// The page in Chinese: chosen by the browser or by the user, without an English sentence, and a change of language loses nothing.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { MACHINES, accessible, enter, openGroups, openPanel, ready, saved, showSteps, start, withPage } from './page.mjs';
import { words } from './words.mjs';

let app;
before(async () => (app = await start()));
after(() => app?.close());

const say = words('zh');
const zh = { locale: 'zh-CN' };

// Texts, names and titles on the page that have two English words in a row. Programs and quotations of them may be English.
const english = (page) =>
  page.evaluate(() => {
    const found = new Set();
    const check = (text) => /[a-z]{3,} [a-z]{3,}/.test(text.replace(/“[^”]*”/g, '')) && found.add(text.trim());
    const texts = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    for (let text; (text = texts.nextNode()); ) if (!text.parentElement.closest('code, pre, .cm-editor, script, style, noscript')) check(text.textContent);
    for (const one of document.querySelectorAll('body *')) ['aria-label', 'title', 'placeholder', 'alt'].forEach((name) => check(one.getAttribute(name) ?? ''));
    return [...found];
  });

async function chinese(page, about) {
  await page.waitForTimeout(200);
  assert.deepEqual(await english(page), [], about);
}

test('browser sets the language, user changes it, project stays', () =>
  withPage(app, zh, async ({ page }) => {
    assert.equal(await page.locator('html').getAttribute('lang'), 'zh');
    assert.ok(await page.getByRole('button', { name: say('ribbon.name') }).isVisible());
    await enter(page.locator('#pitch'), '8');
    await page.getByRole('button', { name: 'English' }).click();
    await page.waitForFunction(() => document.documentElement.lang === 'en');
    await ready(page);
    assert.equal(await page.locator('#pitch').inputValue(), '8');
    assert.ok(await page.getByRole('button', { name: 'Ribbon line' }).isVisible());
    await page.reload();
    await ready(page);
    assert.equal(await page.locator('html').getAttribute('lang'), 'en');
    await page.getByRole('button', { name: '中文' }).click();
    await page.waitForFunction(() => document.documentElement.lang === 'zh');
    await ready(page);
    assert.equal(await page.locator('#pitch').inputValue(), '8');
  }));

for (const name of MACHINES) {
  test(`no English is left on the page (${name})`, () =>
    withPage(app, zh, async ({ page }) => {
      await page.getByRole('button', { name: say(name), exact: true }).click();
      await openGroups(page);
      await openPanel(page);
      const controls = await page.locator('select.control option').evaluateAll((all) => all.map((one) => one.value));
      for (const control of controls) {
        await page.selectOption('select.control', control);
        for (const tab of await page.locator('[role=tab]:not(.gone)').all()) {
          await tab.click();
          // The sheets come from the worker.
          await page.waitForFunction(() => ![...document.querySelectorAll('.side [aria-busy=true]')].some((one) => one.checkVisibility()));
          await chinese(page, `${control}, ${await tab.textContent()}`);
        }
      }
      await accessible(page);
    }));
}

test('no English is left in dialogs, findings and steps', () =>
  withPage(app, zh, async ({ page }) => {
    const press = (id) => page.getByRole('button', { name: say(id), exact: true }).first().click();
    for (const id of ['page.new', 'page.help', 'page.share', 'page.export-short']) {
      await press(id);
      await page.locator('dialog[open]').waitFor();
      await chinese(page, id);
      await accessible(page);
      await page.keyboard.press('Escape');
    }
    await press('page.paper');
    await page.locator('.mode', { hasText: say('page.mode-errors') }).waitFor();
    await chinese(page, 'findings');
    await showSteps(page, say);
    await chinese(page, 'steps');
  }));

test('the report is Chinese', () =>
  withPage(app, zh, async ({ page }) => {
    await page.click('#export');
    const row = page.locator('.exported tr', { hasText: 'report.html' });
    const report = String(await saved(page, () => row.getByRole('button').first().click()));
    assert.match(report, /<html lang="zh">/);
    const text = report.replace(/<(style|script|pre|code|svg)[\s\S]*?<\/\1>/g, ' ').replace(/<[^>]*>/g, '\n');
    assert.deepEqual(text.split('\n').filter((line) => /[a-z]{3,} [a-z]{3,}/.test(line)), []);
  }));
