//! Breakpoints: places where stepping stops, with optional conditions.

use crate::interp::{Interp, World};
use crate::motion::RunEnd;
use crate::nc::{self, Parsed, ParsedFormula};
use crate::project::run::program_number;
use crate::text::{Diagnostic, FileId, LineIndex, Place};

/// Reason of a stop of the debugger.
#[derive(Debug, Clone, PartialEq)]
pub enum Stop {
    /// The goal is reached.
    Reached,
    /// A breakpoint, by its number.
    Breakpoint(u32),
    /// The condition of a breakpoint, by its number, cannot be evaluated here.
    Condition(u32, Box<Diagnostic>),
    /// The run is over, or waits for the operator.
    Ended(RunEnd),
}

/// A block, by line or by program and sequence number.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Location {
    /// The first block in a line or below it.
    Line {
        /// The file.
        file: FileId,
        /// Line, from 1.
        line: u32,
    },
    /// A sequence number of a program; the first block where there is none.
    Sequence {
        /// Program number.
        program: u32,
        /// Sequence number.
        number: Option<u32>,
    },
}

impl Location {
    /// Reads `12`, `O9101.nc:12`, `N30`, `O9101 N30` or `O9101`; without file or program, those of the block `here`.
    pub fn read(text: &str, parsed: &Parsed, here: Place) -> Option<Location> {
        let text = text.trim();
        if text.as_bytes().contains(&b':') {
            return Location::read_line(text, parsed);
        }
        if text.bytes().all(|b| b.is_ascii_digit()) {
            return Some(Location::Line { file: here.file, line: text.parse().ok()? });
        }
        let upper = text.to_ascii_uppercase();
        let (program, number) = match upper.split_once('N') {
            Some((program, number)) => (program.trim(), Some(number.trim().parse().ok()?)),
            None => (upper.as_str(), None),
        };
        let program = if program.is_empty() {
            program_at(parsed, here)?
        } else {
            program_number(program, &parsed.control().syntax)?
        };
        Some(Location::Sequence { program, number })
    }

    /// Reads `O9101.nc:12`.
    pub fn read_line(text: &str, parsed: &Parsed) -> Option<Location> {
        let (name, line) = text.rsplit_once(':')?;
        let file = parsed.files().0.iter().position(|file| file.name.eq_ignore_ascii_case(name.trim()))?;
        Some(Location::Line { file: FileId(u16::try_from(file).ok()?), line: line.trim().parse().ok()? })
    }

    /// The block, if there is one.
    pub fn place(&self, parsed: &Parsed) -> Option<Place> {
        let deck = parsed.deck();
        let find = |fits: &mut dyn FnMut(&nc::Program, &nc::Block) -> bool| {
            for program in &deck.programs {
                if let Some(block) = deck.blocks_of(program).iter().find(|block| fits(program, block)) {
                    return Some(Place { file: program.file, span: block.span });
                }
            }
            None
        };
        match *self {
            Location::Line { file, line } => {
                let lines = LineIndex::new(&parsed.files().get(file)?.text);
                find(&mut |of, block| of.file == file && lines.line_of(block.span.start) >= line)
            }
            Location::Sequence { program, number } => {
                // The first with this number.
                let first = deck.program(program)?.first;
                find(&mut |of, block| of.first == first && (number.is_none() || block.number == number))
            }
        }
    }
}

/// Number of the program that contains a block.
fn program_at(parsed: &Parsed, place: Place) -> Option<u32> {
    let deck = parsed.deck();
    let holds = |blocks: &[nc::Block]| blocks.iter().any(|block| block.span == place.span);
    let mut programs = deck.programs.iter().filter(|program| program.file == place.file);
    programs.find(|program| holds(deck.blocks_of(program))).map(|program| program.number)
}

/// Name, text and number of a breakpoint's line when it was last found.
#[derive(Debug, Clone)]
struct Line {
    name: String,
    text: String,
    number: u32,
}

impl Line {
    fn of(location: &Location, parsed: &Parsed) -> Option<Line> {
        let Location::Line { file, line: number } = *location else { return None };
        let file = parsed.files().get(file)?;
        let text = LineIndex::new(&file.text).line(&file.text, number).to_owned();
        Some(Line { name: file.name.clone(), text, number })
    }

    /// In the file of that name the nearest line with the same text; the line with the same number where none has it.
    fn find(&self, parsed: &Parsed) -> Option<Location> {
        let at = parsed.files().0.iter().position(|file| file.name == self.name)?;
        let text = &parsed.files().0.get(at)?.text;
        let lines = LineIndex::new(text);
        let same = |line: &u32| !self.text.is_empty() && lines.line(text, *line) == self.text;
        let far = |line: &u32| line.abs_diff(self.number);
        let line = (1..=lines.count()).filter(same).min_by_key(far).unwrap_or(self.number);
        Some(Location::Line { file: FileId(u16::try_from(at).ok()?), line })
    }
}

/// A breakpoint.
#[derive(Debug, Clone)]
pub struct Breakpoint {
    /// Number, from 1; never reused.
    pub number: u32,
    /// Location as set.
    pub location: Location,
    /// Condition for a stop; empty for none.
    pub condition: String,
    /// Switched on.
    pub on: bool,
    /// Number of stops.
    pub hits: u32,
    /// The block, if the program has it.
    pub place: Option<Place>,
    /// Line of the breakpoint, to find it again in a changed text.
    line: Option<Line>,
    formula: Result<Option<ParsedFormula>, Box<Diagnostic>>,
}

impl Breakpoint {
    /// File and line as last found, for a breakpoint on a line.
    pub fn name(&self) -> String {
        self.line.as_ref().map_or_else(String::new, |line| format!("{}:{}", line.name, line.number))
    }
}

/// All breakpoints, in the order of their numbers.
#[derive(Debug, Clone, Default)]
pub struct Breakpoints {
    list: Vec<Breakpoint>,
    set: u32,
}

impl Breakpoints {
    /// Sets a breakpoint and returns its number; fails if the condition does not parse.
    pub fn add(&mut self, location: Location, condition: &str, parsed: &Parsed) -> Result<u32, Box<Diagnostic>> {
        let condition = condition.trim().to_owned();
        let formula = Ok(condition_of(&condition, parsed)?);
        self.set += 1;
        let (place, line) = (location.place(parsed), Line::of(&location, parsed));
        self.list.push(Breakpoint { number: self.set, location, condition, on: true, hits: 0, place, line, formula });
        Ok(self.set)
    }

    /// Removes the breakpoint at a block, or sets one there. With a condition, sets or replaces it.
    pub fn turn(
        &mut self,
        location: Location,
        place: Place,
        condition: Option<&str>,
        parsed: &Parsed,
    ) -> Result<(), Box<Diagnostic>> {
        let known = self.list.iter().position(|point| point.place == Some(place));
        if condition.is_some() || known.is_none() {
            self.add(location, condition.unwrap_or_default(), parsed)?;
        }
        if let Some(known) = known {
            self.list.remove(known);
        }
        Ok(())
    }

    /// Finds the blocks again in a changed text: a breakpoint on a line follows that line. A condition that no longer parses stops the run
    /// with its error.
    pub fn resolve(&mut self, parsed: &Parsed) {
        for point in &mut self.list {
            let found = match &point.line {
                Some(line) => line.find(parsed),
                None => Some(point.location.clone()),
            };
            point.place = found.as_ref().and_then(|location| location.place(parsed));
            if let Some(location) = found {
                point.line = Line::of(&location, parsed);
                point.location = location;
            }
            point.formula = condition_of(&point.condition, parsed);
        }
    }

    /// The breakpoints.
    pub fn list(&self) -> &[Breakpoint] {
        &self.list
    }

    /// A breakpoint by its number.
    pub fn get_mut(&mut self, number: u32) -> Option<&mut Breakpoint> {
        self.list.iter_mut().find(|point| point.number == number)
    }

    /// Keeps the breakpoints that fulfil a condition.
    pub fn retain(&mut self, fits: impl FnMut(&Breakpoint) -> bool) {
        self.list.retain(fits);
    }

    /// Whether a breakpoint stops the run before a block.
    pub(super) fn stop(&mut self, place: Place, interp: &Interp, world: &mut dyn World) -> Option<Stop> {
        for point in self.list.iter_mut().filter(|point| point.on && point.place == Some(place)) {
            let holds = match &point.formula {
                Ok(None) => Ok(true),
                Ok(Some(formula)) => {
                    interp.evaluate(formula, world).map(|value| value.is_some_and(|value| value != 0.0))
                }
                Err(why) => Err(why.clone()),
            };
            let holds = match holds {
                Ok(holds) => holds,
                Err(why) => return Some(Stop::Condition(point.number, why)),
            };
            if holds {
                point.hits += 1;
                return Some(Stop::Breakpoint(point.number));
            }
        }
        None
    }
}

fn condition_of(text: &str, parsed: &Parsed) -> Result<Option<ParsedFormula>, Box<Diagnostic>> {
    if text.trim().is_empty() { Ok(None) } else { nc::formula(text.trim(), parsed).map(Some) }
}
