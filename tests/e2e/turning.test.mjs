// Sizing a turning spindle: values, cut, charts over time and over the diameter, export.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { accessible, field, goTo, openGroups, start, withPage } from './page.mjs';

let app;
before(async () => (app = await start()));
after(() => app?.close());

const card = async (page, label) =>
  (await page.locator('.card', { hasText: label }).first().textContent()).replace(/\s/g, '');
const lathe = (act) =>
  withPage(app, {}, async ({ page }) => {
    await page.getByRole('button', { name: 'Turning spindle' }).click();
    await page.locator('.listing li', { hasText: 'G96 S#1 M3' }).waitFor();
    await act(page);
  });

test('lathe shows its limit, volts and time saved', () =>
  lathe(async (page) => {
    assert.match(await card(page, 'Limit begins'), /31\.83mm/);
    assert.match(await card(page, 'Speed at largest'), /682\.1r\/min/);
    assert.match(await card(page, 'Cutting time'), /17\.7\ds|17\.8\ds/);
    // Elements of the ribbon line alone are absent.
    assert.equal(await page.getByText('Stroboscope').isVisible(), false);
    assert.equal(await page.getByText('Paper’s listing').isVisible(), false);
    await accessible(page);
    // The ladder of the spindle, and its reactions to interruptions.
    await page.click('#tab-plc');
    for (const text of ['Ladder', 'Hold, alarm, reset, emergency stop']) await page.locator('#side', { hasText: text }).waitFor();
    await accessible(page);
  }));

test('speed follows diameter of the cut; charts have the play head', () =>
  lathe(async (page) => {
    const outline = () => page.locator('.stage [data-n="0"]').getAttribute('d');
    const speed = async () => Number((await page.locator('.legend .l1 b').textContent()).replace(/[^\d.]/g, ''));
    const whole = await outline();
    await goTo(page, 8);
    await page.waitForFunction((before) => document.querySelector('.stage [data-n="0"]').getAttribute('d') !== before, whole);
    const slow = await speed();
    await goTo(page, 12);
    await page.waitForFunction((before) => Number(document.querySelector('.legend .l1 b').textContent.replace(/[^\d.]/g, '')) > before, slow + 100);
    const charts = page.locator('.chart-bar .chip');
    assert.equal(await charts.count(), 9);
    let timed = 0;
    for (const chart of await charts.all()) {
      await chart.click();
      await page.locator('figure.chart', { hasText: await chart.textContent() }).waitFor();
      assert.equal(await page.locator('figure.chart .cursor').count(), 1);
      // A press sets the time in charts over time alone.
      timed += await page.locator('figure.chart .over .cursor').count();
    }
    assert.equal(timed, 5);
  }));

test('taper on another control is written for it and exported', () =>
  lathe(async (page) => {
    await openGroups(page);
    await page.selectOption('#path', 'taper');
    await field(page, 'large-diameter').waitFor();
    await page.locator('.listing li', { hasText: 'G01 Z#30 F#2' }).waitFor();
    await page.selectOption('select.control', 'mitsubishi-e60');
    await page.locator('.listing li', { hasText: 'G97 S#10 M3' }).waitFor();
    assert.equal(await field(page, 'speed-mode').isVisible(), false);
    await page.locator('#export').click();
    await page.getByText('O9201.nc').last().waitFor();
  }));
