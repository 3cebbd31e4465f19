//! Diagnostics of the program from the worker: warnings cost too much time for the page to make them with every change.

use std::cell::Cell;
use std::rc::Rc;

use leptos::prelude::*;

use super::messages::{Request, Response};
use crate::ui::model::Model;

/// Keeps the model's diagnostics up with its program. A generated program that reads without an error needs no review.
pub(in crate::ui) fn follow(model: Model) {
    let last = Rc::new(Cell::new(0));
    Effect::new(move |_| {
        // Only the response to the last request counts.
        let number = last.get() + 1;
        last.set(number);
        let (doubtful, control) =
            model.written.with(|written| (written.edited || !written.diagnostics.is_empty(), written.parsed.control()));
        model.pending.put(doubtful);
        model.reviewed.put(None);
        if !doubtful {
            return;
        }
        let last = Rc::clone(&last);
        let put = move |response: Option<Response>| {
            if last.get() != number {
                return;
            }
            if let Some(Response::Review(findings)) = response {
                let found = findings.into_iter().filter_map(|finding| finding.diagnostic(control)).collect();
                model.reviewed.put(Some(found));
            }
            model.pending.put(false);
        };
        model.project.with_untracked(|project| model.worker.ask(project, Request::Review, put));
    });
}
