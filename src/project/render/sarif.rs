//! Diagnostics as SARIF 2.1.0 of OASIS, which code hosts and editors show beside the lines that they are about.

use std::collections::BTreeSet;

use serde_json::{Value as Json, json};

use super::Renderer;
use crate::text::catalog::{Language, sentence};
use crate::text::{Diagnostic, Fix, Place, Severity};

/// Address of the schema of the form.
const SCHEMA: &str = "https://json.schemastore.org/sarif-2.1.0.json";

/// A log of one run with these results of [`Renderer::sarif`].
pub fn log(results: Vec<Json>) -> Json {
    let ids: BTreeSet<&str> = results.iter().filter_map(|result| result["ruleId"].as_str()).collect();
    let rules: Vec<Json> = ids.into_iter().map(|id| json!({ "id": id })).collect();
    let driver = json!({ "name": "macroline", "semanticVersion": env!("CARGO_PKG_VERSION"), "rules": rules });
    json!({
        "$schema": SCHEMA,
        "version": "2.1.0",
        "runs": [{ "tool": { "driver": driver }, "columnKind": "unicodeCodePoints", "results": results }],
    })
}

impl Renderer<'_> {
    /// The diagnostic as a result: the alarm leads its sentence, hints follow it; each fix that can be made in the file is one of its own.
    /// Lines and columns count from 1, the end stands behind the last character.
    pub fn sarif(&self, diagnostic: &Diagnostic) -> Json {
        let said = sentence(Language::English, &diagnostic.message);
        let alarm = diagnostic.alarm.iter().map(|alarm| format!("[{alarm}]"));
        let hints = diagnostic.hints.iter().map(|hint| sentence(Language::English, hint));
        let text: Vec<String> = alarm.chain([said]).chain(hints).collect();
        let mut result = json!({
            "ruleId": diagnostic.id(),
            "level": match diagnostic.severity {
                Severity::Error => "error",
                Severity::Warning => "warning",
                Severity::Info => "note",
            },
            "message": { "text": text.join(" ") },
        });
        if let Some(location) = diagnostic.place.and_then(|place| self.location(place)) {
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
        let change = |(place, text): &(Place, String)| {
            let replacement = json!({ "deletedRegion": self.region(*place)?, "insertedContent": { "text": text } });
            let file = json!({ "uri": uri(self.name(place.file)?) });
            Some(json!({ "artifactLocation": file, "replacements": [replacement] }))
        };
        let changes = fix.edits.iter().map(change).collect::<Option<Vec<Json>>>()?;
        Some(json!({ "description": { "text": sentence(Language::English, &fix.title) }, "artifactChanges": changes }))
    }
}

/// A path as a reference of a URI: what is no letter, digit or `-._~/` is percent-encoded.
fn uri(path: &str) -> String {
    let mut out = String::new();
    for byte in path.replace('\\', "/").bytes() {
        if byte.is_ascii_alphanumeric() || b"-._~/".contains(&byte) {
            out.push(char::from(byte));
        } else {
            out.push_str(&format!("%{byte:02X}"));
        }
    }
    out
}
