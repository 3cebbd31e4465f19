//! Labels of a drawing that has less room than they were laid out for: each moves a little to the side, or goes, so that none lies on another.

use std::collections::BTreeMap;

use leptos::wasm_bindgen::JsCast;
use web_sys::{Element, HtmlElement};

use crate::ui::dom;

/// Pixels between two labels.
const GAP: f64 = 10.0;
/// Pixels to the side that are tried, the nearest first.
const ASIDE: [f64; 13] = [0.0, 8.0, -8.0, 16.0, -16.0, 26.0, -26.0, 38.0, -38.0, 52.0, -52.0, 68.0, -68.0];

/// A rectangle in pixels: left, top, right, bottom.
type Area = [f64; 4];

/// The lines of a label: name first, then values. The hairline to the part is no line.
#[derive(Debug, Clone, PartialEq)]
struct Label {
    lines: Vec<Area>,
    /// Whether it names a part.
    leads: bool,
}

/// What becomes of a label: how far it moves aside, and how many of its lines stay.
type Fate = (f64, usize);

fn area(element: &Element) -> Area {
    let area = element.get_bounding_client_rect();
    [area.left(), area.top(), area.right(), area.bottom()]
}

fn aside([left, top, right, bottom]: Area, by: f64) -> Area {
    [left + by, top, right + by, bottom]
}

/// Whether an area is within a frame, and free of others.
fn is_free(own: Area, frame: Area, taken: &[Area]) -> bool {
    let within = own[0] >= frame[0] && own[1] >= frame[1] && own[2] <= frame[2] && own[3] <= frame[3];
    within && taken.iter().all(|a| own[0] >= a[2] + GAP || own[2] <= a[0] - GAP || own[1] >= a[3] || own[3] <= a[1])
}

/// Places the labels, those that name parts first: each with all its lines where it can, else with fewer, its name at last.
fn placed(labels: &[Label], frame: Area) -> Vec<Fate> {
    let mut taken: Vec<Area> = Vec::new();
    let mut fates = vec![(0.0, 0); labels.len()];
    for leads in [true, false] {
        for (label, fate) in labels.iter().zip(&mut fates).filter(|(label, _)| label.leads == leads) {
            let fits = |(lines, by): &(usize, f64)| {
                label
                    .lines
                    .iter()
                    .take(*lines)
                    .all(|line| line[0] == line[2] || is_free(aside(*line, *by), frame, &taken))
            };
            let tries = (1..=label.lines.len()).rev().flat_map(|lines| ASIDE.map(|by| (lines, by)));
            if let Some((lines, by)) = tries.into_iter().find(fits) {
                *fate = (by, lines);
                let seen = label.lines.iter().take(lines).filter(|line| line[0] < line[2]);
                taken.extend(seen.map(|line| aside(*line, by)));
            }
        }
    }
    fates
}

/// Moves and hides labels of a drawing so that none overlaps; `unit` is the number of drawing units per pixel.
pub(super) fn untangle(picture: &HtmlElement, unit: f64) {
    let mut parts: BTreeMap<u16, Vec<Element>> = BTreeMap::new();
    for element in dom::all(picture, "[data-label]") {
        let _ = element.class_list().remove_1("crowded");
        if let Some(style) = style(&element) {
            let _ = style.remove_property("translate");
        }
        if let Some(number) = element.get_attribute("data-label").and_then(|number| number.parse().ok()) {
            parts.entry(number).or_default().push(element);
        }
    }
    let is_text = |element: &&Element| element.tag_name() == "text";
    let label = |elements: &Vec<Element>| Label {
        lines: elements.iter().filter(is_text).map(area).collect(),
        leads: elements.iter().any(|element| !is_text(&element)),
    };
    // What lies over the drawing stays where it is.
    let over = picture.closest(".drawing").ok().flatten();
    let over = over.map_or(Vec::new(), |drawing| dom::all(&drawing, ".mode, .band .icon"));
    let fixed = over.iter().map(|element| Label { lines: vec![area(element)], leads: true });
    let labels: Vec<Label> = fixed.chain(parts.values().map(label)).collect();
    let fates = placed(&labels, area(picture)).into_iter().skip(over.len());
    for (elements, (by, lines)) in parts.values().zip(fates) {
        for (at, text) in elements.iter().filter(is_text).enumerate() {
            if at >= lines {
                let _ = text.class_list().add_1("crowded");
            } else if let Some(style) = style(text).filter(|_| by != 0.0) {
                let _ = style.set_property("translate", &format!("{:.2}px", by * unit));
            }
        }
        let leader = elements.iter().find(|element| !is_text(element)).filter(|_| lines == 0);
        if let Some(leader) = leader {
            let _ = leader.class_list().add_1("crowded");
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
        Label { lines: letters.iter().enumerate().map(line).collect(), leads }
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
    fn value_without_words_takes_no_room() {
        let labels = [label(10.0, 10.0, &[80.0, 0.0], true), label(10.0, 28.0, &[80.0], false)];
        assert_eq!(placed(&labels, FRAME), [(0.0, 2), (0.0, 1)]);
    }
}
