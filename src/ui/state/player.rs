//! The run: a planner ahead of the play head, and the play head itself. Not reactive, except for the few signals at its edge.

use std::sync::Arc;
use std::time::Duration;

use leptos::prelude::*;

use super::put::put;
use super::walk::Walk;
use crate::controls::Control;
use crate::interp::inspect::What;
use crate::machines::{Frame, PreparedMachine};
use crate::math;
use crate::motion::{Action, Budget, Event, Mode, Retention, RunEnd, Snapshot};
use crate::project::Project;
use crate::project::debug::{Debugger, Goal};
use crate::project::program::Written;
use crate::project::run::{self, Run, RunOptions};
use crate::text::{Diagnostic, Place};
use crate::ui::dom::{self, Frames};
use crate::view::Chart;
use crate::view::svg::{Theme, picture};

/// Machine seconds per second that can be chosen.
pub(crate) const SPEEDS: [f64; 10] = [0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0];

/// Machine seconds per second while the machine only waits, at automatic speed.
const WAITING: f64 = 2.0;

/// Milliseconds of planning in one slice.
const SLICE: f64 = 6.0;

/// Milliseconds of planning within a frame, when the play head has caught up with the plan.
const IN_FRAME: f64 = 2.0;

/// Machine seconds that are planned ahead of the play head, at least.
const AHEAD: f64 = 1.0;

/// Machine seconds that are always planned in the background.
const HORIZON: f64 = 60.0;

/// Longest run that is planned: ten hours, which fit the memory.
const LIMITS: Budget = Budget { blocks: 1_000_000_000, seconds: 36_000.0 };

/// Steps of the planner between two looks at the clock.
const STEPS: usize = 64;

/// Milliseconds between two values of the slow signals, and between two whole plans while a field is dragged.
const SLOW: f64 = 100.0;

/// Edits that come in a row count as dragging: how many, and milliseconds between two of them at most.
const DRAGGING: (u32, f64) = (3, 60.0);

/// The run at the play head, as painters get it in each frame.
pub(crate) struct RunMoment<'a> {
    /// The planned run.
    pub run: &'a Run,
    /// The machine.
    pub machine: &'a PreparedMachine,
    /// The machine at the play head.
    pub now: &'a Snapshot,
    /// Ends of the shown time, in seconds.
    pub axis: (f64, f64),
    /// Viewing conditions of the frame.
    pub frame: Frame,
    /// Whether this frame also writes figures that only change some times a second.
    pub slow: bool,
    /// Counts the changes of the plan.
    pub plans: u32,
}

/// Writes the moment into the page, past the signals: there are 60 a second.
type Painter = Box<dyn FnMut(&RunMoment)>;

/// The run of the page. A handle: copies share its state.
#[derive(Clone, Copy)]
pub(crate) struct Player {
    state: StoredValue<State, LocalStorage>,
    painters: StoredValue<Vec<Painter>, LocalStorage>,
    frames: StoredValue<Option<Frames>, LocalStorage>,
    /// Whether the play head moves by itself.
    pub playing: RwSignal<bool>,
    /// Machine seconds per second; 0 is automatic.
    pub speed: RwSignal<f64>,
    /// Whether the run restarts at its end.
    pub repeat: RwSignal<bool>,
    /// Whether rollers are shown once per head.
    pub option: RwSignal<bool>,
    /// The machine at the play head, some times a second.
    pub now: RwSignal<Snapshot>,
    /// The message of the program on the control's screen, at the play head.
    pub message: RwSignal<Option<String>>,
    /// The block that runs at the play head.
    pub running: RwSignal<Option<Place>>,
    /// Seconds that are planned, and whether the run is over there.
    pub planned: RwSignal<(f64, bool)>,
    /// Why the run is over, where the plan has reached its end.
    pub ended: RwSignal<Option<RunEnd>, LocalStorage>,
    /// Seconds shown by film and charts; 0 is the whole plan.
    pub window: RwSignal<f64>,
    /// Part of the run that film and charts show in place of `window`, as chosen at a position of the play head.
    pub zoom: RwSignal<Option<Zoom>>,
    /// Counts the plans, for what asks the planner itself.
    pub plans: RwSignal<u32>,
    /// The effect of the last action of the operator, as a sentence.
    pub changed: RwSignal<String>,
    /// The debugger.
    pub walk: RwSignal<Walk, LocalStorage>,
}

/// A chosen part of the time axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Zoom {
    /// Its begin and length, in seconds.
    from: f64,
    span: f64,
    /// Position of the play head at the choice: when it moves, the part follows it.
    head: f64,
}

/// Least length (s) of a part of the time axis.
const LEAST: f64 = 0.005;

struct State {
    planner: Option<Run>,
    id: &'static str,
    machine: Option<Arc<PreparedMachine>>,
    /// Machine seconds per second at which the machine's motion is visible.
    visible: f64,
    head: f64,
    stamp: Option<f64>,
    slow_at: f64,
    slicing: bool,
    asked: bool,
    /// Length (s) of the plan before the operator changed the past, until it is planned again: the time axis keeps it.
    expected: f64,
    /// Findings of the last plan.
    findings: Vec<Diagnostic>,
    pace: Pace,
}

/// Pace of edits. While a field is dragged, each step plans only up to the play head, and the whole run some times a second.
#[derive(Default)]
struct Pace {
    /// When the last edit was shown.
    edited: f64,
    /// Edits that followed quickly on one another.
    in_a_row: u32,
    /// When the run was last planned as a whole.
    planned: f64,
    /// Whether the whole run has to be planned.
    is_due: bool,
}

impl Pace {
    /// Records an edit at a time (ms); returns whether to show it without planning the whole run.
    fn hurries(&mut self, now: f64) -> bool {
        let (enough, apart) = DRAGGING;
        self.in_a_row = if now - self.edited < apart { self.in_a_row + 1 } else { 0 };
        self.edited = now;
        self.in_a_row >= enough && now - self.planned < SLOW
    }
}

/// Begins the run of a project; nothing of it is planned yet.
pub(crate) fn begin(project: &Project, written: &Written) -> Run {
    let begin = RunOptions { start: None, settings: &[], limits: LIMITS, keep: Retention::Timeline };
    run::of_project(project, written, &begin)
}

impl Player {
    /// A player without a run.
    pub(crate) fn new() -> Player {
        let state = State {
            planner: None,
            id: "",
            machine: None,
            visible: 1.0,
            head: 0.0,
            stamp: None,
            slow_at: 0.0,
            slicing: false,
            asked: false,
            expected: 0.0,
            findings: Vec::new(),
            pace: Pace::default(),
        };
        let player = Player {
            state: StoredValue::new_local(state),
            painters: StoredValue::new_local(Vec::new()),
            frames: StoredValue::new_local(None),
            playing: RwSignal::new(false),
            speed: RwSignal::new(0.0),
            repeat: RwSignal::new(false),
            option: RwSignal::new(false),
            now: RwSignal::new(Snapshot::default()),
            message: RwSignal::new(None),
            running: RwSignal::new(None),
            planned: RwSignal::new((0.0, false)),
            ended: RwSignal::new_local(None),
            window: RwSignal::new(0.0),
            zoom: RwSignal::new(None),
            plans: RwSignal::new(0),
            changed: RwSignal::new(String::new()),
            walk: RwSignal::new_local(Walk::default()),
        };
        player.frames.set_value(Some(Frames::new(move |stamp| player.frame(stamp))));
        player
    }

    /// Begins another run; the play head stays at its time.
    pub(crate) fn load(self, project: &Project, written: &Written) {
        self.take(begin(project, written), project, written);
    }

    /// Takes a run that has begun; the play head stays at its time.
    pub(crate) fn take(self, run: Run, project: &Project, written: &Written) {
        let id = project.machine.id();
        if self.state.with_value(|state| state.id != id) {
            self.speed.set(0.0);
            self.zoom.set(None);
        }
        self.state.update_value(|state| {
            state.planner = Some(run);
            state.id = id;
            state.machine = Some(project.prepared());
            state.visible = project.machine.speed();
            state.expected = 0.0;
        });
        self.walk_away();
        self.walk.update(|walk| walk.points.resolve(&written.parsed));
    }

    /// Shows the changed run after the effects of the change.
    pub(crate) fn settle(self) {
        dom::soon(move || {
            // The page may be gone.
            if self.state.is_disposed() {
                return;
            }
            let now = dom::now();
            let more = if self.state.try_update_value(|state| state.pace.hurries(now)) == Some(true) {
                self.plan_head();
                false
            } else {
                self.plan_whole(now)
            };
            dom::mark("rendered");
            dom::measure("edit", "input", "rendered");
            if more {
                self.plan_on();
            }
        });
    }

    /// Plans the run up to the end of the shown part, and shows it, at a time in ms; returns whether there is more to plan.
    fn plan_whole(self, now: f64) -> bool {
        self.state.update_value(|state| (state.pace.planned, state.pace.is_due) = (now, false));
        let more = self.plan_far();
        self.show();
        more
    }

    /// Shows the run at the play head, and soon as a whole. Until then charts, time axis and findings are those of the last whole plan.
    fn plan_head(self) {
        self.advance_plan(self.head() + AHEAD, SLICE);
        let was_due = self.state.try_update_value(|state| core::mem::replace(&mut state.pace.is_due, true));
        self.show();
        if was_due == Some(false) {
            let whole = move || {
                // The page may be gone, or the run planned meanwhile.
                if self.state.try_with_value(|state| state.pace.is_due) == Some(true) && self.plan_whole(dom::now()) {
                    self.plan_on();
                }
            };
            set_timeout(whole, Duration::from_millis(SLOW as u64));
        }
    }

    /// Adds a painter: it gets every frame from now on.
    pub(crate) fn paint(self, painter: impl FnMut(&RunMoment) + 'static) {
        self.painters.update_value(|painters| painters.push(Box::new(painter)));
        self.ask();
    }

    /// Shows the run and starts it at once, repeating, unless the user prefers reduced motion.
    pub(crate) fn begin(self) {
        self.settle();
        if !dom::prefers("(prefers-reduced-motion: reduce)") {
            self.repeat.set(true);
            dom::soon(move || self.toggle());
        }
    }

    /// Plays or pauses. At the end of the run it restarts.
    pub(crate) fn toggle(self) {
        let playing = !self.playing.get_untracked();
        if playing && self.at_end() {
            self.seek(0.0);
        }
        self.state.update_value(|state| state.stamp = None);
        self.playing.set(playing);
        self.ask();
    }

    /// Sets the play head, away from where the debugger may have stopped.
    pub(crate) fn seek(self, t: f64) {
        self.walk_away();
        self.set_head(t);
    }

    /// Sets the play head.
    pub(crate) fn set_head(self, t: f64) {
        self.state.update_value(|state| {
            state.head = if t > 0.0 { t } else { 0.0 };
            state.slow_at = 0.0;
        });
        self.ask();
        self.plan_on();
    }

    /// Seconds of the play head.
    pub(crate) fn head(self) -> f64 {
        self.state.with_value(|state| state.head)
    }

    /// Whether the play head is at the end of a finished run.
    pub(crate) fn at_end(self) -> bool {
        let (planned, ended) = self.planned.get_untracked();
        ended && self.head() >= planned
    }

    /// Goes to the next time at which a block within a place begins; from the end of the run to the first one.
    pub(crate) fn seek_block(self, place: Place) {
        let head = self.head();
        let to = self.ask_planner(|run| next_begin(&run.timeline().begins(place).collect::<Vec<_>>(), head)).flatten();
        if let Some(t) = to {
            self.playing.set(false);
            self.seek(t);
        }
    }

    /// Pauses at the begin of the next or previous block.
    pub(crate) fn step(self, forth: bool) {
        self.playing.set(false);
        let to = self.state.with_value(|state| {
            let timeline = state.planner.as_ref()?.timeline();
            if forth { timeline.next_block(state.head) } else { Some(timeline.block_before(state.head)) }
        });
        if let Some(t) = to {
            self.seek(t);
        }
    }

    /// Does an action of the operator at the play head.
    pub(crate) fn act(self, action: Action) -> Event {
        let event = Event { t: self.head(), action };
        self.state.update_value(|state| {
            if let Some(planner) = &mut state.planner {
                planner.event(event.clone());
            }
        });
        self.replanned();
        self.settle();
        event
    }

    /// Replans from the earliest changed action of the operator, for the same project.
    pub(crate) fn replan(self, project: &Project, written: &Written) {
        let done = self.state.try_update_value(|state| Some(run::replan(state.planner.as_mut()?, project)));
        if done.flatten() == Some(true) {
            self.replanned();
        } else {
            self.load(project, written);
        }
    }

    /// After a change of the run: walks again to the block before which the debugger waited.
    fn replanned(self) {
        let planned = self.planned.get_untracked().0;
        self.state.update_value(|state| state.expected = planned.max(state.expected));
        self.plans.update(|count| *count += 1);
        if self.walk_away() {
            self.walk_to(Goal::Block(0));
        }
    }

    /// A variable as the control's screen shows it now, and whether it has changed since the last stop of the debugger.
    pub(crate) fn variable(self, control: &Control, number: u32) -> (Option<f64>, bool) {
        self.plans.track();
        let t = self.now.with(|now| now.t);
        // At a stop the block that is read at this very time is not read yet.
        let stopped = self.walk.with(|walk| {
            let debugger = walk.stopped()?;
            let changed = debugger.changes().iter().any(|change| change.what == What::Variable(number));
            Some((run::shown(debugger.run(), control, number, f64::INFINITY), changed))
        });
        stopped
            .unwrap_or_else(|| (self.ask_planner(|planner| run::shown(planner, control, number, t)).flatten(), false))
    }

    /// Asks the planner something.
    pub(crate) fn ask_planner<T>(self, question: impl FnOnce(&Run) -> T) -> Option<T> {
        self.state.with_value(|state| state.planner.as_ref().map(question))
    }

    /// Findings of the planned part of the run.
    pub(crate) fn findings(self) -> Vec<Diagnostic> {
        self.plans.track();
        self.state.with_value(|state| state.findings.clone())
    }

    /// The charts of the whole plan, for a file.
    pub(crate) fn all_charts(self, points: usize) -> Vec<Chart> {
        let end = self.planned.get_untracked().0;
        self.state.with_value(|state| match (&state.planner, &state.machine) {
            (Some(planner), Some(machine)) => machine.charts(planner, 0.0, end, points),
            _ => Vec::new(),
        })
    }

    /// The drawing at the play head, as a picture of its own.
    pub(crate) fn picture(self, theme: Theme) -> Option<String> {
        let frame = Frame { step: 0.0, option: self.option.get_untracked() };
        self.state.with_value(|state| {
            let (run, machine) = (state.planner.as_ref()?, state.machine.as_deref()?);
            let timeline = run.timeline();
            let pose = machine.pose(run, &timeline.at(state.head.min(timeline.end())), frame);
            Some(picture(&machine.scene(), &pose, theme))
        })
    }

    /// Plans now, up to a time, for no longer than a slice.
    pub(crate) fn plan_to(self, t: f64) {
        self.plan(t, SLICE);
    }

    /// Ends of the time that film and charts show, with the play head at `head`.
    pub(crate) fn axis(self, head: f64, planned: f64) -> (f64, f64) {
        let window = self.window.get_untracked();
        if let Some(Zoom { from, span, head: chosen }) = self.zoom.get_untracked() {
            let pages = if head == chosen { 0.0 } else { ((head - from) / span).floor() };
            (from + pages * span, from + (pages + 1.0) * span)
        } else if window > 0.0 {
            let begin = (head / window).floor() * window;
            (begin, begin + window)
        } else {
            (0.0, planned.max(0.001))
        }
    }

    /// Shows a part of the time axis, `factor` times as long, in which the time `about` stays at its place; the whole again where that is less.
    pub(crate) fn zoom_by(self, factor: f64, about: f64) {
        let (head, planned) = (self.now.with_untracked(|now| now.t), self.planned.get_untracked().0);
        let (from, to) = self.axis(head, planned);
        let span = ((to - from) * factor).max(LEAST);
        let zoom = (span < planned).then(|| {
            let begin = about - (about - from) * span / (to - from);
            Zoom { from: math::clamp(begin, 0.0, planned - span), span, head }
        });
        self.window.set(0.0);
        self.zoom.set(zoom);
        self.ask();
    }

    /// Shows a window of `seconds` around the play head; 0 shows all that is planned.
    pub(crate) fn show_window(self, seconds: f64) {
        self.zoom.set(None);
        self.window.set(seconds);
        self.ask();
    }

    /// Plans up to a time, but only for some milliseconds; says whether there is more to plan.
    fn plan(self, until: f64, budget: f64) -> bool {
        let advanced = self.advance_plan(until, budget);
        self.state.update_value(|state| {
            state.findings = state.planner.as_ref().map(|planner| planner.diagnostics().to_vec()).unwrap_or_default();
        });
        let Some((planned, ended, more)) = advanced else { return false };
        let over = ended.is_some();
        self.state.update_value(|state| {
            if over || planned >= state.expected {
                state.expected = 0.0;
            }
        });
        put(self.ended, ended);
        if self.planned.get_untracked() != (planned, over) {
            self.planned.set((planned, over));
            self.plans.update(|count| *count += 1);
        }
        more
    }

    /// Plans without informing the page: planned time (s), why the run ended there, and whether there is more to plan.
    fn advance_plan(self, until: f64, budget: f64) -> Option<(f64, Option<RunEnd>, bool)> {
        let begun = dom::now();
        let progress = self.state.try_update_value(|state| {
            let planner = state.planner.as_mut()?;
            loop {
                let progress = planner.advance(until, STEPS);
                let done = progress.ended.is_some() || progress.planned_to >= until;
                if done || dom::now() - begun > budget {
                    return Some((progress.planned_to, progress.ended, !done));
                }
            }
        });
        progress.flatten()
    }

    /// Plans in slices between the frames, until the plan reaches its goal.
    fn plan_on(self) {
        let slicing = self.state.try_update_value(|state| core::mem::replace(&mut state.slicing, true));
        if slicing != Some(false) {
            return;
        }
        let slice = move || {
            // The page may be gone.
            if self.state.try_update_value(|state| state.slicing = false).is_none() {
                return;
            }
            let more = self.plan_far();
            // Charts of the whole plan cost more than a slice of planning.
            let due = self.state.with_value(|state| dom::now() - state.slow_at >= SLOW);
            if due || !more {
                self.ask();
            }
            if more {
                self.plan_on();
            }
        };
        set_timeout(slice, Duration::ZERO);
    }

    /// Time (s) up to which the plan is needed now: the end of the charts, and a little ahead of the play head.
    fn soon(self) -> f64 {
        let head = self.head();
        self.axis(head, 0.0).1.max(head + AHEAD)
    }

    /// Plans a slice in the background; returns whether there is more to plan.
    fn plan_far(self) -> bool {
        let more = self.plan(self.soon().max(HORIZON), SLICE);
        if !more {
            self.state.update_value(|state| state.expected = 0.0);
        }
        more
    }

    /// Asks for a frame.
    pub(crate) fn ask(self) {
        if self.state.try_update_value(|state| core::mem::replace(&mut state.asked, true)) == Some(false) {
            self.frames.with_value(|frames| {
                if let Some(frames) = frames {
                    frames.ask();
                }
            });
        }
    }

    fn frame(self, stamp: f64) {
        if self.state.try_update_value(|state| state.asked = false).is_none() {
            return;
        }
        dom::mark("frame-begins");
        if self.playing.get_untracked() {
            let ahead = self.advance(stamp);
            if ahead < AHEAD / 2.0 {
                self.plan_on();
            }
            if self.at_end() {
                if self.repeat.get_untracked() && self.planned.get_untracked().0 > 0.0 {
                    self.seek(0.0);
                } else {
                    self.playing.set(false);
                }
            }
        }
        self.show();
        dom::mark("frame-ends");
        dom::measure("frame", "frame-begins", "frame-ends");
        if self.playing.get_untracked() {
            self.ask();
        }
    }

    /// Machine seconds per second at the play head. Automatic: as slow as the motion is visible, and fast while the machine only waits.
    fn speed_now(self) -> f64 {
        let chosen = self.speed.get_untracked();
        if chosen > 0.0 {
            return chosen;
        }
        let waits = self.now.with_untracked(|now| now.mode != Mode::Running);
        self.state.with_value(|state| if waits { WAITING.max(state.visible) } else { state.visible })
    }

    /// Moves the play head by the time since the last frame; says how many seconds are planned ahead of it.
    fn advance(self, stamp: f64) -> f64 {
        let speed = self.speed_now();
        let from = self.head();
        let passed = self.state.try_update_value(|state| {
            // A hidden tab does not jump ahead.
            let passed = state.stamp.map_or(0.0, |last| math::clamp(stamp - last, 0.0, 100.0));
            state.stamp = Some(stamp);
            passed
        });
        let head = self.play_to(from, from + passed.unwrap_or_default() / 1000.0 * speed);
        if head > self.planned.get_untracked().0 {
            self.plan(self.soon(), IN_FRAME);
        }
        let (planned, ended) = self.planned.get_untracked();
        // At a breakpoint the play head may be ahead of the plan.
        let most = if self.playing.get_untracked() { planned.max(from) } else { head };
        self.state.update_value(|state| state.head = head.min(most));
        if ended { f64::INFINITY } else { planned - head }
    }

    /// Writes the moment at the play head into the page. Charts and readouts follow some times a second, and pause while only the play head's
    /// time is planned.
    fn show(self) {
        let time = dom::now();
        let (planned, _) = self.planned.get_untracked();
        let playing = self.playing.get_untracked();
        let frame = Frame { step: self.speed_now() / 60.0, option: self.option.get_untracked() };
        let plans = self.plans.get_untracked();
        let shown = self.state.try_update_value(|state| {
            let slow = !state.pace.is_due && (!playing || time - state.slow_at >= SLOW);
            if slow {
                state.slow_at = time;
            }
            let (run, machine) = (state.planner.as_ref()?, state.machine.as_deref()?);
            // The debugger may be at a time that is not planned yet.
            let now = self.walk.with_untracked(|walk| {
                let stop = walk.stopped().filter(|debugger| debugger.t() > planned);
                let timeline = stop.map_or(run, Debugger::run).timeline();
                timeline.at(state.head.min(timeline.end()))
            });
            let axis = self.axis(now.t, planned.max(state.expected));
            let moment = RunMoment { run, machine, now: &now, axis, frame, slow, plans };
            self.painters.update_value(|painters| painters.iter_mut().for_each(|paint| paint(&moment)));
            let message = run.timeline().message_at(now.t);
            if self.message.with_untracked(|shown| shown.as_deref() != message) {
                self.message.set(message.map(str::to_owned));
            }
            Some((now, slow))
        });
        let Some(Some((now, slow))) = shown else { return };
        let block = now.block;
        if slow {
            put(self.now, now);
        }
        put(self.running, block);
    }
}

/// The first of these rising times after the play head, else the first of all; none without times.
pub(crate) fn next_begin(times: &[f64], head: f64) -> Option<f64> {
    times.get(times.partition_point(|t| *t <= head)).or(times.first()).copied()
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;

    #[wasm_bindgen_test]
    fn only_edits_in_a_row_hurry_and_never_for_long() {
        let mut pace = Pace::default();
        let hurries = |pace: &mut Pace, times: &[f64]| -> Vec<bool> {
            let take = |time: &f64| {
                let hurries = pace.hurries(*time);
                if !hurries {
                    pace.planned = *time;
                }
                hurries
            };
            times.iter().map(take).collect()
        };
        // Typed figures, each a while after the other.
        assert_eq!(hurries(&mut pace, &[1000.0, 1100.0, 1200.0, 1300.0, 1400.0]), [false; 5]);
        // A slider: a step each 16 ms, planned whole once 100 ms have gone by.
        let steps: Vec<f64> = (0..14).map(|step| 2000.0 + 16.0 * f64::from(step)).collect();
        let hurried = hurries(&mut pace, &steps);
        assert_eq!(hurried[..3], [false; 3]);
        let whole = hurried[3..].iter().filter(|hurries| !**hurries).count();
        assert_eq!(whole, 1, "{hurried:?}");
    }
}
