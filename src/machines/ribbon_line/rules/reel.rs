//! The rules of the supply reel: ribbon on it, its pull at a start, its brake at a stop.

use crate::drives::reel;
use crate::machines::form::entry::{at_least, at_most, field_max};
use crate::machines::ribbon_line::params::FIELDS;
use crate::machines::ribbon_line::reel::wound;
use crate::machines::ribbon_line::reel_demand::{coasting_acceleration, coasting_pull, needed, products, ramp_pull};
use crate::machines::ribbon_line::resolved::RibbonLine;
use crate::machines::verdict::{Judgement, Rule, fail, ok, warn};
use crate::msg;
use crate::text::{Citation, Grade};
use crate::view::Advice;
use crate::view::Limit::{AtLeast, AtMost};

const FACTS: Citation = Citation::new("sizing facts 2.9", Grade::Inferred);

/// All rules about the reel.
pub(in crate::machines::ribbon_line) const RULES: &[Rule<RibbonLine>] = &[
    Rule::new("reel-products", lasts, Citation::new("sizing facts 2.9, engineering choice", Grade::Inferred)),
    Rule::new("reel-pull", pull, Citation::new("sizing facts 2.6, engineering choice; rule 12", Grade::Inferred)),
    Rule::new("reel-brake-needed", holds, FACTS),
    Rule::new("reel-brake-torque-full", follows_diameter, FACTS),
];

/// Judges whether a full reel holds at least one product; the advice is the smallest reel that does, if the form accepts it.
fn lasts(line: &RibbonLine) -> Option<Judgement> {
    let (limit, reel) = (AtLeast(1.0), wound(&line.params));
    if limit.holds(products(line)) {
        return ok(limit);
    }
    let needed = needed(line) / 1e3;
    let advice = Advice::from(msg!("ribbon.reel-ends", length = (1e3 * reel.length(), 0), needed = (1e3 * needed, 0)));
    let set = at_least(FIELDS, "reel-diameter", 1e3 * reel.full_for(needed));
    let fits = set.value <= field_max(FIELDS, "reel-diameter");
    let button = || msg!("advice.set-reel", diameter = set.text.as_str());
    fail(limit, [if fits { advice.setting(button(), [set.clone()]) } else { advice }])
}

/// The pull at the start against the tension limit of the ribbon.
fn pull(line: &RibbonLine) -> Option<Judgement> {
    let (p, most) = (&line.params, line.derived.tension.allowed);
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

/// Judges the torque of the brake on the full reel against the torque that the ribbon can bear at the core: with a
/// greater one the brake must follow the diameter.
fn follows_diameter(line: &RibbonLine) -> Option<Judgement> {
    let (reel, most, brake) = (wound(&line.params), line.derived.tension.allowed, line.params.unwinding.brake);
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

/// Judges whether the brake slows the reel down as fast as the unwinder stops; otherwise the reel overruns and the
/// ribbon goes slack.
fn holds(line: &RibbonLine) -> Option<Judgement> {
    let (p, brake) = (&line.params, line.params.unwinding.brake);
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
