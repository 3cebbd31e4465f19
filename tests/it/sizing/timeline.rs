//! Torque summed over the run of the program itself against the closed forms of the results.

use macroline::drives::load::{self, Load};
use macroline::math::PI;
use macroline::motion::{Budget, Retention};
use macroline::project::Project;
use macroline::project::run::{self, RunOptions};

/// Seconds between two looks at the run.
const STEP: f64 = 0.0005;

/// What may lie between sum and closed form.
const WITHIN: f64 = 1e-3;

/// Highest and effective torque of motor X over one product of `seconds`, from what the drive is commanded; at rest it holds the web.
fn torque_of_x(project: &Project, load: &Load, rotor: f64, per_mm: f64, hold: f64, seconds: f64) -> (f64, f64) {
    let written = project.written();
    let limits = Budget { blocks: 1_000_000, seconds: 600.0 };
    let begin = RunOptions { start: None, settings: &[], limits, keep: Retention::Timeline };
    let mut run = run::of_project(project, &written, &begin);
    while run.advance(f64::INFINITY, 100_000).ended.is_none() {}
    let (mut peak, mut square, mut moving) = (0.0_f64, 0.0, 0.0);
    let steps = (run.timeline().end() / STEP).ceil() as u32;
    for step in 0..steps {
        let now = run.timeline().at((f64::from(step) + 0.5) * STEP).axes[0];
        // Rounding leaves a little of a speed.
        if now.feed < 1e-6 {
            continue;
        }
        let acceleration = now.acceleration * per_mm;
        let inertia = if acceleration < 0.0 { load.inertia * load.efficiency } else { load.inertia / load.efficiency };
        let torque = load.torque + (inertia + rotor) * acceleration;
        peak = peak.max(torque);
        square += torque * torque * STEP;
        moving += STEP;
    }
    (peak, ((square + hold * hold * (seconds - moving)) / seconds).sqrt())
}

#[test]
fn torque_over_the_run_is_that_of_the_results() {
    for control in ["mitsubishi-e60", "sinumerik-802d", "fanuc-0i-mf"] {
        let mut project = Project::named("ribbon-line", Some(control), None).unwrap();
        // Ramps that weigh, and a product that is soon over.
        for (field, value) in [("motor-rotor-x", 60.0), ("pitch-count", 40.0)] {
            project.values.insert(field.to_owned(), macroline::machines::form::Value::Number(value));
        }
        let design = project.design();
        let result = |id: &str| design.readouts.iter().find(|row| row.id == id).unwrap().value;
        let (gear, roller) = (50.0, 0.1);
        let load = Load { inertia: result("x-load-inertia") * 1e-4, torque: result("x-load-torque"), efficiency: 0.95 };
        let hold = load::through_gear(15.0 * roller / 2.0, gear, 1.0);
        // Radians of the motor per millimetre of ribbon.
        let per_mm = 2.0 * PI * gear / (PI * roller * 1e3);
        let (peak, effective) = torque_of_x(&project, &load, 60e-4, per_mm, hold, result("product-time"));
        super::same(&format!("{control}, highest"), peak, result("x-peak-torque"), WITHIN);
        super::same(&format!("{control}, effective"), effective, result("x-effective-torque"), WITHIN);
    }
}
