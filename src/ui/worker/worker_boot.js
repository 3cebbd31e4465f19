// Starts the worker's module with the page's sentences. The worker's name is the address of these; it ends in the page's own hash, so that no
// module of an older build comes from a cache.
const { search } = new URL(self.name, import.meta.url);
const sentences = fetch(self.name).then((answer) => answer.text());
const { default: init, work } = await import(`./worker.js${search}`);
await init({ module_or_path: new URL(`worker_bg.wasm${search}`, import.meta.url) });
work(await sentences);
