// Pictures of the page to look at, in target/shots: `make shots`. Arguments are hashes to open, each its own set: `#…`.
import { mkdirSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { ready, start } from './page.mjs';

const SIZES = [[1440, 900], [1024, 768], [390, 844]];
const OUT = fileURLToPath(new URL('../../target/shots/', import.meta.url));

mkdirSync(OUT, { recursive: true });
const app = await start();
for (const hash of process.argv.length > 2 ? process.argv.slice(2) : ['']) {
  for (const [width, height] of SIZES) {
    for (const colorScheme of ['light', 'dark']) {
      const page = await app.browser.newPage({ viewport: { width, height }, colorScheme });
      await page.goto(app.url + hash);
      await ready(page);
      const path = `${OUT}${[hash.replace(/\W/g, ''), width, colorScheme].filter(Boolean).join('-')}.png`;
      await page.screenshot({ path, fullPage: true });
      console.log(path);
      await page.close();
    }
  }
}
await app.close();
