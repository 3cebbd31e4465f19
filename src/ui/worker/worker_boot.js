// Starts the worker's module with the page's sentences. The first message has module, wasm and sentences: their addresses, or where the page is
// one file themselves, for a worker from a disk reads no address within its page. No module itself, which Chromium does not start from there.
addEventListener('message', start, { once: true });

async function start({ data }) {
  try {
    const [module, wasm, words] = data.map((part) => (part instanceof Blob ? URL.createObjectURL(part) : part));
    const sentences = fetch(words).then((answer) => answer.text());
    const { default: init, work } = await import(module);
    await init({ module_or_path: wasm });
    work(await sentences);
  } catch (error) {
    // The page hears of it.
    reportError(error);
  }
}
