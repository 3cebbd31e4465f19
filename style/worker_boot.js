// Starts the module that works for the page, in a worker. The page's own module names its hash, which comes as the worker's name, so that
// no older one is taken from a cache: new Worker('worker_boot.js', { type: 'module', name: hash }).
const sentences = fetch(new URL(`en.txt?${self.name}`, import.meta.url)).then((answer) => answer.text());
const { default: init } = await import(`./worker.js?${self.name}`);
globalThis.sentences = await sentences;
await init({ module_or_path: new URL(`worker_bg.wasm?${self.name}`, import.meta.url) });
