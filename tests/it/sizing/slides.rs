//! Drives of the slides of lathes: the demand of the run equals the formulas, and list, bill and envelope include them.

use macroline::machines;
use macroline::machines::driven::devices::BillItem;
use macroline::math;
use macroline::project::Project;
use macroline::project::size::{SizedAxis, Sizing, TerminalRow};
use macroline::view::Verdict;

use crate::queries::{readout, sized};

/// Machines with slides.
const LATHES: [&str; 2] = ["turning-spindle", "polygon-lathe"];

fn lathe(machine: &str, control: &str, entries: &[(&'static str, &str)]) -> Project {
    let entries: Vec<_> = entries.iter().map(|(id, text)| (*id, (*text).to_owned())).collect();
    Project::named(machine, Some(control), None).unwrap().with_entries(&entries).unwrap()
}

fn first_control(machine: &str) -> &'static str {
    machines::find(machine).unwrap().controls()[0]
}

fn axis<'s>(sizing: &'s Sizing, id: &str) -> &'s SizedAxis {
    sizing.axes.iter().find(|axis| axis.id == id).unwrap()
}

#[test]
fn demand_on_a_slide_in_the_run_matches_the_formulas() {
    for name in LATHES {
        for control in machines::find(name).unwrap().controls() {
            for angle in ["0", "45"] {
                let project = lathe(name, control, &[("bed-angle", angle)]);
                let sizing = sized(&project);
                for id in ["x", "z"] {
                    let (work, formula) =
                        (axis(&sizing, id).motor_load.unwrap(), readout(&project, &format!("{id}-peak-torque")));
                    let about = format!("{name} on {control}, {angle}°, {id}: {work:?}, {}", formula.value);
                    // A short move ends before the rapid is reached.
                    assert!(
                        work.peak.torque <= 1.001 * formula.value && work.peak.torque > 0.25 * formula.value,
                        "{about}"
                    );
                }
                let (z, formula) = (axis(&sizing, "z").motor_load.unwrap(), readout(&project, "z-peak-torque"));
                let reaches = z.speed / math::RPM > 0.999 * readout(&project, "z-motor-speed").value;
                assert!(!reaches || (z.peak.torque / formula.value - 1.0).abs() < 1e-3, "{name} on {control}: {z:?}");
            }
        }
    }
}

#[test]
fn cut_loads_the_slide_that_feeds() {
    let effective = |share: &str, id: &str| {
        axis(&sized(&lathe("turning-spindle", "gsk-980tdc", &[("feed-force", share)])), id)
            .motor_load
            .unwrap()
            .effective
    };
    // The default example faces: X feeds, and Z moves beside the work.
    assert!(effective("200", "x") > 1.5 * effective("0", "x"));
    assert_eq!(effective("200", "z"), effective("0", "z"));
}

#[test]
fn slant_bed_is_held_at_rest_and_lifted() {
    let [flat, slant] = ["0", "60"].map(|angle| lathe("turning-spindle", "gsk-980tdc", &[("bed-angle", angle)]));
    let weight = 100.0 * 9.806_65 * math::sin(60_f64.to_radians()) * 0.005 / (2.0 * std::f64::consts::PI);
    let more = readout(&slant, "x-peak-torque").value - readout(&flat, "x-peak-torque").value;
    assert!((more - weight / 0.9).abs() < 1e-9, "{more}");
    let [held, free] = [&slant, &flat].map(|project| axis(&sized(project), "x").motor_load.unwrap().effective);
    assert!(held > free, "{held} {free}");
    // Without current a brake holds it: it is ordered and wired.
    let brakes = |project: &Project| sized(project).bill.iter().filter(|row| row.item == BillItem::Brake).count();
    assert_eq!((brakes(&slant), brakes(&flat)), (1, 0));
}

#[test]
fn brake_of_a_weight_has_its_service_factor() {
    for name in LATHES {
        for angle in [1_u8, 30, 45, 60, 90] {
            let project = lathe(name, first_control(name), &[("bed-angle", &angle.to_string())]);
            let bill = sized(&project).bill;
            let row = bill.iter().find(|row| row.item == BillItem::Brake).unwrap();
            let printed = row.asked.strip_prefix("at least ").unwrap().split(' ').next().unwrap();
            let driven = project.prepared().driven_axes();
            let weight = driven.iter().find(|axis| axis.id == "x").unwrap().weight;
            let over = printed.parse::<f64>().unwrap() - 1.5 * weight;
            assert!((-1e-6..0.01).contains(&over), "{name} {angle}°: {printed} for {weight}");
            assert!(row.source.contains("service factor"), "{}", row.source);
        }
    }
}

#[test]
fn brake_of_a_weight_closes_whenever_its_amplifier_is_off() {
    let sizing = sized(&lathe("turning-spindle", "gsk-980tdc", &[("bed-angle", "60")]));
    let x = Some("slides.drive.x");
    let contactor = sizing.bill.iter().find(|row| row.item == BillItem::BrakeContactor).unwrap();
    assert!(contactor.asked.contains("brake output of the amplifier"), "{}", contactor.asked);
    let leads = |from: BillItem, to: BillItem, axis| {
        let ends = |row: &&TerminalRow| (row.from.item, row.to.item, row.to.axis) == (from, to, axis);
        sizing.terminals.iter().filter(ends).collect::<Vec<_>>()
    };
    // The coil hangs on an output of the amplifier, and the brake on a supply of its own.
    let [coil] = leads(BillItem::Amplifier, BillItem::BrakeContactor, x)[..] else { panic!("one coil") };
    assert!(coil.from.place.ends_with("brake output") && coil.from.axis == x, "{coil:?}");
    assert_eq!(leads(BillItem::ControlSupply, BillItem::BrakeContactor, x).len(), 1);
    assert_eq!(leads(BillItem::BrakeSupply, BillItem::BrakeContactor, x).len(), 2);
    assert_eq!(leads(BillItem::MainSwitch, BillItem::BrakeContactor, x).len(), 0);
    assert_eq!(leads(BillItem::BrakeContactor, BillItem::Brake, x).len(), 2);
}

#[test]
fn stops_of_a_slant_bed_tell_the_brake() {
    for name in LATHES {
        for (angle, has_brake) in [("0", false), ("60", true)] {
            let project = lathe(name, first_control(name), &[("bed-angle", angle)]);
            let sheet = project.prepared().sheets().into_iter().find(|sheet| sheet.id == "stops").unwrap();
            let cell = |at: &str| sheet.rows.iter().find(|row| row.cells[0] == at).map(|row| row.cells[2].clone());
            let stop = cell("Emergency stop").unwrap();
            assert_eq!(stop.contains("the brake of X closes within 0.1 s"), has_brake, "{name} {angle}: {stop}");
            let dark = cell("Power failure").unwrap_or_default();
            assert_eq!(dark.contains("X sinks by at most"), has_brake, "{name} {angle}: {dark}");
        }
        // From rest under T / (J_L + J_M) for 0.1 s.
        let project = lathe(name, first_control(name), &[("bed-angle", "60")]);
        let x = project.prepared().driven_axes().into_iter().find(|axis| axis.id == "x").unwrap();
        let acceleration = x.weight / (x.load.inertia + x.fitted.motor.rotor) / x.radians_per_unit;
        let way = x.sinks().unwrap();
        assert!((way / (0.5 * acceleration * 0.01) - 1.0).abs() < 1e-9 && way < 50.0, "{name}: {way} mm");
    }
}

#[test]
fn every_slide_has_motor_amplifier_and_torque_in_the_answers() {
    for name in LATHES {
        for control in machines::find(name).unwrap().controls() {
            let project = lathe(name, control, &[]);
            let sizing = sized(&project);
            for (id, drive) in [("x", "slides.drive.x"), ("z", "slides.drive.z")] {
                let of = axis(&sizing, id);
                assert!(of.chart.is_some() && !of.candidates.is_empty(), "{name} on {control}: {id}");
                let rows = sizing.bill.iter().filter(|row| row.axis == Some(drive)).count();
                assert!(rows >= 2, "{name} on {control}: {rows} rows of {id}");
                let torque = format!("{id}-torque");
                assert!(
                    sizing.envelope.iter().any(|row| row.quantity.id() == torque && row.verdict == Verdict::Ok),
                    "{torque}"
                );
            }
        }
    }
}

#[test]
fn motor_of_the_list_is_taken_into_the_form() {
    let project = lathe("turning-spindle", "fanuc-0i-tf", &[]);
    let sizing = sized(&project);
    let chosen = axis(&sizing, "z").ordered().expect("a motor of the catalogue passes");
    let taken = project.with_entries(&chosen.entries).unwrap();
    let bill = sized(&taken).bill;
    let motor = bill.iter().find(|row| row.axis == Some("slides.drive.z")).unwrap();
    assert_eq!((motor.model.as_str(), motor.proposed), (chosen.part.model.as_str(), false));
    for id in ["z-motor-speed", "z-peak-torque", "z-inertia-ratio"] {
        assert_eq!(readout(&taken, id).verdict, Verdict::Ok, "{id}");
    }
}

#[test]
fn weak_motors_fail_with_a_remedy() {
    let project = lathe(
        "turning-spindle",
        "gsk-980tdc",
        &[("motor-max-z", "1500"), ("motor-peak-z", "5"), ("motor-stall-x", "0.3")],
    );
    for (id, field) in
        [("z-motor-speed", Some("rapid-z")), ("z-peak-torque", Some("time-constant")), ("x-cut-torque", Some("feed"))]
    {
        let found = readout(&project, id);
        assert_eq!(found.verdict, Verdict::Fail, "{id}");
        assert_eq!(found.advice[0].entries.first().map(|set| set.field), field, "{id}");
    }
}

#[test]
fn weight_helps_a_cut_downhill() {
    // More force than weight.
    let entries = |angle| [("bed-angle", angle), ("path", "facing"), ("feed-force", "200")];
    let bed = |angle| lathe("turning-spindle", "gsk-980tdc", &entries(angle));
    let [flat, slant] = ["0", "45"].map(|angle| readout(&bed(angle), "x-cut-torque").value);
    let weight = 100.0 * 9.806_65 * math::sin(45_f64.to_radians()) * 0.005 / (2.0 * std::f64::consts::PI);
    assert!((flat - slant - weight / 0.9).abs() < 1e-9, "{flat} {slant}");
    // In a cut along the work X is at rest: its motor holds the weight against the cut.
    let along =
        lathe("turning-spindle", "gsk-980tdc", &[("bed-angle", "45"), ("path", "turning"), ("feed-force", "200")]);
    assert!(readout(&along, "x-cut-torque").value > flat);
}

#[test]
fn motor_holds_a_weight_with_a_reserve() {
    let bed = |mass: &str| {
        lathe("turning-spindle", "gsk-980tdc", &[("bed-angle", "90"), ("slide-mass-x", mass), ("lead-x", "10")])
    };
    let held = |mass: &str| readout(&bed(mass), "x-hold-torque");
    // 190 kg · g · 10 mm / 2π = 2.965 Nm of 0.6 · 4.8 Nm.
    assert!((held("190").value - 2.965).abs() < 1e-3);
    assert!((held("190").limit.unwrap().value() - 2.88).abs() < 1e-12);
    assert_eq!([held("190").verdict, held("180").verdict], [Verdict::Fail, Verdict::Ok]);
    let flat = lathe("turning-spindle", "gsk-980tdc", &[]);
    assert!(flat.design().readouts.iter().all(|row| row.id != "x-hold-torque"));
}

#[test]
fn motor_that_the_list_passes_passes_in_the_form() {
    for name in LATHES {
        for control in machines::find(name).unwrap().controls() {
            for entries in [&[][..], &[("cutting-force", "4000"), ("bed-angle", "60"), ("material", "none")]] {
                let entries = if name == "turning-spindle" { entries } else { &entries[..0] };
                let project = lathe(name, control, entries);
                let sizing = sized(&project);
                for id in ["x", "z"] {
                    let passing = axis(&sizing, id).candidates.iter().filter(|of| of.refusal.is_none());
                    let motors: Vec<_> = passing.filter(|of| !of.entries.is_empty()).take(4).collect();
                    assert!(!motors.is_empty(), "{id} of {name} on {control}");
                    for motor in motors {
                        let fitted = project.with_entries(&motor.entries).unwrap();
                        for row in ["motor-speed", "cut-torque", "peak-torque"] {
                            let row = readout(&fitted, &format!("{id}-{row}"));
                            let about =
                                format!("{name} on {control}: {}, {} of {:?}", motor.part.model, row.value, row.limit);
                            assert_ne!(row.verdict, Verdict::Fail, "{} {about}", row.id);
                        }
                    }
                }
            }
        }
    }
}

#[test]
fn motor_of_a_slide_is_judged_by_its_heat_in_the_run() {
    // Short ways at full rapid of a heavy slide: no torque exceeds its limit, and the motor gets too hot.
    let entries = [
        ("path", "turning"),
        ("length", "100"),
        ("work-length", "160"),
        ("stock-diameter", "60"),
        ("finished-diameter", "40"),
        ("depth", "0.5"),
        ("feed", "1.2"),
        ("cutting-speed", "350"),
        ("upper-limit", "2500"),
        ("rapid-z", "20000"),
        ("lead-z", "10"),
        ("slide-mass-z", "1000"),
        ("screw-diameter-z", "50"),
        ("screw-length-z", "1500"),
        ("motor-rotor-z", "20"),
        ("time-constant", "250"),
        ("material", "none"),
        ("cutting-force", "400"),
        ("motor-power", "22"),
    ];
    let heavy = lathe("turning-spindle", "gsk-980tdc", &entries);
    assert_eq!(readout(&heavy, "z-peak-torque").verdict, Verdict::Ok);
    let sizing = sized(&heavy);
    let heats = sizing.envelope.iter().filter(|row| row.quantity.id() == "z-effective-torque");
    let heat = heats.max_by(|a, b| a.value.total_cmp(&b.value)).unwrap();
    // In a shorter part with more force: with the feed override at its highest position.
    assert_eq!((heat.verdict, heat.feed), (Verdict::Fail, Some(150.0)), "{} {:?}", heat.value, heat.limit);
    assert!((heat.limit.unwrap().value() - 0.8 * 4.8).abs() < 1e-12);
    assert_eq!(heat.value, axis(&sizing, "z").motor_load.unwrap().effective);
}

#[test]
fn end_turned_before_the_polygon_loads_the_slides() {
    let threaded = Project::named("polygon-lathe", None, Some("threaded-shaft")).unwrap();
    let cut = |depth: &str| {
        let entries = [
            ("material", "none".to_owned()),
            ("specific-force", "1750".to_owned()),
            ("rake", "0".to_owned()),
            ("before-depth", depth.to_owned()),
            ("before-feed", "0.6".to_owned()),
        ];
        threaded.with_entries(&entries).unwrap()
    };
    // 1750 N/mm² · 6 mm · 0.6 mm = 6300 N, half of it against the feed, beside 250 N of friction, on a screw of 5 mm.
    let expected = (3150.0 + 250.0) * 0.005 / (2.0 * std::f64::consts::PI * 0.9);
    let deep = cut("6");
    assert!((readout(&deep, "z-cut-torque").value - expected).abs() < 1e-9);
}

/// A cylinder with short, quick passes, and a light rotor at the screw of Z: about 200 starts per minute.
const QUICK: [(&str, &str); 8] = [
    ("path", "turning"),
    ("stock-diameter", "60"),
    ("finished-diameter", "40"),
    ("length", "3"),
    ("depth", "0.5"),
    ("feed", "0.6"),
    ("material", "aluminium"),
    ("motor-rotor-z", "5"),
];

#[test]
fn many_starts_limit_the_inertia_in_form_and_list_alike() {
    let quick = lathe("turning-spindle", "gsk-980tdc", &QUICK);
    let ratio = readout(&quick, "z-inertia-ratio");
    assert!((4.0..5.0).contains(&ratio.value), "{}", ratio.value);
    assert_eq!((ratio.verdict, ratio.limit.unwrap().value()), (Verdict::Warn, 3.0));
    assert_eq!(ratio.advice[0].message.id, "slides.inertia-at-starts");
    // No motor of the list has more than that: those that do are refused for it.
    let load = readout(&quick, "z-load-inertia").value;
    let sizing = sized(&quick);
    let ratios = axis(&sizing, "z").candidates.iter().filter(|motor| motor.refusal.is_none());
    let ratios: Vec<f64> = ratios.filter_map(|motor| Some(load * 1e-4 / motor.part.servo()?.rotor)).collect();
    assert!(!ratios.is_empty() && ratios.iter().all(|ratio| *ratio <= 3.0), "{ratios:?}");
    // A slow feed makes the passes long.
    let slow = lathe("turning-spindle", "gsk-980tdc", &[&QUICK[..], &[("feed", "0.05")]].concat());
    let ratio = readout(&slow, "z-inertia-ratio");
    assert_eq!((ratio.verdict, ratio.limit.unwrap().value()), (Verdict::Ok, 5.0));
}
