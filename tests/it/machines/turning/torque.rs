//! Torque of the turning spindle: the motor's curve in its gear stages, and the force of the cut by material.

use macroline::controls::interface::SignalRole;
use macroline::machines::driven::devices::BillItem;
use macroline::machines::ladder::scan::Image;
use macroline::machines::ladder::{Bit, MachineContact, MachineOutput};
use macroline::math;
use macroline::project::Project;
use macroline::view::{FieldEntry, Verdict};

use super::{machine, project};
use crate::queries::{near, near_share, readout, sized_without_envelope, value};

/// Ø 300, 45 m/min, 1500 N in a stage of 3000 r/min: little power, and far too much torque.
const STALLS: [(&str, &str); 10] = [
    ("path", "turning"),
    ("stock-diameter", "300"),
    ("finished-diameter", "290"),
    ("depth", "2"),
    ("cutting-speed", "45"),
    ("cutting-force", "1500"),
    ("stage-1", "3000"),
    ("stage-2", "0"),
    ("start-x", "400"),
    ("motor-forced-cooling", "true"),
];

#[test]
fn torque_beyond_the_motor_fails_though_power_suffices() {
    for control in ["gsk-980tdc", "sinumerik-802d", "knd-k2000t", "mitsubishi-e60"] {
        let stalls = project(control, &STALLS);
        let (power, torque) = (readout(&stalls, "power"), readout(&stalls, "torque"));
        assert_eq!(power.verdict, Verdict::Ok, "{control}");
        assert!((1.0..1.2).contains(&power.value), "{control}: {}", power.value);
        assert_eq!(torque.verdict, Verdict::Fail, "{control}");
        // 1500 N at Ø 298, the middle of the edge in the first pass, and 2 Nm of friction; 9549.3 · 7.5 · 0.8 / 3000.
        near(torque.value, 225.5, 1e-6);
        near(value(&stalls, "torque-available"), 19.1, 0.01);
        near(torque.limit.unwrap().value(), 19.1, 0.01);
    }
}

/// A motor of 7.5 kW at 2000 r/min that the inverter turns at 1000 r/min with 10 V gives half its power: 9549.3 · 7.5 · 0.8 / 2000 at the
/// motor, 1000 / 800 times as much at the spindle.
#[test]
fn motor_below_its_base_speed_has_its_torque_alone() {
    let stage = [("motor-top", "1000"), ("stage-1", "800"), ("stage-2", "0"), ("motor-forced-cooling", "true")];
    let lathe = project("gsk-980tdc", &[&stage[..], &[("motor-base", "2000")]].concat());
    near(value(&lathe, "torque-available"), 9_549.297 * 7.5 * 0.8 / 2000.0 * 1000.0 / 800.0, 0.01);
}

#[test]
fn lower_stage_with_enough_torque_is_offered() {
    let stages = [("stage-1", "200"), ("stage-2", "3000"), ("gear", "2")];
    let stalls = project("gsk-980tdc", &[&STALLS[..], &stages].concat());
    let torque = readout(&stalls, "torque");
    assert_eq!(torque.verdict, Verdict::Fail);
    assert_eq!(torque.advice[0].entries, [FieldEntry::new("gear", "1")]);
    let after = stalls.with_entries(&torque.advice[0].entries).unwrap();
    // The motor has 286.5 Nm; with the feed override at 150 % the cut needs more.
    assert!(readout(&after, "torque").verdict < Verdict::Fail);
}

/// 66 to 60 mm, 200 m/min, 3 mm by 0.3 mm of C45, κ 95°: 1760.9 N, at Ø 63 6.163 kW, 55.47 Nm (turning spindle facts 4), beside 2 Nm of
/// friction at 1061 r/min.
pub(super) const CUT_OF_THE_FACTS: [(&str, &str); 8] = [
    ("path", "turning"),
    ("stock-diameter", "66"),
    ("finished-diameter", "60"),
    ("depth", "3"),
    ("feed", "0.3"),
    ("cutting-speed", "200"),
    ("material", "c45"),
    ("motor-base", "500"),
];

#[test]
fn kienzle_force_is_that_of_the_fact_sheet() {
    let lathe = project("gsk-980tdc", &[&CUT_OF_THE_FACTS[..], &[("motor-power", "11")]].concat());
    near(value(&lathe, "force"), 1760.9, 0.05);
    near(value(&lathe, "torque"), 55.47 + 2.0, 0.005);
    near(value(&lathe, "power"), 6.163 + 2.0 * 1061.03 / 9_549.297, 0.001);
    // The power of the removed metal: the ring of a turn times its length, times the specific force.
    let removed = std::f64::consts::PI / 4.0 * (66.0 * 66.0 - 60.0 * 60.0) * 0.3 * 1061.03 / 60.0;
    near(6.163, removed * value(&lathe, "force") / (3.0 * 0.3) / 1e6, 0.001);
    let torque = readout(&lathe, "torque");
    assert!(torque.limit.unwrap().holds(torque.value), "{torque:?}");
}

#[test]
fn worn_edge_cuts_with_more_force() {
    let force = |wear: &'static str| {
        let lathe = project("gsk-980tdc", &[("path", "turning"), ("material", "c45"), ("edge-wear", wear)]);
        (value(&lathe, "force"), value(&lathe, "torque") - 2.0)
    };
    let (sharp, worn) = (force("1"), force("1.5"));
    near(worn.0, 1.5 * sharp.0, 1e-9);
    near(worn.1, 1.5 * sharp.1, 1e-9);
}

/// Ø 40 to Ø 24 in one pass: the edge reaches from 12 to 20 mm, 16 in the middle.
#[test]
fn deep_cut_has_its_torque_at_the_middle_of_the_edge() {
    let cut = [
        ("path", "turning"),
        ("stock-diameter", "40"),
        ("finished-diameter", "24"),
        ("depth", "8"),
        ("material", "none"),
        ("cutting-force", "4696"),
    ];
    near(value(&project("gsk-980tdc", &cut), "torque"), 4696.0 * 16.0 / 1000.0 + 2.0, 1e-6);
}

/// A taper that leaves the stock, and a facing cut that begins beside it: nothing is cut there.
#[test]
fn air_beside_the_stock_asks_no_torque() {
    let force = [("material", "none"), ("cutting-force", "1000")];
    let taper = [
        ("path", "taper"),
        ("stock-diameter", "100"),
        ("finished-diameter", "60"),
        ("large-diameter", "99"),
        ("depth", "2"),
        ("length", "50"),
        ("start-x", "200"),
    ];
    let facing = [("stock-diameter", "20"), ("finished-diameter", "4"), ("clearance", "20")];
    let torque =
        |cut: &[(&'static str, &'static str)]| value(&project("gsk-980tdc", &[cut, &force].concat()), "torque");
    near(torque(&taper), 1000.0 * 98.0 / 2000.0 + 2.0, 1e-6);
    near(torque(&facing), 1000.0 * 20.0 / 2000.0 + 2.0, 1e-6);
}

/// The program engages a stage once: at another position of the knob the cut is in the same one.
#[test]
fn knob_leaves_the_best_stage_engaged() {
    let cut = [
        ("path", "turning"),
        ("stock-diameter", "300"),
        ("finished-diameter", "290"),
        ("depth", "5"),
        ("cutting-speed", "240"),
        ("stage-1", "250"),
        ("stage-2", "1000"),
        ("stage-3", "0"),
        ("material", "none"),
        ("cutting-force", "380"),
        ("start-x", "400"),
    ];
    let [best, second] = ["best", "2"].map(|gear| project("gsk-980tdc", &[&cut[..], &[("gear", gear)]].concat()));
    assert_eq!(value(&best, "stage"), 2.0);
    let judged = |project: &Project| (readout(project, "torque").verdict, readout(project, "torque").advice);
    assert_eq!(judged(&best), judged(&second));
}

#[test]
fn less_depth_is_offered_where_the_force_follows_from_it() {
    let cut = [&STALLS[..], &[("material", "c45"), ("depth", "5")]].concat();
    let stalls = project("gsk-980tdc", &cut);
    let torque = readout(&stalls, "torque");
    let [FieldEntry { field: "depth", text: depth }] = &torque.advice[0].entries[..] else {
        panic!("{:?}", torque.advice)
    };
    assert!(depth.parse::<f64>().unwrap() < 5.0);
    let after = stalls.with_entries(&torque.advice[0].entries).unwrap();
    assert!(readout(&after, "torque").verdict < Verdict::Fail);
}

#[test]
fn overload_is_a_warning_within_its_share() {
    // 222 Nm: base speed 300 · 3000 / 1500 gives 95 Nm, and 250 % of it 239 Nm.
    let cut = |entries: [(&'static str, &'static str); 2]| {
        let short = [("motor-base", "300"), ("length", "10"), ("feed", "0.5"), ("pause", "3600")];
        project("gsk-980tdc", &[&STALLS[..], &short, &entries].concat())
    };
    assert_eq!(readout(&cut([("motor-overload", "250"), ("feed", "0.5")]), "torque").verdict, Verdict::Warn);
    assert_eq!(readout(&cut([("motor-overload", "200"), ("feed", "0.5")]), "torque").verdict, Verdict::Fail);
    // 4 minutes at most: a slow feed takes longer.
    let long = cut([("motor-overload", "250"), ("feed", "0.01")]);
    assert!(value(&long, "cutting-time") > 240.0);
    assert_eq!(readout(&long, "torque").verdict, Verdict::Fail);
    // 4 minutes in 10: the cuts are two fifths of the time with the pause that the advice gives.
    let busy = cut([("motor-overload", "250"), ("pause", "0")]);
    let torque = readout(&busy, "torque");
    assert_eq!((torque.verdict, torque.advice[0].message.id), (Verdict::Fail, "turning.overload-without-pause"));
    let rested = busy.with_entries(&torque.advice[0].entries).unwrap();
    assert_eq!(readout(&rested, "torque").verdict, Verdict::Warn);
    let [FieldEntry { field: "pause", text }] = &torque.advice[0].entries[..] else { panic!("{:?}", torque.advice) };
    near(text.parse().unwrap(), 1.5 * value(&busy, "cutting-time"), 0.1);
}

#[test]
fn cut_is_judged_with_the_knob_at_its_highest_position_too() {
    let cut = |percent: &'static str| {
        let entries = [
            ("cutting-force", "1850"),
            ("material", "none"),
            ("motor-base", "600"),
            ("motor-peak", "200"),
            ("override", percent),
        ];
        let entries = entries.map(|(id, text)| (id, text.to_owned()));
        let lathe = Project::named("turning-spindle", Some("gsk-980tdc"), None).unwrap();
        readout(&lathe.with_entries(&entries).unwrap(), "power")
    };
    let [present, highest] = ["100", "120"].map(cut);
    assert_eq!([present.verdict, highest.verdict], [Verdict::Warn, Verdict::Fail]);
    assert!(present.value < present.limit.unwrap().value() && highest.value > highest.limit.unwrap().value());
    assert_eq!(present.advice[0].message.id, "turning.power-at-knobs");
}

#[test]
fn positioning_asks_no_more_than_the_motor_gives() {
    let keyway = |acceleration: &'static str| {
        let project = Project::named("turning-spindle", Some("sinumerik-802d"), Some("keyway")).unwrap();
        let entries = [("positioning-acceleration", acceleration.to_owned()), ("positioning-speed", "500".to_owned())];
        project.with_entries(&entries).unwrap()
    };
    let hard = keyway("6000");
    let torque = readout(&hard, "positioning-torque");
    assert_eq!(torque.verdict, Verdict::Fail);
    let inertia = value(&hard, "inertia");
    near(torque.value, inertia * 6000.0 * std::f64::consts::PI / 30.0 + 2.0, 1e-6 * torque.value);
    let softer = hard.with_entries(&torque.advice[0].entries).unwrap();
    assert_eq!(readout(&softer, "positioning-torque").verdict, Verdict::Ok);
    assert_eq!(readout(&keyway("500"), "positioning-torque").verdict, Verdict::Ok);
}

#[test]
fn examples_pass_with_each_material_at_light_cuts() {
    for (id, _) in macroline_materials() {
        let cut = [("material", id.as_str()), ("depth", "0.2"), ("feed", "0.05"), ("upper-limit", "1800")];
        let light = project("gsk-980tdc", &cut);
        let red: Vec<_> = light.design().readouts.into_iter().filter(|row| row.verdict == Verdict::Fail).collect();
        assert!(red.is_empty(), "{id}: {:?}", red.iter().map(|row| row.id).collect::<Vec<_>>());
    }
}

#[test]
fn no_speed_is_offered_where_none_is_slow_enough() {
    // 300 kW for a motor of 8 W: at 1 m/min it is still 1.7 kW. Without a material no smaller depth can be advised.
    let cut = [("cutting-force", "100000"), ("motor-power", "0.01")];
    let power = readout(&project("gsk-980tdc", &cut), "power");
    assert_eq!(power.verdict, Verdict::Fail);
    let [advice] = &power.advice[..] else { panic!("{:?}", power.advice) };
    assert_eq!((advice.message.id, advice.entries.len()), ("turning.far-too-little-power", 0));
}

/// Materials of the form.
fn macroline_materials() -> Vec<(String, String)> {
    let fields = machine().fields();
    let field = fields.into_iter().find(|field| field.id == "material").unwrap();
    let macroline::machines::form::FieldKindInfo::Choice(options) = field.kind else { panic!("no choice") };
    options.iter().map(|(id, label)| ((*id).to_owned(), (*label).to_owned())).collect()
}

/// A slender bar of 300 mm by 20 mm, or of another length, in the chuck alone or held by the tailstock too.
fn bar(length: &str, tailstock: &str) -> Project {
    let changes = [
        ("path", "turning"),
        ("length", length),
        ("work-length", length),
        ("stock-diameter", "22"),
        ("material", "c45"),
        ("tailstock", tailstock),
    ];
    project("gsk-980tdc", &changes)
}

/// A slender bar without a tailstock bends by `F L³ / 3 E I`; with a tailstock, by a 34th part.
#[test]
fn slender_bar_asks_for_the_tailstock_that_holds_it() {
    let bends = |length: &str, tailstock: &str| readout(&bar(length, tailstock), "bending");
    let slender = bends("300", "false");
    let moment = std::f64::consts::PI * math::pow(20.0, 4.0) / 64.0;
    let force = readout(&bar("300", "false"), "force").value;
    near_share(slender.value, force * math::pow(300.0, 3.0) / (3.0 * 210e3 * moment), 1e-9);
    // The bar bends by more than the depth of cut.
    assert!(slender.value > 2.0, "{}", slender.value);
    assert_eq!((slender.verdict, slender.advice[0].message.id), (Verdict::Fail, "turning.work-gives-way"));
    let held = bends("300", "true");
    near_share(held.value, slender.value / 34.0, 1e-9);
    assert_eq!(slender.advice[0].entries, [FieldEntry::new("tailstock", "true")]);
    assert_eq!(held.verdict, Verdict::Ok);
    let less = bends("110", "false");
    assert!((0.1..1.0).contains(&less.value), "{}", less.value);
    assert_eq!((less.verdict, less.advice[0].message.id), (Verdict::Warn, "turning.work-bends"));
    assert_eq!(bends("60", "false").verdict, Verdict::Ok);
    // Too slender for a tailstock alone.
    let thin = bends("1200", "true");
    assert_eq!((thin.verdict, thin.advice[0].message.id), (Verdict::Fail, "turning.held-work-gives-way"));
}

/// The program names the tailstock; its pressure switch holds the program while the work is not held, and is in the bill.
#[test]
fn tailstock_is_in_program_ladder_and_bill() {
    let (held, free) = (bar("300", "true"), bar("300", "false"));
    let names_it = |project: &Project| {
        project.written().files.0.iter().any(|file| file.text.contains("(THE TAILSTOCK HOLDS THE WORK)"))
    };
    assert!(names_it(&held));
    assert!(!names_it(&free));
    // A face is turned to the centre: there is no room for a tailstock.
    assert!(!names_it(&held.with_entries(&[("path", "facing".to_owned())]).unwrap()));
    let switches = |project: &Project| {
        let bill = sized_without_envelope(project).bill;
        bill.iter().filter(|row| row.item == BillItem::TailstockSwitch).count()
    };
    assert_eq!((switches(&held), switches(&free)), (1, 0));
    let ladder = held.prepared().ladder().expect("a ladder");
    let mut image = Image::default();
    let others = [MachineContact::HoldKey, MachineContact::Emergency, MachineContact::InverterReady];
    others.into_iter().for_each(|contact| image.set(Bit::Input(contact), true));
    for closed in [false, true] {
        image.set(Bit::Input(MachineContact::WorkHeld), closed);
        (0..12).for_each(|_| ladder.scan(0.0, &mut image));
        assert_eq!(image.is_on(Bit::Signal(SignalRole::HoldReleased)), closed);
    }
    assert!(image.is_on(Bit::Output(MachineOutput::Message(MachineContact::WorkHeld))));
}

/// A cone of Ø 45 at the face, where the tailstock holds it, and Ø 12 behind it is as weak as its thin part.
#[test]
fn held_cone_bends_as_its_slices_do() {
    let cone = |large: &'static str| {
        let cut = [
            ("path", "taper"),
            ("tailstock", "true"),
            ("material", "c45"),
            ("cutting-speed", "120"),
            ("depth", "1.5"),
            ("feed", "0.3"),
            ("stock-diameter", "50"),
            ("finished-diameter", "45"),
            ("large-diameter", large),
            ("length", "350"),
            ("work-length", "390"),
            ("grip", "20"),
            ("start-x", "130"),
        ];
        let lathe = project("gsk-980tdc", &cut);
        (value(&lathe, "bending"), value(&lathe, "force"))
    };
    let (bends, force) = cone("12");
    near(
        bends,
        most_of_held(force, &|behind| if behind < 350.0 { 45.0 - 33.0 * behind / 350.0 } else { 50.0 }),
        1e-2 * bends,
    );
    let (even, force) = cone("44.999");
    near_share(even, most_of_held(force, &|behind| if behind < 350.0 { 45.0 } else { 50.0 }), 1e-3);
    // A cylinder of one diameter bends by F L³ / 102 E I.
    let moment = std::f64::consts::PI * math::pow(45.0, 4.0) / 64.0;
    near_share(most_of_held(force, &|_| 45.0), force * math::pow(370.0, 3.0) / (102.0 * 210e3 * moment), 2e-3);
}

/// Greatest deflection (mm) under the force, over its places, of a bar of steel of 370 mm: at the face a hinge, clamped in the jaws. The hinge's force R
/// leaves no deflection at the face; unit loads, in small steps.
fn most_of_held(force: f64, diameter: &dyn Fn(f64) -> f64) -> f64 {
    let (length, steps) = (370.0, 2000);
    let step = length / f64::from(steps);
    let at: Vec<f64> = (0..steps).map(|k| (f64::from(k) + 0.5) * step).collect();
    let soft: Vec<f64> = at
        .iter()
        .map(|behind| 64.0 * step / (std::f64::consts::PI * math::pow(diameter(*behind), 4.0) * 210e3))
        .collect();
    let sum = |of: &dyn Fn(f64) -> f64| at.iter().zip(&soft).map(|(x, soft)| of(*x) * soft).sum::<f64>();
    let hinge = sum(&|x| x * x);
    let bends = |load: f64| {
        let arm = |x: f64| (x - load).max(0.0);
        sum(&|x| arm(x) * arm(x)) - math::pow(sum(&|x| arm(x) * x), 2.0) / hinge
    };
    force * (0..200).map(|k| bends(length * f64::from(k) / 200.0)).fold(0.0, f64::max)
}

/// A depth above the allowance of 2 mm is one pass of the allowance.
#[test]
fn depth_grows_to_one_pass_of_the_stock() {
    let growth = |allowance: &'static str| {
        let sizing = sized_without_envelope(&project("gsk-980tdc", &[("allowance", allowance)]));
        let depth = sizing.limits.iter().find(|growth| growth.field == "depth").unwrap();
        (depth.value, depth.binding.is_some(), depth.more_is_unused)
    };
    assert_eq!(growth("2"), (2.0, false, true));
    assert!(!growth("100").2);
}
