//! The turning spindle on a control: the form with choices that the control has, and the units of its words.

use std::sync::OnceLock;

use super::derive::Derived;
use super::params::{self, Gear, Output, Params, Path, SpeedMode, SpindleDirection};
use crate::controls::Address;
use crate::controls::{Control, Dialect, SpindleRules};
use crate::drives::cutting::{Chip, CuttingEdge, Kienzle};
use crate::drives::{Analog, Positioning};
use crate::machines::driven::scaling::AxisDrive;
use crate::machines::lathe::knobs::{self, KnobPositions};
use crate::machines::lathe::slides::{ALONG, CROSS};
use crate::machines::machine::ControlContext;
use crate::motion::Snapshot;

/// The cut at positions of the knobs: the form, and the results there.
#[derive(Debug, Clone, Copy)]
pub(super) struct CutAtKnobs<'a> {
    pub at: KnobPositions,
    pub params: &'a Params,
    pub derived: &'a Derived,
}

/// The turning spindle on a control.
#[derive(Debug)]
pub(crate) struct TurningSpindle {
    /// The form as filled in.
    pub(super) form: Params,
    /// The form, with the control's own choice where it lacks the chosen one.
    pub(super) params: Params,
    /// The results of the formulas.
    pub(super) derived: Derived,
    /// The results with the override knob at its highest position, computed when a rule asks for them.
    at_highest_knob: OnceLock<Derived>,
    /// The same at its lowest position.
    at_lowest_knob: OnceLock<Derived>,
    /// The lathe with the feed override at its highest position, computed when a rule asks for it.
    at_highest_feed: OnceLock<Box<TurningSpindle>>,
    pub(super) control: &'static Control,
    pub(super) dialect: Dialect,
}

/// Numbers of the M codes of one device of the machine.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct CodePair {
    /// Switches it on.
    pub on: u32,
    /// Switches it off, where there is a code for it.
    pub off: Option<u32>,
}

impl TurningSpindle {
    /// Fits the form to the control and computes the formulas.
    pub(super) fn resolve(form: Params, on: ControlContext) -> TurningSpindle {
        TurningSpindle::on(form, on.control, on.dialect())
    }

    /// The same lathe with another form.
    pub(super) fn with(&self, form: Params) -> TurningSpindle {
        TurningSpindle::on(form, self.control, self.dialect.clone())
    }

    fn on(form: Params, control: &'static Control, dialect: Dialect) -> TurningSpindle {
        let mut params = form.clone();
        if !form.holds_surface_speed(control) {
            (params.speed_mode, params.lower_limit) = (SpeedMode::Fixed, 0.0);
        }
        if !form.has_gears(control) {
            (params.stage_2, params.stage_3, params.stage_4) = (0.0, 0.0, 0.0);
            params.gear = Gear::First;
        }
        if !form.has_signed_output(control) {
            params.output = Output::Unipolar;
        }
        if !form.has_clamp(control) {
            (params.slides.x.clamp, params.slides.z.clamp) = (form.slides.x.rapid, form.slides.z.rapid);
        }
        if !form.has_offsets(control) {
            (params.offset_zero, params.offset_full) = (0.0, 0.0);
        }
        // A face is turned to the centre of the work, where the tailstock's centre would be.
        params.tailstock &= params.path != Path::Facing;
        params.depth = params.greatest_depth();
        // The nearest position of the knob, and S as a whole number where the control reads it so.
        params.override_percent = dialect.spindle().knob.nearest(params.override_percent);
        if control.syntax.integer_addresses.contains(Address::S) {
            let truncates = !dialect.numbers.round_speed;
            params.cutting_speed = if truncates { params.cutting_speed.floor() } else { params.cutting_speed.round() };
        }
        if let Some(row) = params.material.kienzle() {
            let worn = Kienzle { unit_force: row.unit_force * params.edge_wear, ..row };
            let chip = Chip { depth: params.depth, feed: params.feed };
            params.cutting_force = worn.force(chip, CuttingEdge { angle: params.edge_angle, rake: params.rake });
        }
        let derived = Derived::new(&params, &control.analog_output, &dialect.spindle());
        TurningSpindle {
            form,
            params,
            derived,
            at_highest_knob: OnceLock::new(),
            at_lowest_knob: OnceLock::new(),
            at_highest_feed: OnceLock::new(),
            control,
            dialect,
        }
    }

    /// The highest position (%) of the override knob with the results there; none if the form has that position.
    pub(super) fn at_highest_knob(&self) -> Option<(f64, &Derived)> {
        let highest = self.rules().knob.ends(self.params.override_percent).higher?;
        Some((highest, self.at_highest_knob.get_or_init(|| self.at_knob(highest))))
    }

    /// The lowest position (%) of the override knob at which the spindle turns, with the results there; none if the
    /// form has that position.
    pub(super) fn at_lowest_knob(&self) -> Option<(f64, &Derived)> {
        let lowest = self.rules().knob.ends(self.params.override_percent).lower?;
        Some((lowest, self.at_lowest_knob.get_or_init(|| self.at_knob(lowest))))
    }

    /// The results with the knob at another position: the program keeps its gear stage.
    fn at_knob(&self, percent: f64) -> Derived {
        let params = Params {
            override_percent: percent,
            gear: Gear::at(self.derived.stage.number.into()),
            ..self.params.clone()
        };
        Derived::new(&params, &self.control.analog_output, &self.rules())
    }

    /// Highest position (%) of the feed override, and the lathe as it cuts there. A typed force is raised in proportion
    /// to the feed, because its chip thickness is not known.
    pub(super) fn at_highest_feed(&self) -> Option<(f64, &TurningSpindle)> {
        let highest = knobs::highest_feed(self.control.feed_knob.positions)?;
        let share = highest / 100.0;
        let (feed, cutting_force) = (self.form.feed * share, self.form.cutting_force * share);
        let lathe = || Box::new(self.with(Params { feed, cutting_force, ..self.form.clone() }));
        Some((highest, self.at_highest_feed.get_or_init(lathe)))
    }

    /// The cut at the positions of the knobs of feed and spindle, those of the form left out.
    pub(super) fn cuts_at_knobs(&self) -> Vec<CutAtKnobs<'_>> {
        let present = self.params.override_percent;
        let all = knobs::positions(self.control.feed_knob.positions, self.rules().knob.ends(present), present);
        let fed = self.at_highest_feed();
        let cut = |at: KnobPositions| {
            let lathe = fed.filter(|(feed, _)| *feed == at.feed).map_or(self, |(_, lathe)| lathe);
            CutAtKnobs { at, params: &lathe.params, derived: lathe.at_spindle_override(at.spindle) }
        };
        all.into_iter().map(cut).collect()
    }

    /// The cut at the form's positions of the knobs.
    pub(super) fn cut_at_present(&self) -> CutAtKnobs<'_> {
        let at = KnobPositions { feed: knobs::FULL_PERCENT, spindle: self.params.override_percent };
        CutAtKnobs { at, params: &self.params, derived: &self.derived }
    }

    /// The results at the form's position (%) of the spindle override or at an end of it.
    fn at_spindle_override(&self, percent: f64) -> &Derived {
        let ends = [self.at_highest_knob(), self.at_lowest_knob()].into_iter().flatten();
        ends.into_iter().find(|(end, _)| *end == percent).map_or(&self.derived, |(_, d)| d)
    }

    /// Drives of the slides across and along the work.
    pub(super) fn drives(&self) -> [AxisDrive; 2] {
        self.params.slides.drives(self.dialect.words_per_mm(self.cross()))
    }

    /// Index of the axis across the spindle.
    pub(super) fn cross(&self) -> usize {
        self.control.axis(CROSS).unwrap_or(0)
    }

    /// Index of the axis along the spindle.
    pub(super) fn along(&self) -> usize {
        self.control.axis(ALONG).unwrap_or(0)
    }

    /// Whether words of X count diameters; otherwise radii.
    pub(super) fn x_counts_diameters(&self) -> bool {
        self.dialect.counts_diameters(self.cross())
    }

    /// Whether the spindle has constant surface speed.
    pub(super) fn surface(&self) -> bool {
        self.params.speed_mode == SpeedMode::Surface
    }

    /// Dwell in each pass, in seconds per r/min of the speed limit, on a control whose cuts do not wait for the speed;
    /// `None` if a cut ends at the speed with which the next one begins. Between two speeds the spindle needs at most
    /// its ramp to the limit.
    pub(super) fn dwell_of_passes(&self) -> Option<f64> {
        let changes = self.surface() && self.params.path != Path::Turning;
        let per_speed = self.params.spindle.ramp / self.derived.stage.speed;
        (changes && self.rules().reached.is_none() && per_speed > 0.0).then_some(per_speed)
    }

    /// Address of the speed limit under constant surface speed, on controls with a word for it.
    pub(super) fn limit_word(&self) -> Option<Address> {
        params::has_address(self.control, Address::Lims).then_some(Address::Lims)
    }

    /// Whether the spindle is positioned to an angle after the cut.
    pub(super) fn positions(&self) -> bool {
        self.params.keyway && self.form.can_position(self.control)
    }

    /// Diameter (mm) of the cylinder into which the program cuts a keyway with the driven tool; `None` without a
    /// keyway.
    pub(super) fn keyway(&self) -> Option<f64> {
        let cuts = self.positions() && self.params.driven_tool && self.params.keyway_depth > 0.0;
        self.params.keyway_diameter().filter(|_| cuts)
    }

    /// Codes that lock the spindle at its angle and release it again, where the program locks it.
    pub(super) fn lock_codes(&self) -> Option<CodePair> {
        let [lock, off] = [self.params.lock_code, self.params.release_code].map(given_code);
        Some(CodePair { on: lock.filter(|_| self.positions())?, off })
    }

    /// Codes of the machine that start and stop the driven tool; none where the control's own second spindle drives it.
    pub(super) fn driven_codes(&self) -> Option<CodePair> {
        let [start, off] = [self.params.driven_code, self.params.driven_stop].map(given_code);
        Some(CodePair { on: start.filter(|_| self.keyway().is_some())?, off })
    }

    /// Positioning of the spindle, by the machine's data.
    pub(super) fn positioning(&self) -> Positioning {
        Positioning {
            speed: self.params.positioning_speed,
            acceleration: self.params.positioning_acceleration,
            clockwise: self.params.positioning_direction == SpindleDirection::Clockwise,
        }
    }

    /// Spindle rules of the control under its settings.
    pub(super) fn rules(&self) -> SpindleRules {
        self.dialect.spindle()
    }

    /// Whether no slower gear stage reaches the speeds of the cut.
    pub(super) fn is_best_stage(&self) -> bool {
        let best = Params { gear: Gear::Best, ..self.params.clone() };
        let best = Derived::new(&best, &self.control.analog_output, &self.rules());
        best.stage.speed >= self.derived.stage.speed
    }

    /// The analog output in the gear stage of the program.
    pub(super) fn analog(&self) -> Analog {
        self.params.analog(self.derived.stage.speed, &self.control.analog_output)
    }

    /// Number of the gear stage that the program engages.
    pub(super) fn stage(&self) -> u8 {
        self.derived.stage.number
    }

    /// Distance of the tool from the turning centre in mm, and from the finished face.
    pub(super) fn tool(&self, now: &Snapshot) -> (f64, f64) {
        let at = |axis: usize| now.axes.get(axis).map_or(0.0, |axis| axis.actual);
        (at(self.cross()), at(self.along()))
    }

    /// Diameter at the tool tip, mm.
    pub(super) fn diameter(&self, now: &Snapshot) -> f64 {
        2.0 * self.tool(now).0
    }
}

/// The code of a field; 0 is none.
pub(super) fn given_code(number: f64) -> Option<u32> {
    (number > 0.0).then_some(number as u32)
}
