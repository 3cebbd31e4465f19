//! Help: every row, field and term has an entry, every link has a target, and search finds numbers and words of both languages.

use std::collections::BTreeSet;
use std::fmt::Write;
use std::process::Output;

use expect_test::expect;
use macroline::controls::{self, Control};
use macroline::machines::form::{FieldKindInfo, Value};
use macroline::machines::{self, AnyMachine};
use macroline::nc::{Stmt, is_message};
use macroline::project::Project;
use macroline::project::help::content::{HelpEntry, HelpKind, HelpPlace};
use macroline::project::help::texts::{Text, Texts, words};
use macroline::project::help::{Help, explain, pages, search};
use macroline::text::catalog::{self, Language};

use serde_json::Value as Json;

use super::command;
use super::tidy::catalog::{Sentences, chinese_faults};

/// Every machine on each of its controls.
fn subjects() -> impl Iterator<Item = (&'static dyn AnyMachine, &'static Control)> {
    machines::ALL
        .iter()
        .flat_map(|machine| machine.controls().iter().filter_map(|id| Some((*machine, controls::find(id)?))))
}

fn help(machine: &'static dyn AnyMachine, control: &'static Control) -> Help {
    Help::new(machine, control, &Texts::shipped(catalog::spoken()))
}

/// Help on a control.
fn on(control: &'static Control) -> Help {
    let machine = pages::machine_on(control).unwrap_or(machines::ALL[0]);
    help(machine, control)
}

fn ribbon() -> Help {
    on(controls::find("mitsubishi-e60").unwrap())
}

/// Runs a part of a test in a language.
fn speaking<T>(language: Language, part: impl FnOnce() -> T) -> T {
    catalog::speak(language.sentences());
    let done = part();
    catalog::speak(Language::English.sentences());
    done
}

/// Every text of a help.
fn texts(help: &Help) -> impl Iterator<Item = &Text> {
    help.pages.iter().flat_map(|page| &page.sections).flat_map(|section| {
        let entries = section.entries.iter().flat_map(|e| e.text.iter().chain(e.facts.iter().map(|fact| &fact.value)));
        section.text.iter().chain(&section.steps).chain(entries)
    })
}

#[test]
fn every_row_of_every_control_has_an_entry() {
    let mut missing = Vec::new();
    for control in controls::ALL {
        let help = on(control);
        let codes = control.codes.iter().map(|row| format!("code.{}", control.code_name(row.id)));
        let vars = control.vars.iter().flat_map(|row| [row.first, row.last]).map(|number| format!("var.{number}"));
        let alarms = control.alarms.iter().map(|row| format!("alarm.{}", row.number));
        let params = control.params.iter().map(|row| format!("param.{}", row.number));
        let signals = control.interface.iter().map(|row| format!("signal.{}", row.device));
        let switches = control.switches.iter().map(|row| format!("switch.{}", row.id()));
        let all = codes.chain(vars).chain(alarms).chain(params).chain(signals).chain(switches);
        let here = |id: &String| help.find(&format!("{}/{id}", control.id)).is_some_and(|place| place.entry.is_some());
        missing.extend(all.filter(|id| !here(id)).map(|id| format!("{}: {id}", control.id)));
        let cited = help.pages.iter().filter(|page| page.id == control.id).flat_map(|page| &page.sections);
        let uncited = cited.flat_map(|section| &section.entries).filter(|entry| entry.cite.is_none());
        missing.extend(uncited.map(|entry| format!("{}: {} without source", control.id, entry.id)));
    }
    assert_eq!(missing, Vec::<String>::new());
}

/// Projects of a machine on a control in which each choice is taken once.
fn choices(machine: &'static dyn AnyMachine, control: &'static Control) -> Vec<Project> {
    let mut all: Vec<Project> = machine.examples().iter().map(|e| Project::example(machine, control, e)).collect();
    for field in machine.fields() {
        let others = match &field.kind {
            FieldKindInfo::Choice(options) => options.iter().map(|(id, _)| Value::Text((*id).to_owned())).collect(),
            FieldKindInfo::Flag(default) => vec![Value::Flag(!default)],
            _ => Vec::new(),
        };
        for value in others {
            let mut project = Project::new(machine, control);
            project.values.insert(field.id.to_owned(), value);
            all.push(project);
        }
    }
    all
}

#[test]
fn every_field_and_result_of_every_machine_has_an_entry() {
    let mut missing = BTreeSet::new();
    for (machine, control) in subjects() {
        let help = help(machine, control);
        let fields = machine.fields().into_iter().map(|field| format!("field.{}", field.id));
        let projects = choices(machine, control);
        let results = projects.iter().flat_map(|project| project.design().readouts);
        let results = results.map(|readout| format!("result.{}", readout.id));
        let variables = Project::new(machine, control).prepared().variables();
        let variables = variables.into_iter().map(|row| format!("var.{}", row.number));
        for id in fields.chain(results).chain(variables) {
            if help.find(&format!("{}/{id}", machine.id())).is_none() {
                missing.insert(format!("{} on {}: {id}", machine.id(), control.id));
            }
        }
    }
    assert_eq!(missing, BTreeSet::new());
}

#[test]
fn every_page_of_a_machine_has_its_manual() {
    let help = ribbon();
    for machine in machines::ALL {
        for section in ["about", "parts", "commissioning", "first", "loading", "faults", "fields", "results"] {
            assert!(help.find(&format!("{}/{section}", machine.id())).is_some(), "{} has no {section}", machine.id());
        }
    }
    for control in controls::ALL {
        for section in ["about", "loading", "alarms", "codes", "variables", "switches"] {
            assert!(help.find(&format!("{}/{section}", control.id)).is_some(), "{} has no {section}", control.id);
        }
    }
}

#[test]
fn every_alarm_has_its_causes() {
    let mut missing = Vec::new();
    for control in controls::ALL {
        let help = on(control);
        for row in control.alarms {
            let entry = help.find(&format!("{}/alarm.{}", control.id, row.number)).unwrap().entry.unwrap();
            if entry.text.is_empty() {
                missing.push(format!("{}: {} ({:?})", control.id, row.number, row.kind));
            }
        }
    }
    assert_eq!(missing, Vec::<String>::new());
}

#[test]
fn every_link_leads_to_its_place() {
    let raw: BTreeSet<String> = Language::ALL
        .into_iter()
        .flat_map(|language| Sentences::of_help(language).rows)
        .flat_map(|(_, sentence)| links(&sentence))
        .collect();
    for language in Language::ALL {
        speaking(language, || {
            for (machine, control) in subjects() {
                let help = help(machine, control);
                for piece in texts(&help).flatten() {
                    let known = piece.to.is_empty() || help.find(&piece.to).is_some_and(|place| place.id() == piece.to);
                    assert!(known, "{} leads nowhere", piece.to);
                    let lost = piece.to.is_empty() && raw.contains(&piece.words);
                    assert!(!lost, "{} on {}: {} is not found", machine.id(), control.id, piece.words);
                }
            }
        });
    }
}

fn links(sentence: &str) -> Vec<String> {
    sentence.split('{').skip(1).filter_map(|tail| Some(tail.split_once('}')?.0.to_owned())).collect()
}

#[test]
fn languages_have_the_same_manual_and_all_of_it_is_shown() {
    let mut broken = Vec::new();
    let english = Sentences::of_help(Language::English);
    let keys = english.checked(&mut broken);
    for language in Language::ALL {
        let own = Sentences::of_help(language);
        let rows = own.checked(&mut broken);
        for (key, sentence) in &keys {
            match rows.get(key) {
                None => broken.push(format!("{}: {key} is missing", language.code())),
                Some(own) => {
                    let [mut a, mut b] = [links(sentence), links(own)];
                    a.sort();
                    b.sort();
                    if a != b {
                        broken.push(format!("{}: {key} has other links", language.code()));
                    }
                }
            }
        }
        broken.extend(rows.keys().filter(|key| !keys.contains_key(*key)).map(|key| format!("{key} is not English")));
        let shown = speaking(language, || {
            let mut shown = String::new();
            for (machine, control) in subjects() {
                let help = help(machine, control);
                let titles = help.pages.iter().flat_map(|page| &page.sections).map(|section| section.title.clone());
                shown.extend(titles.chain(help.pages.iter().map(|page| page.title.clone())));
                shown.extend(help.pages.iter().flat_map(|page| &page.sections).flat_map(|section| {
                    section.entries.iter().flat_map(|entry| entry.facts.iter().map(|fact| fact.name))
                }));
                shown.extend(texts(&help).map(words));
                shown.push('\n');
            }
            shown
        });
        let is_shown = |sentence: &str| sentence.split(['{', '}']).step_by(2).all(|part| shown.contains(part));
        broken.extend(rows.iter().filter(|row| !is_shown(row.1)).map(|row| format!("nothing shows {}", row.0)));
    }
    assert_eq!(broken, Vec::<String>::new());
}

/// Whether a text is a list of links.
fn is_list(text: &Text) -> bool {
    text.iter().any(|piece| piece.words == " · ")
}

#[test]
fn chinese_help_follows_the_glossary() {
    speaking(Language::Chinese, || {
        let help = ribbon();
        let entries = help.pages.iter().flat_map(|page| &page.sections).flat_map(|section| &section.entries);
        let titles = entries.filter(|entry| entry.kind != HelpKind::Term).map(|entry| entry.title.clone());
        let all: BTreeSet<String> =
            texts(&help).filter(|text| text.len() > 1 && !is_list(text)).map(words).chain(titles).collect();
        let broken: Vec<String> = all
            .iter()
            .flat_map(|text| chinese_faults(text).into_iter().map(move |fault| format!("{fault}: {text}")))
            .collect();
        assert_eq!(broken, Vec::<String>::new());
    });
}

#[test]
fn search_for_an_alarm_number_finds_it_first() {
    let mut wrong = Vec::new();
    for control in controls::ALL {
        let help = on(control);
        for row in control.alarms {
            let first = help.search(row.number).first().map(HelpPlace::id);
            if first != Some(format!("{}/alarm.{}", control.id, row.number)) {
                wrong.push(format!("{} on {}: {first:?}", row.number, control.id));
            }
        }
    }
    assert_eq!(wrong, Vec::<String>::new());
}

#[track_caller]
fn finds(help: &Help, query: &str, expected: &str) {
    let found: Vec<String> = help.search(query).iter().map(|place| place.id()).collect();
    assert_eq!(found.first().map(String::as_str), Some(expected), "{query}: {found:?}");
}

#[test]
fn search_finds_codes_variables_and_words() {
    let help = ribbon();
    for (query, expected) in [
        ("p62", "mitsubishi-e60/alarm.P62"),
        ("G01", "mitsubishi-e60/code.G1"),
        ("M03", "mitsubishi-e60/code.M3"),
        ("#107", "ribbon-line/field.pitch"),
        ("#104", "ribbon-line/var.104"),
        ("#2005", "mitsubishi-e60/var.2001"),
        ("R74", "mitsubishi-e60/signal.R74"),
        ("spindle override", "ribbon-line/field.override"),
        ("feed hold", "terms/term.feed-hold"),
        ("活套", "terms/term.slack-loop-loop"),
        ("commissioning", "ribbon-line/commissioning"),
        ("lint.zero-divisor", "programs/rule.lint.zero-divisor"),
    ] {
        finds(&help, query, expected);
    }
    speaking(Language::Chinese, || {
        let help = ribbon();
        for (query, expected) in [
            ("P62", "mitsubishi-e60/alarm.P62"),
            ("节距", "ribbon-line/field.pitch"),
            ("调试", "ribbon-line/commissioning"),
            ("dancer", "terms/term.dancer"),
        ] {
            finds(&help, query, expected);
        }
        // Words of makers and workshops lead to the glossary's term.
        for (query, term) in [("引数", "argument"), ("计算参数", "r-parameter"), ("刀补", "tool-offset")] {
            let found = help.search(query);
            assert!(found.iter().any(|place| place.id() == format!("terms/term.{term}")), "{query}");
        }
    });
}

#[test]
fn words_that_no_place_has_together_lead_to_the_nearest() {
    let help = ribbon();
    for query in ["dancer zzzz", "slackening", "loops zzzz"] {
        assert!(help.search(query).is_empty(), "{query}");
        assert!(!help.nearest(query).is_empty(), "{query}");
    }
    // A place with both words comes before those with one of them.
    let both: Vec<String> = help.search("analog output").iter().map(HelpPlace::id).collect();
    assert!(both.contains(&help.nearest("analog output zzzz")[0].id()));
    assert!(help.nearest("zzzz").is_empty());
}

#[test]
fn excerpt_has_the_word_that_was_sought() {
    let help = ribbon();
    for (query, word) in [("dancer", "dancer"), ("inverter", "inverter")] {
        let excerpts: Vec<String> = help.search(query).iter().map(|place| place.excerpt(query, 120)).collect();
        let with_word = excerpts.iter().filter(|text| text.to_lowercase().contains(word)).count();
        assert!(2 * with_word > excerpts.len(), "{query}: {excerpts:?}");
        assert!(excerpts.iter().all(|text| text.chars().count() <= 122), "{query}");
        assert!(excerpts.iter().filter(|text| text.starts_with('…')).all(|text| !text.starts_with("… ")), "{query}");
    }
}

#[test]
fn search_takes_any_text() {
    let help = ribbon();
    let long = "活".repeat(10_000);
    for query in
        ["", " ", "\u{0}", "#", "{", "((", "🤖", "é\u{301}", &long, "#99999999999999999999", "no such thing anywhere"]
    {
        assert!(help.search(query).is_empty() || query == "#" || query == "{" || query == "((", "{query:.20}");
    }
    assert!(help.search("a").len() <= search::MOST);
}

#[test]
fn alarm_without_a_row_is_one_of_the_program() {
    let help = on(controls::find("gsk-980tdc").unwrap());
    let place = help.find("alarm.5977").unwrap();
    assert_eq!(place.entry.unwrap().word, "5900");
    assert!(help.find("field.no-such-field").is_none() && help.find("").is_none() && help.find("/").is_none());
}

#[test]
fn explained_word_has_causes_and_source() {
    let help = ribbon();
    let text = explain::text(None, &explain::found(&help, "P283"));
    assert!(text.starts_with("P283"), "{text}");
    assert!(text.contains("A division by 0") && text.contains("open"), "{text}");
    let json = explain::json(None, &explain::found(&help, "field.pitch"));
    assert_eq!(json["found"][0]["id"], "ribbon-line/field.pitch");
    assert!(explain::text(None, &explain::found(&help, "no such thing")).is_empty());
}

#[test]
fn drawing_of_every_machine_has_its_numbered_parts() {
    let mut without = String::new();
    for (machine, control) in subjects() {
        let drawing = pages::drawing(machine, control, macroline::view::Theme::Light);
        let parts = Project::new(machine, control).prepared().parts();
        assert!(drawing.starts_with("<svg") && !parts.is_empty());
        for (item, part) in (1..).zip(parts).filter(|(item, _)| !drawing.contains(&format!(">{item}</text>"))) {
            writeln!(without, "{} {}: {item} {}", machine.id(), control.id, part.name).unwrap();
        }
    }
    // Parts without room for their balloon.
    expect![[""]].assert_eq(&without);
}

/// Runs the program.
fn run(args: &[&str]) -> Output {
    command::macroline().args(args).output().unwrap()
}

#[test]
fn explain_knows_the_words_of_the_language() {
    for (word, control, means) in [
        ("CR", "sinumerik-802d", "Radius"),
        ("LIMS", "sinumerik-802d", "Highest spindle speed"),
        ("GOTO", "fanuc-0i-mf", "Goes on at the block"),
        ("FUP", "fanuc-0i-mf", "Whole number"),
    ] {
        let out = run(&["explain", word, "--control", control]);
        let text = String::from_utf8(out.stdout).unwrap();
        let first = text.lines().next().unwrap_or_default();
        assert!(first.starts_with(word) && first.contains(means), "{first}");
    }
}

#[test]
fn explain_prints_causes_of_an_alarm_on_its_control() {
    let out = run(&["explain", "P62"]);
    let text = String::from_utf8(out.stdout).unwrap();
    assert!(out.status.success() && text.contains("No F command") && text.contains("Write F"), "{text}");
    let out = run(&["explain", "field.pitch", "--json"]);
    let found: Json = serde_json::from_slice(&out.stdout).unwrap();
    assert_eq!(found["found"][0]["id"], "ribbon-line/field.pitch");
    let out = run(&["explain", "G96", "--control", "sinumerik-802d", "--json"]);
    let found: Json = serde_json::from_slice(&out.stdout).unwrap();
    assert_eq!(found["found"][0]["id"], "sinumerik-802d/code.G96");
}

#[test]
fn explain_of_an_unknown_word_fails() {
    assert_eq!(run(&["explain", "no such word at all"]).status.code(), Some(1));
    assert_eq!(run(&["explain", "P62", "--control", "none"]).status.code(), Some(2));
}

/// The number that the control shows leads to the text of the program, its condition and its block, on every control with numbers.
#[test]
fn own_alarms_of_the_programs_have_entries() {
    let mut missing = Vec::new();
    for (machine, control) in subjects() {
        let help = help(machine, control);
        let parsed = Project::new(machine, control).written().parsed;
        for block in &parsed.deck().blocks {
            let text = match block.stmt {
                Stmt::Message(text) => parsed.deck().text(text),
                _ if is_message(parsed.deck(), control, block) => parsed.deck().text(block.comment),
                _ => "",
            };
            let entries = help.pages[0].sections.iter().find(|section| section.id == "own-alarms").map(|s| &s.entries);
            let entry = entries.and_then(|entries| entries.iter().find(|entry| entry.title == text));
            let complete = |entry: &HelpEntry| entry.facts.len() == 2 && help.find(&entry.id).is_some();
            if !text.is_empty() && !entry.is_some_and(complete) {
                missing.push(format!("{} on {}: {text}", machine.id(), control.id));
            }
        }
    }
    assert_eq!(missing, Vec::<String>::new());
    let help = help(machines::find("polygon-lathe").unwrap(), controls::find("knd-k2000t").unwrap());
    let best = help.search("3011")[0].entry.unwrap();
    assert_eq!((best.word.as_str(), best.title.as_str()), ("3011", "RETRACT THE CUTTER BY HAND"));
}
