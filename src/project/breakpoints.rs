//! Breakpoints: where a walk through a program stops, and under which condition.

use super::debug::Stop;
use super::run::program_number;
use crate::interp::{Interp, World};
use crate::nc::{self, Formula, Parsed};
use crate::text::{Diagnostic, FileId, LineIndex, Place};

/// A block as people name it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Spot {
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

impl Spot {
    /// Reads `12`, `O9101.nc:12`, `N30`, `O9101 N30` or `O9101`; `here` is a block of the file and program that are meant where none is
    /// named.
    pub fn read(text: &str, parsed: &Parsed, here: Place) -> Option<Spot> {
        let line = |file: FileId, line: &str| Some(Spot::Line { file, line: line.trim().parse().ok()? });
        let text = text.trim();
        if let Some((name, number)) = text.rsplit_once(':') {
            let file = parsed.files().0.iter().position(|file| file.name.eq_ignore_ascii_case(name.trim()))?;
            return line(FileId(u16::try_from(file).ok()?), number);
        }
        if text.bytes().all(|b| b.is_ascii_digit()) {
            return line(here.file, text);
        }
        let upper = text.to_ascii_uppercase();
        let (program, number) = match upper.split_once('N') {
            Some((program, number)) => (program.trim(), Some(number.trim().parse().ok()?)),
            None => (upper.as_str(), None),
        };
        let program = if program.is_empty() { program_at(parsed, here)? } else { program_number(program)? };
        Some(Spot::Sequence { program, number })
    }

    /// The block, where there is one.
    pub fn place(&self, parsed: &Parsed) -> Option<Place> {
        let deck = parsed.deck();
        match *self {
            Spot::Line { file, line } => {
                let text = &parsed.files().get(file)?.text;
                let lines = LineIndex::new(text);
                let programs = deck.programs.iter().filter(|program| program.file == file);
                let mut blocks = programs.flat_map(|program| deck.blocks_of(program));
                let block = blocks.find(|block| lines.line_of(block.span.start) >= line)?;
                Some(Place { file, span: block.span })
            }
            Spot::Sequence { program, number } => {
                let program = deck.program(program)?;
                let mut blocks = deck.blocks_of(program).iter();
                let block = blocks.find(|block| number.is_none() || block.number == number)?;
                Some(Place { file: program.file, span: block.span })
            }
        }
    }
}

/// The number of the program that a block stands in.
pub fn program_at(parsed: &Parsed, place: Place) -> Option<u32> {
    let deck = parsed.deck();
    let holds = |blocks: &[nc::Block]| blocks.iter().any(|block| block.span == place.span);
    let mut programs = deck.programs.iter().filter(|program| program.file == place.file);
    programs.find(|program| holds(deck.blocks_of(program))).map(|program| program.number)
}

/// A place to stop at.
#[derive(Debug, Clone)]
pub struct Breakpoint {
    /// Its number, from 1; never given twice.
    pub number: u32,
    /// Where.
    pub spot: Spot,
    /// It stops only where this is so; empty is always.
    pub condition: String,
    /// Whether it stops at all.
    pub on: bool,
    /// How often it has stopped a walk.
    pub hits: u32,
    /// The block, where the program has it.
    pub place: Option<Place>,
    formula: Option<Formula>,
}

/// All breakpoints, in the order in which they were set.
#[derive(Debug, Clone, Default)]
pub struct Breakpoints {
    list: Vec<Breakpoint>,
    set: u32,
}

impl Breakpoints {
    /// Sets one and gives its number; fails where the condition does not read.
    pub fn add(&mut self, spot: Spot, condition: &str, parsed: &Parsed) -> Result<u32, Box<Diagnostic>> {
        let condition = condition.trim();
        let formula = if condition.is_empty() { None } else { Some(nc::formula(condition, parsed.control())?) };
        self.set += 1;
        let place = spot.place(parsed);
        let condition = condition.to_owned();
        self.list.push(Breakpoint { number: self.set, spot, condition, on: true, hits: 0, place, formula });
        Ok(self.set)
    }

    /// Finds the blocks again in another text. Where a condition does not read any more, its breakpoint is switched off.
    pub fn resolve(&mut self, parsed: &Parsed) {
        for point in &mut self.list {
            point.place = point.spot.place(parsed);
            if point.formula.is_some() {
                point.formula = nc::formula(&point.condition, parsed.control()).ok();
                point.on &= point.formula.is_some();
            }
        }
    }

    /// All of them.
    pub fn list(&self) -> &[Breakpoint] {
        &self.list
    }

    /// One of them, by its number.
    pub fn get_mut(&mut self, number: u32) -> Option<&mut Breakpoint> {
        self.list.iter_mut().find(|point| point.number == number)
    }

    /// Keeps those that fit.
    pub fn retain(&mut self, fits: impl FnMut(&Breakpoint) -> bool) {
        self.list.retain(fits);
    }

    /// Whether one of them stops before a block.
    pub(super) fn stop(&mut self, place: Place, interp: &Interp, world: &mut dyn World) -> Option<Stop> {
        for point in self.list.iter_mut().filter(|point| point.on && point.place == Some(place)) {
            let holds = match point.formula.as_ref().map(|formula| interp.evaluate(formula, world)) {
                None => true,
                Some(Ok(value)) => value.is_some_and(|value| value != 0.0),
                Some(Err(why)) => return Some(Stop::Condition(point.number, why)),
            };
            if holds {
                point.hits += 1;
                return Some(Stop::Breakpoint(point.number));
            }
        }
        None
    }
}
