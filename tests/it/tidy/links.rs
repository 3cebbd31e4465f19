//! Law: every link of the documentation leads to a file, and to a heading where it names one.

use std::path::{Path, PathBuf};

use super::hold;

/// The pages that are held: all of `docs/`, and the pages beside the sources.
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
