//! A ladder program as plain data, and its drawing.

use core::fmt::Write;

use super::letters::Anchor;
use super::svg::escape;
use crate::text::columns;
use crate::text::number::{fill, filled};

/// A contact of a rung.
#[derive(Debug, Clone, PartialEq)]
pub struct DrawnContact {
    /// Device or condition, for instance `X20`.
    pub device: String,
    /// Normally closed contact.
    pub inverted: bool,
}

/// One rung: branches of contacts and their output.
#[derive(Debug, Clone, PartialEq)]
pub struct DrawnRung {
    /// Branches in parallel, each with its contacts from left to right.
    pub branches: Vec<Vec<DrawnContact>>,
    /// Coil, or instruction with its operands, for instance `MOV R148 R74`.
    pub output: String,
    /// Purpose of the rung.
    pub note: String,
}

/// Least width of the drawing, height of a rung and of a further branch, left rail.
const WIDTH: f64 = 400.0;
const RUNG: f64 = 58.0;
const BRANCH: f64 = 38.0;
const LEFT: f64 = 10.0;

/// The ladder as SVG, with the classes of the page (`s-ink`, `f-dim` …).
pub fn svg(rungs: &[DrawnRung]) -> String {
    let tall = |rung: &DrawnRung| RUNG + BRANCH * rung.branches.len().saturating_sub(1) as f64;
    let height = rungs.iter().map(tall).sum::<f64>() + 8.0;
    let needed = rungs.iter().map(|rung| (reach(rung) + box_width(rung) + 40.0).max(note_width(rung)));
    let width = needed.fold(WIDTH, f64::max).ceil();
    let mut out =
        filled("<svg class=\"ladder\" viewBox=\"0 0 # #\" xmlns=\"http://www.w3.org/2000/svg\">", &[width, height]);
    for rail in [LEFT, width - LEFT] {
        line(&mut out, "M# 4V#", &[rail, height - 4.0], 2.0);
    }
    let mut y = 34.0;
    for rung in rungs {
        fill(&mut out, "<g class=\"rung\" data-view=\"0 # # #\">", &[y - 34.0, width, tall(rung)]);
        draw(&mut out, rung, y, width - LEFT);
        out.push_str("</g>");
        y += tall(rung);
    }
    out.push_str("</svg>");
    out
}

/// Divides a drawing of a ladder by rungs, so that a printed page may end between two of them; any other drawing is one piece.
pub fn pieces(drawing: &str) -> Vec<String> {
    let mut parts = drawing.split("<g class=\"rung\" data-view=\"");
    let rails = parts.next().and_then(|head| head.split_once('>')).map_or("", |(_, rails)| rails);
    let piece = |part: &str| {
        let (view, rung) = part.split_once("\">")?;
        let (rung, _) = rung.split_once("</g>")?;
        Some(format!(
            "<svg class=\"ladder\" viewBox=\"{view}\" xmlns=\"http://www.w3.org/2000/svg\">{rails}{rung}</svg>"
        ))
    };
    let pieces: Vec<String> = parts.filter_map(piece).collect();
    if pieces.is_empty() { vec![drawing.to_owned()] } else { pieces }
}

/// Places of the contacts of a branch from the left rail, each with the middle of its name.
fn places(branch: &[DrawnContact]) -> Vec<f64> {
    let (mut x, mut name_end) = (LEFT, LEFT - 8.0);
    let place = |contact: &DrawnContact| {
        // Names must not overlap.
        let half = 3.7 * contact.device.chars().count() as f64;
        let near = (x + 30.0).max(name_end + 8.0 + half - 5.0);
        (x, name_end) = (near + 10.0, near + 5.0 + half);
        near
    };
    branch.iter().map(place).collect()
}

/// End of the longest branch, including its last name.
fn reach(rung: &DrawnRung) -> f64 {
    let end = |branch: &Vec<DrawnContact>| {
        let half = branch.last().map_or(0.0, |contact| 3.7 * contact.device.chars().count() as f64);
        places(branch).last().map_or(LEFT, |near| near + 5.0 + half.max(5.0))
    };
    rung.branches.iter().map(end).fold(LEFT, f64::max)
}

/// Width of the note between the rails.
fn note_width(rung: &DrawnRung) -> f64 {
    2.0 * LEFT + 16.0 + 6.3 * columns(&rung.note) as f64
}

fn box_width(rung: &DrawnRung) -> f64 {
    13.0 + 7.6 * rung.output.chars().count() as f64
}

fn draw(out: &mut String, rung: &DrawnRung, y: f64, right: f64) {
    text(out, LEFT + 8.0, y - 20.0, Anchor::Start, "f-dim", &rung.note);
    let join = reach(rung) + 6.0;
    for (number, branch) in rung.branches.iter().enumerate() {
        let (mut x, y) = (LEFT, y + BRANCH * number as f64);
        for (contact, near) in branch.iter().zip(places(branch)) {
            let far = near + 10.0;
            line(out, "M# #H#M# #V#M# #V#", &[x, y, near, near, y - 9.0, y + 9.0, far, y - 9.0, y + 9.0], 1.4);
            if contact.inverted {
                line(out, "M# #L# #", &[near - 3.0, y + 10.0, far + 3.0, y - 10.0], 1.4);
            }
            text(out, near + 5.0, y + 20.0, Anchor::Middle, "f-ink value", &contact.device);
            x = far;
        }
        line(out, "M# #H#", &[x, y, join], 1.4);
        if number > 0 {
            line(out, "M# #V#", &[join, y, y - BRANCH], 1.4);
        }
    }
    let width = box_width(rung);
    let begin = right - 14.0 - width;
    line(out, "M# #H#M# #H#", &[join, y, begin, right - 14.0, y, right], 1.4);
    fill(
        out,
        "<rect x=\"#\" y=\"#\" width=\"#\" height=\"22\" rx=\"4\" class=\"f-pane s-ink\" stroke-width=\"1.4\"/>",
        &[begin, y - 11.0, width],
    );
    text(out, begin + width / 2.0, y + 4.0, Anchor::Middle, "f-ink value", &rung.output);
}

fn line(out: &mut String, form: &str, at: &[f64], width: f64) {
    out.push_str("<path d=\"");
    fill(out, form, at);
    fill(out, "\" class=\"f-none s-ink\" stroke-width=\"#\"/>", &[width]);
}

fn text(out: &mut String, x: f64, y: f64, anchor: Anchor, class: &str, words: &str) {
    fill(out, "<text x=\"#\" y=\"#\"", &[x, y]);
    let _ = write!(out, " text-anchor=\"{}\" class=\"{class}\">", anchor.name());
    escape(out, words);
    out.push_str("</text>");
}
