//! The alarms and messages that the programs of a machine raise themselves, each with its cause in the program.

use std::collections::BTreeSet;

use super::content::{HelpEntry, HelpKind, HelpSection};
use super::texts::{Texts, plain};
use crate::nc::{Block, Expr, Parsed, Program, Stmt, is_message};
use crate::project::Project;
use crate::text::catalog::of_program;
use crate::text::{Place, clauses};

/// The section of the alarms and messages in the programs of these projects; those of one number and text once.
pub(super) fn section(projects: &[Project], texts: &Texts) -> HelpSection {
    let mut section = HelpSection::new("own-alarms", texts.words("title.own-alarms"));
    let mut known = BTreeSet::new();
    for project in projects {
        let parsed = project.written().parsed;
        for program in &parsed.deck().programs {
            for block in parsed.deck().blocks_of(program) {
                let Some((word, text)) = raised(&parsed, block) else { continue };
                if known.insert((word.clone(), text.clone())) {
                    section.entries.push(entry(&parsed, (program, block), (word, text), texts));
                }
            }
        }
    }
    if !section.entries.is_empty() {
        section.text = texts.list("own-alarms");
    }
    give_ids(&mut section.entries);
    section
}

/// Number as the control shows it, empty without one, and text of the alarm or message that a block raises.
fn raised(parsed: &Parsed, block: &Block) -> Option<(String, String)> {
    let deck = parsed.deck();
    let text = |id| deck.text(id).trim_start_matches('/').to_owned();
    match block.stmt {
        Stmt::Message(message @ Some(_)) => Some((String::new(), text(message))),
        Stmt::Assign { value, .. } | Stmt::IfThen { value, .. } if is_message(deck, parsed.control(), block) => {
            let Expr::Number(number) = deck.expr(value) else { return None };
            let number = number.to_f64() as u32;
            let base = parsed.dialect().running.user_alarm_base;
            let shown = base.map(|base| parsed.control().macros.user_alarm_shown(base + number));
            Some((shown.unwrap_or_else(|| number.to_string()), text(block.comment)))
        }
        _ => None,
    }
}

fn entry(
    parsed: &Parsed,
    (program, block): (&Program, &Block),
    (word, text): (String, String),
    texts: &Texts,
) -> HelpEntry {
    let mut entry = HelpEntry::new(HelpKind::Alarm, "", word, text);
    entry.text.extend(of_program(&entry.title).map(plain));
    let source = |block: &Block| parsed.text(Place { file: program.file, span: block.span }).trim().to_owned();
    let jumps = |other: &&Block| {
        let deck = parsed.deck();
        deck.jumps_of(other.stmt).any(|jump| match deck.expr(jump.target) {
            Expr::Number(number) => block.number.map(f64::from) == Some(number.to_f64()),
            Expr::Label(label) => block.label.is_some() && deck.text(Some(label)) == deck.text(block.label),
            _ => false,
        })
    };
    let conditions = parsed.deck().blocks_of(program).iter().filter(jumps).map(source);
    entry.fact(texts.words("fact.raised-by"), clauses(conditions));
    entry.fact(texts.words("fact.block"), source(block));
    entry
}

/// Gives the entries their ids: by the number that the control shows, else by their place.
fn give_ids(entries: &mut [HelpEntry]) {
    let mut known = BTreeSet::new();
    for (at, entry) in (1_u32..).zip(entries) {
        entry.id = if entry.word.is_empty() { format!("message.{at}") } else { format!("alarm.{}", entry.word) };
        if !known.insert(entry.id.clone()) {
            entry.id = format!("{}.{at}", entry.id);
        }
    }
}
