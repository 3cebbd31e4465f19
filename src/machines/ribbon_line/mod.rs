//! The ribbon dot-printing line: an inverter unwinds, X pulls, another axis prints a dot every pitch.

mod axes;
mod cam;
mod charts;
mod coasting;
mod contacts;
mod derive;
mod devices;
mod dot_error;
mod driven;
mod examples;
mod knob_turn;
mod ladder;
mod mechanics;
mod params;
mod parts_list;
mod plant;
mod plc;
mod pose;
mod program;
mod readouts;
mod reel;
mod reel_demand;
mod regulated_loop;
mod regulator;
mod resolved;
mod rules;
mod scene;
mod sheets;
mod stops;
mod tension_switch;
mod unwinder_motor;
mod variables;

pub(crate) use resolved::RibbonLine;

use crate::controls::Control;
use crate::controls::options::{Diameter, SpeedReached};
use crate::machines::chart_rows;
use crate::machines::driven::devices::AskedDevice;
use crate::machines::driven::site::SevereSite;
use crate::machines::driven::{DrivenAxis, Gauge, InverterDrive, ProductSize, ResistorDemand, SpindleEncoder, read};
use crate::machines::form::Field;
use crate::machines::ladder::Ladder;
use crate::machines::machine::DrivenMachine;
use crate::machines::machine::LeftOut;
use crate::machines::machine::Samples;
use crate::machines::machine::{
    ControlContext, Defaults, Design, Machine, MachineInfo, MachineProgram, MachineVariable, PanelSetup, Prepared,
};
use crate::machines::machine::{DrawnMachine, Frame};
use crate::motion::{Plant, Plc, RunSegment, Snapshot};
use crate::msg;
use crate::text::number::four_digits;
use crate::text::{Message, units};
use crate::view::{Chart, DrawnPart, Pose, Scene, Sheet};
use params::{Endless, FIELDS, Params};

impl Machine for RibbonLine {
    type Params = Params;
    const INFO: MachineInfo = MachineInfo {
        id: "ribbon-line",
        name: "ribbon.name",
        controls: &[
            "mitsubishi-e60",
            "gsk-980tdc",
            "sinumerik-802d",
            "sinumerik-808d",
            "knd-k2000t",
            "fanuc-0i-tf",
            "fanuc-0i-mf",
        ],
        listing: Some(include_str!("listing.nc")),
        left_out: &[LeftOut {
            number: 30,
            variable: 115,
            text: "#115=#105*SQRT[#107*#107+#110*#110]/#107",
            finding: || msg!("ribbon.equation-4"),
        }],
        speed: 0.05,
        growth: &["spindle-speed", "head-mass", "pitch"],
        speed_result: Some("line-speed"),
        motors: parts_list::MOTORS,
        customer: Some("customer"),
        examples: examples::EXAMPLES,
        ..MachineInfo::BASE
    };

    fn fields() -> &'static [Field<Params>] {
        FIELDS
    }

    /// The control's own times and ranges, and the parameter that keeps the values for a second start.
    fn defaults(control: &Control) -> Defaults {
        let mut defaults = Defaults::timing(control);
        defaults.number("feed-limit", control.limits.feed_max);
        defaults.keep_common(control);
        // Ribbon would pile up while axes wait for the speed of the unwinder.
        defaults.set(control, SpeedReached::NoWait);
        if Params::default().endless_on(control) == Endless::RollOver {
            // The pull axis is a rotary axis then.
            defaults.set(control, Diameter::Radius);
        }
        defaults
    }

    fn new(form: Params, on: ControlContext) -> RibbonLine {
        RibbonLine::resolve(form, on)
    }
}

impl Prepared for RibbonLine {
    fn results(&self) -> Design {
        Design { readouts: readouts::readouts(self), diagnostics: rules::findings(self) }
    }

    fn summary(&self) -> Option<Message> {
        let speed = units::four_digits(self.line_speed(), 3, "mm/min");
        Some(msg!("ribbon.summary", speed, dots = four_digits(self.derived.timing.dots_per_second, 4)))
    }

    fn program(&self) -> MachineProgram {
        MachineProgram {
            deck: program::deck(self),
            setup: Some(program::SETUP),
            main: program::RUN,
            newline: self.params.newline.into(),
        }
    }

    fn plant(&self) -> Plant {
        plant::plant(self)
    }

    fn plc(&self) -> Box<dyn Plc> {
        Box::new(plc::RibbonPlc::new(self))
    }

    fn ladder(&self) -> Option<Ladder> {
        Some(ladder::ladder(self))
    }

    fn panel(&self) -> PanelSetup {
        let percent = if self.params.knob_is_locked() { 100.0 } else { self.start_position() };
        PanelSetup { spindle_override: Some(percent), override_step: self.form.knob_step.percent() }
    }

    fn variables(&self) -> Vec<MachineVariable> {
        program::variables(self)
    }

    fn sheets(&self) -> Vec<Sheet> {
        sheets::sheets(self)
    }
}

impl DrawnMachine for RibbonLine {
    fn parts(&self) -> Vec<DrawnPart> {
        parts_list::parts(self)
    }

    fn scene(&self) -> Scene {
        scene::scene(self)
    }

    fn pose(&self, _: &dyn Samples, now: &Snapshot, frame: Frame) -> Pose {
        pose::pose(self, now, frame)
    }

    fn activity(&self, _run: &dyn Samples, now: &Snapshot) -> Option<Message> {
        let dots = pose::dots_printed(self, now);
        (dots > 0.0 && now.axes[self.pull()].feed > 0.0).then(|| msg!("ribbon.printing", dots = (dots, 0)))
    }

    fn contact(&self, _: &dyn Samples, now: &Snapshot) -> Option<&'static str> {
        (pose::dots_printed(self, now) > 0.0).then_some("ribbon.first-dot")
    }

    fn charts(&self, run: &dyn Samples, from: f64, to: f64, points: usize) -> Vec<Chart> {
        chart_rows::charts(charts::ROWS, self, run, from, to, points)
    }
}

impl DrivenMachine for RibbonLine {
    fn driven_axes(&self) -> Vec<DrivenAxis> {
        driven::axes(self)
    }

    fn inverter_drive(&self) -> Option<InverterDrive> {
        Some(driven::inverter(self))
    }

    fn resistor_demand(&self, _: &dyn Samples, _: &[RunSegment]) -> Option<ResistorDemand> {
        driven::resistor(self)
    }

    fn spindle_encoder(&self) -> Option<SpindleEncoder> {
        driven::encoder(self)
    }

    fn devices(&self) -> Vec<AskedDevice> {
        devices::devices(self)
    }

    fn severe_site(&self) -> Option<SevereSite> {
        let share = SevereSite::leaving(self.params.unwinding.site_share, "unwinder-site-share");
        SevereSite::at(self.params.site(), ["site-height", "site-temperature"]).or(share)
    }

    fn product_size(&self) -> Option<ProductSize> {
        Some(driven::pitch(self))
    }

    fn pause(&self) -> f64 {
        self.params.pause
    }

    fn highest_knob(&self) -> f64 {
        self.highest_position()
    }

    fn lowest_knob(&self) -> f64 {
        self.lowest_position()
    }

    fn time_between_parts(&self) -> f64 {
        reel_demand::change_time(self)
    }

    fn gauges(&self, run: &dyn Samples, span: (f64, f64), points: usize) -> Vec<Gauge> {
        read(driven::GAUGES, self, |t| run.at(t), span, points)
    }
}
