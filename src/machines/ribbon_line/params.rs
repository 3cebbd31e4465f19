//! The form of the ribbon line: every input with unit, range and default, and the parameters that it fills.

use super::axes::PerAxis;
use crate::controls::Address;
use crate::controls::interface::SignalRole;
use crate::controls::{Code, Control, ParamRole, VarKind};
use crate::drives::derating::Site;
use crate::machines::driven::site;
use crate::machines::driven::spindle_encoder::{self, EncoderParams};
use crate::machines::form::Field;
use crate::machines::form::common::{self, LineEnds};
use crate::machines::form::rows::{choice, flag, number, text};
use crate::machines::machine::LOWEST_KNOB;
use crate::{member, options};

/// The axis that pulls the ribbon.
pub(super) const PULL: Address = Address::X;

/// Letter of that axis in texts.
pub(super) const PULL_LETTER: &str = "X";

options! {
    /// Unit of the override in the macro input.
    pub(crate) enum OverrideForm {
        /// In percent: speed = S · override / 100, clamped by the program.
        Percent = "percent" "ribbon.override-form.percent",
        /// Speed of the spindle after override and clamp, in r/min.
        FinalSpeed = "final-speed" "ribbon.override-form.final-speed",
    }
}

options! {
    /// Steps of the override knob.
    pub(crate) enum KnobStep {
        /// 1 %.
        One = "1" "ribbon.knob-step.1",
        /// 5 %.
        Five = "5" "ribbon.knob-step.5",
        /// 10 %.
        Ten = "10" "ribbon.knob-step.10",
    }
}

options! {
    /// Effect of the spindle override knob in automatic if the override is typed: no program reads the knob then.
    pub(crate) enum KnobUse {
        /// The PLC holds the override at 100 %; the typed percentage scales S and the axes alike.
        Locked = "locked" "ribbon.knob-use.locked",
        /// The knob changes the speed of the unwinder alone.
        Free = "free" "ribbon.knob-use.free",
    }
}

options! {
    /// The axis of the print roller.
    pub(crate) enum PrintAxis {
        /// Y.
        Y = "y" "ribbon.print-axis.y",
        /// C, in degrees.
        C = "c" "ribbon.print-axis.c",
        /// Z, in millimetres.
        Z = "z" "ribbon.print-axis.z",
    }
}

options! {
    /// Unit of F.
    pub(crate) enum FeedForm {
        /// mm/min.
        PerMinute = "per-minute" "ribbon.feed-form.per-minute",
        /// mm per revolution of the unwinder's motor.
        PerRevolution = "per-revolution" "ribbon.feed-form.per-revolution",
    }
}

options! {
    /// Unit of the print roller's axis.
    pub(crate) enum YUnit {
        /// Circumference in millimetres.
        Millimetres = "mm" "ribbon.y-unit.mm",
        /// Degrees of the print roller.
        Degrees = "degrees" "ribbon.y-unit.degrees",
    }
}

options! {
    /// Method that keeps the coordinates of the axes, which run one way for ever, within the range of the control.
    pub(crate) enum Endless {
        /// The program shifts the coordinates back at each start.
        Shift = "shift" "ribbon.endless.shift",
        /// Parameters: rotary axes, whose coordinates roll over.
        RollOver = "roll-over" "ribbon.endless.roll-over",
        /// Nothing.
        Nothing = "nothing" "ribbon.endless.nothing",
    }
}

options! {
    /// Size of a product.
    pub(crate) enum Job {
        /// A number of pitches.
        Pitches = "pitch-count" "ribbon.job.pitch-count",
        /// A length of ribbon.
        Length = "product-length" "ribbon.job.product-length",
    }
}

options! {
    /// Treatment of a length that is no whole number of pitches.
    pub(crate) enum Rest {
        /// The nearest whole number of pitches is printed.
        Round = "round" "ribbon.rest.round",
        /// The last pitch is shorter.
        Shorten = "shorten" "ribbon.rest.shorten",
        /// The program stops with an alarm.
        Alarm = "alarm" "ribbon.rest.alarm",
    }
}

options! {
    /// π in the program.
    pub(crate) enum PiForm {
        /// 3.141592654.
        Exact = "exact" "ribbon.pi.exact",
        /// 3.14, as published.
        Short = "3.14" "ribbon.pi.short",
    }
}

options! {
    /// How the program waits for the spindle before the ribbon is pulled.
    pub(crate) enum Wait {
        /// A dwell after M3.
        Dwell = "dwell" "ribbon.wait.dwell",
        /// The PLC answers M3 when the spindle is at speed.
        Fin = "fin" "ribbon.wait.fin",
    }
}

options! {
    /// How blocks join.
    pub(crate) enum PathMode {
        /// Cutting mode, G64.
        Continuous = "continuous" "ribbon.path-mode.continuous",
        /// Exact stop, G61.
        ExactStop = "exact-stop" "ribbon.path-mode.exact-stop",
    }
}

options! {
    /// Source of the program.
    pub(crate) enum Variant {
        /// The ready-made one.
        ReadyMade = "ready-made" "ribbon.variant.ready-made",
        /// The paper's listing with its numbers, corrected.
        Published = "published" "ribbon.variant.published",
        /// The corrected listing, with its calculation before the loop instead of in each pass.
        Precomputed = "precomputed" "ribbon.variant.precomputed",
    }
}

options! {
    /// Law of an electronic cam of the print roller.
    pub(crate) enum CamLaw {
        /// No cam.
        Off = "none" "ribbon.cam-law.none",
        /// 3-4-5 polynomial.
        Polynomial = "polynomial-345" "ribbon.cam-law.polynomial-345",
        /// Modified sine.
        ModifiedSine = "modified-sine" "ribbon.cam-law.modified-sine",
    }
}

impl PrintAxis {
    /// Catalog id of its name.
    pub(super) fn name(self) -> &'static str {
        match self {
            PrintAxis::Y => "ribbon.print-axis.y",
            PrintAxis::C => "ribbon.print-axis.c",
            PrintAxis::Z => "ribbon.print-axis.z",
        }
    }

    /// Its address.
    pub(super) fn address(self) -> Address {
        match self {
            PrintAxis::Y => Address::Y,
            PrintAxis::C => Address::C,
            PrintAxis::Z => Address::Z,
        }
    }

    /// Its letter in texts.
    pub(super) fn letter(self) -> &'static str {
        match self {
            PrintAxis::Y => "Y",
            PrintAxis::C => "C",
            PrintAxis::Z => "Z",
        }
    }
}

impl KnobStep {
    /// Percent per step.
    pub(super) fn percent(self) -> f64 {
        match self {
            KnobStep::One => 1.0,
            KnobStep::Five => 5.0,
            KnobStep::Ten => 10.0,
        }
    }
}

/// Inputs of the ribbon line, within the ranges of [`FIELDS`]. Units as in the form.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Params {
    pub spindle_speed: f64,
    pub reduction_ratio: f64,
    pub press_roller_diameter: f64,
    pub pitch: f64,
    pub heads: f64,
    pub print_roller_diameter: f64,
    pub speed_at_10v: f64,
    pub speed_clamp: f64,
    pub override_percent: f64,
    pub override_form: OverrideForm,
    pub knob_step: KnobStep,
    pub knob_lowest: f64,
    pub knob_use: KnobUse,
    /// Whether the override is typed, because the control has no macro input with the knob. Not a field: it follows
    /// from the control.
    pub typed_override: bool,
    /// Share of the commanded speed within which the control lets a feed begin after a start of the spindle; none where it does not wait.
    /// Not a field: it follows from the control and its switch.
    pub speed_tolerance: Option<f64>,
    pub manual_speed: f64,
    pub frequency_at_10v: f64,
    pub inverter_ramp: f64,
    pub no_load_speed: f64,
    pub rated_load_speed: f64,
    pub unwinder_load: f64,
    pub dancer: bool,
    pub spindle_encoder: bool,
    pub encoder: EncoderParams,
    pub loop_capacity: f64,
    pub ribbon_thickness: f64,
    pub effective_diameter: bool,
    pub ribbon_width: f64,
    pub youngs_modulus: f64,
    pub tensile_strength: f64,
    pub print_axis: PrintAxis,
    pub y_unit: YUnit,
    pub endless: Endless,
    pub contact_length: f64,
    pub smear_limit: f64,
    pub dot_tolerance: f64,
    pub roller_run_out: f64,
    pub gear_backlash: f64,
    pub cam_law: CamLaw,
    pub job: Job,
    pub pitch_count: f64,
    pub product_length: f64,
    pub rest: Rest,
    pub pitches_per_block: f64,
    pub pause: f64,
    pub in_position: f64,
    pub x_roller_diameter: f64,
    pub site_height: f64,
    pub site_temperature: f64,
    pub feed_limit: f64,
    pub block_time: f64,
    pub macro_time: f64,
    pub preread: f64,
    pub pi: PiForm,
    pub feed_form: FeedForm,
    pub wait: Wait,
    pub dwell: f64,
    pub path_mode: PathMode,
    pub variant: Variant,
    pub newline: LineEnds,
    pub customer: String,
    pub product: String,
    pub web: WebParams,
    pub axes: PerAxis<AxisParams>,
    pub pinch: PinchParams,
    pub head: HeadParams,
    pub unwinding: UnwindingParams,
}

/// The ribbon between the rollers.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct WebParams {
    pub density: f64,
    pub span: f64,
    pub tension_before: f64,
    pub tension_behind: f64,
}

/// A servo axis: feeds and servo loop, roller, gear, motor.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct AxisParams {
    pub clamp: f64,
    pub rapid: f64,
    pub time_constant: f64,
    pub position_gain: f64,
    pub encoder: f64,
    pub wall: f64,
    pub length: f64,
    pub friction: f64,
    pub gear: f64,
    pub efficiency: f64,
    pub gear_inertia: f64,
    pub motor: ServoParams,
}

/// Ids of the fields of a servo axis.
#[derive(Debug, Clone, Copy)]
pub(super) struct AxisFields {
    pub clamp: &'static str,
    pub rapid: &'static str,
    pub time_constant: &'static str,
    pub position_gain: &'static str,
    pub encoder: &'static str,
}

/// Ids of the fields of both servo axes.
pub(super) const AXIS_FIELDS: PerAxis<AxisFields> = PerAxis {
    pull: AxisFields {
        clamp: "clamp-x",
        rapid: "rapid-x",
        time_constant: "time-constant-x",
        position_gain: "position-gain-x",
        encoder: "encoder-resolution-x",
    },
    print: AxisFields {
        clamp: "clamp-y",
        rapid: "rapid-y",
        time_constant: "time-constant-y",
        position_gain: "position-gain-y",
        encoder: "encoder-resolution-y",
    },
};

/// The motor of a servo axis.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct ServoParams {
    pub name: String,
    pub rated: f64,
    pub stall: f64,
    pub peak: f64,
    pub rotor: f64,
    pub rated_speed: f64,
    pub top_speed: f64,
    pub inertia_limit: f64,
    pub effective_limit: f64,
}

/// The pinch roller on the pull roller.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct PinchParams {
    pub mass: f64,
    pub diameter: f64,
    pub force: f64,
    pub friction: f64,
}

/// A head of the print roller.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct HeadParams {
    pub mass: f64,
    pub length: f64,
    pub force: f64,
}

/// The drive of the unwinder.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct UnwindingParams {
    pub reel_diameter: f64,
    pub core_diameter: f64,
    pub core_inertia: f64,
    pub reel_change: f64,
    pub inertia: f64,
    pub brake: f64,
    pub friction: f64,
    pub efficiency: f64,
    pub motor: String,
    pub torque: f64,
    pub site_share: f64,
    pub forced_cooling: bool,
    pub motor_brake: f64,
    pub motor_braking: f64,
}

/// Axes that can carry the print roller: on a lathe, whose X counts diameters, Y, C or Z; else Y.
fn print_axes(control: &Control) -> impl Iterator<Item = PrintAxis> {
    let lathe = control.axes.iter().any(|axis| axis.letter == PULL && axis.diameter);
    let axes = [PrintAxis::Y, PrintAxis::C, PrintAxis::Z].into_iter().take(if lathe { 3 } else { 1 });
    axes.filter(|axis| control.axis(axis.address()).is_some())
}

impl Params {
    /// Height and temperature of the site.
    pub(super) fn site(&self) -> Site {
        Site { height: self.site_height, temperature: self.site_temperature }
    }

    /// The print roller's axis on a control: the chosen one, or the first that the control has.
    pub(super) fn print_axis_on(&self, control: &Control) -> PrintAxis {
        let first = print_axes(control).next().unwrap_or_default();
        print_axes(control).find(|axis| *axis == self.print_axis).unwrap_or(first)
    }

    /// The control has several axes for the print roller.
    fn has_print_axes(&self, control: &Control) -> bool {
        print_axes(control).nth(1).is_some()
    }

    /// The unit of the print roller's axis is a choice: Y is fitted as a linear or as a rotary axis.
    fn has_print_unit(&self, control: &Control) -> bool {
        self.print_axis_on(control) == PrintAxis::Y
    }

    /// The chosen method for endless axes, or the first that the control has: not every control has a code that presets
    /// coordinates, or a known parameter for axes that roll over.
    pub(super) fn endless_on(&self, control: &Control) -> Endless {
        let shifts = control.can(Code::SetCoordinates);
        let rolls = control.param(ParamRole::AxisRollOver).is_some();
        match self.endless {
            Endless::Shift if shifts => Endless::Shift,
            Endless::Shift | Endless::RollOver if rolls => Endless::RollOver,
            Endless::RollOver if shifts => Endless::Shift,
            _ => Endless::Nothing,
        }
    }

    /// The control counts the turns of the unwinder's motor.
    fn counts_turns(&self, _: &Control) -> bool {
        self.spindle_encoder
    }

    /// The control gives the PLC the final spindle speed.
    pub(super) fn has_final_speed_signal(&self, control: &Control) -> bool {
        control.interface.iter().any(|row| row.role == SignalRole::SpindleFinal)
    }

    /// A product is a length of ribbon.
    pub(super) fn is_length(&self, _: &Control) -> bool {
        self.job == Job::Length
    }

    /// No macro input hands the knob to the program.
    pub(super) fn types_override(&self, control: &Control) -> bool {
        override_input(control).is_none()
    }

    /// The knob acts in automatic: the PLC does not lock it at 100 %.
    pub(super) fn has_live_knob(&self, control: &Control) -> bool {
        !self.types_override(control) || self.knob_use == KnobUse::Free
    }

    /// A block can end in an exact stop.
    pub(super) fn stops_exactly(&self, control: &Control) -> bool {
        control.can(Code::ExactStop) || control.can(Code::ExactStopOnce)
    }

    /// Whether the control clamps the feed of each axis.
    pub(super) fn has_clamp(&self, control: &Control) -> bool {
        control.clamps_feed()
    }
}

/// Macro input with the override, if the control has one.
pub(super) fn override_input(control: &Control) -> Option<u32> {
    let word = |kind| matches!(kind, VarKind::InputWord(_));
    let first = || control.vars.iter().find(|row| word(row.kind)).map(|row| row.first);
    control.bench.override_echo.or_else(first)
}

/// Every input, in the order of the form.
#[rustfmt::skip]
pub(super) static FIELDS: &[Field<Params>] = &[
    number("spindle-speed", member!(Params.spindle_speed)).group("ribbon.group.unwinder").label("ribbon.spindle-speed").help("ribbon.spindle-speed.help").symbol("#100")
        .unit("r/min").range(1.0..=30000.0).default(1200.0).decimals(0).step(10.0).essential(),
    number("reduction-ratio", member!(Params.reduction_ratio)).group("ribbon.group.unwinder").label("ribbon.reduction-ratio").help("ribbon.reduction-ratio.help").symbol("#101")
        .unit(": 1").range(0.001..=10000.0).default(25.0).decimals(6).step(1.0).essential().fact(),
    number("press-roller-diameter", member!(Params.press_roller_diameter)).group("ribbon.group.unwinder").label("ribbon.press-roller-diameter").help("ribbon.press-roller-diameter.help").symbol("#102")
        .unit("mm").range(1.0..=5000.0).default(100.0).decimals(4).step(1.0).essential().fact(),
    number("pitch", member!(Params.pitch)).group("ribbon.group.web").label("ribbon.pitch").help("ribbon.pitch.help").symbol("#107")
        .unit("mm").range(0.01..=10000.0).default(8.0).decimals(3).step(0.1).essential(),
    number("heads", member!(Params.heads)).group("ribbon.group.print").label("ribbon.heads").help("ribbon.heads.help").symbol("#109")
        .range(1.0..=1000.0).default(6.0).decimals(0).step(1.0).essential().fact(),
    number("print-roller-diameter", member!(Params.print_roller_diameter)).group("ribbon.group.print").label("ribbon.print-roller-diameter").help("ribbon.print-roller-diameter.help").symbol("#111")
        .unit("mm").range(1.0..=5000.0).default(120.0).decimals(4).step(1.0).essential().fact(),
    number("speed-at-10v", member!(Params.speed_at_10v)).group("ribbon.group.unwinder").label("ribbon.speed-at-10v").help("ribbon.speed-at-10v.help").symbol("n10")
        .unit("r/min").range(1.0..=60000.0).default(1480.0).decimals(3).step(10.0).fact(),
    number("speed-clamp", member!(Params.speed_clamp)).group("ribbon.group.unwinder").label("ribbon.speed-clamp").help("ribbon.speed-clamp.help").symbol("#116")
        .unit("r/min").range(1.0..=60000.0).default(1480.0).decimals(3).step(10.0).fact(),
    number("override", member!(Params.override_percent)).group("ribbon.group.unwinder").label("ribbon.override").help("ribbon.override.help")
        .unit("%").range(0.0..=200.0).default(100.0).decimals(0).step(1.0),
    choice("override-form", member!(Params.override_form: OverrideForm)).group("ribbon.group.unwinder").label("ribbon.override-form").help("ribbon.override-form.help")
        .when(Params::has_final_speed_signal),
    choice("knob-step", member!(Params.knob_step: KnobStep)).group("ribbon.group.unwinder").label("ribbon.knob-step").help("ribbon.knob-step.help"),
    number("knob-lowest", member!(Params.knob_lowest)).group("ribbon.group.unwinder").label("ribbon.knob-lowest").help("ribbon.knob-lowest.help")
        .unit("%").range(LOWEST_KNOB..=100.0).default(50.0).decimals(0).step(10.0).setting()
        .when(Params::has_live_knob),
    choice("knob-use", member!(Params.knob_use: KnobUse)).group("ribbon.group.unwinder").label("ribbon.knob-use").help("ribbon.knob-use.help")
        .when(Params::types_override),
    number("manual-speed", member!(Params.manual_speed)).group("ribbon.group.unwinder").label("ribbon.manual-speed").help("ribbon.manual-speed.help").symbol("S")
        .unit("r/min").range(0.0..=30000.0).default(100.0).decimals(0).step(10.0),
    number("frequency-at-10v", member!(Params.frequency_at_10v)).group("ribbon.group.unwinder").label("ribbon.frequency-at-10v").help("ribbon.frequency-at-10v.help")
        .unit("Hz").range(1.0..=1000.0).default(50.0).decimals(2).step(1.0).fact(),
    number("inverter-ramp", member!(Params.inverter_ramp)).group("ribbon.group.unwinder").label("ribbon.inverter-ramp").help("ribbon.inverter-ramp.help")
        .unit("s").range(0.01..=600.0).default(2.0).decimals(3).step(0.1).fact(),
    number("no-load-speed", member!(Params.no_load_speed)).group("ribbon.group.unwinder").label("ribbon.no-load-speed").help("ribbon.no-load-speed.help")
        .unit("r/min").range(1.0..=60000.0).default(1500.0).decimals(3).step(1.0).fact(),
    number("rated-load-speed", member!(Params.rated_load_speed)).group("ribbon.group.unwinder").label("ribbon.rated-load-speed").help("ribbon.rated-load-speed.help")
        .unit("r/min").range(1.0..=60000.0).default(1430.0).decimals(3).step(1.0).fact(),
    number("unwinder-load", member!(Params.unwinder_load)).group("ribbon.group.unwinder").label("ribbon.unwinder-load").help("ribbon.unwinder-load.help")
        .unit("%").range(0.0..=200.0).default(2.286).decimals(3).step(1.0).fact(),
    flag("spindle-encoder", member!(Params.spindle_encoder)).group("ribbon.group.unwinder").label("ribbon.spindle-encoder").help("ribbon.spindle-encoder.help")
        .fact(),
    spindle_encoder::lines("ribbon.group.unwinder", member!(Params.encoder.lines)).when(Params::counts_turns),
    spindle_encoder::turns("ribbon.group.unwinder", member!(Params.encoder.turns)).when(Params::counts_turns),
    spindle_encoder::spindle_turns("ribbon.group.unwinder", member!(Params.encoder.spindle_turns)).when(Params::counts_turns),
    number("reel-brake", member!(Params.unwinding.brake)).group("ribbon.group.reel").label("ribbon.reel-brake").help("ribbon.reel-brake.help")
        .unit("N").range(0.0..=100000.0).default(20.0).decimals(2).step(1.0).fact(),
    number("reel-diameter", member!(Params.unwinding.reel_diameter)).group("ribbon.group.reel").label("ribbon.reel-diameter").help("ribbon.reel-diameter.help").symbol("D")
        .unit("mm").range(10.0..=5000.0).default(224.0).decimals(1).step(10.0).fact(),
    number("reel-core-diameter", member!(Params.unwinding.core_diameter)).group("ribbon.group.reel").label("ribbon.reel-core-diameter").help("ribbon.reel-core-diameter.help").symbol("d")
        .unit("mm").range(10.0..=5000.0).default(68.0).decimals(1).step(1.0).fact(),
    number("reel-core-inertia", member!(Params.unwinding.core_inertia)).group("ribbon.group.reel").label("ribbon.reel-core-inertia").help("ribbon.reel-core-inertia.help")
        .unit("kg cm²").range(0.0..=100000.0).default(20.0).decimals(2).step(1.0).fact(),
    number("reel-change", member!(Params.unwinding.reel_change)).group("ribbon.group.reel").label("ribbon.reel-change").help("ribbon.reel-change.help")
        .unit("s").range(0.0..=36000.0).default(180.0).decimals(0).step(30.0).fact(),
    number("loop-capacity", member!(Params.loop_capacity)).group("ribbon.group.reel").label("ribbon.loop-capacity").help("ribbon.loop-capacity.help")
        .unit("mm").range(0.0..=100000.0).default(500.0).decimals(1).step(10.0).fact(),
    flag("dancer", member!(Params.dancer)).group("ribbon.group.reel").label("ribbon.dancer").help("ribbon.dancer.help")
        .fact(),
    number("ribbon-thickness", member!(Params.ribbon_thickness)).group("ribbon.group.web").label("ribbon.ribbon-thickness").help("ribbon.ribbon-thickness.help")
        .unit("mm").range(0.001..=100.0).default(0.5).decimals(3).step(0.1).fact(),
    flag("effective-diameter", member!(Params.effective_diameter)).group("ribbon.group.web").label("ribbon.effective-diameter").help("ribbon.effective-diameter.help")
        .fact(),
    number("ribbon-width", member!(Params.ribbon_width)).group("ribbon.group.web").label("ribbon.ribbon-width").help("ribbon.ribbon-width.help")
        .unit("mm").range(0.1..=10000.0).default(20.0).decimals(2).step(1.0).fact(),
    number("youngs-modulus", member!(Params.youngs_modulus)).group("ribbon.group.web").label("ribbon.youngs-modulus").help("ribbon.youngs-modulus.help").symbol("E")
        .unit("N/mm²").range(0.1..=300000.0).default(20.0).decimals(2).step(10.0).fact(),
    number("tensile-strength", member!(Params.tensile_strength)).group("ribbon.group.web").label("ribbon.tensile-strength").help("ribbon.tensile-strength.help")
        .unit("N/mm²").range(0.1..=10000.0).default(15.0).decimals(2).step(1.0).fact(),
    number("web-density", member!(Params.web.density)).group("ribbon.group.web").label("ribbon.web-density").help("ribbon.web-density.help").symbol("ρ")
        .unit("kg/m³").range(1.0..=30000.0).default(1300.0).decimals(1).step(10.0).fact(),
    number("web-span", member!(Params.web.span)).group("ribbon.group.web").label("ribbon.web-span").help("ribbon.web-span.help").symbol("L")
        .unit("mm").range(1.0..=1000000.0).default(2000.0).decimals(1).step(100.0).fact(),
    number("tension-before", member!(Params.web.tension_before)).group("ribbon.group.web").label("ribbon.tension-before").help("ribbon.tension-before.help").symbol("T1")
        .unit("N").range(0.0..=100000.0).default(15.0).decimals(2).step(1.0).fact(),
    number("tension-behind", member!(Params.web.tension_behind)).group("ribbon.group.web").label("ribbon.tension-behind").help("ribbon.tension-behind.help").symbol("T2")
        .unit("N").range(0.0..=100000.0).default(0.0).decimals(2).step(1.0).fact(),
    choice("print-axis", member!(Params.print_axis: PrintAxis)).group("ribbon.group.print").label("ribbon.print-axis").help("ribbon.print-axis.help")
        .when(Params::has_print_axes),
    choice("y-unit", member!(Params.y_unit: YUnit)).group("ribbon.group.print").label("ribbon.y-unit").help("ribbon.y-unit.help")
        .when(Params::has_print_unit),
    number("contact-length", member!(Params.contact_length)).group("ribbon.group.print").label("ribbon.contact-length").help("ribbon.contact-length.help").symbol("c")
        .unit("mm").range(0.001..=1000.0).default(2.0).decimals(3).step(0.1).fact(),
    number("smear-limit", member!(Params.smear_limit)).group("ribbon.group.print").label("ribbon.smear-limit").help("ribbon.smear-limit.help")
        .unit("mm").range(0.001..=100.0).default(0.05).decimals(3).step(0.01),
    number("dot-tolerance", member!(Params.dot_tolerance)).group("ribbon.group.print").label("ribbon.dot-tolerance").help("ribbon.dot-tolerance.help")
        .unit("mm").range(0.001..=100.0).default(0.05).decimals(3).step(0.01),
    number("roller-run-out", member!(Params.roller_run_out)).group("ribbon.group.print").label("ribbon.roller-run-out").help("ribbon.roller-run-out.help")
        .unit("mm").range(0.0..=10.0).default(0.02).decimals(3).step(0.01).fact(),
    number("gear-backlash", member!(Params.gear_backlash)).group("ribbon.group.print").label("ribbon.gear-backlash").help("ribbon.gear-backlash.help").symbol("β")
        .unit("′").range(0.0..=600.0).default(3.0).decimals(2).step(1.0).fact(),
    choice("job", member!(Params.job: Job)).group("ribbon.group.job").label("ribbon.job").help("ribbon.job.help"),
    number("pitch-count", member!(Params.pitch_count)).group("ribbon.group.job").label("ribbon.pitch-count").help("ribbon.pitch-count.help").symbol("#120")
        .range(1.0..=10000000.0).default(500.0).decimals(0).step(1.0),
    number("product-length", member!(Params.product_length)).group("ribbon.group.job").label("ribbon.product-length").help("ribbon.product-length.help").symbol("#106")
        .unit("mm").range(0.01..=100000000.0).default(4000.0).decimals(3).step(10.0),
    choice("rest", member!(Params.rest: Rest)).group("ribbon.group.job").label("ribbon.rest").help("ribbon.rest.help")
        .when(Params::is_length),
    number("pitches-per-block", member!(Params.pitches_per_block)).group("ribbon.group.job").label("ribbon.pitches-per-block").help("ribbon.pitches-per-block.help").symbol("#121")
        .range(1.0..=1000.0).default(1.0).decimals(0).step(1.0),
    common::pause("ribbon.group.job", member!(Params.pause)),
    number("clamp-x", member!(Params.axes.pull.clamp)).group("ribbon.group.axes").label("ribbon.clamp-x").help("ribbon.clamp-x.help")
        .unit("mm/min").range(1.0..=10000000.0).default(20000.0).decimals(3).step(1000.0).fact().when(Params::has_clamp),
    number("clamp-y", member!(Params.axes.print.clamp)).group("ribbon.group.axes").label("ribbon.clamp-y").help("ribbon.clamp-y.help")
        .unit("mm/min").range(1.0..=10000000.0).default(150000.0).decimals(3).step(1000.0).fact().when(Params::has_clamp),
    number("rapid-x", member!(Params.axes.pull.rapid)).group("ribbon.group.axes").label("ribbon.rapid-x").help("ribbon.rapid-x.help")
        .unit("mm/min").range(1.0..=10000000.0).default(20000.0).decimals(3).step(1000.0).fact(),
    number("rapid-y", member!(Params.axes.print.rapid)).group("ribbon.group.axes").label("ribbon.rapid-y").help("ribbon.rapid-y.help")
        .unit("mm/min").range(1.0..=10000000.0).default(150000.0).decimals(3).step(1000.0).fact(),
    number("time-constant-x", member!(Params.axes.pull.time_constant)).group("ribbon.group.axes").label("ribbon.time-constant-x").help("ribbon.time-constant-x.help")
        .unit("ms").range(0.0..=5000.0).default(100.0).decimals(1).step(10.0).setting(),
    number("time-constant-y", member!(Params.axes.print.time_constant)).group("ribbon.group.axes").label("ribbon.time-constant-y").help("ribbon.time-constant-y.help")
        .unit("ms").range(0.0..=5000.0).default(100.0).decimals(1).step(10.0).setting(),
    number("position-gain-x", member!(Params.axes.pull.position_gain)).group("ribbon.group.axes").label("ribbon.position-gain-x").help("ribbon.position-gain-x.help")
        .unit("1/s").range(1.0..=1000.0).default(33.0).decimals(2).step(1.0).setting(),
    number("position-gain-y", member!(Params.axes.print.position_gain)).group("ribbon.group.axes").label("ribbon.position-gain-y").help("ribbon.position-gain-y.help")
        .unit("1/s").range(1.0..=1000.0).default(33.0).decimals(2).step(1.0).setting(),
    number("in-position", member!(Params.in_position)).group("ribbon.group.axes").label("ribbon.in-position").help("ribbon.in-position.help")
        .unit("mm").range(0.001..=10.0).default(0.02).decimals(3).step(0.01).setting(),
    choice("endless", member!(Params.endless: Endless)).group("ribbon.group.axes").label("ribbon.endless").help("ribbon.endless.help"),
    number("unwinder-friction", member!(Params.unwinding.friction)).group("ribbon.group.unwinder-drive").label("ribbon.unwinder-friction").help("ribbon.unwinder-friction.help")
        .unit("Nm").range(0.0..=10000.0).default(1.0).decimals(3).step(0.1).fact(),
    number("unwinder-efficiency", member!(Params.unwinding.efficiency)).group("ribbon.group.unwinder-drive").label("ribbon.unwinder-efficiency").help("ribbon.unwinder-efficiency.help").symbol("η")
        .unit("%").range(1.0..=100.0).default(70.0).decimals(1).step(1.0).fact(),
    number("unwinder-inertia", member!(Params.unwinding.inertia)).group("ribbon.group.unwinder-drive").label("ribbon.unwinder-inertia").help("ribbon.unwinder-inertia.help").symbol("J")
        .unit("kg cm²").range(0.01..=1000000.0).default(40.0).decimals(2).step(1.0).fact(),
    text("unwinder-motor", member!(&Params.unwinding.motor)).group("ribbon.group.unwinder-drive").label("ribbon.unwinder-motor").help("ribbon.unwinder-motor.help").characters(40),
    number("unwinder-torque-rated", member!(Params.unwinding.torque)).group("ribbon.group.unwinder-drive").label("ribbon.unwinder-torque-rated").help("ribbon.unwinder-torque-rated.help")
        .unit("Nm").range(0.001..=100000.0).default(5.0).decimals(3).step(0.1).fact(),
    site::share("unwinder-site-share", "ribbon.group.unwinder-drive", member!(Params.unwinding.site_share)),
    flag("unwinder-forced-cooling", member!(Params.unwinding.forced_cooling)).group("ribbon.group.unwinder-drive").label("ribbon.unwinder-forced-cooling").help("ribbon.unwinder-forced-cooling.help")
        .fact(),
    number("unwinder-motor-braking", member!(Params.unwinding.motor_braking)).group("ribbon.group.unwinder-drive").label("ribbon.unwinder-motor-braking").help("ribbon.unwinder-motor-braking.help")
        .unit("%").range(1.0..=150.0).default(20.0).decimals(0).step(10.0).fact(),
    number("unwinder-motor-brake", member!(Params.unwinding.motor_brake)).group("ribbon.group.unwinder-drive").label("ribbon.unwinder-motor-brake").help("ribbon.unwinder-motor-brake.help")
        .unit("Nm").range(0.0..=100000.0).default(0.0).decimals(2).step(0.1).fact(),
    number("x-roller-diameter", member!(Params.x_roller_diameter)).group("ribbon.group.pull-drive").label("ribbon.x-roller-diameter").help("ribbon.x-roller-diameter.help")
        .unit("mm").range(1.0..=5000.0).default(100.0).decimals(4).step(1.0).fact(),
    number("x-roller-wall", member!(Params.axes.pull.wall)).group("ribbon.group.pull-drive").label("ribbon.x-roller-wall").help("ribbon.x-roller-wall.help")
        .unit("mm").range(0.1..=2500.0).default(10.0).decimals(2).step(1.0).fact(),
    number("x-roller-length", member!(Params.axes.pull.length)).group("ribbon.group.pull-drive").label("ribbon.x-roller-length").help("ribbon.x-roller-length.help")
        .unit("mm").range(1.0..=10000.0).default(200.0).decimals(1).step(10.0).fact(),
    number("pinch-mass", member!(Params.pinch.mass)).group("ribbon.group.pull-drive").label("ribbon.pinch-mass").help("ribbon.pinch-mass.help")
        .unit("kg").range(0.0..=10000.0).default(3.0).decimals(3).step(0.1).fact(),
    number("pinch-diameter", member!(Params.pinch.diameter)).group("ribbon.group.pull-drive").label("ribbon.pinch-diameter").help("ribbon.pinch-diameter.help")
        .unit("mm").range(1.0..=5000.0).default(80.0).decimals(2).step(1.0).fact(),
    number("pinch-force", member!(Params.pinch.force)).group("ribbon.group.pull-drive").label("ribbon.pinch-force").help("ribbon.pinch-force.help").symbol("N")
        .unit("N").range(0.1..=1000000.0).default(100.0).decimals(1).step(10.0).fact(),
    number("pinch-friction", member!(Params.pinch.friction)).group("ribbon.group.pull-drive").label("ribbon.pinch-friction").help("ribbon.pinch-friction.help").symbol("μ")
        .range(0.01..=2.0).default(0.4).decimals(2).step(0.05).fact(),
    number("friction-x", member!(Params.axes.pull.friction)).group("ribbon.group.pull-drive").label("ribbon.friction-x").help("ribbon.friction-x.help")
        .unit("Nm").range(0.0..=10000.0).default(0.3).decimals(3).step(0.1).fact(),
    number("gear-x", member!(Params.axes.pull.gear)).group("ribbon.group.pull-drive").label("ribbon.gear-x").help("ribbon.gear-x.help")
        .unit(": 1").range(0.1..=10000.0).default(10.0).decimals(6).step(1.0).fact(),
    number("efficiency-x", member!(Params.axes.pull.efficiency)).group("ribbon.group.pull-drive").label("ribbon.efficiency-x").help("ribbon.efficiency-x.help").symbol("η")
        .unit("%").range(1.0..=100.0).default(95.0).decimals(1).step(1.0).fact(),
    number("gear-inertia-x", member!(Params.axes.pull.gear_inertia)).group("ribbon.group.pull-drive").label("ribbon.gear-inertia-x").help("ribbon.gear-inertia-x.help")
        .unit("kg cm²").range(0.0..=100000.0).default(0.6).decimals(4).step(0.1).fact(),
    text("motor-x", member!(&Params.axes.pull.motor.name)).group("ribbon.group.pull-drive").label("ribbon.motor-x").help("ribbon.motor-x.help").characters(40),
    number("motor-rated-torque-x", member!(Params.axes.pull.motor.rated)).group("ribbon.group.pull-drive").label("ribbon.motor-rated-torque-x").help("ribbon.motor-rated-torque-x.help")
        .unit("Nm").range(0.001..=10000.0).default(1.3).decimals(3).step(0.1).fact(),
    number("motor-stall-x", member!(Params.axes.pull.motor.stall)).group("ribbon.group.pull-drive").label("ribbon.motor-stall-x").help("ribbon.motor-stall-x.help")
        .unit("Nm").range(0.001..=10000.0).default(1.3).decimals(3).step(0.1).fact(),
    number("motor-peak-x", member!(Params.axes.pull.motor.peak)).group("ribbon.group.pull-drive").label("ribbon.motor-peak-x").help("ribbon.motor-peak-x.help")
        .unit("Nm").range(0.001..=10000.0).default(3.8).decimals(3).step(0.1).fact(),
    number("motor-rotor-x", member!(Params.axes.pull.motor.rotor)).group("ribbon.group.pull-drive").label("ribbon.motor-rotor-x").help("ribbon.motor-rotor-x.help")
        .unit("kg cm²").range(0.001..=100000.0).default(0.375).decimals(4).step(0.1).fact(),
    number("motor-rated-x", member!(Params.axes.pull.motor.rated_speed)).group("ribbon.group.pull-drive").label("ribbon.motor-rated-x").help("ribbon.motor-rated-x.help")
        .unit("r/min").range(1.0..=100000.0).default(3000.0).decimals(1).step(100.0).fact(),
    number("motor-max-x", member!(Params.axes.pull.motor.top_speed)).group("ribbon.group.pull-drive").label("ribbon.motor-max-x").help("ribbon.motor-max-x.help")
        .unit("r/min").range(1.0..=100000.0).default(5000.0).decimals(1).step(100.0).fact(),
    number("encoder-resolution-x", member!(Params.axes.pull.encoder)).group("ribbon.group.pull-drive").label("ribbon.encoder-resolution-x").help("ribbon.encoder-resolution-x.help")
        .unit("p/rev").range(1.0..=100000000.0).default(100000.0).decimals(0).step(1000.0).fact(),
    number("inertia-limit-x", member!(Params.axes.pull.motor.inertia_limit)).group("ribbon.group.pull-drive").label("ribbon.inertia-limit-x").help("ribbon.inertia-limit-x.help")
        .unit(": 1").range(0.1..=1000.0).default(15.0).decimals(1).step(1.0).setting(),
    number("effective-limit-x", member!(Params.axes.pull.motor.effective_limit)).group("ribbon.group.pull-drive").label("ribbon.effective-limit-x").help("ribbon.effective-limit-x.help")
        .unit("%").range(1.0..=100.0).default(80.0).decimals(1).step(1.0).setting(),
    number("print-roller-wall", member!(Params.axes.print.wall)).group("ribbon.group.print-drive").label("ribbon.print-roller-wall").help("ribbon.print-roller-wall.help")
        .unit("mm").range(0.1..=2500.0).default(10.0).decimals(2).step(1.0).fact(),
    number("print-roller-length", member!(Params.axes.print.length)).group("ribbon.group.print-drive").label("ribbon.print-roller-length").help("ribbon.print-roller-length.help")
        .unit("mm").range(1.0..=10000.0).default(150.0).decimals(1).step(10.0).fact(),
    number("head-mass", member!(Params.head.mass)).group("ribbon.group.print-drive").label("ribbon.head-mass").help("ribbon.head-mass.help")
        .unit("kg").range(0.0..=1000.0).default(0.15).decimals(4).step(0.01).fact(),
    number("head-length", member!(Params.head.length)).group("ribbon.group.print-drive").label("ribbon.head-length").help("ribbon.head-length.help").symbol("l")
        .unit("mm").range(0.001..=1000.0).default(3.0).decimals(3).step(0.1).fact(),
    number("printing-force", member!(Params.head.force)).group("ribbon.group.print-drive").label("ribbon.printing-force").help("ribbon.printing-force.help")
        .unit("N").range(0.0..=100000.0).default(5.0).decimals(2).step(1.0).fact(),
    number("friction-y", member!(Params.axes.print.friction)).group("ribbon.group.print-drive").label("ribbon.friction-y").help("ribbon.friction-y.help")
        .unit("Nm").range(0.0..=10000.0).default(0.4).decimals(3).step(0.1).fact(),
    number("gear-y", member!(Params.axes.print.gear)).group("ribbon.group.print-drive").label("ribbon.gear-y").help("ribbon.gear-y.help")
        .unit(": 1").range(0.1..=10000.0).default(5.0).decimals(6).step(1.0).fact(),
    number("efficiency-y", member!(Params.axes.print.efficiency)).group("ribbon.group.print-drive").label("ribbon.efficiency-y").help("ribbon.efficiency-y.help").symbol("η")
        .unit("%").range(1.0..=100.0).default(95.0).decimals(1).step(1.0).fact(),
    number("gear-inertia-y", member!(Params.axes.print.gear_inertia)).group("ribbon.group.print-drive").label("ribbon.gear-inertia-y").help("ribbon.gear-inertia-y.help")
        .unit("kg cm²").range(0.0..=100000.0).default(0.6).decimals(4).step(0.1).fact(),
    text("motor-y", member!(&Params.axes.print.motor.name)).group("ribbon.group.print-drive").label("ribbon.motor-y").help("ribbon.motor-y.help").characters(40),
    number("motor-rated-torque-y", member!(Params.axes.print.motor.rated)).group("ribbon.group.print-drive").label("ribbon.motor-rated-torque-y").help("ribbon.motor-rated-torque-y.help")
        .unit("Nm").range(0.001..=10000.0).default(1.59).decimals(3).step(0.1).fact(),
    number("motor-stall-y", member!(Params.axes.print.motor.stall)).group("ribbon.group.print-drive").label("ribbon.motor-stall-y").help("ribbon.motor-stall-y.help")
        .unit("Nm").range(0.001..=10000.0).default(2.94).decimals(3).step(0.1).fact(),
    number("motor-peak-y", member!(Params.axes.print.motor.peak)).group("ribbon.group.print-drive").label("ribbon.motor-peak-y").help("ribbon.motor-peak-y.help")
        .unit("Nm").range(0.001..=10000.0).default(8.82).decimals(3).step(0.1).fact(),
    number("motor-rotor-y", member!(Params.axes.print.motor.rotor)).group("ribbon.group.print-drive").label("ribbon.motor-rotor-y").help("ribbon.motor-rotor-y.help")
        .unit("kg cm²").range(0.001..=100000.0).default(6.6).decimals(4).step(0.1).fact(),
    number("motor-rated-y", member!(Params.axes.print.motor.rated_speed)).group("ribbon.group.print-drive").label("ribbon.motor-rated-y").help("ribbon.motor-rated-y.help")
        .unit("r/min").range(1.0..=100000.0).default(3000.0).decimals(1).step(100.0).fact(),
    number("motor-max-y", member!(Params.axes.print.motor.top_speed)).group("ribbon.group.print-drive").label("ribbon.motor-max-y").help("ribbon.motor-max-y.help")
        .unit("r/min").range(1.0..=100000.0).default(3000.0).decimals(1).step(100.0).fact(),
    number("encoder-resolution-y", member!(Params.axes.print.encoder)).group("ribbon.group.print-drive").label("ribbon.encoder-resolution-y").help("ribbon.encoder-resolution-y.help")
        .unit("p/rev").range(1.0..=100000000.0).default(100000.0).decimals(0).step(1000.0).fact(),
    number("inertia-limit-y", member!(Params.axes.print.motor.inertia_limit)).group("ribbon.group.print-drive").label("ribbon.inertia-limit-y").help("ribbon.inertia-limit-y.help")
        .unit(": 1").range(0.1..=1000.0).default(5.0).decimals(1).step(1.0).setting(),
    number("effective-limit-y", member!(Params.axes.print.motor.effective_limit)).group("ribbon.group.print-drive").label("ribbon.effective-limit-y").help("ribbon.effective-limit-y.help")
        .unit("%").range(1.0..=100.0).default(80.0).decimals(1).step(1.0).setting(),
    choice("cam-law", member!(Params.cam_law: CamLaw)).group("ribbon.group.print-drive").label("ribbon.cam-law").help("ribbon.cam-law.help"),
    number("site-height", member!(Params.site_height)).group("ribbon.group.site").label("ribbon.site-height").help("ribbon.site-height.help")
        .unit("m").range(0.0..=5000.0).default(500.0).decimals(0).step(100.0).fact(),
    number("site-temperature", member!(Params.site_temperature)).group("ribbon.group.site").label("ribbon.site-temperature").help("ribbon.site-temperature.help")
        .unit("°C").range(0.0..=50.0).default(40.0).decimals(1).step(1.0).fact(),
    number("feed-limit", member!(Params.feed_limit)).group("ribbon.group.control").label("ribbon.feed-limit").help("ribbon.feed-limit.help").symbol("#119")
        .unit("mm/min").range(1.0..=10000000.0).default(1000000.0).decimals(3).step(1000.0).fact(),
    common::block_time("ribbon.group.control", 7.1, member!(Params.block_time)),
    common::macro_time("ribbon.group.control", 3.0, member!(Params.macro_time)).range(0.0..=1000.0),
    common::preread("ribbon.group.control", 5.0, member!(Params.preread)),
    choice("variant", member!(Params.variant: Variant)).group("ribbon.group.program").label("ribbon.variant").help("ribbon.variant.help"),
    choice("pi", member!(Params.pi: PiForm)).group("ribbon.group.program").label("ribbon.pi").help("ribbon.pi.help"),
    choice("feed-form", member!(Params.feed_form: FeedForm)).group("ribbon.group.program").label("ribbon.feed-form").help("ribbon.feed-form.help").symbol("F"),
    choice("wait", member!(Params.wait: Wait)).group("ribbon.group.program").label("ribbon.wait").help("ribbon.wait.help"),
    number("dwell", member!(Params.dwell)).group("ribbon.group.program").label("ribbon.dwell").help("ribbon.dwell.help")
        .unit("s").range(0.0..=600.0).default(2.0).decimals(3).step(0.1),
    choice("path-mode", member!(Params.path_mode: PathMode)).group("ribbon.group.program").label("ribbon.path-mode").help("ribbon.path-mode.help")
        .when(Params::stops_exactly),
    common::newline("ribbon.group.program", member!(Params.newline: LineEnds)),
    common::customer("ribbon.group.program", member!(&Params.customer)),
    common::product("ribbon.group.program", member!(&Params.product)),
];
