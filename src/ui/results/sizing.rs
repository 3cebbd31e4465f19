//! Sizing: motors, operating envelope, limits and bill of materials, from runs of the program in the worker.
//! A click on a motor takes it into the form; a click on a chart goes to that moment.

use std::time::Duration;

use leptos::ev::MouseEvent;
use leptos::prelude::*;

use super::take::take_row;
use super::variants::Variants;
use crate::msg;
use crate::project::chance;
use crate::ui::dom;
use crate::ui::parts::followed::{Answered, ProgressBar, follow};
use crate::ui::state::{Page, put};
use crate::ui::words::{Tone, sentence, t};
use crate::ui::worker::messages::{DrawMachines, ShownSection, SizeProject};

/// Delay after the last change before the project is sized, so that a dragged number asks once.
const REST: Duration = Duration::from_millis(400);

/// The sizing tab.
#[component]
pub(crate) fn SizingTab() -> impl IntoView {
    let page = Page::here();
    let sizing = follow(SizeProject, REST);
    let choose = move |event: MouseEvent| {
        if !take_row(page, &event)
            && let Some(t) = moment(&event)
        {
            page.player.seek(t);
        }
    };
    let lead = move || match sizing.answer.get() {
        Answered::Waiting => t("page.reading"),
        Answered::Nothing => t("page.no-answer"),
        Answered::Of(_) => t("page.sizing-lead"),
    };
    let shown = move |at: usize| {
        Memo::new(move |_| {
            sizing.answer.with(|answer| match answer {
                Answered::Of(sections) => sections.get(at).cloned(),
                Answered::Waiting | Answered::Nothing => None,
            })
        })
    };
    // A section that stays keeps its place open or closed, because its element stays.
    let ids = move || {
        sizing.answer.with(|answer| match answer {
            Answered::Of(sections) => {
                sections.iter().enumerate().map(|(at, section)| (at, section.id.clone())).collect()
            }
            Answered::Waiting | Answered::Nothing => Vec::new(),
        })
    };
    let is_answered = move || sizing.answer.with(|answer| matches!(answer, Answered::Of(_)));
    view! {
        <div class="sizing" aria-busy=move || sizing.progress.outdated.get().to_string() on:click=choose>
            <p class="lead">{lead}</p>
            <ProgressBar work="page.runs-work" progress=sizing.progress />
            <For each=ids key=Clone::clone let:place>
                <Section section=shown(place.0) />
            </For>
            <Show when=is_answered>
                <Chances />
            </Show>
        </div>
        <Variants />
    }
}

/// A section of the sizing: its answer, and its sheets once it is opened.
#[component]
fn Section(
    /// The section; none while it is taken away.
    section: Memo<Option<ShownSection>>,
    /// Shown above the sheets once the section is opened.
    #[prop(optional)]
    children: Option<ChildrenFn>,
) -> impl IntoView {
    let is_built = RwSignal::new(false);
    let of = move |read: fn(&ShownSection) -> String| {
        move || section.with(|section| section.as_ref().map(read).unwrap_or_default())
    };
    let (title, answer, sheets) = (of(|of| of.title.clone()), of(|of| of.answer.clone()), of(|of| of.html.clone()));
    let (sign, class) = (of(|of| of.tone.sign().to_owned()), of(|of| format!("answer {}", of.tone)));
    view! {
        <details class="section" id=of(|of| format!("sizing-{}", of.id)) on:toggle=move |_| put(is_built, true)>
            <summary>
                <span class="title">{title}</span>
                <span class=class><i aria-hidden="true">{sign}</i> " " {answer}</span>
            </summary>
            {move || is_built.get().then(|| children.as_ref().map(|children| children()))}
            <div class="sheets" inner_html=move || is_built.get().then(sheets).unwrap_or_default()></div>
        </details>
    }
}

/// The chance that every verdict holds; thousands of machines are drawn when the section is opened.
#[component]
fn Chances() -> impl IntoView {
    let drawn = RwSignal::new(Answered::Waiting);
    let section = Memo::new(move |_| {
        let without = |answer| ShownSection {
            id: "chance".to_owned(),
            title: t("sheet.chance").to_owned(),
            tone: Tone::Plain,
            answer,
            html: String::new(),
        };
        Some(match drawn.get() {
            Answered::Waiting => without(sentence(&msg!("page.chance", count = chance::DRAWS))),
            Answered::Nothing => without(t("page.no-answer").to_owned()),
            Answered::Of(section) => section,
        })
    });
    view! { <Section section><DrawnMachines drawn /></Section> }
}

/// Draws the machines, and draws them again after every change of the project.
#[component]
fn DrawnMachines(
    /// Takes the answer.
    drawn: RwSignal<Answered<ShownSection>>,
) -> impl IntoView {
    let chance = follow(DrawMachines, REST);
    Effect::new(move |_| put(drawn, chance.answer.get()));
    view! { <ProgressBar work="page.chance-work" progress=chance.progress /> }
}

/// Time (s) of the part of the run whose line in a chart was clicked.
fn moment(event: &MouseEvent) -> Option<f64> {
    let line = dom::closest(event, "[data-at]")?;
    line.get_attribute("data-at")?.parse().ok()
}

#[cfg(test)]
mod tests {
    use leptos::wasm_bindgen::JsValue;
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::machines::form::Value;
    use crate::ui::testing::{mount, pause, settled, until};
    use crate::ui::worker::client::Client;
    use crate::ui::worker::messages::{Ask, Request};

    fn sections(entries: &str) -> Option<JsValue> {
        let html =
            format!("<table><tbody><tr data-entries=\"{entries}\"><td><button>M1</button></td></tr></tbody></table>");
        let section = |id: &str, html: &str| ShownSection {
            id: id.to_owned(),
            title: format!("Title of {id}"),
            tone: Tone::Ok,
            answer: format!("answer of {id}"),
            html: html.to_owned(),
        };
        SizeProject.answer(&vec![section("x", &html), section("bill", "<p>Bill</p>")])
    }

    #[wasm_bindgen_test]
    async fn motor_of_the_list_is_taken_into_the_form() {
        let bench = mount(|| {
            Client::here().answer_here(|_, request| match request {
                Request::SizeProject(_) => sections("motor-x=Works; M=1\nmotor-peak-x=7.5"),
                _ => None,
            });
            view! { <SizingTab /> }
        })
        .await;
        until(|| bench.has("#sizing-x")).await;
        assert!(bench.text("#sizing-x summary").contains("answer of x") && !bench.has("tr button"));
        bench.press("#sizing-x summary").await;
        until(|| bench.has("tr button")).await;
        bench.press("tr button").await;
        settled().await;
        let value = |id: &str| bench.page.project.with_untracked(|project| project.values[id].clone());
        assert_eq!(
            (value("motor-x"), value("motor-peak-x")),
            (Value::Text("Works; M=1".to_owned()), Value::Number(7.5))
        );
        assert!(bench.notices().iter().any(|notice| notice.contains("Works; M=1")), "{:?}", bench.notices());
        // Sized again, the section stays open.
        pause(500).await;
        assert!(bench.has("#sizing-x[open] tr button") && !bench.has("#sizing-bill[open]"));
        bench.page.undo();
        settled().await;
        assert_ne!(value("motor-peak-x"), Value::Number(7.5));
    }

    #[wasm_bindgen_test]
    async fn chance_is_the_answer_of_its_section() {
        let bench = mount(|| {
            Client::here().answer_here(|_, request| match request {
                Request::SizeProject(_) => sections(""),
                Request::DrawMachines(_) => DrawMachines.answer(&ShownSection {
                    id: "chance".to_owned(),
                    title: "Chance".to_owned(),
                    tone: Tone::Warn,
                    answer: "92 %".to_owned(),
                    html: "<p>Brake</p>".to_owned(),
                }),
                _ => None,
            });
            view! { <SizingTab /> }
        })
        .await;
        until(|| bench.has("#sizing-chance")).await;
        assert!(bench.text("#sizing-chance summary").contains(&sentence(&msg!("page.chance", count = chance::DRAWS))));
        bench.press("#sizing-chance summary").await;
        until(|| bench.has("#sizing-chance p")).await;
        assert!(bench.text("#sizing-chance .answer.warn").contains("92 %"));
    }

    #[wasm_bindgen_test]
    async fn sizing_waits_until_the_project_rests() {
        let bench = mount(|| {
            Client::here().answer_here(|project, _| sections(&format!("motor-x={}", project.name)));
            view! { <SizingTab /> }
        })
        .await;
        assert!(bench.has("[aria-busy=true]") && !bench.has(".section"));
        until(|| bench.has(".section")).await;
        assert!(bench.has("[aria-busy=false]"));
    }
}
