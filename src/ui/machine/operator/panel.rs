//! The operator's panel: knobs, lamp buttons and emergency stop, acting at the play head. Folded to one bar until it is wanted.

use leptos::prelude::*;

use super::list::OperatorList;
use crate::math;
use crate::motion::{Action, Mode};
use crate::project::Project;
use crate::text::catalog::number_text;
use crate::ui::parts::input::{filled_part, number};
use crate::ui::parts::{Glyph, Icon, IconButton};
use crate::ui::state::Page;
use crate::ui::state::operator::{act, clear};
use crate::ui::state::outlook::CycleStart;
use crate::ui::words::{Tone, t};

/// Percent that the knobs reach.
const FULL: f64 = 200.0;

/// Degrees from the first to the last mark of a knob.
const TURN: f64 = 270.0;

/// The position of a knob or switch at the play head.
fn at_head<T: PartialEq + Send + Sync + 'static>(page: Page, position: fn(&Project, f64) -> T) -> Memo<T> {
    Memo::new(move |_| {
        let head = page.player.now.with(|now| now.t);
        page.project.with(|project| position(project, head))
    })
}

/// The panel.
#[component]
pub(crate) fn OperatorPanel() -> impl IntoView {
    let page = Page::here();
    let player = page.player;
    let open = page.view.panel;
    let spindle = at_head(page, Project::spindle_override_at);
    let feed = at_head(page, Project::feed_override_at);
    let step = Memo::new(move |_| page.project.with(|project| project.prepared().panel().override_step));
    let shown = Memo::new(move |_| open.get() && page.view.actions.get());
    let listed = move || shown.get();
    let count = Memo::new(move |_| page.project.with(|project| project.panel.events().len()));
    let pressed = Memo::new(move |_| player.now.with(|now| now.mode == Mode::EmergencyStop));
    let lamp = move || format!("lamp {}", player.now.with(|now| Tone::from(now.mode)));
    let percent = |letter: char, value: Memo<f64>| {
        view! { <span>{move || format!("{letter} {} %", number_text(value.get(), 1))}</span> }
    };
    view! {
        <section class="panel" class:open=open aria-label=t("page.operator-panel")>
            <div class="fold">
                <button
                    type="button" id="panel-fold" aria-controls="panel-body"
                    aria-expanded=move || open.get().to_string()
                    on:click=move |_| open.update(|open| *open = !*open)
                >
                    <i class=lamp aria-hidden="true"></i>
                    <b class="long">{t("page.operator-panel")}</b>
                    <b class="short">{t("page.operator-panel-short")}</b>
                    <span class="percents">{percent('S', spindle)} " " {percent('F', feed)}</span>
                    <span class="space"></span>
                    <Icon glyph=Glyph::Up />
                </button>
                <button
                    type="button" id="panel-list" class="quiet" aria-pressed=move || listed().to_string()
                    title=t("operator.list-about") on:click=move |_| page.view.toggle_actions()
                >
                    <Icon glyph=Glyph::List />
                    <span class="hidden">{t("operator.actions")}</span>
                    <b>{count}</b>
                </button>
                <button
                    type="button" class="mushroom" aria-pressed=move || pressed.get().to_string() aria-label=t("page.estop")
                    title=t("page.estop-about") on:click=move |_| act(page, Action::EmergencyStop)
                >
                    <i></i>
                </button>
            </div>
            <div id="panel-body" inert=move || !open.get()>
                <div class="plate" class:gone=listed>
                    <Knob id="spindle-knob" label="page.spindle-override" value=spindle step=step action=Action::SpindleOverride />
                    <Knob id="feed-knob" label="page.feed-override" value=feed step=Signal::stored(10.0) action=Action::FeedOverride />
                    <LampButtons />
                    <LastEffect />
                </div>
                {move || listed().then(|| view! { <OperatorList /> })}
            </div>
        </section>
    }
}

/// A knob: drag, wheel, arrow keys, or the buttons beside it.
#[component]
fn Knob(
    /// Id of its slider.
    id: &'static str,
    /// Catalog id of its name.
    label: &'static str,
    /// Percent at which the knob is set.
    value: Memo<f64>,
    /// Percent of a step.
    #[prop(into)]
    step: Signal<f64>,
    /// The action of turning it.
    action: fn(f64) -> Action,
) -> impl IntoView {
    let page = Page::here();
    let turn = move |percent: f64| {
        let percent = math::clamp(percent, 0.0, FULL);
        if percent != value.get_untracked() {
            act(page, action(percent));
        }
    };
    let by = move |sign: f64| turn(value.get_untracked() + sign * step.get_untracked());
    let plain = move |number: f64| number_text(number, 6);
    let pointer = move || format!("rotate({}deg)", plain(value.get() / FULL * TURN - TURN / 2.0));
    view! {
        <div class="knob">
            <label for=id>{t(label)}</label>
            <span class="dial" style:--part=move || filled_part(value.get(), (0.0, FULL))>
                <i style:transform=pointer aria-hidden="true"></i>
                <input
                    type="range" id=id min="0" max="200"
                    step=move || plain(step.get())
                    prop:value=move || plain(value.get())
                    on:input=move |event| if let Some(percent) = number(&event) { turn(percent) }
                />
            </span>
            <span class="by">
                <IconButton glyph=Glyph::Less label=format!("{} −", t(label)) press=move || by(-1.0) />
                <output for=id>{move || format!("{} %", plain(value.get()))}</output>
                <IconButton glyph=Glyph::More label=format!("{} +", t(label)) press=move || by(1.0) />
            </span>
        </div>
    }
}

/// The lamp buttons.
#[component]
fn LampButtons() -> impl IntoView {
    let page = Page::here();
    let waits = move || matches!(page.player.now.with(|now| now.mode), Mode::Hold | Mode::Stopped);
    let runs = move || page.player.now.with(|now| now.mode) == Mode::Running;
    let holds = move || page.player.now.with(|now| now.mode) == Mode::Hold;
    let single = at_head(page, |project, t| {
        let pressed = project.panel.last(t, |action| match action {
            Action::SingleBlock(on) => Some(*on),
            _ => None,
        });
        pressed.unwrap_or(false)
    });
    let is_single = move || single.get();
    // Whether there is an inverter depends on the machine and its control, not on the values.
    let has_inverter = Memo::new(move |_| {
        page.machine.track();
        page.control.track();
        page.project.with_untracked(|project| project.prepared().plc().watches_inverter())
    });
    let fault = at_head(page, |project, t| {
        let occurred = project.panel.last(t, |action| match action {
            Action::InverterFault(on) => Some(*on),
            _ => None,
        });
        occurred.unwrap_or(false)
    });
    let is_faulty = move || fault.get();
    let start = Memo::new(move |_| page.outlook.cycle_start());
    let acts = move || start.get() == CycleStart::Acts;
    let hindrance = move || match start.get() {
        CycleStart::Acts => None,
        CycleStart::AfterReset => Some(t("page.after-reset")),
        CycleStart::StopsAtOnce => Some(t("page.stops-at-once")),
        CycleStart::ComesBack => Some(t("page.comes-back")),
    };
    view! {
        <div class="presses">
            <button
                type="button" class="lit start" class:due=move || waits() && acts() class:on=move || runs() && acts()
                disabled=move || !acts() on:click=move |_| act(page, Action::Start)
            >
                {t("page.start")}
                {move || hindrance().map(|words| view! { <small>{words}</small> })}
            </button>
            <button type="button" class="lit hold" class:on=holds on:click=move |_| act(page, Action::Hold)>{t("page.hold")}</button>
            <button
                type="button" class="lit" class:on=is_single aria-pressed=move || is_single().to_string()
                on:click=move |_| act(page, Action::SingleBlock(!is_single()))
            >
                {t("page.single-block")}
            </button>
            <button type="button" class="lit" on:click=move |_| act(page, Action::Reset)>{t("page.reset")}</button>
            <button
                type="button" class="lit fault" class:gone=move || !has_inverter.get() class:on=is_faulty
                aria-pressed=move || is_faulty().to_string() title=t("page.inverter-fault-about")
                on:click=move |_| act(page, Action::InverterFault(!is_faulty()))
            >
                {t("page.inverter-fault")}
            </button>
        </div>
    }
}

/// Program zero return on controls that have it, the effect of the last action, and the button that removes all actions.
#[component]
fn LastEffect() -> impl IntoView {
    let page = Page::here();
    let told = move || match page.player.changed.get() {
        told if told.is_empty() => t("page.operator-panel-hint").to_owned(),
        told => told,
    };
    let count = move || page.project.with(|project| project.panel.events().len());
    let has_zero_return = Memo::new(move |_| page.project.with(|project| project.control.zero_return.is_some()));
    view! {
        <div class="changed">
            <p class="links">
                <button
                    type="button" class="link zero" class:gone=move || !has_zero_return.get() title=t("page.zero-return-about")
                    on:click=move |_| act(page, Action::ProgramZeroReturn)
                >
                    {t("page.zero-return")}
                </button>
                <button type="button" class="link clear" class:gone=move || count() == 0 on:click=move |_| clear(page)>
                    {t("page.clear-hand")} {move || format!(" ({})", count())}
                </button>
            </p>
            // A long effect scrolls, also by keys.
            <p id="changed" role="status" tabindex="0">{told}</p>
        </div>
    }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::testing::{ViewBench, mount, mount_project};

    async fn panel() -> ViewBench {
        let bench = mount(|| view! { <OperatorPanel /> }).await;
        bench.run().await;
        bench
    }

    #[wasm_bindgen_test]
    async fn folded_panel_takes_no_keys() {
        let bench = panel().await;
        assert_eq!(bench.attribute("#panel-fold", "aria-expanded"), "false");
        assert!(bench.has("#panel-body[inert]"));
        bench.press("#panel-fold").await;
        assert_eq!(bench.attribute("#panel-fold", "aria-expanded"), "true");
        assert!(!bench.has("#panel-body[inert]"));
    }

    #[wasm_bindgen_test]
    async fn list_takes_the_place_of_the_knobs() {
        let bench = panel().await;
        bench.page.note(crate::motion::Event { t: 1.0, action: Action::Hold });
        bench.press("#panel-list").await;
        assert!(bench.has(".panel.open .operator-list") && bench.has(".plate.gone"));
        assert_eq!(bench.text("#panel-list b"), "1");
        assert_eq!(bench.attribute("#panel-list", "aria-pressed"), "true");
        bench.press("#panel-list").await;
        assert!(bench.has(".panel.open .plate:not(.gone)") && !bench.has(".operator-list"));
        bench.press("#panel-list").await;
        bench.press("#panel-fold").await;
        assert!(!bench.has(".operator-list"));
        assert_eq!(bench.attribute("#panel-list", "aria-pressed"), "false");
    }

    #[wasm_bindgen_test]
    async fn buttons_of_a_knob_turn_it_by_a_step() {
        let bench = panel().await;
        let step = bench.page.project.with_untracked(|project| project.prepared().panel().override_step);
        bench.press_button(&format!("{} +", t("page.spindle-override"))).await;
        assert_eq!(bench.actions(), [Action::SpindleOverride(100.0 + step)]);
        assert_eq!(bench.value("#spindle-knob"), number_text(100.0 + step, 6));
        bench.press_button(&format!("{} −", t("page.spindle-override"))).await;
        assert_eq!(bench.text("output[for=spindle-knob]"), "100 %");
    }

    #[wasm_bindgen_test]
    async fn dragged_knob_acts_and_shows_in_the_folded_bar() {
        let bench = panel().await;
        bench.type_into("#feed-knob", "70").await;
        assert_eq!(bench.actions(), [Action::FeedOverride(70.0)]);
        assert!(bench.text(".percents").contains("F 70 %"));
    }

    #[wasm_bindgen_test]
    async fn knob_at_its_end_does_not_act_again() {
        let bench = panel().await;
        bench.type_into("#feed-knob", "200").await;
        bench.press_button(&format!("{} +", t("page.feed-override"))).await;
        assert_eq!(bench.actions(), [Action::FeedOverride(200.0)]);
    }

    #[wasm_bindgen_test]
    async fn lamp_buttons_do_their_actions() {
        let bench = panel().await;
        for words in ["page.start", "page.hold", "page.reset", "page.estop"] {
            bench.press_button(t(words)).await;
        }
        assert_eq!(bench.actions(), [Action::Start, Action::Hold, Action::Reset, Action::EmergencyStop]);
    }

    #[wasm_bindgen_test]
    async fn cycle_start_is_disabled_where_the_run_stops_at_once() {
        let project = crate::project::Project::named("ribbon-line", Some("gsk-980tdc"), Some("paper")).unwrap();
        let bench = mount_project(project, || view! { <OperatorPanel /> }).await;
        bench.run().await;
        assert_eq!(bench.text(".start small"), t("page.stops-at-once"));
        bench.press(".start").await;
        assert!(bench.actions().is_empty() && bench.has(".start[disabled]:not(.due):not(.on)"));
    }

    #[wasm_bindgen_test]
    async fn cycle_start_after_an_emergency_stop_asks_for_a_reset() {
        let bench = panel().await;
        bench.seek(1.0).await;
        bench.press_button(t("page.estop")).await;
        bench.run().await;
        bench.seek(1.5).await;
        assert_eq!(bench.text(".start small"), t("page.after-reset"));
        bench.press_button(t("page.reset")).await;
        bench.run().await;
        assert!(!bench.has(".start[disabled]"));
    }

    #[wasm_bindgen_test]
    async fn single_block_button_turns_on_and_off() {
        let bench = panel().await;
        bench.press_button(t("page.single-block")).await;
        assert!(bench.has("[aria-pressed=true].on"));
        bench.press_button(t("page.single-block")).await;
        assert!(!bench.has("[aria-pressed=true]"));
        assert_eq!(bench.actions(), [Action::SingleBlock(true), Action::SingleBlock(false)]);
    }

    #[wasm_bindgen_test]
    async fn fault_button_is_for_machines_with_an_inverter() {
        let bench = panel().await;
        for on in [true, false] {
            bench.press_button(t("page.inverter-fault")).await;
            assert_eq!(bench.actions().last(), Some(&Action::InverterFault(on)));
            assert_eq!(bench.attribute(".fault", "aria-pressed"), on.to_string());
        }
        assert!(!bench.has(".fault.gone"));
        let polygon = crate::project::Project::of("polygon-lathe", None).unwrap();
        let bench = mount_project(polygon, || view! { <OperatorPanel /> }).await;
        assert!(bench.has(".fault.gone"));
    }

    #[wasm_bindgen_test]
    async fn zero_return_shows_places_on_controls_that_have_it() {
        for (control, has_it) in [("mitsubishi-e60", false), ("gsk-980tdc", true)] {
            let project = crate::project::Project::of("turning-spindle", Some(control)).unwrap();
            let bench = mount_project(project, || view! { <OperatorPanel /> }).await;
            assert_eq!(bench.has(".zero:not(.gone)"), has_it, "{control}");
            if has_it {
                bench.run().await;
                bench.seek(9.0).await;
                bench.press_button(t("page.reset")).await;
                bench.press_button(t("page.zero-return")).await;
                assert_eq!(bench.actions(), [Action::Reset, Action::ProgramZeroReturn]);
                let told = bench.text("#changed");
                assert!(told.contains(" X 150 (without it ") && told.contains(", Z 100 (without it "), "{told}");
            }
        }
    }

    #[wasm_bindgen_test]
    async fn effect_is_shown_and_all_actions_can_be_removed() {
        let bench = panel().await;
        assert_eq!(bench.text("#changed"), t("page.operator-panel-hint"));
        assert!(bench.has(".changed .clear.gone"));
        bench.seek(3.0).await;
        bench.type_into("#spindle-knob", "50").await;
        let told = bench.text("#changed");
        assert!(told.starts_with("00:03.0000: ") && told.contains(" 50 %"), "{told}");
        // The text scrolls, and the button stays.
        assert!(bench.has("#changed[tabindex='0']") && !bench.has("#changed .clear"));
        bench.press(".changed .clear").await;
        assert!(bench.actions().is_empty() && bench.has(".changed .clear.gone"));
    }
}
