// Starts the page where it is one file (scripts/one_file.mjs): unpacks its parts, which are in the document, and hands them to boot.js.
const unpacked = async ({ dataset: { part, type }, textContent }) => {
  const { body } = await fetch(`data:;base64,${textContent}`);
  const plain = new Response(body.pipeThrough(new DecompressionStream('gzip')), { headers: { 'Content-Type': type } });
  return [part, await plain.blob()];
};

try {
  const parts = Object.fromEntries(await Promise.all([...document.querySelectorAll('script[data-part]')].map(unpacked)));
  window.macroline = { parts };
  const address = (part) => URL.createObjectURL(parts[part]);
  Object.assign(document.querySelector('script[data-wasm]').dataset, { js: address('app.js'), wasm: address('app_bg.wasm') });
  await import(address('boot.js'));
} catch (error) {
  // A browser that is too old for it; boot.js reports what fails later.
  document.getElementById('boot')?.append(` ${error.message}`);
  throw error;
}
