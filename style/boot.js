// Starts the page. A file of its own, as the content security policy allows no inline script.
const boot = document.getElementById('boot');
const { js, wasm, words } = document.querySelector('script[data-js]').dataset;
const at = (path) => new URL(path, document.baseURI);
// Two modules can have the page: the first, and the whole one, which takes longer to load and has every control and machine (src/ui/whole.rs).
// The first knows which sentences are its own; what is asked for by its hash is never an older one from a cache.
const FIRST = [js, wasm];
const WHOLE = [`whole.js?${wasm}`, `whole_bg.wasm?${wasm}`];
const sentences = fetch(at(`${words}?${wasm}`)).then((answer) => answer.text());

// wasm cannot call `import()` itself; what it loads this way is no part of the first load.
globalThis.lazyImport = (path) => import(at(path));

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

// Gives the page to a module. `hand` gives all that the one that has it knows.
async function open([js, wasm], hand) {
  const module = compiled(wasm);
  // What fails up to here changes nothing, and may be tried again; an import that has failed fails for ever in some browsers.
  if (hand) await module;
  const [module_or_path, { default: init }] = await Promise.all([module, import(at(js))]);
  globalThis.sentences = await sentences;
  if (hand && document.querySelector('.editor')) {
    // What was typed there last is taken after a pause.
    document.querySelector('.app').inert = true;
    await new Promise((done) => setTimeout(done, 200));
  }
  let again;
  globalThis.handed = () => {
    if (!hand) return undefined;
    again = look();
    // It keeps what is not kept yet.
    dispatchEvent(new Event('pagehide'));
    hearing.abort();
    hearing = new AbortController();
    const state = hand();
    document.querySelector('.app').remove();
    return state;
  };
  await init({ module_or_path });
  again?.();
}

// Where a person is on the page, and what he has typed that is no value yet: the function brings it back.
function look() {
  const path = [];
  const here = document.activeElement;
  const { value, selectionStart, selectionEnd } = here;
  for (let node = here; node && node !== document.body; node = node.parentElement) {
    path.unshift([...node.parentElement.children].indexOf(node));
  }
  const typed = [...document.querySelectorAll('input[aria-invalid="true"]')].map(({ id, value }) => [id, value]);
  const { scrollX, scrollY } = window;
  return () =>
    requestAnimationFrame(() => {
      for (const [id, value] of typed) {
        const input = document.getElementById(id);
        if (!input) continue;
        input.value = value;
        input.dispatchEvent(new Event('input', { bubbles: true }));
      }
      const there = path.reduce((node, at) => node?.children[at], document.body);
      there?.focus({ preventScroll: true });
      if (there?.matches('input[type="text"]')) {
        there.value = value;
        there.setSelectionRange(selectionStart, selectionEnd);
      }
      scrollTo(scrollX, scrollY);
    });
}

// The whole module in place of the first, which hears what failed if it shows the page already, and else has seen that it cannot.
let instead;
globalThis.whole = (hand, told) => {
  if (told) boot.textContent = told;
  document.body.append(boot);
  instead = open(WHOLE, hand).finally(() => boot.remove());
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
