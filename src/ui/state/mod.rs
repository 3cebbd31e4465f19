//! What the page knows, as signals: the project and what follows from it, the program, the run, what is shown.

mod entries;

mod history;

pub(crate) mod notices;

pub(crate) mod operator;

pub(crate) mod page;

pub(crate) mod player;

pub(crate) mod program;

pub(crate) mod stepping;

pub(crate) mod view;

pub(crate) mod walk;

pub(crate) use page::Page;

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
