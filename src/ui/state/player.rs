//! The run at the play head: transport, time axis, and the moment that painters get in each frame.
//! Its state is not reactive, except for a few signals.

use std::ops::RangeInclusive;
use std::sync::Arc;

use leptos::prelude::*;

use super::edit_pace::{EditPace, SLOW};
use super::put::put;
use super::stepper::Stepper;
use super::work_spans::WorkSpans;
use crate::controls::Control;
use crate::interp::inspect::ChangeSubject;
use crate::machines::{Frame, PreparedMachine};
use crate::math;
use crate::motion::{Action, Event, Mode, RunEnd, Snapshot, Timeline};
use crate::project::debugger::stepping::Debugger;
use crate::project::run::{self, Run};
use crate::text::{Diagnostic, Message, Place};
use crate::ui::dom::{self, Frames};
use crate::view::Chart;
use crate::view::svg::{Theme, picture};

/// Machine seconds per second that can be chosen.
pub(crate) const SPEEDS: [f64; 10] = [0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0];

/// Machine seconds per second while the machine does not work, at automatic speed.
const WAITING: f64 = 2.0;

/// Machine seconds that are planned ahead of the play head, at least.
pub(super) const AHEAD: f64 = 1.0;

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
    /// Machine seconds per second at the play head.
    pub speed: f64,
    /// Whether this frame also writes figures that only change some times a second.
    pub slow: bool,
    /// Counts the changes of the plan.
    pub plans: u32,
}

/// Writes the moment into the page without signals, because there are 60 moments a second.
type Painter = Box<dyn FnMut(&RunMoment)>;

/// The run of the page. A handle: copies share its state.
#[derive(Clone, Copy)]
pub(crate) struct Player {
    pub(super) state: StoredValue<PlayerState, LocalStorage>,
    painters: StoredValue<Vec<Painter>, LocalStorage>,
    frames: StoredValue<Option<Frames>, LocalStorage>,
    /// Whether the play head moves by itself.
    pub playing: RwSignal<bool>,
    /// Machine seconds per second; 0 is automatic.
    pub speed: RwSignal<f64>,
    /// Whether the run restarts at its end.
    pub repeat: RwSignal<bool>,
    /// Whether the drawing's own option is on; see [`Scene::drawing_option`](crate::view::Scene::drawing_option).
    pub drawing_option: RwSignal<bool>,
    /// The machine at the play head, some times a second.
    pub now: RwSignal<Snapshot>,
    /// Operation on the work at the play head; updated some times a second.
    pub activity: RwSignal<Option<Message>>,
    /// The message of the program on the control's screen, at the play head.
    pub message: RwSignal<Option<String>>,
    /// The block that runs at the play head.
    pub running: RwSignal<Option<Place>>,
    /// The part of the run that is planned.
    pub planned: RwSignal<PlannedPart>,
    /// Reason why the run is over, once the plan has reached its end.
    pub ended: RwSignal<Option<RunEnd>, LocalStorage>,
    /// Seconds shown by film and charts; 0 is the whole plan.
    pub window: RwSignal<f64>,
    /// Part of the run that film and charts show in place of `window`, as chosen at a position of the play head.
    pub zoom: RwSignal<Option<Zoom>>,
    /// Counts the plans, for code that reads the planner directly.
    pub plans: RwSignal<u32>,
    /// The effect of the last action of the operator, as a sentence.
    pub changed: RwSignal<String>,
    /// The debugger.
    pub stepper: RwSignal<Stepper, LocalStorage>,
}

/// The part of a run that is planned.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(crate) struct PlannedPart {
    /// End of the plan (s).
    pub end: f64,
    /// Whether the run is over there.
    pub is_over: bool,
}

/// A chosen part of the time axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Zoom {
    /// Start and length (s) of the part.
    from: f64,
    span: f64,
    /// Position of the play head at the choice: when it moves, the part follows it.
    head: f64,
}

/// Least length (s) of a part of the time axis.
const LEAST: f64 = 0.005;

/// State of the run that is not in signals: planner, machine, play head, and times of the frames.
pub(super) struct PlayerState {
    pub(super) planner: Option<Run>,
    pub(super) id: &'static str,
    pub(super) machine: Option<Arc<PreparedMachine>>,
    /// Machine seconds per second at which the machine's motion is visible.
    pub(super) visible: f64,
    pub(super) head: f64,
    stamp: Option<f64>,
    /// Whether the play head waits for cycle start, where the run waits for the operator.
    waits: bool,
    pub(super) slow_at: f64,
    pub(super) slicing: bool,
    asked: bool,
    /// Length (s) of the plan before the operator changed the past, until it is planned again: the time axis keeps it.
    pub(super) expected: f64,
    /// Findings of the last plan.
    pub(super) findings: Vec<Diagnostic>,
    pub(super) pace: EditPace,
    work: WorkSpans,
}

impl Player {
    /// A player without a run.
    pub(crate) fn new() -> Player {
        let state = PlayerState {
            planner: None,
            id: "",
            machine: None,
            visible: 1.0,
            head: 0.0,
            stamp: None,
            waits: false,
            slow_at: 0.0,
            slicing: false,
            asked: false,
            expected: 0.0,
            findings: Vec::new(),
            pace: EditPace::default(),
            work: WorkSpans::default(),
        };
        let player = Player {
            state: StoredValue::new_local(state),
            painters: StoredValue::new_local(Vec::new()),
            frames: StoredValue::new_local(None),
            playing: RwSignal::new(false),
            speed: RwSignal::new(0.0),
            repeat: RwSignal::new(false),
            drawing_option: RwSignal::new(false),
            now: RwSignal::new(Snapshot::default()),
            activity: RwSignal::new(None),
            message: RwSignal::new(None),
            running: RwSignal::new(None),
            planned: RwSignal::new(PlannedPart::default()),
            ended: RwSignal::new_local(None),
            window: RwSignal::new(0.0),
            zoom: RwSignal::new(None),
            plans: RwSignal::new(0),
            changed: RwSignal::new(String::new()),
            stepper: RwSignal::new_local(Stepper::default()),
        };
        player.frames.set_value(Some(Frames::new(move |stamp| player.frame(stamp))));
        player
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

    /// Shows the run where it was before a reload.
    pub(crate) fn resume(self, head: f64, plays: bool) {
        self.set_head(head);
        self.settle();
        self.repeat.set(!dom::prefers("(prefers-reduced-motion: reduce)"));
        if plays {
            dom::soon(move || self.toggle());
        }
    }

    /// Plays or pauses. At the end of the run it restarts.
    pub(crate) fn toggle(self) {
        let playing = !self.playing.get_untracked();
        if playing && self.at_end() {
            self.seek(0.0);
        }
        self.play(playing);
    }

    fn play(self, playing: bool) {
        self.state.update_value(|state| (state.stamp, state.waits) = (None, false));
        self.playing.set(playing);
        self.ask();
    }

    /// Sets the play head, away from where the debugger may have stopped.
    pub(crate) fn seek(self, t: f64) {
        self.end_stepping();
        self.set_head(t);
    }

    /// Sets the play head.
    pub(crate) fn set_head(self, t: f64) {
        self.state.update_value(|state| {
            state.head = if t > 0.0 { t } else { 0.0 };
            (state.slow_at, state.waits) = (0.0, false);
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
        let planned = self.planned.get_untracked();
        planned.is_over && self.head() >= planned.end
    }

    /// Goes to the next start of a block within a place; after the last one, back to that.
    pub(crate) fn seek_block(self, place: Place) {
        let head = self.head();
        let to = self.ask_planner(|run| next_begin(&run.timeline().starts(place).collect::<Vec<_>>(), head)).flatten();
        if let Some(t) = to {
            self.playing.set(false);
            self.seek(t);
        }
    }

    /// Pauses at the start of the next block.
    pub(crate) fn pause_at_next_block(self) {
        self.pause_at(|timeline, head| timeline.next_block(head));
    }

    /// Pauses at the start of the previous block.
    pub(crate) fn pause_at_block_before(self) {
        self.pause_at(|timeline, head| Some(timeline.block_before(head)));
    }

    /// Pauses at a time of the planned run that follows from that of the play head.
    fn pause_at(self, to: impl FnOnce(&Timeline, f64) -> Option<f64>) {
        self.playing.set(false);
        let to = self.state.with_value(|state| to(state.planner.as_ref()?.timeline(), state.head));
        if let Some(t) = to {
            self.seek(t);
        }
    }

    /// Applies an action of the operator at the play head.
    pub(crate) fn act(self, action: Action) -> Event {
        let event = Event { t: self.head(), action };
        self.state.update_value(|state| {
            if let Some(planner) = &mut state.planner {
                planner.event(event.clone());
            }
        });
        let waited = self.state.with_value(|state| state.waits);
        self.replanned();
        self.settle();
        if waited && event.action == Action::Start {
            self.play(true);
        }
        event
    }

    /// A variable as the control's screen shows it now, and whether it has changed since the last stop of the debugger.
    pub(crate) fn variable(self, control: &Control, number: u32) -> (Option<f64>, bool) {
        self.plans.track();
        let t = self.now.with(|now| now.t);
        // At a stop the block to be read at this exact time has not been read.
        let stopped = self.stepper.with(|stepper| {
            let debugger = stepper.stopped()?;
            let changed = debugger.changes().iter().any(|change| change.subject == ChangeSubject::Variable(number));
            Some((run::shown(debugger.run(), control, number, f64::INFINITY), changed))
        });
        stopped
            .unwrap_or_else(|| (self.ask_planner(|planner| run::shown(planner, control, number, t)).flatten(), false))
    }

    /// The charts of a span of the plan, in seconds.
    pub(crate) fn charts(self, span: RangeInclusive<f64>, points: usize) -> Vec<Chart> {
        self.state.with_value(|state| match (&state.planner, &state.machine) {
            (Some(planner), Some(machine)) => machine.charts(planner, *span.start(), *span.end(), points),
            _ => Vec::new(),
        })
    }

    /// The charts of the whole plan, for a file.
    pub(crate) fn all_charts(self, points: usize) -> Vec<Chart> {
        self.charts(0.0..=self.planned.get_untracked().end, points)
    }

    /// The drawing at the play head, as a picture of its own.
    pub(crate) fn picture(self, theme: Theme) -> Option<String> {
        let frame = Frame { step: 0.0, drawing_option: self.drawing_option.get_untracked() };
        self.state.with_value(|state| {
            let (run, machine) = (state.planner.as_ref()?, state.machine.as_deref()?);
            let timeline = run.timeline();
            let pose = machine.pose(run, &timeline.at(state.head.min(timeline.end())), frame);
            Some(picture(&machine.scene(), &pose, theme))
        })
    }

    /// Ends of the time that film and charts show, with the play head at `head`.
    pub(crate) fn axis(self, head: f64, planned: f64) -> (f64, f64) {
        let window = self.window.get_untracked();
        if let Some(Zoom { from, span, head: chosen }) = self.zoom.get_untracked() {
            let pages = if head == chosen { 0.0 } else { ((head - from) / span).floor() };
            let begin = math::clamp(from + pages * span, 0.0, (planned - span).max(0.0));
            (begin, begin + span)
        } else if window > 0.0 {
            let begin = (head / window).floor() * window;
            (begin, begin + window)
        } else {
            (0.0, planned.max(0.001))
        }
    }

    /// Shows a part of the time axis, `factor` times as long, in which the time `about` stays at its place; the whole again where that is less.
    pub(crate) fn zoom_by(self, factor: f64, about: f64) {
        let (head, planned) = (self.now.with_untracked(|now| now.t), self.planned.get_untracked().end);
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
                let waits = self.ended.with_untracked(|end| matches!(end, Some(RunEnd::Stop | RunEnd::Alarm(_))));
                if !waits && self.repeat.get_untracked() && self.planned.get_untracked().end > 0.0 {
                    self.seek(0.0);
                } else {
                    // The operator's next actions take effect at this time, so the run does not begin anew by itself.
                    self.playing.set(false);
                    self.state.update_value(|state| state.waits = waits);
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

    /// Machine seconds per second at the play head. Automatic speed is slow enough to see the motion when the machine
    /// begins its work, and fast later and while the machine approaches, returns or waits.
    fn speed_now(self) -> f64 {
        let chosen = self.speed.get_untracked();
        if chosen > 0.0 {
            return chosen;
        }
        let waits = self.now.with_untracked(|now| now.mode != Mode::Running);
        self.state.with_value(|state| {
            let works = !waits && state.work.shows(state.head, state.visible);
            if works { state.visible } else { WAITING.max(state.visible) }
        })
    }

    /// Moves the play head by the time since the last frame; returns the seconds planned ahead of it.
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
        if head > self.planned.get_untracked().end {
            self.plan_in_frame();
        }
        let PlannedPart { end: planned, is_over } = self.planned.get_untracked();
        // At a breakpoint the play head may be ahead of the plan.
        let most = if self.playing.get_untracked() { planned.max(from) } else { head };
        self.state.update_value(|state| state.head = head.min(most));
        if is_over { f64::INFINITY } else { planned - head }
    }

    /// Writes the moment at the play head into the page. Charts and readouts follow some times a second, and pause while only the play head's
    /// time is planned.
    pub(super) fn show(self) {
        let time = dom::now();
        let planned = self.planned.get_untracked().end;
        let playing = self.playing.get_untracked();
        let speed = self.speed_now();
        // A paused drawing has no motion blur.
        let step = if playing { speed / 60.0 } else { 0.0 };
        let frame = Frame { step, drawing_option: self.drawing_option.get_untracked() };
        let plans = self.plans.get_untracked();
        let shown = self.state.try_update_value(|state| {
            let slow = !state.pace.is_due && (!playing || time - state.slow_at >= SLOW);
            if slow {
                state.slow_at = time;
            }
            let (run, machine) = (state.planner.as_ref()?, state.machine.as_deref()?);
            if slow {
                state.work.follow(plans, run, machine);
            }
            // The debugger may be at a time that is not planned yet.
            let now = self.stepper.with_untracked(|stepper| {
                let stop = stepper.stopped().filter(|debugger| debugger.t() > planned);
                let timeline = stop.map_or(run, Debugger::run).timeline();
                timeline.at(state.head.min(timeline.end()))
            });
            let axis = self.axis(now.t, planned.max(state.expected));
            let moment = RunMoment { run, machine, now: &now, axis, frame, speed, slow, plans };
            self.painters.update_value(|painters| painters.iter_mut().for_each(|paint| paint(&moment)));
            let message = run.timeline().message_at(now.t);
            if self.message.with_untracked(|shown| shown.as_deref() != message) {
                self.message.set(message.map(str::to_owned));
            }
            Some((slow.then(|| machine.activity(run, &now)), now))
        });
        let Some(Some((activity, now))) = shown else { return };
        let block = now.block;
        if let Some(activity) = activity {
            put(self.activity, activity);
            put(self.now, now);
        }
        put(self.running, block);
    }
}

/// The first of these rising times after the play head, else the last of all; none without times.
pub(crate) fn next_begin(times: &[f64], head: f64) -> Option<f64> {
    times.get(times.partition_point(|t| *t <= head)).or(times.last()).copied()
}
