//! The timing diagram, and files beside programs and sheets: the section in true millimetres as SVG and DXF, the part with codes of its own.

use core::fmt::Write;

use super::native_code;
use super::resolved::Resolved;
use super::scene::ideal;
use super::sheets::{TRACKS, say, steps};
use crate::nc::File;
use crate::text::number::{Plain, fill, filled};
use crate::view::outline::{Outline, OutlineShape};
use crate::view::svg::escape;

/// Steps along an arc of the section: half a micrometre on a usual part.
const STEPS: u32 = 64;

/// The files beside programs and sheets.
pub(super) fn drawings(lathe: &Resolved) -> Vec<File> {
    let file = |name: &str, text: String| File { name: name.to_owned(), text };
    let mut files = Vec::new();
    if lathe.ratio().is_some() {
        files.push(native_code::file(lathe));
    }
    if let Some(outline) = section(lathe) {
        files.push(file("section.svg", outline.svg()));
        files.push(file("section.dxf", outline.dxf()));
    }
    files
}

/// The finished section, the ideal polygon and the stock.
fn section(lathe: &Resolved) -> Option<Outline> {
    let section = lathe.section()?;
    let p = &lathe.p;
    let mut shapes = vec![
        OutlineShape { layer: "FINISHED", points: section.points(STEPS), radius: 0.0 },
        OutlineShape { layer: "STOCK", points: Vec::new(), radius: section.stock() },
    ];
    if p.sides > 2.0 {
        let points = ideal(p.sides as u32, 0.5 * p.across_flats, section.begin());
        shapes.push(OutlineShape { layer: "IDEAL", points, radius: 0.0 });
    }
    Some(Outline { shapes })
}

/// Left and right edge of the diagram, and the height of a track.
const LEFT: f64 = 10.0;
const RIGHT: f64 = 390.0;
const TRACK: f64 = 44.0;

/// When which signal is on, from G512 to G502. The cut is shown shorter than it is.
pub(super) fn sequence(lathe: &Resolved) -> String {
    let steps = steps(lathe);
    // Every step gets its own column, so that short ones are seen.
    let column = (RIGHT - LEFT) / steps.len() as f64;
    let middle = |at: usize| LEFT + column * (at as f64 + 0.5);
    // A line for each sentence.
    let note = say("polygon.sequence.note");
    let lines: Vec<&str> = note.split_inclusive(". ").collect();
    let bottom = 24.0 + TRACK * TRACKS.len() as f64;
    let height = bottom + 14.0 * (lines.len() as f64 + 1.0);
    let mut out =
        filled("<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"ladder\" viewBox=\"0 0 400 #\">", &[height]);
    let text = |x: f64, y: f64, look: &str, words: &str, out: &mut String| {
        fill(out, "<text x=\"#\" y=\"#\" ", &[x, y]);
        let _ = write!(out, "{look}>");
        escape(out, words);
        out.push_str("</text>");
    };
    for (at, (t, _, _)) in steps.iter().enumerate() {
        let time = format!("{} s", Plain(*t, 2));
        text(middle(at), 14.0, "text-anchor=\"middle\" class=\"f-dim small\"", &time, &mut out);
        fill(&mut out, "<path d=\"M# 20V#\" class=\"f-none s-line\"/>", &[middle(at), bottom]);
    }
    for (track, name) in TRACKS.iter().enumerate() {
        let low = 18.0 + TRACK * (track as f64 + 1.0);
        text(LEFT, low - 24.0, "class=\"f-ink\"", &say(name), &mut out);
        fill(&mut out, "<path d=\"M# #", &[LEFT, low]);
        for (at, (_, _, changes)) in steps.iter().enumerate() {
            for (_, on) in changes.iter().filter(|(changed, _)| *changed == track) {
                fill(&mut out, "H#V#", &[middle(at), if *on { low - 18.0 } else { low }]);
            }
        }
        fill(&mut out, "H#\" class=\"f-none s-accent\" stroke-width=\"2\"/>", &[RIGHT]);
    }
    for (at, line) in lines.into_iter().enumerate() {
        text(LEFT, bottom + 14.0 * (at as f64 + 1.0), "class=\"f-dim small\"", line.trim(), &mut out);
    }
    out.push_str("</svg>");
    out
}
