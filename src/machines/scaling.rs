//! Axis scaling of a machine on a control: its parameters from gears, leads and encoders, and the remainder that whole numbers leave.

use super::form::Field;
use super::form::rows::{Member, number};
use super::sheets::{AxisValues, ParamValue};
use super::verdict::{Judgement, fail, ok, warn};
use crate::controls::{Control, ParamRole};
use crate::drives::scaling::Fraction;
use crate::msg;
use crate::view::Limit::AtMost;

/// Greatest term of a gear parameter that all controls with such parameters take (FANUC 2084, GSK No.015, Mitsubishi #2201).
const TERMS: u64 = 32_767;

/// Greatest term of the gear of a Siemens control: it takes more, but no gear needs more.
const LONG_TERMS: u64 = 1_000_000;

/// Detection units per motor turn to which a FANUC control scales any encoder.
const FEEDBACK: f64 = 1_000_000.0;

/// Units of a turn of a rotary axis, as controls have it.
const TURN: f64 = 360.0;

/// The drive of an axis.
#[derive(Debug, Clone, Copy)]
pub struct AxisDrive<'a> {
    /// Name of the axis on the sheets.
    pub axis: &'a str,
    /// Travel per turn of screw, roller or table, in mm or °.
    pub lead: f64,
    /// Turns of the motor and of screw, roller or table in the same time: the teeth of the gear the other way round.
    pub gear: (f64, f64),
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

impl AxisDrive<'_> {
    /// Travel per turn of the motor, in mm or °: `lead · load turns / motor turns`.
    pub fn travel(&self) -> f64 {
        self.lead * self.gear.1 / self.gear.0
    }

    /// Scaling as the control has it; `None` where the control has no such parameters, or no whole numbers that do.
    pub fn scaling(&self, control: &Control) -> Option<Scaling> {
        let has = |role| control.param(role).is_some();
        let increment = control.limits.increment;
        if has(ParamRole::CountsOver) {
            self.by_counts(increment / self.words)
        } else if has(ParamRole::FeedGearOver) {
            self.by_feed_gear(increment)
        } else if has(ParamRole::WholeLead) {
            self.by_whole_lead()
        } else if has(ParamRole::Lead) {
            self.by_lead()
        } else {
            None
        }
    }

    /// Whether the control has parameters for it.
    pub fn is_scaled(control: &Control) -> bool {
        let roles = [ParamRole::CountsOver, ParamRole::FeedGearOver, ParamRole::WholeLead, ParamRole::Lead];
        roles.into_iter().any(|role| control.param(role).is_some())
    }

    /// Relative error of the travel by rounded parameters: `T / T' - 1`, with the travel T per turn of the motor and T' that of the
    /// parameters; 0 if whole numbers give it exactly.
    pub fn error(&self, control: &Control) -> Option<f64> {
        let error = self.travel() / self.scaling(control)?.travel - 1.0;
        // Below the resolution of a double.
        Some(if error.abs() < 1e-14 { 0.0 } else { error })
    }

    /// GSK: `CMR / CMD = counts · unit / travel`, with the counts of the encoder per turn of the motor. Source: GSK980MDi manual, p.401.
    fn by_counts(&self, unit: f64) -> Option<Scaling> {
        let fraction = Fraction::nearest(self.encoder * unit / self.travel(), TERMS)?;
        let values =
            vec![(ParamRole::CountsOver, fraction.over as f64), (ParamRole::CountsUnder, fraction.under as f64)];
        Some(Scaling { values, travel: self.encoder * unit / fraction.value() })
    }

    /// FANUC: `N / M = travel / unit / 1 000 000`, unit of detection 0.001 mm of travel; a command in diameters has half of it, CMR 1/2.
    fn by_feed_gear(&self, unit: f64) -> Option<Scaling> {
        let fraction = Fraction::nearest(self.travel() / unit / FEEDBACK, TERMS)?;
        let travel = fraction.value() * FEEDBACK * unit;
        let values = vec![
            (ParamRole::CommandMultiplier, if self.words > 1.0 { 102.0 } else { 2.0 }),
            (ParamRole::ReferenceCounts, travel / unit),
            (ParamRole::FeedGearOver, fraction.over as f64),
            (ParamRole::FeedGearUnder, fraction.under as f64),
        ];
        Some(Scaling { values, travel })
    }

    /// Mitsubishi: `travel = PIT · PC1 / PC2`, PIT in whole millimetres, 360 for a rotary axis.
    fn by_whole_lead(&self) -> Option<Scaling> {
        let lead = match self.lead.fract() == 0.0 {
            _ if self.rotary => TURN,
            true => self.lead,
            false => 10.0,
        };
        let fraction = Fraction::nearest(self.travel() / lead, TERMS)?;
        let values = vec![
            (ParamRole::LoadTurns, fraction.over as f64),
            (ParamRole::MotorTurns, fraction.under as f64),
            (ParamRole::WholeLead, lead),
            (ParamRole::EncoderCounts, self.encoder),
        ];
        Some(Scaling { values, travel: lead * fraction.value() })
    }

    /// Siemens: `travel = lead · load turns / motor turns`; of a rotary axis `360 · load turns / motor turns`.
    fn by_lead(&self) -> Option<Scaling> {
        // Six decimals are written.
        let lead = if self.rotary { TURN } else { (self.lead * 1e6).round() / 1e6 };
        let ratio = if self.rotary { self.travel() / TURN } else { self.gear.1 / self.gear.0 };
        let fraction = Fraction::nearest(ratio, LONG_TERMS)?;
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

/// The verdict about it.
pub fn judge(control: &Control, drive: &AxisDrive) -> Option<Judgement> {
    let limit = AtMost(MOST);
    match drive.error(control) {
        _ if !AxisDrive::is_scaled(control) => None,
        None => fail(None, [msg!("scaling.no-ratio", axis = drive.axis).into()]),
        Some(error) if 1e6 * error.abs() > MOST => {
            warn(limit, [msg!("scaling.drifts", axis = drive.axis, millionths = (1e6 * error, 4)).into()])
        }
        Some(_) => ok(limit),
    }
}

/// Rows of the parameter sheet for the scaling of axes.
pub fn parameters<'a>(control: &Control, drives: &[AxisDrive<'a>]) -> Vec<(ParamRole, AxisValues<'a>)> {
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
    row.range(1.0..=10_000.0).default(1.0).decimals(0).step(1.0).fact()
}

/// A field for the counts of the encoders.
pub const fn encoder<P>(id: &'static str, group: &'static str, member: Member<P, f64>) -> Field<P> {
    let row = number(id, member).group(group).label("scaling.encoder").help("scaling.encoder.help");
    row.unit("p/rev").range(1.0..=100_000_000.0).default(10_000.0).decimals(0).step(1000.0).fact()
}
