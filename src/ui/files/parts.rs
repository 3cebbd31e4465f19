//! Parts from a table opened by the user, CSV or JSON: the worker reads it, and its valid rows are kept with the project.

use leptos::prelude::*;

use crate::msg;
use crate::nc;
use crate::project::Project;
use crate::text::headed;
use crate::ui::state::Page;
use crate::ui::state::view::Tab;
use crate::ui::words::{Tone, sentence, t};
use crate::ui::worker::client::Client;
use crate::ui::worker::messages::{ReadParts, ReadPartsTable};

/// Maximum findings about a table that are listed one by one.
const NAMED: usize = 4;

/// Adds the parts of a table to the project, as one step of the history, and reports the faulty rows.
pub(super) fn take(page: Page, worker: Client, table: &nc::File) {
    let name = table.name.clone();
    let show = move |read: Option<ReadParts>| {
        let Some(ReadParts { project, added, remarks }) = read else {
            return page.notices.notify(Tone::Fail, t("page.no-answer").to_owned());
        };
        for (refuses, text) in remarks.iter().take(NAMED) {
            page.notices.notify(if *refuses { Tone::Fail } else { Tone::Info }, headed(&name, text));
        }
        if remarks.len() > NAMED {
            page.notices
                .notify(Tone::Info, sentence(&msg!("page.more-of-parts", count = (remarks.len() - NAMED) as u32)));
        }
        let Some(read) = Project::from_json(&project).project.filter(|_| added > 0) else { return };
        page.edit(|project| project.parts = read.parts);
        page.view.tab.set(Tab::Sizing);
        page.notices.announce(sentence(&msg!("page.parts-added", count = added)));
    };
    let ask = ReadPartsTable { name: table.name.clone(), text: table.text.clone() };
    // Read before the request, because an immediate answer changes the project.
    let project = page.project.get_untracked();
    worker.ask(&project, ask, show);
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::project::parts;
    use crate::ui::testing::{ViewBench, mount, project, settled, work_here};

    /// A table opened on a page whose worker is here.
    async fn opened(text: &str) -> ViewBench {
        let bench = mount(|| ()).await;
        work_here(bench.worker);
        take(bench.page, bench.worker, &nc::File { name: "own.csv".to_owned(), text: text.to_owned() });
        settled().await;
        bench
    }

    #[wasm_bindgen_test]
    async fn parts_of_a_table_are_kept_with_the_project() {
        let table = parts::write(parts::shipped().iter().take(3));
        let bench = opened(&table).await;
        let models = |bench: &ViewBench| bench.page.project.with_untracked(|project| project.parts.len());
        assert_eq!(models(&bench), 3);
        assert_eq!(bench.page.view.tab.get_untracked(), Tab::Sizing);
        bench.page.undo();
        assert_eq!(models(&bench), 0);
    }

    #[wasm_bindgen_test]
    async fn table_without_a_sound_row_only_gives_a_notice() {
        let bench = opened("kind,maker,model\nservo,Works,\n").await;
        assert!(bench.page.project.get_untracked() == project());
        assert!(bench.notices().iter().all(|told| told.starts_with("own.csv: ")) && !bench.notices().is_empty());
    }
}
