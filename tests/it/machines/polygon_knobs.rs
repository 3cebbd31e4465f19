//! The polygon lathe with its knobs away from 100 %: speed of the work's shaft, loads of the cut, threads; and the rooms that the form has to give.

use macroline::motion::{Action, Event, Snapshot};
use macroline::project::Project;
use macroline::view::Verdict;

use super::ribbon_controls::over_time;
use crate::asked::{near, readout};

fn shaft(entries: &[(&'static str, &str)]) -> Project {
    let shaft = Project::named("polygon-lathe", None, Some("threaded-shaft")).unwrap();
    let entries: Vec<_> = entries.iter().map(|(id, typed)| (*id, (*typed).to_owned())).collect();
    shaft.with_entries(&entries).unwrap()
}

/// Value of a parameter on the sheet, by its number.
fn parameter(project: &Project, number: &str) -> String {
    let sheets = project.prepared().sheets();
    let rows = sheets.iter().filter(|sheet| sheet.id == "parameters").flat_map(|sheet| &sheet.rows);
    rows.filter(|row| row.cells[0] == number).map(|row| row.cells[3].clone()).collect()
}

/// Moments of a run, 5 ms apart, with the spindle knob at a position (%) from the start on.
fn moments(project: &Project, percent: f64) -> Vec<Snapshot> {
    let planner = over_time(project, vec![Event { t: 0.0, action: Action::SpindleOverride(percent) }]);
    let steps = (planner.timeline().end() / 0.005) as u32;
    (0..steps).map(|at| planner.timeline().at(f64::from(at) * 0.005)).collect()
}

/// The work's motor and the chuck are on the shaft that the main spindle turns.
#[test]
fn spindle_knob_is_clamped_at_the_limit_of_the_work() {
    for (limit, clamp, top) in [("1000", "1000", 1000.0), ("3000", "3000", 2032.0), ("9000", "3000", 2032.0)] {
        let project = shaft(&[("work-limit", limit)]);
        assert_eq!(parameter(&project, "3772"), clamp, "work-limit {limit}");
        let speed = readout(&project, "main-top-speed");
        assert_eq!((speed.value, speed.verdict), (top, Verdict::Ok));
        let run = moments(&project, 254.0);
        let fastest = run.iter().map(|now| now.spindle.command).fold(0.0, f64::max);
        near(fastest, top, 1e-6);
    }
}
