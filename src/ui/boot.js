// Shows a still picture of the page with the theme and language of the last visit, then loads and starts the page's
// module. A file of its own, because the content security policy allows no script inside the page.
const still = document.getElementById('still');
const notice = document.getElementById('boot');
const data = document.querySelector('script[data-wasm]').dataset;

// The parts of the page that are loaded later. Where the page is one file (`one_file.js`), the part is a `Blob` of this
// table; else it is a file beside the page, with the number of the build in its address, so that neither a cache nor
// the service worker gives one of another build.
const parts = window.macroline?.parts ?? {};
const addresses = {};
window.macroline = {
  address(part) {
    if (!parts[part]) return new URL(`${part}?${data.build}`, document.baseURI).href;
    return (addresses[part] ??= URL.createObjectURL(parts[part]));
  },
  // For the worker: the `Blob` of a part, else its address.
  part: (part) => parts[part] ?? macroline.address(part),
};

const root = document.documentElement;
// Each has a file of sentences (`text/catalog`). The page takes the chosen one, else the browser's first known one.
const languages = ['en', 'zh'];

// Inside another page the address chooses language and units, and nothing is read from this browser's store (`docs/embedding.md`).
const [first, ...wishes] = location.hash.slice(1).split('&');
const embedded = first === 'embed';
const wished = (name) => (embedded ? wishes.find((wish) => wish.startsWith(`${name}=`))?.slice(name.length + 1) : null);
root.toggleAttribute('data-embedded', embedded);
if (embedded) still.replaceChildren(notice);

// A text stored under a key: by this tab before a reload (`dom/tab_entry.rs`), else in the browser's store.
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

// Labels keep their size: where there is little room, the drawing becomes wider than its room, by the same rule as in
// `machine/drawing/scene_view.rs`. The still shows no values, because only the page places them, and in such a wide
// drawing no names. The drawing is laid out only when its scale is known (`#still` in `app.css`).
const drawing = still.querySelector('.scene');
// Ratio of the drawing's units per pixel to those its labels are laid out for, above which the drawing becomes wider
// than its room; and height in pixels of the strip above such a drawing. A test compares both with
// `machine/drawing/scene_view.rs`.
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
