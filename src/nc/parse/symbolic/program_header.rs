//! Lines that name a program, in a language with names.

use crate::controls::Alarm;
use crate::msg;
use crate::nc::ast::{Program, TextId};
use crate::nc::lex::names::{begins_as_name, is_numbered, number_in};
use crate::nc::parse::reader::Reader;
use crate::text::Span;

/// Text between the `%` of a header and the name, and the start of the following line.
const LEAD: &str = "_N_";
const PATH: &[u8] = b";$PATH=";

impl Reader<'_> {
    /// Reads `%_N_NAME_MPF` or `%NAME`, or reports the lone `%` of other controls.
    pub(in crate::nc::parse) fn program_header(&mut self, from: usize, to: usize) {
        let Some(names) = self.names() else { return };
        let line = self.file.text.get(from..to).unwrap_or("");
        let line = line.split(';').next().unwrap_or("").trim_end();
        self.take_line(line.as_bytes(), from);
        self.notes.headed = false;
        let name = line.trim_start_matches('%');
        if name.is_empty() {
            let finding =
                self.finding(Alarm::Format, 0, line.len(), msg!("nc.percent-alone", ending = names.endings[0]));
            return self.report_replacing(Alarm::Format, finding, 0, line.len(), "");
        }
        let lead = name.get(..LEAD.len()).filter(|lead| lead.eq_ignore_ascii_case(LEAD)).map_or(0, str::len);
        let from = line.len() - name.len() + lead;
        let upper = name.get(lead..).unwrap_or("").to_ascii_uppercase();
        let ending =
            names.endings.iter().position(|ending| upper.strip_suffix(ending).is_some_and(|n| n.ends_with('_')));
        let bare = match ending {
            Some(at) => upper.get(..upper.len() - names.endings[at].len() - 1).unwrap_or(""),
            None => upper.as_str(),
        };
        // Without an ending, the letters of the name give its kind.
        let sub = match ending {
            Some(at) => at == 1,
            None => bare.starts_with(names.endings[1]) || bare.starts_with('L') && is_numbered(names, bare),
        };
        let place = self.place(self.span(0, line.len()));
        if !(begins_as_name(bare) || is_numbered(names, bare)) || bare.len() > names.program_chars {
            let message = msg!("nc.program-name", name = bare, most = names.program_chars as u32);
            self.add_finding(crate::text::Diagnostic::warning(message).at(place));
        }
        let number = number_in(names, bare);
        let name = Some(self.add_text(bare, self.span(from, from + bare.len())));
        self.notes.headed = true;
        self.begin_program(Program { number, name, sub, ..self.empty_program(place.span) });
    }

    /// Takes a line that names the directory of the program in the header before it; returns whether it is one.
    pub(in crate::nc::parse) fn take_directory_line(&mut self, line: &[u8]) -> bool {
        core::mem::take(&mut self.notes.headed)
            && line.get(..PATH.len()).is_some_and(|lead| lead.eq_ignore_ascii_case(PATH))
    }

    /// Name, kind and number of the program in a file without a header, from the file's name.
    pub(in crate::nc::parse) fn file_program(&mut self) -> (Option<TextId>, bool, u32) {
        let Some(names) = self.names() else { return (None, false, 0) };
        let upper = self.file.name.to_ascii_uppercase();
        let (stem, ending) = upper.rsplit_once('.').unwrap_or((&upper, ""));
        let stem: String = stem.chars().filter(|c| c.is_ascii_alphanumeric() || *c == '_').collect();
        let number = number_in(names, &stem);
        (Some(self.add_text(stem, Span::default())), ending == names.endings[1], number)
    }

    /// Reports `O1234` of other controls at the start of a line.
    pub(in crate::nc::parse) fn foreign_program_number(&mut self) -> bool {
        let Some(names) = self.names() else { return false };
        let digits = self.cursor.line.get(1..).unwrap_or_default();
        let number = core::str::from_utf8(digits).unwrap_or("").trim();
        if number.is_empty() || !number.bytes().all(|b| b.is_ascii_digit()) {
            return false;
        }
        let head = format!("%_N_{}{number}_{}", names.endings[0], names.endings[0]);
        self.report_replaced(
            Alarm::Format,
            0,
            self.cursor.line.len(),
            msg!("nc.foreign-head", head = head.as_str()),
            &head,
        );
        self.cursor.at = self.cursor.line.len();
        true
    }
}
