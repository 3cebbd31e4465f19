//! Limits of growth where no tried entry keeps every verdict.

use macroline::machines::ALL;
use macroline::project::Project;
use macroline::project::size::{ResultName, Sizing, SizingRuns, size_without_envelope};
use macroline::view::Verdict;

/// Results that fail with S in r/min, beside those that fail at any S.
fn failing(project: &Project, speed: f64, failing_anyway: &[ResultName]) -> Vec<&'static str> {
    let set = [("spindle-speed", speed.to_string())];
    let readouts = project.with_entries(&set).unwrap().design().readouts.into_iter();
    let fails = readouts.filter(|row| row.verdict == Verdict::Fail && !failing_anyway.contains(&ResultName::from(row)));
    fails.map(|row| row.id).collect()
}

/// The sizing without the envelope.
fn sized(project: &Project) -> Sizing {
    let short = project.with_entries(&[("pitch-count", "10")]).unwrap_or_else(|| project.clone());
    size_without_envelope(project, &SizingRuns::new(&short, &short.written()))
}

#[test]
fn no_fastest_speed_is_given_where_none_holds() {
    // At a high S the vector feed is beyond the range of the control, at a low one the motor's slip draws the ribbon taut.
    let project = Project::named("ribbon-line", Some("gsk-980tdc"), Some("paper")).unwrap();
    let sizing = sized(&project);
    let speed = &sizing.limits[0];
    assert_eq!((speed.field, speed.holds), ("spindle-speed", false));
    assert_eq!(sizing.fastest, None);
    for rpm in (82..1200).step_by(13) {
        assert!(!failing(&project, f64::from(rpm), &speed.failing_anyway).is_empty(), "{rpm}");
    }
    assert!(failing(&project, speed.value, &speed.failing_anyway).contains(&speed.binding.unwrap().id));
    let limits = sizing.sheets().into_iter().find(|sheet| sheet.id == "limits").unwrap();
    let row = limits.rows.iter().find(|row| row.cells[1] == "None of those tried").unwrap();
    assert!(row.cells[2].is_empty(), "{:?}", row.cells);
}

#[test]
fn fastest_entry_fails_only_in_the_named_results() {
    let controls = ["gsk-980tdc", "sinumerik-802d"];
    let mut found = Vec::new();
    for control in controls {
        for example in ["matched", "encoder", "paper"] {
            let project = Project::named("ribbon-line", Some(control), Some(example)).unwrap();
            let sizing = sized(&project);
            let Some(fastest) = sizing.fastest else { continue };
            let speed: f64 = fastest.entry.text.parse().unwrap();
            assert_eq!(failing(&project, speed, &fastest.failing_anyway), [""; 0], "{example} on {control} at {speed}");
            found.push((control, example));
        }
    }
    // With the values of the paper no tried speed holds.
    assert_eq!(found, controls.map(|control| ["matched", "encoder"].map(|example| (control, example))).concat());
}

#[test]
fn machine_at_rest_has_no_limits_of_growth() {
    let line = Project::named("ribbon-line", None, None).unwrap();
    for (percent, stands) in [("0", true), ("50", false)] {
        let sizing = sized(&line.with_entries(&[("override", percent)]).unwrap());
        assert_eq!((sizing.limits.is_empty(), sizing.fastest.is_none()), (stands, stands), "{percent}");
        let reason = sizing.json()["inverse_reason"].as_str().map(str::to_owned);
        assert_eq!(reason.is_some_and(|reason| reason.starts_with("The machine stands")), stands, "{percent}");
        let section = sizing.sections().into_iter().find(|section| section.id == "limits").unwrap();
        assert_eq!(section.answer.starts_with("The machine stands"), stands, "{}", section.answer);
    }
}

#[test]
fn json_has_the_reason_for_no_fastest_speed() {
    let reason_of = |project: &Project| {
        let json = sized(project).json();
        let reason = json["inverse_reason"].as_str().map(str::to_owned);
        assert_eq!(json["inverse"].is_null(), reason.is_some(), "{json}");
        reason.unwrap_or_default()
    };
    let lathe = Project::named("turning-spindle", None, None).unwrap();
    let reason = reason_of(&lathe);
    assert!(reason.starts_with("No limit binds: nothing fails up to Cutting speed 2"), "{reason}");
    let line = Project::named("ribbon-line", Some("gsk-980tdc"), Some("paper")).unwrap();
    let reason = reason_of(&line);
    assert!(reason.starts_with("No tried value keeps every verdict: with Spindle speed S down to "), "{reason}");
    assert!(reason.ends_with(" fails."), "{reason}");
    for machine in ALL {
        for control in machine.controls() {
            for example in machine.examples() {
                let project = Project::named(machine.id(), Some(control), Some(example.id)).unwrap();
                reason_of(&project);
            }
        }
    }
}
