//! Marks on the time axis: milestones of the run with their names, actions of the operator, and the end of the run.

use leptos::html;
use leptos::prelude::*;

use super::action_marks::ActionMarks;
use crate::controls::{Code, Control};
use crate::motion::{Milestone, Mode};
use crate::msg;
use crate::text::number::filled;
use crate::text::{columns, headed};
use crate::ui::dom;
use crate::ui::state::player::RunMoment;
use crate::ui::state::{Page, put};
use crate::ui::words::{clock, sentence, t};

/// Pixels of a letter of a name, and beside the name.
const LETTER: f64 = 6.5;
const ROOM: f64 = 8.0;
/// Pixels between two marks of the same name below which they are merged.
const SAME: f64 = 3.0;
/// Pixels of the symbol of an action or of the end.
const SYMBOL: f64 = 12.0;

/// A milestone: its time (s) and name. The names of greater weight are placed first.
#[derive(Debug, Clone, PartialEq)]
struct Named {
    t: f64,
    words: String,
    weight: u8,
}

/// The milestones of a moment's plan in the order of time.
fn milestones(moment: &RunMoment, control: &Control) -> Vec<Named> {
    let timeline = moment.run.timeline();
    let named = |(t, milestone): (f64, Milestone)| {
        let (words, weight) = match milestone {
            Milestone::Spindle(rotation) => {
                let code = Code::of_rotation(rotation);
                let row = control.codes.iter().find(|row| row.code == code)?;
                (control.code_name(row.id), 2)
            }
            Milestone::Mode(mode) => match mode {
                Mode::Dwell => (t_owned("page.mark-dwell"), 0),
                Mode::Hold => (t_owned("page.mark-hold"), 1),
                Mode::Stopped => (t_owned("page.mark-stop"), 1),
                Mode::Ended => (t_owned("page.mark-end"), 1),
                Mode::Alarm => (t_owned("page.mark-alarm"), 3),
                Mode::EmergencyStop => (t_owned("page.mark-estop"), 3),
                Mode::Running | Mode::WaitFin => return None,
            },
        };
        Some(Named { t, words, weight })
    };
    let mut found: Vec<Named> = timeline.milestones().into_iter().filter_map(named).collect();
    if let Some((t, id)) = moment.machine.first_contact(moment.run, timeline.end()) {
        found.push(Named { t, words: t_owned(id), weight: 3 });
    }
    // The first pass begins with the first contact.
    let passes = (1_u32..).zip(moment.machine.pass_starts(moment.run, timeline.end())).skip(1);
    found.extend(passes.map(|(number, t)| Named { t, words: sentence(&msg!("page.mark-pass", number)), weight: 1 }));
    found.sort_by(|a, b| a.t.total_cmp(&b.t));
    found
}

fn t_owned(id: &'static str) -> String {
    t(id).to_owned()
}

/// A mark in its place.
#[derive(Debug, Clone, PartialEq)]
struct Placed {
    /// Percent of the axis.
    at: f64,
    t: f64,
    words: String,
    /// Side of the mark on which its name has room.
    side: Option<Side>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Side {
    Right,
    Left,
}

/// Places the milestones of the shown time on an axis of `width` pixels; a name that would overlap another one, a symbol (of an action or
/// the end, at these times) or the end of the axis is left out. A name is on the side with fewer lines of others, and a dwell behind a name is
/// left out.
fn placed(found: &[Named], (from, to): (f64, f64), width: f64, symbols: &[f64]) -> Vec<Placed> {
    let pixel = |t: f64| (t - from) / (to - from) * width;
    let mut marks: Vec<(f64, &Named)> = Vec::new();
    for row in found.iter().filter(|row| (from..=to).contains(&row.t)) {
        let x = pixel(row.t);
        let same = |(at, other): &&(f64, &Named)| x - at < SAME && other.words == row.words;
        if marks.iter().rev().take(4).find(same).is_none() {
            marks.push((x, row));
        }
    }
    let mut taken: Vec<(f64, f64)> =
        symbols.iter().map(|t| pixel(*t)).map(|x| (x - 0.5 * SYMBOL, x + 0.5 * SYMBOL)).collect();
    let mut sides = vec![None; marks.len()];
    let mut order: Vec<usize> = (0..marks.len()).collect();
    order.sort_by_key(|at| core::cmp::Reverse(marks.get(*at).map_or(0, |mark| mark.1.weight)));
    for at in order {
        let Some((x, row)) = marks.get(at) else { continue };
        let wide = ROOM + LETTER * columns(&row.words) as f64;
        let areas = [(Side::Right, (*x, x + wide)), (Side::Left, (x - wide, *x))];
        let free =
            |(_, (a, b)): &&(Side, (f64, f64))| *a >= 0.0 && *b <= width && taken.iter().all(|(c, d)| b <= c || d <= a);
        let lines = |(_, (a, b)): &&(Side, (f64, f64))| marks.iter().filter(|(line, _)| a < line && line < b).count();
        if let Some((side, area)) = areas.iter().filter(free).min_by_key(lines) {
            taken.push(*area);
            if let Some(place) = sides.get_mut(at) {
                *place = Some(*side);
            }
        }
    }
    let place = |((x, row), side): ((f64, &Named), Option<Side>)| Placed {
        at: 100.0 * x / width,
        t: row.t,
        words: row.words.clone(),
        side,
    };
    // A line behind the letters of another mark makes them hard to read.
    let names = taken.get(symbols.len()..).unwrap_or_default();
    let behind = |x: f64| names.iter().any(|(a, b)| *a < x && x < *b);
    let is_shown = |((x, row), side): &((f64, &Named), Option<Side>)| side.is_some() || row.weight > 0 || !behind(*x);
    marks.into_iter().zip(sides).filter(is_shown).map(place).collect()
}

/// The marks.
#[component]
pub(in crate::ui::machine) fn Marks(
    /// Ends of the shown time, in seconds.
    axis: RwSignal<(f64, f64)>,
) -> impl IntoView {
    let page = Page::here();
    let host: NodeRef<html::Div> = NodeRef::new();
    let found = RwSignal::new(Vec::<Named>::new());
    let mut plans = None;
    page.player.paint(move |moment| {
        if moment.slow && plans != Some(moment.plans) {
            plans = Some(moment.plans);
            let control = page.project.with_untracked(|project| project.control);
            put(found, milestones(moment, control));
        }
    });
    let width = RwSignal::new(0);
    host.on_load(move |host| {
        let axis = host.clone();
        dom::on_resize(&host, move || {
            // The page may be gone.
            if width.try_get_untracked().is_some() {
                put(width, axis.client_width());
            }
        });
    });
    let place = move |seconds: f64| {
        let (from, to) = axis.get();
        (from..=to).contains(&seconds).then(|| 100.0 * (seconds - from) / (to - from))
    };
    // The end of a run that is over: its time and place.
    let end = move || {
        let planned = page.player.planned.get();
        Some((planned.end, place(planned.end).filter(|_| planned.is_over)?))
    };
    let shown = Memo::new(move |_| {
        let mut symbols: Vec<f64> =
            page.project.with(|project| project.panel.events().iter().map(|event| event.t).collect());
        symbols.extend(end().map(|(seconds, _)| seconds));
        let width = f64::from(width.get().max(1));
        found.with(|found| placed(found, axis.get(), width, &symbols))
    });
    // A mark changes in place: while a field is dragged, each step moves it.
    let named = move |at: usize| {
        let mark = Memo::new(move |_| shown.with(|shown| shown.get(at).cloned()));
        let of =
            move |what: fn(&Placed) -> String| move || mark.with(|mark| mark.as_ref().map(what).unwrap_or_default());
        let class = |mark: &Placed| if mark.side == Some(Side::Left) { "event left" } else { "event" }.to_owned();
        let title = |mark: &Placed| headed(clock(mark.t), &mark.words);
        let words = |mark: &Placed| mark.side.map_or_else(String::new, |_| mark.words.clone());
        let at = of(|mark| filled("#", &[mark.at]));
        let go = move |_| {
            if let Some(t) = mark.with_untracked(|mark| mark.as_ref().map(|mark| mark.t)) {
                page.player.seek(t);
            }
        };
        view! {
            <button type="button" class=of(class) tabindex="-1" aria-label=of(title) title=of(title) style=("--at", at) on:click=go>
                {of(words)}
            </button>
        }
    };
    let count = move || 0..shown.with(Vec::len);
    let percent = move || end().map(|(_, percent)| filled("#", &[percent]));
    let is_over = Memo::new(move |_| percent().is_some());
    let ended = move || {
        is_over.get().then(
            || view! { <i class="mark end" style=("--at", move || percent().unwrap_or_default()) title=t("page.end")></i> },
        )
    };
    view! { <div class="marks" node_ref=host><For each=count key=|at| *at children=named /><ActionMarks axis=axis />{ended}</div> }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::project::Project;
    use crate::ui::state::player::PlannedPart;
    use crate::ui::testing::{ViewBench, mount, mount_project, settled, until};

    fn rows(rows: &[(f64, &str, u8)]) -> Vec<Named> {
        rows.iter().map(|(t, words, weight)| Named { t: *t, words: (*words).to_owned(), weight: *weight }).collect()
    }

    #[wasm_bindgen_test]
    fn names_overlap_neither_each_other_nor_the_axis_ends() {
        let found = rows(&[
            (0.0, "M3", 2),
            (0.1, "dwell", 0),
            (2.0, "first dot", 3),
            (2.2, "dwell", 0),
            (9.9, "M5", 2),
            (10.0, "end", 1),
        ]);
        for width in [80.0, 200.0, 343.0, 800.0] {
            let placed = placed(&found, (0.0, 10.0), width, &[5.0]);
            let left_out = found.iter().filter(|row| placed.iter().all(|mark| mark.t != row.t));
            assert!(left_out.map(|row| row.words.as_str()).all(|words| words == "dwell"), "{width}");
            let areas: Vec<(f64, f64)> = placed
                .iter()
                .filter_map(|mark| {
                    let (x, wide) = (mark.at / 100.0 * width, ROOM + LETTER * mark.words.len() as f64);
                    Some(if mark.side? == Side::Right { (x, x + wide) } else { (x - wide, x) })
                })
                .collect();
            let lines = placed.iter().filter(|mark| mark.words == "dwell").map(|mark| mark.at / 100.0 * width);
            let crossed = lines.filter(|x| areas.iter().any(|(a, b)| a < x && x < b)).count();
            assert_eq!(crossed, 0, "{width}: {areas:?}");
            for (at, (a, b)) in areas.iter().enumerate() {
                assert!(*a >= 0.0 && *b <= width, "{width}: {a} {b}");
                assert!(areas[at + 1..].iter().all(|(c, d)| b <= c || d <= a), "{width}: {areas:?}");
            }
        }
        let wide = placed(&found, (0.0, 10.0), 800.0, &[]);
        let named: Vec<_> = wide.iter().filter_map(|mark| Some((mark.words.as_str(), mark.side?))).collect();
        for name in [("M3", Side::Right), ("first dot", Side::Left), ("M5", Side::Left)] {
            assert!(named.contains(&name), "{name:?}: {named:?}");
        }
    }

    #[wasm_bindgen_test]
    fn marks_of_one_name_at_one_place_are_one() {
        let found: Vec<Named> =
            (0..1000).map(|at| Named { t: f64::from(at) * 0.01, words: "dwell".to_owned(), weight: 0 }).collect();
        assert!(placed(&found, (0.0, 10.0), 300.0, &[]).len() <= 101);
    }

    #[wasm_bindgen_test]
    async fn milestones_of_the_run_are_named_and_lead_to_their_times() {
        let (bench, axis) = marks().await;
        bench.run().await;
        let player = bench.page.player;
        until(move || player.planned.get_untracked().is_over).await;
        axis.set((0.0, bench.page.player.planned.get_untracked().end));
        bench.drawn().await;
        let titles: Vec<String> = bench.all(".event").iter().filter_map(|mark| mark.get_attribute("title")).collect();
        for words in ["M3", t("ribbon.first-dot"), "M5", t("page.mark-end")] {
            assert!(titles.iter().any(|title| title.ends_with(&format!(": {words}"))), "{words}: {titles:?}");
        }
        let first = titles.iter().position(|title| title.ends_with(t("ribbon.first-dot"))).unwrap();
        bench.press(&format!(".event:nth-of-type({})", first + 1)).await;
        assert!(titles[first].starts_with(&clock(bench.page.player.head())));
    }

    #[wasm_bindgen_test]
    async fn passes_after_the_first_are_marked() {
        let axis = RwSignal::new((0.0, 10.0));
        let lathe = Project::of("turning-spindle", None).unwrap();
        let bench = mount_project(lathe, move || view! { <Marks axis=axis /> }).await;
        bench.run().await;
        let player = bench.page.player;
        until(move || player.planned.get_untracked().is_over).await;
        axis.set((0.0, player.planned.get_untracked().end));
        bench.drawn().await;
        let titles: Vec<String> = bench.all(".event").iter().filter_map(|mark| mark.get_attribute("title")).collect();
        let passes: Vec<&str> = titles.iter().filter_map(|title| Some(title.split_once(": ")?.1)).collect();
        let place = |words: &str| passes.iter().position(|title| *title == words);
        assert!(place("first contact") < place("pass 2") && place("pass 1").is_none(), "{passes:?}");
        assert!(place("pass 2") < place("M5"), "{passes:?}");
    }

    async fn marks() -> (ViewBench, RwSignal<(f64, f64)>) {
        let axis = RwSignal::new((0.0, 10.0));
        (mount(move || view! { <Marks axis=axis /> }).await, axis)
    }

    #[wasm_bindgen_test]
    async fn end_is_marked_only_when_the_run_is_over() {
        let (bench, _) = marks().await;
        bench.page.player.planned.set(PlannedPart { end: 8.0, is_over: false });
        settled().await;
        assert!(!bench.has(".mark.end"));
        bench.page.player.planned.set(PlannedPart { end: 8.0, is_over: true });
        settled().await;
        assert_eq!(bench.style(".mark.end", "--at"), "80");
    }
}
