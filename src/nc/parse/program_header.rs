//! Where programs have names: the lines that name them, and what a name may be.

use super::super::ast::{Program, TextId};
use super::Reader;
use crate::controls::Alarm;
use crate::controls::syntax::Names;
use crate::msg;
use crate::text::Span;

/// Between the `%` of a head and the name, and what the line behind it begins with.
const LEAD: &str = "_N_";
const PATH: &[u8] = b";$PATH=";

/// The number in a name that is one: 9100 in `L9100`; 0 where it has none. Leading zeros make another name.
pub(in super::super) fn number_in(names: &Names, name: &str) -> u32 {
    let digits = names.numbered.iter().find_map(|letters| name.strip_prefix(letters));
    let digits = digits.filter(|digits| !digits.starts_with('0') && digits.bytes().all(|b| b.is_ascii_digit()));
    digits.and_then(|digits| digits.parse().ok()).unwrap_or(0)
}

/// Whether a name is one of those that stand for a number, with leading zeros too.
fn is_numbered(names: &Names, name: &str) -> bool {
    let digits = |digits: &str| !digits.is_empty() && digits.bytes().all(|b| b.is_ascii_digit());
    names.numbered.iter().any(|letters| name.strip_prefix(letters).is_some_and(digits))
}

/// Whether a name begins as names do: two letters, or `_` and a letter or another `_`.
pub(super) fn begins_as_name(name: &str) -> bool {
    let mut first = name.bytes();
    let letter = |b: Option<u8>| b.is_some_and(|b| b.is_ascii_alphabetic() || b == b'_');
    letter(first.next()) && letter(first.next()) && name.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'_')
}

impl Reader<'_> {
    /// `%_N_NAME_MPF`, `%NAME` or the `%` of other controls, which is none.
    pub(super) fn head(&mut self, from: usize, to: usize) {
        let Some(names) = self.names() else { return };
        let line = self.source.get(from..to).unwrap_or("");
        let line = line.split(';').next().unwrap_or("").trim_end();
        self.take_line(line.as_bytes(), from);
        self.headed = false;
        let name = line.trim_start_matches('%');
        if name.is_empty() {
            let finding = self.finding(Alarm::Format, 0, line.len(), msg!("nc.percent-alone", names.endings[0]));
            return self.replace(Alarm::Format, finding, 0, line.len(), "");
        }
        let lead = name.get(..LEAD.len()).filter(|lead| lead.eq_ignore_ascii_case(LEAD)).map_or(0, str::len);
        let upper = name.get(lead..).unwrap_or("").to_ascii_uppercase();
        let ending =
            names.endings.iter().position(|ending| upper.strip_suffix(ending).is_some_and(|n| n.ends_with('_')));
        let bare = match ending {
            Some(at) => upper.get(..upper.len() - names.endings[at].len() - 1).unwrap_or(""),
            None => upper.as_str(),
        };
        // Without an ending, its own letters say what it is.
        let sub = match ending {
            Some(at) => at == 1,
            None => bare.starts_with(names.endings[1]) || bare.starts_with('L') && is_numbered(names, bare),
        };
        let place = self.place(self.span(0, line.len()));
        if !(begins_as_name(bare) || is_numbered(names, bare)) || bare.len() > names.program_chars {
            let message = msg!("nc.program-name", bare, names.program_chars as u32);
            self.add_finding(crate::text::Diagnostic::warning(message).at(place));
        }
        let (number, at) = (number_in(names, bare), self.deck.blocks.len() as u32);
        let name = Some(self.deck.add_text(bare));
        self.headed = true;
        if self.only_comments()
            && let Some(program) = self.program.and_then(|index| self.deck.programs.get_mut(index))
        {
            // Comments above the head belong to its program.
            (program.number, program.name, program.sub, program.span) = (number, name, sub, place.span);
            return;
        }
        self.program = Some(self.deck.programs.len());
        let program = Program { file: self.id, number, name, sub, title: None, span: place.span, first: at, end: at };
        self.deck.programs.push(program);
    }

    /// Whether a line is the one that tells the directory of the program that the line before names.
    pub(super) fn path(&mut self, line: &[u8]) -> bool {
        core::mem::take(&mut self.headed) && line.get(..PATH.len()).is_some_and(|lead| lead.eq_ignore_ascii_case(PATH))
    }

    /// Name, kind and number of the program of a file without a head: those of the file.
    pub(super) fn file_program(&mut self) -> (Option<TextId>, bool, u32) {
        let Some(names) = self.names() else { return (None, false, 0) };
        let upper = self.file_name.to_ascii_uppercase();
        let (stem, ending) = upper.rsplit_once('.').unwrap_or((&upper, ""));
        let stem: String = stem.chars().filter(|c| c.is_ascii_alphanumeric() || *c == '_').collect();
        let number = number_in(names, &stem);
        (Some(self.deck.add_text(stem)), ending == names.endings[1], number)
    }

    /// `O1234` of other controls at the head of a line.
    pub(super) fn foreign_head(&mut self) -> bool {
        let Some(names) = self.names() else { return false };
        let digits = self.line.get(1..).unwrap_or_default();
        let number = core::str::from_utf8(digits).unwrap_or("").trim();
        if number.is_empty() || !number.bytes().all(|b| b.is_ascii_digit()) {
            return false;
        }
        let head = format!("%_N_{}{number}_{}", names.endings[0], names.endings[0]);
        self.slip(Alarm::Format, 0, self.line.len(), msg!("nc.foreign-head", head.as_str()), &head);
        self.at = self.line.len();
        true
    }

    /// Reads a block once more.
    pub(super) fn again(&mut self, span: Span) -> super::Read<super::Stmt> {
        let (from, to) = (span.start as usize, span.end as usize);
        let source = self.source;
        if self.names().is_some() {
            self.take_named(from, to);
            return self.named_statement();
        }
        self.take_line(source.as_bytes().get(from..to).unwrap_or_default(), from);
        self.statement()
    }
}
