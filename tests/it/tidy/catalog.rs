//! Laws of the catalog: code and English catalog have the same sentences; every other language has all of them, and the phrases of the rows.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use macroline::controls;
use macroline::machines::{self, AnyMachine};
use macroline::project::Project;
use macroline::text::Phrase;
use macroline::text::catalog::parts::{Form, SentencePart, parts};
use macroline::text::catalog::{self, Language};
use macroline::text::units;

use super::source::{Source, TokenKind};
use super::{citations, core, hold, sources};

/// The sentences of a language: keys without their backslashes, in the order of the file.
pub(crate) struct Sentences {
    file: String,
    pub(crate) rows: Vec<(String, String)>,
}

impl Sentences {
    fn of(language: Language) -> Sentences {
        Sentences::read(format!("src/text/catalog/{}.properties", language.code()))
    }

    /// The manual of the help.
    pub(crate) fn of_help(language: Language) -> Sentences {
        Sentences::read(format!("src/text/help/help-{}.properties", language.code()))
    }

    fn read(file: String) -> Sentences {
        let text = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(&file)).unwrap();
        let row = |line: &str| {
            let plain = line.replace("\\=", "\u{0}");
            let (key, sentence) = plain.split_once('=').unwrap_or((&plain, ""));
            (key.replace('\u{0}', "=").replace('\\', ""), sentence.to_owned())
        };
        Sentences { rows: text.lines().skip(1).map(row).collect(), file }
    }

    /// Rows by key; adds the faults of the file: its order, a key given twice, a row without key and sentence.
    pub(crate) fn checked(&self, broken: &mut Vec<String>) -> BTreeMap<&str, &str> {
        for pair in self.rows.windows(2).filter(|pair| pair[0].0 >= pair[1].0) {
            broken.push(format!("{}: out of order or twice: {}", self.file, pair[1].0));
        }
        for (key, sentence) in &self.rows {
            if key.is_empty() || sentence.is_empty() || sentence.trim() != sentence {
                broken.push(format!("{}: no key, equals sign and sentence: {key:?}", self.file));
            }
        }
        self.rows.iter().map(|(key, sentence)| (key.as_str(), sentence.as_str())).collect()
    }
}

#[test]
fn code_and_english_name_the_same_sentences() {
    let english = Sentences::of(Language::English);
    let mut broken = Vec::new();
    let rows = english.checked(&mut broken);
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
    // Labels of switches and options are named by the table of the switches.
    for row in macroline::controls::ALL.iter().flat_map(|control| control.switches) {
        for label in [row.label].into_iter().chain(row.options().iter().map(|option| option.label)) {
            used.insert(label);
            if !rows.contains_key(label) {
                broken.push(format!("{label} of the switch {} is not in the catalog", row.id()));
            }
        }
    }
    for source in sources() {
        for literal in source.literals() {
            if let Some((id, _)) = rows.get_key_value(literal.text.as_str()) {
                used.insert(*id);
            } else if looks_like_id(&literal.text) {
                broken.push(format!("{}: \"{}\" is not in the catalog", source.place(literal.line), literal.text));
            }
        }
        let unknown = calls(source).into_iter().filter(|call| !rows.contains_key(call.id) && !looks_like_id(call.id));
        broken
            .extend(unknown.map(|call| format!("{}: \"{}\" is not in the catalog", source.place(call.line), call.id)));
    }
    broken.extend(rows.keys().filter(|id| !used.contains(*id)).map(|id| format!("{id}: no code says this sentence")));
    let mend = "one line per id in src/text/catalog/en.properties, sorted by id; no line without a use";
    hold("Every sentence stands once in the catalog, and is said.", mend, broken);
}

/// Sentences with placeholders that no `msg!` uses: `text/list.rs` joins by the first, and the second takes the values of `form.assumed`.
const WITHOUT_A_CALL: [&str; 2] = ["list.", "page.assumed-facts"];

#[test]
fn every_place_of_a_sentence_has_its_value() {
    let english = Sentences::of(Language::English);
    let mut broken = Vec::new();
    let rows = english.checked(&mut broken);
    let mut called = BTreeSet::new();
    for source in Source::all() {
        for call in calls(source) {
            let Some((id, sentence)) = rows.get_key_value(call.id) else { continue };
            called.insert(*id);
            if places(sentence) != call.names {
                let names: Vec<&str> = call.names.into_iter().collect();
                let place = source.place(call.line);
                broken.push(format!("{place}: \"{id}\" gets {}, its sentence is “{sentence}”", names.join(", ")));
            }
        }
    }
    let has_call = |id: &str| called.contains(id) || WITHOUT_A_CALL.iter().any(|of| id.starts_with(of));
    let silent = rows.iter().filter(|(id, sentence)| !places(sentence).is_empty() && !has_call(id));
    broken.extend(silent.map(|(id, _)| format!("{id}: it has places, and no `msg!` gives their values")));
    for language in Language::ALL {
        for (id, row) in Sentences::of(language).rows {
            let is_odd = |part: SentencePart| matches!(part, SentencePart::Words(words) if words.trim_end().contains('{') && !words.starts_with("{ \""));
            if parts(&row).any(is_odd) {
                broken.push(format!("{}: {id}: a bracket that opens no place: {row}", language.code()));
            }
            if let Some(name) = places(&row).into_iter().find(|name| units::converted().any(|unit| unit == *name)) {
                broken.push(format!("{}: {id}: “{name}” is a unit, and no name of a place", language.code()));
            }
        }
    }
    let mend = "`msg!(\"id\", speed = expression, limit)` names each place of its sentence, `{speed}`, and no other; a name is of small letters and _";
    hold("Every place of a sentence gets its value by its name.", mend, broken);
}

/// Literals of `format!` in the core with words that no reader sees: a command of the debugger, the end of serde's messages, a class.
const NO_TEXT: [&str; 3] = [" if {}", " at line {} column {}", "tone tone-{}"];

#[test]
fn format_literals_of_the_core_have_no_words() {
    let is_word = |word: &str| word.len() > 1 && word.chars().all(|c| c.is_ascii_lowercase());
    let mut broken = Vec::new();
    for source in core() {
        for part in source.shipped().windows(4) {
            let [name, mark, open, literal] = part else { continue };
            if (&*name.text, &*mark.text, &*open.text) != ("format", "!", "(") || literal.kind != TokenKind::Text {
                continue;
            }
            let mut depth = 0;
            let outside = |c: char| {
                depth += i32::from(c == '{') - i32::from(c == '}');
                if depth > 0 || c == '}' { '#' } else { c }
            };
            let plain: String = literal.text.chars().map(outside).collect();
            // The attributes of an element are no words.
            let has_words = !plain.contains('<') && plain.split_whitespace().any(is_word);
            if has_words && !NO_TEXT.contains(&literal.text.as_str()) {
                broken.push(format!("{}: \"{}\"", source.place(literal.line), literal.text));
            }
        }
    }
    let mend = "a row of the catalog, said with `msg!`";
    hold("The core writes no words of its own into texts.", mend, broken);
}

/// Names of the values in a sentence: those of its places, and units that are values too, `{drift, unit, unit}`.
fn places(sentence: &str) -> BTreeSet<&str> {
    let units = lengths(sentence).map(|(_, unit)| unit).filter(|unit| !units::converted().any(|known| known == *unit));
    let names = parts(sentence).filter_map(|part| match part {
        SentencePart::Place(name, _) => Some(name),
        SentencePart::Words(_) => None,
    });
    names.chain(units).collect()
}

/// The places of a sentence that hold a length, each with its unit, or the place that has it.
fn lengths(sentence: &str) -> impl Iterator<Item = (&str, &str)> {
    parts(sentence).filter_map(|part| match part {
        SentencePart::Place(name, Form::WithUnit(unit) | Form::Number(unit)) => Some((name, unit)),
        _ => None,
    })
}

/// A call of `msg!`.
struct Call<'s> {
    line: usize,
    id: &'s str,
    /// The names of the values; empty for a value without a name.
    names: BTreeSet<&'s str>,
}

/// Every `msg!("id", name = value, name, …)`, in unit tests too.
fn calls(source: &Source) -> Vec<Call<'_>> {
    let mut found = Vec::new();
    for (at, part) in source.tokens.windows(4).enumerate() {
        let [name, mark, open, id] = part else { continue };
        if (&*name.text, &*mark.text, &*open.text) != ("msg", "!", "(") || id.kind != TokenKind::Text {
            continue; // the macro's own definition has no id
        }
        let mut call = Call { line: name.line, id: &id.text, names: BTreeSet::new() };
        let mut depth = 0;
        for pair in source.tokens[at + 4..].windows(2) {
            match (pair[0].kind, pair[0].text.as_str()) {
                (TokenKind::Text, _) => {}
                (_, "(" | "[" | "{") => depth += 1,
                (_, ")") if depth == 0 => break,
                (_, ")" | "]" | "}") => depth -= 1,
                (_, ",") if depth == 0 && pair[1].text != ")" => drop(call.names.insert(&pair[1].text)),
                _ => {}
            }
        }
        found.push(call);
    }
    found
}

/// The phrases of rows, with the table of each.
fn phrases() -> BTreeMap<String, &'static str> {
    let mut all = BTreeMap::new();
    let mut add = |phrase: Phrase, table| {
        if !phrase.is_empty() {
            all.insert(phrase.english.to_owned(), table);
        }
    };
    for control in controls::ALL {
        control.codes.iter().for_each(|row| add(row.text, "code"));
        control.vars.iter().for_each(|row| add(row.text, "variable"));
        control.alarms.iter().for_each(|row| add(row.text, "alarm"));
        control.params.iter().for_each(|row| add(row.text, "parameter"));
        control.interface.iter().for_each(|row| add(row.text, "signal"));
    }
    all.extend(citations::listed().into_iter().map(|source| (source, "citation")));
    all
}

/// The texts of the command line's help: the doc comments of its arguments, as clap shows them.
fn help() -> BTreeSet<String> {
    let arguments = sources().find(|source| source.path == "src/bin/macroline/args.rs").unwrap();
    let docs: Vec<&str> = arguments.text.lines().map(|line| line.trim().strip_prefix("///").unwrap_or("")).collect();
    let texts = docs.split(|line| line.is_empty()).filter(|lines| !lines.is_empty());
    texts.map(|lines| lines.concat().trim().trim_end_matches('.').to_owned()).collect()
}

/// The formulas of results that contain words.
fn formulas() -> BTreeSet<String> {
    let in_words = |formula: &str| {
        let words = formula.split(|c: char| !c.is_ascii_alphabetic()).filter(|word| word.len() > 2);
        words.filter(|word| !["SQRT", "atan", "gcd", "min", "max"].contains(word)).count() > 0
    };
    let of = |machine: &&'static dyn AnyMachine| {
        let projects = machine.examples().iter().flat_map(|example| {
            machine.controls().iter().map(|id| Project::example(*machine, controls::find(id).unwrap(), example))
        });
        projects
            .flat_map(|project| project.design().readouts)
            .map(|readout| readout.formula.english.to_owned())
            .collect::<Vec<_>>()
    };
    machines::ALL.iter().flat_map(of).filter(|formula| in_words(formula)).collect()
}

#[test]
fn other_languages_say_everything() {
    let english = Sentences::of(Language::English);
    let mut broken = Vec::new();
    let sentences = english.checked(&mut broken);
    let (phrases, formulas, help) = (phrases(), formulas(), help());
    let literals: BTreeSet<&str> =
        sources().flat_map(|source| source.literals()).map(|literal| literal.text.as_str()).collect();
    for language in Language::ALL.into_iter().filter(|language| *language != Language::English) {
        let other = Sentences::of(language);
        let rows = other.checked(&mut broken);
        let file = &other.file;
        broken
            .extend(sentences.keys().filter(|id| !rows.contains_key(*id)).map(|id| format!("{file}: {id} is missing")));
        let missing = phrases.iter().filter(|(phrase, _)| !rows.contains_key(phrase.as_str()));
        broken.extend(missing.map(|(phrase, table)| format!("{file}: the phrase of a {table} is missing: {phrase}")));
        let missing = formulas.iter().filter(|formula| !rows.contains_key(formula.as_str()));
        broken.extend(missing.map(|formula| format!("{file}: the formula of a result is missing: {formula}")));
        let missing = help.iter().filter(|text| !rows.contains_key(text.as_str()));
        broken.extend(missing.map(|text| format!("{file}: a text of the command line's help is missing: {text}")));
        for (key, sentence) in &rows {
            match sentences.get(key) {
                Some(original) if places(original) != places(sentence) => {
                    broken.push(format!("{file}: {key} has not the places of “{original}”: {sentence}"));
                }
                None if !phrases.contains_key(*key) && !literals.contains(key) && !help.contains(*key) => {
                    broken.push(format!("{file}: nothing says “{key}”"));
                }
                None if places(key) != places(sentence) => {
                    broken.push(format!("{file}: “{key}” has other places than {sentence}"));
                }
                _ => {}
            }
        }
        // The reader of the program finds each of them.
        catalog::speak(language.sentences());
        let lost = rows.iter().filter(|(key, sentence)| catalog::words(key.to_string().leak()) != **sentence);
        broken.extend(lost.map(|(key, _)| format!("{file}: “{key}” is not found")));
        assert_eq!(catalog::spoken(), language);
        catalog::speak(Language::English.sentences());
    }
    let mend = "one row per id of en.properties and per phrase of a row (`\\ ` for a space, `\\:`, `\\=` in keys), sorted by key";
    hold("Every language says every sentence, with the same places.", mend, broken);
}

#[test]
fn sentences_name_the_list_of_projects_by_its_title() {
    for language in Language::ALL {
        let sentences = Sentences::of(language);
        let rows = sentences.checked(&mut Vec::new());
        let title = format!("“{}”", rows["projects.title"]);
        for id in ["page.fresh", "page.link-opened", "page.store-here-about"] {
            assert!(rows[id].contains(&title), "{id}: {}", rows[id]);
        }
    }
}

/// Words that the glossary bars, and the term in their place.
const BARRED: [(&str, &str); 16] = [
    ("控制器", "系统 or 数控系统"),
    ("告警", "报警"),
    ("警报", "报警"),
    ("挡", "档"),
    ("您", "no address of the reader"),
    ("我们", "no address of the reader"),
    ("单节", "程序段"),
    ("刀片", "车刀"),
    ("程序块", "程序段"),
    ("持续转矩", "连续转矩"),
    ("带材", "带料"),
    ("料带", "带料"),
    ("滑差", "转差"),
    ("电动机", "电机"),
    ("起动", "启动"),
    ("快移", "快速移动"),
];

/// Faults of a Chinese sentence: words that the glossary bars, marks, spaces.
pub(crate) fn chinese_faults(sentence: &str) -> Vec<String> {
    let chinese = |c: char| ('\u{4e00}'..='\u{9fff}').contains(&c);
    let full = |c: char| "，。：；？！（）“”、".contains(c);
    let barred = BARRED.iter().filter(|(word, _)| sentence.contains(word));
    let mut faults: Vec<String> = barred.map(|(word, instead)| format!("{word} is {instead}")).collect();
    let text: Vec<char> = sentence.chars().collect();
    if sentence.contains("} %") {
        faults.push("space between a place and %".to_owned());
    }
    for pair in text.windows(2) {
        let fault = match *pair {
            [a, b] if chinese(a) && ",;:?!".contains(b) => "half-width mark",
            [a, b] if (full(a) && b == ' ') || (a == ' ' && full(b)) => "space beside a full-width mark",
            [a, b] if chinese(a) && (b.is_ascii_alphanumeric() || b == '{') => "no space before Latin letters",
            [a, b] if (a.is_ascii_alphanumeric() || a == '}') && chinese(b) => "no space behind Latin letters",
            _ => continue,
        };
        faults.push(fault.to_owned());
    }
    faults
}

#[test]
fn chinese_follows_its_glossary() {
    let rows = Sentences::of(Language::Chinese).rows;
    let faults = |(key, sentence): (String, String)| {
        chinese_faults(&sentence)
            .into_iter()
            .map(move |fault| format!("{key}: {fault}: {sentence}"))
            .collect::<Vec<_>>()
    };
    let broken = rows.into_iter().flat_map(faults).collect();
    hold("Chinese follows docs/glossary.md.", "see its rules of style", broken);
}

#[test]
fn apostrophes_of_sentences_are_curved() {
    let mut broken = Vec::new();
    for sentences in
        Language::ALL.into_iter().flat_map(|language| [Sentences::of(language), Sentences::of_help(language)])
    {
        let is_straight = |[before, mark]: [char; 2]| before.is_alphabetic() && mark == '\'';
        for (key, sentence) in &sentences.rows {
            let text: Vec<char> = sentence.chars().collect();
            if text.array_windows().any(|pair| is_straight(*pair)) {
                broken.push(format!("{}: {key}: {sentence}", sentences.file));
            }
        }
    }
    hold("Apostrophes are ’.", "’ after a letter; straight marks only around words of a program or a command", broken);
}

/// Sentences whose lengths stay in millimetres in any units: about words that the control reads, or values of a program or a parameter.
const OF_THE_CONTROL: [&str; 12] = [
    "interp.",
    "lint.",
    "motion.",
    "polygon.feed-too-large",
    "polygon.feed-too-small",
    "polygon.x-setting",
    "ribbon.feed-",
    "ribbon.follow-measured",
    "ribbon.knob-stops",
    "ribbon.per-revolution-instead",
    "ribbon.revolution-feed-above-limit",
    "switch.",
];

#[test]
fn lengths_in_sentences_are_shown_in_the_units_of_the_reader() {
    let mut broken = Vec::new();
    let english = Sentences::of(Language::English);
    let marked: BTreeMap<&str, BTreeSet<&str>> =
        english.rows.iter().map(|(id, row)| (id.as_str(), lengths(row).map(|place| place.0).collect())).collect();
    for language in Language::ALL {
        for (id, row) in Sentences::of(language).rows {
            let own: BTreeSet<&str> = lengths(&row).map(|place| place.0).collect();
            if marked.get(id.as_str()).is_some_and(|places| *places != own) {
                broken.push(format!("{}: {id}: other places have units than in English", language.code()));
            }
            let bare = units::converted().filter(|unit| {
                row.split("} ").skip(1).any(|tail| {
                    tail.strip_prefix(unit)
                        .is_some_and(|rest| !rest.starts_with(|c: char| c.is_alphabetic() || "/²³".contains(c)))
                })
            });
            let stays = OF_THE_CONTROL.iter().any(|of| id.starts_with(of));
            broken.extend(
                bare.filter(|_| !stays).map(|unit| format!("{}: {id}: a place before “{unit}”", language.code())),
            );
        }
    }
    let mend = "`{length, unit, mm}` for a length with its unit, `{length, number, mm}` for its number alone; what the control reads stays in its unit and is listed in OF_THE_CONTROL";
    hold("Lengths in sentences are shown in the units of the reader.", mend, broken);
}
