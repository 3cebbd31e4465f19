//! The report and its summary as standalone pages for print on A4 or Letter: a first sheet with title block, then numbered sheets.

mod first_sheet;
mod sections;
mod summary;
mod writer;

use super::document::Report;
use super::references::References;
use writer::ReportHtml;

/// The report as HTML with embedded styles and pictures.
pub fn html(report: &Report) -> String {
    document(report, "form.report.about", |writer| writer.whole())
}

/// The summary for those who decide on the machine, in the form of the report: its first sheet, product, operation, drives to order.
pub fn summary(report: &Report) -> String {
    document(report, "form.summary.about", |writer| writer.summary())
}

/// A document: the first sheet of a report with the catalog text `about` below its title, then the sheets that `behind`
/// writes.
fn document(report: &Report, about: &'static str, behind: impl FnOnce(&mut ReportHtml)) -> String {
    let mut writer = ReportHtml { out: String::new(), report, references: References::default() };
    writer.begin();
    writer.first_sheet(about);
    writer.raw("<main class=\"flow\">");
    behind(&mut writer);
    writer.raw("</main></body></html>\n");
    writer.out
}
