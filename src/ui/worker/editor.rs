//! Answers for the editor: completion proposals, and the places of a symbol.

use super::messages::{Caret, NamedPlace, Places, Proposals};
use crate::nc::symbols::{Occurrence, OutlineItem, Role, Symbol, Symbols};
use crate::project::Project;
use crate::project::completion::{self, ProposalKind};
use crate::project::meaning::Words;
use crate::project::program::Written;
use crate::text::{FileId, LineIndex, Place, utf16};
use crate::ui::words::{sentence, t};

/// Rows of a list at most.
const ROWS: usize = 500;

/// The place as file and byte.
fn at(written: &Written, caret: Caret) -> (FileId, u32) {
    let file = FileId(caret.file);
    let text = written.files.get(file).map_or("", |file| file.text.as_str());
    (file, utf16::byte(text, caret.units))
}

/// Completion proposals at a place.
pub(crate) fn complete(project: &Project, caret: Caret) -> Proposals {
    let written = project.written();
    let (file, byte) = at(&written, caret);
    let found = completion::at(&Words::of(project), &written.parsed, file, byte);
    let text = written.files.get(file).map_or("", |file| file.text.as_str());
    let few = |kind| matches!(kind, ProposalKind::Program | ProposalKind::Block);
    Proposals {
        from: utf16::units(text, found.replaces.start),
        few: found.proposals.first().is_some_and(|first| few(first.kind)),
        rows: found.proposals.into_iter().map(|proposal| (proposal.text.clone(), proposal.line())).collect(),
    }
}

/// Texts and lines of the files, each read once.
struct Lines<'a> {
    written: &'a Written,
    files: Vec<LineIndex>,
}

impl Lines<'_> {
    fn of(written: &Written) -> Lines<'_> {
        Lines { written, files: written.files.0.iter().map(|file| LineIndex::new(&file.text)).collect() }
    }

    /// File and line of a place in words, and the text of the line.
    fn words(&self, place: Place) -> Option<(String, String)> {
        let (file, lines) = (self.written.files.get(place.file)?, self.files.get(usize::from(place.file.0))?);
        let line = lines.line_of(place.span.start);
        let name = sentence(&crate::msg!("page.at-line", file = file.name.as_str(), line));
        Some((name, lines.line(&file.text, line).trim().to_owned()))
    }

    /// A row of a list of uses, with the role of the symbol there.
    fn row(&self, found: &Occurrence) -> Option<NamedPlace> {
        let (name, text) = self.words(found.place)?;
        let role = t(match found.role {
            Role::Definition => "page.role-definition",
            Role::Write | Role::Argument => "page.role-write",
            Role::Read => "page.role-read",
            Role::Jump => "page.role-jump",
            Role::Call => "page.role-call",
        });
        Some(NamedPlace { name: format!("{name} · {role}"), text, below: false, place: found.place.into() })
    }
}

/// Definition of the symbol at a place: one place, or none.
pub(crate) fn definition(project: &Project, caret: Caret) -> Places {
    let written = project.written();
    let (file, byte) = at(&written, caret);
    let symbols = Symbols::new(&written.parsed);
    let place = symbols.at(file, byte).and_then(|found| symbols.definition(found.symbol));
    let row = |place: Place| {
        let (name, text) = Lines::of(&written).words(place)?;
        Some(NamedPlace { name, text, below: false, place: place.into() })
    };
    let rows: Vec<NamedPlace> = place.and_then(row).into_iter().collect();
    Places { count: rows.len() as u32, rows }
}

/// All places of the name at a place.
pub(crate) fn uses(project: &Project, caret: Caret) -> Places {
    let written = project.written();
    let (file, byte) = at(&written, caret);
    let symbols = Symbols::new(&written.parsed);
    let Some(found) = symbols.at(file, byte) else { return Places::default() };
    let lines = Lines::of(&written);
    let all = || symbols.of(found.symbol);
    Places { count: all().count() as u32, rows: all().take(ROWS).filter_map(|found| lines.row(found)).collect() }
}

/// Programs of all files; below each of them its labels, calls, targets of jumps and variables.
pub(crate) fn outline(project: &Project) -> Places {
    let written = project.written();
    let (symbols, words) = (Symbols::new(&written.parsed), Words::of(project));
    let files = (0..).map(FileId).take(written.files.0.len());
    let programs: Vec<(FileId, OutlineItem)> = files
        .flat_map(|file| symbols.outline(&written.parsed, file).into_iter().map(move |program| (file, program)))
        .collect();
    let all = || {
        programs.iter().flat_map(|(file, program)| {
            std::iter::once((*file, program)).chain(program.children.iter().map(|child| (*file, child)))
        })
    };
    let row = |(file, item): (FileId, &OutlineItem)| NamedPlace {
        name: item.name.clone(),
        text: words.line(item),
        below: !matches!(item.symbol, Symbol::Program(_)),
        place: Place { file, span: item.span }.into(),
    };
    Places { count: all().count() as u32, rows: all().take(ROWS).map(row).collect() }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::nc::{File, Files};

    fn of(files: Files) -> Project {
        let mut project = crate::ui::testing::project();
        project.edited = Some(files);
        project
    }

    /// A project of two programs.
    fn edited() -> Project {
        let file = |name: &str, text: &str| File { name: name.to_owned(), text: text.to_owned() };
        let files =
            vec![file("O1.nc", "O1 (äöü)\nN10 #100=1\nM98 P2\nGOTO 10\nM30\n"), file("O2.nc", "O2\n#101=#100\nM99\n")];
        of(Files(files))
    }

    /// The place directly after a text in a file.
    fn behind(project: &Project, file: u16, text: &str) -> Caret {
        let all = &project.edited.as_ref().unwrap().0[usize::from(file)].text;
        Caret { file, units: utf16::units(all, (all.find(text).unwrap() + text.len()) as u32) }
    }

    #[wasm_bindgen_test]
    fn proposals_begin_where_the_word_does_in_units_of_javascript() {
        let project = edited();
        let found = complete(&project, behind(&project, 0, "N10 #10"));
        assert_eq!(found.from, utf16::units("O1 (äöü)\nN10 ", 16));
        let texts: Vec<&str> = found.rows.iter().map(|row| row.0.as_str()).collect();
        assert!(texts.contains(&"#100") && texts.contains(&"#101"), "{texts:?}");
        assert!(!found.few);
        let called = complete(&project, behind(&project, 0, "M98 P"));
        assert!(called.few && called.rows.iter().any(|row| row.0 == "2"), "{called:?}");
    }

    #[wasm_bindgen_test]
    fn definition_of_a_called_program_is_in_its_file() {
        let project = edited();
        let found = definition(&project, behind(&project, 0, "M98 P2"));
        assert_eq!(found.rows.iter().map(|row| Place::from(row.place).file.0).collect::<Vec<_>>(), [1]);
        assert_eq!(definition(&project, behind(&project, 0, "M30")), Places::default());
    }

    #[wasm_bindgen_test]
    fn uses_tell_line_and_role_across_files() {
        let project = edited();
        let found = uses(&project, behind(&project, 1, "#101=#100"));
        let names: Vec<&str> = found.rows.iter().map(|row| row.name.as_str()).collect();
        assert_eq!(names.len(), 2);
        assert!(names[0].contains("O1.nc") && names[0].ends_with(t("page.role-write")), "{names:?}");
        assert!(names[1].contains("O2.nc") && names[1].ends_with(t("page.role-read")), "{names:?}");
        assert_eq!(found.rows[1].text, "#101=#100");
    }

    #[wasm_bindgen_test]
    fn long_lists_are_cut_and_counted() {
        let text = format!("O1\n#100=1\n{}M30\n", "#101=#100\n".repeat(ROWS));
        let files = Files::one("O1.nc", text);
        let project = of(files);
        let found = uses(&project, behind(&project, 0, "#100"));
        assert_eq!((found.rows.len(), found.count as usize), (ROWS, ROWS + 1));
    }

    #[wasm_bindgen_test]
    fn outline_has_programs_blocks_and_variables_of_all_files() {
        let found = outline(&edited());
        let names: Vec<&str> = found.rows.iter().map(|row| row.name.as_str()).collect();
        for name in ["O1", "N10", "#100", "O2", "#101"] {
            assert!(names.contains(&name), "{name}: {names:?}");
        }
        assert_eq!(found.count as usize, names.len());
        let programs: Vec<&str> = found.rows.iter().filter(|row| !row.below).map(|row| row.name.as_str()).collect();
        assert_eq!(programs, ["O1", "O2"]);
    }
}
