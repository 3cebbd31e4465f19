//! Breakpoints of the debugger beside the lines of the editor.

use leptos::prelude::*;
use leptos::wasm_bindgen::JsValue;
use leptos::wasm_bindgen::closure::Closure;

use crate::text::{FileId, LineIndex, Place};
use crate::ui::dom::script::table;
use crate::ui::state::{Page, stepping};
use crate::ui::words::sentence;

/// Places and conditions of the breakpoints. The debugger changes with every frame of a run, the breakpoints do not.
pub(super) fn all(page: Page) -> Memo<Vec<(Place, String)>> {
    Memo::new(move |_| {
        page.player.stepper.with(|stepper| {
            let points = stepper.points.list().iter();
            points.filter_map(|point| Some((point.place?, point.condition.clone()))).collect()
        })
    })
}

/// Line and condition of each breakpoint in a file.
pub(super) fn lines(page: Page, file: usize, all: &[(Place, String)]) -> JsValue {
    let here = || all.iter().filter(|(place, _)| usize::from(place.file.0) == file);
    let text = here().next().map(|_| page.program.text(file)).unwrap_or_default();
    let lines = LineIndex::new(&text);
    table(here().map(|(place, condition)| vec![lines.line_of(place.span.start).into(), condition.into()]))
}

/// The function for the editor that sets or removes a breakpoint at a line of the chosen file, and announces which
/// of both it did.
pub(super) fn toggle(page: Page) -> JsValue {
    let toggle = move |line: JsValue| {
        page.take_typed();
        let file = FileId(page.view.file.get_untracked() as u16);
        let count = move || page.player.stepper.with_untracked(|stepper| stepper.points.list().len());
        let before = count();
        let line = line.as_f64().unwrap_or_default() as u32;
        page.player.stepper.update(|stepper| stepper.cursor = Some((file, line)));
        if !stepping::set_point(page, None) {
            return;
        }
        let last =
            || page.player.stepper.with_untracked(|stepper| stepper.points.list().last().and_then(|point| point.place));
        let place = (count() > before).then(last).flatten().and_then(|place| page.place_words(place));
        page.notices.announce(match place {
            Some(place) => sentence(&crate::msg!("page.point-set", place)),
            None => sentence(&crate::msg!("page.point-removed")),
        });
    };
    Closure::<dyn Fn(JsValue)>::new(toggle).into_js_value()
}

#[cfg(test)]
mod tests {
    use js_sys::{Array, Function};
    use leptos::wasm_bindgen::JsCast;
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::testing::{mount, settled};

    #[wasm_bindgen_test]
    async fn line_gets_a_breakpoint_and_loses_it() {
        let bench = mount(|| ()).await;
        let page = bench.page;
        let toggle: Function = toggle(page).unchecked_into();
        let text = page.program.text(0);
        let block = 1 + text.lines().position(|line| line.starts_with("N2 ")).unwrap() as u32;
        let lines = move || {
            let all = page.player.stepper.with_untracked(|stepper| {
                let points = stepper.points.list().iter();
                points.filter_map(|point| Some((point.place?, point.condition.clone()))).collect::<Vec<_>>()
            });
            let rows: Array = lines(page, 0, &all).unchecked_into();
            rows.iter().filter_map(|row| row.unchecked_into::<Array>().get(0).as_f64()).collect::<Vec<_>>()
        };
        toggle.call1(&JsValue::NULL, &block.into()).unwrap();
        assert_eq!(lines(), [f64::from(block)]);
        assert!(page.notices.announcement.get_untracked().contains(&block.to_string()));
        toggle.call1(&JsValue::NULL, &block.into()).unwrap();
        assert_eq!(lines(), [0.0; 0]);
        settled().await;
    }
}
