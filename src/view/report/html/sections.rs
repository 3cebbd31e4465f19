//! Sections of a report: findings, results, operation, inputs, sheets, variants, programs, sources.

use super::writer::{ReportHtml, cell};
use crate::text::catalog::sentence;
use crate::text::{Grade, Severity, clauses, headed};
use crate::view::report::cells::{
    RESULT_COLUMNS, SETTING_COLUMNS, cells_of_input, cells_of_result, cells_of_setting, source_of_row,
};
use crate::view::svg::escape;
use crate::view::{Chart, Column, ComparedRow, Sheet, Verdict, ladder, plot};

/// Number of variants beside the offer that fit into a table.
const BESIDE: usize = 4;

impl ReportHtml<'_> {
    /// Everything behind the first sheet of the report.
    pub(super) fn whole(&mut self) {
        let report = self.report;
        self.findings();
        for sheet in &report.sizing.tables {
            self.sheet(sheet);
        }
        self.variants();
        self.results();
        self.operation(usize::MAX);
        self.inputs();
        for sheet in &report.sheets {
            self.sheet(sheet);
        }
        self.programs();
        self.open_points();
        self.sources();
    }

    /// Settings and facts of the control that no manual confirms.
    fn open_points(&mut self) {
        let open = &self.report.open;
        self.title("form.report.open");
        if !open.settings.is_empty() {
            self.raw("<table class=\"settings\">");
            self.head(&SETTING_COLUMNS, None);
            for setting in &open.settings {
                self.raw("<tr>");
                cells_of_setting(setting).iter().for_each(|text| cell(&mut self.out, text));
                self.reference(setting.cite.source.words(), setting.cite.grade);
                self.raw("</tr>");
            }
            self.raw("</table>");
        }
        let facts: Vec<_> = open.facts.iter().map(|open| headed(self.words(open.kind), clauses(&open.facts))).collect();
        self.list(facts);
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

    /// Errors and remarks about fields and program, then the advice of the verdicts.
    pub(super) fn findings(&mut self) {
        let report = self.report;
        let all = report.diagnostics.iter().chain(&report.sizing.exceeded);
        let findings = all.filter(|found| found.severity != Severity::Info);
        let mut sentences: Vec<String> = findings.map(|found| sentence(&found.message)).collect();
        for readout in report.readouts.iter().filter(|readout| readout.verdict >= Verdict::Warn) {
            let label = self.words(readout.label);
            sentences.extend(readout.advice.iter().map(|advice| headed(label, sentence(&advice.message))));
        }
        if !sentences.is_empty() {
            self.title("form.report.findings");
            self.list(sentences);
        }
    }

    /// Figures of the run, and its first charts.
    pub(super) fn operation(&mut self, charts: usize) {
        let report = self.report;
        if report.run.figures.is_empty() && report.run.charts.is_empty() {
            return;
        }
        self.title("form.report.run");
        let figures = report.run.figures.iter().map(|row| headed(self.words(row.label), row.shown()));
        let figures: Vec<_> = figures.collect();
        self.list(figures);
        for chart in report.run.charts.iter().take(charts) {
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
