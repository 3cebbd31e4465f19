//! A ladder program as plain data, and its drawing.

use core::fmt::Write;

use super::svg::escape;
use crate::text::number::{fill, filled};

/// A contact of a rung.
#[derive(Debug, Clone, PartialEq)]
pub struct Contact {
    /// Device or condition, for instance `X20`.
    pub device: String,
    /// Opens instead of closing.
    pub inverted: bool,
}

/// One rung: contacts in series and what they switch.
#[derive(Debug, Clone, PartialEq)]
pub struct Rung {
    /// Contacts from left to right; none is always on.
    pub contacts: Vec<Contact>,
    /// Instruction with its operands, for instance `MOV R148 R74`; a coil is `OUT Y20`.
    pub output: String,
    /// What the rung is for.
    pub note: String,
}

impl Contact {
    /// A contact that closes.
    pub fn closes(device: impl Into<String>) -> Contact {
        Contact { device: device.into(), inverted: false }
    }
}

/// Width of the drawing, height of a rung, left and right rail.
const WIDTH: f64 = 400.0;
const RUNG: f64 = 58.0;
const LEFT: f64 = 10.0;
const RIGHT: f64 = 390.0;

/// The ladder as SVG, with the classes of the page (`s-ink`, `f-dim` …).
pub fn svg(rungs: &[Rung]) -> String {
    let height = RUNG * rungs.len() as f64 + 8.0;
    let mut out =
        filled("<svg class=\"ladder\" viewBox=\"0 0 # #\" xmlns=\"http://www.w3.org/2000/svg\">", &[WIDTH, height]);
    for rail in [LEFT, RIGHT] {
        line(&mut out, "M# 4V#", &[rail, height - 4.0], 2.0);
    }
    for (at, rung) in rungs.iter().enumerate() {
        draw(&mut out, rung, RUNG * at as f64 + 34.0);
    }
    out.push_str("</svg>");
    out
}

fn draw(out: &mut String, rung: &Rung, y: f64) {
    text(out, LEFT + 8.0, y - 20.0, "start", "f-dim", &rung.note);
    let (mut x, mut name_end) = (LEFT, LEFT - 8.0);
    for contact in &rung.contacts {
        // Names stand beside each other.
        let half = 3.7 * contact.device.chars().count() as f64;
        let near = (x + 30.0).max(name_end + 8.0 + half - 5.0);
        let far = near + 10.0;
        name_end = near + 5.0 + half;
        line(out, "M# #H#M# #V#M# #V#", &[x, y, near, near, y - 9.0, y + 9.0, far, y - 9.0, y + 9.0], 1.4);
        if contact.inverted {
            line(out, "M# #L# #", &[near - 3.0, y + 10.0, far + 3.0, y - 10.0], 1.4);
        }
        text(out, near + 5.0, y + 20.0, "middle", "f-ink value", &contact.device);
        x = far;
    }
    let width = 13.0 + 7.6 * rung.output.chars().count() as f64;
    let begin = RIGHT - 14.0 - width;
    line(out, "M# #H#M# #H#", &[x, y, begin, RIGHT - 14.0, y, RIGHT], 1.4);
    fill(
        out,
        "<rect x=\"#\" y=\"#\" width=\"#\" height=\"22\" rx=\"4\" class=\"f-pane s-ink\" stroke-width=\"1.4\"/>",
        &[begin, y - 11.0, width],
    );
    text(out, begin + width / 2.0, y + 4.0, "middle", "f-ink value", &rung.output);
}

fn line(out: &mut String, form: &str, at: &[f64], width: f64) {
    out.push_str("<path d=\"");
    fill(out, form, at);
    fill(out, "\" class=\"f-none s-ink\" stroke-width=\"#\"/>", &[width]);
}

fn text(out: &mut String, x: f64, y: f64, anchor: &str, class: &str, words: &str) {
    fill(out, "<text x=\"#\" y=\"#\"", &[x, y]);
    let _ = write!(out, " text-anchor=\"{anchor}\" class=\"{class}\">");
    escape(out, words);
    out.push_str("</text>");
}
