// Speed of the page in Chromium, medians of 50: `node benches/page.mjs` on the existing dist/. Each figure is a line `summary: …`.
import { openGroups, openPanel, processorTime, start, withPage } from '../tests/e2e/page.mjs';

const app = await start();
const field = (page, id) => page.locator(`#${id}`);

function summary(what, milliseconds, asked) {
  const verdict = milliseconds <= asked ? 'met' : 'MISSED';
  console.log(`summary: ${what}: ${milliseconds.toFixed(2)} ms, ${asked} asked: ${verdict}`);
}

// Median of the page's own measures of this name, in ms.
const median = (page, name) =>
  page.evaluate((name) => {
    const all = performance.getEntriesByName(name).map((entry) => entry.duration).sort((a, b) => a - b);
    if (all.length < 40) throw new Error(`${all.length} measures of ${name}`);
    return all[all.length >> 1];
  }, name);

await withPage(app, {}, async ({ page }) => {
  for (let at = 0; at < 50; at++) {
    await field(page, 'spindle-speed').fill(String(1000 + at));
    await page.waitForTimeout(40);
  }
  summary('edit to DOM', await median(page, 'edit'), 8);
  await page.fill('#go-to', '3');
  await page.press('#go-to', 'Enter');
  await page.click('#play');
  await page.waitForFunction(() => performance.getEntriesByName('frame').length > 60, null, { timeout: 60_000 });
  summary('script of a frame', await median(page, 'frame'), 4);
  await page.click('#play');
  await openGroups(page);
  // An hour is longer than the axes stay within the range of the control, unless their coordinates roll over.
  // And longer than the default reel lasts.
  await field(page, 'endless').selectOption('roll-over');
  await field(page, 'y-unit').selectOption('degrees');
  await field(page, 'reel-diameter').fill('1000');
  await field(page, 'pitch-count').fill('10000000');
  await page.fill('#go-to', '3600');
  await page.press('#go-to', 'Enter');
  await page.waitForFunction(() => document.querySelector('#clock').textContent.startsWith('60:00'), null, { timeout: 300_000 });
  await openPanel(page);
  for (let at = 0; at < 50; at++) {
    await page.locator('#spindle-knob').press(at % 2 ? 'ArrowLeft' : 'ArrowRight');
    await page.waitForTimeout(20);
  }
  summary('knob at one hour to DOM', await median(page, 'knob'), 50);
});

// Processor time (ms) of a step of dragging: the slider is walked through once to warm up, and then measured; a step a frame.
async function dragging(page, slider, from, to) {
  const steps = 60;
  const walk = () =>
    slider.evaluate(async (slider, [from, to, steps]) => {
      for (let step = 0; step < steps; step++) {
        slider.value = String(from + ((to - from) * step) / steps);
        slider.dispatchEvent(new Event('input', { bubbles: true }));
        await new Promise((done) => requestAnimationFrame(done));
      }
    }, [from, to, steps]);
  const spent = await processorTime(page);
  await walk();
  const begin = await spent();
  await walk();
  return (1000 * ((await spent()) - begin)) / steps;
}

for (const name of ['Ribbon line', 'Turning spindle', 'Polygon lathe']) {
  await withPage(app, {}, async ({ page }) => {
    await page.getByRole('button', { name }).click();
    const slider = page.locator('#form input.slide').first();
    // Of 400 positions, 200 is the default.
    summary(`${name}, a step of dragging a field's slider, processor time`, await dragging(page, slider, 150, 250), 16.7);
  });
}

await withPage(app, {}, async ({ page }) => {
  await page.getByRole('button', { name: 'Polygon lathe' }).click();
  await page.click('#tab-explore');
  await page.locator('.shape svg').waitFor();
  const slider = page.locator('#explore-tip-radius');
  summary('polygon lathe, a step of dragging with its drawing, processor time', await dragging(page, slider, 30, 60), 16.7);
});

await app.close();
