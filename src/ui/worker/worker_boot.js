// Starts the worker's module. The worker's name is the page's own hash: with it in the address no module of an older build comes from a cache.
const { default: init } = await import(`./worker.js?${self.name}`);
await init({ module_or_path: new URL(`worker_bg.wasm?${self.name}`, import.meta.url) });
