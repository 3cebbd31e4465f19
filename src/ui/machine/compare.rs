//! Two projects or variants side by side: machines at the same time of their runs, differing entries and results, program lines.

use std::sync::Arc;

use leptos::html;
use leptos::prelude::*;
use leptos::wasm_bindgen::closure::Closure;
use leptos::wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_futures::spawn_local;
use web_sys::Element;

use super::drawing::Drawn;
use crate::machines::{Frame, PreparedMachine};
use crate::msg;
use crate::nc::File;
use crate::project::Project;
use crate::project::run::Run;
use crate::ui::dom;
use crate::ui::dom::script::{call, load, object};
use crate::ui::dom::turns::in_turn;
use crate::ui::parts::input::{Choice, filled_part, number};
use crate::ui::parts::phrases::phrases;
use crate::ui::parts::scene::{fit, svg};
use crate::ui::parts::{Dialog, Glyph, IconButton};
use crate::ui::state::planning::begin;
use crate::ui::state::view::Compared;
use crate::ui::state::{Page, put};
use crate::ui::words::{Tone, clock, sentence, shown_name, t};
use crate::ui::worker::client::Client;
use crate::ui::worker::messages::CompareProjects;

/// Seconds of the runs that are shown.
const SHOWN: f64 = 60.0;

/// Events that are planned in one turn.
const SLICE: usize = 1000;

/// A project in motion.
struct Side {
    run: Run,
    machine: Arc<PreparedMachine>,
    drawn: Drawn,
    /// The drawing's box and the most of its units per pixel.
    size: ([f64; 4], f64),
}

impl Side {
    /// The run of a project from its beginning, drawn into `host`.
    fn new(project: &Project, host: &Element) -> Side {
        let machine = project.prepared();
        let scene = machine.scene();
        host.set_inner_html(&svg(&scene));
        let size = (scene.view, scene.unit);
        Side { run: begin(project, &project.written()), drawn: Drawn::new(host, &scene), machine, size }
    }

    /// Whether the run is planned up to the shown time.
    fn is_planned(&self) -> bool {
        self.run.ended_at().is_some() || self.run.timeline().end() >= SHOWN
    }

    /// Shows the machine at a time (s), or at the end of a run that is shorter.
    fn show(&mut self, t: f64) {
        let now = self.run.timeline().at(t.min(self.run.timeline().end()));
        self.drawn.pose(&self.machine.pose(&self.run, &now, Frame { step: 0.0, drawing_option: false }));
    }
}

/// The dialog.
#[component]
pub(crate) fn CompareDialog() -> impl IntoView {
    let page = Page::here();
    let other = page.view.compared;
    let open = Signal::derive(move || other.with(Option::is_some));
    let content = move || {
        let present = page.project.get_untracked();
        let name = shown_name(&present.name);
        let mut all = vec![(sentence(&msg!("compare.present", name)), present.clone())];
        all.extend(present.each_variant());
        let right = match other.get()? {
            Compared::Variant(at) => at + 1,
            Compared::Project(name, text) => {
                all.push((name, Project::from_json(&text).project?));
                all.len() - 1
            }
        };
        (right < all.len()).then(|| view! { <Sides all=all right=right /> })
    };
    view! {
        <Dialog id="compare-title" title=t("compare.title") open=open close=move || other.set(None) class="wide compare">
            {content}
        </Dialog>
    }
}

/// The projects and variants for the comparison, each with its name, and the places of the chosen two.
#[derive(Clone, Copy)]
struct Pair {
    all: StoredValue<Vec<(String, Project)>>,
    places: [RwSignal<usize>; 2],
}

impl Pair {
    /// Reads a value of the left and of the right project; follows the choice.
    fn each<T>(self, read: impl Fn(&str, &Project) -> T) -> Option<[T; 2]> {
        let places = self.places.map(|place| place.get());
        self.all.with_value(|all| {
            let [left, right] = places.map(|at| all.get(at).map(|(name, project)| read(name, project)));
            Some([left?, right?])
        })
    }

    /// Names of the left and of the right project.
    fn names(self) -> [String; 2] {
        self.each(|name, _| name.to_owned()).unwrap_or_default()
    }

    /// Puts a project to a side (0 or 1); if the other side has it, the sides swap.
    fn choose(self, side: usize, at: usize) {
        let [own, other] = [self.places[side], self.places[1 - side]];
        let before = own.get_untracked();
        own.set(at);
        if other.get_untracked() == at {
            other.set(before);
        }
    }
}

/// Comparison of two of the projects and variants.
#[component]
fn Sides(
    /// All of them, each with its name; the present project first.
    all: Vec<(String, Project)>,
    /// The place of the one at the right; the present project is at the left.
    right: usize,
) -> impl IntoView {
    let page = Page::here();
    let pair = Pair { all: StoredValue::new(all), places: [RwSignal::new(0), RwSignal::new(right)] };
    let rows = RwSignal::new(String::new());
    let worker = Client::here();
    Effect::new(move |_| {
        let show = move |html| match html {
            Some(html) => drop(rows.try_set(html)),
            None => page.notices.notify(Tone::Fail, t("page.no-answer").to_owned()),
        };
        if let Some([left, right]) = pair.each(|_, project| project.clone()) {
            worker.ask(&left, CompareProjects { names: pair.names(), other: right.to_json() }, show);
        }
    });
    view! {
        <Motion pair=pair />
        <div class="scroll variants" tabindex="0" role="group" aria-label=t("compare.entries")>
            <table inner_html=rows></table>
        </div>
        <Programs pair=pair />
    }
}

/// The name over a side; a list to choose from if there are more than two projects.
#[component]
fn Caption(
    /// The two projects.
    pair: Pair,
    /// The side: 0 left, 1 right.
    side: usize,
) -> impl IntoView {
    let place = pair.places[side];
    let names = pair.all.with_value(|all| all.iter().map(|(name, _)| name.clone()).collect::<Vec<_>>());
    if names.len() == 2 {
        return names.get(place.get_untracked()).cloned().into_any();
    }
    let options: Vec<_> = names.into_iter().enumerate().map(|(at, name)| (at.to_string(), name)).collect();
    view! {
        <Choice
            attr:aria-label=t(["compare.left", "compare.right"][side]) options=Signal::stored(options)
            chosen=Signal::derive(move || place.get().to_string())
            choose=move |at: String| pair.choose(side, at.parse().unwrap_or(0))
        />
    }
    .into_any()
}

/// Both machines with one transport: they are at the same time of their runs.
#[component]
fn Motion(
    /// The two projects.
    pair: Pair,
) -> impl IntoView {
    let page = Page::here();
    let hosts: [NodeRef<html::Div>; 2] = [NodeRef::new(), NodeRef::new()];
    let sides = StoredValue::new_local(Vec::<Side>::new());
    // Starts at the time of the page's play head.
    let head = RwSignal::new(page.player.head().min(SHOWN));
    let (end, playing) = (RwSignal::new(SHOWN), RwSignal::new(false));
    let show = move || {
        // The dialog may be gone.
        let Some(t) = head.try_get_untracked() else { return };
        sides.try_update_value(|sides| sides.iter_mut().for_each(|side| side.show(t)));
    };
    Effect::new(move |_| {
        let [Some(left), Some(right)] = hosts.map(|host| host.get()) else { return };
        let Some(projects) = pair.each(|_, project| project.clone()) else { return };
        let made = projects.iter().zip([&left, &right]).map(|(project, host)| Side::new(project, host)).collect();
        sides.set_value(made);
        plan(sides, head, end, show);
        // Drawn only after the dialog has its size.
        dom::soon(move || {
            sides.try_with_value(|sides| {
                for (side, host) in sides.iter().zip([&left, &right]) {
                    let picture = dom::all(host, ".scene").into_iter().next();
                    picture.iter().for_each(|picture| fit(picture.unchecked_ref(), side.size.0, side.size.1));
                }
            });
        });
    });
    Effect::new(move |_| {
        head.track();
        show();
    });
    // Number of starts: an earlier playback ends when it changes.
    let going = StoredValue::new(0_u32);
    let toggle = move || {
        if head.get_untracked() >= end.get_untracked() {
            head.set(0.0);
        }
        playing.update(|playing| *playing = !*playing);
        going.update_value(|going| *going += 1);
        let own = going.get_value();
        spawn_local(async move {
            let mut before = dom::now();
            loop {
                dom::frame().await;
                // The dialog may be gone.
                if playing.try_get_untracked() != Some(true) || going.try_get_value() != Some(own) {
                    return;
                }
                let now = dom::now();
                let t = (head.get_untracked() + (now - before) / 1000.0).min(end.get_untracked());
                before = now;
                put(head, t);
                put(playing, t < end.get_untracked());
            }
        });
    };
    let glyph = Signal::derive(move || if playing.get() { Glyph::Pause } else { Glyph::Play });
    let label = Signal::derive(move || t(if playing.get() { "page.pause" } else { "page.play" }).to_owned());
    let scrub = move |event| {
        if let Some(t) = number(&event) {
            playing.set(false);
            head.set(t);
        }
    };
    view! {
        <div class="sides">
            <figure><figcaption><Caption pair=pair side=0 /></figcaption><div class="stage" node_ref=hosts[0]></div></figure>
            <figure><figcaption><Caption pair=pair side=1 /></figcaption><div class="stage" node_ref=hosts[1]></div></figure>
        </div>
        <div class="both">
            <IconButton glyph=glyph label=label press=toggle />
            <input
                type="range" min="0" max=move || end.get().to_string() step="0.001" aria-label=t("compare.time") aria-valuetext=move || clock(head.get())
                prop:value=move || head.get().to_string() style=("--part", move || filled_part(head.get(), (0.0, end.get()))) on:input=scrub
            />
            <output>{move || clock(head.get())}</output>
        </div>
    }
}

/// Plans both runs in turns, and shows them as far as they are.
fn plan(
    sides: StoredValue<Vec<Side>, LocalStorage>,
    head: RwSignal<f64>,
    end: RwSignal<f64>,
    show: impl Fn() + Copy + 'static,
) {
    let planned = sides.try_update_value(|sides| {
        sides.iter_mut().filter(|side| !side.is_planned()).for_each(|side| drop(side.run.advance(SHOWN, SLICE)));
        sides.iter().all(Side::is_planned)
    });
    show();
    match planned {
        Some(false) => in_turn(move || plan(sides, head, end, show)),
        Some(true) => {
            let ends = sides.with_value(|sides| sides.iter().map(|side| side.run.timeline().end()).fold(0.0, f64::max));
            put(end, ends.min(SHOWN));
            put(head, head.get_untracked().min(ends));
        }
        None => {}
    }
}

/// Programs of the right project, line by line, with the differing lines of the left one.
#[component]
fn Programs(
    /// The two projects.
    pair: Pair,
) -> impl IntoView {
    let host: NodeRef<html::Div> = NodeRef::new();
    let (chosen, failed) = (RwSignal::new(0_usize), RwSignal::new(String::new()));
    let shown = StoredValue::new_local(None::<JsValue>);
    let close = move || {
        if let Some(Some(editor)) = shown.try_update_value(Option::take) {
            let _ = call(&editor, "close", &[]);
        }
    };
    let files = Memo::new(move |_| pair.each(|_, project| project.written().files.clone()).unwrap_or_default());
    let option = |(at, file): (usize, &File)| (at.to_string(), file.name.clone());
    let options = move || files.with(|[left, _]| left.0.iter().enumerate().map(option).collect::<Vec<_>>());
    let title = move || {
        let [left, right] = pair.names();
        sentence(&msg!("compare.program", left, right))
    };
    Effect::new(move |_| {
        let (at, Some(host)) = (chosen.get(), host.get()) else { return };
        let [now, other] = files.get();
        // The other side may have fewer files.
        let at = if at < now.0.len() { at } else { 0 };
        let Some(file) = now.0.get(at) else { return };
        let same = other.0.iter().find(|one| one.name == file.name).or(other.0.get(at));
        let texts = [same.map(|one| one.text.clone()).unwrap_or_default(), file.text.clone()].map(JsValue::from);
        // The two controls may have different words, so nothing is coloured.
        let pieces = Closure::<dyn Fn(JsValue) -> JsValue>::new(|_| js_sys::Array::new().into()).into_js_value();
        let options = object([("label", title().into()), ("pieces", pieces), ("phrases", phrases())]);
        spawn_local(async move {
            let [before, after] = &texts;
            let module = load("editor.js").await;
            close();
            match module.and_then(|module| call(&module, "difference", &[&host, before, after, &options])) {
                Ok(editor) => drop(shown.try_set_value(Some(editor))),
                Err(error) => drop(failed.try_set(format!("{} {}", t("compare.failed"), dom::error_text(&error)))),
            }
        });
    });
    on_cleanup(close);
    let choose = move |at: String| chosen.set(at.parse().unwrap_or(0));
    view! {
        <div class="bar">
            <h3>{title}</h3>
            <Choice
                attr:aria-label=t("page.files") options=Signal::derive(options)
                chosen=Signal::derive(move || chosen.get().to_string()) choose=choose
            />
        </div>
        <div class="editor" node_ref=host></div>
        <p class="note">{failed}</p>
    }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::machines::form::Value;
    use crate::ui::state::EditKey;
    use crate::ui::testing::{ViewBench, mount, project, settled, until, work_here};

    /// The dialog on a page whose worker is here.
    async fn dialog() -> ViewBench {
        mount(|| {
            work_here(Client::here());
            view! { <CompareDialog /> }
        })
        .await
    }

    /// The comparison with a project of the name "Order 7".
    async fn compared(change: impl FnOnce(&mut Project)) -> ViewBench {
        let mut other = project();
        change(&mut other);
        let bench = dialog().await;
        bench.page.view.compared.set(Some(Compared::Project("Order 7".to_owned(), other.to_json())));
        settled().await;
        bench
    }

    /// The project "Order 8" of pitch 7 with the variants A of pitch 8 and B of pitch 9, compared with the variant at a place.
    async fn compared_with_variant(at: usize) -> ViewBench {
        let bench = dialog().await;
        for pitch in [8.0, 9.0] {
            bench.page.set("pitch", Value::Number(pitch));
            bench.page.edit(|project| _ = project.keep_variant(""));
        }
        bench.page.set("pitch", Value::Number(7.0));
        bench.page.edit_merged(EditKey::Name, |project| project.name = "Order 8".to_owned());
        bench.page.view.compared.set(Some(Compared::Variant(at)));
        settled().await;
        bench
    }

    /// The names over the table.
    fn heads(bench: &ViewBench) -> Vec<String> {
        bench.all(".compare thead th").iter().skip(1).filter_map(|cell| cell.text_content()).collect()
    }

    /// The pitch of both in the table.
    fn pitches(bench: &ViewBench) -> Vec<String> {
        let rows = bench.all(".compare tbody tr");
        let row = rows.iter().find(|row| row.text_content().is_some_and(|text| text.starts_with("Pitch"))).unwrap();
        dom::all(row, "td").iter().filter_map(|cell| cell.text_content()).collect()
    }

    #[wasm_bindgen_test]
    async fn variant_is_compared_with_the_project_under_its_name() {
        let bench = compared_with_variant(0).await;
        assert_eq!(heads(&bench), [sentence(&msg!("compare.present", name = "Order 8")), "A".to_owned()]);
        assert_eq!(pitches(&bench), ["7", "8"]);
        assert_eq!(bench.all(".sides .scene").len(), 2);
        let [left, right] = [heads(&bench)[0].clone(), "A".to_owned()];
        assert_eq!(bench.text(".compare h3"), sentence(&msg!("compare.program", left, right)));
    }

    #[wasm_bindgen_test]
    async fn two_variants_are_compared_at_the_time_reached() {
        let bench = compared_with_variant(0).await;
        bench.type_into(".both input", "3").await;
        bench.choose(".sides figure:first-child select", "2").await;
        assert_eq!(
            (heads(&bench), pitches(&bench)),
            (vec!["B".to_owned(), "A".to_owned()], vec!["9".to_owned(), "8".to_owned()])
        );
        assert_eq!((bench.all(".sides .scene").len(), bench.text(".both output")), (2, clock(3.0)));
        // A choice of the other side's project swaps the sides.
        bench.choose(".sides figure:last-child select", "2").await;
        assert_eq!(
            (heads(&bench), pitches(&bench)),
            (vec!["A".to_owned(), "B".to_owned()], vec!["8".to_owned(), "9".to_owned()])
        );
        assert_eq!(bench.value(".sides figure:first-child select"), "1");
    }

    #[wasm_bindgen_test]
    async fn variant_beside_an_edited_program_has_its_own() {
        let bench = compared_with_variant(0).await;
        bench.page.edit(|project| project.edited = Some(project.written().files.clone()));
        let both = bench.page.project.with_untracked(|project| {
            project
                .each_variant()
                .map(|(_, variant)| variant.written().files != project.written().files)
                .collect::<Vec<_>>()
        });
        assert_eq!(both, [true, true]);
    }

    #[wasm_bindgen_test]
    async fn differing_entry_and_result_are_listed_under_both_names() {
        let bench = compared(|project| drop(project.values.insert("pitch".to_owned(), Value::Number(9.0)))).await;
        let text = bench.text(".compare table");
        assert!(text.contains("Pitch") && text.contains("Order 7") && text.contains(t("variants.results")), "{text}");
        assert_eq!(bench.all(".sides .scene").len(), 2);
    }

    #[wasm_bindgen_test]
    async fn both_machines_follow_one_slider() {
        let bench = compared(|project| drop(project.values.insert("pitch".to_owned(), Value::Number(9.0)))).await;
        let places =
            || bench.all(".sides [data-g]").iter().map(|part| part.get_attribute("transform")).collect::<Vec<_>>();
        let before = places();
        bench.type_into(".both input", "3").await;
        until(|| places() != before).await;
        assert_eq!(bench.text(".both output"), clock(3.0));
        let half = before.len() / 2;
        let (then, now) = (before.split_at(half), places());
        let now = now.split_at(half);
        assert!(then.0 != now.0 && then.1 != now.1, "one machine stands still");
    }

    #[wasm_bindgen_test]
    async fn closed_comparison_is_gone() {
        let bench = compared(|_| ()).await;
        bench.press_button(t("page.close")).await;
        assert!(!bench.has("dialog[open]") && !bench.has(".sides"));
        assert!(bench.page.view.compared.with_untracked(Option::is_none));
    }
}
