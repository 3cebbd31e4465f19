//! The choice of gear units: units of the catalogue with the form's ratio against the demand of the runs at output and input.

use crate::drives::gear::{GearDuty, GearRefusal};
use crate::drives::inertia::CM2;
use crate::drives::parts::{GearRatings, Part, Ratings};
use crate::drives::shaft_motion::Motion;
use crate::machines::driven::{DrivenAxis, FormGear, InverterDrive};
use crate::msg;
use crate::text::Message;
use crate::text::catalog::number_text;
use crate::view::FieldEntry;

/// Greatest relative difference of equal ratios.
const SAME_RATIO: f64 = 1e-6;

/// A gear unit of a machine: the demand on it, and the available units.
#[derive(Debug, Clone, PartialEq)]
pub struct SizedGear {
    /// Speed of its input over that of its output.
    pub ratio: f64,
    /// Demand of the runs on it.
    pub duty: GearDuty,
    /// Units of this ratio: passing ones by rising size, then the others by their reason.
    pub candidates: Vec<GearCandidate>,
    /// If the catalogue has none of this ratio: the next lower and the next higher one, as far as there are.
    pub next_ratios: Vec<f64>,
}

impl SizedGear {
    /// The smallest unit that passes; none if none does.
    pub fn least(&self) -> Option<&Part> {
        self.candidates.iter().find(|candidate| candidate.reason.is_none()).map(|candidate| &candidate.part)
    }
}

/// A gear unit for an axis or a drive.
#[derive(Debug, Clone, PartialEq)]
pub struct GearCandidate {
    /// The gear unit.
    pub part: Part,
    /// Its ratings.
    pub ratings: GearRatings,
    /// First reason of its refusal; none if it passes.
    pub reason: Option<GearRefusal>,
    /// Entries of the form with this unit: ids of fields and typed texts.
    pub entries: Vec<FieldEntry>,
}

impl GearCandidate {
    /// Its refusal in words; none if it passes.
    pub fn refusal(&self) -> Option<Message> {
        Some(match self.reason? {
            GearRefusal::Peak(torque, limit) => msg!("size.gear-peak", torque = (torque, 2), limit = (limit, 2)),
            GearRefusal::Mean(torque, limit) => msg!("size.gear-mean", torque = (torque, 2), limit = (limit, 2)),
            GearRefusal::Speed(speed, limit) => msg!("size.gear-speed", speed = (speed, 0), limit = (limit, 0)),
            GearRefusal::MeanSpeed(speed, limit) => {
                msg!("size.gear-mean-speed", speed = (speed, 0), limit = (limit, 0))
            }
            GearRefusal::Backlash(own, limit) => msg!("size.gear-backlash", backlash = (own, 2), limit = (limit, 2)),
            GearRefusal::Unknown => msg!("size.gear-unknown"),
        })
    }
}

/// The gear unit of a servo axis, over the motions of its motor in several runs; none without a gear unit.
pub(super) fn of_axis(axis: &DrivenAxis, motions: &[Motion], catalogue: &[&Part]) -> Option<SizedGear> {
    let gear = axis.gear.as_ref()?;
    let duties = motions.iter().map(|motion| GearDuty::new(&gear.output_motion(motion.segments()), gear.ratio));
    Some(sized(gear, duties.reduce(GearDuty::max).unwrap_or_default(), catalogue))
}

/// The gear unit of the motor on the inverter; none without one.
pub(super) fn of_inverter(drive: &InverterDrive, catalogue: &[&Part]) -> Option<SizedGear> {
    let gear = drive.gear.as_ref()?;
    Some(sized(gear, GearDuty::new(&gear.output_motion(&drive.speed_segments()), gear.ratio), catalogue))
}

fn sized(gear: &FormGear, duty: GearDuty, catalogue: &[&Part]) -> SizedGear {
    let all = catalogue.iter().filter_map(|part| match part.ratings {
        Ratings::Gear(ratings) => Some((*part, ratings, ratings.ratio?)),
        _ => None,
    });
    let is_same = |ratio: f64| (ratio - gear.ratio).abs() <= SAME_RATIO * gear.ratio;
    let (same, others): (Vec<_>, Vec<_>) = all.partition(|(_, _, ratio)| is_same(*ratio));
    let mut candidates: Vec<GearCandidate> = same
        .into_iter()
        .map(|(part, ratings, _)| {
            let reason = ratings.refuses(&duty, gear.backlash);
            GearCandidate { part: part.clone(), ratings, reason, entries: entries(gear, &ratings, reason) }
        })
        .collect();
    candidates.sort_by(|a, b| {
        let size = |of: &GearCandidate| of.ratings.rated_torque.unwrap_or(f64::INFINITY);
        let rank = |of: &GearCandidate| of.reason.map(rank);
        rank(a).cmp(&rank(b)).then(size(a).total_cmp(&size(b))).then_with(|| a.part.model.cmp(&b.part.model))
    });
    let ratios = || others.iter().map(|(_, _, ratio)| *ratio);
    let lower = ratios().filter(|ratio| *ratio < gear.ratio).reduce(f64::max);
    let higher = ratios().filter(|ratio| *ratio > gear.ratio).reduce(f64::min);
    let next_ratios = if candidates.is_empty() { lower.into_iter().chain(higher).collect() } else { Vec::new() };
    SizedGear { ratio: gear.ratio, duty, candidates, next_ratios }
}

/// Order of the reasons: the smallest shortage first.
fn rank(reason: GearRefusal) -> u8 {
    match reason {
        GearRefusal::Backlash(..) => 0,
        GearRefusal::MeanSpeed(..) => 1,
        GearRefusal::Speed(..) => 2,
        GearRefusal::Mean(..) => 3,
        GearRefusal::Peak(..) => 4,
        GearRefusal::Unknown => 5,
    }
}

/// Entries of the form with a gear unit, as far as its source has them; none if its ratings do not suffice for a verdict.
fn entries(gear: &FormGear, ratings: &GearRatings, reason: Option<GearRefusal>) -> Vec<FieldEntry> {
    if reason == Some(GearRefusal::Unknown) {
        return Vec::new();
    }
    let efficiency =
        ratings.efficiency.map(|part| FieldEntry::new(gear.fields.efficiency, number_text(100.0 * part, 1)));
    let inertia = gear.fields.inertia.zip(ratings.inertia);
    let inertia = inertia.map(|(field, inertia)| FieldEntry::new(field, number_text(inertia / CM2, 4)));
    // If backlash has an effect, the form gets that of the gear unit.
    let backlash = gear.fields.backlash.filter(|_| gear.backlash.is_some()).zip(ratings.backlash);
    let backlash = backlash.map(|(field, backlash)| FieldEntry::new(field, number_text(backlash, 2)));
    efficiency.into_iter().chain(inertia).chain(backlash).collect()
}
