// Starts the page. A file of its own, as the content security policy allows no inline script.
const boot = document.getElementById('boot');
// wasm cannot call `import()` itself; what it loads this way is no part of the first load.
globalThis.lazyImport = (path) => import(new URL(path, document.baseURI));
try {
  const { js, wasm } = document.querySelector('script[data-js]').dataset;
  const { default: init } = await import(new URL(js, document.baseURI));
  await init({ module_or_path: new URL(wasm, document.baseURI) });
  boot.remove();
} catch (error) {
  boot.textContent = `macroline could not start in this browser: ${error.message}`;
  throw error;
}
