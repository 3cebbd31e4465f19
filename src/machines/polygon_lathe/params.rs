//! The form of the polygon lathe: every input with unit, range and default, and the parameters that it fills.

use super::axes::RatioAxes;
use super::further_form::{self, Further, FurtherForm};
use super::shape::Shape;
use super::turned_end_form::{self, TurnedEnd, TurnedEndForm, TurnedEnds};
use crate::controls::Control;
use crate::machines::driven::scaling;
use crate::machines::driven::site;
use crate::machines::driven::spindle_encoder::{self, EncoderParams};
use crate::machines::form::Field;
use crate::machines::form::common::{self, LineEnds};
use crate::machines::form::rows::{choice, count, flag, joined, number, text};
use crate::machines::lathe::main_spindle::{self, SpindleDrive};
use crate::machines::lathe::materials::Material;
use crate::machines::lathe::slides::{self, LatheSlides, SlideForm, XDefaults};
use crate::{member, options};

options! {
    /// Drives of work and tool at emergency stop.
    pub(crate) enum Emergency {
        /// The drives stay on until work and tool are at rest.
        Held = "held" "polygon.emergency.held",
        /// The drives are switched off at once.
        Off = "off" "polygon.emergency.off",
    }
}

/// Inputs of the polygon lathe, within the ranges of [`FIELDS`]. Units as in the form.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Params {
    pub shape: Shape,
    pub sides: f64,
    pub across_flats: f64,
    pub stock_diameter: f64,
    pub from_face: f64,
    pub length: f64,
    pub free_length: f64,
    pub flatness: f64,
    pub hollow: bool,
    pub orientation: f64,
    pub pause: f64,
    pub inserts: f64,
    pub work_ratio: f64,
    pub tool_ratio: f64,
    pub tip_radius: f64,
    pub overhang: f64,
    pub relief: f64,
    pub insert_width: f64,
    pub radius_errors: String,
    pub angle_errors: String,
    pub speed: f64,
    pub work_start: f64,
    pub tool_start: f64,
    pub depth: f64,
    pub allowance: f64,
    pub lead: f64,
    pub feed: f64,
    pub finish_feed: f64,
    pub infeed: f64,
    pub retract_feed: f64,
    pub clearance: f64,
    pub start_x: f64,
    pub start_z: f64,
    pub turret_room: f64,
    pub tool: f64,
    pub further: [Further; 2],
    pub turned_ends: TurnedEnds,
    /// The main spindle, which turns the bar before and after the polygons.
    pub main: SpindleDrive,
    pub encoder: EncoderParams,
    pub main_speed: f64,
    pub axes: RatioAxes,
    pub index_speed: f64,
    pub emergency: Emergency,
    pub material: Material,
    pub specific_force: f64,
    pub edge_angle: f64,
    pub rake: f64,
    pub edge_wear: f64,
    pub drive_peak: f64,
    pub drive_efficiency: f64,
    pub site_share: f64,
    pub mill_diameter: f64,
    pub mill_depth: f64,
    pub mill_feed: f64,
    pub slowest_cut: f64,
    pub fastest_cut: f64,
    pub most_inserts: f64,
    pub least_radius: f64,
    pub greatest_radius: f64,
    pub most_work_turns: f64,
    pub most_tool_turns: f64,
    pub against: bool,
    pub least_distance: f64,
    pub greatest_distance: f64,
    pub slides: LatheSlides,
    pub block_time: f64,
    pub macro_time: f64,
    pub preread: f64,
    pub newline: LineEnds,
    pub customer: String,
    pub product: String,
}

/// Greatest length of the text with the errors of all inserts.
const ERRORS: usize = 200;

impl Params {
    /// Whether inserts and ratio are typed in the form.
    fn is_own(&self, _: &Control) -> bool {
        self.shape == Shape::Own
    }

    /// Whether the main spindle turns an end of the bar.
    pub(super) fn turns_ends(&self) -> bool {
        self.turned_ends.iter().any(|end| end.on)
    }

    /// Whether the form asks for the main spindle.
    fn turns(&self, _: &Control) -> bool {
        self.turns_ends()
    }

    /// Whether the polygon begins at a distance from the face, with stock at both of its ends.
    pub(super) fn is_behind_face(&self) -> bool {
        self.from_face > 0.0
    }

    /// Whether any polygon begins at a distance from the face, so that the insert goes down into the stock.
    fn goes_down(&self, _: &Control) -> bool {
        self.is_behind_face() || self.further[0].on
    }

    /// Whether the specific cutting force is typed in the form.
    fn has_own_force(&self, _: &Control) -> bool {
        self.material == Material::None
    }

    /// Whether work and tool coast at an emergency stop.
    pub(super) fn coasts(&self, _: &Control) -> bool {
        self.emergency == Emergency::Off
    }
}

impl FurtherForm for Params {
    fn further_polygons(&self) -> &[Further; 2] {
        &self.further
    }

    fn further_polygons_mut(&mut self) -> &mut [Further; 2] {
        &mut self.further
    }
}

impl TurnedEndForm for Params {
    fn turned_ends(&self) -> &[TurnedEnd; 2] {
        &self.turned_ends
    }

    fn turned_ends_mut(&mut self) -> &mut [TurnedEnd; 2] {
        &mut self.turned_ends
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
    choice("shape", member!(Params.shape: Shape)).group("polygon.group.part").label("polygon.shape").help("polygon.shape.help"),
    number("sides", member!(Params.sides)).group("polygon.group.part").label("polygon.sides").help("polygon.sides.help").symbol("N")
        .range(1.0..=100.0).default(4.0).decimals(0).step(1.0).when(Params::is_own),
    number("across-flats", member!(Params.across_flats)).group("polygon.group.part").label("polygon.across-flats").help("polygon.across-flats.help").symbol("AF")
        .unit("mm").range(0.5..=500.0).default(20.0).decimals(3).step(0.5).essential(),
    number("stock-diameter", member!(Params.stock_diameter)).group("polygon.group.part").label("polygon.stock-diameter").help("polygon.stock-diameter.help")
        .unit("mm").range(0.5..=1000.0).default(25.0).decimals(3).step(0.5).essential(),
    number("length", member!(Params.length)).group("polygon.group.part").label("polygon.length").help("polygon.length.help")
        .unit("mm").range(0.1..=2000.0).default(15.0).decimals(3).step(1.0).essential(),
    number("from-face", member!(Params.from_face)).group("polygon.group.part").label("polygon.from-face").help("polygon.from-face.help").symbol("Z")
        .unit("mm").range(0.0..=2000.0).default(0.0).decimals(3).step(1.0).essential(),
    number("free-length", member!(Params.free_length)).group("polygon.group.part").label("polygon.free-length").help("polygon.free-length.help")
        .unit("mm").range(0.0..=5000.0).default(0.0).decimals(3).step(5.0),
    number("flatness", member!(Params.flatness)).group("polygon.group.part").label("polygon.flatness").help("polygon.flatness.help")
        .unit("mm").range(0.0001..=10.0).default(0.1).decimals(4).step(0.01),
    flag("hollow", member!(Params.hollow)).group("polygon.group.part").label("polygon.hollow").help("polygon.hollow.help"),
    number("orientation", member!(Params.orientation)).group("polygon.group.part").label("polygon.orientation").help("polygon.orientation.help").symbol("ψ")
        .unit("°").range(-359.999..=359.999).default(0.0).decimals(3).step(5.0),
    common::pause("polygon.group.part", member!(Params.pause)),
    number("inserts", member!(Params.inserts)).group("polygon.group.cutter").label("polygon.inserts").help("polygon.inserts.help").symbol("n")
        .range(1.0..=50.0).default(2.0).decimals(0).step(1.0).when(Params::is_own),
    number("work-ratio", member!(Params.work_ratio)).group("polygon.group.cutter").label("polygon.work-ratio").help("polygon.work-ratio.help").symbol("D")
        .range(-99.0..=99.0).default(1.0).decimals(0).step(1.0).when(Params::is_own),
    number("tool-ratio", member!(Params.tool_ratio)).group("polygon.group.cutter").label("polygon.tool-ratio").help("polygon.tool-ratio.help").symbol("Q")
        .range(-99.0..=99.0).default(2.0).decimals(0).step(1.0).when(Params::is_own),
    number("tip-radius", member!(Params.tip_radius)).group("polygon.group.cutter").label("polygon.tip-radius").help("polygon.tip-radius.help").symbol("r")
        .unit("mm").range(1.0..=1000.0).default(45.0).decimals(3).step(1.0).essential().fact(),
    number("overhang", member!(Params.overhang)).group("polygon.group.cutter").label("polygon.overhang").help("polygon.overhang.help").symbol("h")
        .unit("mm").range(0.1..=1000.0).default(8.0).decimals(3).step(0.5).fact(),
    number("relief", member!(Params.relief)).group("polygon.group.cutter").label("polygon.relief").help("polygon.relief.help")
        .unit("°").range(0.0..=45.0).default(11.0).decimals(1).step(1.0).fact(),
    number("insert-width", member!(Params.insert_width)).group("polygon.group.cutter").label("polygon.insert-width").help("polygon.insert-width.help")
        .unit("mm").range(0.0..=100.0).default(3.0).decimals(3).step(0.5).fact(),
    text("radius-errors", member!(&Params.radius_errors)).group("polygon.group.cutter").label("polygon.radius-errors").help("polygon.radius-errors.help").symbol("Δr").characters(ERRORS),
    text("angle-errors", member!(&Params.angle_errors)).group("polygon.group.cutter").label("polygon.angle-errors").help("polygon.angle-errors.help").symbol("Δφ").characters(ERRORS),
    number("speed", member!(Params.speed)).group("polygon.group.cut").label("polygon.speed").help("polygon.speed.help").symbol("B")
        .unit("r/min").range(1.0..=10000.0).default(200.0).decimals(0).step(10.0).essential(),
    number("work-start", member!(Params.work_start)).group("polygon.group.cut").label("polygon.work-start").help("polygon.work-start.help").symbol("A")
        .unit("°").range(-359.999..=359.999).default(0.0).decimals(3).step(5.0),
    number("tool-start", member!(Params.tool_start)).group("polygon.group.cut").label("polygon.tool-start").help("polygon.tool-start.help").symbol("E")
        .unit("°").range(-359.999..=359.999).default(0.0).decimals(3).step(5.0),
    number("depth", member!(Params.depth)).group("polygon.group.cut").label("polygon.depth").help("polygon.depth.help")
        .unit("mm").range(0.01..=50.0).default(1.0).decimals(3).step(0.1).essential(),
    number("allowance", member!(Params.allowance)).group("polygon.group.cut").label("polygon.allowance").help("polygon.allowance.help")
        .unit("mm").range(0.0..=10.0).default(0.2).decimals(3).step(0.05),
    number("lead", member!(Params.lead)).group("polygon.group.cut").label("polygon.lead").help("polygon.lead.help").symbol("K")
        .unit("mm").range(-100000.0..=100000.0).default(0.0).decimals(3).step(10.0),
    number("feed", member!(Params.feed)).group("polygon.group.cut").label("polygon.feed").help("polygon.feed.help")
        .unit("mm/rev").range(0.001..=10.0).default(0.5).decimals(3).step(0.05).essential(),
    number("finish-feed", member!(Params.finish_feed)).group("polygon.group.cut").label("polygon.finish-feed").help("polygon.finish-feed.help")
        .unit("mm/rev").range(0.001..=10.0).default(0.25).decimals(3).step(0.05),
    number("infeed", member!(Params.infeed)).group("polygon.group.cut").label("polygon.infeed").help("polygon.infeed.help")
        .unit("mm/rev").range(0.001..=10.0).default(0.1).decimals(3).step(0.01).when(Params::goes_down),
    number("retract-feed", member!(Params.retract_feed)).group("polygon.group.cut").label("polygon.retract-feed").help("polygon.retract-feed.help")
        .unit("mm/min").range(1.0..=10000.0).default(1000.0).decimals(0).step(100.0),
    number("clearance", member!(Params.clearance)).group("polygon.group.cut").label("polygon.clearance").help("polygon.clearance.help")
        .unit("mm").range(0.1..=100.0).default(2.0).decimals(3).step(0.5),
    number("start-x", member!(Params.start_x)).group("polygon.group.cut").label("polygon.start-x").help("polygon.start-x.help")
        .unit("mm").range(1.0..=2000.0).default(60.0).decimals(3).step(5.0),
    number("start-z", member!(Params.start_z)).group("polygon.group.cut").label("polygon.start-z").help("polygon.start-z.help")
        .unit("mm").range(0.1..=2000.0).default(30.0).decimals(3).step(5.0),
    number("turret-room", member!(Params.turret_room)).group("polygon.group.cut").label("lathe.turret-room").help("lathe.turret-room.help")
        .unit("mm").range(1.0..=1000.0).default(30.0).decimals(1).step(5.0).fact(),
    number("tool", member!(Params.tool)).group("polygon.group.cut").label("polygon.tool").help("polygon.tool.help").symbol("T")
        .range(1.0..=99.0).default(1.0).decimals(0).step(1.0),
    ],
    &further_form::rows::<Params, 0>(),
    &further_form::rows::<Params, 1>(),
    &turned_end_form::rows::<Params, 0>(),
    &turned_end_form::rows::<Params, 1>(),
    &[
    main_spindle::power("main-power", "polygon.main.power", "polygon.main.power.help", member!(Params.main.power)).group("polygon.group.main").when(Params::turns),
    main_spindle::base_speed("main-base", "polygon.main.base", "polygon.base.help", member!(Params.main.base)).group("polygon.group.main").when(Params::turns),
    main_spindle::top_speed("main-motor-top", "polygon.main.motor-top", "polygon.main.motor-top.help", 2250.0, member!(Params.main.top)).group("polygon.group.main").when(Params::turns),
    number("main-speed", member!(Params.main_speed)).group("polygon.group.main").label("polygon.main.speed").help("polygon.main.speed.help").symbol("n10")
        .unit("r/min").range(1.0..=60000.0).default(3000.0).decimals(0).step(100.0).fact().when(Params::turns),
    main_spindle::forced_cooling("main-forced-cooling", "polygon.main.forced-cooling", member!(Params.main.forced_cooling)).group("polygon.group.main").when(Params::turns),
    spindle_encoder::lines("polygon.group.main", member!(Params.encoder.lines)).when(Params::turns),
    spindle_encoder::turns("polygon.group.main", member!(Params.encoder.turns)).when(Params::turns),
    spindle_encoder::spindle_turns("polygon.group.main", member!(Params.encoder.spindle_turns)).when(Params::turns),
    main_spindle::peak("main-peak", "polygon.main.peak", member!(Params.main.peak)).group("polygon.group.main").when(Params::turns),
    main_spindle::braking("main-braking", "polygon.main.braking", member!(Params.main.braking)).group("polygon.group.main").when(Params::turns),
    main_spindle::rotor("main-rotor", "polygon.main.rotor", "polygon.main.rotor.help", member!(Params.main.rotor)).group("polygon.group.main").when(Params::turns),
    main_spindle::friction("main-friction", "polygon.main.friction", "polygon.main.friction.help", member!(Params.main.friction)).group("polygon.group.main").when(Params::turns),
    number("main-ramp", member!(Params.main.ramp)).group("polygon.group.main").label("polygon.main.ramp").help("polygon.main.ramp.help")
        .unit("s").range(0.1..=600.0).default(2.0).decimals(2).step(0.1).fact().when(Params::turns),
    number("work-limit", member!(Params.axes.work.limit)).group("polygon.group.drives").label("polygon.work-limit").help("polygon.work-limit.help")
        .unit("r/min").range(1.0..=20000.0).default(1000.0).decimals(0).step(100.0).fact(),
    number("tool-limit", member!(Params.axes.tool.limit)).group("polygon.group.drives").label("polygon.tool-limit").help("polygon.tool-limit.help")
        .unit("r/min").range(1.0..=20000.0).default(2000.0).decimals(0).step(100.0).fact(),
    number("work-time-constant", member!(Params.axes.work.time_constant)).group("polygon.group.drives").label("polygon.work-time-constant").help("polygon.work-time-constant.help").symbol("τ")
        .unit("ms").range(0.0..=10000.0).default(300.0).decimals(1).step(10.0).setting(),
    number("tool-time-constant", member!(Params.axes.tool.time_constant)).group("polygon.group.drives").label("polygon.tool-time-constant").help("polygon.tool-time-constant.help").symbol("τ")
        .unit("ms").range(0.0..=10000.0).default(300.0).decimals(1).step(10.0).setting(),
    number("work-gain", member!(Params.axes.work.gain)).group("polygon.group.drives").label("polygon.work-gain").help("polygon.work-gain.help").symbol("K")
        .unit("1/s").range(1.0..=1000.0).default(30.0).decimals(2).step(1.0).setting(),
    number("tool-gain", member!(Params.axes.tool.gain)).group("polygon.group.drives").label("polygon.tool-gain").help("polygon.tool-gain.help").symbol("K")
        .unit("1/s").range(1.0..=1000.0).default(30.0).decimals(2).step(1.0).setting(),
    scaling::teeth("work-motor-teeth", "polygon.group.drives", "scaling.work-motor-teeth", member!(Params.axes.work.motor_teeth)),
    scaling::teeth("work-teeth", "polygon.group.drives", "scaling.work-teeth", member!(Params.axes.work.teeth)),
    scaling::teeth("tool-motor-teeth", "polygon.group.drives", "scaling.tool-motor-teeth", member!(Params.axes.tool.motor_teeth)),
    scaling::teeth("tool-teeth", "polygon.group.drives", "scaling.tool-teeth", member!(Params.axes.tool.teeth)),
    scaling::encoder("encoder-counts-work", "polygon.group.drives", "scaling.encoder-work", member!(Params.axes.work.encoder)),
    scaling::encoder("encoder-counts-tool", "polygon.group.drives", "scaling.encoder-tool", member!(Params.axes.tool.encoder)),
    number("index-speed", member!(Params.index_speed)).group("polygon.group.drives").label("polygon.index-speed").help("polygon.index-speed.help")
        .unit("r/min").range(0.1..=1000.0).default(20.0).decimals(1).step(1.0),
    choice("emergency", member!(Params.emergency: Emergency)).group("polygon.group.drives").label("polygon.emergency").help("polygon.emergency.help"),
    number("work-coast", member!(Params.axes.work.coast)).group("polygon.group.drives").label("polygon.work-coast").help("polygon.work-coast.help")
        .unit("s").range(0.1..=600.0).default(4.0).decimals(1).step(0.5),
    number("tool-coast", member!(Params.axes.tool.coast)).group("polygon.group.drives").label("polygon.tool-coast").help("polygon.tool-coast.help")
        .unit("s").range(0.1..=600.0).default(2.0).decimals(1).step(0.5),
    choice("material", member!(Params.material: Material)).group("polygon.group.power").label("polygon.material").help("polygon.material.help"),
    number("specific-force", member!(Params.specific_force)).group("polygon.group.power").label("polygon.specific-force").help("polygon.specific-force.help").symbol("kc")
        .unit("N/mm²").range(0.0..=10000.0).default(1750.0).decimals(0).step(50.0).fact().when(Params::has_own_force),
    number("edge-angle", member!(Params.edge_angle)).group("polygon.group.power").label("polygon.edge-angle").help("polygon.edge-angle.help").symbol("κ")
        .unit("°").range(10.0..=170.0).default(90.0).decimals(1).step(1.0).fact(),
    number("rake", member!(Params.rake)).group("polygon.group.power").label("polygon.rake").help("polygon.rake.help").symbol("γ")
        .unit("°").range(-30.0..=30.0).default(0.0).decimals(1).step(1.0).fact(),
    number("edge-wear", member!(Params.edge_wear)).group("polygon.group.power").label("lathe.edge-wear").help("lathe.edge-wear.help")
        .range(1.0..=3.0).default(1.0).decimals(2).step(0.1).fact(),
    number("work-power", member!(Params.axes.work.power)).group("polygon.group.power").label("polygon.work-power").help("polygon.work-power.help").symbol("P")
        .unit("kW").range(0.01..=1000.0).default(5.5).decimals(2).step(0.5).fact(),
    number("work-base", member!(Params.axes.work.base)).group("polygon.group.power").label("polygon.work-base").help("polygon.base.help").symbol("n b")
        .unit("r/min").range(1.0..=60000.0).default(1500.0).decimals(0).step(100.0).fact(),
    number("work-top", member!(Params.axes.work.top)).group("polygon.group.power").label("polygon.work-top").help("polygon.top.help").symbol("n max")
        .unit("r/min").range(1.0..=100000.0).default(6000.0).decimals(0).step(100.0).fact(),
    number("work-inertia", member!(Params.axes.work.inertia)).group("polygon.group.power").label("polygon.work-inertia").help("polygon.work-inertia.help").symbol("J")
        .unit("kg·m²").range(0.0..=1000.0).default(0.2).decimals(5).step(0.01).fact(),
    number("tool-power", member!(Params.axes.tool.power)).group("polygon.group.power").label("polygon.tool-power").help("polygon.tool-power.help").symbol("P")
        .unit("kW").range(0.01..=1000.0).default(5.5).decimals(2).step(0.5).fact(),
    number("tool-base", member!(Params.axes.tool.base)).group("polygon.group.power").label("polygon.tool-base").help("polygon.base.help").symbol("n b")
        .unit("r/min").range(1.0..=60000.0).default(1500.0).decimals(0).step(100.0).fact(),
    number("tool-top", member!(Params.axes.tool.top)).group("polygon.group.power").label("polygon.tool-top").help("polygon.top.help").symbol("n max")
        .unit("r/min").range(1.0..=100000.0).default(6000.0).decimals(0).step(100.0).fact(),
    number("tool-inertia", member!(Params.axes.tool.inertia)).group("polygon.group.power").label("polygon.tool-inertia").help("polygon.tool-inertia.help").symbol("J")
        .unit("kg·m²").range(0.0..=1000.0).default(0.02).decimals(5).step(0.001).fact(),
    number("drive-peak", member!(Params.drive_peak)).group("polygon.group.power").label("polygon.drive-peak").help("polygon.drive-peak.help")
        .unit("%").range(100.0..=600.0).default(250.0).decimals(0).step(10.0).fact(),
    number("drive-efficiency", member!(Params.drive_efficiency)).group("polygon.group.power").label("polygon.drive-efficiency").help("polygon.drive-efficiency.help").symbol("η")
        .unit("%").range(1.0..=100.0).default(90.0).decimals(0).step(1.0).fact(),
    site::share("site-share", "polygon.group.power", member!(Params.site_share)),
    number("mill-diameter", member!(Params.mill_diameter)).group("polygon.group.milling").label("polygon.mill-diameter").help("polygon.mill-diameter.help")
        .unit("mm").range(0.1..=200.0).default(16.0).decimals(3).step(1.0),
    number("mill-depth", member!(Params.mill_depth)).group("polygon.group.milling").label("polygon.mill-depth").help("polygon.mill-depth.help")
        .unit("mm").range(0.01..=200.0).default(5.0).decimals(3).step(0.5),
    number("mill-feed", member!(Params.mill_feed)).group("polygon.group.milling").label("polygon.mill-feed").help("polygon.mill-feed.help")
        .unit("mm/min").range(1.0..=20000.0).default(400.0).decimals(0).step(50.0),
    number("slowest-cut", member!(Params.slowest_cut)).group("polygon.group.limits").label("polygon.slowest-cut").help("polygon.slowest-cut.help")
        .unit("m/min").range(0.0..=5000.0).default(40.0).decimals(1).step(5.0),
    number("fastest-cut", member!(Params.fastest_cut)).group("polygon.group.limits").label("polygon.fastest-cut").help("polygon.fastest-cut.help")
        .unit("m/min").range(1.0..=5000.0).default(250.0).decimals(1).step(5.0),
    number("most-inserts", member!(Params.most_inserts)).group("polygon.group.limits").label("polygon.most-inserts").help("polygon.most-inserts.help")
        .range(1.0..=12.0).default(6.0).decimals(0).step(1.0).setting(),
    number("least-radius", member!(Params.least_radius)).group("polygon.group.limits").label("polygon.least-radius").help("polygon.least-radius.help")
        .unit("mm").range(1.0..=1000.0).default(45.0).decimals(3).step(1.0).fact(),
    number("greatest-radius", member!(Params.greatest_radius)).group("polygon.group.limits").label("polygon.greatest-radius").help("polygon.greatest-radius.help")
        .unit("mm").range(1.0..=1000.0).default(45.0).decimals(3).step(1.0).fact(),
    number("most-work-turns", member!(Params.most_work_turns)).group("polygon.group.limits").label("polygon.most-work-turns").help("polygon.most-work-turns.help").symbol("D")
        .range(1.0..=9.0).default(5.0).decimals(0).step(1.0).setting(),
    number("most-tool-turns", member!(Params.most_tool_turns)).group("polygon.group.limits").label("polygon.most-tool-turns").help("polygon.most-tool-turns.help").symbol("Q")
        .range(1.0..=99.0).default(12.0).decimals(0).step(1.0).setting(),
    flag("against", member!(Params.against)).group("polygon.group.limits").label("polygon.against").help("polygon.against.help"),
    number("least-distance", member!(Params.least_distance)).group("polygon.group.limits").label("polygon.least-distance").help("polygon.least-distance.help")
        .unit("mm").range(0.0..=2000.0).default(20.0).decimals(2).step(5.0).fact(),
    number("greatest-distance", member!(Params.greatest_distance)).group("polygon.group.limits").label("polygon.greatest-distance").help("polygon.greatest-distance.help")
        .unit("mm").range(1.0..=2000.0).default(150.0).decimals(2).step(5.0).fact(),
    number("rapid-x", member!(Params.slides.x.rapid)).group("polygon.group.slides").label("polygon.rapid-x").help("polygon.rapid-x.help")
        .unit("mm/min").range(1.0..=1000000.0).default(6000.0).decimals(0).step(500.0).fact(),
    number("rapid-z", member!(Params.slides.z.rapid)).group("polygon.group.slides").label("polygon.rapid-z").help("polygon.rapid-z.help")
        .unit("mm/min").range(1.0..=1000000.0).default(8000.0).decimals(0).step(500.0).fact(),
    number("clamp-x", member!(Params.slides.x.clamp)).group("polygon.group.slides").label("polygon.clamp-x").help("polygon.clamp-x.help")
        .unit("mm/min").range(1.0..=1000000.0).default(3000.0).decimals(0).step(500.0).fact(),
    number("clamp-z", member!(Params.slides.z.clamp)).group("polygon.group.slides").label("polygon.clamp-z").help("polygon.clamp-z.help")
        .unit("mm/min").range(1.0..=1000000.0).default(6000.0).decimals(0).step(500.0).fact(),
    ],
    &slides::scaling_rows("polygon.group.slides"),
    &[
    number("time-constant", member!(Params.slides.time_constant)).group("polygon.group.slides").label("polygon.time-constant").help("polygon.time-constant.help").symbol("τ")
        .unit("ms").range(0.0..=5000.0).default(100.0).decimals(1).step(10.0).setting(),
    number("position-gain", member!(Params.slides.position_gain)).group("polygon.group.slides").label("polygon.position-gain").help("polygon.position-gain.help").symbol("K")
        .unit("1/s").range(1.0..=1000.0).default(33.0).decimals(2).step(1.0).setting(),
    ],
    &slides::rows(XDefaults { mass: 150.0, friction: 200.0 }),
    &[
    common::block_time("polygon.group.control", 4.0, member!(Params.block_time)),
    common::macro_time("polygon.group.control", 2.0, member!(Params.macro_time)),
    common::preread("polygon.group.control", 5.0, member!(Params.preread)),
    common::newline("polygon.group.control", member!(Params.newline: LineEnds)),
    common::customer("polygon.group.control", member!(&Params.customer)),
    common::product("polygon.group.control", member!(&Params.product)),
    ],
];
