// Comments of the program in Chinese: chosen where the control can show them, exported in its encoding, and read back.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { unzipSync } from 'fflate';
import { accessible, enter, listing, saved, start, withPage } from './page.mjs';
import { words } from './words.mjs';

let app;
before(async () => (app = await start()));
after(() => app?.close());

const say = words('en');
const tab = (page, at) => page.getByRole('tab').nth(at).click();

// Sets the characters that comments can have.
async function characters(page, setting) {
  await tab(page, 4);
  await page.getByLabel(say('switch.comment-characters'), { exact: true }).selectOption(setting);
}

test('Chinese comments export in GBK and restore the form', () =>
  withPage(app, {}, async ({ page }) => {
    const language = page.getByLabel(say('page.comments'), { exact: true });
    await tab(page, 4);
    assert.equal(await page.getByLabel(say('switch.comment-characters')).count(), 0, 'nothing is known of this control');
    await page.selectOption('select.control', 'gsk-980tdc');
    assert.equal(await language.count(), 0);
    await characters(page, 'gbk');
    await language.selectOption('zh');
    await accessible(page);
    await tab(page, 0);
    await page.locator('.listing', { hasText: '印点生产线 - 计算' }).waitFor();
    await enter(page.locator('#pitch'), '8');

    await page.click('#export');
    const files = unzipSync(await saved(page, () => page.click('#save-all')));
    await page.keyboard.press('Escape');
    const names = Object.keys(files).filter((name) => name.endsWith('.nc'));
    assert.equal(names.length, 3);
    const gbk = new TextDecoder('gbk', { fatal: true });
    assert.match(gbk.decode(files['O9100.nc']), /实际转速 R\/MIN/);
    assert.throws(() => new TextDecoder('utf-8', { fatal: true }).decode(files['O9100.nc']));
    assert.match(gbk.decode(files['O9100.nc']), /\(PITCH=8\)/);

    await enter(page.locator('#pitch'), '9');
    await page.setInputFiles('#open', names.map((name) => ({ name, mimeType: 'text/plain', buffer: Buffer.from(files[name]) })));
    await page.waitForFunction(() => document.querySelector('#pitch').value === '8');
    await page.locator('.listing', { hasText: '印点生产线 - 计算' }).waitFor();
    assert.equal(await page.locator('.detached:not(.gone)').count(), 0, 'the program does not follow the form');
  }));

test('control that shows only ASCII gets English comments', () =>
  withPage(app, {}, async ({ page }) => {
    await page.selectOption('select.control', 'sinumerik-802d');
    await characters(page, 'utf-8');
    await page.getByLabel(say('page.comments'), { exact: true }).selectOption('zh');
    await tab(page, 0);
    await page.locator('.listing', { hasText: '印点生产线' }).waitFor();
    await characters(page, 'ascii');
    await tab(page, 0);
    await page.locator('.listing', { hasText: 'RIBBON LINE' }).waitFor();
    assert.doesNotMatch(await listing(page), /[\u4e00-\u9fff]/);
  }));
