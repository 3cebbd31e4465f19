//! What is done with the program of a [`Page`]: fixes, typed text, places.

use leptos::prelude::*;

use super::super::history::EditKey;
use super::super::put::put;
use super::super::view::{ProgramView, Tab};
use super::Page;
use crate::msg;
use crate::nc;
use crate::project::Project;
use crate::project::findings::check::FixChoice;
use crate::text::{LineIndex, Place};
use crate::ui::words::{sentence, t};

impl Page {
    /// Applies a fix of a finding, both by number; the program is then an edited one.
    pub(crate) fn apply_fix(self, finding: usize, fix: usize) {
        let fixed = self.program.findings.with_untracked(|findings| {
            // Marks in the editor may belong to the text before the edit.
            if self.program.pending.get_untracked() {
                return None;
            }
            let fix = findings.get(finding)?.fixes.get(fix)?;
            Some(self.program.written.with_untracked(|written| nc::fix(&written.files, fix)))
        });
        if let Some(files) = fixed {
            self.edit(|project| project.edited = Some(files));
            self.notices.announce(t("page.mended"));
        }
    }

    /// Applies the fixes of a choice in one step.
    pub(crate) fn fix_all(self, choice: FixChoice) {
        if self.program.pending.get_untracked() {
            return;
        }
        let (found, written) = (self.program.findings.get_untracked(), self.program.written.get_untracked());
        let (files, count) = self.project.with_untracked(|project| project.with_fixes(&written.files, &found, choice));
        if count > 0 {
            self.edit(|project| project.edited = Some(files));
            self.notices.confirm(sentence(&msg!("page.mended-all", count = count as u32)));
        }
    }

    /// Moves the last text of the editor into the project, which detaches it from its form.
    pub(crate) fn take_typed(self) {
        let Some((at, text)) = self.program.typed.try_update_value(Option::take).flatten() else { return };
        if text == self.program.text(at) {
            return;
        }
        let files = self.program.written.with_untracked(|written| written.files.clone());
        self.edit_merged(EditKey::Text, |project| {
            let edited = project.edited.get_or_insert(files);
            if let Some(file) = edited.0.get_mut(at) {
                file.text = text;
            }
            // A character that is typed and deleted again is no edit.
            let mut generated = project.clone();
            generated.edited = None;
            if project.edited == Some(generated.written().files.clone()) {
                project.edited = None;
            }
        });
    }

    /// The project with the unsaved text of the editor.
    pub(crate) fn typed_project(self) -> Project {
        let mut project = self.project.get_untracked();
        self.program.typed.with_value(|typed| {
            if let Some((at, text)) = typed {
                let files = || self.program.written.with_untracked(|written| written.files.clone());
                if let Some(file) = project.edited.get_or_insert_with(files).0.get_mut(*at) {
                    file.text.clone_from(text);
                }
            }
        });
        project
    }

    /// Shows a place of the program: in the editor where that is open, else in the listing.
    pub(crate) fn show_place(self, place: Place) {
        // Playback is paused, because a running film would switch back to the file of the running block.
        self.player.playing.set(false);
        if self.view.program.get_untracked() == ProgramView::Difference {
            self.view.program.set(ProgramView::Listing);
        }
        self.view.sought.set(Some(place));
        put(self.view.tab, Tab::Program);
    }

    /// A place of the program in words: its file and line.
    pub(crate) fn place_words(self, place: Place) -> Option<String> {
        self.program.written.with(|written| {
            let file = written.files.get(place.file)?;
            let line = LineIndex::new(&file.text).line_of(place.span.start);
            Some(sentence(&msg!("page.at-line", file = file.name.as_str(), line)))
        })
    }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::testing::mount;

    #[wasm_bindgen_test]
    async fn edited_program_goes_back_to_the_form_when_restored() {
        let bench = mount(|| ()).await;
        let page = bench.page;
        let text = page.program.text(0);
        page.program.typed.set_value(Some((0, format!("{text}(x)\n"))));
        page.take_typed();
        assert!(page.program.edited.get_untracked());
        page.program.typed.set_value(Some((0, text)));
        page.take_typed();
        assert!(!page.program.edited.get_untracked());
    }
}
