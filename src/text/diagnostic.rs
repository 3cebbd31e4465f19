//! What is wrong, where, which alarm the control would show, and how to mend it.

use std::borrow::Cow;

use serde::Serialize;

use super::{Message, Place};

/// How bad it is. Only an error keeps a program from being exported.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Severity {
    /// The control would refuse or misread this text, or a field is invalid.
    Error,
    /// It runs, but a senior programmer would not write it.
    Warning,
    /// Worth knowing.
    Info,
}

/// A change of text that mends a diagnostic.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Fix {
    /// What the change does, for its button.
    pub title: Message,
    /// What is replaced by what; the places do not overlap.
    pub edits: Vec<(Place, String)>,
}

/// One finding.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Diagnostic {
    /// How bad it is.
    pub severity: Severity,
    /// What is wrong.
    pub message: Message,
    /// Where; `None` for the project as a whole.
    pub place: Option<Place>,
    /// The number that this control would show, for instance `P283`.
    pub alarm: Option<Cow<'static, str>>,
    /// What the control says beside it, in its own words.
    pub wording: Option<&'static str>,
    /// The form field that it is about, by id.
    pub field: Option<&'static str>,
    /// How to mend it, in words.
    pub hints: Vec<Message>,
    /// How to mend it, by itself.
    pub fixes: Vec<Fix>,
}

impl Diagnostic {
    fn new(severity: Severity, message: Message) -> Diagnostic {
        Diagnostic {
            severity,
            message,
            place: None,
            alarm: None,
            wording: None,
            field: None,
            hints: Vec::new(),
            fixes: Vec::new(),
        }
    }

    /// An error without a place yet.
    pub fn error(message: Message) -> Diagnostic {
        Diagnostic::new(Severity::Error, message)
    }

    /// A warning without a place yet.
    pub fn warning(message: Message) -> Diagnostic {
        Diagnostic::new(Severity::Warning, message)
    }

    /// A remark without a place yet.
    pub fn info(message: Message) -> Diagnostic {
        Diagnostic::new(Severity::Info, message)
    }

    /// Sorts by file and start; findings without a place come first, findings at one place keep their order.
    pub fn in_order(found: &mut [Diagnostic]) {
        found.sort_by_key(|d| d.place.map(|place| (place.file, place.span.start)));
    }

    /// The same at a place.
    pub fn at(mut self, place: Place) -> Diagnostic {
        self.place = Some(place);
        self
    }

    /// The same about a form field.
    pub fn about(mut self, field: &'static str) -> Diagnostic {
        self.field = Some(field);
        self
    }

    /// The same with the control's alarm: its number and its wording.
    pub fn alarm(mut self, alarm: Option<(&'static str, &'static str)>) -> Diagnostic {
        self.alarm = alarm.map(|(number, _)| Cow::Borrowed(number));
        self.wording = alarm.map(|(_, wording)| wording).filter(|wording| !wording.is_empty());
        self
    }

    /// The same with a hint.
    pub fn hint(mut self, hint: Message) -> Diagnostic {
        self.hints.push(hint);
        self
    }

    /// The same with a fix.
    pub fn fix(mut self, title: Message, edits: Vec<(Place, String)>) -> Diagnostic {
        self.fixes.push(Fix { title, edits });
        self
    }
}
