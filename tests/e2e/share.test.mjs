// Sharing: the link that carries a project, the archive of all files, the printed report.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { FIREFOX, accessible, ready, start, withPage } from './page.mjs';

let app;
before(async () => (app = await start()));
after(() => app?.close());

const pitch = (page) => page.locator('#pitch');
const saved = (page) => page.locator('.kept', { hasText: /^Saved$/ }).waitFor({ state: 'attached' });
const notice = (page, text) => page.getByText(text).first().waitFor();

// The link of a project with this pitch, as a person of another browser gets it.
async function linkWith(value) {
  let link;
  await withPage(app, {}, async ({ page }) => {
    await pitch(page).fill(value);
    await page.getByRole('button', { name: 'Share' }).click();
    link = await page.getByLabel('Link to the project').inputValue();
  });
  return link;
}

// Opens a link in a browser that has a project with a pitch of 7.5.
async function openOver(page, link) {
  await pitch(page).fill('7.5');
  await saved(page);
  await page.goto('about:blank');
  await page.goto(link);
  await ready(page);
}

test('the link is shown, copied by one click, and short', () =>
  withPage(app, {}, async ({ page, context }) => {
    if (!FIREFOX) await context.grantPermissions(['clipboard-read', 'clipboard-write']);
    await page.getByRole('button', { name: 'Share' }).click();
    const link = await page.getByLabel('Link to the project').inputValue();
    assert.ok(link.startsWith(`${app.url}`) && link.length < 2000, link);
    await accessible(page);
    await page.getByRole('button', { name: 'Copy link' }).click();
    await page.locator('.share .said', { hasText: 'The link is on the clipboard.' }).waitFor();
    if (!FIREFOX) assert.equal(await page.evaluate(() => navigator.clipboard.readText()), link);
  }));

test('link opens a copy, the project before is one step back', async () => {
  const link = await linkWith('9.5');
  await withPage(app, {}, async ({ page }) => {
    await openOver(page, link);
    assert.equal(await pitch(page).inputValue(), '9.5');
    await notice(page, 'This project was opened from a link');
    await saved(page);
    assert.equal(new URL(page.url()).hash, '');
    await page.reload();
    await ready(page);
    assert.equal(await pitch(page).inputValue(), '9.5');
    await page.getByRole('button', { name: 'Projects' }).click();
    await page.locator('.projects > li').nth(1).waitFor();
    await page.keyboard.press('Escape');
    await page.getByRole('button', { name: 'Undo' }).click();
    await page.waitForFunction(() => document.getElementById('pitch').value === '7.5');
  });
});

test('a link beside an open tab touches nothing of that tab', async () => {
  const link = await linkWith('9.5');
  await withPage(app, {}, async ({ page, context }) => {
    await pitch(page).fill('7.5');
    await saved(page);
    const other = await context.newPage();
    await other.goto(link);
    await ready(other);
    await notice(other, 'Your own project is open in another tab');
    await pitch(page).fill('6.5');
    await saved(page);
    await other.waitForTimeout(300);
    assert.equal(await pitch(other).inputValue(), '9.5');
    // The page does not store it: the address keeps it.
    await other.reload();
    await ready(other);
    assert.equal(await pitch(other).inputValue(), '9.5');
    assert.equal(await page.evaluate(() => JSON.parse(localStorage.getItem('macroline.project')).values.pitch), 6.5);
  });
});

test('truncated link is reported and changes nothing', async () => {
  const link = (await linkWith('9.5')).slice(0, -9);
  await withPage(app, {}, async ({ page }) => {
    await openOver(page, link);
    await notice(page, 'The link is not whole');
    assert.equal(await pitch(page).inputValue(), '7.5');
  });
});

// Sizes of the pages of a PDF, in points.
function sizesOf(pdf) {
  const boxes = [...pdf.toString('latin1').matchAll(/\/MediaBox \[([^\]]*)\]/g)];
  return [...new Set(boxes.map(([, box]) => box.split(' ').map((side) => Math.round(Number(side))).join(' ')))];
}

// The command of the native tests, where they ran before.
const COMMAND = fileURLToPath(new URL('../../target/debug/macroline', import.meta.url));

test('the command prints the report too', { skip: !existsSync(COMMAND) || FIREFOX }, () => {
  const folder = mkdtempSync(join(tmpdir(), 'share-'));
  const [project, out] = ['line.json', 'out'].map((name) => join(folder, name));
  writeFileSync(project, execFileSync(COMMAND, ['new', 'ribbon-line']));
  for (const [paper, size] of [['a4', '0 0 595 842'], ['letter', '0 0 612 792']]) {
    execFileSync(COMMAND, ['export', project, '--out', out, '--pdf', '--paper', paper]);
    assert.deepEqual(sizesOf(readFileSync(join(out, 'report.pdf'))), [size]);
  }
  rmSync(folder, { recursive: true });
});

// The tab of a document of the export, which its button opens and prints.
async function printed({ page, context }, button) {
  await context.addInitScript(() => (window.print = () => (document.title = `printed ${document.title}`)));
  await page.click('#export');
  const tab = context.waitForEvent('page');
  await page.click(button);
  const document = await tab;
  await document.waitForFunction(() => window.document.title.startsWith('printed '));
  return document;
}

test('the report is printed as the export has it, in three clicks', () =>
  withPage(app, {}, async (opened) => {
    const report = await printed(opened, '#print-report');
    assert.match(await report.title(), /Ribbon line/);
    const { mode, sheet } = await report.evaluate(() => ({
      mode: document.compatMode,
      sheet: getComputedStyle(document.querySelector('.sheet')).backgroundColor,
    }));
    assert.deepEqual({ mode, sheet }, { mode: 'CSS1Compat', sheet: 'rgb(255, 255, 255)' });
    if (!FIREFOX) {
      // The printer sets the paper.
      for (const [format, size] of [['A4', '0 0 596 843'], ['Letter', '0 0 612 792']]) {
        assert.deepEqual(sizesOf(await report.pdf({ format, preferCSSPageSize: true })), [size]);
      }
    }
  }));

test('the summary for a customer is printed in two clicks', () =>
  withPage(app, {}, async (opened) => {
    const summary = await printed(opened, '#print-summary');
    const heads = await summary.locator('h2').allTextContents();
    assert.ok(heads.includes('What limits the machine') && !heads.includes('Sources'), heads.join());
    if (!FIREFOX) {
      for (const format of ['A4', 'Letter']) {
        const pages = (await summary.pdf({ format })).toString('latin1').match(/\/Type \/Page\b/g).length;
        assert.equal(pages, 2, format);
      }
    }
  }));
