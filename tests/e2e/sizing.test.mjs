// The sizing of a machine on the page: its sheets, a motor taken into the form, a moment of the chart, parts of one's own.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { accessible, enter, openSizing, start, withPage } from './page.mjs';

let app;
before(async () => (app = await start()));
after(() => app.close());

test('motor of the list enters the form, bill follows', () =>
  withPage(app, {}, async ({ page }) => {
    await openSizing(page);
    const motor = page.locator('.bill li', { hasText: 'Pull roller: Motor' });
    assert.match(await motor.innerText(), /^Pull roller: Motor, proposal\s+1\s×\s+Mitsubishi Electric HG-KR13\s+.*stall torque 1.3 Nm/);
    await page.getByRole('button', { name: /HG-KR23$/ }).first().click();
    await motor.filter({ hasText: 'HG-KR23' }).waitFor();
    await page.locator('#sizing-x > summary', { hasText: 'HG-KR23' }).waitFor();
    await page.keyboard.press('Control+z');
    await motor.filter({ hasText: 'HG-KR13' }).waitFor();
  }));

test('a line of the torque chart leads to its moment', () =>
  withPage(app, {}, async ({ page }) => {
    await openSizing(page);
    const line = page.locator('.torque [data-at]:not([data-at="0"])').last();
    const at = Number(await line.getAttribute('data-at'));
    await line.dispatchEvent('click');
    await page.waitForFunction((ms) => Math.abs(Number(document.getElementById('head').value) - ms) < 2, 1000 * at);
  }));

test('table parts join the choice, wrong row shows its line', () =>
  withPage(app, {}, async ({ page }) => {
    const rows = [
      'kind,maker,model,rated_speed_rpm,max_speed_rpm,stall_torque_nm,peak_torque_nm,inertia_kgm2,grade',
      'servo,Works,M1,3000,4000,1,3,0.00001,entered',
      'servo,Works,,3000,4000,1,3,0.00001,entered',
    ];
    await page.setInputFiles('#open', { name: 'own.csv', mimeType: 'text/csv', buffer: Buffer.from(`${rows.join('\n')}\n`) });
    await page.getByText('own.csv: ').first().waitFor();
    await openSizing(page);
    // Behind the first five.
    await page.getByText(/^\d+ more$/).first().click();
    await page.getByRole('button', { name: /Works M1$/ }).first().waitFor();
  }));

test('machines are drawn when their section is opened', () =>
  withPage(app, {}, async ({ page }) => {
    await openSizing(page);
    await page.click('#sizing-chance > summary');
    await page.getByText(/Every verdict holds in .* % of 10000 machines/).waitFor({ timeout: 60_000 });
    await page.locator('#sizing-chance > summary', { hasText: /Every verdict holds in .* % of the machines/ }).waitFor();
  }));

test('cancelled draw of machines runs again by a button', () =>
  withPage(app, {}, async ({ page }) => {
    await openSizing(page);
    await page.click('#sizing-chance > summary');
    // Dispatched without waiting: the button is visible only during a slow answer.
    await page.locator('.working').nth(1).locator('button').dispatchEvent('click');
    await page.getByText('Cancelled').waitFor();
    await page.getByRole('button', { name: 'Run again' }).click();
    await page.getByText(/Every verdict holds in .* % of 10000 machines/).waitFor({ timeout: 60_000 });
    // A new worker replaces the cancelled one: the sizing goes on.
    await page.getByRole('button', { name: /HG-KR23$/ }).first().click();
    await page.locator('#sizing-x > summary', { hasText: 'HG-KR23' }).waitFor();
  }));

test('variants are kept, compared, taken and undone', () =>
  withPage(app, {}, async ({ page }) => {
    await openSizing(page);
    const section = page.locator('section.variants');
    const pitch = section.locator('tbody tr', { hasText: 'Pitch mm' });
    await page.getByRole('button', { name: 'Keep as variant' }).click();
    await section.getByText('Nothing differs.').waitFor();
    await enter(page.locator('#pitch'), '20');
    await pitch.locator('td').first().getByText('20', { exact: true }).waitFor();
    assert.deepEqual(await pitch.locator('td').allInnerTexts(), ['20', '10']);
    // The second variant by the keyboard, under its own name.
    await enter(page.getByRole('textbox', { name: 'Name of the variant' }), 'Wide');
    await section.locator('thead .name', { hasText: 'Wide' }).waitFor();
    await page.waitForFunction(() => document.querySelectorAll('.variants tbody td').length % 3 === 0);
    await page.locator('.sizing[aria-busy="false"]').waitFor();
    await accessible(page);
    // A beside the form, then beside the other variant: machines, entries and program in three clicks.
    await page.getByRole('button', { name: 'Compare variant A in motion' }).click();
    const dialog = page.locator('dialog[open]');
    await dialog.getByRole('row', { name: /^Pitch mm 20 10/ }).waitFor();
    await dialog.locator('.sides .scene').nth(1).waitFor();
    await dialog.locator('.editor .cm-content').waitFor();
    await dialog.getByRole('combobox', { name: 'Left side of the comparison' }).selectOption({ label: 'Wide' });
    await dialog.locator('thead', { hasText: 'Wide' }).waitFor();
    await accessible(page);
    await page.keyboard.press('Escape');
    await page.getByRole('button', { name: 'Use variant A in the form' }).press('Enter');
    await page.waitForFunction(() => document.getElementById('pitch').value === '10');
    await page.waitForFunction(() => document.querySelector('.variants tbody td')?.innerText === '10');
    assert.deepEqual(await pitch.locator('td').allInnerTexts(), ['10', '10', '20']);
    assert.equal(await page.evaluate(() => document.activeElement.getAttribute('aria-label')), 'Use variant A in the form');
    await page.locator('.variants h3').click();
    await page.keyboard.press('Control+z');
    await page.waitForFunction(() => document.getElementById('pitch').value === '20');
    // The variants are there after a reload.
    await page.waitForFunction(() => JSON.parse(localStorage.getItem('macroline.project')).values.pitch === 20);
    await page.reload();
    await page.locator('#tab-sizing').click();
    assert.deepEqual(await section.locator('thead .name').allInnerTexts(), ['A', 'Wide']);
    await page.getByRole('button', { name: 'Remove variant A' }).click();
    assert.deepEqual(await section.locator('thead .name').allInnerTexts(), ['Wide']);
  }));

for (const viewport of [{ width: 1440, height: 900 }, { width: 1366, height: 768 }, { width: 390, height: 844 }]) {
  test(`no sheet is cut off at ${viewport.width} px`, () =>
    withPage(app, { viewport }, async ({ page }) => {
      for (const machine of ['Ribbon line', 'Turning spindle', 'Polygon lathe']) {
        await page.locator('.segments button', { hasText: machine }).click();
        await openSizing(page);
        const wide = await page.evaluate(() =>
          [...document.querySelectorAll('.sizing .scroll')]
            .filter((box) => box.scrollWidth > box.clientWidth + 1)
            .map((box) => `${box.getAttribute('aria-label')}: ${box.scrollWidth} in ${box.clientWidth}`),
        );
        assert.deepEqual(wide, [], machine);
      }
    }));
}
