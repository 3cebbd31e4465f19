// Words of the text for the page, which shows their meaning: the listing and the editor have one popover.
import { findingsAt } from './findings.js';

// Characters of a line that are read at most.
export const READ = 2000;

// The line of a place: its text, the place in it, and where it begins.
function lineAt({ state }, at) {
  const { from, text } = state.doc.lineAt(at);
  return at - from < READ ? [text.slice(0, READ), at - from, from] : null;
}

// Adds the page's functions about words to the element of an editor.
export function tellWords(host, view) {
  // The line at a point of the window. A finding has a tooltip of its own.
  host.lineAtPoint = (x, y) => {
    const at = view.posAtCoords({ x, y });
    const area = at === null ? null : view.coordsAtPos(at);
    if (!area || y < area.top || y > area.bottom || Math.abs(x - area.left) > 12 || findingsAt(view.state, at).length) return null;
    // The character under the point begins before the nearest gap, or at it.
    return lineAt(view, x < area.left && at > view.state.doc.lineAt(at).from ? at - 1 : at);
  };
  host.lineAtCursor = () => lineAt(view, view.state.selection.main.head);
  // Left, top and bottom of the character at a place.
  host.areaAt = (at) => {
    const area = view.coordsAtPos(at, 1);
    return area && [area.left, area.top, area.bottom];
  };
}
