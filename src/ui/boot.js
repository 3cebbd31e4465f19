// Shows the still as the last visit left the page, then loads and starts the page's module. It is a file of its own because the content
// security policy allows no script inside the page.
const still = document.getElementById('still');
const notice = document.getElementById('boot');
const data = document.querySelector('script[data-wasm]').dataset;

try {
  const kept = (key) => localStorage.getItem(`macroline.${key}`);
  document.documentElement.dataset.theme = kept('theme') ?? '';
  for (const column of ['--left', '--right']) {
    const width = kept(`width${column}`);
    if (width) document.documentElement.style.setProperty(column, `${width}px`);
  }
  // The machine of a person who has one, or a link to one, is drawn by the module alone.
  if (kept('project') || location.hash) still.querySelector('.scene').remove();
} catch {
  // A browser without a store has kept nothing.
}

// Labels keep their size: where there is little room the drawing becomes wider than it, as the page makes it (`machine/scene_view.rs`). Names
// have room everywhere; values wait for the page, which finds places for them. The drawing is not laid out before its scale is known
// (`#still` in `app.css`): all its labels would be twice.
const drawing = still.querySelector('.scene');
if (drawing) {
  const stage = drawing.parentElement;
  const { width, height } = drawing.viewBox.baseVal;
  const laidOut = Number(drawing.dataset.unit);
  const across = width / stage.clientWidth;
  const pans = across > 1.35 * laidOut && across > height / Math.max(stage.clientHeight - 40, 1);
  stage.classList.toggle('pans', pans);
  const room = stage.getBoundingClientRect();
  const unit = Math.max(height / room.height, pans ? laidOut : width / room.width);
  drawing.style.setProperty('--u', unit.toFixed(4));
  if (pans) drawing.style.setProperty('width', `${(width / unit).toFixed(0)}px`);
  stage.classList.toggle('crowded', unit > laidOut);
  stage.classList.add('scaled');
}

try {
  const [js, wasm, words] = [data.js, data.wasm, data.words].map((name) => new URL(name, document.baseURI));
  const sentences = fetch(words).then((answer) => (answer.ok ? answer.text() : Promise.reject(new Error(`no ${words.pathname}`))));
  const { default: init, open } = await import(js);
  const [loaded] = await Promise.all([sentences, init({ module_or_path: wasm })]);
  open(loaded);
} catch (error) {
  still.remove();
  document.body.append(notice);
  notice.textContent = `macroline could not start in this browser: ${error.message}`;
  throw error;
}
