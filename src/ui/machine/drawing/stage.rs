//! The drawing of the machine, its state, and the buttons of the picture.

use leptos::ev::MouseEvent;
use leptos::html;
use leptos::prelude::*;

use super::alarm_screen::{AlarmScreen, screen_text};
use super::fitted::FittedDrawing;
use super::notices::NoticeBand;
use super::pictures::SavePicture;
use super::scene_view::Drawn;
use crate::motion::{Mode, RunEnd};
use crate::ui::dom;
use crate::ui::parts::scene::{Shown, StillDrawing};
use crate::ui::parts::{Glyph, IconButton, Later};
use crate::ui::state::Page;
use crate::ui::state::outlook::CycleStart;
use crate::ui::words::{Tone, end_words, mode_words, sentence, t};

/// The drawing, moved by the run.
#[component]
pub(crate) fn Stage() -> impl IntoView {
    let page = Page::here();
    let player = page.player;
    let section: NodeRef<html::Section> = NodeRef::new();
    let fitted = FittedDrawing::new(page);
    let (host, pans) = (fitted.host, fitted.pans);
    // The first drawing in the HTML is this drawing, which replaces it in place.
    let still = StoredValue::new_local(StillDrawing::take());
    Effect::new(move |shown: Option<Shown>| {
        let shown = shown.unwrap_or_default();
        let Some(host) = host.get() else { return shown };
        page.results.scene.with(|scene| {
            let shown = match still.try_update_value(Option::take).flatten() {
                Some(still) => Shown::adopt(&host, &still, scene),
                None => shown.change(&host, scene),
            };
            fitted.take(Drawn::new(&host, scene));
            shown
        })
    });
    mark_causes(page, host);
    player.paint(move |moment| fitted.show(moment));
    // A wide drawing is focusable, so that keys scroll it.
    let stop = move || pans.get().then_some("0");
    let option = move || page.results.scene.with(|scene| scene.drawing_option);
    let strobe = move || {
        player.drawing_option.update(|on| *on = !*on);
        player.ask();
    };
    let state = Memo::new(move |_| shown_state(page));
    let screen = Memo::new(move |_| screen_text(page));
    let wrong = Memo::new(move |_| page.wrong_fields().iter().filter(|found| found.field.is_some()).count());
    let full = move || {
        if let Some(section) = section.get_untracked() {
            // With the film, which is beside the drawing.
            dom::full_screen(&section.parent_element().unwrap_or_else(|| section.clone().into()));
        }
    };
    view! {
        <section
            class="pane drawing" id="machine" aria-label=t("page.drawing") node_ref=section
            class:screened=move || screen.with(Option::is_some)
            class:alarmed=move || screen.with(|text| text.as_ref().is_some_and(|text| text.tone == Tone::Fail))
            class:wrong=move || wrong.get() != 0
        >
            <div class="stage" class:pans=move || pans.get() tabindex=stop role="group" aria-label=t("page.drawing") node_ref=host on:click=open_field></div>
            <Show when=move || pans.get()><Stations drawn=fitted.drawn /></Show>
            <Later>
                // The labels make room for the elements over the drawing.
                {fitted.refit()}
                <AlarmScreen text=screen />
                <div class="foot">
                    <div class="state">
                        <span class=move || format!("mode {}", state.get().tone)>{move || state.get().into_view()}</span>
                        <WrongValues count=wrong />
                    </div>
                    <div class="band">
                        <p class="why" role="status">{move || why(page)}</p>
                        <NoticeBand />
                        <Show when=move || option().is_some()>
                            <button
                                type="button" class="icon strobe"
                                aria-label=move || option().map(t).unwrap_or_default()
                                title=move || option().map(t).unwrap_or_default()
                                aria-pressed=move || player.drawing_option.get().to_string()
                                on:click=move |_| strobe()
                            >
                                <crate::ui::parts::Icon glyph=Glyph::Strobe />
                            </button>
                        </Show>
                        <SavePicture />
                        <IconButton glyph=Glyph::Full label=t("page.full-screen") press=full />
                    </div>
                </div>
            </Later>
        </section>
    }
}

/// Goes to the field of the part of the drawing that is clicked.
fn open_field(event: MouseEvent) {
    let part = dom::closest(&event, "[data-field]");
    if let Some(field) = part.and_then(|part| part.get_attribute("data-field")) {
        dom::go_to_field(&field);
    }
}

/// The state of the film or of the machine.
#[derive(Clone, PartialEq)]
struct ShownState {
    words: String,
    /// In a pause, the operation on the work; without it where the drawing is narrow.
    operation: Option<String>,
    tone: Tone,
}

impl ShownState {
    fn into_view(self) -> impl IntoView {
        let operation = self.operation.map(|operation| view! { <span class="operation">" · " {operation}</span> });
        view! { <span>{self.words} {operation}</span> }
    }
}

/// The state: of the machine while the film shows it in motion; while the program runs, the operation on the work.
fn shown_state(page: Page) -> ShownState {
    let player = page.player;
    let (mode, begun) = player.now.with(|now| (now.mode, now.t > 0.0));
    let moves = matches!(mode, Mode::Running | Mode::Dwell | Mode::WaitFin);
    let operation = player.activity.get().filter(|_| mode == Mode::Running).map(|activity| sentence(&activity));
    let plain = |words: &'static str, tone| ShownState { words: t(words).to_owned(), operation: None, tone };
    match player.playing.get() {
        _ if page.program.has_errors() => plain("page.mode-errors", Tone::Fail),
        _ if mode == Mode::EmergencyStop => plain(mode_words(mode), Tone::Fail),
        _ if page.outlook.stopped.with(Option::is_some) => plain("page.mode-at-once", Tone::Fail),
        false if moves && begun => ShownState { operation, ..plain("page.mode-paused", Tone::Info) },
        false if !begun => plain("page.mode-ready", Tone::Info),
        _ => {
            let running = plain(mode_words(mode), Tone::from(mode));
            ShownState { words: operation.unwrap_or(running.words), ..running }
        }
    }
}

/// Count of wrong fields, for a form that is out of sight; a press leads to them.
#[component]
fn WrongValues(
    /// Wrong fields.
    count: Memo<usize>,
) -> impl IntoView {
    let page = Page::here();
    let words = move || {
        if page.is_stale() {
            t("page.stale-short").to_owned()
        } else {
            sentence(&crate::msg!("page.wrong-values", count = count.get() as u32))
        }
    };
    view! {
        <button
            type="button" class="mode fail wrong-values" class:gone=move || count.get() == 0
            title=t("page.go-to-field") on:click=move |_| page.show_wrong_field()
        >
            {words}
        </button>
    }
}

/// The places of a drawing that is wider than its room.
#[component]
fn Stations(
    /// The drawing.
    drawn: StoredValue<Option<Drawn>, LocalStorage>,
) -> impl IntoView {
    let page = Page::here();
    let station = move |(name, x): (&'static str, f64)| {
        let go = move |_| drawn.with_value(|drawn| drawn.iter().for_each(|drawn| drawn.go_to(x)));
        view! { <button type="button" class="chip" on:click=go>{t(name)}</button> }
    };
    let stations = move || page.results.scene.with(|scene| scene.stations.clone());
    view! {
        <div class="stations chips" role="group" aria-label=t("page.stations")>
            {move || stations().into_iter().map(station).collect_view()}
        </div>
    }
}

/// Marks the parts that the chosen result depends on; another drawing has none marked yet.
fn mark_causes(page: Page, host: NodeRef<html::Div>) {
    Effect::new(move |_| {
        page.results.scene.track();
        let (causes, Some(host)) = (page.view.causes.get(), host.get()) else { return };
        dom::all(&host, "[data-field]").iter().for_each(|part| {
            let field = part.get_attribute("data-field").unwrap_or_default();
            let _ = part.class_list().toggle_with_force("cause", causes.contains(&field.as_str()));
        });
    });
}

/// The reason why the run is over, at its end; alarms and messages of the program have a screen of their own.
fn why(page: Page) -> String {
    let (at, planned) = (page.player.now.with(|now| now.t), page.player.planned.get().end);
    match page.player.ended.get().filter(|_| at >= planned) {
        Some(RunEnd::Alarm(_)) | None => String::new(),
        Some(RunEnd::Stop) if page.player.message.with(Option::is_some) => String::new(),
        Some(RunEnd::Stop) if page.player.ask_planner(|run| run.plc_hold().is_some()) == Some(true) => String::new(),
        Some(RunEnd::Stop) if page.outlook.cycle_start() != CycleStart::Acts => t("page.end-blocked").to_owned(),
        Some(end) => end_words(&end, page.player.is_reset()),
    }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::testing::{ViewBench, mount, mount_project};

    async fn stage() -> ViewBench {
        let bench = mount(|| view! { <Stage /> <input id="heads" /> }).await;
        bench.run().await;
        bench
    }

    fn transforms(bench: &ViewBench) -> Vec<String> {
        bench.all("[data-g]").iter().map(|group| group.get_attribute("transform").unwrap_or_default()).collect()
    }

    #[wasm_bindgen_test]
    async fn scene_is_a_picture_with_alternative_text() {
        let bench = stage().await;
        let scene = bench.page.results.scene.get_untracked();
        assert_eq!(bench.attribute("svg.scene", "role"), "img");
        assert_eq!(bench.attribute("svg.scene", "aria-label"), t(scene.alt));
    }

    #[wasm_bindgen_test]
    async fn parts_move_with_the_head_and_back() {
        let bench = stage().await;
        bench.seek(3.0).await;
        let first = transforms(&bench);
        bench.seek(3.01).await;
        assert_ne!(transforms(&bench), first);
        bench.seek(3.0).await;
        assert_eq!(transforms(&bench), first);
    }

    #[wasm_bindgen_test]
    async fn parts_of_a_group_stay_together_after_a_change() {
        let bench = stage().await;
        bench.seek(3.0).await;
        // The face of the dancer is drawn anew, its body is not.
        bench.page.set("heads", crate::machines::form::Value::Number(7.0));
        bench.run().await;
        bench.seek(0.0).await;
        let mut groups = std::collections::BTreeMap::<String, Vec<String>>::new();
        for part in bench.all("[data-g]") {
            let group = part.get_attribute("data-g").unwrap_or_default();
            groups.entry(group).or_default().push(part.get_attribute("transform").unwrap_or_default());
        }
        assert!(groups.values().filter(|parts| parts.len() > 1).count() > 1);
        let apart: Vec<_> = groups.iter().filter(|(_, parts)| parts.iter().any(|part| *part != parts[0])).collect();
        assert!(apart.is_empty(), "{apart:?}");
    }

    #[wasm_bindgen_test]
    async fn state_is_ready_until_the_run_begins() {
        let bench = stage().await;
        assert_eq!(bench.text(".mode"), t("page.mode-ready"));
        assert!(bench.has(".mode.info"));
        bench.seek(1.0).await;
        let mode = bench.page.player.now.with_untracked(|now| now.mode);
        assert_eq!(bench.text(".mode"), t("page.mode-paused"));
        bench.page.player.playing.set(true);
        crate::ui::testing::settled().await;
        assert_eq!(bench.text(".mode"), t(mode_words(mode)));
    }

    #[wasm_bindgen_test]
    async fn state_names_the_operation_on_the_work() {
        let bench = stage().await;
        bench.seek(3.0).await;
        let activity = bench.page.player.activity.get_untracked().unwrap();
        let paused = format!("{} · {}", t("page.mode-paused"), sentence(&activity));
        assert!(activity.id == "ribbon.printing" && bench.text(".mode") == paused);
        bench.page.player.playing.set(true);
        crate::ui::testing::settled().await;
        let activity = bench.page.player.activity.get_untracked().unwrap();
        assert_eq!(bench.text(".mode"), sentence(&activity));
    }

    #[wasm_bindgen_test]
    async fn emergency_stop_is_shown_at_the_end_of_the_run() {
        let bench = stage().await;
        bench.seek(1.0).await;
        crate::ui::state::operator::act(bench.page, crate::motion::Action::EmergencyStop);
        bench.run().await;
        bench.seek(1.5).await;
        assert_eq!(bench.text(".mode"), t("page.mode-estop"));
        assert!(bench.has(".mode.fail"));
    }

    #[wasm_bindgen_test]
    async fn emergency_stop_at_the_beginning_is_never_ready() {
        let bench = stage().await;
        crate::ui::state::operator::act(bench.page, crate::motion::Action::EmergencyStop);
        bench.run().await;
        bench.drawn().await;
        assert_eq!(bench.page.player.head(), 0.0);
        assert_eq!(bench.text(".mode"), t("page.mode-estop"));
        assert!(bench.has(".mode.fail") && bench.has(".alarm-screen .forget"));
    }

    #[wasm_bindgen_test]
    async fn wrong_values_are_counted_and_lead_to_their_field() {
        let bench = stage().await;
        assert!(bench.has(".wrong-values.gone"));
        bench.page.entries.refuse("heads", *crate::ui::testing::field("heads").read_metric("x").unwrap_err());
        crate::ui::testing::settled().await;
        assert_eq!(bench.text(".wrong-values"), t("page.stale-short"));
        bench.press(".wrong-values").await;
        assert_eq!(document().active_element().unwrap().id(), "heads");
        bench.page.set("heads", crate::machines::form::Value::Number(6.0));
        bench.page.set("press-roller-diameter", crate::machines::form::Value::Number(150.0));
        crate::ui::testing::settled().await;
        assert_eq!(bench.text(".wrong-values"), sentence(&crate::msg!("page.wrong-values", count = 2_u32)));
    }

    #[wasm_bindgen_test]
    async fn run_that_stops_at_once_has_its_own_state() {
        let project = crate::project::Project::named("ribbon-line", Some("gsk-980tdc"), Some("paper")).unwrap();
        let bench = mount_project(project, || view! { <Stage /> }).await;
        bench.run().await;
        assert_eq!(bench.text(".mode"), t("page.mode-at-once"));
        assert!(bench.has(".mode.fail") && bench.has(".alarm-screen"));
    }

    #[wasm_bindgen_test]
    async fn state_of_a_program_with_an_error_is_never_running() {
        let bench = stage().await;
        bench.page.edit(|project| project.edited = project.listing());
        bench.run().await;
        bench.page.player.playing.set(true);
        bench.drawn().await;
        assert_eq!(bench.text(".mode"), t("page.mode-errors"));
    }

    #[wasm_bindgen_test]
    async fn drawing_of_another_machine_replaces_the_first() {
        let bench = stage().await;
        let first = bench.attribute("svg.scene", "aria-label");
        bench.page.change_machine(crate::machines::ALL[1].id());
        bench.run().await;
        assert_eq!(bench.all("svg.scene").len(), 1);
        assert_ne!(bench.attribute("svg.scene", "aria-label"), first);
    }

    #[wasm_bindgen_test]
    async fn parts_that_a_value_does_not_change_stay_in_the_drawing() {
        let bench = stage().await;
        bench.seek(3.0).await;
        let parts = bench.all("svg.scene > *");
        let values = [("pitch", 9.0), ("heads", 5.0)];
        for (field, value) in values {
            bench.page.set(field, crate::machines::form::Value::Number(value));
        }
        bench.run().await;
        bench.seek(3.0).await;
        let stayed = parts.iter().filter(|part| part.is_connected()).count();
        assert!(stayed > parts.len() / 2 && stayed < parts.len(), "{stayed} of {}", parts.len());
        let drawing = |bench: &ViewBench| bench.find("svg.scene").inner_html();
        let changed = drawing(&bench);
        let project = bench.page.project.get_untracked();
        drop(bench);
        let fresh = mount_project(project, || view! { <Stage /> <input id="heads" /> }).await;
        fresh.run().await;
        fresh.seek(3.0).await;
        assert_eq!(changed, drawing(&fresh));
    }

    #[wasm_bindgen_test]
    async fn parts_that_a_result_depends_on_are_marked() {
        let bench = stage().await;
        bench.page.show_causes(Some("line-speed"));
        crate::ui::testing::settled().await;
        let fields = |selector: &str| -> std::collections::BTreeSet<String> {
            bench.all(selector).iter().filter_map(|part| part.get_attribute("data-field")).collect()
        };
        let marked = fields(".cause");
        assert!(marked.contains("press-roller-diameter") && !marked.contains("loop-capacity"), "{marked:?}");
        assert_eq!(
            bench.all(".cause").len(),
            bench
                .all("[data-field]")
                .iter()
                .filter(|part| marked.contains(&part.get_attribute("data-field").unwrap()))
                .count()
        );
        bench.page.show_causes(None);
        crate::ui::testing::settled().await;
        assert!(!bench.has(".cause"));
    }

    #[wasm_bindgen_test]
    async fn strobe_button_is_there_where_the_scene_has_the_option() {
        let bench = stage().await;
        let option = bench.page.results.scene.with_untracked(|scene| scene.drawing_option);
        assert_eq!(bench.has(".strobe"), option.is_some());
        if let Some(words) = option {
            bench.press_button(t(words)).await;
            assert_eq!(bench.attribute(".strobe", "aria-pressed"), "true");
        }
    }
}
