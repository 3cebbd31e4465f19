//! Parameter sheet, interface and ladder, as tables with sources and grades.

use leptos::prelude::*;

use super::model::Model;
use super::words::t;
use crate::text::Grade;
use crate::view::{Sheet, ladder};

/// The sheet of the control's parameters.
pub(super) fn parameters(model: Model) -> AnyView {
    sheets(model, |id| id == "parameters")
}

/// Interface and ladder.
pub(super) fn plc(model: Model) -> AnyView {
    sheets(model, |id| id != "parameters")
}

fn sheets(model: Model, which: fn(&str) -> bool) -> AnyView {
    let all = move || {
        model.project.with(|project| {
            let sheets = project.machine.sheets(&project.values, project.control);
            sheets.iter().filter(|sheet| which(sheet.id)).map(table).collect_view()
        })
    };
    view! { <div class="sheets">{all}</div> }.into_any()
}

fn grade(grade: Grade) -> &'static str {
    match grade {
        Grade::Manual => t("page.grade-manual"),
        Grade::Sister => t("page.grade-sister"),
        Grade::Measured => t("page.grade-measured"),
        Grade::Inferred => t("page.grade-inferred"),
        Grade::Open => t("page.grade-open"),
    }
}

fn table(sheet: &Sheet) -> AnyView {
    let heads: Vec<_> = sheet.columns.iter().map(|column| view! { <th scope="col">{t(column)}</th> }).collect();
    let rows: Vec<_> = sheet
        .rows
        .iter()
        .map(|row| {
            let cells: Vec<_> = row.cells.iter().map(|cell| view! { <td>{cell.clone()}</td> }).collect();
            let class = if row.grade == Grade::Open { "grade open" } else { "grade" };
            view! { <tr>{cells}<td class=class title=row.source>{grade(row.grade)}</td></tr> }
        })
        .collect();
    view! {
        <h3>{t(sheet.title)}</h3>
        {(!sheet.ladder.is_empty()).then(|| view! { <div class="scroll" inner_html=ladder::svg(&sheet.ladder)></div> })}
        <div class="scroll" tabindex="0" role="group" aria-label=t(sheet.title)>
            <table class="sheet"><thead><tr>{heads}<th scope="col">{t("page.grade")}</th></tr></thead><tbody>{rows}</tbody></table>
        </div>
    }
    .into_any()
}
