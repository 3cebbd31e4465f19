//! Call frames, and the modal macro call in force.

use std::rc::Rc;

use super::vars::Locals;

/// Caller of a program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum CalledBy {
    /// A word or statement that names the program: `M98 P`, `G65 P`, a name.
    Word,
    /// A code bound to the program.
    Code,
}

/// Return data of a call.
#[derive(Debug, Clone)]
pub(super) struct CallFrame {
    /// The caller's program.
    pub(super) program: u32,
    /// The block after the call.
    pub(super) back: u32,
    /// The modal call of a macro's caller.
    pub(super) modal_call: Option<Rc<ModalCall>>,
    /// First block of the called program, for repeats.
    pub(super) entry: u32,
    /// Number of repeats left.
    pub(super) again: u32,
    /// Arguments of a macro; a subprogram has none and shares its caller's locals.
    pub(super) arguments: Option<CallArguments>,
    /// Codes in a program called by a code call no further program.
    pub(super) called_by: CalledBy,
}

/// Arguments of a macro call.
#[derive(Debug, Clone)]
pub(super) struct CallArguments {
    /// By local variable; vacant if not passed.
    pub(super) locals: Rc<Locals>,
    /// Local variables (bit 0 for `#1`) whose argument had no decimal point and counted increments.
    pub(super) without_point: u64,
}

/// G66 or G66.1 in force.
#[derive(Debug)]
pub(super) struct ModalCall {
    /// Number of the macro.
    pub(super) program: u32,
    /// Runs of the macro per call.
    pub(super) repeats: u32,
    /// Arguments of each call; G66.1 uses the words of each block instead.
    pub(super) arguments: CallArguments,
    /// G66.1: each block is only a call.
    pub(super) each_block: bool,
    /// Origin of the modal call: a word or a code.
    pub(super) called_by: CalledBy,
    /// The preceding modal call: in force within the macro, and again when this one ends.
    pub(super) outer: Option<Rc<ModalCall>>,
}
