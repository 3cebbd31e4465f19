// Loads and starts the page's module. It is a file of its own because the content security policy allows no script inside the page.
const notice = document.getElementById('boot');
const { js, wasm } = document.querySelector('script[data-wasm]').dataset;

try {
  const { default: init } = await import(new URL(js, document.baseURI));
  await init({ module_or_path: new URL(wasm, document.baseURI) });
  notice.remove();
} catch (error) {
  notice.textContent = `macroline could not start in this browser: ${error.message}`;
  throw error;
}
