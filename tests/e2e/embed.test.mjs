// The page inside another one: a machine at work, three fields, and the link to the whole page.
import assert from 'node:assert/strict';
import { createServer } from 'node:http';
import { after, before, test } from 'node:test';
import { accessible, enter, ready, start, withPage } from './page.mjs';
import { words } from './words.mjs';

let app;
before(async () => (app = await start()));
after(() => app?.close());

// A page of another host with the machine in a frame, given to `act` with the frame.
async function inside(fragment, options, act) {
  const html = `<!doctype html><html lang="en"><title>Our machine</title><body style="margin: 0"><h1>Our machine</h1>
    <iframe src="${app.url}#${fragment}" title="macroline" width="100%" height="720" style="border: 0"></iframe></html>`;
  const host = createServer((_, response) => response.writeHead(200, { 'Content-Type': 'text/html; charset=utf-8' }).end(html));
  await new Promise((done) => host.listen(0, 'localhost', done));
  try {
    await withPage(app, options, async ({ page, context }) => {
      await page.goto(`http://localhost:${host.address().port}/`);
      const frame = await (await page.locator('iframe').elementHandle()).contentFrame();
      await frame.waitForFunction(() => document.querySelector('main')?.getAttribute('aria-busy') === 'false');
      await act({ frame, context });
    });
  } finally {
    await new Promise((done) => (host.close(done), host.closeAllConnections()));
  }
}

const playsOn = (frame) => frame.waitForFunction(() => document.getElementById('clock').textContent > '00:00.5');

test('embedded machine runs, follows fields, links to the page', () =>
  inside('embed&machine=turning-spindle', {}, async ({ frame, context }) => {
    assert.equal(await frame.locator('.field').count(), 3);
    assert.equal(await frame.locator('h1').textContent(), 'Turning spindle');
    await frame.click('#play');
    await playsOn(frame);
    const before = await frame.locator('.verdicts').textContent();
    const field = frame.locator('.field input.number').first();
    await enter(field, '60');
    await frame.waitForFunction((before) => document.querySelector('.verdicts').textContent !== before, before);
    await accessible(frame);
    const [whole] = await Promise.all([context.waitForEvent('page'), frame.getByRole('link', { name: 'Open in macroline' }).click()]);
    await ready(whole);
    assert.equal(await whole.locator('.segments [aria-pressed=true]').getAttribute('aria-label'), 'Turning spindle');
    assert.equal(await whole.locator(`#${await field.getAttribute('id')}`).inputValue(), '60');
  }));

test('frame address sets machine, language and unit', () =>
  inside('embed&machine=turning-spindle', {}, async ({ frame }) => {
    await frame.page().evaluate(() => {
      const frame = document.querySelector('iframe');
      frame.src = frame.src.replace('turning-spindle', 'polygon-lathe&lang=zh&lengths=inch');
    });
    await frame.waitForFunction((title) => document.querySelector('h1')?.textContent === title, words('zh')('polygon.name'));
    assert.deepEqual(await frame.locator('.field .unit').allTextContents(), ['in', 'in', 'in']);
  }));

test('share element shows the project and stores nothing', () =>
  withPage(app, {}, async ({ page }) => {
    await enter(page.locator('#pitch'), '9.5');
    await page.getByRole('button', { name: 'Share', exact: true }).click();
    await accessible(page);
    const element = await page.getByLabel(words('en')('page.embed-frame')).inputValue();
    const fragment = element.match(/src="[^"#]*#([^"]*)"/)[1].replaceAll('&amp;', '&');
    await inside(fragment, {}, async ({ frame }) => {
      assert.ok((await frame.locator('.stage').textContent()).includes('9.5 mm'));
      await enter(frame.locator('.field input.number').first(), '60');
      await frame.waitForTimeout(600);
      // Three keys belong to the whole page, which the test opened before and left.
      const kept = await frame.evaluate(() => Object.keys(localStorage));
      assert.deepEqual(kept.filter((key) => !['macroline.place', 'macroline.tab', 'macroline.stepping'].includes(key)), []);
    });
  }));

test('address sets the language, unknown machine is reported', () =>
  inside('embed&machine=loom&lang=zh', {}, async ({ frame }) => {
    assert.equal(await frame.locator('html').getAttribute('lang'), 'zh');
    assert.ok(await frame.getByRole('link', { name: words('zh')('page.embed-open') }).isVisible());
    assert.match(await frame.locator('.notice').textContent(), /ribbon-line/);
  }));

for (const [width, colorScheme] of [[320, 'light'], [375, 'dark'], [390, 'light'], [768, 'light'], [1200, 'dark']]) {
  test(`all of a frame is in sight (${width} px, ${colorScheme})`, () =>
    inside('embed', { viewport: { width, height: 800 }, colorScheme }, async ({ frame }) => {
      const hidden = await frame.evaluate(() => {
        const parts = ['.stage svg', '#play', '.scrub', '.verdicts li', '.field', 'footer a'].flatMap((selector) => [...document.querySelectorAll(selector)]);
        const sight = document.documentElement;
        return [sight.scrollWidth - sight.clientWidth, ...parts.map((part) => part.getBoundingClientRect().right - sight.clientWidth)].filter((beyond) => beyond > 1);
      });
      assert.deepEqual(hidden, []);
      await accessible(frame);
    }));
}
