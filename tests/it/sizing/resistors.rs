//! Regeneration of an amplifier, and the brake resistor that takes it; the energy of all motors of a part.

use macroline::drives::load::{Load, Regeneration};
use macroline::drives::parts::{PartGrade, ResistorRatings};
use macroline::drives::shaft_motion::{Motion, ResistorLoad, SpeedSegment};
use macroline::machines::driven::devices::BillItem;
use macroline::machines::form::Value;
use macroline::project::size::{Candidate, Sizing};
use macroline::project::{Project, parts};
use proptest::prelude::*;

use crate::queries::sized;

/// Starts, runs for a second and stops within 0.2 s, `times` times.
fn starts(times: u32, speed: f64) -> Vec<SpeedSegment> {
    let part = |at: u32| {
        let t = 2.0 * f64::from(at);
        let segment = |from: f64, seconds: f64, speeds: (f64, f64)| SpeedSegment {
            t: t + from,
            seconds,
            from: speeds.0,
            to: speeds.1,
        };
        [
            segment(0.0, 0.3, (0.0, speed)),
            segment(0.3, 1.0, (speed, speed)),
            segment(1.3, 0.2, (speed, 0.0)),
            segment(1.5, 0.5, (0.0, 0.0)),
        ]
    };
    (0..times).flat_map(part).collect()
}

#[test]
fn regenerated_mean_stop_and_peak_follow_the_formulas() {
    let load = Load { inertia: 2e-3, torque: 0.1, efficiency: 0.9 };
    let (rotor, speed) = (3e-4, 200.0);
    let back = Regeneration { efficiency: 0.85, capacitor: 11.0 };
    let motion = Motion::new(starts(5, speed), load, 0.0);
    // T = T_L - (J η + J_M) ω / t over 0.2 s.
    let torque = 0.1 - (2e-3 * 0.9 + rotor) * speed / 0.2;
    let stop = 0.85 * 0.5 * -torque * speed * 0.2 - 11.0;
    let taken = motion.to_resistor(rotor, &back);
    super::same("stop", taken.stop, stop, 1e-12);
    super::same("mean", taken.mean, stop / 2.0, 1e-12);
    super::same("peak", taken.peak, 0.85 * -torque * speed, 1e-12);
    // A pause of the shift counts.
    super::same("paused", motion.clone().with_pause(10.0).to_resistor(rotor, &back).mean, 5.0 * stop / 20.0, 1e-12);
    // Capacitors that take all of it leave nothing.
    let large = Regeneration { capacitor: 1e3, ..back };
    assert_eq!(motion.to_resistor(rotor, &large), ResistorLoad::default());
}

#[test]
fn resistor_takes_loads_within_all_its_known_ratings() {
    let load = ResistorLoad { mean: 20.0, stop: 300.0, peak: 2000.0 };
    let of = |brake_power, brake_peak_power, brake_energy| {
        ResistorRatings { brake_power, brake_peak_power, brake_energy }.takes(&load)
    };
    assert!(of(Some(20.0), None, None) && of(Some(20.0), Some(2000.0), Some(300.0)));
    assert!(!of(Some(19.9), None, None) && !of(None, Some(9e9), Some(9e9)));
    assert!(!of(Some(20.0), Some(1999.0), None) && !of(Some(20.0), None, Some(299.0)));
}

proptest! {
    /// Work over the whole time changes nothing; with two works the energies are those of each and of the idle rest.
    #[test]
    fn motion_without_work_keeps_the_energy_balance(
        points in prop::collection::vec((0.05f64..2.0, -200.0f64..200.0), 2..9),
        (first, long, gap, second) in (0.0f64..4.0, 0.01f64..2.0, 0.01f64..2.0, 0.01f64..2.0),
        rotor in 0.0f64..1e-3,
    ) {
        let (mut t, mut from, mut segments) = (0.0, 0.0, Vec::new());
        for (seconds, to) in points {
            segments.push(SpeedSegment { t, seconds, from, to });
            (t, from) = (t + seconds, to);
        }
        let load = |torque: f64| Load { inertia: 1e-3, torque, efficiency: 0.9 };
        let whole = Motion::new(segments.clone(), load(0.3), 0.0);
        let all = whole.clone().with_loaded_spans(vec![(0.0, t)]).motor_load(rotor);
        super::same("effective", all.effective, whole.motor_load(rotor).effective, 1e-9);
        let works = vec![(first, first + long), (first + long + gap, first + long + gap + second)];
        let part = whole.clone().with_loaded_spans(works.clone());
        let seconds: f64 = part.segments().iter().map(|segment| segment.seconds).sum();
        super::same("seconds", seconds, t, 1e-9);
        // Work of the steady torque: torque times the angle turned within the loaded spans.
        let way = |motion: &Motion, within: &dyn Fn(f64) -> bool| -> f64 {
            motion.segments().iter().filter(|segment| within(segment.t + 0.5 * segment.seconds)).map(|segment| 0.5 * (segment.from + segment.to).abs() * segment.seconds).sum()
        };
        let within = |t: f64| works.iter().any(|(from, to)| (*from..*to).contains(&t));
        let idle = Motion::new(segments, load(0.0), 0.0).motor_load(rotor);
        let work = part.motor_load(rotor);
        let balance = work.given - work.returned - (idle.given - idle.returned);
        prop_assert!((balance - 0.3 * way(&part, &within)).abs() < 1e-9 * (1.0 + work.given + work.returned), "{balance}");
        prop_assert!(part.loaded_time() <= t * (1.0 + 1e-9));
    }
}

/// A line whose print roller stops at each pitch, on a control that takes MR-J4 amplifiers.
fn stopping() -> Project {
    let mut project = Project::named("ribbon-line", Some("mitsubishi-e60"), None).unwrap();
    for (id, number) in [("pitch-count", 60.0), ("gear-y", 80.0), ("head-mass", 2.0)] {
        project.values.insert(id.to_owned(), Value::Number(number));
    }
    project.values.insert("path-mode".to_owned(), Value::Text("exact-stop".to_owned()));
    project
}

/// A line on the same control that starts once for a product.
fn line() -> Project {
    let mut project = stopping();
    project.values.insert("path-mode".to_owned(), Value::Text("continuous".to_owned()));
    project
}

/// The first motor that passes and gives back more than the capacitors of its amplifier take: a large rotor.
fn passing(sizing: &Sizing) -> &Candidate {
    braked(sizing).into_iter().find(|motor| motor.refusal.is_none()).expect("a motor that brakes")
}

/// Motors of the print roller with an amplifier whose resistor gets something.
fn braked(sizing: &Sizing) -> Vec<&Candidate> {
    let of_print = &sizing.axes.iter().find(|axis| axis.id == "y").unwrap().candidates;
    of_print.iter().filter(|candidate| candidate.resistor.is_some()).collect()
}

fn resistor_rows(sizing: &Sizing) -> Vec<(String, PartGrade, f64)> {
    let rows = sizing.bill.iter().filter(|row| row.item == BillItem::Resistor);
    rows.map(|row| (row.part(), row.grade, f64::from(row.quantity))).collect()
}

#[test]
fn demand_beyond_every_resistor_is_an_open_row() {
    let (often, project) = (sized(&stopping()), line());
    let load = |of: &Candidate| of.resistor.as_ref().unwrap().demand;
    assert!(!braked(&often).is_empty());
    assert!(braked(&often).into_iter().all(|motor| load(motor).mean > 0.05 && load(motor).peak > 0.0));
    let sizing = sized(&project);
    let strong = passing(&sizing);
    let named = project.with_entries(&strong.entries).unwrap();
    let rows = resistor_rows(&sized(&named));
    let (text, grade, _) = rows.iter().find(|row| row.1 == PartGrade::Open).expect("an open row");
    assert_eq!(*grade, PartGrade::Open);
    assert!(text.starts_with("open: ") && text.contains(&strong.amplifier.as_ref().unwrap().model), "{text}");
}

#[test]
fn resistor_that_is_paired_and_takes_it_is_billed() {
    let mut project = line();
    let strong = passing(&sized(&project)).clone();
    let (amplifier, load) = (strong.amplifier.as_ref().unwrap(), strong.resistor.as_ref().unwrap().demand);
    let table = format!(
        "kind,maker,series,model,regen_w,fits,source,grade\n\
         resistor,Mitsubishi Electric,{series},R-SMALL,{small},{model},own,entered\n\
         resistor,Mitsubishi Electric,{series},R-RIGHT,{right},{model},own,entered\n\
         resistor,Mitsubishi Electric,{series},R-LARGE,{large},{model},own,entered\n\
         resistor,Mitsubishi Electric,{series},R-OTHER,{right},MR-J4-9999,own,entered\n",
        series = amplifier.series,
        model = amplifier.model,
        small = 0.9 * load.mean,
        right = 1.1 * load.mean,
        large = 9.0 * load.mean,
    );
    let (own, found) = parts::read(&table, "own.csv");
    assert!(found.is_empty(), "{found:?}");
    project.add_parts(own);
    let named = project.with_entries(&strong.entries).unwrap();
    let sizing = sized(&named);
    assert!(
        resistor_rows(&sizing).iter().any(|row| row.0 == "Mitsubishi Electric R-RIGHT" && row.1 == PartGrade::Entered)
    );
    let listed = braked(&sizing).into_iter().find(|candidate| candidate.part.model == strong.part.model).unwrap();
    assert_eq!(listed.resistor.as_ref().unwrap().part.as_ref().unwrap().model, "R-RIGHT");
    let answers = sizing.sheets().into_iter().filter(|sheet| sheet.id == "motors").flat_map(|sheet| sheet.rows);
    assert!(answers.flat_map(|row| row.cells).any(|cell| cell.contains("brake resistor R-RIGHT")));
    let json = sizing.json();
    let rows = json["axes"][1]["candidates"].as_array().unwrap();
    assert!(
        rows.iter()
            .any(|row| row["resistor"] == "Mitsubishi Electric R-RIGHT" && row["resistor_w"].as_f64().unwrap() > 0.0)
    );
}

#[test]
fn amplifier_without_anything_to_take_has_no_resistor() {
    // A line that starts once and stops slowly: the energy that its small motors return stays in the capacitors.
    let sizing = sized(&Project::named("ribbon-line", Some("mitsubishi-e60"), None).unwrap());
    assert!(resistor_rows(&sizing).is_empty(), "{:?}", resistor_rows(&sizing));
    // The rotor of a 2 kW motor returns more than its capacitors take; this is in the list of motors, not in the bill of another motor.
    let with_resistor =
        || sizing.axes.iter().flat_map(|axis| &axis.candidates).filter(|motor| motor.resistor.is_some());
    assert!(with_resistor().count() > 0);
    assert!(with_resistor().all(|motor| motor.part.servo().is_some_and(|servo| servo.rotor > 1e-3)));
}

#[test]
fn energy_of_a_part_has_the_unwinder_and_the_spindle() {
    let line = Project::named("ribbon-line", None, None).unwrap();
    let with = |changes: &[(&'static str, String)]| sized(&line.with_entries(changes).unwrap()).cycle.unwrap();
    let (now, heavy) = (with(&[]), with(&[("reel-brake", "30".to_owned())]));
    // 10 N more of brake on the ribbon of a product, with 70 % efficiency of the gear.
    let pulled = line.design().readouts.into_iter().find(|row| row.id == "product-length").unwrap().value / 1e3;
    let more = heavy.energy.unwrap().given - now.energy.unwrap().given;
    super::same("brake", more, 10.0 * pulled / 0.7, 0.1);
    // Twice the cutting force takes twice the energy of the cut: power over time.
    let lathe = Project::named("turning-spindle", None, Some("shaft")).unwrap();
    let of = |force: &str| {
        let entries = [("material", "none".to_owned()), ("cutting-force", force.to_owned())];
        let project = lathe.with_entries(&entries).unwrap();
        sized(&project).cycle.unwrap().energy.unwrap().given
    };
    let [one, two, three] = ["500", "1000", "1500"].map(of);
    super::same("cut", three - two, two - one, 1e-9);
    assert!(two - one > 0.0 && one > two - one - 1e-9, "{one} {two}");
}

#[test]
fn polygon_is_cut_while_the_slide_is_in_the_stock_alone() {
    let lathe = Project::named("polygon-lathe", None, None).unwrap();
    let sizing = sized(&lathe);
    for axis in &sizing.axes {
        assert!(axis.loaded > 0.0 && axis.loaded < axis.turning, "{}: {} of {}", axis.id, axis.loaded, axis.turning);
    }
    // Less feed, a longer cut: the share of the cut grows, and its energy with it.
    let design = |project: &Project, id: &str| {
        project.design().readouts.into_iter().find(|row| row.id == id).map(|row| row.value)
    };
    assert!(design(&lathe, "sides").is_some());
    // The list of motors has the same work as the energy of a part.
    let energy = sizing.cycle.unwrap().energy.unwrap();
    let works = || sizing.axes.iter().map(|axis| axis.motor_load.unwrap());
    super::same("given", works().map(|work| work.given).sum(), energy.given, 1e-9);
    super::same("returned", works().map(|work| work.returned).sum(), energy.returned, 1e-9);
}

#[test]
fn cut_does_not_help_the_stop_of_the_tool() {
    let lathe = Project::named("polygon-lathe", None, None).unwrap();
    let entries = [
        ("speed", "500"),
        ("feed", "0.3"),
        ("depth", "1.5"),
        ("tool-time-constant", "2000"),
        ("work-time-constant", "2000"),
        ("tool-power", "5"),
        ("work-power", "5"),
        ("drive-efficiency", "100"),
        ("tool-inertia", "0.02"),
    ];
    let lathe = lathe.with_entries(&entries).unwrap();
    let sizing = sized(&lathe);
    let tool = sizing.axes.iter().find(|axis| axis.id == "tool").unwrap();
    // The tool stops outside of the stock from 1000 r/min: ½ J ω² = ½ · 0.02 · 104.72² = 109.7 J.
    let omega = 1000.0 * std::f64::consts::TAU / 60.0;
    super::same("returned", tool.motor_load.unwrap().returned, 0.5 * 0.02 * omega * omega, 1e-3);
    // At the amplifier MR-J4-350A, with 85 % and 40 J in its capacitors, and the rotor of HG-SR352.
    let motor = tool.candidates.iter().find(|motor| motor.part.model == "HG-SR352").unwrap();
    let rotor = motor.part.servo().unwrap().rotor;
    let load = motor.resistor.as_ref().expect("a resistor").demand;
    super::same("stop", load.stop, 0.85 * 0.5 * (0.02 + rotor) * omega * omega - 40.0, 1e-2);
}

/// The line that stops at each pitch, its print roller with a motor of the user behind an amplifier with these further cells.
fn behind(columns: &str, cells: &str) -> Sizing {
    let table = format!(
        "kind,maker,model,rated_speed_rpm,max_speed_rpm,stall_torque_nm,peak_torque_nm,inertia_kgm2,fits,grade{columns}\n\
         servo,Works,S1,3000,6000,20,60,0.003,,entered\n\
         amplifier,Works,A1,,,,,,S1,entered{cells}\n"
    );
    let mut project = stopping();
    let (own, found) = parts::read(&table, "own.csv");
    assert!(found.is_empty(), "{found:?}");
    project.add_parts(own);
    sized(&project.with_entries(&[("motor-y", "Works S1")]).unwrap())
}

/// The open row of the brake resistor of the print roller.
fn open_resistor(sizing: &Sizing) -> Option<String> {
    let own = sizing.bill.iter().filter(|row| row.item == BillItem::Resistor && row.axis == Some("ribbon.drive.print"));
    own.map(|row| row.part()).next()
}

#[test]
fn unknown_regeneration_is_an_open_row_with_its_energy() {
    let sizing = behind("", "");
    let text = open_resistor(&sizing).expect("an open row");
    let motor = sizing.axes[1].candidates.iter().find(|motor| motor.part.model == "S1").unwrap();
    let load = motor.resistor.as_ref().expect("a demand").demand;
    assert!(load.stop > 0.0 && load.mean > 0.05, "{load:?}");
    // Sentences drop a decimal of 0.
    let shown = |value: f64, unit: &str| format!("{value:.1} {unit}").replace(".0 ", " ");
    for figure in [shown(load.stop, "J"), shown(load.mean, "W"), "ask its maker".to_owned()] {
        assert!(text.contains(&figure), "{text} lacks {figure}");
    }
    assert_eq!(
        sizing.bill.iter().filter(|row| row.item == BillItem::Resistor && row.grade == PartGrade::Open).count(),
        1
    );
    let answers = sizing.sheets().into_iter().filter(|sheet| sheet.id == "motors").flat_map(|sheet| sheet.rows);
    let own = answers.map(|row| row.cells).find(|cells| cells[0] == "Works S1").unwrap();
    assert!(own.iter().any(|cell| cell.contains("ask its maker for the brake resistor")), "{own:?}");
    // Capacitors that take the energy of each stop leave no open point.
    assert_eq!(open_resistor(&behind(",capacitor_j", &format!(",{}", 2.0 * load.stop))), None);
    assert!(
        open_resistor(&behind(",capacitor_j", &format!(",{}", 0.5 * load.stop)))
            .is_some_and(|text| text.contains("A1"))
    );
}

#[test]
fn motor_of_no_catalogue_has_its_energy_in_an_open_row() {
    let named = stopping().with_entries(&[("motor-y", "Works of no list")]).unwrap();
    let text = open_resistor(&sized(&named)).expect("an open row");
    assert!(text.contains("ask its maker"), "{text}");
    let lathe = Project::named("polygon-lathe", None, None).unwrap();
    let sizing = sized(&lathe.with_entries(&[("tool-inertia", "10")]).unwrap());
    let tool = sizing.axes.iter().find(|axis| axis.id == "tool").unwrap();
    assert!(tool.ordered().is_none() && tool.returned.is_some());
    assert!(sizing.bill.iter().any(|row| row.item == BillItem::Resistor && row.axis == Some(tool.name)));
}
