//! The shell: signals and DOM, not one formula.

use leptos::prelude::*;

/// The page.
#[component]
pub fn App() -> impl IntoView {
    view! {
        <main>
            <h1>"macroline"</h1>
        </main>
    }
}
