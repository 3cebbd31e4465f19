//! Findings about entries against the ranges of the control's words and parameters.

use crate::controls::ParamRole;
use crate::machines::sheets;
use crate::machines::turning_spindle::resolved::TurningSpindle;
use crate::msg;
use crate::text::Diagnostic;

/// Findings about values that words of the control cannot have: range, whole numbers, positions of the override knob.
pub(super) fn check_words(lathe: &TurningSpindle, found: &mut Vec<Diagnostic>) {
    let TurningSpindle { params: p, derived: d, .. } = lathe;
    let limits = &lathe.control.limits;
    if p.upper_limit > limits.speed_max {
        let message = msg!("turning.speed-above-range", speed = (p.upper_limit, 0), most = limits.speed_max);
        found.push(Diagnostic::error(message).about("upper-limit"));
    }
    if p.feed > limits.revolution_feed_max {
        let message = msg!("turning.feed-above-range", feed = (p.feed, 3), most = limits.revolution_feed_max);
        found.push(Diagnostic::error(message).about("feed"));
    }
    if p.cutting_speed <= 0.0 {
        found.push(
            Diagnostic::error(msg!("turning.speed-is-zero", speed = lathe.form.cutting_speed)).about("cutting-speed"),
        );
    } else if p.cutting_speed != lathe.form.cutting_speed {
        found.push(Diagnostic::warning(msg!("turning.whole-speed", speed = p.cutting_speed)).about("cutting-speed"));
    }
    if !lathe.surface() && d.speeds.asked <= 0.0 && p.cutting_speed > 0.0 {
        let message = msg!("turning.fixed-is-zero", speed = (p.cutting_speed, 2), stock = (p.stock_diameter, 3));
        found.push(Diagnostic::error(message).about("cutting-speed"));
    }
    if p.override_percent != lathe.form.override_percent {
        found.push(Diagnostic::warning(msg!("turning.knob-steps", percent = p.override_percent)).about("override"));
    }
}

/// Errors about parameters out of the control's range: those of the analog output and of the parameter sheet.
pub(super) fn check_parameters(lathe: &TurningSpindle, found: &mut Vec<Diagnostic>) {
    let TurningSpindle { params: p, .. } = lathe;
    let rules = &lathe.control.spindle;
    let mut check = |field, value, unit, range| found.extend(sheets::beyond_range(field, value, unit, range));
    let offsets = |at: usize| rules.offsets.and_then(|ranges| ranges.get(at).copied());
    check("offset-zero", p.offset_zero, "mV", offsets(0));
    check("offset-full", p.offset_full, "mV", offsets(1));
    for (field, speed) in ["stage-1", "stage-2", "stage-3", "stage-4"].into_iter().zip(p.stages()) {
        check(field, speed, "r/min", rules.stage_speeds);
    }
    let range = |role: ParamRole| lathe.control.param(role).and_then(|row| row.range);
    check("time-constant", p.slides.time_constant, "ms", range(ParamRole::AxisTimeConstant));
    check("encoder-lines", p.encoder.lines, "", range(ParamRole::SpindleEncoderLines));
}
