//! Turning spindle and polygon lathe react to hold, single block, alarm, reset and emergency stop as in their tables.

use macroline::controls::Code;
use macroline::drives::Rotation;
use macroline::motion::{Action, Event, PlcOrders, PlcSignals, ProgramState, Snapshot};
use macroline::project::Project;

use super::ribbon::each_control::over_time;
use crate::queries::{every_machine_on_every_control, report_text, stop_table};

/// Each of the two lathes on each of its controls.
fn lathes() -> impl Iterator<Item = Project> {
    every_machine_on_every_control()
        .filter(|project| ["turning-spindle", "polygon-lathe"].contains(&project.machine.id()))
}

/// Speeds of spindle, work and tool.
fn turning(now: &Snapshot) -> [f64; 3] {
    [now.spindle.actual, now.pmc[0].feed, now.pmc[1].feed]
}

#[test]
fn tables_of_both_lathes_name_every_interruption() {
    for project in lathes() {
        let rows = stop_table(&project);
        let names: Vec<_> = rows.iter().map(|cells| cells[0].as_str()).collect();
        let mut wanted =
            vec!["Feed hold", "Stop between two blocks: M00, single block", "Alarm", "Reset", "Emergency stop"];
        let fault = project.prepared().plc().watches_inverter();
        wanted.extend(fault.then_some("Inverter fault"));
        wanted.push("Power failure");
        let changes = project.machine.id() == "turning-spindle";
        if changes && project.control.codes.iter().any(|row| matches!(row.code, Code::GearStage(1..))) {
            wanted.extend(["Gear not in position in time", "Gear leaves its position"]);
        }
        wanted.extend((project.machine.id() == "polygon-lathe").then_some("Alarm: one drive of work or tool fails"));
        assert_eq!(names, wanted, "{}", project.control.id);
        assert!(rows.iter().flatten().all(|cell| cell.len() > 3 && !cell.contains(".stops.")), "{rows:?}");
        let report = report_text(&project);
        let fault = if project.prepared().plc().watches_inverter() { ", inverter fault" } else { "" };
        let title = format!("## Hold, alarm, reset, emergency stop{fault}\n");
        assert!(report.contains(&title), "{}", project.control.id);
    }
}

#[test]
fn keyway_has_rows_of_its_own_in_the_table_of_stops() {
    let rows = |changes: &[(&'static str, &str)]| {
        let project = Project::named("turning-spindle", Some("sinumerik-802d"), Some("keyway")).unwrap();
        let sets: Vec<_> = changes.iter().map(|(id, typed)| (*id, (*typed).to_owned())).collect();
        let rows = stop_table(&project.with_entries(&sets).unwrap());
        rows.into_iter().filter(|cells| cells[0].ends_with("in the keyway")).collect::<Vec<_>>()
    };
    let spindles = |rows: &[Vec<String>]| rows.iter().map(|cells| cells[1].clone()).collect::<Vec<_>>();
    let locked = rows(&[]);
    assert_eq!(spindles(&locked), ["Stays locked at its angle"; 4]);
    assert!(locked[3][3].contains("stays closed without power"), "{locked:?}");
    assert!(locked[1][4].contains("set R124 to 0"), "{locked:?}");
    let opens = "Its clamp opens: no code releases it";
    assert_eq!(spindles(&rows(&[("release-code", "0")]))[1..3], [opens, "Stays locked at its angle"]);
}

/// The rotation that the PLC gives the spindle at M3 behind its lock code and an interruption: none while the clamp is closed.
fn rotation_after(project: &Project, interruption: PlcSignals) -> Option<Rotation> {
    let mut plc = project.prepared().plc();
    let mut orders = PlcOrders::default();
    let running = PlcSignals { program_state: ProgramState::Running, ..PlcSignals::default() };
    let coded = |code| PlcSignals { m_strobe: Some(code), ..running.clone() };
    let scans = [coded(81), interruption, running.clone(), coded(3)];
    for (second, signals) in scans.iter().enumerate() {
        plc.scan(second as f64, signals, &mut orders);
    }
    orders.run_contacts
}

#[test]
fn clamp_of_the_keyway_follows_the_table_of_stops() {
    for control in ["sinumerik-802d", "sinumerik-808d"] {
        for release in ["82", "0"] {
            let project = Project::named("turning-spindle", Some(control), Some("keyway")).unwrap();
            let project = project.with_entries(&[("release-code", release)]).unwrap();
            let rows = stop_table(&project);
            for (name, emergency) in [("Reset", false), ("Emergency stop", true)] {
                let row = rows.iter().find(|cells| cells[0] == format!("{name} in the keyway")).unwrap();
                let stops =
                    PlcSignals { program_state: ProgramState::Idle, reset: true, emergency, ..PlcSignals::default() };
                let locked = row[1].starts_with("Stays locked");
                let rotation = if locked { Rotation::Stopped } else { Rotation::Clockwise };
                assert_eq!(rotation_after(&project, stops), Some(rotation), "{control}, M{release}: {name}");
            }
        }
    }
}

#[test]
fn both_lathes_stop_and_turn_on_as_their_tables_say() {
    for project in lathes() {
        let whole = over_time(&project, vec![]);
        let end = whole.timeline().end();
        // In a cut: it turns, faster than while gears mesh, and the slide along the work moves.
        let cuts = |t: &f64| {
            let now = whole.timeline().at(*t);
            turning(&now).iter().any(|speed| speed.abs() > 40.0) && now.axes.iter().any(|axis| axis.feed != 0.0)
        };
        let at = (1..1000).map(|k| end * f64::from(k) / 1000.0).find(cuts).expect("a cut");
        let name = format!("{} at {at}", project.control.id);
        let rows = stop_table(&project);
        let mut actions =
            vec![(0, Action::Hold), (1, Action::SingleBlock(true)), (3, Action::Reset), (4, Action::EmergencyStop)];
        let fault = project.prepared().plc().watches_inverter();
        actions.extend(fault.then_some((5, Action::InverterFault(true))));
        for (row, action) in actions {
            let planner = over_time(&project, vec![Event { t: at, action: action.clone() }]);
            let last = planner.timeline().at(planner.timeline().end() + 60.0);
            let goes_on = ["Keeps turning", "keep turning"].iter().any(|words| rows[row][1].contains(words));
            let turns = turning(&last).iter().any(|speed| speed.abs() > 1.0);
            assert_eq!(turns, goes_on, "{name} {action:?}: {:?}, {}", turning(&last), rows[row][1]);
            assert!(last.axes.iter().all(|axis| axis.feed == 0.0), "{name} {action:?}");
        }
    }
}
