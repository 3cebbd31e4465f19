// Proposals for the typed word, each with one line of meaning.
import { acceptCompletion, autocompletion, closeCompletion, completionKeymap, selectedCompletion } from '@codemirror/autocomplete';
import { Prec } from '@codemirror/state';
import { keymap } from '@codemirror/view';

// Whether the chosen proposal is typed already, so that nothing is left to take.
function isTyped({ state }) {
  const label = selectedCompletion(state)?.label;
  const { head } = state.selection.main;
  return label !== undefined && state.sliceDoc(Math.max(0, head - label.length), head) === label;
}

// Enter behind a whole word begins a line, as it does without proposals.
function enter(view) {
  if (!isTyped(view)) return acceptCompletion(view);
  closeCompletion(view);
  return false;
}

const tab = (view) => (isTyped(view) ? closeCompletion(view) : acceptCompletion(view));

// Proposals depend on the whole word, so each character requests them again. `complete` promises those at an offset.
const source = (complete) => async ({ explicit, pos, state }) => {
  const found = await complete(pos);
  if (!found?.rows.length || (!explicit && !found.few && found.from === pos)) return null;
  const [[first], second] = found.rows;
  if (!explicit && !second && state.sliceDoc(found.from, pos) === first) return null;
  return { from: found.from, filter: false, options: found.rows.map(([label, detail]) => ({ label, detail })) };
};

export const completion = (complete) => [
  autocompletion({ icons: false, defaultKeymap: false, override: [source(complete)] }),
  Prec.highest(keymap.of([{ key: 'Enter', run: enter }, { key: 'Tab', run: tab }, ...completionKeymap.filter(({ key }) => key !== 'Enter')])),
];
