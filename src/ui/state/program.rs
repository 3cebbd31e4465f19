//! The program files of the project, and the findings about them.

use std::rc::Rc;

use leptos::prelude::*;

use crate::project::program::Written;
use crate::text::Diagnostic;

/// The program. A handle: copies share its state.
#[derive(Clone, Copy)]
pub(crate) struct ProgramFiles {
    /// The files, parsed.
    pub written: RwSignal<Rc<Written>, LocalStorage>,
    /// Whether the text is the user's own, detached from the form.
    pub edited: RwSignal<bool>,
    /// Findings of reading, reviewing and running the program, without the silenced ones.
    pub findings: RwSignal<Vec<Diagnostic>, LocalStorage>,
    /// Findings of the worker's review; it knows more than reading alone.
    pub reviewed: RwSignal<Option<Vec<Diagnostic>>, LocalStorage>,
    /// Whether the worker's review is on its way.
    pub pending: RwSignal<bool>,
    /// Count of silenced findings.
    pub silenced: RwSignal<usize>,
    /// Text in the editor that is not in the project yet: the file and its text.
    pub typed: StoredValue<Option<(usize, String)>>,
}

impl ProgramFiles {
    /// A program without a review yet.
    pub(crate) fn new(written: Rc<Written>) -> ProgramFiles {
        ProgramFiles {
            edited: RwSignal::new(written.edited),
            written: RwSignal::new_local(written),
            findings: RwSignal::new_local(Vec::new()),
            reviewed: RwSignal::new_local(None),
            pending: RwSignal::new(false),
            silenced: RwSignal::new(0),
            typed: StoredValue::new(None),
        }
    }

    /// Whether the control would refuse or misread the program, as reading and review know before it runs.
    pub(crate) fn has_errors(self) -> bool {
        let error = |found: &[Diagnostic]| found.iter().any(|found| found.is_error());
        self.reviewed.with(|found| found.as_deref().is_some_and(error)) || self.written.with(|w| error(&w.diagnostics))
    }

    /// The text of a file; empty where there is none.
    pub(crate) fn text(self, file: usize) -> String {
        self.written.with_untracked(|written| written.files.0.get(file).map(|f| f.text.clone()).unwrap_or_default())
    }
}
