//! The choice of motors: every motor of the catalogue for the control, against the demand of the run.

use super::amplifier::{Resistor, amplifier, braking, resistor, shortage};
use super::demand::RunsDemand;
use super::gears::{self, SizedGear};
use super::refusal::{JudgedMotor, Rank, Refusal};
use super::runs::{SizingRuns, WholeRun};
use crate::controls::Control;
use crate::drives::holding_brake;
use crate::drives::inertia::CM2;
use crate::drives::load::power;
use crate::drives::parts::{Part, Ratings, SeriesLimits, Status};
use crate::drives::servo::{MotorDemand, Servo, Shares};
use crate::drives::shaft_motion::{MotorLoad, ResistorLoad};
use crate::machines::PreparedMachine;
use crate::machines::driven::{DrivenAxis, MotorFields};
use crate::machines::form::Value;
use crate::math::RPM;
use crate::motion::Mover;
use crate::msg;
use crate::project::Project;
use crate::project::parts::{follows, goes_with};
use crate::text::Message;
use crate::text::catalog::{number_text, sentence};
use crate::view::{FieldEntry, TorqueChart};

/// Greatest length of a motor's name in a form, characters.
const LONGEST_NAME: usize = 40;

/// An axis or drive with the demand on its motor, and the available motors.
#[derive(Debug, Clone, PartialEq)]
pub struct SizedAxis {
    /// Id, for instance `x`.
    pub id: &'static str,
    /// Catalog id of its name.
    pub name: &'static str,
    /// Field of the form with maker and model of its motor, if there is one.
    pub field: Option<&'static str>,
    /// Share (0 to 1) of the time of a part in which it turns.
    pub turning: f64,
    /// Share (0 to 1) of the time of a part in which it is loaded: a spindle in run-up, cut and stop, an axis while it turns.
    pub loaded: f64,
    /// Least torque of the brake at its motor that closes without current, Nm; 0 without one.
    pub brake: f64,
    /// Its gear unit, if it has one.
    pub gear: Option<SizedGear>,
    /// Current (A) of the form's motor for 1 Nm; none if the catalogue does not have it.
    pub ampere_per_torque: Option<f64>,
    /// Demand on a motor to be bought, with the inertia of the form's rotor.
    pub demand: MotorDemand,
    /// Speeds to which that demand belongs; none for a motor whose torque is the same at all speeds.
    pub asked_at: Option<AskedSpeeds>,
    /// Load of the run on the form's motor; none for a motor on an inverter.
    pub motor_load: Option<MotorLoad>,
    /// Energy of the run back from the form's motor; none for a drive behind an inverter, and without such energy.
    pub returned: Option<ResistorLoad>,
    /// Position (%) of the knob in the run with the knob at its highest position, if there is such a run.
    pub knob: Option<f64>,
    /// Whether that run has the greatest torque.
    pub peak_is_at_knob: bool,
    /// Position (%) of the feed override in the run with the greatest torque, if it is not at 100 %.
    pub peak_feed: Option<f64>,
    /// Torque over speed of that motor.
    pub chart: Option<TorqueChart>,
    /// The motors: passing ones by rising rating, then the others by their reason.
    pub candidates: Vec<Candidate>,
}

/// Speeds (r/min) at the motor of a spindle to which its demand belongs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AskedSpeeds {
    /// Base speed: the effective torque holds up to it, the power of that torque above it.
    pub base: f64,
    /// Speed of the greatest torque for a short time.
    pub peak_at: f64,
}

impl SizedAxis {
    /// The motors that pass, the smallest first.
    fn passing(&self) -> impl Iterator<Item = &Candidate> {
        self.candidates.iter().filter(|candidate| candidate.refusal.is_none())
    }

    /// Sentence with the demand if no motor in production passes, or no passing one has an amplifier; none otherwise.
    pub fn shortage(&self) -> Option<Message> {
        let is_current = |of: &&Candidate| of.part.status == Some(Status::Current);
        if is_at_rest(&self.demand) {
            return Some(msg!("size.axis-at-rest"));
        }
        let asked = || self.asked();
        if self.least().is_none() {
            Some(msg!("size.no-motor", asked = asked()))
        } else if self.passing().all(|of| of.amplifier.is_none()) {
            Some(msg!("size.no-motor-with-amplifier", asked = asked()))
        } else if !self.passing().any(|of| is_current(&of)) {
            Some(msg!("size.no-current-motor", asked = asked()))
        } else {
            None
        }
    }

    /// The demand in words, as a maker is asked for a motor.
    pub fn asked(&self) -> String {
        let MotorDemand { peak, effective, speed } = self.demand;
        let (peak, speed) = ((peak, 2), (speed, 0));
        sentence(&match self.asked_at {
            Some(AskedSpeeds { base, peak_at }) => {
                let power = (effective * base * RPM / 1e3, 2);
                let (effective, base, at) = ((effective, 2), (base, 0), (peak_at, 0));
                msg!("size.asked-spindle", effective, base, power, peak, at, speed)
            }
            None => msg!("size.asked-motor", peak, effective = (effective, 2), speed),
        })
    }

    /// The smallest motor of the catalogue that passes at the speed of the form; none if none does.
    pub fn least(&self) -> Option<&Part> {
        self.passing().next().map(|candidate| &candidate.part)
    }

    /// The smallest motor that passes and has an amplifier in the catalogue; if none has, the smallest that passes.
    pub fn ordered(&self) -> Option<&Candidate> {
        self.passing().find(|candidate| candidate.amplifier.is_some()).or_else(|| self.passing().next())
    }
}

/// Whether the run asks nothing of a motor: its axis neither moves nor holds.
fn is_at_rest(demand: &MotorDemand) -> bool {
    demand.speed == 0.0
}

/// A motor for an axis.
#[derive(Debug, Clone, PartialEq)]
pub struct Candidate {
    /// The motor.
    pub part: Part,
    /// The smallest amplifier or inverter that the catalogue pairs with it.
    pub amplifier: Option<Part>,
    /// Shortage of the paired amplifiers, if all of them are too small.
    pub shortage: Option<Message>,
    /// Its limits, with their source.
    pub limits: &'static SeriesLimits,
    /// Demand as shares of its ratings; none if a rating is not known.
    pub shares: Option<Shares>,
    /// Mean regenerated power as a share of the rating of its amplifier's brake resistor; none if that is not known.
    pub regenerative: Option<f64>,
    /// External brake resistor for the regenerated energy beyond the amplifier's own: the demand, and the smallest paired resistor of the
    /// catalogue that takes it; none without such a demand, or if the amplifier's capacitors are not known.
    pub resistor: Option<Resistor>,
    /// Current (A) that an induction motor asks of its inverter for a short time; none if it is not known, and for a servo motor.
    pub short_time_current: Option<f64>,
    /// First reason of its refusal; none if it passes.
    pub refusal: Option<Refusal>,
    /// Entries of the form with this motor: ids of fields and typed texts; empty if the form has no fields for it.
    pub entries: Vec<FieldEntry>,
}

/// The axes of servo motors.
pub(super) fn axes(project: &Project, prepared: &PreparedMachine, of: &SizingRuns) -> Vec<SizedAxis> {
    let runs = [Some(&of.present), of.fast.as_ref()].into_iter().flatten();
    let runs: Vec<&WholeRun> = runs.collect();
    let catalogue = project.catalogue();
    let (control, pause) = (project.control, prepared.pause());
    let fed = prepared.with_highest_feed().map_or_else(Vec::new, |(_, machine)| machine.driven_axes());
    let servo = prepared.driven_axes().into_iter().map(|axis| {
        let other = fed.iter().find(|other| other.id == axis.id).map(|other| (other, of.fed.as_slice()));
        let demand = RunsDemand::new(&axis, &runs, other, pause);
        let motors =
            catalogue.iter().filter(|part| matches!(part.ratings, Ratings::Servo(_)) && goes_with(part, control));
        let candidates = motors.map(|part| candidate(part, &axis, &demand, &catalogue, control));
        let candidates = candidates.map(|of| with_unknown_braking(of, &demand)).collect();
        let (turning, loaded) = (share_turning(of, axis.mover, pause), share_loaded(of, &demand, pause));
        let load = demand.motor_load(axis.fitted.motor.rotor);
        SizedAxis {
            id: axis.id,
            name: axis.name,
            field: axis.fields.map(|fields| fields.name),
            turning,
            loaded: loaded.unwrap_or(turning),
            // A weight falls without current.
            brake: holding_brake::torque(axis.weight),
            gear: gears::of_axis(&axis, &demand.motions, &catalogue),
            ampere_per_torque: ampere_per_torque(project, &axis),
            asked_at: None,
            demand: MotorDemand { peak: load.peak.torque, effective: load.effective, speed: load.speed / RPM },
            motor_load: Some(load),
            returned: demand.returned(axis.fitted.motor.rotor),
            knob: demand.knob,
            peak_is_at_knob: demand.peak_is_at_knob(axis.fitted.motor.rotor),
            peak_feed: demand.peak_feed(axis.fitted.motor.rotor),
            chart: Some(demand.chart(&axis.fitted.motor, axis.site_share)),
            candidates: in_order(candidates),
        }
    });
    servo.collect()
}

/// Share of the time of a part, with the pause after it, in which the mover turns.
pub(super) fn share_turning(of: &SizingRuns, mover: Mover, pause: f64) -> f64 {
    let timeline = of.present.run.timeline();
    let all = timeline.run_segments(mover, 0.0, timeline.end());
    let turning = all.iter().filter(|part| part.from != 0.0 || part.to != 0.0).map(|part| part.seconds).sum::<f64>();
    if timeline.end() > 0.0 { turning / (timeline.end() + pause) } else { 0.0 }
}

/// Share of the time of a part, with the pause after it, in which an axis is loaded; none if the machine does not report when it works. The
/// first motion of `demand` is that of the present run.
fn share_loaded(of: &SizingRuns, demand: &RunsDemand, pause: f64) -> Option<f64> {
    of.present.works.as_ref()?;
    Some(demand.motions.first()?.loaded_time() / (of.present.run.timeline().end() + pause))
}

/// The part of the catalogue with the name in the form of an axis's motor.
fn of_form<'a>(project: &'a Project, axis: &DrivenAxis) -> Option<&'a Part> {
    let typed = named(project, axis.fields?.name)?;
    project.catalogue().into_iter().find(|part| name(part) == typed)
}

/// Current (A) for 1 Nm of the form's motor for an axis, if the catalogue has it.
pub(super) fn ampere_per_torque(project: &Project, axis: &DrivenAxis) -> Option<f64> {
    match &of_form(project, axis)?.ratings {
        Ratings::Servo(ratings) => ratings.ampere_per_torque(),
        _ => None,
    }
}

/// Name of the motor in a field of the form.
pub(super) fn named(project: &Project, field: &str) -> Option<String> {
    match project.values.get(field)? {
        Value::Text(name) => Some(name.trim().to_owned()).filter(|name| !name.is_empty()),
        _ => None,
    }
}

/// Orders the candidates: passing ones by rising power, then the others by their reason.
pub(super) fn in_order(mut candidates: Vec<Candidate>) -> Vec<Candidate> {
    candidates.sort_by(|a, b| {
        let rank = |of: &Candidate| of.refusal.as_ref().map(|refusal| refusal.rank);
        let size = |of: &Candidate| size(&of.part);
        rank(a).cmp(&rank(b)).then(size(a).total_cmp(&size(b))).then_with(|| a.part.model.cmp(&b.part.model))
    });
    candidates
}

/// Size of a motor for the order: rated power in W, else that of torque and speed; infinite if neither is known.
fn size(part: &Part) -> f64 {
    let (rated, torque, speed) = match &part.ratings {
        Ratings::Servo(of) => (of.rated_power, of.rated_torque.or(of.stall_torque), of.rated_speed.or(of.top_speed)),
        Ratings::Induction(of) => (of.rated_power, of.rated_torque, of.rated_speed),
        _ => (None, None, None),
    };
    let product = torque.zip(speed).map(|(torque, speed)| power(torque, speed * RPM));
    rated.or(product).unwrap_or(f64::INFINITY)
}

/// A servo motor of the catalogue for an axis, with its amplifier and the first reason against it.
fn candidate(part: &Part, axis: &DrivenAxis, runs: &RunsDemand, catalogue: &[&Part], control: &Control) -> Candidate {
    let Some(motor) = part.servo() else {
        let amplifier = amplifier(part, (0.0, 0.0), catalogue, control);
        return Candidate { amplifier: amplifier.cloned(), ..unknown(part) };
    };
    let demand = runs.on_motor(motor.rotor);
    let torques = (demand.effective, demand.peak);
    let amplifier = amplifier(part, torques, catalogue, control);
    let shortage = if amplifier.is_none() { shortage(part, torques, catalogue, control) } else { None };
    let worst_point = runs.worst_point(&motor);
    let shares = Shares { peak: worst_point.share, ..motor.shares(&axis.load, &demand) };
    let starts_per_minute = runs.starts_per_minute.max(axis.starts_per_minute);
    let limits = part.acceptance().at_starts(starts_per_minute).derated(axis.site_share);
    let back = amplifier.and_then(braking).map(|(back, own)| (runs.to_resistor(motor.rotor, &back), own));
    let regenerative = back.and_then(|(load, own)| Some(load.mean / own?));
    let resistor =
        amplifier.zip(back).and_then(|(amplifier, (load, own))| resistor(amplifier, load, own, catalogue, control));
    let has_resistor = resistor.as_ref().is_some_and(|resistor| resistor.part.is_some());
    let judged =
        JudgedMotor { motor: &motor, limits: &limits, demand: &demand, shares: &shares, worst_point: &worst_point };
    let at_rest = || Refusal::new(Rank::Unknown, msg!("size.axis-at-rest"));
    let refusal = is_at_rest(&demand)
        .then(at_rest)
        .or_else(|| judged.beyond_limit())
        .or_else(|| judged.too_weak_for_long(axis))
        .or_else(|| (!follows(part, control)).then(|| Refusal::new(Rank::Role, msg!("size.refused-role"))))
        .or_else(|| judged.too_warm(runs.mean_speed))
        .or_else(|| {
            let share = regenerative.filter(|share| *share > 1.0 && !has_resistor)?;
            Some(Refusal::new(Rank::Regeneration, msg!("size.refused-regeneration", percent = (100.0 * share, 0))))
        })
        .or_else(|| Some(Refusal::new(Rank::Amplifier, shortage.clone()?)));
    Candidate {
        part: part.clone(),
        amplifier: amplifier.cloned(),
        shortage,
        limits: part.limits(),
        shares: Some(shares),
        regenerative,
        resistor,
        short_time_current: None,
        refusal,
        entries: axis.fields.map(|fields| entries(fields, part, &motor)).unwrap_or_default(),
    }
}

/// The candidate; if the catalogue has its amplifier, but not what that takes, with all energy that comes back as an open demand.
fn with_unknown_braking(of: Candidate, runs: &RunsDemand) -> Candidate {
    let is_known = of.amplifier.as_ref().is_none_or(|amplifier| braking(amplifier).is_some());
    let returned = of.part.servo().and_then(|motor| runs.returned(motor.rotor)).filter(|_| !is_known);
    let resistor = returned.map(|demand| Resistor { demand, part: None, is_unknown: true });
    Candidate { resistor: of.resistor.or(resistor), ..of }
}

/// Entries of the form with a servo motor.
fn entries(fields: &MotorFields, part: &Part, motor: &Servo) -> Vec<FieldEntry> {
    // The limits of its series without the derating for starts and site, which the form applies itself.
    let limits = part.acceptance();
    let encoder = match &part.ratings {
        Ratings::Servo(of) => of.encoder_pulses.map(|pulses| (fields.encoder, number_text(pulses, 0))),
        _ => None,
    };
    let entries = vec![
        (fields.name, name(part)),
        (fields.rated, number_text(motor.rated, 3)),
        (fields.stall, number_text(motor.stall, 3)),
        (fields.peak, number_text(motor.peak, 3)),
        (fields.rotor, number_text(motor.rotor / CM2, 4)),
        (fields.rated_speed, number_text(motor.rated_speed, 1)),
        (fields.top_speed, number_text(motor.top_speed, 1)),
        (fields.inertia_limit, number_text(limits.inertia_ratio, 1)),
        (fields.effective_limit, number_text(100.0 * limits.effective, 1)),
    ];
    entries.into_iter().chain(encoder).map(FieldEntry::from).collect()
}

/// Maker and model as text for the form.
pub(super) fn name(part: &Part) -> String {
    part.name().chars().take(LONGEST_NAME).collect()
}

/// A part whose ratings do not suffice for a choice.
pub(super) fn unknown(part: &Part) -> Candidate {
    Candidate {
        part: part.clone(),
        amplifier: None,
        shortage: None,
        limits: part.limits(),
        shares: None,
        regenerative: None,
        resistor: None,
        short_time_current: None,
        refusal: Some(Refusal::new(Rank::Unknown, msg!("size.refused-unknown"))),
        entries: Vec::new(),
    }
}
