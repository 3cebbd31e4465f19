//! The ribbon line on a control: its axes, words and inputs there, and the form without the choices that the control lacks.

use super::derive::Derived;
use super::params::{FeedForm, OverrideForm, PULL, Params, PathMode, PrintAxis, YUnit};
use super::scene::labels::{distance, names};
use super::scene::layout::Layout;
use crate::controls::vars::Width;
use crate::controls::{Control, Dialect, VarKind};
use crate::machines::machine::ControlContext;

/// Variable for the typed override, on controls whose PLC has no macro input.
const TYPED: u32 = 103;

/// The ribbon line on a control.
#[derive(Debug)]
pub(crate) struct RibbonLine {
    /// The form as it was filled in.
    pub(super) form: Params,
    /// The form, with the control's own choice where it lacks the chosen one.
    pub(super) p: Params,
    /// The results of the formulas.
    pub(super) d: Derived,
    pub(super) control: &'static Control,
    pub(super) dialect: Dialect,
    /// Positions and sizes in the drawing.
    pub(super) layout: Layout,
}

impl RibbonLine {
    /// Fits the form to the control and computes the formulas.
    pub(super) fn resolve(form: Params, on: ControlContext) -> RibbonLine {
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
        let d = Derived::new(&p, control.bench.output_bits);
        let [unwinder, pull, print] = names(&p).map(|name| name.chars().count());
        let letters = [unwinder, pull, print, distance(&p).chars().count()];
        let layout = Layout::new(&p, letters);
        RibbonLine { form, p, d, control, dialect, layout }
    }

    /// Index of the axis that pulls, in the control's order.
    pub(super) fn pull(&self) -> usize {
        self.control.axis(PULL).unwrap_or(0)
    }

    /// Index of the print roller's axis.
    pub(super) fn print(&self) -> usize {
        self.control.axis(self.p.print_axis.address()).unwrap_or(0)
    }

    /// Units of X words per millimetre of ribbon: 2 where they are diameters.
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

    /// The largest F: the range of the control, in mm/min also the limit of the form.
    pub(super) fn feed_max(&self) -> f64 {
        let limits = &self.control.limits;
        if self.in_step() { limits.revolution_feed_max } else { self.p.feed_limit.min(limits.feed_max) }
    }

    /// Variable of the override: the macro input, or the one in which it is typed.
    pub(super) fn input(&self) -> u32 {
        self.handed().unwrap_or(TYPED)
    }

    /// Macro input that carries the override, where the control has one.
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
