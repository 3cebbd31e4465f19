// Stepping through the program on the page: breakpoints, levels, watches, what changed.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { accessible, clock, enter, press, ready, showSteps, start, withPage } from './page.mjs';

let app;
before(async () => (app = await start()));
after(() => app?.close());

// Lines of the file that is shown.
const line = (page, text) => page.locator('.listing li[data-l]', { hasText: text }).first();
const file = (page, name) => page.getByRole('button', { name, exact: true }).click();
const next = (page, text) => page.locator('.listing li.next', { hasText: text }).waitFor();
const point = async (page, text) => {
  await line(page, text).click();
  await page.locator('.listing').press('b');
};
const fill = (page, field, text) => enter(page.getByLabel(field), text);
const why = (page) => page.locator('.here');
const seen = (page) => page.locator('.seen').innerText();

test('line number sets breakpoint; stepping into, over, out works', () =>
  withPage(app, {}, async ({ page }) => {
    await file(page, 'O9101.nc');
    await line(page, 'N5 M98 P9100').click({ position: { x: 20, y: 8 } });
    await press(page, 'Run to a breakpoint or the end');
    await page.locator('.listing li.stop.next').waitFor();
    assert.equal(await why(page).textContent(), 'Breakpoint: N5 M98 P9100');
    await press(page, 'Next block, into calls');
    await next(page, 'N1 IF');
    assert.equal(await page.locator('.chips .chip[aria-pressed="true"]', { hasText: '.nc' }).textContent(), 'O9100.nc', 'the file that runs is shown');
    assert.equal(await why(page).textContent(), 'Next: N1 IF[#100 LE 0]GOTO901');
    assert.match(await seen(page), /Call stack\s+O9100.nc:3\s+N1 IF[\s\S]*O9101.nc:28\s+N5 M98/);
    await press(page, 'Out of this call');
    await next(page, 'WHILE[#115');
    assert.match(await seen(page), /Changed[\s\S]*#115\s+vacant → 10.716\.628/);
    await press(page, 'Back one block');
    await next(page, 'N47 M99');
    await accessible(page);
    // The list of breakpoints can remove a breakpoint.
    assert.match(await seen(page), /Breakpoints\s+O9101.nc:28\s+N5 M98 P9100 · 1 ×/);
    await press(page, 'Remove O9101.nc:28');
    await file(page, 'O9101.nc');
    assert.equal(await page.locator('.listing li.stop').count(), 0);
    await page.locator('.listing').press('x');
    assert.equal(await page.locator('.seen').isVisible(), false);
  }));

test('condition decides the stop; changes, watches are shown', () =>
  withPage(app, {}, async ({ page }) => {
    await showSteps(page);
    await fill(page, 'Break if', '#125 EQ 490');
    await page.getByText('First choose a line').first().waitFor();
    await file(page, 'O9101.nc');
    await line(page, 'N45 #125').click();
    await fill(page, 'Break if', '#125 EQ');
    await page.getByText('ends where a value is expected').first().waitFor();
    assert.equal(await page.getByLabel('Break if').inputValue(), '#125 EQ', 'it is there to be mended');
    await fill(page, 'Break if', '#125 EQ 490');
    await page.locator('.listing li.stop[data-if="#125 EQ 490"]').waitFor();
    await page.locator('.listing').press('c');
    await next(page, 'N45');
    for (const text of ['#125*2', '#1 +']) await fill(page, 'Watch', text);
    assert.match(await seen(page), /#125\*2\s+980/);
    assert.match(await seen(page), /#1 \+\s.*value is expected/);
    await page.locator('h1').click();
    await page.keyboard.press('i');
    await next(page, 'N46');
    assert.match(await seen(page), /#125\s+490 → 489[\s\S]*#125\*2\s+978/);
    await press(page, 'Remove #1 +');
    assert.doesNotMatch(await seen(page), /#1 \+/);
    await page.locator('#tab-variables').click();
    const row = page.locator('tr[data-changed]');
    assert.equal(await row.count(), 1);
    assert.equal(await row.locator('input').inputValue(), '489');
    // A value that the operator sets is visible at the stop, and the run goes on with it.
    await enter(row.locator('input'), '1');
    await page.locator('#tab-program').click();
    await page.waitForFunction(() => /#125\*2\s+2(\s|$)/.test(document.querySelector('.seen').innerText));
    await next(page, 'N46');
    // Letters in a field are text.
    await page.getByLabel('Watch').pressSequentially('bitcoxur');
    await next(page, 'N46');
  }));

test('play head follows stepping; playing stops at breakpoints', () =>
  withPage(app, {}, async ({ page }) => {
    await file(page, 'O9101.nc');
    await line(page, 'N44 G01').click();
    await page.locator('h1').click();
    await page.keyboard.press('t');
    await next(page, 'N44');
    // The clock follows with the next frame.
    await page.waitForFunction(() => document.querySelector('#clock').textContent !== '00:00.0000');
    const at = await clock(page);
    await page.keyboard.press('b');
    await page.selectOption('.speed', { label: '1 ×' });
    await page.keyboard.press('Space');
    await page.waitForFunction((at) => document.querySelector('#clock').textContent > at, at);
    await page.locator('.listing li.stop.next').waitFor();
    assert.equal(await page.locator('#play').getAttribute('aria-label'), 'Play');
    // Another moment is no stop of the debugger.
    await page.keyboard.press('Home');
    await page.waitForFunction(() => document.querySelector('#clock').textContent === '00:00.0000');
    assert.equal(await page.locator('.listing li.next').count(), 0);
    await page.keyboard.press('b');
    await point(page, 'O9101(');
    await page.keyboard.press('Space');
    await page.locator('.listing li.next').waitFor();
    assert.equal(await clock(page), '00:00.0000');
    await page.keyboard.press('b');
    await press(page, 'Run to a breakpoint or the end');
    await why(page).getByText('The program has ended.').waitFor();
  }));

test('breakpoints follow their lines, a new run has no stop mark', () =>
  withPage(app, {}, async ({ page }) => {
    await file(page, 'O9101.nc');
    await point(page, 'N12 #128');
    await fill(page, 'Break if', '#125 LT 400');
    await page.locator('.listing').press('i');
    await next(page, 'N1 #3004');
    // An edit from outside: the same program with a line more.
    await press(page, 'Paper’s listing');
    assert.equal(await page.locator('.listing li.next').count(), 0, 'the walk is over with the run');
    await page.getByText('not in this program').waitFor();
    await page.keyboard.press('Control+z');
    await file(page, 'O9101.nc');
    await page.locator('.listing li.stop', { hasText: 'N12 #128' }).waitFor();
    await page.locator('.listing').press('i');
    await next(page, 'N1 #3004');
    await page.selectOption('.control', 'gsk-980tdc');
    assert.equal(await page.locator('.listing li.next').count(), 0);
    await page.locator('.listing').press('o');
    await page.locator('.listing li.next').waitFor();
    await page.keyboard.press('Control+z');
    assert.equal(await page.locator('.listing li.next').count(), 0);
    // Breakpoints and watches are there after a reload.
    await fill(page, 'Watch', '#100/2');
    await page.reload();
    await ready(page);
    await file(page, 'O9101.nc');
    await page.locator('.listing li.stop[data-if="#125 LT 400"]', { hasText: 'N12 #128' }).waitFor();
    assert.match(await seen(page), /Watches\s+#100\/2/);
  }));

test('endless walk leaves the page responsive, a key stops it', () =>
  withPage(app, {}, async ({ page }) => {
    const text = 'O9101\nN1 #100=0\nN2 #100=#100+1\nGOTO2\nM30\n';
    await page.setInputFiles('#open', { name: 'O9101.nc', mimeType: 'text/plain', buffer: Buffer.from(text) });
    await line(page, 'N2 #100').click();
    await showSteps(page);
    await fill(page, 'Break if', '#100 LT 0');
    await page.locator('.listing').press('c');
    await why(page).getByText('Runs to the next stop').waitFor();
    // Frames follow one another while it runs.
    await page.evaluate(async () => {
      for (let count = 0; count < 60; count++) await new Promise((done) => requestAnimationFrame(done));
    });
    await why(page).getByText('Runs to the next stop').waitFor();
    await page.locator('.listing').press('x');
    await page.locator('.listing li.next').waitFor();
    await page.locator('.listing').press('i');
    await why(page).getByText('Next:').waitFor();
    await page.locator('.listing').press('x');
    assert.equal(await page.locator('.listing li.next').count(), 0);
  }));
