//! The glossary and the warnings about programs.

use std::collections::BTreeSet;

use super::content::{HelpEntry, HelpKind, HelpPage, HelpSection};
use super::texts::{Texts, plain};
use crate::controls::Control;
use crate::text::catalog::parts::{Form, SentencePart, parts};
use crate::text::catalog::{self, Language, words};

/// The page of the terms of the trade in both languages, from `docs/glossary.md`.
pub(super) fn page(control: &'static Control, texts: &Texts) -> HelpPage {
    let chinese = catalog::spoken() == Language::Chinese;
    let mut sections: Vec<HelpSection> = Vec::new();
    let mut known = BTreeSet::new();
    for line in texts.glossary.lines() {
        if let Some(heading) = line.strip_prefix("## ") {
            let (english, other) = heading.split_once(" · ").unwrap_or((heading, heading));
            sections.push(HelpSection::new(format!("terms-{}", slug(english)), if chinese { other } else { english }));
        }
        let cells: Vec<&str> = line.split('|').map(str::trim).collect();
        let ["", english, term, note, _, ""] = cells.as_slice() else { continue };
        let Some(section) = sections.last_mut().filter(|_| *english != "English" && !english.starts_with("---")) else {
            continue;
        };
        let mut id = format!("term.{}", slug(english));
        while !known.insert(id.clone()) {
            id.push_str("-again");
        }
        let (own, other) = if chinese { (term, english) } else { (english, term) };
        let mut entry = HelpEntry::new(HelpKind::Term, id.clone(), "", *own);
        entry.text.extend(texts.text(&id));
        entry.synonyms = note.to_lowercase();
        entry.fact(texts.words("fact.other-language"), *other);
        section.entries.push(entry);
    }
    HelpPage::new("terms", texts.words("title.terms"), control, sections)
}

/// A term as a part of an id: small letters and digits with hyphens.
fn slug(term: &str) -> String {
    let term = term.to_ascii_lowercase();
    let parts = term.split(|c: char| !c.is_ascii_alphanumeric()).filter(|part| !part.is_empty());
    parts.collect::<Vec<_>>().join("-")
}

/// The page about programs: how the page works, and every warning by the id that leaves it out.
pub(super) fn programs(control: &'static Control, texts: &Texts) -> HelpPage {
    let mut about = HelpSection::new("use", texts.words("title.use"));
    about.text = texts.list("use");
    let mut rules = HelpSection::new("rules", texts.words("title.rules"));
    rules.text = texts.list("rules");
    for id in catalog::ids("lint.") {
        let mut entry = HelpEntry::new(HelpKind::Rule, format!("rule.{id}"), id, "");
        entry.text.push(plain(open(words(id))));
        rules.entries.push(entry);
    }
    HelpPage::new("programs", texts.words("title.programs"), control, vec![about, rules])
}

/// A sentence with an ellipsis at each place of a value.
pub(in crate::project) fn open(sentence: &str) -> String {
    let text = |part| match part {
        SentencePart::Words(words) => words,
        SentencePart::Place(_, Form::Plural([_, many])) => many,
        SentencePart::Place(..) => "…",
    };
    parts(sentence).map(text).collect()
}
