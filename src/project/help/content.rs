//! Contents of help: pages with sections and entries, and places in them.

use super::texts::{Text, plain};
use crate::controls::Control;
use crate::text::Citation;

/// Kind of an entry, the kinds that are looked up most first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum HelpKind {
    /// An alarm of a control, by its number.
    Alarm,
    /// A G or M code.
    Code,
    /// A variable, or a range of them.
    Variable,
    /// A field of a machine's form.
    Field,
    /// A result of a machine, with the rule that judges it.
    Result,
    /// A parameter of a control.
    Parameter,
    /// A register between PLC and control.
    Signal,
    /// An open point of a control.
    Switch,
    /// A warning about programs.
    Rule,
    /// A term of the glossary.
    Term,
}

/// A fact of an entry: its name and its value.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Fact {
    /// Name.
    pub name: &'static str,
    /// Value, which may have links.
    pub value: Text,
}

/// Entry of a section: one subject, such as an alarm or a field, with its facts.
#[derive(Debug, Clone, PartialEq)]
pub struct HelpEntry {
    /// Id within its page: kind and name, for instance `alarm.P62`.
    pub id: String,
    /// Kind.
    pub kind: HelpKind,
    /// The subject in the spelling of control or form: `P62`, `#107`; empty if it only has a title.
    pub word: String,
    /// Title.
    pub title: String,
    /// Paragraphs.
    pub text: Vec<Text>,
    /// Facts.
    pub facts: Vec<Fact>,
    /// Source and grade.
    pub cite: Option<Citation>,
    /// Further ids within the page that lead here.
    pub also: Vec<String>,
    /// Words of other makers and of workshops, which the search finds and no page shows.
    pub synonyms: String,
    /// First and last variable of a range.
    pub numbers: Option<(u32, u32)>,
}

/// A part of a page.
#[derive(Debug, Clone, PartialEq)]
pub struct HelpSection {
    /// Id within its page, without a dot.
    pub id: String,
    /// Title.
    pub title: String,
    /// Paragraphs.
    pub text: Vec<Text>,
    /// Steps in their order, below the paragraphs.
    pub steps: Vec<Text>,
    /// Names of the numbered parts of the drawing that the section has; empty without one.
    pub parts: Vec<String>,
    /// Entries.
    pub entries: Vec<HelpEntry>,
}

/// A page.
#[derive(Debug, Clone)]
pub struct HelpPage {
    /// Id: the id of a machine or control, or `terms` or `programs`.
    pub id: &'static str,
    /// Title.
    pub title: String,
    /// The control whose variables and codes the page names.
    pub control: &'static Control,
    /// Sections.
    pub sections: Vec<HelpSection>,
}

/// A place in the help.
#[derive(Debug, Clone, Copy)]
pub struct HelpPlace<'h> {
    /// Page.
    pub page: &'h HelpPage,
    /// Section.
    pub section: &'h HelpSection,
    /// Entry; `None` for the section as a whole.
    pub entry: Option<&'h HelpEntry>,
}

impl HelpPlace<'_> {
    /// Full id.
    pub fn id(&self) -> String {
        format!("{}/{}", self.page.id, self.entry.map_or(&self.section.id, |entry| &entry.id))
    }

    /// Name of the place in links.
    pub fn name(&self) -> String {
        self.entry.map_or_else(|| self.section.title.clone(), HelpEntry::name)
    }
}

impl HelpEntry {
    pub(super) fn new(
        kind: HelpKind,
        id: impl Into<String>,
        word: impl Into<String>,
        title: impl Into<String>,
    ) -> HelpEntry {
        HelpEntry {
            id: id.into(),
            kind,
            word: word.into(),
            title: title.into(),
            text: Vec::new(),
            facts: Vec::new(),
            cite: None,
            also: Vec::new(),
            synonyms: String::new(),
            numbers: None,
        }
    }

    /// Adds a fact; an empty value is none.
    pub(super) fn fact(&mut self, name: &'static str, value: impl Into<String>) {
        let value = value.into();
        if !value.trim().is_empty() {
            self.facts.push(Fact { name, value: plain(value) });
        }
    }

    /// Name in a sentence: fields, results and terms by their title, else as the control writes it.
    pub fn name(&self) -> String {
        match self.kind {
            HelpKind::Field | HelpKind::Result | HelpKind::Term | HelpKind::Switch => self.title.clone(),
            _ if self.word.is_empty() => self.title.clone(),
            _ => self.word.clone(),
        }
    }

    fn has_id(&self, id: &str) -> bool {
        self.id == id || self.also.iter().any(|also| also == id)
    }

    pub(super) fn texts_mut(&mut self) -> impl Iterator<Item = &mut Text> {
        self.text.iter_mut().chain(self.facts.iter_mut().map(|fact| &mut fact.value))
    }
}

impl HelpSection {
    pub(super) fn new(id: impl Into<String>, title: &str) -> HelpSection {
        let (text, steps, parts, entries) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        HelpSection { id: id.into(), title: title.to_owned(), text, steps, parts, entries }
    }

    pub(super) fn is_empty(&self) -> bool {
        self.text.is_empty() && self.steps.is_empty() && self.parts.is_empty() && self.entries.is_empty()
    }
}

impl HelpPage {
    /// A page without its empty sections.
    pub(super) fn new(
        id: &'static str,
        title: impl Into<String>,
        control: &'static Control,
        sections: Vec<HelpSection>,
    ) -> HelpPage {
        let sections = sections.into_iter().filter(|section| !section.is_empty()).collect();
        HelpPage { id, title: title.into(), control, sections }
    }

    /// The section or entry with an id of this page.
    pub(super) fn find(&self, id: &str) -> Option<HelpPlace<'_>> {
        let whole = |section| HelpPlace { page: self, section, entry: None };
        let section = || self.sections.iter().find(|section| section.id == id).map(whole);
        let entries =
            || self.sections.iter().flat_map(|section| section.entries.iter().map(move |entry| (section, entry)));
        let place = |(section, entry)| HelpPlace { page: self, section, entry: Some(entry) };
        let named = || entries().find(|(_, entry)| entry.has_id(id)).map(place);
        let number = || id.strip_prefix("var.")?.parse::<u32>().ok();
        let within =
            |entry: &HelpEntry, number| entry.numbers.is_some_and(|(first, last)| (first..=last).contains(&number));
        let ranged = || {
            let number = number()?;
            entries().find(|(_, entry)| within(entry, number)).map(place)
        };
        section().or_else(named).or_else(ranged)
    }
}
