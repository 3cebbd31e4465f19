// No loss of work: machines and tabs left behind, undone actions, edits without a change, remedies by one click.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { PAPER, accessible, enter, field, goTo, openPanel, processorTime, ready, saved, start, takeExample, withPage } from './page.mjs';
import { words } from './words.mjs';

let app;
before(async () => (app = await start()));
after(() => app?.close());

const machine = (page, name) => page.locator('.segments button', { hasText: name });

test('a machine that was left comes back as it was', () =>
  withPage(app, {}, async ({ page }) => {
    await field(page, 'pitch').fill('9.5');
    await machine(page, 'Turning spindle').click();
    await field(page, 'cutting-speed').waitFor();
    await machine(page, 'Ribbon line').click();
    await field(page, 'pitch').waitFor();
    assert.equal(await field(page, 'pitch').inputValue(), '9.5');
  }));

test('an action of the operator is undone', () =>
  withPage(app, {}, async ({ page }) => {
    await openPanel(page);
    await page.getByRole('button', { name: 'Spindle override −' }).click();
    await page.locator('output[for=spindle-knob]', { hasText: '99 %' }).waitFor();
    await page.getByRole('button', { name: 'Undo' }).click();
    await page.locator('output[for=spindle-knob]', { hasText: '100 %' }).waitFor();
  }));

test('a character that is typed and deleted is no edit', () =>
  withPage(app, {}, async ({ page }) => {
    await page.getByRole('button', { name: 'Edit', exact: true }).click();
    const editor = page.locator('.editor .cm-content');
    await editor.waitFor();
    await editor.press('Control+Home');
    await page.keyboard.type('X');
    await page.getByText('Edited program.').waitFor();
    await page.keyboard.press('Backspace');
    await page.getByText('Edited program.').waitFor({ state: 'detached' });
  }));

test('second tab warns, only watches, and may take over', () =>
  withPage(app, {}, async ({ page, context }) => {
    await field(page, 'pitch').fill('9.5');
    await page.locator('.kept', { hasText: /^Saved$/ }).waitFor();
    const other = await context.newPage();
    await other.goto(app.url);
    await ready(other);
    await other.getByText('The project is open in another tab').first().waitFor();
    await field(page, 'pitch').fill('7.5');
    await other.waitForFunction(() => document.getElementById('pitch').value === '7.5');
    await field(other, 'pitch').fill('6.5');
    await other.waitForTimeout(500);
    const stored = () => page.evaluate(() => JSON.parse(localStorage.getItem('macroline.project')).values.pitch);
    assert.equal(await stored(), 7.5);
    await other.getByRole('button', { name: 'Work here' }).click();
    await page.waitForFunction(() => JSON.parse(localStorage.getItem('macroline.project')).values.pitch === 6.5);
    await page.getByText('Another tab of this browser has taken the project over').first().waitFor();
    await other.getByRole('button', { name: 'Projects' }).click();
    await other.getByText('Of another tab').waitFor();
  }));

test('undo goes on after a reload', () =>
  withPage(app, {}, async ({ page }) => {
    await field(page, 'pitch').fill('9.5');
    await machine(page, 'Turning spindle').click();
    await field(page, 'cutting-speed').waitFor();
    await page.locator('.kept', { hasText: /^Saved$/ }).waitFor();
    await page.reload();
    await ready(page);
    await page.getByRole('button', { name: 'Undo' }).click();
    assert.equal(await field(page, 'pitch').inputValue(), '9.5');
    await page.getByRole('button', { name: 'Undo' }).click();
    assert.equal(await field(page, 'pitch').inputValue(), '10');
    await page.getByRole('button', { name: 'Redo' }).click();
    assert.equal(await field(page, 'pitch').inputValue(), '9.5');
  }));

test('project before “New” is offered again, also after reload', () =>
  withPage(app, {}, async ({ page }) => {
    await field(page, 'pitch').fill('9.5');
    await page.getByLabel('Name of the project').fill('Customer 4711');
    await page.getByRole('button', { name: 'New', exact: true }).click();
    await accessible(page);
    await page.getByRole('dialog').getByRole('button', { name: 'Print roller that fits the pitch' }).click();
    assert.equal(await field(page, 'pitch').inputValue(), '10');
    await page.locator('.kept', { hasText: /^Saved$/ }).waitFor();
    await page.reload();
    await ready(page);
    await page.getByRole('button', { name: 'Projects' }).click();
    await page.getByRole('button', { name: 'Open Customer 4711' }).click();
    assert.equal(await field(page, 'pitch').inputValue(), '9.5');
  }));

test('files that are opened together are all taken or all refused', () =>
  withPage(app, {}, async ({ page }) => {
    const file = (name, text) => ({ name, mimeType: 'text/plain', buffer: Buffer.from(text) });
    await field(page, 'pitch').fill('9.5');
    const project = String(await saved(page, () => page.getByRole('button', { name: 'Save', exact: true }).click()));
    await takeExample(page, PAPER);
    await page.setInputFiles('#open', [file('O1.nc', 'M30'), file('order.json', '{ no project')]);
    await page.locator('.notice.fail').waitFor();
    assert.equal(await field(page, 'pitch').inputValue(), '8');
    await page.setInputFiles('#open', [file('O1.nc', '%\nO1\nG91 G01 X1. F100\nM30\n%\n'), file('order.json', project)]);
    await page.waitForFunction(() => document.getElementById('pitch').value === '9.5');
    await page.getByRole('button', { name: 'O1.nc' }).waitFor();
  }));

test('a remedy is carried out by one click, and undone', () =>
  withPage(app, {}, async ({ page }) => {
    await takeExample(page, PAPER);
    const ratio = page.locator('.card', { hasText: 'Roller : ribbon' });
    await ratio.getByRole('button', { name: 'Set 47 heads' }).click();
    assert.equal(await field(page, 'heads').inputValue(), '47');
    await page.locator('.card.ok', { hasText: 'Roller : ribbon' }).waitFor();
    await page.locator('h1').click();
    await page.keyboard.press('Control+z');
    assert.equal(await field(page, 'heads').inputValue(), '6');
  }));

test('facts to measure first are listed and lead to their fields', () =>
  withPage(app, {}, async ({ page }) => {
    await page.getByText(/^(\d+) of \1 assumed$/).click();
    const fact = page.locator('.measure-first button').first();
    const name = (await fact.textContent()).trim();
    await fact.click();
    // The name of the field, without the number of its variable.
    const at = await page.evaluate(() => document.activeElement.closest('.field')?.querySelector('label').firstChild.textContent.trim());
    assert.ok(at && name.startsWith(at), `${name}: ${at}`);
  }));

test('line of 100,000 characters shows its start, quickly', () =>
  withPage(app, {}, async ({ page }) => {
    const spent = await processorTime(page);
    const begin = await spent();
    await page.setInputFiles('#open', { name: 'O1.nc', mimeType: 'text/plain', buffer: Buffer.from(`%\nO1\n${'X1.'.repeat(33_000)}\nM30\n%\n`) });
    await page.locator('.listing li[data-l="3"]', { hasText: '…' }).waitFor();
    await page.locator('.listing[aria-busy=false]').waitFor({ timeout: 60_000 });
    assert.ok((await spent()) - begin < 10, 'the page works for seconds on one line');
  }));

test('change of language without a store loses nothing', () =>
  withPage(app, {}, async ({ page, context }) => {
    await context.addInitScript(() => {
      const denied = () => {
        throw new DOMException('The user denied permission', 'SecurityError');
      };
      Object.defineProperty(window, 'localStorage', { get: denied });
      IDBFactory.prototype.open = denied;
    });
    await page.reload();
    await ready(page);
    await enter(field(page, 'pitch'), '9.5');
    await page.locator('.kept', { hasText: 'Not saved' }).waitFor();
    await page.locator('#tab-results').click();
    await goTo(page, 5);
    // The slider follows with the next frames, when the run is planned so far.
    const atFive = () => page.waitForFunction(() => document.querySelector('#head').value === '5000');
    await atFive();
    await page.getByLabel('Name of the project').fill('Customer 4711');
    await page.getByRole('button', { name: '中文' }).click();
    await page.waitForFunction(() => document.documentElement.lang === 'zh');
    await ready(page);
    assert.equal(await field(page, 'pitch').inputValue(), '9.5');
    assert.equal(await page.locator('#tab-results').getAttribute('aria-selected'), 'true');
    await atFive();
    const say = words('zh');
    await page.getByRole('button', { name: say('page.undo') }).click();
    await page.getByRole('button', { name: say('page.undo') }).click();
    assert.equal(await field(page, 'pitch').inputValue(), '10');
    await page.reload();
    await ready(page);
    assert.equal(await page.locator('html').getAttribute('lang'), 'zh');
  }));
