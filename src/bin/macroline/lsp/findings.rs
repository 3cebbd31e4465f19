//! Diagnostics and their fixes as messages of the protocol.

use std::collections::HashMap;

use lsp_types::{
    CodeAction, CodeActionKind, CodeActionOrCommand, DiagnosticRelatedInformation, DiagnosticSeverity, Location,
    NumberOrString, Range, TextEdit, Url, WorkspaceEdit,
};
use macroline::msg;
use macroline::nc;
use macroline::project::findings::check::{FixChoice, fixes};
use macroline::project::meaning::Meaning;
use macroline::text::catalog::{sentence, words};
use macroline::text::{Diagnostic, FileId, Fix, Phrase, Place, Severity, Span, headed};

use super::convert::Lines;
use super::documents::Programs;

/// Name of the program that reports.
const SOURCE: &str = "macroline";

/// Kind of the action that makes every fix without a choice.
pub(super) const FIX_ALL: CodeActionKind = CodeActionKind::SOURCE_FIX_ALL;

/// A finding without a program: a remark at the head of a file.
pub(super) fn remark(text: String) -> lsp_types::Diagnostic {
    lsp_types::Diagnostic {
        severity: Some(DiagnosticSeverity::INFORMATION),
        source: Some(SOURCE.to_owned()),
        message: text,
        ..lsp_types::Diagnostic::default()
    }
}

impl Programs {
    /// The findings of a file; findings without a place belong to the start of the first file.
    fn of_file(&self, file: FileId) -> impl Iterator<Item = (Place, &Diagnostic)> {
        let placed = |finding: &Diagnostic| finding.place.unwrap_or_default();
        self.found.iter().map(move |finding| (placed(finding), finding)).filter(move |row| row.0.file == file)
    }

    /// The diagnostics of a file. `related`: the client shows related information beside a diagnostic; otherwise it becomes part of the
    /// message.
    pub(super) fn diagnostics(&self, file: FileId, related: bool) -> Vec<lsp_types::Diagnostic> {
        let Some((address, text)) = self.get(file) else { return Vec::new() };
        let lines = Lines::new(text);
        let one =
            |(place, finding): (Place, &Diagnostic)| diagnostic(finding, address, lines.range(place.span), related);
        self.of_file(file).map(one).collect()
    }

    /// Code actions for the findings that meet a range of a file, and one that makes all fixes without an alternative.
    pub(super) fn actions(&self, file: FileId, range: Range, related: bool) -> Vec<CodeActionOrCommand> {
        let Some((address, text)) = self.get(file) else { return Vec::new() };
        let lines = Lines::new(text);
        let asked = lines.span(range);
        let meets = |span: Span| span.start <= asked.end && asked.start <= span.end;
        let mut all = Vec::new();
        for (place, finding) in self.of_file(file).filter(|row| meets(row.0.span)) {
            let only = finding.certain_fix().is_some();
            for fix in finding.fixes.iter().filter(|fix| can_be_made(fix)) {
                all.push(CodeActionOrCommand::CodeAction(CodeAction {
                    title: sentence(&fix.title),
                    kind: Some(CodeActionKind::QUICKFIX),
                    diagnostics: Some(vec![diagnostic(finding, address, lines.range(place.span), related)]),
                    edit: Some(self.edit(&fix.edits)),
                    is_preferred: only.then_some(true),
                    ..CodeAction::default()
                }));
            }
        }
        all.extend(self.all_fixes().map(CodeActionOrCommand::CodeAction));
        all
    }

    /// One action with every fix that has no alternative, in all files.
    fn all_fixes(&self) -> Option<CodeAction> {
        let files = self.parsed.files();
        let (fixed, count) = nc::fix_all(files, fixes(&self.found, FixChoice::Certain).filter(|fix| can_be_made(fix)));
        let whole = |(at, (old, new)): (u16, (&nc::File, &nc::File))| {
            let place = Place { file: FileId(at), span: Span::new(0, old.text.len() as u32) };
            (old.text != new.text).then(|| (place, new.text.clone()))
        };
        let edits: Vec<(Place, String)> = (0..).zip(files.0.iter().zip(&fixed.0)).filter_map(whole).collect();
        (count > 0).then(|| CodeAction {
            title: sentence(&msg!("page.fix-all", count = count as u32)),
            kind: Some(FIX_ALL),
            edit: Some(self.edit(&edits)),
            ..CodeAction::default()
        })
    }

    fn edit(&self, edits: &[(Place, String)]) -> WorkspaceEdit {
        let mut changes: HashMap<Url, Vec<TextEdit>> = HashMap::new();
        for (place, text) in edits {
            if let Some((address, file)) = self.get(place.file) {
                let range = Lines::new(file).range(place.span);
                changes.entry(address.clone()).or_default().push(TextEdit { range, new_text: text.clone() });
            }
        }
        WorkspaceEdit { changes: Some(changes), ..WorkspaceEdit::default() }
    }
}

/// Whether a fix writes only text. The editor would save a byte that is not text as another character.
fn can_be_made(fix: &Fix) -> bool {
    fix.edits.iter().all(|(_, text)| !text.contains(char::REPLACEMENT_CHARACTER))
}

fn diagnostic(finding: &Diagnostic, address: &Url, range: Range, related: bool) -> lsp_types::Diagnostic {
    let shown = finding.alarm.as_deref().zip(finding.wording);
    let wording =
        shown.map(|(alarm, wording): (&str, Phrase)| sentence(&msg!("project.control-shows", alarm, text = wording)));
    let more: Vec<String> = wording.into_iter().chain(finding.hints.iter().map(sentence)).collect();
    let message = sentence(&finding.message);
    let apart = |message: &String| DiagnosticRelatedInformation {
        location: Location { uri: address.clone(), range },
        message: message.clone(),
    };
    lsp_types::Diagnostic {
        range,
        severity: Some(match finding.severity {
            Severity::Error => DiagnosticSeverity::ERROR,
            Severity::Warning => DiagnosticSeverity::WARNING,
            Severity::Info => DiagnosticSeverity::INFORMATION,
        }),
        code: Some(NumberOrString::String(finding.alarm.as_deref().unwrap_or(finding.message_id()).to_owned())),
        source: Some(SOURCE.to_owned()),
        related_information: related.then(|| more.iter().map(apart).collect()),
        message: if related { message } else { [vec![message], more].concat().join("\n") },
        ..lsp_types::Diagnostic::default()
    }
}

/// A meaning with its unit and source, as lines of plain text.
pub(super) fn meaning_text(meaning: &Meaning) -> String {
    let says: Vec<String> = meaning.says.iter().map(sentence).collect();
    let unit = (!meaning.unit.is_empty()).then(|| headed(words("lsp.unit"), meaning.unit));
    let source = meaning.cite.map(|cite| headed(words("lsp.source"), cite.source.words()));
    let lines = [Some(headed(&meaning.word, says.join("\n"))), unit, source];
    lines.into_iter().flatten().collect::<Vec<_>>().join("\n")
}
