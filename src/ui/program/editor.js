// The editor of a program, bundled beside the page and loaded only when somebody edits. It lives in a shadow root:
// there CodeMirror puts its styles into constructed sheets, which the content security policy allows, and not into <style>.
import { defaultKeymap, history, historyField, historyKeymap, indentWithTab } from '@codemirror/commands';
import { lintGutter, lintKeymap, setDiagnostics } from '@codemirror/lint';
import { unifiedMergeView } from '@codemirror/merge';
import { highlightSelectionMatches, search, searchKeymap } from '@codemirror/search';
import { Annotation, EditorState, RangeSetBuilder } from '@codemirror/state';
import { Decoration, EditorView, ViewPlugin, drawSelection, highlightActiveLine, keymap, lineNumbers } from '@codemirror/view';

// A change that came from the page and not from the keyboard.
const fromPage = Annotation.define();
const SEVERITY = { fail: 'error', warn: 'warning', info: 'info' };
// Characters of a line that are coloured at most.
const COLOURED = 2000;

// The colours of the lines that are to be seen. `pieces` knows the words of the control: of a line it gives start, end and class of each piece.
const colours = (pieces) =>
  ViewPlugin.fromClass(
    class {
      constructor(view) {
        this.draw(view);
      }
      update(update) {
        if (update.docChanged || update.viewportChanged) this.draw(update.view);
      }
      draw({ state, visibleRanges }) {
        const all = new RangeSetBuilder();
        for (const range of visibleRanges) {
          for (let at = range.from; at <= range.to; ) {
            const { from, to, text } = state.doc.lineAt(at);
            const found = pieces(text.slice(0, COLOURED));
            for (const [start, end, name] of found) all.add(from + start, from + end, Decoration.mark({ class: name }));
            at = to + 1;
          }
        }
        this.decorations = all.finish();
      }
    },
    { decorations: (plugin) => plugin.decorations },
  );

const theme = EditorView.theme({
  '&': { height: '100%', width: '100%', color: 'var(--ink)', backgroundColor: 'var(--pane)', fontSize: '12.5px' },
  '&.cm-focused': { outline: 'none' },
  '.cm-scroller': { fontFamily: 'var(--mono)', lineHeight: '1.6', overflow: 'auto' },
  '.cm-content': { caretColor: 'var(--ink)' },
  '.cm-cursor': { borderLeftColor: 'var(--ink)' },
  '.cm-gutters': { color: 'var(--dim)', backgroundColor: 'var(--pane)', borderRight: '1px solid var(--line)' },
  '.cm-activeLine': { backgroundColor: 'color-mix(in srgb, var(--soft) 60%, transparent)' },
  '.cm-selectionBackground, &.cm-focused .cm-selectionBackground': { backgroundColor: 'color-mix(in srgb, var(--accent) 28%, transparent) !important' },
  '.cm-panels, .cm-tooltip': { color: 'var(--ink)', backgroundColor: 'var(--pane)', border: '1px solid var(--line)' },
  '.cm-button, .cm-textfield': { color: 'var(--ink)', background: 'var(--well)', border: '1px solid var(--line)' },
  '.cm-diagnosticAction': { color: 'var(--on-accent)', backgroundColor: 'var(--accent)' },
  '.cm-collapsedLines': { color: 'var(--accent)', background: 'var(--well)' },
  '.cm-deletedChunk': { backgroundColor: 'var(--bad-soft)' },
  '.cm-changedLine, .cm-insertedLine': { backgroundColor: 'var(--ok-soft) !important' },
  '.t-c, .t-n': { color: 'var(--dim)' },
  '.t-g, .t-k': { color: 'var(--accent)' },
  '.t-v': { color: 'var(--violet)' },
  '.t-d': { color: 'var(--orange)' },
});

function shadow(host) {
  return host.shadowRoot ?? host.attachShadow({ mode: 'open' });
}

function view(host, create, { label, pieces }, extensions) {
  const root = shadow(host);
  root.replaceChildren();
  const box = document.createElement('div');
  box.style.cssText = 'width:100%;height:100%';
  root.append(box);
  const common = [lineNumbers(), drawSelection(), highlightActiveLine(), colours(pieces), theme, EditorView.contentAttributes.of({ 'aria-label': label, spellcheck: 'false', tabindex: '0' })];
  return new EditorView({ state: create([...extensions, common]), parent: box, root });
}

// What of an editor goes on in the next one of the same text: cursor and history.
const KEPT = { history: historyField };
let last;

// Opens an editor in `host`, called `label`. `changed` gets the text after each edit, `fix` the numbers of a diagnostic and of its fix.
export function open(host, text, options) {
  const { changed, fix } = options;
  const keys = keymap.of([...defaultKeymap, ...historyKeymap, ...searchKeymap, ...lintKeymap, indentWithTab]);
  const listener = EditorView.updateListener.of((update) => {
    if (update.docChanged && !update.transactions.some((one) => one.annotation(fromPage))) changed(update.state.doc.toString());
  });
  const create = (extensions) =>
    last?.state.doc.toString() === text
      ? EditorState.fromJSON(last.state.toJSON(KEPT), { extensions }, KEPT)
      : EditorState.create({ doc: text, extensions });
  const editor = view(host, create, options, [history(), search({ top: true }), highlightSelectionMatches(), lintGutter(), keys, listener]);
  last = editor;
  // Whoever has gone elsewhere while it was loaded stays there.
  const here = document.activeElement;
  if (here === document.body || here.closest('.tools')) editor.focus();
  editor.dispatch({ scrollIntoView: true });
  return {
    // Another text (undo, a fix, another file); the cursor stays where the text allows.
    set(next) {
      const last = editor.state.doc.toString();
      if (next === last) return;
      const head = Math.min(editor.state.selection.main.head, next.length);
      editor.dispatch({ changes: { from: 0, to: last.length, insert: next }, selection: { anchor: head }, annotations: fromPage.of(true) });
    },
    // What the control says about the text.
    mark(found) {
      const end = editor.state.doc.length;
      const rows = found.map(({ from, to, tone, text: message, number, fixes }) => ({
        from: Math.min(from, end),
        to: Math.min(Math.max(to, from), end),
        severity: SEVERITY[tone],
        message,
        actions: fixes.map((name, at) => ({ name, apply: () => fix(number, at) })),
      }));
      editor.dispatch(setDiagnostics(editor.state, rows));
    },
    // The cursor to a place, which is brought into view.
    go(at) {
      const anchor = Math.min(at, editor.state.doc.length);
      editor.dispatch({ selection: { anchor }, effects: EditorView.scrollIntoView(anchor, { y: 'center' }) });
      editor.focus();
    },
    close: () => editor.destroy(),
  };
}

// Shows in `host` what differs between two texts.
export function difference(host, before, after, options) {
  const merge = unifiedMergeView({ original: before, mergeControls: false, collapseUnchanged: { margin: 4, minSize: 8 } });
  const create = (extensions) => EditorState.create({ doc: after, extensions });
  const editor = view(host, create, options, [merge, EditorState.readOnly.of(true)]);
  return { close: () => editor.destroy() };
}
