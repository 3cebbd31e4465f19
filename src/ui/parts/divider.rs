//! A divider between two columns: dragged or moved by arrow keys, and remembered.

use leptos::ev::{KeyboardEvent, PointerEvent};
use leptos::html;
use leptos::prelude::*;
use leptos::wasm_bindgen::JsCast;
use web_sys::HtmlElement;

use crate::math;
use crate::text::number::filled;
use crate::ui::dom::tab_entry::{remember, remembered};
use crate::ui::words::t;

/// Least and greatest width of a column, in pixels.
const WIDTHS: (f64, f64) = (256.0, 640.0);

/// Pixels of an arrow key.
const STEP: f64 = 16.0;

fn set_width(property: &str, width: f64) {
    let root = document().document_element().and_then(|root| root.dyn_into::<HtmlElement>().ok());
    if let Some(root) = root {
        let _ = root.style().set_property(property, &filled("#px", &[width]));
    }
}

/// The divider at the edge of a column whose width is a property of the style sheet.
#[component]
pub(crate) fn Divider(
    /// The property with the width of the column.
    property: &'static str,
    /// Catalog id of its name.
    label: &'static str,
    /// 1 where the column grows to the right, −1 where it grows to the left.
    grows: f64,
) -> impl IntoView {
    let key = format!("macroline.width{property}");
    let kept = remembered(&key).and_then(|text| text.parse::<f64>().ok()).filter(|width| width.is_finite());
    let width = RwSignal::new(kept.map(|width| math::clamp(width, WIDTHS.0, WIDTHS.1)));
    Effect::new(move |_| {
        if let Some(width) = width.get() {
            set_width(property, width);
        }
    });
    let handle: NodeRef<html::Div> = NodeRef::new();
    // The column is the neighbour of its divider.
    let present = move || {
        let handle = handle.get_untracked()?;
        let column = if grows > 0.0 { handle.previous_element_sibling() } else { handle.next_element_sibling() };
        Some(column?.get_bounding_client_rect().width())
    };
    let take = move |new: f64| {
        let new = math::clamp(new, WIDTHS.0, WIDTHS.1).round();
        width.set(Some(new));
        remember(&key, &new.to_string());
    };
    let begun = StoredValue::new(None::<(f64, f64)>);
    let (dragged, pressed) = (take.clone(), take);
    let down = move |event: PointerEvent| {
        if let (Some(handle), Some(width)) = (handle.get_untracked(), present()) {
            let _ = handle.set_pointer_capture(event.pointer_id());
            begun.set_value(Some((f64::from(event.client_x()), width)));
        }
    };
    let drag = move |event: PointerEvent| {
        if let Some((x, width)) = begun.get_value() {
            dragged(width + grows * (f64::from(event.client_x()) - x));
        }
    };
    let press = move |event: KeyboardEvent| {
        let by = match event.key().as_str() {
            "ArrowRight" => STEP,
            "ArrowLeft" => -STEP,
            _ => return,
        };
        event.prevent_default();
        if let Some(width) = present() {
            pressed(width + grows * by);
        }
    };
    let now = move || width.get().unwrap_or(272.0).to_string();
    view! {
        <div
            class="divider" role="separator" aria-orientation="vertical" tabindex="0" node_ref=handle
            aria-label=t(label) aria-valuenow=now aria-valuemin=WIDTHS.0.to_string() aria-valuemax=WIDTHS.1.to_string()
            on:pointerdown=down on:pointermove=drag on:pointerup=move |_| begun.set_value(None) on:keydown=press
        ></div>
    }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::dom;
    use crate::ui::testing::{ViewBench, mount, mount_project, project};

    const KEY: &str = "macroline.width--left";

    fn columns(width: &'static str) -> impl IntoView {
        view! { <div style:width=width></div><Divider property="--left" label="page.divide-form" grows=1.0 /> }
    }

    async fn divider(width: &'static str) -> ViewBench {
        mount(move || columns(width)).await
    }

    #[wasm_bindgen_test]
    async fn arrow_keys_move_the_divider() {
        let bench = divider("300px").await;
        bench.key(".divider", "ArrowRight", false).await;
        assert_eq!(bench.attribute(".divider", "aria-valuenow"), "316");
        bench.key(".divider", "ArrowLeft", false).await;
        assert_eq!(bench.attribute(".divider", "aria-valuenow"), "284");
        let root: HtmlElement = document().document_element().unwrap().unchecked_into();
        assert_eq!(root.style().get_property_value("--left").unwrap(), "284px");
    }

    #[wasm_bindgen_test]
    async fn divider_to_the_left_of_its_column_grows_it_leftwards() {
        let bench = mount(|| {
            view! { <Divider property="--right" label="page.divide-side" grows=-1.0 /><div style:width="300px"></div> }
        })
        .await;
        bench.key(".divider", "ArrowLeft", false).await;
        assert_eq!(bench.attribute(".divider", "aria-valuenow"), "316");
    }

    #[wasm_bindgen_test]
    async fn divider_stops_at_its_limits() {
        let bench = divider("639px").await;
        bench.key(".divider", "ArrowRight", false).await;
        assert_eq!(bench.attribute(".divider", "aria-valuenow"), bench.attribute(".divider", "aria-valuemax"));
        let bench = divider("221px").await;
        bench.key(".divider", "ArrowLeft", false).await;
        assert_eq!(bench.attribute(".divider", "aria-valuenow"), bench.attribute(".divider", "aria-valuemin"));
    }

    #[wasm_bindgen_test]
    async fn width_is_remembered() {
        let bench = divider("300px").await;
        bench.key(".divider", "ArrowRight", false).await;
        drop(bench);
        assert_eq!(dom::stored(KEY).as_deref(), Some("316"));
        let bench = mount_project(project(), || columns("300px")).await;
        assert_eq!(bench.attribute(".divider", "aria-valuenow"), "316");
    }

    #[wasm_bindgen_test]
    async fn other_keys_are_left_to_the_page() {
        let bench = divider("300px").await;
        bench.key(".divider", "ArrowDown", false).await;
        assert_eq!(dom::stored(KEY), None);
    }
}
