//! The form of the ribbon line: every input with unit, range and default, and the parameters that it fills.

use super::resolved;
use crate::machines::form::Field;
use crate::machines::form::rows::{Newline, choice, essential, fact, flag, number, one_of, setting, words};

choice! {
    /// How the override reaches the program.
    OverrideForm {
        /// In percent: speed = S · override / 100, clamped by the program.
        Percent,
        /// As the spindle's speed after override and clamp, in r/min.
        FinalSpeed,
    }
}

choice! {
    /// Steps of the override knob.
    KnobStep {
        /// 1 %.
        One,
        /// 5 %.
        Five,
        /// 10 %.
        Ten,
    }
}

choice! {
    /// The axis of the print roller.
    PrintAxis {
        /// Y.
        Y,
        /// C, in degrees.
        C,
        /// Z, in millimetres.
        Z,
    }
}

choice! {
    /// What F counts.
    FeedForm {
        /// mm/min.
        PerMinute,
        /// mm per revolution of the unwinder's motor.
        PerRevolution,
    }
}

choice! {
    /// Unit of the print roller's axis.
    YUnit {
        /// Circumference in millimetres.
        Millimetres,
        /// Degrees of the print roller.
        Degrees,
    }
}

choice! {
    /// What ends a product.
    Job {
        /// A number of pitches.
        Pitches,
        /// A length of ribbon.
        Length,
    }
}

choice! {
    /// π in the program.
    PiForm {
        /// 3.141592654.
        Exact,
        /// 3.14, as published.
        Short,
    }
}

choice! {
    /// How the program waits for the spindle before the ribbon is pulled.
    Wait {
        /// A dwell behind M3.
        Dwell,
        /// The PLC answers M3 when the spindle has its speed.
        Fin,
    }
}

choice! {
    /// How blocks join.
    PathMode {
        /// Cutting mode, G64.
        Continuous,
        /// Exact stop, G61.
        ExactStop,
    }
}

choice! {
    /// Which program is written.
    Variant {
        /// The ready-made one.
        ReadyMade,
        /// The paper's listing with its numbers, corrected.
        Published,
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

    /// Its address letter.
    pub fn letter(self) -> u8 {
        match self {
            PrintAxis::Y => b'Y',
            PrintAxis::C => b'C',
            PrintAxis::Z => b'Z',
        }
    }
}

impl KnobStep {
    /// Percent per step.
    pub fn percent(self) -> f64 {
        match self {
            KnobStep::One => 1.0,
            KnobStep::Five => 5.0,
            KnobStep::Ten => 10.0,
        }
    }
}

/// Inputs of the ribbon line, within the ranges of [`FIELDS`]. Units as in the form.
#[derive(Debug, Clone, PartialEq, Default)]
#[allow(missing_docs)] // One row of FIELDS documents each member: label, unit, range, help.
pub struct Params {
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
    pub manual_speed: f64,
    pub frequency_at_10v: f64,
    pub inverter_ramp: f64,
    pub no_load_speed: f64,
    pub rated_load_speed: f64,
    pub unwinder_load: f64,
    pub dancer: bool,
    pub spindle_encoder: bool,
    pub loop_capacity: f64,
    pub ribbon_thickness: f64,
    pub effective_diameter: bool,
    pub ribbon_width: f64,
    pub youngs_modulus: f64,
    pub tensile_strength: f64,
    pub print_axis: PrintAxis,
    pub y_unit: YUnit,
    pub contact_length: f64,
    pub smear_limit: f64,
    pub dot_tolerance: f64,
    pub job: Job,
    pub pitch_count: f64,
    pub product_length: f64,
    pub pitches_per_block: f64,
    pub clamp_x: f64,
    pub clamp_y: f64,
    pub rapid_x: f64,
    pub rapid_y: f64,
    pub time_constant_x: f64,
    pub time_constant_y: f64,
    pub position_gain_x: f64,
    pub position_gain_y: f64,
    pub in_position: f64,
    pub gear_x: f64,
    pub gear_y: f64,
    pub x_roller_diameter: f64,
    pub motor_rated_x: f64,
    pub motor_max_x: f64,
    pub motor_rated_y: f64,
    pub motor_max_y: f64,
    pub encoder_resolution: f64,
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
    pub newline: Newline,
    pub customer: String,
    pub product: String,
}

/// Every input, in the order of the form.
pub static FIELDS: &[Field<Params>] = &[
    essential!("spindle-speed", "ribbon.group.unwinder", "ribbon.spindle-speed", "ribbon.spindle-speed.help", "#100", fact false, number!(spindle_speed, "r/min", 1.0..30000.0, 1200.0, 0, 10.0)),
    essential!("reduction-ratio", "ribbon.group.unwinder", "ribbon.reduction-ratio", "ribbon.reduction-ratio.help", "#101", fact true, number!(reduction_ratio, ": 1", 0.001..10000.0, 25.0, 6, 1.0)),
    essential!("press-roller-diameter", "ribbon.group.unwinder", "ribbon.press-roller-diameter", "ribbon.press-roller-diameter.help", "#102", fact true, number!(press_roller_diameter, "mm", 1.0..5000.0, 100.0, 4, 1.0)),
    essential!("pitch", "ribbon.group.web", "ribbon.pitch", "ribbon.pitch.help", "#107", fact false, number!(pitch, "mm", 0.01..10000.0, 8.0, 3, 0.1)),
    essential!("heads", "ribbon.group.print", "ribbon.heads", "ribbon.heads.help", "#109", fact true, number!(heads, "", 1.0..1000.0, 6.0, 0, 1.0)),
    essential!("print-roller-diameter", "ribbon.group.print", "ribbon.print-roller-diameter", "ribbon.print-roller-diameter.help", "#111", fact true, number!(print_roller_diameter, "mm", 1.0..5000.0, 120.0, 4, 1.0)),
    fact!(
        "speed-at-10v",
        "ribbon.group.unwinder",
        "ribbon.speed-at-10v",
        "ribbon.speed-at-10v.help",
        "n10",
        number!(speed_at_10v, "r/min", 1.0..60000.0, 1480.0, 3, 10.0)
    ),
    fact!(
        "speed-clamp",
        "ribbon.group.unwinder",
        "ribbon.speed-clamp",
        "ribbon.speed-clamp.help",
        "#116",
        number!(speed_clamp, "r/min", 1.0..60000.0, 1480.0, 3, 10.0)
    ),
    setting!(
        "override",
        "ribbon.group.unwinder",
        "ribbon.override",
        "ribbon.override.help",
        "",
        number!(override_percent, "%", 0.0..200.0, 100.0, 0, 1.0)
    ),
    setting!(
        "override-form",
        "ribbon.group.unwinder",
        "ribbon.override-form",
        "ribbon.override-form.help",
        "",
        when resolved::tells_final_speed,
        one_of!(override_form: OverrideForm, "percent" "ribbon.override-form.percent", "final-speed" "ribbon.override-form.final-speed")
    ),
    setting!(
        "knob-step",
        "ribbon.group.unwinder",
        "ribbon.knob-step",
        "ribbon.knob-step.help",
        "",
        one_of!(knob_step: KnobStep, "1" "ribbon.knob-step.1", "5" "ribbon.knob-step.5", "10" "ribbon.knob-step.10")
    ),
    setting!(
        "manual-speed",
        "ribbon.group.unwinder",
        "ribbon.manual-speed",
        "ribbon.manual-speed.help",
        "S",
        number!(manual_speed, "r/min", 0.0..30000.0, 100.0, 0, 10.0)
    ),
    fact!(
        "frequency-at-10v",
        "ribbon.group.unwinder",
        "ribbon.frequency-at-10v",
        "ribbon.frequency-at-10v.help",
        "",
        number!(frequency_at_10v, "Hz", 1.0..1000.0, 50.0, 2, 1.0)
    ),
    fact!(
        "inverter-ramp",
        "ribbon.group.unwinder",
        "ribbon.inverter-ramp",
        "ribbon.inverter-ramp.help",
        "",
        number!(inverter_ramp, "s", 0.0..600.0, 2.0, 3, 0.1)
    ),
    fact!(
        "no-load-speed",
        "ribbon.group.unwinder",
        "ribbon.no-load-speed",
        "ribbon.no-load-speed.help",
        "",
        number!(no_load_speed, "r/min", 1.0..60000.0, 1500.0, 3, 1.0)
    ),
    fact!(
        "rated-load-speed",
        "ribbon.group.unwinder",
        "ribbon.rated-load-speed",
        "ribbon.rated-load-speed.help",
        "",
        number!(rated_load_speed, "r/min", 1.0..60000.0, 1430.0, 3, 1.0)
    ),
    fact!(
        "unwinder-load",
        "ribbon.group.unwinder",
        "ribbon.unwinder-load",
        "ribbon.unwinder-load.help",
        "",
        number!(unwinder_load, "%", 0.0..200.0, 2.286, 3, 1.0)
    ),
    fact!(
        "spindle-encoder",
        "ribbon.group.unwinder",
        "ribbon.spindle-encoder",
        "ribbon.spindle-encoder.help",
        "",
        flag!(spindle_encoder)
    ),
    fact!("dancer", "ribbon.group.unwinder", "ribbon.dancer", "ribbon.dancer.help", "", flag!(dancer)),
    fact!(
        "loop-capacity",
        "ribbon.group.unwinder",
        "ribbon.loop-capacity",
        "ribbon.loop-capacity.help",
        "",
        number!(loop_capacity, "mm", 0.0..100000.0, 500.0, 1, 10.0)
    ),
    fact!(
        "ribbon-thickness",
        "ribbon.group.web",
        "ribbon.ribbon-thickness",
        "ribbon.ribbon-thickness.help",
        "",
        number!(ribbon_thickness, "mm", 0.001..100.0, 0.5, 3, 0.1)
    ),
    fact!(
        "effective-diameter",
        "ribbon.group.web",
        "ribbon.effective-diameter",
        "ribbon.effective-diameter.help",
        "",
        flag!(effective_diameter)
    ),
    fact!(
        "ribbon-width",
        "ribbon.group.web",
        "ribbon.ribbon-width",
        "ribbon.ribbon-width.help",
        "",
        number!(ribbon_width, "mm", 0.1..10000.0, 20.0, 2, 1.0)
    ),
    fact!(
        "youngs-modulus",
        "ribbon.group.web",
        "ribbon.youngs-modulus",
        "ribbon.youngs-modulus.help",
        "E",
        number!(youngs_modulus, "N/mm²", 0.1..300000.0, 20.0, 2, 10.0)
    ),
    fact!(
        "tensile-strength",
        "ribbon.group.web",
        "ribbon.tensile-strength",
        "ribbon.tensile-strength.help",
        "",
        number!(tensile_strength, "N/mm²", 0.1..10000.0, 15.0, 2, 1.0)
    ),
    setting!(
        "print-axis",
        "ribbon.group.print",
        "ribbon.print-axis",
        "ribbon.print-axis.help",
        "",
        when resolved::has_print_axes,
        one_of!(print_axis: PrintAxis, "y" "ribbon.print-axis.y", "c" "ribbon.print-axis.c", "z" "ribbon.print-axis.z")
    ),
    setting!(
        "y-unit",
        "ribbon.group.print",
        "ribbon.y-unit",
        "ribbon.y-unit.help",
        "",
        when resolved::has_print_unit,
        one_of!(y_unit: YUnit, "mm" "ribbon.y-unit.mm", "degrees" "ribbon.y-unit.degrees")
    ),
    fact!(
        "contact-length",
        "ribbon.group.print",
        "ribbon.contact-length",
        "ribbon.contact-length.help",
        "c",
        number!(contact_length, "mm", 0.001..1000.0, 2.0, 3, 0.1)
    ),
    setting!(
        "smear-limit",
        "ribbon.group.print",
        "ribbon.smear-limit",
        "ribbon.smear-limit.help",
        "",
        number!(smear_limit, "mm", 0.001..100.0, 0.05, 3, 0.01)
    ),
    setting!(
        "dot-tolerance",
        "ribbon.group.print",
        "ribbon.dot-tolerance",
        "ribbon.dot-tolerance.help",
        "",
        number!(dot_tolerance, "mm", 0.001..100.0, 0.05, 3, 0.01)
    ),
    setting!(
        "job",
        "ribbon.group.job",
        "ribbon.job",
        "ribbon.job.help",
        "",
        one_of!(job: Job, "pitch-count" "ribbon.job.pitch-count", "product-length" "ribbon.job.product-length")
    ),
    setting!(
        "pitch-count",
        "ribbon.group.job",
        "ribbon.pitch-count",
        "ribbon.pitch-count.help",
        "#120",
        number!(pitch_count, "", 1.0..10000000.0, 500.0, 0, 1.0)
    ),
    setting!(
        "product-length",
        "ribbon.group.job",
        "ribbon.product-length",
        "ribbon.product-length.help",
        "",
        number!(product_length, "mm", 0.01..100000000.0, 4000.0, 3, 10.0)
    ),
    setting!(
        "pitches-per-block",
        "ribbon.group.job",
        "ribbon.pitches-per-block",
        "ribbon.pitches-per-block.help",
        "#121",
        number!(pitches_per_block, "", 1.0..1000.0, 1.0, 0, 1.0)
    ),
    fact!(
        "clamp-x",
        "ribbon.group.axes",
        "ribbon.clamp-x",
        "ribbon.clamp-x.help",
        "",
        number!(clamp_x, "mm/min", 1.0..10000000.0, 20000.0, 3, 1000.0)
    ),
    fact!(
        "clamp-y",
        "ribbon.group.axes",
        "ribbon.clamp-y",
        "ribbon.clamp-y.help",
        "",
        number!(clamp_y, "mm/min", 1.0..10000000.0, 150000.0, 3, 1000.0)
    ),
    fact!(
        "rapid-x",
        "ribbon.group.axes",
        "ribbon.rapid-x",
        "ribbon.rapid-x.help",
        "",
        number!(rapid_x, "mm/min", 1.0..10000000.0, 20000.0, 3, 1000.0)
    ),
    fact!(
        "rapid-y",
        "ribbon.group.axes",
        "ribbon.rapid-y",
        "ribbon.rapid-y.help",
        "",
        number!(rapid_y, "mm/min", 1.0..10000000.0, 150000.0, 3, 1000.0)
    ),
    fact!(
        "time-constant-x",
        "ribbon.group.axes",
        "ribbon.time-constant-x",
        "ribbon.time-constant-x.help",
        "",
        number!(time_constant_x, "ms", 0.0..5000.0, 100.0, 1, 10.0)
    ),
    fact!(
        "time-constant-y",
        "ribbon.group.axes",
        "ribbon.time-constant-y",
        "ribbon.time-constant-y.help",
        "",
        number!(time_constant_y, "ms", 0.0..5000.0, 100.0, 1, 10.0)
    ),
    fact!(
        "position-gain-x",
        "ribbon.group.axes",
        "ribbon.position-gain-x",
        "ribbon.position-gain-x.help",
        "",
        number!(position_gain_x, "1/s", 1.0..1000.0, 33.0, 2, 1.0)
    ),
    fact!(
        "position-gain-y",
        "ribbon.group.axes",
        "ribbon.position-gain-y",
        "ribbon.position-gain-y.help",
        "",
        number!(position_gain_y, "1/s", 1.0..1000.0, 33.0, 2, 1.0)
    ),
    fact!(
        "in-position",
        "ribbon.group.axes",
        "ribbon.in-position",
        "ribbon.in-position.help",
        "",
        number!(in_position, "mm", 0.001..10.0, 0.02, 3, 0.01)
    ),
    fact!(
        "x-roller-diameter",
        "ribbon.group.axes",
        "ribbon.x-roller-diameter",
        "ribbon.x-roller-diameter.help",
        "",
        number!(x_roller_diameter, "mm", 1.0..5000.0, 100.0, 4, 1.0)
    ),
    fact!(
        "gear-x",
        "ribbon.group.axes",
        "ribbon.gear-x",
        "ribbon.gear-x.help",
        "",
        number!(gear_x, ": 1", 0.001..10000.0, 10.0, 6, 1.0)
    ),
    fact!(
        "gear-y",
        "ribbon.group.axes",
        "ribbon.gear-y",
        "ribbon.gear-y.help",
        "",
        number!(gear_y, ": 1", 0.001..10000.0, 5.0, 6, 1.0)
    ),
    fact!(
        "motor-rated-x",
        "ribbon.group.axes",
        "ribbon.motor-rated-x",
        "ribbon.motor-rated-x.help",
        "",
        number!(motor_rated_x, "r/min", 1.0..100000.0, 3000.0, 1, 100.0)
    ),
    fact!(
        "motor-max-x",
        "ribbon.group.axes",
        "ribbon.motor-max-x",
        "ribbon.motor-max-x.help",
        "",
        number!(motor_max_x, "r/min", 1.0..100000.0, 5000.0, 1, 100.0)
    ),
    fact!(
        "motor-rated-y",
        "ribbon.group.axes",
        "ribbon.motor-rated-y",
        "ribbon.motor-rated-y.help",
        "",
        number!(motor_rated_y, "r/min", 1.0..100000.0, 3000.0, 1, 100.0)
    ),
    fact!(
        "motor-max-y",
        "ribbon.group.axes",
        "ribbon.motor-max-y",
        "ribbon.motor-max-y.help",
        "",
        number!(motor_max_y, "r/min", 1.0..100000.0, 3000.0, 1, 100.0)
    ),
    fact!(
        "encoder-resolution",
        "ribbon.group.axes",
        "ribbon.encoder-resolution",
        "ribbon.encoder-resolution.help",
        "",
        number!(encoder_resolution, "p/rev", 1.0..100000000.0, 100000.0, 0, 1000.0)
    ),
    fact!(
        "feed-limit",
        "ribbon.group.control",
        "ribbon.feed-limit",
        "ribbon.feed-limit.help",
        "#119",
        number!(feed_limit, "mm/min", 1.0..10000000.0, 1000000.0, 3, 1000.0)
    ),
    fact!(
        "block-time",
        "ribbon.group.control",
        "form.block-time",
        "form.block-time.help",
        "",
        number!(block_time, "ms", 0.1..1000.0, 7.1, 3, 0.1)
    ),
    fact!(
        "macro-time",
        "ribbon.group.control",
        "form.macro-time",
        "form.macro-time.help",
        "",
        number!(macro_time, "ms", 0.0..1000.0, 3.0, 3, 0.1)
    ),
    fact!(
        "preread",
        "ribbon.group.control",
        "form.preread",
        "form.preread.help",
        "",
        number!(preread, "", 1.0..100.0, 5.0, 0, 1.0)
    ),
    setting!(
        "variant",
        "ribbon.group.program",
        "ribbon.variant",
        "ribbon.variant.help",
        "",
        one_of!(variant: Variant, "ready-made" "ribbon.variant.ready-made", "published" "ribbon.variant.published")
    ),
    setting!(
        "pi",
        "ribbon.group.program",
        "ribbon.pi",
        "ribbon.pi.help",
        "",
        one_of!(pi: PiForm, "exact" "ribbon.pi.exact", "3.14" "ribbon.pi.short")
    ),
    setting!(
        "feed-form",
        "ribbon.group.program",
        "ribbon.feed-form",
        "ribbon.feed-form.help",
        "F",
        one_of!(feed_form: FeedForm, "per-minute" "ribbon.feed-form.per-minute", "per-revolution" "ribbon.feed-form.per-revolution")
    ),
    setting!(
        "wait",
        "ribbon.group.program",
        "ribbon.wait",
        "ribbon.wait.help",
        "",
        one_of!(wait: Wait, "dwell" "ribbon.wait.dwell", "fin" "ribbon.wait.fin")
    ),
    setting!(
        "dwell",
        "ribbon.group.program",
        "ribbon.dwell",
        "ribbon.dwell.help",
        "",
        number!(dwell, "s", 0.0..600.0, 2.0, 3, 0.1)
    ),
    setting!(
        "path-mode",
        "ribbon.group.program",
        "ribbon.path-mode",
        "ribbon.path-mode.help",
        "",
        when resolved::stops_exactly,
        one_of!(path_mode: PathMode, "continuous" "ribbon.path-mode.continuous", "exact-stop" "ribbon.path-mode.exact-stop")
    ),
    setting!(
        "newline",
        "ribbon.group.program",
        "form.newline",
        "form.newline.help",
        "",
        one_of!(newline: Newline, "lf" "form.newline.lf", "crlf" "form.newline.crlf")
    ),
    setting!("customer", "ribbon.group.program", "form.customer", "form.customer.help", "", words!(customer)),
    setting!("product", "ribbon.group.program", "form.product", "form.product.help", "", words!(product)),
];
