//! A session of the debugger: the stepped run beside the one it was forked from, breakpoints, watches, and the diagnostics reported so far.

use super::breakpoints::{Breakpoints, Location};
use super::stepping::{Debugger, Goal, Stop};
use crate::controls::{Control, Dialect};
use crate::interp::Counts;
use crate::motion::{Action, Event, Panel, RunEnd};
use crate::nc::{self, Parsed};
use crate::project::io_names;
use crate::project::run::{Run, Setting};
use crate::text::{Diagnostic, Place};

/// Events of the machine that are planned before the goal is checked again.
const SLICE: usize = 4096;

/// A stop of a session.
#[derive(Debug, Clone, PartialEq)]
pub struct SessionStop {
    /// Reason of the stop.
    pub stop: Stop,
    /// Whether the run was at this end before the command.
    pub again: bool,
    /// Alarms and warnings since the stop before.
    pub found: Vec<Diagnostic>,
}

impl SessionStop {
    /// The run has ended in an alarm.
    pub fn is_alarm(&self) -> bool {
        matches!(self.stop, Stop::Ended(RunEnd::Alarm(_)))
    }
}

/// Steps through a run by commands.
pub struct Session {
    /// The main run, from whose checkpoints the stepped run is forked.
    main: Run,
    debugger: Debugger,
    /// The breakpoints.
    pub points: Breakpoints,
    /// Watches: numbers and expressions.
    watches: Vec<(u32, String)>,
    /// Number of the last watch.
    watched: u32,
    diagnostics: Vec<Diagnostic>,
    /// Time and block counts at the last end of the run, to detect that a command changed nothing.
    over: Option<(f64, Counts)>,
}

impl Session {
    /// A session before the first block of a run, and its first stop.
    pub fn new(main: Run) -> (Session, SessionStop) {
        let mut session = Session {
            debugger: Debugger::new(&main, 0.0, Goal::Into),
            main,
            points: Breakpoints::default(),
            watches: Vec::new(),
            watched: 0,
            diagnostics: Vec::new(),
            over: None,
        };
        let halt = session.walk();
        (session, halt)
    }

    /// Alarms and warnings of the run so far.
    pub fn diagnostics(&self) -> &[Diagnostic] {
        &self.diagnostics
    }

    /// The stepped run at the stop.
    pub fn debugger(&self) -> &Debugger {
        &self.debugger
    }

    /// The program.
    pub fn parsed(&self) -> &Parsed {
        self.main.program().parsed()
    }

    /// The control.
    pub fn control(&self) -> &'static Control {
        self.main.program().control()
    }

    fn dialect(&self) -> &Dialect {
        self.parsed().dialect()
    }

    /// Steps to a goal.
    pub fn go(&mut self, goal: Goal) -> SessionStop {
        self.debugger.go(goal);
        self.walk()
    }

    /// Goes back to the block read before; nothing where there is none.
    pub fn back(&mut self) -> Option<SessionStop> {
        while self.main.timeline().end() < self.debugger.t() {
            if self.main.advance(self.debugger.t(), SLICE).ended.is_some() {
                break;
            }
        }
        drop(self.main.take_log());
        self.debugger.back(&self.main).then(|| self.walk())
    }

    /// Applies an operator's action now, and runs on.
    pub fn press(&mut self, action: Action) -> SessionStop {
        self.act(Event { t: self.debugger.t(), action });
        self.walk()
    }

    /// Sets a variable or an input now; false where the control has none that can be set.
    pub fn set(&mut self, setting: &Setting) -> bool {
        let Some(action) = setting.action(self.control(), self.dialect()) else { return false };
        let event = Event { t: self.debugger.t(), action };
        for event in io_names::panel(&Panel::new([event]), self.control(), self.dialect()).events() {
            self.act(event.clone());
        }
        self.reach();
        true
    }

    /// The block that a text names; see [`Location::read`].
    pub fn location(&self, text: &str) -> Option<(Location, Place)> {
        let here = self.debugger.place().unwrap_or_default();
        let location = Location::read(text, self.parsed(), here)?;
        location.place(self.parsed()).map(|place| (location, place))
    }

    /// Sets a breakpoint and returns its number; fails if the condition does not parse.
    pub fn set_break(&mut self, location: Location, condition: &str) -> Result<u32, Box<Diagnostic>> {
        self.points.add(location, condition, self.main.program().parsed())
    }

    /// Removes a breakpoint, or all of them; false where there is none.
    pub fn clear(&mut self, which: Option<u32>) -> bool {
        let before = self.points.list().len();
        self.points.retain(|point| which.is_some_and(|which| which != point.number));
        self.points.list().len() < before
    }

    /// Watches an expression and returns the number of the watch; fails if it does not parse.
    pub fn watch(&mut self, text: &str) -> Result<u32, Box<Diagnostic>> {
        nc::formula(text, self.parsed())?;
        self.watched += 1;
        self.watches.push((self.watched, text.to_owned()));
        Ok(self.watched)
    }

    /// The watches: numbers and expressions.
    pub fn watches(&self) -> impl Iterator<Item = (u32, &str)> {
        self.watches.iter().map(|(number, text)| (*number, text.as_str()))
    }

    /// Removes a watch, or all of them; false where there is none.
    pub fn unwatch(&mut self, which: Option<u32>) -> bool {
        let before = self.watches.len();
        self.watches.retain(|(number, _)| which.is_some_and(|which| which != *number));
        self.watches.len() < before
    }

    /// Applies an operator's action to both runs.
    fn act(&mut self, event: Event) {
        self.main.event(event.clone());
        self.debugger.act(event);
    }

    /// Steps to the goal.
    fn reach(&mut self) -> Stop {
        loop {
            if let Some(stop) = self.debugger.advance(&mut self.points, f64::INFINITY, SLICE) {
                return stop;
            }
        }
    }

    /// Steps to the goal, and collects new diagnostics.
    fn walk(&mut self) -> SessionStop {
        let stop = self.reach();
        let over = matches!(stop, Stop::Ended(_)).then(|| (self.debugger.t(), self.debugger.run().blocks()));
        let again = over.is_some() && over == self.over;
        self.over = over;
        let mut reported: Vec<Diagnostic> = self.debugger.run().diagnostics().to_vec();
        if let Stop::Ended(RunEnd::Alarm(alarm)) = &stop {
            reported.push((**alarm).clone());
        }
        let mut found = Vec::new();
        for diagnostic in reported {
            if !self.diagnostics.contains(&diagnostic) {
                self.diagnostics.push(diagnostic.clone());
                found.push(diagnostic);
            }
        }
        SessionStop { stop, again, found }
    }
}
