//! Torque over speed of a motor: its continuous and its peak curve, and the operating lines of a run, drawn by their duration.

use core::fmt::Write;

use super::letters::Anchor;
use super::plot::{decimals, keys};
use super::svg::escape;
use crate::text::catalog::number_text;
use crate::text::number::{Plain, fill};

/// Speed in r/min and torque in Nm.
pub type MotorPoint = (f64, f64);

/// A part of a run with constant torque and linear change of speed. Negative torque brakes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OperatingLine {
    /// Speeds at its ends, r/min, 0 or more.
    pub speeds: (f64, f64),
    /// Torque, Nm.
    pub torque: f64,
    /// Time of its first occurrence, s.
    pub t: f64,
    /// Total duration in the run, s.
    pub seconds: f64,
    /// The line belongs to the run with the knob at its highest position, not to the shown run.
    pub is_at_highest_knob: bool,
}

/// The chart of a motor.
#[derive(Debug, Clone, PartialEq)]
pub struct TorqueChart {
    /// Continuous torque over speed.
    pub continuous: Vec<MotorPoint>,
    /// Short-time torque over speed.
    pub peak: Vec<MotorPoint>,
    /// Operating lines of the run.
    pub lines: Vec<OperatingLine>,
    /// Mean speed and effective torque of the run.
    pub effective: MotorPoint,
}

/// Width and height of the picture, and its margins: left, right, top, bottom.
const SIZE: (f64, f64) = (340.0, 220.0);
const MARGINS: (f64, f64, f64, f64) = (44.0, 14.0, 16.0, 34.0);

/// Maximum grid lines, across and up.
const GRID: (usize, usize) = (5, 5);

/// Shares of the run's time above which a line counts as long-lasting, and as short.
const LASTING: f64 = 0.1;
const PASSING: f64 = 0.01;

/// Width of the strip along a line that reacts to the pointer.
const HIT: f64 = 10.0;

/// Words of the picture.
#[derive(Debug, Clone, Copy)]
pub struct TorqueWords<'a> {
    /// Name of the continuous curve.
    pub continuous: &'a str,
    /// Name of the peak curve.
    pub peak: &'a str,
    /// Name of the effective torque.
    pub effective: &'a str,
    /// Text before the time of an operating line.
    pub at: &'a str,
    /// Position of the knob, for lines of the run with the knob at its highest position.
    pub knob: &'a str,
}

/// Scales from speed and torque to positions in the picture.
struct Plane {
    speed: f64,
    torque: (f64, f64),
}

impl Plane {
    fn of(chart: &TorqueChart) -> Plane {
        let points = || chart.continuous.iter().chain(&chart.peak).copied();
        let ends = || chart.lines.iter().flat_map(|line| [(line.speeds.0, line.torque), (line.speeds.1, line.torque)]);
        let all = || points().chain(ends()).chain([chart.effective]).filter(|(x, y)| x.is_finite() && y.is_finite());
        let most = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0_f64, f64::max);
        let (speed, top) = (most(&mut all().map(|point| point.0)), most(&mut all().map(|point| point.1)));
        let least = all().map(|point| point.1).fold(0.0_f64, f64::min);
        let room = |value: f64| if value > 0.0 { 1.08 * value } else { 1.0 };
        Plane { speed: room(speed), torque: (1.08 * least, room(top)) }
    }

    fn x(&self, speed: f64) -> f64 {
        MARGINS.0 + (SIZE.0 - MARGINS.0 - MARGINS.1) * speed / self.speed
    }

    fn y(&self, torque: f64) -> f64 {
        let (low, high) = self.torque;
        SIZE.1 - MARGINS.3 - (SIZE.1 - MARGINS.2 - MARGINS.3) * (torque - low) / (high - low)
    }
}

impl OperatingLine {
    /// Writes the line by its share of the run's time, with a tooltip.
    fn put(&self, out: &mut String, plane: &Plane, share: f64, words: &TorqueWords) {
        let (class, width) = match share {
            _ if self.is_at_highest_knob => ("s-dim", 1.5),
            share if share >= LASTING => ("s-accent", 5.0),
            share if share >= PASSING => ("s-accent", 2.5),
            _ => ("s-dim", 1.5),
        };
        let (from, to, y) = (plane.x(self.speeds.0), plane.x(self.speeds.1), plane.y(self.torque));
        // A single point is drawn too.
        let to = if (to - from).abs() < 1.0 { from + 1.0 } else { to };
        out.push_str("<g");
        if self.is_at_highest_knob {
            out.push_str(" opacity=\"0.6\"");
        } else {
            let _ = write!(out, " data-at=\"{}\"", Plain(self.t, 3));
        }
        out.push_str("><title>");
        escape(out, words.at);
        let _ = write!(out, " {} s", number_text(self.t, 2));
        if self.is_at_highest_knob {
            out.push_str(", ");
            escape(out, words.knob);
        }
        let _ = write!(
            out,
            ": {} Nm, {}–{} r/min, {} s, {} %</title>",
            number_text(self.torque, 3),
            number_text(self.speeds.0, 0),
            number_text(self.speeds.1, 0),
            number_text(self.seconds, 2),
            number_text(100.0 * share, 1),
        );
        for (paint, width) in [(format!("class=\"{class}\""), width), ("stroke=\"transparent\"".to_owned(), HIT)] {
            let _ = write!(out, "<line {paint} stroke-linecap=\"round\"");
            fill(out, " stroke-width=\"#\" x1=\"#\" y1=\"#\" x2=\"#\" y2=\"#\"/>", &[width, from, y, to, y]);
        }
        out.push_str("</g>");
    }
}

impl TorqueChart {
    /// The chart as SVG with the classes of the page; a line of the shown run has its time as `data-at`. Points with NaN or infinity are
    /// omitted.
    pub fn svg(&self, words: &TorqueWords) -> String {
        let plane = Plane::of(self);
        let mut out = String::with_capacity(4096 + 320 * self.lines.len());
        let _ = write!(
            out,
            "<svg class=\"torque\" viewBox=\"0 0 {} {}\" xmlns=\"http://www.w3.org/2000/svg\">",
            SIZE.0, SIZE.1
        );
        grid(&mut out, &plane);
        self.run(&mut out, &plane, words);
        self.motor(&mut out, &plane, words);
        out.push_str("</svg>");
        out
    }

    /// Writes the lines of the runs in layers, longest-lasting on top, by their share of the run's time. Lines with the knob at its highest
    /// position come first, in a lighter style.
    fn run(&self, out: &mut String, plane: &Plane, words: &TorqueWords) {
        for at_highest_knob in [true, false] {
            let of_run = || self.lines.iter().filter(|line| line.is_at_highest_knob == at_highest_knob);
            let all: f64 = of_run().map(|line| line.seconds).sum();
            let mut lines: Vec<&OperatingLine> = of_run().filter(|line| line.torque.is_finite()).collect();
            lines.sort_by(|a, b| a.seconds.total_cmp(&b.seconds));
            for line in lines {
                line.put(out, plane, if all > 0.0 { line.seconds / all } else { 0.0 }, words);
            }
        }
    }

    /// Writes the motor's curves and its effective torque.
    fn motor(&self, out: &mut String, plane: &Plane, words: &TorqueWords) {
        for (points, word, dashes) in
            [(&self.continuous, words.continuous, ""), (&self.peak, words.peak, " stroke-dasharray=\"6 4\"")]
        {
            let points: Vec<_> = points.iter().filter(|(x, y)| x.is_finite() && y.is_finite()).collect();
            let Some((_, first)) = points.first() else { continue };
            let _ =
                write!(out, "<polyline class=\"s-ink f-none\" fill=\"none\" stroke-width=\"1.5\"{dashes} points=\"");
            points.iter().for_each(|(x, y)| fill(out, "#,# ", &[plane.x(*x), plane.y(*y)]));
            out.push_str("\"/>");
            fill(out, "<text class=\"small f-ink\" x=\"#\" y=\"#\">", &[plane.x(0.0) + 6.0, plane.y(*first) - 5.0]);
            escape(out, word);
            out.push_str("</text>");
        }
        let (x, y) = (plane.x(self.effective.0), plane.y(self.effective.1));
        if x.is_finite() && y.is_finite() {
            fill(out, "<circle class=\"s-ink f-pane\" stroke-width=\"1.5\" cx=\"#\" cy=\"#\" r=\"4\"/>", &[x, y]);
            // Toward the side with more space.
            let (anchor, side) = if x > 0.6 * SIZE.0 { (Anchor::End, -8.0) } else { (Anchor::Start, 8.0) };
            let _ = write!(out, "<text class=\"small f-ink\" text-anchor=\"{}\"", anchor.name());
            fill(out, " x=\"#\" y=\"#\">", &[x + side, y - 7.0]);
            escape(out, words.effective);
            let _ = write!(out, " {} Nm</text>", number_text(self.effective.1, 3));
        }
    }
}

/// Writes grid, figures and units.
fn grid(out: &mut String, plane: &Plane) {
    let (left, right) = (MARGINS.0, SIZE.0 - MARGINS.1);
    let (top, bottom) = (MARGINS.2, SIZE.1 - MARGINS.3);
    let speeds = keys((0.0, plane.speed), GRID.0);
    let torques = keys(plane.torque, GRID.1);
    for speed in &speeds {
        let x = plane.x(*speed);
        fill(out, "<line class=\"s-line\" x1=\"#\" y1=\"#\" x2=\"#\" y2=\"#\"/>", &[x, top, x, bottom]);
        fill(out, "<text class=\"small f-dim\" text-anchor=\"middle\" x=\"#\" y=\"#\">", &[x, bottom + 13.0]);
        let _ = write!(out, "{}</text>", number_text(*speed, decimals(&speeds)));
    }
    for torque in &torques {
        let (y, class) = (plane.y(*torque), if *torque == 0.0 { "s-ink" } else { "s-line" });
        fill(out, &format!("<line class=\"{class}\" x1=\"#\" y1=\"#\" x2=\"#\" y2=\"#\"/>"), &[left, y, right, y]);
        fill(out, "<text class=\"small f-dim\" text-anchor=\"end\" x=\"#\" y=\"#\">", &[left - 5.0, y + 3.5]);
        let _ = write!(out, "{}</text>", number_text(*torque, decimals(&torques)));
    }
    fill(out, "<text class=\"small f-dim\" text-anchor=\"end\" x=\"#\" y=\"#\">r/min</text>", &[right, SIZE.1 - 6.0]);
    fill(out, "<text class=\"small f-dim\" x=\"2\" y=\"#\">Nm</text>", &[top - 5.0]);
}
