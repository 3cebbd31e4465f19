//! The line on a control: which axes, words and inputs it has there, and the form without the choices that the control lacks.

use super::params::{FeedForm, OverrideForm, PULL, Params, PathMode, PrintAxis, YUnit};
use crate::controls::vars::Width;
use crate::controls::{Control, Dialect, VarKind};
use crate::machines::ControlContext;

/// The variable in which the operator types the override where the PLC cannot hand it over.
const TYPED: u32 = 103;

/// The form on a control.
pub(super) struct Resolved<'a> {
    /// The form as it was filled in.
    pub(super) form: &'a Params,
    /// The form, with what the control has in place of what it lacks.
    pub(super) p: Params,
    pub(super) control: &'a Control,
    pub(super) dialect: Dialect,
}

impl<'a> Resolved<'a> {
    pub(super) fn new(form: &'a Params, on: ControlContext<'a>) -> Resolved<'a> {
        let (control, dialect) = (on.control, on.dialect());
        let mut p = form.clone();
        p.print_axis = form.print_axis_on(control);
        match p.print_axis {
            PrintAxis::Y => {}
            PrintAxis::C => p.y_unit = YUnit::Degrees,
            PrintAxis::Z => p.y_unit = YUnit::Millimetres,
        }
        if !form.tells_final_speed(control) {
            p.override_form = OverrideForm::Percent;
        }
        if !form.stops_exactly(control) {
            p.path_mode = PathMode::Continuous;
        }
        Resolved { form, p, control, dialect }
    }

    /// Index of the axis that pulls, in the control's order.
    pub(super) fn pull(&self) -> usize {
        self.control.axis(PULL).unwrap_or(0)
    }

    /// Index of the print roller's axis.
    pub(super) fn print(&self) -> usize {
        self.control.axis(self.p.print_axis.letter()).unwrap_or(0)
    }

    /// What words of the pull axis count for each millimetre of ribbon.
    pub(super) fn pull_words(&self) -> u32 {
        if self.dialect.counts_diameters(self.pull()) { 2 } else { 1 }
    }

    /// Degrees instead of millimetres.
    pub(super) fn degrees(&self) -> bool {
        self.p.y_unit == YUnit::Degrees
    }

    /// F counts per revolution of the unwinder.
    pub(super) fn in_step(&self) -> bool {
        self.p.feed_form == FeedForm::PerRevolution
    }

    /// The largest F: in mm/min the project's limit, and never more than the control reads.
    pub(super) fn feed_max(&self) -> f64 {
        let limits = &self.control.limits;
        if self.in_step() { limits.revolution_feed_max } else { self.p.feed_limit.min(limits.feed_max) }
    }

    /// The variable in which the PLC hands over the override; where the control has none, the one in which it is typed.
    pub(super) fn input(&self) -> u32 {
        self.handed().unwrap_or(TYPED)
    }

    /// The variable in which the PLC hands over the override, where the control has such.
    pub(super) fn handed(&self) -> Option<u32> {
        let word = |kind| matches!(kind, VarKind::InputWord(_));
        let first = || self.control.vars.iter().find(|row| word(row.kind)).map(|row| row.first);
        self.control.bench.override_echo.or_else(first)
    }

    /// Least and largest value of that variable.
    pub(super) fn input_range(&self) -> (f64, f64) {
        match self.control.var(self.input()).map(|row| row.kind) {
            Some(VarKind::InputWord(width)) => width.range(),
            _ => Width::Word.range(),
        }
    }
}
