//! Torque over speed of a motor: its continuous and its peak curve, and the operating lines of a run, drawn by their duration.

use core::fmt::Write;

use super::letters::{Anchor, LETTER_BOX};
use super::plot::{decimals, keys};
use super::svg::escape;
use crate::math;
use crate::text::catalog::number_text;
use crate::text::columns;
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

/// Share of the motor's greatest torque below which the run sets the scale: its lines would otherwise be a smear on the zero line. Torque at the
/// top is then a multiple of the run's greatest torque.
const SMALL: f64 = 0.25;
const SHOWN: f64 = 3.0;

/// Letter size of the labels, and pixels between them and lines.
const LETTERS: f64 = 10.0;
const GAP: f64 = 1.5;

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
        let of_run = ends().chain([chart.effective]).map(|point| point.1.abs()).filter(|torque| torque.is_finite());
        let required = most(&mut { of_run });
        let is_small = required > 0.0 && required < SMALL * top;
        Plane { speed: room(speed), torque: (1.08 * least, if is_small { SHOWN * required } else { room(top) }) }
    }

    /// The parts of a curve below the upper edge, in the picture.
    fn shown(&self, points: &[MotorPoint]) -> Vec<Vec<MotorPoint>> {
        let top = self.torque.1;
        let mut parts: Vec<Vec<MotorPoint>> = vec![Vec::new()];
        for (at, point) in points.iter().enumerate() {
            let before = at.checked_sub(1).and_then(|at| points.get(at));
            if let Some(before) = before.filter(|before| (before.1 <= top) != (point.1 <= top)) {
                let part = (top - before.1) / (point.1 - before.1);
                let crossing = (before.0 + part * (point.0 - before.0), top);
                parts.last_mut().into_iter().for_each(|part| part.push(crossing));
            }
            if point.1 <= top {
                parts.last_mut().into_iter().for_each(|part| part.push(*point));
            } else {
                parts.push(Vec::new());
            }
        }
        parts.retain(|part| !part.is_empty());
        parts.iter().map(|part| part.iter().map(|(x, y)| (self.x(*x), self.y(*y))).collect()).collect()
    }

    fn x(&self, speed: f64) -> f64 {
        MARGINS.0 + (SIZE.0 - MARGINS.0 - MARGINS.1) * speed / self.speed
    }

    fn y(&self, torque: f64) -> f64 {
        let (low, high) = self.torque;
        SIZE.1 - MARGINS.3 - (SIZE.1 - MARGINS.2 - MARGINS.3) * (torque - low) / (high - low)
    }
}

/// Point of a label's base line, and the part of its text at the point.
type LabelPlace = (f64, f64, Anchor);

/// Labels of the picture, clear of its lines and of each other.
#[derive(Default)]
struct ChartLabels {
    /// Areas of lines and labels: left, top, right, bottom.
    taken: Vec<[f64; 4]>,
}

impl ChartLabels {
    /// Keeps labels off a line.
    fn keep_off(&mut self, from: MotorPoint, to: MotorPoint) {
        let count = (math::hypot(to.0 - from.0, to.1 - from.1) / 6.0).ceil().max(1.0);
        let at = |share: f64| (from.0 + (to.0 - from.0) * share, from.1 + (to.1 - from.1) * share);
        for piece in 0..count as u32 {
            let (a, b) = (at(f64::from(piece) / count), at(f64::from(piece + 1) / count));
            self.taken.push([a.0.min(b.0), a.1.min(b.1), a.0.max(b.0), a.1.max(b.1)]);
        }
    }

    /// Writes a label at the first place that is free, else at the first one.
    fn put(&mut self, out: &mut String, text: &str, places: &[LabelPlace]) {
        let area = |(x, y, anchor): LabelPlace| LETTER_BOX.area((x, y), anchor, LETTERS, columns(text));
        let is_free = |place: &LabelPlace| {
            let [left, top, right, bottom] = area(*place);
            let is_within = left >= MARGINS.0 && right <= SIZE.0 && top >= 0.0 && bottom <= SIZE.1 - MARGINS.3;
            let is_beside = |taken: &[f64; 4]| {
                left > taken[2] + GAP || right < taken[0] - GAP || top > taken[3] + GAP || bottom < taken[1] - GAP
            };
            is_within && self.taken.iter().all(is_beside)
        };
        let Some(place) = places.iter().find(|place| is_free(place)).or(places.first()) else { return };
        self.taken.push(area(*place));
        let (x, y, anchor) = *place;
        let _ = write!(out, "<text class=\"small f-ink\" text-anchor=\"{}\"", anchor.name());
        fill(out, " x=\"#\" y=\"#\">", &[x, y]);
        escape(out, text);
        out.push_str("</text>");
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

    /// Writes the motor's curves and its effective torque. A curve that leaves the picture has its greatest torque at the upper edge.
    fn motor(&self, out: &mut String, plane: &Plane, words: &TorqueWords) {
        let mut labels = ChartLabels::default();
        labels.keep_off((MARGINS.0, plane.y(0.0)), (SIZE.0 - MARGINS.1, plane.y(0.0)));
        for line in self.lines.iter().filter(|line| line.torque.is_finite()) {
            let y = plane.y(line.torque);
            labels.keep_off((plane.x(line.speeds.0), y), (plane.x(line.speeds.1), y));
        }
        let mut names: Vec<(String, Vec<LabelPlace>)> = Vec::new();
        for (points, word, dashes) in
            [(&self.continuous, words.continuous, ""), (&self.peak, words.peak, " stroke-dasharray=\"6 4\"")]
        {
            let points: Vec<_> = points.iter().copied().filter(|(x, y)| x.is_finite() && y.is_finite()).collect();
            let Some((_, first)) = points.first() else { continue };
            for part in plane.shown(&points) {
                let _ = write!(
                    out,
                    "<polyline class=\"s-ink f-none\" fill=\"none\" stroke-width=\"1.5\"{dashes} points=\""
                );
                part.iter().for_each(|(x, y)| fill(out, "#,# ", &[*x, *y]));
                out.push_str("\"/>");
                part.windows(2).for_each(|ends| labels.keep_off(ends[0], ends[1]));
            }
            let greatest = points.iter().map(|point| point.1).fold(*first, f64::max);
            if greatest > plane.torque.1 {
                names.push((format!("{word} {} Nm ↑", number_text(greatest, 3)), at_the_top()));
            } else {
                names.push((word.to_owned(), beside_a_curve(plane, *first)));
            }
        }
        let (x, y) = (plane.x(self.effective.0), plane.y(self.effective.1));
        let has_point = x.is_finite() && y.is_finite();
        if has_point {
            fill(out, "<circle class=\"s-ink f-pane\" stroke-width=\"1.5\" cx=\"#\" cy=\"#\" r=\"4\"/>", &[x, y]);
            labels.taken.push([x - 4.0, y - 4.0, x + 4.0, y + 4.0]);
        }
        for (text, places) in &names {
            labels.put(out, text, places);
        }
        if has_point {
            let text = format!("{} {} Nm", words.effective, number_text(self.effective.1, 3));
            labels.put(out, &text, &beside_a_point(x, y));
        }
    }
}

/// Places of a label at the upper edge, from left to right, then below it.
fn at_the_top() -> Vec<LabelPlace> {
    let (left, right) = (MARGINS.0 + 6.0, SIZE.0 - MARGINS.1 - 2.0);
    let row = |y: f64| [(left, y, Anchor::Start), (right, y, Anchor::End)];
    [10.0, 24.0, 38.0].into_iter().flat_map(|down| row(MARGINS.2 + down)).collect()
}

/// Places of the name of a curve that begins at a torque: above and below its start, then further to the right.
fn beside_a_curve(plane: &Plane, torque: f64) -> Vec<LabelPlace> {
    let y = plane.y(torque);
    let lefts = (0..6).map(|step| plane.x(0.0) + 6.0 + 36.0 * f64::from(step));
    lefts.flat_map(|x| [(x, y - 5.0, Anchor::Start), (x, y + 12.0, Anchor::Start)]).collect()
}

/// Places of a label beside a point: above and below on the side with more space, then on the other, then further away.
fn beside_a_point(x: f64, y: f64) -> Vec<LabelPlace> {
    let (right, left) = ((8.0, Anchor::Start), (-8.0, Anchor::End));
    let sides = if x > 0.6 * SIZE.0 { [left, right] } else { [right, left] };
    let rows = [-7.0, 14.0, -20.0, 27.0, -33.0, 40.0, -46.0];
    rows.iter().flat_map(|down| sides.map(|(side, anchor)| (x + side, y + down, anchor))).collect()
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
