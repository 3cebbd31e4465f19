//! Variants of a project: kept, taken, dropped, saved, compared, and in the report.

use expect_test::{Expect, expect};
use macroline::machines::form::Value;
use macroline::motion::{Action, Event, Panel};
use macroline::nc::Files;
use macroline::project::Project;
use macroline::project::findings::render::Renderer;
use macroline::project::variants::comparison_text;
use macroline::project::variants::variant::{MAX_VARIANT_NAME, MAX_VARIANTS};
use macroline::view::Comparison;

fn ribbon() -> Project {
    Project::of("ribbon-line", None).unwrap()
}

fn set(project: &mut Project, id: &str, value: f64) {
    assert!(project.values.insert(id.to_owned(), Value::Number(value)).is_some(), "no field {id}");
}

fn names(project: &Project) -> Vec<&str> {
    project.variants.iter().map(|variant| variant.name.as_str()).collect()
}

/// A project with two variants: A has the defaults, B another control with a setting of that control; the present settings have a pitch of
/// 12 mm.
fn two() -> Project {
    let mut project = ribbon();
    project.keep_variant("");
    project.move_to(macroline::controls::find("gsk-980tdc").unwrap());
    project.switches.set(project.control.switch("m-codes").unwrap(), "last-acts");
    project.keep_variant("");
    project.take_variant(0);
    set(&mut project, "pitch", 12.0);
    project
}

#[test]
fn variant_without_a_name_gets_the_next_free_letter() {
    let mut project = ribbon();
    assert_eq!(
        [project.keep_variant(""), project.keep_variant(" \n"), project.keep_variant("C")],
        [Some(0), Some(1), Some(2)]
    );
    project.drop_variant(1);
    assert_eq!(project.free_variant_name(), "B");
    project.keep_variant("");
    assert_eq!(names(&project), ["A", "C", "B"]);
}

#[test]
fn name_of_a_variant_is_one_short_line() {
    let mut project = ribbon();
    project.keep_variant("  fast\u{1b}[2J\n line ");
    project.keep_variant(&"x".repeat(300));
    assert_eq!(names(&project), ["fast[2J line".to_owned(), "x".repeat(MAX_VARIANT_NAME)]);
}

#[test]
fn variant_of_a_known_name_takes_its_place() {
    let mut project = ribbon();
    project.keep_variant("A");
    project.keep_variant("B");
    set(&mut project, "pitch", 12.0);
    assert_eq!(project.keep_variant(" A "), Some(0));
    assert_eq!(names(&project), ["A", "B"]);
    assert_eq!(project.variants[0].values["pitch"], Value::Number(12.0));
}

#[test]
fn thirteenth_variant_is_not_kept() {
    let mut project = ribbon();
    assert!((0..MAX_VARIANTS).all(|at| project.keep_variant("") == Some(at)));
    let full = project.clone();
    assert_eq!(project.keep_variant("M"), None);
    assert!(project == full);
    assert_eq!(project.keep_variant("L"), Some(MAX_VARIANTS - 1), "a known one is still replaced");
}

#[test]
fn variant_comes_back_with_control_entries_and_settings() {
    let mut project = two();
    let before = project.clone();
    project.panel =
        Panel::new([Event { t: 1.0, action: Action::SpindleOverride(80.0) }, Event { t: 2.0, action: Action::Reset }]);
    project.take_variant(1);
    assert_eq!((project.control.id, &project.values["pitch"]), ("gsk-980tdc", &Value::Number(10.0)));
    assert_eq!(project.switches.setting(project.control.switch("m-codes").unwrap()), "last-acts");
    assert_eq!(project.panel.events().len(), 1, "the reset belongs to the run on the other control");
    assert_eq!(project.variants, before.variants);
    project.take_variant(0);
    assert!(project.switches == before.switches && project.control.id == before.control.id);
    project.take_variant(2);
    project.drop_variant(2);
    assert_eq!(names(&project), ["A", "B"], "there is no third variant");
}

#[test]
fn variant_on_the_same_control_keeps_operator_actions() {
    let mut project = two();
    project.panel = Panel::new([Event { t: 2.0, action: Action::Reset }]);
    project.take_variant(0);
    assert_eq!((project.panel.events().len(), &project.values["pitch"]), (1, &Value::Number(10.0)));
}

/// The texts of a row.
fn row(comparison: &Comparison, group: &str, id: &str) -> Vec<String> {
    let groups = comparison.differences();
    let (_, rows) = groups.iter().find(|(title, _)| *title == group).unwrap();
    rows.iter().find(|row| row.id == id).unwrap_or_else(|| panic!("no {id}")).marked()
}

#[test]
fn present_settings_are_compared_with_each_variant() {
    let mut project = two();
    set(&mut project, "spindle-speed", 1400.0);
    let comparison = project.compared_variants("Now").unwrap();
    assert_eq!(comparison.names, ["Now", "A", "B"]);
    assert_eq!(row(&comparison, "variants.entries", "pitch"), ["12", "10", "10"]);
    assert_eq!(row(&comparison, "variants.controls", "control"), ["Mitsubishi E60", "Mitsubishi E60", "GSK 980TDc"]);
    let setting = row(&comparison, "variants.controls", "m-codes");
    assert!(setting[0] == setting[1] && setting[1] != setting[2], "{setting:?}");
    assert_eq!(comparison.switches.len(), 1, "what a control has by default is no choice: {:?}", comparison.switches);
    // Each column is the design of its settings.
    for (at, variant) in [None, Some(0), Some(1)].into_iter().enumerate() {
        let mut alone = project.clone();
        variant.into_iter().for_each(|variant| alone.take_variant(variant));
        let readouts = alone.design().readouts;
        for row in &comparison.results {
            let own = readouts.iter().find(|readout| readout.id == row.id && readout.unit == row.unit);
            let cell = row.cells[at].as_ref();
            assert_eq!(cell.map(|cell| cell.1), own.map(|own| own.verdict), "{} {}", comparison.names[at], row.id);
        }
    }
    let speed = comparison.results.iter().find(|row| row.id == "line-speed").unwrap();
    assert_eq!([0, 1, 2].map(|at| speed.differs_at(at)), [false, true, true]);
}

#[test]
fn same_settings_differ_in_nothing() {
    let mut project = ribbon();
    assert!(project.compared_variants("Now").is_none(), "without a variant there is nothing to compare");
    project.keep_variant("A");
    let comparison = project.compared_variants("Now").unwrap();
    assert!(comparison.differences().is_empty());
    assert!(comparison_text(&comparison).contains("Nothing differs."));
}

#[test]
fn variants_are_saved_with_the_project() {
    let plain = ribbon();
    assert!(!plain.to_json().contains("variants"), "a file without variants is as it was");
    let project = two();
    let loaded = Project::from_json(&project.to_json());
    assert!(loaded.diagnostics.is_empty(), "{:?}", loaded.diagnostics);
    let loaded = loaded.project.unwrap();
    assert!(loaded == project && loaded.variants == project.variants);
    let mut other = project.clone();
    other.drop_variant(0);
    assert!(other != project);
}

/// Findings about a project with these variants, and the names of those that were read.
#[track_caller]
fn check(variants: &str, expect: Expect) {
    let text = format!(
        "{{ \"version\": 1, \"machine\": \"ribbon-line\", \"control\": \"mitsubishi-e60\", \"values\": {{}},\n  \"variants\": {variants}\n}}\n"
    );
    let loaded = Project::from_json(&text);
    let files = Files::one("project.json", text.as_str());
    let renderer = Renderer::new(&files);
    let mut out: String = loaded.diagnostics.iter().map(|found| renderer.text(found)).collect();
    out += &loaded.project.map_or("no project".to_owned(), |project| names(&project).join(", "));
    expect.assert_eq(&out);
}

#[test]
fn variant_of_another_shape_is_an_error_at_its_place() {
    check(
        "{ \"A\": {} }",
        expect![[r#"
            error: This does not have the shape of a project file: an object in place of a list.
             --> project.json:2:14
              |
            2 |   "variants": { "A": {} }
              |              ^
            no project"#]],
    );
    check(
        "[ { \"name\": \"A\", \"control\": \"mitsubishi-e60\" } ]",
        expect![[r#"
            error: This does not have the shape of a project file: the key “values” is missing.
             --> project.json:2:60
              |
            2 |   "variants": [ { "name": "A", "control": "mitsubishi-e60" } ]
              |                                                            ^
            no project"#]],
    );
    check(
        "[ { \"name\": \"A\", \"control\": \"mitsubishi-e60\", \"values\": {}, \"panel\": [] } ]",
        expect![[r#"
            error: This does not have the shape of a project file: “panel” is none of name, control, values, switches.
             --> project.json:2:81
              |
            2 |   "variants": [ { "name": "A", "control": "mitsubishi-e60", "values": {}, "panel": [] } ]
              |                                                                                 ^
            no project"#]],
    );
    check(
        "[ { \"name\": \"A\", \"control\": \"mitsubishi-e60\", \"values\": 3 } ]",
        expect![[r#"
            error: This does not have the shape of a project file: a number in place of an object { "id": value, … }.
             --> project.json:2:71
              |
            2 |   "variants": [ { "name": "A", "control": "mitsubishi-e60", "values": 3 } ]
              |                                                                       ^
            no project"#]],
    );
}

#[test]
fn variant_without_a_name_of_its_own_or_control_is_left_out() {
    let on = |name: &str, control: &str| format!("{{ \"name\": {name}, \"control\": {control}, \"values\": {{}} }}");
    let good = |name: &str| on(name, "\"mitsubishi-e60\"");
    check(
        &format!("[ {},\n {} ]", good("7"), good("\" \"")),
        expect![[r#"
        error: Each variant needs a name of its own; this one was left out.
         --> project.json:2:27
          |
        2 |   "variants": [ { "name": 7, "control": "mitsubishi-e60", "values": {} },
          |                           ^
        error: Each variant needs a name of its own; this one was left out.
         --> project.json:3:12
          |
        3 |  { "name": " ", "control": "mitsubishi-e60", "values": {} } ]
          |            ^^^
    "#]],
    );
    check(
        &format!("[ {},\n {} ]", good("\"A\""), good("\"A \"")),
        expect![[r#"
        error: Each variant needs a name of its own; this one was left out.
         --> project.json:3:12
          |
        3 |  { "name": "A ", "control": "mitsubishi-e60", "values": {} } ]
          |            ^^^^
        A"#]],
    );
    check(
        &format!("[ {},\n {} ]", on("\"A\"", "\"abacus\""), on("\"B\"", "\"fanuc-0i-tf\"")),
        expect![[r#"
        error: The machine does not go with the control of variant A; the variant was left out. Possible: mitsubishi-e60, gsk-980tdc, sinumerik-802d, sinumerik-808d, knd-k2000t, fanuc-0i-tf, fanuc-0i-mf.
         --> project.json:2:43
          |
        2 |   "variants": [ { "name": "A", "control": "abacus", "values": {} },
          |                                           ^^^^^^^^
        B"#]],
    );
    let many: Vec<String> = (0..=MAX_VARIANTS).map(|at| good(&format!("\"V{at}\""))).collect();
    check(
        &format!("[ {} ]", many.join(",\n ")),
        expect![[r#"
        error: A project has at most 12 variants: from this one on they were left out.
          --> project.json:14:12
           |
        14 |  { "name": "V12", "control": "mitsubishi-e60", "values": {} } ]
           |            ^^^^^
        V0, V1, V2, V3, V4, V5, V6, V7, V8, V9, V10, V11"#]],
    );
}

#[test]
fn values_and_settings_of_a_variant_are_checked() {
    check(
        "[ { \"name\": \"A\", \"control\": \"gsk-980tdc\",\n    \"values\": { \"pitch\": \"wide\", \"colour\": 3, \"heads\": 4, \"heads\": 5 },\n    \"switches\": { \"moon\": \"full\" } } ]",
        expect![[r#"
            error: Field “pitch”: text is not what belongs there; the default is taken.
             --> project.json:3:26
              |
            3 |     "values": { "pitch": "wide", "colour": 3, "heads": 4, "heads": 5 },
              |                          ^^^^^^
            error: The machine has no field “colour”; it was left out.
             --> project.json:3:34
              |
            3 |     "values": { "pitch": "wide", "colour": 3, "heads": 4, "heads": 5 },
              |                                  ^^^^^^^^
            error: “heads” is here a second time.
             --> project.json:3:59
              |
            3 |     "values": { "pitch": "wide", "colour": 3, "heads": 4, "heads": 5 },
              |                                                           ^^^^^^^
            error: The control has no switch “moon” with this setting; its default is taken.
             --> project.json:4:19
              |
            4 |     "switches": { "moon": "full" } } ]
              |                   ^^^^^^
            A"#]],
    );
    let text = "{ \"version\": 1, \"machine\": \"ribbon-line\", \"control\": \"mitsubishi-e60\", \"values\": {},
        \"variants\": [ { \"name\": \"A\", \"control\": \"mitsubishi-e60\", \"values\": { \"heads\": 4 } } ] }";
    let project = Project::from_json(text).project.unwrap();
    let own = &project.variants[0].values;
    assert_eq!((&own["heads"], own.get("pitch")), (&Value::Number(4.0), project.values.get("pitch")));
}

#[test]
fn report_has_the_offer_beside_the_variants() {
    let mut project = two();
    let report = |project: &Project, name: &str| {
        let files = project.export().into_files();
        files.into_iter().find(|file| file.name == name).unwrap().text
    };
    let page = report(&project, "report.html");
    let table = page.split("<table class=\"compared\">").nth(1).unwrap().split("</table>").next().unwrap();
    assert!(table.contains("<th>Offer</th><th>A</th><th>B</th>"), "{table}");
    assert!(
        table.contains("<td>Pitch<span class=\"dim\"> mm</span></td><td>12</td><td class=\"differs\">10</td><td class=\"differs\">10</td>"),
        "{table}"
    );
    let lines = report(&project, "report.md");
    assert!(lines.contains("## Variants\n") && lines.contains("| Entries | Pitch | mm | 12 | 10 | 10 |"), "{lines}");
    // A page has room for four variants beside the offer.
    ["C", "D", "E"].iter().for_each(|name| assert!(project.keep_variant(name).is_some()));
    assert_eq!(report(&project, "report.html").matches("<th>Offer</th>").count(), 2);
    project.variants.clear();
    assert!(!report(&project, "report.html").contains("compared\""));
    assert!(!report(&project, "report.md").contains("Variants"));
}

#[test]
fn rows_common_to_both_machines_come_first() {
    let named = |machine: &str| (machine.to_owned(), Project::of(machine, None).unwrap());
    let compared = macroline::project::variants::compare(&[named("turning-spindle"), named("polygon-lathe")]);
    for (title, rows) in compared.differences() {
        let alone: Vec<bool> = rows.iter().map(|row| row.cells.contains(&None)).collect();
        assert!(alone.is_sorted(), "{title}: {alone:?}");
        assert!(title != "variants.entries" || (!alone[0] && alone[alone.len() - 1]), "{title}: {alone:?}");
    }
}
