//! A reload of the page for a choice that it reads at its start; what was shown is shown again.

use leptos::prelude::*;
use serde::{Deserialize, Serialize};

use crate::ui::dom;
use crate::ui::dom::tab_entry::{carried, carry, drop_carried, remember};
use crate::ui::state::Page;
use crate::ui::state::view::{PROJECT, Tab};
use crate::ui::words::{Tone, t};

/// Key in this tab's history entry of what was shown.
const SHOWN: &str = "macroline.shown";

/// View state that a reload would otherwise lose.
#[derive(Serialize, Deserialize)]
struct Shown {
    tab: Tab,
    /// Seconds of the play head.
    head: f64,
    plays: bool,
}

/// Stores a choice and reloads the page. The project returns from the store or from this tab; where neither keeps it, a
/// warning appears in place of the reload.
pub(super) fn reload_with(page: Page, key: &str, choice: &str) {
    let shown = Shown {
        tab: page.view.tab.get_untracked(),
        head: page.player.head(),
        plays: page.player.playing.get_untracked(),
    };
    let shown = serde_json::to_string(&shown).unwrap_or_default();
    let lost = page.view.kept.get_untracked().is_refused() && carried(PROJECT).is_none();
    if lost || !remember(key, choice) {
        return page.notices.notify(Tone::Warn, t("page.language-unkept").to_owned());
    }
    carry(&[(SHOWN, &shown)]);
    dom::reload();
}

/// Begins the run; after a reload for a choice (such as the language), at the play head of before.
pub(crate) fn begin_run(page: Page) {
    let shown = carried(SHOWN).and_then(|text| serde_json::from_str::<Shown>(&text).ok());
    drop_carried(&[SHOWN]);
    match shown {
        None => page.player.begin(),
        Some(Shown { tab, head, plays }) => {
            page.view.tab.set(tab);
            page.player.resume(head, plays);
        }
    }
}
