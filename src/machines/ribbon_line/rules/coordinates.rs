//! Rules about coordinates that only grow: the range of the control, axes that roll over, scaling.

use crate::controls::dialect::CoordinateFrame;
use crate::controls::{Code, ParamRole};
use crate::machines::form::entry::at_most;
use crate::machines::ribbon_line::axes::{LineAxis, PerAxis};
use crate::machines::ribbon_line::params::{Endless, FIELDS, PULL_LETTER, PrintAxis};
use crate::machines::ribbon_line::program;
use crate::machines::ribbon_line::resolved::RibbonLine;
use crate::machines::verdict::{Judgement, fail, ok, warn};
use crate::math::PI;
use crate::msg;
use crate::text::Diagnostic;
use crate::text::listed;
use crate::view::Limit::AtMost;
use crate::view::{Advice, Verdict};

/// A block with a word beyond the coordinate range of the control.
pub(in crate::machines::ribbon_line) fn long_blocks(line: &RibbonLine) -> Option<Diagnostic> {
    let RibbonLine { params: p, derived: d, .. } = line;
    let limits = &line.control.limits;
    let pitches = p.block_pitches().min(p.count());
    let pull = p.pitch * line.x_per_mm();
    let (axis, pitch) =
        if d.feeds.y_stroke > pull { (line.print_letter(), d.feeds.y_stroke) } else { (PULL_LETTER, pull) };
    let max = limits.coordinate_max;
    (pitches * pitch > max).then(|| {
        Diagnostic::error(msg!("ribbon.block-too-long", axis, travel = (pitches * pitch, 3), most = max))
            .about("pitches-per-block")
            .hint(msg!("ribbon.fewer-pitches", count = ((max / pitch).floor(), 0)))
    })
}

/// Places of an axis that every machine has in front of it: pull axis and one more.
const ALWAYS_FITTED: usize = 2;

/// A note about the variable of the print roller's position, whose number counts the axes in front of it. Not every machine has them all.
pub(in crate::machines::ribbon_line) fn counted_axis(line: &RibbonLine) -> Option<Diagnostic> {
    let variable = program::position_variable(line).filter(|_| line.print() > ALWAYS_FITTED)?;
    let letters: Vec<_> = line.control.axes[..=line.print()].iter().map(|axis| axis.letter.to_string()).collect();
    let order = listed(letters.iter().map(String::as_str));
    let message = msg!("ribbon.axis-counted", axis = line.print_letter(), variable = format!("#{variable}"), order);
    Some(Diagnostic::info(message).about("print-axis"))
}

/// The axis whose coordinate leaves the control's range first, and its travel per pitch in units of its words; none if
/// the coordinates of both axes roll over.
fn farthest(line: &RibbonLine) -> Option<(&'static str, f64)> {
    let endless = line.rolls_over();
    let pull = (PULL_LETTER, line.params.pitch * line.x_per_mm());
    let print = (line.print_letter(), line.derived.feeds.y_stroke);
    match (endless.pull, endless.print) {
        (true, true) => None,
        (true, false) => Some(print),
        (false, true) => Some(pull),
        (false, false) => Some(if print.1 < pull.1 { pull } else { print }),
    }
}

/// Seconds of running from zero to the end of the control's range: `range / (travel per pitch · pitches per second)`; 0 at standstill.
pub(in crate::machines::ribbon_line) fn range_time(line: &RibbonLine) -> f64 {
    let speed = farthest(line).map_or(0.0, |(_, travel)| travel * line.derived.timing.dots_per_second);
    match speed > 0.0 {
        true => line.control.limits.coordinate_max / speed,
        false if line.derived.timing.dots_per_second > 0.0 => f64::INFINITY,
        false => 0.0,
    }
}

/// Numbers of the parameters that let the coordinates of an axis roll over.
fn roll_parameters(line: &RibbonLine) -> String {
    let roles = [ParamRole::AxisRotary, ParamRole::AxisRollOver, ParamRole::AxisTurn];
    listed(roles.into_iter().filter_map(|role| line.control.param(role)).map(|row| row.number))
}

/// Remedies of a line whose axes leave the range: parameters, or the program where the control has no such parameters.
fn endless_axes(line: &RibbonLine, product_fits: bool) -> Vec<Advice> {
    if line.rolls_over().pull {
        // The print roller is left, and counts millimetres.
        let advice = Advice::from(msg!("ribbon.range-degrees"));
        let set = [("y-unit", "degrees")];
        return if line.params.print_axis == PrintAxis::Y {
            vec![advice.setting(msg!("advice.degrees"), set)]
        } else {
            vec![]
        };
    }
    let needs_degrees = line.reads_positions() && !line.degrees();
    let can_roll = line.control.param(ParamRole::AxisRollOver).is_some()
        && (!needs_degrees || line.params.print_axis == PrintAxis::Y);
    let shifts = product_fits && line.control.can(Code::SetCoordinates);
    if can_roll && line.x_counts_diameters() && !shifts {
        return vec![msg!("ribbon.range-roll-over-in-radius", parameters = roll_parameters(line)).into()];
    }
    if can_roll && !line.x_counts_diameters() {
        let advice = Advice::from(msg!("ribbon.range-roll-over", parameters = roll_parameters(line)));
        let [rolls, in_degrees] = [("endless", "roll-over".to_owned()), ("y-unit", "degrees".to_owned())];
        return vec![if needs_degrees {
            advice.setting(msg!("advice.roll-over-in-degrees"), [rolls, in_degrees])
        } else {
            advice.setting(msg!("advice.roll-over"), [rolls])
        }];
    }
    if shifts && line.params.endless != Endless::Shift {
        return vec![Advice::from(msg!("ribbon.range-shift")).setting(msg!("advice.shift"), [("endless", "shift")])];
    }
    Vec::new()
}

/// Judges the range of the coordinates, because both axes run in one direction only and the control stops with an alarm
/// at its end. A product beyond the range fails; otherwise the operator has to reset the coordinates in time.
pub(in crate::machines::ribbon_line) fn range(line: &RibbonLine) -> Option<Judgement> {
    let max = line.control.limits.coordinate_max;
    let Some((axis, travel)) = farthest(line) else {
        let advice = msg!("ribbon.range-endless", parameters = roll_parameters(line), limit = max);
        return Some(Judgement { verdict: Verdict::Ok, limit: None, advice: vec![advice.into()] });
    };
    let with = |advice: Advice, fits: bool| [vec![advice], endless_axes(line, fits)].concat();
    let products = (max / (travel * line.params.count())).floor();
    if products < 1.0 {
        let pitches = (max / travel).floor();
        let advice = Advice::from(msg!("ribbon.range-product", axis, limit = max, count = (pitches, 0)));
        let set = if line.params.is_length(line.control) {
            at_most(FIELDS, "product-length", pitches * line.params.pitch)
        } else {
            at_most(FIELDS, "pitch-count", pitches)
        };
        let button = msg!("advice.shorter-product", count = pitches);
        return fail(None, with(if pitches >= 1.0 { advice.setting(button, [set]) } else { advice }, false));
    }
    let seconds = (range_time(line), 0);
    if line.params.endless == Endless::Shift && line.dialect.running.range != Some(CoordinateFrame::Machine) {
        let advice = msg!("ribbon.range-shifted", axis, limit = max, time = seconds, products = (products, 0));
        return Some(Judgement { verdict: Verdict::None, limit: None, advice: vec![advice.into()] });
    }
    warn(
        None,
        with(msg!("ribbon.range-open", axis, limit = max, time = seconds, products = (products, 0)).into(), true),
    )
}

/// Drift (mm/h or °/h) of the pull axis and of the print roller against their motors, by the whole numbers of the scaling parameters; none
/// if the control has no such numbers.
pub(in crate::machines::ribbon_line) fn scaling_drifts(line: &RibbonLine) -> PerAxis<Option<f64>> {
    let (drives, feeds) = (line.drives(), line.derived.feeds.of_axes());
    let drift = |axis: LineAxis| Some(drives[axis].error(line.control)? * feeds[axis] * 60.0);
    PerAxis::of(drift)
}

/// Judges the scaling: over a product the dots may drift by the tolerance of a dot.
pub(in crate::machines::ribbon_line) fn scaling(line: &RibbonLine, axis: LineAxis) -> Option<Judgement> {
    let RibbonLine { params: p, derived: d, .. } = line;
    line.control.scaling?;
    let (letter, is_print) = (line.letter(axis), axis == LineAxis::Print);
    let Some(drift) = scaling_drifts(line)[axis] else {
        return fail(None, [msg!("scaling.no-ratio", axis = letter).into()]);
    };
    let per_turn = if is_print && line.degrees() { 360.0 / (PI * p.print_roller_diameter) } else { 1.0 };
    let limit = p.dot_tolerance * per_turn * 3600.0 / d.product.time;
    if drift.abs() <= limit {
        return ok(AtMost(limit));
    }
    let unit = if is_print && line.degrees() { "°/h" } else { "mm/h" };
    let (drift, most) = ((drift, 4), (limit, 4));
    let mut advice = Advice::from(msg!("ribbon.scaling-drifts", axis = letter, drift, limit = most, unit));
    if is_print && !line.degrees() && p.print_axis == PrintAxis::Y {
        advice = advice.setting(msg!("advice.degrees"), [("y-unit", "degrees")]);
    }
    warn(AtMost(limit), [advice])
}
