//! The choice of the motor on the inverter, and of an inverter with its current, against the demand of the run.

use super::amplifier::smallest;
use super::choice::{AskedSpeeds, Candidate, SizedAxis, in_order, name, named, share_turning, unknown};
use super::gears;
use super::refusal::{Rank, Refusal};
use super::runs::{SizingRuns, WholeRun};
use crate::controls::Control;
use crate::drives::cage_motor::{RATED_FREQUENCY, highest_speed, no_load_speed, shaft_fan_torque_share};
use crate::drives::duty::with_pause;
use crate::drives::load::{Phase, effective, power};
use crate::drives::parts::{InductionRatings, InverterRatings, Part, Ratings};
use crate::drives::servo::{MotorDemand, Shares};
use crate::drives::shaft_motion::OperatingPoint;
use crate::drives::spindle_motor::MotorCurve;
use crate::machines::PreparedMachine;
use crate::machines::driven::{InverterCycle, InverterDrive, SpindleRun};
use crate::math::RPM;
use crate::motion::Mover;
use crate::msg;
use crate::project::Project;
use crate::project::parts::goes_with;
use crate::text::Message;
use crate::text::catalog::number_text;
use crate::view::FieldEntry;

/// The motor on the inverter with its candidates; none if the machine sizes none.
pub(super) fn axis(project: &Project, prepared: &PreparedMachine, of: &SizingRuns) -> Option<SizedAxis> {
    let drive = prepared.inverter_drive()?;
    let runs: Vec<&WholeRun> = [Some(&of.present), of.fast.as_ref()].into_iter().flatten().collect();
    let catalogue = project.catalogue();
    let pause = prepared.pause();
    let motors = catalogue
        .iter()
        .filter(|part| matches!(part.ratings, Ratings::Induction(_)) && goes_with(part, project.control));
    // With the knob at its highest position a cut at constant surface speed asks more power.
    let spindles = runs.iter().filter_map(|whole| whole.spindle(&**prepared));
    // With the feed override there, any cut asks more torque.
    let fed = prepared.with_highest_feed().map(|(_, machine)| machine);
    let fed = fed.into_iter().flat_map(|machine| of.fed.iter().filter_map(|whole| whole.spindle(machine)));
    let spindles: Vec<SpindleRun> =
        spindles.chain(fed).map(|spindle| SpindleRun { motion: spindle.motion.with_pause(pause), ..spindle }).collect();
    let candidates = motors.map(|part| induction(part, &drive, &spindles, &catalogue, project)).collect();
    let turning = share_turning(of, Mover::Spindle, pause);
    let in_run =
        spindles.first().map(|spindle| spindle.motion.loaded_time() / (of.present.run.timeline().end() + pause));
    Some(SizedAxis {
        id: drive.id,
        name: drive.name,
        field: drive.fields.map(|fields| fields.name),
        turning,
        loaded: turning.min(in_run.unwrap_or_else(|| {
            drive.cycle.map_or(turning, |cycle| {
                (cycle.motion.seconds_at_speed + 2.0 * cycle.motion.ramp) / (of.present.end + pause)
            })
        })),
        brake: drive.brake,
        gear: gears::of_inverter(&drive, &catalogue),
        ampere_per_torque: None,
        demand: demand(&drive, &spindles),
        asked_at: spindles
            .iter()
            .map(asked_speeds)
            .reduce(|worst, next| if next.peak_at > worst.peak_at { next } else { worst }),
        motor_load: None,
        returned: None,
        knob: None,
        peak_is_at_knob: false,
        peak_feed: None,
        chart: None,
        candidates: in_order(candidates),
    })
}

/// Speeds to which the demand of a spindle belongs.
fn asked_speeds(spindle: &SpindleRun) -> AskedSpeeds {
    AskedSpeeds { base: spindle.motor.base, peak_at: spindle.worst_point(&spindle.motor, spindle.rotor).speed }
}

/// Demand on the motor on an inverter.
fn demand(drive: &InverterDrive, spindles: &[SpindleRun]) -> MotorDemand {
    let ramps = drive.cycle.iter().flat_map(|cycle| cycle.ramps(None)).map(|ramp| ramp.torque.abs());
    let of_run = spindles.iter().map(|spindle| spindle.worst_point(&spindle.motor, spindle.rotor).torque);
    let steady = drive.torque.abs();
    // With the pause behind the run; above base speed as the torque below it that heats the motor as much.
    let effective = spindles
        .iter()
        .map(|spindle| spindle.motion.effective_share(spindle.rotor, &spindle.motor) * spindle.motor.base_torque());
    MotorDemand {
        peak: ramps.chain(of_run).fold(steady, f64::max),
        effective: effective.fold(steady, f64::max),
        speed: drive.top_speed,
    }
}

/// Entries of the form with a motor on the inverter, of a rated torque (Nm) and a rated speed (r/min); none if the form has no fields for
/// it. The speed at the full signal stays: a motor with other poles needs another frequency for it.
fn induction_entries(part: &Part, drive: &InverterDrive, (torque, rated_speed): (f64, f64)) -> Option<Vec<FieldEntry>> {
    let (fields, full) = drive.fields.zip(drive.full)?;
    let slip = no_load_speed(rated_speed, RATED_FREQUENCY) - rated_speed;
    Some(vec![
        FieldEntry::new(fields.name, name(part)),
        FieldEntry::new(fields.rated, number_text(torque, 3)),
        FieldEntry::new(fields.load, number_text((100.0 * drive.torque.abs() / torque).min(200.0), 3)),
        FieldEntry::new(fields.frequency, number_text(full.no_load / no_load_speed(rated_speed, 1.0), 2)),
        FieldEntry::new(fields.rated_speed, number_text((full.no_load - slip).max(1.0), 3)),
    ])
}

/// Refusal of the form's motor on the inverter, if the form has the frequency of a motor with other poles.
fn other_poles(part: &Part, drive: &InverterDrive, rated_speed: f64, project: &Project) -> Option<(Rank, Message)> {
    let (fields, full) = drive.fields.zip(drive.full)?;
    let (turns, asked) = (no_load_speed(rated_speed, full.frequency), full.no_load);
    let is_off = named(project, fields.name) == Some(name(part)) && (turns / asked - 1.0).abs() > OTHER_POLES;
    is_off.then(|| (Rank::Speed, msg!("size.refused-poles", speed = (turns, 0), asked = (asked, 0))))
}

/// Greatest relative difference of two speeds of motors with equal poles.
const OTHER_POLES: f64 = 0.2;

/// A motor on the inverter: torque up to its rated speed, power above, both as far as its site leaves them; in run-up and stop their
/// short-time share, and over both with the work between them the continuous torque.
fn induction(
    part: &Part,
    drive: &InverterDrive,
    spindles: &[SpindleRun],
    catalogue: &[&Part],
    project: &Project,
) -> Candidate {
    let Ratings::Induction(of) = part.ratings else { return unknown(part) };
    let (Some(rated_power), Some(rated_speed)) = (of.rated_power, of.rated_speed) else { return unknown(part) };
    let torque = of.rated_torque.unwrap_or(rated_power / (rated_speed * RPM));
    let cooled = drive.cooled_at.map_or(1.0, |speed| shaft_fan_torque_share(speed / rated_speed));
    let (most, most_power) = (torque * drive.site_share * cooled, rated_power * drive.site_share);
    let (speed, asked) = (drive.speed.abs(), drive.torque.abs());
    let top_speed = of.top_speed.unwrap_or_else(|| highest_speed(rated_power, rated_speed));
    let needed = power(asked, speed * RPM);
    let mut shares = Shares {
        inertia_ratio: 0.0,
        peak: asked / torque,
        effective: asked / most,
        speed: drive.top_speed / top_speed,
    };
    let mut refusal = if drive.top_speed > top_speed {
        Some((Rank::Speed, msg!("size.refused-speed", speed = (drive.top_speed, 0), limit = (top_speed, 0))))
    } else if asked > most {
        Some((Rank::Effective, torque_refusal(drive, asked, (most, torque * drive.site_share))))
    } else if needed > most_power {
        Some((Rank::Peak, msg!("size.refused-power", power = (needed, 0), limit = (most_power, 0))))
    } else {
        None
    };
    if let Some(cycle) = &drive.cycle {
        // Power, not torque, limits the end of a ramp above rated speed.
        let gives = torque.min(rated_power / cycle.motion.speed);
        let reason = over_cycle(cycle, of.inertia, (asked, most, gives), &mut shares);
        refusal = refusal.or(reason);
    }
    let curve = MotorCurve::with_torque(rated_power / 1000.0, torque);
    let in_runs = spindles
        .iter()
        .map(|spindle| of_spindle(spindle, of.inertia.unwrap_or(drive.rotor), &curve, drive))
        .reduce(|worst, next| (worst.0.max(next.0), worst.1.max(next.1), worst.2.or(next.2)));
    if let Some((peak, effective, reason)) = in_runs {
        (shares.peak, shares.effective) = (peak, effective);
        refusal = refusal.or(reason);
    }
    let refusal = other_poles(part, drive, rated_speed, project).or(refusal);
    let short_time_current = of.rated_current.map(|current| current * share_of_rated(drive, &of, spindles));
    let inverter = inverter(&of, short_time_current, catalogue, project.control);
    let shortage = match inverter {
        None => short_time_current.and_then(|current| inverter_shortage(&of, current, catalogue, project.control)),
        Some(_) => None,
    };
    let refusal = refusal.or_else(|| Some((Rank::Amplifier, shortage.clone()?)));
    let entries = induction_entries(part, drive, (torque, rated_speed));
    Candidate {
        amplifier: inverter.cloned(),
        shortage,
        shares: Some(shares),
        short_time_current,
        refusal: refusal.map(|(rank, message)| Refusal::new(rank, message)),
        entries: entries.unwrap_or_default(),
        ..unknown(part)
    }
}

/// Run-up, work and stop of a cycle, by the torque (Nm) of the work, the continuous torque of the motor and its torque at the end of a ramp:
/// raises the shares of the motor, and gives the refusal where it is too weak or too hot.
fn over_cycle(
    cycle: &InverterCycle,
    inertia: Option<f64>,
    (asked, continuous, gives): (f64, f64, f64),
    shares: &mut Shares,
) -> Option<(Rank, Message)> {
    let mut refusal = None;
    let ramps = cycle.ramps(inertia);
    // A load that brakes harder than the ramp leaves the motor to drive in the stop too.
    let share = |torque: f64| cycle.short_time.at(torque < 0.0);
    for (asked, most) in ramps.map(|ramp| (ramp.torque.abs(), share(ramp.torque) * gives)) {
        shares.peak = shares.peak.max(asked / most);
        if asked > most {
            refusal = refusal
                .or_else(|| Some((Rank::Peak, msg!("size.refused-ramp", torque = (asked, 3), limit = (most, 3)))));
        }
    }
    let [rise, fall] = ramps;
    let run = cycle.motion.seconds_at_speed + 2.0 * cycle.motion.ramp;
    let effective = effective(&[rise, Phase { torque: asked, seconds: cycle.motion.seconds_at_speed }, fall]);
    let effective = with_pause(effective, run, cycle.motion.pause, cycle.motion.hold);
    shares.effective = effective / continuous;
    if effective > continuous {
        let limit = (continuous, 3);
        let refused = || Some((Rank::Effective, msg!("size.refused-cycle", torque = (effective, 3), limit)));
        refusal = refusal.or_else(refused);
    }
    refusal
}

/// Refusal of a motor whose continuous torque is below the demand (Nm): with its cooling, and with forced cooling.
fn torque_refusal(drive: &InverterDrive, asked: f64, (most, forced): (f64, f64)) -> Message {
    let (torque, limit) = ((asked, 3), (most, 3));
    match drive.cooled_at.filter(|_| asked <= forced) {
        Some(speed) => msg!("size.refused-shaft-fan", torque, limit, speed = (speed, 0), forced = (forced, 3)),
        None => msg!("size.refused-torque", torque, limit),
    }
}

/// Greatest torque of a motor on the inverter in ramps, work and runs, as a share of the torque of its rated current at the same speed:
/// the rated torque, above rated speed the rated power. At least 1.
fn share_of_rated(drive: &InverterDrive, of: &InductionRatings, spindles: &[SpindleRun]) -> f64 {
    let Some((rated_power, rated_speed)) = of.rated_power.zip(of.rated_speed) else { return 1.0 };
    let torque = of.rated_torque.unwrap_or(rated_power / (rated_speed * RPM));
    let curve = MotorCurve::with_torque(rated_power / 1000.0, torque);
    let ramps = drive.cycle.iter().flat_map(|cycle| {
        let gives = torque.min(rated_power / cycle.motion.speed);
        cycle.ramps(of.inertia).map(|ramp| ramp.torque.abs() / gives)
    });
    let runs = spindles.iter().map(|spindle| spindle.share_of_rated(&curve, of.inertia.unwrap_or(drive.rotor)));
    ramps.chain(runs).fold(1.0, f64::max)
}

/// The smallest inverter that feeds a motor and gives its current (A) for a short time, as far as both are known.
fn inverter<'a>(
    of: &InductionRatings,
    short_time_current: Option<f64>,
    catalogue: &[&'a Part],
    control: &Control,
) -> Option<&'a Part> {
    let gives = |inverter: &InverterRatings| {
        inverter.short_time_current().zip(short_time_current).is_none_or(|(has, asked)| has >= asked)
    };
    smallest(catalogue, control, |other| match &other.ratings {
        Ratings::Inverter(inverter) if inverter.feeds(of) && gives(inverter) => inverter.rated_power,
        _ => None,
    })
}

/// Shortage of the inverters that feed a motor, for a current (A) for a short time: that of the largest one; none if none feeds it.
fn inverter_shortage(of: &InductionRatings, current: f64, catalogue: &[&Part], control: &Control) -> Option<Message> {
    let feeding = catalogue.iter().filter(|part| goes_with(part, control)).filter_map(|part| match &part.ratings {
        Ratings::Inverter(inverter) if inverter.feeds(of) => Some((part, inverter.short_time_current()?)),
        _ => None,
    });
    let (part, limit) = feeding.max_by(|a, b| a.1.total_cmp(&b.1))?;
    let inverter = part.model.as_str();
    (limit < current).then(|| msg!("size.refused-inverter", current = (current, 2), inverter, limit = (limit, 2)))
}

/// A motor of a main spindle in the run: shares of its short-time and of its continuous torque, and the reason of its refusal. Cut and
/// friction stay below the continuous curve at each speed, with the acceleration below the short-time one, and all of the run below the
/// continuous one in the effective mean.
fn of_spindle(
    spindle: &SpindleRun,
    rotor: f64,
    curve: &MotorCurve,
    drive: &InverterDrive,
) -> (f64, f64, Option<(Rank, Message)>) {
    let continuous = drive.continuous(curve);
    let (steady, worst_point) = (spindle.worst_point_steady(&continuous), spindle.worst_point(curve, rotor));
    let ramps = spindle.worst_point_idle(curve, rotor);
    let effective = spindle.motion.effective_share(rotor, &continuous);
    let at = |of: OperatingPoint| ((of.torque, 3), (of.speed, 0), (of.torque / of.share, 3));
    let refusal = if steady.share > 1.0 {
        let (torque, speed, limit) = at(steady);
        Some((Rank::Effective, msg!("size.refused-cut", torque, speed, limit)))
    } else if ramps.share > 1.0 {
        let (torque, _, limit) = at(ramps);
        Some((Rank::Peak, msg!("size.refused-ramp", torque, limit)))
    } else if worst_point.share > 1.0 {
        let (torque, speed, limit) = at(worst_point);
        Some((Rank::Peak, msg!("size.refused-cut-peak", torque, speed, limit)))
    } else if effective > 1.0 {
        let most = continuous.base_torque();
        let (torque, limit) = ((effective * most, 3), (most, 3));
        Some((Rank::Effective, msg!("size.refused-cycle", torque, limit)))
    } else {
        None
    };
    (worst_point.share, effective, refusal)
}
