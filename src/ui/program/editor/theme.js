// How the editor looks: the colours and sizes of the page.
import { EditorView } from '@codemirror/view';

const text = {
  '&': { height: '100%', width: '100%', color: 'var(--ink)', backgroundColor: 'var(--pane)', fontSize: '12.5px' },
  '&.cm-focused': { outline: 'none' },
  '.cm-scroller': { fontFamily: 'var(--mono)', lineHeight: '1.6', overflow: 'auto' },
  '.cm-content': { caretColor: 'var(--ink)' },
  '.cm-cursor': { borderLeftColor: 'var(--ink)' },
  '.cm-gutters': { color: 'var(--dim)', backgroundColor: 'var(--pane)', borderRight: '1px solid var(--line)' },
  '.cm-activeLine': { backgroundColor: 'color-mix(in srgb, var(--soft) 60%, transparent)' },
  '.cm-selectionBackground, &.cm-focused .cm-selectionBackground': { backgroundColor: 'color-mix(in srgb, var(--accent) 28%, transparent) !important' },
  '.cm-collapsedLines': { color: 'var(--accent)', background: 'var(--well)' },
  '.cm-deletedChunk': { backgroundColor: 'var(--bad-soft)' },
  '.cm-changedLine, .cm-insertedLine': { backgroundColor: 'var(--ok-soft) !important' },
  '.t-c, .t-n': { color: 'var(--dim)' },
  '.t-g, .t-k': { color: 'var(--accent)' },
  '.t-v': { color: 'var(--violet)' },
  '.t-d': { color: 'var(--orange)' },
};

const gutters = {
  '.cm-points': { minWidth: '16px' },
  '.cm-points, .cm-lineNumbers': { cursor: 'pointer' },
  '.cm-point': { color: 'var(--bad)', padding: '0 2px' },
  // The signs that findings have everywhere on the page.
  '.cm-gutter-lint .cm-gutterElement': { display: 'flex', alignItems: 'center', justifyContent: 'center', padding: '0' },
  '.cm-lint-marker': { width: 'auto', height: 'auto', font: '600 11px/1 var(--sans)' },
  '.cm-lint-marker-error': { content: 'normal', color: 'var(--bad)' },
  '.cm-lint-marker-warning': { content: 'normal', color: 'var(--warn)' },
  '.cm-lint-marker-info': { content: 'normal', color: 'var(--dim)' },
  '.cm-lint-marker-error::before': { content: '"✕"' },
  '.cm-lint-marker-warning::before': { content: '"▲"' },
  '.cm-lint-marker-info::before': { content: '"ⓘ"' },
};

const panels = {
  '.cm-panels, .cm-tooltip': { color: 'var(--ink)', backgroundColor: 'var(--pane)', border: '1px solid var(--line)' },
  '.cm-panels': { zIndex: 3 },
  '.cm-panels-top': { borderWidth: '0 0 1px' },
  '.cm-button, .cm-textfield': { color: 'var(--ink)', background: 'var(--well)', border: '1px solid var(--line)', borderRadius: '5px', padding: '3px 8px', minHeight: '26px', fontSize: '12.5px', boxSizing: 'border-box' },
  '.cm-button': { backgroundImage: 'none', cursor: 'pointer' },
  '.cm-textfield': { minWidth: '0', flex: '1 1 120px', maxWidth: '260px' },
  '.cm-textfield:focus-visible, .cm-button:focus-visible, .cm-fix:focus-visible': { outline: '2px solid var(--accent)', outlineOffset: '1px' },
  '.cm-panel.cm-search, .cm-panel.cm-gotoLine': { display: 'flex', flexWrap: 'wrap', gap: '4px 6px', alignItems: 'center', padding: '6px 32px 6px 8px', fontSize: '12.5px' },
  '.cm-panel.cm-search br': { flexBasis: '100%', width: '0' },
  '.cm-panel.cm-search label': { display: 'inline-flex', gap: '4px', alignItems: 'center', fontSize: '12.5px' },
  '.cm-panel.cm-search input, .cm-panel.cm-search button, .cm-panel.cm-search label': { margin: '0' },
  '.cm-panel.cm-search [name=close]': { color: 'var(--ink)', fontSize: '18px', width: '26px', height: '26px', top: '6px', right: '4px', cursor: 'pointer' },
};

const lists = {
  '.cm-list': { display: 'flex', flexWrap: 'wrap', gap: '4px 8px', alignItems: 'center', padding: '6px 8px', fontSize: '12.5px' },
  '.cm-list input': { marginLeft: 'auto' },
  '.cm-list ul': { flexBasis: '100%', listStyle: 'none', margin: '0', padding: '0', maxHeight: 'min(38vh, 320px)', overflow: 'auto', outline: 'none' },
  '.cm-list li': { padding: '3px 6px', borderRadius: '4px', cursor: 'pointer', whiteSpace: 'nowrap', overflow: 'hidden', textOverflow: 'ellipsis' },
  '.cm-list li.below': { paddingLeft: '22px' },
  '.cm-list li b': { fontWeight: '600' },
  '.cm-list li span': { color: 'var(--dim)' },
  '.cm-list li:hover, .cm-list li[aria-selected=true]': { backgroundColor: 'var(--soft)' },
};

const tooltips = {
  '.cm-tooltip': { borderRadius: '6px', boxShadow: '0 2px 10px #0003', maxWidth: 'min(460px, 94vw)' },
  '.cm-tooltip.cm-tooltip-autocomplete > ul': { fontFamily: 'var(--sans)', maxWidth: 'min(460px, 94vw)', minWidth: '0', maxHeight: '13em' },
  '.cm-tooltip.cm-tooltip-autocomplete > ul > li': { display: 'flex', gap: '10px', padding: '3px 8px', lineHeight: '1.4', alignItems: 'baseline' },
  '.cm-tooltip.cm-tooltip-autocomplete > ul > li[aria-selected]': { color: 'var(--ink)', backgroundColor: 'var(--soft)', boxShadow: 'inset 3px 0 var(--accent)' },
  '.cm-completionLabel': { fontFamily: 'var(--mono)', fontWeight: '600', minWidth: '4ch' },
  '.cm-completionDetail': { margin: '0', color: 'var(--dim)', fontStyle: 'normal', overflow: 'hidden', textOverflow: 'ellipsis' },
  '.cm-diagnosticText': { fontFamily: 'var(--sans)', whiteSpace: 'normal' },
  '.cm-fix': { display: 'block', margin: '4px 0 2px', padding: '3px 8px', minHeight: '26px', border: '0', borderRadius: '5px', cursor: 'pointer', font: 'inherit', color: 'var(--on-accent)', backgroundColor: 'var(--accent)' },
};

// A finger needs more room than a pointer.
const touch = {
  '@media (pointer: coarse)': {
    '.cm-tooltip.cm-tooltip-autocomplete > ul > li': { padding: '9px 8px' },
    '.cm-list ul': { maxHeight: '28vh' },
    '.cm-list li': { padding: '9px 6px' },
    '.cm-list li.below': { paddingLeft: '22px' },
    '.cm-button, .cm-textfield, .cm-fix': { minHeight: '36px' },
    '.cm-points': { minWidth: '28px' },
  },
};

export const theme = EditorView.theme({ ...text, ...gutters, ...panels, ...lists, ...tooltips, ...touch });
