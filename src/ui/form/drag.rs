//! Dragging a number: a pull to the left or right on the field's name or number changes it, as one step of the history.

use std::sync::Arc;

use leptos::ev::PointerEvent;
use leptos::prelude::*;
use leptos::wasm_bindgen::JsCast;
use web_sys::{HtmlElement, HtmlInputElement, MouseEvent};

use super::value::value_of;
use crate::machines::form::{FieldInfo, FieldKindInfo, Value};
use crate::math;
use crate::text::units;
use crate::ui::dom;
use crate::ui::state::Page;

/// Pixels of a step, and pixels before a press is a pull.
const STEP: f64 = 4.0;
const SLACK: f64 = 4.0;

/// Change of a number per step: about a fiftieth of it, as 1, 2 or 5 times a power of ten; fine, a tenth of that; at least its last
/// decimal.
fn step(value: f64, decimals: u8, fine: bool) -> f64 {
    let least = math::pow(10.0, -f64::from(decimals));
    let wanted = math::clamp(value.abs() / 50.0, least, 1e12) * if fine { 0.1 } else { 1.0 };
    math::step_at_most(wanted * (1.0 + 1e-9)).max(least)
}

/// A press that may become a pull.
#[derive(Clone, Copy)]
struct Pull {
    /// Start of the pull in pixels, and the value there.
    x: f64,
    from: f64,
    moved: bool,
    fine: bool,
}

/// The pull of one field. Its element hands it the events of the pointer.
#[derive(Clone)]
pub(super) struct Drag {
    page: Page,
    info: Arc<FieldInfo>,
    pull: StoredValue<Option<Pull>>,
    /// A pull has just ended, so its click is ignored.
    ended: StoredValue<bool>,
}

impl Drag {
    pub(super) fn new(info: &Arc<FieldInfo>) -> Drag {
        let info = Arc::clone(info);
        Drag { page: Page::here(), info, pull: StoredValue::new(None), ended: StoredValue::new(false) }
    }

    fn present(&self) -> Option<f64> {
        match untrack(|| value_of(self.page, &self.info)) {
            Value::Number(value) => Some(value),
            _ => None,
        }
    }

    pub(super) fn press(&self, event: &PointerEvent) {
        let target = dom::target(event);
        // In a focused number the pointer selects text.
        let focused = document().active_element();
        let held = target.filter(|target| {
            target.matches("label, label *, .number").unwrap_or(false) && focused.as_ref() != Some(target)
        });
        self.ended.set_value(false);
        if let (Some(_), Some(from), 0) = (held, self.present(), event.button()) {
            let (x, fine) = (f64::from(event.client_x()), event.shift_key());
            self.pull.set_value(Some(Pull { x, from, moved: false, fine }));
        }
    }

    /// A press on a number does not focus it yet, so that a pull selects no text.
    pub(super) fn press_mouse(&self, event: &MouseEvent) {
        let number = event.target().and_then(|target| target.dyn_into::<HtmlElement>().ok());
        let number = number.filter(|target| target.matches(".number").unwrap_or(false));
        if number.is_some() && self.pull.with_value(Option::is_some) {
            event.prevent_default();
        }
    }

    pub(super) fn pull(&self, event: &PointerEvent) {
        let (Some(mut pull), Some(field)) = (self.pull.get_value(), event.current_target()) else { return };
        let field: HtmlElement = field.unchecked_into();
        let x = f64::from(event.client_x());
        if !pull.moved {
            if (x - pull.x).abs() < SLACK {
                return;
            }
            let _ = field.set_pointer_capture(event.pointer_id());
            let _ = field.class_list().add_1("pulled");
            self.page.hold(true);
            (pull.moved, pull.x) = (true, x);
        } else if pull.fine != event.shift_key() {
            // Finer or coarser from here on.
            (pull.x, pull.fine) = (x, event.shift_key());
            pull.from = self.present().unwrap_or(pull.from);
        }
        self.pull.set_value(Some(pull));
        let FieldKindInfo::Number { unit, min, max, decimals, .. } = self.info.kind else { return };
        let steps = ((x - pull.x) / STEP).trunc();
        let from = self.info.shown(pull.from);
        let moved = from + steps * step(from, units::decimals(decimals, unit), pull.fine);
        dom::mark("input");
        if let Some(value) = self.info.from_displayed(moved) {
            self.page.set(self.info.id, Value::Number(math::clamp(value, min, max)));
        }
        event.prevent_default();
    }

    pub(super) fn release(&self, event: &PointerEvent) {
        let Some(pull) = self.pull.try_update_value(Option::take).flatten() else { return };
        if !pull.moved {
            let number = event.target().and_then(|target| target.dyn_into::<HtmlInputElement>().ok());
            if let Some(number) = number.filter(|target| target.matches(".number").unwrap_or(false)) {
                let _ = number.focus();
                number.select();
            }
        } else {
            self.page.hold(false);
            self.ended.set_value(true);
            if let Some(field) = event.current_target() {
                let _ = field.unchecked_into::<HtmlElement>().class_list().remove_1("pulled");
            }
        }
    }

    /// The click at the end of a pull neither focuses nor opens anything.
    pub(super) fn click(&self, event: &MouseEvent) {
        if self.ended.try_update_value(core::mem::take) == Some(true) {
            event.prevent_default();
        }
    }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::super::field::FormField;
    use super::*;
    use crate::ui::testing::{ViewBench, event, field, mount, settled};

    #[wasm_bindgen_test]
    fn step_is_a_round_part_of_the_number() {
        let steps = [(1200.0, 3), (62.8, 3), (8.0, 3), (6.0, 0), (0.12, 3), (0.0, 2)];
        assert_eq!(steps.map(|(value, decimals)| step(value, decimals, false)), [20.0, 1.0, 0.1, 1.0, 0.002, 0.01]);
        assert_eq!(steps.map(|(value, decimals)| step(value, decimals, true)), [2.0, 0.1, 0.01, 1.0, 0.001, 0.01]);
    }

    async fn pitch() -> ViewBench {
        mount(|| view! { <FormField info=field("pitch") /> }).await
    }

    async fn send(bench: &ViewBench, selector: &str, kind: &str, x: f64, fine: bool) {
        let members = [("clientX", x.into()), ("shiftKey", fine.into()), ("pointerId", 1.into())];
        bench.find(selector).dispatch_event(&event("PointerEvent", kind, &members)).unwrap();
        settled().await;
    }

    #[wasm_bindgen_test]
    async fn pull_on_name_or_number_changes_the_value_in_one_step() {
        for selector in ["label", "#pitch"] {
            let bench = pitch().await;
            send(&bench, selector, "pointerdown", 100.0, false).await;
            for x in [105.0, 125.0, 145.0] {
                send(&bench, selector, "pointermove", x, false).await;
            }
            assert_eq!((bench.setting("pitch"), bench.value("#pitch").as_str()), (Some(Value::Number(9.0)), "9"));
            send(&bench, selector, "pointermove", 65.0, false).await;
            send(&bench, selector, "pointerup", 65.0, false).await;
            assert_eq!(bench.setting("pitch"), Some(Value::Number(7.0)));
            bench.page.undo();
            assert_eq!(bench.setting("pitch"), Some(Value::Number(8.0)));
            assert!(!bench.page.undoable.get_untracked().undo);
        }
    }

    #[wasm_bindgen_test]
    async fn shift_makes_the_steps_finer_from_there() {
        let bench = pitch().await;
        send(&bench, "label", "pointerdown", 0.0, false).await;
        for (x, fine) in [(5.0, false), (25.0, false), (30.0, true), (50.0, true)] {
            send(&bench, "label", "pointermove", x, fine).await;
        }
        assert_eq!(bench.setting("pitch"), Some(Value::Number(8.55)));
    }

    #[wasm_bindgen_test]
    async fn pull_stops_at_the_limits_of_the_field() {
        let bench = pitch().await;
        send(&bench, "label", "pointerdown", 0.0, false).await;
        send(&bench, "label", "pointermove", -5.0, false).await;
        send(&bench, "label", "pointermove", -9000.0, false).await;
        let FieldKindInfo::Number { min, .. } = field("pitch").kind else { panic!("a number") };
        assert_eq!(bench.setting("pitch"), Some(Value::Number(min)));
    }

    #[wasm_bindgen_test]
    async fn press_without_a_pull_changes_nothing() {
        let bench = pitch().await;
        send(&bench, "label", "pointerdown", 10.0, false).await;
        send(&bench, "label", "pointermove", 12.0, false).await;
        send(&bench, "label", "pointerup", 12.0, false).await;
        assert!(!bench.page.undoable.get_untracked().undo);
        bench.press("label").await;
        assert_eq!(document().active_element().unwrap().id(), "pitch");
    }

    #[wasm_bindgen_test]
    async fn number_with_the_focus_keeps_its_pointer() {
        let bench = pitch().await;
        let _ = bench.find("#pitch").unchecked_into::<HtmlElement>().focus();
        send(&bench, "#pitch", "pointerdown", 0.0, false).await;
        send(&bench, "#pitch", "pointermove", 50.0, false).await;
        assert_eq!(bench.setting("pitch"), Some(Value::Number(8.0)));
    }
}
