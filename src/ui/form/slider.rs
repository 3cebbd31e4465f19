//! The slider of a product field.

use std::sync::Arc;

use leptos::prelude::*;

use super::value::value_of;
use crate::machines::form::{FieldInfo, FieldKindInfo, Value};
use crate::math;
use crate::text::units;
use crate::ui::dom;
use crate::ui::parts::input::{filled_part, number};
use crate::ui::state::Page;
use crate::ui::words::t;

/// Positions of a slider.
const POSITIONS: f64 = 400.0;

/// The range of a slider and its step, in the unit that is shown: from a quarter of the present value (in the unit of the project) to four
/// times, widened to the default, within the limits of the field.
fn reach(info: &FieldInfo, present: f64) -> Option<(f64, f64, f64)> {
    let FieldKindInfo::Number { unit, min, max, default, step, .. } = info.kind else { return None };
    let centre = if present > 0.0 { present } else { default };
    let low = (centre / 4.0).min(default).min(present);
    let high = (centre * 4.0).max(default).max(present);
    let [low, high] = [low, high].map(|end| info.shown(math::clamp(end, min, max)));
    Some((low, high, units::step(step, unit)))
}

/// The value at a position: logarithmic, so that halving and doubling are equally far.
fn at(position: f64, low: f64, high: f64, step: f64) -> f64 {
    let part = position / POSITIONS;
    let value = if low > 0.0 { low * math::exp(part * math::ln(high / low)) } else { low + part * (high - low) };
    math::clamp((value / step).round() * step, low, high)
}

/// The position of a value.
fn position(value: f64, low: f64, high: f64) -> f64 {
    let value = math::clamp(value, low, high);
    let part = if low > 0.0 { math::ln(value / low) / math::ln(high / low) } else { (value - low) / (high - low) };
    (part * POSITIONS).round()
}

/// The slider; the field beside it takes any value, the slider the usual ones.
#[component]
pub(super) fn Slider(
    /// The field's row.
    info: Arc<FieldInfo>,
) -> impl IntoView {
    let page = Page::here();
    let number_of = move |row: &FieldInfo| match value_of(page, row) {
        Value::Number(value) => value,
        _ => 0.0,
    };
    let (low, high, step) = reach(&info, untrack(|| number_of(&info)))?;
    if low >= high {
        return None;
    }
    let label = t(info.label);
    let id = info.id;
    let row = Arc::clone(&info);
    // Sliding keeps the range; a value from elsewhere beyond it is the centre of the next one.
    let range = Memo::new(move |old: Option<&(f64, f64)>| {
        let present = number_of(&row);
        let shown = row.shown(present);
        let (low, high) = old.copied().unwrap_or((low, high));
        let is_within = (low - step / 2.0..=high + step / 2.0).contains(&shown);
        let other = || reach(&row, present).map(|(low, high, _)| (low, high));
        Some((low, high)).filter(|_| is_within).or_else(other).unwrap_or((low, high))
    });
    let row = Arc::clone(&info);
    let place = Memo::new(move |_| {
        let (low, high) = range.get();
        position(row.shown(number_of(&row)), low, high)
    });
    let slide = move |event: web_sys::Event| {
        let Some(position) = number(&event) else { return };
        dom::mark("input");
        let (low, high) = range.get_untracked();
        if let Some(value) = info.from_displayed(at(position, low, high, step)) {
            page.set(id, Value::Number(value));
        }
    };
    Some(view! {
        <input
            type="range" class="slide" min="0" max="400" tabindex="-1" aria-label=label
            prop:value=move || place.get().to_string()
            style:--part=move || filled_part(place.get(), (0.0, POSITIONS))
            on:input=slide
        />
    })
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::testing::{InInches, ViewBench, field, mount, settled, until};

    async fn mounted() -> ViewBench {
        mount(|| view! { <Slider info=Arc::new(field("pitch")) /> }).await
    }

    #[wasm_bindgen_test]
    fn halving_and_doubling_are_equally_far() {
        let [half, one, double] = [4.0, 8.0, 16.0].map(|value| position(value, 2.0, 32.0));
        assert_eq!([half, one, double], [100.0, 200.0, 300.0]);
    }

    #[wasm_bindgen_test]
    fn position_and_value_agree_at_every_step() {
        for place in 0..=400 {
            let value = at(f64::from(place), 2.0, 32.0, 0.001);
            assert_eq!(position(value, 2.0, 32.0), f64::from(place));
        }
    }

    #[wasm_bindgen_test]
    async fn value_is_in_the_middle_of_the_slider() {
        let bench = mounted().await;
        assert_eq!((bench.value("input").as_str(), bench.style("input", "--part").as_str()), ("200", "50%"));
        assert_eq!(bench.attribute("input", "aria-label"), t(field("pitch").label));
    }

    #[wasm_bindgen_test]
    async fn slider_sets_its_field() {
        let bench = mounted().await;
        bench.type_into("input", "300").await;
        assert_eq!(bench.setting("pitch"), Some(Value::Number(16.0)));
        bench.page.undo();
        settled().await;
        assert_eq!(bench.value("input"), "200");
    }

    #[wasm_bindgen_test]
    async fn dragging_ends_with_the_whole_run() {
        let bench = mounted().await;
        bench.run().await;
        for position in 201..=220 {
            bench.type_into("input", &position.to_string()).await;
        }
        let player = bench.page.player;
        let end = move || player.ask_planner(|run| run.timeline().end());
        // The run is planned whole again, and the page shows it.
        until(move || player.planned.get_untracked().is_over && end() == Some(player.planned.get_untracked().end))
            .await;
    }

    #[wasm_bindgen_test]
    async fn slider_in_inches_goes_in_steps_of_inches() {
        let _inches = InInches::new();
        let bench = mounted().await;
        assert_eq!(bench.value("input"), "200");
        bench.type_into("input", "300").await;
        let shown = field("pitch").text(&bench.setting("pitch").unwrap());
        assert_eq!((shown.as_str(), bench.setting("pitch")), ("0.63", Some(Value::Number(16.002))));
    }

    #[wasm_bindgen_test]
    async fn slider_reaches_a_value_from_elsewhere() {
        let bench = mounted().await;
        bench.page.set("pitch", Value::Number(50.0));
        settled().await;
        let (low, high, _) = reach(&field("pitch"), 50.0).unwrap();
        assert!(low <= 8.0 && high > 50.0, "{low} {high}");
        assert_eq!(bench.value("input"), position(50.0, low, high).to_string());
        bench.type_into("input", "400").await;
        assert_eq!((bench.value("input").as_str(), bench.setting("pitch")), ("400", Some(Value::Number(high))));
    }

    #[wasm_bindgen_test]
    async fn slider_keeps_its_range_while_it_slides() {
        let bench = mounted().await;
        for (position, value) in [("400", 32.0), ("200", 8.0), ("0", 2.0), ("300", 16.0)] {
            bench.type_into("input", position).await;
            assert_eq!((bench.value("input").as_str(), bench.setting("pitch")), (position, Some(Value::Number(value))));
        }
    }

    #[wasm_bindgen_test]
    fn range_has_the_present_value_and_the_default() {
        // The default is 8.
        let ends = |present| reach(&field("pitch"), present).map(|(low, high, _)| (low, high)).unwrap();
        assert_eq!([ends(8.0), ends(10.0)], [(2.0, 32.0), (2.5, 40.0)]);
        assert_eq!(ends(48.0).0, 8.0);
        assert_eq!(ends(1.0).1, 8.0);
    }

    #[wasm_bindgen_test]
    fn slider_keeps_the_limits_of_its_field() {
        let mut info = field("pitch");
        if let FieldKindInfo::Number { min, max, .. } = &mut info.kind {
            (*min, *max) = (5.0, 10.0);
        }
        let (low, high, ..) = reach(&info, 8.0).unwrap();
        assert_eq!((low, high), (5.0, 10.0));
    }

    #[wasm_bindgen_test]
    async fn sliding_mends_a_wrong_entry() {
        let bench = mounted().await;
        bench.page.entries.refuse("pitch", field("pitch").read_metric("x").map(|_| ()).unwrap_err().as_ref().clone());
        bench.type_into("input", "300").await;
        assert!(bench.page.entries.refused("pitch").is_none());
    }
}
