//! The language server as an editor drives it: messages over standard input and output, and Neovim as a real client.

mod client;
mod neovim;

use client::{Client, address, folder};
use macroline::controls;
use serde_json::{Value as Json, json};

/// The texts of a list of proposals.
fn labels(found: &Json) -> Vec<&str> {
    found["items"].as_array().unwrap().iter().map(|item| item["label"].as_str().unwrap()).collect()
}

#[test]
fn bad_fixture_has_the_diagnostic_of_its_alarm() {
    for id in ["mitsubishi-e60", "gsk-980tdc", "sinumerik-802d"] {
        let mut client = Client::start(&["--control", id]);
        for name in ["unknown-code", "no-equals"] {
            let path = format!("{}/tests/data/programs/{id}/bad/{name}.nc", env!("CARGO_MANIFEST_DIR"));
            let text = std::fs::read_to_string(path).unwrap();
            let alarm = controls::find(id).unwrap().alarms.iter().find(|row| {
                text.lines().next().unwrap().split(|c: char| !c.is_ascii_alphanumeric()).any(|word| word == row.number)
            });
            let found = client.open(&format!("file:///{name}/A.nc"), &text);
            let alarm = alarm.unwrap_or_else(|| panic!("{id} {name}: no alarm in the first line")).number;
            let is = |row: &Json| row["code"] == alarm && row["severity"] == 1 && row["source"] == "macroline";
            assert!(found.as_array().unwrap().iter().any(is), "{id} {name}: {found}");
        }
        client.end();
    }
}

#[test]
fn quick_fix_makes_the_diagnostic_go() {
    let mut client = Client::start(&["--control", "mitsubishi-e60"]);
    let uri = "file:///shop/O1.nc";
    let found = client.open(uri, "O1\n(Ø 😀) IF[#100>1]GOTO10\nN10 M30\n%\n");
    let first = found.as_array().unwrap().iter().find(|row| row["severity"] == 1).unwrap().clone();
    let context = json!({ "diagnostics": [first], "only": ["quickfix"] });
    let params = json!({ "textDocument": { "uri": uri }, "range": first["range"], "context": context });
    let actions = client.ask("textDocument/codeAction", params);
    let fix = actions.as_array().unwrap().iter().find(|action| action["diagnostics"][0]["range"] == first["range"]);
    let fix = fix.unwrap_or_else(|| panic!("no fix among {actions}"));
    assert_eq!(fix["kind"], "quickfix");
    let edits = fix["edit"]["changes"][uri].as_array().unwrap();
    let changes: Vec<Json> =
        edits.iter().rev().map(|edit| json!({ "range": edit["range"], "text": edit["newText"] })).collect();
    let left = client.change(uri, &changes);
    assert!(
        !left.as_array().unwrap().iter().any(|row| row["range"] == first["range"] && row["severity"] == 1),
        "{left}"
    );
    client.end();
}

#[test]
fn all_certain_fixes_are_one_source_action() {
    let mut client = Client::start(&["--control", "mitsubishi-e60"]);
    let uri = "file:///shop/O1.nc";
    client.open(uri, "%\nO1\n#100=1;\nIF[#100>1]GOTO10\nN10 M30\n%\n");
    let range = json!({ "start": { "line": 0, "character": 0 }, "end": { "line": 0, "character": 0 } });
    let context = json!({ "diagnostics": [], "only": ["source"] });
    let params = json!({ "textDocument": { "uri": uri }, "range": range, "context": context });
    let actions = client.ask("textDocument/codeAction", params);
    let [action] = &actions.as_array().unwrap()[..] else { panic!("{actions}") };
    assert_eq!(action["kind"], "source.fixAll");
    assert!(action["edit"]["changes"][uri][0]["newText"].as_str().unwrap().contains("#100 GT 1"), "{action}");
    client.end();
}

#[test]
fn source_action_changes_its_own_file_alone() {
    let mut client = Client::start(&["--control", "fanuc-0i-mf"]);
    let (own, other) = ("file:///shop/O1.nc", "file:///shop/O2.nc");
    client.open(own, "%\nO1\nIF[1>0]GOTO10\nN10 M30\n%\n");
    client.open(other, "%\nO2\nIF[2>0]GOTO10\nN10 M99\n%\n");
    let range = json!({ "start": { "line": 0, "character": 0 }, "end": { "line": 0, "character": 0 } });
    let context = json!({ "diagnostics": [], "only": ["source.fixAll"] });
    let params = json!({ "textDocument": { "uri": own }, "range": range, "context": context });
    let actions = client.ask("textDocument/codeAction", params);
    let changes = actions[0]["edit"]["changes"].as_object().unwrap();
    assert_eq!(changes.keys().collect::<Vec<_>>(), [own], "{actions}");
    client.end();
}

#[test]
fn hover_has_meaning_and_source() {
    let mut client = Client::start(&["--control", "gsk-980tdc"]);
    let uri = "file:///shop/O1.nc";
    client.open(uri, "O0001\nG00 X50 Z2\nM30\n%\n");
    let found = client.at("textDocument/hover", uri, 1, 1);
    let row = controls::find("gsk-980tdc").unwrap().code(controls::CodeId::g(0)).unwrap();
    let text = found["contents"]["value"].as_str().unwrap();
    assert!(text.contains(row.text.english) && text.contains(row.cite.source.english), "{text}");
    assert_eq!(found["range"]["end"]["character"], 3);
    assert_eq!(client.at("textDocument/hover", uri, 1, 3), Json::Null);
    client.end();
}

#[test]
fn completion_replaces_the_typed_text() {
    let mut client = Client::start(&["--control", "mitsubishi-e60"]);
    let uri = "file:///shop/O1.nc";
    // The letters before the word take two units each.
    client.open(uri, "O1\n(😀)G01 X1 M\n#777=1\nX#7\nM30\n%\n");
    let found = client.at("textDocument/completion", uri, 1, 12);
    assert!(labels(&found).starts_with(&["M00", "M01"]), "{found}");
    let edit = &found["items"][0]["textEdit"];
    assert_eq!([&edit["range"]["start"]["character"], &edit["range"]["end"]["character"]], [11, 12]);
    assert_eq!(labels(&client.at("textDocument/completion", uri, 3, 3)), ["#777"]);
    client.end();
}

#[test]
fn proposed_program_replaces_all_digits_of_the_call() {
    let mut client = Client::start(&["--control", "mitsubishi-e60"]);
    let uri = "file:///shop/O1.nc";
    client.open(uri, "O1\nM98 P0012\nM30\nO123\nM99\n%\n");
    for cursor in [5, 8, 9] {
        let found = client.at("textDocument/completion", uri, 1, cursor);
        let item = found["items"].as_array().unwrap().iter().find(|item| item["label"] == "123").unwrap();
        // The client compares the filter with the text that it replaces.
        assert_eq!((&item["filterText"], &item["textEdit"]["newText"]), (&json!("00123"), &json!("123")));
        let range = &item["textEdit"]["range"];
        assert_eq!([&range["start"]["character"], &range["end"]["character"]], [5, 9]);
    }
    client.end();
}

/// The protocol ends a line at a CR alone, too; the control does not.
#[test]
fn edit_behind_a_lone_carriage_return_meets_its_line() {
    let mut client = Client::start(&["--control", "mitsubishi-e60"]);
    let uri = "file:///shop/O1.nc";
    let unknown = |found: &Json| -> Vec<Json> {
        let rows = found.as_array().unwrap().iter().filter(|row| row["code"] == "P34");
        rows.map(|row| row["range"]["start"].clone()).collect()
    };
    let found = client.open(uri, "O1\nM5\rM9\r\nG999\nM30\n%\n");
    assert_eq!(unknown(&found), [json!({ "line": 3, "character": 0 })], "{found}");
    let range = json!({ "start": { "line": 3, "character": 0 }, "end": { "line": 3, "character": 4 } });
    let left = client.change(uri, &[json!({ "range": range, "text": "M5" })]);
    assert!(unknown(&left).is_empty(), "{left}");
    client.end();
}

#[test]
fn definition_and_references_lead_to_other_open_files() {
    let mut client = Client::start(&["--control", "mitsubishi-e60"]);
    let [main, part, apart] = ["file:///shop/O1.nc", "file:///shop/O9100.nc", "file:///other/O9100.nc"];
    client.open(part, "O9100\n#100=#1\nM99\n%\n");
    client.open(apart, "O9100\nM99\n%\n");
    let found = client.open(main, "O1\n#100=1\nG65 P9100 A#100\nM30\n%\n");
    assert!(!found.to_string().contains("lint.no-such-program"), "{found}");
    let definition = client.at("textDocument/definition", main, 2, 6);
    assert_eq!((&definition["uri"], &definition["range"]["start"]["line"]), (&json!(part), &json!(0)));
    let mut params = client::position(main, 1, 2);
    params["context"] = json!({ "includeDeclaration": true });
    let references = client.ask("textDocument/references", params);
    let places: Vec<(&str, u64)> = references
        .as_array()
        .unwrap()
        .iter()
        .map(|row| (row["uri"].as_str().unwrap(), row["range"]["start"]["line"].as_u64().unwrap()))
        .collect();
    assert_eq!(places, [(main, 1), (main, 2), (part, 1)]);
    let here = client.at("textDocument/documentHighlight", main, 1, 2);
    assert_eq!(here.as_array().unwrap().iter().map(|row| row["kind"].as_u64().unwrap()).collect::<Vec<_>>(), [3, 2]);
    // A closed file is no longer a program of the folder.
    client.close(part);
    assert_eq!(client.at("textDocument/definition", main, 2, 6), Json::Null);
    client.end();
}

#[test]
fn open_text_replaces_the_program_on_the_disk() {
    let path = folder("beside");
    for (name, text) in [
        ("O9100.nc", "O9100\n#100=#1\nM99\n%\n"),
        ("O9200", "O9200\nM99\n%\n"),
        ("O9300.txt", "O9300\nM99\n%\n"),
        ("O1.cnc", "O1\nM30\n%\n"),
        ("O9400.nc", &format!("O9400\nM99\n({})\n%\n", "x".repeat(1 << 20))),
    ] {
        std::fs::write(path.join(name), text).unwrap();
    }
    let [main, part] = ["O1.nc", "O9100.nc"].map(|name| address(&path.join(name)));
    let mut client = Client::start(&["--control", "mitsubishi-e60"]);
    let calls = "O1\nG65 P9100\nM98 P9200\nM98 P9300\nM98 P9400\nM30\n%\n";
    let unknown = |found: &Json| -> Vec<u64> {
        let rows = found.as_array().unwrap().iter().filter(|row| row.to_string().contains("none of these files"));
        rows.map(|row| row["range"]["start"]["line"].as_u64().unwrap()).collect()
    };
    let found = client.open(&main, calls);
    assert_eq!(unknown(&found), [3, 4], "{found}");
    assert!(!found.to_string().contains("O1.cnc"), "{found}");
    let definition = client.at("textDocument/definition", &main, 1, 6);
    assert_eq!((&definition["uri"], &definition["range"]["start"]["line"]), (&json!(part), &json!(0)));
    client.open(&part, "(NEW)\nO9100\nM99\n%\n");
    let definition = client.at("textDocument/definition", &main, 1, 6);
    assert_eq!((&definition["uri"], &definition["range"]["start"]["line"]), (&json!(part), &json!(1)));
    client.end();
}

#[test]
fn client_chooses_the_language_unless_the_option_does() {
    for (args, chinese) in
        [(&["--control", "mitsubishi-e60"][..], true), (&["--control", "mitsubishi-e60", "--language", "en"], false)]
    {
        let mut client = Client::before_start(args);
        client.introduce_with(json!({ "locale": "zh-cn" }));
        let found = client.open("file:///shop/O1.nc", "O1\nG65 P9100\nM30\n%\n");
        let message = found[0]["message"].as_str().unwrap();
        assert_eq!(message.chars().any(|c| ('\u{4e00}'..='\u{9fff}').contains(&c)), chinese, "{message}");
        client.end();
    }
}

#[test]
fn outline_has_programs_with_their_blocks() {
    let mut client = Client::start(&["--control", "sinumerik-802d"]);
    let uri = "file:///shop/PART.MPF";
    client.open(uri, "AGAIN: R1=R1+1\nIF R1<3 GOTOB AGAIN\nM2\n");
    let found = client.ask("textDocument/documentSymbol", json!({ "textDocument": { "uri": uri } }));
    assert_eq!(found[0]["name"], "PART");
    let children: Vec<&str> =
        found[0]["children"].as_array().unwrap().iter().map(|row| row["name"].as_str().unwrap()).collect();
    assert_eq!(children, ["AGAIN", "R1"]);
    client.end();
}

#[test]
fn control_is_that_of_the_folder_or_of_the_settings() {
    let path = folder("choice");
    let project = super::command::macroline().args(["new", "ribbon-line", "--control", "gsk-980tdc"]).output().unwrap();
    std::fs::write(path.join("project.json"), project.stdout).unwrap();
    let uri = address(&path.join("O1.nc"));
    let text = "O0001\nG32 X1 F2\nM30\n%\n";
    let lathe = |client: &mut Client, uri: &str| {
        client.at("textDocument/hover", uri, 1, 1)["contents"]["value"].as_str().unwrap_or_default().contains("hread")
    };
    let mut client = Client::start(&[]);
    client.open(&uri, text);
    assert!(lathe(&mut client, &uri));
    // In another folder no file names the control; the only remark explains how to name it.
    let other = "file:///nowhere/O1.nc";
    let found = client.open(other, text);
    assert!(found[0]["message"].as_str().unwrap().contains("--control") && found[1] == Json::Null, "{found}");
    client
        .tell("workspace/didChangeConfiguration", json!({ "settings": { "macroline": { "control": "fanuc-0i-tf" } } }));
    assert_ne!(client.diagnostics(other), found);
    assert!(lathe(&mut client, other));
    client.tell("workspace/didChangeConfiguration", json!({ "settings": { "macroline": { "control": "nothing" } } }));
    assert!(client.next("window/showMessage")["message"].as_str().unwrap().contains("nothing"));
    client.end();
    // A program that macroline wrote names its control itself.
    let written =
        std::fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/machines/turning-spindle/gsk-980tdc"));
    let program = written.unwrap().map(|entry| entry.unwrap().path()).find(|path| {
        std::fs::read_to_string(path)
            .is_ok_and(|text| path.extension().is_some_and(|it| it == "nc") && text.contains("WRITTEN BY MACROLINE"))
    });
    if let Some(program) = program {
        let mut client = Client::start(&[]);
        let found = client.open("file:///written/A.nc", &std::fs::read_to_string(program).unwrap());
        assert!(!found.to_string().contains("--control"), "{found}");
        client.end();
    }
}

#[test]
fn hostile_messages_end_nothing() {
    let mut client = Client::start(&["--control", "mitsubishi-e60"]);
    let uri = "file:///shop/O1.nc";
    client.open(uri, "O1\nX1\nM30\n%\n");
    client.send("Content-Length: 5\r\n\r\n{{{{{");
    assert_eq!(client.message()["error"]["code"], -32700);
    client.send("Content-Length: 99999999999999999999999\r\nnonsense\r\n\r\n");
    client.send(&format!("Content-Length: 4\r\n\r\n{}", "null"));
    assert_eq!(client.message()["error"]["code"], -32700);
    for params in [json!(null), json!([]), json!({ "textDocument": 5 }), json!({ "position": { "line": -1 } })] {
        assert_eq!(client.refused("textDocument/hover", params), -32602);
    }
    assert_eq!(client.refused("textDocument/unheard", json!({})), -32601);
    assert_eq!(client.refused("initialize", json!({ "capabilities": {} })), -32600);
    for (line, character) in [(u32::MAX, u32::MAX), (1, u32::MAX), (9, 0)] {
        for method in ["hover", "completion", "definition", "documentHighlight"] {
            client.at(&format!("textDocument/{method}"), uri, line, character);
        }
    }
    let position = |line: u32, character: u32| json!({ "line": line, "character": character });
    let wild = json!({ "range": { "start": position(7, 9), "end": position(0, 1) }, "text": "😀" });
    client.change(uri, &[wild.clone(), wild]);
    client.tell(
        "textDocument/didChange",
        json!({ "textDocument": { "uri": "file:///unknown.nc", "version": 1 }, "contentChanges": [{ "text": "O1" }] }),
    );
    client.tell("textDocument/didClose", json!({ "textDocument": { "uri": "data:,a" } }));
    client.tell("textDocument/didOpen", json!({ "textDocument": { "uri": "untitled:A", "languageId": "nc", "version": 1, "text": "\u{feff}%\u{0}\u{fffd}" } }));
    client.diagnostics("untitled:A");
    assert!(
        client.at("textDocument/hover", uri, 0, 0).is_object() || client.at("textDocument/hover", uri, 0, 0).is_null()
    );
    client.end();
}

#[test]
fn session_follows_the_protocol_to_its_end() {
    let mut client = Client::before_start(&[]);
    assert_eq!(client.refused("textDocument/hover", json!({})), -32002);
    client.introduce();
    assert_eq!(client.ask("shutdown", Json::Null), Json::Null);
    assert_eq!(client.refused("textDocument/hover", json!({})), -32600);
    client.tell("exit", Json::Null);
    assert_eq!(client.status(), 0);
    let mut client = Client::start(&[]);
    client.tell("exit", Json::Null);
    assert_eq!(client.status(), 1);
    let wrong = super::command::macroline().args(["lsp", "--control", "nothing"]).output().unwrap();
    assert_eq!(wrong.status.code(), Some(2));
}
