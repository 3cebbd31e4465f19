//! The polygon lathe: a cutter disc and the work turn in a fixed ratio, started and stopped by G512 and G502, and flats appear.

mod axes;
mod bending;
mod charts;
mod citations;
mod cutter_choices;
mod demand;
mod derive;
mod drawings;
mod driven;
mod examples;
mod explore;
mod findings;
mod further;
mod further_form;
mod geometry;
mod ladder;
mod load;
mod main_spindle;
mod milling;
mod native_code;
mod outlines;
mod params;
mod parts_list;
mod passes;
mod path;
mod plant;
mod plc;
mod polygon_forms;
mod pose;
mod program;
mod progress;
mod readouts;
mod resolved;
mod results;
mod rules;
mod scene;
mod sequence;
mod shape;
mod sheets;
mod speeds;
mod stops;
mod turned_end_form;
mod turned_ends;

pub(crate) use resolved::PolygonLathe;
use resolved::WORK;

use crate::machines::chart_rows;
use crate::machines::driven::devices::AskedDevice;
use crate::machines::driven::site::SevereSite;
use crate::machines::driven::{
    CoastedAxes, DrivenAxis, Gauge, InverterDrive, ResistorDemand, SpindleEncoder, SpindleRun, read,
};
use crate::machines::form::Field;
use crate::machines::ladder::Ladder;
use crate::machines::lathe::slides;
use crate::machines::machine::DrivenMachine;
use crate::machines::machine::Samples;
use crate::machines::machine::{
    ControlContext, Design, Machine, MachineFile, MachineInfo, MachineProgram, MachineVariable, Prepared,
};
use crate::machines::machine::{DrawnMachine, Frame};
use crate::motion::{Plant, Plc, RunSegment, Snapshot};
use crate::msg;
use crate::text::{Message, units};
use crate::view::{Chart, ChartAxis, DrawnPart, Explorer, Pose, Scene, Sheet};
use params::{FIELDS, Params};

impl Machine for PolygonLathe {
    type Params = Params;
    const INFO: MachineInfo = MachineInfo {
        id: "polygon-lathe",
        name: "polygon.name",
        controls: &["knd-k2000t"],
        listing: Some(include_str!("listing.nc")),
        speed: 0.05,
        growth: &["speed", "feed", "depth"],
        speed_result: Some("work-speed"),
        motors: parts_list::MOTORS,
        explores: true,
        customer: Some("customer"),
        examples: examples::EXAMPLES,
        ..MachineInfo::BASE
    };

    fn fields() -> &'static [Field<Params>] {
        FIELDS
    }

    fn new(form: Params, on: ControlContext) -> PolygonLathe {
        PolygonLathe::resolve(form, on)
    }
}

impl Prepared for PolygonLathe {
    fn results(&self) -> Design {
        Design { readouts: results::results(self), diagnostics: findings::findings(self) }
    }

    fn summary(&self) -> Option<Message> {
        let d = &self.derived;
        let length = |value, decimals| units::four_digits(value, decimals, "mm");
        let (across, error) = (length(d.section.across_flats, 3), length(d.section.flatness, 4));
        d.cuts.then(|| msg!("polygon.summary", sides = (d.section.sides, 0), across, error))
    }

    fn program(&self) -> MachineProgram {
        MachineProgram {
            deck: program::deck(self),
            setup: None,
            main: program::PART,
            newline: self.params.newline.into(),
        }
    }

    fn plant(&self) -> Plant {
        plant::plant(self)
    }

    fn plc(&self) -> Box<dyn Plc> {
        Box::new(plc::plc(self))
    }

    fn turned_axes(&self) -> &'static [&'static str] {
        &["work", "tool"]
    }

    fn ladder(&self) -> Option<Ladder> {
        Some(ladder::ladder(self))
    }

    fn variables(&self) -> Vec<MachineVariable> {
        program::VARIABLES.to_vec()
    }

    fn sheets(&self) -> Vec<Sheet> {
        sheets::sheets(self)
    }

    fn files(&self) -> Vec<MachineFile> {
        drawings::files(self)
    }

    fn explored(&self) -> Vec<&'static str> {
        self.polygons().zip(drawings::NAMES).map(|(_, name)| name).collect()
    }

    fn explorer(&self, shape: usize) -> Option<Explorer> {
        Some(explore::explorer(self.polygons().nth(shape)?, shape))
    }
}

impl DrawnMachine for PolygonLathe {
    fn parts(&self) -> Vec<DrawnPart> {
        parts_list::parts(self)
    }

    fn scene(&self) -> Scene {
        scene::scene(self)
    }

    fn pose(&self, run: &dyn Samples, now: &Snapshot, frame: Frame) -> Pose {
        pose::pose(self, run, now, frame)
    }

    fn spindle_speed(&self, now: &Snapshot) -> f64 {
        // While the PMC turns the work, the spindle is its axis.
        if now.pmc[WORK].feed == 0.0 { now.spindle.actual } else { now.pmc[WORK].feed / 360.0 }
    }

    fn contact(&self, run: &dyn Samples, now: &Snapshot) -> Option<&'static str> {
        progress::progress(self, run, now).now().map(|_| "polygon.first-contact")
    }

    fn activity(&self, run: &dyn Samples, now: &Snapshot) -> Option<Message> {
        let turned = || progress::turning_spans(self, run, now.t).pop();
        if self.has_main_spindle() && turned().is_some_and(|(_, end)| end >= now.t) {
            return Some(msg!("polygon.turning-end"));
        }
        let (_, end) = progress::cuts(self, run, now.t).pop()?;
        let pass = (end >= now.t).then(|| pose::pass(self, &progress::progress(self, run, now)))?;
        Some(msg!("polygon.cutting", pass))
    }

    fn pass_starts(&self, run: &dyn Samples, until: f64) -> Vec<f64> {
        progress::cuts(self, run, until).into_iter().map(|(begin, _)| begin).collect()
    }

    fn place_on(&self, axis: ChartAxis, now: &Snapshot) -> Option<f64> {
        (axis == ChartAxis::Speed).then(|| self.spindle_speed(now).abs())
    }

    fn charts(&self, run: &dyn Samples, from: f64, to: f64, points: usize) -> Vec<Chart> {
        let mut all = chart_rows::charts(charts::ROWS, self, run, from, to, points);
        all.extend(charts::deviation(self, points));
        all.extend(charts::over_radius(self, points));
        all.extend(main_spindle::charts(self, points));
        all
    }
}

impl DrivenMachine for PolygonLathe {
    fn inverter_drive(&self) -> Option<InverterDrive> {
        main_spindle::inverter(self)
    }

    fn spindle_run(&self, run: &dyn Samples, segments: &[RunSegment]) -> Option<SpindleRun> {
        main_spindle::in_run(self, run, segments)
    }

    fn resistor_demand(&self, run: &dyn Samples, segments: &[RunSegment]) -> Option<ResistorDemand> {
        self.spindle_run(run, segments)?.resistor(self.params.main.braking, self.params.pause)
    }

    fn with_highest_feed(&self) -> Option<(f64, &dyn DrivenMachine)> {
        let (percent, lathe) = self.at_highest_feed()?;
        Some((percent, lathe))
    }

    fn spindle_encoder(&self) -> Option<SpindleEncoder> {
        main_spindle::encoder(self)
    }

    fn devices(&self) -> Vec<AskedDevice> {
        main_spindle::devices(self).into_iter().chain(slides::reference_switches()).collect()
    }

    fn severe_site(&self) -> Option<SevereSite> {
        SevereSite::leaving(self.params.site_share, "site-share")
    }

    fn driven_axes(&self) -> Vec<DrivenAxis> {
        driven::axes(self)
    }

    fn working(&self, run: &dyn Samples, until: f64) -> Option<Vec<(f64, f64)>> {
        Some(progress::cuts(self, run, until))
    }

    fn pause(&self) -> f64 {
        self.params.pause
    }

    fn time_between_parts(&self) -> f64 {
        self.params.mean_index_time() - self.params.index_time().min(self.params.mean_index_time())
    }

    fn without_supply(&self) -> Option<CoastedAxes> {
        driven::without_supply(self)
    }

    fn coasts_at_emergency_stop(&self) -> bool {
        self.params.coasts(self.control)
    }

    fn gauges(&self, run: &dyn Samples, span: (f64, f64), points: usize) -> Vec<Gauge> {
        read(driven::GAUGES, self, |t| run.at(t), span, points)
    }
}
