// Starts the worker's module with the page's units and sentences. The first message has units, module, wasm, sentences and texts of help: their addresses, or
// where the page is one file themselves, for a worker from a disk reads no address within its page. No module itself, which Chromium does not
// start from there.
addEventListener('message', start, { once: true });

async function start({ data }) {
  try {
    const [lengths, module, wasm, words, ...help] = data.map((part) => (part instanceof Blob ? URL.createObjectURL(part) : part));
    const sentences = text(words);
    const { default: init, work } = await import(module);
    await init({ module_or_path: wasm });
    // Help is loaded when it is first asked for.
    work(await sentences, lengths, () => Promise.all(help.map(text)));
  } catch (error) {
    // The page hears of it.
    reportError(error);
  }
}

async function text(address) {
  const answer = await fetch(address);
  if (!answer.ok) throw new Error(`no ${address}`);
  return answer.text();
}
