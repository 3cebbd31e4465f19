//! The form of the turning spindle: every input with unit, range and default, and the parameters that it fills.

use super::resolved;
use crate::machines::form::Field;
use crate::machines::form::rows::{Newline, choice, essential, fact, flag, number, one_of, setting, words};

choice! {
    /// What is cut.
    Path {
        /// Across the face, from the stock's diameter inwards.
        Facing,
        /// Along the part, at one diameter per pass.
        Turning,
        /// Along a taper that begins at the face.
        Taper,
    }
}

choice! {
    /// What the spindle holds.
    SpeedMode {
        /// The surface speed, by the diameter.
        Surface,
        /// Its own speed, that of the stock's diameter.
        Fixed,
    }
}

choice! {
    /// Which way it turns.
    Direction {
        /// M03.
        Clockwise,
        /// M04.
        CounterClockwise,
    }
}

choice! {
    /// The gear stage that the program engages.
    Gear {
        /// The lowest that reaches the highest speed needed.
        Best,
        /// Stage 1.
        First,
        /// Stage 2.
        Second,
        /// Stage 3.
        Third,
        /// Stage 4.
        Fourth,
    }
}

choice! {
    /// Form of the analog output.
    Output {
        /// 0 to 10 V, direction by contacts.
        Unipolar,
        /// -10 to 10 V.
        Bipolar,
    }
}

/// Inputs of the turning spindle, within the ranges of [`FIELDS`]. Units as in the form.
#[derive(Debug, Clone, PartialEq, Default)]
#[allow(missing_docs)] // One row of FIELDS documents each member: label, unit, range, help.
pub struct Params {
    pub path: Path,
    pub stock_diameter: f64,
    pub finished_diameter: f64,
    pub length: f64,
    pub large_diameter: f64,
    pub allowance: f64,
    pub depth: f64,
    pub clearance: f64,
    pub start_x: f64,
    pub start_z: f64,
    pub keyway: bool,
    pub keyway_angle: f64,
    pub lock_code: f64,
    pub driven_tool: bool,
    pub speed_mode: SpeedMode,
    pub cutting_speed: f64,
    pub feed: f64,
    pub upper_limit: f64,
    pub lower_limit: f64,
    pub direction: Direction,
    pub override_percent: f64,
    pub gear: Gear,
    pub stage_1: f64,
    pub stage_2: f64,
    pub stage_3: f64,
    pub stage_4: f64,
    pub chuck_limit: f64,
    pub spindle_ramp: f64,
    pub gear_time: f64,
    pub gear_patience: f64,
    pub output: Output,
    pub offset_zero: f64,
    pub offset_full: f64,
    pub cutting_force: f64,
    pub motor_power: f64,
    pub efficiency: f64,
    pub rapid_x: f64,
    pub rapid_z: f64,
    pub clamp_x: f64,
    pub clamp_z: f64,
    pub travel_x: f64,
    pub travel_z: f64,
    pub time_constant: f64,
    pub position_gain: f64,
    pub block_time: f64,
    pub macro_time: f64,
    pub preread: f64,
    pub newline: Newline,
    pub customer: String,
    pub product: String,
}

impl Params {
    /// Speeds at full output of the gear stages that are fitted, in r/min.
    pub fn stages(&self) -> impl Iterator<Item = f64> {
        [self.stage_1, self.stage_2, self.stage_3, self.stage_4].into_iter().take_while(|speed| *speed > 0.0)
    }
}

/// Every input, in the order of the form.
#[rustfmt::skip]
pub static FIELDS: &[Field<Params>] = &[
    setting!("path", "turning.group.part", "turning.path", "turning.path.help", "",
        one_of!(path: Path, "facing" "turning.path.facing", "turning" "turning.path.turning", "taper" "turning.path.taper")),
    essential!("stock-diameter", "turning.group.part", "turning.stock-diameter", "turning.stock-diameter.help", "#102", fact false,
        number!(stock_diameter, "mm", 1.0..3000.0, 80.0, 3, 1.0)),
    essential!("finished-diameter", "turning.group.part", "turning.finished-diameter", "turning.finished-diameter.help", "#103", fact false,
        number!(finished_diameter, "mm", 0.0..3000.0, 20.0, 3, 1.0)),
    setting!("large-diameter", "turning.group.part", "turning.large-diameter", "turning.large-diameter.help", "#104",
        when resolved::is_taper, number!(large_diameter, "mm", 0.001..3000.0, 60.0, 3, 1.0)),
    setting!("length", "turning.group.part", "turning.length", "turning.length.help", "#105",
        when resolved::has_length, number!(length, "mm", 0.1..10000.0, 60.0, 3, 1.0)),
    setting!("allowance", "turning.group.part", "turning.allowance", "turning.allowance.help", "#114",
        when resolved::is_facing, number!(allowance, "mm", 0.01..1000.0, 2.0, 3, 0.1)),
    essential!("depth", "turning.group.cut", "turning.depth", "turning.depth.help", "#106", fact false,
        number!(depth, "mm", 0.01..100.0, 1.0, 3, 0.1)),
    setting!("speed-mode", "turning.group.cut", "turning.speed-mode", "turning.speed-mode.help", "",
        when resolved::holds_surface_speed,
        one_of!(speed_mode: SpeedMode, "surface" "turning.speed-mode.surface", "fixed" "turning.speed-mode.fixed")),
    essential!("cutting-speed", "turning.group.cut", "turning.cutting-speed", "turning.cutting-speed.help", "#100", fact false,
        number!(cutting_speed, "m/min", 0.1..5000.0, 180.0, 2, 5.0)),
    essential!("feed", "turning.group.cut", "turning.feed", "turning.feed.help", "#101", fact false,
        number!(feed, "mm/rev", 0.001..10.0, 0.2, 3, 0.01)),
    essential!("upper-limit", "turning.group.cut", "turning.upper-limit", "turning.upper-limit.help", "#107", fact false,
        number!(upper_limit, "r/min", 1.0..60000.0, 2500.0, 0, 100.0)),
    setting!("lower-limit", "turning.group.cut", "turning.lower-limit", "turning.lower-limit.help", "", when resolved::holds_surface_speed,
        number!(lower_limit, "r/min", 0.0..10000.0, 0.0, 0, 10.0)),
    setting!("clearance", "turning.group.cut", "turning.clearance", "turning.clearance.help", "#108",
        number!(clearance, "mm", 0.1..100.0, 2.0, 3, 0.5)),
    setting!("start-x", "turning.group.cut", "turning.start-x", "turning.start-x.help", "#111",
        number!(start_x, "mm", 1.0..5000.0, 150.0, 3, 10.0)),
    setting!("start-z", "turning.group.cut", "turning.start-z", "turning.start-z.help", "#112",
        number!(start_z, "mm", 0.1..5000.0, 100.0, 3, 10.0)),
    setting!("keyway", "turning.group.cut", "turning.keyway", "turning.keyway.help", "", when resolved::can_position, flag!(keyway)),
    setting!("keyway-angle", "turning.group.cut", "turning.keyway-angle", "turning.keyway-angle.help", "#113",
        when resolved::has_keyway, number!(keyway_angle, "°", 0.0..359.999, 0.0, 3, 5.0)),
    setting!("lock-code", "turning.group.cut", "turning.lock-code", "turning.lock-code.help", "M",
        when resolved::has_keyway, number!(lock_code, "", 0.0..999.0, 0.0, 0, 1.0)),
    setting!("driven-tool", "turning.group.cut", "turning.driven-tool", "turning.driven-tool.help", "",
        when resolved::has_keyway, flag!(driven_tool)),
    setting!("direction", "turning.group.spindle", "turning.direction", "turning.direction.help", "",
        one_of!(direction: Direction, "cw" "turning.direction.cw", "ccw" "turning.direction.ccw")),
    setting!("override", "turning.group.spindle", "turning.override", "turning.override.help", "",
        number!(override_percent, "%", 10.0..200.0, 100.0, 0, 10.0)),
    setting!("gear", "turning.group.spindle", "turning.gear", "turning.gear.help", "", when resolved::has_gears,
        one_of!(gear: Gear, "best" "turning.gear.best", "1" "turning.gear.1", "2" "turning.gear.2", "3" "turning.gear.3", "4" "turning.gear.4")),
    fact!("stage-1", "turning.group.spindle", "turning.stage-1", "turning.stage-1.help", "M41",
        number!(stage_1, "r/min", 1.0..60000.0, 1000.0, 0, 100.0)),
    Field { shown: resolved::has_gears, ..fact!("stage-2", "turning.group.spindle", "turning.stage-2", "turning.stage.help", "M42",
        number!(stage_2, "r/min", 0.0..60000.0, 3000.0, 0, 100.0)) },
    Field { shown: resolved::has_gears, ..fact!("stage-3", "turning.group.spindle", "turning.stage-3", "turning.stage.help", "M43",
        number!(stage_3, "r/min", 0.0..60000.0, 0.0, 0, 100.0)) },
    Field { shown: resolved::has_gears, ..fact!("stage-4", "turning.group.spindle", "turning.stage-4", "turning.stage.help", "M44",
        number!(stage_4, "r/min", 0.0..60000.0, 0.0, 0, 100.0)) },
    fact!("chuck-limit", "turning.group.spindle", "turning.chuck-limit", "turning.chuck-limit.help", "",
        number!(chuck_limit, "r/min", 1.0..60000.0, 3000.0, 0, 100.0)),
    fact!("spindle-ramp", "turning.group.spindle", "turning.spindle-ramp", "turning.spindle-ramp.help", "",
        number!(spindle_ramp, "s", 0.0..600.0, 3.0, 2, 0.1)),
    Field { shown: resolved::has_gears, ..fact!("gear-time", "turning.group.spindle", "turning.gear-time", "turning.gear-time.help", "",
        number!(gear_time, "s", 0.0..60.0, 2.0, 2, 0.1)) },
    Field { shown: resolved::has_gear_alarm, ..fact!("gear-patience", "turning.group.spindle", "turning.gear-patience", "turning.gear-patience.help", "",
        number!(gear_patience, "s", 0.0..60.0, 0.0, 2, 0.5)) },
    Field { shown: resolved::has_signed_output, ..fact!("output", "turning.group.output", "turning.output", "turning.output.help", "",
        one_of!(output: Output, "0-10" "turning.output.unipolar", "+-10" "turning.output.bipolar")) },
    fact!("offset-zero", "turning.group.output", "turning.offset-zero", "turning.offset-zero.help", "",
        number!(offset_zero, "mV", -2000.0..2000.0, 0.0, 0, 1.0)),
    fact!("offset-full", "turning.group.output", "turning.offset-full", "turning.offset-full.help", "",
        number!(offset_full, "mV", -2000.0..2000.0, 0.0, 0, 1.0)),
    setting!("cutting-force", "turning.group.power", "turning.cutting-force", "turning.cutting-force.help", "F",
        number!(cutting_force, "N", 0.0..100000.0, 0.0, 0, 50.0)),
    fact!("motor-power", "turning.group.power", "turning.motor-power", "turning.motor-power.help", "P",
        number!(motor_power, "kW", 0.01..1000.0, 7.5, 2, 0.5)),
    fact!("efficiency", "turning.group.power", "turning.efficiency", "turning.efficiency.help", "η",
        number!(efficiency, "%", 1.0..100.0, 80.0, 0, 1.0)),
    fact!("rapid-x", "turning.group.axes", "turning.rapid-x", "turning.rapid-x.help", "",
        number!(rapid_x, "mm/min", 1.0..1000000.0, 8000.0, 0, 500.0)),
    fact!("rapid-z", "turning.group.axes", "turning.rapid-z", "turning.rapid-z.help", "",
        number!(rapid_z, "mm/min", 1.0..1000000.0, 10000.0, 0, 500.0)),
    fact!("clamp-x", "turning.group.axes", "turning.clamp-x", "turning.clamp-x.help", "",
        number!(clamp_x, "mm/min", 1.0..1000000.0, 4000.0, 0, 500.0)),
    fact!("clamp-z", "turning.group.axes", "turning.clamp-z", "turning.clamp-z.help", "",
        number!(clamp_z, "mm/min", 1.0..1000000.0, 8000.0, 0, 500.0)),
    fact!("travel-x", "turning.group.axes", "turning.travel-x", "turning.travel.help", "",
        number!(travel_x, "mm", 0.0..10000.0, 0.0, 1, 10.0)),
    fact!("travel-z", "turning.group.axes", "turning.travel-z", "turning.travel.help", "",
        number!(travel_z, "mm", 0.0..20000.0, 0.0, 1, 10.0)),
    fact!("time-constant", "turning.group.axes", "turning.time-constant", "turning.time-constant.help", "τ",
        number!(time_constant, "ms", 0.0..5000.0, 100.0, 1, 10.0)),
    fact!("position-gain", "turning.group.axes", "turning.position-gain", "turning.position-gain.help", "K",
        number!(position_gain, "1/s", 1.0..1000.0, 33.0, 2, 1.0)),
    fact!("block-time", "turning.group.control", "form.block-time", "form.block-time.help", "",
        number!(block_time, "ms", 0.1..1000.0, 5.0, 3, 0.1)),
    fact!("macro-time", "turning.group.control", "form.macro-time", "form.macro-time.help", "",
        number!(macro_time, "ms", 0.1..1000.0, 1.0, 3, 0.1)),
    fact!("preread", "turning.group.control", "form.preread", "form.preread.help", "",
        number!(preread, "", 1.0..100.0, 2.0, 0, 1.0)),
    setting!("newline", "turning.group.control", "form.newline", "form.newline.help", "",
        one_of!(newline: Newline, "lf" "form.newline.lf", "crlf" "form.newline.crlf")),
    setting!("customer", "turning.group.control", "form.customer", "form.customer.help", "", words!(customer)),
    setting!("product", "turning.group.control", "form.product", "form.product.help", "", words!(product)),
];
