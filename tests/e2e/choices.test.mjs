// Another control, another machine, or a file that names them: all entries stay, and undo goes back.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { PAPER, accessible, enter, field, goTo, line, listing, openPanel, ready, saved, showSteps, start, takeExample, withPage } from './page.mjs';

let app;
before(async () => (app = await start()));
after(() => app?.close());

const CONTROL = 'sinumerik-802d';
const chosen = (page) => page.locator('select.control').inputValue();
const choose = async (page, control = CONTROL) => {
  await page.locator('select.control').focus();
  await page.selectOption('select.control', control);
};
const machine = (page, name) => page.locator('.segments button', { hasText: name });

test('another control keeps all input and writes its own words', () =>
  withPage(app, {}, async ({ page }) => {
    await field(page, 'pitch').fill('9.5');
    await field(page, 'spindle-speed').fill('900');
    await page.getByLabel('Name of the project').fill('Customer 4711');
    await field(page, 'heads').fill('six');
    await page.click('#tab-results');
    await goTo(page, 0.05);
    await choose(page);
    await page.locator('#form small', { hasText: 'R10' }).first().waitFor();
    assert.equal(await field(page, 'pitch').inputValue(), '9.5');
    assert.equal(await field(page, 'heads').inputValue(), 'six');
    assert.equal(await field(page, 'heads').getAttribute('aria-invalid'), 'true');
    assert.equal(await page.getByLabel('Name of the project').inputValue(), 'Customer 4711');
    assert.equal(await page.locator('#tab-results').getAttribute('aria-selected'), 'true');
    assert.match(await page.locator('#clock').textContent(), /00:00\.0500/);
    assert.ok(await page.locator('select.control').evaluate((select) => select === document.activeElement));
    await page.click('#tab-program');
    await page.getByRole('button', { name: 'MPF9102.MPF' }).click();
    await line(page, 'R107=9.5').waitFor();
    // One key is one step.
    await page.locator('h1').click();
    await page.keyboard.press('Control+z');
    await line(page, '#107=9.5').waitFor();
    assert.equal(await chosen(page), 'mitsubishi-e60');
    for (const _ of ['name', 'speed']) await page.keyboard.press('Control+z');
    assert.equal(await field(page, 'spindle-speed').inputValue(), '1200');
    assert.equal(await field(page, 'pitch').inputValue(), '9.5');
    await page.keyboard.press('Control+z');
    assert.equal(await field(page, 'pitch').inputValue(), '10');
    assert.ok(await page.getByRole('button', { name: 'Undo' }).isDisabled());
    for (const _ of [1, 2, 3, 4]) await page.keyboard.press('Control+Shift+z');
    await line(page, 'R107=9.5').waitFor();
    assert.equal(await chosen(page), CONTROL);
  }));

test('802D runs, takes variables and settings, and exports', () =>
  withPage(app, {}, async ({ page }) => {
    await field(page, 'spindle-speed').fill('900');
    await choose(page);
    await goTo(page, 4);
    await page.locator('[aria-current="step"]', { hasText: 'G1' }).waitFor();
    await openPanel(page);
    await page.locator('#spindle-knob').press('ArrowLeft');
    await page.waitForFunction(() => /Spindle override 99 %/.test(document.querySelector('#changed').textContent));
    await page.click('#tab-variables');
    const pitch = page.getByLabel('R107', { exact: true });
    await enter(pitch, '12');
    await page.waitForFunction(() => /R107 = 12/.test(document.querySelector('#changed').textContent));
    await page.getByRole('tab', { name: 'Parameters' }).click();
    await page.getByText('MD30130').waitFor();
    await page.getByLabel('Words of X (MD20100)').selectOption('radius');
    await accessible(page);
    await page.click('#tab-program');
    await page.getByRole('button', { name: 'L9100.SPF' }).click();
    await line(page, /R129=R107\*R128(?!\*2)/).waitFor();
    await page.click('#export');
    const row = page.getByRole('row', { name: /MPF9101\.MPF/ });
    const file = await saved(page, () => row.getByRole('button').click());
    assert.match(file.toString('latin1'), /^%_N_MPF9101_MPF\r?\n;\$PATH=\/_N_MPF_DIR/);
  }));

test('control too slow for the line offers the speed it can run', () =>
  withPage(app, {}, async ({ page }) => {
    await takeExample(page, PAPER);
    for (const [control, message] of [['gsk-980tdc', '5920 FEED #115 ABOVE LIMIT #119'], ['sinumerik-802d', 'FEED R115 ABOVE LIMIT R119']]) {
      await choose(page, control);
      const screen = page.locator('.alarm-screen');
      await screen.getByRole('heading', { name: message }).waitFor();
      await page.locator('.mode', { hasText: 'Stops at once' }).waitFor();
      assert.ok(await page.locator('.lit.start').isDisabled(), 'cycle start promises nothing');
      await accessible(page);
      await screen.getByRole('button', { name: /^Set \d+ r\/min$/ }).click();
      await screen.waitFor({ state: 'detached' });
      await page.locator('.mode', { hasText: 'Ready' }).waitFor();
      await page.getByRole('button', { name: 'Undo' }).click();
      await screen.waitFor();
    }
  }));

test('alarm on a phone is a bar that opens to its whole text', () =>
  withPage(app, { viewport: { width: 390, height: 844 } }, async ({ page }) => {
    await takeExample(page, PAPER);
    await choose(page, 'gsk-980tdc');
    const screen = page.locator('.alarm-screen');
    await screen.getByRole('heading', { name: '5920 FEED #115 ABOVE LIMIT #119' }).waitFor();
    const boxes = () => Promise.all(['#machine', '.alarm-screen'].map((selector) => page.locator(selector).boundingBox()));
    const [stage, bar] = await boxes();
    // Buttons of the picture and notices: left, top, right, bottom.
    const beside = await page.locator('.band .icon:not(.notice .icon), .notices').evaluateAll((parts) => parts.map((part) => part.getBoundingClientRect()).map((b) => [b.left, b.top, b.right, b.bottom]));
    assert.ok(bar.height <= 44 && bar.height <= 0.15 * stage.height, `${bar.height} of ${stage.height}`);
    // Over the lower edge, beside the buttons of the picture.
    assert.ok(bar.y + bar.height <= stage.y + stage.height && bar.y > stage.y + 0.8 * stage.height, JSON.stringify({ stage, bar }));
    assert.ok(bar.x >= stage.x && beside.length > 2, `${beside.length}`);
    for (const [left, top, right, bottom] of beside) {
      assert.ok(bar.x + bar.width <= left || bar.y + bar.height <= top || bottom <= bar.y, JSON.stringify({ bar, left, top, right, bottom }));
    }
    const remedy = screen.getByRole('button', { name: /^Set \d+ r\/min$/ });
    assert.ok(!(await remedy.isVisible()));
    await screen.getByRole('button', { name: 'Why' }).click();
    assert.ok(await remedy.isVisible());
    const [, open] = await boxes();
    assert.ok(open.y >= stage.y && open.y + open.height <= stage.y + stage.height);
    await accessible(page);
    await screen.getByRole('button', { name: 'Less' }).click();
    assert.deepEqual((await boxes())[1], bar);
  }));

test('impossible value is counted and leads to its field', () =>
  withPage(app, {}, async ({ page }) => {
    await takeExample(page, PAPER);
    await field(page, 'press-roller-diameter').fill('150');
    const wrong = page.getByRole('button', { name: '2 values to correct' });
    await wrong.waitFor();
    assert.equal(await page.getByText('Results before the invalid entry').count(), 0);
    await wrong.click();
    await page.waitForFunction(() => document.activeElement.id === 'clamp-x');
  }));

test('the 802D is debugged and edited in its own words', () =>
  withPage(app, {}, async ({ page }) => {
    await page.getByRole('button', { name: 'Turning spindle' }).click();
    await line(page, 'G96 S#1 M3').waitFor();
    await choose(page);
    await line(page, 'G96 S=R1 LIMS=R8 M3').waitFor();
    await page.locator('.listing li', { hasText: 'LB32: IF' }).click();
    await showSteps(page);
    await enter(page.getByPlaceholder('Break if R1<3'), 'R11<2');
    await page.locator('.listing li.stop').waitFor();
    await page.getByRole('button', { name: 'Run to a breakpoint or the end' }).click();
    await page.locator('.listing li.next', { hasText: 'LB32: IF' }).waitFor();
    await enter(page.getByPlaceholder('Watch R100*2'), 'R11*2');
    await page.locator('.seen p', { hasText: 'R11*2' }).filter({ hasText: '2' }).waitFor();
    await page.getByRole('button', { name: 'Edit', exact: true }).click();
    const editor = page.locator('.editor .cm-content');
    await editor.waitFor();
    assert.equal(await page.locator('.editor .t-v', { hasText: /^R11$/ }).first().textContent(), 'R11');
    await editor.press('Control+Home');
    for (const key of ['ArrowDown', 'ArrowDown', 'Home']) await editor.press(key);
    await page.keyboard.type('G1 X=R1+*2\n');
    await page.getByText('Edited program.').waitFor();
    await page.locator('.editor .cm-lintRange-error').first().waitFor();
    await page.getByRole('button', { name: 'Edit', exact: true }).click();
    await page.locator('.listing[aria-busy=false]').waitFor();
    await page.locator('.listing li:has-text("G1 X=R1+*2") + .says.fail').waitFor();
    await accessible(page);
  }));

test('a reload keeps the chosen control', () =>
  withPage(app, {}, async ({ page }) => {
    for (const [control, variable] of [[CONTROL, 'R100'], ['gsk-980tdc', '#100']]) {
      await choose(page, control);
      await line(page, variable).waitFor();
      await page.reload();
      await ready(page);
      assert.equal(await chosen(page), control);
      await line(page, variable).waitFor();
    }
  }));

test('another machine is opened fresh, and undo goes back', () =>
  withPage(app, {}, async ({ page }) => {
    await field(page, 'pitch').fill('9.5');
    await machine(page, 'Polygon lathe').click();
    await line(page, 'G512').waitFor();
    assert.deepEqual(await page.locator('select.control option').allTextContents(), ['KND K2000T']);
    await machine(page, 'Turning spindle').click();
    await choose(page, 'knd-k2000t');
    await line(page, 'G96 S#1 M3').waitFor();
    assert.equal(await machine(page, 'Turning spindle').getAttribute('aria-pressed'), 'true');
    await page.locator('h1').click();
    for (const _ of ['control', 'turning spindle', 'polygon lathe']) await page.keyboard.press('Control+z');
    assert.equal(await machine(page, 'Ribbon line').getAttribute('aria-pressed'), 'true');
    assert.equal(await field(page, 'pitch').inputValue(), '9.5');
  }));

test('files of another control open: project, written, kept', () =>
  withPage(app, {}, async ({ page, context }) => {
    await choose(page);
    await line(page, 'R100').waitFor();
    await field(page, 'pitch').fill('7.25');
    const project = await saved(page, () => page.getByRole('button', { name: 'Save', exact: true }).click());
    await page.getByRole('button', { name: 'L9100.SPF' }).click();
    await line(page, 'PITCH=7.25').waitFor();
    const program = await listing(page);
    for (const [name, buffer] of [['project.json', project], ['L9100.SPF', Buffer.from(program)]]) {
      await page.evaluate(() => {
        window.addEventListener('pagehide', () => localStorage.clear());
      });
      await page.reload();
      await ready(page);
      assert.equal(await chosen(page), 'mitsubishi-e60');
      await page.setInputFiles('#open', { name, mimeType: 'text/plain', buffer });
      await line(page, 'R100').waitFor();
      assert.equal(await chosen(page), CONTROL);
      assert.equal(await field(page, 'pitch').inputValue(), '7.25', name);
      await page.getByRole('button', { name: 'Undo' }).click();
      assert.equal(await chosen(page), 'mitsubishi-e60');
    }
    const fresh = await context.newPage();
    await fresh.goto(app.url);
    await ready(fresh);
    await fresh.evaluate((text) => {
      window.addEventListener('pagehide', () => {
        localStorage.clear();
        localStorage.setItem('macroline.project', text);
      });
    }, project.toString());
    await fresh.reload();
    await ready(fresh);
    assert.equal(await chosen(fresh), CONTROL);
    assert.equal(await field(fresh, 'pitch').inputValue(), '7.25');
  }));

