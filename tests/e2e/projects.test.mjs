// Projects in this browser: kept by themselves, found, opened, duplicated, deleted and brought back, compared; versions and steps that one can see.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { strToU8, unzipSync, zipSync } from 'fflate';
import { PAPER, accessible, enter, ready, saved, start, takeExample, withPage } from './page.mjs';
import { words } from './words.mjs';

let app;
before(async () => (app = await start()));
after(() => app?.close());

const pitch = (page) => page.locator('#pitch');
const name = (page) => page.getByRole('banner').getByLabel('Name of the project');
const dialog = (page) => page.getByRole('dialog');
const items = (page) => dialog(page).locator('.projects > li');

async function openProjects(page) {
  await page.locator('#projects').click();
  await items(page).first().waitFor();
}

// The item of a project by its name, as soon as the list has it.
async function item(page, called) {
  let names = [];
  for (let tries = 0; tries < 50 && !names.includes(called); tries++) {
    if (tries > 0) await page.waitForTimeout(100);
    names = await items(page).locator('.what input').evaluateAll((all) => all.map((one) => one.value));
  }
  assert.ok(names.includes(called), `${called} is none of ${names}`);
  return items(page).nth(names.indexOf(called));
}

// Unfolds a group of the present project by its title; it stays unfolded when the dialog is opened again.
async function unfold(page, title) {
  const group = dialog(page).locator('details').filter({ has: page.getByText(title, { exact: true }) }).first();
  await group.waitFor();
  if (!(await group.evaluate((one) => one.open))) await group.locator('summary').click();
}

// Begins a project of this name with a pitch in mm, apart from the present one.
async function project(page, called, mm) {
  await takeExample(page, PAPER);
  await name(page).fill(called);
  await enter(pitch(page), mm);
}

test('projects are kept, found and opened, also after reload', () =>
  withPage(app, {}, async ({ page }) => {
    await project(page, 'Order 4711', '9.5');
    await project(page, 'Order 4712', '7.5');
    await page.getByRole('button', { name: 'Turning spindle' }).click();
    await page.locator('#cutting-speed').waitFor();
    await page.locator('.kept', { hasText: /^Saved$/ }).waitFor();
    await page.reload();
    await ready(page);
    await openProjects(page);
    await items(page).nth(2).locator('img').waitFor();
    await accessible(page);
    await dialog(page).getByRole('textbox', { name: 'Search' }).fill('4711');
    assert.equal(await items(page).filter({ visible: true }).count(), 1);
    await (await item(page, 'Order 4711')).getByRole('button', { name: 'Open' }).click();
    assert.equal(await pitch(page).inputValue(), '9.5');
    await page.getByRole('button', { name: 'Undo' }).click();
    await page.locator('#cutting-speed').waitFor();
    await page.getByRole('button', { name: 'Redo' }).click();
    assert.equal(await pitch(page).inputValue(), '9.5');
    await openProjects(page);
    // Until the worker has answered, the dialog has the list of the last time.
    await page.waitForFunction(() => document.querySelector('.projects > .present .what input')?.value === 'Order 4711');
    assert.equal((await items(page).locator('.what input').evaluateAll((all) => all.map((one) => one.value))).filter((one) => one === 'Order 4711').length, 1);
  }));

test('a project is duplicated, renamed, deleted and brought back', () =>
  withPage(app, {}, async ({ page }) => {
    await project(page, 'Order 1', '9.5');
    await openProjects(page);
    await dialog(page).getByRole('button', { name: 'Duplicate Order 1' }).click();
    await dialog(page).getByText('Added: Order 1 (copy)').waitFor();
    const copy = await item(page, 'Order 1 (copy)');
    await enter(copy.getByRole('textbox', { name: 'Name of the project' }), 'Order 2');
    await dialog(page).getByRole('button', { name: 'Delete Order 2' }).click();
    await dialog(page).getByText('Deleted: Order 2').waitFor();
    await dialog(page).getByRole('button', { name: 'Undo' }).click();
    await dialog(page).getByRole('button', { name: 'Open Order 2' }).click();
    assert.equal(await name(page).inputValue(), 'Order 2');
    assert.equal(await pitch(page).inputValue(), '9.5');
  }));

test('version lists changes, opening it keeps the last state', () =>
  withPage(app, {}, async ({ page }) => {
    await project(page, 'Order 1', '9.5');
    await openProjects(page);
    await unfold(page, 'Versions: 0');
    await dialog(page).getByRole('textbox', { name: 'Note about the version' }).fill('as offered');
    await dialog(page).getByRole('button', { name: 'Keep a version' }).click();
    await dialog(page).getByText('as offered').waitFor();
    await accessible(page);
    await page.keyboard.press('Escape');
    await enter(pitch(page), '12');
    await openProjects(page);
    await unfold(page, 'Versions: 1');
    await dialog(page).getByText('Pitch 9.5 → 12 mm').first().waitFor();
    await dialog(page).getByRole('button', { name: 'Open as offered' }).click();
    assert.equal(await pitch(page).inputValue(), '9.5');
    await openProjects(page);
    await unfold(page, 'Versions: 2');
    await dialog(page).getByText('Before another version was opened').waitFor();
    await page.keyboard.press('Escape');
    await page.getByRole('button', { name: 'Undo' }).click();
    assert.equal(await pitch(page).inputValue(), '12');
  }));

test('a version is kept before a program is opened over the form', () =>
  withPage(app, {}, async ({ page }) => {
    await enter(pitch(page), '9.5');
    await page.setInputFiles('#open', { name: 'O1.nc', mimeType: 'text/plain', buffer: Buffer.from('%\nO1\nG91 G01 X1. F100\nM30\n%\n') });
    await page.getByText('Edited program.').waitFor();
    await openProjects(page);
    await unfold(page, 'Versions: 1');
    await dialog(page).getByText('Before a program was opened').waitFor();
    await dialog(page).getByText('Program edited').first().waitFor();
  }));

test('steps are listed in words, one leads back over several', () =>
  withPage(app, {}, async ({ page }) => {
    await enter(pitch(page), '9.5');
    await enter(page.locator('#heads'), '7');
    await page.selectOption('select.control', 'gsk-980tdc');
    await openProjects(page);
    await unfold(page, 'Steps: 3');
    await dialog(page).getByText('Control GSK 980TDc').waitFor();
    await accessible(page);
    await dialog(page).getByRole('button', { name: 'Pitch 10 → 9.5 mm' }).click();
    assert.equal(await page.locator('select.control').inputValue(), 'mitsubishi-e60');
    assert.notEqual(await page.locator('#heads').inputValue(), '7');
    await openProjects(page);
    await unfold(page, 'Steps: 3');
    await dialog(page).getByRole('button', { name: 'Control GSK 980TDc' }).click();
    assert.equal(await page.locator('#heads').inputValue(), '7');
  }));

test('archive has all projects, another browser adds them once', async () => {
  let archive;
  await withPage(app, {}, async ({ page }) => {
    await project(page, '印带机', '9.5');
    await openProjects(page);
    await unfold(page, 'Versions: 0');
    await dialog(page).getByRole('button', { name: 'Keep a version' }).click();
    await dialog(page).getByText('Versions: 1').waitFor();
    archive = await saved(page, () => dialog(page).locator('#pack').click());
    assert.equal(Object.keys(unzipSync(archive)).filter((file) => /^\d+-印带机\.json$/.test(file)).length, 2);
  });
  await withPage(app, {}, async ({ page }) => {
    await openProjects(page);
    for (const added of [2, 0]) {
      await page.setInputFiles('#unpack', { name: 'all.zip', mimeType: 'application/zip', buffer: archive });
      await dialog(page).getByText(`Projects and versions added: ${added}`).waitFor();
    }
    await dialog(page).getByRole('button', { name: 'Open 印带机' }).click();
    assert.equal(await pitch(page).inputValue(), '9.5');
    await openProjects(page);
    await page.setInputFiles('#unpack', { name: 'no.zip', mimeType: 'application/zip', buffer: Buffer.from('no archive') });
    await page.locator('.notice', { hasText: 'no.zip was not added: It is not an archive of projects.' }).waitFor();
  });
});

test('archive is added whole or not at all', () =>
  withPage(app, { locale: 'zh-CN' }, async ({ page }) => {
    const say = words('zh');
    await page.getByRole('button', { name: say('projects.title'), exact: true }).click();
    await items(page).first().waitFor();
    const good = { id: 'good', at: 1, file: 'a.json' };
    const text = '{ "version": 1, "machine": "ribbon-line", "control": "mitsubishi-e60", "values": {}, "name": "Good" }';
    const archive = (states, files, version = 1) => Buffer.from(zipSync({ 'shelf.json': strToU8(JSON.stringify({ version, states })), ...files }));
    for (const [name, buffer, reason] of [
      ['own.zip', archive([good, { id: 'bad', at: 1, file: 'toString' }], { 'a.json': strToU8(text) }), 'projects.incomplete'],
      ['large.zip', archive([good, { id: 'bad', at: 1, file: 'b.json' }], { 'a.json': strToU8(text), 'b.json': new Uint8Array(17 << 20) }), 'projects.incomplete'],
      ['newer.zip', archive([good], { 'a.json': strToU8(text) }, 2), 'projects.newer'],
      ['cut.zip', archive([good], { 'a.json': strToU8(text) }).subarray(0, 80), 'projects.no-archive'],
    ]) {
      await page.setInputFiles('#unpack', { name, mimeType: 'application/zip', buffer });
      const notice = page.locator('.notice', { hasText: name });
      await notice.waitFor();
      const told = await notice.innerText();
      assert.ok(told.includes(say(reason)) && !/[a-z]{3,} [a-z]{3,}/i.test(told), told);
    }
    assert.equal(await items(page).count(), 1);
    await page.setInputFiles('#unpack', { name: 'all.zip', mimeType: 'application/zip', buffer: archive([good], { 'a.json': strToU8(text) }) });
    await item(page, 'Good');
  }));

test('without a database nothing is lost and a notice shows it', () =>
  withPage(app, {}, async ({ page, context }) => {
    await context.addInitScript(() => {
      IDBFactory.prototype.open = () => {
        throw new DOMException('The user denied permission', 'SecurityError');
      };
    });
    await page.reload();
    await ready(page);
    await project(page, 'Order 1', '9.5');
    await takeExample(page, PAPER);
    await page.locator('.notice', { hasText: 'does not keep the list of projects' }).waitFor();
    await page.locator('#projects').click();
    await dialog(page).getByText('Before another one was opened').first().waitFor();
    await dialog(page).getByRole('button', { name: 'Open Order 1' }).click();
    assert.equal(await pitch(page).inputValue(), '9.5');
  }));

test('database rows show as text, broken or newer rows stay', () =>
  withPage(app, {}, async ({ page }) => {
    await project(page, '<img src=x onerror=alert(1)>', '9.5');
    await openProjects(page);
    await page.evaluate(
      () =>
        new Promise((done) => {
          const opening = indexedDB.open('macroline');
          opening.onsuccess = () => {
            const transaction = opening.result.transaction('states', 'readwrite');
            const store = transaction.objectStore('states');
            store.put({ id: 'broken', text: 7, at: 'x' });
            store.put({ id: 'newer', version: 9, at: 1, text: '{}' });
            transaction.oncomplete = () => (opening.result.close(), done());
          };
        }),
    );
    await page.keyboard.press('Escape');
    await openProjects(page);
    await dialog(page).getByText('Kept by a newer version of this page').waitFor();
    await dialog(page).getByText('Could not be read').first().waitFor();
    await item(page, '<img src=x onerror=alert(1)>');
    await accessible(page);
  }));

test('projects list in Chinese has no English sentence', () =>
  withPage(app, { locale: 'zh-CN' }, async ({ page }) => {
    const say = words('zh');
    await enter(pitch(page), '9.5');
    await page.selectOption('select.control', 'gsk-980tdc');
    await page.getByRole('button', { name: say('projects.title'), exact: true }).click();
    await items(page).first().waitFor();
    await dialog(page).locator('.present summary').first().click();
    await dialog(page).locator('.present summary').nth(1).click();
    await dialog(page).getByRole('button', { name: say('projects.keep') }).click();
    await dialog(page).getByText(say('projects.kept')).waitFor();
    const text = await dialog(page).innerText();
    assert.ok(!/[a-z]{3,} [a-z]{3,}/i.test(text), text);
  }));

test('two projects compare in five clicks: motion, results, text', () =>
  withPage(app, {}, async ({ page }) => {
    await project(page, 'Order 1', '9.5');
    await project(page, 'Order 2', '12');
    await openProjects(page); // the first click
    await dialog(page).getByRole('button', { name: 'Compare Order 1' }).click(); // the second
    const table = dialog(page).locator('table');
    await table.getByRole('row', { name: /^Pitch mm 12 9\.5/ }).waitFor();
    await dialog(page).locator('.editor .cm-content').waitFor();
    await dialog(page).locator('.sides .scene').nth(1).waitFor();
    await accessible(page);
    const angles = () => dialog(page).locator('.sides').evaluate((sides) => [...sides.querySelectorAll('.stage')].map((stage) => [...stage.querySelectorAll('[data-g]')].map((one) => one.getAttribute('transform')).join()));
    const before = await angles();
    await dialog(page).getByRole('slider').fill('5');
    await page.waitForFunction(() => document.querySelector('.both output').textContent.startsWith('00:05'));
    const after = await angles();
    assert.ok(before[0] !== after[0] && before[1] !== after[1], 'a machine stands still');
    await dialog(page).getByRole('button', { name: 'Play' }).click();
    await page.waitForFunction(() => !document.querySelector('.both output').textContent.startsWith('00:05'));
    await dialog(page).getByRole('button', { name: 'Pause' }).click();
    await page.keyboard.press('Escape');
    assert.equal(await name(page).inputValue(), 'Order 2');
  }));

test('a file is compared, one without a project is refused', () =>
  withPage(app, {}, async ({ page }) => {
    await project(page, 'Order 1', '9.5');
    const file = await saved(page, () => page.getByRole('button', { name: 'Save', exact: true }).click());
    await enter(pitch(page), '12');
    await openProjects(page);
    await page.setInputFiles('#compare-file', { name: 'no.json', mimeType: 'application/json', buffer: Buffer.from('{ no project') });
    await dialog(page).getByText('no.json is not a project').waitFor();
    await page.setInputFiles('#compare-file', { name: 'order-1.json', mimeType: 'application/json', buffer: file });
    await dialog(page).getByRole('row', { name: /^Pitch mm 12 9\.5/ }).waitFor();
    await dialog(page).getByText('order-1.json').first().waitFor();
    assert.equal(await pitch(page).inputValue(), '12');
  }));
