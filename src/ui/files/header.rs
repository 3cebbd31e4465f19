//! The header: machine and control, name of the project, and its buttons.

use leptos::prelude::*;

use super::gallery::NewButton;
use super::open::OpenButton;
use super::print::show_report;
use super::projects::ProjectsButton;
use super::share::{self, ShareButton};
use super::store;
use crate::controls;
use crate::machines;
use crate::project::name::{NAME_LENGTH, clean_name};
use crate::ui::parts::input::Choice;
use crate::ui::parts::{ContrastButton, Glyph, IconButton, LanguageButtons, Later, LengthsButton, ThemeButton};
use crate::ui::state::view::Kept;
use crate::ui::state::{EditKey, Page};
use crate::ui::words::t;
use crate::ui::worker::client::Client;

/// The header.
#[component]
pub(crate) fn Header() -> impl IntoView {
    let page = Page::here();
    view! {
        <header class="top">
            <h1><Logo /> <span>"macro"<i>"line"</i></span></h1>
            <Later>
                <MachinePicker />
                <ControlPicker />
                <ProjectName />
                <div class="doing">
                    <Show when=move || page.view.kept.get() == Kept::Elsewhere>
                        <button type="button" class="work-here" title=t("page.store-here-about") on:click=move |_| store::take_over(page)>
                            {t("page.store-here")}
                        </button>
                    </Show>
                    <IconButton glyph=Glyph::Undo label=t("page.undo") title=t("page.undo-key") disabled=Signal::derive(move || !page.undoable.get().undo) press=move || page.undo() />
                    <IconButton glyph=Glyph::Redo label=t("page.redo") title=t("page.redo-key") disabled=Signal::derive(move || !page.undoable.get().redo) press=move || page.redo() />
                    <ProjectsButton />
                    <NewButton />
                    <OpenButton />
                    <button type="button" class="quiet save" title=t("page.save-about") on:click=move |_| share::save(page)>{t("page.save")}</button>
                    <ShareButton />
                    <ReportButton />
                    <button type="button" class="primary" id="export" on:click=move |_| page.view.exporting.set(true)>{t("page.export-short")}</button>
                    <LanguageButtons />
                    <LengthsButton />
                    <ThemeButton />
                    <ContrastButton />
                    <IconButton glyph=Glyph::Help label=t("page.help") class="help" press=move || page.view.helping.set(true) />
                </div>
            </Later>
        </header>
    }
}

/// Opens the report to print; only where the header has room, for the export offers it too.
#[component]
fn ReportButton() -> impl IntoView {
    let (page, worker) = (Page::here(), Client::here());
    view! {
        <button type="button" class="quiet report" title=t("page.print-about") on:click=move |_| show_report(page, worker)>
            {t("page.report")}
        </button>
    }
}

/// A roller on a web.
#[component]
fn Logo() -> impl IntoView {
    view! {
        <svg class="logo" viewBox="0 0 24 24" aria-hidden="true">
            <path d="M2 19h20" class="web" />
            <circle cx="12" cy="11" r="7" />
            <path d="M12 11v7" class="web" />
        </svg>
    }
}

/// The machines.
#[component]
fn MachinePicker() -> impl IntoView {
    let page = Page::here();
    let button = |machine: &&'static dyn machines::AnyMachine| {
        let machine = *machine;
        let chosen = move || page.machine.get() == machine.id();
        let choose = move |_| {
            if !untrack(chosen) {
                page.change_machine(machine.id());
            }
        };
        let name = t(machine.name());
        // A narrow header shows the first word alone.
        let (first, rest) = name.split_once(' ').unwrap_or((name, ""));
        view! {
            <button type="button" aria-label=name aria-pressed=move || chosen().to_string() on:click=choose>
                {first} <span class="rest">" " {rest}</span>
            </button>
        }
    };
    let buttons = machines::ALL.iter().map(button).collect_view();
    view! { <div class="segments" role="group" aria-label=t("page.machine")>{buttons}</div> }
}

/// List of the controls that the machine can have.
#[component]
fn ControlPicker() -> impl IntoView {
    let page = Page::here();
    let options = move || {
        page.machine.track();
        let ids = page.project.with_untracked(|project| project.machine.controls());
        let found = ids.iter().filter_map(|id| controls::find(id));
        found.map(|control| (control.id.to_owned(), control.name.to_owned())).collect::<Vec<_>>()
    };
    let choose = move |id: String| {
        if let Some(control) = controls::find(&id) {
            page.edit(|project| project.move_to(control));
        }
    };
    view! {
        <Choice
            attr:class="control" attr:aria-label=t("page.control")
            options=Signal::derive(options) chosen=Signal::derive(move || page.control.get().to_owned()) choose=choose
        />
    }
}

/// The name of the project, and whether it is kept.
#[component]
fn ProjectName() -> impl IntoView {
    let page = Page::here();
    let take = move |event| {
        let name = clean_name(&event_target_value(&event));
        page.edit_merged(EditKey::Name, |project| project.name = name);
    };
    let kept = move || t(page.view.kept.get().words());
    view! {
        <div class="project">
            <input
                class="name" type="text" maxlength=NAME_LENGTH.to_string() placeholder=t("page.untitled") aria-label=t("page.name")
                prop:value=move || page.project.with(|project| project.name.clone())
                on:input=take
            />
            // A tooltip shows the text that the header has no room for.
            <span
                class="kept" title=move || if page.view.kept.get() == Kept::Yes { t("page.kept-about") } else { kept() }
                class:warn=move || page.view.kept.get().is_refused() || page.view.kept.get() == Kept::Elsewhere
            >
                {kept}
            </span>
        </div>
    }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::dom;
    use crate::ui::testing::{ViewBench, mount, settled};

    async fn header() -> ViewBench {
        mount(|| view! { <Header /> }).await
    }

    #[wasm_bindgen_test]
    async fn pressed_machine_is_taken() {
        let bench = header().await;
        assert_eq!(bench.all(".segments button").len(), machines::ALL.len());
        assert_eq!(bench.attribute(".segments button:nth-child(1)", "aria-pressed"), "true");
        bench.press(".segments button:nth-child(2)").await;
        assert_eq!(bench.page.machine.get_untracked(), machines::ALL[1].id());
        assert_eq!(bench.all(".segments [aria-pressed=true]").len(), 1);
    }

    #[wasm_bindgen_test]
    async fn controls_are_those_of_the_machine() {
        let bench = header().await;
        for machine in machines::ALL {
            bench.page.change_machine(machine.id());
            settled().await;
            assert_eq!(bench.all(".control option").len(), machine.controls().len());
            assert_eq!(bench.value(".control"), bench.page.control.get_untracked());
        }
    }

    #[wasm_bindgen_test]
    async fn chosen_control_is_taken_and_undone() {
        let bench = header().await;
        let controls = machines::ALL[0].controls();
        bench.choose(".control", controls[2]).await;
        assert_eq!(bench.page.control.get_untracked(), controls[2]);
        bench.press_button(t("page.undo")).await;
        assert_eq!(bench.value(".control"), controls[0]);
    }

    #[wasm_bindgen_test]
    async fn undo_and_redo_are_disabled_without_a_step() {
        let bench = header().await;
        let disabled = |words| bench.has(&format!("[aria-label={}][disabled]", t(words)));
        assert!(disabled("page.undo") && disabled("page.redo"));
        bench.type_into(".name", "Order 7").await;
        assert!(!disabled("page.undo") && disabled("page.redo"));
        bench.press_button(t("page.undo")).await;
        assert!(disabled("page.undo") && !disabled("page.redo"));
        assert_eq!(bench.value(".name"), "");
    }

    #[wasm_bindgen_test]
    async fn name_of_the_project_has_no_control_characters() {
        let bench = header().await;
        bench.type_into(".name", "Order\u{7} 7").await;
        assert_eq!(bench.page.project.with_untracked(|project| project.name.clone()), "Order 7");
    }

    #[wasm_bindgen_test]
    async fn state_of_the_store_is_shown() {
        let bench = header().await;
        for (kept, words) in [
            (Kept::Yes, "page.kept"),
            (Kept::Soon, "page.kept-soon"),
            (Kept::No, "page.kept-not"),
            (Kept::Denied, "page.kept-denied"),
        ] {
            bench.page.view.kept.set(kept);
            settled().await;
            assert_eq!(bench.text(".kept"), t(words));
        }
        assert!(bench.has(".kept.warn"));
    }

    #[wasm_bindgen_test]
    async fn project_of_another_tab_is_overwritten_only_when_asked() {
        let bench = header().await;
        bench.page.view.kept.set(Kept::Elsewhere);
        settled().await;
        bench.press_button(t("page.store-here")).await;
        assert_eq!(bench.page.view.kept.get_untracked(), Kept::Yes);
        assert!(dom::stored("macroline.project").is_some());
    }

    #[wasm_bindgen_test]
    async fn gallery_export_and_help_are_asked_for() {
        let bench = header().await;
        bench.press_button(t("page.new")).await;
        bench.press("#export").await;
        bench.press_button(t("page.help")).await;
        let view = bench.page.view;
        assert!([view.gallery, view.exporting, view.helping].iter().all(|asked| asked.get_untracked()));
    }
}
