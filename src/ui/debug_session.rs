//! The debugger of the page: walks beside the run, in slices, and sets the head where the walk stops.

use std::time::Duration;

use leptos::prelude::set_timeout;

use super::player::Player;
use super::walk::Walk;
use super::words::{end_words, t, tell};
use crate::math;
use crate::project::debug::{Debugger, Goal, Stop};

/// Milliseconds of walking in one slice.
const SLICE: f64 = 8.0;

/// Milliseconds of walking within a frame.
const IN_FRAME: f64 = 3.0;

impl Player {
    /// Forgets where the walk stands; whether it stood.
    pub(super) fn walk_away(self) -> bool {
        let stood = self.walk.quietly(|walk| {
            walk.debugger = None;
            core::mem::take(&mut walk.stands) | core::mem::take(&mut walk.going)
        });
        if stood {
            self.walk.update(|_| {});
        }
        stood
    }

    /// Walks to a goal: from where the walk stands, or from the head.
    pub(super) fn walk_to(self, goal: Goal) {
        self.playing.set(false);
        self.set_goal(self.head(), goal);
        self.walk_on();
    }

    fn set_goal(self, t: f64, goal: Goal) {
        self.walk.quietly(|walk| match &mut walk.debugger {
            Some(debugger) if walk.stands || walk.going => debugger.go(goal),
            debugger => *debugger = self.ask_planner(|main| Debugger::new(main, t, goal)),
        });
    }

    /// Walks back by a block. Every key of the debugger is one that is known: true.
    pub(super) fn walk_back(self) -> bool {
        let back = self.walk.quietly(|walk| {
            let debugger = walk.debugger.as_mut().filter(|_| walk.stands)?;
            self.ask_planner(|main| debugger.back(main))
        });
        if back == Some(true) {
            self.walk_on();
        }
        true
    }

    /// Stops where it is on its way; leaves the walk where it stands.
    pub(super) fn walk_stop(self) -> bool {
        if self.walk.with_untracked(|walk| walk.going) {
            self.arrive(Stop::Reached);
        } else {
            self.walk_away();
        }
        true
    }

    fn walk_on(self) {
        if let Some(stop) = self.walk.quietly(|walk| walk.advance(f64::INFINITY, SLICE)) {
            return self.arrive(stop);
        }
        self.walk.update(|walk| (walk.going, walk.stands) = (true, false));
        let on = move || {
            self.walk.quietly(|walk| walk.slicing = false);
            if self.walk.with_untracked(|walk| walk.going) {
                self.walk_on();
            }
        };
        if !self.walk.quietly(|walk| core::mem::replace(&mut walk.slicing, true)) {
            set_timeout(on, Duration::ZERO);
        }
    }

    /// The head goes where the walk has stopped.
    fn arrive(self, stop: Stop) {
        self.playing.put(false);
        self.walk.update(|walk| {
            (walk.going, walk.stands) = (false, true);
            let next = walk.stands().map_or_else(String::new, |debugger| {
                debugger.run().program().parsed().text(debugger.place().unwrap_or_default()).to_owned()
            });
            let words = |id: &'static str, what: String| format!("{}: {what}", t(id));
            walk.why = match stop {
                Stop::Reached => words("page.walk-next", next),
                Stop::Breakpoint(_) => words("page.walk-breakpoint", next),
                Stop::Condition(_, why) => words("page.walk-breakpoint", tell(&why)),
                Stop::Ended(end) => end_words(&end),
            };
        });
        self.set_head(self.walk.with_untracked(Walk::t));
    }

    /// How far the head may go on its way while it plays: to the next breakpoint.
    pub(super) fn play_to(self, from: f64, to: f64) -> f64 {
        let (idle, going) = self.walk.with_untracked(|walk| (walk.points.list().is_empty(), walk.going));
        if idle || going {
            self.walk_away();
        }
        if idle {
            return to;
        }
        if self.walk.with_untracked(|walk| walk.stands || walk.debugger.is_none()) {
            self.set_goal(from, Goal::Continue);
            self.walk.update(|walk| walk.stands = false);
        }
        match self.walk.quietly(|walk| walk.advance(to, IN_FRAME)) {
            None => math::clamp(self.walk.with_untracked(Walk::t), from, to),
            Some(Stop::Ended(_)) => to,
            Some(stop) => {
                self.arrive(stop);
                self.head()
            }
        }
    }
}
