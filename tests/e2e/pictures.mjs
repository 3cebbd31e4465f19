// Pictures of every view in its sizes, themes and languages, taken into target/pictures and compared with the last accepted ones in
// .pictures. Accepted pictures belong to one machine, because fonts and browsers draw differently. Differences are listed and marked in
// NAME.diff.png; the status is then 1. `node tests/e2e/pictures.mjs` (make pictures); `--accept` replaces the old ones with the new (make
// accept-pictures); a part of a name selects the pictures whose names hold it.
import { copyFileSync, existsSync, mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import pixelmatch from 'pixelmatch';
import { PNG } from 'pngjs';
import { openGroups, openPanel, showSteps, start, withPage } from './page.mjs';
import { words } from './words.mjs';

const folder = (path) => fileURLToPath(new URL(`../../${path}/`, import.meta.url));
const TAKEN = folder('target/pictures');
const ACCEPTED = folder('.pictures');

const LARGE = { width: 1440, height: 900 };
const PHONE = { width: 390, height: 844 };
const LOOKS = ['light', 'dark'].flatMap((theme) => ['en', 'zh'].map((language) => [theme, language]));
const SIZES = [LARGE, { width: 1366, height: 768 }, { width: 1920, height: 1080 }, { width: 1024, height: 768 }, PHONE];

// Actions before a picture, by the page and the sentences of its language.
const machine = (id) => (page, say) => page.getByRole('button', { name: say(id), exact: true }).click();
const tab = (id) => (page) => page.click(`#tab-${id}`);
const button = (id) => (page, say) => page.getByRole('button', { name: say(id), exact: true }).click();
// Time into the run at which the machine has made something.
const later = (act, seconds) => async (page, say) => {
  await act(page, say);
  const ms = 1000 * seconds;
  await page.waitForFunction((ms) => Number(document.getElementById('head').max) >= ms, ms);
  await page.locator('#head').fill(String(ms));
};
const errors = async (page, say) => {
  await button('page.paper')(page, say);
  await page.locator('.mode', { hasText: say('page.mode-errors') }).waitFor();
};

// The machines in every size, elements over and beside them in two. Each in both themes and languages.
const VIEWS = [
  ['ribbon', SIZES, later(() => {}, 3)],
  ['turning', SIZES, later(machine('turning.name'), 8)],
  ['polygon', SIZES, later(machine('polygon.name'), 4)],
  ['machine-data', [LARGE, PHONE], openGroups],
  ['panel', [LARGE, PHONE], openPanel],
  ['results', [LARGE, PHONE], tab('results')],
  ['sizing', [LARGE, PHONE], async (page) => (await tab('sizing')(page), await page.locator('.sizing .section').first().waitFor())],
  ['ways', [LARGE, PHONE], async (page, say) => (await machine('polygon.name')(page, say), await tab('explore')(page))],
  ['variables', [LARGE, PHONE], tab('variables')],
  ['parameters', [LARGE, PHONE], tab('parameters')],
  ['plc', [LARGE, PHONE], tab('plc')],
  ['stepping', [LARGE, PHONE], showSteps],
  ['editor', [LARGE, PHONE], button('page.edit')],
  ['errors', [LARGE, PHONE], errors],
  ['gallery', [LARGE, PHONE], async (page, say) => (await button('page.new')(page, say), await page.locator('.gallery img').first().waitFor())],
  ['projects', [LARGE, PHONE], async (page) => (await page.click('#projects'), await page.locator('.projects img').first().waitFor())],
  ['share', [LARGE, PHONE], button('page.share')],
  ['export', [LARGE, PHONE], (page) => page.click('#export')],
  ['help', [LARGE, PHONE], button('page.help')],
];

// Takes the pictures whose names hold `part`; gives the names.
async function take(part) {
  mkdirSync(TAKEN, { recursive: true });
  readdirSync(TAKEN).forEach((name) => rmSync(TAKEN + name));
  const taken = [];
  const app = await start();
  for (const [view, sizes, act] of VIEWS) {
    for (const viewport of sizes) {
      for (const [colorScheme, locale] of LOOKS) {
        const name = `${view}-${viewport.width}-${colorScheme}-${locale}.png`;
        if (!name.includes(part)) continue;
        await withPage(app, { viewport, colorScheme, locale }, async ({ page }) => {
          await act(page, words(locale));
          await page.waitForLoadState('networkidle');
          await page.waitForTimeout(500);
          await page.screenshot({ path: TAKEN + name, animations: 'disabled', caret: 'hide' });
        });
        taken.push(name);
      }
    }
  }
  await app.close();
  return taken;
}

// Number of pixels that differ from the accepted picture; writes the difference as a picture. None without an accepted picture.
function difference(name) {
  if (!existsSync(ACCEPTED + name)) return null;
  const [now, before] = [TAKEN, ACCEPTED].map((from) => PNG.sync.read(readFileSync(from + name)));
  const { width, height } = now;
  if (before.width !== width || before.height !== height) return width * height;
  const marked = new PNG({ width, height });
  const count = pixelmatch(before.data, now.data, marked.data, width, height, { threshold: 0.1 });
  if (count > 0) writeFileSync(`${TAKEN}${name.replace('.png', '.diff.png')}`, PNG.sync.write(marked));
  return count;
}

const accept = process.argv.includes('--accept');
const taken = await take(process.argv.slice(2).find((argument) => !argument.startsWith('--')) ?? '');
let changed = 0;
for (const name of taken) {
  const count = difference(name);
  if (count === 0) continue;
  changed++;
  console.log(count === null ? `new: ${name}` : `changed: ${name}, ${count} pixels`);
  if (accept) {
    mkdirSync(ACCEPTED, { recursive: true });
    copyFileSync(TAKEN + name, ACCEPTED + name);
  }
}
console.log(`summary: ${taken.length} pictures in target/pictures, ${changed} ${accept ? 'accepted' : 'new or changed'}`);
process.exit(changed > 0 && !accept ? 1 : 0);
