//! The functions of the package: the same answers as the command line, and an answer to any text.

use macroline::project::Project;
use macroline::project::package::{StepAnswers, answer};
use proptest::prelude::*;
use serde_json::{Value as Json, json};

use crate::command::macroline;

/// Functions of the package, and an unknown one.
const ASKS: [&str; 9] = ["list", "new", "design", "size", "export", "check", "run", "interpret", "other"];

fn answered(ask: &str, request: &Json) -> Json {
    serde_json::from_str(&answer(ask, &request.to_string())).unwrap()
}

/// JSON output of the command line.
fn printed(arguments: &[&str]) -> Json {
    let output = macroline().args(arguments).output().unwrap();
    serde_json::from_slice(&output.stdout).unwrap()
}

fn project() -> Json {
    serde_json::from_str(&Project::of("ribbon-line", None).unwrap().to_json()).unwrap()
}

/// A program that stops, alarms and calls.
const PROGRAM: &str = "O1\n#100=2\nM98P2\nM00\nG01X[#100]F100\n#3000=1(OUCH)\nM30\nO2\n#100=#100*2\nM99\n";

fn programs() -> Json {
    json!({ "control": "mitsubishi-e60", "files": [{ "name": "O1.nc", "text": PROGRAM }] })
}

#[test]
fn package_answers_as_the_command_line_prints() {
    let folder = std::env::temp_dir().join(format!("macroline-package-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let (file, bare) = (folder.join("project.json"), folder.join("O1.nc"));
    std::fs::write(&file, Project::of("ribbon-line", None).unwrap().to_json()).unwrap();
    std::fs::write(&bare, PROGRAM).unwrap();
    let (file, bare) = (file.to_str().unwrap(), bare.to_str().unwrap());
    assert_eq!(answered("list", &json!({})), printed(&["list", "--json"]));
    assert_eq!(answered("new", &json!({ "machine": "ribbon-line" })), printed(&["new", "ribbon-line"]));
    let request = json!({ "project": project() });
    assert_eq!(answered("design", &request), printed(&["design", file, "--json"]));
    let drawn = json!({ "project": project(), "draws": 3, "seed": 2 });
    assert_eq!(answered("size", &drawn), printed(&["size", file, "--json", "--draws", "3", "--seed", "2"]));
    let request = json!({ "subject": programs(), "choices": { "silence": ["lint.no-point"] } });
    let arguments = ["check", bare, "--control", "mitsubishi-e60", "--silence", "lint.no-point", "--json"];
    assert_eq!(answered("check", &request)["diagnostics"], printed(&arguments)["diagnostics"]);
    let request = json!({ "subject": programs(), "continue": true, "set": { "#101": 3 } });
    let arguments = ["run", bare, "--control", "mitsubishi-e60", "--continue", "--set", "#101=3", "--json"];
    assert_eq!(answered("run", &request), printed(&arguments));
    std::fs::remove_dir_all(&folder).unwrap();
}

#[test]
fn export_has_the_files_of_the_command_line() {
    let folder = std::env::temp_dir().join(format!("macroline-package-export-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let file = folder.join("line.json");
    std::fs::write(&file, Project::of("ribbon-line", None).unwrap().to_json()).unwrap();
    let out = folder.join("out");
    assert!(macroline().arg("export").arg(&file).arg("--out").arg(&out).output().unwrap().status.success());
    let files = answered("export", &json!({ "project": project() }))["files"].as_array().unwrap().clone();
    assert_eq!(files.len(), std::fs::read_dir(&out).unwrap().count());
    for file in files {
        let written = std::fs::read_to_string(out.join(file["name"].as_str().unwrap())).unwrap();
        assert_eq!(file["text"].as_str().unwrap(), written);
    }
    std::fs::remove_dir_all(&folder).unwrap();
}

/// A session, its first stop, and the answers to commands.
fn stepped(commands: &[Json]) -> (Json, Vec<Json>) {
    let (steps, first) = StepAnswers::new(&json!({ "subject": programs() }).to_string());
    let mut steps = steps.unwrap();
    let answers = commands.iter().map(|command| serde_json::from_str(&steps.answer(&command.to_string())).unwrap());
    (serde_json::from_str(&first).unwrap(), answers.collect())
}

#[test]
fn session_stops_at_breakpoints_and_waits() {
    let (first, answers) = stepped(&[
        json!({ "watch": "#100" }),
        json!({ "break": { "place": "O1.nc:9", "condition": "#100 GT 1" } }),
        json!("continue"),
        json!("out"),
        json!("continue"),
        json!("start"),
        json!("continue"),
        json!("variables"),
    ]);
    assert_eq!((&first["stop"], &first["block"]["line"]), (&json!("block"), &json!(2)));
    let stops: Vec<_> = answers.iter().map(|stop| (stop["stop"].as_str(), stop["block"]["line"].as_u64())).collect();
    let seen = [
        (Some("breakpoint"), Some(9)),
        (Some("block"), Some(4)),
        (Some("stop"), Some(4)),
        (Some("block"), Some(5)),
        (Some("alarm"), Some(6)),
    ];
    assert_eq!(stops[2..7], seen);
    assert_eq!(answers[2]["stack"][0]["entered"], "subprogram");
    assert_eq!(answers[2]["watches"][0]["value"], 2.0);
    assert_eq!(answers[3]["changes"][0], json!({ "name": "#100", "before": 2.0, "after": 4.0 }));
    assert!(answers[6]["diagnostics"][0]["message"].as_str().unwrap().contains("OUCH"));
    assert_eq!(answers[7]["variables"]["#100"], 4.0);
}

#[test]
fn wrong_commands_of_a_session_are_sentences() {
    let (_, answers) = stepped(&[
        json!({ "to": "N99" }),
        json!("back"),
        json!({ "watch": "[#1" }),
        json!({ "break": { "place": "3", "condition": "#1 +" } }),
        json!({ "evaluate": "" }),
        json!({ "set": { "name": "#99999", "value": 1 } }),
        json!({ "fly": 1 }),
        json!(5),
    ]);
    for answer in answers {
        assert!(answer["error"].as_str().is_some_and(|error| error.len() > 5), "{answer}");
        assert!(answer["diagnostics"].is_array());
    }
}

#[test]
fn wrong_arguments_are_sentences_and_never_a_panic() {
    let deep = "[".repeat(100_000);
    let texts = ["", "null", "5", "[]", "{", "{}", r#"{"subject":{"files":5}}"#, r#"{"project":null}"#, &deep];
    for ask in ASKS {
        for text in texts {
            let answer: Json = serde_json::from_str(&answer(ask, text)).unwrap();
            let is_answered = ask == "list" && text == "{}";
            assert_eq!(answer["error"].is_string(), !is_answered, "{ask} {text:.20}: {answer:.100}");
        }
    }
    let wrong = [
        json!({ "subject": programs(), "seconds": -1 }),
        json!({ "subject": programs(), "start": "O7777777777" }),
        json!({ "subject": programs(), "set": { "#9999999": 1 } }),
        json!({ "subject": programs(), "set": { "": 1 } }),
        json!({ "subject": programs(), "plant": {} }),
        json!({ "subject": programs(), "choices": { "switches": { "modulo": "x" } } }),
        json!({ "subject": programs(), "choices": { "silence": ["lint.none"] } }),
        json!({ "subject": { "control": "x", "files": [] } }),
    ];
    for request in wrong {
        assert!(answered("run", &request)["error"].is_string(), "{request}");
    }
    let at = |positions: Json| answered("interpret", &json!({ "subject": programs(), "positions": positions }));
    assert!(at(json!({ "Q": 1 }))["error"].is_string());
    assert!(at(json!({ "XY": 1 }))["error"].is_string());
    assert_eq!(at(json!({ "X": 1 }))["ended"], "alarm");
}

#[test]
fn panel_errors_are_reported_with_the_run() {
    let request = json!({ "subject": programs(), "panel": [{ "t": 0, "fly": true }] });
    let found = &answered("run", &request)["diagnostics"][0];
    assert_eq!((&found["severity"], &found["file"]), (&json!("error"), &json!("panel.json")));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn any_text_gets_an_answer(ask in prop::sample::select(&ASKS[..]), text in ".{0,200}") {
        prop_assert!(serde_json::from_str::<Json>(&answer(ask, &text)).is_ok());
    }

    #[test]
    fn any_program_gets_an_answer(text in "[GMXYZ#O0-9\\[\\]=+.\n -]{0,200}", ask in prop::sample::select(&ASKS[5..8])) {
        let files = json!([{ "name": "a.nc", "text": text }]);
        let subject = json!({ "control": "fanuc-0i-tf", "files": files });
        let answer = answered(ask, &json!({ "subject": subject, "choices": {} }));
        prop_assert!(answer["diagnostics"].is_array());
    }
}
