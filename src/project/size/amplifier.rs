//! The amplifier of a servo motor and its brake resistor: the smallest of the catalogue, and the shortage where none suffices.

use super::demand::LEAST_RETURNED;
use crate::controls::Control;
use crate::drives::load::Regeneration;
use crate::drives::parts::{AmplifierRatings, Part, Ratings};
use crate::drives::shaft_motion::ResistorLoad;
use crate::msg;
use crate::project::parts::goes_with;
use crate::text::Message;

/// The smallest part of the catalogue that the control can use, the filter accepts and that has a size.
pub(super) fn smallest<'a>(
    catalogue: &[&'a Part],
    control: &Control,
    size: impl Fn(&Part) -> Option<f64>,
) -> Option<&'a Part> {
    let sized = catalogue.iter().filter(|part| goes_with(part, control)).filter_map(|part| Some((size(part)?, *part)));
    sized.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, part)| part)
}

/// The smallest amplifier paired with a servo motor that has its currents for an effective and a greatest torque (Nm), as far as both are
/// known.
pub(super) fn amplifier<'a>(
    motor: &Part,
    (effective, peak): (f64, f64),
    catalogue: &[&'a Part],
    control: &Control,
) -> Option<&'a Part> {
    let Ratings::Servo(ratings) = &motor.ratings else { return None };
    let gives = |current: Option<f64>, torque: f64| {
        current.zip(ratings.ampere_per_torque()).is_none_or(|(current, per_torque)| torque * per_torque <= current)
    };
    smallest(catalogue, control, |other| match &other.ratings {
        Ratings::Amplifier(of) if other.fits.contains(&motor.model) => {
            let does = gives(of.rated_current, effective) && gives(of.peak_current, peak);
            does.then(|| of.rated_power.unwrap_or(f64::MAX))
        }
        _ => None,
    })
}

/// Shortage of the amplifiers paired with a servo motor for an effective and a greatest torque (Nm): the currents of the largest one; none
/// if none is paired, or no current is known.
pub(super) fn shortage(
    motor: &Part,
    (effective, peak): (f64, f64),
    catalogue: &[&Part],
    control: &Control,
) -> Option<Message> {
    let Ratings::Servo(ratings) = &motor.ratings else { return None };
    let per_torque = ratings.ampere_per_torque()?;
    let paired = catalogue.iter().filter(|part| goes_with(part, control)).filter_map(|part| match &part.ratings {
        Ratings::Amplifier(of) if part.fits.contains(&motor.model) => Some((part, of)),
        _ => None,
    });
    let size = |of: &AmplifierRatings| of.rated_current.or(of.peak_current).unwrap_or(0.0);
    let (part, of) = paired.max_by(|a, b| size(a.1).total_cmp(&size(b.1)))?;
    let short =
        |has: Option<f64>, torque: f64| has.map(|has| (torque * per_torque, has)).filter(|(asked, has)| asked > has);
    let amplifier = part.model.as_str();
    if let Some((current, limit)) = short(of.rated_current, effective) {
        return Some(msg!("size.refused-amplifier", current = (current, 2), amplifier, limit = (limit, 2)));
    }
    let (current, limit) = short(of.peak_current, peak)?;
    Some(msg!("size.refused-amplifier-peak", current = (current, 2), amplifier, limit = (limit, 2)))
}

/// A brake resistor beside an amplifier.
#[derive(Debug, Clone, PartialEq)]
pub struct Resistor {
    /// Demand on the resistor.
    pub demand: ResistorLoad,
    /// The resistor; none if the catalogue has none.
    pub part: Option<Part>,
    /// Whether the catalogue lacks the energy that the amplifier absorbs by itself: the demand is then all of the
    /// energy, and its maker has to be asked.
    pub is_unknown: bool,
}

/// Brake resistor for the regenerated energy beyond the amplifier's own resistor, whose continuous power (W) may be known; none without
/// such energy.
pub(super) fn resistor(
    amplifier: &Part,
    demand: ResistorLoad,
    own: Option<f64>,
    catalogue: &[&Part],
    control: &Control,
) -> Option<Resistor> {
    let is_needed = demand.mean > own.unwrap_or(0.0).max(LEAST_RETURNED);
    is_needed.then(|| {
        let part = smallest(catalogue, control, |other| match &other.ratings {
            Ratings::Resistor(of) if other.fits.contains(&amplifier.model) => {
                of.takes(&demand).then_some(of.brake_power).flatten()
            }
            _ => None,
        });
        Resistor { demand, part: part.cloned(), is_unknown: false }
    })
}

/// Regeneration of an amplifier, if its capacitors or its own resistor are known, and the continuous power (W) of that resistor. An unknown
/// efficiency counts as 1.
pub(super) fn braking(amplifier: &Part) -> Option<(Regeneration, Option<f64>)> {
    let Ratings::Amplifier(AmplifierRatings { regeneration_efficiency, capacitor_energy, brake_power, .. }) =
        &amplifier.ratings
    else {
        return None;
    };
    let back =
        Regeneration { efficiency: regeneration_efficiency.unwrap_or(1.0), capacitor: capacitor_energy.unwrap_or(0.0) };
    let own = brake_power.filter(|most| *most > 0.0);
    (own.is_some() || capacitor_energy.is_some()).then_some((back, own))
}
