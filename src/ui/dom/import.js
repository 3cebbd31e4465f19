// Loads a module by its address: `import()` is syntax, so wasm cannot call it. A module that could not be loaded may be asked for again.
const loaded = {};

export function importModule(address) {
  loaded[address] ??= import(address).catch((error) => {
    delete loaded[address];
    throw error;
  });
  return loaded[address];
}
