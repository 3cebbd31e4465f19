// The debugger's breakpoints, in a gutter beside the lines.
import { RangeSet, StateEffect, StateField } from '@codemirror/state';
import { GutterMarker, gutter, lineNumbers } from '@codemirror/view';

const setPoints = StateEffect.define();

class Point extends GutterMarker {
  constructor(condition) {
    super();
    this.condition = condition;
  }
  eq(other) {
    return other.condition === this.condition;
  }
  toDOM() {
    const dot = document.createElement('span');
    dot.className = 'cm-point';
    dot.textContent = '●';
    dot.title = this.condition;
    return dot;
  }
}

const field = StateField.define({
  create: () => RangeSet.empty,
  update(known, { changes, effects, state }) {
    const last = effects.findLast((effect) => effect.is(setPoints));
    if (!last) return known.map(changes);
    const here = last.value.filter(([line]) => line <= state.doc.lines);
    return RangeSet.of(here.map(([line, condition]) => new Point(condition).range(state.doc.line(line).from)), true);
  },
});

// The lines with breakpoints, each with its condition.
export const showPoints = (view, lines) => view.dispatch({ effects: setPoints.of(lines) });

// A press beside a line or on its number toggles its breakpoint, as in the listing.
export function points(toggle) {
  const mousedown = (view, { from }, event) => {
    if (event.button !== 0) return false;
    toggle(view.state.doc.lineAt(from).number);
    return true;
  };
  const domEventHandlers = { mousedown };
  return [
    field,
    gutter({ class: 'cm-points', markers: (view) => view.state.field(field), initialSpacer: () => new Point(''), domEventHandlers }),
    lineNumbers({ domEventHandlers }),
  ];
}
