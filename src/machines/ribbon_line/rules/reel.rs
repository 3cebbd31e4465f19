//! The results about the supply reel with their rules: ribbon on it, and the demand of start and stop on ribbon and brake while its diameter changes.

use crate::drives::inertia::CM2;
use crate::drives::reel;
use crate::machines::form::entry::{at_least, at_most, field_max};
use crate::machines::ribbon_line::contacts::left_at_reel_end;
use crate::machines::ribbon_line::mechanics::{unwinder_load, unwinder_torque};
use crate::machines::ribbon_line::params::{FIELDS, Params};
use crate::machines::ribbon_line::reel::{ramp_acceleration, wound};
use crate::machines::ribbon_line::resolved::RibbonLine;
use crate::machines::verdict::{Judgement, ReadoutRow, Rule, fail, ok, warn};
use crate::math::RPM;
use crate::msg;
use crate::text::{Citation, Grade};
use crate::view::Advice;
use crate::view::Limit::{AtLeast, AtMost};

const FACTS: Citation = Citation::new("sizing facts 2.9", Grade::Inferred);

/// Rows in the order they are shown.
#[rustfmt::skip]
pub(in super::super) const ROWS: &[ReadoutRow<RibbonLine>] = &[
    ReadoutRow {
        id: "reel-length", label: "ribbon.readout.reel-length", unit: "m", decimals: 2,
        formula: "π · (D² - d²) / (4 · thickness)", cite: FACTS, value: |line| wound(&line.p).length(), ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "reel-time", label: "ribbon.readout.reel-time", unit: "s", decimals: 1,
        formula: "length / line speed", cite: FACTS, value: time, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "reel-products", label: "ribbon.readout.reel-products", unit: "", decimals: 0,
        formula: "whole products in the length, less what the stop at the reel’s end takes", cite: FACTS, value: products, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "reel-inertia-full", label: "ribbon.readout.reel-inertia-full", unit: "kg cm²", decimals: 2,
        formula: "m (D² + d²) / 8 + core", cite: FACTS,
        value: |line| wound(&line.p).inertia(wound(&line.p).full) / CM2, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "reel-inertia-empty", label: "ribbon.readout.reel-inertia-empty", unit: "kg cm²", decimals: 2,
        formula: "core", cite: FACTS, value: |line| wound(&line.p).inertia(wound(&line.p).core) / CM2, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "reel-speed-empty", label: "ribbon.readout.reel-speed-empty", unit: "r/min", decimals: 1,
        formula: "line speed / (π · d)", cite: FACTS,
        value: |line| reel::speed(wound(&line.p).core, line.d.line_speed / 60e3) / RPM, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "reel-brake-torque-full", label: "ribbon.readout.reel-brake-torque-full", unit: "Nm", decimals: 3,
        formula: "brake · D / 2", cite: FACTS,
        value: |line| reel::torque(wound(&line.p).full, line.p.unwinding.brake), ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "reel-brake-torque-empty", label: "ribbon.readout.reel-brake-torque-empty", unit: "Nm", decimals: 3,
        formula: "brake · d / 2", cite: FACTS,
        value: |line| reel::torque(wound(&line.p).core, line.p.unwinding.brake), ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "reel-pull", label: "ribbon.readout.reel-pull", unit: "N", decimals: 2,
        formula: "brake + J · α / r over the inverter’s ramp, of the full reel or at the core, whichever is more", cite: FACTS,
        value: |line| line.p.unwinding.brake + ramp_pull(&line.p), ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "reel-brake-needed", label: "ribbon.readout.reel-brake-needed", unit: "N", decimals: 2,
        formula: "J · α / r of the fastest stop, over the ramp or without current, of the full reel or at the core, whichever is more", cite: FACTS,
        value: |line| ramp_pull(&line.p).max(coasting_pull(line)), ..ReadoutRow::BASE
    },
];

/// All rules about the reel.
pub(in super::super) const RULES: &[Rule<RibbonLine>] = &[
    Rule::new("reel-products", lasts, Citation::new("sizing facts 2.9, engineering choice", Grade::Inferred)),
    Rule::new("reel-pull", pull, Citation::new("sizing facts 2.6, engineering choice; rule 12", Grade::Inferred)),
    Rule::new("reel-brake-needed", holds, FACTS),
    Rule::new("reel-brake-torque-full", follows_diameter, FACTS),
];

/// Deceleration in m/s², without sign, of the ribbon at an unwinder without current, with a brake of the reel in N: the torque that brakes
/// its motor over the inertia of all rotating parts, the same at every speed. Source: sizing facts 2.2.
fn coasting_acceleration(p: &Params, brake: f64) -> f64 {
    let torque = unwinder_torque(p, brake) + p.unwinding.motor_brake;
    torque / unwinder_load(p, 0.0).inertia / p.reduction_ratio * p.press_roller_diameter / 2e3
}

/// Seconds in which the line takes the ribbon of a reel; 0 of a reel without ribbon, whatever the speed.
fn time(line: &RibbonLine) -> f64 {
    let length = wound(&line.p).length();
    if length > 0.0 { 60e3 * length / line.d.line_speed } else { 0.0 }
}

/// Whole products that a reel makes until its sensor holds the program.
fn products(line: &RibbonLine) -> f64 {
    ((1e3 * wound(&line.p).length() - left_at_reel_end(line)).max(0.0) / line.d.product_length).floor()
}

/// Pull (N) of the reel over the inverter's ramp, at the diameter with the greatest mass at the web.
fn ramp_pull(p: &Params) -> f64 {
    let reel = wound(p);
    reel.pull(reel.worst(), ramp_acceleration(p))
}

/// Pull (N) of the reel while the unwinder coasts without current: the deceleration is the same from every speed.
fn coasting_pull(line: &RibbonLine) -> f64 {
    let reel = wound(&line.p);
    reel.pull(reel.worst(), coasting_acceleration(&line.p, line.p.unwinding.brake))
}

/// Judges whether a full reel holds at least one product; the advice is the smallest reel that does, if the form accepts it.
fn lasts(line: &RibbonLine) -> Option<Judgement> {
    let (limit, reel) = (AtLeast(1.0), wound(&line.p));
    if limit.holds(products(line)) {
        return ok(limit);
    }
    let needed = (line.d.product_length + left_at_reel_end(line)) / 1e3;
    let advice = Advice::from(msg!("ribbon.reel-ends", length = (1e3 * reel.length(), 0), needed = (1e3 * needed, 0)));
    let set = at_least(FIELDS, "reel-diameter", 1e3 * reel.full_for(needed));
    let fits = set.value <= field_max(FIELDS, "reel-diameter");
    let button = || msg!("advice.set-reel", diameter = set.text.as_str());
    fail(limit, [if fits { advice.setting(button(), [set.clone()]) } else { advice }])
}

/// The pull at the start against the tension limit of the ribbon.
fn pull(line: &RibbonLine) -> Option<Judgement> {
    let (p, most) = (&line.p, line.d.tension_limit);
    let (brake, extra) = (p.unwinding.brake, ramp_pull(p));
    let limit = AtMost(most);
    if limit.holds(brake + extra) {
        return ok(limit);
    }
    let message = msg!("ribbon.reel-pull", tension = (brake + extra, 1), limit = (most, 1), brake = (brake, 1));
    let ramp = p.inverter_ramp * extra / (most - brake);
    let advice = if most > brake && ramp <= field_max(FIELDS, "inverter-ramp") {
        with_ramp(ramp, message.into())
    } else if most > extra {
        let set = at_most(FIELDS, "reel-brake", most - extra);
        Advice::from(message).setting(msg!("advice.set-brake", force = set.text.as_str()), [set])
    } else {
        message.into()
    };
    fail(limit, [advice])
}

/// The torque of the brake on the full reel against the torque that the ribbon bears at the core: beyond it the brake must follow the
/// diameter.
fn follows_diameter(line: &RibbonLine) -> Option<Judgement> {
    let (reel, most, brake) = (wound(&line.p), line.d.tension_limit, line.p.unwinding.brake);
    let limit = AtMost(reel::torque(reel.core, most));
    if limit.holds(reel::torque(reel.full, brake)) {
        return ok(limit);
    }
    let at_core = brake * reel.full / reel.core;
    warn(limit, [msg!("ribbon.brake-at-core", pull = (at_core, 1), brake = (brake, 1), limit = (most, 1)).into()])
}

/// An advice with a longer ramp of the inverter, s.
fn with_ramp(seconds: f64, advice: Advice) -> Advice {
    let set = at_least(FIELDS, "inverter-ramp", seconds);
    advice.setting(msg!("advice.set-ramp", time = set.text.as_str()), [set])
}

/// Whether the brake slows the reel down as fast as the unwinder stops: otherwise the reel runs on and the ribbon goes slack.
fn holds(line: &RibbonLine) -> Option<Judgement> {
    let (p, brake) = (&line.p, line.p.unwinding.brake);
    let (ramp, coasting) = (ramp_pull(p), coasting_pull(line));
    let (limit, needed) = (AtMost(brake), ramp.max(coasting));
    if limit.holds(needed) {
        return ok(limit);
    }
    let runs_on = || Advice::from(msg!("ribbon.reel-runs-on", needed = (needed, 2), brake = (brake, 2)));
    // More brake also stops the unwinder sooner: the pull without current grows linearly with it.
    let reel = wound(p);
    let with = |brake: f64| reel.pull(reel.worst(), coasting_acceleration(p, brake));
    let (without, growth) = (with(0.0), with(1.0) - with(0.0));
    let set = at_least(FIELDS, "reel-brake", ramp.max(without / (1.0 - growth)));
    let mut advice = vec![runs_on().setting(msg!("advice.set-brake", force = set.text.as_str()), [set])];
    let seconds = p.inverter_ramp * ramp / brake;
    if coasting <= brake && seconds <= field_max(FIELDS, "inverter-ramp") {
        advice.push(with_ramp(seconds, runs_on()));
    }
    warn(limit, advice)
}
