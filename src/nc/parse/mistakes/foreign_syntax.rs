//! Words, signs and forms of other languages and of printed formulas, each with its replacement on this control.

use crate::msg;
use crate::nc::lex::spelling::prose;
use crate::nc::parse::failure::{LineFix, ParseFailure};
use crate::nc::parse::reader::Reader;
use crate::text::{Diagnostic, Message};

/// Words of other languages, and the catalog id of the hint for them.
const WORDS: [(&[&str], &str); 5] = [
    (&["ELSE", "ELSEIF", "ELIF", "ENDIF"], "nc.hint.else"),
    (
        &["FOR", "NEXT", "REPEAT", "UNTIL", "LOOP", "WEND", "ENDW", "ENDWHILE", "ENDFOR", "BREAK", "CONTINUE"],
        "nc.hint.loop",
    ),
    (&["CALL", "GOSUB", "RETURN"], "nc.hint.call"),
    (&["MOD"], "nc.hint.modulo"),
    (&["POW", "POWER"], "nc.hint.power"),
];

/// π with as many digits as a word allows.
const PI: &str = "3.14159265";

impl Reader<'_> {
    /// The finding that replaces a failure caused by foreign syntax; the alarm stays.
    pub(in crate::nc::parse) fn foreign_syntax(&self, failure: &ParseFailure) -> Option<Diagnostic> {
        if self.names().is_some() {
            return None;
        }
        let word = [failure.from, self.statement_start()].into_iter().find_map(|at| self.foreign_word(failure, at));
        word.or_else(|| self.foreign_form(failure, failure.from))
    }

    /// Start of the statement, after an optional block skip and a sequence number.
    fn statement_start(&self) -> usize {
        let lead = |b: &u8| matches!(b, b'/' | b'N' | b'n' | b'0'..=b'9' | b' ' | b'\t');
        let letters = self.cursor.line.iter().take_while(|b| lead(b)).count();
        // `NEXT` does not begin with a sequence number.
        match self.cursor.line.get(letters) {
            Some(b)
                if b.is_ascii_alphabetic() && letters > 0 && self.cursor.line[letters - 1].is_ascii_alphabetic() =>
            {
                letters - 1
            }
            _ => letters,
        }
    }

    /// Letters from a byte of the line on, as capitals.
    fn letters_at(&self, at: usize) -> String {
        let rest = self.cursor.line.get(at..).unwrap_or_default();
        let letters = rest.iter().take_while(|b| b.is_ascii_alphabetic()).count();
        String::from_utf8_lossy(rest.get(..letters).unwrap_or_default()).to_ascii_uppercase()
    }

    fn foreign_word(&self, failure: &ParseFailure, at: usize) -> Option<Diagnostic> {
        let word = self.letters_at(at);
        let end = at + word.len();
        if prose(self.cursor.line.get(end..).unwrap_or_default().trim_ascii()) {
            // `RETURN TO START` is an unbracketed comment.
            return None;
        }
        if word == "PI" {
            let finding = self.finding(failure.alarm, at, end, msg!("nc.no-pi"));
            return Some(self.with_fix(finding, LineFix::Write(at, end, PI)));
        }
        let &(_, id) = WORDS.iter().find(|row| row.0.contains(&word.as_str()))?;
        if word == "MOD" && self.tables.rules.modulo {
            return None;
        }
        let message = msg!("nc.foreign-word", word, control = self.control.name);
        Some(self.finding(failure.alarm, at, end, message).hint(Message { id, values: Vec::new() }))
    }

    /// Finding for a sign or number in an impossible position.
    fn foreign_form(&self, failure: &ParseFailure, at: usize) -> Option<Diagnostic> {
        let byte = *self.cursor.line.get(at)?;
        let before = self.cursor.line.get(..at).unwrap_or_default().trim_ascii_end();
        let rest = self.cursor.line.get(at..).unwrap_or_default();
        let digits = rest.iter().take_while(|b| b.is_ascii_digit()).count();
        let after = rest.get(digits..).unwrap_or_default().trim_ascii_start();
        if byte == b'^' {
            let finding = self.finding(failure.alarm, at, at + 1, msg!("nc.no-power"));
            return Some(finding.hint(msg!("nc.hint.power")));
        }
        if digits > 0 && before.is_empty() {
            // `100=5`, or a program number without its letter.
            let letter = match after.first() {
                Some(b'=') => self.control.syntax.variable.to_string(),
                None if self.only_comments() => self.program_letter(),
                _ => return None,
            };
            let finding = self.finding(failure.alarm, at, at + digits, msg!("nc.number-without-address"));
            return Some(self.with_fix(finding, LineFix::Write(at, at, &letter)));
        }
        let value = before.last().is_some_and(|b| b.is_ascii_digit() || matches!(b, b']' | b'.'));
        let value_ahead = byte.is_ascii_digit() || matches!(byte, b'#' | b'[');
        (value && value_ahead && before.contains(&b'=')).then(|| {
            let end = (at + digits).max(at + 1);
            self.finding(failure.alarm, at, end, msg!("nc.no-operator"))
        })
    }
}
