// Findings in the text: a mark each, with its sentence and its fixes, and commands that go to the next or previous one.
import { forEachDiagnostic, lintGutter, nextDiagnostic, previousDiagnostic, setDiagnostics } from '@codemirror/lint';
import { EditorView } from '@codemirror/view';

const SEVERITY = { fail: 'error', warn: 'warning', info: 'info' };

// The sentence with a button for each fix.
function content(message, fixes, apply) {
  const all = document.createElement('span');
  all.append(message);
  fixes.forEach((name, at) => {
    const button = document.createElement('button');
    button.type = 'button';
    button.className = 'cm-fix';
    button.textContent = name;
    button.addEventListener('click', () => apply(at));
    all.append(button);
  });
  return all;
}

// Marks the findings; `fix` gets the numbers of a finding and of its fix.
export function showFindings(view, found, fix) {
  const end = view.state.doc.length;
  const rows = found.map(({ from, to, tone, text: message, number, fixes }) => ({
    from: Math.min(from, end),
    to: Math.min(Math.max(to, from), end),
    severity: SEVERITY[tone],
    message,
    renderMessage: () => content(message, fixes, (at) => fix(number, at)),
  }));
  view.dispatch(setDiagnostics(view.state, rows));
}

// Sentences of the findings at a place.
export function findingsAt(state, at) {
  const found = [];
  forEachDiagnostic(state, ({ message }, from, to) => {
    if (from <= at && at <= to) found.push(message);
  });
  return found;
}

// Goes to a finding and announces it to screen readers.
const go = (step) => (view) => {
  if (!step(view)) return false;
  const said = findingsAt(view.state, view.state.selection.main.from);
  view.dispatch({ effects: EditorView.announce.of(said.join(' ')) });
  return true;
};

export const findings = lintGutter();
export const next = go(nextDiagnostic);
export const previous = go(previousDiagnostic);
