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
    pub(super) arguments: Option<Given>,
    /// A code called it: within it no code calls.
    pub(super) by_code: bool,
}

/// Arguments of a macro call.
#[derive(Debug, Clone)]
pub(super) struct Given {
    /// By local variable; vacant where the call has none.
    pub(super) locals: Rc<Locals>,
    /// Local variables, bit 0 for `#1`, whose argument counted command increments because its number had no point.
    pub(super) pointless: u64,
}

/// G66 or G66.1 in force.
#[derive(Debug)]
pub(super) struct ModalCall {
    /// Number of the macro.
    pub(super) program: u32,
    /// How often each call runs it.
    pub(super) repeats: u32,
    /// Arguments of each call; G66.1 takes those of the block instead.
    pub(super) arguments: Given,
    /// G66.1: each block is a call, and nothing but a call.
    pub(super) each_block: bool,
    /// A code put it in force.
    pub(super) by_code: bool,
    /// The modal call that was in force before: it acts within the macro, and again when this one ends.
    pub(super) outer: Option<Rc<ModalCall>>,
}
