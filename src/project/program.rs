//! The program of a project: written by the machine or edited by the user, and read again as the control reads it.

use std::rc::Rc;

use super::Project;
use crate::controls::options::CommentCharacters;
use crate::machines::program::comments;
use crate::nc::{self, Files, Parsed};
use crate::text::Diagnostic;
use crate::text::catalog::Language;

/// The program files of a project, and the programs parsed from them.
#[derive(Debug, Clone)]
pub struct Written {
    /// The text of the export.
    pub files: Files,
    /// The emitted text, parsed again; every run uses it.
    pub parsed: Rc<Parsed>,
    /// Findings of emitting and parsing it.
    pub diagnostics: Vec<Diagnostic>,
    /// Whether the text is the user's own and no longer follows the form.
    pub edited: bool,
    /// Number of the program that sets the project's values, if the text has one.
    pub setup: Option<u32>,
    /// Number of the program that runs the machine.
    pub main: u32,
}

impl Project {
    /// Characters that comments can have on the control, with its settings.
    pub fn characters(&self) -> CommentCharacters {
        self.control_context().dialect().comment_characters()
    }

    /// The language of the comments that are written: Chinese where that is chosen and the control can show it.
    fn comment_language(&self) -> Language {
        if self.characters() == CommentCharacters::Ascii { Language::English } else { self.comments }
    }

    /// The program: the machine's own, or the edited text.
    pub fn written(&self) -> Written {
        let mut own = self.prepared().program();
        if self.comment_language() == Language::Chinese {
            comments::put_in_chinese(&mut own.deck, self.control);
        }
        let (files, mut diagnostics) = match &self.edited {
            Some(files) => (files.clone(), Vec::new()),
            None => {
                let emitted = nc::emit_with(&own.deck, self.control, own.newline, self.characters());
                (emitted.files, emitted.diagnostics)
            }
        };
        let parsed = Rc::new(nc::parse_with(&files, self.control, &self.switches));
        diagnostics.extend(parsed.diagnostics().iter().cloned());
        let has = |number: u32| parsed.deck().program(number).is_some();
        // Edited text may hold other programs: then the first one runs, and nothing is set up.
        let first = parsed.deck().programs.first().map_or(0, |program| program.number);
        let (setup, main) =
            if has(own.main) { (own.setup.filter(|setup| has(*setup)), own.main) } else { (None, first) };
        Written { files, parsed, diagnostics, edited: self.edited.is_some(), setup, main }
    }
}
