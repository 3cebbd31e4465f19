//! Cutter, ratio and section of the polygon lathe, from the form. Lengths in mm, angles in radians.

use std::cell::RefCell;
use std::collections::VecDeque;
use std::rc::Rc;

use super::params::Params;
use crate::drives::polygon::choose::{Cutter, LatheLimits, PolygonSpec};
use crate::drives::polygon::cut::{self, InsertLoad};
use crate::drives::polygon::load::{self, PassLoad};
use crate::drives::polygon::{CutterSetup, Ratio, Section};
use crate::math::PI;
use crate::text::catalog::number_text as show;
use crate::text::number;
use crate::view::FieldEntry;

/// Radians in a degree.
const RADIANS: f64 = PI / 180.0;

/// Greatest radial error of an insert (mm), and greatest angular error (°).
pub(super) const RADIUS_ERROR: f64 = 1.0;
pub(super) const ANGLE_ERROR: f64 = 10.0;

/// Number of results kept: enough for the three polygons of a part and one changed value of each.
const KEPT: usize = 6;

/// Results with their inputs, the newest first.
type Kept<K, V> = RefCell<VecDeque<(K, V)>>;

/// Inputs of the loads of all passes: sizes across flats, tip radius, ratio, number of inserts, and radius of the stock.
type PassInputs = (Vec<f64>, f64, Ratio, u32, f64);

thread_local! {
    /// Sections by cutter and radius of the stock. The search for repairs and sensitivities needs the same ones hundreds of times with
    /// other machine data; the loads of many passes too.
    static LAST_SECTIONS: Kept<(CutterSetup, f64), Option<Section>> = const { RefCell::new(VecDeque::new()) };
    static LAST_LOADS: Kept<PassInputs, Rc<[PassLoad]>> = const { RefCell::new(VecDeque::new()) };
}

/// The kept result of these inputs, or a new one, which is kept.
fn kept<K: PartialEq, V: Clone>(all: &Kept<K, V>, inputs: K, new: impl FnOnce(&K) -> V) -> V {
    let mut all = all.borrow_mut();
    if let Some((_, result)) = all.iter().find(|(of, _)| *of == inputs) {
        return result.clone();
    }
    let result = new(&inputs);
    all.truncate(KEPT - 1);
    all.push_front((inputs, result.clone()));
    result
}

impl Params {
    /// Tool to work speed; none where D or Q is 0.
    pub(super) fn ratio(&self) -> Option<Ratio> {
        Ratio::new(self.tool_ratio as i32, self.work_ratio as i32)
    }

    /// The cutter at a distance across flats, with the errors of its inserts.
    pub(super) fn setup(&self, across_flats: f64) -> Option<CutterSetup> {
        let mut setup = CutterSetup::even(across_flats, self.tip_radius, self.ratio()?, self.inserts as u32);
        (setup.work_start, setup.tool_start) = (self.work_start * RADIANS, self.tool_start * RADIANS);
        let angles = insert_deviations(&self.angle_errors, setup.tips.len(), ANGLE_ERROR).unwrap_or_default();
        for (tip, error) in setup.tips.iter_mut().zip(self.insert_radius_errors()) {
            tip.radius += error;
        }
        for (tip, error) in setup.tips.iter_mut().zip(angles) {
            tip.angle += error * RADIANS;
        }
        Some(setup)
    }

    /// Radial errors (mm) of the inserts, in their order; none for those behind the last entry, or where an entry is wrong.
    pub(super) fn insert_radius_errors(&self) -> Vec<f64> {
        insert_deviations(&self.radius_errors, self.inserts as usize, RADIUS_ERROR).unwrap_or_default()
    }

    /// Number (from 1) of every pass, with its needed relief and its cutting speeds. `sizes`: across flats of the
    /// passes, mm.
    pub(super) fn cuts(&self, setup: &CutterSetup, sizes: &[f64]) -> Vec<(f64, InsertLoad)> {
        let cuts = cut::passes(sizes, self.tip_radius, setup.ratio, setup.sides(), 0.5 * self.blank());
        (1_u32..).map(f64::from).zip(cuts).collect()
    }

    /// The loads of passes of these `sizes` across flats.
    pub(super) fn pass_loads(&self, sizes: &[f64], ratio: Ratio) -> Rc<[PassLoad]> {
        let inputs = (sizes.to_vec(), self.tip_radius, ratio, self.inserts as u32, 0.5 * self.blank());
        LAST_LOADS.with(|last| {
            kept(last, inputs, |(sizes, radius, ratio, inserts, stock)| {
                load::passes(sizes, *radius, *ratio, *inserts, *stock).collect()
            })
        })
    }

    /// The finished section.
    pub(super) fn section(&self) -> Option<Section> {
        self.section_in(0.5 * self.blank())
    }

    /// The section cut out of stock of this radius, mm.
    pub(super) fn section_in(&self, stock: f64) -> Option<Section> {
        let setup = self.setup(self.across_flats)?;
        LAST_SECTIONS.with(|last| kept(last, (setup, stock), |(setup, stock)| Section::new(setup, *stock)))
    }

    /// The polygon to be turned, in passes of these `sizes` across flats.
    pub(super) fn polygon_spec<'s>(&self, sizes: &'s [f64]) -> PolygonSpec<'s> {
        PolygonSpec {
            sides: self.sides as u32,
            sizes,
            stock: 0.5 * self.blank(),
            flatness: self.flatness,
            hollow: self.hollow,
        }
    }

    /// Cutters, ratios, speeds and distances that the machine allows; `at_full_feed` leads from a limit of a speed to that at 100 % of the
    /// feed override.
    pub(super) fn lathe_limits(&self, at_full_feed: impl Fn(f64) -> f64) -> LatheLimits {
        let radius = (self.least_radius.min(self.greatest_radius), self.greatest_radius);
        let cutter = |inserts: u32| Cutter { inserts, radius, relief: self.relief * RADIANS };
        LatheLimits {
            cutters: (1..=self.most_inserts as u32).map(cutter).collect(),
            terms: (self.most_tool_turns as u32, self.most_work_turns as u32),
            against: self.against,
            work_speed: at_full_feed(self.axes.work.limit),
            tool_speed: at_full_feed(self.axes.tool.limit),
            distance: (self.least_distance, self.greatest_distance),
            cutting_speed: (self.slowest_cut, at_full_feed(self.fastest_cut)),
        }
    }
}

/// Position errors of the inserts, in their order, from the text of the form; none if one is not a number or is greater
/// than `most`, or if there are more of them than inserts.
pub(super) fn insert_deviations(text: &str, inserts: usize, most: f64) -> Option<Vec<f64>> {
    let within = |deviation: &f64| deviation.abs() <= most;
    let all: Option<Vec<f64>> = text.split_whitespace().map(|each| number::read(each).filter(within)).collect();
    all.filter(|all| all.len() <= inserts)
}

/// Entries of the form for a cutter and a ratio, with the shape `own`.
pub(super) fn own_shape(sides: f64, inserts: f64, (tool, work): (f64, f64)) -> Vec<FieldEntry> {
    let number = |id, value| FieldEntry::new(id, show(value, 0));
    vec![
        FieldEntry::new("shape", "own"),
        number("sides", sides),
        number("inserts", inserts),
        number("work-ratio", work),
        number("tool-ratio", tool),
    ]
}
