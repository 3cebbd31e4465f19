// High contrast: text 7:1, borders and curves 4.5:1, in light and dark, by the system's setting and by its button.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { FIREFOX, PAPER, accessible, openGroups, openPanel, start, takeExample, withPage } from './page.mjs';
import { words } from './words.mjs';

let app;
before(async () => (app = await start()));
after(() => app?.close());

const say = words('en');
const TEXT = ['color-contrast-enhanced'];

// Lowest contrast of a property of visible elements against their background.
const lowest = (page, selector, property) =>
  page.evaluate(
    ([selector, property]) => {
      const canvas = document.createElement('canvas').getContext('2d', { willReadFrequently: true });
      const rgba = (colour) => {
        canvas.clearRect(0, 0, 1, 1);
        canvas.fillStyle = colour;
        canvas.fillRect(0, 0, 1, 1);
        return [...canvas.getImageData(0, 0, 1, 1).data].map((part) => part / 255);
      };
      const light = (colour) => {
        const [r, g, b] = rgba(colour).map((part) => (part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4));
        return 0.2126 * r + 0.7152 * g + 0.0722 * b;
      };
      const ground = (element) => {
        for (let at = element.parentElement; at; at = at.parentElement) {
          const colour = getComputedStyle(at).backgroundColor;
          if (rgba(colour)[3] === 1) return colour;
        }
        return getComputedStyle(document.body).backgroundColor;
      };
      const shown = [...document.querySelectorAll(selector)].filter((element) => element.checkVisibility({ visibilityProperty: true, opacityProperty: true }));
      const ratios = shown.map((element) => {
        const [dark, bright] = [getComputedStyle(element)[property], ground(element)].map(light).sort((a, b) => a - b);
        return [(bright + 0.05) / (dark + 0.05), element.outerHTML.slice(0, 120)];
      });
      return ratios.sort(([a], [b]) => a - b)[0];
    },
    [selector, property],
  );

async function strong(page) {
  await accessible(page, TEXT);
  for (const [selector, property] of [
    ['select, input[type="text"]', 'borderTopColor'],
    ['main button:not(:disabled):where(.chip, .icon, .quiet)', 'borderTopColor'],
    ['.plot .line', 'stroke'],
  ]) {
    const found = await lowest(page, selector, property);
    assert.ok(found?.[0] >= 4.5, `${property} of ${found?.[1]}: ${found?.[0]}`);
  }
}

for (const colorScheme of ['light', 'dark'])
  test(`more contrast: text, borders, curves strong, ${colorScheme}`, { skip: FIREFOX && 'its driver has no setting of contrast' }, () =>
    withPage(app, { colorScheme, contrast: 'more' }, async ({ page }) => {
      await strong(page);
      await takeExample(page, PAPER);
      await openPanel(page);
      await openGroups(page);
      await strong(page);
      for (const tab of await page.getByRole('tab').all()) {
        await tab.click();
        await page.getByRole('tabpanel').locator('> *').first().waitFor();
        await strong(page);
      }
      await page.keyboard.press('?');
      await page.waitForFunction(() => document.querySelector('#help-page h3'));
      await accessible(page, TEXT);
    }));

test('high contrast is chosen beside the theme and stays chosen', () =>
  withPage(app, { viewport: { width: 1600, height: 900 } }, async ({ page }) => {
    const ink = () => page.evaluate(() => getComputedStyle(document.body).color);
    const standard = await ink();
    await page.getByRole('button', { name: say('page.contrast-system') }).click();
    assert.notEqual(await ink(), standard);
    await accessible(page);
    await strong(page);
    await page.reload();
    await page.getByRole('button', { name: say('page.contrast-high') }).click();
    assert.equal(await ink(), standard);
  }));
