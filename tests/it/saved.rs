//! Project files: saved projects read back equal, and hostile input gets findings with their place.

use expect_test::{Expect, expect};
use macroline::machines::form::{Provenance, Value};
use macroline::motion::{Action, Event, Panel};
use macroline::nc::{File, Files};
use macroline::project::findings::render::Renderer;
use macroline::project::import::FileKind;
use macroline::project::saved::{MAX_PROGRAM, panel_from_json, steps_from_json, steps_to_json};
use macroline::project::{Project, import};
use macroline::text::Severity;
use macroline::text::catalog::{Language, sentence, speak};
use proptest::prelude::*;

fn ribbon() -> Project {
    Project::of("ribbon-line", None).unwrap()
}

/// Findings about a file, one line each.
#[track_caller]
fn check(text: &str, expect: Expect) {
    let loaded = Project::from_json(text);
    let files = Files::one("project.json", text);
    let renderer = Renderer::new(&files);
    let mut out: String = loaded.diagnostics.iter().map(|d| renderer.text(d)).collect();
    out += if loaded.project.is_some() { "a project" } else { "no project" };
    expect.assert_eq(&out);
}

#[test]
fn saved_project_reads_back_equal() {
    let mut project = ribbon();
    project.name = "Customer 4711".to_owned();
    project.values.insert("pitch".to_owned(), Value::Number(12.5));
    project.panel = Panel::new([
        Event { t: 2.5, action: Action::SpindleOverride(80.0) },
        Event { t: 3.0, action: Action::Input("#1033".into(), 70.0) },
        Event { t: 4.0, action: Action::Variable(107, Some(9.5)) },
        Event { t: 5.0, action: Action::Reset },
        Event { t: 6.0, action: Action::InverterFault(true) },
        Event { t: 7.0, action: Action::InverterFault(false) },
        Event { t: 8.0, action: Action::ProgramZeroReturn },
    ]);
    project.edited = Some(Files::one("O1.nc", "%\nO1\nM30\n%\n"));
    let loaded = Project::from_json(&project.to_json());
    assert!(loaded.diagnostics.is_empty(), "{:?}", loaded.diagnostics);
    assert!(loaded.project.unwrap() == project);
}

#[test]
fn file_that_is_no_project_is_an_error() {
    check(
        "",
        expect![[r#"
            error: This is not JSON: the text ends where a value belongs.
             --> project.json:1:1
              |
            1 | 
              | ^
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
            error: This is no macroline project: open the JSON file that Save writes.
            no project"#]],
    );
    check(
        r#"{ "version": 1, "machine": "loom" }"#,
        expect![[r#"
        error: The file names no machine that is known. Possible: ribbon-line, turning-spindle, polygon-lathe.
         --> project.json:1:28
          |
        1 | { "version": 1, "machine": "loom" }
          |                            ^^^^^^
        no project"#]],
    );
    check(
        r#"{ "version": 1, "machine": "ribbon-line", "control": "abacus" }"#,
        expect![[r#"
            error: The file names no control that this machine goes with. Possible: mitsubishi-e60, gsk-980tdc, sinumerik-802d, sinumerik-808d, knd-k2000t, fanuc-0i-tf, fanuc-0i-mf.
             --> project.json:1:54
              |
            1 | { "version": 1, "machine": "ribbon-line", "control": "abacus" }
              |                                                      ^^^^^^^^
            no project"#]],
    );
}

/// A project file of the ribbon line with these lines after its first members.
fn with(lines: &str) -> String {
    format!("{{\n  \"version\": 1,\n  \"machine\": \"ribbon-line\",\n  \"control\": \"mitsubishi-e60\",\n{lines}\n}}\n")
}

#[test]
fn wrong_shapes_are_errors_at_their_place() {
    check(
        &with("  \"values\": [ 1, 2 ]"),
        expect![[r#"
            error: This does not have the shape of a project file: a list in place of an object { "id": value, … }.
             --> project.json:5:12
              |
            5 |   "values": [ 1, 2 ]
              |            ^
            no project"#]],
    );
    check(
        &with("  \"name\": \"no values\""),
        expect![[r#"
        error: The file has no values of the form: the key “values” is missing.
        no project"#]],
    );
    check(
        &with("  \"values\": {},\n  \"valuess\": {}"),
        expect![[r#"
            error: This does not have the shape of a project file: “valuess” is none of version, name, title_block, machine, control, values, provenance, switches, comments, silenced, panel, edited, parts, variants.
             --> project.json:6:11
              |
            6 |   "valuess": {}
              |           ^
            no project"#]],
    );
    check(
        &with("  \"values\": {},\n  \"values\": {}"),
        expect![[r#"
            error: This does not have the shape of a project file: the key “values” is here a second time.
             --> project.json:6:10
              |
            6 |   "values": {}
              |          ^
            no project"#]],
    );
    check(
        &with("  \"values\": {},\n  \"edited\": [ { \"name\": \"O1\", \"code\": \"M30\" } ]"),
        expect![[r#"
            error: This does not have the shape of a project file: “code” is none of name, text.
             --> project.json:6:36
              |
            6 |   "edited": [ { "name": "O1", "code": "M30" } ]
              |                                    ^
            no project"#]],
    );
    check(
        &with("  \"values\": {}\n  \"name\": \"\""),
        expect![[r#"
        error: This is not JSON: expected `,` or `}`.
         --> project.json:6:3
          |
        6 |   "name": ""
          |   ^
        no project"#]],
    );
}

#[test]
fn reasons_are_in_the_chosen_language() {
    let project = |lines: &str| with(&format!("  \"values\": {{}}{lines}"));
    let texts = [
        "{ no".to_owned(),
        "{ \"a\" 1".to_owned(),
        "[".to_owned(),
        "{ \"a".to_owned(),
        "{ \"a\": \"\\q\" }".to_owned(),
        "{ \"a\": \"\n\" }".to_owned(),
        "{ \"a\": 1, }".to_owned(),
        "{} {}".to_owned(),
        "{ \"a\": 01 }".to_owned(),
        "{ \"a\": 1e999 }".to_owned(),
        "{ \"a\": tru }".to_owned(),
        "[".repeat(200),
        project(",\n  \"values\": {}"),
        project(",\n  \"colour\": {}"),
        project(",\n  \"edited\": [ { \"name\": \"O1\" } ]"),
        project(",\n  \"edited\": {}"),
        project(",\n  \"title_block\": 7"),
        project(",\n  \"variants\": [ { \"name\": \"A\", \"control\": \"x\", \"values\": 3 } ]"),
    ];
    speak(Language::Chinese.sentences());
    let sentences: Vec<String> = texts
        .iter()
        .flat_map(|text| Project::from_json(text).diagnostics)
        .map(|found| sentence(&found.message))
        .collect();
    speak(Language::English.sentences());
    assert_eq!(sentences.len(), texts.len(), "{sentences:#?}");
    let is_english = |text: &str| text.len() > 2 && text.chars().all(|c| c.is_ascii_alphabetic());
    for text in sentences {
        let words: Vec<bool> = text.split(' ').map(is_english).collect();
        assert!(!words.windows(2).any(|pair| pair[0] && pair[1]), "{text}");
    }
}

#[test]
fn repeated_keys_are_errors_at_their_place() {
    check(
        &with(
            "  \"values\": { \"pitch\": 8, \"pitch\": 9 },\n  \"switches\": {\n    \"decimal-point\": \"millimetres\",\n    \
             \"decimal-point\": \"increments\"\n  },\n  \"panel\": [ { \"t\": 0, \"t\": 1, \"input\": { \"R74\": 1, \"R74\": 2 } } ]",
        ),
        expect![[r#"
            error: “pitch” is here a second time.
             --> project.json:5:27
              |
            5 |   "values": { "pitch": 8, "pitch": 9 },
              |                           ^^^^^^^
            error: “decimal-point” is here a second time.
             --> project.json:8:5
              |
            8 |     "decimal-point": "increments"
              |     ^^^^^^^^^^^^^^^
            error: “t” is here a second time.
              --> project.json:10:24
               |
            10 |   "panel": [ { "t": 0, "t": 1, "input": { "R74": 1, "R74": 2 } } ]
               |                        ^^^
            error: “R74” is here a second time.
              --> project.json:10:53
               |
            10 |   "panel": [ { "t": 0, "t": 1, "input": { "R74": 1, "R74": 2 } } ]
               |                                                     ^^^^^
            a project"#]],
    );
}

#[test]
fn unknown_values_are_named_and_the_rest_is_kept() {
    check(
        r#"{ "version": 1, "machine": "ribbon-line", "control": "mitsubishi-e60",
             "values": { "pitch": "wide", "colour": 3, "heads": 4 }, "provenance": { "pitch": "guessed" },
             "switches": { "moon": "full", "decimal-point": "none" },
             "panel": [ { "spindle_override": 80 }, { "t": 1, "dance": true } ] }"#,
        expect![[r#"
            error: Field “pitch”: text is not what belongs there; the default is taken.
             --> project.json:2:35
              |
            2 |              "values": { "pitch": "wide", "colour": 3, "heads": 4 }, "provenance": { "pitch": "guessed" },
              |                                   ^^^^^^
            error: The machine has no field “colour”; it was left out.
             --> project.json:2:43
              |
            2 |              "values": { "pitch": "wide", "colour": 3, "heads": 4 }, "provenance": { "pitch": "guessed" },
              |                                           ^^^^^^^^
            error: Field “pitch”: this is no origin of a value. Possible: measured, data-sheet, assumed.
             --> project.json:2:95
              |
            2 |              "values": { "pitch": "wide", "colour": 3, "heads": 4 }, "provenance": { "pitch": "guessed" },
              |                                                                                               ^^^^^^^^^
            error: The control has no switch “moon” with this setting; its default is taken.
             --> project.json:3:28
              |
            3 |              "switches": { "moon": "full", "decimal-point": "none" },
              |                            ^^^^^^
            error: The control has no switch “decimal-point” with this setting; its default is taken.
             --> project.json:3:61
              |
            3 |              "switches": { "moon": "full", "decimal-point": "none" },
              |                                                             ^^^^^^
            error: Panel entry 1 has no time: { "t": seconds, … } with 0 or more seconds.
             --> project.json:4:27
              |
            4 |              "panel": [ { "spindle_override": 80 }, { "t": 1, "dance": true } ] }
              |                           ^^^^^^^^^^^^^^^^^^
            error: Panel entry 2: “dance” is no action of the panel, or its value does not fit.
             --> project.json:4:63
              |
            4 |              "panel": [ { "spindle_override": 80 }, { "t": 1, "dance": true } ] }
              |                                                               ^^^^^^^
            a project"#]],
    );
}

#[test]
fn projects_over_the_limits_are_refused() {
    let program = r#"{ "name": "O1.nc", "text": "M30" }"#;
    for (count, taken) in [(64, true), (65, false)] {
        let text = with(&format!("\"values\": {{}}, \"edited\": [{}]", vec![program; count].join(",")));
        let loaded = Project::from_json(&text);
        assert_eq!(loaded.project.is_some(), taken, "{count} programs");
        let files = vec![File { name: "O1.nc".to_owned(), text: "M30\n".to_owned() }; count];
        assert_eq!(import::programs(&files).is_ok(), taken, "{count} programs");
    }
    let large = File { name: "O1.nc".to_owned(), text: "G".repeat(MAX_PROGRAM / 2 + 1) };
    assert!(
        import::programs(std::slice::from_ref(&large)).is_ok() && import::programs(&[large.clone(), large]).is_err()
    );
    for (count, taken) in [(100_000, true), (100_001, false)] {
        let text = format!("[{}]", vec![r#"{"t":1,"start":true}"#; count].join(","));
        let (panel, found) = panel_from_json(&text);
        assert_eq!((panel.events().len(), found.is_empty()), (if taken { count } else { 0 }, taken));
    }
    // The largest program of the most bytes a JSON text has for each is read again.
    let mut project = ribbon();
    project.edited = Some(Files::one("O1.nc", "\u{1}".repeat(MAX_PROGRAM)));
    assert!(Project::from_json(&project.to_json()).project.is_some_and(|back| back == project));
}

#[test]
fn first_100_findings_are_listed_and_the_rest_counted() {
    let keys: Vec<String> = (0..100_000).map(|key| format!("\"key{key}\": 1")).collect();
    let loaded = Project::from_json(&with(&format!("\"values\": {{ {} }}", keys.join(", "))));
    assert_eq!(loaded.diagnostics.len(), 101);
    let last = loaded.diagnostics.last().unwrap();
    assert_eq!(sentence(&last.message), "99900 more findings about this file are not listed.");
    assert_eq!(last.severity, Severity::Error);
}

#[test]
fn byte_order_mark_is_skipped_and_places_hold() {
    let text = format!("\u{feff}{}", with("  \"values\": { \"colour\": 3 }"));
    let loaded = Project::from_json(&text);
    assert!(loaded.project.is_some());
    assert_eq!(loaded.diagnostics[0].place.unwrap().span.of(&text), "\"colour\"");
    let broken = "\u{feff}{ \"version\": 1,, }";
    let finding = &Project::from_json(broken).diagnostics[0];
    assert_eq!(finding.place.unwrap().span.start as usize, broken.rfind(',').unwrap());
}

#[test]
fn saved_numbers_are_written_as_people_write_them() {
    let mut project = ribbon();
    for (value, text) in [
        (8.0, "8"),
        (-12.5, "-12.5"),
        (0.1 + 0.2, "0.30000000000000004"),
        (5e-324, "5e-324"),
        (9_007_199_254_740_991.0, "9007199254740991"),
        (f64::MAX, "1.7976931348623157e+308"),
        (f64::NAN, "null"),
    ] {
        project.values.insert("pitch".to_owned(), Value::Number(value));
        let json = project.to_json();
        let line = json.lines().find(|line| line.contains("\"pitch\"")).unwrap();
        assert_eq!(line.trim(), format!("\"pitch\": {text},"));
    }
}

#[test]
fn value_out_of_range_is_kept_with_an_error() {
    let mut project = ribbon();
    project.values.insert("pitch".to_owned(), Value::Number(-8.0));
    let back = Project::from_json(&project.to_json()).project.unwrap();
    assert_eq!(back.values.get("pitch"), Some(&Value::Number(-8.0)));
    let design = back.design();
    assert!(design.diagnostics.iter().any(|d| d.field == Some("pitch") && d.message.id == "form.too-small"));
}

#[test]
fn hostile_program_name_stays_in_the_folder() {
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
        assert_eq!(project.export().into_files()[0].name, bare);
    }
}

#[test]
fn version_1_project_file_still_reads() {
    let text = include_str!("../data/saved/v1.json");
    let loaded = Project::from_json(text);
    assert!(loaded.diagnostics.is_empty(), "{:?}", loaded.diagnostics);
    let written: serde_json::Value = serde_json::from_str(&loaded.project.unwrap().to_json()).unwrap();
    let first: serde_json::Value = serde_json::from_str(text).unwrap();
    for (id, value) in first["values"].as_object().unwrap() {
        // A field of the first files has become one of each axis.
        let ids = match id.as_str() {
            "encoder-resolution" => vec!["encoder-resolution-x", "encoder-resolution-y"],
            same => vec![same],
        };
        for id in ids {
            assert_eq!(&written["values"][id], value, "{id}");
        }
    }
}

/// Lathes had one field for the encoders of all axes.
#[test]
fn old_field_becomes_those_that_the_machine_has() {
    for (machine, axes) in [("turning-spindle", &["x", "z"][..]), ("polygon-lathe", &["x", "z", "work", "tool"])] {
        let mut file: serde_json::Value = serde_json::from_str(&Project::of(machine, None).unwrap().to_json()).unwrap();
        for part in ["values", "provenance"] {
            if let Some(members) = file[part].as_object_mut() {
                members.retain(|id, _| !id.starts_with("encoder-counts"));
            }
        }
        file["values"]["encoder-counts"] = 4096.into();
        file["provenance"]["encoder-counts"] = "measured".into();
        let loaded = Project::from_json(&file.to_string());
        assert!(loaded.diagnostics.is_empty(), "{:?}", loaded.diagnostics);
        let project = loaded.project.unwrap();
        let counts = |map: Vec<&String>| map.into_iter().filter(|id| id.starts_with("encoder-counts")).count();
        assert_eq!(counts(project.values.keys().collect()), axes.len());
        for axis in axes {
            let id = format!("encoder-counts-{axis}");
            assert_eq!(project.values[&id], Value::Number(4096.0), "{id}");
            assert_eq!(project.provenance[&id], Provenance::Measured, "{id}");
        }
    }
}

proptest! {
    #[test]
    fn only_invalid_json_is_refused_as_json(text in r#"([\[\]{}",:.\\+\-]|[0-9]{1,3}|e|E|true|null|"[a-c]?"|\\u[dD][89abcdEF]0[0-9]|\\[nx/]|[ \n\t]|é){0,12}"#) {
        // Half of a surrogate pair and numbers beyond every double are JSON.
        let is_json = |text: &str| serde_json::from_str::<serde::de::IgnoredAny>(text).is_ok();
        for text in [text.clone(), format!("{{\"a\":\"{text}\"}}"), format!("{{\"a\":{text}}}")] {
            let loaded = Project::from_json(&text);
            let refused = loaded.diagnostics.iter().any(|d| d.message.id == "project.not-json");
            prop_assert!(loaded.project.is_none());
            prop_assert_eq!(refused, !is_json(&text), "{}", text);
        }
    }

    #[test]
    fn saved_numbers_read_back_to_the_bit(value in any::<f64>().prop_filter("numbers", |value| value.is_finite())) {
        let mut project = ribbon();
        project.values.insert("pitch".to_owned(), Value::Number(value));
        let back = Project::from_json(&project.to_json()).project.unwrap();
        prop_assert_eq!(back.values.get("pitch"), Some(&Value::Number(value)));
    }

    #[test]
    fn any_bytes_as_project_give_an_answer(bytes in proptest::collection::vec(any::<u8>(), 0..400)) {
        let text = String::from_utf8_lossy(&bytes);
        let loaded = Project::from_json(&text);
        prop_assert!(loaded.project.is_some() || !loaded.diagnostics.is_empty());
        let _ = panel_from_json(&text);
    }

    #[test]
    fn damaged_project_gives_an_answer(at in 0usize..4000, byte in 0x20u8..0x7f) {
        let mut text = ribbon().to_json().into_bytes();
        let at = at % text.len();
        text[at] = byte;
        let changed = String::from_utf8_lossy(&text).into_owned();
        let loaded = Project::from_json(&changed);
        prop_assert!(loaded.project.is_some() || !loaded.diagnostics.is_empty());
    }
}

#[test]
fn old_sentences_of_settings_are_upgraded() {
    use macroline::controls::ALL;
    // Copied on purpose: a change of the table in the code must not change what old files mean.
    // Switch, the sentence of files up to November 2026, the id of the option.
    let old = [
        ("angle-range", "ATAN -180 to 180, ASIN -90 to 90", "atan-minus-180-to-180-asin-minus-90-to-90"),
        ("angle-range", "ATAN -180 to 180, ASIN 90 to 270", "atan-minus-180-to-180-asin-90-to-270"),
        ("angle-range", "ATAN 0 to 360, ASIN -90 to 90", "atan-0-to-360-asin-minus-90-to-90"),
        ("angle-range", "ATAN 0 to 360, ASIN 270 to 90", "atan-0-to-360-asin-270-to-90"),
        ("argument-point", "as written", "as-written"),
        ("codes-g22-g23", "radius and diameter", "radius-and-diameter"),
        ("common-variables", "#100 to #149, #500 to #549", "100-sets"),
        ("common-variables", "#100 to #199, #500 to #599", "200-sets"),
        ("common-variables", "#100 to #199, #500 to #699", "300-sets"),
        ("common-variables", "#100 to #199, #500 to #999", "600-sets"),
        ("crossed-limits", "lower holds", "lower-holds"),
        ("crossed-limits", "upper holds", "upper-holds"),
        ("end-in-subprogram", "end the program", "end-program"),
        ("g9x-without-s", "last programmed", "last-programmed"),
        ("m-codes", "the last 3 act", "last-three-act"),
        ("m-codes", "the last acts", "last-acts"),
        ("m03-m04", "turns back", "turns-back"),
        ("offset-values", "as written", "as-written"),
        ("override-order", "before the limits", "before-limits"),
        ("override-order", "behind the limits", "behind-limits"),
        ("pmc-override", "acts not", "acts-not"),
        ("r-parameters", "R0 to R249", "250"),
        ("r-parameters", "R0 to R299", "300"),
        ("round-in-word", "to a whole number", "whole-number"),
        ("round-in-word", "to the step of the address", "address-step"),
        ("speed-limit-sets-zero", "reference point", "reference-point"),
        ("speed-limit-sets-zero", "work zero", "work-zero"),
        ("speed-reached", "do not wait", "no-wait"),
        ("spindle-knob", "0 to 200 %", "0-to-200"),
        ("spindle-knob", "50 to 120 %", "50-to-120"),
        ("thread-e", "threads per inch", "threads-per-inch"),
        ("word-formula", "as it is", "as-is"),
        ("word-formula", "in brackets", "in-brackets"),
        ("working-area", "limit not", "no-limit"),
    ];
    let mut offered = Vec::new();
    for (id, sentence, option) in old {
        for control in ALL {
            let Some(row) = control.switch(id).filter(|row| row.takes(option)) else { continue };
            let machine =
                macroline::machines::ALL.iter().find(|machine| machine.controls().contains(&control.id)).unwrap();
            let text = format!(
                r#"{{ "version": 1, "machine": "{}", "control": "{}", "values": {{}}, "switches": {{ "{id}": "{sentence}" }} }}"#,
                machine.id(),
                control.id,
            );
            let loaded = Project::from_json(&text);
            let project = loaded.project.unwrap_or_else(|| panic!("{text}"));
            assert_eq!(project.switches.setting(row), option, "{} {id}", control.id);
            assert!(
                !row.takes(sentence) && loaded.diagnostics.is_empty(),
                "{} {id}: {:?}",
                control.id,
                loaded.diagnostics
            );
            offered.push((id, option));
        }
    }
    // Every renamed option has its old sentence here.
    for (id, _, option) in old {
        assert!(offered.contains(&(id, option)), "no control offers {option} of {id}");
    }
}

#[test]
fn old_ids_of_suppressed_warnings_are_upgraded() {
    let old = [
        ("interp.other-spindle-stands", "interp.other-spindle-at-rest"),
        ("lint.slow-way-back", "lint.slow-retract"),
        ("motion.spindle-stands", "motion.spindle-at-rest"),
        ("motion.standing-work", "motion.feed-without-rotation"),
        ("nc.stands-alone", "nc.not-alone"),
    ];
    for (saved, present) in old {
        let text = format!(
            r#"{{ "version": 1, "machine": "ribbon-line", "control": "mitsubishi-e60", "values": {{}}, "silenced": ["{saved}", "lint.unreachable"] }}"#
        );
        let project = Project::from_json(&text).project.unwrap();
        assert_eq!(project.silenced, [present, "lint.unreachable"]);
        assert_eq!(macroline::text::catalog::id(present), Some(present));
    }
}

fn named(name: &str) -> Project {
    let mut project = ribbon();
    project.name = name.to_owned();
    project
}

#[test]
fn steps_of_undo_read_back_in_their_order() {
    let texts = ["a", "b", "c"].map(|name| named(name).to_json());
    let (past, future) = steps_from_json(&steps_to_json([("p1", &*texts[0]), ("", &texts[1])], [("p2", &*texts[2])]));
    assert!(past == [named("a"), named("b")] && future == [named("c")]);
    let ids = [&past[0], &past[1], &future[0]].map(|project| project.id.as_deref());
    assert_eq!(ids, [Some("p1"), None, Some("p2")]);
}

#[test]
fn undo_stops_at_a_step_that_does_not_read() {
    let texts = ["a", "b", "c"].map(|name| named(name).to_json());
    let (past, _) =
        steps_from_json(&steps_to_json([("", &*texts[0]), ("", "{"), ("", &texts[1]), ("", &texts[2])], []));
    assert!(past == [named("b"), named("c")]);
}

proptest! {
    #[test]
    fn any_text_gives_steps_or_none(text in any::<String>(), step in any::<String>()) {
        steps_from_json(&text);
        prop_assert!(steps_from_json(&steps_to_json([("", &*step)], [])).0.is_empty());
    }
}

fn file(name: &str, text: &str) -> File {
    File { name: name.to_owned(), text: text.to_owned() }
}

#[test]
fn kind_of_a_file_follows_its_text_behind_a_byte_order_mark() {
    // In one line, the columns of its own parts are in the first line of a project.
    let part = r#"{ "kind": "servo", "maker": "a", "model": "b" }"#;
    let project =
        format!(r#"{{ "version": 1, "machine": "ribbon-line", "control": "mitsubishi-e60", "parts": [{part}] }}"#);
    let list = format!("[ {part} ]");
    for (text, kind) in [
        (project.as_str(), FileKind::Project),
        (" \n{", FileKind::Project),
        (list.as_str(), FileKind::Parts),
        ("Maker;kind;model;power\n", FileKind::Parts),
        ("[\n{ \"t\": 1, \"hold\": true } ]", FileKind::Panel),
        ("[ ]", FileKind::Panel),
        ("", FileKind::Program),
        ("[", FileKind::Program),
        ("[1]", FileKind::Program),
        ("%\nO1\n", FileKind::Program),
        ("[MAIN]\n", FileKind::Program),
    ] {
        for text in [text.to_owned(), format!("\u{feff}{text}")] {
            assert_eq!(FileKind::of(&text), kind, "{text}");
        }
    }
}

#[test]
fn project_and_its_programs_open_together() {
    let order = named("Order 7");
    let mut files = order.written().files.0;
    files.push(file("order.json", &order.to_json()));
    let opened = import::open(&ribbon(), &files).project.unwrap();
    assert!(opened == order && opened.edited.is_none());
    files[1].text.push_str("(MINE)\n");
    let opened = import::open(&ribbon(), &files).project.unwrap();
    assert_eq!(opened.name, "Order 7");
    assert!(opened.edited.unwrap().0[1].text.ends_with("(MINE)\n"));
}

#[test]
fn export_opens_as_a_whole_without_its_documents() {
    for machine in macroline::machines::ALL {
        let order = Project::named(machine.id(), None, None).unwrap();
        let mut files = order.export().into_files();
        for project_file in [true, false] {
            files.retain(|file| project_file || !file.name.ends_with(".json"));
            let opened = import::open(&ribbon(), &files);
            let project = opened.project.unwrap();
            assert!(project.machine.id() == machine.id() && project.edited.is_none(), "{}", machine.id());
            assert!(opened.diagnostics.iter().any(|found| found.message_id() == "project.documents-left"));
        }
    }
}

#[test]
fn every_edited_program_of_an_export_is_taken() {
    let mut files = named("").written().files.0;
    files[2].text.push_str("(MINE)\n");
    let opened = import::open(&ribbon(), &files).project.unwrap();
    assert!(opened.edited.unwrap().0[2].text.ends_with("(MINE)\n"));
}

#[test]
fn files_that_do_not_go_together_are_all_refused() {
    let (json, program) = (file("a.json", &ribbon().to_json()), file("O1.nc", "M30\n"));
    for (files, reason) in [
        (vec![json.clone(), json.clone()], "project.several-projects"),
        (vec![program.clone(), file("b.json", "{")], "project.not-json"),
        (vec![program.clone(), file("a.png", "\0PNG")], "project.not-a-text"),
        (vec![json, file("O1.nc", &"G".repeat(MAX_PROGRAM + 1))], "project.program-too-large"),
        // A file of another kind replaces nothing.
        (vec![file("prog.exe", "MZ\0\0")], "project.not-a-text"),
        (vec![file("O1.nc", "\u{feff} \n")], "project.empty-file"),
        (vec![file("a.json", "null")], "project.no-project-file"),
        (vec![file("A.JSON", "[[[[")], "project.no-project-file"),
    ] {
        let opened = import::open(&ribbon(), &files);
        assert!(opened.project.is_none());
        assert_eq!(opened.diagnostics.iter().map(|found| found.message_id()).collect::<Vec<_>>(), [reason]);
    }
}

#[test]
fn archive_is_named_after_project_and_revision() {
    let mut project = ribbon();
    assert_eq!(project.archive_name(), "ribbon-line.zip");
    project.name = "Order 7 / Łódź".to_owned();
    assert_eq!(project.archive_name(), "order-7-łódź.zip");
    project.title_block.revision = "B.2".to_owned();
    assert_eq!(project.archive_name(), "order-7-łódź-revision-b-2.zip");
    (project.name, project.title_block.revision) = ("印带机".to_owned(), "第2版".to_owned());
    assert_eq!(
        (project.archive_name(), project.file_name("json")),
        ("印带机-revision-第2版.zip".to_owned(), "印带机.json".to_owned())
    );
}

#[test]
fn names_of_files_are_taken_by_every_file_system() {
    for (name, file) in [
        (r#"a\b/c:d*e?f"g<h>i|j"#, "a-b-c-d-e-f-g-h-i-j.json"),
        ("\u{202e}fdp.1\u{7}2\u{200f} ", "fdp-1-2.json"),
        (" ..印带机.. ", "印带机.json"),
        ("Cafe\u{301}", "cafe\u{301}.json"),
        ("...", "ribbon-line.json"),
        ("CON", "macroline-con.json"),
        ("nul.", "macroline-nul.json"),
        ("COM9", "macroline-com9.json"),
        ("LPT¹", "macroline-lpt¹.json"),
        ("Com10", "com10.json"),
        ("Console", "console.json"),
    ] {
        assert_eq!(ribbon().with_name(name).file_name("json"), file, "{name:?}");
    }
    for long in ["印带机".repeat(50), "é".repeat(200), format!("{} 印带机", "x".repeat(75)), "x ".repeat(200)] {
        let mut project = ribbon().with_name(long.clone());
        project.title_block.revision = long;
        for name in [project.archive_name(), project.file_name("panel.json")] {
            assert!((40..=120).contains(&name.len()) && !name.contains("-."), "{name}");
        }
    }
}
