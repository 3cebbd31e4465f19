//! The command line as an engineer uses it: the paper's figures by running the exported text.

use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Output, Stdio};

use serde_json::{Value as Json, json};

use super::command;

/// A folder of its own for one test, emptied first.
fn folder(name: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_dir_all(&path);
    std::fs::create_dir_all(&path).unwrap();
    path
}

fn macroline(args: &[&str]) -> Output {
    command::macroline().args(args).output().unwrap()
}

fn text(path: &Path) -> String {
    path.to_str().unwrap().to_owned()
}

/// A project file: the paper's example with the exact π and some changed values.
#[track_caller]
fn project(folder: &Path, values: Json) -> String {
    let out = macroline(&["new", "ribbon-line", "--example", "paper"]);
    assert!(out.status.success(), "{}", String::from_utf8_lossy(&out.stderr));
    let mut project: Json = serde_json::from_slice(&out.stdout).unwrap();
    project["values"]["pi"] = json!("exact");
    for (id, value) in values.as_object().unwrap() {
        assert!(project["values"].get(id).is_some(), "no field {id}");
        project["values"][id] = value.clone();
    }
    let path = folder.join("project.json");
    std::fs::write(&path, project.to_string()).unwrap();
    text(&path)
}

/// Exports a project and returns its program files.
#[track_caller]
fn exported(folder: &Path, values: Json) -> Vec<String> {
    let project = project(folder, values);
    let out = macroline(&["export", &project, "--out", &text(&folder.join("out"))]);
    assert!(out.status.success(), "{}", String::from_utf8_lossy(&out.stderr));
    let mut files: Vec<String> = std::fs::read_dir(folder.join("out"))
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|ending| ending == "nc"))
        .map(|path| text(&path))
        .collect();
    files.sort();
    files
}

/// Runs and reads the JSON; the exit status must be `status`.
#[track_caller]
fn run(args: &[&str], status: i32) -> Json {
    let mut line = vec!["run", "--json"];
    line.extend(args);
    let out = macroline(&line);
    assert_eq!(
        out.status.code(),
        Some(status),
        "{}\n{}",
        String::from_utf8_lossy(&out.stdout),
        String::from_utf8_lossy(&out.stderr)
    );
    serde_json::from_slice(&out.stdout).unwrap()
}

#[track_caller]
fn near(value: &Json, want: f64, relative: f64) {
    let value = value.as_f64().unwrap_or_else(|| panic!("no number: {value}"));
    assert!((value - want).abs() <= relative * want.abs(), "{value} is not {want}");
}

/// The values of the project on the control: O9102 by itself, then the run program.
fn values_of_o9102(files: &[String]) -> Vec<String> {
    let path = files.iter().find(|path| path.ends_with("O9102.nc")).unwrap();
    let out = run(&[path.as_str(), "--control", "mitsubishi-e60"], 0);
    let variables = out["variables"].as_object().unwrap();
    variables.iter().flat_map(|(name, value)| ["--set".to_owned(), format!("{name}={value}")]).collect()
}

fn run_exported(files: &[String], more: &[&str]) -> Json {
    let set = values_of_o9102(files);
    let mut args: Vec<&str> = files.iter().map(String::as_str).collect();
    args.extend(["--control", "mitsubishi-e60", "--start", "O9101"]);
    args.extend(set.iter().map(String::as_str));
    args.extend(more);
    run(&args, 0)
}

#[test]
fn exported_paper_example_with_exact_pi_runs_to_its_figures() {
    let files = exported(&folder("paper-exact"), json!({ "pitch-count": 40 }));
    assert_eq!(files.len(), 3, "{files:?}");
    let out = run_exported(&files, &["--no-canon"]);
    assert_eq!(out["ended"], "program-end");
    near(&out["variables"]["#105"], 15079.644737, 2e-9);
    near(&out["variables"]["#110"], 62.831853, 2e-9);
    near(&out["variables"]["#115"], 119391.393301, 2e-9);
    near(&out["axes"]["X"], 320.0, 1e-12);
}

#[test]
fn exported_paper_example_with_short_pi_runs_to_its_figures() {
    let files = exported(&folder("paper-314"), json!({ "pitch-count": 40, "pi": "3.14" }));
    let out = run_exported(&files, &["--no-canon"]);
    near(&out["variables"]["#105"], 15072.0, 1e-12);
    near(&out["variables"]["#110"], 62.8, 1e-12);
    near(&out["variables"]["#115"], 119271.336603, 1e-10);
}

#[test]
fn project_and_its_exported_files_run_alike() {
    let folder = folder("project-run");
    let files = exported(&folder, json!({ "pitch-count": 40 }));
    let bare = run_exported(&files, &[]);
    let whole = run(&[&text(&folder.join("project.json"))], 0);
    assert_eq!(bare["canon"], whole["canon"]);
    assert_eq!(bare["axes"], whole["axes"]);
}

#[test]
fn pitches_per_block_do_not_change_the_pitch_count() {
    for per_block in [1, 3, 6, 7, 499, 500, 600] {
        let folder = folder(&format!("per-block-{per_block}"));
        let path = project(&folder, json!({ "pitch-count": 500, "pitches-per-block": per_block }));
        let out = run(&[&path, "--no-canon"], 0);
        near(&out["axes"]["X"], 4000.0, 1e-12);
        let y = out["axes"]["Y"].as_f64().unwrap();
        let want = 500.0 * std::f64::consts::PI * 120.0 / 6.0;
        assert!((y - want).abs() <= 0.001, "Y {y} is not within one increment of {want}");
    }
}

#[test]
fn operator_changes_product_by_variables_on_the_command_line() {
    let folder = folder("product-change");
    let files = exported(&folder, json!({ "pitch-count": 60 }));
    let out = run_exported(&files, &["--no-canon", "--set", "#107=12.5", "--set", "#109=4"]);
    near(&out["variables"]["#110"], std::f64::consts::PI * 120.0 / 4.0, 2e-9);
    near(&out["axes"]["X"], 60.0 * 12.5, 1e-12);
    near(&out["variables"]["#107"], 12.5, 0.0);
    near(&out["variables"]["#109"], 4.0, 0.0);
}

#[test]
fn override_during_run_changes_spindle_and_axis_speed() {
    let folder = folder("knob");
    let path = project(&folder, json!({ "pitch-count": 400 }));
    let panel = folder.join("panel.json");
    std::fs::write(&panel, r#"[ { "t": 6.0, "spindle_override": 80 } ]"#).unwrap();
    let out = run(&[&path, "--no-canon", "--panel", &text(&panel)], 0);
    near(&out["variables"]["#104"], 960.0, 1e-12);
    near(&out["variables"]["#105"], 15079.644737 * 0.8, 2e-9);
}

#[test]
fn inverter_fault_in_a_panel_file_stops_the_run_with_its_alarm() {
    let folder = folder("inverter-fault");
    let path = project(&folder, json!({ "pitch-count": 400 }));
    let panel = folder.join("panel.json");
    std::fs::write(&panel, r#"[ { "t": 6.0, "inverter_fault": true } ]"#).unwrap();
    let out = run(&[&path, "--no-canon", "--panel", &text(&panel)], 1);
    assert_eq!(out["ended"], "alarm");
    assert!(
        out["diagnostics"].as_array().unwrap().iter().any(|finding| finding["id"] == "motion.inverter-fault"),
        "{out}"
    );
}

#[test]
fn wrong_usage_exits_2_and_error_diagnostics_exit_1() {
    for line in [
        &["run"][..],
        &["new", "no-such-machine"],
        &["check", "missing.nc", "--control", "mitsubishi-e60"],
        &["frobnicate"],
    ] {
        assert_eq!(macroline(line).status.code(), Some(2), "{line:?}");
    }
    let folder = folder("errors");
    let bad = folder.join("bad.nc");
    std::fs::write(&bad, "%\nO1\n#105=1/0\nM30\n%\n").unwrap();
    let out = run(&[&text(&bad), "--control", "mitsubishi-e60"], 1);
    assert_eq!(out["ended"], "alarm");
    assert_eq!(out["diagnostics"][0]["alarm"], "P283");
    assert_eq!(out["diagnostics"][0]["line"], 3);
    let path = project(&folder, json!({ "pitch": 0 }));
    let out = macroline(&["export", &path, "--out", &text(&folder.join("none"))]);
    assert_eq!(out.status.code(), Some(1));
    assert!(!folder.join("none").exists(), "nothing is written when there is an error");
}

#[test]
fn draw_writes_the_machine_at_a_moment_in_both_themes() {
    let folder = folder("draw");
    let path = project(&folder, json!({}));
    let out = text(&folder.join("line.svg"));
    let drawn = |more: &[&str]| {
        let mut line = vec!["draw", &path, "--out", &out];
        line.extend(more);
        let done = macroline(&line);
        assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
        std::fs::read_to_string(&out).unwrap()
    };
    let (rest, later, dark) = (drawn(&[]), drawn(&["--at", "4"]), drawn(&["--at", "4", "--dark"]));
    assert!(rest.starts_with("<svg xmlns=") && rest.contains(">0.0 r/min</text>"), "{rest}");
    assert!(later.contains(">8.107 V</text>") && dark.contains(">8.107 V</text>"), "{later}");
    assert!(later.contains("#15191e") && dark.contains("#e9ecef") && !dark.contains("#15191e"));
    assert_eq!(macroline(&["draw", &path, "--out", &out, "--at", "-1"]).status.code(), Some(2));
    assert_eq!(macroline(&["draw", &path, "--out", &text(&folder.join("none/line.svg"))]).status.code(), Some(1));
}

#[test]
fn endless_program_ends_at_its_budget() {
    let folder = folder("endless");
    let path = folder.join("endless.nc");
    std::fs::write(&path, "%\nO1\nWHILE[1 EQ 1]DO1\n#100=#100+1\nEND1\nM30\n%\n").unwrap();
    let out = run(&[&text(&path), "--control", "mitsubishi-e60", "--blocks", "1000"], 3);
    assert_eq!(out["ended"], "blocks");
    assert_eq!(out["diagnostics"][0]["severity"], "warning");
    let out = run(&[&text(&path), "--control", "mitsubishi-e60", "--seconds", "2"], 3);
    assert_eq!(out["ended"], "seconds");
    let finding = &out["diagnostics"][0];
    assert_eq!(finding["severity"], "info");
    assert!(finding["message"].as_str().unwrap().contains("budget"), "{finding}");
}

#[test]
fn run_has_the_reference_point_of_g50_s_by_its_switch() {
    let path = folder("reference").join("O1.nc");
    std::fs::write(&path, "O1\nG00 X50. Z20.\nG50 S800\nG00 X80.\nM30\n%\n").unwrap();
    for (setting, x) in [("reference-point", json!(50.0)), ("work-zero", json!(50.0)), ("nothing", json!(null))] {
        let switch = format!("speed-limit-sets-zero={setting}");
        let out = run(&[&text(&path), "--control", "gsk-980tdc", "--switch", &switch], 0);
        assert_eq!(out["reference_point"]["X"], x, "{setting}");
    }
}

#[test]
fn program_zero_in_a_panel_file_returns_to_the_point() {
    let folder = folder("program-zero");
    let (path, panel) = (folder.join("O1.nc"), folder.join("panel.json"));
    std::fs::write(&path, "O1\nG00 X50. Z20.\nG50 S800\nG00 X80.\nM30\n%\n").unwrap();
    for (pressed, x) in [(true, 50.0), (false, 80.0)] {
        std::fs::write(&panel, format!(r#"[ {{ "t": 9.0, "program_zero": {pressed} }} ]"#)).unwrap();
        let out = run(&[&text(&path), "--control", "gsk-980tdc", "--panel", &text(&panel)], 0);
        assert_eq!((&out["ended"], &out["axes"]["X"]), (&json!("program-end"), &json!(x)));
    }
}

#[test]
fn diagnostics_without_place_have_the_same_json_keys() {
    let folder = folder("keys");
    let path = folder.join("keys.nc");
    std::fs::write(&path, "%\nO1\nN1GOTO1\nX#2000\nM30\n%\n").unwrap();
    let out = run(&[&text(&path), "--control", "mitsubishi-e60", "--blocks", "10"], 3);
    let findings = out["diagnostics"].as_array().unwrap();
    assert!(findings.iter().any(|d| d["line"].is_null()) && findings.iter().any(|d| d["line"] == 4), "{findings:#?}");
    for diagnostic in findings {
        let keys: Vec<_> = diagnostic.as_object().unwrap().keys().map(String::as_str).collect();
        assert_eq!(
            keys,
            ["alarm", "column", "field", "file", "fixes", "hints", "id", "line", "message", "severity", "wording"]
        );
    }
}

#[test]
fn terminal_output_is_short_and_without_control_characters() {
    let folder = folder("terminal");
    let path = folder.join("long.nc");
    let text_of_it = format!("%\nO1(\u{1b}[31m)\nGOTO7\n#1=1{}\nM30\n%\n", "+1".repeat(20_000));
    std::fs::write(&path, text_of_it).unwrap();
    let out = macroline(&["run", &text(&path), "--control", "mitsubishi-e60"]);
    let stderr = String::from_utf8(out.stderr).unwrap();
    assert!(!stderr.contains('\u{1b}') && stderr.lines().all(|line| line.chars().count() < 200), "{stderr}");
    assert_eq!(stderr.matches("[P231]").count(), 1, "found by the reader and by the run, reported once: {stderr}");
}

#[test]
fn plc_inputs_are_forced_by_variable_or_register() {
    let folder = folder("inputs");
    let path = folder.join("inputs.nc");
    std::fs::write(&path, "%\nO1\nS1200M3\nG04X3.\n#100=#1033\n#101=#1032\n#102=#1002\nG04X1.\nM00\nM30\n%\n").unwrap();
    let path = text(&path);
    let panel = folder.join("panel.json");
    for (forced, events, word, rpm) in [
        ("#1033=80", "[]", 80.0, 1200.0),
        ("R74=70", "[]", 70.0, 1200.0),
        // The knob's register: the spindle follows, and the word that the PLC copies from it.
        ("R148=50", "[]", 50.0, 600.0),
        ("#1=1", r##"[ { "t": 0, "input": { "#1033": 60 } } ]"##, 60.0, 1200.0),
        ("#1=1", r#"[ { "t": 0, "input": { "R74": 60, "R75": 1 } } ]"#, 65596.0, 1200.0),
        ("#1=1", r#"[ { "t": 0, "spindle_override": 90, "input": { "R75": 65535 } } ]"#, -65446.0, 1080.0),
        ("R72=5", "[]", 100.0, 1200.0),
    ] {
        std::fs::write(&panel, events).unwrap();
        let args = [&path, "--control", "mitsubishi-e60", "--set", forced, "--panel", &text(&panel)];
        let out = run(&args.map(|arg: &str| arg), 4);
        near(&out["variables"]["#100"], word, 0.0);
        near(&out["spindle"]["rpm"], rpm, 1e-12);
        if forced == "R72=5" {
            assert_eq!((&out["variables"]["#101"], &out["variables"]["#102"]), (&json!(5.0), &json!(1.0)));
        }
    }
    std::fs::write(&panel, r##"[ { "t": 0, "input": { "R999": 1 }, "variable": { "#2000": 1 } } ]"##).unwrap();
    let out = run(&[&path, "--control", "mitsubishi-e60", "--panel", &text(&panel)], 4);
    let messages: Vec<_> = out["diagnostics"].as_array().unwrap().iter().map(|d| d["message"].to_string()).collect();
    assert!(
        messages.iter().any(|text| text.contains("R999")) && messages.iter().any(|text| text.contains("#2000")),
        "{messages:?}"
    );
    // Values beyond the range of the register.
    std::fs::write(&panel, r##"[ { "t": 0, "input": { "#1033": 5e9, "R72": 70000, "#1005": 2 } } ]"##).unwrap();
    let out = run(&[&path, "--control", "mitsubishi-e60", "--panel", &text(&panel)], 4);
    let out_of_range = out["diagnostics"].as_array().unwrap().iter().filter(|d| d["id"] == "interp.output-range");
    assert_eq!(out_of_range.count(), 3);
    near(&out["variables"]["#100"], 2_147_483_647.0, 0.0);
    for name in ["#2000=1", "#3004=2", "R999=1", "R172=1", "#1033", "#100=abc", "#100=1e400"] {
        let out = macroline(&["run", &path, "--control", "mitsubishi-e60", "--set", name]);
        assert_eq!(out.status.code(), Some(2), "{name}");
    }
}

#[test]
fn continue_answers_stops_and_messages_of_the_program() {
    let folder = folder("continue");
    let path = text(&folder.join("stops.nc"));
    std::fs::write(&path, "%\nO1\nM00\n#3006=1(TURN THE PART)\n#100=7\nM01\nM30\n%\n").unwrap();
    let waits = run(&[&path, "--control", "mitsubishi-e60"], 4);
    assert_eq!(waits["variables"].get("#100"), None);
    let goes_on = run(&[&path, "--control", "mitsubishi-e60", "--continue"], 0);
    assert_eq!((&goes_on["ended"], &goes_on["variables"]["#100"]), (&json!("program-end"), &json!(7.0)));
    // A program that stops again after every cycle start ends at its budget.
    std::fs::write(&path, "N10 R1=1\nLB1: M0\nGOTOB LB1\nM30\n").unwrap();
    let endless = run(&[&path, "--control", "sinumerik-802d", "--continue", "--blocks", "5000"], 3);
    assert_eq!(endless["ended"], "blocks");
}

#[test]
fn run_that_ends_at_m00_reports_the_turning_spindle() {
    let folder = folder("m00");
    let path = folder.join("spindle.nc");
    std::fs::write(&path, "%\nO1\nS1200M3\nG04X5.\nM00\nM30\n%\n").unwrap();
    let out = run(&[&text(&path), "--control", "mitsubishi-e60"], 4);
    assert_eq!(out["ended"], "stop");
    near(&out["spindle"]["rpm"], 1200.0, 1e-9);
    near(&out["spindle"]["volts_command"], 8.108108, 1e-6);
    near(&out["spindle"]["volts"], 8.107, 1e-4);
}

#[test]
fn run_json_reports_gear_angle_and_speed_limits() {
    let folder = folder("spindle");
    let path = folder.join("spindle.nc");
    std::fs::write(&path, "O1\nS1000 M03\nM42\nG04 X5.\nM30\n%\n").unwrap();
    let panel = folder.join("panel.json");
    for (events, rpm) in [
        ("[]", 1000.0),
        (r#"[ { "t": 0, "upper_speed_limit": 700 } ]"#, 700.0),
        (r#"[ { "t": 0, "lower_speed_limit": 1200 }, { "t": 1, "surface_speed_limit": 300 } ]"#, 1200.0),
    ] {
        std::fs::write(&panel, events).unwrap();
        let out = run(&[&text(&path), "--control", "gsk-980tdc", "--panel", &text(&panel)], 0);
        near(&out["spindle"]["rpm"], rpm, 1e-9);
        near(&out["spindle"]["volts_command"], 10.0 * rpm / 2000.0, 1e-9);
        assert_eq!((&out["spindle"]["gear"], &out["spindle"]["angle_deg"]), (&json!(2), &json!(null)));
        // Times of the standard ladder: 5 s, the gear, 5 s.
        assert!(out["time_s"].as_f64().unwrap() > 15.0);
    }
}

/// The memory limit leaves no room for a log: even eight bytes kept per block would exceed it.
#[cfg(unix)]
#[test]
fn run_prints_its_log_while_it_runs() {
    let program = folder("streams").join("endless.nc");
    std::fs::write(&program, "%\nO1\nG91G01F119391.393\nDO1\nX8.Y62.832\nX-8.Y-62.832\nEND1\n%\n").unwrap();
    let run = "ulimit -v 32000 && exec \"$0\" run \"$1\" --control mitsubishi-e60 --seconds 1e9 --blocks 3000000";
    let out = command::in_english("sh")
        .args(["-c", run, command::MACROLINE, &text(&program)])
        .stdout(std::process::Stdio::null())
        .output()
        .unwrap();
    let stderr = String::from_utf8_lossy(&out.stderr);
    assert!(out.status.code() == Some(3) && stderr.contains("blocks after 3000000 blocks"), "{stderr}");
}

/// Steps through a program with a script of commands: exit status, standard output, standard error.
#[track_caller]
fn step(args: &[&str], script: &str) -> (i32, String, String) {
    let mut command = command::macroline();
    command.arg("step").args(args).stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().unwrap();
    child.stdin.take().unwrap().write_all(script.as_bytes()).unwrap();
    let out = child.wait_with_output().unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    (out.status.code().unwrap(), text(out.stdout), text(out.stderr))
}

#[test]
fn step_exits_with_the_status_of_its_run() {
    let path = folder("step").join("a.nc");
    std::fs::write(&path, "%\nO1\n#100=#107+1\n#101=SQRT[3-#100]\nM30\n%\n").unwrap();
    let file = text(&path);
    let args = [file.as_str(), "--control", "mitsubishi-e60", "--set", "#107=2"];
    let (status, out, stderr) = step(&args, "into\nprint #100*2\ncontinue\n");
    assert_eq!((status, stderr.as_str()), (0, ""));
    assert!(out.starts_with(" --> a.nc:3:1\n"), "{out}");
    assert!(out.contains("  #100 vacant -> 3\n") && out.contains("#100*2 = 6\n"), "{out}");
    assert!(out.contains("the program is over\n"), "{out}");
    // Lines after `quit` are not read; an alarm is exit status 1 as in `run`; a wrong command is wrong usage.
    assert_eq!(step(&args, "quit\nwrong\n").0, 0);
    let (status, out, _) = step(&args, "set #107=9\ncontinue\n");
    assert_eq!(status, 1);
    assert!(out.contains("error[P282]: SQRT of -7 has no value.\n --> a.nc:4:6\n"), "{out}");
    let (status, out, stderr) = step(&args, "intwo\n");
    assert_eq!(status, 2);
    assert!(out.contains("There is no command “intwo”"), "{out}");
    assert_eq!(stderr, "macroline: 1 of the commands could not be carried out\n");
    assert_eq!(step(&[file.as_str()], "").0, 2);
}

#[test]
fn step_uses_panel_and_budget_of_the_project() {
    let folder = folder("step-project");
    let project = project(&folder, json!({}));
    let (status, out, _) =
        step(&[&project, "--blocks", "5000"], "break O9101 N30 if #1033 GT 0\nbreaks\ncontinue\ncontinue\n");
    assert_eq!(status, 0);
    assert!(out.contains("breakpoint 1\n"), "{out}");
}

/// Ids of the findings that a command prints, and its line with the number of silenced ones.
fn reported_ids(out: &Output) -> (Vec<String>, String) {
    let stderr = String::from_utf8(out.stderr.clone()).unwrap();
    let id = |line: &str| Some(line.split_once('[')?.1.split_once("]: ")?.0.to_owned());
    let ids = stderr.lines().filter(|line| !line.starts_with(' ')).filter_map(id).collect();
    (ids, stderr.lines().find(|line| line.ends_with("silenced")).unwrap_or_default().to_owned())
}

#[test]
fn warning_shows_the_id_that_suppresses_it() {
    let folder = folder("silence");
    let path = folder.join("O1.nc");
    std::fs::write(&path, "%\nO1\nG91 G01 X8 F100\nM30\nX1.\nM30\n%\n").unwrap();
    let (path, control) = (text(&path), ["--control", "mitsubishi-e60"]);
    for command in ["check", "run"] {
        let line = |more: &[&str]| macroline(&[&[command, path.as_str()], &control[..], more].concat());
        let all = ["lint.no-point".to_owned(), "lint.unreachable".to_owned()];
        assert_eq!(reported_ids(&line(&[])), (all.to_vec(), String::new()), "{command}");
        let out = line(&["--silence", "lint.no-point"]);
        assert_eq!(reported_ids(&out), (all[1..].to_vec(), "1 silenced".to_owned()), "{command}");
        let out = line(&["--silence", "lint.no-point", "--silence", "lint.unreachable", "--json"]);
        let json: Json = serde_json::from_slice(&out.stdout).unwrap();
        assert_eq!(json["diagnostics"], json!([]), "{command}");
        assert_eq!(line(&["--silence", "lint.no-such"]).status.code(), Some(2), "{command}");
    }
    let out = macroline(&["check", &path, "--control", "mitsubishi-e60", "--json"]);
    let json: Json = serde_json::from_slice(&out.stdout).unwrap();
    assert_eq!(
        (&json["diagnostics"][0]["id"], &json["diagnostics"][0]["alarm"]),
        (&json!("lint.no-point"), &Json::Null)
    );
}

#[test]
fn json_fixes_carry_their_edits() {
    let path = folder("edits").join("O1.nc");
    let source = "%\nO1\nG91 G01 X8 F100\nM30\n%\n";
    std::fs::write(&path, source).unwrap();
    let out = macroline(&["check", &text(&path), "--control", "mitsubishi-e60", "--json"]);
    let json: Json = serde_json::from_slice(&out.stdout).unwrap();
    let fix = &json["diagnostics"][0]["fixes"][0];
    let edit = &fix["edits"][0];
    assert_eq!((&edit["file"], &edit["text"]), (&json!("O1.nc"), &json!("X8.")));
    let at = |key: &str| edit[key].as_u64().unwrap() as usize;
    assert_eq!(&source[at("start")..at("end")], "X8");
    assert!(fix["title"].as_str().unwrap().contains("X8."), "{fix}");
}

#[test]
fn json_numbers_are_never_minus_zero() {
    let path = folder("zero").join("O1.nc");
    std::fs::write(&path, "%\nO1\nG00 X-0. Y[0*-1]\nG91 X1.\nX-1.\nM30\n%\n").unwrap();
    let args = ["run", &text(&path), "--control", "mitsubishi-e60", "--set", "#100=-0", "--json"];
    let out = String::from_utf8(macroline(&args).stdout).unwrap();
    assert!(out.contains("\"#100\": 0.0") && !out.contains("-0.0"), "{out}");
}

#[test]
fn last_command_is_logged_once() {
    let path = folder("end").join("O1.nc");
    std::fs::write(&path, "%\nO1\nG00 X1.\nM30\n%\n").unwrap();
    let args = [text(&path), "--control".to_owned(), "mitsubishi-e60".to_owned()];
    let args: Vec<&str> = args.iter().map(String::as_str).collect();
    let (_, out, _) = step(&args, "continue\ninto\nover\n");
    assert_eq!((out.matches("gives end").count(), out.matches("the program is over").count()), (1, 3), "{out}");
    // Reached again from an earlier block, it is reported again.
    let (_, out, _) = step(&args, "continue\nback\ncontinue\n");
    assert_eq!(out.matches("gives end").count(), 2, "{out}");
}

#[test]
fn loop_without_its_other_end_is_one_finding() {
    let path = text(&folder("loops").join("O1.nc"));
    for (lines, alarm) in [("DO1\nG04 X1.\nEND", "P291"), ("DO1\nDO2\nEND1\nEND2", "P294"), ("G04 X1.\nEND1", "P294")] {
        std::fs::write(&path, format!("%\nO1\n{lines}\nM30\n%\n")).unwrap();
        let outcome = run(&[&path, "--control", "mitsubishi-e60"], 1);
        let alarms: Vec<_> = outcome["diagnostics"].as_array().unwrap().iter().map(|d| &d["alarm"]).collect();
        assert_eq!((alarms, &outcome["ended"]), (vec![&json!(alarm)], &json!("alarm")), "{lines}");
    }
}

#[test]
fn stopped_run_omits_the_warning_that_foresaw_it() {
    let path = text(&folder("may").join("O1.nc"));
    for (block, warning, alarm) in [
        ("M98 P77", "lint.no-such-program", "P232"),
        ("#2=5/#1", "lint.zero-divisor", "P283"),
        ("G01 X1. F0", "lint.feed-zero-digit", "P62"),
    ] {
        // The warning stays if the run does not reach its block.
        for (jump, expected) in [("", json!([alarm])), ("#3=1\nIF[#3 EQ 1]GOTO9", json!([null]))] {
            std::fs::write(&path, format!("%\nO1\n#1=0\n{jump}\n{block}\nN9 M30\n%\n")).unwrap();
            let out = run(&[&path, "--control", "mitsubishi-e60"], i32::from(jump.is_empty()));
            let found = out["diagnostics"].as_array().unwrap();
            let alarms: Vec<&Json> = found.iter().map(|d| &d["alarm"]).collect();
            assert_eq!(json!(alarms), expected, "{block}: {found:#?}");
            let ids: Vec<&Json> = found.iter().map(|d| &d["id"]).collect();
            assert_eq!(ids.contains(&&json!(warning)), !jump.is_empty(), "{block}: {ids:?}");
        }
    }
}

#[test]
fn ignored_part_of_a_block_is_one_finding() {
    let path = folder("remarks").join("O1.nc");
    let program =
        "%\nO1\nWHILE[#1 LT 5]DO1\n#1=#1+1\n#1132=#1*1E9\nG04 P0.5\nEND1\nM30\n%\n".replace("1E9", "1000000000");
    std::fs::write(&path, program).unwrap();
    let out = macroline(&["run", &text(&path), "--control", "mitsubishi-e60"]);
    assert_eq!(reported_ids(&out).0, ["interp.decimals-dropped", "interp.output-range"]);
    let silent = ["--silence", "interp.decimals-dropped", "--silence", "interp.output-range"];
    let out = macroline(&[&["run", &text(&path), "--control", "mitsubishi-e60"], &silent[..]].concat());
    assert_eq!(reported_ids(&out), (Vec::new(), "2 silenced".to_owned()));
}

#[test]
fn code_call_setting_without_a_program_is_a_finding() {
    let path = folder("call-parameters").join("O1.nc");
    std::fs::write(&path, "O1\nM30\n%\n").unwrap();
    for (control, setting, strange) in [
        ("knd-k2000t", "4120=512 4121=502", &[][..]),
        ("knd-k2000t", "4120=512, 4140=502; G502", &["4140=502", "G502"][..]),
        ("knd-k2000t", "No.4120=0", &[][..]),
        ("gsk-980tdc", "86=3 87=100 88=2000", &[][..]),
        ("gsk-980tdc", "86=3 87=100", &["86=3", "87=100"][..]),
        // Codes of the control itself are unchanged.
        ("gsk-980tdc", "86=1 87=1 88=2000", &["86=1", "87=1", "88=2000"][..]),
        ("mitsubishi-e60", "#7201=200 #7202=1 #7203=9010 #7301=200", &["#7301=200"][..]),
    ] {
        let switch = format!("call-parameters={setting}");
        let out = macroline(&["check", &text(&path), "--control", control, "--switch", &switch, "--json"]);
        let json: Json = serde_json::from_slice(&out.stdout).unwrap();
        let found = json["diagnostics"].as_array().unwrap().iter().filter(|d| d["id"] == "lint.call-parameter");
        let messages: Vec<String> = found.map(|d| d["message"].to_string()).collect();
        assert_eq!(messages.len(), strange.len(), "{setting}: {messages:?}");
        assert!(messages.iter().zip(strange).all(|(text, piece)| text.contains(piece)), "{setting}: {messages:?}");
    }
}

#[test]
fn suppression_hides_warnings_everywhere_but_never_errors() {
    let folder = folder("silenced-project");
    let path = project(&folder, json!({}));
    let mut saved: Json = serde_json::from_str(&std::fs::read_to_string(&path).unwrap()).unwrap();
    saved["edited"] = json!([{ "name": "O1.nc", "text": "%\nO1\nG91 G01 X8 F100\nM30\nX1.\nM30\n%\n" }]);
    saved["silenced"] = json!(["lint.unreachable", "form.assumed"]);
    std::fs::write(&path, saved.to_string()).unwrap();
    let out = text(&folder.join("out"));
    for line in [&["check", &path][..], &["run", &path], &["export", &path, "--out", &out]] {
        let (ids, _) = reported_ids(&macroline(line));
        assert_eq!(ids, ["lint.no-point"], "{line:?}");
    }
    let report = std::fs::read_to_string(folder.join("out/report.md")).unwrap();
    assert!(report.contains("X8 is 0.008 mm") && !report.contains("Nothing leads here"), "{report}");
    saved["edited"][0]["text"] = json!("%\nO1\nGOTO7\nM30\n%\n");
    saved["silenced"] = json!(["nc.no-such-sequence", "form.assumed"]);
    std::fs::write(&path, saved.to_string()).unwrap();
    let out = macroline(&["check", &path]);
    assert_eq!((reported_ids(&out).0, out.status.code()), (vec!["P231".to_owned()], Some(1)));
}

#[test]
fn axes_that_stop_between_short_blocks_are_one_finding() {
    let folder = folder("short");
    let path = folder.join("O1.nc");
    let program = format!("%\nO1\nG91 G64 G01 X10. F30000\n{}M30\n%\n", "X0.5\n".repeat(40));
    std::fs::write(&path, program).unwrap();
    let args = ["run", &text(&path), "--control", "mitsubishi-e60"];
    assert_eq!(reported_ids(&macroline(&args)).0, ["lint.short-blocks"]);
    // Calculated lengths are reported by the run.
    std::fs::write(&path, format!("%\nO1\n#1=0.5\nG91 G64 G01 X10. F30000\n{}M30\n%\n", "X#1\n".repeat(40))).unwrap();
    assert_eq!(reported_ids(&macroline(&args)).0, ["motion.starved"]);
}

#[test]
fn design_json_lists_facts_to_measure_first() {
    let path = project(&folder("measure-first"), json!({ "clamp-x": 20000 }));
    let out = macroline(&["design", &path, "--json"]);
    let design: Json = serde_json::from_slice(&out.stdout).unwrap();
    let first = design["measure_first"].as_array().unwrap();
    assert!(first.contains(&json!("clamp-x")) && !first.contains(&json!("spindle-speed")), "{first:?}");
}

#[test]
fn size_json_has_motors_envelope_limits_and_bill() {
    let path = project(&folder("size"), json!({ "pitch-count": 60, "dancer": true }));
    let out = macroline(&["size", &path, "--json"]);
    assert!(out.status.success(), "{}", String::from_utf8_lossy(&out.stderr));
    let sizing: Json = serde_json::from_slice(&out.stdout).unwrap();
    let rows = |key: &str| sizing[key].as_array().unwrap_or_else(|| panic!("no {key}")).clone();
    assert_eq!(rows("axes").iter().map(|row| row["axis"].clone()).collect::<Vec<_>>(), ["x", "y", "unwinder"]);
    for (list, keys) in [
        (
            sizing["axes"][0]["candidates"].as_array().unwrap().clone(),
            "maker model passes reason effective_load peak_load regenerative_load inertia_ratio status grade",
        ),
        (rows("envelope"), "event id value unit limit verdict"),
        (rows("limits"), "quantity limit margin"),
        (rows("sensitivities"), "input result flips"),
        (rows("bom"), "item part maker model quantity status grade source"),
    ] {
        assert!(!list.is_empty(), "{keys}");
        for row in list {
            for key in keys.split(' ') {
                assert!(row.get(key).is_some(), "{key}: {row}");
            }
        }
    }
    for key in ["line_speed", "binding"] {
        assert!(!sizing["inverse"][key].is_null(), "{key}: {}", sizing["inverse"]);
    }
    assert!(sizing["chance"].is_null());
    let stdout = String::from_utf8(macroline(&["size", &path, "--draws", "20"]).stdout).unwrap();
    for part in ["Bill of materials", "What limits the machine", "Operating envelope", "Pull roller", "of 20 machines"]
    {
        assert!(stdout.contains(part), "{part}: {stdout}");
    }
}

#[test]
fn compare_lists_entries_and_results_that_differ() {
    let (slow, fast) = (folder("compare-a"), folder("compare-b"));
    let (a, b) = (project(&slow, json!({ "pitch": 9 })), project(&fast, json!({ "pitch": 9, "spindle-speed": 1400 })));
    let out = macroline(&["compare", &a, &b, "--json"]);
    let compared: Json = serde_json::from_slice(&out.stdout).unwrap();
    let ids: Vec<&Json> = compared["entries"].as_array().unwrap().iter().map(|row| &row["id"]).collect();
    assert_eq!(ids, ["spindle-speed"]);
    let speed = compared["results"].as_array().unwrap().iter().find(|row| row["id"] == "line-speed").unwrap();
    assert_eq!((&speed["differs"], speed["variants"].as_array().unwrap().len()), (&json!(true), 2));
    let pitch = compared["results"].as_array().unwrap().iter().find(|row| row["id"] == "surface-ratio").unwrap();
    assert_eq!(pitch["differs"], json!(false));
    let text = String::from_utf8(macroline(&["compare", &a, &b]).stdout).unwrap();
    assert!(
        text.contains("Spindle speed") && text.contains("Line speed") && !text.contains("Roller : ribbon speed"),
        "{text}"
    );
    // Another control has other entries; a file that is no project compares nothing.
    let other = fast.join("other.json");
    std::fs::write(&other, macroline(&["new", "ribbon-line", "--control", "gsk-980tdc"]).stdout).unwrap();
    let compared: Json =
        serde_json::from_slice(&macroline(&["compare", &a, other.to_str().unwrap(), "--json"]).stdout).unwrap();
    assert_eq!(compared["controls"], json!(["Mitsubishi E60", "GSK 980TDc"]));
}

#[test]
fn compare_of_one_file_compares_its_variants() {
    let folder = folder("compare-variants");
    let path = project(&folder, json!({ "pitch": 9 }));
    let alone = macroline(&["compare", &path]);
    assert_eq!(alone.status.code(), Some(2));
    assert!(String::from_utf8(alone.stderr).unwrap().contains("one that keeps variants"));
    let mut saved: Json = serde_json::from_str(&std::fs::read_to_string(&path).unwrap()).unwrap();
    saved["variants"] = json!([{ "name": "Wide", "control": "mitsubishi-e60", "values": saved["values"].clone() }]);
    saved["variants"][0]["values"]["pitch"] = json!(12);
    std::fs::write(&path, saved.to_string()).unwrap();
    let compared: Json = serde_json::from_slice(&macroline(&["compare", &path, "--json"]).stdout).unwrap();
    assert_eq!(compared["variants"], json!(["Now", "Wide"]));
    let values: Vec<&Json> =
        compared["entries"][0]["variants"].as_array().unwrap().iter().map(|cell| &cell["value"]).collect();
    assert_eq!((&compared["entries"][0]["id"], values), (&json!("pitch"), vec![&json!("9"), &json!("12")]));
    let text = String::from_utf8(macroline(&["compare", &path]).stdout).unwrap();
    assert!(text.contains("Wide") && text.contains("Pitch mm") && !text.contains("Control"), "{text}");
}

#[test]
fn example_is_printed_with_the_reasons_of_its_faults() {
    let printed = macroline(&["new", "ribbon-line", "--control", "gsk-980tdc", "--example", "paper"]);
    assert!(printed.status.success());
    let project: Json = serde_json::from_slice(&printed.stdout).unwrap();
    assert_eq!((&project["control"], project["values"]["pitch"].as_f64()), (&json!("gsk-980tdc"), Some(8.0)));
    let stderr = String::from_utf8(printed.stderr).unwrap();
    for part in ["The paper’s machine", "FAIL  Roller : ribbon speed", "alarm 20"] {
        assert!(stderr.contains(part), "{part}: {stderr}");
    }
    assert!(macroline(&["new", "ribbon-line"]).stderr.is_empty());
}

#[test]
fn unknown_example_is_wrong_usage_with_the_known_ones() {
    let refused = macroline(&["new", "turning-spindle", "--example", "papers"]);
    assert_eq!(refused.status.code(), Some(2));
    let stderr = String::from_utf8(refused.stderr).unwrap();
    assert!(stderr.contains("facing, shaft, keyway, taper"), "{stderr}");
}

#[test]
fn list_names_the_examples_of_each_machine() {
    let listed: Json = serde_json::from_slice(&macroline(&["list", "--json"]).stdout).unwrap();
    let text = String::from_utf8(macroline(&["list"]).stdout).unwrap();
    for machine in listed["machines"].as_array().unwrap() {
        for example in machine["examples"].as_array().unwrap() {
            let (machine, id) = (machine["id"].as_str().unwrap(), example["id"].as_str().unwrap());
            assert!(macroline(&["new", machine, "--example", id]).status.success(), "{machine} {id}");
            assert!(text.contains(example["about"].as_str().unwrap()), "{machine} {id}");
        }
    }
}

#[test]
fn design_has_the_origin_of_each_value() {
    let path = project(&folder("origins"), json!({ "pitch": 9 }));
    let out = macroline(&["design", &path, "--json"]);
    let design: Json = serde_json::from_slice(&out.stdout).unwrap();
    let of = |id: &str| design["values"].as_array().unwrap().iter().find(|row| row["id"] == id).unwrap().clone();
    assert_eq!(of("pitch"), json!({ "id": "pitch", "value": "9", "unit": "mm", "origin": "entered" }));
    assert_eq!((&of("heads")["origin"], &of("pitch-count")["origin"]), (&json!("assumed"), &json!("default")));
    // Facts that flip a verdict are the first of the assumed ones.
    let assumed = design["assumed"].as_array().unwrap();
    let first = design["measure_first"].as_array().unwrap();
    let fields: Vec<&Json> = assumed.iter().map(|row| &row["field"]).collect();
    assert!(
        !first.is_empty() && fields.len() > first.len() && fields[..first.len()] == first.iter().collect::<Vec<_>>()
    );
    assert!(assumed[0]["flips"]["readout"].is_string() && assumed[first.len()]["flips"].is_null());
    let text = String::from_utf8(macroline(&["design", &path]).stdout).unwrap();
    let at = |part: &str| text.find(part).unwrap_or_else(|| panic!("{part}: {text}"));
    assert!(at("entered      Pitch #107") < at("measure first") && at("measure first") < at("assumed as well: "));
}

#[test]
fn parts_prints_the_catalogue_and_takes_rows_back() {
    let folder = folder("parts");
    let all = String::from_utf8(macroline(&["parts"]).stdout).unwrap();
    assert_eq!(all, include_str!("../../src/project/parts/shipped.csv"));
    let of = |control: &str| String::from_utf8(macroline(&["parts", "--control", control]).stdout).unwrap();
    assert!(of("mitsubishi-e60").contains(",HC53,") && !of("fanuc-0i-mf").contains(",HC53,"));
    // The head line and a row, changed, as a spreadsheet of another country saves them.
    let row = all.lines().find(|line| line.contains(",HC53,")).unwrap().replace(",HC53,", ",HC53X,");
    let own = folder.join("own.csv");
    let table = format!("{}\n{row}\n", all.lines().next().unwrap()).replace(',', ";").replace('.', ",");
    std::fs::write(&own, table).unwrap();
    let read: Json = serde_json::from_slice(&macroline(&["parts", &text(&own), "--json"]).stdout).unwrap();
    assert_eq!((&read[0]["model"], &read[0]["rated_torque_nm"]), (&json!("HC53X"), &json!(1.59)));
    let project = project(&folder, json!({}));
    let added = macroline(&["parts", &text(&own), "--add-to", &project]);
    assert!(added.status.success(), "{}", String::from_utf8_lossy(&added.stderr));
    let added: Json = serde_json::from_slice(&added.stdout).unwrap();
    assert_eq!(added["parts"][0], read[0]);
    // A mistake is reported with its place, and fails.
    std::fs::write(&own, "kind,maker,model,ratio\ngear,Own,G1,two\n").unwrap();
    let wrong = macroline(&["parts", &text(&own)]);
    let stderr = String::from_utf8(wrong.stderr).unwrap();
    assert!(wrong.status.code() == Some(1) && stderr.contains("own.csv:2:13"), "{stderr}");
}
