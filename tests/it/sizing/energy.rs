//! Energy on a bus that several motors share, duty types, currents.

use macroline::drives::duty::{DutyType, duty_type};
use macroline::drives::load::Load;
use macroline::drives::shaft_motion::{Motion, SpeedSegment, on_one_bus};
use macroline::machines::form::Value;
use macroline::project::Project;
use macroline::project::size::OperatingEvent;
use proptest::prelude::*;

use crate::queries::sized;

fn motion(segments: &[(f64, f64, f64)], torque: f64) -> Motion {
    let mut t = 0.0;
    let segments = segments.iter().map(|(seconds, from, to)| {
        let segment = SpeedSegment { t, seconds: *seconds, from: *from, to: *to };
        t += seconds;
        segment
    });
    Motion::new(segments.collect::<Vec<_>>(), Load { inertia: 1e-3, torque, efficiency: 0.9 }, 0.0)
}

#[test]
fn one_motor_on_a_bus_returns_the_energy_of_it_alone() {
    let own = motion(&[(0.1, 0.0, 100.0), (1.0, 100.0, 100.0), (0.1, 100.0, 0.0)], 0.05);
    let alone = own.motor_load(2e-4);
    let (given, returned) = on_one_bus(&[(&own, 2e-4)]);
    super::same("given", given, alone.given, 1e-12);
    super::same("returned", returned, alone.returned, 1e-12);
}

#[test]
fn starting_motor_takes_the_energy_of_a_braking_one() {
    // Without friction and losses: one stops while its like starts.
    let segments = |from: f64, to: f64| {
        Motion::new(
            [SpeedSegment { t: 0.0, seconds: 0.2, from, to }],
            Load { inertia: 1e-3, torque: 0.0, efficiency: 1.0 },
            0.0,
        )
    };
    let (stops, starts) = (segments(100.0, 0.0), segments(0.0, 100.0));
    // With equal torques J ω / t = 0.5 Nm one gives 0.5 ω (1 - t / T), the other takes 0.5 ω t / T; over the first half of the time the
    // first has more.
    let (given, returned) = on_one_bus(&[(&stops, 0.0), (&starts, 0.0)]);
    super::same("returned", returned, 0.5 * 50.0 * 0.1, 1e-12);
    super::same("given", given, 0.5 * 50.0 * 0.1, 1e-12);
    // Alone each has all of its kinetic energy, J ω² / 2 = 5 J.
    super::same("alone", on_one_bus(&[(&stops, 0.0)]).1, 5.0, 1e-12);
}

proptest! {
    /// For any motions: the balance equals that of the motors, a shared bus gives back at most the sum of the motors alone, and the area
    /// under the sampled power agrees.
    #[test]
    fn bus_keeps_the_balance_of_its_motors(
        one in prop::collection::vec((0.01f64..1.0, -200.0f64..200.0), 1..8),
        two in prop::collection::vec((0.01f64..1.0, -200.0f64..200.0), 1..8),
        (friction, rotor) in (0.0f64..1.0, 0.0f64..1e-3),
    ) {
        let course = |points: &[(f64, f64)]| {
            let mut from = 0.0;
            let segments: Vec<_> = points.iter().map(|(seconds, to)| (*seconds, core::mem::replace(&mut from, *to), *to)).collect();
            motion(&segments, friction)
        };
        let motions = [course(&one), course(&two)];
        let works = [motions[0].motor_load(rotor), motions[1].motor_load(rotor)];
        let (given, returned) = on_one_bus(&[(&motions[0], rotor), (&motions[1], rotor)]);
        let (alone, back) = (works[0].given + works[1].given, works[0].returned + works[1].returned);
        prop_assert!((given - returned - (alone - back)).abs() <= 1e-9 * (alone + back), "{given} {returned} {alone} {back}");
        prop_assert!(returned <= back * (1.0 + 1e-9) + 1e-9 && returned >= 0.0, "{returned} of {back}");
        let power = |motion: &Motion, t: f64| {
            let segment = motion.segments().iter().find(|segment| segment.t <= t && t < segment.t + segment.seconds);
            segment.map_or(0.0, |segment| {
                let speed = segment.from + (segment.to - segment.from) * (t - segment.t) / segment.seconds;
                motion.torque(segment, rotor) * speed
            })
        };
        // Between the ends of all turns the power is straight: it is sampled finely there.
        let mut ends: Vec<f64> =
            motions.iter().flat_map(|motion| motion.segments()).flat_map(|segment| [segment.t, segment.t + segment.seconds]).collect();
        ends.sort_by(f64::total_cmp);
        let sampled: f64 = ends.windows(2).map(|pair| {
            let dt = (pair[1] - pair[0]) / 1000.0;
            let at = |step: u32| pair[0] + (f64::from(step) + 0.5) * dt;
            (0..1000).map(|step| (-(power(&motions[0], at(step)) + power(&motions[1], at(step)))).max(0.0) * dt).sum::<f64>()
        }).sum();
        prop_assert!((sampled - returned).abs() <= 1e-5 * (alone + back), "{sampled} sampled, {returned}");
    }
}

#[test]
fn duty_type_is_the_least_factor_that_covers() {
    for (turning, loaded, wanted) in [
        (0.0, 0.0, DutyType::Intermittent(15)),
        (0.15, 0.15, DutyType::Intermittent(15)),
        (0.151, 0.1, DutyType::Intermittent(25)),
        (0.4, 0.4, DutyType::Intermittent(40)),
        (0.41, 0.41, DutyType::Intermittent(60)),
        (0.601, 0.601, DutyType::Continuous),
        // The standstill is too long for S6.
        (0.97, 0.3, DutyType::Continuous),
        (0.98, 0.3, DutyType::Periodic(40)),
        (1.0, 0.6, DutyType::Periodic(60)),
        (1.0, 0.61, DutyType::Continuous),
        (1.0, 1.0, DutyType::Continuous),
    ] {
        assert_eq!(duty_type(turning, loaded, 600.0), wanted, "{turning} turning, {loaded} loaded");
        // In a longer cycle the motor reaches its final temperature.
        assert_eq!(duty_type(turning, loaded, 600.1), DutyType::Continuous);
    }
}

#[test]
fn drives_of_the_line_turn_for_the_time_of_their_motion() {
    let project = Project::named("ribbon-line", None, None).unwrap();
    let sizing = sized(&project);
    let product = project.design().readouts.iter().find(|row| row.id == "product-time").unwrap().value;
    for axis in &sizing.axes {
        let seconds = sizing.cycle.unwrap().seconds;
        assert!(axis.turning > 0.9 * product / seconds && axis.turning <= 1.0, "{}: {}", axis.id, axis.turning);
    }
}

#[test]
fn current_follows_the_torque_of_a_motor_of_the_catalogue() {
    let mut project = Project::named("ribbon-line", Some("mitsubishi-e60"), None).unwrap();
    assert!(sized(&project).envelope.iter().all(|row| row.unit != "A"), "no motor is named");
    let sizing = sized(&project);
    let motor = sizing.axes[0].candidates.iter().find(|candidate| candidate.part.model == "HC52").unwrap();
    project = project.with_entries(&motor.entries).unwrap();
    let after = sized(&project);
    // HC52: 3.2 A at 2.39 Nm.
    super::same("A/Nm", after.axes[0].ampere_per_torque.unwrap(), 3.2 / 2.39, 1e-9);
    assert_eq!(project.values["motor-x"], Value::Text(motor.part.name()));
    // The feed override does not act on the line.
    for (event, _) in OperatingEvent::IDS.into_iter().filter(|(event, _)| *event != OperatingEvent::FeedKnob) {
        let row =
            |id: &str| after.envelope.iter().find(|row| row.event == event && row.quantity.id() == id).unwrap().value;
        super::same(event.id(), row("x-current"), 3.2 / 2.39 * row("x-torque"), 1e-9);
    }
}

proptest! {
    /// A pause counts like a turn of the same length at rest, until run and pause fill 10 min; beyond it takes nothing off the torque of the run.
    #[test]
    fn pause_counts_as_a_turn_at_rest(
        points in prop::collection::vec((0.01f64..20.0, -200.0f64..200.0), 1..8),
        (pause, hold, rotor) in (0.0f64..3000.0, 0.0f64..0.5, 0.0f64..1e-3),
    ) {
        let load = Load { inertia: 1e-3, torque: 0.05, efficiency: 0.9 };
        let (mut t, mut from, mut segments) = (0.0, 0.0, Vec::new());
        for (seconds, to) in points.iter().chain([&(0.5, 0.0)]) {
            segments.push(SpeedSegment { t, seconds: *seconds, from, to: *to });
            (t, from) = (t + seconds, *to);
        }
        let counted = if t < 600.0 { pause.min(600.0 - t) } else { 0.0 };
        let own = Motion::new(segments.clone(), load, hold);
        let paused = own.clone().with_pause(pause).motor_load(rotor);
        segments.push(SpeedSegment { t, seconds: counted, from: 0.0, to: 0.0 });
        let stands = Motion::new(segments, load, hold);
        let wanted = if pause >= 600.0 { stands.motor_load(rotor).effective.max(hold) } else { stands.motor_load(rotor).effective };
        super::same("effective", paused.effective, wanted, 1e-12);
        super::same("speed", own.clone().with_pause(pause).mean_speed(), stands.mean_speed(), 1e-12);
        // The energy of a part is that of its run.
        let alone = own.motor_load(rotor);
        prop_assert_eq!((paused.given, paused.returned, paused.seconds), (alone.given, alone.returned, alone.seconds));
    }
}

#[test]
fn pause_of_the_shift_counts_in_torque_duty_and_parts_per_hour() {
    for (machine, example, pause) in
        [("ribbon-line", None, 60.0), ("polygon-lathe", None, 120.0), ("turning-spindle", Some("shaft"), 120.0)]
    {
        let project = Project::named(machine, None, example).unwrap();
        let project = project.with_entries(&[("reel-change", "0")]).unwrap_or(project);
        let with = |pause: f64| sized(&project.with_entries(&[("pause", format!("{pause}"))]).unwrap());
        let (now, later) = (with(0.0), with(pause));
        let seconds = now.cycle.unwrap().mean();
        super::same("parts", later.cycle.unwrap().parts_per_hour(), 3600.0 / (seconds + pause), 1e-4);
        for (axis, paused) in now.axes.iter().zip(&later.axes) {
            assert!(paused.turning < axis.turning && paused.loaded <= axis.loaded, "{machine} {}", axis.id);
            let Some((work, rests)) = axis.motor_load.zip(paused.motor_load) else { continue };
            assert!(rests.effective < work.effective, "{machine} {}: {} {}", axis.id, work.effective, rests.effective);
            super::same("peak", rests.peak.torque, work.peak.torque, 1e-6);
            super::same("speed", rests.speed, work.speed, 1e-9);
        }
    }
    // Motors that turn for all of a product have S1; with a pause of a minute after it S3.
    let mut line = Project::named("ribbon-line", None, None).unwrap();
    line.values.insert("pitch-count".to_owned(), Value::Number(100.0));
    line.values.insert("reel-change".to_owned(), Value::Number(0.0));
    let duty = |line: &Project| {
        let sheet = sized(line).sheets().into_iter().find(|sheet| sheet.id == "cycle").unwrap();
        sheet.rows.into_iter().map(|row| row.cells.join(" ")).find(|row| row.contains("Pull roller")).unwrap()
    };
    assert!(duty(&line).contains("S1"), "{}", duty(&line));
    line.values.insert("pause".to_owned(), Value::Number(60.0));
    assert!(duty(&line).contains("S3"), "{}", duty(&line));
    // The form's effective torque agrees: √(T² t / (t + p)), with the pull of the ribbon at rest.
    let result = |line: &Project, id: &str| line.design().readouts.into_iter().find(|row| row.id == id).unwrap().value;
    let (paused, time) = (result(&line, "y-effective-torque"), result(&line, "product-time"));
    super::same("per hour", result(&line, "products-per-hour"), 3600.0 / (time + 60.0), 1e-12);
    line.values.insert("pause".to_owned(), Value::Number(0.0));
    let share = time / (time + 60.0);
    super::same("form", paused, result(&line, "y-effective-torque") * share.sqrt(), 1e-9);
}
