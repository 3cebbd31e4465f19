//! The film: transport, and one time axis that scrubber, marks and chart share.

mod action_marks;
mod charts;
mod marks;
mod plot;
mod transport;

use leptos::html;
use leptos::prelude::*;
use leptos::wasm_bindgen::JsCast;

use crate::text::catalog::number_text;
use crate::text::number::filled;
use crate::ui::dom;
use crate::ui::parts::Later;
use crate::ui::parts::input::{Choice, filled_part, number};
use crate::ui::state::{Page, put};
use crate::ui::words::{clock, t};
use crate::view::csv;
use charts::Charts;
use marks::Marks;
use plot::Plot;
pub(super) use transport::Transport;

/// Points of a line in a file.
const POINTS_IN_FILE: usize = 20_000;

/// Seconds that film and charts may show; 0 is all that is planned.
const WINDOWS: [f64; 6] = [0.0, 60.0, 10.0, 2.0, 0.5, 0.2];

/// Value of the list while a part that was zoomed in is shown.
const ZOOMED: &str = "zoomed";

/// Transport, time axis, and the choice of chart.
#[component]
pub(crate) fn Film() -> impl IntoView {
    let page = Page::here();
    let player = page.player;
    let plot: NodeRef<html::Div> = NodeRef::new();
    let titles = RwSignal::new(Vec::<&'static str>::new());
    let chosen = RwSignal::new(0_usize);
    let axis = RwSignal::new((0.0, 1.0));
    let charts = StoredValue::new_local(Charts::default());
    player.paint(move |moment| {
        put(axis, moment.axis);
        if let Some(host) = plot.get_untracked() {
            let changed = charts.try_update_value(|charts| charts.frame(&host, moment, chosen.get_untracked()));
            if changed == Some(true) {
                put(titles, charts.with_value(Charts::titles));
            }
        }
    });
    // The first chart of another machine.
    Effect::new(move |_| {
        page.machine.track();
        chosen.set(0);
    });
    let film: NodeRef<html::Section> = NodeRef::new();
    view! {
        <section class="film" aria-label=t("page.transport") node_ref=film>
            <Transport />
            <div class="axis">
                <Marks axis=axis />
                <Scrubber />
                <Plot axis=axis charts=charts plot=plot film=film />
            </div>
            <div class="chart-bar">
                <Later>
                    <ChartChips titles=titles chosen=chosen />
                    <span class="space"></span>
                    <WindowChoice />
                    <button
                        type="button" class="quiet"
                        on:click=move |_| {
                            let charts = player.all_charts(POINTS_IN_FILE);
                            dom::download("timeline.csv", "text/csv", csv::charts(&charts).as_bytes());
                        }
                    >
                        {t("page.save-csv")}
                    </button>
                </Later>
            </div>
        </section>
    }
}

/// Sides on which chips are out of sight.
#[derive(Clone, Copy, PartialEq, Default)]
struct CutSides {
    left: bool,
    right: bool,
}

/// The choice of chart, with an arrow to the chips that are out of sight. The place of the arrow is kept, so that it moves nothing.
#[component]
fn ChartChips(
    /// Titles of the charts.
    titles: RwSignal<Vec<&'static str>>,
    /// The number of the chosen chart.
    chosen: RwSignal<usize>,
) -> impl IntoView {
    let player = Page::here().player;
    let chips: NodeRef<html::Div> = NodeRef::new();
    let cut = RwSignal::new(CutSides::default());
    let measure = move || {
        // The page may be gone.
        if let Some(chips) = chips.try_get_untracked().flatten() {
            let rest = chips.scroll_width() - chips.client_width() - chips.scroll_left();
            put(cut, CutSides { left: chips.scroll_left() > 1, right: rest > 1 });
        }
    };
    chips.on_load(move |chips| dom::on_resize(&chips, measure));
    Effect::new(move |_| {
        titles.track();
        dom::soon(measure);
    });
    // A part of the chips further, and from the last ones back to the first.
    let further = move |_| {
        if let Some(chips) = chips.get_untracked() {
            let next = chips.scroll_left() + 3 * chips.client_width() / 4;
            chips.set_scroll_left(if cut.get_untracked().right { next } else { 0 });
        }
    };
    view! {
        <div
            class="chips" role="group" aria-label=t("page.charts") node_ref=chips on:scroll=move |_| measure()
            class:cut-left=move || cut.get().left class:cut-right=move || cut.get().right>
            <For each=move || titles.get().into_iter().enumerate() key=|(at, title)| (*at, *title) let:row>
                <button
                    type="button" class="chip"
                    aria-pressed=move || (chosen.get() == row.0).to_string()
                    on:click=move |_| {
                        chosen.set(row.0);
                        player.ask();
                    }
                >
                    {t(row.1)}
                </button>
            </For>
        </div>
        <button
            type="button" class="further" title=t("page.more-charts") aria-label=t("page.more-charts")
            class:unseen=move || cut.get() == CutSides::default() on:click=further>
            {move || if cut.get().right { "›" } else { "‹" }}
        </button>
    }
}

/// How many seconds the axis shows.
#[component]
fn WindowChoice() -> impl IntoView {
    let player = Page::here().player;
    let label = |seconds: f64| if seconds > 0.0 { filled("# s", &[seconds]) } else { t("page.all").to_owned() };
    // While a part is zoomed in, the list shows that, and “all” is a choice again.
    let options = move || {
        let zoomed = player.zoom.get().is_some().then(|| (ZOOMED.to_owned(), t("page.zoomed").to_owned()));
        let windows = WINDOWS.map(|seconds| (number_text(seconds, 6), label(seconds)));
        zoomed.into_iter().chain(windows).collect::<Vec<_>>()
    };
    let chosen = move || match player.zoom.get() {
        Some(_) => ZOOMED.to_owned(),
        None => number_text(player.window.get(), 6),
    };
    let choose = move |seconds: String| {
        if let Ok(seconds) = seconds.parse() {
            player.show_window(seconds);
        }
    };
    view! {
        <Choice
            attr:class="window" attr:aria-label=t("page.window") attr:title=t("page.window")
            options=Signal::derive(options) chosen=Signal::derive(chosen) choose=choose
        />
    }
}

/// The slider of the play head.
#[component]
pub(super) fn Scrubber() -> impl IntoView {
    let player = Page::here().player;
    let slider: NodeRef<html::Input> = NodeRef::new();
    let mut last = (0_u64, 0_u64, 0_u64);
    player.paint(move |moment| {
        let Some(slider) = slider.get_untracked() else { return };
        let ms = |seconds: f64| (seconds * 1000.0) as u64;
        let ((from, to), head) = (moment.axis, moment.now.t);
        let at = (ms(from), ms(to), ms(head));
        if at == last {
            return;
        }
        if (at.0, at.1) != (last.0, last.1) {
            slider.set_min(&at.0.to_string());
            slider.set_max(&at.1.to_string());
        }
        slider.set_value(&at.2.to_string());
        dom::set(&slider, "aria-valuetext", &clock(head));
        let style = slider.unchecked_ref::<web_sys::HtmlElement>().style();
        let _ = style.set_property("--part", &filled_part(head, (from, to)));
        last = at;
    });
    let scrub = move |event| {
        player.playing.set(false);
        if let Some(ms) = number(&event) {
            player.seek(ms / 1000.0);
        }
    };
    view! { <input node_ref=slider class="scrub" id="head" type="range" min="0" max="1" aria-label=t("page.head") on:input=scrub /> }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::testing::{ViewBench, event, mount, until};
    use leptos::wasm_bindgen::JsValue;

    async fn film() -> ViewBench {
        let bench = mount(|| view! { <Film /> }).await;
        bench.run().await;
        bench
    }

    #[wasm_bindgen_test]
    async fn every_chart_has_a_chip() {
        let bench = film().await;
        let titles: Vec<&str> = bench.page.player.all_charts(10).iter().map(|chart| t(chart.title)).collect();
        let chips: Vec<String> = bench.all(".chip").iter().filter_map(|chip| chip.text_content()).collect();
        assert_eq!(chips, titles);
        assert!(bench.text("figcaption").starts_with(titles[0]));
    }

    #[wasm_bindgen_test]
    async fn chosen_chart_is_drawn() {
        let bench = film().await;
        bench.press(".chip:nth-of-type(2)").await;
        bench.drawn().await;
        let title = bench.text(".chip:nth-of-type(2)");
        assert!(bench.text("figcaption").starts_with(&title));
        assert_eq!(bench.attribute(".chip:nth-of-type(2)", "aria-pressed"), "true");
        assert_eq!(bench.all(".chip[aria-pressed=true]").len(), 1);
    }

    #[wasm_bindgen_test]
    async fn arrow_leads_to_chips_out_of_sight_and_back() {
        let bench = film().await;
        let chips = bench.find(".chips");
        chips.set_attribute("style", "width: 120px; overflow-x: auto; display: flex; flex: none").unwrap();
        until(|| bench.has(".chips.cut-right")).await;
        assert!(!bench.has(".unseen") && !bench.has(".cut-left"));
        bench.press(".further").await;
        until(|| bench.has(".chips.cut-left")).await;
        chips.set_scroll_left(10_000);
        until(|| !bench.has(".chips.cut-right")).await;
        bench.press(".further").await;
        until(|| bench.has(".chips.cut-right")).await;
        assert_eq!(chips.scroll_left(), 0);
    }

    #[wasm_bindgen_test]
    async fn another_machine_begins_with_its_first_chart() {
        let bench = film().await;
        bench.press(".chip:nth-of-type(2)").await;
        bench.page.change_machine(crate::machines::ALL[1].id());
        bench.run().await;
        assert_eq!(bench.attribute(".chip:nth-of-type(1)", "aria-pressed"), "true");
    }

    #[wasm_bindgen_test]
    async fn window_cuts_the_axis_to_its_seconds() {
        let bench = film().await;
        assert_eq!(bench.value(".window"), "0");
        bench.choose(".window", "2").await;
        bench.seek(3.0).await;
        assert_eq!(
            (bench.attribute("#head", "min").as_str(), bench.attribute("#head", "max").as_str()),
            ("2000", "4000")
        );
        assert_eq!(bench.style("#head", "--part"), "50%");
    }

    /// Ends of the axis, in milliseconds.
    fn ends(bench: &ViewBench) -> (f64, f64) {
        let end = |name| bench.attribute("#head", name).parse::<f64>().unwrap();
        (end("min"), end("max"))
    }

    /// An event of the pointer in the middle of the chart.
    async fn at_middle(bench: &ViewBench, class: &str, kind: &str, more: &[(&str, JsValue)]) {
        let over = bench.find(".over");
        let area = over.get_bounding_client_rect();
        let mut members = vec![("clientX", (area.left() + 0.5 * area.width()).into()), ("bubbles", true.into())];
        members.extend_from_slice(more);
        over.dispatch_event(&event(class, kind, &members)).unwrap();
        bench.drawn().await;
    }

    #[wasm_bindgen_test]
    async fn wheel_zooms_about_the_pointer_and_double_click_goes_back() {
        let bench = film().await;
        until(|| bench.page.player.planned.get_untracked().is_over).await;
        bench.drawn().await;
        let (from, to) = ends(&bench);
        at_middle(&bench, "PointerEvent", "pointermove", &[]).await;
        at_middle(&bench, "WheelEvent", "wheel", &[("deltaY", (-200.0).into())]).await;
        let (a, b) = ends(&bench);
        assert!(
            (0.5 * (a + b) - 0.5 * (from + to)).abs() < 0.01 * (to - from) && b - a < 0.7 * (to - from),
            "{a} {b} {from} {to}"
        );
        at_middle(&bench, "MouseEvent", "dblclick", &[]).await;
        assert_eq!(ends(&bench), (from, to));
    }

    #[wasm_bindgen_test]
    async fn keys_zoom_about_the_pointer_or_the_head() {
        let bench = film().await;
        bench.seek(2.0).await;
        let (from, to) = ends(&bench);
        bench.key("#head", "+", false).await;
        bench.drawn().await;
        let (a, b) = ends(&bench);
        assert!(((b - a) / (to - from) - 0.5).abs() < 0.01 && (a..b).contains(&2000.0), "{a} {b}");
        bench.key("#head", "0", false).await;
        bench.drawn().await;
        assert!(ends(&bench).1 >= to);
    }

    #[wasm_bindgen_test]
    async fn zoomed_axis_follows_the_head_once_it_moves() {
        let bench = film().await;
        bench.page.player.zoom_by(0.1, 0.0);
        bench.drawn().await;
        let (_, b) = ends(&bench);
        bench.seek(b / 1000.0 * 1.5).await;
        bench.drawn().await;
        assert!((ends(&bench).0 - b).abs() <= 1.0, "{b} {:?}", ends(&bench));
    }

    #[wasm_bindgen_test]
    async fn two_fingers_zoom() {
        let bench = film().await;
        let (from, to) = ends(&bench);
        let over = bench.find(".over").get_bounding_client_rect();
        for (kind, id, part) in [("pointerdown", 1, 0.4), ("pointerdown", 2, 0.6), ("pointermove", 2, 0.8)] {
            let x = over.left() + part * over.width();
            let members: [(&str, JsValue); 4] = [
                ("clientX", x.into()),
                ("pointerId", id.into()),
                ("pointerType", "touch".into()),
                ("buttons", 1.into()),
            ];
            bench.find(".over").dispatch_event(&event("PointerEvent", kind, &members)).unwrap();
        }
        bench.drawn().await;
        let (a, b) = ends(&bench);
        assert!(b - a < 0.7 * (to - from), "{a} {b}");
    }

    #[wasm_bindgen_test]
    async fn scrubber_moves_the_head_and_names_the_time() {
        let bench = film().await;
        bench.page.player.playing.set(true);
        bench.type_into("#head", "1500").await;
        let player = bench.page.player;
        until(move || player.now.with_untracked(|now| now.t) == 1.5).await;
        assert!(!player.playing.get_untracked());
        assert_eq!(bench.attribute("#head", "aria-valuetext"), "00:01.5000");
    }

    #[wasm_bindgen_test]
    async fn cursor_of_the_chart_follows_the_head() {
        let bench = film().await;
        bench.choose(".window", "2").await;
        bench.seek(1.0).await;
        assert_eq!(bench.style(".cursor", "transform"), "translateX(50%)");
        assert!(!bench.text(".legend b").is_empty());
    }
}
