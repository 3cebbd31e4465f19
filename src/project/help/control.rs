//! The page of a control: loading, alarms with their causes, codes, variables, parameters, registers, open points; each with its source.

use super::content::{HelpEntry, HelpKind, HelpPage, HelpSection};
use super::texts::{Texts, id_of, plain};
use crate::controls::syntax::Percent;
use crate::controls::{Alarm, AlarmDef, Control};
use crate::project::meaning::{code_says, signal_says, variable_says};
use crate::text::catalog::{sentence, words};
use crate::text::{Grade, Message, clauses, headed, sentences};

/// The page of a control.
pub(super) fn page(control: &'static Control, texts: &Texts) -> HelpPage {
    let mut about = HelpSection::new("about", texts.words("title.about"));
    about.text = texts.list(&format!("{}.about", control.id));
    let sections = vec![
        about,
        loading(control, texts),
        alarms(control, texts),
        codes(control, texts),
        variables(control, texts),
        parameters(control, texts),
        signals(control, texts),
        switches(control, texts),
    ];
    HelpPage::new(control.id, control.name, control, sections)
}

/// The steps from an export to the first run.
fn loading(control: &Control, texts: &Texts) -> HelpSection {
    let mut section = HelpSection::new("loading", texts.words("title.loading"));
    section.steps = texts.list("load.before");
    section.steps.push(plain(words(match control.syntax.percent {
        Percent::Both => "form.report.percent-both",
        Percent::End => "form.report.percent-end",
        Percent::Head => "form.report.percent-head",
    })));
    section.steps.push(plain(words("form.report.transfer")));
    section.steps.extend(texts.list(&format!("{}.load", control.id)));
    section.steps.extend(texts.list("load.behind"));
    section
}

/// Alarms by number; each has the causes of all kinds that the control shows it for.
fn alarms(control: &Control, texts: &Texts) -> HelpSection {
    let mut section = HelpSection::new("alarms", texts.words("title.alarms"));
    section.text = texts.list("alarms");
    let mut rows: Vec<&AlarmDef> = control.alarms.iter().collect();
    rows.sort_by_key(|row| row.number);
    for row in rows {
        let id = format!("alarm.{}", row.number);
        if section.entries.last().is_some_and(|entry| entry.id == id) {
            continue;
        }
        let same: Vec<&AlarmDef> = control.alarms.iter().filter(|other| other.number == row.number).collect();
        let mut titles: Vec<&str> = same.iter().map(|other| other.text.words()).collect();
        titles.dedup();
        let mut entry = HelpEntry::new(HelpKind::Alarm, id, row.number, clauses(titles));
        let one_of = |shown: &AlarmDef| same.iter().any(|row| row.kind == shown.kind);
        let shown = |kind: &&Alarm| control.alarm(**kind).is_some_and(one_of) && control.can_raise(**kind);
        for kind in Alarm::ALL.iter().filter(shown) {
            let key = format!("alarm.{}", id_of(&format!("{kind:?}")));
            entry.text.extend(texts.text(&key));
            entry.also.push(key);
        }
        if row.cite.grade == Grade::Open {
            entry.text.push(plain(texts.words("alarm-open")));
        }
        entry.cite = Some(row.cite);
        section.entries.push(entry);
    }
    section
}

fn in_words(says: &[Message]) -> String {
    sentences(says.iter().map(sentence))
}

fn codes(control: &Control, texts: &Texts) -> HelpSection {
    let mut section = HelpSection::new("codes", texts.words("title.codes"));
    for row in control.codes {
        let word = control.code_name(row.id);
        let mut entry = HelpEntry::new(HelpKind::Code, format!("code.{word}"), word, row.text.words());
        entry.text.extend(code_says(row).get(1..).filter(|more| !more.is_empty()).map(|more| plain(in_words(more))));
        entry.cite = Some(row.cite);
        section.entries.push(entry);
    }
    section
}

fn variables(control: &Control, texts: &Texts) -> HelpSection {
    let mut section = HelpSection::new("variables", texts.words("title.variables"));
    for row in control.vars {
        let first = control.variable(row.first);
        let word = if row.first == row.last { first } else { format!("{first} … {}", control.variable(row.last)) };
        let mut entry = HelpEntry::new(HelpKind::Variable, format!("var.{}", row.first), word, row.text.words());
        entry
            .text
            .extend(variable_says(row).get(1..).filter(|more| !more.is_empty()).map(|more| plain(in_words(more))));
        entry.cite = Some(row.cite);
        entry.numbers = Some((row.first, row.last));
        section.entries.push(entry);
    }
    section
}

fn parameters(control: &Control, texts: &Texts) -> HelpSection {
    let mut section = HelpSection::new("parameters", texts.words("title.parameters"));
    for row in control.params {
        let title = match row.name {
            "" => row.text.words().to_owned(),
            name => headed(name, row.text.words()),
        };
        let mut entry = HelpEntry::new(HelpKind::Parameter, format!("param.{}", row.number), row.number, title);
        entry.fact(texts.words("fact.unit"), row.unit.text());
        entry.also.push(format!("param.{}", id_of(&format!("{:?}", row.role))));
        entry.cite = Some(row.cite);
        section.entries.push(entry);
    }
    section
}

fn signals(control: &Control, texts: &Texts) -> HelpSection {
    let mut section = HelpSection::new("signals", texts.words("title.signals"));
    for row in control.interface {
        let mut entry =
            HelpEntry::new(HelpKind::Signal, format!("signal.{}", row.device), row.device, row.text.words());
        entry.text.push(plain(in_words(signal_says(control, row).get(1..).unwrap_or_default())));
        entry.fact(texts.words("fact.unit"), row.unit);
        entry.also.push(format!("signal.{}", id_of(&format!("{:?}", row.role))));
        entry.cite = Some(row.cite);
        section.entries.push(entry);
    }
    section
}

fn switches(control: &Control, texts: &Texts) -> HelpSection {
    let mut section = HelpSection::new("switches", texts.words("title.switches"));
    section.text = texts.list("switches");
    for row in control.switches {
        let mut entry = HelpEntry::new(HelpKind::Switch, format!("switch.{}", row.id()), row.id(), row.text());
        let options = row.options();
        let labels =
            |at: core::ops::Range<usize>| clauses(options.get(at).unwrap_or_default().iter().map(|o| words(o.label)));
        match options.len() {
            0 => entry.fact(texts.words("fact.default"), format!("“{}”", row.default())),
            count => {
                entry.fact(texts.words("fact.default"), labels(0..1));
                entry.fact(texts.words("fact.or"), labels(1..count));
            }
        }
        entry.cite = Some(row.cite);
        section.entries.push(entry);
    }
    section
}
