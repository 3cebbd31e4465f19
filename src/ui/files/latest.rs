//! The latest project of the shelf, offered at the start if the browser's other store had no room for it.

use leptos::prelude::*;
use wasm_bindgen_futures::spawn_local;

use super::open::show;
use super::shelf;
use crate::msg;
use crate::project::Project;
use crate::ui::state::Page;
use crate::ui::state::notices::Notice;
use crate::ui::words::{Tone, sentence, shown_name};

/// Offers the latest project of the shelf where the page began with another one. The shelf has more room than the browser's other store, and
/// may be allowed where that is denied.
pub(super) fn offer(page: Page) {
    spawn_local(async move {
        // If the shelf does not answer, nothing is offered; the next change of the project reports the reason.
        let states = shelf::states().await.unwrap_or_default();
        let projects = states.into_iter().filter(|state| state.of.is_empty() && state.note.is_empty());
        let Some(latest) = projects.max_by(|a, b| a.at.total_cmp(&b.at)) else { return };
        if page.is_gone() || latest.text == shelf::present(page).text {
            return;
        }
        let Some(project) = Project::from_json(&latest.text).project.map(|project| project.with_id(Some(latest.id)))
        else {
            return;
        };
        let name = shown_name(&project.name);
        let text = sentence(&msg!("projects.latest", name));
        let act = Callback::new(move |()| show(page, project.clone()));
        page.notices.show(Notice {
            offer: Some(("page.open", act)),
            of_project: true,
            ..Notice::new(Tone::Warn, text)
        });
    });
}
