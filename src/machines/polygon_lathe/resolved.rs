//! The lathe on a control: what the form comes to, as geometry and as the words that start it.

use super::derive::Derived;
use super::params::{Emergency, Params, Shape};
use crate::controls::{Control, Switches};
use crate::drives::polygon::choose::{Cutter, Means, Wanted};
use crate::drives::polygon::cut::{self, Cut};
use crate::drives::polygon::{Ratio, Section, Setup};
use crate::machines::ControlContext;
use crate::math::PI;
use crate::motion::Snapshot;
use crate::text::number;

/// The slide across the work, and the one along it.
pub(super) const CROSS: u8 = b'X';
pub(super) const ALONG: u8 = b'Z';

/// Which axis of the PLC turns the work, and which the tool.
pub(super) const WORK: usize = 0;
pub(super) const TOOL: usize = 1;

/// Radians in a degree.
const RADIANS: f64 = PI / 180.0;

/// The switch of whether overrides act on axes of the PMC.
const OVERRIDE: &str = "pmc-override";

/// The form on a control.
pub(super) struct Resolved<'a> {
    /// The form as it was filled in.
    pub(super) form: &'a Params,
    /// The form, with what the shape says of inserts and ratio.
    pub(super) p: Params,
    pub(super) control: &'a Control,
    pub(super) switches: &'a Switches,
    /// Across flats of every pass.
    pub(super) sizes: Vec<f64>,
}

impl<'a> Resolved<'a> {
    pub(super) fn new(form: &'a Params, on: ControlContext<'a>) -> Resolved<'a> {
        let ControlContext { control, switches } = on;
        let mut p = form.clone();
        let shape = match p.shape {
            Shape::Own => None,
            Shape::Knob => Some((2.0, 1.0, 1.0, 2.0)),
            Shape::Triangle => Some((3.0, 2.0, 2.0, 3.0)),
            Shape::Square => Some((4.0, 2.0, 1.0, 2.0)),
            Shape::Hexagon => Some((6.0, 3.0, 1.0, 2.0)),
        };
        if let Some(shape) = shape {
            (p.sides, p.inserts, p.work_ratio, p.tool_ratio) = shape;
        }
        let sizes = (1..=p.passes() as u32).map(|pass| p.size(f64::from(pass))).collect();
        Resolved { form, p, control, switches, sizes }
    }

    /// What follows from the form.
    pub(super) fn derived(&self) -> Derived {
        Derived::new(self)
    }

    /// Index of the slide across the work.
    pub(super) fn cross(&self) -> usize {
        self.control.axis(CROSS).unwrap_or(0)
    }

    /// Index of the slide along the work.
    pub(super) fn along(&self) -> usize {
        self.control.axis(ALONG).unwrap_or(0)
    }

    /// What words of X count for each millimetre that the slide moves.
    pub(super) fn words(&self) -> f64 {
        if self.control.counts_diameters(self.cross(), self.switches) { 2.0 } else { 1.0 }
    }

    /// Whether the feed override acts on the axes of the PMC.
    pub(super) fn overrides(&self) -> bool {
        self.switches.get(self.control.switches, OVERRIDE) == Some("acts")
    }

    /// The codes that start and stop it, as the parameters bind them.
    pub(super) fn codes(&self) -> [Option<u32>; 2] {
        let calls = self.control.code_calls(self.switches);
        super::program::MACROS.map(|program| {
            let call = calls.iter().find(|call| call.letter == b'G' && call.program == program);
            call.map(|call| call.number / 10)
        })
    }

    /// Tool to work speed; none where D or Q is 0.
    pub(super) fn ratio(&self) -> Option<Ratio> {
        Ratio::new(self.p.tool_ratio as i32, self.p.work_ratio as i32)
    }

    /// The cutter at a distance across flats, with its inserts as they are seated.
    pub(super) fn setup(&self, across_flats: f64) -> Option<Setup> {
        let p = &self.p;
        let mut setup = Setup::even(across_flats, p.tip_radius, self.ratio()?, p.inserts as u32);
        (setup.work_start, setup.tool_start) = (p.work_start * RADIANS, p.tool_start * RADIANS);
        let errors = |text: &str, most: f64| errors(text, setup.tips.len(), most).unwrap_or_default();
        let (radii, angles) = (errors(&p.radius_errors, RADIUS_ERROR), errors(&p.angle_errors, ANGLE_ERROR));
        for (tip, off) in setup.tips.iter_mut().zip(radii) {
            tip.radius += off;
        }
        for (tip, off) in setup.tips.iter_mut().zip(angles) {
            tip.angle += off * RADIANS;
        }
        Some(setup)
    }

    /// What every pass asks of the inserts, with its number from 1.
    pub(super) fn cuts(&self, setup: &Setup) -> Vec<(f64, Cut)> {
        let Params { tip_radius, stock_diameter, .. } = self.p;
        let cuts = cut::passes(&self.sizes, tip_radius, setup.ratio, setup.sides(), 0.5 * stock_diameter);
        (1_u32..).map(f64::from).zip(cuts).collect()
    }

    /// The finished section.
    pub(super) fn section(&self) -> Option<Section> {
        Section::new(&self.setup(self.p.across_flats)?, 0.5 * self.p.stock_diameter)
    }

    /// The polygon that is wanted.
    pub(super) fn wanted(&self) -> Wanted<'_> {
        let p = &self.p;
        Wanted {
            sides: p.sides as u32,
            sizes: &self.sizes,
            stock: 0.5 * p.stock_diameter,
            flatness: p.flatness,
            hollow: p.hollow,
        }
    }

    /// What the machine allows.
    pub(super) fn means(&self) -> Means {
        let p = &self.p;
        let radius = (p.least_radius.min(p.greatest_radius), p.greatest_radius);
        let cutter = |inserts: u32| Cutter { inserts, radius, relief: p.relief * RADIANS };
        Means {
            cutters: (1..=p.most_inserts as u32).map(cutter).collect(),
            terms: (p.most_tool_turns as u32, p.most_work_turns as u32),
            against: p.against,
            work_speed: p.work_limit,
            tool_speed: p.tool_limit,
            distance: (p.least_distance, p.greatest_distance),
            cutting_speed: (p.slowest_cut, p.fastest_cut),
        }
    }

    /// Across flats that the slide is set to, and where it stands along the work, in mm.
    pub(super) fn slide(&self, now: &Snapshot) -> (f64, f64) {
        let at = |axis: usize| now.axes.get(axis).map_or(0.0, |axis| axis.actual);
        (2.0 * at(self.cross()), at(self.along()))
    }

    /// By how much the tool is ahead of where ratio and start angles want it beside the work, in degrees, half a turn at most.
    pub(super) fn phase(&self, now: &Snapshot) -> f64 {
        let k = self.ratio().map_or(0.0, Ratio::value);
        let (work, tool) = (now.pmc[WORK].actual - self.p.work_start, now.pmc[TOOL].actual - self.p.tool_start);
        let off = (tool - k * work) / 360.0;
        360.0 * (off - off.round())
    }
}

/// Whether the form says itself how many inserts there are, and at which ratio they turn.
pub(super) fn is_own(p: &Params, _: &Control) -> bool {
    p.shape == Shape::Own
}

/// Whether emergency stop leaves work and tool to coast.
pub(super) fn coasts(p: &Params, _: &Control) -> bool {
    p.emergency == Emergency::Off
}

/// The most that an insert is seated beside its place: in mm, and in degrees.
pub(super) const RADIUS_ERROR: f64 = 1.0;
pub(super) const ANGLE_ERROR: f64 = 10.0;

/// The errors of the inserts as the form has them, one after the other; none where one is no number or too large, or where there are more than inserts.
pub(super) fn errors(text: &str, inserts: usize, most: f64) -> Option<Vec<f64>> {
    let within = |off: &f64| off.abs() <= most;
    let errors: Option<Vec<f64>> = text.split_whitespace().map(|off| number::read(off).filter(within)).collect();
    errors.filter(|errors| errors.len() <= inserts)
}
