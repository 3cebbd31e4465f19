//! Sheets for the machine builder: parameters, registers between PLC and control, and the ladder of figure 1.

use super::axes::LineAxis;
use super::ladder::ladder;
use super::params::{AxisParams, PULL_LETTER, PathMode, PrintAxis};
use super::resolved::RibbonLine;
use super::stops::reactions;
use crate::controls::{Code, ParamRole};
use crate::drives::block::ramp;
use crate::machines::driven::scaling;
use crate::machines::sheets::{self, AxisUnits, ParamValue, ParamValues, ServoSettings, answer, number};
use crate::machines::stops;
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
    // Axes whose coordinates roll over are rotary axes of the control, in mm too.
    let endless = line.rolls_over();
    let rolling: Vec<&str> =
        [(PULL_LETTER, endless.pull), (print, endless.print)].into_iter().filter_map(rolls).collect();
    let each = |value: fn() -> ParamValue| rolling.iter().map(|axis| (*axis, value())).collect::<Vec<_>>();
    let mut turning: Vec<_> = each(|| ParamValue::Answer(true));
    if !endless.print && p.print_axis != PrintAxis::Z {
        turning.push((print, ParamValue::Answer(false)));
    }
    let stops = p.path_mode == PathMode::ExactStop;
    let rules = line.dialect.spindle();
    let mut values = vec![
        (ParamRole::SpindleCount, answer(true)),
        (ParamRole::SpindleConnection, answer(true)),
        (ParamRole::OverrideIsCoded, answer(false)),
        (ParamRole::SpindleLimit, number(p.speed_at_10v)),
        (ParamRole::SpindleUnipolar, answer(true)),
        (ParamRole::SpindleRatedVolts, number(100.0)),
        (ParamRole::SpindleMaximum, number(p.top_speed())),
        (ParamRole::SpindleGearMaximum(1), number(p.top_speed().min(p.speed_at_10v))),
        (ParamRole::SpindleStageMaximum, vec![("1", ParamValue::Number(p.top_speed()))]),
        (ParamRole::SpindleMinimum, number(0.0)),
        (ParamRole::SpindleTolerance, number(rules.tolerance())),
        (ParamRole::SpindleReached, answer(rules.reached.is_some())),
        (ParamRole::SpindleReachedDelay, number(0.0)),
        (ParamRole::SpindleEncoder, answer(p.spindle_encoder)),
        // The guards of a restart are in the first blocks.
        (ParamRole::RewindAtReset, answer(true)),
        (ParamRole::RewindAtEnd, answer(true)),
        (ParamRole::AxisRotary, turning),
        (ParamRole::AxisRollOver, each(|| ParamValue::Answer(true))),
        (ParamRole::AxisRollDisplay, each(|| ParamValue::Answer(true))),
        (ParamRole::AxisShortWay, each(|| ParamValue::Answer(false))),
        (ParamRole::AxisTurn, each(|| ParamValue::Number(360.0))),
        (ParamRole::AxisSoftLimits, [PULL_LETTER, print].map(|axis| (axis, ParamValue::Answer(false))).into()),
        // Without a code for the exact stop the parameter alone decides; with one it says how the stop is checked.
        (ParamRole::ExactStopCheck, answer(stops || line.control.can(Code::Cutting))),
        (ParamRole::FeedOneDigit, answer(false)),
    ];
    values.extend(servo_axes(line));
    values.extend(sheets::for_macros());
    values.extend(sheets::keeping_variables());
    if p.spindle_encoder {
        values.extend(p.encoder.parameters(line.control));
    }
    values.extend(scaling::parameters(line.control, &line.drives().both()));
    let axes = AxisUnits { in_diameters: if line.x_counts_diameters() { &["X"] } else { &[] }, rotary: &rolling };
    sheets::parameters(line.control, &axes, values)
}

/// Parameters of both servo axes.
fn servo_axes(line: &RibbonLine) -> ParamValues<'static> {
    let p = &line.params;
    // The ramps of the results are those of the line at its fastest. An acceleration that reaches rapid traverse as soon would ask the
    // multiple torque of them.
    let feeds = line.fast.feeds.of_axes();
    let settings = |axis: LineAxis| {
        let AxisParams { rapid, clamp, time_constant, position_gain, .. } = p.axes[axis];
        let acceleration = feeds[axis] / 60.0 / ramp(time_constant / 1e3, position_gain);
        ServoSettings { axis: line.letter(axis), rapid, clamp, time_constant, position_gain, acceleration }
    };
    sheets::servo_axes(&[LineAxis::Pull, LineAxis::Print].map(settings), line.x_counts_diameters(), p.in_position)
}

/// The axis, if it rolls over.
fn rolls((axis, rolls): (&str, bool)) -> Option<&str> {
    rolls.then_some(axis)
}

const CITE: Citation = Citation::new(
    "ribbon dot-printing paper, figure 1: R148 to R74; instructions by the usual list of the maker",
    Grade::Inferred,
);
