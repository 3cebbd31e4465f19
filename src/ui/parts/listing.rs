//! A program as rows of HTML: coloured words, line numbers, and the findings of each line below it.

use std::collections::BTreeMap;
use std::fmt::Write;

use crate::controls::Control;
use crate::nc::{File, TokenKind, tokens};
use crate::text::{Diagnostic, FileId, LineIndex};
use crate::ui::words::{Tone, sentence, t};
use crate::ui::worker::messages::SHOWN;
use crate::view::svg::escape;

/// Bytes of a line that are coloured at most, and bytes that are shown.
const COLOURED: usize = 2_000;
const LONGEST: usize = 10_000;

/// Findings below one line that are shown at most.
const FINDINGS: usize = 20;

/// A finding with its number among all.
type Numbered<'d> = (usize, &'d Diagnostic);

/// The lines of a file and the findings below them, a row each; `diagnostics` are those of all files. Lines carry their number, fixes the
/// numbers of diagnostic and fix.
pub(crate) fn rows(file: &File, id: FileId, control: &Control, diagnostics: &[Diagnostic]) -> Vec<String> {
    let lines = LineIndex::new(&file.text);
    let by_line = by_line(diagnostics, id, &lines);
    let mut rows = Vec::with_capacity(lines.count() as usize);
    let mut number = 0;
    let mut start = 0;
    for line in file.text.split('\n').take(SHOWN as usize) {
        number += 1;
        let text = line.strip_suffix('\r').unwrap_or(line);
        let found = by_line.get(&number).map_or(&[][..], Vec::as_slice);
        if !(number == lines.count() && text.is_empty()) {
            let mut row = format!("<li data-l=\"{number}\"><code>");
            words(&mut row, text, start, control, found);
            row.push_str("</code></li>");
            rows.push(row);
        }
        rows.extend(found.iter().take(FINDINGS).map(|(at, diagnostic)| finding(*at, diagnostic)));
        if found.len() > FINDINGS {
            let more = sentence(&crate::msg!("page.more-findings", count = (found.len() - FINDINGS) as f64));
            rows.push(format!("<li class=\"says info\">{more}</li>"));
        }
        start += line.len() + 1;
    }
    if lines.count() > SHOWN {
        rows.push(format!("<li class=\"says info\">{} {SHOWN} / {}</li>", t("page.first-lines"), lines.count()));
    }
    rows
}

/// The findings of a file by the line that they begin in.
fn by_line<'d>(diagnostics: &'d [Diagnostic], id: FileId, lines: &LineIndex) -> BTreeMap<u32, Vec<Numbered<'d>>> {
    let mut found: BTreeMap<u32, Vec<Numbered>> = BTreeMap::new();
    for (at, diagnostic) in diagnostics.iter().enumerate() {
        if let Some(place) = diagnostic.place.filter(|place| place.file == id) {
            found.entry(lines.line_of(place.span.start)).or_default().push((at, diagnostic));
        }
    }
    found
}

/// The part of a text before a byte, at a character.
fn before(text: &str, byte: usize) -> &str {
    let end = (0..=byte.min(text.len())).rev().find(|at| text.is_char_boundary(*at)).unwrap_or(0);
    text.get(..end).unwrap_or_default()
}

/// The words of a line, coloured and marked; a line that is too long to be read is cut.
fn words(out: &mut String, text: &str, start: usize, control: &Control, found: &[Numbered]) {
    if text.is_empty() {
        out.push(' ');
    }
    let coloured = before(text, COLOURED);
    let mut done = 0;
    for (span, kind) in tokens(coloured, control) {
        // Space between the pieces.
        escape(out, coloured.get(done..span.start as usize).unwrap_or(""));
        done = span.end as usize;
        let (from, to) = (start as u32 + span.start, start as u32 + span.end);
        let bad = found.iter().take(FINDINGS).find(|(_, d)| {
            d.place.is_some_and(|place| place.span.start < to && from < place.span.end.max(place.span.start + 1))
        });
        let class = class(kind);
        let _ = match bad {
            Some((_, d)) => write!(out, "<span class=\"{class} bad-{}\">", Tone::from(d.severity)),
            None if class.is_empty() => Ok(()),
            None => write!(out, "<span class=\"{class}\">"),
        };
        escape(out, span.of(coloured));
        if bad.is_some() || !class.is_empty() {
            out.push_str("</span>");
        }
    }
    let shown = before(text, LONGEST);
    escape(out, shown.get(coloured.len()..).unwrap_or(""));
    if shown.len() < text.len() {
        let _ = write!(out, " … {}", sentence(&crate::msg!("page.bytes", count = (text.len() - shown.len()) as f64)));
    }
}

/// The class of a piece of text.
pub(crate) fn class(kind: TokenKind) -> &'static str {
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

/// HTML of a finding: message, hints, and a button for each fix.
fn finding(at: usize, diagnostic: &Diagnostic) -> String {
    let tone = Tone::from(diagnostic.severity);
    let mut out = format!("<li class=\"says {tone}\"><p><i aria-hidden=\"true\">{}</i> ", tone.sign());
    if let Some(alarm) = &diagnostic.alarm {
        let _ = write!(out, "<b data-means=\"alarms\">{alarm}</b> ");
        if let Some(wording) = diagnostic.wording {
            out.push_str("<q>");
            escape(&mut out, wording.words());
            out.push_str("</q> ");
        }
    }
    escape(&mut out, &sentence(&diagnostic.message));
    for hint in &diagnostic.hints {
        out.push_str(" <em>");
        escape(&mut out, &sentence(hint));
        out.push_str("</em>");
    }
    out.push_str("</p>");
    for (fix, row) in diagnostic.fixes.iter().enumerate() {
        let _ = write!(out, "<button type=\"button\" data-d=\"{at}\" data-fix=\"{fix}\">");
        escape(&mut out, &sentence(&row.title));
        out.push_str("</button>");
    }
    if !diagnostic.is_error() {
        let (id, words) = (diagnostic.message_id(), t("page.silence"));
        let _ = write!(out, "<button type=\"button\" class=\"quiet\" data-silence=\"{id}\">{words}</button>");
        // The help has an entry for each warning about programs.
        if diagnostic.kind.is_lint() {
            let more = t("help.more");
            let _ = write!(out, "<button type=\"button\" class=\"quiet\" data-explain=\"rule.{id}\">{more}</button>");
        }
    }
    out.push_str("</li>");
    out
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::text::{DiagnosticKind, Place, Span};
    use crate::ui::testing::project;

    fn shown(text: &str, found: &[Diagnostic]) -> String {
        rows(&File { name: "O1".to_owned(), text: text.to_owned() }, FileId(0), project().control, found).concat()
    }

    #[wasm_bindgen_test]
    fn lines_are_numbered_and_coloured() {
        let html = shown("G01 X1.\r\n\nM30\n", &[]);
        assert_eq!(html.matches("<li data-l=").count(), 3);
        assert!(html.contains("<span class=\"t-g\">G01</span>"), "{html}");
        assert!(html.contains("<li data-l=\"2\"><code> </code>"), "{html}");
    }

    #[wasm_bindgen_test]
    fn text_of_a_program_is_never_markup() {
        let html = shown("(<script>alert(1)</script>)", &[]);
        assert!(!html.contains("<script"), "{html}");
    }

    #[wasm_bindgen_test]
    fn finding_is_below_its_line_with_a_button_per_fix() {
        let place = Place { file: FileId(0), span: Span { start: 4, end: 7 } };
        let fixed = vec![(place, "X2.".to_owned())];
        let found =
            Diagnostic::warning(crate::msg!("page.not-a-value")).at(place).fix(crate::msg!("page.taken"), fixed);
        let html = shown("G01 X1.\nM30\n", &[found]);
        let (first, second) = (html.find("data-l=\"1\"").unwrap(), html.find("data-l=\"2\"").unwrap());
        let says = html.find("<li class=\"says warn\">").unwrap();
        assert!(first < says && says < second, "{html}");
        assert!(html.contains("data-d=\"0\" data-fix=\"0\"") && html.contains("data-silence="), "{html}");
        assert!(html.contains("bad-warn"), "{html}");
    }

    #[wasm_bindgen_test]
    fn warning_about_a_program_leads_to_its_place_in_the_help() {
        let place = Place { file: FileId(0), span: Span { start: 4, end: 6 } };
        for (kind, leads) in [(DiagnosticKind::Lint, true), (DiagnosticKind::Plain, false)] {
            let html = shown("G01 X1.\n", &[Diagnostic::warning(crate::msg!("lint.feed-zero")).kind(kind).at(place)]);
            assert_eq!(html.contains("data-explain=\"rule.lint.feed-zero\""), leads, "{html}");
        }
    }

    #[wasm_bindgen_test]
    fn error_cannot_be_silenced() {
        let place = Place { file: FileId(0), span: Span { start: 0, end: 3 } };
        let html = shown("G01\n", &[Diagnostic::error(crate::msg!("page.not-a-value")).at(place)]);
        assert!(html.contains("says fail") && !html.contains("data-silence"), "{html}");
    }

    #[wasm_bindgen_test]
    fn many_findings_of_a_line_are_counted_instead() {
        let place = Place { file: FileId(0), span: Span { start: 0, end: 3 } };
        let found = vec![Diagnostic::warning(crate::msg!("page.not-a-value")).at(place); FINDINGS + 5];
        let html = shown("G01\n", &found);
        assert_eq!(html.matches("says warn").count(), FINDINGS);
        assert!(html.contains(&sentence(&crate::msg!("page.more-findings", count = 5.0))), "{html}");
    }
}
