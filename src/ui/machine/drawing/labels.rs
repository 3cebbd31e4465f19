//! Labels of a drawing in less room than they were laid out for: each moves or is hidden, so that none overlaps another, a hairline or a lens.

use std::cmp::Reverse;
use std::collections::BTreeMap;

use leptos::wasm_bindgen::JsCast;
use web_sys::{Element, HtmlElement};

use crate::math;
use crate::text::number::filled;
use crate::ui::dom;

/// Pixels between two labels, and between a label and the hairline of another.
const GAP: f64 = 10.0;
const GAP_TO_HAIRLINE: f64 = 3.0;
/// Length in pixels of the pieces of a hairline that labels keep clear of.
const PIECE: f64 = 6.0;
/// Shifts to the side, and up or down, in pixels. A label leaves its row only where the next place in the row is much farther away.
const ASIDE: [f64; 13] = [0.0, 8.0, -8.0, 16.0, -16.0, 26.0, -26.0, 38.0, -38.0, 52.0, -52.0, 68.0, -68.0];
const UP_OR_DOWN: [f64; 7] = [0.0, 9.0, -9.0, 18.0, -18.0, 28.0, -28.0];
const OUT_OF_ROW: f64 = 2.5;
/// Cost of a label on a drawn part, in pixels of shift: for touching it, and on top for the covered share of a line.
const OFF_PART: (f64, f64) = (12.0, 90.0);

/// Greatest shift in pixels of a label without a hairline: further away it would seem to name another part.
const NEAR: f64 = 38.0;
/// Share of a text's box above and below that its letters leave free.
const FREE: f64 = 0.12;

/// Pixels between a text and the start of its hairline, and from the ends of the text to the start at least.
const CLEAR: (f64, f64) = (4.0, 8.0);

/// Attribute of a moved hairline: its path in the drawing.
const LED: &str = "data-led";

/// A rectangle in pixels: left, top, right, bottom.
type Area = [f64; 4];

/// A place in pixels.
type Place = (f64, f64);

/// An area that labels keep clear of, and how many pixels.
type Obstacle = (Area, f64);

/// The lines of a label: name first, then values. The hairline to the part is no line.
#[derive(Debug, Clone, PartialEq, Default)]
struct Label {
    lines: Vec<Area>,
    /// Whether the label belongs to a part that a hairline leads to, or keeps its place.
    leads: bool,
    /// Start, as it was laid out, and end of its hairline.
    hairline: Option<[Place; 2]>,
    /// The lens around it, in which it stays.
    lens: Option<Area>,
    /// Whether the label belongs on a part: letters in the colour for dark parts, figures that move with a part.
    on_part: bool,
}

/// Placement of a label.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
struct LabelPlacement {
    /// Shift to the right and down in pixels.
    by: Place,
    /// The number of its lines that are shown.
    lines: usize,
    /// Start of its hairline; `None` where the text has come to the part itself.
    start: Option<Place>,
}

fn area(element: &Element) -> Area {
    let area = element.get_bounding_client_rect();
    [area.left(), area.top(), area.right(), area.bottom()]
}

/// Box of a text without the free space above and below its letters.
fn letters(text: &Element) -> Area {
    let [left, top, right, bottom] = area(text);
    let free = FREE * (bottom - top);
    [left, top + free, right, bottom - free]
}

/// Area of a lens that other labels keep clear of: two rectangles that approximate the circle.
fn rectangles([left, top, right, bottom]: Area) -> [Area; 2] {
    let part = 0.15 * (right - left);
    [[left, top + part, right, bottom - part], [left + part, top, right - part, bottom]]
}

fn shifted([left, top, right, bottom]: Area, by: Place) -> Area {
    [left + by.0, top + by.1, right + by.0, bottom + by.1]
}

/// The shifts of a label, the nearest first.
fn shifts() -> Vec<(f64, Place)> {
    let all = UP_OR_DOWN.iter().flat_map(|down| ASIDE.iter().map(move |aside| (*aside, *down)));
    let mut all: Vec<(f64, Place)> = all.map(|by| (by.0.abs() + OUT_OF_ROW * by.1.abs(), by)).collect();
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    all
}

/// Whether two areas are closer than a gap.
fn touch(a: Area, b: Area, gap: f64) -> bool {
    a[0] < b[2] + gap && b[0] < a[2] + gap && a[1] < b[3] + gap && b[1] < a[3] + gap
}

/// The greatest share of an area that one of the drawn parts covers.
fn covered(own: Area, parts: &[Area]) -> f64 {
    let size = (own[2] - own[0]) * (own[3] - own[1]);
    let share = |part: &Area| {
        let wide = own[2].min(part[2]) - own[0].max(part[0]);
        let high = own[3].min(part[3]) - own[1].max(part[1]);
        wide.max(0.0) * high.max(0.0) / size.max(1e-9)
    };
    parts.iter().map(share).fold(0.0, f64::max)
}

/// Whether an area is within a frame, and free of obstacles.
fn is_free(own: Area, frame: Area, taken: &[Obstacle]) -> bool {
    let within = own[0] >= frame[0] && own[1] >= frame[1] && own[2] <= frame[2] && own[3] <= frame[3];
    let is_beside = |(a, gap): &Obstacle| own[0] >= a[2] + gap || own[2] <= a[0] - gap;
    within && taken.iter().all(|obstacle| is_beside(obstacle) || own[1] >= obstacle.0[3] || own[3] <= obstacle.0[1])
}

/// The area around all lines; `None` without a line.
fn around(lines: impl Iterator<Item = Area>) -> Option<Area> {
    lines.reduce(|a, b| [a[0].min(b[0]), a[1].min(b[1]), a[2].max(b[2]), a[3].max(b[3])])
}

/// Where a hairline begins at a text: below or above it, and as it was laid out where the text reaches there. `None` where the text has come
/// to the part itself.
fn begin([(x, y), end]: [Place; 2], text: Area) -> Option<Place> {
    let (clear, inset) = CLEAR;
    let is_below = y <= end.1;
    let edge = if is_below { text[3] + clear } else { text[1] - clear };
    let has_length = if is_below { edge < end.1 } else { edge > end.1 };
    has_length.then(|| (x.min(text[2] - inset).max(text[0] + inset), edge))
}

/// All places where a hairline may begin at the lines of a text, the best first: along the edge towards the part, then at the side of a line.
fn begins(hairline: [Place; 2], lines: &[Area]) -> Vec<Place> {
    let Some(text) = around(lines.iter().copied()) else { return Vec::new() };
    let (clear, inset) = CLEAR;
    let end = hairline[1];
    let along = begin(hairline, text).map(|(x, edge)| {
        let others = [end.0.min(text[2] - inset).max(text[0] + inset), text[0] + inset, text[2] - inset];
        core::iter::once(x).chain(others).map(move |x| (x, edge))
    });
    let side = |line: &Area| {
        let x = if end.0 > line[2] { line[2] + clear } else { line[0] - clear };
        (end.0 > line[2] + clear || end.0 < line[0] - clear).then_some((x, 0.5 * (line[1] + line[3])))
    };
    along.into_iter().flatten().chain(lines.iter().filter_map(side)).collect()
}

/// The pieces of a line.
fn pieces(from: Place, end: Place) -> Vec<Area> {
    let count = (math::hypot(end.0 - from.0, end.1 - from.1) / PIECE).ceil().max(1.0);
    let at = |share: f64| (from.0 + (end.0 - from.0) * share, from.1 + (end.1 - from.1) * share);
    let piece = |k: u32| {
        let (a, b) = (at(f64::from(k) / count), at(f64::from(k + 1) / count));
        [a.0.min(b.0), a.1.min(b.1), a.0.max(b.0), a.1.max(b.1)]
    };
    (0..count as u32).map(piece).collect()
}

/// The first start of a hairline from which it crosses nothing: neither lines of its own label nor obstacles.
fn clear_start(hairline: [Place; 2], lines: &[Area], taken: &[Obstacle]) -> Option<Place> {
    let is_clear = |from: &Place| {
        pieces(*from, hairline[1]).into_iter().all(|piece| {
            let is_free = |area: Area| !touch(piece, area, GAP_TO_HAIRLINE);
            lines.iter().all(|line| is_free(*line)) && taken.iter().all(|(area, _)| is_free(*area))
        })
    };
    begins(hairline, lines).into_iter().find(is_clear)
}

/// Whether a line has words: a value may be empty at the moment, and its box is then a point, or at the drawing's corner.
fn has_words(line: &Area) -> bool {
    line[0] < line[2]
}

/// Number of the first lines of a label in a lens that are within it and not on the lines above. An empty line takes no room.
fn seen_in(label: &Label, lens: Area) -> usize {
    let mut bottom = f64::NEG_INFINITY;
    let is_within = |line: &&Area| {
        if !has_words(line) {
            return true;
        }
        let is_below = line[1] >= bottom;
        bottom = line[3];
        line[0] >= lens[0] && line[2] <= lens[2] && is_below
    };
    label.lines.iter().take_while(is_within).count()
}

/// The lines of a label that have words, the first `count` of them, moved.
fn seen(label: &Label, count: usize, by: Place) -> Vec<Area> {
    label.lines.iter().take(count).filter(|line| has_words(line)).map(|line| shifted(*line, by)).collect()
}

/// Fewest lines that a label is shown with: its name and the first value that has words. A name alone would seem to be a label without values.
fn fewest(label: &Label) -> usize {
    let value = label.lines.iter().skip(1).position(has_words);
    value.map_or(1, |at| at + 2)
}

/// Place of a label with so many lines: the nearest one where it is free and, if that is not far, no drawn part is below it. Its hairline
/// crosses nothing, or `may_cross`.
fn place(
    label: &Label,
    (count, may_cross): (usize, bool),
    ways: &[(f64, Place)],
    (frame, taken, parts): Room,
) -> Option<LabelPlacement> {
    let mut best: Option<(f64, LabelPlacement)> = None;
    for (far, by) in ways {
        if best.is_some_and(|(cost, _)| cost <= *far) {
            break;
        }
        let lines = seen(label, count, *by);
        if !lines.iter().all(|line| is_free(*line, frame, taken)) {
            continue;
        }
        let clear = label.hairline.and_then(|ends| clear_start(ends, &lines, taken));
        // A text that has come to its part needs no hairline.
        let any = label.hairline.and_then(|ends| begins(ends, &lines).first().copied());
        if clear.is_none() && any.is_some() && !may_cross {
            continue;
        }
        let start = clear.or(any);
        let on_parts =
            if label.on_part { 0.0 } else { lines.iter().map(|line| covered(*line, parts)).fold(0.0, f64::max) };
        let off_part = if on_parts > 0.0 { OFF_PART.0 + OFF_PART.1 * on_parts } else { 0.0 };
        let cost = far + off_part;
        if best.is_none_or(|(least, _)| cost < least) {
            best = Some((cost, LabelPlacement { by: *by, lines: count, start }));
        }
    }
    best.map(|(_, placement)| placement)
}

/// Frame of the drawing, what is taken in it, and its drawn parts.
type Room<'a> = (Area, &'a [Obstacle], &'a [Area]);

/// Places the labels: labels in lenses keep their place; then come labels with hairlines, then the others, those with values before single
/// words and figures. A label without room loses lines from its end, and all of them where only its name would be left.
fn placed(labels: &[Label], frame: Area, parts: &[Area]) -> Vec<LabelPlacement> {
    let mut taken: Vec<Obstacle> = Vec::new();
    let mut placements = vec![LabelPlacement::default(); labels.len()];
    for (label, placement) in labels.iter().zip(&mut placements) {
        if let Some(lens) = label.lens {
            placement.lines = seen_in(label, lens);
            taken.extend(rectangles(lens).map(|area| (area, GAP)));
        }
    }
    let shifts = shifts();
    let near: Vec<(f64, Place)> =
        shifts.iter().copied().filter(|(_, (x, y))| x.abs() <= NEAR && y.abs() <= 0.5 * NEAR).collect();
    for leads in [true, false] {
        let free = labels.iter().zip(&mut placements).filter(|(label, _)| label.lens.is_none() && label.leads == leads);
        let mut free: Vec<_> = free.collect();
        if !leads {
            free.sort_by_key(|(label, _)| Reverse(label.lines.len()));
        }
        for (label, placement) in free {
            let ways = if leads { &shifts } else { &near };
            let counts = (fewest(label)..=label.lines.len()).rev();
            let mut tries = counts.flat_map(|count| [(count, false), (count, true)]);
            if let Some(found) = tries.find_map(|how| place(label, how, ways, (frame, &taken, parts))) {
                *placement = found;
                let lines = seen(label, found.lines, found.by);
                taken.extend(lines.into_iter().map(|line| (line, GAP)));
                let hairline = found.start.zip(label.hairline).map(|(from, [_, end])| pieces(from, end));
                taken.extend(hairline.into_iter().flatten().map(|piece| (piece, GAP_TO_HAIRLINE)));
            }
        }
    }
    placements
}

/// Start and end of a hairline that is one straight line.
fn ends(path: &str) -> Option<[(f64, f64); 2]> {
    let (from, to) = path.strip_prefix('M')?.split_once('L')?;
    let point = |text: &str| {
        let (x, y) = text.split_once(' ')?;
        Some((x.parse().ok()?, y.parse().ok()?))
    };
    Some([point(from)?, point(to)?])
}

/// Where a hairline ends in pixels, by the area that it is drawn in.
fn end_of(path: &str, drawn: Area) -> Option<Place> {
    let [from, to] = ends(path)?;
    let x = if from.0 <= to.0 { drawn[2] } else { drawn[0] };
    let y = if from.1 <= to.1 { drawn[3] } else { drawn[1] };
    Some((x, y))
}

/// A hairline of the drawing that ends at a place in pixels, made to begin at another one. Letters keep their size in a larger drawing, so that
/// a text reaches less far there than it was laid out for.
fn led(path: &str, end: Place, start: Place, unit: f64) -> Option<String> {
    let [from, to] = ends(path)?;
    let [(x, y), _] = in_pixels(path, end, unit)?;
    Some(filled("M# #L# #", &[from.0 + (start.0 - x) * unit, from.1 + (start.1 - y) * unit, to.0, to.1]))
}

/// Start and end in pixels of a hairline that ends at a place in pixels.
fn in_pixels(path: &str, end: Place, unit: f64) -> Option<[Place; 2]> {
    let [from, to] = ends(path)?;
    Some([(end.0 - (to.0 - from.0) / unit, end.1 - (to.1 - from.1) / unit), end])
}

/// A hairline in the document: its element, its path as the drawing has it, and where it ends in pixels.
struct Hairline {
    element: Element,
    path: String,
    end: Option<Place>,
}

impl Hairline {
    /// The hairline among the elements of a label. Its path in the drawing is kept: it must not depend on the sizes that the drawing had
    /// before.
    fn among(elements: &[Element]) -> Option<Hairline> {
        let element = elements.iter().find(|element| element.tag_name() == "path")?.clone();
        let present = element.get_attribute("d").unwrap_or_default();
        let end = end_of(&present, area(&element));
        let path = element.get_attribute(LED).unwrap_or(present);
        Some(Hairline { element, path, end })
    }

    /// Makes it begin at a place, and hides it where its text is hidden.
    fn lead_from(&self, placement: &LabelPlacement, unit: f64) {
        if placement.lines == 0 {
            let _ = self.element.class_list().add_1("crowded");
            return;
        }
        if let Some(end) = self.end {
            let led = placement.start.and_then(|start| led(&self.path, end, start, unit));
            dom::set(&self.element, LED, &self.path);
            dom::set(&self.element, "d", &led.unwrap_or_else(|| self.path.clone()));
        }
    }
}

/// Filled shapes of parts that never move, without their shadows.
const PARTS: &str = ":is(path, circle, ellipse, rect):not([fill=none], [fill='url(#ground-shade)'], [data-label], [data-n], \
                     [data-g] *, defs *)";

/// Areas of the drawn parts that never move: the labels' places must not depend on the moment at which they are fitted. What reaches from edge
/// to edge is ground.
fn parts_of(picture: &HtmlElement, frame: Area) -> Vec<Area> {
    let is_ground = |area: &Area| area[0] <= frame[0] && area[2] >= frame[2];
    dom::all(picture, PARTS).iter().map(area).filter(|area| !is_ground(area)).collect()
}

/// Whether a label belongs on the parts below it.
fn is_on_part(elements: &[Element]) -> bool {
    let dark = |element: &Element| element.get_attribute("fill").is_some_and(|fill| fill == "var(--rim)");
    let moves = |element: &Element| element.closest("[data-g]").ok().flatten().is_some();
    elements.iter().any(|element| dark(element) || moves(element))
}

/// Moves and hides labels of a drawing so that none overlaps; `unit` is the number of drawing units per pixel.
pub(super) fn untangle(picture: &HtmlElement, unit: f64) {
    for element in dom::all(picture, ".crowded") {
        let _ = element.class_list().remove_1("crowded");
    }
    for style in dom::all(picture, "[data-label][style]").iter().filter_map(style) {
        let _ = style.remove_property("translate");
    }
    let mut parts: BTreeMap<u16, Vec<Element>> = BTreeMap::new();
    for element in dom::all(picture, "[data-label]") {
        if let Some(number) = element.get_attribute("data-label").and_then(|number| number.parse().ok()) {
            parts.entry(number).or_default().push(element);
        }
    }
    let is_text = |element: &&Element| element.tag_name() == "text";
    let hairlines: Vec<Option<Hairline>> = parts.values().map(|elements| Hairline::among(elements)).collect();
    let label = |(elements, hairline): (&Vec<Element>, &Option<Hairline>)| Label {
        lines: elements.iter().filter(is_text).map(letters).collect(),
        leads: elements.iter().any(|element| !is_text(&element)),
        hairline: hairline.as_ref().and_then(|line| in_pixels(&line.path, line.end?, unit)),
        lens: elements.iter().find(|element| element.tag_name() == "circle").map(area),
        on_part: is_on_part(elements),
    };
    // Elements over the drawing keep their place.
    let over = picture.closest(".drawing").ok().flatten();
    let over = over.map_or(Vec::new(), |drawing| dom::all(&drawing, ".state, .band .icon"));
    let fixed =
        over.iter().map(|element| Label { lines: vec![area(element)], leads: true, on_part: true, ..Label::default() });
    let labels: Vec<Label> = fixed.chain(parts.values().zip(&hairlines).map(label)).collect();
    let frame = area(picture);
    let placements = placed(&labels, frame, &parts_of(picture, frame)).into_iter().skip(over.len());
    for ((elements, hairline), placement) in parts.values().zip(&hairlines).zip(placements) {
        let LabelPlacement { by, lines, .. } = placement;
        for (at, text) in elements.iter().filter(is_text).enumerate() {
            if at >= lines {
                let _ = text.class_list().add_1("crowded");
            } else if let Some(style) = style(text).filter(|_| by != (0.0, 0.0)) {
                let _ = style.set_property("translate", &format!("{:.2}px {:.2}px", by.0 * unit, by.1 * unit));
            }
        }
        if let Some(hairline) = hairline {
            hairline.lead_from(&placement, unit);
        }
    }
}

fn style(element: &Element) -> Option<web_sys::CssStyleDeclaration> {
    Some(element.dyn_ref::<web_sys::SvgElement>()?.style())
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;

    const FRAME: Area = [0.0, 0.0, 300.0, 200.0];

    fn label(left: f64, top: f64, letters: &[f64], leads: bool) -> Label {
        let line =
            |(at, width): (usize, &f64)| [left, top + 18.0 * at as f64, left + width, top + 18.0 * at as f64 + 15.0];
        Label { lines: letters.iter().enumerate().map(line).collect(), leads, ..Label::default() }
    }

    /// Shift and number of lines of each label, beside some parts.
    fn placed_beside(labels: &[Label], parts: &[Area]) -> Vec<(Place, usize)> {
        placed(labels, FRAME, parts).iter().map(|placement| (placement.by, placement.lines)).collect()
    }

    fn placed_alone(labels: &[Label]) -> Vec<(Place, usize)> {
        placed_beside(labels, &[])
    }

    #[wasm_bindgen_test]
    fn labels_with_room_stay_as_they_are() {
        let labels = [label(10.0, 10.0, &[80.0, 60.0], true), label(100.0, 10.0, &[80.0], false)];
        assert_eq!(placed_alone(&labels), [((0.0, 0.0), 2), ((0.0, 0.0), 1)]);
    }

    #[wasm_bindgen_test]
    fn label_on_another_one_moves_aside() {
        let labels = [label(10.0, 10.0, &[80.0], true), label(80.0, 10.0, &[80.0], true)];
        assert_eq!(placed_alone(&labels), [((0.0, 0.0), 1), ((26.0, 0.0), 1)]);
        assert_eq!(placed_alone(&[label(-20.0, 10.0, &[80.0], true)]), [((26.0, 0.0), 1)]);
    }

    #[wasm_bindgen_test]
    fn label_leaves_its_row_where_the_row_is_full() {
        let labels = [label(10.0, 30.0, &[280.0], true), label(60.0, 30.0, &[120.0], true)];
        assert_eq!(placed_alone(&labels)[1], ((0.0, 18.0), 1));
        // Beside the lower edge there is room above alone.
        let labels = [label(10.0, 182.0, &[280.0], false), label(60.0, 182.0, &[120.0], true)];
        assert_eq!(placed_alone(&labels), [((0.0, -18.0), 1), ((0.0, 0.0), 1)]);
    }

    #[wasm_bindgen_test]
    fn figure_alone_gives_way_to_a_label_with_values() {
        // The zero of a ruler just below a name and its value.
        let labels = [label(40.0, 36.0, &[10.0], false), label(10.0, 10.0, &[60.0, 60.0], false)];
        let placed = placed_alone(&labels);
        assert_eq!(placed[1], ((0.0, 0.0), 2));
        assert!(placed[0].0 != (0.0, 0.0) || placed[0].1 == 0, "{placed:?}");
    }

    #[wasm_bindgen_test]
    fn label_without_room_for_a_value_is_hidden() {
        // Full rows above and below leave room for one line.
        let labels = [
            label(10.0, 100.0, &[280.0], false),
            label(10.0, 64.0, &[280.0], true),
            label(10.0, 118.0, &[280.0], true),
            label(10.0, 82.0, &[100.0, 290.0], true),
            label(60.0, 82.0, &[90.0, 90.0], true),
            label(60.0, 82.0, &[90.0, 0.0], true),
        ];
        let here = (0.0, 0.0);
        let all = [(here, 0), (here, 1), (here, 1), (here, 2), (here, 0), ((68.0, 0.0), 2)];
        assert_eq!(placed_alone(&labels), all);
    }

    #[wasm_bindgen_test]
    fn label_loses_later_values_but_not_its_first() {
        // A full row where the third line would be, then where the second one would be.
        let lines = |top: f64| {
            let labels = [label(10.0, top, &[280.0], true), label(10.0, 10.0, &[80.0, 80.0, 80.0], true)];
            placed(&labels, [0.0, 0.0, 300.0, 63.0], &[])[1].lines
        };
        assert_eq!([lines(46.0), lines(28.0)], [2, 0]);
    }

    #[wasm_bindgen_test]
    fn label_without_a_hairline_stays_near_its_part() {
        let beside = |left| placed_alone(&[label(10.0, 10.0, &[80.0], true), label(left, 10.0, &[80.0], false)])[1];
        assert_eq!(beside(80.0), ((26.0, 0.0), 1));
        let full = [label(10.0, 10.0, &[280.0], true), label(10.0, 30.0, &[280.0], true)];
        let between = [full[0].clone(), full[1].clone(), label(50.0, 22.0, &[80.0], false)];
        assert_eq!(placed_alone(&between)[2], ((0.0, 0.0), 0));
    }

    #[wasm_bindgen_test]
    fn label_keeps_clear_of_the_hairline_of_another() {
        // From the text in the corner down to the right, through the place of the other label.
        let led = Label { hairline: Some([(80.0, 29.0), (140.0, 89.0)]), ..label(10.0, 10.0, &[80.0], true) };
        let other = |left| placed_alone(&[led.clone(), label(left, 50.0, &[40.0], false)])[1];
        assert_eq!(other(140.0), ((0.0, 0.0), 1));
        assert_eq!(other(90.0), ((38.0, 0.0), 1));
    }

    #[wasm_bindgen_test]
    fn hairline_begins_at_the_side_where_it_crosses_no_text() {
        // Below the first label, a second one is between it and the part at the right.
        let below = label(10.0, 40.0, &[120.0], true);
        let led = Label { hairline: Some([(60.0, 29.0), (240.0, 70.0)]), ..label(10.0, 10.0, &[80.0], true) };
        let start = placed(&[below, led], FRAME, &[])[1].start;
        assert_eq!(start, Some((94.0, 17.5)));
    }

    #[wasm_bindgen_test]
    fn label_leaves_a_drawn_part_if_room_is_near() {
        let part = [100.0, 0.0, 180.0, 60.0];
        assert_eq!(placed_beside(&[label(60.0, 10.0, &[60.0], true)], &[part])[0], ((-26.0, 0.0), 1));
        // All of the room near it is on the part.
        let inside = [0.0, 0.0, 300.0, 200.0];
        assert_eq!(placed_beside(&[label(60.0, 10.0, &[60.0], true)], &[inside])[0], ((0.0, 0.0), 1));
        let belongs = Label { on_part: true, ..label(60.0, 10.0, &[60.0], true) };
        assert_eq!(placed_beside(&[belongs], &[part])[0], ((0.0, 0.0), 1));
    }

    #[wasm_bindgen_test]
    fn lens_keeps_its_figures_and_others_away() {
        let lens = Some([100.0, 0.0, 180.0, 80.0]);
        let figures = Label { lens, ..label(110.0, 40.0, &[60.0, 50.0], true) };
        let over = label(60.0, 50.0, &[60.0], true);
        assert_eq!(placed_alone(&[over.clone(), figures.clone()]), [((-38.0, 0.0), 1), ((0.0, 0.0), 2)]);
        let beside = label(30.0, 50.0, &[60.0], false);
        assert_eq!(placed_alone(&[beside, figures.clone()]), [((0.0, 0.0), 1), ((0.0, 0.0), 2)]);
        // A smaller drawing keeps the size of its letters: lines without room in the lens are left out.
        let wide = Label { lens, ..label(90.0, 40.0, &[100.0, 50.0], true) };
        assert_eq!(placed_alone(&[wide]), [((0.0, 0.0), 0)]);
        let mut close = figures;
        close.lines[1][1] = close.lines[0][3] - 1.0;
        assert_eq!(placed_alone(&[close]), [((0.0, 0.0), 1)]);
    }

    #[wasm_bindgen_test]
    fn empty_line_in_a_lens_hides_no_later_line() {
        let lens = Some([100.0, 0.0, 180.0, 80.0]);
        let mut scale = Label { lens, ..label(110.0, 10.0, &[60.0, 0.0, 50.0], true) };
        assert_eq!(placed_alone(&[scale.clone()]), [((0.0, 0.0), 3)]);
        // Some browsers put the box of an empty text at the corner of the drawing.
        scale.lines[1] = [0.0; 4];
        assert_eq!(placed_alone(&[scale.clone()]), [((0.0, 0.0), 3)]);
        // The last line is compared with the last one that has words.
        scale.lines[2][1] = scale.lines[0][3] - 1.0;
        assert_eq!(placed_alone(&[scale]), [((0.0, 0.0), 2)]);
    }

    #[wasm_bindgen_test]
    fn hairline_begins_at_the_edge_of_its_text() {
        // Laid out for a text from 10 to 90 that ends at 40; drawn at two pixels a unit from (100, 100).
        let end = end_of("M90 40L110 100", [280.0, 180.0, 320.0, 300.0]).unwrap();
        assert_eq!(end, (320.0, 300.0));
        let from = |path: &str, end: Place, text: Area| {
            let start = begin(in_pixels(path, end, 0.5)?, text)?;
            led(path, end, start, 0.5)
        };
        let text = [120.0, 100.0, 200.0, 150.0];
        assert_eq!(from("M90 40L110 100", end, text).as_deref(), Some("M46 27L110 100"));
        // The same after it was moved.
        assert_eq!(end_of("M46 27L110 100", [192.0, 154.0, 320.0, 300.0]), Some(end));
        // Below its part, and where the text comes to the part.
        let end = end_of("M90 100L110 40", [280.0, 180.0, 320.0, 300.0]).unwrap();
        assert_eq!(from("M90 100L110 40", end, [120.0, 320.0, 300.0, 340.0]).as_deref(), Some("M90 108L110 40"));
        assert_eq!(from("M90 40L110 100", (320.0, 300.0), [120.0, 100.0, 300.0, 297.0]), None);
        assert_eq!((end_of("", text), from("", end, text)), (None, None));
    }

    #[wasm_bindgen_test]
    fn value_without_words_takes_no_room() {
        let labels = [label(10.0, 10.0, &[80.0, 0.0], true), label(10.0, 28.0, &[80.0], false)];
        assert_eq!(placed_alone(&labels), [((0.0, 0.0), 2), ((0.0, 0.0), 1)]);
    }
}
