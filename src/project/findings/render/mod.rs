//! Renders diagnostics: as text with the marked line, and as JSON.

pub mod sarif;

use serde_json::{Value as Json, json};

use crate::msg;
use crate::nc::{self, Files};
use crate::project::files::decode::{Decoded, Encoding};
use crate::text::catalog::{sentence, words};
use crate::text::columns::of_char;
use crate::text::escape::{is_terminal_control, terminal};
use crate::text::{Diagnostic, FileId, Fix, LineIndex, Place, Severity, Span, headed, listed};

/// Writes diagnostics about a set of files. It reads each file's lines once.
pub struct Renderer<'f> {
    files: &'f Files,
    /// Names shown instead of the names of the files.
    names: &'f [String],
    /// The files as they were read from a disk; files beyond these are UTF-8.
    read: &'f [Decoded],
    indices: Vec<LineIndex>,
}

impl<'f> Renderer<'f> {
    /// Renders diagnostics of these files.
    pub fn new(files: &'f Files) -> Renderer<'f> {
        Renderer::about(files, &[], &[])
    }

    /// Renders diagnostics of files from a disk, with names that distinguish them and their encodings. Either list may be shorter
    /// than the files.
    pub fn about(files: &'f Files, names: &'f [String], read: &'f [Decoded]) -> Renderer<'f> {
        Renderer { files, names, read, indices: files.0.iter().map(|file| LineIndex::new(&file.text)).collect() }
    }

    /// The shown name of a file.
    fn name(&self, id: FileId) -> Option<&str> {
        let own = &self.files.get(id)?.name;
        Some(self.names.get(usize::from(id.0)).unwrap_or(own))
    }

    /// The offset of a place in the file on the disk.
    fn offset(&self, id: FileId, at: u32) -> Option<u32> {
        self.read.get(usize::from(id.0)).map_or(Some(at), |file| file.offset(at))
    }

    /// The fixes that can be made in the files on the disk: their places exist there, and they copy only text.
    fn fixes<'d>(&self, diagnostic: &'d Diagnostic) -> impl Iterator<Item = &'d Fix> {
        let made = |(place, text): &(Place, String)| {
            let ends = [place.span.start, place.span.end];
            let plain = self.read.get(usize::from(place.file.0)).is_none_or(|file| file.encoding == Encoding::Utf8);
            ends.iter().all(|end| self.offset(place.file, *end).is_some()) && (plain || text.is_ascii())
        };
        diagnostic.fixes.iter().filter(move |fix| fix.edits.iter().all(made))
    }

    /// Severity with the alarm, or with the id that silences it, and the sentence; then file:line:column, the line itself with the place
    /// marked, the hints, and the lines after each fix.
    pub fn text(&self, diagnostic: &Diagnostic) -> String {
        let fixes: Vec<&Fix> = self.fixes(diagnostic).collect();
        let fixed: Vec<_> = fixes.iter().map(|fix| self.fixed_lines(fix)).collect();
        let place = diagnostic.place.and_then(|place| self.position(place));
        let last = fixed.iter().flatten().map(|(first, lines)| first + lines.len() as u32 - 1);
        let width = last.chain(place.map(|(_, line, _)| line)).max().map_or(1, |line| line.to_string().len());
        let mut out = headline(diagnostic) + "\n";
        if let Some(excerpt) = diagnostic.place.and_then(|place| self.aligned(place, width)) {
            out += &excerpt;
        } else if let Some(field) = diagnostic.field {
            out += &format!("{:width$}--> {}\n", "", sentence(&msg!("project.field", field)));
        }
        if let (Some(alarm), Some(wording)) = (diagnostic.alarm.as_deref(), diagnostic.wording) {
            let shown = sentence(&msg!("project.control-shows", alarm, text = wording));
            out += &format!("{:width$} = {shown}\n", "");
        }
        for hint in &diagnostic.hints {
            out += &format!("{:width$} = {}\n", "", sentence(hint));
        }
        for (fix, lines) in fixes.iter().zip(&fixed) {
            out += &format!("{}\n", sentence(&msg!("project.help", text = sentence(&fix.title))));
            let Some((first, lines)) = lines else { continue };
            out += &format!("{:width$} |\n", "");
            for (line, number) in lines.iter().zip(*first..) {
                out += &format!("{number:width$} + {}\n", Shown::new(line, 0, 0).text);
            }
        }
        terminal(&out).into_owned()
    }

    /// File:line:column, then the line itself with the place marked.
    pub fn excerpt(&self, place: Place) -> Option<String> {
        self.aligned(place, 0)
    }

    /// File:line:column and the marked line, with line numbers padded to a width.
    fn aligned(&self, place: Place, width: usize) -> Option<String> {
        let (file, line, column) = self.position(place)?;
        let text = self.files.get(place.file).map_or("", |file| place.span.of(&file.text));
        let length = text.split('\n').next().unwrap_or("").chars().count();
        let shown = Shown::new(self.line_text(place, line), column as usize - 1, length);
        let width = width.max(line.to_string().len());
        let (gap, left) = (" ".repeat(width), " ".repeat(shown.column));
        let marks = "^".repeat(shown.width.max(1));
        let text = shown.text;
        Some(format!("{gap}--> {file}:{line}:{column}\n{gap} |\n{line:width$} | {text}\n{gap} | {left}{marks}\n"))
    }

    /// The lines after a fix that it changes, and the number of the first; `None` if it changes too much of the file.
    fn fixed_lines(&self, fix: &Fix) -> Option<(u32, Vec<String>)> {
        let place = fix.edits.first()?.0;
        let text = self.files.get(place.file)?.text.as_str();
        let from = fix.edits.iter().map(|(place, _)| place.span.start as usize).min()?;
        let to = fix.edits.iter().map(|(place, _)| place.span.end as usize).max()?;
        let from = text.get(..from)?.rfind('\n').map_or(0, |at| at + 1);
        let to = to + text.get(to..)?.find('\n').unwrap_or(text.len() - to);
        if fix.edits.iter().any(|(other, _)| other.file != place.file) || to - from > TOUCHED {
            return None;
        }
        let shifted = |span: Span| Span::new(span.start - from as u32, span.end - from as u32);
        let edits =
            fix.edits.iter().map(|(place, new)| (Place { span: shifted(place.span), ..Place::default() }, new.clone()));
        let part = Fix { title: fix.title.clone(), edits: edits.collect() };
        let fixed = nc::fix(&Files::one("", text.get(from..to)?), &part);
        let lines: Vec<String> =
            fixed.0.first()?.text.lines().map(|line| line.trim_end_matches('\r').to_owned()).collect();
        let first = self.indices.get(place.file.0 as usize)?.line_of(from as u32);
        let short = lines.iter().all(|line| line.len() <= SHOWN);
        (!lines.is_empty() && lines.len() <= LINES && short).then_some((first, lines))
    }

    /// File:line, and the bytes of a place.
    pub fn block(&self, place: Place) -> String {
        let Some((file, line, _)) = self.position(place) else { return String::new() };
        let text = self.files.get(place.file).map_or("", |file| place.span.of(&file.text));
        format!("{file}:{line}: {}", terminal(&Shown::new(text, 0, 0).text))
    }

    /// File, line, column and bytes of a place as an object.
    pub fn block_json(&self, place: Place) -> Option<Json> {
        let (file, line, column) = self.position(place)?;
        let text = self.files.get(place.file).map_or("", |file| place.span.of(&file.text));
        Some(json!({ "file": file, "line": line, "column": column, "text": text }))
    }

    /// The diagnostic as an object with severity, alarm, its wording, id, message, file, line, column, field, hints and fixes, each a
    /// title and its edits; what does not apply is null. An edit replaces the bytes of a file from start to end, counted in the file.
    pub fn json(&self, diagnostic: &Diagnostic) -> Json {
        let hints: Vec<String> = diagnostic.hints.iter().map(sentence).collect();
        let edit = |(place, text): &(Place, String)| {
            let [start, end] = [place.span.start, place.span.end].map(|at| self.offset(place.file, at));
            json!({ "file": self.name(place.file), "start": start, "end": end, "text": text })
        };
        let fix = |fix: &Fix| {
            let edits: Vec<Json> = fix.edits.iter().map(edit).collect();
            json!({ "title": sentence(&fix.title), "edits": edits })
        };
        let fixes: Vec<Json> = self.fixes(diagnostic).map(fix).collect();
        let place = diagnostic.place.and_then(|place| self.position(place));
        json!({
            "severity": diagnostic.severity,
            "alarm": diagnostic.alarm,
            "wording": diagnostic.wording,
            "id": diagnostic.message_id(),
            "message": sentence(&diagnostic.message),
            "file": place.map(|(file, _, _)| file),
            "line": place.map(|(_, line, _)| line),
            "column": place.map(|(_, _, column)| column),
            "field": diagnostic.field,
            "hints": hints,
            "fixes": fixes,
        })
    }

    fn position(&self, place: Place) -> Option<(&str, u32, u32)> {
        let file = self.files.get(place.file)?;
        let position = self.indices.get(place.file.0 as usize)?.position(&file.text, place.span.start);
        Some((self.name(place.file)?, position.line, position.column))
    }

    fn line_text(&self, place: Place, line: u32) -> &str {
        match (self.files.get(place.file), self.indices.get(place.file.0 as usize)) {
            (Some(file), Some(index)) => index.line(&file.text, line),
            _ => "",
        }
    }
}

/// Severity, alarm and sentence.
pub fn headline(diagnostic: &Diagnostic) -> String {
    let tag = match (diagnostic.severity, diagnostic.alarm.as_deref()) {
        (_, Some(alarm)) => format!("[{alarm}]"),
        (Severity::Error, None) => String::new(),
        (_, None) => format!("[{}]", diagnostic.message_id()),
    };
    let severity = match diagnostic.severity {
        Severity::Error => words("project.severity.error"),
        Severity::Warning => words("project.severity.warning"),
        Severity::Info => words("project.severity.info"),
    };
    headed(severity.to_owned() + &tag, sentence(&diagnostic.message))
}

/// Number of diagnostics of each severity: `2 errors, 1 warning`.
pub fn summary(diagnostics: &[Diagnostic]) -> String {
    let count = |severity| diagnostics.iter().filter(|d| d.severity == severity).count() as u32;
    let counts = [
        (count(Severity::Error), msg!("project.errors", count = count(Severity::Error))),
        (count(Severity::Warning), msg!("project.warnings", count = count(Severity::Warning))),
        (count(Severity::Info), msg!("project.remarks", count = count(Severity::Info))),
    ];
    let counts: Vec<String> =
        counts.into_iter().filter(|(count, _)| *count > 0).map(|(_, message)| sentence(&message)).collect();
    if counts.is_empty() { words("project.nothing-to-say").to_owned() } else { listed(counts) }
}

/// Columns of a line that are shown at most.
const SHOWN: usize = 160;

/// Columns from one tabulator stop to the next.
const TAB: usize = 4;

/// Bytes and lines that are shown of a fix at most.
const TOUCHED: usize = 1000;
const LINES: usize = 8;

/// The part of a line around the marked characters, for a terminal.
struct Shown {
    text: String,
    /// Columns in front of the characters.
    column: usize,
    /// Columns of the characters.
    width: usize,
}

impl Shown {
    /// A line with `length` characters marked from the character `at` on.
    fn new(line: &str, at: usize, length: usize) -> Shown {
        let long = line.chars().nth(SHOWN).is_some();
        let skipped = if long { at.saturating_sub(SHOWN / 4) } else { 0 };
        let mut shown = Shown { text: String::new(), column: 0, width: 0 };
        let mut column = 0;
        for (index, c) in line.chars().enumerate().skip(skipped) {
            let wide = if c == '\t' { TAB - column % TAB } else { of_char(c) };
            if column + wide > SHOWN {
                break;
            }
            column += wide;
            if index < at {
                shown.column = column;
            } else if index < at + length {
                shown.width += wide;
            }
            match c {
                '\t' => shown.text.extend(core::iter::repeat_n(' ', wide)),
                c if is_terminal_control(c) => shown.text.push(char::REPLACEMENT_CHARACTER),
                c => shown.text.push(c),
            }
        }
        shown
    }
}
