// An engineer's day at the page: types, runs, turns knobs, edits, exports, comes back.
import assert from 'node:assert/strict';
import { readFile, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { after, before, test } from 'node:test';
import { PAPER, accessible, enter, field, goTo, listing, openGroups, openPanel, processorTime, ready, saved, start, takeExample, withPage } from './page.mjs';

let app;
before(async () => (app = await start()));
after(() => app?.close());

// The text of a headline card, by its label.
const card = (page, label) => page.locator('.card', { hasText: label }).locator('.v');
const seconds = async (page) => {
  const [, minutes, rest] = /(\d+):([\d.]+)/.exec(await page.locator('#clock').textContent());
  return Number(minutes) * 60 + Number(rest);
};

test('what is typed stays as it is typed, and counts as it reads', () =>
  withPage(app, {}, async ({ page }) => {
    const pitch = field(page, 'pitch');
    for (const [typed, valid] of [['1.05', true], ['0.05', true], ['1,5', true], ['-1.50', false], ['1.', true], ['8', true]]) {
      await pitch.click();
      await pitch.press('Control+a');
      await pitch.pressSequentially(typed);
      assert.equal(await pitch.inputValue(), typed);
      assert.equal(await pitch.getAttribute('aria-invalid'), String(!valid), typed);
      await page.locator('h1').click();
      assert.equal(await pitch.inputValue(), typed, 'and after the field is left');
    }
    await pitch.fill('1,5');
    await page.locator('#tab-program').click();
    await page.getByRole('button', { name: 'O9102.nc' }).click();
    await page.getByText('#107=1.5').first().waitFor();
  }));

test('wrong field shows limits, keeps results, bars export', () =>
  withPage(app, {}, async ({ page }) => {
    const good = await card(page, 'Line speed').textContent();
    const speed = field(page, 'spindle-speed');
    for (const typed of ['', 'fast', '1e400', '0', '-3', '99999999', '1,2,3']) {
      await speed.fill(typed);
      assert.equal(await speed.getAttribute('aria-invalid'), 'true', typed);
      assert.match(await page.locator('#spindle-speed-note').textContent(), /1 to 30000 r\/min/, typed);
      assert.equal(await card(page, 'Line speed').textContent(), good, typed);
    }
    await page.getByText('Results before the invalid entry').waitFor();
    await page.click('#export');
    await page.getByText('Nothing is exported').waitFor();
    assert.equal(await page.locator('#save-all').count(), 0);
    await page.keyboard.press('Escape');
    await speed.fill('1200');
    assert.equal(await speed.getAttribute('aria-invalid'), 'false');
    assert.equal(await page.getByText('Results before the invalid entry').isVisible(), false);
  }));

test('arrow keys step a field; undo, redo, reset restore values', () =>
  withPage(app, {}, async ({ page }) => {
    const speed = field(page, 'spindle-speed');
    await speed.press('ArrowUp');
    assert.equal(await speed.inputValue(), '1210');
    await page.locator('h1').click();
    await page.keyboard.press('Control+z');
    assert.equal(await speed.inputValue(), '1200');
    await page.keyboard.press('Control+Shift+z');
    assert.equal(await speed.inputValue(), '1210');
    await page.getByRole('button', { name: 'About: Spindle speed S' }).click();
    await page.getByRole('button', { name: 'Reset to default' }).click();
    assert.equal(await speed.inputValue(), '1200');
  }));

test('paper example shows its figures and why it slips', () =>
  withPage(app, {}, async ({ page }) => {
    await takeExample(page, PAPER);
    const plain = (text) => text.replace(/\s/g, '');
    assert.match(plain(await card(page, 'Line speed').textContent()), /^15072/);
    assert.match(plain(await card(page, 'Vector feed').textContent()), /^119271/);
    assert.match(plain(await card(page, 'Analog output').textContent()), /^8\.107/);
    assert.match(plain(await card(page, 'Roller').textContent()), /^7\.850?/);
    await page.locator('.card', { hasText: 'Roller' }).click();
    assert.match(await page.locator('.result.fail', { hasText: 'Roller' }).first().textContent(), /7\.850/);
  }));

test('another control keeps the values and can be undone', () =>
  withPage(app, {}, async ({ page }) => {
    await takeExample(page, PAPER);
    await openGroups(page);
    await field(page, 'pitch').fill('12.5');
    assert.equal(await field(page, 'print-axis').isVisible(), false);
    await page.selectOption('select.control', 'gsk-980tdc');
    assert.equal(await field(page, 'pitch').inputValue(), '12.5');
    assert.deepEqual(
      [await field(page, 'print-axis').isVisible(), await field(page, 'path-mode').isVisible()],
      [true, false],
    );
    await page.locator('.card.fail', { hasText: 'Vector feed' }).waitFor();
    // C counts degrees: there is no unit to choose.
    await page.selectOption('#print-axis', 'c');
    await field(page, 'y-unit').waitFor({ state: 'hidden' });
    await page.locator('#tab-program').click();
    await page.getByRole('button', { name: 'O9101.nc' }).click();
    await page.locator('.listing, #program', { hasText: 'U#129 H#124' }).first().waitFor();
    await page.keyboard.press('Control+z');
    await page.keyboard.press('Control+z');
    assert.equal(await page.locator('select.control').inputValue(), 'mitsubishi-e60');
    assert.equal(await field(page, 'pitch').inputValue(), '12.5');
  }));

test('a setting of the control that is free text is typed', () =>
  withPage(app, {}, async ({ page }) => {
    await page.selectOption('select.control', 'knd-k2000t');
    await page.locator('#tab-parameters').click();
    const calls = page.locator('.switches input');
    assert.equal(await calls.inputValue(), '4120=512 4121=502');
    await enter(calls, '4120=600');
    await page.locator('h1').click();
    await page.keyboard.press('Control+z');
    await page.waitForFunction(() => document.querySelector('.switches input').value === '4120=512 4121=502');
  }));

test('run plays, steps by block, marks the running block', () =>
  withPage(app, {}, async ({ page }) => {
    await page.locator('h1').click();
    await page.keyboard.press('Space');
    await page.waitForFunction(() => document.querySelector('#clock').textContent > '00:00.0200');
    await page.keyboard.press('Space');
    const at = await seconds(page);
    const clock = await page.locator('#clock').textContent();
    await page.keyboard.press('.');
    await page.waitForFunction((last) => document.querySelector('#clock').textContent !== last, clock);
    assert.ok((await seconds(page)) > at);
    await page.keyboard.press(',');
    await goTo(page, 3);
    await page.locator('[aria-current="step"]', { hasText: 'G01' }).waitFor();
    await page.locator('h1').click();
    await page.keyboard.press('Home');
    await page.waitForFunction(() => document.querySelector('#clock').textContent === '00:00.0000');
  }));

test('operator acts at the play head, the change is announced', () =>
  withPage(app, {}, async ({ page }) => {
    await goTo(page, 4);
    await openPanel(page);
    await page.locator('#spindle-knob').focus();
    await page.locator('#spindle-knob').press('ArrowLeft');
    await page.waitForFunction(() => /Spindle override 99 %.*#104 1.188 \(without it 1.200\)/.test(document.querySelector('#changed').textContent));
    await page.getByRole('button', { name: 'Feed hold' }).click();
    await page.waitForFunction(() => /Feed hold/.test(document.querySelector('#changed').textContent));
    await goTo(page, 5);
    await page.waitForFunction(() => document.querySelector('.drawing .mode').textContent === 'Feed hold');
    await page.getByRole('button', { name: 'Cycle start' }).click();
    await goTo(page, 6);
    await page.waitForFunction(() => document.querySelector('.drawing .mode').textContent.startsWith('Paused'));
    await page.getByRole('button', { name: 'Emergency stop' }).click();
    await goTo(page, 7);
    await page.waitForFunction(() => document.querySelector('.drawing .mode').textContent === 'Emergency stop');
  }));

test('a variable set as on the screen changes the run', () =>
  withPage(app, {}, async ({ page }) => {
    await goTo(page, 4);
    await page.click('#tab-variables');
    const pitch = page.getByLabel('#107', { exact: true });
    await enter(pitch, '12');
    await page.waitForFunction(() => /#107 = 12/.test(document.querySelector('#changed').textContent));
  }));

test('the programs of an export are those that the page runs', () =>
  withPage(app, {}, async ({ page }) => {
    await page.evaluate(() => {
      window.replies = [];
      window.Worker = class extends Worker {
        constructor(...options) {
          super(...options);
          this.addEventListener('message', ({ data }) => window.replies.push(data));
        }
      };
    });
    await field(page, 'pitch').fill('9.5');
    await page.getByRole('button', { name: 'O9100.nc' }).click();
    const shown = await listing(page);
    await page.click('#export');
    const row = page.getByRole('row', { name: /O9100\.nc/ });
    const file = await saved(page, () => row.getByRole('button').click());
    assert.equal(file.toString('latin1').replaceAll('\r', '').trimEnd(), shown.trimEnd());
    // The worker sends the documents only.
    const documents = await page.evaluate(() => window.replies.flatMap((reply) => reply.Answer?.[1]?.files ?? []).map(({ name }) => name));
    assert.ok(documents.includes('report.md'), documents.join(' '));
    assert.deepEqual(documents.filter((name) => /^[OLM].*\.(nc|SPF|MPF)$/.test(name)), []);
  }));

test('exports what the control takes', () =>
  withPage(app, {}, async ({ page }) => {
    await page.click('#export');
    const row = page.getByRole('row', { name: /O9101\.nc/ });
    const text = (await saved(page, () => row.getByRole('button').click())).toString('latin1');
    assert.match(text, /^%\r?\nO9101/);
    assert.match(text, /M30/);
    await accessible(page);
  }));

test('reload keeps everything, broken state is set aside', () =>
  withPage(app, {}, async ({ page }) => {
    await field(page, 'pitch').fill('9.5');
    await page.getByLabel('Name of the project').fill('Customer 4711');
    await page.locator('.kept', { hasText: /^Saved$/ }).waitFor();
    await page.reload();
    await ready(page);
    assert.equal(await field(page, 'pitch').inputValue(), '9.5');
    assert.equal(await page.getByLabel('Name of the project').inputValue(), 'Customer 4711');
    await page.evaluate(() => {
      window.addEventListener('pagehide', () => localStorage.setItem('macroline.project', '{"version":1,'), { once: true });
    });
    await page.reload();
    await ready(page);
    await page.getByText('could not be read').first().waitFor();
    assert.equal(await field(page, 'pitch').inputValue(), '10');
    const file = await saved(page, () => page.locator('.notice').getByRole('button', { name: 'Save' }).click());
    assert.equal(file.toString('utf8'), '{"version":1,');
  }));

test('paper listing shows its faults, a fix mends it', () =>
  withPage(app, {}, async ({ page }) => {
    await page.getByRole('button', { name: 'Paper’s listing' }).click();
    await page.getByText('Edited program.').waitFor();
    await page.locator('.listing[aria-busy=false]').waitFor();
    const findings = page.locator('.says');
    const count = await findings.count();
    assert.ok(count > 3, `${count} findings`);
    await page.locator('[data-fix]').first().click();
    await page.waitForFunction((before) => document.querySelectorAll('.says').length !== before, count);
    await page.click('#export');
    await page.getByText('Nothing is exported').waitFor();
    // The report is there all the same, as a draft.
    const tab = page.waitForEvent('popup');
    await page.click('#print-draft');
    const draft = await tab;
    await draft.locator('.conclusion', { hasText: 'Draft without programs' }).waitFor();
    await draft.close();
    await page.keyboard.press('Escape');
    await page.getByRole('button', { name: 'Write again' }).click();
    await page.getByRole('button', { name: 'O9101.nc' }).waitFor();
  }));

test('the paper’s listing is mended in three clicks', () =>
  withPage(app, {}, async ({ page }) => {
    await page.getByRole('button', { name: 'Paper’s listing' }).click();
    await page.locator('.mode', { hasText: 'Program error' }).waitFor();
    await page.getByRole('button', { name: /^Fix \d+ errors$/ }).click();
    await page.getByRole('button', { name: /^Take \d+ first proposals?$/ }).click();
    // It reads without an error; the missing values are found by the run.
    await page.waitForFunction(() => document.querySelector('.mode').textContent !== 'Program error');
    for (const _ of ['proposals', 'errors', 'listing']) await page.getByRole('button', { name: 'Undo' }).click();
    await page.getByRole('button', { name: 'O9101.nc' }).waitFor();
  }));

test('finding leads to its line in listing and editor', () =>
  withPage(app, {}, async ({ page }) => {
    await page.getByRole('button', { name: 'Edit', exact: true }).click();
    const editor = page.locator('.editor .cm-content');
    await editor.waitFor();
    await editor.press('Control+Home');
    for (const key of ['ArrowDown', 'ArrowDown', 'Home']) await editor.press(key);
    await page.keyboard.type('G999\n');
    await page.locator('.mode', { hasText: 'Program error' }).waitFor();
    await editor.press('Control+End');
    await page.getByRole('button', { name: /errors?: show the next/ }).click();
    await page.locator('.editor .cm-activeLine', { hasText: 'G999' }).waitFor();
    await page.getByRole('button', { name: 'Edit', exact: true }).click();
    await page.getByRole('button', { name: 'O9101.nc' }).click();
    await page.getByRole('button', { name: /errors?: show the next/ }).click();
    await page.locator('.listing li.cursor', { hasText: 'G999' }).waitFor();
  }));

test('editor loads on demand, keeps the CSP, detaches the program', () =>
  withPage(app, {}, async ({ page, requests }) => {
    assert.ok(!requests.some((name) => name.includes('editor')));
    await page.getByRole('button', { name: 'Edit', exact: true }).click();
    const editor = page.locator('.editor .cm-content');
    await editor.waitFor();
    await editor.press('Control+Home');
    for (const key of ['ArrowDown', 'ArrowDown', 'Home']) await editor.press(key);
    await page.keyboard.type('G999 ');
    await page.getByText('Edited program.').waitFor();
    await page.locator('.editor .cm-lintRange-error').first().waitFor();
    await page.getByRole('button', { name: 'Show my changes' }).click();
    await page.locator('.editor .cm-changedLine, .editor .cm-insertedLine').first().waitFor();
  }));

test('typing on during a slow read loses nothing', () =>
  withPage(app, {}, async ({ page }) => {
    await page.getByRole('button', { name: 'Edit', exact: true }).click();
    const editor = page.locator('.editor .cm-content');
    await editor.waitFor();
    await editor.press('Control+Home');
    let sent = '';
    // Pauses in which the text is read, and keys at the moments at which answers arrive.
    for (let at = 0; at < 60; at++) {
      await page.keyboard.type('ABC'[at % 3]);
      sent += 'ABC'[at % 3];
      await page.waitForTimeout(at % 4 ? 15 : 155 + at);
    }
    assert.equal(await page.locator('.editor .cm-line').first().textContent(), `${sent}%`);
    // A page closed after the last letter has that letter when it opens again.
    await page.locator('.editor .cm-lintRange-error').first().waitFor();
    await page.keyboard.type('D');
    await page.reload();
    await ready(page);
    await page.locator('.listing li', { hasText: `${sent}D%` }).waitFor();
  }));

test('a program dropped on the page restores the form', () =>
  withPage(app, {}, async ({ page }) => {
    await field(page, 'pitch').fill('7.25');
    await page.getByRole('button', { name: 'O9101.nc' }).click();
    const text = await listing(page);
    await field(page, 'pitch').fill('3');
    await page.setInputFiles('#open', { name: 'O9101.nc', mimeType: 'text/plain', buffer: Buffer.from(text) });
    await page.getByText('the form is as it was then').waitFor();
    assert.equal(await field(page, 'pitch').inputValue(), '7.25');
  }));

test('an open point of the control is set, acts and is saved', () =>
  withPage(app, {}, async ({ page }) => {
    await page.getByRole('tab', { name: 'Parameters' }).click();
    const base = page.getByLabel('First register of the macro inputs');
    await base.selectOption('R172');
    await page.getByRole('tab', { name: 'PLC' }).click();
    await page.getByRole('cell', { name: 'R174', exact: true }).first().waitFor();
    await page.waitForTimeout(500);
    await page.reload();
    await ready(page);
    await page.getByRole('tab', { name: 'Parameters' }).click();
    assert.equal(await base.inputValue(), 'R172');
  }));

test('warnings have fixes, are silenced and shown again', () =>
  withPage(app, {}, async ({ page, requests }) => {
    assert.ok(!requests.some((url) => url.includes('worker')), 'the page opens without what finds warnings');
    const program = '%\nO1\nG91 G01 X8 F100\nM30\nX1.\nM30\n%\n';
    await page.setInputFiles('#open', { name: 'O1.nc', mimeType: 'text/plain', buffer: Buffer.from(program) });
    const says = page.locator('.says.warn');
    await says.filter({ hasText: 'X8 is 0.008 mm' }).waitFor();
    const unreachable = says.filter({ hasText: 'Nothing leads here' });
    await unreachable.getByRole('button', { name: 'Silence' }).click();
    await page.getByText('1 silenced.').waitFor();
    assert.equal(await unreachable.count(), 0);
    await accessible(page);
    await page.waitForTimeout(500);
    await page.reload();
    await ready(page);
    await says.filter({ hasText: 'X8 is 0.008 mm' }).waitFor();
    assert.equal(await unreachable.count(), 0);
    await page.getByRole('button', { name: 'Show again' }).click();
    await unreachable.waitFor();
    await page.getByRole('button', { name: 'Add the point: X8.' }).click();
    await page.locator('.listing').getByText('X8.').waitFor();
    await says.filter({ hasText: 'X8 is' }).waitFor({ state: 'detached' });
  }));

test('any bytes are answered, a large file by the worker', () =>
  withPage(app, {}, async ({ page }) => {
    // What no text has is refused, and the program stays; other bytes without a block are read on request.
    const junk = [0, 255, 37, 10, 71, 192, 40, 10, 123];
    const open = (bytes) => page.setInputFiles('#open', { name: 'junk.nc', mimeType: 'text/plain', buffer: Buffer.from(bytes) });
    await open(junk);
    await page.getByText('junk.nc is no text').first().waitFor();
    assert.equal(await page.getByRole('button', { name: 'Write again' }).count(), 0);
    await open(junk.slice(1));
    await page.getByRole('button', { name: 'Open it all the same' }).click();
    await page.locator('.says').first().waitFor();
    await page.getByRole('button', { name: 'Write again' }).click();
    const big = Buffer.from('%\nO1\n' + 'G91 G01 X1. Y2. F100\n'.repeat(2_300_000));
    const path = `${tmpdir()}/macroline-big.nc`;
    await writeFile(path, big);
    const spent = await processorTime(page);
    const begin = await spent();
    await page.setInputFiles('#open', path);
    await page.getByText('Checked.').waitFor({ timeout: 300_000 });
    // The worker spends seconds on it, the page's own thread next to nothing, whatever the load of the machine.
    assert.ok((await spent()) - begin < 1, 'the page itself works on a large file');
    assert.ok((await page.locator('.raw').textContent()).split('\n').length <= 5001);
  }));

test('assumed facts are counted and lead to their fields', () =>
  withPage(app, {}, async ({ page }) => {
    await page.click('#tab-results');
    await page.getByText(/\d+ facts of the machine are only assumed/).click();
    await accessible(page);
    assert.equal(await field(page, 'rapid-x').isVisible(), false);
    await page.getByRole('button', { name: 'Rapid X' }).click();
    // Its group is opened and built first.
    await page.waitForFunction(() => document.activeElement.id === 'rapid-x');
  }));

test('every tab is accessible, and so is the help', () =>
  withPage(app, {}, async ({ page }) => {
    await openGroups(page);
    for (const tab of ['results', 'variables', 'parameters', 'plc']) {
      await page.click(`#tab-${tab}`);
      await accessible(page);
    }
    await page.getByRole('button', { name: 'Help and keys' }).click();
    await accessible(page);
  }));

for (const [width, height] of [[1440, 900], [1024, 768], [390, 844]]) {
  test(`nothing is wider than ${width} px`, () =>
    withPage(app, { viewport: { width, height } }, async ({ page }) => {
      // Firefox takes the width of the scroll bar from it.
      const wide = await page.evaluate(() => document.documentElement.scrollWidth);
      assert.ok(wide <= width, `${wide} px`);
      assert.ok(await page.locator('#play').isVisible());
      // All of the machine is visible at once, or there are stations to scroll to.
      if ((await page.locator('.stations').count()) > 0) return;
      const [scene, stage] = [await page.locator('.scene').boundingBox(), await page.locator('.stage').boundingBox()];
      assert.ok(scene.width <= stage.width && scene.height <= stage.height + 1, JSON.stringify({ scene, stage }));
    }));
}
