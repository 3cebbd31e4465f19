//! The laws of src/README.md that can be checked in the sources, one test each.

pub(crate) mod catalog;
mod citations;
mod imports;
mod links;
mod lists;
mod methods;
mod numbers_of_the_page;
mod source;
mod test_names;
mod views;

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use imports::Imports;
use source::{Source, TokenKind};

/// The modules in the order of the flow: each names only itself and those before it. The order of `lib.rs`.
const ORDER: [&str; 11] =
    ["math", "text", "drives", "controls", "nc", "interp", "motion", "view", "machines", "project", "ui"];

/// Fails with every place that breaks a law, and with the instruction to correct it.
#[track_caller]
fn hold(law: &str, mend: &str, broken: Vec<String>) {
    assert!(broken.is_empty(), "\n{law}\nTo mend: {mend}\n  {}\n", broken.join("\n  "));
}

/// All of `src/`.
fn sources() -> impl Iterator<Item = &'static Source> {
    Source::all().iter().filter(|source| source.path.starts_with("src/"))
}

/// The core: everything but the shells (page, command line, browser's main).
fn core() -> impl Iterator<Item = &'static Source> {
    sources().filter(|source| !matches!(source.room(), None | Some("ui")))
}

/// The modules of the root that code names as `crate::x` or `super::…::x`, with the lines.
fn roots_named(source: &Source) -> Vec<(String, usize)> {
    let deep = source.modules().len();
    let root = |path: &[&str]| {
        let supers = path.iter().take_while(|word| **word == "super").count();
        // An inner `mod` only makes this stricter.
        let at = if path[0] == "crate" { 1 } else { supers };
        (path[0] == "crate" || supers >= deep).then(|| path.get(at).map(|word| (*word).to_owned())).flatten()
    };
    let imports = source.imports.iter().filter_map(|import| {
        let path: Vec<&str> = import.path.iter().map(String::as_str).collect();
        Some((root(&path)?, import.line))
    });
    imports.chain(source.paths().into_iter().filter_map(|(path, line)| Some((root(&path)?, line)))).collect()
}

#[test]
fn modules_name_only_earlier_modules() {
    let rank = |module: &str| ORDER.iter().position(|name| *name == module);
    let mut broken = Vec::new();
    for source in sources() {
        let Some(own) = source.room() else { continue };
        let Some(own_rank) = rank(own) else {
            broken.push(format!("{}: the module {own} has no place in ORDER (tests/it/tidy.rs)", source.path));
            continue;
        };
        for (named, line) in roots_named(source) {
            if rank(&named).is_some_and(|named_rank| named_rank > own_rank) {
                broken.push(format!("{}: {own} names {named}, which comes later", source.place(line)));
            }
        }
    }
    let mend =
        "move the code to the later module, or declare in the earlier one what it needs (a trait, a plain value)";
    hold(&format!("The order of modules is {}.", ORDER.join(", ")), mend, broken);
}

/// The folders of the page, in the order of its flow: each names only itself and earlier ones. The features are one step: they name neither
/// each other nor later folders.
const PAGE: [&[&str]; 7] = [
    &["words"],
    &["dom"],
    &["state"],
    &["worker"],
    &["parts"],
    &["form", "machine", "program", "results", "files", "help"],
    &["app"],
];

#[test]
fn folders_of_the_page_name_only_earlier_ones() {
    let folder = |source: &Source| match source.modules()[..] {
        ["ui", folder, ..] => PAGE.iter().position(|step| step.contains(&folder)).map(|rank| (rank, folder.to_owned())),
        _ => None,
    };
    let all = Imports::new(sources().collect());
    let unknown = sources()
        .filter(|source| source.modules().len() > 1 && source.room() == Some("ui") && folder(source).is_none())
        // The bench of the components' tests mounts any of them.
        .filter(|source| source.path != "src/ui/testing.rs");
    let mut broken: Vec<String> =
        unknown.map(|source| format!("{}: the folder has no place in PAGE (tests/it/tidy.rs)", source.path)).collect();
    for (from, to, names) in all.between() {
        let (Some((rank, own)), Some((named_rank, named))) = (folder(from), folder(to)) else { continue };
        if named_rank > rank || named_rank == rank && own != named {
            let names: Vec<&str> = names.iter().map(String::as_str).collect();
            broken.push(format!("{} names {} of {}", from.path, names.join(", "), to.path));
        }
    }
    let mend = "move what two features share to parts/ or state/, and put features together in app.rs";
    hold("The order of the page is words, dom, state, worker, parts, features, app.", mend, broken);
}

#[test]
fn library_declares_its_modules_in_order() {
    let library = sources().find(|source| source.path == "src/lib.rs").unwrap();
    assert_eq!(
        library.children, ORDER,
        "src/lib.rs declares exactly the modules of ORDER (tests/it/tidy.rs), in that order"
    );
}

#[test]
fn web_crates_are_named_only_in_ui() {
    // The entry points of the page's two modules and of the package, which JavaScript calls.
    let doors = ["src/lib.rs", "src/main.rs", "src/bin/worker.rs", "src/bin/package.rs"];
    let outside = sources().filter(|source| !doors.contains(&source.path.as_str()) && source.room() != Some("ui"));
    let web = ["leptos", "web_sys", "js_sys", "wasm_bindgen", "wasm_bindgen_futures", "gloo"];
    let broken = outside.flat_map(|source| source.find_words(&web)).collect();
    hold("Crates of the web stand only under src/ui/.", "let the page hand plain values in and out", broken);
}

#[test]
fn control_names_are_only_in_controls() {
    // From the ids, so that a new control needs no line here: `mitsubishi-e60` gives `mitsubishi` and `e60`.
    let names: BTreeSet<&str> = macroline::controls::ALL.iter().flat_map(|control| control.id.split('-')).collect();
    let named = |text: &str| {
        let text = text.to_lowercase();
        text.split(|c: char| !c.is_alphanumeric()).any(|word| names.contains(word))
    };
    let mut broken = Vec::new();
    for source in sources().filter(|source| source.room() != Some("controls")) {
        let list = list_of_controls(source);
        for (at, token) in source.shipped().iter().enumerate() {
            let breaks = match token.kind {
                // `e60` alone may be any local name, `mitsubishi_e60` cannot.
                TokenKind::Word => token.text.contains('_') && named(&token.text.replace('_', "-")),
                TokenKind::Text => named(&token.text) && !list.contains(&at),
                TokenKind::Sign => false,
            };
            if breaks {
                broken.push(format!("{}: {}", source.place(token.line), token.text));
            }
        }
    }
    let mend = "ask the control for an ability or a row (`control.can(…)`, `control.alarm(…)`, `control.name`); \
                a machine lists its controls in `controls` of its `INFO`; for a new control that finds itself all over \
                the code, choose an id whose parts have at least 2 characters and are no everyday words";
    hold("A control's name stands only in src/controls/, in tests and in a machine's list of controls.", mend, broken);
}

/// The tokens of a machine's list of controls: `controls: &[…]` of its constants.
fn list_of_controls(source: &Source) -> std::ops::Range<usize> {
    let tokens = source.shipped();
    let is = |at: usize, text: &str| tokens.get(at).is_some_and(|token| token.text == text);
    let begins = |at: &usize| (*at..).zip(["controls", ":", "&", "["]).all(|(at, text)| is(at, text));
    match (0..tokens.len()).find(begins).filter(|_| source.room() == Some("machines")) {
        Some(begin) => begin..(begin..tokens.len()).find(|&at| is(at, "]")).unwrap_or(tokens.len()),
        None => 0..0,
    }
}

#[test]
fn control_files_hold_rows_and_no_logic() {
    let files = sources().filter(|source| {
        let modules = source.modules();
        let file = modules.get(1).copied().unwrap_or_default().replace('_', "-");
        modules.first() == Some(&"controls") && macroline::controls::ALL.iter().any(|control| control.id == file)
    });
    let broken =
        files.flat_map(|source| source.find_words(&["fn", "if", "match", "impl", "trait", "for", "while"])).collect();
    let mend = "row builders stand in src/controls/schema/; a difference of behaviour is a switch row or a named rewrite in src/nc/lower/";
    hold("The files of the controls contain rows and no logic.", mend, broken);
}

/// Places at which a file imports one of these modules of the standard library, however the `use` is written: `use std::{fs, io}`.
fn imported(source: &Source, modules: &[&str]) -> Vec<String> {
    let of = |import: &source::Import| match &import.path[..] {
        [std, module, ..] if std == "std" && modules.contains(&module.as_str()) => Some(module.clone()),
        _ => None,
    };
    let imports = source.imports.iter().filter_map(|import| Some((import.line, of(import)?)));
    imports.map(|(line, module)| format!("{}: use of std::{module}", source.place(line))).collect()
}

#[test]
fn grouped_imports_of_the_standard_library_are_seen() {
    let text = "//! A file.\nuse std::{cell, fs, io::{self, Read}};\nuse crate::io::b;";
    let source = Source::new("src/nc/lex.rs".to_owned(), text.to_owned());
    let found = imported(&source, &["fs", "io"]);
    assert_eq!(found, ["fs", "io", "io"].map(|name| format!("src/nc/lex.rs:2: use of std::{name}")));
}

#[test]
fn core_has_no_clock_randomness_or_files() {
    let words =
        ["SystemTime", "Instant", "rand", "getrandom", "HashMap", "HashSet", "RandomState", "println", "eprintln"];
    let outside = ["time", "fs", "env", "net", "thread", "process", "io"];
    let paths = outside.map(|name| format!("std : : {name}"));
    let paths = paths.each_ref().map(String::as_str);
    let find =
        |source: &Source| [source.find_words(&words), source.find_code(&paths), imported(source, &outside)].concat();
    let mend = "take the value as an argument, from the page or the command line; a BTreeMap has an order, a HashMap a random one";
    hold("A run is a pure function of its input.", mend, core().flat_map(find).collect());
}

#[test]
fn no_code_steers_by_the_id_of_a_message() {
    let outside = sources().filter(|source| source.room() != Some("text"));
    let mut broken: Vec<String> = outside.flat_map(|source| source.find_code(&[". message . id"])).collect();
    // Readers of ids: silencing, output as text and JSON, the help.
    let readers = [
        "src/bin/macroline/lsp/findings.rs",
        "src/project/findings/render/mod.rs",
        "src/project/findings/render/sarif.rs",
        "src/project/findings/silence.rs",
        "src/text/diagnostic.rs",
        "src/ui/parts/listing.rs",
        "src/ui/program/mod.rs",
    ];
    let compared = ["= =", "! =", ") = =", ") ! =", ". starts_with", ". ends_with", ". strip_prefix", ". contains"];
    let compared = compared.map(|sign| format!("message_id ( ) {sign}"));
    let compared = compared.each_ref().map(String::as_str);
    for source in sources() {
        broken.extend(source.find_code(&compared));
        if !readers.contains(&source.path.as_str()) {
            broken.extend(source.find_code(&["message_id"]));
        }
    }
    let mend = "give the diagnostic a `DiagnosticKind` where it arises; `message_id` is for silencing, help and JSON";
    hold("Diagnostics have kinds; ids and texts of messages are for people.", mend, broken);
}

#[test]
fn no_code_steers_by_the_id_of_a_sheet() {
    let compared = ["sheet . id = =", "match sheet . id"];
    let broken = sources().flat_map(|source| source.find_code(&compared)).collect();
    hold("Sheets and columns have kinds.", "give the sheet a `SheetKind`, the column its variant of `Column`", broken);
}

#[test]
fn libm_is_named_only_in_math() {
    let broken =
        sources().filter(|source| source.path != "src/math.rs").flat_map(|s| s.find_words(&["libm"])).collect();
    hold(
        "Transcendental functions go through src/math.rs.",
        "add the function there (clippy.toml bans the standard ones)",
        broken,
    );
}

#[test]
fn core_has_no_panicking_calls() {
    // The controls are left out, because the panics of their const row builders stop the compiler.
    let outside = core().filter(|source| source.room() != Some("controls"));
    let macros = ["panic", "unreachable", "assert", "assert_eq", "assert_ne"].map(|name| format!("{name} !"));
    let calls = ["unwrap", "expect", "unwrap_err", "expect_err"].map(|name| format!(". {name} ("));
    let panics: Vec<&str> = macros.iter().chain(&calls).map(String::as_str).collect();
    let broken = outside.flat_map(|source| source.find_code(&panics)).collect();
    hold(
        "parse, emit, design, plan and run are total.",
        "return a value and a diagnostic; `let … else` with a default",
        broken,
    );
}

#[test]
fn code_acts_on_alarm_kinds_and_not_on_numbers() {
    // Of the rooms that come after the tables of the controls; warnings show numbers in their sentences.
    let others = core().filter(|source| !matches!(source.room(), Some("controls" | "text")));
    let mut broken = Vec::new();
    for source in others {
        if !source.path.starts_with("src/nc/lint/") {
            broken.extend(source.find_words(&["alarm_number"]));
        }
        if source.room() != Some("nc") {
            let compared = [". alarm = =", ". alarm ! =", ". alarm . as_deref ( ) = =", ". alarm . as_deref ( ) ! ="];
            broken.extend(source.find_code(&compared));
        }
    }
    hold(
        "Code acts on the kind of an alarm; its number is for people.",
        "compare `Alarm` or `DiagnosticKind`; whether two findings show one alarm: `Diagnostic::shows_alarm_of`",
        broken,
    );
}

#[test]
fn deserialize_is_only_in_project() {
    let outside = core().filter(|source| source.room() != Some("project"));
    let broken = outside.flat_map(|source| source.find_words(&["Deserialize", "DeserializeOwned"])).collect();
    hold(
        "Deserialize stands only in src/project/.",
        "saved shapes stand in src/project/saved/, apart from the types in use",
        broken,
    );
}

#[test]
fn serialize_is_only_on_json_types() {
    let leaves = ["text", "view", "project"];
    let inside = core().filter(|source| !leaves.contains(&source.modules()[0]));
    let broken = inside.flat_map(|source| source.find_words(&["Serialize"])).collect();
    hold(
        &format!("Serialize stands only in {}.", leaves.join(", ")),
        "build the JSON in src/project/ or give the view a plain type",
        broken,
    );
}

#[test]
fn files_are_short_and_open_with_a_sentence() {
    let mut broken = Vec::new();
    for source in Source::all() {
        // Data is read by looking a row up, not from top to bottom.
        let modules = source.modules().join("/");
        let data =
            modules == "drives/catalog" || modules.strip_prefix("controls/").is_some_and(|file| file.contains('_'));
        let lines = source.text.lines().count();
        if lines > 800 && !data {
            broken.push(format!("{}: {lines} lines; divide it", source.path));
        }
        let opening = source.text.lines().next().unwrap_or_default();
        if opening.strip_prefix("//! ").is_none_or(|text| text.trim().len() < 2 || !text.ends_with(['.', ':'])) {
            broken.push(format!("{}: line 1 is no whole `//! ` sentence that says what the file is", source.path));
        }
    }
    hold("A file has at most 800 lines and opens with what it is.", "see each place", broken);
}

#[test]
fn no_unfinished_code_or_ignored_tests() {
    let mut broken = Vec::new();
    for source in Source::all() {
        let marked =
            source.tokens.windows(3).filter_map(|part| match [&*part[0].text, &*part[1].text, &*part[2].text] {
                ["unsafe", ..] if part[0].kind == TokenKind::Word => Some(&part[0]),
                ["todo" | "unimplemented" | "dbg", "!", _] if part[0].kind == TokenKind::Word => Some(&part[0]),
                ["#", "[", "ignore"] => Some(&part[2]),
                _ => None,
            });
        broken.extend(marked.map(|token| format!("{}: {}", source.place(token.line), token.text)));
        for (line, text) in (1..).zip(source.text.lines()) {
            let marks = ["FIX\u{4d}E", "TO\u{44}O"].into_iter().filter(|mark| text.contains(mark));
            broken.extend(marks.map(|mark| format!("{}: {mark}", source.place(line))));
        }
    }
    hold("What is committed is finished.", "do it, or write an issue and leave the code without it", broken);
}

#[test]
fn disabled_lints_have_a_reason_and_everything_is_documented() {
    let mut broken = Vec::new();
    for source in Source::all() {
        for lints in source.disabled_lints() {
            let has = |word: &str| lints.iter().any(|token| token.kind == TokenKind::Word && token.text == word);
            let names: Vec<&str> = lints.iter().map(|token| token.text.as_str()).collect();
            if has("missing_docs") {
                broken.push(format!("{}: missing_docs is disabled", source.place(lints[0].line)));
            } else if !has("reason") {
                broken.push(format!("{}: {} without a reason", source.place(lints[0].line), names.concat()));
            }
        }
    }
    let mend = "write the doc comment; where a lint is wrong, `#[allow(lint, reason = \"…\")]` on the smallest item";
    hold("Everything public is documented, and a lint is disabled for a stated reason.", mend, broken);
}

#[test]
fn files_have_no_import_circle() {
    let mend = "move what both need into a file of its own below them, or hand it in as an argument";
    hold("Imports between files lead one way.", mend, Imports::new(sources().collect()).circles());
}

/// Names that several types visible outside their modules have, with the places. A name that each machine's folder gives to one type is the
/// same role in every machine, such as `Params`; a machine's folder is one with a `params.rs`.
fn names_of_several_types(sources: &[&Source]) -> Vec<String> {
    let folder = |source: &Source| {
        let (folder, _) = source.path.strip_prefix("src/machines/")?.split_once('/')?;
        let params = format!("src/machines/{folder}/params.rs");
        sources.iter().any(|other| other.path == params).then(|| folder.to_owned())
    };
    let mut types: BTreeMap<&str, Vec<(Option<String>, String)>> = BTreeMap::new();
    for source in sources {
        for (name, line) in &source.visible_types {
            types.entry(name).or_default().push((folder(source), source.place(*line)));
        }
    }
    types.retain(|_, places| {
        let machines: BTreeSet<_> = places.iter().filter_map(|(machine, _)| machine.as_ref()).collect();
        places.len() > 1 && machines.len() < places.len()
    });
    let places = |places: Vec<(Option<String>, String)>| places.into_iter().map(|(_, place)| place).collect::<Vec<_>>();
    types.into_iter().map(|(name, found)| format!("{name}: {}", places(found).join(", "))).collect()
}

#[test]
fn visible_type_names_are_unique() {
    hold(
        "A type that is visible outside its module has a name of its own; each machine's folder may have one type of a name.",
        "name each after the trade's noun for it (CONTRIBUTING.md, “Words”)",
        names_of_several_types(&sources().collect::<Vec<_>>()),
    );
}

#[test]
fn repeated_type_name_is_found_apart_from_machine_roles() {
    let source = |path: &str, code: &str| Source::new(path.to_owned(), format!("//! A file.\n{code}"));
    let planted = [
        source("src/drives/a.rs", "pub struct Load;\npub enum Gear {}\nstruct Own;"),
        source("src/machines/form/rows.rs", "pub(super) struct Row;\npub(super) trait Cell {}"),
        source("src/machines/ladder/rows.rs", "pub(super) struct Row;\nstruct Own;"),
        source("src/machines/lathe/load.rs", "pub(super) type Load = f64;\npub(self) struct Gear;"),
        source("src/machines/lathe/params.rs", "pub(crate) struct Params;\npub(crate) struct Cut;"),
        source("src/machines/lathe/path.rs", "pub(in crate::machines) enum Cut {}"),
        source("src/machines/line/params.rs", "pub(crate) struct Params;"),
    ];
    assert_eq!(
        names_of_several_types(&planted.iter().collect::<Vec<_>>()),
        [
            "Cut: src/machines/lathe/params.rs:3, src/machines/lathe/path.rs:2",
            "Load: src/drives/a.rs:2, src/machines/lathe/load.rs:2",
            "Row: src/machines/form/rows.rs:2, src/machines/ladder/rows.rs:2",
        ]
    );
}

/// Rooms with structs that are tables: a field of a machine's form, or a row of a control, is a field of the struct.
const WIDE_STRUCTS: [&str; 2] = ["controls", "machines"];

#[test]
fn functions_and_structs_stay_within_their_size() {
    let mut broken = Vec::new();
    for source in sources() {
        let is_in = |rooms: &[&str]| source.room().is_some_and(|room| rooms.contains(&room));
        let long = source.functions.iter().filter(|function| function.size > 100);
        broken.extend(long.map(|f| format!("{}: {} has {} lines", source.place(f.line), f.name, f.size)));
        let wide = source.structs.iter().filter(|item| item.size > 20 && !is_in(&WIDE_STRUCTS));
        broken.extend(wide.map(|item| format!("{}: {} has {} fields", source.place(item.line), item.name, item.size)));
    }
    let mend = "divide a function into named steps, and a struct into parts by subject";
    hold("A function has at most 100 lines, a struct at most 20 fields.", mend, broken);
}

/// The map in `src/README.md`: every file with its first line. `UPDATE_EXPECT=1` writes the map again.
#[test]
fn map_lists_every_file_with_its_first_sentence() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/README.md");
    let readme = std::fs::read_to_string(&path).unwrap();
    let (head, _) = readme.split_once("\n## Map\n").expect("src/README.md has a section “Map”");
    let mut map = String::new();
    for file in sources() {
        let first = file.text.lines().next().unwrap_or_default().trim_start_matches("//! ");
        map += &format!("- `{}`: {first}\n", file.path);
    }
    expect_test::expect_file![path].assert_eq(&format!("{head}\n## Map\n\n{map}"));
}
