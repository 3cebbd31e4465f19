// The editor of the page by the tables of the control: proposals, meanings, places, breakpoints, findings, by key, pointer and finger.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { FIREFOX, accessible, press, start, withPage } from './page.mjs';
import { words } from './words.mjs';

let app;
before(async () => (app = await start()));
after(() => app?.close());

const say = words('en');

// Opens the editor of a file.
async function edit(page, file, told = say) {
  await page.getByRole('button', { name: file, exact: true }).click();
  await press(page, told('page.edit'));
  const content = page.locator('.editor .cm-content');
  await content.waitFor();
  await content.focus();
  return content;
}

// Puts the cursor behind a text of a line that is in view, or that find brings there.
async function behind(page, content, line, text) {
  await content.focus();
  await content.press('Control+f');
  await page.keyboard.type(line);
  await page.keyboard.press('Enter');
  await page.keyboard.press('Escape');
  await content.press('Home');
  for (let at = line.indexOf(text) + text.length; at > 0; at--) await content.press('ArrowRight');
}

// A new line behind the head of the program.
async function newLine(page, content, text) {
  await content.press('Control+Home');
  await content.press('ArrowDown');
  await content.press('End');
  await content.press('Enter');
  await page.keyboard.type(text);
}

// Records the announcements of the editor from now on; the result returns them. Each lasts a fifth of a second.
async function announcements(page) {
  const noted = await page.locator('.editor .cm-announced').evaluateHandle((place) => {
    const all = [];
    new MutationObserver(() => all.push(place.textContent)).observe(place, { childList: true });
    return all;
  });
  return () => noted.evaluate((all) => all.join('\n'));
}

const line = (page, text) => page.locator('.editor .cm-line', { hasText: text });
const active = (page, text) => page.locator('.editor .cm-activeLine', { hasText: text });
const option = (page, text) => page.locator('.editor [role=option]', { hasText: text }).first();
const proposals = (page) => page.locator('.editor .cm-tooltip-autocomplete');
const list = (page) => page.locator('.editor .cm-list');
const file = (page) => page.locator('.chip[aria-pressed=true]', { hasText: '.nc' }).textContent();

test('code proposals show meaning; Enter, Tab take, Escape leaves', () =>
  withPage(app, {}, async ({ page }) => {
    const content = await edit(page, 'O9101.nc');
    await newLine(page, content, 'G0');
    await option(page, /^G04\s*dwell/).waitFor();
    const chosen = await content.getAttribute('aria-activedescendant');
    assert.match(await page.locator(`.editor [id="${chosen}"]`).textContent(), /^G00/, 'a screen reader is told the chosen proposal');
    await page.keyboard.press('Escape');
    await proposals(page).waitFor({ state: 'detached' });
    await page.keyboard.press('Control+Space');
    await option(page, 'G04').waitFor();
    await page.waitForTimeout(100);
    await page.keyboard.press('ArrowDown');
    await page.keyboard.press('Tab');
    await active(page, /^G01$/).waitFor();
    await page.keyboard.press('Enter');
    await page.keyboard.type('M3');
    await option(page, /^M3/).waitFor();
    await page.waitForTimeout(100);
    await page.keyboard.press('Enter');
    await line(page, /^M3$/).waitFor();
    assert.equal(await active(page, /./).count(), 0, 'Enter behind a whole word begins a line');
    // Tab belongs to the editor, except after Escape.
    await page.keyboard.press('Tab');
    assert.ok(await content.evaluate((element) => element.matches(':focus')));
    await page.keyboard.press('Escape');
    await page.keyboard.press('Tab');
    assert.ok(!(await content.evaluate((element) => element.matches(':focus'))));
  }));

test('variables, functions, programs, jump targets are proposed', () =>
  withPage(app, {}, async ({ page }) => {
    const content = await edit(page, 'O9101.nc');
    await newLine(page, content, '#10');
    await option(page, /^#107\s*\S/).waitFor();
    await page.keyboard.type('0=SQ');
    await option(page, /^SQRT\s*\S/).waitFor();
    // A longer list scrolls by the keys of the text; axe knows that of single-line fields only.
    await accessible(page);
    await page.keyboard.press('Enter');
    await active(page, '#100=SQRT').waitFor();
    await page.keyboard.type('[4]\nM98 P');
    await option(page, /^9100\s*RIBBON LINE - COMPUTE/).waitFor();
    await page.waitForTimeout(100);
    await page.keyboard.press('Enter');
    await active(page, 'M98 P9100').waitFor();
    await page.keyboard.type('\nGOTO ');
    await option(page, /^15\s*N15 M98 P9100/).waitFor();
    await page.keyboard.press('Escape');
  }));

test('definition opens by key, press or button', () =>
  withPage(app, {}, async ({ page }) => {
    const content = await edit(page, 'O9101.nc');
    await behind(page, content, 'N5 M98 P9100', 'N5 M98 P91');
    await page.keyboard.press('F12');
    await active(page, 'O9100').waitFor();
    assert.equal(await file(page), 'O9100.nc');
    // Each file has a history of its own.
    await page.keyboard.press('Control+z');
    await active(page, 'O9100').waitFor();
    await behind(page, content, 'N42 IF[#104 LE #116]GOTO44', 'GOTO44');
    await press(page, say('page.definition'));
    await active(page, /^N44 /).waitFor();
    await page.locator('.editor .cm-activeLine .t-v', { hasText: '#118' }).click({ modifiers: [process.platform === 'darwin' ? 'Meta' : 'Control'] });
    await active(page, /^N33 #118=/).waitFor();
    await behind(page, content, 'N47 M99', 'N47 M99');
    await page.keyboard.press('F12');
    await page.getByText(say('page.no-definition')).first().waitFor();
  }));

test('all uses are listed across files, a row leads to its place', () =>
  withPage(app, {}, async ({ page }) => {
    const content = await edit(page, 'O9101.nc');
    await behind(page, content, 'N16 IF[#100 EQ #127]', 'N16 IF[#100');
    await page.keyboard.press('Shift+F12');
    await option(page, `O9100.nc, line 3 · ${say('page.role-read')}`).waitFor();
    await option(page, `O9102.nc, line`).waitFor();
    await accessible(page);
    await page.keyboard.type(say('page.role-write'));
    const found = option(page, 'O9102.nc');
    await found.waitFor();
    await page.waitForFunction(() => document.querySelector('.editor').shadowRoot.querySelectorAll('[role=option]').length < 5);
    await page.keyboard.press('Enter');
    await active(page, '#100=').waitFor();
    assert.equal(await file(page), 'O9102.nc');
    await press(page, say('page.uses'));
    await option(page, 'O9101.nc').click();
    await list(page).waitFor({ state: 'detached' });
    await active(page, '#100').waitFor();
    assert.equal(await file(page), 'O9101.nc');
  }));

test('programs, blocks and variables are found by their names', () =>
  withPage(app, {}, async ({ page }) => {
    const content = await edit(page, 'O9101.nc');
    await content.press('Control+Shift+o');
    await option(page, /^O9101\s*RIBBON LINE - RUN/).waitFor();
    await page.keyboard.type('compute');
    await option(page, /^O9100/).waitFor();
    await page.keyboard.press('Enter');
    await active(page, 'O9100').waitFor();
    await press(page, say('page.go-to-place'));
    await option(page, /^N44/).waitFor();
    await page.keyboard.type('no such name');
    await option(page, say('page.nothing-found')).waitFor();
    await page.keyboard.press('Escape');
    await list(page).waitFor({ state: 'detached' });
    await active(page, 'O9100').waitFor();
    // An edit closes a list, which belongs to the text before it.
    await content.press('Control+Shift+o');
    await list(page).waitFor();
    await content.focus();
    await page.keyboard.type('(');
    await list(page).waitFor({ state: 'detached' });
  }));

test('meaning of a word shows by pointer, key and button', () =>
  withPage(app, {}, async ({ page }) => {
    const content = await edit(page, 'O9101.nc');
    const meaning = page.locator('#meaning:popover-open');
    await page.locator('.editor .t-v', { hasText: '#3004' }).hover();
    await meaning.locator('code', { hasText: '#3004' }).waitFor();
    await page.mouse.move(5, 5);
    await meaning.waitFor({ state: 'hidden' });
    await behind(page, content, 'N2 #125=#120', 'N2 #125=#1');
    await page.keyboard.press('Control+i');
    await meaning.locator('code', { hasText: '#120' }).waitFor();
    // As the listing has it: text, value, source.
    assert.ok((await meaning.locator('.live b').textContent()).length > 0);
    await meaning.locator('.source').waitFor();
    await page.locator('[role=status], [aria-live]', { hasText: /^#120/ }).first().waitFor({ state: 'attached' });
    await page.keyboard.press('Escape');
    await meaning.waitFor({ state: 'hidden' });
    await press(page, say('page.meaning'));
    await meaning.locator('code', { hasText: '#120' }).waitFor();
    await content.focus();
    await page.keyboard.type('0');
    await meaning.waitFor({ state: 'hidden' });
  }));

test('breakpoints of the editor are those of the debugger', () =>
  withPage(app, {}, async ({ page }) => {
    const content = await edit(page, 'O9101.nc');
    const points = page.locator('.editor .cm-gutterElement .cm-point:visible');
    await behind(page, content, 'N5 M98 P9100', 'N5');
    await page.keyboard.press('F9');
    await points.first().waitFor();
    await page.locator('[role=status], [aria-live]', { hasText: /^Breakpoint: O9101.nc, line/ }).first().waitFor({ state: 'attached' });
    // A line inserted above moves the breakpoint.
    const beside = async (text) => {
      for (let turn = 0; turn < 50; turn++) {
        const [dot, row] = [await points.first().boundingBox(), await line(page, text).first().boundingBox()];
        if (Math.abs(dot.y + dot.height / 2 - row.y - row.height / 2) < 6) return true;
        await page.waitForTimeout(100);
      }
      return false;
    };
    await content.press('ArrowUp');
    await content.press('Home');
    await page.keyboard.type('(A)\n');
    assert.ok(await beside('N5 M98 P9100'));
    await page.getByText(say('page.detached')).waitFor();
    assert.ok(await beside('N5 M98 P9100'), 'and stays when the text is read');
    const row = await line(page, 'N2 #125').boundingBox();
    const numbers = await page.locator('.editor .cm-lineNumbers').boundingBox();
    await page.mouse.click(numbers.x + numbers.width / 2, row.y + row.height / 2);
    await points.nth(1).waitFor();
    await behind(page, content, 'N5 M98 P9100', 'N5');
    await press(page, say('page.stepping-breakpoint'));
    await points.nth(1).waitFor({ state: 'detached' });
    await press(page, say('page.edit'));
    await page.locator('.listing li.stop', { hasText: 'N2 #125' }).waitFor();
    assert.equal(await page.locator('.listing li.stop').count(), 1);
    // And the other way round.
    await page.locator('.listing li', { hasText: 'N5 M98 P9100' }).click({ position: { x: 10, y: 8 } });
    await press(page, say('page.edit'));
    await points.nth(1).waitFor();
  }));

test('keys step through findings, a list has their fixes', () =>
  withPage(app, {}, async ({ page }) => {
    const content = await edit(page, 'O9101.nc');
    await newLine(page, content, 'G999 X1.\nG01 X1,5');
    await page.keyboard.press('Escape');
    await page.locator('.editor .cm-lintRange-error').nth(1).waitFor();
    await content.press('Control+Home');
    const told = await announcements(page);
    await page.keyboard.press('F8');
    await active(page, 'G999').waitFor();
    await page.locator('.editor .cm-tooltip-lint', { hasText: 'P34' }).waitFor();
    assert.match(await told(), /P34/);
    await page.keyboard.press('F8');
    await active(page, 'X1,5').waitFor();
    await page.keyboard.press('Shift+F8');
    await active(page, 'G999').waitFor();
    await page.keyboard.press('Control+.');
    await option(page, /P34/).waitFor();
    assert.match(await page.locator('.editor [role=option][aria-selected=true]').textContent(), /P34/, 'the one at the cursor is chosen');
    await accessible(page);
    await page.keyboard.press('ArrowDown');
    await page.keyboard.press('ArrowDown');
    await page.keyboard.press('Enter');
    await line(page, 'G01 X1.5').waitFor();
    await press(page, say('page.findings'));
    await option(page, /P34/).click();
    await active(page, 'G999').waitFor();
  }));

test('marks are in place in a file with carriage returns', () =>
  withPage(app, {}, async ({ page }) => {
    const blocks = Array.from({ length: 12 }, (_, at) => `N${at + 1} G01 X${at}. F100`);
    const text = ['%', 'O1(RETURNS)', ...blocks, 'GOTO 5', 'G999', 'M30', '%'].join('\r\n');
    await page.setInputFiles('#open', { name: 'O1.nc', mimeType: 'text/plain', buffer: Buffer.from(text) });
    await page.locator('.listing', { hasText: 'RETURNS' }).waitFor();
    const content = await edit(page, 'O1.nc');
    await page.locator('.editor .cm-lintRange-error', { hasText: /^G999$/ }).waitFor();
    await behind(page, content, 'GOTO 5', 'GOTO 5');
    await page.keyboard.press('F12');
    await active(page, /^N5 /).waitFor();
    await page.keyboard.press('End');
    await page.keyboard.type(' #10');
    await option(page, '#100').waitFor();
    await page.waitForTimeout(100);
    await page.keyboard.press('Enter');
    await active(page, /^N5 G01 X4\. F100 #\d+$/).waitFor();
  }));

test('a fix is a press away in the tooltip of its finding', () =>
  withPage(app, {}, async ({ page }) => {
    const content = await edit(page, 'O9101.nc');
    await newLine(page, content, 'G01 X1,5');
    await page.keyboard.press('Escape');
    await page.locator('.editor .cm-lintRange-error').waitFor();
    await page.keyboard.press('F8');
    await page.locator('.editor .cm-tooltip-lint button').click();
    await line(page, 'G01 X1.5').waitFor();
  }));

test('the whole editor speaks Chinese', () =>
  withPage(app, { locale: 'zh-CN' }, async ({ page }) => {
    const told = words('zh');
    const content = await edit(page, 'O9101.nc', told);
    const chinese = async (element) => {
      const text = await element.evaluate((panel) => {
        const named = [...panel.querySelectorAll('[aria-label], [placeholder], [title]')];
        const attributes = named.flatMap((one) => ['aria-label', 'placeholder', 'title'].map((name) => one.getAttribute(name) ?? ''));
        return [panel.innerText, ...attributes].join('\n');
      });
      assert.ok(!/[a-z]{3}/.test(text), text);
    };
    await content.press('Control+f');
    await chinese(page.locator('.editor .cm-search'));
    await accessible(page);
    await page.keyboard.press('Escape');
    await press(page, told('page.go-to-place'));
    await list(page).waitFor();
    await chinese(list(page).locator('input'));
    await page.keyboard.press('Escape');
    await newLine(page, content, 'G0');
    await option(page, /^G04\s*暂停/).waitFor();
    assert.equal(await proposals(page).locator('ul').getAttribute('aria-label'), told('page.completions'));
  }));

test('a finger takes a proposal, a row of a list and a breakpoint', { skip: FIREFOX && 'it has no touch here' }, () =>
  withPage(app, { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true }, async ({ page }) => {
    await page.locator('#tab-program').tap();
    const content = await edit(page, 'O9101.nc');
    await newLine(page, content, 'G0');
    await option(page, /^G04/).tap();
    await active(page, /^G04$/).waitFor();
    await page.getByRole('button', { name: say('page.go-to-place'), exact: true }).tap();
    await page.waitForFunction(() => document.querySelector('.editor').shadowRoot.activeElement?.getAttribute('role') === 'listbox');
    await option(page, /^O9101/).tap();
    await active(page, 'O9101').waitFor();
    await line(page, 'N4 #128').locator('.t-v').first().tap();
    await page.getByRole('button', { name: say('page.stepping-breakpoint'), exact: true }).tap();
    await page.locator('.editor .cm-gutterElement .cm-point:visible').first().waitFor();
    await page.getByRole('button', { name: say('page.meaning'), exact: true }).tap();
    await page.locator('#meaning:popover-open').waitFor();
    const wide = await page.evaluate(() => document.documentElement.scrollWidth);
    assert.ok(wide <= 390, `${wide} px`);
  }));
