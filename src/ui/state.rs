//! States of the page that the model holds: tab, view of the program, saving, notices, check of a large text.

use std::rc::Rc;

use super::worker::client::Running;
use super::worker::messages::Report;

/// A tab.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Tab {
    /// The program files.
    Program,
    /// Every result.
    Results,
    /// What is dragged to look for a shape.
    Explore,
    /// The control's variables.
    Variables,
    /// Parameters of the control.
    Parameters,
    /// Interface and ladder.
    Plc,
}

/// A view of the program file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Shown {
    /// Its lines.
    Listing,
    /// The editor.
    Editor,
    /// The lines beside those that the form writes.
    Difference,
}

/// Whether the browser's store has the project.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kept {
    /// The store has it.
    Yes,
    /// It is about to be stored.
    Soon,
    /// The browser has no room or no store.
    No,
}

/// Something to tell the user until it is dismissed.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Notice {
    /// Class: `info`, `warn`, `fail`.
    pub tone: &'static str,
    /// The sentence.
    pub text: String,
    /// A file that goes with it: name and content.
    pub file: Option<(&'static str, String)>,
}

/// A check of a text that is too large for the page.
#[derive(Clone)]
pub(super) struct Check {
    /// Name of the text.
    pub name: String,
    /// Bytes read, and bytes in all. All are read when the check itself runs.
    pub progress: (f64, f64),
    /// The findings, at the end of the check.
    pub report: Option<Report>,
    /// The worker that checks; it ends with this.
    pub worker: Rc<Running>,
}
