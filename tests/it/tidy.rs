//! The laws of the house (src/README.md) that can be read from the sources, one test each.

mod source;

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use source::{Source, words};

/// The modules in the order of the flow: each names only itself and those before it. The order of `lib.rs`.
const ORDER: [&str; 11] =
    ["math", "text", "drives", "controls", "nc", "interp", "motion", "view", "machines", "project", "ui"];

/// The sentences.
const CATALOG: &str = "src/text/catalog/en.txt";

/// Where Rust stands.
const FOLDERS: [&str; 5] = ["src", "tests", "benches", "examples", "fuzz"];

/// Fails with every place that breaks a law, and with what to do about it.
#[track_caller]
fn hold(law: &str, mend: &str, broken: Vec<String>) {
    assert!(broken.is_empty(), "\n{law}\nTo mend: {mend}\n  {}\n", broken.join("\n  "));
}

/// All of `src/`.
fn sources() -> Vec<Source> {
    Source::all_in("src")
}

/// The core: everything but the shells (page, command line, browser's main).
fn core() -> Vec<Source> {
    sources().into_iter().filter(|source| !matches!(source.modules().first(), None | Some(&"ui"))).collect()
}

/// The modules of the root that code names as `crate::x`, `crate::{x, y}` or `super::…::x`, with the offsets.
fn roots_named(source: &Source) -> Vec<(usize, &str)> {
    let code = source.code.as_str();
    let mut found = Vec::new();
    let mut supers = 0;
    for (at, word) in source.words() {
        let Some(tail) = code[at + word.len()..].strip_prefix("::") else { continue };
        supers = match word {
            "super" if code[..at].ends_with("super::") => supers + 1,
            "super" => 1,
            _ => 0,
        };
        // `super` from a module at the top is the root; an inner `mod` only makes this stricter.
        let at_root = word == "crate" || supers > 0 && supers >= source.modules().len();
        if !at_root || tail.starts_with("super") {
            continue;
        }
        let begin = code.len() - tail.len();
        let Some(group) = tail.strip_prefix('{') else {
            found.extend(words(tail).next().filter(|(gap, _)| *gap == 0).map(|(_, head)| (begin, head)));
            continue;
        };
        let mut depth = 0;
        let mut head = true;
        for (gap, c) in group.char_indices() {
            match c {
                '{' => depth += 1,
                '}' if depth == 0 => break,
                '}' => depth -= 1,
                ',' if depth == 0 => head = true,
                c if c.is_whitespace() => {}
                _ if head && depth == 0 => {
                    head = false;
                    found.extend(words(&group[gap..]).next().map(|(_, head)| (begin + 1 + gap, head)));
                }
                _ => {}
            }
        }
    }
    found
}

#[test]
fn a_module_names_only_itself_and_those_before_it() {
    let rank = |module: &str| ORDER.iter().position(|name| *name == module);
    let mut broken = Vec::new();
    for source in sources() {
        let modules = source.modules();
        let Some(own) = modules.first() else { continue };
        let Some(own_rank) = rank(own) else {
            broken.push(format!("{}: the module {own} has no place in ORDER (tests/it/tidy.rs)", source.path));
            continue;
        };
        for (at, named) in roots_named(&source) {
            if rank(named).is_some_and(|named_rank| named_rank > own_rank) {
                broken.push(format!("{}: {own} names {named}, which comes later", source.place(at)));
            }
        }
    }
    let mend =
        "move the code to the later module, or declare in the earlier one what it needs (a trait, a plain value)";
    hold(&format!("The order of modules is {}.", ORDER.join(", ")), mend, broken);
}

#[test]
fn the_library_declares_its_modules_in_the_order_of_the_flow() {
    let library = sources().into_iter().find(|source| source.path == "src/lib.rs").unwrap();
    let all: Vec<&str> = library.words().map(|(_, word)| word).collect();
    let declared: Vec<&str> = all.windows(2).filter(|pair| pair[0] == "mod").map(|pair| pair[1]).collect();
    assert_eq!(declared, ORDER, "src/lib.rs declares exactly the modules of ORDER (tests/it/tidy.rs), in that order");
}

#[test]
fn only_the_page_knows_the_web() {
    let outside =
        sources().into_iter().filter(|source| source.path != "src/lib.rs" && source.modules().first() != Some(&"ui"));
    let web = ["leptos", "web_sys", "js_sys", "wasm_bindgen", "wasm_bindgen_futures", "gloo"];
    let broken = outside.flat_map(|source| source.find_words(&web)).collect();
    hold("Crates of the web stand only under src/ui/.", "let the page hand plain values in and out", broken);
}

#[test]
fn a_controls_name_stands_only_with_the_controls() {
    // From the ids, so that a new control needs no line here: `mitsubishi-e60` gives `mitsubishi` and `e60`.
    let names: BTreeSet<&str> = macroline::controls::ALL.iter().flat_map(|control| control.id.split('-')).collect();
    let named = |text: &str| {
        let text = text.to_lowercase();
        text.split(|c: char| !c.is_alphanumeric()).any(|word| names.contains(word))
    };
    let mut broken = Vec::new();
    for source in sources().iter().filter(|source| source.modules().first() != Some(&"controls")) {
        let list = list_of_controls(source);
        for (at, word) in source.words().filter(|(at, _)| source.ships(*at)) {
            // `e60` alone may be any local name, `mitsubishi_e60` cannot.
            if word.contains('_') && named(&word.replace('_', "-")) {
                broken.push(format!("{}: {word}", source.place(at)));
            }
        }
        for literal in source.literals.iter().filter(|literal| source.ships(literal.at)) {
            if named(&literal.text) && !list.contains(&literal.at) {
                broken.push(format!("{}: \"{}\"", source.place(literal.at), literal.text));
            }
        }
    }
    let mend = "ask the control for an ability or a row (`control.can(…)`, `control.alarm(…)`, `control.name`); \
                a machine lists its controls in `fn controls` or `CONTROLS`";
    hold("A control's name stands only in src/controls/, in tests and in a machine's list of controls.", mend, broken);
}

/// Where a machine lists its controls: from `fn controls` or `CONTROLS` to the end of that item.
fn list_of_controls(source: &Source) -> std::ops::Range<usize> {
    let code = source.code.as_str();
    let begin = code.find("CONTROLS:").or_else(|| code.find("fn controls("));
    match begin.filter(|_| source.modules().first() == Some(&"machines")) {
        Some(begin) => begin..code[begin..].find(['}', ';']).map_or(code.len(), |end| begin + end),
        None => 0..0,
    }
}

#[test]
fn the_files_of_the_controls_are_rows() {
    let files = sources().into_iter().filter(|source| {
        let modules = source.modules();
        let file = modules.get(1).copied().unwrap_or_default().replace('_', "-");
        modules.first() == Some(&"controls") && macroline::controls::ALL.iter().any(|control| control.id == file)
    });
    let broken =
        files.flat_map(|source| source.find_words(&["fn", "if", "match", "impl", "trait", "for", "while"])).collect();
    let mend = "row builders stand in src/controls/mod.rs; a difference of behaviour is a switch row or a named rewrite in src/nc/lower.rs";
    hold("The files of the controls contain rows and no logic.", mend, broken);
}

#[test]
fn the_core_has_no_clock_no_randomness_and_no_files() {
    let words =
        ["SystemTime", "Instant", "rand", "getrandom", "HashMap", "HashSet", "RandomState", "println", "eprintln"];
    let paths = ["std::time", "std::fs", "std::env", "std::net", "std::thread", "std::process", "std::io"];
    let find = |source: Source| [source.find_words(&words), source.find_text(&paths)].concat();
    let mend = "take the value as an argument, from the page or the command line; a BTreeMap has an order, a HashMap a random one";
    hold("A run is a pure function of its input.", mend, core().into_iter().flat_map(find).collect());
}

#[test]
fn only_the_math_gate_names_libm() {
    let broken =
        sources().iter().filter(|source| source.path != "src/math.rs").flat_map(|s| s.find_words(&["libm"])).collect();
    hold(
        "Transcendental functions go through src/math.rs.",
        "add the function there (clippy.toml bans the standard ones)",
        broken,
    );
}

#[test]
fn the_core_never_panics_by_itself() {
    let outside = |source: &Source| source.modules().first() != Some(&"controls"); // their const row builders stop the compiler
    let panics = ["panic!", "unreachable!", ".unwrap()", ".expect("];
    let broken = core().iter().filter(|source| outside(source)).flat_map(|source| source.find_text(&panics)).collect();
    hold(
        "parse, emit, design, plan and run are total.",
        "return a value and a diagnostic; `let … else` with a default",
        broken,
    );
}

#[test]
fn only_the_project_reads_what_was_saved() {
    let outside = core().into_iter().filter(|source| source.modules().first() != Some(&"project"));
    let broken = outside.flat_map(|source| source.find_words(&["Deserialize", "DeserializeOwned"])).collect();
    hold(
        "Deserialize stands only in src/project/.",
        "saved shapes stand in src/project/saved.rs, apart from the types in use",
        broken,
    );
}

#[test]
fn only_what_leaves_through_json_is_serialized() {
    let leaves = ["text", "view", "project"];
    let inside = core().into_iter().filter(|source| !leaves.contains(&source.modules()[0]));
    let broken = inside.flat_map(|source| source.find_words(&["Serialize"])).collect();
    hold(
        &format!("Serialize stands only in {}.", leaves.join(", ")),
        "build the JSON in src/project/ or give the view a plain type",
        broken,
    );
}

#[test]
fn the_catalog_and_the_source_name_the_same_sentences() {
    let file = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(CATALOG)).unwrap();
    let lines: Vec<&str> = file.lines().skip(1).collect();
    let mut broken = Vec::new();
    for pair in lines.windows(2).filter(|pair| pair[0] >= pair[1]) {
        broken.push(format!("{CATALOG}: out of order: {}", pair[1]));
    }
    let mut rows: BTreeMap<&str, &str> = BTreeMap::new();
    for line in lines {
        match line.split_once(' ') {
            Some((id, sentence)) if sentence.trim() == sentence && !sentence.is_empty() => {
                if rows.insert(id, sentence).is_some() {
                    broken.push(format!("{CATALOG}: {id} stands there twice"));
                }
            }
            _ => broken.push(format!("{CATALOG}: no id, space and sentence: {line:?}")),
        }
    }
    let areas: BTreeSet<&str> = rows.keys().filter_map(|id| id.split_once('.')).map(|(area, _)| area).collect();
    let looks_like_id = |text: &str| {
        let (area, subject) = text.split_once('.').unwrap_or_default();
        let file = [".json", ".csv", ".svg", ".txt", ".nc"].iter().any(|kind| text.ends_with(kind));
        areas.contains(area)
            && !file
            && !subject.is_empty()
            && subject.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || "-.".contains(c))
    };
    let mut used = BTreeSet::new();
    for source in &sources() {
        for literal in source.literals.iter().filter(|literal| source.ships(literal.at)) {
            if let Some((id, _)) = rows.get_key_value(literal.text.as_str()) {
                used.insert(*id);
            } else if looks_like_id(&literal.text) {
                broken.push(format!("{}: \"{}\" is not in the catalog", source.place(literal.at), literal.text));
            }
        }
        for (at, id, values) in messages(source) {
            match rows.get(id) {
                None if !looks_like_id(id) => {
                    broken.push(format!("{}: \"{id}\" is not in the catalog", source.place(at)))
                }
                None => {}
                Some(sentence) if places(sentence) != (0..values).collect() => {
                    broken.push(format!(
                        "{}: \"{id}\" gets {values} values, its sentence is “{sentence}”",
                        source.place(at)
                    ));
                }
                Some(_) => {}
            }
        }
    }
    broken.extend(rows.keys().filter(|id| !used.contains(*id)).map(|id| format!("{id}: no code says this sentence")));
    let mend = "one line per id in src/text/catalog/en.txt, sorted, with a place {0}, {1} … for each value of `msg!`; no line without a use";
    hold("Every sentence stands once in the catalog, and is said.", mend, broken);
}

/// The numbers of the places `{0}`, `{1}` … of a sentence.
fn places(sentence: &str) -> BTreeSet<usize> {
    sentence.split('{').skip(1).filter_map(|tail| tail.split_once('}')?.0.parse().ok()).collect()
}

/// Every `msg!("id", value, …)`: where, the id, and how many values.
fn messages(source: &Source) -> Vec<(usize, &str, usize)> {
    let code = &source.code[..source.shipped];
    let mut found = Vec::new();
    for (at, _) in code.match_indices("msg!(") {
        let Some(id) = source.literals.iter().find(|literal| literal.at > at) else { continue };
        let arguments = &code[at + "msg!(".len()..];
        if !arguments.trim_start().starts_with('"') {
            continue; // the macro's own definition
        }
        let (mut depth, mut commas, mut last) = (0, 0, ' ');
        for c in arguments.chars() {
            match c {
                '(' | '[' | '{' => depth += 1,
                ')' if depth == 0 => break,
                ')' | ']' | '}' => depth -= 1,
                ',' if depth == 0 => commas += 1,
                _ => {}
            }
            if !c.is_whitespace() {
                last = c;
            }
        }
        found.push((at, id.text.as_str(), commas - usize::from(last == ',')));
    }
    found
}

#[test]
fn files_are_short_and_say_what_they_are() {
    let mut broken = Vec::new();
    for source in FOLDERS.into_iter().flat_map(Source::all_in) {
        // Data is read by looking a row up, not from top to bottom.
        let modules = source.modules().join("/");
        let data =
            modules == "drives/catalog" || modules.strip_prefix("controls/").is_some_and(|file| file.contains('_'));
        let lines = source.text.lines().count();
        if lines > 800 && !data {
            broken.push(format!("{}: {lines} lines; divide it", source.path));
        }
        let opening = source.text.lines().next().unwrap_or_default();
        if opening.strip_prefix("//! ").is_none_or(|text| text.trim().is_empty()) {
            broken.push(format!("{}: line 1 is no `//! ` sentence that says what the file is", source.path));
        }
    }
    hold("A file has at most 800 lines and opens with what it is.", "see each place", broken);
}

#[test]
fn nothing_is_left_undone_or_switched_off() {
    let mut broken = Vec::new();
    for source in FOLDERS.into_iter().flat_map(Source::all_in) {
        for word in ["unsafe", "todo", "unimplemented", "dbg", "ignore"] {
            // `todo` and its like are macros, `ignore` an attribute: as plain words they may be a name.
            let code = |at: usize| (source.code[..at].ends_with("#["), source.code[at + word.len()..].starts_with('!'));
            let hits = source.words().filter(|(_, found)| *found == word).filter(|(at, _)| match word {
                "unsafe" => true,
                "ignore" => code(*at).0,
                _ => code(*at).1,
            });
            broken.extend(hits.map(|(at, _)| format!("{}: {word}", source.place(at))));
        }
        let marks = source.text.match_indices("FIX\u{4d}E").chain(source.text.match_indices("TO\u{44}O"));
        broken.extend(marks.map(|(at, mark)| format!("{}: {mark}", source.place(at))));
    }
    hold("What is committed is finished.", "do it, or write an issue and leave the code without it", broken);
}

/// The map in `src/README.md`: every file with its first sentence. `UPDATE_EXPECT=1` writes it anew.
#[test]
fn the_map_names_every_file_with_its_first_sentence() {
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
