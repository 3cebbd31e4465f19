//! Sheets as HTML for the page.

use crate::msg;
use crate::project::Project;
use crate::project::meaning::{self, Subject, Table};
use crate::project::size::sections::SizingSection;
use crate::text::{Grade, columns, headed};
use crate::ui::words::{sentence, t};
use crate::view::svg::escape;
use crate::view::{Column, Row, Sheet, SheetKind};

/// The sheets of a section. Its first sheet needs no title beside that of the section; every event of operation is folded below the worst.
pub(super) fn section_html(section: &SizingSection, project: &Project) -> String {
    let mut out = String::new();
    for (at, sheet) in section.sheets.iter().enumerate() {
        match (section.sheets.first().map(|first| first.kind), at) {
            (_, 0) => table(&mut out, sheet, project),
            (Some(SheetKind::Worst), _) => folded(&mut out, t("page.all-events"), |out| table(out, sheet, project)),
            _ => html(&mut out, sheet, project),
        }
    }
    out
}

/// Number of rows above which a list that repeats a drawing is folded.
const FOLDED: usize = 12;

/// Products of a choice that are shown, suitable ones first; more than one below them are folded.
const OFFERED: usize = 5;

/// Opens a tag with the title of a sheet as its name.
fn titled(out: &mut String, tag: &str, sheet: &Sheet) {
    out.push_str(tag);
    out.push_str(" aria-label=\"");
    escape(out, t(sheet.title));
    out.push_str("\">");
}

/// Writes content that is shown when it is opened.
fn folded(out: &mut String, summary: &str, write: impl FnOnce(&mut String)) {
    out.push_str("<details>");
    tagged(out, "summary", summary);
    write(out);
    out.push_str("</details>");
}

/// Writes a sheet with its title.
pub(super) fn html(out: &mut String, sheet: &Sheet, project: &Project) {
    tagged(out, "h3", t(sheet.title));
    table(out, sheet, project);
}

/// Writes the drawing and the rows of a sheet.
pub(super) fn table(out: &mut String, sheet: &Sheet, project: &Project) {
    if !sheet.drawing.is_empty() {
        titled(out, "<div role=\"img\"", sheet);
        out.push_str(&sheet.drawing);
        out.push_str("</div>");
    }
    if !sheet.drawing.is_empty() && sheet.rows.len() > FOLDED {
        folded(out, t("page.as-table"), |out| rows(out, sheet, &sheet.rows, project));
    } else {
        offered(out, sheet, project);
    }
}

/// Writes the rows of a sheet; of a choice the first products, and the others folded.
fn offered(out: &mut String, sheet: &Sheet, project: &Project) {
    let lead = sheet.rows.iter().take_while(|row| row.entries.is_empty()).count();
    let shown = match sheet.kind {
        SheetKind::Choice if sheet.rows.len() > lead + OFFERED + 1 => lead + OFFERED,
        _ => sheet.rows.len(),
    };
    let (first, others) = sheet.rows.split_at(shown);
    rows(out, sheet, first, project);
    if !others.is_empty() {
        let words = sentence(&msg!("page.more-products", count = others.len() as u32));
        folded(out, &words, |out| rows(out, sheet, others, project));
    }
}

/// Writes a bill of materials: each item with its part, its open questions, and the source of its data.
fn bill(out: &mut String, sheet: &Sheet) {
    titled(out, "<ul class=\"bill\"", sheet);
    for row in &sheet.rows {
        let [item, maker, model, quantity, status, to_settle, grade, source] = row.cells.as_slice() else { continue };
        out.push_str("<li>");
        tagged(out, "h3", item);
        tagged(out, "b", &format!("{quantity}\u{a0}×"));
        // An item that is still open has neither part nor source.
        if maker.is_empty() && model == t("size.grade.open") {
            tagged(out, "p", to_settle);
        } else {
            out.push_str("<p>");
            escape(out, maker);
            out.push(' ');
            tagged(out, "b", model);
            out.push_str("</p>");
            [to_settle, status].into_iter().filter(|text| !text.is_empty()).for_each(|text| tagged(out, "p", text));
            tagged(out, "small", &format!("{source} · {grade}"));
        }
        out.push_str("</li>");
    }
    out.push_str("</ul>");
}

/// Writes rows of a sheet.
fn rows(out: &mut String, sheet: &Sheet, listed: &[Row], project: &Project) {
    if sheet.kind == SheetKind::Bill {
        return bill(out, sheet);
    }
    titled(out, "<div class=\"scroll\" tabindex=\"0\" role=\"group\"", sheet);
    // Columns without a value are left out.
    let some = |at: &usize| sheet.rows.iter().any(|row| row.cells.get(*at).is_some_and(|cell| !cell.is_empty()));
    let shown: Vec<usize> = (0..sheet.columns.len()).filter(some).collect();
    // In a narrow layout, prose after many columns goes below them: see `.stacked`.
    let prose = matches!(sheet.columns.last(), Some(Column::Prose(_))) && shown.len() > 3;
    // In a narrow layout, sentences in several columns go below one another, each with its head: see `.told`.
    let has_sentences = !prose && shown.iter().filter(|at| longest(sheet, **at) > SENTENCE).count() > 2;
    // In a narrow layout, more columns than fit go below one another, each with its head: see `.dense`.
    let is_dense = !prose && !has_sentences && shown.len() > IN_A_ROW;
    let has_heads = has_sentences || is_dense;
    let are_long: Vec<bool> = shown.iter().map(|at| is_dense && longest(sheet, *at) > SENTENCE).collect();
    // A source that all rows share is shown once.
    let common = sheet.common_source().filter(|_| !has_sentences);
    out.push_str("<table class=\"sheet");
    if has_sentences {
        out.push_str(" told");
    } else if is_dense {
        out.push_str(" dense");
    } else if prose {
        out.push_str(&format!(" stacked n{}", shown.len() - 1));
        out.push_str(if common.is_some() { " ungraded" } else { "" });
    } else if shown.first().is_some_and(|at| longest(sheet, *at) > ONE_LINE) {
        out.push_str(" wraps");
    }
    out.push_str("\"><thead><tr>");
    let heads = shown.iter().filter_map(|at| sheet.columns.get(*at)).map(|column| column.head());
    for head in heads.chain(common.is_none().then_some("page.grade")) {
        out.push_str("<th scope=\"col\">");
        escape(out, t(head));
        out.push_str("</th>");
    }
    out.push_str("</tr></thead><tbody>");
    for row in listed {
        let cells: Vec<(Option<&Column>, &String)> =
            shown.iter().filter_map(|at| Some((sheet.columns.get(*at), row.cells.get(*at)?))).collect();
        match cells.as_slice() {
            [(column, first), rest @ ..] if !row.entries.is_empty() => {
                offer(out, row, column.filter(|_| is_dense), first);
                for ((column, cell), is_long) in rest.iter().zip(are_long.iter().skip(1)) {
                    out.push_str(if *is_long { "<td class=\"long\">" } else { "<td>" });
                    head_of(out, column.filter(|_| is_dense));
                    escape(out, cell);
                    out.push_str("</td>");
                }
            }
            cells => {
                out.push_str("<tr>");
                for (column, cell) in cells {
                    table_cell(out, *column, cell, has_heads, project);
                }
            }
        }
        if common.is_none() {
            graded(out, "td", row);
        }
        out.push_str("</tr>");
    }
    out.push_str("</tbody></table></div>");
    if let Some(row) = common {
        graded(out, "p", row);
    }
}

/// Writes the head of a column into a cell of it.
fn head_of(out: &mut String, column: Option<&Column>) {
    if let Some(column) = column {
        tagged(out, "small", t(column.head()));
    }
}

/// Opens a row whose entries the form can take, with its first cell as a button, below the head of its column if that is given.
fn offer(out: &mut String, row: &Row, column: Option<&Column>, first: &str) {
    let entries: Vec<String> = row.entries.iter().map(|entry| format!("{}={}", entry.field, entry.text)).collect();
    out.push_str("<tr data-entries=\"");
    escape(out, &entries.join("\n"));
    out.push_str("\"><td>");
    head_of(out, column);
    out.push_str("<button type=\"button\" class=\"chip\" aria-label=\"");
    escape(out, &format!("{} {first}", t("page.take")));
    out.push_str("\">");
    escape(out, first);
    out.push_str("</button></td>");
}

/// A cell of a column, with the head of the column where cells have heads.
fn table_cell(out: &mut String, column: Option<&Column>, cell: &str, has_heads: bool, project: &Project) {
    match column {
        Some(Column::Parameter(_)) if meaning::of(project, cell, Table::Parameters).is_some() => {
            out.push_str("<td data-means=\"parameters\">");
            escape(out, cell);
            out.push_str("</td>");
        }
        Some(Column::Prose(_) | Column::Product(_)) => tagged(out, "td", cell),
        // An empty cell needs no head.
        _ if has_heads && cell.is_empty() => out.push_str("<td></td>"),
        Some(_) if has_heads => {
            out.push_str("<td>");
            head_of(out, column);
            escape(out, cell);
            out.push_str("</td>");
        }
        _ => devices(out, cell, project),
    }
}

/// The grade of a row, with its source; as a paragraph with the source beside it.
fn graded(out: &mut String, tag: &str, row: &Row) {
    let open = if row.grade == Grade::Open { " open" } else { "" };
    out.push_str(&format!("<{tag} class=\"grade{open}\" title=\""));
    escape(out, row.source.words());
    out.push_str("\">");
    let grade = row.grade.words();
    if tag == "p" {
        escape(out, &headed(row.source.words(), grade))
    } else {
        escape(out, grade)
    }
    out.push_str(&format!("</{tag}>"));
}

/// Number of columns that fit a narrow layout.
const IN_A_ROW: usize = 9;

/// Letters of a first cell that stays on one line: a register, a parameter, a short block.
const ONE_LINE: usize = 20;

/// Number of characters from which a cell counts as a sentence.
const SENTENCE: usize = 24;

/// Characters of the longest cell of a column.
fn longest(sheet: &Sheet, at: usize) -> usize {
    sheet.rows.iter().filter_map(|row| Some(columns(row.cells.get(at)?))).max().unwrap_or(0)
}

/// A cell whose registers and variables have their meaning: `MOV R148 R74`.
fn devices(out: &mut String, cell: &str, project: &Project) {
    out.push_str("<td>");
    for (at, word) in cell.split(' ').enumerate() {
        if at > 0 {
            out.push(' ');
        }
        let means = meaning::of(project, word, Table::Interface).map(|found| found.subject);
        if matches!(means, Some(Subject::Signal(_) | Subject::Variable(_) | Subject::Code(_))) {
            out.push_str("<span data-means=\"interface\">");
            escape(out, word);
            out.push_str("</span>");
        } else {
            escape(out, word);
        }
    }
    out.push_str("</td>");
}

pub(super) fn tagged(out: &mut String, tag: &str, text: &str) {
    out.push_str(&format!("<{tag}>"));
    escape(out, text);
    out.push_str(&format!("</{tag}>"));
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::machines::sheets::row;
    use crate::text::Citation;
    use crate::ui::testing::project;
    use crate::view::FieldEntry;

    fn choice(products: usize) -> String {
        let cite = Citation::new("catalogue", Grade::Manual);
        let asked = row(["asked".to_owned(), "1 Nm".to_owned()], cite);
        let product = |at: usize| Row {
            entries: vec![FieldEntry::new("motor-x", format!("M{at}"))],
            ..row([format!("M{at}"), format!("{at} Nm")], cite)
        };
        let sheet = Sheet {
            id: "motors",
            kind: SheetKind::Choice,
            title: "sheet.motors",
            columns: vec![Column::Product("sheet.motor"), Column::Plain("sheet.effective-load")],
            rows: core::iter::once(asked).chain((0..products).map(product)).collect(),
            drawing: String::new(),
        };
        let mut out = String::new();
        table(&mut out, &sheet, &project());
        out
    }

    #[wasm_bindgen_test]
    fn cells_of_a_wide_choice_have_their_heads() {
        let cite = Citation::new("catalogue", Grade::Manual);
        let cells = core::array::from_fn::<String, 10, _>(|at| "7".repeat(if at == 5 { SENTENCE + 1 } else { 1 }));
        let way = Row { entries: vec![FieldEntry::new("tip-radius", "45".to_owned())], ..row(cells, cite) };
        let mut sheet = Sheet {
            id: "choices",
            kind: SheetKind::Plain,
            title: "polygon.sheet.choices",
            columns: vec![Column::Plain("polygon.sheet.rank"); 10],
            rows: vec![way.clone(), way],
            drawing: String::new(),
        };
        let written = |sheet: &Sheet| {
            let mut out = String::new();
            table(&mut out, sheet, &project());
            out
        };
        let wide = written(&sheet);
        let counts = ["sheet dense", "<small>", "class=\"long\""].map(|part| wide.matches(part).count());
        assert_eq!(counts, [1, 20, 2]);
        sheet.columns.pop();
        assert!(!written(&sheet).contains("<small>"));
    }

    #[wasm_bindgen_test]
    fn choice_shows_its_first_products_and_folds_the_others() {
        let html = choice(9);
        let (first, others) = html.split_once("<details>").unwrap();
        assert_eq!([first, others].map(|part| part.matches("data-entries").count()), [OFFERED, 4]);
        assert!(others.contains(&sentence(&msg!("page.more-products", count = 4_u32))) && !others.contains("asked"));
        assert!(!choice(OFFERED + 1).contains("<details>"), "a single one is not folded");
    }
}
