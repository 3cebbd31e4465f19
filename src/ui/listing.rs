//! A program as lines of HTML: coloured words, line numbers, and what is wrong below the line it is wrong in.

use std::fmt::Write;

use super::words::{say, sign, t, tone};
use crate::controls::Control;
use crate::nc::{File, TokenKind, tokens};
use crate::text::{Diagnostic, FileId, LineIndex, Severity};
use crate::view::svg::escape;

/// Lines of a program that are shown at most.
pub(super) const SHOWN: u32 = 5000;

/// The lines of a file; `diagnostics` are those of all files. Lines carry their number, fixes the numbers of diagnostic and fix.
pub(super) fn html(file: &File, id: FileId, control: &Control, diagnostics: &[Diagnostic]) -> String {
    let lines = LineIndex::new(&file.text);
    let here: Vec<(usize, &Diagnostic)> =
        diagnostics.iter().enumerate().filter(|(_, d)| d.place.is_some_and(|place| place.file == id)).collect();
    let mut out = String::with_capacity(file.text.len() * 4);
    let mut number = 0;
    let mut start = 0;
    for line in file.text.split('\n').take(SHOWN as usize) {
        number += 1;
        let text = line.strip_suffix('\r').unwrap_or(line);
        let end = start + text.len();
        if !(number == lines.count() && text.is_empty()) {
            let _ = write!(out, "<li data-l=\"{number}\"><code>");
            words(&mut out, text, start, control, &here);
            out.push_str("</code></li>");
        }
        for (at, diagnostic) in &here {
            if diagnostic.place.is_some_and(|place| lines.line_of(place.span.start) == number) {
                finding(&mut out, *at, diagnostic);
            }
        }
        start = end + (line.len() - text.len()) + 1;
    }
    if lines.count() > SHOWN {
        let _ = write!(out, "<li class=\"says info\">{} {SHOWN} / {}</li>", t("page.first-lines"), lines.count());
    }
    out
}

fn words(out: &mut String, text: &str, start: usize, control: &Control, here: &[(usize, &Diagnostic)]) {
    if text.is_empty() {
        out.push(' ');
    }
    let mut told = 0;
    for (span, kind) in tokens(text, control) {
        // Space between the pieces.
        escape(out, text.get(told..span.start as usize).unwrap_or(""));
        told = span.end as usize;
        let (from, to) = (start as u32 + span.start, start as u32 + span.end);
        let bad = here.iter().find(|(_, d)| {
            d.place.is_some_and(|place| {
                let span = place.span;
                span.start < to && from < span.end.max(span.start + 1)
            })
        });
        let class = class(kind);
        let _ = match bad {
            Some((_, d)) => write!(out, "<span class=\"{class} bad-{}\">", tone(d.severity)),
            None if class.is_empty() => Ok(()),
            None => write!(out, "<span class=\"{class}\">"),
        };
        escape(out, span.of(text));
        if bad.is_some() || !class.is_empty() {
            out.push_str("</span>");
        }
    }
}

/// The class of a piece of text.
pub(super) fn class(kind: TokenKind) -> &'static str {
    match kind {
        TokenKind::Comment | TokenKind::Percent => "t-c",
        TokenKind::Code => "t-g",
        TokenKind::Sequence => "t-n",
        TokenKind::Variable => "t-v",
        TokenKind::Number => "t-d",
        TokenKind::Keyword => "t-k",
        TokenKind::Error => "bad-fail",
        TokenKind::Address | TokenKind::Operator => "",
    }
}

/// What is wrong, how to mend it, and buttons that do.
fn finding(out: &mut String, at: usize, diagnostic: &Diagnostic) {
    let class = tone(diagnostic.severity);
    let _ = write!(out, "<li class=\"says {class}\"><p><i aria-hidden=\"true\">{}</i> ", sign(class));
    if let Some(alarm) = &diagnostic.alarm {
        let _ = write!(out, "<b>{alarm}</b> ");
        if let Some(wording) = diagnostic.wording {
            out.push_str("<q>");
            escape(out, wording);
            out.push_str("</q> ");
        }
    }
    escape(out, &say(&diagnostic.message));
    for hint in &diagnostic.hints {
        out.push_str(" <em>");
        escape(out, &say(hint));
        out.push_str("</em>");
    }
    out.push_str("</p>");
    for (fix, row) in diagnostic.fixes.iter().enumerate() {
        let _ = write!(out, "<button type=\"button\" data-d=\"{at}\" data-fix=\"{fix}\">");
        escape(out, &say(&row.title));
        out.push_str("</button>");
    }
    if diagnostic.severity != Severity::Error {
        let (id, words) = (diagnostic.id(), t("page.silence"));
        let _ = write!(out, "<button type=\"button\" class=\"quiet\" data-silence=\"{id}\">{words}</button>");
    }
    out.push_str("</li>");
}

/// How many errors, warnings and remarks there are.
pub(super) fn count(diagnostics: &[Diagnostic]) -> [(Severity, usize); 3] {
    [Severity::Error, Severity::Warning, Severity::Info]
        .map(|severity| (severity, diagnostics.iter().filter(|d| d.severity == severity).count()))
}
