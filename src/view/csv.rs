//! Charts and sheets as comma-separated values, RFC 4180.

use core::fmt::Write;

use super::{Chart, Sheet};
use crate::text::BYTE_ORDER_MARK;
use crate::text::catalog::words;
use crate::text::number::Fixed;

/// The text of a table as a file for spreadsheets. A text beyond ASCII begins with a byte order mark: without it they
/// read the text in the computer’s legacy code page.
pub fn file(text: String) -> String {
    if text.is_ascii() { text } else { format!("{BYTE_ORDER_MARK}{text}") }
}

/// Lines of all charts over time, side by side, with units in the heads. Empty without a line.
pub fn charts(charts: &[Chart]) -> String {
    let over_time = charts.iter().filter(|chart| chart.over_time());
    let lines: Vec<_> = over_time.flat_map(|chart| chart.series.iter().map(move |line| (chart.unit, line))).collect();
    let (Some(first), Some((_, line))) = (charts.first(), lines.first()) else { return String::new() };
    let mut out = format!("t [{}]", first.x_unit());
    for (unit, line) in &lines {
        let _ = write!(out, ",{}", quoted(&format!("{} [{unit}]", words(line.label))));
    }
    out.push_str("\r\n");
    for (row, (x, _)) in line.points.iter().enumerate() {
        let _ = write!(out, "{}", Fixed(*x, 6));
        for (_, line) in &lines {
            match line.points.get(row) {
                Some((_, y)) => {
                    let _ = write!(out, ",{}", Fixed(*y, 6));
                }
                None => out.push(','),
            }
        }
        out.push_str("\r\n");
    }
    file(out)
}

/// A sheet: heads, then rows.
pub fn sheet(sheet: &Sheet) -> String {
    let heads = sheet.columns.iter().map(|column| quoted(words(column.head()))).collect::<Vec<_>>().join(",");
    let rows = sheet.rows.iter().map(|row| row.cells.iter().map(|cell| quoted(cell)).collect::<Vec<_>>().join(","));
    file(core::iter::once(heads).chain(rows).map(|line| line + "\r\n").collect())
}

fn quoted(text: &str) -> String {
    if text.contains([',', '"', '\n', '\r']) { format!("\"{}\"", text.replace('"', "\"\"")) } else { text.to_owned() }
}
