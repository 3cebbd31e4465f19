//! The debugger as lines of text: a command in, an answer out.

use super::breakpoints::Location;
use super::session::{Session, SessionStop};
use super::stepping::{Debugger, Goal, Stop};
use crate::controls::Control;
use crate::interp::inspect::{CallLevel, Change, ChangeSubject, Entered};
use crate::motion::{Action, RunEnd};
use crate::msg;
use crate::project::findings::render::{Renderer, headline};
use crate::project::run::{Run, Setting};
use crate::text::catalog::{number_text, sentence, words};
use crate::text::{Diagnostic, Message, Place, headed};

/// Commands with their abbreviations, as `help` lists them, each with the id of its description.
const COMMANDS: [(&str, &str); 24] = [
    ("into, i", "console.help.into"),
    ("over, o", "console.help.over"),
    ("out", "console.help.out"),
    ("to PLACE", "console.help.to"),
    ("continue, c", "console.help.continue"),
    ("back", "console.help.back"),
    ("break PLACE [if CONDITION]", "console.help.break"),
    ("breaks", "console.help.breaks"),
    ("on N, off N", "console.help.on-off"),
    ("clear [N]", "console.help.clear"),
    ("watch EXPRESSION", "console.help.watch"),
    ("watches", "console.help.watches"),
    ("unwatch [N]", "console.help.unwatch"),
    ("print, p EXPRESSION", "console.help.print"),
    ("where, w", "console.help.where"),
    ("stack", "console.help.stack"),
    ("locals", "console.help.locals"),
    ("changed", "console.help.changed"),
    ("set VAR=VALUE", "console.help.set"),
    ("start", "console.help.start"),
    ("reset", "console.help.reset"),
    ("fault, fault off", "console.help.fault"),
    ("zero", "console.help.zero"),
    ("quit, q", "console.help.quit"),
];

/// Columns of a command in `help`; a longer one has a line of its own.
const COMMAND_WIDTH: usize = 20;

/// The text of `help`.
fn help() -> String {
    let row = |(command, id): &(&str, &'static str)| {
        let own_line = if command.len() < COMMAND_WIDTH { String::new() } else { format!("{command}\n") };
        let command = if own_line.is_empty() { command } else { "" };
        format!("{own_line}{command:<COMMAND_WIDTH$}{}\n", words(id))
    };
    COMMANDS.iter().map(row).collect()
}

/// A sentence as a line.
fn line(message: &Message) -> String {
    sentence(message) + "\n"
}

/// Decimals of values.
const DECIMALS: u8 = 9;

/// Result of a command.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Outcome {
    /// Carried out.
    Done,
    /// Unknown command, or wrong arguments.
    Wrong,
    /// `quit`.
    Quit,
}

/// A session of the debugger on the command line.
pub struct Console<'f> {
    session: Session,
    renderer: Renderer<'f>,
}

fn value_text(value: Option<f64>, control: &Control) -> String {
    match value {
        None if control.has_vacant() => words("console.vacant").to_owned(),
        value => number_text(value.unwrap_or_default(), DECIMALS),
    }
}

/// A change as a line: `#105 vacant -> 15072`, `G0 -> G1`.
fn change_text(change: &Change, control: &Control) -> String {
    let side = |value: Option<f64>| match (change.subject, value) {
        (ChangeSubject::Variable(_) | ChangeSubject::Local(_), value) => value_text(value, control),
        (_, None) => words("console.none").to_owned(),
        (ChangeSubject::Code, value) => format!("G{}", value_text(value, control)),
        (ChangeSubject::Feed, value) => format!("F{}", value_text(value, control)),
    };
    let name = match change.subject {
        ChangeSubject::Variable(number) | ChangeSubject::Local(number) => control.variable(number) + " ",
        ChangeSubject::Code | ChangeSubject::Feed => String::new(),
    };
    format!("{name}{} -> {}", side(change.before), side(change.after))
}

impl<'f> Console<'f> {
    /// A session before the first block of a run; `renderer` knows the files of its program.
    pub fn new(main: Run, renderer: Renderer<'f>) -> Console<'f> {
        Console { session: Session::new(main).0, renderer }
    }

    /// Alarms and warnings of the run so far.
    pub fn diagnostics(&self) -> &[Diagnostic] {
        self.session.diagnostics()
    }

    fn control(&self) -> &'static Control {
        self.session.control()
    }

    fn debugger(&self) -> &Debugger {
        self.session.debugger()
    }

    /// Carries out a line and returns its answer.
    pub fn line(&mut self, text: &str) -> (Outcome, String) {
        let text = text.trim();
        let (command, rest) = text.split_once(char::is_whitespace).unwrap_or((text, ""));
        let rest = rest.trim();
        let answer = match command {
            "into" | "i" => Ok(self.go(Goal::Into)),
            "over" | "o" => Ok(self.go(Goal::Over)),
            "out" => Ok(self.go(Goal::Out)),
            "continue" | "c" => Ok(self.go(Goal::Continue)),
            "to" => self.location(rest).map(|(_, place)| self.go(Goal::To(place))),
            "back" => self.back(),
            "break" | "b" => self.set_break(rest),
            "breaks" => Ok(self.breaks()),
            "on" => self.switch(rest, true),
            "off" => self.switch(rest, false),
            "clear" => self.clear(rest),
            "watch" => self.watch(rest),
            "watches" => Ok(self.watches()),
            "unwatch" => self.unwatch(rest),
            "print" | "p" => self.print(rest),
            "where" | "w" => Ok(self.place()),
            "stack" => Ok(self.stack()),
            "locals" => Ok(self.locals()),
            "changed" => Ok(self.changed()),
            "set" => self.set(rest),
            "start" => Ok(self.press(Action::Start)),
            "reset" => Ok(self.press(Action::Reset)),
            "fault" => match rest {
                "" | "on" => Ok(self.press(Action::InverterFault(true))),
                "off" => Ok(self.press(Action::InverterFault(false))),
                _ => Err(line(&msg!("console.fault-off"))),
            },
            "zero" => Ok(self.press(Action::ProgramZeroReturn)),
            "help" | "h" | "?" => Ok(help()),
            "quit" | "q" => return (Outcome::Quit, String::new()),
            "" => Ok(String::new()),
            _ => Err(line(&msg!("console.no-command", command))),
        };
        match answer {
            Ok(text) => (Outcome::Done, text),
            Err(text) => (Outcome::Wrong, text),
        }
    }

    /// The next block and the executing block, with machine time.
    pub fn place(&self) -> String {
        let levels = self.debugger().levels();
        let Some(now) = levels.first() else { return String::new() };
        let mut out = self.renderer.excerpt(now.place).unwrap_or_default();
        out +=
            &format!("  = {}", line(&msg!("console.now", program = self.level(now), time = (self.debugger().t(), 4))));
        if let Some(place) = self.debugger().executing().filter(|place| *place != now.place) {
            out += &format!("  = {}", line(&msg!("console.executing", block = self.renderer.block(place))));
        }
        out
    }

    /// Name of a program by its number.
    fn program(&self, number: u32) -> String {
        let letter = self.control().syntax.program_letters.first().copied().map_or('O', char::from);
        if number == 0 { words("console.unnumbered").to_owned() } else { format!("{letter}{number}") }
    }

    /// A program and how it was entered: `O9101, macro at level 1`.
    fn level(&self, level: &CallLevel) -> String {
        let program = if level.name.is_empty() { self.program(level.program) } else { level.name.clone() };
        let entered = match level.entered {
            Entered::Start => program,
            Entered::Subprogram => sentence(&msg!("console.subprogram", program)),
            Entered::Macro => sentence(&msg!("console.macro", program, level = level.local_level as u32)),
        };
        if level.again == 0 {
            entered
        } else {
            sentence(&msg!("console.again", program = entered, count = level.again))
        }
    }

    fn go(&mut self, goal: Goal) -> String {
        let halt = self.session.go(goal);
        self.halted(&halt)
    }

    /// Describes a stop.
    fn halted(&self, halt: &SessionStop) -> String {
        let mut out = match &halt.stop {
            Stop::Reached => String::new(),
            Stop::Breakpoint(number) => line(&msg!("console.breakpoint", number = *number)),
            Stop::Condition(number, why) => {
                line(&msg!("console.no-condition", number = *number)) + &self.renderer.text(why)
            }
            Stop::Ended(RunEnd::ProgramEnd) => line(&msg!("console.program-end")),
            Stop::Ended(RunEnd::Stop) => line(&msg!("console.waits")),
            Stop::Ended(RunEnd::Alarm(_)) => line(&msg!("console.alarm")),
            Stop::Ended(RunEnd::Blocks | RunEnd::Seconds) => line(&msg!("console.given-up")),
        };
        if !halt.again {
            out += &self.changed();
        }
        for diagnostic in &halt.found {
            out += &self.renderer.text(diagnostic);
        }
        if !halt.is_alarm() {
            out += &self.place();
        }
        out + &self.watches()
    }

    /// A watch: its expression with its value, or the reason why it has none.
    fn shown(&self, number: u32, text: &str) -> String {
        let watch = match self.debugger().evaluate(text) {
            Ok(value) => format!("{text} = {}", value_text(value, self.control())),
            Err(why) => headed(text, headline(&why)),
        };
        line(&msg!("console.watch", number, text = watch))
    }

    fn changed(&self) -> String {
        let mut out = String::new();
        for change in self.debugger().changes() {
            out += &format!("  {}\n", change_text(&change, self.control()));
        }
        let (earlier, newest) = self.debugger().run().newest_commands();
        let names = self.debugger().run().program().names();
        let newest: Vec<String> = newest
            .map(|canon| format!("  {}", line(&msg!("console.gives", command = canon.line(names).to_string()))))
            .collect();
        if earlier > 0 {
            out += &format!("  {}", line(&msg!("console.gives-many", count = (earlier + newest.len()) as u32)));
        }
        out + &newest.concat()
    }

    fn stack(&self) -> String {
        let mut out = String::new();
        for (at, level) in self.debugger().levels().iter().enumerate() {
            out += &format!("{at}  {}  {}\n", self.level(level), self.renderer.block(level.place));
            let locals = locals_text(level);
            if !locals.is_empty() {
                out += &format!("   {locals}\n");
            }
        }
        out
    }

    fn locals(&self) -> String {
        let levels = self.debugger().levels();
        // A subprogram shares the local variables of its caller.
        let Some(level) = levels.iter().find(|level| level.entered != Entered::Subprogram) else {
            return String::new();
        };
        let locals = locals_text(level);
        let number = level.local_level as u32;
        if locals.is_empty() {
            line(&msg!("console.locals-vacant", level = number))
        } else {
            format!("{}{locals}\n", sentence(&msg!("console.locals", level = number)))
        }
    }

    fn location(&self, text: &str) -> Result<(Location, Place), String> {
        self.session.location(text).ok_or_else(|| line(&msg!("console.no-block", place = text)))
    }

    fn set_break(&mut self, rest: &str) -> Result<String, String> {
        let lower = rest.to_ascii_lowercase();
        let (place, condition) = match lower.find(" if") {
            Some(at) => (rest.get(..at).unwrap_or(rest), rest.get(at + 3..).unwrap_or("")),
            None => (rest, ""),
        };
        let (location, at) = self.location(place)?;
        let added = self.session.set_break(location, condition);
        let number = added.map_err(|why| expression_error(condition.trim(), &why))?;
        Ok(line(&msg!("console.breakpoint-set", number, block = self.renderer.block(at))))
    }

    fn breaks(&self) -> String {
        let mut out = String::new();
        for point in self.session.points.list() {
            let condition = if point.condition.is_empty() { String::new() } else { format!(" if {}", point.condition) };
            let block = point.place.map_or_else(String::new, |place| self.renderer.block(place));
            let hits = sentence(&msg!("console.hits", breakpoint = format!("{block}{condition}"), hits = point.hits));
            let state = if point.on { hits } else { sentence(&msg!("console.off", breakpoint = hits)) };
            out += &format!("{}  {state}\n", point.number);
        }
        if out.is_empty() { line(&msg!("console.no-breakpoints")) } else { out }
    }

    fn switch(&mut self, rest: &str, on: bool) -> Result<String, String> {
        let point = number(rest).and_then(|number| self.session.points.get_mut(number));
        point.ok_or_else(|| no_such(rest, "breaks"))?.on = on;
        Ok(String::new())
    }

    fn clear(&mut self, rest: &str) -> Result<String, String> {
        let cleared = chosen(rest).is_some_and(|which| self.session.clear(which));
        if cleared { Ok(String::new()) } else { Err(no_such(rest, "breaks")) }
    }

    fn watch(&mut self, text: &str) -> Result<String, String> {
        let number = self.session.watch(text).map_err(|why| expression_error(text, &why))?;
        Ok(self.shown(number, text))
    }

    fn watches(&self) -> String {
        self.session.watches().map(|(number, text)| self.shown(number, text)).collect()
    }

    fn unwatch(&mut self, rest: &str) -> Result<String, String> {
        let removed = chosen(rest).is_some_and(|which| self.session.unwatch(which));
        if removed { Ok(String::new()) } else { Err(no_such(rest, "watches")) }
    }

    fn print(&self, text: &str) -> Result<String, String> {
        match self.debugger().evaluate(text) {
            Ok(value) => Ok(format!("{text} = {}\n", value_text(value, self.control()))),
            Err(why) => Err(expression_error(text, &why)),
        }
    }

    fn back(&mut self) -> Result<String, String> {
        let halt = self.session.back().ok_or_else(|| line(&msg!("console.no-block-before")))?;
        Ok(self.halted(&halt))
    }

    fn set(&mut self, rest: &str) -> Result<String, String> {
        let is_set = Setting::read(rest).is_some_and(|setting| self.session.set(&setting));
        if is_set { Ok(String::new()) } else { Err(line(&msg!("console.set"))) }
    }

    /// Applies an operator's action now, and runs on.
    fn press(&mut self, action: Action) -> String {
        let halt = self.session.press(action);
        self.halted(&halt)
    }
}

fn number(text: &str) -> Option<u32> {
    text.parse().ok()
}

/// The number that a command names; all of them where it names none, nothing where it is no number.
fn chosen(text: &str) -> Option<Option<u32>> {
    if text.is_empty() { Some(None) } else { number(text).map(Some) }
}

fn no_such(number: &str, list: &str) -> String {
    line(&msg!("console.no-such", number, command = list))
}

fn locals_text(level: &CallLevel) -> String {
    level.locals().map(|(number, value)| format!("  #{number}={}", number_text(value, DECIMALS))).collect()
}

/// The error of an expression, with its place marked below the text.
fn expression_error(text: &str, why: &Diagnostic) -> String {
    let mut out = headline(why);
    if let Some(place) = why.place {
        let before = text.get(..place.span.start as usize).unwrap_or("").chars().count();
        let wide = place.span.of(text).chars().count().max(1);
        out = format!("{text}\n{}{}\n{out}", " ".repeat(before), "^".repeat(wide));
    }
    out + "\n"
}
