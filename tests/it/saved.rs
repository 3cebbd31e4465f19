//! Project files: what is saved comes back, and what comes in is hostile until checked.

use expect_test::{Expect, expect};
use macroline::machines::form::Value;
use macroline::motion::{Action, Event, Panel};
use macroline::nc::Files;
use macroline::project::render::Teller;
use macroline::project::{Project, saved};
use proptest::prelude::*;

fn ribbon() -> Project {
    Project::of("ribbon-line", None).unwrap()
}

/// What is said of a file, one line each.
#[track_caller]
fn check(text: &str, expect: Expect) {
    let loaded = Project::from_json(text);
    let files = Files::default();
    let teller = Teller::new(&files);
    let mut out: String = loaded.diagnostics.iter().map(|d| teller.text(d)).collect();
    out += if loaded.project.is_some() { "a project" } else { "no project" };
    expect.assert_eq(&out);
}

#[test]
fn a_project_comes_back_as_it_was_saved() {
    let mut project = ribbon();
    project.name = "Customer 4711".to_owned();
    project.values.insert("pitch".to_owned(), Value::Number(12.5));
    project.panel = Panel::new([
        Event { t: 2.5, action: Action::SpindleOverride(80.0) },
        Event { t: 3.0, action: Action::Input("#1033".to_owned(), 70.0) },
        Event { t: 4.0, action: Action::Variable(107, Some(9.5)) },
        Event { t: 5.0, action: Action::Reset },
    ]);
    project.edited = Some(Files::one("O1.nc", "%\nO1\nM30\n%\n"));
    let loaded = Project::from_json(&project.to_json());
    assert!(loaded.diagnostics.is_empty(), "{:?}", loaded.diagnostics);
    assert!(loaded.project.unwrap() == project);
}

#[test]
fn a_file_that_is_no_project_says_so() {
    check(
        "",
        expect![[r#"
            error: Line 1, column 0: this is not JSON (it ends too early).
            no project"#]],
    );
    check(
        "[1, 2]",
        expect![[r#"
        error: This is not a macroline project.
        no project"#]],
    );
    check(
        r#"{ "version": 99 }"#,
        expect![[r#"
        error: The file has version 99; this macroline reads up to version 1. Take a newer macroline.
        no project"#]],
    );
    check(
        r#"{ "machine": "ribbon-line" }"#,
        expect![[r#"
        error: The file has no version of a macroline project.
        no project"#]],
    );
    check(
        r#"{ "version": 1, "machine": "loom" }"#,
        expect![[r#"
            error: The file names no machine that is known. Possible: ribbon-line, turning-spindle, polygon-lathe.
            no project"#]],
    );
    check(
        r#"{ "version": 1, "machine": "ribbon-line", "control": "abacus" }"#,
        expect![[r#"
            error: The file names no control that this machine goes with. Possible: mitsubishi-e60, gsk-980tdc, sinumerik-802d, knd-k2000t.
            no project"#]],
    );
}

#[test]
fn what_does_not_fit_is_named_and_the_rest_is_kept() {
    check(
        r#"{ "version": 1, "machine": "ribbon-line", "control": "mitsubishi-e60",
             "values": { "pitch": "wide", "colour": 3, "heads": 4 }, "switches": { "moon": "full" },
             "panel": [ { "spindle_override": 80 }, { "t": 1, "dance": true } ] }"#,
        expect![[r#"
            error: Field “pitch”: text is not what belongs there; the default is taken.
             --> field pitch
            warning[project.unknown-field]: The machine has no field “colour”; it was left out.
            warning[project.unknown-switch]: The control has no switch “moon” with this setting; it was left out.
            error: Panel entry 1 has no time: { "t": seconds, … } with 0 or more seconds.
            error: Panel entry 2: “dance” is no action of the panel, or its value does not fit.
            a project"#]],
    );
}

#[test]
fn a_value_out_of_range_stays_and_the_field_says_what_is_allowed() {
    let mut project = ribbon();
    project.values.insert("pitch".to_owned(), Value::Number(-8.0));
    let back = Project::from_json(&project.to_json()).project.unwrap();
    assert_eq!(back.values.get("pitch"), Some(&Value::Number(-8.0)));
    let design = back.design();
    assert!(design.diagnostics.iter().any(|d| d.field == Some("pitch") && d.message.id == "form.too-small"));
}

#[test]
fn a_hostile_name_of_a_program_stays_in_the_folder() {
    for (name, bare) in [
        ("../../evil.nc", "evil.nc"),
        ("/etc/passwd", "passwd"),
        ("C:\\x\\O1.nc", "O1.nc"),
        ("..", "program.nc"),
        ("", "program.nc"),
    ] {
        let edited = serde_json::json!([{ "name": name, "text": "%\nO1\nM30\n%\n" }]);
        let mut json: serde_json::Value = serde_json::from_str(&ribbon().to_json()).unwrap();
        json["edited"] = edited;
        let project = Project::from_json(&json.to_string()).project.unwrap();
        assert_eq!(project.export().files[0].name, bare);
    }
}

#[test]
fn the_first_shape_of_a_file_is_read_for_ever() {
    let text = include_str!("../data/saved/v1.json");
    let loaded = Project::from_json(text);
    assert!(loaded.diagnostics.is_empty(), "{:?}", loaded.diagnostics);
    let written: serde_json::Value = serde_json::from_str(&loaded.project.unwrap().to_json()).unwrap();
    let first: serde_json::Value = serde_json::from_str(text).unwrap();
    for (id, value) in first["values"].as_object().unwrap() {
        assert_eq!(&written["values"][id], value, "{id}");
    }
}

proptest! {
    #[test]
    fn what_is_not_json_is_refused_and_nothing_else(text in r#"([\[\]{}",:.\\+\-]|[0-9]{1,3}|e|E|true|null|"[a-c]?"|\\u[dD][89abcdEF]0[0-9]|\\[nx/]|[ \n\t]|é){0,12}"#) {
        for text in [text.clone(), format!("[\"{text}\"]"), format!("[{text}]"), format!("{{\"a\":{text}}}")] {
            let loaded = Project::from_json(&text);
            let refused = loaded.diagnostics.iter().any(|d| d.message.id == "project.not-json");
            prop_assert_eq!(refused, serde_json::from_str::<serde_json::Value>(&text).is_err(), "{}", text);
        }
    }

    #[test]
    fn every_number_comes_back_to_the_bit(value in any::<f64>().prop_filter("numbers", |value| value.is_finite())) {
        let mut project = ribbon();
        project.values.insert("pitch".to_owned(), Value::Number(value));
        let back = Project::from_json(&project.to_json()).project.unwrap();
        prop_assert_eq!(back.values.get("pitch"), Some(&Value::Number(value)));
    }

    #[test]
    fn any_bytes_give_an_answer(bytes in proptest::collection::vec(any::<u8>(), 0..400)) {
        let text = String::from_utf8_lossy(&bytes);
        let loaded = Project::from_json(&text);
        prop_assert!(loaded.project.is_some() || !loaded.diagnostics.is_empty());
        let _ = saved::panel_from_json(&text);
    }

    #[test]
    fn a_cut_or_changed_project_gives_an_answer(at in 0usize..4000, byte in 0x20u8..0x7f) {
        let mut text = ribbon().to_json().into_bytes();
        let at = at % text.len();
        text[at] = byte;
        let changed = String::from_utf8_lossy(&text).into_owned();
        let loaded = Project::from_json(&changed);
        prop_assert!(loaded.project.is_some() || !loaded.diagnostics.is_empty());
    }
}
