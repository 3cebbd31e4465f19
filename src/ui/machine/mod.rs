//! The machine in the middle of the page: verdicts, drawing, film with its charts, operator's panel.

mod charts;

mod film;

mod marks;

mod notices;

pub(crate) mod operator_panel;

mod pictures;

mod scene_view;

mod stage;

mod transport;

mod verdicts;

use leptos::prelude::*;

use film::Film;
use stage::Stage;
use verdicts::Verdicts;

/// Verdicts, drawing and film, from top to bottom.
#[component]
pub(crate) fn Machine() -> impl IntoView {
    view! {
        <div class="centre">
            <Verdicts />
            <Stage />
            <Film />
        </div>
    }
}
