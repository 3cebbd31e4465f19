//! Axis scaling of a machine on a control: its parameters from gears, leads and encoders, and the remainder that whole numbers leave.

use crate::controls::{Control, ParamRole, ScalingKind};
use crate::drives::scaling::Fraction;
use crate::machines::form::Field;
use crate::machines::form::rows::{Member, number};
use crate::machines::sheets::{ParamValue, ParamValues};
use crate::machines::verdict::{Judgement, fail, ok, warn};
use crate::msg;
use crate::view::Limit::AtMost;

/// Greatest numerator of the detection units between two marks: eight digits (FANUC 1821, from memory).
const GREATEST_COUNTS: u64 = 99_999_999;

/// Units of a turn of a rotary axis, as controls have it.
const TURN: f64 = 360.0;

/// Turns of a gear in the same time, or the teeth of its opposite wheels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GearTurns {
    /// Turns of the motor, or teeth on the driven side.
    pub motor: f64,
    /// Turns of screw, roller or table, or teeth on the motor's side.
    pub load: f64,
}

/// The drive of an axis.
#[derive(Debug, Clone, Copy)]
pub struct AxisDrive {
    /// Name of the axis on the sheets.
    pub axis: &'static str,
    /// Travel per turn of screw, roller or table, in mm or °.
    pub lead: f64,
    /// The gear between motor and screw, roller or table.
    pub gear: GearTurns,
    /// Counts of the encoder per turn of the motor.
    pub encoder: f64,
    /// Whether the control treats it as a rotary axis: a turn has 360 units.
    pub rotary: bool,
    /// Units of a programmed word per millimetre: 2 for diameters.
    pub words: f64,
}

/// Scaling of an axis by the parameters of a control.
#[derive(Debug, Clone, PartialEq)]
pub struct Scaling {
    /// Values by parameter.
    values: Vec<(ParamRole, f64)>,
    /// Travel per turn of the motor by these parameters, in mm or °.
    travel: f64,
}

impl AxisDrive {
    /// Travel per turn of the motor, in mm or °: `lead · load turns / motor turns`.
    pub fn travel(&self) -> f64 {
        self.lead * self.gear.load / self.gear.motor
    }

    /// Scaling in the parameters of the control; `None` if the control has no such parameters, or if no whole numbers
    /// in their ranges suffice.
    pub fn scaling(&self, control: &Control) -> Option<Scaling> {
        let row = control.scaling?;
        let (increment, terms) = (control.limits.increment, row.greatest_term);
        match row.kind {
            ScalingKind::Counts => self.by_counts(increment / self.words, terms),
            ScalingKind::FeedGear { feedback, multiplier, diameter_multiplier } => {
                let multiplier = if self.words > 1.0 { diameter_multiplier } else { multiplier };
                self.by_feed_gear(increment, feedback, multiplier, terms)
            }
            ScalingKind::WholeLead => self.by_whole_lead(terms),
            ScalingKind::Lead => self.by_lead(terms),
        }
    }

    /// Relative error of the travel by rounded parameters: `T / T' - 1`, with the travel T per turn of the motor and T' that of the
    /// parameters; 0 if whole numbers give it exactly.
    pub fn error(&self, control: &Control) -> Option<f64> {
        let error = self.travel() / self.scaling(control)?.travel - 1.0;
        // Below the resolution of a double.
        Some(if error.abs() < 1e-14 { 0.0 } else { error })
    }

    /// `over / under = counts · unit / travel`, with the counts of the encoder and the travel per turn of the motor.
    fn by_counts(&self, unit: f64, terms: u64) -> Option<Scaling> {
        let fraction = Fraction::nearest(self.encoder * unit / self.travel(), terms)?;
        let values =
            vec![(ParamRole::CountsOver, fraction.over as f64), (ParamRole::CountsUnder, fraction.under as f64)];
        Some(Scaling { values, travel: self.encoder * unit / fraction.value() })
    }

    /// `over / under = travel / unit / feedback`, with the detection unit in mm of travel, the travel and the feedback counts per turn of
    /// the motor.
    fn by_feed_gear(&self, unit: f64, feedback: f64, multiplier: f64, terms: u64) -> Option<Scaling> {
        let fraction = Fraction::nearest(self.travel() / unit / feedback, terms)?;
        let travel = fraction.value() * feedback * unit;
        let mut values = vec![(ParamRole::CommandMultiplier, multiplier)];
        match Fraction::nearest(travel / unit, GREATEST_COUNTS).filter(|counts| counts.under <= terms) {
            // Rounded: the zero point moves by at most half a unit per turn of the motor from it.
            None => values.push((ParamRole::ReferenceCounts, (travel / unit).round())),
            Some(counts) => {
                values.push((ParamRole::ReferenceCounts, counts.over as f64));
                values.extend((counts.under > 1).then_some((ParamRole::ReferenceCountsUnder, counts.under as f64)));
            }
        }
        values.extend([
            (ParamRole::FeedGearOver, fraction.over as f64),
            (ParamRole::FeedGearUnder, fraction.under as f64),
        ]);
        Some(Scaling { values, travel })
    }

    /// `travel = lead · load turns / motor turns`, with the lead in whole millimetres, 360 for a rotary axis.
    fn by_whole_lead(&self, terms: u64) -> Option<Scaling> {
        let lead = match self.lead.fract() == 0.0 {
            _ if self.rotary => TURN,
            true => self.lead,
            false => 10.0,
        };
        let fraction = Fraction::nearest(self.travel() / lead, terms)?;
        let values = vec![
            (ParamRole::LoadTurns, fraction.over as f64),
            (ParamRole::MotorTurns, fraction.under as f64),
            (ParamRole::WholeLead, lead),
            (ParamRole::EncoderCounts, self.encoder),
        ];
        Some(Scaling { values, travel: lead * fraction.value() })
    }

    /// `travel = lead · load turns / motor turns`; of a rotary axis `360 · load turns / motor turns`.
    fn by_lead(&self, terms: u64) -> Option<Scaling> {
        // Six decimals are written.
        let lead = if self.rotary { TURN } else { (self.lead * 1e6).round() / 1e6 };
        let ratio = if self.rotary { self.travel() / TURN } else { self.gear.load / self.gear.motor };
        let fraction = Fraction::nearest(ratio, terms)?;
        let mut values = vec![
            (ParamRole::LoadTurns, fraction.over as f64),
            (ParamRole::MotorTurns, fraction.under as f64),
            (ParamRole::EncoderCounts, self.encoder),
        ];
        if !self.rotary {
            values.push((ParamRole::Lead, lead));
        }
        Some(Scaling { values, travel: lead * fraction.value() })
    }
}

/// Greatest drift, in millionths of the travel: 1 µm in a metre (engineering choice).
const MOST: f64 = 1.0;

/// Error of the travel in millionths that the whole numbers of the parameters leave; 0 if they give it exactly.
pub fn parts_per_million(control: &Control, drive: &AxisDrive) -> f64 {
    drive.error(control).map_or(0.0, |error| 1e6 * error)
}

/// Judges that error against the greatest drift.
pub fn judge(control: &Control, drive: &AxisDrive) -> Option<Judgement> {
    let limit = AtMost(MOST);
    match drive.error(control) {
        _ if control.scaling.is_none() => None,
        None => fail(None, [msg!("scaling.no-ratio", axis = drive.axis).into()]),
        Some(error) if 1e6 * error.abs() > MOST => {
            warn(limit, [msg!("scaling.drifts", axis = drive.axis, millionths = (1e6 * error, 4)).into()])
        }
        Some(_) => ok(limit),
    }
}

/// Rows of the parameter sheet for the scaling of axes.
pub fn parameters(control: &Control, drives: &[AxisDrive]) -> ParamValues<'static> {
    let scaled = drives.iter().filter_map(|drive| Some((drive.axis, drive.scaling(control)?)));
    let values = scaled.flat_map(|(axis, scaling)| scaling.values.into_iter().map(move |value| (axis, value)));
    values.map(|(axis, (role, value))| (role, vec![(axis, ParamValue::Fine(value))])).collect()
}

/// A field for the lead of a screw.
pub const fn lead<P>(id: &'static str, group: &'static str, label: &'static str, member: Member<P, f64>) -> Field<P> {
    let row = number(id, member).group(group).label(label).help("scaling.lead.help");
    row.unit("mm").range(0.1..=1000.0).default(5.0).decimals(4).step(1.0).fact()
}

/// A field for the teeth of a gear.
pub const fn teeth<P>(id: &'static str, group: &'static str, label: &'static str, member: Member<P, f64>) -> Field<P> {
    let row = number(id, member).group(group).label(label).help("scaling.teeth.help");
    row.range(1.0..=1000.0).default(1.0).decimals(0).step(1.0).fact()
}

/// A field for the counts of the encoders.
pub const fn encoder<P>(
    id: &'static str,
    group: &'static str,
    label: &'static str,
    member: Member<P, f64>,
) -> Field<P> {
    let row = number(id, member).group(group).label(label).help("scaling.encoder.help");
    row.unit("p/rev").range(1.0..=100_000_000.0).default(10_000.0).decimals(0).step(1000.0).fact()
}
