//! Comments of programs in English and Chinese, and their bytes in the control's encoding.

use std::collections::BTreeSet;

use macroline::controls::options::CommentCharacters;
use macroline::controls::{self, Switches};
use macroline::machines;
use macroline::machines::form::Value;
use macroline::motion::{Budget, Retention};
use macroline::nc::{self, Files, Parsed};
use macroline::project::Project;
use macroline::project::files::decode::{Decoded, Encoding};
use macroline::project::files::encode;
use macroline::project::import::open;
use macroline::project::run::{self, RunOptions};
use macroline::text::catalog::parts::{SentencePart, parts};
use macroline::text::catalog::{self, Language, programs};
use serde_json::Value as Json;

use super::command;
use super::queries::every_machine_on_every_control;

const GBK: &str = "gbk";
const UTF8: &str = "utf-8";

/// The project with Chinese comments in an encoding.
fn in_chinese(mut project: Project, encoding: &str) -> Project {
    let row = project.control.switch("comment-characters").unwrap();
    project.switches.set(row, encoding);
    project.comments = Language::Chinese;
    project
}

fn in_english(project: &Project) -> Project {
    let mut project = project.clone();
    project.comments = Language::English;
    project
}

/// Every machine on every control, as a new project and with each of its examples.
fn new_projects_and_examples() -> impl Iterator<Item = Project> {
    every_machine_on_every_control().flat_map(|project| {
        let (machine, control) = (project.machine, project.control);
        let examples = machine.examples().iter().map(move |example| Project::example(machine, control, example));
        std::iter::once(project).chain(examples)
    })
}

fn chinese_projects(encoding: &str) -> Vec<Project> {
    let allowed = new_projects_and_examples().filter(|project| project.control.switch("comment-characters").is_some());
    allowed.map(|project| in_chinese(project, encoding)).collect()
}

/// Comments and titles, without messages to the operator.
fn comments_of(parsed: &Parsed) -> Vec<String> {
    let deck = parsed.deck();
    let blocks = deck.blocks.iter().filter(|block| !nc::is_message(deck, parsed.control(), block));
    let texts = blocks.map(|block| block.comment).chain(deck.programs.iter().map(|program| program.title));
    texts.flatten().map(|id| deck.text(Some(id)).trim().to_owned()).collect()
}

/// Whether a comment is a line of the form's settings, which is not translated.
fn is_setting(comment: &str) -> bool {
    comment.starts_with("MACROLINE ") || comment.split_once('=').is_some_and(|(key, _)| !key.contains(' '))
}

#[test]
fn every_comment_of_every_program_has_chinese() {
    let (mut missing, mut compared) = (BTreeSet::new(), 0);
    for project in chinese_projects(GBK) {
        let [english, chinese] = [in_english(&project), project].map(|project| comments_of(&project.written().parsed));
        assert_eq!(english.len(), chinese.len());
        compared += english.len();
        for (english, chinese) in english.into_iter().zip(chinese) {
            if is_setting(&english) {
                assert_eq!(english, chinese);
            } else if chinese.is_ascii() && english.contains(|c: char| c.is_alphabetic()) {
                missing.insert(english);
            }
        }
    }
    assert!(missing.is_empty(), "no Chinese of {missing:#?}");
    assert!(compared > 100, "{compared} comments");
}

/// Texts of the alarms and messages of a program.
fn messages_of(parsed: &Parsed) -> Vec<String> {
    let deck = parsed.deck();
    let text = |block: &nc::Block| match block.stmt {
        nc::Stmt::Message(text) => text,
        _ => block.comment.filter(|_| nc::is_message(deck, parsed.control(), block)),
    };
    deck.blocks.iter().filter_map(text).map(|id| deck.text(Some(id)).trim().to_owned()).collect()
}

#[test]
fn every_alarm_and_message_of_every_program_has_chinese() {
    let mut all = BTreeSet::new();
    for mut project in new_projects_and_examples() {
        all.extend(messages_of(&project.written().parsed));
        for (field, value) in [("rest", "alarm"), ("job", "product-length")] {
            if project.machine.fields().iter().any(|row| row.id == field) {
                project.values.insert(field.to_owned(), Value::Text(value.to_owned()));
            }
        }
        all.extend(messages_of(&project.written().parsed));
    }
    let missing: Vec<&String> = all.iter().filter(|text| programs::chinese(text).is_none()).collect();
    assert!(missing.is_empty(), "no Chinese of {missing:#?}");
    assert!(all.len() > 20, "{all:#?}");
}

#[test]
fn alarm_of_the_program_has_its_chinese_behind_it() {
    let alarm = macroline::msg!("interp.user-alarm-text", number = 20_u32, text = "FEED #115 ABOVE LIMIT #119");
    let own = macroline::msg!("interp.user-alarm-text", number = 20_u32, text = "CHECK THE DOOR");
    assert_eq!(catalog::sentence(&alarm), "The program raises its alarm 20: FEED #115 ABOVE LIMIT #119");
    catalog::speak(Language::Chinese.sentences());
    let sentences = [alarm, own].map(|alarm| catalog::sentence(&alarm));
    catalog::speak(Language::English.sentences());
    let chinese = "程序产生用户报警 20：FEED #115 ABOVE LIMIT #119（进给 #115 超过上限 #119）";
    assert_eq!(sentences, [chinese, "程序产生用户报警 20：CHECK THE DOOR"]);
}

#[test]
fn every_comment_in_the_sources_has_chinese() {
    let mut seen = 0;
    for folder in machines::ALL.iter().map(|machine| machine.id().replace('-', "_")) {
        let mut folders =
            vec![std::path::PathBuf::from(format!("{}/src/machines/{folder}", env!("CARGO_MANIFEST_DIR")))];
        let mut files = Vec::new();
        while let Some(folder) = folders.pop() {
            let found = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
            let (inner, of_folder): (Vec<_>, Vec<_>) = found.partition(|path| path.is_dir());
            folders.extend(inner);
            files.extend(of_folder);
        }
        for file in files {
            let source = std::fs::read_to_string(&file).unwrap();
            for start in
                [".note(\"", ".comment(\"", "b.program(RUN, \"", "b.program(SETUP, \"", "b.program(COMPUTE, \""]
            {
                for (at, _) in source.match_indices(start) {
                    let text = &source[at + start.len()..];
                    let comment = &text[..text.find('"').unwrap()];
                    assert!(programs::chinese(comment).is_some(), "{}: no Chinese of “{comment}”", file.display());
                    seen += 1;
                }
            }
        }
    }
    assert!(seen > 80, "{seen} comments");
}

#[test]
fn chinese_comments_are_short_and_in_gbk() {
    for (english, chinese) in programs::all() {
        assert!(chinese.chars().all(|c| CommentCharacters::Gbk.has(c)), "{chinese}");
        assert!(!chinese.contains(['(', ')', '%', ';', '"']) && !chinese.is_ascii(), "{chinese}");
        let places = |text: &str| {
            let parts = parts(text).filter(|part| matches!(part, SentencePart::Place(..)));
            parts.map(|part| format!("{part:?}")).collect::<BTreeSet<_>>()
        };
        assert_eq!(places(&english), places(chinese), "{english}");
        assert!(CommentCharacters::Utf8.length(chinese) <= 70, "{chinese}");
    }
}

#[test]
fn values_of_a_comment_are_in_its_chinese() {
    assert_eq!(programs::chinese("X PER PITCH").as_deref(), Some("X 每节距行程"));
    assert_eq!(programs::chinese("THEN X12.5 IS 24 MM ACROSS FLATS").as_deref(), Some("此时 X12.5 对应对边宽度 24 mm"));
    assert_eq!(programs::chinese("X OFFSET OF T3 IS -40."), Some("T3 的 X 刀偏为 -40.".to_owned()));
    for none in ["PITCH=8", "MACROLINE RIBBON-LINE 1", "A NOTE OF THE USER", "", "PER PITCH"] {
        assert_eq!(programs::chinese(none), None, "{none}");
    }
}

/// The canonical log of a project's run, and how it ended.
fn log(project: &Project) -> (Vec<String>, String) {
    let limits = Budget { blocks: 3000, seconds: 60.0 };
    let options = RunOptions { start: None, settings: &[], limits, keep: Retention::Log };
    let mut run = run::of_project(project, &project.written(), &options);
    let mut lines = Vec::new();
    let summary = run::to_end(&mut run, run::AtStop::CycleStart, |line| {
        lines.push(line.to_string());
        Ok::<(), ()>(())
    });
    (lines, summary.unwrap().word().to_owned())
}

#[test]
fn chinese_comments_change_nothing_that_runs() {
    for project in chinese_projects(GBK) {
        let english = in_english(&project);
        assert_eq!(log(&project), log(&english), "{} {}", project.machine.id(), project.control.id);
        let found = project.written().diagnostics;
        assert_eq!(found, english.written().diagnostics, "{} {}", project.machine.id(), project.control.id);
    }
}

#[test]
fn control_without_the_switch_keeps_english() {
    let mut project = Project::of("ribbon-line", None).unwrap();
    project.comments = Language::Chinese;
    assert!(project.control.switch("comment-characters").is_none());
    assert!(project.written().files.0.iter().all(|file| file.text.is_ascii()));
}

#[test]
fn every_character_of_the_table_is_in_gbk() {
    let all: Vec<char> = ('\u{80}'..='\u{ffff}').filter(|c| CommentCharacters::Gbk.has(*c)).collect();
    assert!(all.len() > 20_000);
    let text: String = all.iter().collect();
    let bytes = encode::bytes(&text, CommentCharacters::Gbk);
    assert_eq!(bytes.len(), 2 * all.len());
    assert!(bytes.chunks(2).all(|pair| !b"()%;\"\r\n".contains(&pair[1])));
    assert_eq!(Decoded::new(bytes).in_gbk().unwrap().text, text);
    assert_eq!(encode::bytes("漢😀é", CommentCharacters::Gbk), [0x9d, 0x68, b'?', b'?']);
}

#[test]
fn gbk_is_read_back_with_the_offsets_of_the_file() {
    for project in chinese_projects(GBK) {
        for file in &project.written().files.0 {
            let bytes = encode::bytes(&file.text, CommentCharacters::Gbk);
            let unknown = Decoded::new(bytes.clone());
            assert_eq!(unknown.encoding, Encoding::Unknown);
            let read = unknown.in_gbk().unwrap();
            assert_eq!((&read.text, read.encoding), (&file.text, Encoding::Gbk));
            for (at, c) in read.text.char_indices() {
                let offset = read.offset(at as u32).unwrap() as usize;
                let width = CommentCharacters::Gbk.width(c);
                assert_eq!(encode::bytes(&c.to_string(), CommentCharacters::Gbk), bytes[offset..offset + width]);
                assert!(c.is_ascii() || read.offset(at as u32 + 1).is_none());
            }
            assert_eq!(read.offset(read.text.len() as u32), Some(bytes.len() as u32));
        }
    }
}

#[test]
fn bytes_that_are_no_gbk_stay_unknown() {
    for bytes in [&b"(\xff\xff)"[..], b"(\xb3)", b"(\x80)"] {
        let read = Decoded::new(bytes.to_vec());
        assert_eq!((read.encoding, read.in_gbk()), (Encoding::Unknown, None));
    }
    assert_eq!(Decoded::new("(车)".into()).in_gbk(), None);
}

#[test]
fn dropped_program_with_chinese_comments_restores_the_form() {
    let mut line = Project::of("ribbon-line", Some("gsk-980tdc")).unwrap();
    line.values.insert("pitch".to_owned(), Value::Number(8.5));
    for encoding in [GBK, UTF8] {
        let project = in_chinese(line.clone(), encoding);
        let opened = open(&project, &project.written().files.0);
        let opened = opened.project.unwrap();
        assert_eq!((&opened.values, opened.edited.is_some()), (&project.values, false), "{encoding}");
    }
}

#[test]
fn program_of_another_version_is_not_an_edited_one() {
    for control in ["gsk-980tdc", "sinumerik-802d"] {
        let line = Project::of("turning-spindle", Some(control)).unwrap();
        for project in [in_chinese(line.clone(), UTF8), line] {
            let mut files = project.written().files.0;
            let version = env!("CARGO_PKG_VERSION");
            assert!(files.iter().all(|file| file.text.matches(version).count() == 1));
            files.iter_mut().for_each(|file| file.text = file.text.replace(version, "99.1.0-beta"));
            let opened = open(&project, &files).project.unwrap();
            assert!(opened.edited.is_none(), "{control}, {:?}", project.comments);
            files[0].text = files[0].text.replace("99.1.0-beta", "99.1.0 BY ANNA");
            assert!(open(&project, &files).project.unwrap().edited.is_some());
        }
    }
}

#[test]
fn finding_about_a_character_follows_the_switch() {
    let control = controls::find("gsk-980tdc").unwrap();
    let found = |setting: &str, text: &str| {
        let switches = Switches(vec![("comment-characters".to_owned(), setting.to_owned())]);
        let parsed = nc::parse_with(&Files::one("O1.nc", format!("O1({text})\n(SECOND)\nM30\n")), control, &switches);
        parsed.diagnostics().iter().any(|found| found.message_id() == "nc.foreign-comment")
    };
    assert_eq!(["ascii", GBK, UTF8].map(|setting| found(setting, "车削")), [true, false, false]);
    assert_eq!(["ascii", GBK, UTF8].map(|setting| found(setting, "😀")), [true, true, false]);
    assert_eq!(["ascii", GBK, UTF8].map(|setting| found(setting, "TURNING")), [false; 3]);
}

#[test]
fn long_comment_is_cut_at_the_bytes_of_its_encoding() {
    let control = controls::find("fanuc-0i-tf").unwrap();
    let mut b = nc::build::Builder::new();
    b.program(1, "");
    b.comment(&"车".repeat(60));
    let deck = b.finish();
    let cut = |characters| {
        let out = nc::emit_with(&deck, control, nc::Newline::Lf, characters);
        assert_eq!(out.diagnostics.len(), 1);
        out.files.0[0].text.matches('车').count()
    };
    let room = control.syntax.block_chars - 3;
    assert_eq!([CommentCharacters::Gbk, CommentCharacters::Utf8].map(cut), [room / 2, room / 3]);
}

#[test]
fn language_of_comments_is_saved_and_an_old_file_has_english() {
    let project = in_chinese(Project::of("turning-spindle", Some("sinumerik-802d")).unwrap(), UTF8);
    let json = project.to_json();
    assert!(json.contains("\"comments\": \"zh\""));
    assert!(Project::from_json(&json).project.unwrap() == project);
    let mut old: Json = serde_json::from_str(&json).unwrap();
    assert!(old.as_object_mut().unwrap().remove("comments").is_some());
    assert_eq!(Project::from_json(&old.to_string()).project.unwrap().comments, Language::English);
    let wrong = json.replace("\"comments\": \"zh\"", "\"comments\": \"xx\"");
    assert_eq!(Project::from_json(&wrong).project.unwrap().comments, Language::English);
}

#[test]
fn export_and_check_of_the_command_line_carry_gbk() {
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("comments-gbk");
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    let project = in_chinese(Project::of("ribbon-line", Some("gsk-980tdc")).unwrap(), GBK);
    let path = folder.join("line.json");
    std::fs::write(&path, project.to_json()).unwrap();
    let macroline = |args: &[&str]| command::macroline().args(args).output().unwrap();
    let text = |path: &std::path::Path| path.to_str().unwrap().to_owned();
    let out = macroline(&["export", &text(&path), "--out", &text(&folder.join("out"))]);
    assert!(out.status.success(), "{}", String::from_utf8_lossy(&out.stderr));
    let report = std::fs::read_to_string(folder.join("out/report.md")).unwrap();
    for file in &project.written().files.0 {
        let bytes = std::fs::read(folder.join("out").join(&file.name)).unwrap();
        assert_eq!(bytes, encode::bytes(&file.text, CommentCharacters::Gbk));
        let sum = crc::Crc::<u32>::new(&crc::CRC_32_ISO_HDLC).checksum(&bytes);
        assert!(report.contains(&format!("{}, CRC-32 {sum:08X}", file.name)), "{}", file.name);
    }
    let program = text(&folder.join("out").join(&project.written().files.0[0].name));
    let check = |setting: &str| -> Json {
        let switch = format!("comment-characters={setting}");
        let out = macroline(&["check", &program, "--control", "gsk-980tdc", "--switch", &switch, "--format", "json"]);
        serde_json::from_slice(&out.stdout).unwrap()
    };
    let foreign = |json: Json| json.to_string().contains("nc.foreign-comment");
    assert_eq!([GBK, "ascii"].map(|setting| foreign(check(setting))), [false, true]);
}
