//! Errors raised while a block executes, before they are located and turned into a [`Diagnostic`].

use crate::controls::Address;
use crate::controls::Alarm;
use crate::nc::{Block, Deck, ExprId, Parsed};
use crate::text::{Diagnostic, DiagnosticKind, Message, Place, Span};

/// An alarm before it is located.
#[derive(Debug)]
pub(super) struct RaisedAlarm {
    alarm: Alarm,
    /// The reader's finding about the block; replaces the other fields.
    reported: Option<Diagnostic>,
    message: Message,
    hints: Vec<Message>,
    word: Option<Span>,
    /// Part of a formula without a value.
    part: Option<ExprId>,
    /// Letters of the word concerned.
    letters: &'static [Address],
    /// Number shown in place of the alarm's own.
    number: Option<u32>,
}

/// Reasons that end a block early.
#[derive(Debug)]
pub(super) enum Trap {
    /// The machine has to come to rest first.
    Sync,
    /// An alarm.
    Alarm(Box<RaisedAlarm>),
}

/// Result of a part of a block.
pub(super) type BlockResult<T> = Result<T, Trap>;

impl Trap {
    /// An alarm with its message.
    #[cold]
    pub(super) fn alarm(alarm: Alarm, message: Message) -> Trap {
        Trap::Alarm(Box::new(RaisedAlarm {
            alarm,
            reported: None,
            message,
            hints: Vec::new(),
            word: None,
            part: None,
            letters: &[],
            number: None,
        }))
    }

    /// Replaces the alarm by the reader's finding, if any.
    #[cold]
    pub(super) fn reported_as(mut self, finding: Option<&Diagnostic>) -> Trap {
        if let Trap::Alarm(fault) = &mut self {
            fault.reported = finding.cloned();
        }
        self
    }

    /// Adds a hint.
    #[cold]
    pub(super) fn hint(mut self, hint: Message) -> Trap {
        if let Trap::Alarm(fault) = &mut self {
            fault.hints.push(hint);
        }
        self
    }

    /// Sets the number shown in place of the alarm's own.
    #[cold]
    pub(super) fn numbered(mut self, number: Option<u32>) -> Trap {
        if let Trap::Alarm(fault) = &mut self {
            fault.number = number;
        }
        self
    }

    /// Locates the alarm at a part of a formula, unless a smaller part is known.
    #[cold]
    pub(super) fn part(mut self, part: ExprId) -> Trap {
        if let Trap::Alarm(fault) = &mut self {
            fault.part.get_or_insert(part);
        }
        self
    }

    /// Locates the alarm at the block's first word with one of these letters, unless a narrower place is known.
    #[cold]
    pub(super) fn at_word(mut self, letters: &'static [Address]) -> Trap {
        if let Trap::Alarm(fault) = &mut self
            && fault.letters.is_empty()
        {
            fault.letters = letters;
        }
        self
    }

    /// Locates the alarm at a word, unless a narrower place is known.
    #[cold]
    pub(super) fn within(mut self, word: Span) -> Trap {
        if let Trap::Alarm(fault) = &mut self {
            fault.word.get_or_insert(word);
        }
        self
    }
}

impl RaisedAlarm {
    /// Kind of the alarm.
    pub(super) fn kind(&self) -> Alarm {
        self.alarm
    }

    /// Finds the word of the alarm in its block.
    pub(super) fn locate(&mut self, deck: &Deck, block: &Block) {
        let word = deck.words_of(block).iter().find(|word| self.letters.contains(&word.letter));
        self.word = self.word.or(word.map(|word| word.span(block)));
    }

    /// The diagnostic in the control's numbers; located at `block` if neither part nor word is known.
    pub(super) fn diagnostic(self, parsed: &Parsed, block: Place) -> Diagnostic {
        if let Some(finding) = self.reported {
            return finding;
        }
        let part = self.part.and_then(|part| parsed.expr_span(block, part));
        let place = Place { file: block.file, span: part.or(self.word).unwrap_or(block.span) };
        let (kind, shown) = (self.kind(), parsed.control().alarm_shown(self.alarm));
        let mut diagnostic = Diagnostic::error(self.message).at(place).alarm(shown);
        if kind == Alarm::User {
            diagnostic.kind = DiagnosticKind::ProgramAlarm;
        }
        if let Some(number) = self.number {
            // The program supplies the wording.
            let shown = parsed.control().macros.user_alarm_shown(number);
            (diagnostic.alarm, diagnostic.wording) = (Some(shown.into()), None);
        }
        diagnostic.hints = self.hints;
        diagnostic
    }
}
