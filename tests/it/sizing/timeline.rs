//! Torque and energy over the segments of the program's own run against the closed forms.

use macroline::drives::load::{Load, Move, effective};
use macroline::drives::shaft_motion::{Motion, SpeedSegment};
use macroline::machines::driven::DrivenAxis;
use macroline::machines::form::Value;
use macroline::motion::{Budget, Mover, Retention, RunSegment};
use macroline::project::Project;
use macroline::project::run::{self, Run, RunOptions};
use macroline::project::size::size;
use proptest::prelude::*;

/// Greatest relative difference between a run and its closed form.
const WITHIN: f64 = 1e-3;

fn with(mut project: Project, values: &[(&str, f64)]) -> Project {
    for (field, value) in values {
        project.values.insert((*field).to_owned(), Value::Number(*value));
    }
    project
}

fn run_of(project: &Project) -> Run {
    let limits = Budget { blocks: 1_000_000, seconds: 600.0 };
    let begin = RunOptions { start: None, settings: &[], limits, keep: Retention::Timeline };
    let mut run = run::of_project(project, &project.written(), &begin);
    while run.advance(f64::INFINITY, 100_000).ended.is_none() {}
    run
}

fn axis(project: &Project, id: &str) -> DrivenAxis {
    project.prepared().driven_axes().into_iter().find(|axis| axis.id == id).unwrap()
}

fn travelled(segments: &[RunSegment]) -> f64 {
    segments.iter().map(|part| 0.5 * (part.from + part.to) * part.seconds).sum()
}

#[test]
fn torque_over_the_run_is_that_of_the_results() {
    for control in ["mitsubishi-e60", "sinumerik-802d", "fanuc-0i-mf"] {
        // Ramps that weigh, and a product that is soon over.
        let project = Project::named("ribbon-line", Some(control), None).unwrap();
        let project = with(project, &[("motor-rotor-x", 60.0), ("pitch-count", 40.0)]);
        let design = project.design();
        let result = |id: &str| design.readouts.iter().find(|row| row.id == id).unwrap().value;
        let (run, axis) = (run_of(&project), axis(&project, "x"));
        let work = axis
            .motion(&run.timeline().run_segments(axis.mover, 0.0, run.timeline().end()), None)
            .motor_load(axis.fitted.motor.rotor);
        // Before and after the product the axis holds the web.
        let (product, hold) = (result("product-time"), axis.standstill_torque);
        let square = work.effective * work.effective * work.seconds - hold * hold * (work.seconds - product);
        super::same(&format!("{control}, highest"), work.peak.torque, result("x-peak-torque"), WITHIN);
        super::same(&format!("{control}, effective"), (square / product).sqrt(), result("x-effective-torque"), WITHIN);
    }
}

#[test]
fn segments_of_a_run_add_up_to_its_travel() {
    for (machine, control) in
        [("ribbon-line", "mitsubishi-e60"), ("ribbon-line", "gsk-980tdc"), ("polygon-lathe", "knd-k2000t")]
    {
        let project = with(Project::named(machine, Some(control), None).unwrap(), &[("pitch-count", 60.0)]);
        let run = run_of(&project);
        let end = run.timeline().end();
        let place_at = |mover: Mover, t: f64| {
            let now = run.timeline().at(t);
            match mover {
                Mover::Axis(at) => now.axes[at].position,
                Mover::Turned(at) => now.pmc[at].position,
                Mover::Spindle => now.spindle.turns,
            }
        };
        let place = |mover: Mover| place_at(mover, end) - place_at(mover, 0.0);
        let axes = project.prepared().driven_axes();
        assert!(!axes.is_empty());
        for axis in axes {
            let segments = run.timeline().run_segments(axis.mover, 0.0, end);
            for pair in segments.windows(2) {
                assert!(
                    (pair[1].t - pair[0].t - pair[0].seconds).abs() < 1e-9,
                    "{machine} {}: a gap at {}",
                    axis.id,
                    pair[1].t
                );
            }
            // Each of the sixty blocks bends the speed twice; where that changes the speed by less than the least increment, both are one segment.
            assert!(segments.len() < 120, "{machine} {}: {} segments", axis.id, segments.len());
            let (sum, travel) = (travelled(&segments), place(axis.mover));
            let about = format!("{machine} on {control}, {}", axis.id);
            // A slide comes back to where it started.
            if axis.cut.is_some() {
                let way: f64 = segments.iter().map(|part| 0.5 * (part.from + part.to).abs() * part.seconds).sum();
                assert!(way > 50.0 && (sum - travel).abs() < 1e-6 * way, "{about}: {sum}, {travel}, {way}");
            } else {
                assert!(travel.abs() > 100.0);
                super::same(&about, sum, travel, 1e-6);
            }
        }
        // Turns of the spindle: r/min over seconds.
        let segments = travelled(&run.timeline().run_segments(Mover::Spindle, 0.0, end)) / 60.0;
        assert!(
            (segments - place(Mover::Spindle)).abs() < 1e-6 * segments.abs().max(1.0),
            "{machine}: {segments} turns"
        );
    }
}

#[test]
fn energy_of_a_run_goes_into_friction_alone() {
    // Without losses in the gear all energy that is given and not returned is friction times distance.
    let project = Project::named("ribbon-line", None, None).unwrap();
    let project = with(project, &[("efficiency-x", 100.0), ("efficiency-y", 100.0), ("pitch-count", 100.0)]);
    let run = run_of(&project);
    let end = run.timeline().end();
    for id in ["x", "y"] {
        let axis = axis(&project, id);
        let segments = run.timeline().run_segments(axis.mover, 0.0, end);
        let work = axis.motion(&segments, None).motor_load(axis.fitted.motor.rotor);
        let friction = axis.load.torque * axis.radians_per_unit * travelled(&segments);
        assert!(work.given > 1.0, "{id}: {work:?}");
        super::same(&format!("energy of {id}"), work.given - work.returned, friction, WITHIN);
    }
}

#[test]
fn machine_with_an_unknown_drive_has_no_energy_of_a_part() {
    let project = Project::named("turning-spindle", None, None).unwrap();
    let project = project.with_entries(&[("material", "none")]).unwrap();
    let sizing = size(&project, &project.written());
    assert_eq!(sizing.cycle.expect("the program comes to its end").energy, None);
    assert!(sizing.json()["cycle"]["energy_given_j"].is_null());
}

#[test]
fn energy_of_a_part_is_that_of_its_motors() {
    let project = Project::named("ribbon-line", None, None).unwrap();
    let cycle = size(&project, &project.written()).cycle.expect("the program comes to its end");
    let run = run_of(&project);
    let works = project.prepared().driven_axes().into_iter().map(|axis| {
        axis.motion(&run.timeline().run_segments(axis.mover, 0.0, run.timeline().end()), None)
            .motor_load(axis.fitted.motor.rotor)
    });
    // Includes the unwinder, whose spindle speed is in r/min of its motor.
    let unwinder = project.prepared().inverter_drive().unwrap();
    let segments = run.timeline().run_segments(Mover::Spindle, 0.0, run.timeline().end());
    let unwinder = unwinder.motion(&segments).motor_load(unwinder.rotor);
    let given = works.map(|work| work.given).sum::<f64>() + unwinder.given;
    super::same("energy of a part", cycle.energy.unwrap().given, given, 1e-9);
    // Its steady torque over the turns of the run, and what runs it up, at least.
    let turned: f64 = segments.iter().map(|segment| 0.5 * (segment.from + segment.to) * segment.seconds / 60.0).sum();
    let steady = project.design().readouts.into_iter().find(|row| row.id == "unwinder-torque").unwrap().value;
    assert!(unwinder.given > 0.9 * steady * turned * std::f64::consts::TAU, "{} J", unwinder.given);
    super::same("cycle time", cycle.seconds, run.ended_at().unwrap(), 1e-9);
    // A program that does not end makes no part.
    let mut endless = project.clone();
    endless.edited = Some(macroline::nc::Files::one("O1.NC", "%\nO1\nM00\nM30\n%\n"));
    assert_eq!(size(&endless, &endless.written()).cycle, None);
}

/// A move from rest to rest as turns, forward or backward.
fn segments(of: &Move, side: f64) -> Vec<SpeedSegment> {
    let top = side * of.speed;
    let parts = [(of.ramp, 0.0, top), (of.seconds_at_speed, top, top), (of.ramp, top, 0.0), (of.pause, 0.0, 0.0)];
    let mut t = 0.0;
    parts
        .into_iter()
        .map(|(seconds, from, to)| {
            t += seconds;
            SpeedSegment { t: t - seconds, seconds, from, to }
        })
        .collect()
}

proptest! {
    #[test]
    fn motion_of_one_move_is_its_closed_form(
        (inertia, torque, efficiency) in (1e-6..1.0_f64, 0.0..50.0_f64, 0.3..1.0_f64),
        (speed, ramp, run, pause) in (1.0..600.0_f64, 0.01..3.0_f64, 0.01..5.0_f64, 0.01..5.0_f64),
        (rotor, hold, backward) in (1e-6..0.1_f64, 0.0..5.0_f64, any::<bool>()),
    ) {
        let load = Load { inertia, torque, efficiency };
        let of = Move { speed, ramp, seconds_at_speed: run, pause, hold };
        let motion = Motion::new(segments(&of, if backward { -1.0 } else { 1.0 }), load, hold);
        let work = motion.motor_load(rotor);
        let phases = load.phases(rotor, of);
        let peak = phases.iter().map(|phase| phase.torque.abs()).fold(0.0, f64::max);
        prop_assert!((work.peak.torque - peak).abs() <= 1e-9 * peak);
        let expected = effective(&phases);
        prop_assert!((work.effective - expected).abs() <= 1e-9 * expected);
        // Energy of the ramps, with the losses of the gear both ways.
        let way = speed * (ramp + run);
        let losses = 0.5 * inertia * speed * speed * (1.0 / efficiency - efficiency);
        let spent = torque * way + losses;
        prop_assert!((work.given - work.returned - spent).abs() <= 1e-9 * (work.given + work.returned));
    }

    #[test]
    fn reversal_inside_a_turn_changes_nothing_but_the_sign(
        (from, to, seconds) in (-300.0..300.0_f64, -300.0..300.0_f64, 0.01..2.0_f64),
    ) {
        // Without steady torque and losses the torque is the same before and after standstill.
        let load = Load { inertia: 0.01, torque: 0.0, efficiency: 1.0 };
        let motion = Motion::new([SpeedSegment { t: 0.0, seconds, from, to }], load, 0.0);
        let torque = 0.01 * (to - from) / seconds;
        for segment in motion.segments() {
            prop_assert!((motion.torque(segment, 0.0) - torque).abs() <= 1e-9 * torque.abs().max(1e-9));
            prop_assert!(segment.from * segment.to >= 0.0);
        }
        let (work, kinetic) = (motion.motor_load(0.0), 0.5 * 0.01 * (to * to - from * from));
        prop_assert!((work.given - work.returned - kinetic).abs() <= 1e-9 * (work.given + work.returned).max(1e-9));
    }
}

#[test]
fn starts_by_formula_bound_those_of_the_run() {
    let quick = |machine, example, entries: &[(&'static str, &str)]| {
        let project = Project::named(machine, None, example).unwrap();
        let entries: Vec<_> = entries.iter().map(|(id, typed)| (*id, (*typed).to_owned())).collect();
        project.with_entries(&entries).unwrap()
    };
    let short = [("length", "3"), ("depth", "0.5"), ("feed", "0.6"), ("material", "aluminium")];
    let lathe = |example| quick("turning-spindle", Some(example), &short);
    let polygon = [("length", "3"), ("depth", "0.2"), ("feed", "2"), ("finish-feed", "2")];
    let falls = [("finished-diameter", "50".to_owned()), ("large-diameter", "45".to_owned())];
    // Bounds of the starts of the run over those of the form. The form counts the passes alone, with the knob at its highest position, and as
    // many starts of Z as of X, which starts once more along a taper; the run
    // of a polygon is short, and the motions to its first pass and after its last one count in it besides.
    let all = [
        (quick("turning-spindle", None, &[&short[..], &[("allowance", "10")]].concat()), (0.9, 1.0)),
        (lathe("shaft"), (0.5, 1.0)),
        (lathe("taper"), (0.55, 1.0)),
        (lathe("taper").with_entries(&falls).unwrap(), (0.3, 1.0)),
        (quick("polygon-lathe", None, &polygon), (1.0, 1.1)),
        (quick("polygon-lathe", Some("threaded-shaft"), &[]), (1.0, 1.1)),
    ];
    for (project, (least, most)) in all {
        let run = run_of(&project);
        for id in ["x", "z"] {
            let axis = axis(&project, id);
            let segments = run.timeline().run_segments(axis.mover, 0.0, run.timeline().end());
            let starts = axis.motion(&segments, None).starts_per_minute();
            let about = format!("{} {id}: {starts} of {}", project.machine.id(), axis.starts_per_minute);
            assert!((least..=most).contains(&(starts / axis.starts_per_minute)), "{about}");
        }
    }
}
