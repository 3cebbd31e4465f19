//! From the polygon to the cutter: inserts, ratio and tip circle, their form error, and the limit that rules others out.

use super::cut::{self, InsertLoad};
use super::ratio::Ratio;
use super::section::Section;
use super::setup::CutterSetup;
use crate::math::{self, PI};

/// The polygon that is wanted. Lengths in mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wanted<'a> {
    /// Number of sides.
    pub sides: u32,
    /// Distance across flats of every pass of the slide, the last one being the finished one; twice the distance of a side from the centre
    /// where the number of sides is odd.
    pub sizes: &'a [f64],
    /// Radius of the stock.
    pub stock: f64,
    /// Greatest flatness error of a side.
    pub flatness: f64,
    /// Whether a side may be hollow.
    pub hollow: bool,
}

/// A cutter that the machine takes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cutter {
    /// Number of inserts, evenly spaced.
    pub inserts: u32,
    /// Least and greatest radius of the tip circle in mm, the same where it cannot be set.
    pub radius: (f64, f64),
    /// Relief angle of the inserts in radians.
    pub relief: f64,
}

/// What the machine allows.
#[derive(Debug, Clone, PartialEq)]
pub struct Means {
    /// Its cutters.
    pub cutters: Vec<Cutter>,
    /// Greatest term of the ratio for the tool, and for the work.
    pub terms: (u32, u32),
    /// Whether tool and work may turn against each other.
    pub against: bool,
    /// Greatest speed of the work in r/min.
    pub work_speed: f64,
    /// Greatest speed of the tool in r/min.
    pub tool_speed: f64,
    /// Least and greatest distance of the axes in mm.
    pub distance: (f64, f64),
    /// Least and greatest cutting speed in m/min that suits inserts and material.
    pub cutting_speed: (f64, f64),
}

/// What excludes a choice.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ChoiceLimit {
    /// Tool and work would turn against each other.
    Sense,
    /// The axes do not come so near or go so far apart.
    Distance,
    /// The stock is large enough for corners, but the sides do not meet in it.
    Gap,
    /// The sides are hollow.
    Hollow,
    /// The flatness error is too great.
    Flatness,
    /// The inserts have too little relief.
    Relief,
    /// The greatest speed of the work is too slow a cut.
    WorkSpeed,
    /// The greatest speed of the tool is too slow a cut.
    ToolSpeed,
    /// The cutting speed varies more along a side than it may.
    CuttingSpeed,
}

/// One way to turn the polygon.
#[derive(Debug, Clone, PartialEq)]
pub struct Choice {
    /// Index of the cutter in the means.
    pub cutter: usize,
    /// Tool to work speed.
    pub ratio: Ratio,
    /// Radius of the tip circle in whole µm, as a form holds it: the flattest possible one where the cutter can be set.
    pub radius: f64,
    /// Least and greatest deviation of a side from its plane in mm.
    pub deviation: (f64, f64),
    /// Relief angle in radians that the inserts need more than in the pass that asks most of them.
    pub relief: f64,
    /// Speed that the terms of the ratio multiply, a whole number of r/min as a program has it: as fast as every limit allows.
    pub speed: f64,
    /// Speed of the work in r/min.
    pub work_speed: f64,
    /// Speed of the tool in r/min; negative against the work.
    pub tool_speed: f64,
    /// Least and greatest cutting speed in m/min.
    pub cutting_speed: (f64, f64),
    /// What excludes it; nothing where it is possible.
    pub limits: Vec<ChoiceLimit>,
}

impl Choice {
    /// Flatness error in mm.
    pub fn flatness(&self) -> f64 {
        self.deviation.1 - self.deviation.0
    }

    /// Lower is better. Numbers that are not negative have bits in their own order; what is excluded has the top bit.
    fn rank(&self) -> u64 {
        self.flatness().max(0.0).to_bits() | u64::from(!self.limits.is_empty()) << 63
    }
}

/// Every way to turn a polygon with the means of a machine: the possible ones first, the flattest first among them and among the others.
pub fn choices(wanted: &Wanted, means: &Means) -> Vec<Choice> {
    let mut found = Vec::new();
    for cutter in 0..means.cutters.len() {
        for work in 1..=means.terms.1.min(MOST_TURNS) {
            let forward = Ratio::for_sides(wanted.sides, means.cutters[cutter].inserts, work);
            let Some(forward) = forward.filter(|ratio| ratio.tool().unsigned_abs() <= means.terms.0) else { continue };
            let against = Ratio::new(-forward.tool(), forward.work());
            found.extend(
                [Some(forward), against].into_iter().flatten().filter_map(|ratio| choice(wanted, means, cutter, ratio)),
            );
        }
    }
    found.sort_by_key(Choice::rank);
    found
}

/// The most turns of the work in which a pattern may close.
const MOST_TURNS: u32 = 100;

/// A cutter at a ratio, its tip circle set to the best radius. (At ratio 2 that is the greatest one; above 2 there is one in between where crown and
/// hollow balance.)
fn choice(wanted: &Wanted, means: &Means, cutter: usize, ratio: Ratio) -> Option<Choice> {
    let (low, high) = means.cutters.get(cutter)?.radius;
    // What is found has to stay as it is found once it is typed: beside a radius at which a side breaks off, the next digit counts.
    let set = |radius: f64| set(wanted, means, cutter, ratio, (radius * 1000.0).round() / 1000.0);
    let rank = |choice: &Option<Choice>| choice.as_ref().map_or(u64::MAX, Choice::rank);
    let mut best = set(high);
    if low < high {
        let mut put = |radius: f64| {
            let next = set(radius);
            let found = rank(&next);
            if found < rank(&best) {
                best = next;
            }
            found
        };
        let at = |i: u32| low + (high - low) * f64::from(i) / f64::from(STEPS);
        let ranks: Vec<u64> = (0..=STEPS).map(|i| put(at(i))).collect();
        let least = (0..=STEPS).zip(ranks).min_by_key(|(_, rank)| *rank).map_or(STEPS, |(i, _)| i);
        // Between the neighbours of the best step, by thirds.
        let (mut from, mut to) = (at(least.saturating_sub(1)), at((least + 1).min(STEPS)));
        for _ in 0..30 {
            let third = (to - from) / 3.0;
            if put(from + third) < put(to - third) { to -= third } else { from += third }
        }
    }
    best
}

/// In how many steps the radii of a cutter are looked through.
const STEPS: u32 = 24;

/// A cutter at a ratio and a radius of its tip circle.
fn set(wanted: &Wanted, means: &Means, cutter: usize, ratio: Ratio, radius: f64) -> Option<Choice> {
    let head = means.cutters.get(cutter)?;
    let across_flats = *wanted.sizes.last()?;
    let setup = CutterSetup::even(across_flats, radius, ratio, head.inserts);
    let section = Section::new(&setup, wanted.stock)?;
    let side = section.side(0)?;
    let passes = cut::passes(wanted.sizes, radius, ratio, wanted.sides, wanted.stock);
    let InsertLoad { relief, speeds: each } = passes.reduce(InsertLoad::worst)?;

    let (work, tool) = (f64::from(ratio.work()), f64::from(ratio.tool()));
    let suits = means.cutting_speed.1 / each.1 / work;
    let (fastest, bound) =
        [(means.work_speed / work, ChoiceLimit::WorkSpeed), (means.tool_speed / tool.abs(), ChoiceLimit::ToolSpeed)]
            .into_iter()
            .fold((suits, ChoiceLimit::CuttingSpeed), |least, next| if next.0 < least.0 { next } else { least });
    let speed = fastest.floor().max(1.0);
    let work_speed = speed * work;

    let full = 0.5 * across_flats / math::cos(PI / f64::from(wanted.sides.max(3)));
    let gap = wanted.sides > 2 && wanted.stock >= full && !section.corners().first().is_some_and(|corner| corner.meets);
    let held = [
        (ChoiceLimit::Sense, ratio.value() < 0.0 && !means.against),
        (ChoiceLimit::Distance, setup.distance < means.distance.0 || setup.distance > means.distance.1),
        (ChoiceLimit::Gap, gap),
        (ChoiceLimit::Hollow, side.high > NOTHING && !wanted.hollow),
        (ChoiceLimit::Flatness, side.flatness() > wanted.flatness),
        (ChoiceLimit::Relief, relief >= head.relief),
        (bound, speed > fastest || each.0 * work_speed < means.cutting_speed.0),
    ];
    Some(Choice {
        cutter,
        ratio,
        radius,
        deviation: (side.low, side.high),
        relief,
        speed,
        work_speed,
        tool_speed: speed * tool,
        cutting_speed: (each.0 * work_speed, each.1 * work_speed),
        limits: held.iter().filter(|(_, holds)| *holds).map(|(limit, _)| *limit).collect(),
    })
}

/// A deviation in mm that is none.
const NOTHING: f64 = 1e-9;
