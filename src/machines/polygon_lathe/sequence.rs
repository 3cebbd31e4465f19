//! The sequence from G512 to G502: its steps in closed form, as a table and as a timing diagram.

use core::fmt::Write;

use super::citations::OURS;
use super::resolved::PolygonLathe;
use crate::machines::sheets::{row, say};
use crate::text::catalog::number_text as show;
use crate::text::number::{Plain, fill, filled};
use crate::view::svg::escape;
use crate::view::{Column, Sheet, SheetKind};

/// Signals that rise and fall, in the order of the diagram.
const TRACKS: [&str; 6] = [
    "polygon.track.index",
    "polygon.track.at-angle",
    "polygon.track.turn",
    "polygon.track.at-speed",
    "polygon.track.on",
    "polygon.track.slide",
];

/// A step of the sequence: its time (s), its text, and the tracks that change, as (index, on).
type Step = (f64, &'static str, Vec<(usize, bool)>);

/// Steps from G512 to G502, with times in closed form that leave out the blocks of the macro programs.
fn steps(lathe: &PolygonLathe) -> Vec<Step> {
    let (p, d) = (&lathe.params, &lathe.derived);
    let angle = p.index_time() + p.settling();
    let speed = angle + p.settling();
    let cut = speed + d.times.cutting;
    vec![
        (0.0, "polygon.step.request", vec![(0, true), (4, true)]),
        (p.index_time(), "polygon.step.told", vec![]),
        (angle, "polygon.step.at-angle", vec![(1, true)]),
        (angle, "polygon.step.turn", vec![(2, true)]),
        (speed, "polygon.step.at-speed", vec![(3, true)]),
        (speed, "polygon.step.cut", vec![(5, true)]),
        (cut, "polygon.step.off", vec![(5, false), (2, false), (0, false), (1, false), (3, false)]),
        (cut + p.settling(), "polygon.step.stands", vec![(4, false)]),
    ]
}

/// Ids and titles of the sequences, in the order of the polygons.
const SHEETS: [(&str, &str); 3] = [
    ("sequence", "polygon.sheet.sequence"),
    ("second-sequence", "polygon.second.sequence"),
    ("third-sequence", "polygon.third.sequence"),
];

/// The sequence of every polygon as a table with its diagram.
pub(super) fn all(lathe: &PolygonLathe) -> impl Iterator<Item = Sheet> {
    lathe.polygons().zip(SHEETS).map(|(lathe, name)| sheet(lathe, name))
}

fn sheet(lathe: &PolygonLathe, (id, title): (&'static str, &'static str)) -> Sheet {
    let step = |(t, text, _): Step| row([show(t, 3), say(text)], OURS);
    let coasts = lathe.params.coasts(lathe.control);
    let emergency = if coasts { "polygon.step.coast" } else { "polygon.step.emergency" };
    let breaks = ["polygon.step.held", "polygon.step.reset", emergency];
    let breaks = breaks.map(|text| row([String::new(), say(text)], OURS));
    Sheet {
        id,
        kind: SheetKind::Plain,
        title,
        columns: vec![Column::Plain("polygon.sheet.time"), Column::Prose("sheet.use")],
        rows: steps(lathe).into_iter().map(step).chain(breaks).collect(),
        drawing: diagram(lathe),
    }
}

/// Left and right edge of the diagram, and the height of a track.
const LEFT: f64 = 10.0;
const RIGHT: f64 = 390.0;
const TRACK: f64 = 44.0;

/// Timing diagram of the signals from G512 to G502; the cut is shortened.
fn diagram(lathe: &PolygonLathe) -> String {
    let steps = steps(lathe);
    // Every step has its own column, so that short steps are visible.
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
