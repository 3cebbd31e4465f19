//! Search in help: numbers of alarms, codes, variables, words of both languages; the best hit first.

use core::cmp::Reverse;

use super::content::{HelpEntry, HelpKind, HelpPlace, HelpSection};
use super::{Help, texts};

/// Hits that are listed at most.
pub const MOST: usize = 40;

/// Score from which on a word or title is the query itself.
const EXACT: u32 = 900;

/// Characters of a query that are read.
const QUERY: usize = 100;

/// Length of the prefix by which words with another or a mistyped ending are found.
const BEGIN: usize = 4;

impl Help {
    /// Places that have every word of a query, the best first; none for a query without words.
    pub fn search(&self, query: &str) -> Vec<HelpPlace<'_>> {
        let wanted = words(query);
        if wanted.is_empty() {
            return Vec::new();
        }
        let whole = canonical(&readable(query));
        let mut hits: Vec<(u32, HelpPlace)> = Vec::new();
        for (at, page) in self.pages.iter().enumerate() {
            // The present machine and control before others.
            let near = if at < 3 { 25 } else { 0 };
            for section in &page.sections {
                let mut add = |score: Option<u32>, entry| {
                    hits.extend(score.map(|score| (score + near, HelpPlace { page, section, entry })));
                };
                add(of_section(section, &wanted), None);
                for entry in &section.entries {
                    // A title of several words counts as many.
                    let exact = of_entry(entry, core::slice::from_ref(&whole)).filter(|score| *score >= EXACT);
                    add(of_entry(entry, &wanted).max(exact.map(|score| score * wanted.len() as u32)), Some(entry));
                }
            }
        }
        best(hits)
    }

    /// Where no place has every word: places that have some of them, or their beginnings, those with the most first.
    pub fn nearest(&self, query: &str) -> Vec<HelpPlace<'_>> {
        let mut hits: Vec<(u32, HelpPlace)> = Vec::new();
        for word in words(query) {
            let begin: String = word.chars().take(BEGIN).collect();
            let found =
                [word.as_str(), &begin].into_iter().map(|word| self.search(word)).find(|found| !found.is_empty());
            for (place, score) in found.unwrap_or_default().into_iter().zip((1..=MOST as u32).rev()) {
                match hits.iter_mut().find(|hit| hit.1.id() == place.id()) {
                    Some(hit) => hit.0 += MOST as u32 + score,
                    None => hits.push((score, place)),
                }
            }
        }
        best(hits)
    }
}

impl HelpPlace<'_> {
    /// Text of the place around the first word of a query, of so many characters at most; its first text if it has no such word.
    pub fn excerpt(&self, query: &str, most: usize) -> String {
        let wanted = words(query);
        let own: Vec<String> = match self.entry {
            Some(entry) => {
                entry.text.iter().chain(entry.facts.iter().map(|fact| &fact.value)).map(texts::words).collect()
            }
            None => self.section.text.iter().chain(&self.section.steps).map(texts::words).collect(),
        };
        let place = |text: &String| {
            let lower = text.to_lowercase();
            let at = wanted.iter().filter_map(|word| lower.find(word.as_str())).min()?;
            Some(lower.get(..at)?.chars().count())
        };
        let hit = own.iter().find_map(|text| Some((text, place(text)?)));
        let Some((text, at)) = hit.or_else(|| own.first().map(|text| (text, 0))) else { return String::new() };
        clipped(text, at, most)
    }
}

/// Part of a text with the character at a place, from the beginning of a word; `…` stands for what is left out.
fn clipped(text: &str, at: usize, most: usize) -> String {
    let letters: Vec<char> = text.chars().collect();
    let from = if at + most / 3 > most {
        (at - most / 3..at).find(|at| letters.get(*at - 1) == Some(&' ')).unwrap_or(at)
    } else {
        0
    };
    let part: String = letters.iter().skip(from).take(most).collect();
    let [before, behind] = [from > 0, from + most < letters.len()].map(|is_cut| if is_cut { "…" } else { "" });
    format!("{before}{part}{behind}")
}

fn best(mut hits: Vec<(u32, HelpPlace)>) -> Vec<HelpPlace> {
    hits.sort_by_key(|hit| Reverse(hit.0));
    hits.truncate(MOST);
    hits.into_iter().map(|(_, place)| place).collect()
}

/// The characters of a query that are read.
fn readable(query: &str) -> String {
    query.chars().filter(|c| !c.is_control()).take(QUERY).collect()
}

/// The words of a query.
fn words(query: &str) -> Vec<String> {
    readable(query).split_whitespace().map(canonical).filter(|word| !word.is_empty()).collect()
}

/// Form of a word for comparison: small letters, and no zeros in front of the number of a code or alarm (`G01`, `M03`).
fn canonical(word: &str) -> String {
    let word = word.trim().to_lowercase();
    let digits = word.find(|c: char| c.is_ascii_digit()).unwrap_or(word.len());
    let (letters, number) = word.split_at(digits);
    let short = number.trim_start_matches('0');
    if digits == 1 && letters.chars().all(|c| c.is_ascii_lowercase()) && !short.is_empty() && number.len() <= 3 {
        return format!("{letters}{short}");
    }
    word
}

fn of_section(section: &HelpSection, wanted: &[String]) -> Option<u32> {
    let title = section.title.to_lowercase();
    let text = || section.text.iter().chain(&section.steps).map(texts::words).collect::<String>().to_lowercase();
    let score = |word: &String| match title.find(word.as_str()) {
        Some(0) => Some(320),
        Some(_) => Some(220),
        None => text().contains(word.as_str()).then_some(40),
    };
    wanted.iter().map(score).sum()
}

fn of_entry(entry: &HelpEntry, wanted: &[String]) -> Option<u32> {
    let (word, title) = (canonical(&entry.word), entry.title.to_lowercase());
    let rank = 10 * (HelpKind::Term as u32 - entry.kind as u32);
    let score = |wanted: &String| {
        let number = || wanted.trim_start_matches(['#', 'r']).parse::<u32>().ok();
        let ranged = || entry.numbers.zip(number()).is_some_and(|((first, last), at)| (first..=last).contains(&at));
        let bare = || word.strip_prefix(['#', 'r']).is_some_and(|bare| bare == wanted);
        if word == *wanted {
            return Some(1000 + rank);
        }
        if title == *wanted {
            return Some(EXACT + rank);
        }
        if bare() || ranged() {
            return Some(800 + rank);
        }
        if !word.is_empty() && word.starts_with(wanted.as_str()) {
            return Some(400 + rank);
        }
        match title.find(wanted.as_str()) {
            Some(0) => return Some(300),
            Some(at) if title.get(..at).is_some_and(|before| before.ends_with([' ', '('])) => return Some(250),
            Some(_) => return Some(200),
            None => {}
        }
        let facts = entry.facts.iter().any(|fact| texts::words(&fact.value).to_lowercase().contains(wanted.as_str()));
        let synonym = || entry.synonyms.contains(wanted.as_str()).then_some(150);
        let text = || entry.text.iter().any(|text| texts::words(text).to_lowercase().contains(wanted.as_str()));
        (facts && entry.kind == HelpKind::Term)
            .then_some(280)
            .or_else(synonym)
            .or_else(|| (facts || text()).then_some(50))
    };
    wanted.iter().map(score).sum()
}
