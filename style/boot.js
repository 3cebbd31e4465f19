// Starts the page. A file of its own, as the content security policy allows no inline script.
const boot = document.getElementById('boot');
// wasm cannot call `import()` itself; what it loads this way is no part of the first load.
globalThis.lazyImport = (path) => import(new URL(path, document.baseURI));
try {
  const { js, wasm, words } = document.querySelector('script[data-js]').dataset;
  // The module knows which sentences are its own; asked for by its hash, no older ones are taken from a cache.
  const sentences = fetch(new URL(`${words}?${wasm}`, document.baseURI)).then((answer) => answer.text());
  const { default: init } = await import(new URL(js, document.baseURI));
  globalThis.sentences = await sentences;
  await init({ module_or_path: new URL(wasm, document.baseURI) });
  boot.remove();
} catch (error) {
  boot.textContent = `macroline could not start in this browser: ${error.message}`;
  throw error;
}
