//! The debugger of the page: a stepped run beside the shown one, in slices; the play head is set to its stops.

use std::fmt::Write;
use std::time::Duration;

use leptos::prelude::*;

use super::Page;
use super::player::Player;
use super::put::put;
use super::stepper::Stepper;
use crate::math;
use crate::project::debugger::breakpoints::Location;
use crate::project::debugger::stepping::{Debugger, Goal, Stop};
use crate::text::{Place, headed};
use crate::ui::dom::tab_entry::{remember, remembered};
use crate::ui::words::{Tone, end_words, sentence_with_hints, t};

/// Milliseconds of stepping in one slice.
const SLICE: f64 = 8.0;

/// Milliseconds of stepping within a frame.
const IN_FRAME: f64 = 3.0;

impl Player {
    /// Ends stepping; returns whether the debugger was in use.
    pub(crate) fn end_stepping(self) -> bool {
        let stood = self.stepper.update_untracked(|stepper| {
            stepper.debugger = None;
            core::mem::take(&mut stepper.at_stop) | core::mem::take(&mut stepper.going)
        });
        if stood {
            self.stepper.update(|_| {});
        }
        stood
    }

    /// Steps to a goal: from the block of the last stop, or from the play head.
    pub(super) fn step_to(self, goal: Goal) {
        self.playing.set(false);
        self.set_goal(self.head(), goal);
        self.continue_stepping();
    }

    fn set_goal(self, t: f64, goal: Goal) {
        self.stepper.update_untracked(|stepper| match &mut stepper.debugger {
            Some(debugger) if stepper.at_stop || stepper.going => debugger.go(goal),
            debugger => *debugger = self.ask_planner(|main| Debugger::new(main, t, goal)),
        });
    }

    /// Steps back by a block.
    fn step_back(self) {
        let back = self.stepper.update_untracked(|stepper| {
            let debugger = stepper.debugger.as_mut().filter(|_| stepper.at_stop)?;
            self.ask_planner(|main| debugger.back(main))
        });
        if back == Some(true) {
            self.continue_stepping();
        }
    }

    /// Stops the stepping under way and keeps its place; ends the debugger at a stop.
    fn stop_stepping(self) {
        if self.stepper.with_untracked(|stepper| stepper.going) {
            self.arrive(Stop::Reached);
        } else {
            self.end_stepping();
        }
    }

    fn continue_stepping(self) {
        if let Some(stop) = self.stepper.update_untracked(|stepper| stepper.advance(f64::INFINITY, SLICE)) {
            return self.arrive(stop);
        }
        self.stepper.update(|stepper| (stepper.going, stepper.at_stop) = (true, false));
        let on = move || {
            self.stepper.update_untracked(|stepper| stepper.slicing = false);
            if self.stepper.with_untracked(|stepper| stepper.going) {
                self.continue_stepping();
            }
        };
        if !self.stepper.update_untracked(|stepper| core::mem::replace(&mut stepper.slicing, true)) {
            set_timeout(on, Duration::ZERO);
        }
    }

    /// Sets the play head to the stop of the debugger.
    fn arrive(self, stop: Stop) {
        put(self.playing, false);
        self.stepper.update(|stepper| {
            (stepper.going, stepper.at_stop) = (false, true);
            let next = stepper.stopped().map_or_else(String::new, |debugger| {
                debugger.run().program().parsed().text(debugger.place().unwrap_or_default()).to_owned()
            });
            let is_reset = stepper.stopped().is_some_and(|debugger| debugger.run().is_reset());
            let words = |id: &'static str, what: String| headed(t(id), what);
            stepper.why = match stop {
                Stop::Reached => words("page.stepping-next", next),
                Stop::Breakpoint(_) => words("page.stepping-breakpoint", next),
                Stop::Condition(_, why) => words("page.stepping-breakpoint", sentence_with_hints(&why)),
                Stop::Ended(end) => end_words(&end, is_reset),
            };
        });
        self.set_head(self.stepper.with_untracked(Stepper::t));
    }

    /// Time up to which the play head may move while it plays: at most the next breakpoint.
    pub(crate) fn play_to(self, from: f64, to: f64) -> f64 {
        let (idle, going) = self.stepper.with_untracked(|stepper| (stepper.points.list().is_empty(), stepper.going));
        if idle || going {
            self.end_stepping();
        }
        if idle {
            return to;
        }
        if self.stepper.with_untracked(|stepper| stepper.at_stop || stepper.debugger.is_none()) {
            self.set_goal(from, Goal::Continue);
            self.stepper.update(|stepper| stepper.at_stop = false);
        }
        match self.stepper.update_untracked(|stepper| stepper.advance(to, IN_FRAME)) {
            None => math::clamp(self.stepper.with_untracked(Stepper::t), from, to),
            Some(Stop::Ended(_)) => to,
            Some(stop) => {
                self.arrive(stop);
                self.head()
            }
        }
    }
}

/// Key in the browser's store of breakpoints and watches.
const KEPT: &str = "macroline.stepping";
/// The key under which former versions of the page kept them.
const FORMER: &str = "macroline.walk";

/// A command of the debugger.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum SteppingCommand {
    Into,
    Over,
    Out,
    Back,
    ToCursor,
    Continue,
    Stop,
    Breakpoint,
}

impl SteppingCommand {
    /// In the order of their buttons.
    pub(crate) const ALL: [SteppingCommand; 8] = [
        SteppingCommand::Into,
        SteppingCommand::Over,
        SteppingCommand::Out,
        SteppingCommand::Back,
        SteppingCommand::ToCursor,
        SteppingCommand::Continue,
        SteppingCommand::Stop,
        SteppingCommand::Breakpoint,
    ];

    /// Key, sign, and catalog id of the words.
    pub(crate) const fn shown(self) -> (&'static str, &'static str, &'static str) {
        match self {
            SteppingCommand::Into => ("i", "↓", "page.stepping-into"),
            SteppingCommand::Over => ("o", "↷", "page.stepping-over"),
            SteppingCommand::Out => ("u", "↑", "page.stepping-out"),
            SteppingCommand::Back => ("r", "←", "page.stepping-back"),
            SteppingCommand::ToCursor => ("t", "⇥", "page.stepping-to"),
            SteppingCommand::Continue => ("c", "▶", "page.stepping-go"),
            SteppingCommand::Stop => ("x", "■", "page.stepping-stop"),
            SteppingCommand::Breakpoint => ("b", "●", "page.stepping-point"),
        }
    }

    /// The command of a key.
    pub(crate) fn of_key(key: &str) -> Option<SteppingCommand> {
        SteppingCommand::ALL.into_iter().find(|command| command.shown().0 == key)
    }

    /// Carries it out.
    pub(crate) fn run(self, page: Page) {
        let player = page.player;
        match self {
            SteppingCommand::Into => player.step_to(Goal::Into),
            SteppingCommand::Over => player.step_to(Goal::Over),
            SteppingCommand::Out => player.step_to(Goal::Out),
            SteppingCommand::Continue => player.step_to(Goal::Continue),
            SteppingCommand::ToCursor => {
                if let Some((_, place)) = cursor(page) {
                    player.step_to(Goal::To(place));
                }
            }
            SteppingCommand::Back => player.step_back(),
            SteppingCommand::Stop => player.stop_stepping(),
            SteppingCommand::Breakpoint => {
                set_point(page, None);
            }
        }
    }
}

/// The block at the cursor; follows the cursor.
pub(crate) fn at_cursor(page: Page) -> Option<(Location, Place)> {
    let (file, line) = page.player.stepper.with(|stepper| stepper.cursor)?;
    let spot = Location::Line { file, line };
    let place = page.program.written.with(|written| spot.place(&written.parsed))?;
    Some((spot, place))
}

/// The block at the cursor; without one the user is asked for it.
fn cursor(page: Page) -> Option<(Location, Place)> {
    let found = untrack(|| at_cursor(page));
    if found.is_none() {
        page.notices.confirm(t("page.stepping-cursor").to_owned());
    }
    found
}

/// Shows the machine when the block at the cursor runs next.
pub(crate) fn show_block(page: Page) {
    if let Some((_, place)) = untrack(|| at_cursor(page)) {
        page.player.seek_block(place);
    }
}

/// Sets a breakpoint at the cursor or removes it; with a condition, sets the condition. Returns whether that succeeded.
pub(crate) fn set_point(page: Page, condition: Option<&str>) -> bool {
    let Some((spot, place)) = cursor(page) else { return false };
    let parsed = page.program.written.with_untracked(|written| written.parsed.clone());
    let mut done = Ok(());
    page.player.stepper.update(|stepper| done = stepper.points.turn(spot, place, condition, &parsed));
    if let Err(why) = &done {
        page.notices.notify(Tone::Warn, sentence_with_hints(why));
    }
    done.is_ok()
}

/// Keeps breakpoints and watches in this browser, a line each.
pub(crate) fn keep(page: Page) {
    let mut out = String::new();
    page.player.stepper.with_untracked(|stepper| {
        for watch in &stepper.watches {
            let _ = writeln!(out, "{watch}");
        }
        for point in stepper.points.list() {
            let _ = writeln!(out, "{}\t{}", point.name(), point.condition);
        }
    });
    remember(KEPT, &out);
}

/// Takes the kept breakpoints and watches, as far as the program has their lines.
pub(crate) fn restore(page: Page) {
    let Some(text) = remembered(KEPT).or_else(|| remembered(FORMER)) else { return };
    let parsed = page.program.written.with_untracked(|written| written.parsed.clone());
    page.player.stepper.update_untracked(|stepper| {
        for line in text.lines() {
            match line.split_once('\t') {
                None => stepper.watches.push(line.to_owned()),
                Some((name, condition)) => {
                    if let Some(spot) = Location::read_line(name, &parsed) {
                        let _ = stepper.points.add(spot, condition, &parsed);
                    }
                }
            }
        }
    });
}
