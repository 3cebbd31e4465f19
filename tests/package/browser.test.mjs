// The example page of the package in Chromium, and the package as bundlers for browsers take it.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { build } from 'esbuild';
import { serve } from '../../scripts/serve.mjs';
import { launch } from '../e2e/page.mjs';
import { PACKAGE } from './package.mjs';

const AXE = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

let site, browser;
before(async () => {
  site = await serve(PACKAGE);
  browser = await launch();
});
after(async () => {
  await browser?.close();
  await site?.close();
});

test('example designs, follows its choices, runs a program', async () => {
  const page = await browser.newPage();
  const complaints = [];
  page.on('console', (message) => message.type() === 'error' && complaints.push(message.text()));
  page.on('pageerror', (fault) => complaints.push(fault.message));
  await page.goto(`${site.url}example/`);
  const row = (id) => page.getByRole('row', { name: new RegExp(`^${id} `) });
  await row('volts').waitFor();
  await page.getByRole('combobox', { name: 'Machine' }).selectOption('turning-spindle');
  await row('stage-speed').waitFor();
  await page.getByRole('combobox', { name: 'Control' }).selectOption('gsk-980tdc');
  await page.getByRole('button', { name: 'Run' }).click();
  const log = page.getByRole('status', { name: 'Log' });
  await log.getByText('linear X30 F6000').waitFor();
  assert.match(await log.textContent(), /program-end, \d+\.\d{3} s/);
  await page.getByRole('textbox').fill('O1\nG01 X[#1+ F5\nM30\n');
  await page.getByRole('combobox', { name: 'Language' }).selectOption('zh');
  await page.getByRole('button', { name: 'Run' }).click();
  await log.getByText(/\p{Script=Han}/u).waitFor();
  await page.evaluate(AXE);
  const { violations } = await page.evaluate(() => window.axe.run(document, { resultTypes: ['violations'] }));
  assert.deepEqual(violations.map(({ id, nodes }) => `${id}: ${nodes[0].html}`), []);
  assert.deepEqual(complaints, []);
});

test('a bundler for browsers takes the package', async () => {
  const { warnings, errors } = await build({ entryPoints: [join(PACKAGE, 'index.js')], bundle: true, format: 'esm', platform: 'browser', write: false, logLevel: 'silent' });
  assert.deepEqual([warnings, errors], [[], []]);
});
