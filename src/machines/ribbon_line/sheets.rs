//! Sheets for the machine builder: parameters, registers between PLC and control, and the ladder of figure 1.

use super::axes::PerAxis;
use super::ladder::ladder;
use super::params::{AxisParams, PathMode, PrintAxis};
use super::resolved::RibbonLine;
use super::stops::reactions;
use crate::controls::{Code, ParamRole};
use crate::drives::block::ramp;
use crate::machines::driven::scaling;
use crate::machines::sheets::{self, AxisUnits, ParamValue};
use crate::machines::stops;
use crate::math;
use crate::text::{Citation, Grade};
use crate::view::Sheet;

/// All sheets.
pub(super) fn sheets(line: &RibbonLine) -> Vec<Sheet> {
    let ladder = ladder(line);
    let sheet = ladder.sheet("ribbon.sheet.ladder", CITE);
    vec![parameters(line), ladder.interface(), sheet, stops::sheet(&reactions(line))]
}

/// Parameters with their values for this project.
fn parameters(line: &RibbonLine) -> Sheet {
    let p = &line.params;
    let print = p.print_axis.letter();
    let number = |value: f64| ParamValue::Number(value);
    let per_axis = |value: &dyn Fn(&AxisParams) -> f64| {
        let values = p.axes.map(value);
        vec![("X", number(values.pull)), (print, number(values.print))]
    };
    let one = |setting: ParamValue| vec![("", setting)];
    let both = |on: bool| vec![("X", ParamValue::Answer(on)), (print, ParamValue::Answer(on))];
    // Axes whose coordinates roll over are rotary axes of the control, in mm too.
    let endless = line.rolls_over();
    let rolling: Vec<&str> = [("X", endless.pull), (print, endless.print)].into_iter().filter_map(rolls).collect();
    let each = |value: fn() -> ParamValue| rolling.iter().map(|axis| (*axis, value())).collect::<Vec<_>>();
    let mut turning: Vec<_> = each(|| ParamValue::Answer(true));
    if !endless.print && p.print_axis != PrintAxis::Z {
        turning.push((print, ParamValue::Answer(false)));
    }
    let yes = |on: bool| one(ParamValue::Answer(on));
    let stops = p.path_mode == PathMode::ExactStop;
    // The ramps of the results are those of the line at its fastest. An acceleration that reaches rapid traverse as soon would ask the
    // multiple torque of them.
    let feeds = line.fast.feeds.of_axes();
    let acceleration = PerAxis::of(|axis| {
        let AxisParams { time_constant, position_gain, .. } = p.axes[axis];
        feeds[axis] / 60.0 / ramp(time_constant / 1e3, position_gain)
    });
    let rules = line.dialect.spindle();
    let mut values = vec![
        (ParamRole::SpindleCount, yes(true)),
        (ParamRole::SpindleConnection, yes(true)),
        (ParamRole::OverrideIsCoded, yes(false)),
        (ParamRole::SpindleLimit, one(number(p.speed_at_10v))),
        (ParamRole::SpindleUnipolar, yes(true)),
        (ParamRole::SpindleRatedVolts, one(number(100.0))),
        (ParamRole::SpindleMaximum, one(number(p.top_speed()))),
        (ParamRole::SpindleGearMaximum(1), one(number(p.top_speed().min(p.speed_at_10v)))),
        (ParamRole::SpindleStageMaximum, vec![("1", number(p.top_speed()))]),
        (ParamRole::SpindleMinimum, one(number(0.0))),
        (ParamRole::SpindleTolerance, one(number(rules.tolerance()))),
        (ParamRole::SpindleReached, yes(rules.reached.is_some())),
        (ParamRole::SpindleReachedDelay, one(number(0.0))),
        (ParamRole::SpindleEncoder, yes(p.spindle_encoder)),
        // The guards of a restart are in the first blocks.
        (ParamRole::RewindAtReset, yes(true)),
        (ParamRole::RewindAtEnd, yes(true)),
        (ParamRole::AxisDiameter, vec![("X", ParamValue::Answer(line.pull_words() == 2))]),
        (ParamRole::AxisRotary, turning),
        (ParamRole::AxisRollOver, each(|| ParamValue::Answer(true))),
        (ParamRole::AxisRollDisplay, each(|| ParamValue::Answer(true))),
        (ParamRole::AxisShortWay, each(|| ParamValue::Answer(false))),
        (ParamRole::AxisTurn, each(|| ParamValue::Number(360.0))),
        (ParamRole::AxisRapid, per_axis(&|axis| axis.rapid)),
        (ParamRole::AxisClamp, per_axis(&|axis| axis.clamp)),
        // Above what both axes reach together: each of them is clamped by itself.
        (
            ParamRole::PathClamp,
            vec![("", ParamValue::Number(math::hypot(p.axes.pull.clamp, p.axes.print.clamp).ceil()))],
        ),
        (ParamRole::AxisAcceleration, both(true)),
        (ParamRole::RapidTimeConstant, per_axis(&|axis| axis.time_constant)),
        (ParamRole::AxisTimeConstant, per_axis(&|axis| axis.time_constant)),
        (
            ParamRole::AxisGreatestAcceleration,
            vec![("X", number(acceleration.pull)), (print, number(acceleration.print))],
        ),
        (ParamRole::AxisPositionGain, per_axis(&|axis| axis.position_gain)),
        (ParamRole::AxisInPosition, per_axis(&|_| p.in_position)),
        (ParamRole::AxisSoftLimits, both(false)),
        // Without a code for the exact stop the parameter alone decides; with one it says how the stop is checked.
        (ParamRole::ExactStopCheck, yes(stops || line.control.can(Code::Cutting))),
        (ParamRole::CommandUnit, yes(true)),
        (ParamRole::FeedOneDigit, yes(false)),
        (ParamRole::VariablesAtReset, yes(false)),
        (ParamRole::VariablesAtPowerOn, yes(false)),
        (ParamRole::EditLock, yes(false)),
        (ParamRole::MacroSingle, yes(false)),
    ];
    if p.spindle_encoder {
        values.extend(p.encoder.parameters(line.control));
    }
    values.extend(scaling::parameters(line.control, &line.drives().both()));
    let axes = AxisUnits { in_diameters: if line.pull_words() == 2 { &["X"] } else { &[] }, rotary: &rolling };
    sheets::parameters(line.control, &axes, values)
}

/// The axis, if it rolls over.
fn rolls((axis, rolls): (&str, bool)) -> Option<&str> {
    rolls.then_some(axis)
}

const CITE: Citation = Citation::new(
    "ribbon dot-printing paper, figure 1: R148 to R74; instructions by the usual list of the maker",
    Grade::Inferred,
);
