//! Search in help: numbers of alarms, codes, variables, words of both languages; the best hit first.

use core::cmp::Reverse;

use super::content::{HelpEntry, HelpKind, HelpPlace, HelpSection};
use super::{Help, texts};

/// Hits that are listed at most.
pub const MOST: usize = 40;

/// Score from which on a word or title is the query itself.
const EXACT: u32 = 900;

/// Characters of a query that are looked at.
const QUERY: usize = 100;

impl Help {
    /// Places that have every word of a query, the best first; none for a query without words.
    pub fn search(&self, query: &str) -> Vec<HelpPlace<'_>> {
        let query: String = query.chars().filter(|c| !c.is_control()).take(QUERY).collect();
        let whole = canonical(&query);
        let wanted: Vec<String> = query.split_whitespace().map(canonical).filter(|word| !word.is_empty()).collect();
        if wanted.is_empty() {
            return Vec::new();
        }
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
        hits.sort_by_key(|hit| Reverse(hit.0));
        hits.truncate(MOST);
        hits.into_iter().map(|(_, place)| place).collect()
    }
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
        let text = || entry.text.iter().any(|text| texts::words(text).to_lowercase().contains(wanted.as_str()));
        (facts && entry.kind == HelpKind::Term).then_some(280).or_else(|| (facts || text()).then_some(50))
    };
    wanted.iter().map(score).sum()
}
