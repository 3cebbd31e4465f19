// The package under test: PACKAGE, else the one that `make test-package` builds.
import { fileURLToPath, pathToFileURL } from 'node:url';
import { join } from 'node:path';

export const PACKAGE = process.env.PACKAGE ?? fileURLToPath(new URL('../../target/npm-test', import.meta.url));

export const INDEX = pathToFileURL(join(PACKAGE, 'index.js')).href;

// The package, ready.
export async function macroline() {
  const core = await import(INDEX);
  await core.init();
  return core;
}
