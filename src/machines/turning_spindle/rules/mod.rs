//! The rules of the turning spindle, as rows: result, limit, remedy.

mod bending;
mod cut;
mod knob_positions;
mod output;
mod overload;
mod power;
mod remedies;
mod slides;
mod speed;
mod stages;
mod time;
mod torque;
mod words;

use super::cooling;
use super::gears::judge_delay;
use super::keyway;
use super::program;
use super::resolved::TurningSpindle;
use super::run_up;
use super::travel;
use crate::machines::verdict::Rule;
use crate::msg;
use crate::text::{Citation, Diagnostic, Grade};

/// All rules that judge a result.
pub(super) const RULES: &[Rule<TurningSpindle>] = &[
    Rule::new("x-scaling-drift", slides::scaling_x, Citation::new("ribbon line facts, 10", Grade::Inferred)),
    Rule::new("z-scaling-drift", slides::scaling_z, Citation::new("ribbon line facts, 10", Grade::Inferred)),
    Rule::new("speed-smallest", speed::top_speed, Citation::new("highest speed of the chuck", Grade::Manual)),
    Rule::new(
        "speed-greatest",
        speed::passes_limit,
        Citation::new("turning spindle facts 2: the upper limit wins", Grade::Inferred),
    ),
    Rule::new(
        "limit-diameter",
        speed::limit_diameter,
        Citation::new("turning spindle facts 2: the upper limit wins", Grade::Inferred),
    ),
    Rule::new("volts-smallest", output::few_volts_smallest, Citation::new("engineering choice", Grade::Inferred)),
    Rule::new("volts-largest", output::few_volts_largest, Citation::new("engineering choice", Grade::Inferred)),
    Rule::new("stage-speed", output::full_output, Citation::new("speed at 10 V of the gear stage", Grade::Manual)),
    Rule::new("stage", stages::gear_time, Citation::new("ladder of the control, A1.0", Grade::Sister)),
    Rule::new("gear-delay", judge_delay, Citation::new("turning spindle facts, 2", Grade::Inferred)),
    Rule::new("feed-top", slides::clamped_feed, Citation::new("cutting feed clamp, a parameter", Grade::Sister)),
    Rule::new(
        "acceleration-needed",
        speed::acceleration,
        Citation::new("derivative of n = 1000 v / (π d)", Grade::Inferred),
    ),
    Rule::new("shortest-ramp", run_up::judge, Citation::new("turning spindle facts, 5", Grade::Inferred)),
    Rule::new(
        "positioning-torque",
        run_up::judge_positioning,
        Citation::new("turning spindle facts, 5", Grade::Inferred),
    ),
    Rule::new("driven-feed", keyway::judge_feed, Citation::new("engineering choice", Grade::Inferred)),
    Rule::new("x-travel", travel::judge_x, Citation::new("travel of the slide", Grade::Manual)),
    Rule::new("z-travel", travel::judge_z, Citation::new("travel of the slide", Grade::Manual)),
    Rule::new("cutting-time", time::block_time, Citation::new("what a block costs, a parameter", Grade::Open)),
    Rule::new("power", power::power, Citation::new("data sheet of the motor", Grade::Manual)),
    Rule::new("torque", torque::torque, Citation::new("data sheet of the motor; curve by base speed", Grade::Inferred)),
    Rule::new("torque", cooling::judge, Citation::new("sizing facts 2.10", Grade::Open)),
    Rule::new("bending", bending::bends, Citation::new("polygon turning facts 3.13", Grade::Open)),
    Rule::new("peak-torque", torque::peak_torque, Citation::new("turning spindle facts, 4", Grade::Inferred)),
];

/// Errors that refuse the export, and notes for the operator.
pub(super) fn findings(lathe: &TurningSpindle) -> Vec<Diagnostic> {
    let p = &lathe.params;
    let mut found = Vec::new();
    cut::check_diameters(p, &mut found);
    travel::findings(lathe, &mut found);
    words::check_words(lathe, &mut found);
    words::check_parameters(lathe, &mut found);
    if lathe.form.speed_mode != p.speed_mode {
        found.push(Diagnostic::info(msg!("turning.no-surface-speed", control = lathe.control.name)));
    }
    if lathe.form.keyway && !lathe.positions() {
        found.push(Diagnostic::info(msg!("turning.no-keyway", control = lathe.control.name)));
    }
    found.extend(p.encoder.finding(lathe.control));
    keyway::findings(lathe, &mut found);
    found.extend(stages::missing_stage(p));
    found.extend(stages::stage_behind_gap(p));
    speed::check_speed_limits(lathe, &mut found);
    if !lathe.control.macros.common_kept {
        found.push(Diagnostic::info(msg!("form.values-are-lost", program = program::SETUP)));
    }
    found
}
