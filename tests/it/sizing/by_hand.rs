//! The hand calculation of `docs/sizing-by-hand.md`, followed step by step: its figures are read from the page.

use macroline::drives::inertia;
use macroline::machines::form::{FieldKindInfo, Value};
use macroline::math;
use macroline::project::Project;

use super::{PULL_ROLLER, pinch, pull, web_mass};

/// The figure of a row of the page, and half a unit of its last digit.
fn figure(step: &str) -> (f64, f64) {
    let page = include_str!("../../../docs/sizing-by-hand.md");
    let row = page.lines().find_map(|line| line.strip_prefix(&format!("| {step} | ")));
    let text = row.unwrap_or_else(|| panic!("no row “{step}”")).split(" |").next().unwrap();
    let decimals = text.split_once('.').map_or(0, |(_, behind)| behind.len());
    (text.parse().unwrap(), 0.5 / math::pow(10.0, decimals as f64))
}

fn follow(step: &str, own: f64) {
    let (printed, within) = figure(step);
    assert!((own - printed).abs() <= within * 1.000_001, "{step}: {printed} on the page, {own} computed");
}

fn paper() -> Project {
    let mut project = Project::named("ribbon-line", Some("mitsubishi-e60"), Some("paper")).unwrap();
    project.values.insert("pi".to_owned(), Value::Text("exact".to_owned()));
    project
}

#[test]
fn inputs_of_the_hand_calculation_are_those_of_the_example() {
    let project = paper();
    for (step, field) in [
        ("pull roller, steel tube: diameter", "x-roller-diameter"),
        ("wall", "x-roller-wall"),
        ("length", "x-roller-length"),
        ("pinch roller: mass", "pinch-mass"),
        ("diameter", "pinch-diameter"),
        ("tension before X, none behind", "tension-before"),
        ("friction at the roller", "friction-x"),
        ("gear", "gear-x"),
        ("its efficiency", "efficiency-x"),
        ("its inertia at the motor", "gear-inertia-x"),
        ("ramp (time constant of the feed)", "time-constant-x"),
        ("motor: rotor", "motor-rotor-x"),
        ("stall torque", "motor-stall-x"),
        ("peak torque", "motor-peak-x"),
    ] {
        let rows = project.machine.fields();
        let row = rows.iter().find(|row| row.id == field).unwrap();
        let FieldKindInfo::Number { default, .. } = row.kind else { panic!("{field} is a number") };
        let value = project.values.get(field).cloned().unwrap_or(Value::Number(default));
        assert_eq!(value, Value::Number(figure(step).0), "{step}, {field}");
    }
}

#[test]
fn hand_calculation_is_followed_step_by_step() {
    follow("ribbon before X: mass", web_mass());
    follow("mass of the tube", PULL_ROLLER.mass());
    follow("inertia of the tube", PULL_ROLLER.inertia());
    follow("pinch roller as the pull roller sees it", pinch());
    let ribbon = inertia::at_radius(web_mass(), PULL_ROLLER.outer / 2.0);
    follow("ribbon", ribbon);
    follow("together behind the gear", PULL_ROLLER.inertia() + pinch() + ribbon);
    follow("at the motor: 0.012915 / 10² + 0.00006", pull().load.inertia * 1e4);
    let design = paper().design();
    let result = |id: &str| design.readouts.iter().find(|row| row.id == id).unwrap();
    follow("speed of the ribbon v", result("line-speed").value / 60.0);
    follow("over the rotor", result("x-inertia-ratio").value);
    follow("steady torque at the motor", result("x-load-torque").value);
    follow("speed of the motor", result("x-motor-speed").value);
    follow("torque of the ramp: 2.366 · 10⁻⁴ · 50.27 / 0.1", result("x-ramp-torque").value);
    follow("highest torque", result("x-peak-torque").value);
    follow("of 80 % of the peak torque, 3.04 Nm", 100.0 * result("x-peak-torque").value / 3.04);
    follow("shortest ramp that those 3.04 Nm allow", result("x-shortest-ramp").value);
}
