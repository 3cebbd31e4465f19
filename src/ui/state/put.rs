//! Setting a signal only if its value differs.

use leptos::prelude::*;

/// Sets a signal; an equal value runs no effect.
pub(crate) fn put<S>(signal: S, value: S::Value)
where
    S: Update,
    S::Value: PartialEq,
{
    signal.maybe_update(|present| {
        let differs = *present != value;
        if differs {
            *present = value;
        }
        differs
    });
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use std::cell::Cell;
    use std::rc::Rc;

    use crate::ui::testing::{mount, settled};

    #[wasm_bindgen_test]
    async fn put_of_the_same_value_runs_no_effect() {
        let (signal, runs) = (RwSignal::new(1), Rc::new(Cell::new(0)));
        let counted = Rc::clone(&runs);
        let _bench = mount(move || {
            Effect::new(move |_| {
                signal.track();
                counted.set(counted.get() + 1);
            });
        })
        .await;
        for (value, expected) in [(1, 1), (2, 2), (2, 2)] {
            put(signal, value);
            settled().await;
            assert_eq!(runs.get(), expected, "{value}");
        }
    }
}
