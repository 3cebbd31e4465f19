//! Diagnostics of the program from the worker: warnings take too long for the page to make them at every change.

use std::cell::Cell;
use std::rc::Rc;

use leptos::prelude::*;

use super::client::Client;
use super::messages::{Finding, ReviewProgram};
use crate::ui::state::{Page, put};

/// Keeps the page's diagnostics up with its program. A generated program that reads without an error needs no review.
pub(crate) fn follow(page: Page, worker: Client) {
    let last = Rc::new(Cell::new(0));
    Effect::new(move |_| {
        // Only the response to the last request counts.
        let number = last.get() + 1;
        last.set(number);
        let program = page.program;
        let (doubtful, control) = program
            .written
            .with(|written| (written.edited || !written.diagnostics.is_empty(), written.parsed.control()));
        put(program.pending, doubtful);
        put(program.reviewed, None);
        if !doubtful {
            return;
        }
        let last = Rc::clone(&last);
        let take = move |findings: Option<Vec<Finding>>| {
            if last.get() != number {
                return;
            }
            if let Some(findings) = findings {
                let found = findings.into_iter().filter_map(|finding| finding.diagnostic(control)).collect();
                put(program.reviewed, Some(found));
            }
            put(program.pending, false);
        };
        page.project.with_untracked(|project| worker.ask(project, ReviewProgram, take));
    });
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::testing::{mount, settled};
    use crate::ui::worker::messages::Ask;

    #[wasm_bindgen_test]
    async fn only_a_doubtful_program_is_reviewed() {
        let bench = mount(|| follow(Page::here(), Client::here())).await;
        bench.worker.answer_here(|_, _| ReviewProgram.answer(&Vec::new()));
        bench.page.set("pitch", crate::machines::form::Value::Number(9.0));
        settled().await;
        assert!(bench.page.program.reviewed.with_untracked(Option::is_none));
        bench.page.edit(|project| project.edited = project.listing());
        settled().await;
        assert_eq!(bench.page.program.reviewed.with_untracked(|found| found.as_ref().map(Vec::len)), Some(0));
        assert!(!bench.page.program.pending.get_untracked());
    }
}
