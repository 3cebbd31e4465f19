//! The turning spindle: a lathe that faces, turns or cuts a taper at constant surface speed or constant r/min.

mod bending;
mod charts;
mod cooling;
mod demand;
mod derive;
mod driven;
mod examples;
mod full_output;
mod gear_stage;
mod gears;
mod keyway;
mod ladder;
mod params;
mod parts_list;
mod plant;
mod pose;
mod program;
mod progress;
mod readouts;
mod resolved;
mod rules;
mod run_up;
mod scene;
mod sheets;
mod stops;
mod travel;
mod variables;
mod worst_cut;

pub(crate) use resolved::TurningSpindle;

use crate::controls::Control;
use crate::machines::chart_rows;
use crate::machines::driven::devices::AskedDevice;
use crate::machines::driven::site::SevereSite;
use crate::machines::driven::{DrivenAxis, Gauge, InverterDrive, ResistorDemand, SpindleEncoder, SpindleRun, read};
use crate::machines::form::Field;
use crate::machines::ladder::Ladder;
use crate::machines::lathe::slides;
use crate::machines::machine::DrivenMachine;
use crate::machines::machine::Samples;
use crate::machines::machine::{
    ControlContext, Defaults, Design, Machine, MachineInfo, MachineProgram, MachineVariable, PanelSetup, Prepared,
};
use crate::machines::machine::{DrawnMachine, Frame};
use crate::machines::verdict::results;
use crate::motion::{Plant, Plc, RunSegment, Snapshot};
use crate::msg;
use crate::text::{Message, units};
use crate::view::{Chart, ChartAxis, DrawnPart, Pose, Scene, Sheet};
use params::{FIELDS, Params};
use rules::RULES;

impl Machine for TurningSpindle {
    type Params = Params;
    const INFO: MachineInfo = MachineInfo {
        id: "turning-spindle",
        name: "turning.name",
        controls: &["gsk-980tdc", "sinumerik-802d", "sinumerik-808d", "knd-k2000t", "fanuc-0i-tf", "mitsubishi-e60"],
        speed: 1.0,
        growth: &["cutting-speed", "feed", "depth"],
        speed_result: Some("speed-largest"),
        motors: parts_list::MOTORS,
        customer: Some("customer"),
        examples: examples::EXAMPLES,
        ..MachineInfo::BASE
    };

    fn fields() -> &'static [Field<Params>] {
        FIELDS
    }

    fn defaults(control: &Control) -> Defaults {
        let mut defaults = Defaults::timing(control);
        defaults.keep_common(control);
        defaults
    }

    fn new(form: Params, on: ControlContext) -> TurningSpindle {
        TurningSpindle::resolve(form, on)
    }
}

impl Prepared for TurningSpindle {
    fn results(&self) -> Design {
        let readouts = results(readouts::ROWS, self, RULES).chain(slides::results(self)).collect();
        Design { readouts, diagnostics: rules::findings(self) }
    }

    fn summary(&self) -> Option<Message> {
        let turns = |speed| units::four_digits(speed, 1, "r/min");
        let (largest, smallest) = (turns(self.derived.speeds.largest), turns(self.derived.speeds.smallest));
        Some(msg!("turning.summary", time = units::four_digits(self.derived.times.cutting, 2, "s"), largest, smallest))
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
        Box::new(plant::plc(self))
    }

    fn ladder(&self) -> Option<Ladder> {
        Some(ladder::ladder(self))
    }

    fn panel(&self) -> PanelSetup {
        PanelSetup { spindle_override: Some(self.form.override_percent), ..PanelSetup::default() }
    }

    fn variables(&self) -> Vec<MachineVariable> {
        program::variables(self)
    }

    fn sheets(&self) -> Vec<Sheet> {
        sheets::sheets(self)
    }
}

impl DrawnMachine for TurningSpindle {
    fn parts(&self) -> Vec<DrawnPart> {
        parts_list::parts(self)
    }

    fn scene(&self) -> Scene {
        scene::scene(self)
    }

    fn pose(&self, run: &dyn Samples, now: &Snapshot, frame: Frame) -> Pose {
        pose::pose(self, run, now, frame)
    }

    fn contact(&self, run: &dyn Samples, now: &Snapshot) -> Option<&'static str> {
        let progress = progress::progress(self, run, now);
        (progress.done > 0 || progress::cuts(self, progress, now)).then_some("turning.first-contact")
    }

    fn activity(&self, run: &dyn Samples, now: &Snapshot) -> Option<Message> {
        if keyway::driven_tool(self, run, now).is_some_and(|tool| tool.cuts) {
            return Some(msg!("turning.milling"));
        }
        let progress = progress::progress(self, run, now);
        progress::cuts(self, progress, now).then(|| msg!("turning.cutting", pass = pose::pass(self, progress)))
    }

    fn pass_starts(&self, run: &dyn Samples, until: f64) -> Vec<f64> {
        run.execution_spans(program::PASS_BEGIN, until).into_iter().map(|(begin, _)| begin).collect()
    }

    fn place_on(&self, axis: ChartAxis, now: &Snapshot) -> Option<f64> {
        match axis {
            ChartAxis::Diameter => Some(self.diameter(now)),
            ChartAxis::Speed => Some(now.spindle.actual.abs()),
            ChartAxis::Time | ChartAxis::Angle | ChartAxis::TipRadius => None,
        }
    }

    fn charts(&self, run: &dyn Samples, from: f64, to: f64, points: usize) -> Vec<Chart> {
        let mut all = chart_rows::charts(charts::ROWS, self, run, from, to, points);
        all.extend(charts::over_diameter(self, points));
        all.extend(charts::charts_by_speed(self, points));
        all
    }
}

impl DrivenMachine for TurningSpindle {
    fn driven_axes(&self) -> Vec<DrivenAxis> {
        slides::axes(self)
    }

    fn working(&self, run: &dyn Samples, until: f64) -> Option<Vec<(f64, f64)>> {
        Some(demand::working(self, run, until))
    }

    fn inverter_drive(&self) -> Option<InverterDrive> {
        driven::inverter(self)
    }

    fn spindle_run(&self, run: &dyn Samples, segments: &[RunSegment]) -> Option<SpindleRun> {
        (self.derived.stage.speed > 0.0).then(|| demand::in_run(self, run, segments))
    }

    fn resistor_demand(&self, run: &dyn Samples, segments: &[RunSegment]) -> Option<ResistorDemand> {
        self.spindle_run(run, segments)?.resistor(self.params.spindle.braking, self.params.pause)
    }

    fn inverter_abilities(&self) -> Vec<Message> {
        driven::inverter_abilities(self)
    }

    fn with_highest_feed(&self) -> Option<(f64, &dyn DrivenMachine)> {
        let (percent, lathe) = self.at_highest_feed()?;
        Some((percent, lathe))
    }

    fn spindle_encoder(&self) -> Option<SpindleEncoder> {
        Some(driven::encoder(self))
    }

    fn devices(&self) -> Vec<AskedDevice> {
        cooling::devices(self).into_iter().chain(keyway::devices(self)).chain(slides::reference_switches()).collect()
    }

    fn severe_site(&self) -> Option<SevereSite> {
        SevereSite::leaving(self.params.site_share, "site-share")
    }

    fn pause(&self) -> f64 {
        self.params.pause
    }

    fn first_part_differs(&self) -> bool {
        self.params.has_several_stages() && self.stage() != gears::AT_POWER_ON
    }

    fn gauges(&self, run: &dyn Samples, span: (f64, f64), points: usize) -> Vec<Gauge> {
        read(driven::GAUGES, self, |t| run.at(t), span, points)
    }
}
