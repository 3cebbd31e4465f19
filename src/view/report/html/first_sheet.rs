//! The first sheet of a report: conclusion, drawing, verdicts, parts and title block in a frame.

use super::writer::ReportHtml;
use crate::msg;
use crate::text::catalog::sentence;
use crate::text::number::{decimals_of_four, filled, short};
use crate::text::{Message, Provenance};
use crate::view::report::Report;
use crate::view::report::cells::{PART_COLUMNS, cells_of_part};
use crate::view::report::conclusion::conclusion;
use crate::view::{Readout, Verdict};

/// The mark of macroline, as in the header of the page.
const MARK: &str = "<svg viewBox=\"0 0 24 24\"><path class=\"web\" d=\"M2 19h20\"/><circle cx=\"12\" cy=\"11\" r=\"7\"/>\
                    <path class=\"web\" d=\"M12 11v7\"/></svg>";

/// Number of rows of verdicts that fit on the first sheet.
const FIRST: usize = 10;
/// Rows of the parts list that fit beside all [`FIRST`] rows of verdicts; each further row replaces a row of verdicts.
const PARTS: usize = 11;
/// Least number of verdicts on the first sheet.
const LEAST: usize = 4;

impl ReportHtml<'_> {
    /// Heading, conclusion, drawing, verdicts and title block.
    pub(super) fn first_sheet(&mut self, about: &'static str) {
        let report = self.report;
        self.raw("<section class=\"sheet\">");
        self.frame();
        self.raw("<header><div>");
        self.text("h1", "", &report.title);
        self.text("p", "dim", self.words(about));
        self.raw(&format!("</div><b class=\"maker\">{MARK}macroline</b></header>"));
        self.raw("<p class=\"conclusion\">");
        self.raw(&conclusion(report));
        self.raw("</p>");
        self.raw("<figure class=\"drawing\">");
        self.raw(&report.run.drawing);
        self.text("figcaption", "dim", &sentence(&msg!("form.report.drawn-at", time = (report.run.drawn_at, 1))));
        self.raw("</figure>");
        self.title("form.report.verdicts");
        let mut columns = vec![
            "form.report.result",
            "form.report.value",
            "form.report.unit",
            "form.report.against",
            "form.report.limit",
        ];
        let rows = first_rows(report);
        let has_remedies = rows.iter().any(|readout| remedy(readout).is_some());
        columns.extend(has_remedies.then_some("form.report.remedy"));
        self.raw("<table class=\"verdicts\">");
        self.head(&columns, Some(""));
        for readout in rows {
            self.verdict(readout, has_remedies);
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

    fn verdict(&mut self, readout: &Readout, has_remedies: bool) {
        let class = match readout.verdict {
            Verdict::Fail => "fail",
            Verdict::Warn => "warn",
            Verdict::Ok => "ok",
            Verdict::None => "",
        };
        self.raw(&format!("<tr class=\"{class}\">"));
        self.text("td", "sign", readout.verdict.sign());
        self.text("td", "", self.words(readout.label));
        self.text("td", "figure", &readout.value_text());
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
        if has_remedies {
            self.text("td", "", &remedy(readout).map_or(String::new(), sentence));
        }
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
}

/// Text of the button of the first advice that has one.
fn remedy(readout: &Readout) -> Option<&Message> {
    readout.advice.iter().find_map(|advice| advice.button.as_ref())
}

/// The verdicts of the first sheet: the worst first, then the headline results, then others.
fn first_rows(report: &Report) -> Vec<&Readout> {
    let judged = report.readouts.iter().filter(|readout| readout.headline || readout.verdict != Verdict::None);
    let mut rows: Vec<&Readout> = judged.collect();
    rows.sort_by_key(|readout| (core::cmp::Reverse(readout.verdict.max(Verdict::Ok)), !readout.headline));
    rows.truncate(FIRST.saturating_sub(report.parts.len().saturating_sub(PARTS)).max(LEAST));
    rows
}
