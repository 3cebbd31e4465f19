//! Laws: every link of the documentation leads to a file, and to a heading where it names one; so does a page that a comment names.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use super::hold;
use super::source::Source;

/// The checked pages: all of `docs/`, and the pages beside the sources.
fn pages() -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut pages: Vec<PathBuf> = ["README.md", "CONTRIBUTING.md", "CHANGELOG.md", "src/README.md", "tests/README.md"]
        .map(|name| root.join(name))
        .into();
    for folder in ["docs", "docs/reference"] {
        let entries = std::fs::read_dir(root.join(folder)).unwrap().map(|entry| entry.unwrap().path());
        pages.extend(entries.filter(|path| path.extension().is_some_and(|kind| kind == "md")));
    }
    pages.sort();
    pages
}

/// The anchor that a heading gets, as GitHub makes it: small letters, `-` for blanks, no punctuation.
fn anchor(heading: &str) -> String {
    let kept = heading.trim().chars().filter(|c| c.is_alphanumeric() || matches!(c, ' ' | '-' | '_'));
    kept.flat_map(char::to_lowercase).map(|c| if c == ' ' { '-' } else { c }).collect()
}

#[test]
fn every_link_of_the_documentation_leads_somewhere() {
    let mut broken = Vec::new();
    for page in pages() {
        let text = std::fs::read_to_string(&page).unwrap_or_else(|error| panic!("{}: {error}", page.display()));
        for (number, line) in text.lines().enumerate() {
            for (at, _) in line.match_indices("](") {
                let Some((target, _)) = line[at + 2..].split_once(')') else { continue };
                if target.contains("://") || target.contains(' ') {
                    continue;
                }
                let (file, heading) = target.split_once('#').unwrap_or((target, ""));
                let path = if file.is_empty() { page.clone() } else { page.parent().unwrap().join(file) };
                let lost = match std::fs::read_to_string(&path) {
                    Ok(text) if !heading.is_empty() => {
                        let mut headings = text.lines().filter(|line| line.starts_with('#'));
                        !headings.any(|line| anchor(line.trim_start_matches('#')) == heading)
                    }
                    Ok(_) => false,
                    Err(_) => !path.is_dir(),
                };
                if lost {
                    broken.push(format!("{}:{}: {target}", page.display(), number + 1));
                }
            }
        }
    }
    hold("A link leads to what is there.", "mend the link, or write the page that it promises", broken);
}

/// The pages that comments name by their file, with the numbers of their headings: `3.4` of `### 3.4 Limits`.
fn numbered() -> BTreeMap<String, BTreeSet<String>> {
    let heading = |line: &str| {
        let number =
            line.strip_prefix('#')?.trim_start_matches('#').trim_start().split(' ').next()?.trim_end_matches('.');
        number.starts_with(|c: char| c.is_ascii_digit()).then(|| number.to_owned())
    };
    let page = |path: PathBuf| {
        let text = std::fs::read_to_string(&path).unwrap();
        (path.file_name().unwrap().to_string_lossy().into_owned(), text.lines().filter_map(heading).collect())
    };
    pages().into_iter().map(page).collect()
}

/// Pages named in a line of comment by their file, each with the sections named after it: `section 3.4`, `sections 3.4 and 4`.
fn named_pages(comment: &str) -> Vec<(&str, Vec<&str>)> {
    let is_name = |c: char| c.is_ascii_alphanumeric() || c == '-' || c == '_';
    let mut found = Vec::new();
    for (at, _) in comment.match_indices(".md") {
        let (before, behind) = (&comment[..at], &comment[at + 3..]);
        let begin = before.rfind(|c| !is_name(c)).map_or(0, |last| last + 1);
        let behind = behind.trim_start_matches(['`', ',', ' ']);
        let rest = behind.strip_prefix("sections ").or_else(|| behind.strip_prefix("section ")).unwrap_or_default();
        let is_number = |word: &&str| word.starts_with(|c: char| c.is_ascii_digit());
        let mut words = rest.split(' ').peekable();
        let mut numbers = Vec::from_iter(words.next_if(is_number));
        while !numbers.is_empty()
            && words.next_if_eq(&"and").is_some()
            && let Some(number) = words.next_if(is_number)
        {
            numbers.push(number);
        }
        if begin < at {
            let bare = numbers.into_iter().map(|number| number.trim_end_matches(['.', ',', ':', ';', ')']));
            found.push((&comment[begin..at + 3], bare.collect()));
        }
    }
    found
}

#[test]
fn every_page_and_section_that_a_comment_names_is_there() {
    assert_eq!(
        named_pages("`reference/a-b.md` sections 3.4 and 4, c.md section 1.3: 80 mm; d.md"),
        [("a-b.md", vec!["3.4", "4"]), ("c.md", vec!["1.3"]), ("d.md", vec![])]
    );
    let pages = numbered();
    let mut broken = Vec::new();
    for source in Source::all() {
        for (line, text) in (1..).zip(source.text.lines()) {
            let Some((_, comment)) = text.split_once("//") else { continue };
            // The report of an export.
            for (page, sections) in named_pages(comment).into_iter().filter(|(page, _)| *page != "report.md") {
                match pages.get(page) {
                    None => broken.push(format!("{}: there is no page {page}", source.place(line))),
                    Some(headings) => {
                        let lost = sections.into_iter().filter(|section| !headings.contains(*section));
                        broken.extend(lost.map(|n| format!("{}: {page} has no section {n}", source.place(line))));
                    }
                }
            }
        }
    }
    let mend = "name the page of docs/ or docs/reference/ and the number of the heading that has the fact";
    hold("A source in a comment leads to what is there.", mend, broken);
}
