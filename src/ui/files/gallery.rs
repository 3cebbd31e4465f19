//! The gallery: the examples of all machines with their pictures; one of them begins a new project.

use leptos::prelude::*;

use crate::controls;
use crate::machines::machine::{Example, KnownFault};
use crate::machines::{self, AnyMachine};
use crate::project::Project;
use crate::ui::dom;
use crate::ui::parts::{Dialog, DialogButton};
use crate::ui::state::Page;
use crate::ui::words::{Tone, has_all_words, sentence, t};
use crate::ui::worker::client::Client;
use crate::ui::worker::messages::DrawExamples;
use crate::view::Readout;

/// The button of the gallery.
#[component]
pub(super) fn NewButton() -> impl IntoView {
    view! { <DialogButton id="new" label="page.new" about="page.gallery-about" open=Page::here().view.gallery /> }
}

/// The dialog with the examples of all machines.
#[component]
pub(crate) fn GalleryDialog() -> impl IntoView {
    let page = Page::here();
    let open = page.view.gallery;
    view! {
        <Dialog id="gallery-title" title=t("page.gallery") open=open close=move || open.set(false) class="wide gallery">
            <Show when=move || open.get()>
                <Gallery />
            </Show>
        </Dialog>
    }
}

/// A machine of the gallery with its examples, each with the place of its picture.
type Group = (&'static dyn AnyMachine, Vec<(usize, &'static Example)>);

/// The machines with their examples, the present machine first.
fn groups(present: &str) -> Vec<Group> {
    let mut pictures = 0..;
    let with_examples =
        |machine: &&'static dyn AnyMachine| (*machine, pictures.by_ref().zip(machine.examples()).collect());
    let mut groups: Vec<Group> = machines::ALL.iter().map(with_examples).collect();
    groups.sort_by_key(|(machine, _)| machine.id() != present);
    groups
}

/// Search and cards.
#[component]
fn Gallery() -> impl IntoView {
    let page = Page::here();
    let search = RwSignal::new(String::new());
    let pictures = RwSignal::new(Vec::new());
    let show = move |drawn: Option<Vec<String>>| {
        if let Some(drawn) = drawn {
            let _ = pictures.try_set(drawn);
        }
    };
    page.project.with_untracked(|project| Client::here().ask(project, DrawExamples { theme: dom::theme() }, show));
    let group = move |(machine, examples): Group| {
        let found = move |example: &Example| {
            let text = [machine.name(), example.name, example.about].map(t).join(" ");
            search.with(|search| has_all_words(&text, search))
        };
        let any = examples.clone();
        let cards = examples.into_iter().map(|(at, example)| {
            let picture = Signal::derive(move || pictures.with(|all: &Vec<String>| all.get(at).cloned().unwrap_or_default()));
            view! { <ExampleCard machine=machine example=example picture=picture shown=Signal::derive(move || found(example)) /> }
        });
        view! {
            <section class:gone=move || !any.iter().any(|(_, example)| found(example))>
                <h3>{t(machine.name())}</h3>
                <div class="examples">{cards.collect_view()}</div>
            </section>
        }
    };
    let groups = page.project.with_untracked(|project| groups(project.machine.id()));
    view! {
        <p>{t("page.gallery-about")}</p>
        <input
            type="text" autocomplete="off" aria-label=t("page.gallery-search") placeholder=t("page.gallery-search")
            prop:value=search on:input=move |event| search.set(event_target_value(&event))
        />
        {groups.into_iter().map(group).collect_view()}
    }
}

/// One example: picture, name, sentence, the control that it takes where it is another one, and the reason of each verdict that fails in it.
#[component]
fn ExampleCard(
    /// The machine.
    machine: &'static dyn AnyMachine,
    /// The example.
    example: &'static Example,
    /// Address of its picture; empty until it is drawn.
    picture: Signal<String>,
    /// Whether the example is among those found.
    shown: Signal<bool>,
) -> impl IntoView {
    let page = Page::here();
    // The present control, if the machine can have it.
    let preferred = move || {
        let present = page.project.with_untracked(|project| project.control);
        let first = || machine.controls().first().and_then(|id| controls::find(id));
        Some(present).filter(|control| machine.controls().contains(&control.id)).or_else(first)
    };
    let made = move || Some(Project::whole_example(machine, preferred()?, example));
    // Names of the control that the example takes and of the preferred one, where they differ.
    let moved = move |project: &Project| {
        let lacking = preferred().filter(|control| control.id != project.control.id)?;
        Some((project.control.name, lacking.name))
    };
    let present = page.project.with_untracked(|project| {
        let is = |present: &Example| present.id == example.id;
        project.machine.id() == machine.id() && project.present_example().is_some_and(is)
    });
    let faults =
        if example.faults.is_empty() { Vec::new() } else { made().map(|project| project.faults()).unwrap_or_default() };
    let count = faults.len() as u32;
    let other_control = made().as_ref().and_then(moved).map(|(control, lacking)| {
        view! { <p>{sentence(&crate::msg!("page.example-control", control, lacking))}</p> }
    });
    let take = move |_| {
        let Some(project) = made() else { return };
        let moved = moved(&project);
        page.replace(project);
        page.view.gallery.set(false);
        // The first change may mend a result: it takes the count away.
        if count > 0 {
            let message = crate::msg!("page.example-fails", example = t(example.name), count = count);
            page.notices.confirm_as(Tone::Warn, sentence(&message));
        } else if let Some((control, lacking)) = moved {
            page.notices.confirm(sentence(&crate::msg!("page.example-opened", control, lacking)));
        } else {
            page.notices.confirm(t("page.fresh").to_owned());
        }
    };
    let about = format!("{}-{}", machine.id(), example.id);
    let fault = |(readout, fault): &(Readout, &'static KnownFault)| {
        view! { <li><b>{t(readout.label)}</b> " " {t(fault.reason)}</li> }
    };
    let reasons = (count > 0).then(|| {
        view! {
            <details>
                <summary>{sentence(&crate::msg!("page.results-fail", count = count))}</summary>
                <ul>{faults.iter().map(fault).collect_view()}</ul>
            </details>
        }
    });
    view! {
        <article class="example" class:gone=move || !shown.get()>
            <button type="button" aria-current=present.then_some("true") aria-describedby=about.clone() on:click=take>
                <span class="mini">
                    <Show when=move || picture.with(|address| !address.is_empty())>
                        <img alt="" src=picture />
                    </Show>
                </span>
                <b>{t(example.name)}</b>
            </button>
            <p id=about>{t(example.about)}</p>
            {other_control}
            {reasons}
        </article>
    }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::machines::form::Value;
    use crate::ui::testing::{ViewBench, mount, until, work_here};
    use crate::view::Verdict;

    /// The open gallery.
    async fn gallery() -> ViewBench {
        let bench = mount(|| {
            work_here(Client::here());
            view! { <NewButton /> <GalleryDialog /> }
        })
        .await;
        bench.press("#new").await;
        bench
    }

    /// Names of the shown examples.
    fn names(bench: &ViewBench) -> Vec<String> {
        let cards = bench.all(".gallery section:not(.gone) .example:not(.gone) button b");
        cards.into_iter().filter_map(|name| name.text_content()).collect()
    }

    /// Presses the card of an example.
    async fn press(bench: &ViewBench, example: &str) {
        bench.press(&format!("button[aria-describedby={example}]")).await;
    }

    #[wasm_bindgen_test]
    async fn gallery_shows_and_explains_the_examples_of_all_machines() {
        let bench = gallery().await;
        let text = bench.text(".gallery");
        let all: Vec<&Example> = machines::ALL.iter().flat_map(|machine| machine.examples()).collect();
        assert_eq!(names(&bench), all.iter().map(|example| t(example.name)).collect::<Vec<_>>());
        assert!(all.iter().all(|example| text.contains(t(example.about))), "{text}");
        until({
            let gallery = bench.find(".gallery");
            move || gallery.query_selector_all("img").unwrap().length() as usize == all.len()
        })
        .await;
    }

    #[wasm_bindgen_test]
    async fn examples_of_the_present_machine_come_first() {
        let bench = gallery().await;
        bench.page.view.gallery.set(false);
        let last = machines::ALL.last().unwrap();
        bench.page.change_machine(last.id());
        crate::ui::testing::settled().await;
        bench.press("#new").await;
        assert_eq!(names(&bench)[0], t(last.examples()[0].name));
    }

    #[wasm_bindgen_test]
    async fn search_leaves_the_examples_that_have_all_words() {
        let bench = gallery().await;
        bench.type_into(".gallery input", "HEXAGON key").await;
        assert_eq!(names(&bench), [t("polygon.example.hexagon")]);
        bench.type_into(".gallery input", "no such thing").await;
        assert!(names(&bench).is_empty());
    }

    #[wasm_bindgen_test]
    async fn chosen_example_replaces_the_project_and_is_undone() {
        let bench = gallery().await;
        bench.page.view.gallery.set(false);
        bench.page.set("pitch", Value::Number(9.0));
        crate::ui::testing::settled().await;
        bench.press("#new").await;
        press(&bench, "ribbon-line-matched").await;
        assert_eq!(bench.setting("pitch"), Some(Value::Number(10.0)));
        assert!(!bench.has("dialog[open]"));
        bench.page.undo();
        assert_eq!(bench.setting("pitch"), Some(Value::Number(9.0)));
    }

    #[wasm_bindgen_test]
    async fn example_of_another_machine_takes_its_machine_and_control() {
        let bench = gallery().await;
        press(&bench, "polygon-lathe-hexagon-key").await;
        let (machine, control) =
            bench.page.project.with_untracked(|project| (project.machine.id(), project.control.id));
        assert_eq!((machine, control), ("polygon-lathe", "knd-k2000t"));
        bench.page.undo();
        assert_eq!(bench.page.project.with_untracked(|project| project.machine.id()), "ribbon-line");
    }

    #[wasm_bindgen_test]
    async fn example_takes_a_control_that_can_run_all_of_it() {
        let bench = gallery().await;
        let control = || bench.page.project.with_untracked(|project| project.control);
        let lacking = control().name;
        press(&bench, "turning-spindle-keyway").await;
        assert!(control().name != lacking);
        assert!(bench.page.project.with_untracked(|project| !project.prepared().hidden().contains(&"keyway")));
        let control = control().name;
        let told = bench.page.notices.list.get_untracked().pop().unwrap();
        assert_eq!(told.text, sentence(&crate::msg!("page.example-opened", control, lacking)));
        bench.page.undo();
        crate::ui::testing::settled().await;
        bench.press("#new").await;
        assert!(bench.text(".gallery").contains(&sentence(&crate::msg!("page.example-control", control, lacking))));
        // The shaft without a keyway keeps the control.
        press(&bench, "turning-spindle-shaft").await;
        assert_eq!(bench.page.project.with_untracked(|project| project.control.name), lacking);
    }

    #[wasm_bindgen_test]
    async fn present_example_is_marked() {
        let bench = gallery().await;
        press(&bench, "ribbon-line-matched").await;
        bench.press("#new").await;
        assert_eq!(bench.attribute("button[aria-describedby=ribbon-line-matched]", "aria-current"), "true");
        assert_eq!(bench.all(".gallery [aria-current]").len(), 1);
    }

    #[wasm_bindgen_test]
    async fn paper_names_its_faults_before_and_after_it_is_taken() {
        let bench = gallery().await;
        let examples = bench.page.project.with_untracked(|project| project.machine.examples());
        let paper = examples.iter().find(|example| example.id == "paper").unwrap();
        let everywhere = || paper.faults.iter().filter(|fault| fault.everywhere);
        let reasons = bench.text(".gallery ul");
        assert!(everywhere().all(|fault| reasons.contains(t(fault.reason))), "{reasons}");
        press(&bench, "ribbon-line-paper").await;
        let faults = bench.page.project.with_untracked(Project::faults);
        let told = bench.page.notices.list.get_untracked().pop().unwrap();
        assert_eq!((told.tone, faults.len() >= everywhere().count()), (Tone::Warn, true));
        let message = crate::msg!("page.example-fails", example = t(paper.name), count = faults.len() as u32);
        assert_eq!(told.text, sentence(&message));
        // The tab of the results lists the failed verdicts.
        let design = bench.page.results.design.get_untracked();
        let fails =
            |id: &str| design.readouts.iter().any(|readout| readout.id == id && readout.verdict == Verdict::Fail);
        assert!(faults.iter().all(|(readout, _)| fails(readout.id)));
    }
}
