// Serves a folder on localhost: `node scripts/serve.mjs [folder]`, at $PORT, else at 8080 or any free port. The browser keeps the page for
// use without a network only with OFFLINE=1.
import { createReadStream } from 'node:fs';
import { stat } from 'node:fs/promises';
import { createServer } from 'node:http';
import { extname, join, resolve, sep } from 'node:path';
import { pathToFileURL } from 'node:url';

// Content types by file extension.
export const TYPES = {
  '.css': 'text/css; charset=utf-8',
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript; charset=utf-8',
  '.json': 'application/json',
  '.svg': 'image/svg+xml',
  '.txt': 'text/plain; charset=utf-8',
  '.webmanifest': 'application/manifest+json',
  '.wasm': 'application/wasm', // without it the browser cannot compile while it loads
};

// Replaces the page's service worker: removes itself and the files that an earlier one kept.
const NO_WORKER = `
addEventListener('install', () => skipWaiting());
addEventListener('activate', (event) => event.waitUntil(leave()));
async function leave() {
  const names = (await caches.keys()).filter((name) => name.startsWith('macroline '));
  await Promise.all(names.map((name) => caches.delete(name)));
  await registration.unregister();
}
`;

// Serves `folder`; port 0 is any free one. `packed` returns the bytes of a file compressed with brotli, for measurements. With `offline:
// false` the browser keeps nothing, and each reload shows the present build. Resolves to { url, close }.
export async function serve(folder, port = 0, packed = null, { offline = true } = {}) {
  const root = resolve(folder);
  const server = createServer(async (request, response) => {
    try {
      const path = decodeURIComponent(new URL(request.url, 'http://localhost').pathname);
      const file = join(root, path.endsWith('/') ? `${path}index.html` : path);
      if (!file.startsWith(root + sep) || !(await stat(file)).isFile()) throw new Error('not a file of the site');
      const type = TYPES[extname(file)] ?? 'application/octet-stream';
      // No cache: after the next build the same names may hold other bytes.
      const headers = { 'Content-Type': type, 'Cache-Control': 'no-cache', 'X-Content-Type-Options': 'nosniff' };
      if (!offline && path === '/service_worker.js') return void response.writeHead(200, headers).end(NO_WORKER);
      response.writeHead(200, packed ? { ...headers, 'Content-Encoding': 'br' } : headers);
      if (packed) response.end(packed(file));
      else createReadStream(file).pipe(response);
    } catch {
      response.writeHead(404, { 'Content-Type': 'text/plain' }).end('not found\n');
    }
  });
  const listen = (at) =>
    new Promise((done, failed) => server.once('error', failed).listen(at, 'localhost', () => done(server.address().port)));
  const at = await listen(port);
  return { url: `http://localhost:${at}/`, close: () => new Promise((done) => (server.close(done), server.closeAllConnections())) };
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  const folder = process.argv[2] ?? 'dist';
  // A fixed port keeps the browser's store for the page; another one is used if it is taken.
  const at = (port) => serve(folder, port, null, { offline: Boolean(process.env.OFFLINE) });
  const { url } = await (process.env.PORT ? at(Number(process.env.PORT)) : at(8080).catch(() => at(0)));
  console.log(`macroline is at ${url} (Ctrl+C ends it)`);
}
