// The editor of a program, bundled beside the page and loaded at the first edit. It lives in a shadow root: there
// CodeMirror puts its styles into constructed sheets, which the content security policy allows, and not into <style>.
import { defaultKeymap, history, historyField, historyKeymap, indentWithTab } from '@codemirror/commands';
import { unifiedMergeView } from '@codemirror/merge';
import { highlightSelectionMatches, openSearchPanel, search, searchKeymap } from '@codemirror/search';
import { Annotation, EditorState, RangeSetBuilder } from '@codemirror/state';
import { Decoration, EditorView, ViewPlugin, drawSelection, highlightActiveLine, keymap, lineNumbers, tooltips } from '@codemirror/view';
import { completion } from './editor/completion.js';
import { findings, next, previous, showFindings } from './editor/findings.js';
import { list } from './editor/list.js';
import { points, showPoints } from './editor/points.js';
import { waysOf, withoutReturns } from './editor/returns.js';
import { theme } from './editor/theme.js';
import { READ, tellWords } from './editor/words.js';

// A change that came from the page and not from the keyboard.
const fromPage = Annotation.define();

// The colours of the visible lines. `pieces` reads a line as the control does: start, end and class of each piece.
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
            const found = pieces(text.slice(0, READ));
            for (const [start, end, name] of found) all.add(from + start, from + end, Decoration.mark({ class: name }));
            at = to + 1;
          }
        }
        this.decorations = all.finish();
      }
    },
    { decorations: (plugin) => plugin.decorations },
  );

// Height in pixels of the bars that cover the foot of a small window.
const covered = () => parseFloat(getComputedStyle(document.body).paddingBottom) || 0;

// A bar that appears above the editor reduces its height: scrolls so that the edited line stays in view.
const staysInView = EditorView.updateListener.of(({ geometryChanged, view }) => {
  const height = view.scrollDOM.clientHeight;
  const lower = height < view.heightBefore;
  view.heightBefore = height;
  if (!geometryChanged || !lower || !view.hasFocus) return;
  requestAnimationFrame(() => view.dom.isConnected && view.dispatch({ effects: EditorView.scrollIntoView(view.state.selection.main.head) }));
});

// Keeps the cursor and its tooltips clear of the bars.
const inSight = [
  staysInView,
  EditorView.scrollMargins.of(() => ({ bottom: covered() })),
  tooltips({ tooltipSpace: () => ({ top: 0, left: 0, right: innerWidth, bottom: innerHeight - covered() }) }),
];

// A view in the shadow root of `host`; `begin` makes its state of all extensions.
function openView(host, begin, { label, pieces, phrases }, extensions) {
  const root = host.shadowRoot ?? host.attachShadow({ mode: 'open' });
  root.replaceChildren();
  const box = document.createElement('div');
  box.style.cssText = 'width:100%;height:100%';
  root.append(box);
  const content = EditorView.contentAttributes.of({ 'aria-label': label, spellcheck: 'false', tabindex: '0' });
  const common = [drawSelection(), highlightActiveLine(), colours(pieces), theme, inSight, EditorState.phrases.of(phrases), content];
  const view = new EditorView({ state: begin([...extensions, common]), parent: box, root });
  tellWords(host, view);
  return view;
}

// State of a file that its next editor continues while the text is the same: cursor and undo history.
const KEPT = { history: historyField };
const states = new Map();

function stateOf(file, text, extensions) {
  const doc = withoutReturns(text);
  const before = states.get(file);
  return before?.doc.toString() === doc ? EditorState.fromJSON(before.toJSON(KEPT), { extensions }, KEPT) : EditorState.create({ doc, extensions });
}

// Requests of keys, buttons and clicks to the page, each for an offset of its text. `list` promises the places of the
// name there, `define` shows the definition of that name.
function commandsOf(host, { list: ask, define, toggle }, show, toPage) {
  const head = ({ state }) => toPage(state.selection.main.head);
  const offer = (name) => (view) => {
    const { doc } = view.state;
    const take = (shown) => {
      if (!view.dom.isConnected || view.state.doc !== doc) return;
      if (shown) show(view, shown);
      else if (shown === undefined) setTimeout(() => ask(name, head(view)).then(take), 100);
    };
    ask(name, head(view)).then(take);
    return true;
  };
  return {
    outline: offer('outline'),
    uses: offer('uses'),
    findings: offer('findings'),
    define: (view) => (define(head(view)), true),
    toggle: ({ state }) => (toggle(state.doc.lineAt(state.selection.main.head).number), true),
    meaning(view) {
      view.dispatch({ effects: EditorView.scrollIntoView(view.state.selection.main) });
      return host.dispatchEvent(new CustomEvent('means', { bubbles: true }));
    },
    find: openSearchPanel,
  };
}

// A click with Ctrl, on a Mac with Command, leads to the definition.
const press = (define) =>
  EditorView.domEventHandlers({
    mousedown(event, view) {
      const held = /Mac|iP/.test(navigator.platform) ? event.metaKey : event.ctrlKey;
      const at = held && event.button === 0 ? view.posAtCoords(event) : null;
      if (at === null) return false;
      view.dispatch({ selection: { anchor: at } });
      define(view);
      event.preventDefault();
      return true;
    },
  });

// Opens an editor of a file in `host`, named `label` for screen readers. `changed` gets the number of the file and its
// text after each edit, `fix` the numbers of a finding and of its fix, `choose` the number of a row of a list, `toggle`
// the line of a breakpoint; `complete` promises proposals at an offset.
export function open(host, number, text, options) {
  let file = number;
  let ways = waysOf(text);
  const toPage = (at) => ways.toPage(at);
  const lists = list(options.choose, options.words);
  const commands = commandsOf(host, options, lists.show, toPage);
  const keys = keymap.of([
    { key: 'F12', run: commands.define },
    { key: 'Shift-F12', run: commands.uses },
    { key: 'Mod-Shift-o', run: commands.outline },
    { key: 'Mod-.', run: commands.findings },
    { key: 'Mod-i', run: commands.meaning },
    { key: 'F8', run: next, shift: previous, preventDefault: true },
    { key: 'F9', run: commands.toggle },
    ...[defaultKeymap, historyKeymap, searchKeymap].flat(),
    indentWithTab,
  ]);
  const listener = EditorView.updateListener.of(({ docChanged, state, transactions }) => {
    if (!docChanged || transactions.some((one) => one.annotation(fromPage))) return;
    const typed = state.doc.toString();
    ways = waysOf(typed);
    options.changed(file, typed);
  });
  const complete = async (at) => {
    const found = await options.complete(toPage(at));
    return found && { ...found, from: ways.toEditor(found.from) };
  };
  const parts = [history(), search({ top: true }), highlightSelectionMatches(), findings, points(options.toggle), completion(complete)];
  let all;
  const begin = (extensions) => stateOf(file, text, (all = extensions));
  const editor = openView(host, begin, options, [parts, lists.extension, press(commands.define), keys, listener]);
  // Takes the focus only if the user has not moved it elsewhere during loading.
  const here = document.activeElement;
  if (here === document.body || here.closest('.tools')) editor.focus();
  editor.dispatch({ scrollIntoView: true });
  return {
    // Another file, or another text of this one (undo, a fix); the cursor stays where the text allows.
    show(number, text) {
      ways = waysOf(text);
      if (number !== file) {
        states.set(file, editor.state);
        file = number;
        return editor.setState(stateOf(file, text, all));
      }
      const [last, next] = [editor.state.doc.toString(), withoutReturns(text)];
      if (next === last) return;
      const head = Math.min(editor.state.selection.main.head, next.length);
      editor.dispatch({ changes: { from: 0, to: last.length, insert: next }, selection: { anchor: head }, annotations: fromPage.of(true) });
    },
    // Marks the findings in the text.
    mark: (found) => showFindings(editor, found.map((one) => ({ ...one, from: ways.toEditor(one.from), to: ways.toEditor(one.to) })), options.fix),
    // The lines with breakpoints.
    points: (lines) => showPoints(editor, lines),
    // The cursor to a place, which is brought into view.
    go(at) {
      this.reveal(at);
      editor.focus();
    },
    // Moves the cursor and scrolls to an offset; the focus does not move.
    reveal(at) {
      const anchor = Math.min(ways.toEditor(at), editor.state.doc.length);
      editor.dispatch({ selection: { anchor }, effects: EditorView.scrollIntoView(anchor, { y: 'center' }) });
    },
    // A command by its name.
    run: (name) => commands[name](editor),
    close() {
      states.set(file, editor.state);
      editor.destroy();
    },
  };
}

// Shows in `host` the differences between two texts.
export function difference(host, before, after, options) {
  const merge = unifiedMergeView({ original: before, mergeControls: false, collapseUnchanged: { margin: 4, minSize: 8 } });
  const begin = (extensions) => EditorState.create({ doc: after, extensions });
  const editor = openView(host, begin, options, [lineNumbers(), merge, EditorState.readOnly.of(true)]);
  return { close: () => editor.destroy() };
}
