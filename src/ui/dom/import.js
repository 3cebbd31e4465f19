// Loads a module beside the page: `import()` is syntax, so wasm cannot call it. A module that could not be loaded may be asked for again.
const loaded = {};

export function importModule(path) {
  loaded[path] ??= import(new URL(path, document.baseURI)).catch((error) => {
    delete loaded[path];
    throw error;
  });
  return loaded[path];
}
