//! Positions of the machine's axes and spindle speed at the play head, as the control's position page has them.

use leptos::prelude::*;

use crate::motion::Snapshot;
use crate::text::units::{self, Lengths};
use crate::ui::state::Page;
use crate::ui::words::{figure, t};

/// An axis of the control: its number, its name, and units of its words per millimetre of travel.
type Counted = (usize, String, f64);

/// The axes of the control that the machine has.
fn fitted(page: Page) -> Vec<Counted> {
    page.project.with(|project| {
        let plant = project.prepared().plant();
        let axes = project.control.axes.iter().enumerate();
        let found = axes.filter_map(|(at, axis)| {
            let own = plant.axes.iter().find(|own| own.letter == Some(axis.letter))?;
            Some((at, axis.letter.to_string(), own.words_per_unit()))
        });
        found.collect()
    })
}

/// A word of the control and its value now.
fn cell(letter: String, mark: &'static str, value: impl Fn() -> Option<String> + Send + Sync + 'static) -> AnyView {
    let value = Memo::new(move |_| value());
    view! { <div><dt data-means="program" data-word=letter.clone()>{letter.clone()} {mark}</dt><dd>{value}</dd></div> }
        .into_any()
}

/// Axes and spindle.
#[component]
pub(super) fn Positions() -> impl IntoView {
    let page = Page::here();
    let axes = Memo::new(move |_| fitted(page));
    let now = page.player.now;
    let cells = move || {
        let axes = axes.get().into_iter().map(move |(at, letter, words)| {
            let mark = if words > 1.0 { " Ø" } else { "" };
            // The program's own unit beside inches elsewhere.
            let unit = if units::shown() == Lengths::Inches { " mm" } else { "" };
            let position = move || {
                now.with(|now| now.axes.get(at).map(|axis| format!("{}{unit}", figure(words * axis.actual, 3))))
            };
            cell(letter, mark, position)
        });
        let of_machine =
            move |now: &Snapshot| page.project.with_untracked(|project| project.prepared().spindle_speed(now));
        let speed = move || Some(now.with(|now| figure(of_machine(now), 0)));
        axes.chain([cell("S".to_owned(), "", speed)]).collect_view()
    };
    view! { <dl class="now" aria-label=t("page.now")>{cells}</dl> }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::testing::{ViewBench, mount, mount_project, settled};

    #[wasm_bindgen_test]
    async fn positions_have_the_axes_of_the_machine_and_the_spindle() {
        let names =
            |bench: &ViewBench| -> Vec<_> { bench.all("dt").iter().filter_map(|name| name.text_content()).collect() };
        let bench = mount(|| view! { <Positions /> }).await;
        bench.run().await;
        // The E60 has Z and A too, the ribbon line has not.
        assert_eq!(names(&bench), ["X", "Y", "S"]);
        assert_eq!(bench.text("dd"), "0.000");
        let lathe = crate::project::Project::of("turning-spindle", Some("gsk-980tdc")).unwrap();
        let bench = mount_project(lathe, || view! { <Positions /> }).await;
        bench.run().await;
        assert_eq!(names(&bench), ["X Ø", "Z", "S"]);
    }

    #[wasm_bindgen_test]
    async fn work_that_the_plc_turns_has_its_speed() {
        let lathe = crate::project::Project::of("polygon-lathe", Some("knd-k2000t")).unwrap();
        let bench = mount_project(lathe, || view! { <Positions /> }).await;
        bench.run().await;
        bench.seek(8.0).await;
        settled().await;
        assert_eq!(bench.text("dl > div:last-child dd"), "200");
    }

    #[wasm_bindgen_test]
    async fn position_of_a_lathe_is_a_diameter() {
        let lathe = crate::project::Project::of("turning-spindle", Some("gsk-980tdc")).unwrap();
        let bench = mount_project(lathe, || view! { <Positions /> }).await;
        bench.run().await;
        bench.seek(0.0).await;
        settled().await;
        let x = bench.page.player.now.with_untracked(|now| now.axes[0].actual);
        assert!(x > 0.0);
        assert_eq!(bench.text("dd"), figure(2.0 * x, 3));
    }

    #[wasm_bindgen_test]
    async fn positions_follow_the_head() {
        let bench = mount(|| view! { <Positions /> }).await;
        bench.run().await;
        bench.seek(3.5).await;
        settled().await;
        let x = bench.page.player.now.with_untracked(|now| now.axes[0].actual);
        assert_eq!(bench.text("dd"), figure(x, 3));
        assert_ne!(bench.text("dl > div:last-child dd"), "0");
    }
}
