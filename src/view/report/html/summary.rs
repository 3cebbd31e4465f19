//! The sheets behind the first one of a summary: product, operation, limits and drives to order.

use super::writer::ReportHtml;
use crate::view::report::cells::cells_of_input;
use crate::view::report::document::Input;
use crate::view::{Sheet, SheetKind};

/// Number of charts of the run.
const CHARTS: usize = 2;

/// Columns of the bill of materials: item, maker, order number, quantity.
const OF_THE_BILL: usize = 4;

/// Heads of the table of inputs.
const INPUT_COLUMNS: [&str; 3] = ["form.report.input", "form.report.symbol", "form.report.value"];

impl ReportHtml<'_> {
    /// Everything behind the first sheet of the summary.
    pub(super) fn summary(&mut self) {
        let report = self.report;
        self.raw("<div class=\"summary\">");
        self.title("page.essentials");
        let shown = |input: &&Input| input.essential;
        let cells = |input| {
            let [_, label, symbol, value, _] = cells_of_input(report, input);
            [label, symbol, value]
        };
        let rows: Vec<[String; 3]> = report.inputs.iter().filter(shown).map(cells).collect();
        self.table("essentials", &INPUT_COLUMNS, &rows);
        self.operation(CHARTS);
        let of_kind = |kind| report.sizing.tables.iter().find(|sheet| sheet.kind == kind);
        if let Some(limits) = of_kind(SheetKind::Limits) {
            self.first_columns(limits, limits.columns.len());
        }
        if let Some(bill) = of_kind(SheetKind::Bill) {
            self.first_columns(bill, OF_THE_BILL);
        }
        self.findings();
        self.raw("</div>");
    }

    /// A sheet with its first columns, without sources.
    fn first_columns(&mut self, sheet: &Sheet, count: usize) {
        self.title(sheet.title);
        self.raw(&format!("<div class=\"short-{0}\"><table>", sheet.id));
        let heads: Vec<&str> = sheet.columns.iter().take(count).map(|column| column.head()).collect();
        self.head(&heads, None);
        for row in &sheet.rows {
            self.row(row.cells.get(..count).unwrap_or(&row.cells));
        }
        self.raw("</table></div>");
    }
}
