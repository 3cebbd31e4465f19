//! Setting a signal only where its value differs.

use leptos::prelude::*;

/// Sets a signal; nothing that follows it runs where the value is the same.
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
