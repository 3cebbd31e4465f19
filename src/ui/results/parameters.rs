//! Parameter sheet with the open points of the control, and the sheets of interface and ladder.

use leptos::prelude::*;

use crate::controls::Switch;
use crate::controls::options::CommentCharacters;
use crate::text::Grade;
use crate::text::catalog::Language;
use crate::ui::parts::followed::follow_sheets;
use crate::ui::parts::input::Choice;
use crate::ui::parts::sheet_view::SheetView;
use crate::ui::state::{EditKey, Page};
use crate::ui::words::{Tone, t};

/// The parameters tab.
#[component]
pub(crate) fn ParametersTab() -> impl IntoView {
    view! { <SheetView sheets=follow_sheets(|sheets| sheets.parameters)><Switches /></SheetView> }
}

/// The PLC tab.
#[component]
pub(crate) fn PlcTab() -> impl IntoView {
    view! { <SheetView sheets=follow_sheets(|sheets| sheets.plc) /> }
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
            <table class="switches"><tbody>{rows} <CommentLanguage /></tbody></table>
        </div>
    }
}

/// The language of comments, where the control can show more than one.
#[component]
fn CommentLanguage() -> impl IntoView {
    let page = Page::here();
    let offered = Memo::new(move |_| page.project.with(|project| project.characters() != CommentCharacters::Ascii));
    let options: Vec<_> = Language::ALL.map(|one| (one.code().to_owned(), one.name().to_owned())).into();
    let chosen = Signal::derive(move || page.project.with(|project| project.comments.code().to_owned()));
    let take = move |code: String| {
        if let Some(language) = Language::of_code(&code) {
            page.edit(|project| project.comments = language);
        }
    };
    let row = move || {
        view! {
            <tr class="comments">
                <td title=t("page.comments-about")>{t("page.comments")}</td>
                <td>
                    <Choice
                        attr:aria-label=t("page.comments") options=Signal::stored(options.clone()) chosen=chosen choose=take
                    />
                </td>
                <td></td>
            </tr>
        }
    };
    move || offered.get().then(&row)
}

/// One open point.
#[component]
fn SwitchRow(
    /// Row of the switch.
    switch: &'static Switch,
) -> impl IntoView {
    let page = Page::here();
    let set = move || page.project.with(|project| project.switches.setting(switch).to_owned());
    let text = switch.text();
    let take = move |chosen: String| {
        let chosen = chosen.trim().to_owned();
        if switch.takes(&chosen) {
            page.edit_merged(EditKey::Switch(switch.id()), |project| project.switches.set(switch, &chosen));
        } else {
            page.notices.notify(Tone::Warn, t("page.not-a-setting").to_owned());
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
            <td class=class title=switch.cite.source.words()>{switch.cite.grade.words()}</td>
        </tr>
    }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::testing::{ViewBench, mount, settled};

    #[wasm_bindgen_test]
    async fn language_of_comments_is_offered_where_the_control_shows_it() {
        let bench = parameters().await;
        let gsk = crate::controls::find("gsk-980tdc").unwrap();
        bench.page.edit(|project| project.move_to(gsk));
        settled().await;
        assert!(!bench.has(".comments"));
        let row = gsk.switch("comment-characters").unwrap();
        bench.page.edit(|project| project.switches.set(row, "utf-8"));
        settled().await;
        bench.choose(".comments select", "zh").await;
        let title = bench.page.program.written.with_untracked(|written| written.files.0[0].text.clone());
        assert!(title.contains("印点生产线"), "{title}");
        bench.page.undo();
        settled().await;
        assert_eq!(bench.value(".comments select"), "en");
    }

    async fn parameters() -> ViewBench {
        mount(|| view! { <ParametersTab /> }).await
    }

    fn place(of: impl Fn(&Switch) -> bool) -> (usize, &'static Switch) {
        let switches = crate::ui::testing::project().control.switches;
        switches.iter().enumerate().find(|(_, switch)| of(switch)).unwrap()
    }

    #[wasm_bindgen_test]
    async fn every_open_point_has_setting_and_grade() {
        let bench = parameters().await;
        let switches = bench.page.project.with_untracked(|project| project.control.switches);
        assert_eq!(bench.all(".switches tr").len(), switches.len());
        let grades: Vec<String> = bench.all(".switches .grade").iter().filter_map(|cell| cell.text_content()).collect();
        assert_eq!(grades, switches.iter().map(|switch| switch.cite.grade.words()).collect::<Vec<_>>());
    }

    #[wasm_bindgen_test]
    async fn chosen_setting_reaches_the_project_and_is_undone() {
        let (at, switch) = place(|switch| !switch.is_text() && switch.options().len() > 1);
        let bench = parameters().await;
        let list = format!(".switches tr:nth-child({}) select", at + 1);
        let present = bench.value(&list);
        let other = switch.options().iter().map(|option| option.id).find(|id| *id != present).unwrap();
        bench.choose(&list, other).await;
        assert_eq!(bench.page.project.with_untracked(|project| project.switches.setting(switch).to_owned()), other);
        bench.page.undo();
        settled().await;
        assert_eq!(bench.value(&list), present);
    }

    #[wasm_bindgen_test]
    async fn control_has_its_own_points() {
        let bench = parameters().await;
        let control = crate::controls::find(crate::machines::ALL[0].controls()[2]).unwrap();
        bench.page.edit(|project| project.move_to(control));
        settled().await;
        assert_eq!(bench.all(".switches tr").len(), control.switches.len());
    }

    #[wasm_bindgen_test]
    async fn wrong_setting_is_refused_with_a_notice() {
        let text = |control: &&'static crate::controls::Control| control.switches.iter().any(Switch::is_text);
        let Some(control) = crate::controls::ALL.iter().copied().find(text) else { return };
        let machine = crate::machines::ALL.iter().find(|machine| machine.controls().contains(&control.id)).unwrap();
        let project = crate::project::Project::of(machine.id(), Some(control.id)).unwrap();
        let bench = crate::ui::testing::mount_project(project, || view! { <ParametersTab /> }).await;
        let before = bench.value(".switches input");
        bench.choose(".switches input", &"x".repeat(501)).await;
        assert_eq!(bench.notices(), [t("page.not-a-setting")]);
        let switch = control.switches.iter().find(|switch| switch.is_text()).unwrap();
        assert_eq!(bench.page.project.with_untracked(|project| project.switches.setting(switch).to_owned()), before);
    }

    #[wasm_bindgen_test]
    async fn sheet_of_the_plc_waits_for_the_worker() {
        let bench = mount(|| view! { <PlcTab /> }).await;
        assert_eq!(bench.text(".sheets"), t("page.no-answer"));
    }
}
