// The operator's actions as part of the project: edited as a list and on the time axis, kept, saved as a panel file and opened again.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { accessible, enter, goTo, ready, saved, start, withPage } from './page.mjs';

let app;
before(async () => (app = await start()));
after(() => app?.close());

const EVENTS = [
  { t: 4, feed_override: 80 },
  { t: 6, hold: true },
  { t: 8, start: true },
];

const openFile = (page, events, name = 'panel.json') =>
  page.setInputFiles('#open', { name, mimeType: 'application/json', buffer: Buffer.from(JSON.stringify(events)) });

// Takes a panel file in, and waits until its marks are there.
async function withActions(page, events = EVENTS) {
  await openFile(page, events);
  await page.locator('button.mark').nth(events.length - 1).waitFor({ state: 'attached' });
  await page.waitForFunction(() => Number(document.querySelector('#head').max) > 30_000);
}

// A phone shows the button of the list in the open panel.
async function openList(page) {
  if (!(await page.isVisible('#panel-list'))) await page.click('#panel-fold');
  await page.click('#panel-list');
}
const row = (page, at) => page.locator(`#action-${at}`);
const entry = (page, at, column) => row(page, at).locator(`[data-column="${column}"]`);
const times = (page) => page.locator('.operator-list [data-column="time"]').evaluateAll((inputs) => inputs.map((input) => input.value));
const timesAre = (page, expected) =>
  page.waitForFunction((expected) => [...document.querySelectorAll('.operator-list [data-column="time"]')].map(({ value }) => value).join() === expected, expected.join());
const focusOf = (page) =>
  page.evaluate(() => {
    const { activeElement } = document;
    return [activeElement.closest('li')?.id ?? activeElement.id, activeElement.closest('[data-column]')?.dataset.column];
  });
const focusIs = (page, id, column) =>
  page.waitForFunction(
    ([id, column]) => {
      const { activeElement } = document;
      return (activeElement.closest('li')?.id ?? activeElement.id) === id && (!column || activeElement.closest('[data-column]')?.dataset.column === column);
    },
    [id, column],
  );
const modeAt = async (page, seconds, mode) => {
  await goTo(page, seconds);
  await page.waitForFunction((mode) => document.querySelector('.drawing .mode').textContent.startsWith(mode), mode);
};

test('action added, edited, removed at the play head, a step each', () =>
  withPage(app, {}, async ({ page }) => {
    await goTo(page, 5);
    await openList(page);
    await page.locator('#action-kind').selectOption({ label: 'Feed hold' });
    await page.getByRole('button', { name: 'Add at 00:05.0000' }).click();
    await focusIs(page, 'action-0', 'time');
    await modeAt(page, 7, 'Feed hold');
    await goTo(page, 3);
    await page.locator('#action-kind').selectOption({ label: 'Spindle override' });
    await page.getByRole('button', { name: 'Add at 00:03.0000' }).click();
    await focusIs(page, 'action-0', 'value');
    await page.keyboard.type('50');
    await page.keyboard.press('Enter');
    await page.waitForFunction(() => document.querySelector('.percents').textContent.includes('S 50 %'));
    // A bad value is reported and not accepted.
    await enter(entry(page, 0, 'value'), '2000');
    assert.equal(await page.locator('#operator-list-reason').textContent(), 'Spindle override takes a number from 0 to 1000 %.');
    await accessible(page);
    await page.keyboard.press('Control+a');
    await page.keyboard.type('60');
    // The override moves after the hold, and the focus moves with it, although Tab went on to the next column.
    await entry(page, 0, 'time').click();
    await page.keyboard.press('Control+a');
    await page.keyboard.type('9,5');
    await page.keyboard.press('Tab');
    await focusIs(page, 'action-1', 'value');
    await timesAre(page, ['5', '9.5']);
    assert.equal(await entry(page, 1, 'value').inputValue(), '60');
    await row(page, 0).getByRole('button', { name: 'Remove Feed hold at 5 s' }).click();
    await focusIs(page, 'action-0', 'remove');
    await timesAre(page, ['9.5']);
    await modeAt(page, 8, 'Paused');
    await page.waitForFunction(() => document.querySelector('.percents').textContent.includes('S 100 %'));
    // Each change is a step: removed, moved, 60, 50, added, added.
    await page.locator('h1').click();
    for (const expected of [['5', '9.5'], ['3', '5']]) {
      await page.keyboard.press('Control+z');
      await timesAre(page, expected);
    }
    assert.equal(await entry(page, 0, 'value').inputValue(), '60');
    await page.keyboard.press('Control+z');
    await page.waitForFunction(() => document.querySelector('#action-0 [data-column="value"]').value === '50');
    await modeAt(page, 7, 'Feed hold');
  }));

test('steps of undo name the changed actions', () =>
  withPage(app, {}, async ({ page }) => {
    await withActions(page);
    await openList(page);
    await enter(entry(page, 0, 'value'), '70');
    await enter(entry(page, 1, 'time'), '7');
    await page.getByRole('button', { name: 'Projects' }).click();
    await page.locator('.projects .steps').first().waitFor();
    const told = (await page.locator('.projects .steps').allTextContents()).join(' ');
    assert.match(told, /At 4 s: Feed override 80 % → 70 %/);
    assert.match(told, /Feed hold 6 → 7 s/);
  }));

test('dragging a mark replans from its new time, as one step', () =>
  withPage(app, {}, async ({ page }) => {
    await withActions(page);
    await modeAt(page, 7, 'Feed hold');
    const box = await page.locator('#action-mark-1').boundingBox();
    assert.ok(box.width >= 24 && box.height >= 24, `${box.width} × ${box.height}`);
    const axis = await page.locator('.marks').boundingBox();
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x - axis.width * 0.03, y, { steps: 4 });
    const shown = await page.locator('output.moving').textContent();
    assert.match(shown, /^00:0[45]\.\d{4}$/);
    await page.mouse.up();
    await page.locator('output.moving').waitFor({ state: 'detached' });
    await page.locator(`#action-mark-1[title^="${shown}"]`).waitFor({ state: 'attached' });
    await focusIs(page, 'action-mark-1');
    assert.equal(await page.locator('.clock, #clock').first().textContent(), '00:07.0000', 'the end of a pull is no click');
    await modeAt(page, 5.9, 'Feed hold');
    await page.locator('h1').click();
    await page.keyboard.press('Control+z');
    await modeAt(page, 5.9, 'Paused');
    await page.locator('#action-mark-1').click();
    await page.waitForFunction(() => document.querySelector('#clock').textContent === '00:06.0000');
  }));

test('marks are moved, removed and followed to the list by keys', () =>
  withPage(app, {}, async ({ page }) => {
    await withActions(page);
    await page.locator('#action-mark-0').focus();
    await page.keyboard.press('ArrowRight');
    await page.locator('#action-mark-0[title^="00:04.1"]').waitFor({ state: 'attached' });
    for (let nth = 0; nth < 2; nth++) await page.keyboard.press('Shift+ArrowRight');
    await focusIs(page, 'action-mark-1');
    await page.keyboard.press('Enter');
    await focusIs(page, 'action-1', 'time');
    assert.deepEqual(await times(page), ['6', '6', '8']);
    await accessible(page);
    await page.keyboard.press('Escape');
    await focusIs(page, 'panel-list');
    await page.locator('#action-mark-1').focus();
    await page.keyboard.press('Delete');
    await page.waitForFunction(() => document.querySelectorAll('button.mark').length === 2);
    await focusIs(page, 'action-mark-1');
    await page.keyboard.press('ArrowUp');
    await focusIs(page, 'action-mark-0');
    // The list has a key of its own.
    await page.keyboard.press('a');
    await focusIs(page, 'action-0', 'time');
    assert.deepEqual(await times(page), ['6', '8']);
  }));

test('panel file opens in page and command line, browser keeps it', () =>
  withPage(app, {}, async ({ page }) => {
    await withActions(page);
    await openList(page);
    await entry(page, 0, 'value').waitFor();
    const file = await saved(page, () => page.locator('.operator-list').getByRole('button', { name: 'Save' }).click());
    assert.deepEqual(JSON.parse(file), EVENTS);
    await page.getByRole('button', { name: 'Delete all actions' }).click();
    await page.locator('.operator-list li').first().waitFor({ state: 'hidden' });
    await focusIs(page, 'action-kind');
    await openFile(page, JSON.parse(file), 'shift.json');
    await page.locator('.notice', { hasText: 'shift.json' }).waitFor();
    await timesAre(page, ['4', '6', '8']);
    await page.waitForFunction(() => JSON.parse(localStorage.getItem('macroline.project') ?? '{}').panel?.length === 3);
    await page.reload();
    await ready(page);
    await openList(page);
    await timesAre(page, ['4', '6', '8']);
    assert.deepEqual(await focusOf(page), ['panel-list', undefined]);
    // An unreadable file changes nothing.
    await openFile(page, [{ t: 1, dance: true }], 'no.json');
    await page.locator('.notice.fail', { hasText: 'dance' }).waitFor();
    await timesAre(page, ['4', '6', '8']);
    const command = fileURLToPath(new URL('../../target/debug/macroline', import.meta.url));
    if (existsSync(command)) {
      const folder = mkdtempSync(join(tmpdir(), 'replay-'));
      const [project, panel] = ['line.json', 'panel.json'].map((name) => join(folder, name));
      writeFileSync(project, execFileSync(command, ['new', 'ribbon-line']));
      writeFileSync(panel, file);
      const out = execFileSync(command, ['run', project, '--no-canon', '--json', '--panel', panel], { encoding: 'utf8' });
      rmSync(folder, { recursive: true });
      assert.match(out, /program-end/);
    }
  }));

test('five hundred actions are edited as fast as three', () =>
  withPage(app, {}, async ({ page }) => {
    const events = Array.from({ length: 500 }, (_, at) => ({ t: 1 + at * 0.05, feed_override: 100 - (at % 2) * 20 }));
    await withActions(page, events);
    await openList(page);
    await entry(page, 0, 'time').waitFor();
    assert.ok((await page.locator('.operator-list li').count()) < 60);
    await page.locator('.operator-list .rows').evaluate((rows) => (rows.scrollTop = rows.scrollHeight));
    await enter(entry(page, 499, 'value'), '75');
    await page.keyboard.press('ArrowUp');
    await focusIs(page, 'action-498', 'value');
    await enter(entry(page, 499, 'time'), '2');
    await focusIs(page, 'action-21', 'time');
    assert.equal(await entry(page, 21, 'value').inputValue(), '75');
    await accessible(page);
  }));

for (const [width, height, locale] of [[390, 844, 'en'], [1024, 768, 'zh'], [320, 640, 'zh']])
  test(`the list has room at ${width} pixels in ${locale}`, () =>
    withPage(app, { viewport: { width, height }, locale, hasTouch: true }, async ({ page }) => {
      await openFile(page, [...EVENTS, { t: 9, variable: { '#107': 12.5 } }, { t: 10, single_block: true }]);
      await page.locator('button.mark').nth(4).waitFor({ state: 'attached' });
      await openList(page);
      await entry(page, 4, 'value').waitFor();
      const wide = await page.evaluate(() => {
        const list = document.querySelector('.operator-list');
        const within = ({ left, right }) => left >= 0 && right <= innerWidth + 0.5;
        return [...list.querySelectorAll('button, input, select, .what')].filter((part) => !within(part.getBoundingClientRect())).map((part) => part.outerHTML);
      });
      assert.deepEqual(wide, []);
      assert.ok(await page.evaluate(() => [...document.querySelectorAll('.operator-list li')].every((row) => row.getBoundingClientRect().height === 40)));
      await accessible(page);
    }));
