//! Work that waits for its turn: one piece in a task of its own after the other, so that the browser can paint and answer in between.

use std::cell::RefCell;
use std::collections::VecDeque;
use std::time::Duration;

use leptos::prelude::set_timeout;

type Work = Box<dyn FnOnce()>;

thread_local! {
    static WAITING: RefCell<VecDeque<Work>> = const { RefCell::new(VecDeque::new()) };
    static LAST: RefCell<VecDeque<Work>> = const { RefCell::new(VecDeque::new()) };
}

/// Runs `work` in a task of its own, after all work that already waits.
pub(crate) fn in_turn(work: impl FnOnce() + 'static) {
    let waiting = WAITING.with_borrow_mut(|waiting| {
        waiting.push_back(Box::new(work));
        waiting.len()
    });
    if waiting == 1 {
        set_timeout(next, Duration::ZERO);
    }
}

/// Runs the first piece of work. It stays in the queue while it runs, so that work it adds comes after the work that waits.
fn next() {
    let work =
        WAITING.with_borrow_mut(|waiting| waiting.front_mut().map(|first| core::mem::replace(first, Box::new(|| ()))));
    if let Some(work) = work {
        work();
    }
    let more = WAITING.with_borrow_mut(|waiting| {
        waiting.pop_front();
        if waiting.is_empty() {
            waiting.extend(LAST.with_borrow_mut(VecDeque::pop_front));
        }
        !waiting.is_empty()
    });
    if more {
        set_timeout(next, Duration::ZERO);
    }
}

/// Runs `work` after all work of [`in_turn`]; several such pieces run in the order of their calls.
pub(crate) fn at_last(work: impl FnOnce() + 'static) {
    LAST.with_borrow_mut(|last| last.push_back(Box::new(work)));
    // Starts the queue if it is empty.
    in_turn(|| ());
}

/// Whether nothing waits.
#[cfg(test)]
pub(crate) fn are_over() -> bool {
    WAITING.with_borrow(VecDeque::is_empty)
}

#[cfg(test)]
mod tests {
    use std::rc::Rc;

    use leptos::prelude::*;
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::testing::{mount, until};

    #[wasm_bindgen_test]
    async fn work_is_done_in_its_order_and_not_at_once() {
        let _page = mount(|| view! { <p></p> }).await;
        let done = Rc::new(RefCell::new(Vec::new()));
        let note = |name: &'static str| {
            let done = Rc::clone(&done);
            move || done.borrow_mut().push(name)
        };
        let (first, inner) = (note("first"), note("added"));
        at_last(note("last"));
        in_turn(move || {
            first();
            in_turn(inner);
        });
        in_turn(note("second"));
        assert!(done.borrow().is_empty());
        until(are_over).await;
        assert_eq!(*done.borrow(), ["first", "second", "added", "last"]);
    }

    #[wasm_bindgen_test]
    async fn two_works_at_last_both_run() {
        let _page = mount(|| view! { <p></p> }).await;
        let done = Rc::new(RefCell::new(Vec::new()));
        for name in ["one", "other"] {
            let done = Rc::clone(&done);
            at_last(move || done.borrow_mut().push(name));
        }
        until(are_over).await;
        assert_eq!(*done.borrow(), ["one", "other"]);
    }
}
