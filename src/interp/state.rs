//! The state of a run between two steps.

use crate::controls::Address;
use std::rc::Rc;

use super::canon::AXES;
use super::context::{BlockContext, Shared};
use super::error::Trap;
use super::frame::{CallFrame, ModalCall};
use super::modal::Modal;
use super::modal_history::ModalHistory;
use super::queue::CommandQueue;
use super::step::{Counts, End};
use super::vars::{VACANT, VariableStore};
use crate::controls::Alarm;
use crate::msg;
use crate::nc::Deck;
use crate::text::{Diagnostic, FileId, Message, Place, Span};

/// Plane, centre and direction of an arc.
#[derive(Debug, Clone, Copy)]
pub(super) struct ArcGeometry {
    pub(super) plane: (u8, u8),
    /// In command increments, machine frame.
    pub(super) center: (f64, f64),
    pub(super) clockwise: bool,
}

/// The last motion, for arcs that continue in its direction.
#[derive(Debug, Clone, Default)]
pub(super) struct LastMotion {
    /// Start in command increments, machine frame.
    pub(super) from: [i64; AXES],
    /// Geometry of the motion if it was an arc.
    pub(super) arc: Option<ArcGeometry>,
}

/// A run between two steps.
#[derive(Debug, Clone)]
pub(super) struct RunState {
    pub(super) vars: VariableStore,
    pub(super) modal: Modal,
    /// Commanded position in command increments, machine frame.
    pub(super) position: [i64; AXES],
    /// The last motion, for arcs that continue in its direction.
    pub(super) last_motion: LastMotion,
    /// End of the last motion with skip signal, machine frame.
    pub(super) skip: [i64; AXES],
    pub(super) queue: CommandQueue,
    /// Modal states of the issued commands, if the program reads them.
    pub(super) issued: ModalHistory,
    pub(super) frames: Vec<CallFrame>,
    pub(super) modal_call: Option<Rc<ModalCall>>,
    /// Running program, with its file and its blocks.
    pub(super) program: u32,
    pub(super) file: FileId,
    pub(super) first: u32,
    pub(super) end: u32,
    /// Next block.
    pub(super) at: u32,
    /// Last block read.
    pub(super) place: Place,
    pub(super) counts: Counts,
    /// Machine time (ms) of the zero of each [`MachineClock`](super::world::MachineClock).
    pub(super) clock_zero: [f64; 2],
    /// The machine is at rest for the next block.
    pub(super) synced: bool,
    /// The machine has to come to rest before a further block is read.
    pub(super) pause: bool,
    pub(super) ended: Option<End>,
}

impl RunState {
    pub(super) fn new(shared: &Shared) -> RunState {
        let mut state = RunState {
            vars: VariableStore::new(shared.index.stored),
            modal: Modal::new(shared.control, shared.rules.dialect.startup.iter().copied()),
            position: [0; AXES],
            last_motion: LastMotion::default(),
            skip: [0; AXES],
            queue: CommandQueue::default(),
            issued: ModalHistory::default(),
            frames: Vec::new(),
            modal_call: None,
            program: 0,
            file: FileId::default(),
            first: 0,
            end: 0,
            at: 0,
            place: Place::default(),
            counts: Counts::default(),
            clock_zero: [0.0; 2],
            synced: false,
            pause: false,
            ended: None,
        };
        state.rewind(shared);
        state
    }

    pub(super) fn go_to_program(&mut self, deck: &Deck, program: u32) {
        if let Some(row) = deck.programs.get(program as usize) {
            (self.program, self.file) = (program, row.file);
            (self.first, self.end, self.at) = (row.first, row.end, row.first);
            self.modal.set_shown(Address::O, if row.number == 0 { VACANT } else { f64::from(row.number) });
        }
    }

    /// Back to the first block of the start program.
    fn rewind(&mut self, shared: &Shared) {
        match shared.start {
            Ok(program) => self.go_to_program(shared.parsed.deck(), program),
            Err(number) => {
                let trap = if number == 0 {
                    Trap::alarm(Alarm::NoProgram, msg!("interp.no-program-at-all"))
                } else {
                    Trap::alarm(Alarm::NoProgram, msg!("interp.no-program", program = number))
                };
                self.fail(shared, trap);
            }
        }
    }

    /// Reset key: modal codes as after power-on, locals vacant, common variables by the control's parameter.
    pub(super) fn reset(&mut self, shared: &Shared) {
        let (position, counts, clock_zero, modal) = (self.position, self.counts, self.clock_zero, self.modal.clone());
        let vars = core::mem::replace(&mut self.vars, VariableStore::new(shared.index.stored));
        *self = RunState::new(shared);
        (self.position, self.counts, self.clock_zero) = (position, counts, clock_zero);
        self.modal.keep_zeros(&modal);
        self.keep_stored(shared, &vars);
    }

    fn keep_stored(&mut self, shared: &Shared, old: &VariableStore) {
        use crate::controls::VarKind::*;
        for (at, row) in shared.control.vars.iter().enumerate() {
            let kept = match row.kind {
                Common => !shared.rules.running.clear_common,
                Retained | Kept | OutputWord(_) => true,
                _ => false,
            };
            for number in row.first..=row.last {
                if let (true, Some(slot)) = (kept, shared.index.stored_at(row, at, number)) {
                    let value = old.common(slot);
                    if !value.is_nan() {
                        self.vars.set_common(slot, value);
                    }
                }
            }
        }
    }

    /// Adds a warning about a span of the present block.
    #[cold]
    pub(super) fn remark(&self, cx: &mut BlockContext, span: Span, message: Message) {
        cx.world.remark(Diagnostic::warning(message).at(Place { file: self.file, span }));
    }

    /// Modal state of the executing block; at rest, of the last block read.
    pub(super) fn executing(&self, cx: &mut BlockContext) -> &Modal {
        cx.world.waiting().and_then(|waiting| self.issued.of_queued(waiting)).unwrap_or(&self.modal)
    }
}
