//! Parameter sheet with the open points of the control, and the sheets of interface and ladder.

use leptos::prelude::*;

use crate::controls::Switch;
use crate::text::Grade;
use crate::text::catalog::Language;
use crate::ui::parts::input::Choice;
use crate::ui::parts::sheet_view::SheetView;
use crate::ui::state::Page;
use crate::ui::words::{grade, t};

/// The parameters tab.
#[component]
pub(crate) fn ParametersTab() -> impl IntoView {
    view! {
        <SheetView which=|sheets| sheets.parameters />
        <Switches />
    }
}

/// The PLC tab.
#[component]
pub(crate) fn PlcTab() -> impl IntoView {
    view! { <SheetView which=|sheets| sheets.plc /> }
}

/// The points of the control that no manual at hand settles, each with its settings, source and grade.
#[component]
fn Switches() -> impl IntoView {
    let page = Page::here();
    let rows = move || {
        page.control.track();
        let switches = page.project.with_untracked(|project| project.control.switches);
        switches.iter().map(|row| view! { <SwitchRow switch=row /> }).collect_view()
    };
    view! {
        <div class="sheets">
            <h3>{t("page.switches")}</h3>
            <p class="lead">{t("page.switches-lead")}</p>
            <table class="switches"><tbody>{rows}</tbody></table>
        </div>
    }
}

/// One open point.
#[component]
fn SwitchRow(
    /// Its row.
    switch: &'static Switch,
) -> impl IntoView {
    let page = Page::here();
    let set = move || page.project.with(|project| project.switches.setting(switch).to_owned());
    let text = switch.text(Language::English);
    let take = move |chosen: String| {
        let chosen = chosen.trim().to_owned();
        if switch.takes(&chosen) {
            page.edit(switch.id(), |project| project.switches.set(switch, &chosen));
        } else {
            page.notices.notify("warn", t("page.not-a-setting").to_owned());
        }
    };
    let label = text.clone();
    let input = if switch.is_text() {
        view! {
            <input type="text" spellcheck="false" autocomplete="off" aria-label=label prop:value=set on:change=move |event| take(event_target_value(&event)) />
        }
        .into_any()
    } else {
        let options = switch.options();
        let options: Vec<_> = options.iter().map(|one| (one.id.to_owned(), t(one.label).to_owned())).collect();
        view! {
            <Choice attr:aria-label=label options=Signal::stored(options) chosen=Signal::derive(set) choose=take />
        }
        .into_any()
    };
    let class = if switch.cite.grade == Grade::Open { "grade open" } else { "grade" };
    view! {
        <tr>
            <td>{text}</td>
            <td>{input}</td>
            <td class=class title=switch.cite.source>{grade(switch.cite.grade)}</td>
        </tr>
    }
}
