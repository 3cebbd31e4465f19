//! Writing the HTML of a report: the head with styles, and the elements of which sheets and sections consist.

use crate::text::Grade;
use crate::text::catalog::{spoken, words};
use crate::text::columns;
use crate::view::Verdict;
use crate::view::report::document::Report;
use crate::view::report::references::References;
use crate::view::svg::escape;

/// The style sheet.
const STYLE: &str = include_str!("../../../../style/report.css");

/// The HTML of a report while it is written.
pub(super) struct ReportHtml<'r> {
    /// HTML written so far.
    pub(super) out: String,
    /// The report.
    pub(super) report: &'r Report,
    /// Sources of the rows so far.
    pub(super) references: References,
}

impl ReportHtml<'_> {
    pub(super) fn raw(&mut self, html: &str) {
        self.out.push_str(html);
    }

    pub(super) fn words(&self, id: &'static str) -> &'static str {
        words(id)
    }

    /// Writes an element with a text.
    pub(super) fn text(&mut self, tag: &str, class: &str, text: &str) {
        self.raw("<");
        self.raw(tag);
        if !class.is_empty() {
            self.raw(&format!(" class=\"{class}\""));
        }
        self.raw(">");
        escape(&mut self.out, text);
        self.raw(&format!("</{tag}>"));
    }

    pub(super) fn title(&mut self, id: &'static str) {
        self.text("h2", "", self.words(id));
    }

    pub(super) fn list(&mut self, messages: impl IntoIterator<Item = String>) {
        self.raw("<ul>");
        for message in messages {
            self.text("li", "", &message);
        }
        self.raw("</ul>");
    }

    /// The begin of the document, with its styles.
    pub(super) fn begin(&mut self) {
        let report = self.report;
        self.raw(&format!("<!DOCTYPE html>\n<html lang=\"{}\"><head><meta charset=\"utf-8\"/>", spoken().code()));
        self.raw("<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>");
        self.text("title", "", &report.title);
        self.raw("<style>");
        self.raw(STYLE);
        let strip = self.strip();
        self.raw(&strip);
        self.raw("</style></head><body>");
    }

    /// Footer of every sheet after the first, as a rule of the style sheet: title, then number, revision, date and sheet number.
    fn strip(&self) -> String {
        let report = self.report;
        let named = |id, value: &str| (!value.is_empty()).then(|| format!("{} {value}", self.words(id)));
        let above = [
            named("form.report.number", &report.block.number),
            named("form.report.revision", &report.block.revision),
            Some(report.date.clone()).filter(|date| !date.is_empty()),
        ];
        let above: Vec<String> = above.into_iter().flatten().collect();
        let (title, above) = (css_text(&report.title), css_text(&above.join(" · ")));
        let line = if above.is_empty() { "" } else { "\\a " };
        let sheet = css_text(self.words("form.report.sheet"));
        format!(
            "@page {{ @bottom-left {{ content: \"{title}\"; }} @bottom-right {{ content: \"{above}{line}{sheet} \" counter(page) \" / \" counter(pages); }} }}\n"
        )
    }

    /// Writes a cell with the number of a source, which leads to the list at the end; `?` for a source that is not confirmed.
    pub(super) fn reference(&mut self, source: &str, grade: Grade) {
        self.raw("<td class=\"ref\">");
        if !source.is_empty() {
            let number = self.references.number(source);
            let doubt = if grade == Grade::Open { "\u{a0}?" } else { "" };
            self.raw(&format!("<a href=\"#source-{number}\">{number}</a>{doubt}"));
        }
        self.raw("</td>");
    }

    pub(super) fn head(&mut self, columns: &[&'static str], before: Option<&str>) {
        self.raw("<thead><tr>");
        if let Some(text) = before {
            self.text("th", "", text);
        }
        for id in columns {
            self.text("th", "", self.words(id));
        }
        self.raw("</tr></thead>");
    }

    pub(super) fn table<const N: usize>(&mut self, class: &str, columns: &[&'static str; N], rows: &[[String; N]]) {
        self.raw(&format!("<table class=\"{class}\">"));
        self.head(columns, None);
        for row in rows {
            self.row(row);
        }
        self.raw("</table>");
    }

    pub(super) fn row(&mut self, cells: &[String]) {
        self.raw("<tr>");
        for text in cells {
            cell(&mut self.out, text);
        }
        self.raw("</tr>");
    }
}

/// Columns of a cell of one or two words that stays on one line.
const WORD: usize = 12;
/// Columns of a figure with its unit that stays on one line.
const FIGURE: usize = 24;
/// Letters from which on a name without spaces may break, because no column is wider.
const NAME: usize = 24;

/// Writes a cell. Figures, single words and order numbers stay on one line, a figure stays with its unit; only a very long name without
/// spaces breaks.
pub(super) fn cell(out: &mut String, text: &str) {
    let signs = [Verdict::Fail, Verdict::Warn].map(Verdict::sign);
    let is_figure = text.starts_with(|c: char| c.is_ascii_digit() || "+-−±≤≥=".contains(c))
        || signs.iter().any(|sign| text.starts_with(sign));
    let whole = columns(text) <= if is_figure { FIGURE } else { WORD };
    out.push_str(if whole { "<td class=\"whole\">" } else { "<td>" });
    for (at, word) in with_units(text).split(' ').enumerate() {
        if at > 0 {
            out.push(' ');
        }
        // Chinese text breaks between any two characters.
        let class = match word.chars().filter(char::is_ascii).count() {
            NAME.. => "name",
            _ if word.contains('-') && word.contains(|c: char| c.is_ascii_digit()) => "whole",
            _ => "",
        };
        if class.is_empty() {
            escape(out, word);
        } else {
            out.push_str(&format!("<span class=\"{class}\">"));
            for (at, part) in word.split_inclusive('_').enumerate() {
                out.push_str(if at > 0 && class == "name" { "<wbr/>" } else { "" });
                escape(out, part);
            }
            out.push_str("</span>");
        }
    }
    out.push_str("</td>");
}

/// A text with each number kept on one line with its unit: `1200 r/min`, `50 : 1`.
fn with_units(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut rest = text.chars().peekable();
    let (mut last, mut before_last) = (' ', ' ');
    while let Some(c) = rest.next() {
        let of_number = last.is_ascii_digit() && rest.peek().is_some_and(|next| !next.is_ascii_digit() && *next != '(');
        let of_ratio = last == ':' && before_last == '\u{a0}';
        let c = if c == ' ' && (of_number || of_ratio) { '\u{a0}' } else { c };
        out.push(c);
        (before_last, last) = (last, c);
    }
    out
}

/// A text for quotation marks of a style sheet within a page: all but letters, digits and plain marks are escaped as numbers.
fn css_text(text: &str) -> String {
    let plain = |c: char| c.is_alphanumeric() || " .,:;/()-·".contains(c);
    text.chars().map(|c| if plain(c) { c.to_string() } else { format!("\\{:x} ", u32::from(c)) }).collect()
}
