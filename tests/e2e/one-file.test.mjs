// The page as one file, opened from a disk: all of it works, and it requests no other file.
import assert from 'node:assert/strict';
import { copyFileSync, mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { unzipSync } from 'fflate';
import { DIST, accessible, enter, ready, saved, start, withPage } from './page.mjs';

let app, folder;
before(async () => {
  app = await start();
  // Alone in its folder, as on a memory stick.
  folder = mkdtempSync(join(tmpdir(), 'macroline-'));
  copyFileSync(join(DIST, 'macroline.html'), join(folder, 'macroline.html'));
});
after(async () => {
  await app?.close();
  rmSync(folder, { recursive: true, force: true });
});

const opened = (options, act) => withPage({ ...app, url: pathToFileURL(join(folder, 'macroline.html')).href }, options, act);

test('one file runs, sizes, edits and exports', () =>
  opened({}, async ({ page }) => {
    await page.click('#play');
    await page.waitForFunction(() => document.getElementById('clock').textContent > '00:00.5');
    await enter(page.locator('#pitch'), '8');
    await page.click('#tab-sizing');
    await page.locator('.sizing[aria-busy="false"] .section').first().waitFor({ timeout: 60_000 });
    await page.click('#tab-program');
    await page.getByRole('button', { name: 'Edit', exact: true }).click();
    await page.locator('.editor .cm-content').waitFor();
    await page.click('#export');
    await page.locator('#save-all').waitFor();
    const files = unzipSync(await saved(page, () => page.click('#save-all')));
    assert.ok('report.html' in files);
    await page.keyboard.press('Escape');
    await accessible(page);
    await page.reload();
    await ready(page);
    assert.equal(await page.locator('#pitch').inputValue(), '8');
  }));

test('one file on a disk offers no link', () =>
  opened({}, async ({ page }) => {
    await page.click('#share');
    const dialog = page.getByRole('dialog');
    await dialog.getByText('Send the project as a file').waitFor();
    assert.equal(await dialog.getByRole('textbox').count(), 0);
    const project = await saved(page, () => dialog.locator('.primary').click());
    assert.equal(JSON.parse(project).machine, 'ribbon-line');
  }));

test('the one file speaks both languages', () =>
  opened({ locale: 'zh-CN' }, async ({ page }) => {
    assert.equal(await page.locator('html').getAttribute('lang'), 'zh');
    await page.getByRole('button', { name: 'English' }).click();
    await page.waitForFunction(() => document.documentElement.lang === 'en');
    await ready(page);
  }));
