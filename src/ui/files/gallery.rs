//! The gallery: examples of the machine, each with its name and a sentence; one of them begins a new project.

use leptos::prelude::*;

use crate::machines::AnyMachine;
use crate::machines::examples::{Example, Fault};
use crate::project::Project;
use crate::text::listed;
use crate::ui::parts::{Dialog, DialogButton};
use crate::ui::state::Page;
use crate::ui::words::{say, t};
use crate::view::Readout;

/// The button of the gallery.
#[component]
pub(super) fn NewButton() -> impl IntoView {
    view! { <DialogButton id="new" label="page.new" about="page.gallery-about" open=Page::here().view.gallery /> }
}

/// The dialog with the examples of the present machine.
#[component]
pub(crate) fn GalleryDialog() -> impl IntoView {
    let page = Page::here();
    let open = page.view.gallery;
    let rows = move || {
        let machine = open.get().then(|| page.project.with_untracked(|project| project.machine))?;
        let present = page.project.with_untracked(|project| project.present_example().map(|example| example.id));
        let row = |example: &'static Example| {
            view! { <ExampleRow machine=machine example=example present={present == Some(example.id)} /> }
        };
        Some(machine.examples().iter().map(row).collect_view())
    };
    view! {
        <Dialog id="gallery-title" title=t("page.gallery") open=open close=move || open.set(false) class="wide">
            <p>{t("page.gallery-about")}</p>
            <div class="gallery">{rows}</div>
        </Dialog>
    }
}

/// One example: its name, its sentence, and the reason of each verdict that fails in it on the present control.
#[component]
fn ExampleRow(
    /// The machine.
    machine: &'static dyn AnyMachine,
    /// Its example.
    example: &'static Example,
    /// The project has the values of the example.
    present: bool,
) -> impl IntoView {
    let page = Page::here();
    let made = move || Project::example(machine, page.project.with_untracked(|project| project.control), example);
    let faults = if example.faults.is_empty() { Vec::new() } else { made().faults() };
    let failed = listed(faults.iter().map(|(readout, _)| t(readout.label)));
    let take = move |_| {
        page.replace(made());
        page.view.gallery.set(false);
        page.notices.notify("info", t("page.fresh").to_owned());
        if !failed.is_empty() {
            page.notices.notify(
                "warn",
                say(&crate::msg!("page.example-fails", example = t(example.name), results = failed.as_str())),
            );
        }
    };
    let about = format!("example-{}", example.id);
    let fault = |(readout, fault): &(Readout, &'static Fault)| {
        view! { <li><b>{t(readout.label)}</b> " " {t(fault.reason)}</li> }
    };
    let reasons = (!faults.is_empty()).then(|| view! { <ul>{faults.iter().map(fault).collect_view()}</ul> });
    view! {
        <button type="button" aria-current=present.then_some("true") aria-describedby=about.clone() on:click=take>
            {t(example.name)}
        </button>
        <p id=about>{t(example.about)}</p>
        {reasons}
    }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::machines::{self, form::Value};
    use crate::ui::testing::{Bench, mount, settled};

    async fn gallery() -> Bench {
        let bench = mount(|| view! { <NewButton /> <GalleryDialog /> }).await;
        bench.press("#new").await;
        bench
    }

    #[wasm_bindgen_test]
    async fn gallery_names_and_explains_the_examples_of_the_machine() {
        let bench = gallery().await;
        for machine in machines::ALL {
            bench.page.view.gallery.set(false);
            bench.page.change_machine(machine.id());
            settled().await;
            bench.press("#new").await;
            assert_eq!(bench.all(".gallery button").len(), machine.examples().len());
            let text = bench.text(".gallery");
            for example in machine.examples() {
                assert!(text.contains(t(example.name)) && text.contains(t(example.about)), "{}: {text}", example.id);
            }
        }
    }

    #[wasm_bindgen_test]
    async fn chosen_example_replaces_the_project_and_is_undone() {
        let bench = gallery().await;
        bench.page.view.gallery.set(false);
        bench.page.set("pitch", Value::Number(9.0));
        settled().await;
        bench.press("#new").await;
        bench.press(".gallery button:first-of-type").await;
        assert_eq!(bench.setting("pitch"), Some(Value::Number(10.0)));
        assert!(!bench.has("dialog[open]"));
        bench.page.undo();
        assert_eq!(bench.setting("pitch"), Some(Value::Number(9.0)));
    }

    #[wasm_bindgen_test]
    async fn present_example_is_marked() {
        let bench = gallery().await;
        bench.press(".gallery button:first-of-type").await;
        bench.press("#new").await;
        assert_eq!(bench.attribute(".gallery button:first-of-type", "aria-current"), "true");
        assert_eq!(bench.all(".gallery [aria-current]").len(), 1);
    }

    #[wasm_bindgen_test]
    async fn paper_names_its_faults_before_and_after_it_is_taken() {
        let bench = gallery().await;
        let examples = bench.page.project.with_untracked(|project| project.machine.examples());
        let at = examples.iter().position(|example| example.id == "paper").unwrap();
        let everywhere = || examples[at].faults.iter().filter(|fault| fault.everywhere);
        let reasons = bench.text(".gallery ul");
        assert!(everywhere().all(|fault| reasons.contains(t(fault.reason))), "{reasons}");
        bench.press(&format!(".gallery button:nth-of-type({})", at + 1)).await;
        let faults = bench.page.project.with_untracked(Project::faults);
        let told = bench.page.notices.list.get_untracked().pop().unwrap();
        assert_eq!((told.tone, faults.len() >= everywhere().count()), ("warn", true));
        assert!(faults.iter().all(|(readout, _)| told.text.contains(t(readout.label))), "{}", told.text);
    }
}
