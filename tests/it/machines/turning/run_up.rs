//! Inertia of the turning spindle: its run-up and braking by the motor, its coasting without current, by formulas and in the run.

use macroline::drives::spindle_motor::{GearedMotor, MotorCurve};
use macroline::motion::{Action, Event, Planner};
use macroline::project::Project;
use macroline::project::size::OperatingEvent;
use macroline::view::{FieldEntry, Limit, Verdict};

use super::{machine, project, run_of};
use crate::machines::ribbon::each_control::over_time;
use crate::queries::{readout, sized, value};

/// Radians per second of one turn per minute.
const RPM: f64 = std::f64::consts::TAU / 60.0;

#[track_caller]
fn same(value: f64, expected: f64) {
    assert!((value - expected).abs() <= 1e-9 * expected.abs(), "{value} is not {expected}");
}

/// A shaft that is turned at one speed in a stage of 1500 r/min, with 6 kW at the spindle up to 750 r/min: 76.4 Nm.
const SHAFT: [(&str, &str); 12] = [
    ("path", "turning"),
    ("speed-mode", "fixed"),
    ("stock-diameter", "80"),
    ("finished-diameter", "70"),
    ("length", "90"),
    ("work-length", "200"),
    ("upper-limit", "1200"),
    ("cutting-speed", "300"),
    ("stage-1", "1500"),
    ("stage-2", "0"),
    ("motor-base", "1500"),
    ("motor-top", "3000"),
];

/// Inertia of the shaft's spindle: 0.2 of the chuck, 0.006313 of the work, a rotor of 0.03 at twice its speed.
const INERTIA: f64 = 0.2 + 0.006_313_344_596_654 + 0.03 * 4.0;

fn shaft(control: &str, changes: &[(&str, &str)]) -> Project {
    project(control, &[&SHAFT[..], changes].concat())
}

fn each_control() -> impl Iterator<Item = &'static str> {
    machine().controls().iter().copied()
}

#[test]
fn work_is_a_solid_cylinder_as_long_as_its_cut() {
    // Steel, Ø 80 by 200 mm: 0.006313 kg m² (operation facts F).
    let inertia = |changes: &[(&str, &str)]| value(&shaft("gsk-980tdc", changes), "work-inertia");
    assert!((inertia(&[]) - 0.006_313).abs() < 5e-7, "{}", inertia(&[]));
    same(inertia(&[("work-density", "2700")]), inertia(&[]) * 2700.0 / 7850.0);
    same(inertia(&[("stock-diameter", "160"), ("cutting-speed", "500")]), inertia(&[]) * 16.0);
    // A bar is not shorter than the cut along it; facing has no length.
    same(inertia(&[("length", "400")]), inertia(&[]) * 2.0);
    same(inertia(&[("path", "facing"), ("length", "400")]), inertia(&[]));
}

#[test]
fn rotor_counts_by_the_square_of_its_speed() {
    for (stage, squared) in [("1500", 4.0), ("300", 100.0), ("6000", 0.25)] {
        let lathe = shaft("gsk-980tdc", &[("stage-1", stage), ("chuck-limit", "6000")]);
        let inertia = value(&lathe, "inertia");
        assert!((inertia - (0.206_313 + 0.03 * squared)).abs() < 1e-6, "{stage}: {inertia}");
    }
}

#[test]
fn run_up_asks_inertia_over_ramp_and_friction() {
    // From rest to 1500 r/min in 4 s against 2 Nm.
    let lathe = shaft("gsk-980tdc", &[("spindle-ramp", "4")]);
    assert!((value(&lathe, "run-up-torque") - (INERTIA * 1500.0 * RPM / 4.0 + 2.0)).abs() < 1e-6);
    // A stop from 1193 r/min over 4 · 1193 / 1500 s gives back its energy less the work of the friction.
    let (n, turning) = (value(&lathe, "speed-largest"), value(&lathe, "inertia"));
    let seconds = 4.0 * n / 1500.0;
    let friction = 2.0 * 0.5 * n * RPM * seconds;
    same(value(&lathe, "stop-energy"), 0.5 * turning * n * n * RPM * RPM - friction);
}

#[test]
fn ramp_fails_just_below_the_shortest_one() {
    for control in each_control() {
        let plain = shaft(control, &[]);
        let shortest = value(&plain, "shortest-ramp");
        // 150 % of the motor's torque at the highest speed, by its power above base speed.
        let torque = 1.5 * 9_549.296_585_513_72 * 6.0 / value(&plain, "speed-largest");
        same(shortest, value(&plain, "inertia") * 1500.0 * RPM / (torque - 2.0));
        let hundredths = (shortest * 100.0).ceil();
        // A greater speed at the highest position of the knob needs more torque, and is a warning.
        for (entry, verdict) in [(hundredths - 1.0, Verdict::Fail), (hundredths, Verdict::Warn)] {
            let entry = format!("{:.2}", entry / 100.0);
            let judged = readout(&shaft(control, &[("spindle-ramp", &entry)]), "shortest-ramp");
            let limit = Limit::AtMost(entry.parse().unwrap());
            assert_eq!((judged.verdict, judged.limit), (verdict, Some(limit)), "{control}: {entry}");
        }
        // The advice is the least entry that holds.
        let short = shaft(control, &[("spindle-ramp", "0.1")]);
        let sets = readout(&short, "shortest-ramp").advice[0].entries.clone();
        let [FieldEntry { field: "spindle-ramp", text: typed }] = &sets[..] else { panic!("{control}: {sets:?}") };
        assert_eq!(typed.parse::<f64>().unwrap(), hundredths / 100.0, "{control}");
        let at_form = short.with_entries(&sets).unwrap();
        let at_knob = at_form.with_entries(&readout(&at_form, "shortest-ramp").advice[0].entries).unwrap();
        assert_eq!(readout(&at_knob, "shortest-ramp").verdict, Verdict::Ok, "{control}");
    }
}

#[test]
fn inverter_without_brake_resistor_asks_a_longer_ramp() {
    let lathe = shaft("gsk-980tdc", &[("motor-braking", "20")]);
    let torque = 0.2 * 9_549.296_585_513_72 * 6.0 / value(&lathe, "speed-largest");
    same(value(&lathe, "shortest-ramp"), value(&lathe, "inertia") * 1500.0 * RPM / (torque + 2.0));
    assert!(value(&lathe, "braking-time") > value(&lathe, "run-up-time"));
    assert_eq!(readout(&lathe, "shortest-ramp").verdict, Verdict::Fail);
}

#[test]
fn friction_above_the_torque_of_the_motor_has_no_ramp() {
    let lathe = shaft("gsk-980tdc", &[("spindle-friction", "100")]);
    let judged = readout(&lathe, "shortest-ramp");
    assert_eq!((judged.value, judged.verdict), (f64::INFINITY, Verdict::Fail));
    assert!(judged.advice.iter().all(|advice| advice.entries.is_empty()));
    assert_eq!(value(&lathe, "run-up-time"), f64::INFINITY);
    // Friction shortens the braking.
    assert!(value(&lathe, "braking-time") < value(&shaft("gsk-980tdc", &[]), "braking-time"));
}

/// Seconds to a speed by small steps of speed, each with the torque at its middle.
fn by_steps(motor: MotorCurve, rpm: f64, inertia: f64, load: f64) -> f64 {
    let steps = 200_000;
    let step = rpm / f64::from(steps);
    let middle = (0..steps).map(|at| step * (f64::from(at) + 0.5));
    middle.map(|n| inertia * step * RPM / (motor.torque(n) - load)).sum()
}

#[test]
fn fastest_run_up_is_the_integral_over_the_curve() {
    let motor = MotorCurve::through_gear(GearedMotor {
        power: 7.5,
        base: 1500.0,
        top: 6000.0,
        spindle_top: 3000.0,
        efficiency: 0.8,
    });
    assert_eq!(motor.base, 750.0);
    for rpm in [500.0, 750.0, 2000.0, 3000.0] {
        // From none to nearly all of the 19.1 Nm that there are at 3000 r/min; braking has the friction on its side.
        for load in [0.0, 1e-6, 0.01, 0.019, 0.02, 2.0, 18.0, -0.01, -2.0, -50.0] {
            let (closed, sum) = (motor.seconds_to(rpm, 0.3, load), by_steps(motor, rpm, 0.3, load));
            assert!((closed - sum).abs() < 1e-6 * sum, "{rpm} r/min, {load} Nm: {closed} is not {sum}");
        }
    }
    assert_eq!(motor.seconds_to(0.0, 0.3, 2.0), 0.0);
    assert_eq!(motor.seconds_to(3000.0, 0.3, 19.2), f64::INFINITY);
    assert!(motor.seconds_to(2000.0, 0.3, 19.2).is_finite());
    assert_eq!(motor.seconds_to(100.0, 0.3, 77.0), f64::INFINITY);
}

#[test]
fn fastest_times_of_the_form_are_those_of_the_curve() {
    let lathe = shaft("gsk-980tdc", &[("motor-peak", "200"), ("motor-braking", "120")]);
    let (n, inertia) = (value(&lathe, "speed-largest"), value(&lathe, "inertia"));
    let motor = MotorCurve { power: 6.0, base: 750.0, has_shaft_fan: false };
    assert!(n > 750.0, "{n}");
    same(value(&lathe, "run-up-time"), motor.share(2.0).seconds_to(n, inertia, 2.0));
    same(value(&lathe, "braking-time"), motor.share(1.2).seconds_to(n, inertia, -2.0));
}

/// The run, and a moment in its cut at which the spindle has its speed.
fn in_the_cut(project: &Project) -> (f64, f64) {
    let whole = over_time(project, vec![]);
    let n = value(project, "speed-largest");
    let end = whole.timeline().end();
    let cuts = |t: &f64| {
        let now = whole.timeline().at(*t);
        // A step of the output is 1.5 r/min in a stage of 6000.
        (now.spindle.actual - n).abs() < 1.0 && now.axes.iter().any(|axis| axis.feed != 0.0)
    };
    let at = (1..1000).map(|k| end * f64::from(k) / 1000.0).find(cuts).expect("a cut at its speed");
    (at, whole.timeline().at(at).spindle.actual)
}

/// Checks that the spindle coasts from `at` on by friction alone: the deceleration is constant, and the turns to rest follow from it.
fn coasts<P: macroline::motion::RunningProgram>(name: &str, planner: &Planner<P>, (at, n): (f64, f64), inertia: f64) {
    let seconds = inertia * n * RPM / 2.0;
    let now = |t: f64| planner.timeline().at(t).spindle;
    for share in [0.25, 0.5, 0.75] {
        let speed = now(at + share * seconds).actual;
        assert!((speed - (1.0 - share) * n).abs() < 2e-3 * n, "{name}: {speed} after {share} of {seconds} s");
    }
    assert!(now(at + 0.99 * seconds).actual > 0.0 && now(at + 1.01 * seconds).actual == 0.0, "{name}: {seconds} s");
    let turns = now(at + 2.0 * seconds).turns - now(at).turns;
    assert!((turns - 0.5 * n / 60.0 * seconds).abs() < 2e-3 * turns, "{name}: {turns} turns");
    // Its energy is the work of the friction.
    let work = 2.0 * turns * std::f64::consts::TAU;
    assert!((work - 0.5 * inertia * n * n * RPM * RPM).abs() < 2e-3 * work, "{name}: {work} J");
}

#[test]
fn spindle_without_current_coasts_by_its_friction() {
    for control in each_control() {
        let lathe = shaft(control, &[]);
        let (at, n) = in_the_cut(&lathe);
        same(value(&lathe, "coasting-time"), value(&lathe, "inertia") * value(&lathe, "speed-largest") * RPM / 2.0);
        let fault = over_time(&lathe, vec![Event { t: at, action: Action::InverterFault(true) }]);
        coasts(&format!("{control}, fault"), &fault, (at, n), INERTIA);
        let mut dark = run_of(&lathe, None);
        dark.lose_power(at);
        dark.advance(f64::INFINITY, usize::MAX);
        coasts(&format!("{control}, power failure"), &dark, (at, n), INERTIA);
    }
}

#[test]
fn each_gear_stage_coasts_with_its_own_inertia() {
    let stages = [("stage-1", "1500"), ("stage-2", "6000"), ("chuck-limit", "6000")];
    for (gear, inertia) in [("1", INERTIA), ("2", INERTIA - 0.03 * 3.75)] {
        let lathe = shaft("gsk-980tdc", &[&stages[..], &[("gear", gear)]].concat());
        let (at, n) = in_the_cut(&lathe);
        let fault = over_time(&lathe, vec![Event { t: at, action: Action::InverterFault(true) }]);
        coasts(&format!("stage {gear}"), &fault, (at, n), inertia);
    }
}

#[test]
fn table_of_stops_has_the_coasting_time_of_the_spindle() {
    for control in each_control() {
        let lathe = shaft(control, &[]);
        let export = lathe.export();
        let report = &export
            .files
            .iter()
            .map(|exported| &exported.file)
            .find(|file| file.name == "report.md")
            .expect("a report")
            .text;
        let fault = report.lines().find(|line| line.starts_with("| Inverter fault | ")).expect("a row");
        // As in the operating envelope: with the knob at its highest position.
        let most = sized(&lathe).envelope.into_iter().filter(|row| row.event == OperatingEvent::PowerFailure);
        let most = most.filter(|row| row.unit == "s").map(|row| row.value).fold(0.0, f64::max);
        let wanted = format!("coasts to rest beside the tool, {most:.1} s");
        assert!(most >= value(&lathe, "coasting-time"), "{control}: {most} s");
        assert!(fault.contains(&wanted) && !fault.contains("open"), "{control}: {fault}");
    }
}

#[test]
fn each_pass_begins_at_the_speed_of_its_diameter() {
    for control in each_control() {
        for path in ["facing", "taper", "turning"] {
            let changes = [("path", path), ("finished-diameter", "20"), ("spindle-ramp", "3")];
            let lathe = project(control, &changes);
            let run = over_time(&lathe, vec![]);
            let timeline = run.timeline();
            let works = lathe.prepared().working(&run, timeline.end()).unwrap();
            assert!(works.len() > 1, "{control} {path}");
            for (begin, _) in works {
                let now = timeline.at(begin + 0.02).spindle;
                let share = now.actual / now.command;
                assert!(
                    (0.85..1.15).contains(&share),
                    "{control} {path} at {begin}: {} of {}",
                    now.actual,
                    now.command
                );
            }
        }
    }
}
