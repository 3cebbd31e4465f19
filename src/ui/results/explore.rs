//! The explorer: a dragged value shows its consequences at once, and the form takes it at the end of the drag; a click on a listed way takes that way.

use std::sync::Arc;

use leptos::html;
use leptos::prelude::*;
use leptos::wasm_bindgen::JsCast;

use super::take::{set, take, take_row};
use crate::machines::PreparedMachine;
use crate::machines::form::{FieldInfo, Value, Values};
use crate::project::Project;
use crate::text::catalog::number_text;
use crate::ui::dom;
use crate::ui::parts::followed::follow_sheets;
use crate::ui::parts::input::{filled_part, number};
use crate::ui::parts::sheet_view::SheetView;
use crate::ui::parts::verdict::VerdictLines;
use crate::ui::parts::{chart_figure, scene};
use crate::ui::state::{EditKey, Page};
use crate::ui::words::t;
use crate::view::{Explorer, Readout, Slider};

/// The machine with dragged values, or with those of the form.
fn prepared(project: &Project, draft: Option<&Values>) -> Arc<PreparedMachine> {
    match draft {
        Some(values) => Arc::new(project.machine.prepare(values, project.control_context())),
        None => project.prepared(),
    }
}

/// What the explorer shows of the machine with the present values.
#[derive(Clone, PartialEq)]
struct Explored {
    explorer: Explorer,
    readouts: Vec<Readout>,
}

impl Explored {
    /// The results concerned.
    fn results(&self) -> Vec<Readout> {
        let wanted = &self.explorer.results;
        let is_wanted =
            |readout: &&Readout| if wanted.is_empty() { readout.headline } else { wanted.contains(&readout.id) };
        self.readouts.iter().filter(is_wanted).cloned().collect()
    }

    fn charts_html(&self) -> String {
        let mut out = String::new();
        self.explorer.charts.iter().for_each(|chart| chart_figure::html(&mut out, &chart.clone().shown()));
        out
    }
}

/// Sliders, their consequences, and the listed ways.
#[component]
pub(crate) fn ExploreTab() -> impl IntoView {
    let page = Page::here();
    // Values that are dragged and not yet in the form.
    let draft = RwSignal::new(None::<Values>);
    // Place of the chosen shape in the list of those that can be explored.
    let chosen = RwSignal::new(0_usize);
    let names = Memo::new(move |_| page.project.with(|project| project.prepared().explored()));
    let at = Memo::new(move |_| chosen.get().min(names.with(Vec::len).saturating_sub(1)));
    let explored = Memo::new(move |_| {
        page.project.with(|project| {
            let machine = draft.with(|draft| prepared(project, draft.as_ref()));
            let explorer = machine.explorer(at.get()).unwrap_or_default();
            Explored { explorer, readouts: machine.design(&project.provenance).readouts }
        })
    });
    let shape_host: NodeRef<html::Div> = NodeRef::new();
    let shape = move || explored.with(|explored| scene::svg(&explored.explorer.scene));
    let plots = move || explored.with(Explored::charts_html);
    let results = Signal::derive(move || explored.with(Explored::results));
    Effect::new(move |_| {
        let (view, most) = explored.with(|explored| (explored.explorer.scene.view, explored.explorer.scene.unit));
        dom::soon(move || {
            // The tab may have been left.
            let host = shape_host.try_get_untracked().flatten();
            let picture = host.and_then(|host| dom::all(&host, ".scene").into_iter().next());
            if let Some(picture) = picture {
                scene::fit(picture.unchecked_ref(), view, most);
            }
        });
    });
    let sliders = Memo::new(move |_| explored.with(|explored| explored.explorer.sliders.clone()));
    let fields =
        Memo::new(move |_| sliders.with(|sliders| sliders.iter().map(|slider| slider.field).collect::<Vec<_>>()));
    let knobs = move || {
        let (all, first) = (page.project.with_untracked(|project| project.machine.fields()), sliders.get_untracked());
        let slider = |(at, id): (usize, &'static str)| {
            let (info, first) = (all.iter().find(|field| field.id == id)?.clone(), first.get(at)?.clone());
            Some(view! { <ExplorerSlider draft=draft sliders=sliders at=at first=first info=info /> })
        };
        fields.get().into_iter().enumerate().filter_map(slider).collect_view()
    };
    let shapes = move || {
        let names = names.get();
        let option = |(shape, name): (usize, &'static str)| {
            let pick = move |_| {
                draft.set(None);
                chosen.set(shape);
            };
            view! {
                <button type="button" class="chip" aria-pressed=move || (at.get() == shape).to_string() on:click=pick>
                    {t(name)}
                </button>
            }
        };
        let chips = |names: Vec<&'static str>| names.into_iter().enumerate().map(option).collect_view();
        (names.len() > 1)
            .then(|| view! { <div class="chips" role="group" aria-label=t("page.explored")>{chips(names)}</div> })
    };
    let choose = move |event: leptos::ev::MouseEvent| {
        if take_row(page, &event) {
            draft.set(None);
        }
    };
    view! {
        <p class="lead">{t("page.explore-lead")}</p>
        {shapes}
        <div class="shape" node_ref=shape_host inner_html=shape></div>
        <div class="knobs">{knobs}</div>
        <div class="row"><VerdictLines readouts=results /></div>
        <div class="ways" hidden=move || { at.get() > 0 } on:click=choose><SheetView sheets=follow_sheets(|sheets| sheets.ways) /></div>
        <div class="plots" inner_html=plots></div>
    }
}

/// A value of the form as a slider.
#[component]
fn ExplorerSlider(
    /// Values that are dragged.
    draft: RwSignal<Option<Values>>,
    /// The sliders with the present values.
    sliders: Memo<Vec<Slider>>,
    /// Index among the sliders.
    at: usize,
    /// The slider at first.
    first: Slider,
    /// The row of its field.
    info: FieldInfo,
) -> impl IntoView {
    let page = Page::here();
    let field = first.field;
    let knob = Memo::new(move |_| sliders.with(|sliders| sliders.get(at).cloned()).unwrap_or_else(|| first.clone()));
    let plain = |number: f64| number_text(number, 6);
    let id = format!("explore-{field}");
    let drag = move |event| {
        let Some(number) = number(&event) else { return };
        let along = knob.with_untracked(|knob| knob.along.clone());
        let mut values = draft.get_untracked().unwrap_or_else(|| page.project.with_untracked(|p| p.values.clone()));
        let text = plain(number);
        let along = along.iter().map(|entry| (entry.field, entry.text.as_str())).chain([(field, text.as_str())]);
        page.project.with_untracked(|project| set(project, &mut values, along));
        draft.set(Some(values));
    };
    let drop = move |_| {
        if let Some(values) = draft.get_untracked() {
            draft.set(None);
            take(page, Some(EditKey::Field(field)), values);
        }
    };
    view! {
        <div class="slider">
            <label for=id.clone()>{t(info.label)}</label>
            <input
                type="range" id=id.clone()
                min=move || plain(knob.get().range.0)
                max=move || plain(knob.get().range.1)
                step=move || plain(knob.get().step)
                prop:value=move || plain(knob.get().value)
                style:--part=move || filled_part(knob.get().value, knob.get().range)
                on:input=drag
                on:change=drop
            />
            <output for=id>{move || info.text_with_unit(&Value::Number(knob.get().value))}</output>
        </div>
    }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::testing::{ViewBench, mount_project};

    async fn explorer() -> ViewBench {
        let machine = crate::machines::ALL.iter().find(|machine| machine.info().explores).unwrap();
        mount_project(Project::of(machine.id(), None).unwrap(), || view! { <ExploreTab /> }).await
    }

    /// Another position of the first slider.
    fn elsewhere(bench: &ViewBench) -> String {
        let (value, max) = (bench.value(".slider input"), bench.attribute(".slider input", "max"));
        if value == max { bench.attribute(".slider input", "min") } else { max }
    }

    #[wasm_bindgen_test]
    async fn slider_begins_with_the_value_of_the_form() {
        let bench = explorer().await;
        let field = bench.attribute(".slider label", "for").replace("explore-", "");
        let Some(crate::machines::form::Value::Number(value)) = bench.setting(&field) else { panic!("a number") };
        assert_eq!(bench.value(".slider input"), number_text(value, 6));
        assert!(bench.text(".slider output").starts_with(&number_text(value, 6)));
    }

    #[wasm_bindgen_test]
    async fn form_takes_a_dragged_value_only_at_the_end() {
        let bench = explorer().await;
        let before = bench.page.project.with_untracked(|project| project.values.clone());
        let to = elsewhere(&bench);
        let shown = bench.text(".slider output");
        bench.type_into(".slider input", &to).await;
        assert_ne!(bench.text(".slider output"), shown);
        assert_eq!(bench.page.project.with_untracked(|project| project.values.clone()), before);
        bench.choose(".slider input", &to).await;
        assert_ne!(bench.page.project.with_untracked(|project| project.values.clone()), before);
        bench.page.undo();
        assert_eq!(bench.page.project.with_untracked(|project| project.values.clone()), before);
    }

    #[wasm_bindgen_test]
    async fn shape_and_verdicts_are_shown() {
        let bench = explorer().await;
        assert!(bench.has(".shape svg") && bench.has(".row .card"));
    }

    #[wasm_bindgen_test]
    async fn second_shape_is_explored_with_its_own_fields() {
        let project = Project::named("polygon-lathe", None, Some("square-and-hexagon")).unwrap();
        let bench = mount_project(project, || view! { <ExploreTab /> }).await;
        let first = bench.value(".slider input");
        bench.press(".chips button:nth-of-type(2)").await;
        assert_eq!(bench.attribute(".chips button:nth-of-type(2)", "aria-pressed"), "true");
        assert_eq!(bench.attribute(".slider label", "for"), "explore-second-sides");
        assert_ne!(bench.value(".slider input"), first);
        bench.type_into(".slider input", "8").await;
        bench.choose(".slider input", "8").await;
        let set = bench.setting("second-sides");
        assert_eq!(set, Some(crate::machines::form::Value::Number(8.0)));
        assert_eq!(bench.attribute(".slider label", "for"), "explore-second-sides");
    }
}
