//! The report as a standalone page for print on A4 or Letter: first sheet with frame and title block, then tables on numbered sheets.

use super::cells::{PART_COLUMNS, RESULT_COLUMNS, cells_of_input, cells_of_part, cells_of_result, source_of_row};
use super::conclusion::conclusion;
use super::document::Report;
use super::references::References;
use crate::msg;
use crate::text::catalog::{sentence, spoken, words};
use crate::text::columns;
use crate::text::headed;
use crate::text::number::{decimals_of_four, filled, four_digits, short};
use crate::text::{Grade, Provenance, Severity, clauses};
use crate::view::svg::escape;
use crate::view::{Chart, Column, ComparedRow, Readout, Sheet, Verdict, ladder, plot};

/// The style sheet.
const STYLE: &str = include_str!("../../../style/report.css");

/// The mark of macroline, as in the header of the page.
const MARK: &str = "<svg viewBox=\"0 0 24 24\"><path class=\"web\" d=\"M2 19h20\"/><circle cx=\"12\" cy=\"11\" r=\"7\"/>\
                    <path class=\"web\" d=\"M12 11v7\"/></svg>";

/// Number of variants beside the offer that fit into a table.
const BESIDE: usize = 4;

/// Number of rows of verdicts that fit on the first sheet.
const FIRST: usize = 10;
/// Rows of the parts list that fit beside all [`FIRST`] rows of verdicts; each further row replaces a row of verdicts.
const PARTS: usize = 11;
/// Least number of verdicts on the first sheet.
const LEAST: usize = 4;

/// The report as HTML with embedded styles and pictures.
pub fn html(report: &Report) -> String {
    let mut page = Page { out: String::new(), report, references: References::default() };
    page.whole();
    page.out
}

struct Page<'r> {
    out: String,
    report: &'r Report,
    references: References,
}

impl Page<'_> {
    fn raw(&mut self, html: &str) {
        self.out.push_str(html);
    }

    fn words(&self, id: &'static str) -> &'static str {
        words(id)
    }

    /// Writes an element with a text.
    fn text(&mut self, tag: &str, class: &str, text: &str) {
        self.raw("<");
        self.raw(tag);
        if !class.is_empty() {
            self.raw(&format!(" class=\"{class}\""));
        }
        self.raw(">");
        escape(&mut self.out, text);
        self.raw(&format!("</{tag}>"));
    }

    fn title(&mut self, id: &'static str) {
        self.text("h2", "", self.words(id));
    }

    fn list(&mut self, messages: impl IntoIterator<Item = String>) {
        self.raw("<ul>");
        for message in messages {
            self.text("li", "", &message);
        }
        self.raw("</ul>");
    }

    fn whole(&mut self) {
        let report = self.report;
        self.raw(&format!("<!DOCTYPE html>\n<html lang=\"{}\"><head><meta charset=\"utf-8\"/>", spoken().code()));
        self.raw("<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>");
        self.text("title", "", &report.title);
        self.raw("<style>");
        self.raw(STYLE);
        let strip = self.strip();
        self.raw(&strip);
        self.raw("</style></head><body>");
        self.first_sheet();
        self.raw("<main class=\"flow\">");
        self.findings();
        for sheet in &report.sizing.tables {
            self.sheet(sheet);
        }
        self.variants();
        self.results();
        self.run();
        self.inputs();
        for sheet in &report.sheets {
            self.sheet(sheet);
        }
        self.programs();
        self.title("form.report.open");
        let open = report.open.iter().map(|open| headed(self.words(open.kind), clauses(&open.facts)));
        let open: Vec<_> = open.collect();
        self.list(open);
        self.sources();
        self.raw("</main></body></html>\n");
    }

    /// All results, with formulas and the numbers of their sources.
    fn results(&mut self) {
        let report = self.report;
        self.title("form.report.results");
        self.raw("<table class=\"results\">");
        self.head(&RESULT_COLUMNS, None);
        for readout in &report.readouts {
            let [cells @ .., source] = cells_of_result(report, readout);
            self.raw("<tr>");
            cells.iter().for_each(|text| cell(&mut self.out, text));
            self.reference(&source, readout.cite.grade);
            self.raw("</tr>");
        }
        self.raw("</table>");
    }

    /// All inputs, a table for each group.
    fn inputs(&mut self) {
        let report = self.report;
        self.title("form.report.inputs");
        self.raw("<div class=\"inputs\">");
        for group in report.inputs.chunk_by(|a, b| a.group == b.group) {
            let rows: Vec<_> = group.iter().map(|row| cells_of_input(report, row)).collect();
            self.raw("<table>");
            for (at, [title, cells @ ..]) in rows.iter().enumerate() {
                if at == 0 {
                    self.text("caption", "", title);
                }
                self.row(cells);
            }
            self.raw("</table>");
        }
        self.raw("</div>");
    }

    /// Writes a cell with the number of a source, which leads to the list at the end; `?` for a source that is not confirmed.
    fn reference(&mut self, source: &str, grade: Grade) {
        self.raw("<td class=\"ref\">");
        if !source.is_empty() {
            let number = self.references.number(source);
            let doubt = if grade == Grade::Open { "\u{a0}?" } else { "" };
            self.raw(&format!("<a href=\"#source-{number}\">{number}</a>{doubt}"));
        }
        self.raw("</td>");
    }

    /// The sources by their numbers.
    fn sources(&mut self) {
        self.title("form.report.sources");
        self.text("p", "dim", self.words("form.report.about-sources"));
        self.raw("<ol class=\"sources\">");
        for (number, source) in (1..).zip(core::mem::take(&mut self.references).sources()) {
            self.raw(&format!("<li id=\"source-{number}\">"));
            escape(&mut self.out, &source);
            self.raw("</li>");
        }
        self.raw("</ol>");
    }

    /// Heading, conclusion, drawing, verdicts and title block.
    fn first_sheet(&mut self) {
        let report = self.report;
        self.raw("<section class=\"sheet\">");
        self.frame();
        self.raw("<header><div>");
        self.text("h1", "", &report.title);
        self.text("p", "dim", self.words("form.report.about"));
        self.raw(&format!("</div><b class=\"maker\">{MARK}macroline</b></header>"));
        self.raw("<p class=\"conclusion\">");
        self.raw(&conclusion(report));
        self.raw("</p>");
        self.raw("<figure class=\"drawing\">");
        self.raw(&report.run.drawing);
        self.text("figcaption", "dim", &sentence(&msg!("form.report.drawn-at", time = (report.run.drawn_at, 1))));
        self.raw("</figure>");
        self.title("form.report.verdicts");
        let columns = [
            "form.report.result",
            "form.report.value",
            "form.report.unit",
            "form.report.against",
            "form.report.limit",
            "form.report.remedy",
        ];
        self.raw("<table class=\"verdicts\">");
        self.head(&columns, Some(""));
        for readout in first_rows(report) {
            self.verdict(readout);
        }
        self.raw("</table><footer><div>");
        self.parts();
        self.assumed();
        self.raw("</div>");
        self.block();
        self.raw("</footer></section>");
    }

    /// Frame with zones for references to places in the drawing: four across and six down on A4. Source: ISO 5457, from memory.
    fn frame(&mut self) {
        self.raw("<div class=\"frame\" aria-hidden=\"true\">");
        for (class, zones) in [("across", ["1", "2", "3", "4"].as_slice()), ("down", &["A", "B", "C", "D", "E", "F"])] {
            self.raw("<p class=\"");
            self.raw(class);
            self.raw("\">");
            zones.iter().for_each(|zone| self.text("span", "", zone));
            self.raw("</p>");
        }
        self.raw("</div>");
    }

    fn head(&mut self, columns: &[&'static str], before: Option<&str>) {
        self.raw("<thead><tr>");
        if let Some(text) = before {
            self.text("th", "", text);
        }
        for id in columns {
            self.text("th", "", self.words(id));
        }
        self.raw("</tr></thead>");
    }

    fn verdict(&mut self, readout: &Readout) {
        let (class, sign) = match readout.verdict {
            Verdict::Fail => ("fail", "✕"),
            Verdict::Warn => ("warn", "△"),
            Verdict::Ok => ("ok", "✓"),
            Verdict::None => ("", ""),
        };
        self.raw(&format!("<tr class=\"{class}\">"));
        self.text("td", "sign", sign);
        self.text("td", "", self.words(readout.label));
        self.text("td", "figure", &four_digits(readout.value, readout.decimals));
        self.text("td", "", readout.unit);
        self.raw("<td>");
        if let Some((part, limit)) = readout.bar() {
            // In units of the view box, 100 wide.
            let bar = filled(
                "<svg class=\"bar\" viewBox=\"0 0 100 9\"><path class=\"rest\" d=\"M0 2H100V7H0z\"/><path class=\"part\" d=\"M0 2H#V7H0z\"/><path class=\"limit\" d=\"M# 0V9\"/></svg>",
                &[part, limit],
            );
            self.raw(&bar);
        }
        self.raw("</td>");
        let limit = readout.limit.map_or(String::new(), |limit| {
            let decimals = decimals_of_four(limit.value(), readout.decimals);
            sentence(&limit.message(short(limit.value(), decimals)))
        });
        self.text("td", "", &limit);
        let repair = readout.advice.iter().find_map(|advice| advice.button.as_ref());
        let repair = repair.map_or(String::new(), sentence);
        self.text("td", "", &repair);
        self.raw("</tr>");
    }

    /// Parts list, with the item numbers of the drawing's balloons.
    fn parts(&mut self) {
        if self.report.parts.is_empty() {
            return;
        }
        self.title("form.report.parts");
        let rows: Vec<_> = (1..).zip(&self.report.parts).map(|(item, part)| cells_of_part(item, part)).collect();
        self.table("parts", &PART_COLUMNS, &rows);
    }

    /// Share of the machine's facts that are only assumed.
    fn assumed(&mut self) {
        let facts = self.report.inputs.iter().filter_map(|input| input.origin);
        let (all, assumed) = facts.fold((0_u32, 0_u32), |(all, assumed), origin| {
            (all + 1, assumed + u32::from(origin == Provenance::Assumed))
        });
        if assumed > 0 {
            self.text("p", "assumed", &sentence(&msg!("form.report.assumed-facts", count = assumed, all)));
        } else {
            self.raw("<p></p>");
        }
    }

    /// Title block, with the fields of ISO 7200: title, customer, project, author, date, number, revision.
    fn block(&mut self) {
        let report = self.report;
        self.raw("<dl class=\"block\">");
        // Twelve columns; the number is the width of an entry in columns. The style sheet adds the count of sheets to the sheet number.
        let entries = [
            (12, "form.report.title", report.title.as_str()),
            (8, "form.report.customer", &report.customer),
            (4, "form.report.project", &report.project),
            (4, "form.report.date", &report.date),
            (4, "form.report.author", &report.block.author),
            (4, "form.report.checked", ""),
            (8, "form.report.number", &report.block.number),
            (4, "form.report.revision", &report.block.revision),
            (5, "form.report.checksum", &report.checksum),
            (4, "form.report.version", env!("CARGO_PKG_VERSION")),
            (3, "form.report.sheet", "1"),
        ];
        for (columns, label, value) in entries {
            self.raw(&format!("<div class=\"w{columns}\">"));
            self.text("dt", "", self.words(label));
            self.text("dd", "", if value.is_empty() { "\u{a0}" } else { value });
            self.raw("</div>");
        }
        self.raw("</dl>");
    }

    /// Errors and remarks about fields and program, then the advice of the verdicts.
    fn findings(&mut self) {
        let report = self.report;
        let all = report.diagnostics.iter().chain(&report.sizing.exceeded);
        let told = all.filter(|found| found.severity != Severity::Info);
        let mut said: Vec<String> = told.map(|found| sentence(&found.message)).collect();
        for readout in report.readouts.iter().filter(|readout| readout.verdict >= Verdict::Warn) {
            let label = self.words(readout.label);
            said.extend(readout.advice.iter().map(|advice| headed(label, sentence(&advice.message))));
        }
        if !said.is_empty() {
            self.title("form.report.findings");
            self.list(said);
        }
    }

    fn table<const N: usize>(&mut self, class: &str, columns: &[&'static str; N], rows: &[[String; N]]) {
        self.raw(&format!("<table class=\"{class}\">"));
        self.head(columns, None);
        for row in rows {
            self.row(row);
        }
        self.raw("</table>");
    }

    fn row(&mut self, cells: &[String]) {
        self.raw("<tr>");
        for text in cells {
            cell(&mut self.out, text);
        }
        self.raw("</tr>");
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

    /// Figures of the run, and its charts.
    fn run(&mut self) {
        let report = self.report;
        if report.run.figures.is_empty() && report.run.charts.is_empty() {
            return;
        }
        self.title("form.report.run");
        let figures = report.run.figures.iter().map(|row| headed(self.words(row.label), row.shown()));
        let figures: Vec<_> = figures.collect();
        self.list(figures);
        for chart in &report.run.charts {
            self.chart(chart);
        }
    }

    fn chart(&mut self, chart: &Chart) {
        self.raw("<figure class=\"chart\"><figcaption>");
        self.text("b", "", self.words(chart.title));
        self.text("span", "dim", &format!(" {}", chart.unit));
        for line in &chart.series {
            self.text("span", &format!("tone tone-{}", line.tone), self.words(line.label));
        }
        self.raw("</figcaption>");
        self.raw(&plot::svg(chart));
        self.raw("</figure>");
    }

    fn sheet(&mut self, sheet: &Sheet) {
        self.raw(&format!("<section class=\"of-{}\">", sheet.id));
        self.title(sheet.title);
        // Long lists of short rows flow in columns of the page, which a table itself cannot.
        self.raw(&format!("<div class=\"rows\"><table class=\"{}\">", sheet.id));
        let mut heads: Vec<&str> = sheet.columns.iter().map(|column| column.head()).collect();
        // A source common to all rows is given once.
        let common = sheet.common_source();
        let own = sheet.columns.iter().position(|column| matches!(column, Column::Source(_)));
        if common.is_none() && own.is_none() {
            heads.push("form.report.source");
        }
        self.head(&heads, None);
        for row in &sheet.rows {
            self.raw("<tr>");
            for (at, text) in row.cells.iter().enumerate() {
                if Some(at) == own {
                    self.reference(text, Grade::Manual);
                } else {
                    cell(&mut self.out, text);
                }
            }
            if common.is_none() && own.is_none() {
                self.reference(&row.source.to_string(), row.grade);
            }
            self.raw("</tr>");
        }
        self.raw("</table></div>");
        if let Some(row) = common {
            let source = source_of_row(row);
            self.text("p", "dim source", &source);
        }
        if !sheet.drawing.is_empty() {
            let pieces = ladder::pieces(&sheet.drawing);
            self.raw(if pieces.len() > 1 { "<figure class=\"sketch rungs\">" } else { "<figure class=\"sketch\">" });
            pieces.iter().for_each(|piece| self.raw(piece));
            self.raw("</figure>");
        }
        self.raw("</section>");
    }

    /// Rows in which the variants differ from the offer or from each other; variants beyond the width of a table have further tables.
    fn variants(&mut self) {
        let Some(comparison) = &self.report.variants else { return };
        self.title("variants.title");
        let groups = comparison.differences();
        if groups.is_empty() {
            self.text("p", "", self.words("variants.same"));
            return;
        }
        let kept: Vec<usize> = (1..comparison.names.len()).collect();
        for beside in kept.chunks(BESIDE) {
            let shown: Vec<usize> = [0].iter().chain(beside).copied().collect();
            self.raw("<table class=\"compared\"><thead><tr>");
            self.text("th", "", self.words("variants.row"));
            shown.iter().filter_map(|at| comparison.names.get(*at)).for_each(|name| self.text("th", "", name));
            self.raw("</tr></thead>");
            for (title, rows) in &groups {
                let mut rows = rows.iter().filter(|row| shown.iter().any(|at| row.differs_at(*at))).peekable();
                if rows.peek().is_none() {
                    continue;
                }
                self.raw(&format!("<tr><th colspan=\"{}\">", shown.len() + 1));
                let title = self.words(title);
                escape(&mut self.out, title);
                self.raw("</th></tr>");
                rows.for_each(|row| self.compared(row, &shown));
            }
            self.raw("</table>");
        }
    }

    /// A row of variants; cells that differ from the offer are marked.
    fn compared(&mut self, row: &ComparedRow, shown: &[usize]) {
        self.raw("<tr><td>");
        escape(&mut self.out, &row.label);
        self.text("span", "dim", &format!(" {}", row.unit));
        self.raw("</td>");
        let cells = row.marked();
        for at in shown {
            let text = cells.get(*at).map_or("", String::as_str);
            self.text("td", if row.differs_at(*at) { "differs" } else { "" }, text);
        }
        self.raw("</tr>");
    }

    /// Loading instructions of the programs, then their texts.
    fn programs(&mut self) {
        let report = self.report;
        self.title("form.report.programs");
        let loading: Vec<_> = report.loading.iter().map(sentence).collect();
        self.list(loading);
        for program in &report.programs {
            self.raw("<h3>");
            escape(&mut self.out, &program.name);
            self.text("span", "dim", &format!(" CRC-32 {}", program.checksum));
            self.raw("</h3>");
            self.text("pre", "", &program.text);
        }
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
fn cell(out: &mut String, text: &str) {
    let is_figure = text.starts_with(|c: char| c.is_ascii_digit() || "+-−±≤≥=✕".contains(c));
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

/// The verdicts of the first sheet: the worst first, then the headline results, then others.
fn first_rows(report: &Report) -> Vec<&Readout> {
    let judged = report.readouts.iter().filter(|readout| readout.headline || readout.verdict != Verdict::None);
    let mut rows: Vec<&Readout> = judged.collect();
    rows.sort_by_key(|readout| (core::cmp::Reverse(readout.verdict.max(Verdict::Ok)), !readout.headline));
    rows.truncate(FIRST.saturating_sub(report.parts.len().saturating_sub(PARTS)).max(LEAST));
    rows
}
