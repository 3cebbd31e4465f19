//! The film: transport, and one time axis that scrubber, marks and chart share.

use leptos::ev::PointerEvent;
use leptos::html;
use leptos::prelude::*;
use leptos::wasm_bindgen::JsCast;
use web_sys::{DomRect, Element};

use super::charts::Charts;
use super::marks::Marks;
use super::transport::Transport;
use crate::math;
use crate::text::catalog::number_text;
use crate::text::number::filled;
use crate::ui::dom;
use crate::ui::parts::Later;
use crate::ui::parts::input::{Choice, filled_part, number};
use crate::ui::state::{Page, put};
use crate::ui::words::{clock, t};
use crate::view::csv;

/// Points of a line in a file.
const POINTS_IN_FILE: usize = 20_000;

/// Seconds that film and charts may show; 0 is all that is planned.
const WINDOWS: [f64; 6] = [0.0, 60.0, 10.0, 2.0, 0.5, 0.2];

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
    // The time under the pointer, as a part of the axis.
    let pointed = RwSignal::new(None::<f64>);
    let time = move |part: f64| {
        let (from, to) = axis.get();
        from + part * (to - from)
    };
    let point = move |event: PointerEvent| {
        let target = event.target().and_then(|target| target.dyn_into::<Element>().ok());
        let over = target.and_then(|target| target.closest(".over").ok().flatten());
        let area = over.map(|over| over.get_bounding_client_rect());
        let share = |area: DomRect| (f64::from(event.client_x()) - area.left()) / area.width();
        let part = area.map(|area| math::clamp(share(area), 0.0, 1.0));
        pointed.set(part);
        if let Some(part) = part.filter(|_| event.buttons() & 1 == 1) {
            player.playing.set(false);
            player.seek(untrack(|| time(part)));
        }
    };
    let readout = move || {
        let part = pointed.get()?;
        let seconds = time(part);
        let values = charts.with_value(|charts| charts.values_at(seconds));
        let text = format!("{} s  {}", number_text(seconds, 3), values.join("  "));
        let class = if part > 0.5 { "pointed left" } else { "pointed" };
        Some(view! { <span class=class style:left=filled("#%", &[100.0 * part])>{text}</span> })
    };
    view! {
        <section class="film" aria-label=t("page.transport")>
            <Transport />
            <div class="axis">
                <Marks axis=axis />
                <Scrubber />
                <div class="plots" node_ref=plot on:pointerdown=point on:pointermove=point on:pointerleave=move |_| pointed.set(None)></div>
                {readout}
            </div>
            <div class="chart-bar">
                <Later>
                    <div class="chips" role="group" aria-label=t("page.charts")>
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

/// How many seconds the axis shows.
#[component]
fn WindowChoice() -> impl IntoView {
    let player = Page::here().player;
    let label = |seconds: f64| if seconds > 0.0 { filled("# s", &[seconds]) } else { t("page.all").to_owned() };
    let options = WINDOWS.map(|seconds| (number_text(seconds, 6), label(seconds))).to_vec();
    let choose = move |seconds: String| {
        if let Ok(seconds) = seconds.parse() {
            player.window.set(seconds);
            player.ask();
        }
    };
    view! {
        <Choice
            attr:class="window" attr:aria-label=t("page.window") attr:title=t("page.window")
            options=Signal::stored(options) chosen=Signal::derive(move || number_text(player.window.get(), 6)) choose=choose
        />
    }
}

/// The slider of the play head.
#[component]
fn Scrubber() -> impl IntoView {
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
    use crate::ui::testing::{Bench, mount, until};

    async fn film() -> Bench {
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

    #[wasm_bindgen_test]
    async fn scrubber_moves_the_head_and_says_the_time() {
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
