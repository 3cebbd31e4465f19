//! The choice of motors: every motor of the catalogue for the control, against the demand of the run.

use std::collections::BTreeMap;

use super::gears::{self, SizedGear};
use super::runs::{SizingRuns, WholeRun};
use crate::controls::Control;
use crate::drives::duty::{Motion, OperatingPoint, ResistorLoad, Work};
use crate::drives::holding_brake;
use crate::drives::inertia::CM2;
use crate::drives::load::{Regeneration, power};
use crate::drives::parts::{AmplifierRatings, Part, Ratings, SeriesLimits, Status};
use crate::drives::servo::{Acceptance, MotorDemand, Reason, Servo, Shares, WEIGHT_SHARE};
use crate::machines::PreparedMachine;
use crate::machines::driven::{DrivenAxis, MotorFields};
use crate::machines::form::Value;
use crate::math::RPM;
use crate::motion::Mover;
use crate::msg;
use crate::project::Project;
use crate::project::parts::{follows, goes_with};
use crate::text::Message;
use crate::text::catalog::number_text;
use crate::view::{FieldEntry, OperatingLine, TorqueChart};

/// Greatest number of a run's lines in a chart.
const MOST_LINES: usize = 600;

/// Number of straight pieces of a motor's curve above its rated speed.
const BEND: u32 = 8;

/// Reciprocal of the resolution (r/min, Nm) at which speeds and torques count as equal.
const ALIKE: f64 = 1e3;

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
    /// Demand of the run on the form's motor; none for a motor on an inverter.
    pub work: Option<Work>,
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

impl SizedAxis {
    /// The motors that pass, the smallest first.
    fn passing(&self) -> impl Iterator<Item = &Candidate> {
        self.candidates.iter().filter(|candidate| candidate.refusal.is_none())
    }

    /// Sentence with the demand if no motor in production passes, or no passing one has an amplifier; none otherwise.
    pub fn shortage(&self) -> Option<Message> {
        let is_current = |of: &&Candidate| of.part.status == Some(Status::Current);
        let MotorDemand { peak, effective, speed } = self.demand;
        let (peak, effective, speed) = ((peak, 2), (effective, 2), (speed, 0));
        if self.least().is_none() {
            Some(msg!("size.no-motor", peak, effective, speed))
        } else if self.passing().all(|of| of.amplifier.is_none()) {
            Some(msg!("size.no-motor-with-amplifier", peak, effective, speed))
        } else if !self.passing().any(|of| is_current(&of)) {
            Some(msg!("size.no-current-motor", peak, effective, speed))
        } else {
            None
        }
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

/// A brake resistor beside an amplifier.
#[derive(Debug, Clone, PartialEq)]
pub struct Resistor {
    /// Demand on the resistor.
    pub asked: ResistorLoad,
    /// The resistor; none if the catalogue has none.
    pub part: Option<Part>,
    /// Whether the catalogue lacks what the amplifier takes by itself: the demand is all of the energy, and its maker has to be asked.
    pub is_unknown: bool,
}

/// Refusal of a motor.
#[derive(Debug, Clone, PartialEq)]
pub struct Refusal {
    pub(super) rank: Rank,
    /// The reason with its numbers.
    pub message: Message,
}

impl Refusal {
    fn new(rank: Rank, message: Message) -> Refusal {
        Refusal { rank, message }
    }
}

/// Reasons in the order of the list: the smallest shortage first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Rank {
    Inertia,
    Amplifier,
    Regeneration,
    Effective,
    Peak,
    Speed,
    Role,
    Unknown,
}

/// Demand of one or several runs on a shaft.
struct Asked {
    motions: Vec<Motion>,
    /// Greatest mean speed of a run, r/min.
    mean_speed: f64,
    /// Greatest number of starts per minute of a run.
    starts_per_minute: f64,
    /// Position (%) of the knob in the second run.
    knob: Option<f64>,
    /// The motions with the feed override at its highest position.
    fed: Vec<Motion>,
    /// That position, %.
    feed: Option<f64>,
}

impl Asked {
    /// Demand on an axis in these runs, and on the same axis in the runs at another feed.
    fn of(axis: &DrivenAxis, runs: &[&WholeRun], fed: Option<(&DrivenAxis, &[WholeRun])>, pause: f64) -> Asked {
        let motion = |axis: &DrivenAxis, whole: &WholeRun| whole.motion(axis).with_pause(pause);
        let motions: Vec<Motion> = runs.iter().map(|whole| motion(axis, whole)).collect();
        let feed = fed.and_then(|(_, runs)| runs.first()?.feed);
        let fed = fed.into_iter().flat_map(|(axis, runs)| runs.iter().map(|whole| motion(axis, whole)));
        let fed: Vec<Motion> = fed.collect();
        let greatest = |of: fn(&Motion) -> f64| motions.iter().chain(&fed).map(of).fold(0.0, f64::max);
        let (mean_speed, starts_per_minute) = (greatest(Motion::mean_speed), greatest(Motion::starts_per_minute));
        let knob = runs.iter().find_map(|whole| whole.knob);
        Asked { motions, mean_speed, starts_per_minute, knob, fed, feed }
    }

    /// The motions of all runs.
    fn all(&self) -> impl Iterator<Item = &Motion> + Clone {
        self.motions.iter().chain(&self.fed)
    }

    /// Whether the second run has the greatest torque.
    fn peak_is_at_knob(&self, rotor: f64) -> bool {
        let peak = |motion: &Motion| motion.work(rotor).peak.torque;
        self.peak_feed(rotor).is_none()
            && matches!(self.motions.as_slice(), [first, second] if peak(second) > peak(first))
    }

    /// Position (%) of the feed override if a run with it has the greatest torque.
    fn peak_feed(&self, rotor: f64) -> Option<f64> {
        let peak = |motions: &[Motion]| motions.iter().map(|of| of.work(rotor).peak.torque).fold(0.0, f64::max);
        self.feed.filter(|_| peak(&self.fed) > peak(&self.motions))
    }

    /// The greatest value of each figure over all runs, of the energies over those at the feed of the form.
    fn work(&self, rotor: f64) -> Work {
        let works = self.all().map(|motion| motion.work(rotor));
        let at_form = works.clone().take(self.motions.len());
        let (given, returned) = at_form
            .fold((0.0_f64, 0.0_f64), |(given, returned), work| (given.max(work.given), returned.max(work.returned)));
        let worst = works.fold(Work::default(), |worst, next| Work {
            peak: if next.peak.torque > worst.peak.torque { next.peak } else { worst.peak },
            effective: worst.effective.max(next.effective),
            speed: worst.speed.max(next.speed),
            seconds: worst.seconds.max(next.seconds),
            ..worst
        });
        Work { given, returned, ..worst }
    }

    /// Moment with the greatest share of the motor's short-time torque.
    fn worst_point(&self, motor: &Servo) -> OperatingPoint {
        let all = self.all().map(|motion| motion.worst_point(motor));
        all.reduce(|worst, next| if next.share > worst.share { next } else { worst }).unwrap_or_default()
    }

    /// Energy and power beyond the capacitors, the greatest value of each figure over all runs.
    fn to_resistor(&self, rotor: f64, back: &Regeneration) -> ResistorLoad {
        let all = self.all().map(|motion| motion.to_resistor(rotor, back));
        all.reduce(ResistorLoad::max).unwrap_or_default()
    }

    /// All of the energy and power that come back with a rotor, the greatest value of each figure over all runs; none without any.
    fn returned(&self, rotor: f64) -> Option<ResistorLoad> {
        let returned = self.to_resistor(rotor, &Regeneration { efficiency: 1.0, capacitor: 0.0 });
        (returned.mean > LEAST_RETURNED).then_some(returned)
    }

    /// Mean speed (r/min) and effective torque (Nm) of the run with the greatest effective torque.
    fn effective(&self, rotor: f64) -> (f64, f64) {
        let of = |motion: &Motion| (motion.mean_speed(), motion.work(rotor).effective);
        let greater = |worst: (f64, f64), next: (f64, f64)| if next.1 > worst.1 { next } else { worst };
        self.all().map(of).reduce(greater).unwrap_or_default()
    }

    /// Torque over speed of a motor at its site, with the lines of all runs; lines of a run with equal speeds and torque are merged.
    fn chart(&self, motor: &Servo, site_share: f64) -> TorqueChart {
        let mut lines: BTreeMap<(usize, i64, i64, i64), OperatingLine> = BTreeMap::new();
        for (run, motion) in self.motions.iter().enumerate() {
            for turn in motion.turns() {
                let torque = motion.torque(turn, motor.rotor) * if turn.from + turn.to < 0.0 { -1.0 } else { 1.0 };
                let speeds = (turn.from.abs() / RPM, turn.to.abs() / RPM);
                let key = |value: f64| (value * ALIKE).round() as i64;
                let line = OperatingLine { speeds, torque, t: turn.t, seconds: 0.0, is_at_highest_knob: run > 0 };
                lines.entry((run, key(speeds.0), key(speeds.1), key(torque))).or_insert(line).seconds += turn.seconds;
            }
        }
        // The longest lines; the others are too short to be seen.
        let mut lines: Vec<OperatingLine> = lines.into_values().collect();
        lines.sort_by(|a, b| b.seconds.total_cmp(&a.seconds));
        lines.truncate(MOST_LINES);
        let points = |torque: &dyn Fn(f64) -> f64| {
            let bend = motor.rated_speed.min(motor.top_speed);
            let above = (1..=BEND).map(|at| bend + (motor.top_speed - bend) * f64::from(at) / f64::from(BEND));
            [0.0, bend].into_iter().chain(above).map(|speed| (speed, torque(speed))).collect::<Vec<_>>()
        };
        TorqueChart {
            continuous: points(&|speed| motor.continuous_at(site_share, speed)),
            peak: points(&|speed| motor.short_time_torque(speed)),
            lines,
            effective: self.effective(motor.rotor),
        }
    }
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
        let asked = Asked::of(&axis, &runs, other, pause);
        let motors =
            catalogue.iter().filter(|part| matches!(part.ratings, Ratings::Servo(_)) && goes_with(part, control));
        let candidates = motors.map(|part| candidate(part, &axis, &asked, &catalogue, control));
        let candidates = candidates.map(|of| with_unknown_braking(of, &asked)).collect();
        let (turning, loaded) = (share_turning(of, axis.mover, pause), share_loaded(of, &asked, pause));
        let work = asked.work(axis.fitted.motor.rotor);
        SizedAxis {
            id: axis.id,
            name: axis.name,
            field: axis.fields.map(|fields| fields.name),
            turning,
            loaded: loaded.unwrap_or(turning),
            // A weight falls without current.
            brake: holding_brake::torque(axis.weight),
            gear: gears::of_axis(&axis, &asked.motions, &catalogue),
            ampere_per_torque: ampere_per_torque(project, &axis),
            demand: MotorDemand { peak: work.peak.torque, effective: work.effective, speed: work.speed / RPM },
            work: Some(work),
            returned: asked.returned(axis.fitted.motor.rotor),
            knob: asked.knob,
            peak_is_at_knob: asked.peak_is_at_knob(axis.fitted.motor.rotor),
            peak_feed: asked.peak_feed(axis.fitted.motor.rotor),
            chart: Some(asked.chart(&axis.fitted.motor, axis.site_share)),
            candidates: in_order(candidates),
        }
    });
    servo.collect()
}

/// Share of the time of a part, with the pause after it, in which the mover turns.
pub(super) fn share_turning(of: &SizingRuns, mover: Mover, pause: f64) -> f64 {
    let timeline = of.present.run.timeline();
    let all = timeline.stretches(mover, 0.0, timeline.end());
    let turning = all.iter().filter(|part| part.from != 0.0 || part.to != 0.0).map(|part| part.seconds).sum::<f64>();
    if timeline.end() > 0.0 { turning / (timeline.end() + pause) } else { 0.0 }
}

/// Share of the time of a part, with the pause after it, in which an axis is loaded; none if the machine does not report when it works. The
/// first motion of `asked` is that of the present run.
fn share_loaded(of: &SizingRuns, asked: &Asked, pause: f64) -> Option<f64> {
    of.present.works.as_ref()?;
    Some(asked.motions.first()?.loaded() / (of.present.run.timeline().end() + pause))
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

/// The smallest part of the catalogue that the control can use, the filter accepts and that has a size.
pub(super) fn smallest<'a>(
    catalogue: &[&'a Part],
    control: &Control,
    size: impl Fn(&Part) -> Option<f64>,
) -> Option<&'a Part> {
    let sized = catalogue.iter().filter(|part| goes_with(part, control)).filter_map(|part| Some((size(part)?, *part)));
    sized.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, part)| part)
}

fn candidate(part: &Part, axis: &DrivenAxis, asked: &Asked, catalogue: &[&Part], control: &Control) -> Candidate {
    let Some(motor) = part.servo() else {
        let amplifier = amplifier(part, (0.0, 0.0), catalogue, control);
        return Candidate { amplifier: amplifier.cloned(), ..unknown(part) };
    };
    let work = asked.work(motor.rotor);
    let torques = (work.effective, work.peak.torque);
    let amplifier = amplifier(part, torques, catalogue, control);
    let shortage = if amplifier.is_none() { shortage(part, torques, catalogue, control) } else { None };
    let demand = MotorDemand { peak: work.peak.torque, effective: work.effective, speed: work.speed / RPM };
    let worst_point = asked.worst_point(&motor);
    let shares = Shares { peak: worst_point.share, ..motor.shares(&axis.load, &demand) };
    let limits =
        part.acceptance().at_starts(asked.starts_per_minute.max(axis.starts_per_minute)).derated(axis.site_share);
    let refusal =
        shares.fails(&limits).map(|reason| refused_by(reason, &motor, (&shares, &limits), (&demand, &worst_point)));
    let back = amplifier.and_then(braking).map(|(back, own)| (asked.to_resistor(motor.rotor, &back), own));
    let regenerative = back.and_then(|(asked, own)| Some(asked.mean / own?));
    let resistor = amplifier.zip(back).and_then(|(of, (asked, own))| resistor(of, asked, own, catalogue, control));
    let has_resistor = resistor.as_ref().is_some_and(|resistor| resistor.part.is_some());
    let refusal = refusal
        .or_else(|| too_weak_for_long(&motor, axis, &limits))
        .or_else(|| (!follows(part, control)).then(|| Refusal::new(Rank::Role, msg!("size.refused-role"))))
        .or_else(|| too_warm(&motor, &limits, (demand.effective, asked.mean_speed)))
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

/// The smallest amplifier paired with a servo motor that has its currents for an effective and a greatest torque (Nm), as far as both are
/// known.
fn amplifier<'a>(
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
fn shortage(motor: &Part, (effective, peak): (f64, f64), catalogue: &[&Part], control: &Control) -> Option<Message> {
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

/// The refusal of a servo motor for a reason, in words.
fn refused_by(
    reason: Reason,
    motor: &Servo,
    (shares, limits): (&Shares, &Acceptance),
    (demand, worst_point): (&MotorDemand, &OperatingPoint),
) -> Refusal {
    match reason {
        Reason::Speed => Refusal::new(
            Rank::Speed,
            msg!("size.refused-speed", speed = (demand.speed, 0), limit = (motor.top_speed, 0)),
        ),
        Reason::Peak => {
            let gives = motor.short_time_torque(worst_point.speed);
            let message = msg!(
                "size.refused-peak",
                torque = (worst_point.torque, 3),
                speed = (worst_point.speed, 0),
                limit = (limits.peak * gives, 3),
                percent = (100.0 * limits.peak, 0)
            );
            Refusal::new(Rank::Peak, message)
        }
        Reason::Effective => {
            let message = msg!(
                "size.refused-effective",
                torque = (demand.effective, 3),
                limit = (limits.effective * motor.stall, 3),
                percent = (100.0 * limits.effective, 1)
            );
            Refusal::new(Rank::Effective, message)
        }
        Reason::Inertia => {
            let (ratio, limit) = ((shares.inertia_ratio, 1), (limits.inertia_ratio, 1));
            Refusal::new(Rank::Inertia, msg!("size.refused-inertia", ratio = ratio, limit = limit))
        }
    }
}

/// The refusal of a motor that gives less torque continuously than a long cut or a weight asks; none if it suffices.
fn too_weak_for_long(motor: &Servo, axis: &DrivenAxis, limits: &Acceptance) -> Option<Refusal> {
    let most = limits.effective * motor.stall;
    if let Some(torque) = axis.lasting.filter(|torque| *torque > most) {
        return Some(Refusal::new(
            Rank::Effective,
            msg!("size.refused-long-cut", torque = (torque, 3), limit = (most, 3)),
        ));
    }
    let most = WEIGHT_SHARE * axis.site_share * motor.stall;
    let too_heavy = || msg!("size.refused-weight", torque = (axis.weight, 3), limit = (most, 3));
    (axis.weight > most).then(|| Refusal::new(Rank::Effective, too_heavy()))
}

/// The refusal of a motor whose continuous torque at the mean speed (r/min), a point of the data sheet's chart, is below the effective torque (Nm);
/// none if it suffices.
fn too_warm(motor: &Servo, limits: &Acceptance, (effective, speed): (f64, f64)) -> Option<Refusal> {
    let most = limits.effective * motor.continuous(speed);
    let message = || {
        msg!(
            "size.refused-warm-at-speed",
            torque = (effective, 3),
            speed = (speed, 0),
            limit = (most, 3),
            percent = (100.0 * limits.effective, 1)
        )
    };
    (effective > most).then(|| Refusal::new(Rank::Effective, message()))
}

/// Mean regenerated power (W) below which none is reported. Our choice.
const LEAST_RETURNED: f64 = 0.05;

/// Brake resistor for the regenerated energy beyond the amplifier's own resistor, whose continuous power (W) may be known; none without
/// such energy.
fn resistor(
    amplifier: &Part,
    asked: ResistorLoad,
    own: Option<f64>,
    catalogue: &[&Part],
    control: &Control,
) -> Option<Resistor> {
    let is_asked = asked.mean > own.unwrap_or(0.0).max(LEAST_RETURNED);
    is_asked.then(|| {
        let part = smallest(catalogue, control, |other| match &other.ratings {
            Ratings::Resistor(of) if other.fits.contains(&amplifier.model) => {
                of.takes(&asked).then_some(of.brake_power).flatten()
            }
            _ => None,
        });
        Resistor { asked, part: part.cloned(), is_unknown: false }
    })
}

/// The candidate; if the catalogue has its amplifier, but not what that takes, with all energy that comes back as an open demand.
fn with_unknown_braking(of: Candidate, asked: &Asked) -> Candidate {
    let is_known = of.amplifier.as_ref().is_none_or(|amplifier| braking(amplifier).is_some());
    let returned = of.part.servo().and_then(|motor| asked.returned(motor.rotor)).filter(|_| !is_known);
    let resistor = returned.map(|asked| Resistor { asked, part: None, is_unknown: true });
    Candidate { resistor: of.resistor.or(resistor), ..of }
}

/// Regeneration of an amplifier, if its capacitors or its own resistor are known, and the continuous power (W) of that resistor. An unknown
/// efficiency counts as 1.
fn braking(amplifier: &Part) -> Option<(Regeneration, Option<f64>)> {
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
        refusal: Some(Refusal { rank: Rank::Unknown, message: msg!("size.refused-unknown") }),
        entries: Vec::new(),
    }
}
