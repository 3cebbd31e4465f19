//! The chart under the pointer: values at a time, a press that sets the play head, and zoom by wheel, fingers and keys.

use leptos::ev::PointerEvent;
use leptos::html;
use leptos::prelude::*;
use web_sys::{DomRect, Element, WheelEvent};

use super::charts::Charts;
use crate::math;
use crate::text::catalog::number_text;
use crate::text::number::filled;
use crate::text::{columns, units};
use crate::ui::dom;
use crate::ui::state::Page;
use crate::ui::state::player::Player;
use crate::ui::words::t;
use crate::view::Chart;

/// Pixels of a letter of the readout, and of its margins.
const LETTER: f64 = 7.3;
const MARGINS: f64 = 26.0;

/// Fingers on the chart, by their number and place in pixels.
#[derive(Clone, Copy)]
struct Fingers(StoredValue<Vec<(i32, f64)>>);

impl Default for Fingers {
    fn default() -> Fingers {
        Fingers(StoredValue::new(Vec::new()))
    }
}

impl Fingers {
    /// Pixels between two fingers.
    fn are_apart(self) -> Option<f64> {
        self.0.with_value(|fingers| match fingers[..] {
            [(_, a), (_, b)] => Some((a - b).abs()),
            _ => None,
        })
    }

    /// Records a finger as down or lifted; with two fingers down, returns the ratio of their old to their new distance.
    fn touch(self, event: &PointerEvent, down: bool) -> Option<f64> {
        if event.pointer_type() != "touch" {
            return None;
        }
        let before = self.are_apart();
        self.0.update_value(|fingers| {
            fingers.retain(|finger| finger.0 != event.pointer_id());
            if down {
                fingers.push((event.pointer_id(), f64::from(event.client_x())));
            }
        });
        Some(before? / self.are_apart()?.max(1.0))
    }
}

/// Keys zoom where the pointer is over the chart or the focus in the film: about the pointer, or about the play head.
fn keys(player: Player, film: NodeRef<html::Section>, pointed: impl Fn() -> Option<f64> + 'static) {
    let keys = window_event_listener(leptos::ev::keydown, move |event| {
        let target = dom::target(&event);
        let within = |target: &Element| film.get_untracked().is_some_and(|film| film.contains(Some(target)));
        let Some(target) = target.filter(|target| !dom::takes_text(target)) else { return };
        let pointed = pointed();
        let plain = !(event.ctrl_key() || event.meta_key() || event.alt_key());
        if !plain || pointed.is_none() && !within(&target) {
            return;
        }
        let about = pointed.unwrap_or_else(|| player.now.with_untracked(|now| now.t));
        match event.key().as_str() {
            "+" | "=" => player.zoom_by(0.5, about),
            "-" => player.zoom_by(2.0, about),
            "0" => player.show_window(0.0),
            _ => return,
        }
        event.prevent_default();
    });
    on_cleanup(move || keys.remove());
}

/// The chart's place, with the values under the pointer.
#[component]
pub(super) fn Plot(
    /// Ends of the shown time, in seconds.
    axis: RwSignal<(f64, f64)>,
    /// The charts.
    charts: StoredValue<Charts, LocalStorage>,
    /// The element that they are drawn in.
    plot: NodeRef<html::Div>,
    /// The film around them.
    film: NodeRef<html::Section>,
) -> impl IntoView {
    let player = Page::here().player;
    // The time under the pointer, as a part of the axis, and the pixels of the axis.
    let pointed = RwSignal::new(None::<f64>);
    let width = StoredValue::new(0.0_f64);
    let time = move |part: f64| {
        let (from, to) = axis.get();
        from + part * (to - from)
    };
    let fingers = Fingers::default();
    let touch = move |event: &PointerEvent, down: bool| {
        if let (Some(factor), Some(part)) = (fingers.touch(event, down), pointed.get_untracked()) {
            player.zoom_by(factor, untrack(|| time(part)));
        }
    };
    let point = move |event: PointerEvent| {
        let over = dom::closest(&event, ".over");
        let area = over.map(|over| over.get_bounding_client_rect());
        let share = |area: DomRect| {
            width.set_value(area.width());
            (f64::from(event.client_x()) - area.left()) / area.width()
        };
        let part = area.map(|area| math::clamp(share(area), 0.0, 1.0));
        pointed.set(part);
        touch(&event, event.buttons() & 1 == 1);
        let alone = fingers.are_apart().is_none();
        if let Some(part) = part.filter(|_| alone && event.buttons() & 1 == 1) {
            player.playing.set(false);
            player.seek(untrack(|| time(part)));
        }
    };
    let wheel = move |event: WheelEvent| {
        if let Some(part) = pointed.get_untracked() {
            event.prevent_default();
            player.zoom_by(math::exp(math::clamp(event.delta_y(), -200.0, 200.0) / 400.0), untrack(|| time(part)));
        }
    };
    keys(player, film, move || pointed.get_untracked().map(|part| untrack(|| time(part))));
    // The values with their unit: one chart of all has values to show.
    let values = move |at: f64| {
        let with_unit = |chart: Chart| {
            let unit = units::unit(chart.unit);
            let texts = charts.with_value(|charts| charts.value_texts(vec![chart]));
            (!texts.is_empty())
                .then(move || texts.into_iter().map(move |text| format!("{text} {unit}").trim_end().to_owned()))
        };
        let texts = player.charts(at..=at, 1).into_iter().find_map(with_unit);
        texts.into_iter().flatten().collect::<Vec<_>>().join("  ")
    };
    let readout = move || {
        let part = pointed.get()?;
        let seconds = time(part);
        let text = format!("{} s  {}", number_text(seconds, 3), values(seconds));
        // On the left of the pointer only where it would leave the plot on the right.
        let has_room = (1.0 - part) * width.get_value() >= LETTER * columns(&text) as f64 + MARGINS;
        let class = if part > 0.5 && !has_room { "pointed left" } else { "pointed" };
        Some(view! { <span class=class style:left=filled("#%", &[100.0 * part])>{text}</span> })
    };
    let stops_at_once = Memo::new(move |_| player.planned.with(|planned| planned.is_over && planned.end <= 0.0));
    view! {
        <div
            class="plots" class:hairline=move || pointed.get().is_some()
            style:--pointed=move || filled("#%", &[100.0 * pointed.get().unwrap_or_default()]) node_ref=plot
            on:pointerdown=point on:pointermove=point on:wheel=wheel
            on:pointerup=move |event| touch(&event, false) on:pointercancel=move |event| touch(&event, false)
            on:pointerleave=move |event| {
                touch(&event, false);
                pointed.set(None);
            }
            on:dblclick=move |_| player.show_window(0.0)
        ></div>
        {readout}
        <Show when=move || stops_at_once.get()><p class="no-run">{t("page.no-run")}</p></Show>
    }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::machine::film::Film;
    use crate::ui::testing::{ViewBench, event, mount, until};

    /// A pointer at a part of the chart's width; `buttons` is 1 for a press.
    async fn point(bench: &ViewBench, kind: &str, part: f64, buttons: i32) {
        let over = bench.find(".over");
        let area = over.get_bounding_client_rect();
        let members = [("clientX", (area.left() + part * area.width()).into()), ("buttons", buttons.into())];
        over.dispatch_event(&event("PointerEvent", kind, &members)).unwrap();
        bench.drawn().await;
    }

    async fn film() -> ViewBench {
        let bench = mount(|| view! { <Film /> }).await;
        bench.run().await;
        bench.choose(".window", "2").await;
        bench.seek(1.0).await;
        bench
    }

    #[wasm_bindgen_test]
    async fn pointer_shows_time_and_values_until_it_leaves() {
        let bench = film().await;
        point(&bench, "pointermove", 0.25, 0).await;
        let text = bench.text(".pointed");
        assert!(text.starts_with("0.5") && text.split("  ").count() > 1, "{text}");
        assert!(text.ends_with(" mm"), "{text}");
        assert!(!bench.has(".pointed.left") && bench.has(".plots.hairline"));
        assert_eq!(bench.style(".plots", "--pointed"), "25%");
        // It changes sides where it would leave the plot.
        point(&bench, "pointermove", 1.0, 0).await;
        assert!(bench.text(".pointed.left").starts_with('2'));
        bench.find(".plots").dispatch_event(&event("PointerEvent", "pointerleave", &[])).unwrap();
        bench.drawn().await;
        assert!(!bench.has(".pointed") && !bench.has(".hairline"));
    }

    #[wasm_bindgen_test]
    async fn run_without_time_has_a_sentence_in_place_of_curves() {
        let bench = film().await;
        assert!(!bench.has(".no-run"));
        bench.page.edit(|project| project.edited = project.listing());
        bench.run().await;
        assert_eq!(bench.text(".no-run"), t("page.no-run"));
    }

    #[wasm_bindgen_test]
    async fn press_sets_the_head_and_stops_the_play() {
        let bench = film().await;
        let player = bench.page.player;
        player.playing.set(true);
        point(&bench, "pointermove", 0.25, 0).await;
        assert!(player.playing.get_untracked(), "to look is not to press");
        player.playing.set(false);
        bench.seek(1.0).await;
        player.playing.set(true);
        point(&bench, "pointerdown", 0.25, 1).await;
        assert!(!player.playing.get_untracked());
        until(move || player.now.with_untracked(|now| now.t) < 1.0).await;
    }
}
