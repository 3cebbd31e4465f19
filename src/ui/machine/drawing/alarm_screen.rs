//! The screen of the control over the drawing: an alarm or a message of the program in large type, its meaning, and the way out.

use leptos::prelude::*;

use crate::machines::MachineVariable;
use crate::motion::{Action, Event, Mode, RunEnd};
use crate::project::findings::check::reported;
use crate::project::run;
use crate::text::catalog::of_program;
use crate::text::{Diagnostic, DiagnosticKind, MessageValue, Phrase, Place};
use crate::ui::state::Page;
use crate::ui::state::operator::remove;
use crate::ui::state::outlook::CycleStart;
use crate::ui::words::{Tone, sentence, sentence_with_hints, t, value_of};
use crate::view::Advice;

/// Content of the screen.
#[derive(Clone, PartialEq)]
pub(super) struct ScreenText {
    /// Weight.
    pub tone: Tone,
    /// Number of the alarm; empty for a message.
    alarm: String,
    /// The control's words for the number, where the program has a text of its own.
    wording: Option<&'static str>,
    /// The text, in the control's words or in those of the program; empty for a number alone.
    headline: String,
    /// The program's text in the language of the page, if macroline wrote the program.
    translation: Option<String>,
    /// The meaning in a sentence.
    meaning: String,
    /// The block that raises it.
    place: Option<Place>,
    /// Catalog id of the instruction; empty if the meaning has it.
    way_out: &'static str,
}

/// Content of the screen at the play head; `None` if there is nothing to report.
pub(super) fn screen_text(page: Page) -> Option<ScreenText> {
    let player = page.player;
    let at_once = page.outlook.stopped.with(Option::is_some);
    let planned = player.planned.get();
    let at_end = planned.is_over && player.now.with(|now| now.t) >= planned.end;
    match player.ended.get().filter(|_| at_once || at_end) {
        Some(RunEnd::Alarm(alarm)) => Some(of_alarm(page, &alarm, at_once)),
        Some(RunEnd::Stop) => of_stop(page, planned.end, at_once),
        _ => player.message.get().map(|headline| ScreenText {
            tone: Tone::Info,
            alarm: String::new(),
            wording: None,
            translation: of_program(&headline),
            headline,
            meaning: t("page.own-message").to_owned(),
            place: None,
            way_out: "",
        }),
    }
}

/// A stop at the end of the run, with the message of the PLC that holds the program, or the program's own.
fn of_stop(page: Page, end: f64, at_once: bool) -> Option<ScreenText> {
    let (held, headline, place) = page.player.ask_planner(|run| {
        let timeline = run.timeline();
        (run.plc_hold().map(sentence), timeline.message_at(end).map(str::to_owned), timeline.block_at(end))
    })?;
    if let Some(meaning) = held {
        return Some(of_hold(meaning, place));
    }
    let headline = headline?;
    let way_out = match page.outlook.cycle_start() {
        CycleStart::StopsAtOnce => "page.way-value",
        CycleStart::ComesBack => "page.way-comes-back",
        _ if page.player.is_reset() => "page.end-reset",
        _ => "page.way-start",
    };
    let (tone, meaning) =
        if at_once { (Tone::Fail, "page.own-message-at-once") } else { (Tone::Warn, "page.own-message") };
    let translation = of_program(&headline);
    Some(ScreenText {
        tone,
        alarm: String::new(),
        wording: None,
        headline,
        translation,
        meaning: t(meaning).to_owned(),
        place,
        way_out,
    })
}

/// A hold of the PLC: its sentence has the way out.
fn of_hold(meaning: String, place: Option<Place>) -> ScreenText {
    let (alarm, headline) = (String::new(), t("size.hold").to_owned());
    ScreenText { tone: Tone::Fail, alarm, wording: None, headline, translation: None, meaning, place, way_out: "" }
}

fn of_alarm(page: Page, alarm: &Diagnostic, at_once: bool) -> ScreenText {
    // Uses the sentence of the finding at the place of the alarm in the program.
    let known = page.program.findings.with(|found| reported(found, alarm).cloned());
    let alarm = known.as_ref().unwrap_or(alarm);
    let own = match alarm.message.value("text") {
        Some(MessageValue::Text(text)) if alarm.kind == DiagnosticKind::ProgramAlarm => Some(text.as_str()),
        _ => None,
    };
    let translation = own.and_then(of_program);
    let words = alarm.wording.map(Phrase::words);
    let (wording, headline) = match own {
        Some(own) => (words, own.to_owned()),
        None => (None, words.unwrap_or_default().to_owned()),
    };
    let meaning = match alarm.kind {
        DiagnosticKind::ProgramAlarm if at_once => t("page.own-alarm-at-once").to_owned(),
        DiagnosticKind::ProgramAlarm => t("page.own-alarm").to_owned(),
        _ => sentence_with_hints(alarm),
    };
    let way_out = match alarm.place {
        Some(_) if at_once => "page.way-value",
        Some(_) => "page.way-reset",
        None => "",
    };
    let number = alarm.alarm.as_deref().unwrap_or_default().to_owned();
    ScreenText { tone: Tone::Fail, alarm: number, wording, headline, translation, meaning, place: alarm.place, way_out }
}

/// Variables that a text names, with meaning and value at the end of the run.
fn named(page: Page, text: &str) -> Vec<(String, &'static str, String)> {
    let control = page.project.with(|project| project.control);
    let end = page.player.planned.get().end;
    let names = |number| text.split_whitespace().any(|word| word == control.variable(number));
    let row = |MachineVariable { number, label, unit }: MachineVariable| {
        let value = page.player.ask_planner(|planner| run::shown(planner, control, number, end)).flatten();
        (control.variable(number), t(label), format!("{} {unit}", value_of(control, value, 3)))
    };
    page.results.variables.get().into_iter().filter(|row| names(row.number)).map(row).collect()
}

/// The screen; empty while there is no alarm and no message.
#[component]
pub(super) fn AlarmScreen(
    /// Content of the screen at the play head.
    text: Memo<Option<ScreenText>>,
) -> impl IntoView {
    let page = Page::here();
    // A bar over the lower edge of the drawing until opened: labels stay in sight.
    let open = RwSignal::new(false);
    move || {
        let ScreenText { tone, alarm, wording, headline, translation, meaning, place, way_out } = text.get()?;
        // A number alone says nothing: the meaning is beside it.
        let bare = headline.is_empty();
        let spaced =
            |text: &str| if alarm.is_empty() || text.is_empty() { text.to_owned() } else { format!(" {text}") };
        let (wording, headline) = (wording.map(spaced), spaced(&headline));
        let wording = wording.map(|wording| view! { <span class="wording">{wording}</span> });
        let number = alarm.clone();
        let more = (!alarm.is_empty()).then(|| {
            let open = move |_| page.view.explain(format!("alarm.{alarm}"));
            view! { <button type="button" class="link more" on:click=open>{t("help.more")}</button> }
        });
        let rows = named(page, &headline).into_iter().map(|(name, label, value)| {
            view! { <dt><code>{name}</code> " " {label}</dt><dd>{value}</dd> }
        });
        let rows = rows.collect_view();
        let remedy = page.outlook.stopped.get().and_then(|stopped| stopped.remedy);
        let forget = emergency_stop(page).map(|at| {
            view! {
                <p class="act">
                    <button type="button" class="forget" on:click=move |_| remove(page, at)>{t("page.forget-action")}</button>
                </p>
            }
        });
        let way_out = (!way_out.is_empty() && remedy.is_none()).then(|| view! { <p class="way-out">{t(way_out)}</p> });
        let block = place.and_then(|place| Some((place, page.place_words(place)?)));
        let block = block.map(|(place, words)| {
            view! { <button type="button" class="link" on:click=move |_| page.show_place(place)>{words}</button> }
        });
        Some(view! {
            <section
                class=format!("alarm-screen {tone}") class:open=move || open.get() class:bare=bare
                role="status" aria-label=t("page.screen")
            >
                <h2>{number}{wording}{headline}</h2>
                {translation.map(|words| view! { <p class="translation">{words}</p> })}
                <button
                    type="button" class="unfold" aria-expanded=move || open.get().to_string()
                    on:click=move |_| open.update(|open| *open = !*open)
                >
                    {move || t(if open.get() { "page.screen-less" } else { "page.screen-more" })}
                </button>
                <p>{meaning} " " {block} " " {more}</p>
                <dl>{rows}</dl>
                {way_out}
                {remedy.map(|advice| view! { <Remedy advice=advice /> })}
                {forget}
            </section>
        })
    }
}

/// Place of the operator's emergency stop that ended the run, in the list of actions.
fn emergency_stop(page: Page) -> Option<usize> {
    let ended = page.player.now.with(|now| now.mode == Mode::EmergencyStop);
    let at = page.player.planned.get().end;
    let is_stop = |event: &Event| event.action == Action::EmergencyStop && event.t <= at;
    page.project.with(|project| project.panel.events().iter().rposition(is_stop)).filter(|_| ended)
}

/// The entries of the form with which the run moves.
#[component]
fn Remedy(
    /// Entries of the form that make the run move.
    advice: Advice,
) -> impl IntoView {
    let page = Page::here();
    let (words, why) = (advice.button.as_ref().map(sentence), sentence(&advice.message));
    view! {
        <p class="way-out act">
            <span>{t("page.way-remedy")} " "</span>
            <button type="button" class="primary remedy" title=why on:click=move |_| page.take_entries(&advice.entries)>
                {words}
            </button>
        </p>
    }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::machines::form::Value;
    use crate::project::Project;
    use crate::text::catalog::{self, Language};
    use crate::ui::state::operator::act;
    use crate::ui::testing::{ViewBench, mount, mount_project, until};

    fn screen_view() -> impl IntoView {
        let page = Page::here();
        view! { <AlarmScreen text=Memo::new(move |_| screen_text(page)) /> }
    }

    async fn screen(control: &str) -> ViewBench {
        let project = Project::named("ribbon-line", Some(control), Some("paper")).unwrap();
        let bench = mount_project(project, screen_view).await;
        bench.run().await;
        bench
    }

    #[wasm_bindgen_test]
    async fn moving_run_shows_no_alarm_screen() {
        assert!(!screen("mitsubishi-e60").await.has(".alarm-screen"));
    }

    #[wasm_bindgen_test]
    async fn alarm_of_the_program_is_explained_with_its_values() {
        let bench = screen("gsk-980tdc").await;
        assert_eq!(bench.text("h2"), "5920 FEED #115 ABOVE LIMIT #119");
        assert!(bench.text("dl").contains("#119") && bench.text("dl").contains(t("ribbon.feed-limit")));
        assert!(bench.text("p").contains(t("page.own-alarm-at-once")));
        bench.press(".link.more").await;
        assert_eq!(bench.page.view.help_at.get_untracked(), "alarm.5920");
        bench.press(".link").await;
        assert_eq!(bench.page.view.sought.get_untracked().map(|place| place.file.0), Some(0));
    }

    #[wasm_bindgen_test]
    async fn text_of_the_program_follows_a_shared_alarm_number() {
        let mut project = Project::named("ribbon-line", Some("mitsubishi-e60"), None).unwrap();
        // The print roller would have to turn five times as fast: above its clamp.
        project.values.insert("heads".to_owned(), Value::Number(7.0));
        let bench = mount_project(project, screen_view).await;
        bench.run().await;
        let shown = bench.text("h2");
        assert!(shown.starts_with("P277 ") && shown.ends_with("FEED ABOVE CLAMP 20000"), "{shown}");
        assert!(bench.text("p").contains(t("page.own-alarm-at-once")));
    }

    #[wasm_bindgen_test]
    async fn bar_opens_and_folds() {
        let bench = screen("gsk-980tdc").await;
        assert_eq!(bench.attribute(".unfold", "aria-expanded"), "false");
        bench.press(".unfold").await;
        assert!(bench.has(".alarm-screen.open") && bench.text(".unfold") == t("page.screen-less"));
        bench.press(".unfold").await;
        assert!(!bench.has(".alarm-screen.open"));
    }

    #[wasm_bindgen_test]
    async fn message_of_a_control_without_alarms_is_shown_as_well() {
        let bench = screen("sinumerik-802d").await;
        assert_eq!(bench.text("h2"), "FEED R115 ABOVE LIMIT R119");
        assert!(bench.text("p").contains(t("page.own-message-at-once")));
    }

    #[wasm_bindgen_test]
    async fn text_of_the_program_has_its_chinese_below() {
        catalog::speak(Language::Chinese.sentences());
        let mut shown = Vec::new();
        for control in ["gsk-980tdc", "sinumerik-802d"] {
            let bench = screen(control).await;
            shown.push((bench.text("h2"), bench.text(".translation")));
        }
        catalog::speak(Language::English.sentences());
        let expected = [
            ("5920 FEED #115 ABOVE LIMIT #119", "进给 #115 超过上限 #119"),
            ("FEED R115 ABOVE LIMIT R119", "进给 R115 超过上限 R119"),
        ];
        assert_eq!(shown, expected.map(|(text, chinese)| (text.to_owned(), chinese.to_owned())));
        assert!(!screen("gsk-980tdc").await.has(".translation"));
    }

    #[wasm_bindgen_test]
    async fn remedy_is_one_click_and_one_step() {
        for control in ["gsk-980tdc", "sinumerik-802d"] {
            let bench = screen(control).await;
            bench.press(".remedy").await;
            bench.run().await;
            assert!(!bench.has(".alarm-screen"), "{control}");
            bench.page.undo();
            bench.run().await;
            assert!(bench.has(".alarm-screen .remedy"), "{control}");
        }
    }

    #[wasm_bindgen_test]
    async fn hold_by_a_contact_is_shown_and_refuses_cycle_start() {
        let mut project = Project::named("ribbon-line", Some("mitsubishi-e60"), None).unwrap();
        project.values.insert("loop-capacity".to_owned(), Value::Number(20.0));
        let bench = mount_project(project, screen_view).await;
        bench.run().await;
        let player = bench.page.player;
        until(move || player.planned.get_untracked().is_over).await;
        bench.seek(player.planned.get_untracked().end).await;
        bench.drawn().await;
        assert_eq!(bench.text("h2"), t("size.hold"));
        assert!(bench.text(".alarm-screen p").starts_with("The loop is at its longest limit of 20 mm"));
        assert_ne!(untrack(|| bench.page.outlook.cycle_start()), CycleStart::Acts);
    }

    #[wasm_bindgen_test]
    async fn emergency_stop_is_shown_with_its_remedy() {
        let bench = mount(screen_view).await;
        bench.run().await;
        bench.seek(1.0).await;
        act(bench.page, Action::EmergencyStop);
        bench.run().await;
        bench.page.player.seek(20.0);
        bench.drawn().await;
        assert!(bench.text(".alarm-screen p").contains(t("motion.emergency-stop")));
        assert!(!bench.has(".way-out"));
        bench.press(".forget").await;
        bench.run().await;
        assert!(bench.actions().is_empty() && !bench.has(".alarm-screen"));
    }
}
