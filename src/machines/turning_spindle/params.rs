//! The form of the turning spindle: every input with unit, range and default, and the parameters that it fills.

use crate::controls::Address;
use crate::controls::{Code, Control, ParamRole, ParamUnit};
use crate::drives::inertia::STEEL;
use crate::machines::driven::site;
use crate::machines::driven::spindle_encoder::{self, EncoderParams};
use crate::machines::form::Field;
use crate::machines::form::common::{self, LineEnds};
use crate::machines::form::rows::{choice, count, flag, joined, number};
use crate::machines::lathe::main_spindle::{self, SpindleDrive};
use crate::machines::lathe::materials::Material;
use crate::machines::lathe::slides::{self, LatheSlides, SlideForm, XDefaults};
use crate::math;
use crate::{member, options};

options! {
    /// Shape of the cut.
    pub(crate) enum Path {
        /// Across the face, from the stock's diameter inwards.
        Facing = "facing" "turning.path.facing",
        /// Along the part, at one diameter per pass.
        Turning = "turning" "turning.path.turning",
        /// Along a taper that begins at the face.
        Taper = "taper" "turning.path.taper",
    }
}

options! {
    /// Spindle speed during the cut.
    pub(crate) enum SpeedMode {
        /// Constant surface speed: r/min by the diameter.
        Surface = "surface" "turning.speed-mode.surface",
        /// Constant r/min, calculated from the stock's diameter.
        Fixed = "fixed" "turning.speed-mode.fixed",
    }
}

options! {
    /// Direction of rotation.
    pub(crate) enum SpindleDirection {
        /// M03.
        Clockwise = "cw" "turning.direction.cw",
        /// M04.
        CounterClockwise = "ccw" "turning.direction.ccw",
    }
}

options! {
    /// The gear stage that the program engages.
    pub(crate) enum Gear {
        /// The lowest stage that reaches the highest commanded speed.
        Best = "best" "turning.gear.best",
        /// Stage 1.
        First = "1" "turning.gear.1",
        /// Stage 2.
        Second = "2" "turning.gear.2",
        /// Stage 3.
        Third = "3" "turning.gear.3",
        /// Stage 4.
        Fourth = "4" "turning.gear.4",
    }
}

options! {
    /// Form of the analog output.
    pub(crate) enum Output {
        /// 0 to 10 V, direction by contacts.
        Unipolar = "0-10" "turning.output.unipolar",
        /// -10 to 10 V.
        Bipolar = "+-10" "turning.output.bipolar",
    }
}

/// Inputs of the turning spindle, within the ranges of [`FIELDS`]. Units as in the form.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Params {
    pub path: Path,
    pub stock_diameter: f64,
    pub finished_diameter: f64,
    pub length: f64,
    pub work_length: f64,
    pub grip: f64,
    pub tailstock: bool,
    pub work_density: f64,
    pub large_diameter: f64,
    pub allowance: f64,
    pub pause: f64,
    pub depth: f64,
    pub clearance: f64,
    pub turret_room: f64,
    pub start_x: f64,
    pub start_z: f64,
    pub tool: f64,
    pub keyway: bool,
    pub keyway_angle: f64,
    pub lock_code: f64,
    pub driven_tool: bool,
    pub driven_number: f64,
    pub keyway_width: f64,
    pub keyway_depth: f64,
    pub keyway_start: f64,
    pub keyway_length: f64,
    pub keyway_feed: f64,
    pub keyway_infeed: f64,
    pub driven_speed: f64,
    pub driven_code: f64,
    pub driven_stop: f64,
    pub release_code: f64,
    pub positioning_speed: f64,
    pub positioning_acceleration: f64,
    pub positioning_direction: SpindleDirection,
    pub speed_mode: SpeedMode,
    pub cutting_speed: f64,
    pub feed: f64,
    pub upper_limit: f64,
    pub lower_limit: f64,
    pub direction: SpindleDirection,
    pub override_percent: f64,
    pub gear: Gear,
    pub stage_1: f64,
    pub stage_2: f64,
    pub stage_3: f64,
    pub stage_4: f64,
    pub chuck_limit: f64,
    pub spindle: SpindleDrive,
    pub encoder: EncoderParams,
    pub spindle_inertia: f64,
    pub gear_time: f64,
    pub gear_patience: f64,
    pub output: Output,
    pub offset_zero: f64,
    pub offset_full: f64,
    pub material: Material,
    pub edge_angle: f64,
    pub rake: f64,
    pub edge_wear: f64,
    pub cutting_force: f64,
    pub motor_overload: f64,
    pub site_share: f64,
    pub efficiency: f64,
    pub travel_x: f64,
    pub travel_z: f64,
    pub slides: LatheSlides,
    pub block_time: f64,
    pub macro_time: f64,
    pub preread: f64,
    pub newline: LineEnds,
    pub customer: String,
    pub product: String,
}

/// Whether the control has an address of several letters.
pub(super) fn has_address(control: &Control, address: Address) -> bool {
    control.syntax.names().is_some_and(|names| names.addresses.iter().any(|row| row.1 == address))
}

impl Params {
    /// Speeds at full output of the gear stages that are fitted, in r/min.
    pub(super) fn stages(&self) -> impl Iterator<Item = f64> {
        [self.stage_1, self.stage_2, self.stage_3, self.stage_4].into_iter().take_while(|speed| *speed > 0.0)
    }

    /// Whether more than one gear stage is fitted.
    pub(super) fn has_several_stages(&self) -> bool {
        self.stages().nth(1).is_some()
    }

    /// Whether the control can hold a constant surface speed.
    pub(super) fn holds_surface_speed(&self, control: &Control) -> bool {
        control.can(Code::SurfaceSpeed)
    }

    /// Whether the control has codes for gear stages.
    pub(super) fn has_gears(&self, control: &Control) -> bool {
        control.codes.iter().any(|row| matches!(row.code, Code::GearStage(1..)))
    }

    /// Greatest length (mm) behind the face that may be cut: the length outside the jaws less the clearance.
    pub(super) fn reach(&self) -> f64 {
        (self.work_length - self.grip - self.clearance).max(0.0)
    }

    /// Distance (mm) by which the edge cuts ahead of its tip where it is at the surface of the stock: `t / tan κ` for an edge angle κ below
    /// 90°, with t the depth from there to the end of the finished part. All passes end one above the other, so that the edge cuts their
    /// shoulder as a cone.
    pub(super) fn edge_lead(&self) -> f64 {
        let depth = match self.path {
            Path::Facing => return 0.0,
            Path::Turning => 0.5 * (self.stock_diameter - self.finished_diameter),
            Path::Taper => 0.5 * (self.stock_diameter - self.large_diameter),
        };
        let slope = math::tan_degrees(self.edge_angle).filter(|slope| self.edge_angle < 90.0 && *slope > 0.0);
        slope.map_or(0.0, |slope| depth.max(0.0) / slope)
    }

    /// Greatest length (mm) of the cut behind the face, with an edge that leads its tip.
    pub(super) fn cut_reach(&self) -> f64 {
        (self.reach() - self.edge_lead()).max(0.0)
    }

    /// Greatest distance (mm) of the end of a keyway behind the finished face: the allowance of a face is in front of it.
    pub(super) fn keyway_reach(&self) -> f64 {
        let in_front = if self.path == Path::Facing { self.allowance } else { 0.0 };
        (self.reach() - in_front).max(0.0)
    }

    /// Length (mm) of the cut along the work.
    pub(super) fn cut_length(&self) -> f64 {
        if self.path == Path::Facing { self.allowance } else { self.length }
    }

    /// Whether the sign of the control's output can set the direction.
    pub(super) fn has_signed_output(&self, control: &Control) -> bool {
        control.spindle.signed_output
    }

    /// Whether the control clamps the feed of each axis.
    pub(super) fn has_clamp(&self, control: &Control) -> bool {
        control.clamps_feed()
    }

    /// Whether the control has parameters for the offsets of its output.
    pub(super) fn has_offsets(&self, control: &Control) -> bool {
        control.param(ParamRole::SpindleOffsetZero).is_some_and(|row| row.unit == ParamUnit::Millivolts)
    }

    /// Whether the control has a word that positions the spindle.
    pub(super) fn can_position(&self, control: &Control) -> bool {
        has_address(control, Address::Spos)
    }

    /// Whether the spindle is positioned for a keyway.
    fn has_keyway(&self, control: &Control) -> bool {
        self.keyway && self.can_position(control)
    }

    /// Whether a driven tool can cut the keyway.
    fn has_driven_tool(&self, control: &Control) -> bool {
        self.has_keyway(control) && self.driven_tool
    }

    /// Diameter (mm) of the cylinder that a keyway is cut into; `None` on a taper.
    pub(super) fn keyway_diameter(&self) -> Option<f64> {
        match self.path {
            Path::Facing => Some(self.stock_diameter),
            Path::Turning => Some(self.finished_diameter),
            Path::Taper => None,
        }
    }

    /// Whether the control has codes that limit the speed of the spindle in every mode (G25 S, G26 S).
    pub(super) fn has_speed_limits(&self, control: &Control) -> bool {
        control.can(Code::UpperLimits)
    }

    /// Whether the cutting force follows from the material.
    fn has_material(&self, _: &Control) -> bool {
        self.material != Material::None
    }

    fn has_force(&self, _: &Control) -> bool {
        self.material == Material::None
    }

    fn is_taper(&self, _: &Control) -> bool {
        self.path == Path::Taper
    }

    fn is_facing(&self, _: &Control) -> bool {
        self.path == Path::Facing
    }

    fn has_length(&self, _: &Control) -> bool {
        self.path != Path::Facing
    }
}

impl SlideForm for Params {
    fn lathe_slides(&self) -> &LatheSlides {
        &self.slides
    }

    fn lathe_slides_mut(&mut self) -> &mut LatheSlides {
        &mut self.slides
    }
}

/// Every input, in the order of the form.
pub(super) static FIELDS: &[Field<Params>] = &joined::<Params, { count(ROWS) }>(ROWS);

/// The inputs in lists: those of this machine, and between them those that every lathe has.
#[rustfmt::skip]
const ROWS: &[&[Field<Params>]] = &[
    &[
    choice("path", member!(Params.path: Path)).group("turning.group.part").label("turning.path").help("turning.path.help"),
    number("stock-diameter", member!(Params.stock_diameter)).group("turning.group.part").label("turning.stock-diameter").help("turning.stock-diameter.help").symbol("#102")
        .unit("mm").range(1.0..=3000.0).default(80.0).decimals(3).step(1.0).essential(),
    number("finished-diameter", member!(Params.finished_diameter)).group("turning.group.part").label("turning.finished-diameter").help("turning.finished-diameter.help").symbol("#103")
        .unit("mm").range(0.0..=3000.0).default(20.0).decimals(3).step(1.0).essential(),
    number("large-diameter", member!(Params.large_diameter)).group("turning.group.part").label("turning.large-diameter").help("turning.large-diameter.help").symbol("#104")
        .unit("mm").range(0.001..=3000.0).default(60.0).decimals(3).step(1.0).when(Params::is_taper),
    number("length", member!(Params.length)).group("turning.group.part").label("turning.length").help("turning.length.help").symbol("#105")
        .unit("mm").range(0.1..=10000.0).default(60.0).decimals(3).step(1.0).when(Params::has_length),
    number("work-length", member!(Params.work_length)).group("turning.group.part").label("turning.work-length").help("turning.work-length.help")
        .unit("mm").range(0.1..=20000.0).default(100.0).decimals(1).step(10.0),
    number("grip", member!(Params.grip)).group("turning.group.part").label("turning.grip").help("turning.grip.help")
        .unit("mm").range(0.0..=5000.0).default(15.0).decimals(1).step(1.0),
    flag("tailstock", member!(Params.tailstock)).group("turning.group.part").label("turning.tailstock").help("turning.tailstock.help")
        .when(Params::has_length),
    number("work-density", member!(Params.work_density)).group("turning.group.part").label("turning.work-density").help("turning.work-density.help").symbol("ρ")
        .unit("kg/m³").range(1.0..=25000.0).default(STEEL).decimals(0).step(50.0).fact(),
    number("allowance", member!(Params.allowance)).group("turning.group.part").label("turning.allowance").help("turning.allowance.help").symbol("#114")
        .unit("mm").range(0.01..=1000.0).default(2.0).decimals(3).step(0.1).when(Params::is_facing),
    common::pause("turning.group.part", member!(Params.pause)),
    number("depth", member!(Params.depth)).group("turning.group.cut").label("turning.depth").help("turning.depth.help").symbol("#106")
        .unit("mm").range(0.01..=100.0).default(1.0).decimals(3).step(0.1).essential(),
    choice("speed-mode", member!(Params.speed_mode: SpeedMode)).group("turning.group.cut").label("turning.speed-mode").help("turning.speed-mode.help")
        .when(Params::holds_surface_speed),
    number("cutting-speed", member!(Params.cutting_speed)).group("turning.group.cut").label("turning.cutting-speed").help("turning.cutting-speed.help").symbol("#100")
        .unit("m/min").range(0.1..=5000.0).default(180.0).decimals(2).step(5.0).essential(),
    number("feed", member!(Params.feed)).group("turning.group.cut").label("turning.feed").help("turning.feed.help").symbol("#101")
        .unit("mm/rev").range(0.001..=10.0).default(0.2).decimals(3).step(0.01).essential(),
    number("upper-limit", member!(Params.upper_limit)).group("turning.group.cut").label("turning.upper-limit").help("turning.upper-limit.help").symbol("#107")
        .unit("r/min").range(1.0..=60000.0).default(2500.0).decimals(0).step(100.0).essential(),
    number("lower-limit", member!(Params.lower_limit)).group("turning.group.cut").label("turning.lower-limit").help("turning.lower-limit.help")
        .unit("r/min").range(0.0..=10000.0).default(0.0).decimals(0).step(10.0).when(Params::holds_surface_speed),
    number("clearance", member!(Params.clearance)).group("turning.group.cut").label("turning.clearance").help("turning.clearance.help").symbol("#108")
        .unit("mm").range(0.1..=100.0).default(2.0).decimals(3).step(0.5),
    number("start-x", member!(Params.start_x)).group("turning.group.cut").label("turning.start-x").help("turning.start-x.help").symbol("#111")
        .unit("mm").range(1.0..=5000.0).default(150.0).decimals(3).step(10.0),
    number("start-z", member!(Params.start_z)).group("turning.group.cut").label("turning.start-z").help("turning.start-z.help").symbol("#112")
        .unit("mm").range(0.1..=5000.0).default(100.0).decimals(3).step(10.0),
    number("turret-room", member!(Params.turret_room)).group("turning.group.cut").label("lathe.turret-room").help("lathe.turret-room.help").symbol("#126")
        .unit("mm").range(1.0..=1000.0).default(30.0).decimals(1).step(5.0).fact(),
    number("tool", member!(Params.tool)).group("turning.group.cut").label("turning.tool").help("turning.tool.help").symbol("T")
        .range(1.0..=99.0).default(1.0).decimals(0).step(1.0),
    flag("keyway", member!(Params.keyway)).group("turning.group.cut").label("turning.keyway").help("turning.keyway.help")
        .when(Params::can_position),
    number("keyway-angle", member!(Params.keyway_angle)).group("turning.group.cut").label("turning.keyway-angle").help("turning.keyway-angle.help").symbol("#113")
        .unit("°").range(0.0..=359.999).default(0.0).decimals(3).step(5.0).when(Params::has_keyway),
    number("lock-code", member!(Params.lock_code)).group("turning.group.cut").label("turning.lock-code").help("turning.lock-code.help").symbol("M")
        .range(0.0..=999.0).default(0.0).decimals(0).step(1.0).when(Params::has_keyway),
    flag("driven-tool", member!(Params.driven_tool)).group("turning.group.cut").label("turning.driven-tool").help("turning.driven-tool.help")
        .when(Params::has_keyway),
    number("positioning-speed", member!(Params.positioning_speed)).group("turning.group.spindle").label("turning.positioning-speed").help("turning.positioning-speed.help")
        .unit("r/min").range(0.1..=10000.0).default(100.0).decimals(1).step(10.0).setting().when(Params::has_keyway),
    number("positioning-acceleration", member!(Params.positioning_acceleration)).group("turning.group.spindle").label("turning.positioning-acceleration").help("turning.positioning-acceleration.help")
        .unit("r/min/s").range(1.0..=1000000.0).default(500.0).decimals(0).step(50.0).setting().when(Params::has_keyway),
    choice("positioning-direction", member!(Params.positioning_direction: SpindleDirection)).group("turning.group.spindle").label("turning.positioning-direction").help("turning.positioning-direction.help")
        .setting().when(Params::has_keyway),
    number("driven-number", member!(Params.driven_number)).group("turning.group.keyway").label("turning.driven-number").help("turning.driven-number.help").symbol("T")
        .range(1.0..=99.0).default(2.0).decimals(0).step(1.0).when(Params::has_driven_tool),
    number("keyway-width", member!(Params.keyway_width)).group("turning.group.keyway").label("turning.keyway-width").help("turning.keyway-width.help").symbol("#120")
        .unit("mm").range(0.1..=200.0).default(6.0).decimals(3).step(0.5).when(Params::has_driven_tool),
    number("keyway-depth", member!(Params.keyway_depth)).group("turning.group.keyway").label("turning.keyway-depth").help("turning.keyway-depth.help").symbol("#117")
        .unit("mm").range(0.0..=500.0).default(0.0).decimals(3).step(0.5).when(Params::has_driven_tool),
    number("keyway-start", member!(Params.keyway_start)).group("turning.group.keyway").label("turning.keyway-start").help("turning.keyway-start.help").symbol("#119")
        .unit("mm").range(0.0..=10000.0).default(5.0).decimals(3).step(1.0).when(Params::has_driven_tool),
    number("keyway-length", member!(Params.keyway_length)).group("turning.group.keyway").label("turning.keyway-length").help("turning.keyway-length.help").symbol("#118")
        .unit("mm").range(0.1..=10000.0).default(20.0).decimals(3).step(1.0).when(Params::has_driven_tool),
    number("keyway-feed", member!(Params.keyway_feed)).group("turning.group.keyway").label("turning.keyway-feed").help("turning.keyway-feed.help").symbol("#122")
        .unit("mm/min").range(1.0..=20000.0).default(100.0).decimals(0).step(10.0).when(Params::has_driven_tool),
    number("keyway-infeed", member!(Params.keyway_infeed)).group("turning.group.keyway").label("turning.keyway-infeed").help("turning.keyway-infeed.help").symbol("#123")
        .unit("mm/min").range(1.0..=20000.0).default(50.0).decimals(0).step(10.0).when(Params::has_driven_tool),
    number("driven-speed", member!(Params.driven_speed)).group("turning.group.keyway").label("turning.driven-speed").help("turning.driven-speed.help").symbol("#121")
        .unit("r/min").range(1.0..=60000.0).default(2000.0).decimals(0).step(100.0).when(Params::has_driven_tool),
    number("driven-code", member!(Params.driven_code)).group("turning.group.keyway").label("turning.driven-code").help("turning.driven-code.help").symbol("M")
        .range(0.0..=999.0).default(0.0).decimals(0).step(1.0).when(Params::has_driven_tool),
    number("driven-stop", member!(Params.driven_stop)).group("turning.group.keyway").label("turning.driven-stop").help("turning.driven-stop.help").symbol("M")
        .range(0.0..=999.0).default(0.0).decimals(0).step(1.0).when(Params::has_driven_tool),
    number("release-code", member!(Params.release_code)).group("turning.group.cut").label("turning.release-code").help("turning.release-code.help").symbol("M")
        .range(0.0..=999.0).default(0.0).decimals(0).step(1.0).when(Params::has_keyway),
    choice("direction", member!(Params.direction: SpindleDirection)).group("turning.group.spindle").label("turning.direction").help("turning.direction.help"),
    number("override", member!(Params.override_percent)).group("turning.group.spindle").label("turning.override").help("turning.override.help")
        .unit("%").range(10.0..=200.0).default(100.0).decimals(0).step(10.0),
    choice("gear", member!(Params.gear: Gear)).group("turning.group.spindle").label("turning.gear").help("turning.gear.help")
        .when(Params::has_gears),
    number("stage-1", member!(Params.stage_1)).group("turning.group.spindle").label("turning.stage-1").help("turning.stage-1.help").symbol("M41")
        .unit("r/min").range(1.0..=60000.0).default(1000.0).decimals(0).step(100.0).fact(),
    number("stage-2", member!(Params.stage_2)).group("turning.group.spindle").label("turning.stage-2").help("turning.stage.help").symbol("M42")
        .unit("r/min").range(0.0..=60000.0).default(3000.0).decimals(0).step(100.0).fact().when(Params::has_gears),
    number("stage-3", member!(Params.stage_3)).group("turning.group.spindle").label("turning.stage-3").help("turning.stage.help").symbol("M43")
        .unit("r/min").range(0.0..=60000.0).default(0.0).decimals(0).step(100.0).fact().when(Params::has_gears),
    number("stage-4", member!(Params.stage_4)).group("turning.group.spindle").label("turning.stage-4").help("turning.stage.help").symbol("M44")
        .unit("r/min").range(0.0..=60000.0).default(0.0).decimals(0).step(100.0).fact().when(Params::has_gears),
    number("chuck-limit", member!(Params.chuck_limit)).group("turning.group.spindle").label("turning.chuck-limit").help("turning.chuck-limit.help")
        .unit("r/min").range(1.0..=60000.0).default(3000.0).decimals(0).step(100.0).fact(),
    number("spindle-ramp", member!(Params.spindle.ramp)).group("turning.group.spindle").label("turning.spindle-ramp").help("turning.spindle-ramp.help")
        .unit("s").range(0.0..=600.0).default(3.0).decimals(2).step(0.1).fact(),
    number("spindle-inertia", member!(Params.spindle_inertia)).group("turning.group.spindle").label("turning.spindle-inertia").help("turning.spindle-inertia.help").symbol("J")
        .unit("kg m²").range(0.0001..=10000.0).default(0.2).decimals(4).step(0.01).fact(),
    main_spindle::friction("spindle-friction", "turning.spindle-friction", "turning.spindle-friction.help", member!(Params.spindle.friction)).group("turning.group.spindle"),
    spindle_encoder::lines("turning.group.spindle", member!(Params.encoder.lines)),
    spindle_encoder::turns("turning.group.spindle", member!(Params.encoder.turns)),
    spindle_encoder::spindle_turns("turning.group.spindle", member!(Params.encoder.spindle_turns)),
    number("gear-time", member!(Params.gear_time)).group("turning.group.spindle").label("turning.gear-time").help("turning.gear-time.help")
        .unit("s").range(0.0..=60.0).default(2.0).decimals(2).step(0.1).fact().when(Params::has_gears),
    number("gear-patience", member!(Params.gear_patience)).group("turning.group.spindle").label("turning.gear-patience").help("turning.gear-patience.help")
        .unit("s").range(0.0..=60.0).default(5.0).decimals(2).step(0.5).fact().when(Params::has_gears),
    choice("output", member!(Params.output: Output)).group("turning.group.output").label("turning.output").help("turning.output.help")
        .fact().when(Params::has_signed_output),
    number("offset-zero", member!(Params.offset_zero)).group("turning.group.output").label("turning.offset-zero").help("turning.offset-zero.help")
        .unit("mV").range(-2000.0..=2000.0).default(0.0).decimals(0).step(1.0).fact().when(Params::has_offsets),
    number("offset-full", member!(Params.offset_full)).group("turning.group.output").label("turning.offset-full").help("turning.offset-full.help")
        .unit("mV").range(-2000.0..=2000.0).default(0.0).decimals(0).step(1.0).fact().when(Params::has_offsets),
    choice("material", member!(Params.material: Material)).group("turning.group.power").label("turning.material").help("turning.material.help"),
    number("edge-angle", member!(Params.edge_angle)).group("turning.group.power").label("turning.edge-angle").help("turning.edge-angle.help").symbol("κ")
        .unit("°").range(10.0..=170.0).default(95.0).decimals(1).step(1.0).when(Params::has_material),
    number("rake", member!(Params.rake)).group("turning.group.power").label("turning.rake").help("turning.rake.help").symbol("γ")
        .unit("°").range(-30.0..=30.0).default(0.0).decimals(1).step(1.0).when(Params::has_material),
    number("edge-wear", member!(Params.edge_wear)).group("turning.group.power").label("lathe.edge-wear").help("lathe.edge-wear.help")
        .range(1.0..=3.0).default(1.0).decimals(2).step(0.1).when(Params::has_material),
    number("cutting-force", member!(Params.cutting_force)).group("turning.group.power").label("turning.cutting-force").help("turning.cutting-force.help").symbol("F")
        .unit("N").range(0.0..=100000.0).default(0.0).decimals(0).step(50.0).when(Params::has_force),
    main_spindle::power("motor-power", "turning.motor-power", "turning.motor-power.help", member!(Params.spindle.power)).group("turning.group.power"),
    main_spindle::base_speed("motor-base", "turning.motor-base", "turning.motor-base.help", member!(Params.spindle.base)).group("turning.group.power"),
    main_spindle::top_speed("motor-top", "turning.motor-top", "turning.motor-top.help", 1500.0, member!(Params.spindle.top)).group("turning.group.power"),
    number("motor-overload", member!(Params.motor_overload)).group("turning.group.power").label("turning.motor-overload").help("turning.motor-overload.help")
        .unit("%").range(100.0..=400.0).default(100.0).decimals(0).step(10.0).fact(),
    main_spindle::forced_cooling("motor-forced-cooling", "turning.motor-forced-cooling", member!(Params.spindle.forced_cooling)).group("turning.group.power"),
    site::share("site-share", "turning.group.power", member!(Params.site_share)),
    main_spindle::peak("motor-peak", "turning.motor-peak", member!(Params.spindle.peak)).group("turning.group.power"),
    main_spindle::braking("motor-braking", "turning.motor-braking", member!(Params.spindle.braking)).group("turning.group.power"),
    main_spindle::rotor("rotor-inertia", "turning.rotor-inertia", "turning.rotor-inertia.help", member!(Params.spindle.rotor)).group("turning.group.power"),
    number("efficiency", member!(Params.efficiency)).group("turning.group.power").label("turning.efficiency").help("turning.efficiency.help").symbol("η")
        .unit("%").range(1.0..=100.0).default(80.0).decimals(0).step(1.0).fact(),
    number("rapid-x", member!(Params.slides.x.rapid)).group("turning.group.axes").label("turning.rapid-x").help("turning.rapid-x.help")
        .unit("mm/min").range(1.0..=1000000.0).default(8000.0).decimals(0).step(500.0).fact(),
    number("rapid-z", member!(Params.slides.z.rapid)).group("turning.group.axes").label("turning.rapid-z").help("turning.rapid-z.help")
        .unit("mm/min").range(1.0..=1000000.0).default(10000.0).decimals(0).step(500.0).fact(),
    number("clamp-x", member!(Params.slides.x.clamp)).group("turning.group.axes").label("turning.clamp-x").help("turning.clamp-x.help")
        .unit("mm/min").range(1.0..=1000000.0).default(4000.0).decimals(0).step(500.0).fact().when(Params::has_clamp),
    number("clamp-z", member!(Params.slides.z.clamp)).group("turning.group.axes").label("turning.clamp-z").help("turning.clamp-z.help")
        .unit("mm/min").range(1.0..=1000000.0).default(8000.0).decimals(0).step(500.0).fact().when(Params::has_clamp),
    number("travel-x", member!(Params.travel_x)).group("turning.group.axes").label("turning.travel-x").help("turning.travel.help")
        .unit("mm").range(0.0..=10000.0).default(0.0).decimals(1).step(10.0).fact(),
    number("travel-z", member!(Params.travel_z)).group("turning.group.axes").label("turning.travel-z").help("turning.travel.help")
        .unit("mm").range(0.0..=20000.0).default(0.0).decimals(1).step(10.0).fact(),
    ],
    &slides::scaling_rows("turning.group.axes"),
    &[
    number("time-constant", member!(Params.slides.time_constant)).group("turning.group.axes").label("turning.time-constant").help("turning.time-constant.help").symbol("τ")
        .unit("ms").range(0.0..=5000.0).default(100.0).decimals(1).step(10.0).setting(),
    number("position-gain", member!(Params.slides.position_gain)).group("turning.group.axes").label("turning.position-gain").help("turning.position-gain.help").symbol("K")
        .unit("1/s").range(1.0..=1000.0).default(33.0).decimals(2).step(1.0).setting(),
    ],
    &slides::rows(XDefaults { mass: 100.0, friction: 150.0 }),
    &[
    common::block_time("turning.group.control", 5.0, member!(Params.block_time)),
    common::macro_time("turning.group.control", 1.0, member!(Params.macro_time)),
    common::preread("turning.group.control", 2.0, member!(Params.preread)),
    common::newline("turning.group.control", member!(Params.newline: LineEnds)),
    common::customer("turning.group.control", member!(&Params.customer)),
    common::product("turning.group.control", member!(&Params.product)),
    ],
];
