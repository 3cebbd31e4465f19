//! The debugger: its commands above the listing, and below it the state at the stop.

use leptos::prelude::*;

use crate::controls::Control;
use crate::interp::inspect::Change;
use crate::project::program::Written;
use crate::text::{LineIndex, with_aside};
use crate::ui::parts::input::EntryField;
use crate::ui::parts::{Glyph, IconButton};
use crate::ui::state::Page;
use crate::ui::state::stepper::Stepper;
use crate::ui::state::stepping::{SteppingCommand, set_point};
use crate::ui::words::{clock, sentence, sentence_with_hints, short, t, value_of};

/// Whether the debugger is in use: a stop, a step under way, a watch or a breakpoint.
fn is_used(stepper: &Stepper) -> bool {
    stepper.at_stop || stepper.going || !stepper.watches.is_empty() || !stepper.points.list().is_empty()
}

/// The commands as buttons, and a field for the condition of the breakpoint at the cursor; shown while stepping.
#[component]
pub(super) fn DebuggerBar() -> impl IntoView {
    let page = Page::here();
    let condition = Signal::derive(move || {
        let signs = page.project.with_untracked(|project| project.control.syntax.comparison_signs);
        sentence(&crate::msg!(
            "page.stepping-condition",
            example = page.spelled(if signs { "#1<3" } else { "#1 LT 3" })
        ))
    });
    let button = move |command: SteppingCommand| {
        let (key, sign, words) = command.shown();
        let words = t(words);
        view! {
            <button
                type="button" class="icon" title=with_aside(words, key) aria-label=words
                on:click=move |_| command.run(page)
            >
                {sign}
            </button>
        }
    };
    let buttons = move || SteppingCommand::ALL.map(button).collect_view();
    view! {
        <Show when=move || page.view.stepping.get() || page.player.stepper.with(is_used)>
            <div class="bar tools stepping" role="group" aria-label=t("page.stepping")>
                {buttons}
                <EntryField words=condition take=move |text: String| set_point(page, Some(&text)) />
            </div>
        </Show>
    }
}

/// A row about the stop: a name, and its text lines.
type Row = (String, String);

/// The state at the stop, as rows.
#[derive(Clone, Default, PartialEq)]
struct State {
    under_way: Option<String>,
    changed: Option<Vec<Row>>,
    levels: Vec<Row>,
    points: Vec<(u32, Row)>,
    watches: Vec<Row>,
}

impl State {
    fn of(stepper: &Stepper, written: &Written) -> State {
        let control = written.parsed.control();
        let stop = stepper.stopped();
        let watch = |text: &String| {
            let value = stop.map_or_else(String::new, |debugger| {
                debugger
                    .evaluate(text)
                    .map_or_else(|why| sentence_with_hints(&why), |value| value_of(control, value, 6))
            });
            (text.clone(), value)
        };
        State {
            under_way: stepper.going.then(|| clock(stepper.t())),
            changed: stop.map(|_| changes(stepper, control)),
            levels: levels(stepper, written),
            points: points(stepper, written),
            watches: stepper.watches.iter().map(watch).collect(),
        }
    }
}

/// Variables and codes that the last step has changed.
fn changes(stepper: &Stepper, control: &Control) -> Vec<Row> {
    let Some(debugger) = stepper.stopped() else { return Vec::new() };
    let shown = |value| value_of(control, value, 6);
    let row =
        |change: Change| (change.subject.name(control), format!("{} → {}", shown(change.before), shown(change.after)));
    debugger.changes().into_iter().map(row).collect()
}

/// The call levels with their local variables.
fn levels(stepper: &Stepper, written: &Written) -> Vec<Row> {
    let (files, control) = (&written.files, written.parsed.control());
    let Some(debugger) = stepper.stopped() else { return Vec::new() };
    let mut rows = Vec::new();
    for level in debugger.levels() {
        let Some(file) = files.get(level.place.file) else { continue };
        let line = LineIndex::new(&file.text).line_of(level.place.span.start);
        let mut text = level.place.span.of(&file.text).to_owned();
        let locals: Vec<String> = level
            .locals()
            .map(|(number, value)| format!("{} = {}", control.variable(number), short(value, 6)))
            .collect();
        if !locals.is_empty() {
            text = format!("{text}\n{}", locals.join(" "));
        }
        rows.push((format!("{}:{line}", file.name), text));
    }
    rows
}

/// The breakpoints with their numbers.
fn points(stepper: &Stepper, written: &Written) -> Vec<(u32, Row)> {
    let row = |point: &crate::project::debugger::breakpoints::Breakpoint| {
        let mut text = match point.place {
            Some(place) => written.files.get(place.file).map_or("", |file| place.span.of(&file.text)),
            None => t("page.stepping-absent"),
        }
        .to_owned();
        if !point.condition.is_empty() {
            text = format!("{text}\nIF {}", point.condition);
        }
        if point.hits > 0 {
            text = format!("{text} · {} ×", point.hits);
        }
        (point.number, (point.name(), text))
    };
    stepper.points.list().iter().map(row).collect()
}

/// The state at the stop: reason of the stop, changes, call levels, breakpoints, watches.
#[component]
pub(super) fn StopState() -> impl IntoView {
    let page = Page::here();
    let stepper = page.player.stepper;
    let why = move || {
        stepper.with(|stepper| match (stepper.going, stepper.at_stop) {
            (true, _) => t("page.stepping-going").to_owned(),
            (_, true) => stepper.why.clone(),
            _ => String::new(),
        })
    };
    let state = Memo::new(move |_| {
        stepper.with(|stepper| page.program.written.with_untracked(|written| State::of(stepper, written)))
    });
    let watch = Signal::derive(move || sentence(&crate::msg!("page.stepping-watch", example = page.spelled("#100*2"))));
    let add = move |text: String| {
        stepper.update(|stepper| stepper.watches.push(text));
        true
    };
    view! {
        <div class="seen" class:gone=move || !page.view.stepping.get() && !stepper.with(is_used)>
            <p class="here" role="status">{why}</p>
            {move || state.with(|state| rows(page, state))}
            <EntryField words=watch take=add />
        </div>
    }
}

fn rows(page: Page, state: &State) -> impl IntoView + use<> {
    let stepper = page.player.stepper;
    let plain = |class: &'static str, row: &Row| view! { <p class=class><i>{row.0.clone()}</i> " " <span>{row.1.clone()}</span></p> };
    let removable = |row: &Row, remove: Callback<()>| {
        view! {
            <p>
                <i>{row.0.clone()}</i> " " <span>{row.1.clone()}</span>
                <IconButton class="quiet" glyph=Glyph::Close label=format!("{} {}", t("page.stepping-remove"), row.0) press=remove />
            </p>
        }
    };
    let changed = state.changed.as_ref().map(|rows| {
        let none = rows.is_empty().then_some("–");
        view! { <h3>{t("page.stepping-changed")}</h3> {none} {rows.iter().map(|row| plain("c", row)).collect_view()} }
    });
    let levels = state.changed.is_some().then(|| {
        view! { <h3>{t("page.stepping-stack")}</h3> {state.levels.iter().map(|row| plain("", row)).collect_view()} }
    });
    let point = |(number, row): &(u32, Row)| {
        let number = *number;
        removable(
            row,
            Callback::from(move || stepper.update(|stepper| stepper.points.retain(|point| point.number != number))),
        )
    };
    let points = (!state.points.is_empty()).then(|| {
        view! { <h3>{t("page.stepping-points")}</h3> {state.points.iter().map(point).collect_view()} }
    });
    let watch = |(at, row): (usize, &Row)| {
        removable(row, Callback::from(move || stepper.update(|stepper| drop(stepper.watches.remove(at)))))
    };
    view! {
        {state.under_way.clone().map(|time| view! { <p>{time}</p> })}
        {changed}
        {levels}
        {points}
        <h3>{t("page.stepping-watches")}</h3>
        {state.watches.iter().enumerate().map(watch).collect_view()}
    }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::text::FileId;
    use crate::ui::testing::{ViewBench, mount, settled, until};

    async fn debugger() -> ViewBench {
        let bench = mount(|| view! { <DebuggerBar /> <StopState /> }).await;
        bench.run().await;
        bench
    }

    async fn stepped(bench: &ViewBench, words: &'static str) {
        bench.press_button(t(words)).await;
        let stepper = bench.page.player.stepper;
        until(move || stepper.with_untracked(|stepper| stepper.at_stop)).await;
    }

    #[wasm_bindgen_test]
    async fn commands_are_hidden_until_stepping_starts() {
        let bench = debugger().await;
        assert!(!bench.has(".stepping") && bench.has(".seen.gone"));
        bench.page.view.stepping.set(true);
        settled().await;
        assert_eq!(bench.all(".stepping button").len(), SteppingCommand::ALL.len());
        assert!(!bench.has(".seen.gone"));
    }

    #[wasm_bindgen_test]
    async fn step_stops_at_the_next_block_and_names_it() {
        let bench = debugger().await;
        bench.page.view.stepping.set(true);
        settled().await;
        stepped(&bench, "page.stepping-into").await;
        let first = bench.text(".here");
        assert!(first.starts_with(t("page.stepping-next")), "{first}");
        stepped(&bench, "page.stepping-into").await;
        assert_ne!(bench.text(".here"), first);
        assert!(bench.text(".seen").contains(t("page.stepping-stack")));
        bench.press_button(t("page.stepping-stop")).await;
        assert_eq!(bench.text(".here"), "");
    }

    #[wasm_bindgen_test]
    async fn watch_is_shown_with_its_value_and_removed() {
        let bench = debugger().await;
        bench.page.view.stepping.set(true);
        settled().await;
        bench.type_into(".seen input", "1+2").await;
        bench.key(".seen input", "Enter", false).await;
        stepped(&bench, "page.stepping-into").await;
        assert_eq!(bench.text(".seen p:last-of-type span"), "3");
        bench.press_button(&format!("{} 1+2", t("page.stepping-remove"))).await;
        assert!(!bench.text(".seen").contains("1+2"));
    }

    #[wasm_bindgen_test]
    async fn breakpoint_without_a_chosen_line_asks_for_one() {
        let bench = debugger().await;
        bench.page.view.stepping.set(true);
        settled().await;
        bench.press_button(t("page.stepping-point")).await;
        assert_eq!(bench.notices(), [t("page.stepping-cursor")]);
    }

    #[wasm_bindgen_test]
    async fn breakpoint_stops_the_run_and_is_removed() {
        let bench = debugger().await;
        bench.page.view.stepping.set(true);
        settled().await;
        stepped(&bench, "page.stepping-into").await;
        stepped(&bench, "page.stepping-into").await;
        let place = bench.page.player.stepper.with_untracked(Stepper::place).unwrap();
        let line = LineIndex::new(&bench.page.program.text(place.file.0 as usize)).line_of(place.span.start);
        bench.page.player.seek(0.0);
        bench.page.player.stepper.update(|stepper| stepper.cursor = Some((FileId(place.file.0), line)));
        bench.press_button(t("page.stepping-point")).await;
        stepped(&bench, "page.stepping-go").await;
        assert!(bench.text(".here").starts_with(t("page.stepping-breakpoint")), "{}", bench.text(".here"));
        assert_eq!(bench.page.player.stepper.with_untracked(Stepper::place), Some(place));
        bench.press(".seen button[aria-label]").await;
        assert!(bench.page.player.stepper.with_untracked(|stepper| stepper.points.list().is_empty()));
        assert!(!bench.text(".seen").contains(t("page.stepping-points")));
    }
}
