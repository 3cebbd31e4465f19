// Five tasks of an engineer from a blank profile, with the greatest number of clicks for each.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { unzipSync } from 'fflate';
import { saved, start, withPage } from './page.mjs';

let app;
before(async () => (app = await start()));
after(() => app?.close());

// Runs a task on a fresh page and checks the number of its clicks.
const within = (clicks, act) =>
  withPage(app, {}, async ({ page }) => {
    // A choice in a list is a click as well.
    await page.evaluate(() => {
      window.clicks = 0;
      document.addEventListener('click', ({ detail }) => (window.clicks += detail === 1 ? 1 : 0), true);
      document.addEventListener('change', ({ target }) => (window.clicks += target.matches('select') ? 1 : 0), true);
    });
    await act(page);
    const made = await page.evaluate(() => window.clicks);
    assert.ok(made > 0 && made <= clicks, `${made} clicks`);
  });

const choose = async (page, text) => {
  await page.locator('select.control').click();
  await page.locator('select.control').selectOption({ label: text });
};

test('change the roller and read the consequence', () =>
  within(3, async (page) => {
    const card = page.locator('.card', { hasText: 'Roller : ribbon' });
    const before = await card.textContent();
    await page.locator('#print-roller-diameter').click();
    await page.keyboard.press('Control+a');
    await page.keyboard.type('120');
    await page.waitForFunction((before) => !document.body.textContent.includes(before), before);
    assert.match(await card.textContent(), /✕|▲/);
  }));

test('choose a control and take its files', () =>
  within(4, async (page) => {
    await choose(page, 'FANUC 0i-MF');
    await page.click('#export');
    await page.locator('#save-all').waitFor();
    const names = await page.locator('.exported th').allTextContents();
    const files = unzipSync(await saved(page, () => page.click('#save-all')));
    assert.deepEqual(Object.keys(files).sort(), names.sort());
    assert.ok(names.length > 5 && Object.values(files).every((bytes) => bytes.length > 0));
  }));

test('follow an advice', () =>
  within(1, async (page) => {
    // The advice is about a roller that does not match the ribbon; the click into its field is not part of the task.
    await page.locator('#print-roller-diameter').focus();
    await page.keyboard.press('Control+a');
    await page.keyboard.type('120');
    const card = page.locator('.card', { hasText: 'Roller : ribbon' });
    await card.getByRole('button', { name: /^Set Ø/ }).click();
    await page.locator('.card.ok', { hasText: 'Roller : ribbon' }).waitFor();
  }));

test('mend the paper’s listing', () =>
  within(3, async (page) => {
    await page.getByRole('button', { name: 'Paper’s listing' }).click();
    await page.locator('.mode', { hasText: 'Program error' }).waitFor();
    await page.getByRole('button', { name: /^Fix \d+ errors$/ }).click();
    await page.getByRole('button', { name: /^Take \d+ first proposals?$/ }).click();
    // It reads without an error; the missing values are found by the run.
    await page.waitForFunction(() => document.querySelector('.mode').textContent !== 'Program error');
  }));

test('find the block that runs at a time', () =>
  within(1, async (page) => {
    const { x, y, width } = await page.locator('.plot').boundingBox();
    await page.mouse.click(x + width / 2, y + 30);
    await page.locator('.listing li[aria-current="step"]').waitFor();
  }));
