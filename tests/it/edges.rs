//! Edges of files and output: exports that fail, outputs that are closed, files of other encodings, text that is hostile.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Output, Stdio};

use serde_json::{Value as Json, json};

use super::command;

/// A folder of its own for one test, emptied first.
fn folder(name: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("edges").join(name);
    let _ = fs::remove_dir_all(&path);
    fs::create_dir_all(&path).unwrap();
    path
}

fn macroline(args: &[&str]) -> Output {
    command::macroline().args(args).output().unwrap()
}

fn text(path: &Path) -> &str {
    path.to_str().unwrap()
}

/// Standard error as text.
fn error_text(out: &Output) -> String {
    String::from_utf8(out.stderr.clone()).unwrap()
}

/// The default project of the ribbon line, changed, as a file.
fn project(folder: &Path, change: impl FnOnce(&mut Json)) -> PathBuf {
    let mut project: Json = serde_json::from_slice(&macroline(&["new", "ribbon-line"]).stdout).unwrap();
    change(&mut project);
    let path = folder.join("project.json");
    fs::write(&path, project.to_string()).unwrap();
    path
}

/// Names and texts of a folder; of a symbolic link its target.
fn contents(folder: &Path) -> Vec<(String, String)> {
    let entry = |entry: std::io::Result<fs::DirEntry>| {
        let path = entry.unwrap().path();
        let text = match fs::read_link(&path) {
            Ok(target) => format!("-> {}", target.display()),
            Err(_) => fs::read_to_string(&path).unwrap_or_else(|_| "a folder".to_owned()),
        };
        (path.file_name().unwrap().to_str().unwrap().to_owned(), text)
    };
    let mut all: Vec<_> = fs::read_dir(folder).unwrap().map(entry).collect();
    all.sort();
    all
}

#[test]
fn name_taken_by_a_folder_leaves_everything_as_it_was() {
    let folder = folder("taken");
    let project = project(&folder, |_| {});
    let out = folder.join("out");
    fs::create_dir_all(out.join("report.md")).unwrap();
    fs::write(out.join("O9100.nc"), "kept").unwrap();
    let before = contents(&out);
    let done = macroline(&["export", text(&project), "--out", text(&out)]);
    assert_eq!(done.status.code(), Some(1));
    assert!(error_text(&done).contains("report.md: a folder has this name"), "{}", error_text(&done));
    assert!(done.stdout.is_empty());
    assert_eq!(contents(&out), before);
}

#[test]
fn folder_that_cannot_be_made_leaves_nothing() {
    let folder = folder("unmade");
    let project = project(&folder, |_| {});
    fs::write(folder.join("file"), "kept").unwrap();
    let out = folder.join("file/deep/out");
    let done = macroline(&["export", text(&project), "--out", text(&out)]);
    assert_eq!(done.status.code(), Some(1), "{}", error_text(&done));
    assert!(error_text(&done).contains("file is a file, not a folder"), "{}", error_text(&done));
    assert_eq!(contents(&folder).len(), 2);
    let done = macroline(&["export", text(&project), "--out", "/dev/null"]);
    assert_eq!(
        (done.status.code(), error_text(&done).contains("/dev/null is a file, not a folder")),
        (Some(1), !cfg!(windows))
    );
}

/// A limit of file sizes ends the export after its first files.
#[cfg(unix)]
#[test]
fn failure_within_an_export_takes_all_of_it_back() {
    let folder = folder("taken-back");
    let project = project(&folder, |_| {});
    let out = folder.join("out");
    let export = format!("trap '' XFSZ; ulimit -f 4; \"$0\" export \"$1\" --out {}", text(&out));
    let done = shell(&export, text(&project));
    assert_eq!(done.status.code(), Some(1), "{}", error_text(&done));
    assert!(!out.exists() && done.stdout.is_empty());
    fs::create_dir(&out).unwrap();
    fs::write(out.join("O9100.nc"), "kept").unwrap();
    let before = contents(&out);
    assert_eq!(shell(&export, text(&project)).status.code(), Some(1));
    assert_eq!(contents(&out), before);
}

#[cfg(unix)]
#[test]
fn read_only_folder_stays_as_it_was() {
    use std::os::unix::fs::PermissionsExt;
    let folder = folder("read-only");
    let project = project(&folder, |_| {});
    let out = folder.join("out");
    fs::create_dir(&out).unwrap();
    fs::write(out.join("O9100.nc"), "kept").unwrap();
    let before = contents(&out);
    fs::set_permissions(&out, fs::Permissions::from_mode(0o555)).unwrap();
    let done = macroline(&["export", text(&project), "--out", text(&out)]);
    fs::set_permissions(&out, fs::Permissions::from_mode(0o755)).unwrap();
    // For root the folder is writable, so there is nothing to check.
    if done.status.code() != Some(0) {
        assert_eq!(done.status.code(), Some(1), "{}", error_text(&done));
        assert_eq!(contents(&out), before);
    }
}

#[cfg(unix)]
/// A shell script in place of a browser.
#[cfg(unix)]
fn browser(folder: &Path, script: &str) -> String {
    use std::os::unix::fs::PermissionsExt;
    let path = folder.join("browser");
    fs::write(&path, format!("#!/bin/sh\n{script}\n")).unwrap();
    fs::set_permissions(&path, fs::Permissions::from_mode(0o755)).unwrap();
    text(&path).to_owned()
}

/// Script that writes the PDF to the path in its option, like a browser.
#[cfg(unix)]
const PRINTS: &str =
    r#"for word; do case "$word" in --print-to-pdf=*) printf %s %PDF-1.4 > "${word#--print-to-pdf=}";; esac; done"#;

#[test]
#[cfg(unix)]
fn pdf_of_a_browser_is_a_file_of_the_export() {
    let folder = folder("pdf");
    let (project, browser, out) = (project(&folder, |_| {}), browser(&folder, PRINTS), folder.join("out"));
    let done = macroline(&["export", text(&project), "--out", text(&out), "--pdf", "--browser", &browser]);
    assert_eq!(done.status.code(), Some(0), "{}", error_text(&done));
    let stdout = String::from_utf8(done.stdout).unwrap();
    for name in ["summary.pdf", "report.pdf"] {
        assert_eq!(fs::read_to_string(out.join(name)).unwrap(), "%PDF-1.4");
        assert!(stdout.contains(&format!("{name}\n")), "{stdout}");
    }
}

#[test]
#[cfg(unix)]
fn browser_that_prints_nothing_or_is_missing_exports_nothing() {
    let folder = folder("no-pdf");
    let (project, out) = (project(&folder, |_| {}), folder.join("out"));
    let fails = browser(&folder, "exit 3");
    for (browser, reason) in
        [(fails.as_str(), "printed no PDF (exit status: 3)"), ("/no/such/browser", "/no/such/browser: ")]
    {
        let done = macroline(&["export", text(&project), "--out", text(&out), "--pdf", "--browser", browser]);
        assert_eq!(done.status.code(), Some(1));
        assert!(error_text(&done).contains(reason), "{}", error_text(&done));
        assert!(!out.exists());
    }
    let without = command::macroline()
        .args(["export", text(&project), "--out", text(&out), "--pdf"])
        .env("PATH", "")
        .output()
        .unwrap();
    assert!(error_text(&without).contains("install Chromium, Chrome or Edge"), "{}", error_text(&without));
    assert_eq!(macroline(&["export", text(&project), "--out", "out", "--browser", "any"]).status.code(), Some(2));
}

#[test]
fn links_are_replaced_and_not_followed() {
    let folder = folder("links");
    let project = project(&folder, |_| {});
    let out = folder.join("out");
    fs::create_dir(&out).unwrap();
    fs::write(folder.join("elsewhere"), "untouched").unwrap();
    std::os::unix::fs::symlink(folder.join("elsewhere"), out.join("O9100.nc")).unwrap();
    let done = macroline(&["export", text(&project), "--out", text(&out)]);
    assert!(done.status.success(), "{}", error_text(&done));
    assert_eq!(fs::read_to_string(folder.join("elsewhere")).unwrap(), "untouched");
    assert!(fs::read_to_string(out.join("O9100.nc")).unwrap().contains("O9100"));
    assert!(!fs::symlink_metadata(out.join("O9100.nc")).unwrap().is_symlink());
}

#[test]
fn concurrent_exports_do_not_mix() {
    let folder = folder("concurrent");
    let out = folder.join("out");
    let alone: Vec<_> = ["8", "12.5"]
        .iter()
        .map(|pitch| {
            let own = folder.join(pitch);
            fs::create_dir(&own).unwrap();
            let project = project(&own, |project| project["values"]["pitch"] = serde_json::from_str(pitch).unwrap());
            let done = macroline(&["export", text(&project), "--out", text(&own.join("out"))]);
            assert!(done.status.success(), "{}", error_text(&done));
            (project, contents(&own.join("out")))
        })
        .collect();
    let start = |at: usize| {
        let mut command = command::macroline();
        command.args(["export", text(&alone[at % 2].0), "--out", text(&out)]);
        command.stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap()
    };
    let running: Vec<_> = (0..8).map(start).collect();
    for mut child in running {
        assert!(child.wait().unwrap().success());
    }
    let all = contents(&out);
    assert!(alone.iter().any(|(_, own)| *own == all), "{:?}", all.iter().map(|(name, _)| name).collect::<Vec<_>>());
}

#[test]
fn names_that_would_be_one_file_are_an_error() {
    for (one, other) in [("O1.nc", "O1.nc"), ("O1.nc", "o1.NC"), ("O1.nc", "O1.nc."), ("Report.MD", "O2.nc")] {
        let folder = folder("names");
        let project = project(&folder, |project| {
            let program = |name: &str, number: u32| json!({ "name": name, "text": format!("%\nO{number}\nM30\n%\n") });
            project["edited"] = json!([program(one, 1), program(other, 2)]);
        });
        let out = folder.join("out");
        let done = macroline(&["export", text(&project), "--out", text(&out)]);
        assert_eq!(done.status.code(), Some(1), "{one} {other}");
        assert!(error_text(&done).contains("would be one file"), "{}", error_text(&done));
        assert!(!out.exists());
    }
}

/// Runs a line of the shell; `$0` is macroline and `$1` the argument.
#[cfg(unix)]
fn shell(line: &str, argument: &str) -> Output {
    command::in_english("sh").args(["-c", line, command::MACROLINE, argument]).output().unwrap()
}

#[cfg(unix)]
#[test]
fn closed_and_full_outputs_end_without_a_panic() {
    let folder = folder("outputs");
    let project = project(&folder, |_| {});
    let out = folder.join("out");
    let export = format!("export \"$1\" --out {}", text(&out));
    for command in ["list", "new ribbon-line", "design \"$1\"", "design \"$1\" --json", "run \"$1\"", &export] {
        let full = shell(&format!("\"$0\" {command} > /dev/full"), text(&project));
        assert_eq!(full.status.code(), Some(1), "{command}: {}", error_text(&full));
        assert!(error_text(&full).contains("the disk is full"), "{command}: {}", error_text(&full));
        let broken = shell(&format!("{{ \"$0\" {command}; echo $? >&2; }} | true"), text(&project));
        assert!(!error_text(&broken).contains("panicked"), "{command}: {}", error_text(&broken));
        assert!(error_text(&broken).ends_with("0\n"), "{command}: {}", error_text(&broken));
        let closed = shell(&format!("\"$0\" {command} >&-"), text(&project));
        assert_eq!(closed.status.code(), Some(0), "{command}: {}", error_text(&closed));
        let silent = shell(&format!("\"$0\" {command} 2> /dev/full > /dev/null"), text(&project));
        assert!(matches!(silent.status.code(), Some(0 | 1)), "{command}");
    }
    // All files of the export are written although their list could not be printed.
    assert!(contents(&out).iter().any(|(name, text)| name == "O9100.nc" && text.ends_with("%\n")));
}

#[test]
fn wrong_shapes_are_refused_by_every_command() {
    let folder = folder("shapes");
    for (change, place) in [
        (json!({ "values": [1] }), "project.json:1:"),
        (json!({ "values": { "pitchh": 9 } }), "“pitchh”"),
        (json!({ "valuess": {} }), "valuess"),
        (json!({ "switches": { "moon": "full" } }), "“moon”"),
    ] {
        let path =
            project(&folder, |project| project.as_object_mut().unwrap().extend(change.as_object().unwrap().clone()));
        let out = folder.join("out");
        let done = macroline(&["export", text(&path), "--out", text(&out)]);
        assert_eq!(done.status.code(), Some(1), "{change}");
        assert!(
            error_text(&done).contains(place) && error_text(&done).contains("--> project.json:1:"),
            "{}",
            error_text(&done)
        );
        assert!(!out.exists());
        for command in ["design", "check", "run"] {
            let done = macroline(&[command, text(&path), "--json"]);
            assert_eq!(done.status.code(), Some(1), "{command} {change}");
            let answer: Json = serde_json::from_slice(&done.stdout).unwrap();
            let first = &answer["diagnostics"][0];
            assert_eq!((&first["severity"], &first["file"]), (&json!("error"), &json!("project.json")), "{first}");
            assert!(first["line"] == 1 && first["column"].as_u64().is_some_and(|at| at > 1), "{first}");
        }
    }
}

#[test]
fn project_that_does_not_load_is_reported_as_json() {
    let folder = folder("unloaded");
    let path = folder.join("project.json");
    fs::write(&path, "{ \"version\": 1,").unwrap();
    for command in ["design", "check", "run"] {
        let done = macroline(&[command, text(&path), "--json"]);
        assert_eq!(done.status.code(), Some(1));
        let answer: Json = serde_json::from_slice(&done.stdout).unwrap();
        assert_eq!(answer["diagnostics"][0]["id"], "project.not-json");
        assert!(done.stderr.is_empty());
    }
}

fn utf16(text: &str, little: bool) -> Vec<u8> {
    let units = std::iter::once(0xfeff).chain(text.encode_utf16());
    units.flat_map(|unit| if little { unit.to_le_bytes() } else { unit.to_be_bytes() }).collect()
}

#[test]
fn encodings_are_read_or_named() {
    let folder = folder("encodings");
    let path = project(&folder, |_| {});
    let plain = fs::read_to_string(&path).unwrap();
    let design = macroline(&["design", text(&path)]);
    for bytes in [utf16(&plain, true), utf16(&plain, false), format!("\u{feff}{plain}").into_bytes()] {
        fs::write(&path, bytes).unwrap();
        let same = macroline(&["design", text(&path)]);
        assert_eq!((&same.stdout, same.status.code()), (&design.stdout, design.status.code()), "{}", error_text(&same));
    }
    // 主 in GBK.
    let mut bytes = plain.replace("\"name\":\"\"", "\"name\":\"#\"").into_bytes();
    let at = bytes.windows(3).position(|window| window == b"\"#\"").unwrap() + 1;
    bytes.splice(at..=at, [0xd6, 0xf7]);
    fs::write(&path, bytes).unwrap();
    let refused = macroline(&["design", text(&path)]);
    assert_eq!(refused.status.code(), Some(1));
    assert!(error_text(&refused).contains(&format!("Byte {at} of the file is not UTF-8")), "{}", error_text(&refused));
    let program = folder.join("O1.nc");
    for little in [true, false] {
        fs::write(&program, utf16("%\nO1\nM30\n%\n", little)).unwrap();
        let named = macroline(&["check", text(&program), "--control", "mitsubishi-e60"]);
        assert_eq!(named.status.code(), Some(1));
        assert!(
            error_text(&named).contains("UTF-16") && error_text(&named).ends_with("1 error\n"),
            "{}",
            error_text(&named)
        );
    }
}

#[test]
fn files_that_are_no_text_are_named() {
    let folder = folder("no-text");
    let path = folder.join("O1.nc");
    for (start, word) in [
        (&b"PK\x03\x04\x14\0"[..], "ZIP"),
        (b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1\0", "DOC"),
        (b"{\\rtf1 ", "RTF"),
        (b"%PDF-1.4\n", "PDF"),
        (b"\x7fELF\x02\x01", "computer"),
    ] {
        fs::write(&path, [start, b"O1\nG00 X1.\nM30\n\xff\0"].concat()).unwrap();
        for command in ["check", "run"] {
            let named = macroline(&[command, text(&path), "--control", "mitsubishi-e60"]);
            assert_eq!(named.status.code(), Some(1), "{word}");
            assert!(
                error_text(&named).contains(word) && error_text(&named).ends_with("1 error\n"),
                "{}",
                error_text(&named)
            );
        }
        let project = macroline(&["design", text(&path)]);
        assert!(error_text(&project).contains(word) && project.status.code() == Some(1), "{}", error_text(&project));
    }
}

#[test]
fn error_in_a_branch_never_taken_is_no_failure() {
    let folder = folder("branches");
    let path = folder.join("O1.nc");
    let status = |program: &str| {
        fs::write(&path, program).unwrap();
        let done = macroline(&["run", text(&path), "--control", "mitsubishi-e60"]);
        (done.status.code(), error_text(&done))
    };
    for block in ["#2=1/0", "X5.Q[", "G777"] {
        let (code, stderr) = status(&format!("%\nO1\nGOTO10\n{block}\nN10M30\n%\n"));
        assert_eq!(code, Some(0), "{stderr}");
        assert!(stderr.contains("warning[P") && stderr.contains("did not come to this block"), "{stderr}");
        let (code, stderr) = status(&format!("%\nO1\n{block}\nN10M30\n%\n"));
        assert_eq!(code, Some(1), "{stderr}");
        // Checked without a run it is an error.
        assert_eq!(macroline(&["check", text(&path), "--control", "mitsubishi-e60"]).status.code(), Some(1));
    }
}

#[test]
fn fixes_count_the_bytes_of_the_file() {
    let folder = folder("offsets");
    let path = folder.join("O1.nc");
    // A comment of eight characters in GBK, then a mistake that has a fix.
    let mut bytes = b"%\nO1\n(".to_vec();
    bytes.extend([0xd6, 0xf7, 0xd6, 0xe1, 0xd7, 0xaa, 0xcb, 0xd9]);
    bytes.extend(b")\nIF[#1==0]GOTO1\nN1\nM30\n%\n");
    fs::write(&path, &bytes).unwrap();
    let done = macroline(&["check", text(&path), "--control", "mitsubishi-e60", "--json"]);
    let answer: Json = serde_json::from_slice(&done.stdout).unwrap();
    let fixes = answer["diagnostics"].as_array().unwrap().iter().flat_map(|d| d["fixes"].as_array().unwrap());
    let edits: Vec<&Json> = fixes.flat_map(|fix| fix["edits"].as_array().unwrap()).collect();
    let sign = bytes.windows(2).position(|pair| pair == b"==").unwrap();
    assert!(edits.iter().any(|edit| edit["start"] == sign && edit["end"] == sign + 2), "{edits:?}");
    for edit in edits {
        let (start, end) = (edit["start"].as_u64().unwrap() as usize, edit["end"].as_u64().unwrap() as usize);
        assert!(start <= end && end <= bytes.len() && edit["text"].as_str().unwrap().is_ascii(), "{edit}");
    }
}

#[test]
fn files_of_one_name_are_distinguished() {
    let folder = folder("same-name");
    let paths: Vec<PathBuf> = ["a/x/O1.nc", "b/x/O1.nc", "b/x/O2.nc"].iter().map(|path| folder.join(path)).collect();
    for path in &paths {
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, "%\nO1\n#2000=1\nM30\n%\n").unwrap();
    }
    let mut args = vec!["check", "--control", "mitsubishi-e60", "--json"];
    args.extend(paths.iter().map(|path| text(path)));
    let answer: Json = serde_json::from_slice(&macroline(&args).stdout).unwrap();
    let found = answer["diagnostics"].as_array().unwrap().iter().filter(|d| d["alarm"] == "P241");
    let files: Vec<&str> = found.map(|d| d["file"].as_str().unwrap()).collect();
    assert_eq!(files, ["a/x/O1.nc", "b/x/O1.nc", "O2.nc"]);
}

/// Text that a terminal or a document would interpret: escape sequences, C1, the writing direction, markup, line ends.
const HOSTILE: &str = "\u{1b}[31m\u{9b}2J\u{202e}<script>alert(1)</script>\u{2066}[x](http://x)";

fn obeyed(text: &str) -> bool {
    text.contains(|c: char| {
        (c.is_control() && c != '\n') || matches!(c, '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
    })
}

#[test]
fn hostile_text_is_escaped_wherever_it_leaves() {
    let folder = folder("hostile");
    let program = folder.join("O1.MPF");
    fs::write(&program, format!("%_N_A_MPF\nMSG(\"{HOSTILE}\")\nG0 X1 ;{HOSTILE}\nG999 {HOSTILE}\nM30\n")).unwrap();
    for command in ["check", "run"] {
        let done = macroline(&[command, text(&program), "--control", "sinumerik-802d"]);
        for stream in [&done.stdout, &done.stderr] {
            let output = String::from_utf8(stream.clone()).unwrap();
            assert!(!obeyed(&output), "{command}: {output:?}");
        }
    }
    let path = project(&folder, |project| {
        project["name"] = json!(format!("{HOSTILE}\n# heading"));
        project["values"]["customer"] = json!(format!("{HOSTILE}\n# heading"));
    });
    let out = folder.join("out");
    let done = macroline(&["export", text(&path), "--out", text(&out)]);
    assert!(!obeyed(&error_text(&done)));
    if done.status.success() {
        let report = fs::read_to_string(out.join("report.md")).unwrap();
        assert!(!report.contains("<script>") && !report.contains("](http") && !obeyed(&report), "{report}");
        assert!(!report.lines().any(|line| line.starts_with("# heading")), "{report}");
        let saved: Json = serde_json::from_str(&fs::read_to_string(out.join("project.json")).unwrap()).unwrap();
        assert!(saved["values"]["customer"].as_str().unwrap().contains("<script>"), "JSON stays data");
    } else {
        assert!(error_text(&done).contains("customer"), "{}", error_text(&done));
    }
    let missing = macroline(&["check", "\u{1b}[31m\u{202e}.nc", "--control", "mitsubishi-e60"]);
    assert!(missing.status.code() == Some(2) && !obeyed(&error_text(&missing)), "{:?}", error_text(&missing));
}

/// Processor time in seconds of a command in a shell, user and system.
#[cfg(unix)]
fn processor(path: &Path, command: &str) -> f64 {
    let out = shell(&format!("\"$0\" {command} > /dev/null 2>&1; times"), text(path));
    let times = String::from_utf8(out.stdout).unwrap();
    let of_children = times.lines().nth(1).unwrap();
    let seconds = |time: &str| {
        let (minutes, seconds) = time.trim_end_matches('s').split_once('m').unwrap();
        minutes.parse::<f64>().unwrap() * 60.0 + seconds.parse::<f64>().unwrap()
    };
    of_children.split_whitespace().map(seconds).sum()
}

/// Four times the size may take six times the processor time, start-up excluded; a quadratic algorithm would take sixteen times.
#[cfg(unix)]
#[test]
fn large_projects_take_no_quadratic_time() {
    let folder = folder("large");
    let size = |count: usize, make: &dyn Fn(usize, &mut Json)| project(&folder, |project| make(count, project));
    let keys = |count: usize, project: &mut Json| {
        for key in 0..count {
            project["values"][format!("unknown-{key}")] = json!(key);
        }
    };
    let panel = |count: usize, project: &mut Json| {
        let event = |at: usize| json!({ "t": (count - at) as f64 / 1e6, "spindle_override": 80 + at % 20 });
        project["panel"] = (0..count).map(event).collect();
    };
    let inputs = |count: usize, project: &mut Json| {
        let event = |at: usize| json!({ "t": (count - at) as f64 / 1e6, "input": { format!("R{}", 900 + at): 1 } });
        project["panel"] = (0..count).map(event).collect();
    };
    for (name, make) in [("keys", &keys as &dyn Fn(usize, &mut Json)), ("panel", &panel), ("inputs", &inputs)] {
        for command in ["design \"$1\" --json", "run \"$1\" --json --no-canon --seconds 1"] {
            let small = processor(&size(10_000, make), command);
            let large = processor(&size(40_000, make), command);
            assert!(large <= 6.0 * small + 0.3, "{name}, {command}: {small} s for 10,000, {large} s for 40,000");
        }
    }
}

/// Checks the processor time of commands on a program of 10,000 blocks against one of 40,000.
#[cfg(unix)]
fn assert_no_quadratic_time(path: &Path, name: &str, commands: &[&str], program: &dyn Fn(usize) -> String) {
    for command in commands {
        let [small, large] = [10_000, 40_000].map(|count| {
            fs::write(path, program(count)).unwrap();
            processor(path, command)
        });
        assert!(large <= 6.0 * small + 0.3, "{name}, {command}: {small} s for 10,000, {large} s for 40,000");
    }
}

/// Makes the lines of a program that belong to a number.
type Lines<'a> = &'a dyn Fn(usize) -> String;

/// Programs with many faults of each kind that once compared a block with all others.
#[cfg(unix)]
#[test]
fn large_faulty_programs_take_no_quadratic_time() {
    let folder = folder("large-programs");
    let unread = |at: usize| format!("N10A{at}: X=\nGOTOF B{at}\n");
    let in_unread = |at: usize| format!("N10 X= A{at}X\nGOTOF A{at}X\n");
    let numbers = |at: usize| format!("N{at} G4 F1\nGOTOF N{at}\n");
    let labels = |at: usize| format!("A{at}X: G4 F1\nGOTOF A{at}X\n");
    let calls = |at: usize| format!("A{at}X\n");
    let programs = |at: usize| format!("%_N_A{at}X_SPF\nA{at}Y\nM17\n");
    let if_then = |at: usize| format!("IF[#1EQ{at}]THEN G00X1.\n");
    let loops = |at: usize| format!("WHILE[#1EQ{at}]DO1\nEND2\n");
    let jumps = |at: usize| format!("N{at}GOTO{}\n", at + 1);
    let one_label = |at: usize| format!("AGAIN: R1={at}\nIF R1==R2 GOTOB AGAIN\n");
    let records = |at: usize| format!("(PART {at})\n%\n");
    let cases: [(&str, &str, &str, Lines); 11] = [
        ("sinumerik-802d", "%_N_A_MPF\n", "unread labels", &unread),
        ("sinumerik-802d", "%_N_A_MPF\n", "labels in unread blocks", &in_unread),
        ("sinumerik-802d", "%_N_A_MPF\n", "block numbers", &numbers),
        ("sinumerik-802d", "%_N_A_MPF\n", "labels", &labels),
        ("sinumerik-802d", "%_N_A_MPF\n", "calls", &calls),
        ("sinumerik-802d", "", "programs", &programs),
        ("mitsubishi-e60", "O1\n", "IF THEN", &if_then),
        ("mitsubishi-e60", "O1\n", "loops", &loops),
        ("mitsubishi-e60", "O1\n", "jumps", &jumps),
        ("sinumerik-802d", "%_N_A_MPF\n", "one label", &one_label),
        ("mitsubishi-e60", "", "comments between %", &records),
    ];
    let path = folder.join("large.nc");
    let command = |control: &str| format!("check \"$1\" --control {control} --json");
    for (control, head, name, block) in cases {
        let program = |count: usize| head.to_owned() + &(1..=count).map(block).collect::<String>() + "M30\n";
        assert_no_quadratic_time(&path, name, &[&command(control)], &program);
    }
    // One line of brackets, in a file that names a missing variable, for which free ones are proposed.
    let brackets = |count: usize| "O1\n#9999=1\n".to_owned() + &"(".repeat(10 * count);
    assert_no_quadratic_time(&path, "open brackets", &[&command("mitsubishi-e60")], &brackets);
    let words = |count: usize| ("X1Y1".repeat(count / 4) + "\n").repeat(20);
    assert_no_quadratic_time(&path, "words of a block", &[&command("sinumerik-802d")], &words);
}

/// Programs without errors: warnings follow jumps, calls and variables, and a run executes every block.
#[cfg(unix)]
#[test]
fn large_good_programs_take_no_quadratic_time() {
    let folder = folder("large-good-programs");
    // Block numbers have four digits, so they restart from 1.
    let number = |at: usize| at % 9999 + 1;
    let assigned = |at: usize| format!("N{}#100=#101+{at}\n", number(at));
    let jumps = |at: usize| format!("N{}IF[#100EQ{at}]GOTO{}\n", number(at), number(at));
    let moves = |at: usize| format!("N{}G91G01X{}.F100.\n", number(at), at % 7);
    let loops = |at: usize| format!("#1=0\nWHILE[#1LT1]DO1\n#1=#1+1\nS{}M03\nEND1\n", at % 5000 + 1);
    let divisors = |at: usize| format!("#{}=1/[#1-#{}]\n", at % 49 + 100, at % 49 + 101);
    let subs = |at: usize| format!("M98P2H{}\n", at % 900 + 1);
    let sub = "M30\nO2\n".to_owned() + &(1..=900).map(|at| format!("N{at}#100=#100+1\n")).collect::<String>() + "M99\n";
    let twice = |at: usize| format!("O{at}\nN1IF[#1EQ1]GOTO1\nN1M99P{at}\n");
    let programs = |at: usize| format!("O{at}\nM98P{}\n#100=1/#500\nM99\n", at + 1);
    let functions = |at: usize| format!("N{} G65 H81 P{} Q#100 R{at}\n", number(at), number(at));
    let r_parameters = |at: usize| format!("N{} R{}=R2+{at}/R{}\n", number(at), at % 250, at % 249);
    let labels = |at: usize| format!("AB{at}: R1=R2+{at}\nIF R1=={at} GOTOB AB{at}\nGOTOF CD{at}\nCD{at}: R3=1\n");
    let names = |at: usize| format!("G1 X=IC(R{}) Y=AC({}) F=R2+100\nMSG(\"PART {at}\")\n", at % 250, at % 7);
    let called = |at: usize| format!("%_N_SUB{at}_SPF\nSUB{}\nM17\n", at + 1);
    type Case<'a> = (&'a str, &'a str, &'a str, Lines<'a>, &'a str);
    let cases: [Case; 13] = [
        ("mitsubishi-e60", "assignments", "O1\n", &assigned, "M30\n"),
        ("mitsubishi-e60", "jumps", "O1\n", &jumps, "M30\n"),
        ("mitsubishi-e60", "moves", "O1\n", &moves, "M30\n"),
        ("mitsubishi-e60", "loops", "O1\n", &loops, "M30\n"),
        ("mitsubishi-e60", "divisors", "O1\n", &divisors, "M30\n"),
        ("mitsubishi-e60", "calls with H", "O1\n", &subs, &sub),
        ("mitsubishi-e60", "programs with jumps", "", &twice, ""),
        ("mitsubishi-e60", "programs that call the next", "", &programs, ""),
        ("gsk-980tdc", "G65 H", "O1\n", &functions, "M30\n"),
        ("sinumerik-802d", "R parameters", "%_N_MAIN_MPF\n", &r_parameters, "M2\n"),
        ("sinumerik-802d", "labels", "%_N_MAIN_MPF\n", &labels, "M2\n"),
        ("sinumerik-802d", "names", "%_N_MAIN_MPF\nF100\n", &names, "M2\n"),
        ("sinumerik-802d", "programs that call the next", "", &called, ""),
    ];
    for (control, name, head, block, tail) in cases {
        let program = |count: usize| head.to_owned() + &(1..=count).map(block).collect::<String>() + tail;
        let commands = ["check", "run"].map(|command| format!("{command} \"$1\" --control {control} --json"));
        let commands = commands.each_ref().map(String::as_str);
        let path = folder.join("large.nc");
        fs::write(&path, program(1000)).unwrap();
        let checked = macroline(&["check", text(&path), "--control", control]);
        assert!(checked.status.success(), "{name}: {}", error_text(&checked));
        assert_no_quadratic_time(&path, name, &commands, &program);
    }
}
