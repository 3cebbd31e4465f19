//! A program of steps, so that time is tested without a language.

use std::rc::Rc;

use macroline::interp::canon::AXES;
use macroline::interp::{Canon, Counts, End, Feed, Step, Target, World};
use macroline::motion::RunningProgram;
use macroline::text::{FileId, Place, Span};

/// A block of a script.
#[derive(Debug, Clone)]
pub(super) enum Line {
    /// Commands of one NC block.
    Nc(Vec<Canon>),
    /// A macro block: variable = input.
    Input(u32, u32),
    /// A macro block: variable = variable + number.
    Add(u32, f64),
    /// A macro block that jumps to a line.
    Goto(usize),
    /// A relative straight block, in increments; the feed is the value of a variable in mm/min.
    Step([i64; 2], u32),
    /// Waits for the machine and puts the position of the first axis into a variable.
    Position(u32),
}

#[derive(Debug, Clone)]
pub(super) struct Script {
    lines: Rc<Vec<Line>>,
    at: usize,
    part: usize,
    synced: bool,
    blocks: Counts,
    position: [i64; AXES],
    variables: Vec<(u32, Option<f64>)>,
}

impl Script {
    pub(super) fn new(lines: impl IntoIterator<Item = Line>) -> Script {
        let lines = Rc::new(lines.into_iter().collect());
        let (blocks, position) = (Counts::default(), [0; AXES]);
        Script { lines, at: 0, part: 0, synced: false, blocks, position, variables: Vec::new() }
    }

    fn logic(&mut self, world: &mut dyn World, number: u32, value: f64) -> Step {
        self.blocks.macros += 1;
        self.at += 1;
        if self.variable(number) != Some(value) {
            self.set_variable(number, Some(value));
            world.changed(number, Some(value));
        }
        Step::Logic(place(self.at - 1))
    }
}

pub(super) fn place(line: usize) -> Place {
    Place { file: FileId(0), span: Span::at(line as u32) }
}

impl RunningProgram for Script {
    fn step(&mut self, world: &mut dyn World) -> Step {
        let lines = self.lines.clone();
        let Some(line) = lines.get(self.at) else { return Step::Ended(End::Program) };
        let here = place(self.at);
        match line {
            Line::Nc(commands) => {
                let command = commands[self.part].clone();
                self.blocks.nc += u64::from(self.part == 0);
                self.part += 1;
                if self.part == commands.len() {
                    (self.at, self.part) = (self.at + 1, 0);
                }
                if let Canon::Rapid { to }
                | Canon::Linear { to, .. }
                | Canon::Thread { to, .. }
                | Canon::Arc { to, .. } = &command
                {
                    self.position = to.position;
                }
                Step::Command(command, here)
            }
            Line::Input(to, from) => {
                let value = world.input(*from);
                self.logic(world, *to, value)
            }
            Line::Add(number, value) => {
                let sum = self.variable(*number).unwrap_or(0.0) + value;
                self.logic(world, *number, sum)
            }
            Line::Goto(line) => {
                self.blocks.macros += 1;
                self.at = *line;
                Step::Logic(here)
            }
            Line::Step(by, feed) => {
                self.blocks.nc += 1;
                self.at += 1;
                self.position[0] += by[0];
                self.position[1] += by[1];
                let feed = Feed::PerMinute(self.variable(*feed).unwrap_or(0.0));
                let to = Target { position: self.position, mask: 3 };
                Step::Command(Canon::Linear { to, feed, exact: false }, here)
            }
            Line::Position(to) => {
                self.synced = !self.synced;
                if self.synced {
                    return Step::Sync(here);
                }
                let value = world.position(0);
                self.logic(world, *to, value)
            }
        }
    }

    fn blocks(&self) -> Counts {
        self.blocks
    }

    fn restart(&mut self, position: [i64; AXES]) {
        (self.at, self.part, self.synced, self.position) = (0, 0, false, position);
    }

    fn set_variable(&mut self, number: u32, value: Option<f64>) -> bool {
        match self.variables.iter_mut().find(|(known, _)| *known == number) {
            Some(known) => known.1 = value,
            None => self.variables.push((number, value)),
        }
        true
    }

    fn variable(&self, number: u32) -> Option<f64> {
        self.variables.iter().find(|(known, _)| *known == number).and_then(|(_, value)| *value)
    }
}
