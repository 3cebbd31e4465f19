//! Law: every source text that a row cites has its line in `docs/reference/sources.md`, and every such line is cited.

use std::collections::{BTreeMap, BTreeSet};

use super::hold;
use super::source::{Source, TokenKind};

const SOURCES: &str = "docs/reference/sources.md";

/// The grades of evidence, as rows name them after a source text.
const GRADES: [&str; 5] = ["Manual", "Sister", "Measured", "Inferred", "Open"];

const CALL: [&str; 5] = ["Citation", ":", ":", "new", "("];

/// The source texts that have a line.
pub(super) fn listed() -> BTreeSet<String> {
    let page = std::fs::read_to_string(format!("{}/{SOURCES}", env!("CARGO_MANIFEST_DIR"))).unwrap();
    let cell = |line: &str| Some(line.strip_prefix("| `")?.split_once("` | ")?.0.to_owned());
    let texts: Vec<String> = page.lines().filter_map(cell).collect();
    let set: BTreeSet<String> = texts.iter().cloned().collect();
    assert_eq!(texts.len(), set.len(), "{SOURCES}: no source text has two lines");
    set
}

/// Every literal in front of a grade, `"…", Grade::Open` or `"…", Open`: the text and its line.
fn cited(source: &Source) -> Vec<(usize, &str)> {
    let tokens = source.shipped();
    let mut found = Vec::new();
    for (at, token) in tokens.iter().enumerate().filter(|(_, token)| token.kind == TokenKind::Text) {
        let behind: Vec<&str> = tokens[at + 1..].iter().take(5).map(|token| token.text.as_str()).collect();
        let grade = match behind[..] {
            [",", "Grade", ":", ":", grade] | [",", grade, ..] => grade,
            _ => continue,
        };
        if GRADES.contains(&grade) {
            found.push((token.line, token.text.as_str()));
        }
    }
    found
}

#[test]
fn every_cited_source_has_its_line_in_the_reference() {
    let listed = listed();
    let mut used = BTreeSet::new();
    let mut broken = Vec::new();
    for source in Source::all().iter().filter(|source| source.path.starts_with("src/")) {
        for (line, text) in cited(source) {
            if !listed.contains(text) {
                broken.push(format!("{}: `{text}` leads nowhere", source.place(line)));
            }
            used.insert(text.to_owned());
        }
        // A text that is not a literal here, which this law cannot follow.
        for call in source.shipped().windows(CALL.len() + 1) {
            let is_call = call.iter().zip(CALL).all(|(token, wanted)| token.text == wanted);
            let argument = &call[CALL.len()];
            if is_call && argument.kind != TokenKind::Text && argument.text != "$" {
                broken.push(format!("{}: the source of a citation is a literal", source.place(argument.line)));
            }
        }
    }
    broken.extend(listed.difference(&used).map(|text| format!("{SOURCES}: no row cites `{text}`")));
    let mend = "one line in docs/reference/sources.md per source text, word for word, with the section of the sheet that has its facts";
    hold("A citation leads to a line that a reader has.", mend, broken);
}

#[test]
fn results_of_every_machine_cite_listed_sources() {
    let listed = listed();
    let mut broken = BTreeMap::new();
    for machine in macroline::machines::ALL {
        for control in machine.controls() {
            let project = macroline::project::Project::of(machine.id(), Some(control)).unwrap();
            for readout in project.design().readouts {
                if !listed.contains(readout.cite.source.english) {
                    let row = format!("{} {}: `{}`", machine.id(), readout.id, readout.cite.source);
                    broken.insert(row, ());
                }
            }
        }
    }
    let mend = "pass the whole text as one literal, and give it its line in docs/reference/sources.md";
    hold("A result cites a source that is listed.", mend, broken.into_keys().collect());
}
