//! Sheets for the machine builder: parameters of spindle and slides.

use super::gears::{delay_before, gear_times};
use super::ladder::ladder;
use super::params::Output;
use super::plant::{SHIFT_SHARE, shift_volts};
use super::resolved::TurningSpindle;
use super::stops::reactions;
use crate::controls::{ParamRole, ParamUnit};
use crate::machines::driven::scaling;
use crate::machines::sheets::{self, AxisUnits, AxisValues, ParamValue, ParamValues, answer, number};
use crate::machines::stops;
use crate::text::{Citation, Grade};
use crate::view::Sheet;

const LADDER: Citation = Citation::new("turning spindle facts, 7", Grade::Inferred);

/// All sheets.
pub(super) fn sheets(lathe: &TurningSpindle) -> Vec<Sheet> {
    let ladder = ladder(lathe);
    let sheet = ladder.sheet("turning.sheet.ladder", LADDER);
    vec![parameters(lathe), ladder.interface(), sheet, stops::sheet(&reactions(lathe))]
}

fn parameters(lathe: &TurningSpindle) -> Sheet {
    let p = &lathe.params;
    let stage = |speed: f64| if speed > 0.0 { number(speed) } else { Vec::new() };
    // Some controls have a gain here, or units of their own.
    let volts = |role: ParamRole, value: f64| {
        let millivolts = lathe.control.param(role).is_some_and(|row| row.unit == ParamUnit::Millivolts);
        if millivolts { number(value) } else { Vec::new() }
    };
    // One value per gear stage.
    let names = ["1", "2", "3", "4"];
    let by_stage = |value: &dyn Fn(f64) -> f64| -> AxisValues {
        let stages = names.into_iter().zip(lathe.params.stages());
        stages.map(|(name, speed)| (name, ParamValue::Number(value(speed)))).collect()
    };
    let (rules, shift) = (lathe.rules(), gear_times(lathe));
    // If the sheet has the ratio of each stage, the voltage represents the speed of the motor.
    let by_motor = lathe.control.param(ParamRole::SpindleRatioMotor).is_some();
    // Where the program sets the lowest speed of the part, the stages keep their whole range.
    let minimum = if rules.low_always { by_stage(&|_| 0.0) } else { number(p.lower_limit) };
    let (shifts, positioning) = (p.has_several_stages(), lathe.positioning());
    let angle = |value: f64| if lathe.positions() { number(value) } else { Vec::new() };
    let mut values: ParamValues = vec![
        (ParamRole::SpindleCount, answer(true)),
        (ParamRole::SpindleConnection, answer(true)),
        (ParamRole::OverrideIsCoded, answer(false)),
        (ParamRole::SpindleOffsetRated, volts(ParamRole::SpindleOffsetRated, p.offset_full)),
        (ParamRole::SpindleOffsetZero, volts(ParamRole::SpindleOffsetZero, p.offset_zero)),
        (ParamRole::SpindleShiftVolts, volts(ParamRole::SpindleShiftVolts, 1000.0 * shift_volts(lathe))),
        (ParamRole::ShiftBySignal, if shifts { answer(true) } else { Vec::new() }),
        (
            ParamRole::SpindleShiftCode,
            if shifts {
                number((f64::from(p.analog(p.stage_1, &lathe.control.analog_output).steps()) * SHIFT_SHARE).round())
            } else {
                Vec::new()
            },
        ),
        (ParamRole::MotorShiftSpeed, if shifts { number(SHIFT_SHARE * p.spindle.top) } else { Vec::new() }),
        (ParamRole::SpindleLimit, number(if by_motor { p.spindle.top } else { p.stage_1 })),
        (ParamRole::SpindleGear(2), stage(p.stage_2)),
        (ParamRole::SpindleGear(3), stage(p.stage_3)),
        (ParamRole::SpindleGear(4), stage(p.stage_4)),
        (ParamRole::SpindleMaximum, number(p.chuck_limit)),
        (ParamRole::SpindleGearMaximum(1), number(p.chuck_limit.min(p.stage_1))),
        (ParamRole::SpindleGearMaximum(2), stage(p.chuck_limit.min(p.stage_2))),
        (ParamRole::SpindleGearMaximum(3), stage(p.chuck_limit.min(p.stage_3))),
        (ParamRole::SpindleGearMaximum(4), stage(p.chuck_limit.min(p.stage_4))),
        (ParamRole::SpindleMinimum, minimum),
        (ParamRole::SpindleUnipolar, answer(p.output == Output::Unipolar)),
        (ParamRole::SpindleRatedVolts, number(100.0)),
        (ParamRole::SpindleRatioSpindle, by_stage(&|speed| speed)),
        (ParamRole::SpindleRatioMotor, by_stage(&|_| p.spindle.top)),
        (ParamRole::SpindleStageMaximum, by_stage(&|speed| speed)),
        (ParamRole::SpindleTolerance, number(rules.tolerance())),
        (ParamRole::SpindleReached, answer(rules.reached.is_some())),
        (ParamRole::SpindleReachedDelay, number(0.0)),
        (ParamRole::PositioningAcceleration, angle(positioning.acceleration)),
        (ParamRole::PositioningSpeed, angle(positioning.speed)),
        (ParamRole::PositioningClockwise, if lathe.positions() { answer(positioning.clockwise) } else { Vec::new() }),
        (ParamRole::SpindleLowerSet, number(p.lower_limit)),
        (ParamRole::SpindleUpperSet, number(p.chuck_limit)),
        (ParamRole::SpindleSurfaceLimit, number(p.upper_limit)),
        (ParamRole::TurnsThroughReset, answer(rules.turns_through_reset)),
        // The guards for a restart are in the first blocks.
        (ParamRole::RewindAtReset, answer(true)),
        (ParamRole::RewindAtEnd, answer(true)),
        (ParamRole::GearShift, answer(shifts)),
        (ParamRole::GearShiftBefore, number(delay_before(lathe))),
        (ParamRole::GearShiftAfter, number(1000.0 * shift.after)),
        (ParamRole::StopLast, answer(rules.stop_last)),
        (ParamRole::VoltsOffAtStop, answer(!rules.volts_stay)),
        (ParamRole::SpindleEncoder, answer(true)),
    ];
    values.extend(p.slides.parameters(lathe.x_counts_diameters()));
    values.extend(sheets::for_macros());
    values.extend(sheets::keeping_variables());
    values.extend(p.encoder.parameters(lathe.control));
    values.extend(scaling::parameters(lathe.control, &lathe.drives()));
    let axes = AxisUnits { in_diameters: if lathe.x_counts_diameters() { &["X"] } else { &[] }, rotary: &[] };
    sheets::parameters(lathe.control, &axes, values)
}
