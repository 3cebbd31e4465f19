//! The rules of the analog output: voltages that are too low, and a speed above that at full voltage.

use super::stages::with_best_stage;
use crate::drives::Bound;
use crate::drives::analog::FEW_VOLTS;
use crate::machines::turning_spindle::full_output;
use crate::machines::turning_spindle::params::Output;
use crate::machines::turning_spindle::resolved::TurningSpindle;
use crate::machines::verdict::{Judgement, fail, ok, warn};
use crate::msg;
use crate::view::Advice;
use crate::view::Limit::{AtLeast, AtMost};

pub(super) fn few_volts_smallest(lathe: &TurningSpindle) -> Option<Judgement> {
    judge_volts(lathe, lathe.derived.output.volts_smallest)
}

pub(super) fn few_volts_largest(lathe: &TurningSpindle) -> Option<Judgement> {
    judge_volts(lathe, lathe.derived.output.volts_largest)
}

fn judge_volts(lathe: &TurningSpindle, volts: f64) -> Option<Judgement> {
    let limit = if volts < 0.0 { AtMost(-FEW_VOLTS) } else { AtLeast(FEW_VOLTS) };
    let turns = lathe.analog().speed(0.0);
    if volts == 0.0 && lathe.params.output == Output::Unipolar && turns > 0.0 {
        let advice = Advice::from(msg!("turning.turns-at-zero-volts", speed = (turns, 0)));
        return fail(limit, [advice.setting(msg!("advice.no-offset"), [("offset-zero", "0")])]);
    }
    if volts.abs() >= FEW_VOLTS {
        return ok(limit);
    }
    let advice = if lathe.params.stages().nth(1).is_none() {
        msg!("turning.few-volts-alone", volts = (volts, 3)).into()
    } else if lathe.is_best_stage() {
        msg!("turning.few-volts-lowest", volts = (volts, 3)).into()
    } else {
        with_best_stage(lathe, msg!("turning.few-volts", volts = (volts, 3)))
    };
    warn(limit, [advice])
}

/// A speed above that of the full output in the gear stage.
pub(super) fn full_output(lathe: &TurningSpindle) -> Option<Judgement> {
    let TurningSpindle { derived: d, params: p, .. } = lathe;
    if d.speeds.bound == Bound::Output {
        let (full, speed) = ((d.stage.top, 0), (d.speeds.commanded, 0));
        let advice = if lathe.params.has_several_stages() {
            msg!("turning.output-full", stage = f64::from(d.stage.number), full, speed)
        } else {
            msg!("turning.output-full-alone", full, speed)
        };
        return fail(None, [full_output::remedy(lathe, advice)]);
    }
    if d.speeds.bound == Bound::Gear && lathe.surface() && d.stage.surface_top < p.upper_limit {
        let advice = msg!(
            "turning.stage-too-slow",
            stage = f64::from(d.stage.number),
            full = (d.stage.surface_top, 0),
            limit = (p.upper_limit, 0)
        );
        return warn(AtLeast(p.upper_limit), [with_best_stage(lathe, advice)]);
    }
    ok(None)
}
