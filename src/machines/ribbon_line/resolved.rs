//! The ribbon line on a control: axes, words and inputs, and the form with choices that the control has.

use std::sync::OnceLock;

use super::axes::{LineAxis, PerAxis};
use super::derive::{Derived, TRIM, greatest};
use super::knob_turn::KnobTurn;
use super::mechanics::Mechanics;
use super::params::{
    Endless, KnobStep, OverrideForm, PULL, PULL_LETTER, Params, PathMode, PrintAxis, YUnit, override_input,
};
use super::regulated_loop;
use super::scene::captions::{distance, names};
use super::scene::layout::Layout;
use super::variables::TYPED_OVERRIDE;
use crate::controls::interface::SignalRole;
use crate::controls::{AnalogOutput, Control, Dialect};
use crate::drives::speed::KnobRange;
use crate::drives::web;
use crate::machines::driven::scaling::{AxisDrive, GearTurns};
use crate::machines::machine::ControlContext;
use crate::machines::program::writing;
use crate::math::PI;
use crate::text::columns;

/// Override (%) to which the line's ladder limits the knob.
pub(super) const KNOB_LIMIT: f64 = 200.0;

/// The ribbon line on a control.
#[derive(Debug)]
pub(crate) struct RibbonLine {
    /// The form as filled in.
    pub(super) form: Params,
    /// The form, with the control's own choice where it lacks the chosen one.
    pub(super) params: Params,
    /// The results of the formulas.
    pub(super) derived: Derived,
    /// Results with the override knob at its highest position; equal to `derived` if the line is at rest.
    pub(super) fast: Derived,
    /// Results with the override knob at the lowest position of the line; equal to `derived` if the line is at rest.
    pub(super) slow: Derived,
    /// Mechanics of the drives, and the same with the knob at its highest position.
    pub(super) mechanics: Mechanics,
    pub(super) fast_mechanics: Mechanics,
    pub(super) control: &'static Control,
    pub(super) dialect: Dialect,
    /// Positions and sizes in the drawing, worked out when it is first shown: most forms are tried for their results alone.
    layout: OnceLock<Layout>,
}

impl RibbonLine {
    /// Fits the form to the control and computes the formulas.
    pub(super) fn resolve(form: Params, on: ControlContext) -> RibbonLine {
        let (control, dialect) = (on.control, on.dialect());
        let mut params = form.clone();
        params.print_axis = form.print_axis_on(control);
        match params.print_axis {
            PrintAxis::Y => {}
            PrintAxis::C => params.y_unit = YUnit::Degrees,
            PrintAxis::Z => params.y_unit = YUnit::Millimetres,
        }
        params.endless = form.endless_on(control);
        if !form.has_final_speed_signal(control) {
            params.override_form = OverrideForm::Percent;
        }
        if !form.stops_exactly(control) {
            params.path_mode = PathMode::Continuous;
        }
        if !form.has_clamp(control) {
            for axis in [&mut params.axes.pull, &mut params.axes.print] {
                axis.clamp = axis.rapid;
            }
        }
        params.typed_override = form.types_override(control);
        params.speed_tolerance = dialect.spindle().reached;
        let knob = dialect.spindle().knob;
        params.knob_lowest = params.knob_lowest.max(knob.low);
        if dialect.device(control, SignalRole::SpindleOverrideCode).is_some() {
            // An override code has fixed positions; no other value reaches spindle or program.
            (params.override_percent, params.knob_step) = (knob.nearest(params.override_percent), KnobStep::Ten);
            params.knob_lowest = knob.at_least(params.knob_lowest);
        }
        let [derived, fast, slow] = derive_over_knob(&params, knob, &control.analog_output);
        let tautest = greatest([&derived, &fast, &slow], |at| at.tension.greatest(&params));
        let (mechanics, fast_mechanics) =
            (Mechanics::new(&params, &derived, tautest), Mechanics::new(&params, &fast, tautest));
        RibbonLine {
            form,
            params,
            derived,
            fast,
            slow,
            mechanics,
            fast_mechanics,
            control,
            dialect,
            layout: OnceLock::new(),
        }
    }

    /// Results of the formulas with the knob at a position (%).
    pub(super) fn at(&self, percent: f64) -> Derived {
        Derived::new(&Params { override_percent: percent, ..self.params.clone() }, &self.control.analog_output)
    }

    /// One turn of the knob between its lowest and its highest position.
    pub(super) fn knob_turn(&self) -> KnobTurn<'_> {
        KnobTurn::new(&self.params, self.dialect.spindle().knob.low <= 0.0, &self.slow, &self.fast)
    }

    /// Results of the formulas for another form, with the knob as it is, at its highest and at its lowest position.
    pub(super) fn with(&self, params: &Params) -> [Derived; 3] {
        derive_over_knob(params, self.dialect.spindle().knob, &self.control.analog_output)
    }

    /// The results with the knob as it is, at its highest and at its lowest position.
    pub(super) fn over_knob(&self) -> [&Derived; 3] {
        [&self.derived, &self.fast, &self.slow]
    }

    /// The results at the position of the knob at which the quantity `of` is greatest.
    pub(super) fn worst(&self, of: fn(&Derived) -> f64) -> &Derived {
        let [now, others @ ..] = self.over_knob();
        others.into_iter().fold(now, |worst, next| if of(next) > of(worst) { next } else { worst })
    }

    /// Highest position (%) of the knob that the line takes.
    pub(super) fn highest_position(&self) -> f64 {
        highest(self.dialect.spindle().knob)
    }

    /// Lowest position (%) of the knob at which the line runs.
    pub(super) fn lowest_position(&self) -> f64 {
        self.params.knob_lowest
    }

    /// Position (%) to which the knob is set at the start: the form's, from the lowest one of the line on.
    pub(super) fn start_position(&self) -> f64 {
        let percent = self.form.override_percent;
        if percent > 0.0 { percent.max(self.lowest_position()) } else { percent }
    }

    /// Positions and sizes in the drawing.
    pub(super) fn layout(&self) -> &Layout {
        self.layout.get_or_init(|| {
            let [unwinder, pull, print] = names(&self.params).map(|name| columns(&name));
            Layout::new(&self.params, [unwinder, pull, print, columns(&distance(&self.params))])
        })
    }

    /// Speed with the knob as it is over the speed at its highest position: factor by which a limit at the highest
    /// position is lower here.
    pub(super) fn knob_share(&self) -> f64 {
        if self.fast.unwinder.actual > 0.0 { self.derived.unwinder.actual / self.fast.unwinder.actual } else { 1.0 }
    }

    /// Index of the axis that pulls, in the control's order.
    pub(super) fn pull(&self) -> usize {
        self.control.axis(PULL).unwrap_or(0)
    }

    /// Index of the print roller's axis.
    pub(super) fn print(&self) -> usize {
        self.control.axis(self.params.print_axis.address()).unwrap_or(0)
    }

    /// Driven speed over commanded speed, now or with the knob at its highest position: a feed per revolution follows the measured speed of
    /// the unwinder.
    pub(super) fn driven_share(&self, at: &Derived) -> f64 {
        self.params.followed(at.unwinder.error)
    }

    /// Driven speed of the ribbon, mm/min.
    pub(super) fn line_speed(&self) -> f64 {
        self.derived.feeds.line_speed * self.driven_share(&self.derived)
    }

    /// Letter of a servo axis.
    pub(super) fn letter(&self, axis: LineAxis) -> &'static str {
        match axis {
            LineAxis::Pull => PULL_LETTER,
            LineAxis::Print => self.print_letter(),
        }
    }

    /// Letter of the print roller's axis.
    pub(super) fn print_letter(&self) -> &'static str {
        self.params.print_axis.letter()
    }

    /// Whether words of X count diameters: two units per millimetre of ribbon.
    pub(super) fn x_counts_diameters(&self) -> bool {
        self.dialect.counts_diameters(self.pull())
    }

    /// Units that words of X count per millimetre of ribbon: 2 for diameters.
    pub(super) fn x_per_mm(&self) -> f64 {
        self.dialect.words_per_mm(self.pull())
    }

    /// Degrees instead of millimetres.
    pub(super) fn degrees(&self) -> bool {
        self.params.y_unit == YUnit::Degrees
    }

    /// Whether the coordinates of the pull axis and of the print roller roll over. The print roller's always do if they count degrees. In
    /// mm they do not where the program looks for a head: the coordinate would lose the phase with each turn, whose length is no whole
    /// number of increments.
    pub(super) fn rolls_over(&self) -> PerAxis<bool> {
        let rolls = self.params.endless == Endless::RollOver;
        PerAxis { pull: rolls, print: self.degrees() || rolls && !self.reads_positions() }
    }

    /// Whether a program of the control reads the positions of its axes, and with them brings a head to the ribbon itself.
    pub(super) fn reads_positions(&self) -> bool {
        writing::work_position(self.control).is_some()
    }

    /// Whether the pull axis rolls over, which makes it a rotary axis, while its words count diameters.
    pub(super) fn rolls_in_diameters(&self) -> bool {
        self.rolls_over().pull && self.x_counts_diameters()
    }

    /// Drives of the pull axis and of the print roller.
    pub(super) fn drives(&self) -> PerAxis<AxisDrive> {
        let params = &self.params;
        let (axes, rolls) = (&params.axes, self.rolls_over());
        let turn = if self.degrees() { 360.0 } else { PI * params.print_roller_diameter };
        PerAxis {
            pull: AxisDrive {
                axis: PULL_LETTER,
                lead: PI * params.x_roller_diameter,
                gear: GearTurns { motor: axes.pull.gear, load: 1.0 },
                encoder: axes.pull.encoder,
                rotary: rolls.pull,
                words: self.x_per_mm(),
            },
            print: AxisDrive {
                axis: self.print_letter(),
                lead: turn,
                gear: GearTurns { motor: axes.print.gear, load: 1.0 },
                encoder: axes.print.encoder,
                rotary: rolls.print,
                words: 1.0,
            },
        }
    }

    /// Speed (r/min) of the motor of X, and of that of the print roller, at rapid traverse.
    pub(super) fn rapid_speeds(&self) -> PerAxis<f64> {
        let (axes, drives) = (&self.params.axes, self.drives());
        PerAxis { pull: axes.pull.rapid / drives.pull.travel(), print: axes.print.rapid / drives.print.travel() }
    }

    /// Time (s) in which the regulator of a dancer takes 63 % of a slack away while the line runs, `T = range / (limit · v)`; none without
    /// regulator, or at standstill. Source: ribbon line facts, 7.
    pub(super) fn regulating_time(&self) -> Option<f64> {
        let speed = self.params.loop_trim() * self.derived.feeds.mm_per_second();
        (speed > 0.0).then(|| self.params.loop_trim_range() / speed)
    }

    /// Highest speed of the unwinder's motor over that with the knob at its highest position: the regulator of a dancer trims upwards too.
    pub(super) fn trimmed_up(&self) -> f64 {
        if self.params.is_regulated() { 1.0 + TRIM } else { 1.0 }
    }

    /// F counts per revolution of the unwinder.
    pub(super) fn feeds_per_revolution(&self) -> bool {
        self.params.feeds_per_revolution()
    }

    /// The largest F: the range of the control, in mm/min also the limit of the form.
    pub(super) fn feed_max(&self) -> f64 {
        let limits = &self.control.limits;
        if self.feeds_per_revolution() {
            limits.revolution_feed_max
        } else {
            self.params.feed_limit.min(limits.feed_max)
        }
    }

    /// Length (mm) of a dot along the ribbon.
    pub(super) fn dot_length(&self) -> f64 {
        web::mark_length(self.params.head.length, self.derived.surface.ratio, self.params.contact_length)
    }

    /// Ribbon (mm) between two dots; negative where they run into each other.
    pub(super) fn dot_gap(&self) -> f64 {
        self.params.pitch - self.dot_length()
    }

    /// Variable of the override: the macro input, or the variable in which it is typed.
    pub(super) fn override_variable(&self) -> u32 {
        self.override_macro_input().unwrap_or(TYPED_OVERRIDE)
    }

    /// Macro input with the override, if the control has one.
    pub(super) fn override_macro_input(&self) -> Option<u32> {
        override_input(self.control)
    }
}

/// Highest position (%) of a knob that the line takes.
fn highest(knob: KnobRange) -> f64 {
    knob.high.min(KNOB_LIMIT)
}

/// Results of the formulas with the knob as it is, at its highest and at its lowest position. A locked knob has no other position, a line
/// at standstill neither.
fn derive_over_knob(params: &Params, knob: KnobRange, output: &AnalogOutput) -> [Derived; 3] {
    let mut over_knob = unregulated_over_knob(params, knob, output);
    regulated_loop::keep(params, knob, &mut over_knob);
    over_knob
}

/// The same without the loop that the regulator of a dancer keeps.
fn unregulated_over_knob(params: &Params, knob: KnobRange, output: &AnalogOutput) -> [Derived; 3] {
    let at = |percent: f64| Derived::new(&Params { override_percent: percent, ..params.clone() }, output);
    let now = Derived::new(params, output);
    if now.unwinder.actual <= 0.0 || params.knob_is_locked() {
        return [now.clone(), now.clone(), now];
    }
    let fast = at(highest(knob).max(params.override_percent));
    // The PLC raises one step of the knob to the lowest position, which may be between two steps.
    let slow = at(params.knob_step.percent());
    [now, fast, slow]
}
