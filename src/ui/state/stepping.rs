//! The debugger of the page: a stepped run beside the shown one, in slices; the play head is set to its stops.

use std::fmt::Write;
use std::time::Duration;

use leptos::prelude::*;

use super::Page;
use super::player::Player;
use super::put::put;
use super::walk::Walk;
use crate::math;
use crate::project::breakpoints::Location;
use crate::project::debug::{Debugger, Goal, Stop};
use crate::text::{Place, headed};
use crate::ui::dom::tab_entry::{remember, remembered};
use crate::ui::words::{Tone, end_words, sentence_with_hints, t};

/// Milliseconds of stepping in one slice.
const SLICE: f64 = 8.0;

/// Milliseconds of stepping within a frame.
const IN_FRAME: f64 = 3.0;

impl Player {
    /// Ends stepping; returns whether the debugger was in use.
    pub(crate) fn walk_away(self) -> bool {
        let stood = self.walk.update_untracked(|walk| {
            walk.debugger = None;
            core::mem::take(&mut walk.at_stop) | core::mem::take(&mut walk.going)
        });
        if stood {
            self.walk.update(|_| {});
        }
        stood
    }

    /// Steps to a goal: from the block of the last stop, or from the play head.
    pub(crate) fn walk_to(self, goal: Goal) {
        self.playing.set(false);
        self.set_goal(self.head(), goal);
        self.walk_on();
    }

    fn set_goal(self, t: f64, goal: Goal) {
        self.walk.update_untracked(|walk| match &mut walk.debugger {
            Some(debugger) if walk.at_stop || walk.going => debugger.go(goal),
            debugger => *debugger = self.ask_planner(|main| Debugger::new(main, t, goal)),
        });
    }

    /// Steps back by a block. Always returns true, like the other commands of a key.
    pub(crate) fn walk_back(self) -> bool {
        let back = self.walk.update_untracked(|walk| {
            let debugger = walk.debugger.as_mut().filter(|_| walk.at_stop)?;
            self.ask_planner(|main| debugger.back(main))
        });
        if back == Some(true) {
            self.walk_on();
        }
        true
    }

    /// Stops the stepping under way and keeps its place.
    pub(crate) fn walk_stop(self) -> bool {
        if self.walk.with_untracked(|walk| walk.going) {
            self.arrive(Stop::Reached);
        } else {
            self.walk_away();
        }
        true
    }

    fn walk_on(self) {
        if let Some(stop) = self.walk.update_untracked(|walk| walk.advance(f64::INFINITY, SLICE)) {
            return self.arrive(stop);
        }
        self.walk.update(|walk| (walk.going, walk.at_stop) = (true, false));
        let on = move || {
            self.walk.update_untracked(|walk| walk.slicing = false);
            if self.walk.with_untracked(|walk| walk.going) {
                self.walk_on();
            }
        };
        if !self.walk.update_untracked(|walk| core::mem::replace(&mut walk.slicing, true)) {
            set_timeout(on, Duration::ZERO);
        }
    }

    /// Sets the play head to the stop of the debugger.
    fn arrive(self, stop: Stop) {
        put(self.playing, false);
        self.walk.update(|walk| {
            (walk.going, walk.at_stop) = (false, true);
            let next = walk.stopped().map_or_else(String::new, |debugger| {
                debugger.run().program().parsed().text(debugger.place().unwrap_or_default()).to_owned()
            });
            let words = |id: &'static str, what: String| headed(t(id), what);
            walk.why = match stop {
                Stop::Reached => words("page.walk-next", next),
                Stop::Breakpoint(_) => words("page.walk-breakpoint", next),
                Stop::Condition(_, why) => words("page.walk-breakpoint", sentence_with_hints(&why)),
                Stop::Ended(end) => end_words(&end),
            };
        });
        self.set_head(self.walk.with_untracked(Walk::t));
    }

    /// Time up to which the play head may move while it plays: at most the next breakpoint.
    pub(crate) fn play_to(self, from: f64, to: f64) -> f64 {
        let (idle, going) = self.walk.with_untracked(|walk| (walk.points.list().is_empty(), walk.going));
        if idle || going {
            self.walk_away();
        }
        if idle {
            return to;
        }
        if self.walk.with_untracked(|walk| walk.at_stop || walk.debugger.is_none()) {
            self.set_goal(from, Goal::Continue);
            self.walk.update(|walk| walk.at_stop = false);
        }
        match self.walk.update_untracked(|walk| walk.advance(to, IN_FRAME)) {
            None => math::clamp(self.walk.with_untracked(Walk::t), from, to),
            Some(Stop::Ended(_)) => to,
            Some(stop) => {
                self.arrive(stop);
                self.head()
            }
        }
    }
}

/// Key in the browser's store of breakpoints and watches.
const KEPT: &str = "macroline.walk";

/// Key, sign and words of each command.
pub(crate) const COMMANDS: [(&str, &str, &str); 8] = [
    ("i", "↓", "page.walk-into"),
    ("o", "↷", "page.walk-over"),
    ("u", "↑", "page.walk-out"),
    ("r", "←", "page.walk-back"),
    ("t", "⇥", "page.walk-to"),
    ("c", "▶", "page.walk-go"),
    ("x", "■", "page.walk-stop"),
    ("b", "●", "page.walk-point"),
];

/// Carries out the command of a key; returns whether the key has one.
pub(crate) fn press(page: Page, key: &str) -> bool {
    let player = page.player;
    let goal = match key {
        "i" => Goal::Into,
        "o" => Goal::Over,
        "u" => Goal::Out,
        "c" => Goal::Continue,
        "t" => match cursor(page) {
            Some((_, place)) => Goal::To(place),
            None => return true,
        },
        "r" => return player.walk_back(),
        "x" => return player.walk_stop(),
        "b" => {
            set_point(page, None);
            return true;
        }
        _ => return false,
    };
    player.walk_to(goal);
    true
}

/// The block at the cursor; follows the cursor.
pub(crate) fn at_cursor(page: Page) -> Option<(Location, Place)> {
    let (file, line) = page.player.walk.with(|walk| walk.cursor)?;
    let spot = Location::Line { file, line };
    let place = page.program.written.with(|written| spot.place(&written.parsed))?;
    Some((spot, place))
}

/// The block at the cursor; without one the user is asked for it.
fn cursor(page: Page) -> Option<(Location, Place)> {
    let found = untrack(|| at_cursor(page));
    if found.is_none() {
        page.notices.notify(Tone::Info, t("page.walk-cursor").to_owned());
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
    page.player.walk.update(|walk| done = walk.points.turn(spot, place, condition, &parsed));
    if let Err(why) = &done {
        page.notices.notify(Tone::Warn, sentence_with_hints(why));
    }
    done.is_ok()
}

/// Keeps breakpoints and watches in this browser, a line each.
pub(crate) fn keep(page: Page) {
    let mut out = String::new();
    page.player.walk.with_untracked(|walk| {
        for watch in &walk.watches {
            let _ = writeln!(out, "{watch}");
        }
        for point in walk.points.list() {
            let _ = writeln!(out, "{}\t{}", point.name(), point.condition);
        }
    });
    remember(KEPT, &out);
}

/// Takes the kept breakpoints and watches, as far as the program has their lines.
pub(crate) fn restore(page: Page) {
    let Some(text) = remembered(KEPT) else { return };
    let parsed = page.program.written.with_untracked(|written| written.parsed.clone());
    page.player.walk.update_untracked(|walk| {
        for line in text.lines() {
            match line.split_once('\t') {
                None => walk.watches.push(line.to_owned()),
                Some((name, condition)) => {
                    if let Some(spot) = Location::read_line(name, &parsed) {
                        let _ = walk.points.add(spot, condition, &parsed);
                    }
                }
            }
        }
    });
}
