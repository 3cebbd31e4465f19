// A list above the text to choose a row from: places, findings and their fixes. Typing narrows it down.
import { StateEffect, StateField } from '@codemirror/state';
import { closeHoverTooltips, showPanel } from '@codemirror/view';

const setList = StateEffect.define();

function element(name, attributes, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.append(...children);
  return made;
}

// The panel of a list: each of `rows` has a name, a text and whether it belongs to the row above; `at` is chosen first.
function panel(view, { title, rows, at }, choose, words) {
  const attributes = { class: 'cm-textfield', type: 'text', role: 'combobox', autocomplete: 'off', spellcheck: 'false', placeholder: words.find };
  const input = element('input', { ...attributes, 'aria-label': title, 'aria-expanded': 'true', 'aria-controls': 'list', 'aria-autocomplete': 'list' });
  const options = element('ul', { id: 'list', role: 'listbox', 'aria-label': title, tabindex: '-1' });
  const end = element('button', { class: 'cm-button', type: 'button' }, words.close);
  const dom = element('div', { class: 'cm-list' }, element('b', {}, title), input, end, options);
  let shown = [];
  let chosen = 0;
  const close = () => {
    view.dispatch({ effects: setList.of(null) });
    view.focus();
  };
  const mark = (next) => {
    chosen = Math.min(Math.max(next, 0), shown.length - 1);
    [...options.children].forEach((row, k) => row.setAttribute('aria-selected', String(k === chosen)));
    for (const owner of [input, options]) {
      if (shown.length) owner.setAttribute('aria-activedescendant', `row-${chosen}`);
      else owner.removeAttribute('aria-activedescendant');
    }
    // Within the list only: the page itself does not move.
    const row = options.children[chosen];
    if (!row) return;
    const [top, bottom] = [row.offsetTop - options.offsetTop, row.offsetTop - options.offsetTop + row.offsetHeight];
    if (top < options.scrollTop) options.scrollTop = top;
    else if (bottom > options.scrollTop + options.clientHeight) options.scrollTop = bottom - options.clientHeight;
  };
  const take = (number) => {
    close();
    choose(number);
  };
  const option = ([[name, text, below], number], k) => {
    const row = element('li', { id: `row-${k}`, role: 'option', ...(below && { class: 'below' }) }, element('b', {}, name), ' ', element('span', {}, text));
    row.addEventListener('click', () => take(number));
    return row;
  };
  const draw = () => {
    const sought = input.value.toLowerCase();
    shown = rows.map((row, number) => [row, number]).filter(([[name, text]]) => `${name} ${text}`.toLowerCase().includes(sought));
    options.replaceChildren(...shown.map(option));
    if (!shown.length) options.append(element('li', { role: 'option', 'aria-disabled': 'true' }, words.none));
    mark(sought ? 0 : at);
  };
  input.addEventListener('input', draw);
  end.addEventListener('click', close);
  dom.addEventListener('keydown', (event) => {
    const step = { ArrowDown: 1, ArrowUp: -1, PageDown: 8, PageUp: -8 }[event.key];
    if (step) mark(chosen + step);
    else if (event.key === 'Enter' && event.target !== end && shown.length) take(shown[chosen][1]);
    else if (event.key === 'Escape') close();
    else return;
    event.preventDefault();
    event.stopPropagation();
  });
  const mount = () => {
    draw();
    // A finger chooses from the rows: the keyboard of the screen would cover them.
    (matchMedia('(pointer: coarse)').matches ? options : input).focus({ preventScroll: true });
  };
  return { dom, top: true, mount };
}

// The extension, and a function that shows a list in a view. `choose` gets the number of the row; a change of the text closes the list.
export function list(choose, words) {
  const field = StateField.define({
    create: () => null,
    update: (shown, { docChanged, effects }) => effects.reduce((last, effect) => (effect.is(setList) ? effect.value : last), docChanged ? null : shown),
    provide: (of) => showPanel.from(of, (shown) => shown && ((view) => panel(view, shown, choose, words))),
  });
  return { extension: field, show: (view, shown) => view.dispatch({ effects: [setList.of(shown), closeHoverTooltips] }) };
}
