//! Labels of a drawing in less room than they were laid out for: each moves aside or is hidden, so that none overlaps another or a lens.

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
/// Shifts to the side in pixels, tried in this order.
const ASIDE: [f64; 13] = [0.0, 8.0, -8.0, 16.0, -16.0, 26.0, -26.0, 38.0, -38.0, 52.0, -52.0, 68.0, -68.0];

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
#[derive(Debug, Clone, PartialEq)]
struct Label {
    lines: Vec<Area>,
    /// Whether it belongs to a part that a hairline leads to, or keeps its place.
    leads: bool,
    /// Start, as it was laid out, and end of its hairline.
    hairline: Option<[Place; 2]>,
    /// The lens around it, in which it stays.
    lens: Option<Area>,
}

/// Placement of a label: shift to the right in pixels, and the number of its lines that are shown.
type LabelPlacement = (f64, usize);

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

fn aside([left, top, right, bottom]: Area, by: f64) -> Area {
    [left + by, top, right + by, bottom]
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

/// The pieces of a hairline from a text.
fn pieces(hairline: [Place; 2], text: Area) -> Vec<Area> {
    let Some(from) = begin(hairline, text) else { return Vec::new() };
    let end = hairline[1];
    let count = (math::hypot(end.0 - from.0, end.1 - from.1) / PIECE).ceil().max(1.0);
    let at = |share: f64| (from.0 + (end.0 - from.0) * share, from.1 + (end.1 - from.1) * share);
    let piece = |k: u32| {
        let (a, b) = (at(f64::from(k) / count), at(f64::from(k + 1) / count));
        [a.0.min(b.0), a.1.min(b.1), a.0.max(b.0), a.1.max(b.1)]
    };
    (0..count as u32).map(piece).collect()
}

/// Lines of a label in a lens that are within it and not on the lines above.
fn seen_in(label: &Label, lens: Area) -> usize {
    let is_below = |at: usize| at == 0 || label.lines[at][1] >= label.lines[at - 1][3];
    let is_within = |at: &usize| label.lines[*at][0] >= lens[0] && label.lines[*at][2] <= lens[2] && is_below(*at);
    (0..label.lines.len()).take_while(is_within).count()
}

/// Places the labels: labels in lenses keep their place; then come labels with hairlines, then the others. A label without room loses
/// lines from its end, the name last.
fn placed(labels: &[Label], frame: Area) -> Vec<LabelPlacement> {
    let mut taken: Vec<Obstacle> = Vec::new();
    let mut placements = vec![(0.0, 0); labels.len()];
    for (label, placement) in labels.iter().zip(&mut placements) {
        if let Some(lens) = label.lens {
            *placement = (0.0, seen_in(label, lens));
            taken.extend(rectangles(lens).map(|area| (area, GAP)));
        }
    }
    for leads in [true, false] {
        let free = labels.iter().zip(&mut placements).filter(|(label, _)| label.lens.is_none() && label.leads == leads);
        for (label, placement) in free {
            let fits = |(lines, by): &(usize, f64)| {
                label
                    .lines
                    .iter()
                    .take(*lines)
                    .all(|line| line[0] == line[2] || is_free(aside(*line, *by), frame, &taken))
            };
            let ways = ASIDE.iter().filter(|by| label.leads || by.abs() <= NEAR);
            let mut tries = (1..=label.lines.len()).rev().flat_map(|lines| ways.clone().map(move |by| (lines, *by)));
            if let Some((lines, by)) = tries.find(fits) {
                *placement = (by, lines);
                let seen = label.lines.iter().take(lines).filter(|line| line[0] < line[2]).map(|line| aside(*line, by));
                taken.extend(seen.clone().map(|line| (line, GAP)));
                let hairline =
                    label.hairline.zip(around(seen)).map_or_else(Vec::new, |(ends, text)| pieces(ends, text));
                taken.extend(hairline.into_iter().map(|piece| (piece, GAP_TO_HAIRLINE)));
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

/// A hairline of the drawing that ends at a place in pixels, made to begin at the edge of its text. Letters keep their size in a larger
/// drawing, so that a text reaches less far there than it was laid out for. `None` where the text has come to the part itself.
fn led(path: &str, end: Place, text: Area, unit: f64) -> Option<String> {
    let [from, to] = ends(path)?;
    let [(x, y), end] = in_pixels(path, end, unit)?;
    let start = begin([(x, y), end], text)?;
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

    /// Makes it begin at the edge of its text, and hides it where there is none.
    fn lead_from(&self, text: Option<Area>, unit: f64) {
        let Some(text) = text else {
            let _ = self.element.class_list().add_1("crowded");
            return;
        };
        if let Some(end) = self.end {
            dom::set(&self.element, LED, &self.path);
            dom::set(&self.element, "d", &led(&self.path, end, text, unit).unwrap_or_else(|| self.path.clone()));
        }
    }
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
    };
    // Elements over the drawing keep their place.
    let over = picture.closest(".drawing").ok().flatten();
    let over = over.map_or(Vec::new(), |drawing| dom::all(&drawing, ".state, .band .icon"));
    let fixed =
        over.iter().map(|element| Label { lines: vec![area(element)], leads: true, hairline: None, lens: None });
    let labels: Vec<Label> = fixed.chain(parts.values().zip(&hairlines).map(label)).collect();
    let placements = placed(&labels, area(picture)).into_iter().zip(&labels).skip(over.len());
    for ((elements, hairline), ((by, lines), label)) in parts.values().zip(&hairlines).zip(placements) {
        for (at, text) in elements.iter().filter(is_text).enumerate() {
            if at >= lines {
                let _ = text.class_list().add_1("crowded");
            } else if let Some(style) = style(text).filter(|_| by != 0.0) {
                let _ = style.set_property("translate", &format!("{:.2}px", by * unit));
            }
        }
        let shown = label.lines.iter().take(lines).filter(|line| line[0] < line[2]).map(|line| aside(*line, by));
        if let Some(hairline) = hairline {
            hairline.lead_from(around(shown), unit);
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
        Label { lines: letters.iter().enumerate().map(line).collect(), leads, hairline: None, lens: None }
    }

    #[wasm_bindgen_test]
    fn labels_with_room_stay_as_they_are() {
        let labels = [label(10.0, 10.0, &[80.0, 60.0], true), label(100.0, 10.0, &[80.0], false)];
        assert_eq!(placed(&labels, FRAME), [(0.0, 2), (0.0, 1)]);
    }

    #[wasm_bindgen_test]
    fn label_on_another_one_moves_aside() {
        let labels = [label(10.0, 10.0, &[80.0], true), label(80.0, 10.0, &[80.0], true)];
        assert_eq!(placed(&labels, FRAME), [(0.0, 1), (26.0, 1)]);
        assert_eq!(placed(&[label(-20.0, 10.0, &[80.0], true)], FRAME), [(26.0, 1)]);
    }

    #[wasm_bindgen_test]
    fn name_of_a_part_outlives_values_and_other_labels() {
        let labels = [
            label(10.0, 100.0, &[280.0], false),
            label(10.0, 82.0, &[100.0, 290.0], true),
            label(60.0, 82.0, &[90.0, 90.0], true),
        ];
        assert_eq!(placed(&labels, FRAME), [(0.0, 0), (0.0, 2), (68.0, 1)]);
    }

    #[wasm_bindgen_test]
    fn label_without_a_hairline_stays_near_its_part() {
        let beside = |left| placed(&[label(10.0, 10.0, &[80.0], true), label(left, 10.0, &[80.0], false)], FRAME)[1];
        assert_eq!(beside(80.0), (26.0, 1));
        assert_eq!(beside(50.0), (0.0, 0));
    }

    #[wasm_bindgen_test]
    fn label_keeps_clear_of_the_hairline_of_another() {
        // From the text in the corner down to the right, through the place of the other label.
        let led = Label { hairline: Some([(80.0, 29.0), (140.0, 89.0)]), ..label(10.0, 10.0, &[80.0], true) };
        let other = |left| placed(&[led.clone(), label(left, 50.0, &[40.0], false)], FRAME)[1];
        assert_eq!(other(140.0), (0.0, 1));
        assert_eq!(other(90.0), (38.0, 1));
        // Between both sides there is no room near its part.
        assert_eq!(placed(&[led, label(70.0, 50.0, &[120.0], false)], FRAME)[1], (0.0, 0));
    }

    #[wasm_bindgen_test]
    fn lens_keeps_its_figures_and_others_away() {
        let lens = Some([100.0, 0.0, 180.0, 80.0]);
        let figures = Label { lens, ..label(110.0, 40.0, &[60.0, 50.0], true) };
        let over = label(60.0, 50.0, &[60.0], true);
        assert_eq!(placed(&[over.clone(), figures.clone()], FRAME), [(-38.0, 1), (0.0, 2)]);
        let beside = label(30.0, 50.0, &[60.0], false);
        assert_eq!(placed(&[beside, figures.clone()], FRAME), [(0.0, 1), (0.0, 2)]);
        // A smaller drawing keeps the size of its letters: lines without room in the lens are left out.
        let wide = Label { lens, ..label(90.0, 40.0, &[100.0, 50.0], true) };
        assert_eq!(placed(&[wide], FRAME), [(0.0, 0)]);
        let mut close = figures;
        close.lines[1][1] = close.lines[0][3] - 1.0;
        assert_eq!(placed(&[close], FRAME), [(0.0, 1)]);
    }

    #[wasm_bindgen_test]
    fn hairline_begins_at_the_edge_of_its_text() {
        // Laid out for a text from 10 to 90 that ends at 40; drawn at two pixels a unit from (100, 100).
        let end = end_of("M90 40L110 100", [280.0, 180.0, 320.0, 300.0]).unwrap();
        assert_eq!(end, (320.0, 300.0));
        let text = [120.0, 100.0, 200.0, 150.0];
        assert_eq!(led("M90 40L110 100", end, text, 0.5).as_deref(), Some("M46 27L110 100"));
        // The same after it was moved.
        assert_eq!(end_of("M46 27L110 100", [192.0, 154.0, 320.0, 300.0]), Some(end));
        // Below its part, and where the text comes to the part.
        let end = end_of("M90 100L110 40", [280.0, 180.0, 320.0, 300.0]).unwrap();
        assert_eq!(led("M90 100L110 40", end, [120.0, 320.0, 300.0, 340.0], 0.5).as_deref(), Some("M90 108L110 40"));
        assert_eq!(led("M90 40L110 100", (320.0, 300.0), [120.0, 100.0, 300.0, 297.0], 0.5), None);
        assert_eq!((end_of("", text), led("", end, text, 0.5)), (None, None));
    }

    #[wasm_bindgen_test]
    fn value_without_words_takes_no_room() {
        let labels = [label(10.0, 10.0, &[80.0, 0.0], true), label(10.0, 28.0, &[80.0], false)];
        assert_eq!(placed(&labels, FRAME), [(0.0, 2), (0.0, 1)]);
    }
}
