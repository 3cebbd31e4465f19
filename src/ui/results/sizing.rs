//! Sizing: motors, operating envelope, limits and bill of materials, from runs of the program in the worker.
//! A click on a motor takes it into the form; a click on a chart goes to that moment.

use std::time::Duration;

use leptos::ev::MouseEvent;
use leptos::prelude::*;
use leptos::wasm_bindgen::JsCast;
use web_sys::Element;

use super::take::{listed, take};
use super::variants::Variants;
use crate::msg;
use crate::project::chance;
use crate::ui::parts::sheet_view::SheetView;
use crate::ui::state::Page;
use crate::ui::words::{sentence, t};
use crate::ui::worker::messages::Request;

/// Delay after the last change before the project is sized, so that a dragged number asks once.
const REST: Duration = Duration::from_millis(400);

/// The sizing tab.
#[component]
pub(crate) fn SizingTab() -> impl IntoView {
    let page = Page::here();
    // Thousands of machines are drawn only on request.
    let drawn = RwSignal::new(false);
    let choose = move |event: MouseEvent| {
        if let Some(values) = listed(page, &event) {
            take(page, "", values);
        } else if let Some(t) = moment(&event) {
            page.player.seek(t);
        }
    };
    view! {
        <Variants />
        <p class="lead">{t("page.sizing-lead")}</p>
        <div class="sizing" on:click=choose>
            <SheetView which=|sheets| sheets.sizing request=|| Request::Sizing rest=REST long=true />
            <Show
                when=move || drawn.get()
                fallback=move || view! {
                    <p class="row"><button type="button" class="chip" on:click=move |_| drawn.set(true)>{sentence(&msg!("page.chance", count = chance::DRAWS))}</button></p>
                }
            >
                <SheetView which=|sheets| sheets.sizing request=|| Request::Chance rest=REST long=true />
            </Show>
        </div>
    }
}

/// Time (s) of the part of the run whose line in a chart was clicked.
fn moment(event: &MouseEvent) -> Option<f64> {
    let line = event.target()?.dyn_into::<Element>().ok()?.closest("[data-at]").ok().flatten()?;
    line.get_attribute("data-at")?.parse().ok()
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::machines::form::Value;
    use crate::ui::testing::{mount, settled, until};
    use crate::ui::worker::client::Client;
    use crate::ui::worker::messages::{Response, Sheets};

    fn row(sizing: &str) -> Option<Response> {
        let sizing =
            format!("<table><tbody><tr data-sets=\"{sizing}\"><td><button>M1</button></td></tr></tbody></table>");
        Some(Response::Sheets(Sheets { sizing, ..Sheets::default() }))
    }

    #[wasm_bindgen_test]
    async fn motor_of_the_list_is_taken_into_the_form() {
        let bench = mount(|| {
            Client::here().answer_here(|_, request| match request {
                Request::Sizing => row("motor-x=Works; M=1\nmotor-peak-x=7.5"),
                _ => None,
            });
            view! { <SizingTab /> }
        })
        .await;
        until(|| bench.has("tr button")).await;
        bench.press("tr button").await;
        settled().await;
        let value = |id: &str| bench.page.project.with_untracked(|project| project.values[id].clone());
        assert_eq!(
            (value("motor-x"), value("motor-peak-x")),
            (Value::Text("Works; M=1".to_owned()), Value::Number(7.5))
        );
        bench.page.undo();
        settled().await;
        assert_ne!(value("motor-peak-x"), Value::Number(7.5));
    }

    #[wasm_bindgen_test]
    async fn sizing_waits_until_the_project_rests() {
        let bench = mount(|| {
            Client::here().answer_here(|project, _| row(&format!("motor-x={}", project.name)));
            view! { <SizingTab /> }
        })
        .await;
        assert!(bench.has("[aria-busy=true]") && !bench.has(".sheets tr"));
        until(|| bench.has(".sheets tr")).await;
        assert!(bench.has("[aria-busy=false]"));
    }
}
