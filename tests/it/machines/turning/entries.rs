//! Entries of the operator: those that change while a part is cut act from the next start.

use macroline::motion::{Action, RunEnd};
use macroline::project::Project;

use super::{machine, project, run_set};
use crate::machines::every_machine::restart::within;

const PATHS: [&str; 3] = ["facing", "turning", "taper"];

/// The end of a run in which the operator sets variables in its middle, and its motions and spindle words.
fn changed(project: &Project, at: f64, settings: &[(u32, f64)]) -> (Option<RunEnd>, Vec<String>) {
    let events: Vec<_> = settings.iter().map(|(number, value)| (at, Action::Variable(*number, Some(*value)))).collect();
    let run = within(7200.0, project, &events);
    (run.ended, run.log.into_iter().map(|(_, canon)| canon).collect())
}

/// Entries that the checks at the start refuse, set in the middle of a part: a cut into the chuck, no depth, no
/// clearance, a part as thick as its stock, no feed.
#[test]
fn entries_changed_in_a_cut_leave_the_part_as_it_is() {
    let settings =
        [(105, 300.0), (114, 300.0), (106, 0.0), (108, -40.0), (102, 10.0), (103, -20.0), (104, 200.0), (101, 0.0)];
    for control in machine().controls() {
        for path in PATHS {
            let project = project(control, &[("path", path), ("depth", "5")]);
            let whole = within(7200.0, &project, &[]);
            let end = whole.planner.ended_at().unwrap();
            let commands: Vec<String> = whole.log.into_iter().map(|(_, canon)| canon).collect();
            for share in [0.2, 0.5, 0.8] {
                let (ended, again) = changed(&project, share * end, &settings);
                assert_eq!(ended, Some(RunEnd::ProgramEnd), "{control} {path} at {share}");
                assert_eq!(again, commands, "{control} {path} at {share}: another part");
            }
        }
    }
}

/// A keyway after the cut, deeper and longer by variables that change in the cut.
#[test]
fn keyway_changed_in_a_cut_stays_as_it_was() {
    let project = Project::named("turning-spindle", Some("sinumerik-802d"), Some("keyway")).unwrap();
    let whole = within(7200.0, &project, &[]);
    let commands: Vec<String> = whole.log.into_iter().map(|(_, canon)| canon).collect();
    let settings =
        [(113, 10.0), (117, 90.0), (118, 300.0), (119, 90.0), (120, 0.0), (121, 0.0), (122, 0.0), (123, 0.0)];
    assert_eq!(changed(&project, 20.0, &settings), (Some(RunEnd::ProgramEnd), commands));
}

/// The changed entry is checked and acts at the next start.
#[test]
fn entry_changed_in_a_cut_acts_at_the_next_start() {
    let project = project("gsk-980tdc", &[("path", "turning"), ("depth", "5")]);
    let end = within(7200.0, &project, &[]).planner.ended_at().unwrap();
    let again = |length: f64| {
        let events = [(0.5 * end, Action::Variable(105, Some(length))), (end + 1.0, Action::Start)];
        within(7200.0, &project, &events)
    };
    assert!(matches!(again(300.0).ended, Some(RunEnd::Alarm(_))));
    let shorter = again(40.0).log;
    let cuts =
        |word: &str| shorter.iter().filter(|(_, canon)| canon.starts_with("linear") && canon.contains(word)).count();
    assert!(cuts("Z-60") > 1 && cuts("Z-60") == cuts("Z-40"), "{shorter:?}");
}

/// A part as thick as its stock is no part: form and program refuse it alike, and nothing moves.
#[test]
fn entries_with_nothing_to_cut_raise_an_alarm() {
    for control in machine().controls() {
        for (path, number, field, value) in [
            ("facing", 103, "finished-diameter", 100.0),
            ("turning", 103, "finished-diameter", 100.0),
            ("turning", 103, "finished-diameter", 120.0),
            ("taper", 103, "finished-diameter", 100.0),
            ("taper", 104, "large-diameter", 100.0),
        ] {
            let plain = [("path", path), ("depth", "5"), ("stock-diameter", "100"), ("start-x", "180")];
            let text = value.to_string();
            let design = project(control, &[&plain[..], &[(field, text.as_str())]].concat()).design();
            assert!(
                design.diagnostics.iter().any(|found| found.message.id == "turning.nothing-to-cut"),
                "{path} {field}"
            );
            let mut planner = run_set(&project(control, &plain), number, value);
            let before = planner.timeline().words_at(0.0);
            let ended = planner.advance(f64::INFINITY, usize::MAX).ended;
            let end = planner.timeline().end();
            let ending = format!("{ended:?} {}", planner.timeline().message_at(end).unwrap_or_default());
            assert!(ending.contains("IS NOT BELOW"), "{control} {path} {number}: {ending}");
            assert_eq!(before, planner.timeline().words_at(end), "{control} {path}: it moved");
        }
    }
}
