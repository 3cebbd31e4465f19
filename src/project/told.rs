//! Diagnostics as they leave: for a terminal, with the line and the place marked, and for programs.

use serde_json::{Value as Json, json};

use crate::nc::Files;
use crate::text::catalog::{Language, sentence};
use crate::text::{Diagnostic, LineIndex, Place, Severity};

/// Writes diagnostics about a set of files. It reads each file's lines once.
pub struct Teller<'f> {
    files: &'f Files,
    indices: Vec<LineIndex>,
}

impl<'f> Teller<'f> {
    /// A teller for these files.
    pub fn new(files: &'f Files) -> Teller<'f> {
        Teller { files, indices: files.0.iter().map(|file| LineIndex::new(&file.text)).collect() }
    }

    /// Severity, alarm and sentence, then file:line:column, the line itself with the place marked, and the hints.
    pub fn text(&self, diagnostic: &Diagnostic) -> String {
        let mut out = headline(diagnostic) + "\n";
        if let Some(excerpt) = diagnostic.place.and_then(|place| self.excerpt(place)) {
            out += &excerpt;
        } else if let Some(field) = diagnostic.field {
            out += &format!(" --> field {field}\n");
        }
        for hint in &diagnostic.hints {
            out += &format!("  = {}\n", sentence(Language::English, hint));
        }
        harmless(&out)
    }

    /// File:line:column, then the line itself with the place marked.
    pub fn excerpt(&self, place: Place) -> Option<String> {
        let (file, line, column) = self.position(place)?;
        let (shown, at) = window(self.line_text(place, line), column as usize - 1);
        let digits = line.to_string();
        let gap = " ".repeat(digits.len());
        let left = shown.chars().take(at).map(|c| if c == '\t' { '\t' } else { ' ' }).collect::<String>();
        let room = shown.chars().count().saturating_sub(at).max(1);
        let wide = ((place.span.end - place.span.start) as usize).clamp(1, room);
        let marks = "^".repeat(wide);
        Some(format!("{gap}--> {file}:{line}:{column}\n{gap} |\n{digits} | {shown}\n{gap} | {left}{marks}\n"))
    }

    /// File:line, and the bytes of a place.
    pub fn block(&self, place: Place) -> String {
        let Some((file, line, _)) = self.position(place) else { return String::new() };
        let text = self.files.get(place.file).map_or("", |file| place.span.of(&file.text));
        format!("{file}:{line}: {}", harmless(&window(text, 0).0))
    }

    /// The diagnostic as an object with severity, alarm, message, file, line, column, field and hints; what does not apply is null.
    pub fn json(&self, diagnostic: &Diagnostic) -> Json {
        let hints: Vec<String> = diagnostic.hints.iter().map(|hint| sentence(Language::English, hint)).collect();
        let place = diagnostic.place.and_then(|place| self.position(place));
        json!({
            "severity": word(diagnostic.severity),
            "alarm": diagnostic.alarm,
            "message": sentence(Language::English, &diagnostic.message),
            "file": place.map(|(file, _, _)| file),
            "line": place.map(|(_, line, _)| line),
            "column": place.map(|(_, _, column)| column),
            "field": diagnostic.field,
            "hints": hints,
        })
    }

    fn position(&self, place: Place) -> Option<(&str, u32, u32)> {
        let file = self.files.get(place.file)?;
        let position = self.indices.get(place.file.0 as usize)?.position(&file.text, place.span.start);
        Some((&file.name, position.line, position.column))
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
    let alarm = diagnostic.alarm.as_ref().map_or(String::new(), |alarm| format!("[{alarm}]"));
    format!("{}{alarm}: {}", word(diagnostic.severity), sentence(Language::English, &diagnostic.message))
}

/// A program may hold anything, and a terminal obeys control characters.
fn harmless(text: &str) -> String {
    text.replace(|c: char| c.is_control() && !matches!(c, '\n' | '\t'), "\u{fffd}")
}

/// The severity as it is written.
pub fn word(severity: Severity) -> &'static str {
    match severity {
        Severity::Error => "error",
        Severity::Warning => "warning",
        Severity::Info => "info",
    }
}

/// Characters of a line that are shown at most.
const SHOWN: usize = 160;

/// The part of a line around a character, and where that character stands in it.
fn window(line: &str, at: usize) -> (String, usize) {
    if line.chars().nth(SHOWN).is_none() {
        return (line.to_owned(), at);
    }
    let from = at.saturating_sub(SHOWN / 4);
    (line.chars().skip(from).take(SHOWN).collect(), at - from)
}
