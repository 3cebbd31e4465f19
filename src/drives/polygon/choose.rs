//! Selection of cutters for a polygon: inserts, ratio and tip circle, their form error, and the limits that exclude choices.

use super::cut::{self, InsertLoad};
use super::ratio::Ratio;
use super::section::{SAME_LENGTH, Section};
use super::setup::CutterSetup;
use crate::math::{self, PI};

/// The required polygon. Lengths in mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PolygonSpec<'a> {
    /// Number of sides.
    pub sides: u32,
    /// Distance across flats of each pass of the slide, the last being the finished one; for an odd number of sides, twice the distance of
    /// a side from the centre.
    pub sizes: &'a [f64],
    /// Radius of the stock.
    pub stock: f64,
    /// Greatest flatness error of a side.
    pub flatness: f64,
    /// Whether a side may be concave.
    pub hollow: bool,
}

/// A cutter that fits the machine.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cutter {
    /// Number of inserts, evenly spaced.
    pub inserts: u32,
    /// Least and greatest radius of the tip circle in mm; equal if it is fixed.
    pub radius: (f64, f64),
    /// Relief angle of the inserts in radians.
    pub relief: f64,
}

/// Cutters and limits of the machine.
#[derive(Debug, Clone, PartialEq)]
pub struct LatheLimits {
    /// Its cutters.
    pub cutters: Vec<Cutter>,
    /// Greatest term of the ratio for the tool, and for the work.
    pub terms: (u32, u32),
    /// Whether tool and work may turn in opposite directions.
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

/// Reason for excluding a choice.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ChoiceLimit {
    /// Tool and work would turn in opposite directions.
    Sense,
    /// The distance of the axes is outside its range.
    Distance,
    /// The stock is large enough for corners, but adjacent sides do not meet in it.
    Gap,
    /// The sides are concave.
    Hollow,
    /// The flatness error is too great.
    Flatness,
    /// The inserts have too little relief.
    Relief,
    /// The cutting speed is too low at the greatest speed of the work.
    WorkSpeed,
    /// The cutting speed is too low at the greatest speed of the tool.
    ToolSpeed,
    /// The cutting speed along a side varies more than its range allows.
    CuttingSpeed,
}

/// A combination of cutter, ratio and tip circle for the polygon.
#[derive(Debug, Clone, PartialEq)]
pub struct Choice {
    /// Index of the cutter in the means.
    pub cutter: usize,
    /// Tool to work speed.
    pub ratio: Ratio,
    /// Radius of the tip circle in whole µm, as in the form: the radius with the flattest sides if the cutter is adjustable.
    pub radius: f64,
    /// Least and greatest deviation of a side from its plane in mm.
    pub deviation: (f64, f64),
    /// Relief angle in radians that the inserts have to exceed, in the most demanding pass.
    pub relief: f64,
    /// Speed that the terms of the ratio multiply, in whole r/min as in a program: the highest within all limits.
    pub speed: f64,
    /// Speed of the work in r/min.
    pub work_speed: f64,
    /// Speed of the tool in r/min; negative if opposite to the work.
    pub tool_speed: f64,
    /// Least and greatest cutting speed in m/min.
    pub cutting_speed: (f64, f64),
    /// Reasons for excluding it; empty if it is possible.
    pub limits: Vec<ChoiceLimit>,
}

impl Choice {
    /// Flatness error in mm.
    pub fn flatness(&self) -> f64 {
        self.deviation.1 - self.deviation.0
    }

    /// Sort key, lower is better. The bits of a non-negative number sort like the number; excluded choices have the top bit set.
    fn rank(&self) -> u64 {
        self.flatness().max(0.0).to_bits() | u64::from(!self.limits.is_empty()) << 63
    }
}

/// All choices for a polygon on a machine, possible ones first, by flatness within each group.
pub fn choices(spec: &PolygonSpec, lathe: &LatheLimits) -> Vec<Choice> {
    let mut found = Vec::new();
    for cutter in 0..lathe.cutters.len() {
        for work in 1..=lathe.terms.1.min(MOST_TURNS) {
            let forward = Ratio::for_sides(spec.sides, lathe.cutters[cutter].inserts, work);
            let Some(forward) = forward.filter(|ratio| ratio.tool().unsigned_abs() <= lathe.terms.0) else { continue };
            let against = Ratio::new(-forward.tool(), forward.work());
            found.extend(
                [Some(forward), against].into_iter().flatten().filter_map(|ratio| choice(spec, lathe, cutter, ratio)),
            );
        }
    }
    found.sort_by_key(Choice::rank);
    found
}

/// Maximum turns of the work until a pattern closes.
const MOST_TURNS: u32 = 100;

/// A cutter at a ratio, with the best radius of its tip circle. (At ratio 2 that is the greatest radius; above 2 it is a radius in between,
/// where convex and concave deviation balance.)
fn choice(spec: &PolygonSpec, lathe: &LatheLimits, cutter: usize, ratio: Ratio) -> Option<Choice> {
    let (low, high) = lathe.cutters.get(cutter)?.radius;
    // Rounded to the digits of the form, because the next digit matters beside a radius at which a side breaks off.
    let set = |radius: f64| set(spec, lathe, cutter, ratio, (radius * 1000.0).round() / 1000.0);
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
        // Ternary search between the neighbours of the best step.
        let (mut from, mut to) = (at(least.saturating_sub(1)), at((least + 1).min(STEPS)));
        for _ in 0..30 {
            let third = (to - from) / 3.0;
            if put(from + third) < put(to - third) { to -= third } else { from += third }
        }
    }
    best
}

/// Number of steps in the search over the radii of a cutter.
const STEPS: u32 = 24;

/// A cutter at a ratio and a radius of its tip circle.
fn set(spec: &PolygonSpec, lathe: &LatheLimits, cutter: usize, ratio: Ratio, radius: f64) -> Option<Choice> {
    let head = lathe.cutters.get(cutter)?;
    let across_flats = *spec.sizes.last()?;
    let setup = CutterSetup::even(across_flats, radius, ratio, head.inserts);
    let section = Section::new(&setup, spec.stock)?;
    let side = section.side(0)?;
    let passes = cut::passes(spec.sizes, radius, ratio, spec.sides, spec.stock);
    let InsertLoad { relief, speeds: each } = passes.reduce(InsertLoad::worst)?;

    let (work, tool) = (f64::from(ratio.work()), f64::from(ratio.tool()));
    let suits = lathe.cutting_speed.1 / each.1 / work;
    let (fastest, bound) =
        [(lathe.work_speed / work, ChoiceLimit::WorkSpeed), (lathe.tool_speed / tool.abs(), ChoiceLimit::ToolSpeed)]
            .into_iter()
            .fold((suits, ChoiceLimit::CuttingSpeed), |least, next| if next.0 < least.0 { next } else { least });
    let speed = fastest.floor().max(1.0);
    let work_speed = speed * work;

    let full = 0.5 * across_flats / math::cos(PI / f64::from(spec.sides.max(3)));
    let gap = spec.sides > 2 && spec.stock >= full && !section.corners().first().is_some_and(|corner| corner.meets);
    let held = [
        (ChoiceLimit::Sense, ratio.value() < 0.0 && !lathe.against),
        (ChoiceLimit::Distance, setup.distance < lathe.distance.0 || setup.distance > lathe.distance.1),
        (ChoiceLimit::Gap, gap),
        (ChoiceLimit::Hollow, side.high > SAME_LENGTH && !spec.hollow),
        (ChoiceLimit::Flatness, side.flatness() > spec.flatness),
        (ChoiceLimit::Relief, relief >= head.relief),
        (bound, speed > fastest || each.0 * work_speed < lathe.cutting_speed.0),
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
