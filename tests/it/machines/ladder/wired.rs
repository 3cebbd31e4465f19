//! Ladders on a wired machine: codes of the override.

use macroline::controls::interface::SignalRole;
use macroline::machines::ladder::PlcNumber;
use macroline::machines::ladder::scan::Image;
use macroline::motion::Action;
use macroline::project::Project;

use super::{ladder, settle};
use crate::machines::restart::within;

/// Codes of 50 to 120 % in steps of 10, by the setting of the switch. Source: reference/gsk-980tdc.md, section 6.
const CODES: [(&str, [f64; 8]); 2] =
    [("980mdi", [7.0, 6.0, 2.0, 3.0, 1.0, 0.0, 4.0, 5.0]), ("988ta", [5.0, 6.0, 7.0, 8.0, 9.0, 10.0, 11.0, 12.0])];

/// Projects of a machine on the control with codes of the override, by the setting of the switch.
fn coded(machine: &str) -> impl Iterator<Item = (Project, [f64; 8])> {
    CODES.into_iter().map(move |(setting, codes)| {
        let mut project = Project::of(machine, Some("gsk-980tdc")).unwrap();
        let row = project.control.switches.iter().find(|row| row.id() == "override-code").expect("a switch");
        project.switches.set(row, setting);
        (project, codes)
    })
}

#[test]
fn override_has_the_code_of_its_nearest_position() {
    for machine in ["turning-spindle", "ribbon-line"] {
        for (project, codes) in coded(machine) {
            let (ladder, mut image) = (ladder(&project), Image::default());
            let input =
                ladder.words.iter().find(|row| matches!(row.0, PlcNumber::Signal(SignalRole::MacroInputLow(_))));
            assert_eq!(input.is_some(), machine == "ribbon-line");
            for knob in 0..=255 {
                image.put(PlcNumber::Knob, f64::from(knob));
                settle(&ladder, &mut image, 0.0);
                let position = (knob + 5) / 10;
                let position = position.clamp(5, 12);
                let code = image.number(PlcNumber::Signal(SignalRole::SpindleOverrideCode));
                assert_eq!(code, codes[position as usize - 5], "{machine}: {knob} %");
                if let Some((input, _)) = input {
                    assert_eq!(image.number(*input), f64::from(10 * position), "{machine}: {knob} %");
                }
            }
        }
    }
}

#[test]
fn control_turns_at_the_percentage_of_the_code() {
    for (knob, percent) in [(100.0, 100.0), (20.0, 50.0), (74.0, 70.0), (137.0, 120.0)] {
        for (project, _) in coded("ribbon-line") {
            let run = within(30.0, &project, &[(0.0, Action::SpindleOverride(knob))]);
            let speed = run.planner.timeline().at(20.0).spindle.command.abs();
            assert_eq!(speed, 1200.0 * percent / 100.0, "knob at {knob} %");
        }
    }
}
