// A person asks for what the first module lacks: the whole one goes on with what he has, and he notices nothing but the time it takes.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { after, before, test } from 'node:test';
import { accessible, ready, start, withPage } from './page.mjs';

let app;
before(async () => (app = await start()));
after(() => app?.close());

const CONTROL = 'sinumerik-802d';
const WHOLE = /whole(_bg)?\.(js|wasm)/;
const field = (page, id) => page.locator(`#${id}`);
const line = (page, text) => page.locator('.listing li', { hasText: text }).first();
const chosen = (page) => page.locator('select.control').inputValue();
const choose = async (page, control = CONTROL) => {
  await page.locator('select.control').focus();
  await page.selectOption('select.control', control);
};
const arrived = (page) => page.locator('#form small', { hasText: 'R10' }).first().waitFor();
const goTo = async (page, t) => {
  await page.fill('#go-to', String(t));
  await page.press('#go-to', 'Enter');
};

test('a control of the whole module is chosen: the program is written in its words, and all that was done can be undone', () =>
  withPage(app, {}, async ({ page, requests }) => {
    await field(page, 'pitch').fill('9.5');
    await field(page, 'spindle-speed').fill('900');
    await page.getByLabel('Name of the project').fill('Customer 4711');
    await field(page, 'heads').fill('six');
    await page.click('#tab-results');
    await goTo(page, 0.05);
    assert.ok(!requests.some((name) => WHOLE.test(name)), 'the page opens with the first module');
    await choose(page);
    await arrived(page);
    assert.equal(requests.filter((name) => name === 'whole_bg.wasm').length, 1);
    assert.equal(await page.locator('body > .app').count(), 1);
    assert.equal(await page.locator('#boot').count(), 0);
    // All is as it was left: values, what is typed and wrong, name, tab, play head, and where the keys go.
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
    // Each step once: the keys are heard by one module alone.
    await page.locator('h1').click();
    await page.keyboard.press('Control+z');
    await line(page, '#107=9.5').waitFor();
    assert.equal(await chosen(page), 'mitsubishi-e60');
    for (const _ of ['name', 'speed']) await page.keyboard.press('Control+z');
    assert.equal(await field(page, 'spindle-speed').inputValue(), '1200');
    assert.equal(await field(page, 'pitch').inputValue(), '9.5');
    await page.keyboard.press('Control+z');
    assert.equal(await field(page, 'pitch').inputValue(), '8');
    assert.ok(await page.getByRole('button', { name: 'Undo' }).isDisabled());
    for (const _ of [1, 2, 3, 4]) await page.keyboard.press('Control+Shift+z');
    await line(page, 'R107=9.5').waitFor();
    assert.equal(await chosen(page), CONTROL);
    assert.equal(requests.filter((name) => name === 'whole_bg.wasm').length, 1);
  }));

test('it runs, variables are set, open points act, and it is exported', () =>
  withPage(app, {}, async ({ page }) => {
    await field(page, 'spindle-speed').fill('900');
    await choose(page);
    await arrived(page);
    await goTo(page, 4);
    await page.locator('[aria-current="step"]', { hasText: 'G1' }).waitFor();
    await page.locator('#spindle-knob').press('ArrowLeft');
    await page.waitForFunction(() => /Spindle override 99 %/.test(document.querySelector('#changed').textContent));
    await page.click('#tab-variables');
    const pitch = page.getByLabel('R107', { exact: true });
    await pitch.fill('10');
    await pitch.press('Enter');
    await page.waitForFunction(() => /R107 = 10/.test(document.querySelector('#changed').textContent));
    await page.getByRole('tab', { name: 'Parameters' }).click();
    await page.getByText('MD30130').waitFor();
    await page.getByLabel('Words of X (MD20100)').selectOption('radius');
    await accessible(page);
    await page.click('#tab-program');
    await page.getByRole('button', { name: 'L9100.SPF' }).click();
    await line(page, /R129=R107\*R128(?!\*2)/).waitFor();
    await page.click('#export');
    const row = page.getByRole('row', { name: /MPF9101\.MPF/ });
    const [download] = await Promise.all([page.waitForEvent('download'), row.getByRole('button').click()]);
    assert.match(await readFile(await download.path(), 'latin1'), /^%_N_MPF9101_MPF\r?\n;\$PATH=\/_N_MPF_DIR/);
  }));

test('a bad line is marked where it stands, in the listing and in the editor, and the debugger stops at a condition', () =>
  withPage(app, {}, async ({ page }) => {
    await page.getByRole('button', { name: 'Turning spindle' }).click();
    await line(page, 'G96 S#100 M3').waitFor();
    await choose(page);
    await line(page, 'G96 S=R100 LIMS=R107 M3').waitFor();
    await page.locator('.listing li', { hasText: 'LB31: IF' }).click();
    await page.getByPlaceholder('Break if R1<3').fill('R110<2');
    await page.getByPlaceholder('Break if R1<3').press('Enter');
    await page.locator('.listing li.stop').waitFor();
    await page.getByRole('button', { name: 'Run to a breakpoint or the end' }).click();
    await page.locator('.listing li.next', { hasText: 'LB31: IF' }).waitFor();
    await page.getByPlaceholder('Watch R100*2').fill('R110*2');
    await page.getByPlaceholder('Watch R100*2').press('Enter');
    await page.locator('.seen p', { hasText: 'R110*2' }).filter({ hasText: '2' }).waitFor();
    await page.getByRole('button', { name: 'Edit', exact: true }).click();
    const editor = page.locator('.editor .cm-content');
    await editor.waitFor();
    assert.equal(await page.locator('.editor .t-v', { hasText: 'R100' }).first().textContent(), 'R100');
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

test('a reload keeps it, with the whole module alone; back on another control the next visit is the first module’s', () =>
  withPage(app, {}, async ({ page, requests }) => {
    await choose(page);
    await page.getByText('Saved in this browser').waitFor();
    await line(page, 'R100').waitFor();
    await page.waitForTimeout(400);
    requests.length = 0;
    await page.reload();
    await ready(page);
    assert.equal(await chosen(page), CONTROL);
    await line(page, 'R100').waitFor();
    assert.ok(!requests.some((name) => /^app.*wasm/.test(name)), requests.join(' '));
    await choose(page, 'gsk-980tdc');
    await line(page, '#100').waitFor();
    await page.waitForTimeout(400);
    requests.length = 0;
    await page.reload();
    await ready(page);
    assert.equal(await chosen(page), 'gsk-980tdc');
    assert.ok(!requests.some((name) => WHOLE.test(name)), requests.join(' '));
  }));

test('files that need the whole module open directly: a project, a program that macroline wrote, a kept project that nothing is known of', () =>
  withPage(app, {}, async ({ page, context }) => {
    await choose(page);
    await line(page, 'R100').waitFor();
    await field(page, 'pitch').fill('7.25');
    const [download] = await Promise.all([page.waitForEvent('download'), page.getByRole('button', { name: 'Save', exact: true }).click()]);
    const project = await readFile(await download.path());
    await page.getByRole('button', { name: 'L9100.SPF' }).click();
    await line(page, 'PITCH=7.25').waitFor();
    const program = (await page.locator('.listing li[data-l] code').allTextContents()).join('\n');
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

test('without the network the user stays where he is, is told, and may try again', async () => {
  const away = ({ message, actual }) => {
    assert.ok(actual?.every((text) => /whole|Failed to load resource/.test(text)), `${message} ${actual}`);
    return true;
  };
  const offline = async ({ page, context }) => {
    await field(page, 'pitch').fill('9.5');
    await context.setOffline(true);
    await choose(page);
    await page.locator('.notice.fail', { hasText: 'could not be loaded' }).waitFor();
    assert.equal(await chosen(page), 'mitsubishi-e60');
    assert.equal(await field(page, 'pitch').inputValue(), '9.5');
    assert.equal(await page.locator('#boot').count(), 0);
    await page.keyboard.press('Escape');
    await context.setOffline(false);
    await choose(page);
    await arrived(page);
    assert.equal(await field(page, 'pitch').inputValue(), '9.5');
    assert.equal(await page.locator('.notice.fail').count(), 0);
  };
  await assert.rejects(withPage(app, {}, offline), away);
});

// The whole module comes when the test lets it come.
const late = async (page) => {
  let go;
  const wait = new Promise((done) => (go = done));
  await page.route(/whole_bg\.wasm/, async (route) => {
    await wait;
    await route.continue();
  });
  return go;
};
const handed = (page) => page.waitForFunction(() => window.first && !window.first.isConnected);
const machine = (page, name) => page.locator('.segments button', { hasText: name });
// Types while the page changes hands: some letters before, and more after, without waiting for anything.
const typeOver = async (page, go, keys, act) => {
  await page.evaluate(() => (window.first = document.querySelector('.app')));
  let over = false;
  const done = handed(page).then(() => (over = true));
  let sent = '';
  const type = async () => {
    const key = keys[sent.length % keys.length];
    await page.keyboard.type(key);
    sent += key;
  };
  for (let at = 0; at < 12; at++) {
    await type();
    if (at === 4) go();
    await page.waitForTimeout(40);
  }
  // Now a person stops to think, and goes on at any moment: as early as the page can have changed, and later.
  while (!over) {
    await act?.();
    await page.waitForTimeout(230);
    await type();
  }
  await done;
  for (let at = 0; at < 5; at++) await type();
  return sent;
};

test('what is typed into a field while the page changes hands is there, letter by letter, and nothing else happens', () =>
  withPage(app, {}, async ({ page }) => {
    const go = await late(page);
    await choose(page);
    const name = page.getByLabel('Name of the project');
    await name.click();
    const sent = await typeOver(page, go, 'a. b,?s');
    assert.equal(await name.inputValue(), sent);
    assert.ok(await name.evaluate((input) => input === document.activeElement));
    assert.equal(await page.locator('dialog[open]').count(), 0);
    assert.equal(await page.locator('#clock').textContent(), '00:00.0000');
    await arrived(page);
    // A number goes on where it was, and its text is the value.
    await field(page, 'pitch').fill('9.12');
    await line(page, '9.12').waitFor();
  }));

test('a number that is typed while the page changes hands is the value of the project', () =>
  withPage(app, {}, async ({ page }) => {
    const go = await late(page);
    await choose(page);
    await field(page, 'pitch').fill('0.');
    await field(page, 'pitch').press('End');
    await page.evaluate(() => document.querySelector('.form').scrollTo(0, 120));
    const sent = await typeOver(page, go, '1234');
    assert.equal(await field(page, 'pitch').inputValue(), `0.${sent}`);
    // It has more decimals than the field takes.
    assert.equal(await field(page, 'pitch').getAttribute('aria-invalid'), 'true');
    for (let at = sent.length; at > 3; at--) await page.keyboard.press('Backspace');
    assert.equal(await field(page, 'pitch').getAttribute('aria-invalid'), 'false');
    await page.getByRole('button', { name: 'MPF9102.MPF' }).click();
    await line(page, 'R107=0.123').waitFor();
    assert.ok((await page.locator('.form').evaluate((form) => form.scrollTop)) > 60, 'the form stays where it was scrolled to');
  }));

test('what is typed into the editor goes along, up to the last letter, and the cursor stands where it stood', () =>
  withPage(app, {}, async ({ page }) => {
    const go = await late(page);
    await page.getByRole('button', { name: 'Edit', exact: true }).click();
    const editor = page.locator('.editor .cm-content');
    await editor.waitFor();
    await choose(page);
    await editor.press('Control+Home');
    for (const key of ['ArrowDown', 'ArrowDown', 'Home']) await editor.press(key);
    const row = page.locator('.editor .cm-line').nth(2);
    const before = await row.textContent();
    const sent = await typeOver(page, go, 'ABC');
    assert.equal(await row.textContent(), sent + before);
  }));

test('a drag and a dialog are brought to their end before the page changes hands', () =>
  withPage(app, {}, async ({ page }) => {
    const go = await late(page);
    await choose(page);
    await page.evaluate(() => (window.first = document.querySelector('.app')));
    const slider = await page.locator('#spindle-knob').boundingBox();
    await page.mouse.move(slider.x + slider.width / 2, slider.y + slider.height / 2);
    await page.mouse.down();
    go();
    await page.waitForTimeout(600);
    assert.ok(await page.evaluate(() => window.first.isConnected));
    await page.mouse.move(slider.x + slider.width / 4, slider.y + slider.height / 2);
    const turned = page.locator('#spindle-knob ~ output');
    await turned.filter({ hasNotText: '100 %' }).waitFor();
    const percent = await turned.textContent();
    await page.keyboard.press('?');
    await page.mouse.up();
    await page.locator('dialog[open]').waitFor();
    await page.waitForTimeout(500);
    assert.ok(await page.evaluate(() => window.first.isConnected));
    await page.keyboard.press('Escape');
    await handed(page);
    await arrived(page);
    assert.equal(await turned.textContent(), percent);
  }));

test('what is asked for last counts: another machine, a control for it, and back again', () =>
  withPage(app, {}, async ({ page, requests }) => {
    const go = await late(page);
    await field(page, 'pitch').fill('9.5');
    // First one machine, then the other, on a control that goes with it.
    await machine(page, 'Polygon lathe').click();
    await page.locator('#boot', { hasText: 'loading Polygon lathe' }).waitFor();
    await machine(page, 'Turning spindle').click();
    await page.locator('#boot', { hasText: 'loading Turning spindle …' }).waitFor();
    assert.equal(await machine(page, 'Turning spindle').getAttribute('aria-pressed'), 'true');
    assert.equal(await machine(page, 'Ribbon line').getAttribute('aria-pressed'), 'false');
    await choose(page);
    await choose(page, 'knd-k2000t');
    await page.locator('#boot', { hasText: 'loading Turning spindle, KND K2000T …' }).waitFor();
    assert.equal(await chosen(page), 'knd-k2000t');
    // Nothing has changed yet, and the form still counts.
    await field(page, 'pitch').fill('9.25');
    go();
    await line(page, 'G96 S#100 M3').waitFor();
    assert.equal(await chosen(page), 'knd-k2000t');
    assert.equal(await machine(page, 'Turning spindle').getAttribute('aria-pressed'), 'true');
    // Back to what was typed meanwhile: the control, then the machine.
    await page.locator('h1').click();
    for (const _ of [1, 2]) await page.keyboard.press('Control+z');
    assert.equal(await machine(page, 'Ribbon line').getAttribute('aria-pressed'), 'true');
    assert.equal(await field(page, 'pitch').inputValue(), '9.25');
    assert.equal(requests.filter((name) => name === 'whole_bg.wasm').length, 1);
  }));

test('who takes it back stays where he is', () =>
  withPage(app, {}, async ({ page }) => {
    const go = await late(page);
    await page.evaluate(() => (window.first = document.querySelector('.app')));
    for (const [ask, back] of [
      [() => choose(page), () => choose(page, 'mitsubishi-e60')],
      [() => machine(page, 'Turning spindle').click(), () => machine(page, 'Ribbon line').click()],
      [() => choose(page), () => choose(page, 'gsk-980tdc')],
    ]) {
      await ask();
      await page.locator('#boot', { hasText: 'loading' }).waitFor();
      await back();
      await page.locator('#boot').waitFor({ state: 'hidden' });
      assert.equal(await machine(page, 'Ribbon line').getAttribute('aria-pressed'), 'true');
    }
    go();
    await page.waitForFunction(() => !document.getElementById('boot'));
    await page.waitForTimeout(500);
    assert.ok(await page.evaluate(() => window.first.isConnected), 'the first module keeps the page');
    assert.equal(await chosen(page), 'gsk-980tdc');
    // And may ask again.
    await choose(page);
    await arrived(page);
    assert.equal(await chosen(page), CONTROL);
  }));

test('a control that does not go with the machine that is asked for is told', () =>
  withPage(app, {}, async ({ page }) => {
    const go = await late(page);
    await machine(page, 'Polygon lathe').click();
    await choose(page);
    go();
    await page.locator('.notice.warn', { hasText: 'SINUMERIK 802D does not go with this machine' }).waitFor();
    await line(page, 'G512').waitFor();
    assert.equal(await chosen(page), 'knd-k2000t');
  }));

test('while it loads the page works on, and what is done meanwhile is not lost', () =>
  withPage(app, {}, async ({ page }) => {
    let go;
    const wait = new Promise((done) => (go = done));
    await page.route(/whole_bg\.wasm/, async (route) => {
      await wait;
      await route.continue();
    });
    await choose(page);
    await page.locator('#boot', { hasText: 'loading SINUMERIK 802D' }).waitFor();
    assert.equal(await chosen(page), CONTROL);
    await field(page, 'pitch').fill('9.25');
    await accessible(page);
    await page.locator('#go-to').pressSequentially('0.0');
    go();
    await arrived(page);
    await page.keyboard.type('7');
    await page.keyboard.press('Enter');
    await page.waitForFunction(() => document.querySelector('#clock').textContent.startsWith('00:00.0700'));
    assert.equal(await field(page, 'pitch').inputValue(), '9.25');
    await page.locator('h1').click();
    await page.keyboard.press('Control+z');
    assert.equal(await chosen(page), 'mitsubishi-e60');
    assert.equal(await field(page, 'pitch').inputValue(), '9.25');
  }));
