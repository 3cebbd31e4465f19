// Shows the still as the last visit left the page, then loads and starts the page's module in the reader's language. It is a file of its own
// because the content security policy allows no script inside the page.
const still = document.getElementById('still');
const notice = document.getElementById('boot');
const data = document.querySelector('script[data-wasm]').dataset;

// The parts of the page that are loaded later, for all who ask: they are here where the page is one file (`one_file.js`), else beside the page, by
// the number of the build, so that neither a cache nor the service worker gives one of another build.
const parts = window.macroline?.parts ?? {};
const addresses = {};
window.macroline = {
  address(part) {
    if (!parts[part]) return new URL(`${part}?${data.build}`, document.baseURI).href;
    return (addresses[part] ??= URL.createObjectURL(parts[part]));
  },
  // The part itself where it is here, else its address: for the worker.
  part: (part) => parts[part] ?? macroline.address(part),
};

const root = document.documentElement;
// A file of sentences for each (`text/catalog`). The language that was chosen, or the first of the browser's that there is.
const languages = ['en', 'zh'];

// Inside another page the address chooses language and units, and nothing is read from this browser's store (`docs/embedding.md`).
const [first, ...wishes] = location.hash.slice(1).split('&');
const embedded = first === 'embed';
const wished = (name) => (embedded ? wishes.find((wish) => wish.startsWith(`${name}=`))?.slice(name.length + 1) : null);
root.toggleAttribute('data-embedded', embedded);
if (embedded) still.replaceChildren(notice);

// A text of an earlier visit: of this tab, which a reload keeps (`dom/tab_entry.rs`), or else of the browser's store.
function kept(key) {
  if (embedded) return null;
  try {
    return history.state?.[`macroline.${key}`] ?? localStorage.getItem(`macroline.${key}`);
  } catch {
    // A browser without a store has kept nothing.
    return null;
  }
}

root.dataset.theme = kept('theme') ?? '';
root.dataset.lengths = wished('lengths') ?? kept('lengths') ?? '';
for (const column of ['--left', '--right']) {
  const width = kept(`width${column}`);
  if (width) root.style.setProperty(column, `${width}px`);
}

const asked = [wished('lang'), kept('language'), ...navigator.languages].map((tag) => tag?.split('-')[0]);
root.lang = asked.find((code) => languages.includes(code)) ?? languages[0];
data.words = `${root.lang}.properties`;
// The still shows a fresh project with English names in millimetres. The module draws every other one: a stored or linked project, another language, inches.
if (kept('project') || location.hash || root.lang !== languages[0] || root.dataset.lengths === 'inch') still.querySelector('.scene')?.remove();

// Labels keep their size: where there is little room the drawing becomes wider than it, as the page makes it (`machine/drawing/scene_view.rs`). Values
// wait for the page, which finds places for them, and so do names in such a drawing. The drawing is not laid out before its scale is known
// (`#still` in `app.css`): all its labels would be twice.
const drawing = still.querySelector('.scene');
// Ratio of the drawing's units per pixel to those its labels are laid out for, above which it becomes wider than its room, and height in pixels
// of the strip over it then: the same two as in `machine/drawing/scene_view.rs`, held by a test.
const CROWDED = 1.35;
const STRIP = 40;
if (drawing) {
  const stage = drawing.parentElement;
  const { width, height } = drawing.viewBox.baseVal;
  const laidOut = Number(drawing.dataset.unit);
  const across = width / stage.clientWidth;
  const pans = across > CROWDED * laidOut && across > height / Math.max(stage.clientHeight - STRIP, 1);
  stage.classList.toggle('pans', pans);
  const room = stage.getBoundingClientRect();
  const unit = Math.max(height / room.height, pans ? laidOut : width / room.width);
  drawing.style.setProperty('--u', unit.toFixed(4));
  if (pans) drawing.style.setProperty('width', `${(width / unit).toFixed(0)}px`);
  stage.classList.toggle('crowded', unit > laidOut);
  stage.classList.add('scaled');
}

try {
  const [js, wasm] = [data.js, data.wasm].map((name) => new URL(name, document.baseURI));
  const sentences = fetch(macroline.address(data.words)).then((answer) => (answer.ok ? answer.text() : Promise.reject(new Error(`no ${data.words}`))));
  const { default: init, open } = await import(js);
  const [loaded] = await Promise.all([sentences, init({ module_or_path: wasm })]);
  open(loaded);
} catch (error) {
  still.remove();
  document.body.append(notice);
  const told = { en: 'macroline could not start in this browser', zh: 'macroline 无法在此浏览器中启动' };
  notice.textContent = `${told[root.lang]}: ${error.message}`;
  throw error;
}
