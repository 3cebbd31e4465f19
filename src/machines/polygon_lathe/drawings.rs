//! Files beside programs and sheets: the section in true millimetres as SVG and DXF, the timing diagram, the part with codes of its own.

use core::fmt::Write;

use super::fitted::Fitted;
use super::other;
use super::scene::ideal;
use super::sheets::{TRACKS, say, steps};
use crate::nc::File;
use crate::text::number::{Plain, fill};
use crate::view::outline::{Outline, Shape};
use crate::view::svg::escape;

/// Steps along an arc of the section: half a micrometre on a usual part.
const STEPS: u32 = 64;

/// All files.
pub(super) fn drawings(lathe: &Fitted) -> Vec<File> {
    let file = |name: &str, text: String| File { name: name.to_owned(), text };
    let mut files = vec![file("sequence.svg", sequence(lathe))];
    if lathe.ratio().is_some() {
        files.push(other::file(lathe));
    }
    if let Some(outline) = section(lathe) {
        files.push(file("section.svg", outline.svg()));
        files.push(file("section.dxf", outline.dxf()));
    }
    files
}

/// The finished section, the ideal polygon and the stock.
fn section(lathe: &Fitted) -> Option<Outline> {
    let section = lathe.section()?;
    let p = &lathe.p;
    let mut shapes = vec![
        Shape { layer: "FINISHED", points: section.points(STEPS), radius: 0.0 },
        Shape { layer: "STOCK", points: Vec::new(), radius: section.stock() },
    ];
    if p.sides > 2.0 {
        let points = ideal(p.sides as u32, 0.5 * p.across_flats, section.begin());
        shapes.push(Shape { layer: "IDEAL", points, radius: 0.0 });
    }
    Some(Outline { shapes })
}

/// Left edge of the diagram, its width, and the height of a track.
const LEFT: f64 = 190.0;
const WIDTH: f64 = 520.0;
const TRACK: f64 = 34.0;

/// When which signal is on, from G512 to G502. The cut is shown shorter than it is.
fn sequence(lathe: &Fitted) -> String {
    let steps = steps(lathe);
    // Every step gets its own column, so that short ones are seen.
    let column = WIDTH / steps.len() as f64;
    let height = TRACK * TRACKS.len() as f64 + 60.0;
    let mut out = String::from("<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"ladder\" viewBox=\"0 0 ");
    let _ = write!(out, "{} {}\">", Plain(LEFT + WIDTH + 20.0, 2), Plain(height, 2));
    out.push_str("<style>text{font:11px system-ui,sans-serif}path{fill:none;stroke:#17212b}</style>");
    let text = |x: f64, y: f64, anchor: &str, words: &str, out: &mut String| {
        fill(out, "<text x=\"#\" y=\"#\"", &[x, y]);
        let _ = write!(out, " text-anchor=\"{anchor}\">");
        escape(out, words);
        out.push_str("</text>");
    };
    for (track, name) in TRACKS.iter().enumerate() {
        let low = 30.0 + TRACK * (track as f64 + 0.8);
        text(LEFT - 10.0, low - 4.0, "end", &say(name), &mut out);
        fill(&mut out, "<path d=\"M# #", &[LEFT, low]);
        for (at, (_, _, changes)) in steps.iter().enumerate() {
            for (_, on) in changes.iter().filter(|(changed, _)| *changed == track) {
                let y = if *on { low - 0.55 * TRACK } else { low };
                fill(&mut out, "H#V#", &[LEFT + column * (at as f64 + 0.5), y]);
            }
        }
        fill(&mut out, "H#\"/>", &[LEFT + WIDTH]);
    }
    for (at, (t, _, _)) in steps.iter().enumerate() {
        let x = LEFT + column * (at as f64 + 0.5);
        text(x, 18.0, "middle", &format!("{} s", Plain(*t, 2)), &mut out);
    }
    text(LEFT, height - 8.0, "start", &say("polygon.sequence.note"), &mut out);
    out.push_str("</svg>");
    out
}
