// The page in WebKit, by the driver of WebKitGTK: it opens, answers a field, runs and goes to a time. `make test-browsers`.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { createServer } from 'node:net';
import { after, before, test } from 'node:test';
import { Builder, By, Key, until } from 'selenium-webdriver';
import { serve } from '../../scripts/serve.mjs';
import { DIST } from './page.mjs';

// WebKitGTK needs a screen.
const SCREEN = ':77';
// Milliseconds.
const WAIT = 60_000;

async function freePort() {
  const server = createServer().listen(0, '127.0.0.1');
  await once(server, 'listening');
  const { port } = server.address();
  server.close();
  return port;
}

let site, screen, driver, browser;
before(async () => {
  site = await serve(DIST);
  screen = spawn('Xvfb', [SCREEN, '-screen', '0', '1440x900x24'], { stdio: 'ignore' });
  const port = await freePort();
  driver = spawn('WebKitWebDriver', [`--port=${port}`], { stdio: 'ignore', env: { ...process.env, DISPLAY: SCREEN } });
  const server = `http://127.0.0.1:${port}`;
  for (let turn = 0; turn < 100; turn++) {
    if (await fetch(`${server}/status`).then((answer) => answer.ok, () => false)) break;
    await new Promise((done) => setTimeout(done, 100));
  }
  const args = ['--automation'];
  browser = await new Builder()
    .usingServer(server)
    .withCapabilities({ browserName: 'MiniBrowser', 'webkitgtk:browserOptions': { binary: process.env.WEBKIT ?? binary(), args } })
    .build();
});
after(async () => {
  await browser?.quit();
  for (const child of [driver, screen]) child?.kill();
  await site?.close();
});

// Debian keeps it outside the path, in the folder of its machine's kind.
function binary() {
  const kind = { x64: 'x86_64', arm64: 'aarch64' }[process.arch];
  return `/usr/lib/${kind}-linux-gnu/webkit2gtk-4.1/MiniBrowser`;
}

const find = (selector) => browser.wait(until.elementLocated(By.css(selector)), WAIT);
const text = (selector) => browser.executeScript((selector) => document.querySelector(selector)?.textContent ?? '', selector);
const type = async (selector, value) => {
  const input = await find(selector);
  await input.clear();
  await input.sendKeys(value, Key.ENTER);
};

test('WebKit opens, runs, follows a field, goes to a time', async () => {
  await browser.manage().window().setRect({ x: 0, y: 0, width: 1440, height: 900 });
  await browser.get(site.url);
  await find('#play');
  await browser.wait(async () => (await text('#clock')) > '00:00.0000', WAIT, 'the machine moves at first sight');
  await (await find('#play')).click();
  assert.match(await text('.mode'), /^Paused/);
  await type('#pitch', '9.5');
  await browser.wait(async () => (await text('.stage')).includes('every 9.5 mm'), WAIT, 'the drawing follows the pitch');
  await type('#go-to', '5');
  await browser.wait(async () => (await text('#clock')) === '00:05.0000', WAIT, 'the play head is where one goes');
  assert.equal(await text('#boot'), '');
});
