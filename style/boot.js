// Starts the page. It stands in index.html itself, so that the module is asked for as soon as that is there, and whichever of the two it
// is; the content security policy knows it by its hash (scripts/shrink.mjs puts both there).
const boot = document.getElementById('boot');
const { js, wasm, words } = document.querySelector('script[data-js]').dataset;
const at = (path) => new URL(path, document.baseURI);
// Two modules can have the page: the first, and the whole one, which takes longer to load and has every control and machine (src/ui/whole.rs).
// The first knows which sentences are its own; what is asked for by its hash is never an older one from a cache.
const FIRST = [js, wasm];
const WHOLE = [`whole.js?${wasm}`, `whole_bg.wasm?${wasm}`];
const sentences = fetch(at(`${words}?${wasm}`)).then((answer) => answer.text());

// wasm cannot call `import()` itself; what it loads this way is no part of the first load. What is loaded already is there at once: an
// editor that was open is so again before the next key.
const loaded = {};
globalThis.lazyImport = (path) => (loaded[path] ??= import(at(path)).catch((error) => {
  delete loaded[path];
  throw error;
}));

// What the module that has the page hears of it, until another one has it.
let hearing = new AbortController();
globalThis.hear = (event, act) => addEventListener(event, act, { capture: event === 'paste', signal: hearing.signal });

async function compiled(path) {
  const answer = await fetch(at(path));
  if (!answer.ok) throw new Error(`${path}: ${answer.status} ${answer.statusText}`);
  // Not every host knows what a module is.
  const known = answer.headers.get('Content-Type')?.startsWith('application/wasm');
  return known ? WebAssembly.compileStreaming(answer) : WebAssembly.compile(await answer.arrayBuffer());
}

// Resolves in a moment in which nobody types, drags or answers a dialog: what is done then is done on one page or the other.
const PAUSE = 200;
function quiet() {
  const heard = new AbortController();
  let last = -PAUSE;
  let held = false;
  const note = ({ type }) => {
    last = performance.now();
    if (type.startsWith('pointer')) held = type === 'pointerdown';
  };
  const kinds = ['keydown', 'keyup', 'input', 'compositionupdate', 'pointerdown', 'pointerup', 'pointercancel'];
  for (const kind of kinds) addEventListener(kind, note, { capture: true, signal: heard.signal });
  return async () => {
    while (held || performance.now() - last < PAUSE || document.querySelector('dialog[open]')) await new Promise((done) => setTimeout(done, 20));
    heard.abort();
  };
}

// Gives the page to a module. `hand` gives all that the one that has it knows.
async function open([js, wasm], hand) {
  const pause = hand && quiet();
  const module = compiled(wasm);
  // What fails up to here changes nothing, and may be tried again; an import that has failed fails for ever in some browsers.
  if (hand) await module;
  const [module_or_path, { default: init }] = await Promise.all([module, import(at(js))]);
  globalThis.sentences = await sentences;
  await pause?.();
  if (hand && !boot.textContent) return;
  globalThis.handed = () => {
    if (!hand) return undefined;
    globalThis.again = look();
    // It keeps what is not kept yet.
    dispatchEvent(new Event('pagehide'));
    hearing.abort();
    hearing = new AbortController();
    const state = hand();
    document.querySelector('.app').remove();
    return state;
  };
  await init({ module_or_path });
}

// Where a person is on the page, and what he has typed that is no value yet: the function brings it back.
function look() {
  const steps = (node) => {
    const path = [];
    for (; node && node !== document.body; node = node.parentElement) path.unshift([...node.parentElement.children].indexOf(node));
    return path;
  };
  const find = (path) => path.reduce((node, at) => node?.children[at], document.body);
  const { activeElement: here, documentElement: root } = document;
  const { value, selectionStart, selectionEnd } = here;
  const focus = steps(here);
  const typed = [...document.querySelectorAll('input[aria-invalid="true"]')].map(({ id, value }) => [id, value]);
  const open = [...document.querySelectorAll('details')].map((group) => [steps(group), group.open]);
  const moved = [root, ...document.querySelectorAll('.app *')].filter((node) => node.scrollTop || node.scrollLeft);
  const places = moved.map((node) => [node === root ? node : steps(node), node.scrollTop, node.scrollLeft]);
  return () => {
    for (const [id, value] of typed) {
      const input = document.getElementById(id);
      if (!input) continue;
      input.value = value;
      input.dispatchEvent(new Event('input', { bubbles: true }));
    }
    for (const [path, is] of open) {
      const group = find(path);
      if (group?.matches('details')) group.open = is;
    }
    for (const [path, top, left] of places) (path === root ? root : find(path))?.scrollTo(left, top);
    const there = find(focus);
    there?.focus({ preventScroll: true });
    if (there?.matches('input[type="text"]')) {
      there.value = value;
      there.setSelectionRange(selectionStart, selectionEnd);
    }
  };
}

// The whole module in place of the first, which hears what failed if it shows the page already, and else has seen that it cannot. What is
// told stands in the page meanwhile; without a word it stays with the first one.
let instead;
globalThis.whole = (hand, told) => {
  if (hand) boot.textContent = told;
  document.body.append(boot);
  if (instead) return;
  instead = open(WHOLE, hand).finally(() => {
    boot.remove();
    instead = undefined;
  });
  if (hand) instead.catch(hand);
};

try {
  let module;
  try {
    module = localStorage.getItem('macroline.module');
  } catch {
    // A browser without a store.
  }
  await open(module === 'whole' ? WHOLE : FIRST);
  await instead;
  boot.remove();
} catch (error) {
  document.body.prepend(boot);
  boot.textContent = `macroline could not start in this browser: ${error.message}`;
  throw error;
}
