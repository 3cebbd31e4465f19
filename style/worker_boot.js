// Starts the same module in a worker. The file names come through the worker's name, `<js> <wasm>`, because they carry a
// hash that only the page knows: new Worker('worker_boot.js', { type: 'module', name: `${js} ${wasm}` }).
const [js, wasm] = self.name.split(' ');
const { default: init } = await import(new URL(js, import.meta.url));
await init({ module_or_path: new URL(wasm, import.meta.url) });
