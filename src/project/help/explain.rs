//! An entry of help as text and as an object, for the command line.

use serde_json::{Map, Value as Json, json};

use super::Help;
use super::content::HelpPlace;
use super::texts::{self, Text};
use crate::project::meaning::Meaning;
use crate::text::catalog::{sentence, words};
use crate::text::{Citation, headed, with_aside};

/// Further places that are listed at most.
const FURTHER: usize = 9;

/// Search results for a word, the best first; the id of a place comes before them.
pub fn found<'h>(help: &'h Help, word: &str) -> Vec<HelpPlace<'h>> {
    let named = if word.contains('.') { help.find(word) } else { None };
    named.into_iter().chain(help.search(word)).collect()
}

/// The meaning of a word of the language, then the first place in full, the others by name.
pub fn text(own: Option<&Meaning>, found: &[HelpPlace]) -> String {
    let mut out = own.map(|meaning| meaning.text() + "\n").unwrap_or_default();
    let Some(first) = found.first() else { return out };
    if own.is_some() {
        out.push('\n');
    }
    out.push_str(&format!("{} – {}\n", title(first), first.page.title));
    let mut paragraph = |text: &str| out.push_str(&format!("  {text}\n"));
    if let Some(entry) = first.entry {
        entry.text.iter().for_each(|text| paragraph(&texts::words(text)));
        for fact in &entry.facts {
            paragraph(&headed(fact.name, texts::words(&fact.value)));
        }
        if let Some(Citation { source, grade: known }) = entry.cite {
            paragraph(&headed(source.words(), known.words()));
        }
    } else {
        first.section.text.iter().for_each(|text| paragraph(&texts::words(text)));
        for (at, step) in first.section.steps.iter().enumerate() {
            paragraph(&format!("{}. {}", at + 1, texts::words(step)));
        }
    }
    let further: Vec<String> = found
        .iter()
        .skip(1)
        .filter(|place| place.id() != first.id())
        .take(FURTHER)
        .map(|place| format!("  {}\n", with_aside(&title(place), &place.page.title)))
        .collect();
    if !further.is_empty() {
        out.push_str(&format!("{}\n{}", words("help.further"), further.concat()));
    }
    out
}

/// Word and title of a place.
pub fn title(place: &HelpPlace) -> String {
    match place.entry {
        None => place.section.title.clone(),
        Some(entry) if entry.word.is_empty() => entry.title.clone(),
        Some(entry) if entry.title.is_empty() => entry.word.clone(),
        Some(entry) => format!("{}  {}", entry.word, entry.title),
    }
}

/// The meaning of a word of the language, and all places.
pub fn json(own: Option<&Meaning>, found: &[HelpPlace]) -> Json {
    let list = |all: &[Text]| all.iter().map(texts::words).collect::<Vec<_>>();
    let place = |place: &HelpPlace| {
        let Some(entry) = place.entry else {
            let section = place.section;
            return json!({ "id": place.id(), "page": place.page.title, "title": section.title,
                "text": list(&section.text), "steps": list(&section.steps) });
        };
        let facts: Map<String, Json> =
            entry.facts.iter().map(|fact| (fact.name.to_owned(), texts::words(&fact.value).into())).collect();
        json!({ "id": place.id(), "page": place.page.title, "word": entry.word, "title": entry.title,
            "text": list(&entry.text), "facts": facts,
            "source": entry.cite.map(|cite| cite.source), "grade": entry.cite.map(|cite| cite.grade) })
    };
    let own = own.map(|meaning| {
        json!({ "word": meaning.word, "text": meaning.says.iter().map(sentence).collect::<Vec<_>>(), "unit": meaning.unit,
            "source": meaning.cite.map(|cite| cite.source), "grade": meaning.cite.map(|cite| cite.grade) })
    });
    json!({ "meaning": own, "found": found.iter().map(place).collect::<Vec<_>>() })
}
