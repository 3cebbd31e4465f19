//! The supply reel: its formulas against sums over turns and shells, and its results, verdicts and repairs in the form.

use macroline::drives::inertia::Cylinder;
use macroline::drives::reel::{Reel, acceleration, radius_after, speed, torque, turns};
use macroline::machines::form::Value;
use macroline::math::PI;
use macroline::project::Project;
use macroline::view::{FieldEntry, Verdict};
use proptest::prelude::*;

use super::{line, same};
use crate::queries::{readout, sized_without_envelope};

fn reels() -> impl Strategy<Value = Reel> {
    let sizes = (0.02..2.0_f64, 0.01..0.99_f64, 0.005..1.0_f64, 1e-5..2e-3_f64);
    (sizes, 300.0..3000.0_f64, 0.0..2.0_f64).prop_map(|((full, part, width, thickness), density, core_inertia)| Reel {
        full,
        core: part * full,
        width,
        thickness,
        density,
        core_inertia,
    })
}

/// Diameter (m) after a length (m) was removed from the full reel: `√(D² - 4 t L / π)`, at least the core. Source: sizing facts 2.9.
fn diameter_after(reel: &Reel, length: f64) -> f64 {
    (2.0 * radius_after(0.5 * reel.full, reel.thickness, -length)).max(reel.core)
}

proptest! {
    #[test]
    fn length_is_that_of_its_turns(reel in reels()) {
        // Whole turns, each a circle at its middle.
        let layers = ((reel.full - reel.core) / 2.0 / reel.thickness).floor();
        prop_assume!((1.0..20_000.0).contains(&layers));
        let whole = Reel { full: reel.core + 2.0 * layers * reel.thickness, ..reel };
        let sum: f64 = (0..layers as usize).map(|at| PI * (reel.core + (2.0 * at as f64 + 1.0) * reel.thickness)).sum();
        same("length", whole.length(), sum, 1e-9);
        same("full", whole.full_for(sum), whole.full, 1e-9);
        same("empty", diameter_after(&whole, sum + reel.thickness), reel.core, 1e-3);
        same("turns", turns((reel.core / 2.0, whole.full / 2.0), sum), layers, 1e-9);
    }

    #[test]
    fn removed_and_remaining_length_is_the_full_reel(reel in reels(), share in 0.0..1.0_f64) {
        let gone = share * reel.length();
        let rest = Reel { full: diameter_after(&reel, gone), ..reel };
        same("rest", rest.length() + gone, reel.length(), 1e-9);
        same("back", radius_after(rest.full / 2.0, reel.thickness, gone), reel.full / 2.0, 1e-9);
    }

    #[test]
    fn inertia_is_that_of_its_shells(reel in reels(), share in 0.0..1.0_f64) {
        let diameter = reel.core + share * (reel.full - reel.core);
        let (from, to, shells) = (reel.core / 2.0, diameter / 2.0, 2000);
        let step = (to - from) / f64::from(shells);
        let sum: f64 = (0..shells)
            .map(|at| from + (f64::from(at) + 0.5) * step)
            .map(|r| 2.0 * PI * r * step * reel.width * reel.density * r * r)
            .sum();
        same("inertia", reel.inertia(diameter), sum + reel.core_inertia, 1e-5);
        let web = Cylinder { outer: diameter, inner: reel.core, length: reel.width, density: reel.density };
        same("mass", reel.web_mass(diameter), web.mass(), 1e-12);
    }

    #[test]
    fn no_diameter_pulls_more_than_the_worst(reel in reels()) {
        let worst = reel.mass_at_web(reel.worst());
        for at in 0..=200 {
            let diameter = reel.core + f64::from(at) / 200.0 * (reel.full - reel.core);
            prop_assert!(reel.mass_at_web(diameter) <= worst * (1.0 + 1e-12), "{diameter}");
        }
    }

    #[test]
    fn pull_of_a_run_up_is_the_energy_that_the_reel_has_then(reel in reels(), v in 0.01..5.0_f64, seconds in 0.05..20.0_f64) {
        let diameter = reel.worst();
        let way = 0.5 * v * seconds;
        let turning = speed(diameter, v);
        let energy = 0.5 * reel.inertia(diameter) * turning * turning;
        same("energy", reel.pull(diameter, acceleration(v, seconds)) * way, energy, 1e-9);
        // J α of the reel's own shaft.
        let own = reel.inertia(diameter) * acceleration(v, seconds) / (diameter / 2.0);
        same("torque", torque(diameter, reel.pull(diameter, acceleration(v, seconds))), own, 1e-9);
    }
}

/// A reel of 600 mm on a core of 100 mm, 0.2 mm · 50 mm of 1000 kg/m³.
const LARGE: [(&str, f64); 6] = [
    ("reel-diameter", 600.0),
    ("reel-core-diameter", 100.0),
    ("reel-core-inertia", 0.0),
    ("ribbon-thickness", 0.2),
    ("ribbon-width", 50.0),
    ("web-density", 1000.0),
];

/// A motor that slips more than expected: with F per revolution the axes follow its measured speed.
#[test]
fn speed_of_the_line_is_the_driven_one() {
    let project = line(&[("unwinder-load", 100.0), ("rated-load-speed", 1400.0)]);
    let in_step = [("feed-form", "per-revolution"), ("spindle-encoder", "true"), ("dancer", "false")];
    let project = project.with_entries(&in_step).unwrap();
    let value = |id: &str| readout(&project, id).value;
    let pitch = value("product-length") / value("dots-per-product");
    assert!((value("line-speed") / value("x-feed") - 1.0).abs() > 0.01);
    same("dots", value("line-speed"), value("dots-per-second") * 60.0 * pitch, 1e-12);
    same("time", value("reel-time"), value("reel-length") * 60e3 / value("line-speed"), 1e-12);
}

/// Ribbon (mm) in the loop when M5 stops the unwinder: slack of start, run and stop without `v · t_r / 2`, at the worst position of the knob.
fn left_in_loop(project: &Project) -> f64 {
    let at = |percent: &str| {
        let there = project.with_entries(&[("override", percent)]).unwrap();
        let value = |id: &str| readout(&there, id).value;
        let ramp = 2.0 * value("actual-speed") / 1480.0;
        let of_ramp = value("line-speed") / 60.0 * ramp / 2.0;
        value("slack-start") + value("slack-run") + value("slack-stop") - of_ramp
    };
    ["50", "100", "200"].map(at).into_iter().fold(0.0, f64::max)
}

#[test]
fn results_of_the_reel_follow_the_formulas() {
    let project = line(&LARGE);
    let value = |id: &str| readout(&project, id).value;
    // π (0.36 - 0.01) / (4 · 0.0002)
    let length = PI * 0.35 / 0.0008;
    same("length", value("reel-length"), length, 1e-12);
    same("time", value("reel-time"), length * 60e3 / value("line-speed"), 1e-12);
    // The sensor leaves as much ribbon as the stop takes: v · t_r / 2 at 1480 r/min through 50 : 1 on 100.5 mm, over 2 s.
    let left = PI * 100.5 / 50.0 * 1480.0 / 60.0;
    let left = left + left_in_loop(&project);
    assert_eq!(value("reel-products"), ((length * 1e3 - left) / value("product-length")).floor());
    // π / 32 · ρ · b · (D⁴ - d⁴)
    let inertia = PI / 32.0 * 1000.0 * 0.05 * (0.1296 - 0.0001);
    same("full", value("reel-inertia-full") * 1e-4, inertia, 1e-12);
    assert_eq!(value("reel-inertia-empty"), 0.0);
    same("speed", value("reel-speed-empty"), value("line-speed") / (PI * 100.0), 1e-12);
    same("brake", value("reel-brake-torque-full"), 20.0 * 0.3, 1e-12);
    same("brake", value("reel-brake-torque-empty"), 20.0 * 0.05, 1e-12);
    // 1480 r/min through 50 : 1 on 100.5 mm, reached in 2 s.
    let faster = PI * 0.1005 / 50.0 * 1480.0 / 60.0 / 2.0;
    let extra = inertia / 0.09 * faster;
    same("pull", value("reel-pull"), 20.0 + extra, 1e-12);
    // Torque of the ramp at the motor, with 70 % efficiency of the gear.
    let ramp = value("unwinder-torque") + (40e-4 + inertia / 0.09 * 0.001005 * 0.001005 / 0.7) * PI / 30.0 * 740.0;
    same("ramp", value("unwinder-ramp-torque"), ramp, 1e-12);
}

/// The verdict of a result, and of the same after each of its repairs.
fn mended(project: &Project, id: &str) -> (Verdict, Vec<(&'static str, Verdict)>) {
    let row = readout(project, id);
    let after = |sets: &[FieldEntry]| readout(&project.with_entries(sets).unwrap(), id).verdict;
    let repairs = row.advice.iter().filter(|advice| !advice.entries.is_empty());
    (row.verdict, repairs.map(|advice| (advice.entries[0].field, after(&advice.entries))).collect())
}

#[test]
fn a_reel_of_the_line_passes() {
    for id in ["reel-products", "reel-pull", "reel-brake-needed"] {
        assert_eq!(readout(&line(&[]), id).verdict, Verdict::Ok, "{id}");
    }
}

/// A reel makes whole products, and its change counts for each of them; a product that is longer than the reel takes more than one change.
#[test]
fn products_per_hour_count_the_change_of_the_reel() {
    let seconds = |project: &Project| 3600.0 / readout(project, "products-per-hour").value;
    for (pitches, products) in [(10.0, None), (100_000.0, None), (100.0, Some(0.0))] {
        let diameter = if products.is_some() { 68.0 } else { 224.0 };
        let with = |change: f64| {
            let job = [("pitch-count", pitches), ("reel-diameter", diameter), ("reel-change", change)];
            let project = Project::named("ribbon-line", None, None).unwrap();
            project.with_entries(&job.map(|(id, value)| (id, value.to_string()))).unwrap()
        };
        let (none, some) = (with(0.0), with(300.0));
        let value = |id: &str| readout(&some, id).value;
        same("time", seconds(&none), value("product-time"), 1e-9);
        let of_reel = value("reel-products");
        let changes = match products {
            Some(changes) => changes,
            None if of_reel >= 1.0 => 1.0 / of_reel,
            // The sensor leaves the ribbon of a stop, and the loop has that of start and run.
            None => {
                let left = PI * 100.5 / 50.0 * 1480.0 / 60.0 + left_in_loop(&some);
                value("product-length") / (1e3 * value("reel-length") - left)
            }
        };
        same("change", seconds(&some) - seconds(&none), 300.0 * changes, 1e-6);
        let parts = |project: &Project| 3600.0 / sized_without_envelope(project).cycle.unwrap().parts_per_hour();
        // A reel that ends in the product holds the program, and no cycle is known.
        if of_reel >= 1.0 {
            same("parts", parts(&some) - parts(&none), 300.0 * changes, 1e-6);
        }
    }
}

#[test]
fn start_without_a_ramp_is_no_gentle_start() {
    // No drive starts a reel at once: the form requires a ramp, and the shortest one needs the greatest torque.
    assert!(line(&[]).with_entries(&[("inverter-ramp", "0")]).is_none());
    let hardest = line(&[("inverter-ramp", 0.01)]);
    for id in ["unwinder-ramp-torque", "unwinder-braking-torque"] {
        assert_eq!(readout(&hardest, id).verdict, Verdict::Fail, "{id}");
    }
}

#[test]
fn failing_reel_result_has_an_advice_that_holds() {
    // A product of 4 m on a reel of a metre.
    let short = line(&[("reel-diameter", 70.0)]);
    assert_eq!(mended(&short, "reel-products"), (Verdict::Fail, vec![("reel-diameter", Verdict::Ok)]));
    // A heavy reel that runs up in 20 ms tears soft ribbon; over a longer ramp it does not.
    let hasty = line(&[("reel-core-inertia", 20000.0), ("inverter-ramp", 0.02)]);
    assert_eq!(mended(&hasty, "reel-pull"), (Verdict::Fail, vec![("inverter-ramp", Verdict::Ok)]));
    // A brake that pulls more than the ribbon takes at rest.
    let tight = line(&[("reel-brake", 400.0)]);
    assert_eq!(mended(&tight, "reel-pull"), (Verdict::Fail, vec![("reel-brake", Verdict::Ok)]));
    // A brake that does not stop a heavy reel in time.
    let loose = line(&[("reel-core-inertia", 2000.0), ("reel-brake", 1.0), ("unwinder-motor-brake", 0.0)]);
    let brake = mended(&loose, "reel-brake-needed");
    assert_eq!(brake.0, Verdict::Warn);
    assert!(
        brake.1.contains(&("reel-brake", Verdict::Ok)) && brake.1.iter().all(|row| row.1 == Verdict::Ok),
        "{brake:?}"
    );
}

#[test]
fn brake_of_constant_torque_is_judged_at_the_core() {
    let brake = |force: f64| {
        let mut project = line(&LARGE);
        project.values.insert("reel-brake".to_owned(), Value::Number(force));
        readout(&project, "reel-brake-torque-full")
    };
    // The ribbon bears it up to the tension limit on a radius of 50 mm; the full reel has 300 mm.
    let most = brake(1.0).limit.unwrap().value();
    let tension = most / 0.05;
    assert_eq!(brake(tension / 6.0 - 0.1).verdict, Verdict::Ok);
    let strong = brake(tension / 6.0 + 0.1);
    assert_eq!(strong.verdict, Verdict::Warn);
    assert_eq!(strong.advice[0].message.id, "ribbon.brake-at-core");
}
