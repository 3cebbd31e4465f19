//! Context of a block during its execution: program, control, machine.

use std::rc::Rc;

use super::index::Index;
use super::rules::{Rules, Units};
use super::world::World;
use crate::controls::Control;
use crate::nc::{Codes, Deck, Parsed};

/// Data shared by all copies of a run.
#[derive(Debug)]
pub(super) struct Shared {
    pub(super) parsed: Rc<Parsed>,
    pub(super) control: &'static Control,
    pub(super) index: Index,
    pub(super) rules: Rules,
    pub(super) units: Units,
    /// Index of the start program; `Err` holds a program number that does not exist.
    pub(super) start: Result<u32, u32>,
    /// The reader has reported blocks that the control refuses although each alone is right.
    pub(super) refuses: bool,
    /// The program reads modal data of the executing block.
    pub(super) executing: bool,
}

/// Data for the execution of a block.
pub(super) struct BlockContext<'a> {
    pub(super) shared: &'a Shared,
    pub(super) control: &'static Control,
    pub(super) deck: &'a Deck,
    pub(super) world: &'a mut dyn World,
    /// Reciprocal of the step that ROUND rounds to (1 = whole numbers).
    pub(super) parts: f64,
}

impl<'a> BlockContext<'a> {
    /// Codes of the control under its switch settings.
    #[inline]
    pub(super) fn codes(&self) -> &'a Codes {
        self.shared.parsed.codes()
    }
}
