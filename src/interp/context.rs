//! The context of a block while it runs: program, control, machine.

use std::rc::Rc;

use super::index::Index;
use super::rules::{Rules, Units};
use super::world::World;
use crate::controls::Control;
use crate::nc::{Codes, Deck, Parsed};

/// What all copies of a run share.
#[derive(Debug)]
pub(super) struct Shared {
    pub(super) parsed: Rc<Parsed>,
    pub(super) control: &'static Control,
    pub(super) index: Index,
    pub(super) rules: Rules,
    pub(super) units: Units,
    /// The program that a run starts with; `Err` is a number that no program has.
    pub(super) start: Result<u32, u32>,
    /// Programs may read data of the block that is executed.
    pub(super) executing: bool,
}

/// Data that a block reads while it executes.
pub(super) struct BlockContext<'a> {
    pub(super) shared: &'a Shared,
    pub(super) control: &'static Control,
    pub(super) deck: &'a Deck,
    pub(super) world: &'a mut dyn World,
    /// Reciprocal of the step that ROUND rounds to (1 = whole numbers).
    pub(super) parts: f64,
}

impl<'a> BlockContext<'a> {
    /// The codes of the control as its switches have them.
    #[inline]
    pub(super) fn codes(&self) -> &'a Codes {
        self.shared.parsed.codes()
    }
}
