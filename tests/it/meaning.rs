//! Meaning of words on a control, and the fields that a result depends on.

use std::rc::Rc;

use macroline::controls::{ALL, CodeId, Switches, find};
use macroline::machines::{ControlContext, MachineVariable};
use macroline::motion::{Action, Budget, Event, Retention};
use macroline::nc::{self, Files};
use macroline::project::dependence::fields_by_result;
use macroline::project::meaning::{self, Meaning, Subject, Table, Words};
use macroline::project::run::{self, RunOptions};
use macroline::project::{Project, run::Run};
use macroline::text::catalog::sentence;

use crate::queries::every_machine_on_every_control;

fn ribbon() -> Project {
    Project::of("ribbon-line", Some("mitsubishi-e60")).unwrap()
}

fn text(meaning: &Meaning) -> String {
    meaning.says.iter().map(sentence).collect::<Vec<_>>().join(" ")
}

#[track_caller]
fn program(word: &str) -> Meaning {
    meaning::of(&ribbon(), word, Table::Program).unwrap_or_else(|| panic!("{word} has no meaning"))
}

fn planned(project: &Project) -> Run {
    let limits = Budget { blocks: 100_000, seconds: 10.0 };
    let begin = RunOptions { start: None, settings: &[], limits, keep: Retention::Timeline };
    let mut run = run::of_project(project, &project.written(), &begin);
    while run.advance(10.0, 4096).ended.is_none() && run.timeline().end() < 5.0 {}
    run
}

#[test]
fn words_of_a_line_are_addresses_with_their_numbers() {
    let control = ribbon().control;
    let line = "N35 G01 X-8.5 Y#110 F[#115*2] (G02)";
    let found: Vec<&str> = meaning::words(line, control).iter().map(|span| span.of(line)).collect();
    assert_eq!(found, ["N35", "G01", "X-8.5", "Y", "#110", "F", "#115"]);
}

#[test]
fn code_has_the_text_and_source_of_its_row() {
    let found = program("G01");
    let row = ribbon().control.code(CodeId::g(1)).unwrap();
    assert_eq!((found.word.as_str(), found.subject, found.cite), ("G1", Subject::Code(row.id), Some(row.cite)));
    assert!(text(&found).starts_with(row.text.english), "{}", text(&found));
    assert!(text(&found).contains("In force"), "{}", text(&found));
    assert!(text(&program("g4")).contains("its own block"));
}

#[test]
fn variable_has_the_meaning_that_the_machine_gives_it() {
    let project = ribbon();
    let MachineVariable { number, label, unit } = project.prepared().variables()[0];
    let found = program(&format!("#{number}"));
    assert_eq!((found.subject, found.unit), (Subject::Variable(number), unit));
    let own = macroline::text::catalog::words(label);
    assert!(text(&found).starts_with(own), "{}", text(&found));
    assert_eq!(found.cite, Some(project.control.var(number).unwrap().cite));
}

#[test]
fn number_is_a_variable_in_programs_and_a_parameter_in_sheets() {
    let project = ribbon();
    let row = project.control.params.iter().find(|row| row.number.starts_with("#3")).unwrap();
    let found = meaning::of(&project, row.number, Table::Parameters).unwrap();
    assert_eq!((found.subject, found.cite), (Subject::Parameter, Some(row.cite)));
    assert_ne!(meaning::of(&project, row.number, Table::Program).map(|other| other.subject), Some(Subject::Parameter));
}

#[test]
fn every_row_of_a_control_has_a_meaning_and_a_source() {
    for project in every_machine_on_every_control() {
        let control = project.control;
        let known = |word: &str, table| {
            let found = meaning::of(&project, word, table);
            let found = found.unwrap_or_else(|| panic!("{}: {word} in {table:?}", control.id));
            assert!(found.cite.is_some() && !text(&found).is_empty(), "{}: {word}", control.id);
        };
        control.codes.iter().for_each(|row| known(&control.code_name(row.id), Table::Program));
        control.vars.iter().for_each(|row| known(&control.variable(row.first), Table::Program));
        control.axes.iter().for_each(|row| known(&row.letter.to_string(), Table::Program));
        control.params.iter().for_each(|row| known(row.number, Table::Parameters));
        control.alarms.iter().for_each(|row| known(row.number, Table::Alarms));
        let dialect = project.control_context().dialect();
        for row in control.interface {
            known(&dialect.device(control, row.role).unwrap().0, Table::Interface);
        }
    }
}

#[test]
fn every_word_of_the_written_programs_has_a_meaning() {
    for project in every_machine_on_every_control() {
        let written = project.written();
        for line in written.files.0.iter().flat_map(|file| file.text.lines()) {
            for span in meaning::words(line, project.control) {
                let word = span.of(line);
                let found = meaning::at(&project, line, span.start);
                assert!(found.is_some_and(|(at, _)| at == span), "{}: {word:?} in {line:?}", project.control.id);
            }
        }
    }
}

#[test]
fn every_keyword_of_a_control_has_a_meaning() {
    for project in every_machine_on_every_control() {
        let ignored = nc::IGNORED_STATEMENTS.into_iter().filter(|_| project.control.syntax.names().is_none());
        for word in nc::keywords(project.control).into_iter().chain(ignored) {
            let found = meaning::of(&project, word, Table::Program);
            assert!(found.is_some_and(|found| found.subject == Subject::Keyword), "{word} on {}", project.control.id);
        }
    }
}

#[test]
fn any_text_has_a_meaning_or_none() {
    let project = ribbon();
    for text in
        ["", " ", "G", "G99999999999", "M-1", "#", "#99999999999", "G1.15", "é", "(", "X", "CYCLE97", "%", "G\u{663}"]
    {
        for table in [Table::Program, Table::Interface, Table::Parameters, Table::Alarms] {
            let _ = meaning::of(&project, text, table);
        }
        let _ = meaning::at(&project, text, 0);
    }
}

#[test]
fn live_value_is_that_of_the_moment() {
    let mut project = ribbon();
    project.panel.add(Event { t: 2.0, action: Action::FeedOverride(80.0) });
    let run = planned(&project);
    let live = |word: &str, table, t| meaning::of(&project, word, table).unwrap().live(&project, &run, t);
    let value = |word: &str, t| live(word, Table::Program, t).unwrap();
    let at = 3.5;
    assert_eq!(value("X", at).value, Some(run.timeline().words_at(at)[0]));
    assert_eq!((value("S", at).value, value("S", at).unit), (Some(run.timeline().at(at).spindle.actual), "r/min"));
    let MachineVariable { number, .. } = project.prepared().variables()[0];
    let name = project.control.variable(number);
    assert_eq!(value(&name, at).value, run::shown(&run, project.control, number, at));
    assert!(live("G01", Table::Program, at).is_none() && live("#1", Table::Program, at).is_none());
    let role = macroline::controls::interface::SignalRole::FeedOverride;
    let (device, _) = project.control_context().dialect().device(project.control, role).unwrap();
    assert_eq!(live(&device, Table::Interface, 1.0).unwrap().value, Some(100.0));
    assert_eq!(live(&device, Table::Interface, at).unwrap().value, Some(80.0));
}

#[test]
fn pasted_program_has_meanings() {
    let control = ALL.iter().find(|control| control.id == "sinumerik-802d").unwrap();
    let project = Project::of("ribbon-line", Some(control.id)).unwrap();
    let line = "N10 G1 X=R107 CR=5 LIMS=2000 DIAMON ; G2";
    let _ = Rc::new(nc::parse(&Files::one("A.MPF", line), control));
    let found: Vec<&str> = meaning::words(line, control).iter().map(|span| span.of(line)).collect();
    assert_eq!(found, ["N10", "G1", "X", "R107", "CR=5", "LIMS=2000", "DIAMON"]);
    for span in meaning::words(line, control) {
        assert!(meaning::at(&project, line, span.start).is_some(), "{}", span.of(line));
    }
}

#[test]
fn result_depends_on_the_fields_of_its_formula() {
    let found = fields_by_result(&ribbon());
    for (result, field, depends) in [
        ("line-speed", "press-roller-diameter", true),
        ("line-speed", "pitch-count", false),
        ("dots-per-second", "pitch", true),
        ("dots-per-product", "pitch", false),
    ] {
        assert_eq!(found[result].contains(&field), depends, "{result} {field}: {:?}", found[result]);
    }
}

#[test]
fn every_result_depends_on_some_field() {
    for project in every_machine_on_every_control() {
        let found = fields_by_result(&project);
        let design = project.design();
        let headlines: Vec<_> = design.readouts.iter().filter(|readout| readout.headline).collect();
        assert!(!headlines.is_empty(), "{}", project.machine.id());
        for readout in headlines {
            assert!(!found[readout.id].is_empty(), "{} {}", project.machine.id(), readout.id);
        }
    }
}

#[test]
fn meaning_of_an_address_depends_on_the_code_of_its_block() {
    let meaning_in = |id: &str, line: &str, word: &str| {
        let project =
            Project::of(if id == "mitsubishi-e60" { "ribbon-line" } else { "turning-spindle" }, Some(id)).unwrap();
        let at = line.find(word).unwrap() as u32;
        text(&meaning::at(&project, line, at).unwrap().1)
    };
    assert_eq!(meaning_in("mitsubishi-e60", "G04 X2.", "X"), "Time of the dwell.");
    assert_eq!(meaning_in("mitsubishi-e60", "G33 Z-10. F2.", "F"), "Lead of the thread.");
    assert_eq!(meaning_in("sinumerik-802d", "G33 Z-10 K2", "K"), "Lead of the thread.");
    assert_eq!(
        meaning_in("sinumerik-802d", "G2 X5 Z5 K2", "K"),
        "Centre of an arc from its start; argument of a macro call."
    );
    assert_eq!(meaning_in("sinumerik-802d", "L10 P3", "P"), "How often a program is called.");
}

/// The word at a text of a line, on a control.
#[track_caller]
fn in_line(control: &str, line: &str, word: &str) -> String {
    let switches = Switches::default();
    let words = Words::bare(ControlContext { control: find(control).unwrap(), switches: &switches });
    let (_, found) = words.at(line, line.find(word).unwrap() as u32).unwrap_or_else(|| panic!("{word}"));
    text(&found)
}

#[test]
fn word_in_a_macro_call_is_its_variable() {
    let line = "G65 P9010 X10. F100. S500 M7";
    for (word, variable) in [("X10", "#24"), ("F100", "#9"), ("S500", "#19"), ("M7", "#13")] {
        let found = in_line("fanuc-0i-mf", line, word);
        assert!(found.contains(variable) && !found.contains("Position"), "{word}: {found}");
    }
    assert!(in_line("gsk-980tdc", "G65 H01 P#100 Q#101", "H01").contains("macro function"));
}

#[test]
fn speed_in_a_dwell_is_its_length_in_turns() {
    let found = in_line("sinumerik-802d", "G4 S5", "S5");
    assert!(found.contains("turns") && !found.contains("speed"), "{found}");
}
