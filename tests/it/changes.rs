//! Differences between two states of a project, as phrases.

use macroline::controls;
use macroline::machines::form::Value;
use macroline::motion::{Action, Event, Panel};
use macroline::nc::Files;
use macroline::project::Project;
use macroline::project::changes::{changes, changes_in_words};

fn ribbon() -> Project {
    Project::of("ribbon-line", None).unwrap()
}

/// Differences between a new ribbon line and the same after a change, as phrases.
fn change_phrases(change: impl FnOnce(&mut Project)) -> Vec<String> {
    let mut after = ribbon();
    change(&mut after);
    changes(&ribbon(), &after)
}

#[test]
fn changed_entry_has_both_values_and_its_unit() {
    let found = change_phrases(|project| drop(project.values.insert("pitch".to_owned(), Value::Number(9.0))));
    assert_eq!(found, ["Pitch 10 → 9 mm"]);
}

#[test]
fn each_part_of_a_project_has_its_phrase() {
    type Case = (fn(&mut Project), &'static str);
    let cases: [Case; 7] = [
        (|project| project.move_to(controls::find("gsk-980tdc").unwrap()), "Control GSK 980TDc"),
        (|project| project.name = "Order 7".to_owned(), "Name Order 7"),
        (|project| project.edited = Some(Files::one("O1.nc", "M30")), "Program edited"),
        (|project| project.panel = Panel::new(two_actions()), "Operator’s actions"),
        (|project| project.title_block.number = "ML-1".to_owned(), "Title block"),
        (|project| project.silenced.push("lint.unreachable".to_owned()), "Silenced warnings"),
        (|project| assert!(project.keep_variant("").is_some()), "Variants"),
    ];
    for (change, phrase) in cases {
        assert!(change_phrases(change).iter().any(|words| words == phrase), "{phrase}: {:?}", change_phrases(change));
    }
}

fn two_actions() -> [Event; 2] {
    [Event { t: 1.0, action: Action::Hold }, Event { t: 2.5, action: Action::SpindleOverride(80.0) }]
}

#[test]
fn one_changed_operator_action_is_listed() {
    let mut before = ribbon();
    before.panel = Panel::new(two_actions());
    let [hold, slow] = two_actions();
    let actions = |panel: Panel| {
        let mut after = before.clone();
        after.panel = panel;
        changes(&before, &after)
    };
    let panel = |events: &[&Event]| Panel::new(events.iter().map(|event| (*event).clone()));
    assert_eq!(actions(panel(&[&slow])), ["Feed hold at 1 s removed"]);
    let variable = Event { t: 3.25, action: Action::Variable(107, Some(9.5)) };
    assert_eq!(actions(panel(&[&hold, &slow, &variable])), ["At 3.25 s: #107 = 9.5"]);
    let late = Event { t: 4.0, ..hold.clone() };
    assert_eq!(actions(panel(&[&slow, &late])), ["Feed hold 1 → 4 s"]);
    let early = Event { t: 0.5, ..slow.clone() };
    assert_eq!(actions(panel(&[&early, &hold])), ["Spindle override 80 % 2.5 → 0.5 s"]);
    let fast = Event { action: Action::SpindleOverride(120.0), ..slow.clone() };
    assert_eq!(actions(panel(&[&hold, &fast])), ["At 2.5 s: Spindle override 80 % → 120 %"]);
    assert_eq!(actions(panel(&[&late, &variable])), ["Operator’s actions"], "more than one");
    assert_eq!(actions(Panel::default()), ["Operator’s actions"]);
}

#[test]
fn removed_name_and_edits_are_listed() {
    let mut before = ribbon();
    before.name = "Order 7".to_owned();
    before.edited = Some(Files::one("O1.nc", "M30"));
    assert_eq!(changes(&before, &ribbon()), ["Name removed", "Program as the form writes it"]);
}

#[test]
fn another_machine_is_the_only_difference() {
    let other = Project::of("turning-spindle", None).unwrap();
    assert_eq!(changes(&ribbon(), &other), ["Machine Turning spindle"]);
}

#[test]
fn identical_projects_have_no_difference() {
    assert_eq!(changes_in_words(&ribbon(), &ribbon()), "No difference");
    let other = ribbon().with_id(Some("p1".to_owned()));
    assert!(changes(&ribbon(), &other).is_empty() && ribbon() == other);
}

#[test]
fn many_differences_are_counted() {
    let mut after = ribbon();
    after.name = "Order 7".to_owned();
    after.title_block.author = "A".to_owned();
    let entries = [("pitch", 9.0), ("heads", 7.0), ("print-roller-diameter", 30.0)];
    entries.into_iter().for_each(|(id, value)| drop(after.values.insert(id.to_owned(), Value::Number(value))));
    let text = changes_in_words(&ribbon(), &after);
    assert_eq!(text, "Name Order 7; Pitch 10 → 9 mm; Print heads 36 → 7; 2 more");
}
