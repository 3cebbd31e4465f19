//! The rules of the gear stages: meshing time, missing stages, and the stage that an advice offers.

use crate::machines::form::entry::at_least;
use crate::machines::turning_spindle::derive::Derived;
use crate::machines::turning_spindle::gears::gear_times;
use crate::machines::turning_spindle::params::{FIELDS, Gear, Params};
use crate::machines::turning_spindle::resolved::TurningSpindle;
use crate::machines::verdict::{Judgement, fail};
use crate::msg;
use crate::text::{Diagnostic, Message};
use crate::view::Advice;

/// Judges the meshing time of a gear against the time limit of the PLC.
pub(super) fn gear_time(lathe: &TurningSpindle) -> Option<Judgement> {
    let TurningSpindle { params: p, .. } = lathe;
    let shift = gear_times(lathe);
    let patience = shift.patience.filter(|&patience| patience < shift.meshing)?;
    let set = at_least(FIELDS, "gear-patience", shift.meshing);
    let advice = Advice::from(msg!(
        "turning.gear-too-late",
        time = (shift.meshing, 2),
        wait = (patience, 2),
        shorter = (2.0 * patience, 2),
        present = (p.gear_time, 2)
    ));
    fail(None, [advice.setting(msg!("advice.set-gear-patience", time = set.text.as_str()), [set])])
}

/// An advice to let the program choose the gear stage instead of the form.
pub(super) fn with_best_stage(lathe: &TurningSpindle, message: Message) -> Advice {
    let advice = Advice::from(message);
    match lathe.params.gear {
        Gear::Best => advice,
        _ => advice.setting(msg!("advice.best-stage"), [("gear", "best".to_owned())]),
    }
}

/// A gear stage with sufficient torque at the same speed.
pub(super) fn stronger_stage(lathe: &TurningSpindle) -> Option<u8> {
    let output = &lathe.control.analog_output;
    let gears = [Gear::First, Gear::Second, Gear::Third, Gear::Fourth];
    let mut fitted = (1..).zip(lathe.params.stages()).zip(gears);
    let found = fitted.find(|(_, gear)| {
        let p = Params { gear: *gear, ..lathe.params.clone() };
        let d = Derived::new(&p, output, &lathe.dialect.spindle());
        let as_fast = |now: f64, before: f64| (now - before).abs() <= 1e-9 * before.abs();
        d.load.torque <= d.load.torque_available
            && as_fast(d.speeds.largest_whole, lathe.derived.speeds.largest_whole)
            && as_fast(d.speeds.smallest, lathe.derived.speeds.smallest)
    });
    found.map(|((number, _), _)| number)
}

/// A chosen gear stage that is not fitted.
pub(super) fn missing_stage(p: &Params) -> Option<Diagnostic> {
    let chosen = p.gear as u8;
    let message = msg!("turning.no-such-stage", stage = f64::from(chosen));
    (p.stages().count() < usize::from(chosen)).then(|| Diagnostic::warning(message).about("gear"))
}

/// A gear stage behind one that is not fitted: the program would never engage it.
pub(super) fn stage_behind_gap(p: &Params) -> Option<Diagnostic> {
    let stages = [("stage-2", p.stage_2), ("stage-3", p.stage_3), ("stage-4", p.stage_4)];
    let fitted = stages.iter().skip_while(|(_, speed)| *speed > 0.0).find(|(_, speed)| *speed > 0.0);
    fitted.map(|(field, _)| Diagnostic::error(msg!("turning.stage-behind-gap")).about(field))
}
