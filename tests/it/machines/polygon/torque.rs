//! Torque of the polygon lathe: the interrupted cut against kinematics in the frame of the machine, energy, run-up, and the remedies.

use std::f64::consts::PI;

use macroline::drives::polygon::{CutterSetup, Ratio, Section, load};
use macroline::math;
use macroline::project::Project;
use macroline::view::{FieldEntry, Verdict};

use super::project;
use crate::queries::{near_share, readout, sized_without_envelope, value};

/// The paper's single pass: 2.5 mm deep at 1 mm for each turn, tips at 45 mm.
const SINGLE: [(&str, &str); 4] = [("depth", "2.5"), ("allowance", "0"), ("feed", "1"), ("finish-feed", "1")];

#[test]
fn peak_in_the_middle_of_a_side_is_force_times_radius() {
    let square = project(&SINGLE);
    // 1750 N/mm² · 2.5 mm · 1 mm at 45 mm from the tool's axis and 10 mm from that of the work.
    near_share(value(&square, "cutting-force"), 4375.0, 1e-9);
    near_share(value(&square, "tool-torque"), 4375.0 * 0.045, 1e-9);
    assert!(value(&square, "work-torque") >= 4375.0 * 0.010 * (1.0 - 1e-9));
    // C45 after Kienzle: 1500 · 2.5 · 1^0.78, and half of the feed 0.5^0.78 of it.
    let steel = project(&[&SINGLE[..], &[("material", "c45")]].concat());
    near_share(value(&steel, "tool-torque"), 1500.0 * 2.5 * 0.045, 1e-9);
    let slow = project(&[&SINGLE[..], &[("material", "c45"), ("feed", "0.5")]].concat());
    near_share(value(&slow, "tool-torque"), 1500.0 * 2.5 * math::pow(0.5, 0.78) * 0.045, 1e-9);
    // 45 mm, 10 mm, stock of 12.5 mm: cos σ = (a² + r² - R²) / (2 a r), so that one insert of two is in the cut.
    assert_eq!(value(&square, "at-once"), 1.0);
}

/// Mean and peak torque (Nm) of work and tool of the first pass, from positions and motions of the tips in the frame of the machine: tips
/// on a circle of radius r about (a, 0), work about 0, force against the motion of the tip over the work. In the mean the layer has the area
/// of a sector of a ring.
fn turned(inserts: u32, (tool, work): (f64, f64), d: f64, r: f64, stock: f64, force_per_depth: f64) -> [(f64, f64); 2] {
    let (a, k) = (d + r, tool / work);
    const STEPS: u32 = 400_000;
    let mut sums = [(0.0_f64, 0.0_f64); 2];
    for step in 0..STEPS {
        // The work turns by 1 rad in a unit of time, the tool by k.
        let time = 2.0 * PI / k.abs() * f64::from(step) / f64::from(STEPS);
        let (mut now, mut of_area) = ([0.0; 2], [0.0; 2]);
        for insert in 0..inserts {
            let angle = PI + k * time + 2.0 * PI * f64::from(insert) / f64::from(inserts);
            let arm = (r * math::cos(angle), r * math::sin(angle));
            let at = (a + arm.0, arm.1);
            let reach = math::hypot(at.0, at.1);
            if reach >= stock {
                continue;
            }
            let motion = (-k * arm.1 + at.1, k * arm.0 - at.0);
            let speed = math::hypot(motion.0, motion.1);
            let along = (motion.1 * at.0 - motion.0 * at.1).abs() / (reach * speed);
            let force = force_per_depth * (stock - reach) * along;
            let pull = (-force * motion.0 / speed, -force * motion.1 / speed);
            // The work feels the opposite of the tip.
            let torques =
                [-(at.0 * pull.1 - at.1 * pull.0), arm.0 * pull.1 - arm.1 * pull.0].map(|torque| torque / 1000.0);
            for (axis, torque) in torques.into_iter().enumerate() {
                now[axis] += torque;
                of_area[axis] += torque * (stock + reach) / (2.0 * reach);
            }
        }
        for (axis, sum) in sums.iter_mut().enumerate() {
            *sum = (sum.0 + of_area[axis] / f64::from(STEPS), sum.1.max(now[axis].abs()));
        }
    }
    sums.map(|(mean, peak)| (mean.abs(), peak))
}

/// Checks the results of the first pass against the tips in motion, which advance by `chip` mm of feed between two cuts of a side.
#[track_caller]
fn same_as_in_motion(changes: &[(&str, &str)], inserts: u32, terms: (f64, f64), (d, chip): (f64, f64)) {
    // Sides that do not meet in the stock; the second pass cuts nothing.
    let plain = [("depth", "1"), ("allowance", "0"), ("feed", "0.4")];
    let lathe = project(&[&plain[..], changes].concat());
    let expected = turned(inserts, terms, d, 45.0, 12.5, 1750.0 * chip);
    for (id, (mean, peak)) in ["work-torque", "tool-torque"].into_iter().zip(expected) {
        near_share(value(&lathe, id), peak, 1e-3);
        near_share(value(&lathe, &format!("{id}-mean")), mean, 2e-3);
    }
}

#[test]
fn first_pass_has_the_torque_of_the_tips_in_motion() {
    same_as_in_motion(&[("across-flats", "23")], 2, (2.0, 1.0), (11.5, 0.4));
    same_as_in_motion(&[("shape", "knob"), ("across-flats", "23")], 1, (2.0, 1.0), (11.5, 0.4));
    same_as_in_motion(&[("shape", "hexagon"), ("across-flats", "24.5")], 3, (2.0, 1.0), (12.25, 0.4));
    same_as_in_motion(&[("shape", "triangle"), ("across-flats", "23")], 2, (3.0, 2.0), (11.5, 0.4));
    let own = [("shape", "own"), ("inserts", "1"), ("across-flats", "23")];
    // One insert at 3 : 2 cuts each side once in two turns of the work.
    let star = [&own[..], &[("sides", "3"), ("tool-ratio", "3"), ("work-ratio", "2")]].concat();
    same_as_in_motion(&star, 1, (3.0, 2.0), (11.5, 0.8));
    let against = [&own[..], &[("sides", "2"), ("tool-ratio", "-2"), ("work-ratio", "1")]].concat();
    same_as_in_motion(&against, 1, (-2.0, 1.0), (11.5, 0.4));
}

#[test]
fn energy_of_a_pass_is_that_of_the_removed_area() {
    for (tool, work, inserts) in
        [(2, 1, 1), (2, 1, 2), (2, 1, 3), (3, 1, 2), (3, 2, 2), (12, 5, 5), (5, 2, 2), (1, 1, 6)]
    {
        let (ratio, r, stock) = (Ratio::new(tool, work).unwrap(), 45.0, 13.0);
        for depth in [0.001, 2.0] {
            let sizes = [20.0, 20.0 - 2.0 * depth];
            let pass = load::passes(&sizes, r, ratio, inserts, stock).nth(1).unwrap();
            let area = |size: f64| Section::new(&CutterSetup::even(size, r, ratio, inserts), stock).unwrap().area();
            // Over a turn of the work, 2π: every side is cut equally often.
            let energy = 2.0 * PI * (pass.work.mean + ratio.value() * pass.tool.mean);
            near_share(energy, (area(sizes[0]) - area(sizes[1])) * ratio.passes_per_turn(inserts), 2e-3);
        }
    }
}

#[test]
fn several_inserts_in_the_cut_at_once_add_up() {
    // σ to the corner of a round stock: 24 inserts, 15° apart on the tool, some of them in the cut.
    let entries = [
        ("shape", "own"),
        ("inserts", "24"),
        ("sides", "24"),
        ("tool-ratio", "1"),
        ("work-ratio", "1"),
        ("stock-diameter", "40"),
        ("across-flats", "30"),
        ("depth", "5"),
        ("allowance", "0"),
    ];
    let lathe = project(&entries);
    let (a, r, stock) = (60.0_f64, 45.0_f64, 20.0_f64);
    let sigma = math::acos((a * a + r * r - stock * stock) / (2.0 * a * r));
    let at_once = (24.0 * sigma / PI).floor() + 1.0;
    assert!(at_once > 1.0);
    assert_eq!(value(&lathe, "at-once"), at_once);
    near_share(value(&lathe, "tool-torque"), at_once * 1750.0 * 5.0 * 0.5 * 0.045, 1e-9);
}

#[test]
fn feed_that_the_drive_holds_is_offered_to_the_last_digit() {
    let square = project(&SINGLE);
    let torque = readout(&square, "tool-torque");
    // 9549.3 · 5.5 · 0.9 / 1500 Nm up to base speed, and 250 % of it for a moment.
    near_share(torque.limit.unwrap().value(), 9549.3 * 5.5 * 0.9 / 1500.0 * 2.5, 1e-4);
    assert_eq!(torque.verdict, Verdict::Fail);
    // The last pass cuts nothing: its feed stays.
    let [FieldEntry { field: "feed", text: feed }] = &torque.advice[0].entries[..] else {
        panic!("{:?}", torque.advice)
    };
    let after = square.with_entries(&torque.advice[0].entries).unwrap();
    // It holds, but for the feed override at its highest position.
    assert_eq!(readout(&after, "tool-torque").verdict, Verdict::Warn);
    let slower = after.with_entries(&readout(&after, "tool-torque").advice[0].entries).unwrap();
    assert_eq!(readout(&slower, "tool-torque").verdict, Verdict::Ok);
    let more = format!("{:.3}", feed.parse::<f64>().unwrap() + 0.001);
    let beyond = square.with_entries(&[("feed", more)]).unwrap();
    assert_eq!(readout(&beyond, "tool-torque").verdict, Verdict::Fail);
}

#[test]
fn strikes_heat_a_drive_more_than_their_mean() {
    // Few inserts strike hard and seldom: the mean is half of what the drive gives for long, the effective torque above it.
    let entries = [
        ("shape", "own"),
        ("inserts", "3"),
        ("sides", "6"),
        ("across-flats", "40"),
        ("stock-diameter", "50"),
        ("length", "60"),
        ("overhang", "10"),
        ("relief", "15"),
        ("flatness", "0.8"),
        ("greatest-distance", "200"),
        ("tool-power", "2.78"),
    ];
    let lathe = project(&entries);
    let [peak, mean, effective] =
        ["tool-torque", "tool-torque-mean", "tool-torque-effective"].map(|id| readout(&lathe, id));
    near_share(effective.value, (peak.value * mean.value).sqrt(), 1e-12);
    let limit = effective.limit.unwrap().value();
    assert!(mean.value < 0.6 * limit && effective.value > limit, "{} {limit}", mean.value);
    assert_eq!(effective.verdict, Verdict::Warn);
    let after = lathe.with_entries(&effective.advice[0].entries).unwrap();
    assert_eq!(readout(&after, "tool-torque-effective").verdict, Verdict::Ok);
}

#[test]
fn slow_drive_lacks_power_above_its_base_speed() {
    // The cut at 400 r/min is far above a base speed of 40 r/min: torque falls with the speed, power stays.
    let weak = project(&[("tool-power", "0.05"), ("tool-base", "40"), ("drive-peak", "600")]);
    let [mean, effective, power] =
        ["tool-torque-mean", "tool-torque-effective", "tool-power"].map(|id| readout(&weak, id));
    assert_eq!([effective.verdict, power.verdict], [Verdict::Fail, Verdict::Fail]);
    near_share(effective.limit.unwrap().value(), 9549.3 * 0.05 * 0.9 / 400.0, 1e-4);
    near_share(power.limit.unwrap().value(), 0.045, 1e-9);
    near_share(power.value, mean.value * 400.0 / 9549.3, 1e-4);
}

#[test]
fn run_up_takes_both_to_one_longer_ramp() {
    let lathe = project(&[]);
    // 0.2 kg·m² to 200 r/min in 0.3 s.
    near_share(value(&lathe, "work-run-up"), 0.2 * 200.0 * PI / 30.0 / 0.3, 1e-9);
    near_share(value(&lathe, "tool-run-up"), 0.02 * 400.0 * PI / 30.0 / 0.3, 1e-9);
    let heavy = project(&[("work-inertia", "8"), ("tool-time-constant", "200")]);
    let run_up = readout(&heavy, "work-run-up");
    assert_eq!((run_up.verdict, readout(&heavy, "tool-run-up").verdict), (Verdict::Fail, Verdict::Ok));
    let [
        FieldEntry { field: "work-time-constant", text: work },
        FieldEntry { field: "tool-time-constant", text: tool },
    ] = &run_up.advice[0].entries[..]
    else {
        panic!("{:?}", run_up.advice)
    };
    assert_eq!(work, tool);
    let after = heavy.with_entries(&run_up.advice[0].entries).unwrap();
    assert_eq!((readout(&after, "work-run-up").verdict, readout(&after, "phase").verdict), (Verdict::Ok, Verdict::Ok));
    let less = format!("{:.1}", work.parse::<f64>().unwrap() - 0.1);
    let short = heavy.with_entries(&[("work-time-constant", less)]).unwrap();
    assert_eq!(readout(&short, "work-run-up").verdict, Verdict::Fail);
    // 8 · 20.94 / 78.8 s.
    near_share(value(&heavy, "shortest-ramp"), 8.0 * 200.0 * PI / 30.0 / (9549.3 * 5.5 * 0.9 / 1500.0 * 2.5), 1e-4);
}

#[test]
fn worst_of_several_polygons_is_judged() {
    let one = project(&[]);
    let second = [("second", "true"), ("second-shape", "hexagon"), ("second-across-flats", "12"), ("second-tool", "2")];
    let two = project(&second);
    // A deeper polygon during the infeed: its far sides are nearer to the work's axis, the infeed reaches the stock.
    assert!(value(&two, "work-torque") >= value(&one, "work-torque"));
    // Down with an insert of 3 mm by 0.1 mm: 525 N, at the tips.
    let down = project(&[("from-face", "20"), ("feed", "0.001"), ("finish-feed", "0.001")]);
    near_share(value(&down, "tool-torque"), 1750.0 * 3.0 * 0.1 * 0.045, 1e-9);
    let advised = project(&[("from-face", "20"), ("infeed", "1"), ("insert-width", "10")]);
    let [FieldEntry { field: "infeed", .. }] = &readout(&advised, "tool-torque").advice[0].entries[..] else {
        panic!()
    };
}

#[test]
fn no_force_leaves_the_cut_unjudged() {
    let free = project(&[("specific-force", "0")]);
    let ids: Vec<_> = free.design().readouts.iter().map(|row| row.id).collect();
    assert!(!ids.contains(&"tool-torque") && ids.contains(&"tool-run-up"));
}

/// A thin bar far from the jaws: `F L³ / 3 E I`, which the parts of other examples stay well below.
#[test]
fn slender_work_that_bends_is_red_and_mended() {
    let key = Project::named("polygon-lathe", None, Some("hexagon-key")).unwrap();
    let slender = [
        ("across-flats", "8"),
        ("stock-diameter", "10"),
        ("length", "20"),
        ("from-face", "0"),
        ("free-length", "160"),
        ("material", "c45"),
        ("overhang", "30"),
        ("feed", "0.2"),
        ("finish-feed", "0.2"),
    ];
    let slender = key.with_entries(&slender).unwrap();
    let bends = readout(&slender, "bending");
    let moment = |diameter: f64| std::f64::consts::PI * math::pow(diameter, 4.0) / 64.0;
    let give = 1.0 / (3.0 * 210e3)
        * (math::pow(20.0, 3.0) / moment(8.0) + (math::pow(160.0, 3.0) - math::pow(20.0, 3.0)) / moment(10.0));
    // A roughing pass of 0.8 mm, and the last one of 0.2 mm at the same feed: each springs back from what is there.
    let compliance = give * readout(&slender, "cutting-force").value / 0.8;
    let left = |left: f64, depth: f64| compliance * (depth + left) / (1.0 + compliance);
    near_share(bends.value, left(left(0.0, 0.8), 0.2), 1e-9);
    assert!(compliance > 5.0, "{compliance}");
    assert_eq!(bends.verdict, Verdict::Fail);
    let shorter = bends.advice.iter().find(|advice| !advice.entries.is_empty()).expect("a remedy");
    assert_eq!(readout(&slender.with_entries(&shorter.entries).unwrap(), "bending").verdict, Verdict::Ok);
    // Nearer to the jaws a smaller depth, or an even shorter bar helps.
    let longer = slender.with_entries(&[("free-length", "40"), ("flatness", "0.01")]).unwrap();
    let bends = readout(&longer, "bending");
    assert!(bends.advice.iter().any(|advice| !advice.entries.is_empty()));
    for advice in bends.advice.iter().filter(|advice| !advice.entries.is_empty()) {
        let mended = readout(&longer.with_entries(&advice.entries).unwrap(), "bending");
        assert_eq!(mended.verdict, Verdict::Ok, "{:?}: {}", advice.entries, mended.value);
    }
    // The part of the example bends in roughing less than its allowance, at every position of the feed override.
    assert_eq!(readout(&key, "bending").verdict, Verdict::Ok);
}

#[test]
fn torque_chart_shows_the_strikes_of_the_cut() {
    let sizing = sized_without_envelope(&project(&[]));
    for id in ["work", "tool"] {
        let axis = sizing.axes.iter().find(|axis| axis.id == id).unwrap();
        let lines = &axis.chart.as_ref().unwrap().lines;
        let of_run = lines.iter().filter(|line| !line.is_at_highest_knob).map(|line| line.torque);
        let most = of_run.fold(0.0, f64::max);
        // The mean torque of the cut and that of its strikes.
        assert!(most > 0.5 * axis.demand.peak && most <= axis.demand.peak + 1e-9, "{id}: {most} {:?}", axis.demand);
    }
}
