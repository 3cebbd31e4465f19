// Keeps the files of one build in this browser and answers the page from them, so that it works without a network. Above this line
// scripts/finish.mjs writes `BUILD`, the number of the build, and `FILES`, each file of it with its SHA-256.
//
// A newer build is fetched beside this one and waits until no page of this one is open, or until a page asks for it. A page always gets the files
// of its own build: it asks for them by its number (boot.js), and they are kept as long as it is open.

// Caches belong to all pages of the host, and several copies of macroline may be in its folders.
const PREFIX = `macroline ${registration.scope} `;
const OWN = PREFIX + BUILD;

addEventListener('install', (event) => event.waitUntil(install()));
addEventListener('activate', (event) => event.waitUntil(forgetOthers().then(() => clients.claim())));
addEventListener('message', ({ data }) => data === 'take' && skipWaiting());
addEventListener('fetch', (event) => {
  const { request } = event;
  const { href, search } = new URL(request.url);
  if (request.method !== 'GET' || !href.startsWith(registration.scope)) return;
  const path = href.slice(registration.scope.length).replace(/[?#].*/, '');
  if (request.mode !== 'navigate') event.respondWith(part(request, path, search.slice(1)));
  else if (path === '' || path === 'index.html') {
    event.respondWith(kept('./', OWN).then((page) => page ?? fetch(request)));
    event.waitUntil(forgetOthers());
  }
});

// Stores all files or none: if a file cannot be fetched, has another hash than listed, or does not fit, nothing
// changes. Even then it waits for the other files, so that a failed build does not go on loading or writing.
async function install() {
  const cache = await caches.open(OWN);
  const files = await Promise.allSettled(Object.entries(FILES).map(async ([file, hash]) => cache.put(file, (await same(file, hash)) ?? (await fetched(file)))));
  const failed = files.find(({ status }) => status === 'rejected');
  if (!failed) return;
  await caches.delete(OWN);
  throw failed.reason;
}

// The browser itself compares the file with its hash.
const fetched = (file) => fetch(file, { integrity: `sha256-${FILES[file]}`, cache: 'no-cache', priority: 'low' });

// The stored file of another build, if it has the same content.
async function same(file, hash) {
  const before = await caches.match(file, { ignoreVary: true });
  if (!before) return null;
  const digest = await crypto.subtle.digest('SHA-256', await before.clone().arrayBuffer());
  return btoa(String.fromCharCode(...new Uint8Array(digest))) === hash ? before : null;
}

const kept = (file, cacheName) => caches.match(file, { cacheName, ignoreVary: true });

// A file for a page of build `build`; without a number, for a page of this build. A file that the browser has dropped
// is fetched from the network; for this build, only with the listed hash.
async function part(request, file, build) {
  const found = build ? await kept(file, PREFIX + build) : ((await kept(file, OWN)) ?? (await caches.match(request, { ignoreVary: true })));
  if (found) return found;
  return file in FILES && (build || BUILD) === BUILD ? fetched(file) : fetch(request);
}

// Deletes the files of other builds when no open page can be of one of them and no build waits to be activated.
async function forgetOthers() {
  const pages = await clients.matchAll({ includeUncontrolled: true });
  if (registration.installing || registration.waiting || pages.some(({ url }) => url.startsWith(registration.scope))) return;
  const others = (await caches.keys()).filter((name) => name.startsWith(PREFIX) && name !== OWN);
  await Promise.all(others.map((name) => caches.delete(name)));
}
