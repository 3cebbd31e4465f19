//! Diagnostics as SARIF 2.1.0 (OASIS), which code hosts and editors show beside the lines concerned.

use std::collections::BTreeMap;

use serde_json::{Value as Json, json};

use super::Renderer;
use crate::msg;
use crate::project::help::open;
use crate::text::catalog::{self, sentence, words};
use crate::text::{Diagnostic, FileId, Fix, Place, Severity, Span, sentences};

/// Address of the schema of the form.
const SCHEMA: &str = "https://json.schemastore.org/sarif-2.1.0.json";

/// A log of one run with these results of [`Renderer::sarif`].
pub fn log(results: Vec<Json>) -> Json {
    let level = |result: &Json| Some((result["ruleId"].as_str()?.to_owned(), result["level"].clone()));
    let levels: BTreeMap<String, Json> = results.iter().filter_map(level).collect();
    let rules: Vec<Json> = levels.iter().map(|(id, level)| rule(id, level)).collect();
    let driver = json!({ "name": "macroline", "semanticVersion": env!("CARGO_PKG_VERSION"), "rules": rules });
    json!({
        "$schema": SCHEMA,
        "version": "2.1.0",
        "runs": [{ "tool": { "driver": driver }, "columnKind": "unicodeCodePoints", "results": results }],
    })
}

/// Rule of an id, shown by code hosts beside all of its results: the sentence with an ellipsis at each value, and how to silence the
/// warning.
fn rule(id: &str, level: &Json) -> Json {
    let description = catalog::id(id).map(|id| open(words(id))).unwrap_or_else(|| id.to_owned());
    let silence = (level != "error").then(|| sentence(&msg!("project.sarif-silence", id)));
    let help: Vec<&str> = core::iter::once(description.as_str()).chain(silence.as_deref()).collect();
    let marked: Vec<String> = help.iter().map(|text| markdown(text)).collect();
    json!({
        "id": id,
        "name": pascal(id),
        "shortDescription": { "text": first_sentence(&description) },
        "fullDescription": { "text": description },
        "help": { "text": help.join("\n\n"), "markdown": marked.join("\n\n") },
        "defaultConfiguration": { "level": level },
    })
}

/// An id as one word: `lint.no-point` is `LintNoPoint`.
fn pascal(id: &str) -> String {
    let word = |word: &str| {
        let mut letters = word.chars();
        letters.next().map(|first| first.to_ascii_uppercase()).into_iter().chain(letters).collect::<String>()
    };
    id.split(['.', '-']).map(word).collect()
}

/// The text up to the end of its first sentence.
fn first_sentence(text: &str) -> &str {
    let ends = [text.find(". ").map(|at| at + 1), text.find('。').map(|at| at + '。'.len_utf8())];
    ends.into_iter().flatten().min().and_then(|end| text.get(..end)).unwrap_or(text)
}

/// Escapes a text for Markdown.
fn markdown(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        if "\\`*_[]<>#".contains(c) {
            out.push('\\');
        }
        out.push(c);
    }
    out
}

impl Renderer<'_> {
    /// The diagnostic as a result: its message is the alarm, the sentence, the hints and the field; each fix that can be made in the file
    /// is separate. Lines and columns count from 1; the end column is after the last character. A diagnostic without a place is put at the
    /// first line, because code hosts refuse a result without one.
    pub fn sarif(&self, diagnostic: &Diagnostic) -> Json {
        let message = sentence(&diagnostic.message);
        let alarm = diagnostic.alarm.iter().map(|alarm| format!("[{alarm}]"));
        let hints = diagnostic.hints.iter().map(sentence);
        let field = diagnostic.field.iter().map(|field| sentence(&msg!("project.sarif-field", field = *field)));
        let text = sentences(alarm.chain([message]).chain(hints).chain(field));
        let mut result = json!({
            "ruleId": diagnostic.message_id(),
            "level": match diagnostic.severity {
                Severity::Error => "error",
                Severity::Warning => "warning",
                Severity::Info => "note",
            },
            "message": { "text": text },
        });
        let start = Place { file: FileId::default(), span: Span::at(0) };
        if let Some(location) = self.location(diagnostic.place.unwrap_or(start)) {
            result["locations"] = json!([{ "physicalLocation": location }]);
        }
        let fixes: Vec<Json> = self.fixes(diagnostic).filter_map(|fix| self.sarif_fix(fix)).collect();
        if !fixes.is_empty() {
            result["fixes"] = fixes.into();
        }
        result
    }

    fn location(&self, place: Place) -> Option<Json> {
        Some(json!({ "artifactLocation": { "uri": uri(self.name(place.file)?) }, "region": self.region(place)? }))
    }

    fn region(&self, place: Place) -> Option<Json> {
        let (file, index) = (self.files.get(place.file)?, self.indices.get(usize::from(place.file.0))?);
        let [start, end] = [place.span.start, place.span.end].map(|at| index.position(&file.text, at));
        Some(
            json!({ "startLine": start.line, "startColumn": start.column, "endLine": end.line, "endColumn": end.column }),
        )
    }

    fn sarif_fix(&self, fix: &Fix) -> Option<Json> {
        // All edits of a file are one change: their places are those before any of them.
        let mut edits: BTreeMap<FileId, Vec<&(Place, String)>> = BTreeMap::new();
        fix.edits.iter().for_each(|edit| edits.entry(edit.0.file).or_default().push(edit));
        let replacement = |(place, text): &&(Place, String)| {
            Some(json!({ "deletedRegion": self.region(*place)?, "insertedContent": { "text": text } }))
        };
        let change = |(file, mut edits): (FileId, Vec<&(Place, String)>)| {
            edits.sort_by_key(|edit| edit.0.span.start);
            let replacements = edits.iter().map(replacement).collect::<Option<Vec<Json>>>()?;
            Some(json!({ "artifactLocation": { "uri": uri(self.name(file)?) }, "replacements": replacements }))
        };
        let changes = edits.into_iter().map(change).collect::<Option<Vec<Json>>>()?;
        Some(json!({ "description": { "text": sentence(&fix.title) }, "artifactChanges": changes }))
    }
}

/// A path as a URI, or a relative one as a relative reference: characters other than letters, digits and `-._~/` are percent-encoded.
fn uri(path: &str) -> String {
    let path = if cfg!(windows) { path.replace('\\', "/") } else { path.to_owned() };
    let path = path.trim_start_matches("./");
    let (mut out, path) = match path.split_at_checked(2) {
        Some((drive, rest)) if drive.ends_with(':') && rest.starts_with('/') => (format!("file:///{drive}"), rest),
        _ if path.starts_with('/') => ("file://".to_owned(), path),
        _ => (String::new(), path),
    };
    for byte in path.bytes() {
        if byte.is_ascii_alphanumeric() || b"-._~/".contains(&byte) {
            out.push(char::from(byte));
        } else {
            out.push_str(&format!("%{byte:02X}"));
        }
    }
    out
}
