//! Tornado chart: for each fact a bar between the results with less and with more of it, around the present result, with the limit.

use core::fmt::Write;

use super::letters::Anchor;
use super::svg::escape;
use crate::text::number::fill;
use crate::text::units;

/// A fact of the chart.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TornadoBar<'a> {
    /// Name of the fact.
    pub name: &'a str,
    /// The result with less and with more of the fact.
    pub ends: (f64, f64),
}

/// The chart of a result.
#[derive(Debug, Clone, PartialEq)]
pub struct TornadoChart<'a> {
    /// The result and its present value, as a sentence.
    pub title: &'a str,
    /// Unit of its values.
    pub unit: &'a str,
    /// Present value of the result.
    pub value: f64,
    /// Limit of the result, and its name.
    pub limit: Option<(f64, &'a str)>,
    /// Decimals shown.
    pub decimals: u8,
    /// Names of the changes: less and more of a fact.
    pub changes: (&'a str, &'a str),
    /// The facts from top to bottom.
    pub bars: Vec<TornadoBar<'a>>,
}

/// Width of the picture, margin at its sides for the figures, height of the heading, of a bar with its name, and of a bar without it.
const WIDTH: f64 = 340.0;
const SIDE: f64 = 44.0;
const HEAD: f64 = 50.0;
const ROW: f64 = 27.0;
const BAR: f64 = 10.0;

impl TornadoChart<'_> {
    /// The chart as SVG with the classes of the page. Bars without finite ends are omitted.
    pub fn svg(&self) -> String {
        let bars: Vec<_> = self.bars.iter().filter(|bar| bar.ends.0.is_finite() && bar.ends.1.is_finite()).collect();
        let limit = self.limit.filter(|(limit, _)| limit.is_finite());
        let fixed = [Some(self.value), limit.map(|(limit, _)| limit)];
        let ends = || bars.iter().flat_map(|bar| [bar.ends.0, bar.ends.1]).chain(fixed.into_iter().flatten());
        let (low, high) =
            ends().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), end| (low.min(end), high.max(end)));
        let place = |value: f64| {
            if high > low { SIDE + (WIDTH - 2.0 * SIDE) * (value - low) / (high - low) } else { 0.5 * WIDTH }
        };
        let height = HEAD + ROW * bars.len() as f64 + 6.0;
        let mut out = String::with_capacity(1024 + 700 * bars.len());
        let _ =
            write!(out, "<svg class=\"torque\" viewBox=\"0 0 {WIDTH} {height}\" xmlns=\"http://www.w3.org/2000/svg\">");
        self.heading(&mut out);
        if let Some((limit, name)) = limit {
            limit_line(&mut out, place(limit), height, name);
        }
        for (at, bar) in bars.iter().enumerate() {
            let top = HEAD + ROW * at as f64;
            self.bar(&mut out, bar, top, place);
            // Only beside the bars, because the names are between them. In a bar, the limit is a gap.
            let across = |out: &mut String, class: &str, value: f64| {
                let (x, y) = (place(value), top + ROW - BAR - 4.0);
                let _ = write!(out, "<line class=\"{class}\"");
                fill(out, " x1=\"#\" y1=\"#\" x2=\"#\" y2=\"#\"/>", &[x, y, x, y + BAR + 4.0]);
            };
            if let Some((limit, _)) = limit.filter(|(limit, _)| self.reaches(bar, *limit)) {
                across(&mut out, "s-pane", limit);
            }
            across(&mut out, "s-ink", self.value);
        }
        out.push_str("</svg>");
        out
    }

    /// Whether a bar covers a value.
    fn reaches(&self, bar: &TornadoBar, value: f64) -> bool {
        let (low, high) = (bar.ends.0.min(bar.ends.1), bar.ends.0.max(bar.ends.1));
        (low.min(self.value)..=high.max(self.value)).contains(&value)
    }

    /// Writes the title and the key of both halves of a bar.
    fn heading(&self, out: &mut String) {
        out.push_str("<text class=\"f-ink\" x=\"0\" y=\"12\">");
        escape(out, self.title);
        out.push_str("</text>");
        for (class, word, x) in [("f-dim", self.changes.0, 0.0), ("f-accent", self.changes.1, 0.5 * WIDTH)] {
            fill(out, &format!("<rect class=\"{class}\" x=\"#\" y=\"20\" width=\"14\" height=\"9\"/>"), &[x]);
            fill(out, "<text class=\"small f-dim\" x=\"#\" y=\"28\">", &[x + 19.0]);
            escape(out, word);
            out.push_str("</text>");
        }
    }

    /// Writes a fact: its name, both halves of its bar, the figures at their ends.
    fn bar(&self, out: &mut String, bar: &TornadoBar, top: f64, place: impl Fn(f64) -> f64) {
        out.push_str("<g><title>");
        escape(out, bar.name);
        let figure = |value: f64| units::plain(value, self.decimals, self.unit);
        let _ = write!(out, ": {} … {}</title>", figure(bar.ends.0), figure(bar.ends.1));
        fill(out, "<text class=\"small f-ink\" x=\"0\" y=\"#\">", &[top + 10.0]);
        escape(out, bar.name);
        out.push_str("</text>");
        let (centre, y) = (place(self.value), top + ROW - BAR - 2.0);
        // Where both ends are on one side of the present result, each has half of the height: one bar would hide the other. The figure of
        // the shorter bar is then on the free side.
        let (less, more) = (bar.ends.0 - self.value, bar.ends.1 - self.value);
        let halved = less * more > 0.0;
        let wide = if halved { 0.5 * BAR } else { BAR };
        let ends = [("f-dim", less, more, y), ("f-accent", more, less, if halved { y + wide } else { y })];
        for (class, change, other, y) in ends {
            let x = place(self.value + change);
            fill(
                out,
                &format!("<rect class=\"{class}\" x=\"#\" y=\"#\" width=\"#\" height=\"#\"/>"),
                &[centre.min(x), y, (x - centre).abs(), wide],
            );
            let is_shorter = halved && change.abs() < other.abs();
            let to_the_left = (change < 0.0) != is_shorter;
            let (anchor, side) = if to_the_left { (Anchor::End, -4.0) } else { (Anchor::Start, 4.0) };
            if change != 0.0 {
                let _ = write!(out, "<text class=\"small {class}\" text-anchor=\"{}\"", anchor.name());
                let from = if is_shorter { centre } else { x };
                fill(out, " x=\"#\" y=\"#\">", &[from + side, top + ROW - 3.0]);
                out.push_str(&figure(self.value + change));
                out.push_str("</text>");
            }
        }
        out.push_str("</g>");
    }
}

/// Writes the line of the limit over all rows, with its name above it. The names of the facts are written over it.
fn limit_line(out: &mut String, x: f64, height: f64, name: &str) {
    out.push_str("<line class=\"s-ink\" stroke-dasharray=\"3 2\"");
    fill(out, " x1=\"#\" y1=\"#\" x2=\"#\" y2=\"#\"/>", &[x, HEAD - 4.0, x, height]);
    out.push_str("<text class=\"small f-ink\" text-anchor=\"middle\"");
    fill(out, " x=\"#\" y=\"#\">", &[x, HEAD - 7.0]);
    escape(out, name);
    out.push_str("</text>");
}
