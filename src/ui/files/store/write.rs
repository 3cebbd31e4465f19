//! The project in this browser's store: written with its steps of undo, or carried over a reload where the store refuses it.

use std::cell::Cell;

use leptos::prelude::*;

use super::super::{share, shelf};
use crate::ui::dom;
use crate::ui::dom::tab_entry::{carried, carry, drop_carried};
use crate::ui::state::Page;
use crate::ui::state::view::{Kept, PROJECT};
use crate::ui::words::{Tone, t};
use crate::ui::worker::messages::ShelfState;

/// Key of the project's id.
pub(super) const ID: &str = "macroline.id";

/// Key of the project's steps of undo and redo.
pub(super) const STEPS: &str = "macroline.steps";

/// Keys of the texts that this tab's history entry carries over a reload where the store refuses the project.
pub(super) const CARRIED: [&str; 3] = [PROJECT, ID, STEPS];

/// Key of the place that has the latest state of the project: [`IN_STORE`] or [`ON_SHELF`]. Both words have the same length, so that a full
/// store can replace one by the other.
pub(super) const PLACE: &str = "macroline.place";

/// This store has the latest state.
const IN_STORE: &str = "store";

/// The store had no room for the latest state: at most the shelf has it.
const ON_SHELF: &str = "shelf";

/// Stores the project now, then its steps, and notes whether the store had room.
pub(super) fn store_now(page: Page) {
    let ShelfState { id, text, .. } = shelf::present(page);
    // The id before the text: a tab that is notified of the text reads its id. An id without its project would belong to another one.
    let id_before = dom::stored(ID);
    if !dom::store(ID, &id) {
        dom::forget(ID);
    }
    // Without room for both, the steps are dropped for the project.
    let kept = dom::store(PROJECT, &text) || make_room(&text);
    if kept {
        dom::store(STEPS, &page.steps());
        drop_carried(&CARRIED);
    } else {
        dom::forget(ID);
        if let Some(id) = id_before {
            dom::store(ID, &id);
        }
        // A stale state would come back.
        if !carry(&[(PROJECT, &text), (ID, &id), (STEPS, &page.steps())]) {
            drop_carried(&CARRIED);
        }
    }
    if kept || carried(PROJECT).is_some() {
        share::forget_link();
    }
    dom::store(PLACE, if kept { IN_STORE } else { ON_SHELF });
    // A state that has no room in this store may have room in the database.
    shelf::soon(page);
    page.view.kept.set(if kept { Kept::Yes } else { refused() });
    // Once: a small screen shows no state of the store.
    if !kept && !REFUSED.replace(true) {
        page.notices.notify(Tone::Warn, t(refused().words()).to_owned());
    }
}

/// The state of a store that refuses the project.
pub(super) fn refused() -> Kept {
    if dom::storage().is_some() { Kept::No } else { Kept::Denied }
}

thread_local! {
    /// Whether the refusal of the store has been reported to the user.
    static REFUSED: Cell<bool> = const { Cell::new(false) };
}

/// Stores the project in the space of its stored steps; if even that does not suffice, the steps stay stored.
fn make_room(text: &str) -> bool {
    let Some(steps) = dom::stored(STEPS) else { return false };
    dom::forget(STEPS);
    let kept = dom::store(PROJECT, text);
    if !kept {
        dom::store(STEPS, &steps);
    }
    kept
}

/// Whether this store has the latest state of the project. Without a word from the last visit the store is new, full or denied; it is new
/// if it accepts a word.
pub(super) fn has_latest() -> bool {
    match dom::stored(PLACE) {
        Some(place) => place == IN_STORE,
        None => dom::store(PLACE, IN_STORE),
    }
}
