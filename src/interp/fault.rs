//! Why a block did not come to its end, on the way to becoming a diagnostic.

use crate::controls::{Alarm, Control};
use crate::text::{Diagnostic, Message, Place, Span};

/// An alarm in the making.
#[derive(Debug)]
pub(super) struct Fault {
    alarm: Alarm,
    message: Message,
    hints: Vec<Message>,
    word: Option<Span>,
    /// The number that is shown instead of that of the kind.
    number: Option<u32>,
}

/// What ends a block early.
#[derive(Debug)]
pub(super) enum Trap {
    /// The machine has to come to rest first.
    Sync,
    /// An alarm.
    Alarm(Box<Fault>),
}

/// Result of a part of a block.
pub(super) type Run<T> = Result<T, Trap>;

impl Trap {
    /// An alarm with what is wrong.
    #[cold]
    pub(super) fn alarm(alarm: Alarm, message: Message) -> Trap {
        Trap::Alarm(Box::new(Fault { alarm, message, hints: Vec::new(), word: None, number: None }))
    }

    /// An alarm that the parser has already found.
    #[cold]
    pub(super) fn repeat(alarm: Alarm, finding: &Diagnostic) -> Trap {
        let word = finding.place.map(|place| place.span);
        Trap::Alarm(Box::new(Fault {
            alarm,
            message: finding.message.clone(),
            hints: finding.hints.clone(),
            word,
            number: None,
        }))
    }

    /// The same with a way out.
    #[cold]
    pub(super) fn hint(mut self, hint: Message) -> Trap {
        if let Trap::Alarm(fault) = &mut self {
            fault.hints.push(hint);
        }
        self
    }

    /// The same with a number of its own.
    #[cold]
    pub(super) fn numbered(mut self, number: Option<u32>) -> Trap {
        if let Trap::Alarm(fault) = &mut self {
            fault.number = number;
        }
        self
    }

    /// The same in a word, if no narrower place is known.
    #[cold]
    pub(super) fn within(mut self, word: Span) -> Trap {
        if let Trap::Alarm(fault) = &mut self {
            fault.word.get_or_insert(word);
        }
        self
    }
}

impl Fault {
    /// The diagnostic in the control's numbers; `block` is its place where no word is known.
    pub(super) fn diagnostic(self, control: &Control, block: Place) -> Diagnostic {
        let place = Place { file: block.file, span: self.word.unwrap_or(block.span) };
        let mut diagnostic = Diagnostic::error(self.message).at(place).alarm(control.alarm_number(self.alarm));
        if let Some(number) = self.number {
            diagnostic.alarm = Some(number.to_string().into());
        }
        diagnostic.hints = self.hints;
        diagnostic
    }
}
