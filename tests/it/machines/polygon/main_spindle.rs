//! The main spindle of the polygon lathe, sized where the program turns the bar before or after the polygons.

use macroline::machines::driven::devices::BillItem;
use macroline::machines::ladder::scan::Image;
use macroline::machines::ladder::{Bit, MachineContact};
use macroline::motion::{Action, Event, RunEnd};
use macroline::project::Project;
use macroline::project::size::{OperatingEvent, size};
use macroline::text::catalog::sentence;
use macroline::view::{FieldEntry, Verdict};

use super::shaft::whole;
use crate::machines::every_machine::restart::{Outcome, within};
use crate::machines::ribbon::each_control::{begun, ended};
use crate::queries::{near, readout, sized, sized_without_envelope, stop_table, value};

const NAME: &str = "polygon.drive.main";

/// The threaded shaft with other entries: 25 mm stock, turned to 12 mm at 800 r/min, 1750 N/mm².
fn shaft(entries: &[(&'static str, &str)]) -> Project {
    let shaft = Project::named("polygon-lathe", None, Some("threaded-shaft")).unwrap();
    let force = [("material", "none"), ("specific-force", "1750"), ("rake", "0")];
    let entries: Vec<_> = force.iter().chain(entries).map(|(id, typed)| (*id, (*typed).to_owned())).collect();
    shaft.with_entries(&entries).unwrap()
}

/// Newton metres of the motor at the spindle: 7.5 kW with 90 %, base speed 1500 · 3000 / 2250 = 2000 r/min.
const RATED: f64 = 9_549.297 * 7.5 * 0.9 / 2000.0;

#[test]
fn cut_of_a_turned_end_is_judged_by_the_main_motor() {
    // 1750 N/mm² · 2 mm · 0.2 mm = 700 N at Ø 25, and 2 Nm of friction; the fan on the motor's shaft leaves 0.5 + 0.5 · 800 / 2000.
    let light = shaft(&[]);
    let torque = readout(&light, "main-torque");
    near(torque.value, 700.0 * 25.0 / 2000.0 + 2.0, 1e-9);
    near(torque.limit.unwrap().value(), 0.7 * RATED, 1e-3);
    assert_eq!(torque.verdict, Verdict::Ok);
    near(readout(&light, "main-cutting-power").value, 10.75 * 800.0 / 9_549.297, 1e-6);
    near(readout(&light, "main-volts").value, 10.0 * 800.0 / 3000.0, 0.003);
    // 6 mm by 0.6 mm: less depth is offered.
    let deep = shaft(&[("before-depth", "6"), ("before-feed", "0.6")]);
    let torque = readout(&deep, "main-torque");
    assert_eq!((torque.verdict, torque.advice[0].entries[0].field), (Verdict::Fail, "before-depth"));
    let less = deep.with_entries(&torque.advice[0].entries).unwrap();
    assert!(readout(&less, "main-torque").verdict < Verdict::Fail);
}

#[test]
fn end_equal_to_the_one_before_it_is_cut_from_that_one() {
    // Ø 25 to Ø 12 in cuts of 2 mm: four for the first end. The second finds its Ø 12 turned, and cuts once.
    let equal = [("before-chamfer", "0"), ("before-pitch", "0"), ("after", "true"), ("after-length", "20")];
    let cuts = |entries: &[_]| {
        let written = shaft(entries).written();
        written.files.0[0].text.lines().filter(|line| line.starts_with("G01 Z-20. F0.2")).count()
    };
    assert_eq!((cuts(&equal[..2]), cuts(&equal)), (4, 5));
    // 1050 N at the Ø 12 of the second end take less torque than 700 N at the Ø 25 of the first.
    let fed = shaft(&[&equal[..], &[("after-feed", "0.3")]].concat());
    near(readout(&fed, "main-torque").value, 700.0 * 25.0 / 2000.0 + 2.0, 1e-9);
}

/// 3000 r/min at 10 V: 0.5 V are 150 r/min. The slower of both ends counts.
#[test]
fn few_volts_at_the_slowest_turned_end_warn() {
    for (before, after, volts, verdict) in
        [("800", "150", 0.5, Verdict::Ok), ("800", "120", 0.4, Verdict::Warn), ("90", "800", 0.3, Verdict::Warn)]
    {
        let slow = shaft(&[("before-speed", before), ("after", "true"), ("after-speed", after)]);
        let least = readout(&slow, "main-least-volts");
        near(least.value, volts, 0.003);
        assert_eq!((least.verdict, least.advice.len()), (verdict, usize::from(verdict == Verdict::Warn)), "{volts}");
    }
}

#[test]
fn cut_too_heavy_for_the_shaft_fan_gets_forced_cooling() {
    // 1750 N: 23.9 Nm of 22.6 with a fan on the motor's shaft, of 32.2 with forced cooling.
    let heavy = shaft(&[("before-feed", "0.5")]);
    let torque = readout(&heavy, "main-torque");
    assert_eq!(torque.verdict, Verdict::Fail);
    assert_eq!(torque.advice[0].entries, [FieldEntry::new("main-forced-cooling", "true")]);
    let cooled = heavy.with_entries(&torque.advice[0].entries).unwrap();
    let torque = readout(&cooled, "main-torque");
    // But for the feed override at its highest position.
    assert_eq!((torque.verdict, torque.advice[0].message.id), (Verdict::Warn, "lathe.torque-at-knobs"));
    near(torque.limit.unwrap().value(), RATED, 1e-3);
    for (project, fans) in [(&heavy, 0), (&cooled, 1)] {
        let sizing = sized_without_envelope(project);
        assert_eq!(sizing.bill.iter().filter(|row| row.item == BillItem::Fan && row.axis == Some(NAME)).count(), fans);
        assert_eq!(sizing.terminals.iter().filter(|row| row.to.item == BillItem::Fan).count(), 2 * fans);
    }
}

#[test]
fn ramp_shorter_than_the_main_motor_gives_fails() {
    // Chuck and work 0.2 kg m², the rotor 0.03 at three quarters of the speed; 150 % of the rated torque below base speed.
    let inertia = 0.2 + 0.03 * 0.75 * 0.75;
    let omega = 3000.0 * std::f64::consts::PI / 30.0;
    let hasty = shaft(&[("main-ramp", "1"), ("work-limit", "3000")]);
    let shortest = readout(&hasty, "main-shortest-ramp");
    near(shortest.value, inertia * omega / (1.5 * RATED - 2.0), 1e-6);
    assert_eq!(shortest.verdict, Verdict::Fail);
    // Twice the first advice, for the speed of the form and for that of the knob at 254 %.
    let mut slower = hasty.clone();
    for after in [Verdict::Warn, Verdict::Ok] {
        slower = slower.with_entries(&readout(&slower, "main-shortest-ramp").advice[0].entries).unwrap();
        assert_eq!(readout(&slower, "main-shortest-ramp").verdict, after);
    }
    let to_speed = inertia * 800.0 * std::f64::consts::PI / 30.0 / (1.5 * RATED - 2.0);
    near(readout(&hasty, "main-run-up-time").value, to_speed, 1e-6);
    near(readout(&hasty, "main-coasting-time").value, inertia * 800.0 * std::f64::consts::PI / 30.0 / 2.0, 1e-6);
}

#[test]
fn main_spindle_is_ordered_and_wired_where_the_program_turns() {
    let items = |project: &Project| {
        let sizing = sized_without_envelope(project);
        let own = sizing.bill.iter().filter(|row| row.axis == Some(NAME)).map(|row| row.item);
        let mut items: Vec<BillItem> = own.collect();
        items.sort();
        items.dedup();
        let wired =
            |item| sizing.terminals.iter().filter(|row| row.to.item == item && row.to.axis == Some(NAME)).count();
        // Mains and earth, the set speed with its screen, enable, the run commands of M03 and M04 with their common, and that of the contacts;
        // three phases and earth.
        (items, wired(BillItem::Inverter), wired(BillItem::Motor))
    };
    let (motor, inverter, resistor, encoder) =
        (BillItem::Motor, BillItem::Inverter, BillItem::Resistor, BillItem::Encoder);
    assert_eq!(items(&shaft(&[])), (vec![motor, inverter, resistor, encoder], 10, 4));
    assert_eq!(items(&shaft(&[("before-pitch", "0")])), (vec![motor, inverter, resistor, encoder], 10, 4));
    assert_eq!(
        items(&shaft(&[("before-pitch", "0"), ("main-braking", "20")])),
        (vec![motor, inverter, encoder], 10, 4)
    );
    assert_eq!(items(&shaft(&[("before", "false")])), (vec![], 0, 0));
}

#[test]
fn list_refuses_main_motors_too_weak_for_the_cut() {
    let sizing = size(&shaft(&[]), &shaft(&[]).written());
    let axis = sizing.axes.iter().find(|axis| axis.id == "main").unwrap();
    // (8.75 + 2) Nm through 0.75 : 1 with 90 %.
    near(axis.demand.effective, 10.75 / (0.75 * 0.9), 1e-9);
    assert!(axis.least().is_some());
    let weak: Vec<String> =
        axis.candidates.iter().filter_map(|motor| Some(sentence(&motor.refusal.as_ref()?.message))).collect();
    assert!(weak.iter().any(|reason| reason.contains("15.926 Nm")), "{weak:?}");
    // The run has its torque on the list of the operating envelope, below that of the motor.
    let row = sizing
        .envelope
        .iter()
        .find(|row| row.quantity.id() == "spindle-torque" && row.event == OperatingEvent::Run)
        .unwrap();
    assert_eq!(row.verdict, Verdict::Ok);
}

#[test]
fn bar_is_turned_at_the_speed_of_the_form() {
    let (planner, _) = whole(&shaft(&[("main-speed", "1000"), ("main-motor-top", "1000"), ("main-ramp", "3")]));
    let timeline = planner.timeline();
    let (mut fastest, mut volts) = (0.0_f64, 0.0_f64);
    for at in 0..2000 {
        let now = timeline.at(timeline.end() * f64::from(at) / 2000.0);
        (fastest, volts) = (fastest.max(now.spindle.actual), volts.max(now.spindle.volts));
    }
    near(fastest, 800.0, 1.0);
    near(volts, 8.0, 0.01);
}

#[test]
fn turned_end_feeds_per_revolution_of_its_spindle() {
    let project = shaft(&[]);
    let text = &project.written().files.0[0].text;
    let lines = |from: &str, count: usize| -> Vec<&str> {
        text.lines().skip_while(|line| !line.starts_with(from)).take(count).collect()
    };
    assert_eq!(lines("M3 S800", 3), ["M3 S800", "G04 X2. (SPINDLE COMES TO ITS SPEED)", "G99"]);
    assert_eq!(lines("G01 Z-20.", 1), ["G01 Z-20. F0.2"]);
    assert_eq!(lines("G98 M5", 2), ["G98 M5", "G04 X2. (SPINDLE STOPS)"]);
    // With the knob at 0 the bar is at rest, and the tool waits in front of it.
    let mut planner = begun(&project, vec![Event { t: 0.0, action: Action::SpindleOverride(0.0) }]);
    let ended = ended(&mut planner);
    assert_eq!(ended, RunEnd::Stop);
    let end = planner.timeline().end();
    assert!(planner.timeline().at(end).axes[1].actual > 0.0);
    assert!(planner.diagnostics().iter().any(|found| found.message.id == "motion.spindle-at-rest"));
}

#[test]
fn slow_way_out_of_a_turned_end_has_a_feed() {
    // 1 mm/min at 2500 r/min is 0.0004 mm per revolution, below the last decimal of F.
    let slow = shaft(&[("retract-feed", "1"), ("before-speed", "2500")]);
    let text = &slow.written().files.0[0].text;
    assert!(text.contains("G01 X31. F0.001\n") && !text.contains("F0.\n"), "{text}");
    let (planner, _) = whole(&slow);
    assert!(planner.diagnostics().iter().all(|found| found.message.id != "lint.feed-zero"));
}

#[test]
fn encoders_reach_the_speed_of_the_knob_at_its_end() {
    let encoder = |project: &Project| {
        let bill = sized_without_envelope(project).bill;
        bill.into_iter().find(|row| row.item == BillItem::Encoder).unwrap().asked
    };
    // 800 r/min by 254 %, the greatest override of the register, up to the clamp by the work axis.
    let free = shaft(&[("work-limit", "3000")]);
    assert!(encoder(&free).starts_with("up to 2032 r/min"), "{}", encoder(&free));
    assert!(encoder(&shaft(&[])).starts_with("up to 1000 r/min"), "{}", encoder(&shaft(&[])));
    let lathe = Project::of("turning-spindle", Some("mitsubishi-e60")).unwrap();
    let envelope = size(&lathe, &lathe.written()).envelope;
    let speeds = envelope.iter().filter(|row| row.quantity.label() == "turning.gauge.speed").map(|row| row.value);
    let highest = speeds.fold(0.0, f64::max);
    let requirement = encoder(&lathe);
    let required: f64 = requirement.split(' ').nth(2).unwrap().replace('\u{202f}', "").parse().unwrap();
    assert!(required >= highest.floor() && highest > 0.0, "{requirement}: {highest}");
}

#[test]
fn stops_name_the_inverter_where_the_bar_is_turned() {
    let stops = |project: &Project| {
        let sheets = project.prepared().sheets();
        let sheet = sheets.into_iter().find(|sheet| sheet.id == "stops").unwrap();
        (sheet.title, sheet.rows.len())
    };
    let (with, without) = (stops(&shaft(&[])), stops(&shaft(&[("before", "false")])));
    // One of them about the thread.
    assert_eq!((with.0, without.0, with.1 - without.1), ("sheet.stops-and-fault", "sheet.stops", 6));
}

#[test]
fn turned_end_faster_than_the_idling_motor_fails() {
    let fast = shaft(&[("before-speed", "1200")]);
    let speed = readout(&fast, "main-top-speed");
    assert_eq!((speed.value, speed.limit.unwrap().value(), speed.verdict), (1200.0, 1000.0, Verdict::Fail));
    assert_eq!(speed.advice[0].entries, [FieldEntry::new("before-speed", "1000")]);
    let slower = fast.with_entries(&speed.advice[0].entries).unwrap();
    assert_eq!(readout(&slower, "main-top-speed").verdict, Verdict::Ok);
}

#[test]
fn turned_end_is_judged_at_the_highest_knob_too() {
    // 1400 N: 19.5 Nm of 22.6 at 800 r/min; the knob of 254 % takes the spindle to 2032 r/min, where a base speed of 1000 r/min leaves less.
    let cooled = [("before-feed", "0.4"), ("main-forced-cooling", "true"), ("work-limit", "3000")];
    let at = |motor: &[(&'static str, &'static str)]| readout(&shaft(&[&cooled, motor].concat()), "main-torque");
    assert_eq!(at(&[("main-base", "1500")]).verdict, Verdict::Ok);
    let weak = at(&[("main-base", "1000"), ("main-power", "4.5")]);
    assert_eq!((weak.verdict, weak.advice[0].message.id), (Verdict::Warn, "lathe.torque-at-knobs"));
}

#[test]
fn shaft_fan_is_judged_at_the_lowest_knob_too() {
    // At 1 % of 1900 r/min the fan on the motor's shaft leaves 0.505 of the torque, 16.3 Nm, and at 1900 r/min 31.4 Nm. With the feed
    // override at 150 % the cuts take 15.1 and 18.4 Nm.
    for (feed, verdict) in [("0.2", Verdict::Ok), ("0.25", Verdict::Warn)] {
        let lathe = shaft(&[("before-feed", feed), ("before-speed", "1900"), ("work-limit", "3000")]);
        let torque = readout(&lathe, "main-torque");
        assert_eq!(torque.verdict, verdict, "{} Nm", torque.value);
        for advice in torque.advice {
            assert_eq!(advice.message.id, "lathe.shaft-fan-at-knobs");
            assert_eq!(readout(&lathe.with_entries(&advice.entries).unwrap(), "main-torque").verdict, Verdict::Ok);
        }
    }
}

/// The main motor stays on the spindle: at 200 r/min over 0.3 s with a gain of 30 the work axis turns its rotor along, against its friction.
#[test]
fn work_axis_runs_up_the_main_motor_too() {
    let motor = [("main-rotor", "0.2"), ("main-speed", "1000")];
    let [alone, coupled] =
        ["false", "true"].map(|on| readout(&shaft(&[&motor[..], &[("before", on)]].concat()), "work-run-up"));
    let run_up = |inertia: f64| inertia * 200.0 * std::f64::consts::PI / 30.0 / 0.3;
    near(alone.value, run_up(0.2), 1e-6);
    near(coupled.value, run_up(0.2 + 0.2 * 2.25 * 2.25), 1e-6);
    near(alone.limit.unwrap().value() - coupled.limit.unwrap().value(), 2.0, 1e-9);
    assert_eq!((alone.verdict, coupled.verdict), (Verdict::Ok, Verdict::Fail));
}

#[test]
fn end_speed_above_that_of_the_main_spindle_is_an_error() {
    let errors = |speed: &'static str| {
        let design = shaft(&[("main-speed", "700"), ("before-speed", speed)]).design();
        design.diagnostics.iter().filter(|found| found.message.id == "polygon.fast-spindle").count()
    };
    assert_eq!((errors("701"), errors("700")), (1, 0));
}

/// The sizing has the same run-up as the form: inertia and friction of the main spindle, through the gear of the work axis.
#[test]
fn sizing_of_the_work_axis_has_the_main_friction() {
    let peak = |friction: &'static str| {
        let lathe = shaft(&[("main-friction", friction)]);
        let sizing = size(&lathe, &lathe.written());
        let start = sizing.envelope.iter().find(|row| row.quantity.id() == "work-torque" && row.event.id() == "start");
        start
            .unwrap_or_else(|| panic!("{:?}", sizing.envelope.iter().map(|row| row.quantity.id()).collect::<Vec<_>>()))
            .value
    };
    // At the motor, with 90 %.
    near(peak("30") - peak("2"), 28.0 / 0.9, 0.2);
}

/// The mirror case: M3 waits until the work servo has stopped, instead of getting lost.
#[test]
fn main_spindle_waits_for_the_work_servo_at_rest() {
    let slow =
        [("work-time-constant", "3000"), ("tool-time-constant", "3000")].map(|(id, typed)| (id, typed.to_owned()));
    // The turret may turn close to the work, so that a start after a reset comes to the spindle.
    let example = Project::named("polygon-lathe", None, Some("threaded-shaft")).unwrap();
    let example = example.with_entries(&[("turret-room", "1")]).unwrap();
    for (project, resets) in
        [(&example, &[83.0][..]), (&example.with_entries(&slow).unwrap(), &[83.0, 85.0, 87.0, 89.0, 189.0, 191.0])]
    {
        for reset in resets {
            let start = reset + 0.1;
            let Outcome { planner, ended, .. } =
                within(3600.0, project, &[(*reset, Action::Reset), (start, Action::Start)]);
            let findings = planner.diagnostics();
            assert_eq!(ended, Some(RunEnd::ProgramEnd), "after a reset at {reset}: {findings:?}");
            let moments = || (0..40_000).map(|k| planner.timeline().at(start + f64::from(k) * 0.005));
            let both =
                moments().find(|now| now.pmc.iter().any(|axis| axis.feed.abs() > 1e-3) && now.spindle.actual > 0.5);
            assert!(both.is_none(), "both drives turn the work after a reset at {reset}");
        }
    }
}

/// Servo and inverter turn one shaft: SVF is on from the run command until standstill, and off while the servo turns the work itself.
#[test]
fn work_servo_is_off_while_the_main_spindle_turns() {
    let ladder = shaft(&[]).prepared().ladder().unwrap();
    let [off, follows] = ["G126.3", "G7.5"].map(Bit::Device);
    let stands = Bit::Input(MachineContact::AtStandstill);
    let mut image = Image::default();
    [
        MachineContact::HoldKey,
        MachineContact::Emergency,
        MachineContact::EmergencyDelayed,
        MachineContact::InverterReady,
    ]
    .into_iter()
    .for_each(|contact| image.set(Bit::Input(contact), true));
    image.set(stands, true);
    let mut is_off = |changes: &[(Bit, bool)]| {
        changes.iter().for_each(|(bit, closed)| image.set(*bit, *closed));
        (0..12).for_each(|_| ladder.scan(0.0, &mut image));
        assert_eq!(image.is_on(off), !image.is_on(follows));
        image.is_on(off)
    };
    assert!(!is_off(&[]), "at rest");
    let key = Bit::Input(MachineContact::ForwardKey);
    assert!(is_off(&[(Bit::Input(MachineContact::StopKey), true), (key, true)]), "by the key");
    assert!(is_off(&[(key, false), (stands, false)]), "it turns");
    assert!(is_off(&[(Bit::Input(MachineContact::StopKey), false)]), "it slows down");
    assert!(!is_off(&[(stands, true)]), "it stands");
}

#[test]
fn work_servo_waits_for_the_main_spindle_at_rest() {
    // The ramp lasts longer than the move of the tool to the polygon.
    let turned_end =
        [("before", "false"), ("after", "true"), ("main-ramp", "20")].map(|(id, typed)| (id, typed.to_owned()));
    let project = Project::named("polygon-lathe", None, None).unwrap().with_entries(&turned_end).unwrap();
    let done = within(3600.0, &project, &[]).planner.ended_at().unwrap();
    let whole = within(3600.0, &project, &[]).planner;
    let turns = |t: &f64| whole.timeline().at(*t).spindle.actual > 700.0;
    let cut = (1..1000).map(|k| done * f64::from(k) / 1000.0).find(turns).expect("the end is turned");
    // Cycle start behind a reset in the cut, behind one in the dwell in which the spindle stops, and while it coasts after a fault.
    let fault = [(cut - 0.3, Action::InverterFault(true)), (cut - 0.2, Action::InverterFault(false))];
    for (reset, faults) in [(cut, &[][..]), (done - 19.5, &[]), (cut, &fault)] {
        let start = reset + 0.1;
        let actions = [faults, &[(reset, Action::Reset), (start, Action::Start)]].concat();
        let planner = within(3600.0, &project, &actions).planner;
        let moments = || (0..40_000).map(|k| planner.timeline().at(start + f64::from(k) * 0.005));
        assert!(moments().next().unwrap().spindle.actual > 100.0, "it still turns at {start}");
        let both = moments().find(|now| now.pmc.iter().any(|axis| axis.feed.abs() > 1e-3) && now.spindle.actual > 0.5);
        assert!(both.is_none(), "both drives turn the work: {:?}", both.map(|now| (now.pmc, now.spindle)));
        assert!(moments().any(|now| now.pmc[0].feed > 100.0), "the polygon is turned");
    }
    // The zero-speed contact of an inverter closes as soon as its output is off: the contact is that of a monitor at the spindle.
    let sizing = sized_without_envelope(&project);
    let ladder = project.prepared().ladder().unwrap();
    let place = format!("PLC {}", ladder.bit(Bit::Input(MachineContact::AtStandstill)));
    let ends = |row: &macroline::project::size::TerminalRow| {
        [(&row.from, &row.to), (&row.to, &row.from)]
            .iter()
            .any(|(plc, other)| plc.place == place && other.item == BillItem::StandstillMonitor)
    };
    assert!(sizing.terminals.iter().any(ends), "{place}");
    assert!(sizing.bill.iter().any(|row| row.item == BillItem::StandstillMonitor));
}

/// Half of the program turns the bar by the main spindle: hold and alarm leave it turning.
#[test]
fn stops_and_servo_off_of_the_main_spindle_are_on_the_sheets() {
    let shaft = Project::named("polygon-lathe", None, Some("threaded-shaft")).unwrap();
    let rows = stop_table(&shaft);
    for name in ["Feed hold", "Alarm"] {
        let of_main = format!("{name} while the main spindle turns");
        let row = rows.iter().find(|cells| cells[0] == of_main).expect("a row of its own");
        assert!(row[1].contains("Keeps turning") && row[3] == "The work keeps turning", "{row:?}");
    }
    let servo_off = |project: &Project| {
        let sheets = project.prepared().sheets();
        let rows = sheets.iter().filter(|sheet| sheet.id == "parameters").flat_map(|sheet| &sheet.rows);
        rows.filter(|row| row.cells[5].contains("servo off")).count()
    };
    let square = Project::named("polygon-lathe", None, None).unwrap();
    assert_eq!([&shaft, &square].map(servo_off), [1, 0]);
}

/// Between the polygons the axes turn to other angles; under the main spindle they stand. Only in the cut the phase counts.
#[test]
fn envelope_takes_the_phase_in_the_cut_of_a_polygon() {
    let two = [("second", "true"), ("second-across-flats", "21")];
    let square = Project::named("polygon-lathe", None, None).unwrap();
    let two = square.with_entries(&two).unwrap();
    let shaft = Project::named("polygon-lathe", None, Some("threaded-shaft")).unwrap();
    let phase = |project: &Project, event: OperatingEvent| {
        let rows = sized(project).envelope;
        let row = rows.iter().find(|row| row.event == event && row.quantity.id() == "phase").expect("a phase");
        row.value
    };
    near(phase(&two, OperatingEvent::Run), 0.0, 1e-6);
    near(phase(&shaft, OperatingEvent::PowerFailure), value(&shaft, "coast-phase").abs(), 1e-9);
}
