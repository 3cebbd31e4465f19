//! The instruments on the headstock: speed of the spindle with its limits, and voltage of the analog output.

use super::ids::{group, node};
use crate::machines::turning_spindle::params::{Output, Params};
use crate::machines::turning_spindle::resolved::TurningSpindle;
use crate::math;
use crate::text::catalog::number_text as show;
use crate::text::number::{fill, filled};
use crate::view::drawing::{Drawing, polar, spoke};
use crate::view::letters::Anchor;
use crate::view::look::{Look, Paint};
use crate::view::scene::Font;

/// Left, top, width and height of the panel.
pub(super) const PANEL: [f64; 4] = [-6.0, 52.0, 230.0, 164.0];
/// Centre and radius of the dial of the speed; degrees of its scale, from its lowest mark.
const DIAL: (f64, f64, f64) = (52.0, 112.0, 45.0);
const DIAL_FROM: f64 = 135.0;
const DIAL_SWEEP: f64 = 270.0;
/// Centre and half width of the voltmeter, and its pivot, radius and degrees of the scale from its middle to either end.
const METER: (f64, f64, f64) = (165.0, 112.0, 47.0);
const PIVOT: (f64, f64) = (165.0, 142.0);
const METER_RADIUS: f64 = 62.0;
const METER_SWEEP: f64 = 44.0;
/// Height of the letters on the dials.
const LETTERS: f64 = 13.0;
/// Height of the figures below them; they scale with the panel.
const FIGURES: f64 = 14.0;

/// The scale of the speed dial: its end, the step of its long marks, and the unit of its figures, all in r/min.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Scale {
    end: f64,
    step: f64,
    unit: f64,
}

impl Scale {
    /// The scale with two to four long steps that shows every speed of the machine.
    fn of(lathe: &TurningSpindle) -> Scale {
        let top = lathe.params.stages().fold(lathe.params.chuck_limit.min(lathe.derived.stage.top), f64::max).max(1.0);
        let mut step = 0.1;
        // 1, 2, 5, 10, 20, 50 …
        for at in 0..24 {
            let decade = math::pow(10.0, f64::from(at / 3));
            step = decade * [1.0, 2.0, 5.0].get(at as usize % 3).copied().unwrap_or(1.0);
            if step * 4.0 >= top {
                break;
            }
        }
        let end = step * (top / step).ceil();
        Scale { end, step, unit: if end >= 1000.0 { 1000.0 } else { 1.0 } }
    }

    /// Degrees of the dial for a speed, clockwise from the right.
    fn degrees(&self, speed: f64) -> f64 {
        DIAL_FROM + DIAL_SWEEP * math::clamp(speed.abs() / self.end, 0.0, 1.04)
    }
}

/// The panel with both instruments at rest.
pub(super) fn draw(drawing: &mut Drawing, lathe: &TurningSpindle) {
    let [x, y, w, h] = PANEL;
    // The bracket that carries the panel.
    drawing.rect([x + 70.0, y + h - 4.0, 22.0, 20.0, 0.0], Look::fill(Paint::DarkShade));
    drawing.rect([x + 140.0, y + h - 4.0, 22.0, 20.0, 0.0], Look::fill(Paint::DarkShade));
    drawing.rect([x, y, w, h, 9.0], Look::fill(Paint::DarkFront).thin(Paint::Edge, 1.0));
    drawing.path(filled("M# #V#q0 -8 8 -8H#", &[x + 1.5, y + h - 9.0, y + 9.5, x + w - 10.0]), Look::RIM.faint(0.5));
    for (x, y) in [(x + 8.0, y + 8.0), (x + w - 8.0, y + 8.0), (x + 8.0, y + h - 8.0), (x + w - 8.0, y + h - 8.0)] {
        drawing.circle((x, y, 2.8), Look::fill(Paint::DarkShade));
    }
    dial(drawing, lathe);
    meter(drawing, &lathe.params);
    for (x, id) in [(DIAL.0, node::SPEED), (METER.0, node::VOLTS)] {
        drawing.text((x, y + h - 17.0), Anchor::Middle, "", Font::Engraved(FIGURES), Paint::Rim).id = Some(id);
    }
}

fn dial(drawing: &mut Drawing, lathe: &TurningSpindle) {
    let (x, y, r) = DIAL;
    let (p, scale) = (&lathe.params, Scale::of(lathe));
    drawing.circle((x, y, r + 4.0), Look::fill(Paint::Black));
    drawing.circle((x, y, r), Look::fill(Paint::Rim));
    // Speeds above the limit of the program or of the chuck.
    drawing.showing("upper-limit", |drawing| {
        drawing
            .path(band(&scale, p.upper_limit.min(p.chuck_limit), scale.end, r - 2.5), Look::line(Paint::Needle, 4.0));
    });
    let mut marks = String::new();
    let (steps, fine) = ((scale.end / scale.step).round() as u32, 5);
    for mark in 0..=steps * fine {
        let degrees = scale.degrees(scale.step * f64::from(mark) / f64::from(fine));
        let is_long = mark % fine == 0;
        marks += &spoke((x, y), degrees, r - if is_long { 9.0 } else { 5.5 }, r - 1.0);
    }
    drawing.path(marks, Look::line(Paint::Black, 1.3));
    for mark in 0..=steps {
        let value = scale.step * f64::from(mark);
        let (x, y) = polar((x, y), scale.degrees(value), r - 17.0);
        let text = show(value / scale.unit, 1);
        drawing.text((x, y + 0.36 * LETTERS), Anchor::Middle, &text, Font::Engraved(LETTERS), Paint::Black);
    }
    let unit = if scale.unit > 1.0 { "×1000/min" } else { "r/min" };
    drawing.text((x, y + r - 8.0), Anchor::Middle, unit, Font::Engraved(7.5), Paint::Black);
    limits(drawing, lathe, &scale);
    drawing.within(group::SPEED, |drawing| {
        drawing.path(filled("M-8 -1.6L# 0L-8 1.6Z", &[r - 7.0]), Look::fill(Paint::Needle));
    });
    drawing.circle((x, y, 4.5), Look::fill(Paint::Black));
}

/// A band along the scale.
fn band(scale: &Scale, from: f64, to: f64, radius: f64) -> String {
    let (from, to) = (scale.degrees(from), scale.degrees(to));
    if to - from < 0.5 {
        return String::new();
    }
    let (a, b) = (polar((DIAL.0, DIAL.1), from, radius), polar((DIAL.0, DIAL.1), to, radius));
    let large = f64::from(u8::from(to - from > 180.0));
    filled("M# #A# # 0 # 1 # #", &[a.0, a.1, radius, radius, large, b.0, b.1])
}

/// Pointers of the limits at the rim: upper and lower limit of the program, limit of the chuck.
fn limits(drawing: &mut Drawing, lathe: &TurningSpindle, scale: &Scale) {
    let p = &lathe.params;
    let centre = (DIAL.0, DIAL.1);
    let pointers = [
        ("chuck-limit", p.chuck_limit, Paint::Black, 3.2),
        ("upper-limit", p.upper_limit, Paint::Needle, 4.0),
        ("lower-limit", p.lower_limit, Paint::Accent, 4.0),
    ];
    for (field, speed, paint, half) in pointers {
        if speed <= 0.0 || speed > scale.end {
            continue;
        }
        let degrees = scale.degrees(speed);
        let tip = polar(centre, degrees, DIAL.2 - 4.0);
        let aside = |hand: f64| polar(centre, degrees + hand * half * 2.0, DIAL.2 + 4.0);
        let (left, right) = (aside(-1.0), aside(1.0));
        let path = filled("M# #L# #L# #Z", &[tip.0, tip.1, left.0, left.1, right.0, right.1]);
        drawing.showing(field, |drawing| {
            drawing.path(path, Look::fill(paint).thin(Paint::Rim, 0.8));
        });
    }
}

fn meter(drawing: &mut Drawing, p: &Params) {
    let (x, y, half) = METER;
    drawing.rect([x - half - 4.0, y - half - 4.0, 2.0 * half + 8.0, 2.0 * half + 8.0, 5.0], Look::fill(Paint::Black));
    drawing.rect([x - half, y - half, 2.0 * half, 2.0 * half, 3.0], Look::fill(Paint::Rim));
    let (from, to) = (polar(PIVOT, -90.0 - METER_SWEEP, METER_RADIUS), polar(PIVOT, -90.0 + METER_SWEEP, METER_RADIUS));
    let mut marks = filled("M# #A# # 0 0 1 # #", &[from.0, from.1, METER_RADIUS, METER_RADIUS, to.0, to.1]);
    for mark in 0..=10 {
        let degrees = -90.0 + METER_SWEEP * (f64::from(mark) / 5.0 - 1.0);
        let long = if mark % 5 == 0 { 9.0 } else { 5.0 };
        marks += &spoke(PIVOT, degrees, METER_RADIUS - long, METER_RADIUS);
    }
    drawing.path(marks, Look::line(Paint::Black, 1.2));
    for part in [-1.0, 0.0, 1.0] {
        let volts = if p.output == Output::Bipolar { 10.0 * part } else { 5.0 * (part + 1.0) };
        let (x, y) = polar(PIVOT, -90.0 + METER_SWEEP * part, METER_RADIUS - 17.0);
        let text = show(volts, 0);
        drawing.text((x, y + 0.36 * LETTERS), Anchor::Middle, &text, Font::Engraved(LETTERS), Paint::Black);
    }
    drawing.within(group::NEEDLE, |drawing| {
        drawing.path(filled("M0 -1.4L# 0L0 1.4Z", &[METER_RADIUS - 2.0]), Look::fill(Paint::Needle));
    });
    let mut cover = String::new();
    fill(
        &mut cover,
        "M# #h#v#q0 3 -3 3h#q-3 0 -3 -3Z",
        &[x - half, y + 24.0, 2.0 * half, half - 27.0, 6.0 - 2.0 * half],
    );
    drawing.path(cover, Look::fill(Paint::DarkShade));
    drawing.circle((PIVOT.0, PIVOT.1, 4.0), Look::fill(Paint::Black));
    drawing.text((x - half + 12.0, y + half - 8.0), Anchor::Middle, "V", Font::Engraved(LETTERS), Paint::Rim);
}

/// Degrees of the needles of speed and voltage.
pub(in super::super) fn needles(lathe: &TurningSpindle, speed: f64, volts: f64) -> (f64, f64) {
    let part = if lathe.params.output == Output::Bipolar { volts / 10.0 } else { volts / 5.0 - 1.0 };
    (Scale::of(lathe).degrees(speed), -90.0 + METER_SWEEP * math::clamp(part, -1.06, 1.06))
}

/// Pivots of the needles of speed and voltage.
pub(super) const PIVOTS: [(f64, f64); 2] = [(DIAL.0, DIAL.1), PIVOT];
