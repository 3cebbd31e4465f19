//! Diagnostics and their fixes as messages of the protocol.

use std::collections::HashMap;

use lsp_types::{
    CodeAction, CodeActionKind, CodeActionOrCommand, DiagnosticRelatedInformation, DiagnosticSeverity, Location,
    NumberOrString, Range, TextEdit, Url, WorkspaceEdit,
};
use macroline::msg;
use macroline::nc;
use macroline::project::findings::check::{FixChoice, fixes};
use macroline::text::catalog::sentence;
use macroline::text::{Diagnostic, FileId, Fix, Phrase, Place, Severity, Span};

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

    /// Code actions for the findings that meet a range of a file, and one that makes all its fixes without an alternative.
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
        all.extend(self.all_fixes(file).map(CodeActionOrCommand::CodeAction));
        all
    }

    /// One action with every fix that has no alternative and changes this file alone: an editor that carries it out at every save must
    /// not change files that nobody opened.
    fn all_fixes(&self, file: FileId) -> Option<CodeAction> {
        let is_own = |fix: &&Fix| can_be_made(fix) && fix.edits.iter().all(|(place, _)| place.file == file);
        let (fixed, count) = nc::fix_all(self.parsed.files(), fixes(&self.found, FixChoice::Certain).filter(is_own));
        let (_, old) = self.get(file)?;
        let new = fixed.0.into_iter().nth(usize::from(file.0))?.text;
        let whole = Place { file, span: Span::new(0, old.len() as u32) };
        (count > 0).then(|| CodeAction {
            title: sentence(&msg!("page.fix-all", count = count as u32)),
            kind: Some(FIX_ALL),
            edit: Some(self.edit(&[(whole, new)])),
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
