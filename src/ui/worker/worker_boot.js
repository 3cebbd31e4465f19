// Starts the worker's module with the page's units and sentences. The first message holds the units and the addresses
// of module, wasm, sentences and texts of help. Where the page is one file it holds `Blob`s instead, because a worker of a
// page from disk cannot read addresses of its page. A classic script: Chromium starts no module worker from disk.
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
    // Fires `onerror` on the page's side.
    reportError(error);
  }
}

async function text(address) {
  const answer = await fetch(address);
  if (!answer.ok) throw new Error(`no ${address}`);
  return answer.text();
}
