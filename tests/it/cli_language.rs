//! The language of the command line's texts: chosen by option or locale, complete in each language, and absent from output for programs.

use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Output, Stdio};

use serde_json::Value as Json;

use super::command;

/// Every command.
const COMMANDS: [&str; 11] =
    ["list", "parts", "new", "design", "size", "compare", "export", "draw", "check", "explain", "run"];

/// A folder of its own for one test, emptied first.
fn folder(name: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("language").join(name);
    let _ = std::fs::remove_dir_all(&path);
    std::fs::create_dir_all(&path).unwrap();
    path
}

/// Runs the program with `--language zh` after the arguments.
fn chinese(folder: &Path, args: &[&str]) -> Output {
    command::macroline().current_dir(folder).args(args).args(["--language", "zh"]).output().unwrap()
}

/// Both outputs as one text.
fn text(out: &Output) -> String {
    [&out.stdout, &out.stderr].map(|bytes| String::from_utf8_lossy(bytes).into_owned()).concat()
}

/// Lines with three lowercase English words in a row.
fn english(text: &str) -> Vec<&str> {
    let is_word = |word: &&str| word.len() > 1 && word.bytes().all(|byte| byte.is_ascii_lowercase());
    let has_three = |line: &&str| {
        let words: Vec<&str> = line.split_whitespace().collect();
        words.windows(3).any(|three| three.iter().all(is_word))
    };
    text.lines().filter(has_three).collect()
}

#[track_caller]
fn assert_chinese(text: &str) {
    assert!(text.contains(|c| ('\u{4e00}'..='\u{9fff}').contains(&c)), "no Chinese: {text}");
    assert_eq!(english(text), Vec::<&str>::new());
}

/// A project file of a machine's first example.
fn project(folder: &Path, machine: &str) -> String {
    let name = format!("{machine}.json");
    std::fs::write(folder.join(&name), chinese(folder, &["new", machine]).stdout).unwrap();
    name
}

/// A program whose third block divides by 0.
fn broken(folder: &Path) -> &'static str {
    std::fs::write(folder.join("bad.nc"), "%\nO1\n#100=#107/0\nG01X8\nM30\n%\n").unwrap();
    "bad.nc"
}

#[test]
fn help_of_every_command_is_chinese() {
    let folder = folder("help");
    for command in COMMANDS.into_iter().chain(["step"]) {
        let short = text(&chinese(&folder, &[command, "-h"]));
        let by_name = command::macroline().args(["--language=zh", "help", command]).output().unwrap();
        for help in [short, text(&chinese(&folder, &[command, "--help"])), text(&by_name)] {
            assert_chinese(&help);
            assert!(help.contains(&format!("用法：macroline {command} [选项]")), "{help}");
            assert!(
                !["Usage", "Options", "Arguments", "default:", "values:", "Print"].iter().any(|s| help.contains(s))
            );
        }
    }
    let help = text(&chinese(&folder, &["--help"]));
    assert_chinese(&help);
    assert!(help.contains("\n命令：\n  list ") && help.contains("显示版本"), "{help}");
}

#[test]
fn list_design_and_size_are_chinese() {
    let folder = folder("outputs");
    assert_chinese(&text(&chinese(&folder, &["list"])));
    for machine in ["ribbon-line", "turning-spindle", "polygon-lathe"] {
        let project = project(&folder, machine);
        for args in [&["design", &project][..], &["run", &project, "--no-canon"], &["check", &project]] {
            assert_chinese(&text(&chinese(&folder, args)));
        }
    }
    assert_chinese(&text(&chinese(&folder, &["size", "ribbon-line.json", "--draws", "2"])));
    assert_chinese(&text(&chinese(&folder, &["compare", "ribbon-line.json", "turning-spindle.json"])));
    let printed = text(&chinese(&folder, &["new", "ribbon-line", "--example", "paper"]));
    assert!(printed.contains("\n不满足  辊带速比："), "{printed}");
}

#[test]
fn check_with_errors_is_chinese() {
    let folder = folder("check");
    let out = chinese(&folder, &["check", broken(&folder), "--control", "mitsubishi-e60"]);
    assert_eq!(out.status.code(), Some(1));
    let printed = text(&out);
    assert_chinese(&printed);
    assert!(printed.contains("错误[P283]：除数为 0。") && printed.contains(" 处错误、"), "{printed}");
    assert!(printed.contains("系统显示：P283 ") && printed.contains("\n建议："), "{printed}");
}

#[test]
fn step_answers_in_chinese() {
    let folder = folder("step");
    let mut command = command::macroline();
    command.current_dir(&folder).args(["step", broken(&folder), "--control", "mitsubishi-e60", "--language", "zh"]);
    let mut child = command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    let script = b"help\nlocals\nbreaks\nbreak N9\nbreak 4 if #107 GT 1\nbreaks\noff 1\noff 2\nbreaks\nwatch #107\n\
        set x\nback\nfault x\ncontinue\nwhere\nstack\nreset\nnonsense\nquit\n";
    child.stdin.take().unwrap().write_all(script).unwrap();
    let printed = text(&child.wait_with_output().unwrap());
    assert_chinese(&printed);
    assert!(printed.contains("监视 1：#107 = 空\n") && printed.contains("停止 0 次，已停用\n"), "{printed}");
}

#[test]
fn wrong_usage_is_reported_in_chinese() {
    let folder = folder("usage");
    broken(&folder);
    for line in [
        "frobnicate",
        "lst",
        "list --jso",
        "list extra",
        "list --json=1",
        "list --json --json",
        "run",
        "export x",
        "check bad.nc --format xml",
        "check bad.nc --format json --json",
        "run bad.nc --blocks x",
        "size x --seed",
        "new nope",
        "new ribbon-line --control x",
        "new ribbon-line --example x",
        "check missing.nc --control x",
        "check bad.nc --control mitsubishi-e60 --switch x",
        "check bad.nc --control mitsubishi-e60 --switch x=1",
        "check bad.nc --control mitsubishi-e60 --switch modulo=x",
        "check bad.nc --control mitsubishi-e60 --silence x",
        "run bad.nc --control mitsubishi-e60 --set x",
        "run bad.nc --control mitsubishi-e60 --set x=1",
        "run bad.nc --control mitsubishi-e60 --start x",
        "run bad.nc --control mitsubishi-e60 --seconds=-1",
        "check bad.nc",
        "draw x --out x --at=-1",
    ] {
        let out = chinese(&folder, &line.split(' ').collect::<Vec<_>>());
        assert_eq!(out.status.code(), Some(2), "{line}");
        assert!(text(&out).contains(|c| ('\u{4e00}'..='\u{9fff}').contains(&c)), "{line}: {}", text(&out));
        assert!(english(&text(&out)).is_empty() && !text(&out).contains("Usage"), "{line}: {}", text(&out));
    }
}

// The reason after the colon is worded by serde or the system, and stays in their language.
#[test]
fn broken_json_is_reported_in_chinese() {
    let folder = folder("json");
    for file in [
        "{",
        "{\"a\":1,}",
        "{\"a\":nul}",
        "{\"a\":\"\\x\"}",
        "{\"a\":1}x",
        "{\"a\":\"\u{1}\"}",
        "{\"version\":1,\"values\":[1]}",
        "{\"version\":1,\"nam\":1}",
        "{\"version\":1,\"name\":2.5}",
        "{\"version\":1,\"name\":\"a\",\"name\":\"b\"}",
        "{\"version\":1,\"edited\":[{\"name\":\"x\"}]}",
        "{\"version\":1,\"edited\":[{\"nam\":1}]}",
        "{\"version\":1,\"title_block\":true}",
    ] {
        std::fs::write(folder.join("j.json"), file).unwrap();
        let printed = text(&chinese(&folder, &["check", "j.json"]));
        let sentence = printed.lines().next().unwrap();
        assert!(
            sentence.starts_with("错误：这不是 JSON：") || sentence.starts_with("错误：内容不符合"),
            "{file}: {printed}"
        );
    }
}

#[test]
fn locale_chooses_the_language_unless_the_option_does() {
    let prints_chinese = |locale: [&str; 3], args: &[&str]| {
        let [all, messages, lang] = locale;
        let mut command = command::macroline();
        command.env("LC_ALL", all).env("LC_MESSAGES", messages).env("LANG", lang).args(args);
        let out = text(&command.output().unwrap());
        out.starts_with("机床\n")
    };
    for (locale, is_chinese) in [
        (["", "", "zh_CN.UTF-8"], true),
        (["zh_TW.UTF-8", "", "C"], true),
        (["", "zh_CN", "en_US.UTF-8"], true),
        (["C", "zh_CN", "zh_CN.UTF-8"], false),
        (["", "", "C"], false),
        (["", "", "de_DE.UTF-8"], false),
        (["", "", ""], false),
    ] {
        assert_eq!(prints_chinese(locale, &["list"]), is_chinese, "{locale:?}");
        assert!(
            prints_chinese(locale, &["list", "--language", "zh"]) && prints_chinese(locale, &["--language=zh", "list"]),
            "{locale:?}"
        );
        assert!(
            !prints_chinese(locale, &["list", "--language=en"])
                && !prints_chinese(locale, &["--language", "en", "list"]),
            "{locale:?}"
        );
    }
}

/// The keys of a JSON value with their values, except texts with Chinese or English words.
fn neutral(json: &Json, path: &str, out: &mut Vec<String>) {
    match json {
        Json::Object(rows) => rows.iter().for_each(|(key, value)| neutral(value, &format!("{path}.{key}"), out)),
        Json::Array(list) => list.iter().for_each(|value| neutral(value, &format!("{path}[]"), out)),
        Json::String(text) => {
            let is_id = [".id", ".ended", ".severity", ".verdict", ".origin", ".canon[]", ".machine", ".control"]
                .iter()
                .any(|end| path.ends_with(end));
            out.push(if is_id { format!("{path}={text}") } else { path.to_owned() });
        }
        other => out.push(format!("{path}={other}")),
    }
}

#[test]
fn programs_and_json_are_the_same_in_every_language() {
    let folder = folder("neutral");
    let english = |args: &[&str]| command::macroline().current_dir(&folder).args(args).output().unwrap();
    let bad = broken(&folder);
    for machine in ["ribbon-line", "turning-spindle", "polygon-lathe"] {
        assert_eq!(chinese(&folder, &["new", machine]).stdout, english(&["new", machine]).stdout);
        let project = project(&folder, machine);
        for args in [
            &["design", &project, "--json"][..],
            &["run", &project, "--json"],
            &["list", "--json"],
            &["run", bad, "--control", "mitsubishi-e60", "--json"],
        ] {
            let [mut one, mut other] = [Vec::new(), Vec::new()];
            neutral(&serde_json::from_slice(&english(args).stdout).unwrap(), "", &mut one);
            neutral(&serde_json::from_slice(&chinese(&folder, args).stdout).unwrap(), "", &mut other);
            assert!(one == other && one.len() > 3, "{args:?}");
        }
        for (out, done) in [
            ("en", english(&["export", &project, "--out", "en"])),
            ("zh", chinese(&folder, &["export", &project, "--out", "zh"])),
        ] {
            assert!(done.status.success(), "{out}: {}", text(&done));
        }
        for entry in std::fs::read_dir(folder.join("en")).unwrap() {
            let name = entry.unwrap().file_name().into_string().unwrap();
            let [one, other] = ["en", "zh"].map(|out| std::fs::read(folder.join(out).join(&name)).unwrap());
            let is_for_controls = name.ends_with(".nc") || name == "project.json" || name.ends_with(".dxf");
            assert!(!is_for_controls || one == other, "{machine} {name}");
        }
    }
    assert_eq!(chinese(&folder, &["parts"]).stdout, english(&["parts"]).stdout);
}

#[test]
fn assumed_facts_are_counted_and_the_first_named() {
    let folder = folder("assumed");
    let project = project(&folder, "ribbon-line");
    let english = |args: &[&str]| command::macroline().current_dir(&folder).args(args).output().unwrap();
    let design: Json = serde_json::from_slice(&english(&["design", &project, "--json"]).stdout).unwrap();
    let ids =
        |list: &str| design[list].as_array().unwrap().iter().map(|fact| fact["field"].as_str().unwrap_or_default());
    let count = ids("assumed").count();
    assert!(count > 50);
    let fields = macroline::machines::find("ribbon-line").unwrap().fields();
    let label = |id: &str| fields.iter().find(|field| field.id == id).unwrap().label;
    let first = design["measure_first"].as_array().unwrap()[0].as_str().unwrap();
    let first = macroline::text::catalog::words(label(first));
    for command in ["check", "design", "run"] {
        let out = text(&english(&[command, &project]));
        let line = out.lines().find(|line| line.contains("only assumed")).unwrap_or_else(|| panic!("{command}: {out}"));
        let named = format!("{count} facts of the machine are only assumed: first of all {first},");
        assert!(line.contains(&named) && line.contains("`design` lists"), "{command}: {line}");
        assert!(ids("assumed").filter(|id| id.contains('-')).all(|id| !line.contains(id)), "{command}: {line}");
        let chinese = text(&chinese(&folder, &[command, &project]));
        let line = chinese.lines().find(|line| line.contains("只是假定")).unwrap();
        assert!(line.contains("首先是"), "{command}: {line}");
        assert_chinese(line);
    }
    let exported = english(&["export", &project, "--out", "out"]);
    assert!(exported.status.success(), "{}", text(&exported));
    let report = std::fs::read_to_string(folder.join("out/report.md")).unwrap();
    let line = report.lines().find(|line| line.contains("facts of the machine are only assumed: ")).unwrap();
    assert!(line.contains(first) && !line.contains("reduction-ratio"), "{line}");
}
