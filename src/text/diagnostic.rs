//! Diagnostics: message, place, the control's alarm, hints and fixes.

use std::borrow::Cow;

use serde::Serialize;

use super::with_all::with_all;
use super::{Message, Phrase, Place};

with_all! {
/// Severity. Only an error prevents the export of a program.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Severity {
    /// The control would refuse or misread this text, or a field is invalid.
    Error,
    /// The text runs, but an experienced programmer would not write it.
    Warning,
    /// Worth knowing.
    Info,
}
}

/// A change of text that corrects a diagnostic.
#[derive(Debug, Clone, PartialEq)]
pub struct Fix {
    /// Label of its button.
    pub title: Message,
    /// Places and their new texts; the places do not overlap.
    pub edits: Vec<(Place, String)>,
}

with_all! {
/// Kinds of diagnostics tested by code; sentences are only for people.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum DiagnosticKind {
    /// No code tests for it.
    #[default]
    Plain,
    /// A file begins with a byte order mark; independent of errors in its lines.
    ByteOrderMark,
    /// Several signs in a row in a formula.
    TwoSigns,
    /// A warning about a program that parses.
    Lint,
    /// A comment without its end hides the rest of the line.
    OpenComment,
    /// An incomplete block.
    EndsEarly,
    /// The contour of a cycle is skipped.
    Contour,
    /// A DO or END without its partner, or too deep.
    UnpairedLoop,
    /// The control refuses a block when it comes to it, although the block alone is right.
    RefusedBlock,
    /// A WHILE without its DO, which belongs at the end of its place.
    WhileWithoutDo,
    /// The fix is a guess, applied only on request.
    GuessedFix,
    /// An auxiliary function is put out in each pass of a loop.
    AuxiliaryInLoop,
    /// A spindle code is put out in each pass of a loop.
    SpindleInLoop,
    /// Blocks shorter in time than the control's block time, from the program text.
    ShortBlocks,
    /// The machine waited for the control to read blocks, during a run.
    Starved,
    /// An alarm raised by the program itself; the message value `text` is the program's text, if any.
    ProgramAlarm,
    /// Form facts that are only assumed; the message values `count` and `fields` are their number and their names.
    AssumedFacts,
}
}

impl DiagnosticKind {
    /// Whether the diagnostic is a warning about a program that parses; the help explains each such kind.
    pub fn is_lint(self) -> bool {
        use DiagnosticKind::{AuxiliaryInLoop, Lint, ShortBlocks, SpindleInLoop};
        matches!(self, Lint | AuxiliaryInLoop | SpindleInLoop | ShortBlocks)
    }
}

/// One finding.
#[derive(Debug, Clone, PartialEq)]
pub struct Diagnostic {
    /// Severity.
    pub severity: Severity,
    /// Kind, for diagnostics tested by code.
    pub kind: DiagnosticKind,
    /// Message.
    pub message: Message,
    /// Place; `None` for the project as a whole.
    pub place: Option<Place>,
    /// Alarm number on this control, for instance `P283`.
    pub alarm: Option<Cow<'static, str>>,
    /// The control's wording of the alarm.
    pub wording: Option<Phrase>,
    /// Id of the form field concerned.
    pub field: Option<&'static str>,
    /// Entry of that field, in its metric unit, with which the fault is gone.
    pub entry: Option<f64>,
    /// Advice in words.
    pub hints: Vec<Message>,
    /// Changes of text that correct it.
    pub fixes: Vec<Fix>,
}

impl Diagnostic {
    fn new(severity: Severity, message: Message) -> Diagnostic {
        Diagnostic {
            severity,
            kind: DiagnosticKind::Plain,
            message,
            place: None,
            alarm: None,
            wording: None,
            field: None,
            entry: None,
            hints: Vec::new(),
            fixes: Vec::new(),
        }
    }

    /// An error without a place.
    pub fn error(message: Message) -> Diagnostic {
        Diagnostic::new(Severity::Error, message)
    }

    /// Whether it is an error, which prevents the export of a program.
    pub fn is_error(&self) -> bool {
        self.severity == Severity::Error
    }

    /// A warning without a place.
    pub fn warning(message: Message) -> Diagnostic {
        Diagnostic::new(Severity::Warning, message)
    }

    /// A remark without a place.
    pub fn info(message: Message) -> Diagnostic {
        Diagnostic::new(Severity::Info, message)
    }

    /// Sorts by file and start; findings without a place come first, findings at one place keep their order.
    pub fn in_order(found: &mut [Diagnostic]) {
        found.sort_by_key(|d| d.place.map(|place| (place.file, place.span.start)));
    }

    /// Stable id of the message: silences warnings, names their help, and appears in JSON. Code tests the [kind](DiagnosticKind).
    pub fn message_id(&self) -> &'static str {
        self.message.id
    }

    /// Whether both show the same alarm of one control, or none.
    pub fn shows_alarm_of(&self, other: &Diagnostic) -> bool {
        self.alarm == other.alarm
    }

    /// Sets the kind.
    pub fn kind(mut self, kind: DiagnosticKind) -> Diagnostic {
        self.kind = kind;
        self
    }

    /// Sets the place.
    pub fn at(mut self, place: Place) -> Diagnostic {
        self.place = Some(place);
        self
    }

    /// Sets the form field.
    pub fn about(mut self, field: &'static str) -> Diagnostic {
        self.field = Some(field);
        self
    }

    /// Sets the control's alarm: its number and its wording.
    pub fn alarm(mut self, alarm: Option<(&'static str, Phrase)>) -> Diagnostic {
        self.alarm = alarm.map(|(number, _)| Cow::Borrowed(number));
        self.wording = alarm.map(|(_, wording)| wording).filter(|wording| !wording.is_empty());
        self
    }

    /// Adds the entry of its field with which the fault is gone.
    pub fn mended_by(self, entry: f64) -> Diagnostic {
        Diagnostic { entry: Some(entry), ..self }
    }

    /// Adds a hint.
    pub fn hint(mut self, hint: Message) -> Diagnostic {
        self.hints.push(hint);
        self
    }

    /// The fix of an error that is certain to be the intention: the only one, and no guess.
    pub fn certain_fix(&self) -> Option<&Fix> {
        match &self.fixes[..] {
            [fix] if self.is_error() && self.kind != DiagnosticKind::GuessedFix => Some(fix),
            _ => None,
        }
    }

    /// Adds a fix.
    pub fn fix(mut self, title: Message, edits: Vec<(Place, String)>) -> Diagnostic {
        self.fixes.push(Fix { title, edits });
        self
    }
}
