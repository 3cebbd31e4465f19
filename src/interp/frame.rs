//! Call frames, and the modal macro call in force.

use std::rc::Rc;

use super::vars::Locals;

/// The caller of a program, for its return.
#[derive(Debug, Clone)]
pub(super) struct CallFrame {
    /// The caller's program.
    pub(super) program: u32,
    /// The block behind the call.
    pub(super) back: u32,
    /// The modal call of a macro's caller.
    pub(super) modal_call: Option<Rc<ModalCall>>,
    /// First block of the called program, for repeats.
    pub(super) entry: u32,
    /// How often it runs again.
    pub(super) again: u32,
    /// Arguments of a macro; a subprogram has none and shares its caller's locals.
    pub(super) arguments: Option<Rc<Locals>>,
    /// A code called it: within it no code calls.
    pub(super) by_code: bool,
}

/// G66 or G66.1 in force.
#[derive(Debug)]
pub(super) struct ModalCall {
    /// Number of the macro.
    pub(super) program: u32,
    /// How often each call runs it.
    pub(super) repeats: u32,
    /// Arguments of each call; G66.1 takes those of the block instead.
    pub(super) arguments: Rc<Locals>,
    /// G66.1: each block is a call, and nothing but a call.
    pub(super) each_block: bool,
    /// A code put it in force.
    pub(super) by_code: bool,
    /// The modal call that was in force before: it acts within the macro, and again when this one ends.
    pub(super) outer: Option<Rc<ModalCall>>,
}
