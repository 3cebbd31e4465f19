//! The pane of the charts: choice of time, saving as a file, and the play head set by a click.

use leptos::wasm_bindgen::JsCast;
use web_sys::{Element, Event, PointerEvent};

use super::dom;
use super::el::{El, button, el};
use super::model::Model;
use super::words::t;
use crate::text::number::filled;
use crate::view::csv;

/// Points of a line in a file.
const POINTS_IN_FILE: usize = 20_000;

/// Seconds that the charts may show; 0 is all that is planned.
const WINDOWS: [f64; 6] = [0.2, 0.5, 2.0, 10.0, 60.0, 0.0];

/// Charts with their choice of time.
pub(super) fn chart_pane(model: Model) -> El {
    let player = model.player;
    let options = WINDOWS.map(|seconds| {
        let label = if seconds > 0.0 { filled("# s", &[seconds]) } else { t("page.all").to_owned() };
        let choose = move || {
            player.window.set(seconds);
            player.refresh_charts();
        };
        button("button.chip", &label, choose).state("aria-pressed", move || player.window.get() == seconds)
    });
    let save = move || {
        let charts = player.all_charts(POINTS_IN_FILE);
        dom::download("timeline.csv", "text/csv", csv::charts(&charts).as_bytes());
    };
    let seek = move |event: Event| {
        let event: &PointerEvent = event.unchecked_ref();
        let target = event.target().and_then(|e| e.dyn_into::<Element>().ok());
        if event.buttons() & 1 == 1
            && let Some(Some(over)) = target.map(|e| e.closest(".over").ok().flatten())
        {
            let area = over.get_bounding_client_rect();
            player.seek_in_page((f64::from(event.client_x()) - area.left()) / area.width());
        }
    };
    let plots = el("div.plots").on("pointerdown", seek).on("pointermove", seek);
    player.set_charts(plots.html().clone());
    let bar = el("div.bar").add(&[
        el("h2").text(t("page.charts")),
        el("div.chips").at("role", "group").label(t("page.window")).add(&options),
        button("button.quiet", t("page.save-csv"), save),
    ]);
    el("section.pane.charts").label(t("page.charts")).add(&[bar, plots])
}
