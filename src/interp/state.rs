//! The state of a run between two steps, and the step itself.

use std::rc::Rc;

use super::call::{Frame, ModalCall};
use super::canon::{AXES, Canon};
use super::error::{Run, Trap};
use super::eval::WHOLE;
use super::index::{Index, Partner};
use super::modal::Modal;
use super::modal_history::Given;
use super::rules::{Rules, Units};
use super::vars::{VACANT, Vars};
use super::{Counts, End, Step, World};
use crate::controls::{Alarm, Code, Control};
use crate::msg;
use crate::nc::{Block, Codes, Deck, ExprId, Parsed, Stmt};
use crate::text::{Diagnostic, FileId, Message, Place, Span};

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

/// What a block may ask while it runs.
pub(super) struct BlockContext<'a> {
    pub(super) shared: &'a Shared,
    pub(super) control: &'static Control,
    pub(super) deck: &'a Deck,
    pub(super) world: &'a mut dyn World,
    /// Parts of a unit that ROUND rounds to: 1 but for words whose step it counts.
    pub(super) parts: f64,
}

impl<'a> BlockContext<'a> {
    /// The codes of the control as its switches have them.
    #[inline]
    pub(super) fn codes(&self) -> &'a Codes {
        self.shared.parsed.codes()
    }
}

/// Commands of the last block that were not taken yet.
#[derive(Debug, Clone, Default)]
pub(super) struct Queue {
    items: Vec<Canon>,
    head: usize,
}

impl Queue {
    #[inline]
    pub(super) fn push(&mut self, canon: Canon) {
        self.items.push(canon);
    }

    #[inline]
    pub(super) fn is_empty(&self) -> bool {
        self.items.is_empty()
    }

    #[inline]
    fn pop(&mut self) -> Option<Canon> {
        if self.items.len() == self.head + 1 {
            self.head = 0;
            let last = self.items.pop();
            self.items.clear();
            return last;
        }
        let canon = core::mem::replace(self.items.get_mut(self.head)?, Canon::Stop);
        self.head += 1;
        Some(canon)
    }

    fn clear(&mut self) {
        self.items.clear();
        self.head = 0;
    }
}

/// What an arc turns about.
#[derive(Debug, Clone, Copy)]
pub(super) struct ArcGeometry {
    pub(super) plane: (u8, u8),
    /// In command increments, machine frame.
    pub(super) center: (f64, f64),
    pub(super) clockwise: bool,
}

/// How the last motion came to its end.
#[derive(Debug, Clone, Default)]
pub(super) struct LastMotion {
    /// Where it began, in command increments, machine frame.
    pub(super) from: [i64; AXES],
    /// Of an arc, what it turned about.
    pub(super) arc: Option<ArcGeometry>,
}

/// A run between two steps.
#[derive(Debug, Clone)]
pub(super) struct State {
    pub(super) vars: Vars,
    pub(super) modal: Modal,
    /// Commanded position in command increments, machine frame.
    pub(super) position: [i64; AXES],
    /// The last motion, where the next one may go on in its direction.
    pub(super) came: LastMotion,
    /// Where the last motion that a signal may skip came to its end, machine frame.
    pub(super) skip: [i64; AXES],
    pub(super) queue: Queue,
    /// What was in force with the commands handed out, where a program may ask for it.
    pub(super) given: Given,
    pub(super) frames: Vec<Frame>,
    pub(super) modal_call: Option<Rc<ModalCall>>,
    /// Program that is running, with its file and its blocks.
    pub(super) program: u32,
    pub(super) file: FileId,
    pub(super) first: u32,
    pub(super) end: u32,
    /// Next block.
    pub(super) at: u32,
    /// Block that ran last.
    pub(super) place: Place,
    pub(super) counts: Counts,
    /// Machine time at which `#3001` and `#3002` would be 0, in ms.
    pub(super) clock_zero: [f64; 2],
    /// The machine is at rest for the block that comes next.
    pub(super) synced: bool,
    /// Nothing behind the last block may be read before the machine is at rest.
    pub(super) pause: bool,
    pub(super) ended: Option<End>,
}

impl State {
    pub(super) fn new(shared: &Shared) -> State {
        let mut state = State {
            vars: Vars::new(shared.index.stored),
            modal: Modal::new(shared.control, shared.rules.startup.iter().copied()),
            position: [0; AXES],
            came: LastMotion::default(),
            skip: [0; AXES],
            queue: Queue::default(),
            given: Given::default(),
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

    /// Back to the first block of the start program.
    fn rewind(&mut self, shared: &Shared) {
        match shared.start {
            Ok(program) => self.go_to_program(shared.parsed.deck(), program),
            Err(number) => {
                let trap = if number == 0 {
                    Trap::alarm(Alarm::NoProgram, msg!("interp.no-program-at-all"))
                } else {
                    Trap::alarm(Alarm::NoProgram, msg!("interp.no-program", number))
                };
                self.fail(shared, trap);
            }
        }
    }

    /// What the reset key does: modal codes as after power-on, locals vacant, common variables as the control's parameter says.
    pub(super) fn reset(&mut self, shared: &Shared) {
        let (position, counts, clock_zero, modal) = (self.position, self.counts, self.clock_zero, self.modal.clone());
        let vars = core::mem::replace(&mut self.vars, Vars::new(shared.index.stored));
        *self = State::new(shared);
        (self.position, self.counts, self.clock_zero) = (position, counts, clock_zero);
        self.modal.keep_zeros(&modal);
        self.keep_stored(shared, &vars);
    }

    fn keep_stored(&mut self, shared: &Shared, old: &Vars) {
        use crate::controls::VarKind::*;
        for (at, row) in shared.control.vars.iter().enumerate() {
            let kept = match row.kind {
                Common => !shared.rules.clear_common,
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

    pub(super) fn go_to_program(&mut self, deck: &Deck, program: u32) {
        if let Some(row) = deck.programs.get(program as usize) {
            (self.program, self.file) = (program, row.file);
            (self.first, self.end, self.at) = (row.first, row.end, row.first);
            self.modal.word(b'O', if row.number == 0 { VACANT } else { f64::from(row.number) });
        }
    }

    /// Says something about bytes of the block at hand that is no alarm.
    #[cold]
    pub(super) fn remark(&self, cx: &mut BlockContext, span: Span, message: Message) {
        cx.world.remark(Diagnostic::warning(message).at(Place { file: self.file, span }));
    }

    #[cold]
    fn fail(&mut self, shared: &Shared, trap: Trap) -> Step {
        self.queue.clear();
        if let Trap::Alarm(fault) = trap {
            self.ended = Some(End::Alarm(Box::new(fault.diagnostic(&shared.parsed, self.place))));
        }
        self.over()
    }

    #[cold]
    fn over(&self) -> Step {
        Step::Ended(self.ended.clone().unwrap_or(End::Program))
    }

    #[inline]
    fn hand_out(&mut self, shared: &Shared, canon: Canon) -> Step {
        if shared.executing {
            self.given.note(&canon, &self.modal);
        }
        Step::Command(canon, self.place)
    }

    /// What is in force in the block that the machine executes; at rest all that was read is.
    pub(super) fn executing(&self, cx: &mut BlockContext) -> &Modal {
        cx.world.waiting().and_then(|waiting| self.given.behind(waiting)).unwrap_or(&self.modal)
    }

    /// At most one block, or one more command of the last.
    pub(super) fn step(&mut self, shared: &Shared, world: &mut dyn World) -> Step {
        if let Some(canon) = self.queue.pop() {
            return self.hand_out(shared, canon);
        }
        if self.ended.is_some() {
            return self.over();
        }
        if core::mem::take(&mut self.pause) {
            return Step::Sync(self.place);
        }
        let deck = shared.parsed.deck();
        let mut cx = BlockContext { shared, control: shared.control, deck, world, parts: 1.0 };
        let at = self.at;
        let Some(block) = deck.blocks.get(at as usize).filter(|_| at < self.end) else {
            return self.no_end(&cx);
        };
        self.place = Place { file: self.file, span: block.span };
        self.at = at + 1;
        match self.block(&mut cx, at, block) {
            Ok(()) => {
                self.synced = false;
                match self.queue.pop() {
                    Some(canon) => self.hand_out(shared, canon),
                    None => Step::Logic(self.place),
                }
            }
            Err(Trap::Sync) => {
                self.queue.clear();
                self.at = at;
                self.synced = true;
                Step::Sync(self.place)
            }
            Err(mut trap) => {
                if let Trap::Alarm(fault) = &mut trap {
                    fault.locate(deck, block);
                }
                self.fail(shared, trap)
            }
        }
    }

    /// The program has run out of blocks.
    #[cold]
    fn no_end(&mut self, cx: &BlockContext) -> Step {
        let program = cx.deck.programs.get(self.program as usize);
        let last = (self.first < self.end).then(|| cx.deck.blocks.get(self.end as usize - 1)).flatten();
        let span = last.map_or(program.map_or(Span::default(), |program| program.span), |block| block.span);
        self.place = Place { file: self.file, span };
        let name = |code: Code| {
            let row = cx.control.codes.iter().find(|row| row.code == code);
            row.map_or(String::new(), |row| cx.control.code_name(row.id))
        };
        let hint = if self.frames.is_empty() {
            msg!("interp.hint-end-main", name(Code::EndRewind))
        } else {
            msg!("interp.hint-end-sub", name(Code::SubEnd))
        };
        let number = program.map_or(0, |program| program.number).to_string();
        let name = program.and_then(|program| program.name).map(|name| cx.deck.text(Some(name)).to_owned());
        let message = msg!("interp.no-end", name.unwrap_or(number), cx.control.program_ends());
        self.fail(cx.shared, Trap::alarm(Alarm::NoProgramEnd, message).hint(hint))
    }

    fn block(&mut self, cx: &mut BlockContext, at: u32, block: &Block) -> Run<()> {
        if block.skip > 0 && cx.world.block_skip(block.skip) {
            self.counts.macros += 1;
            return Ok(());
        }
        if let Some(number) = block.number {
            self.modal.word(b'N', f64::from(number));
        }
        if let Stmt::Words { .. } = block.stmt {
            return self.words(cx, at, block, cx.deck.words_of(block));
        }
        match block.stmt {
            Stmt::Words { .. } | Stmt::Empty => {}
            Stmt::Assign { to, value } => self.assign(cx, block, to, value)?,
            Stmt::If { cond, target, .. } => {
                if self.number(cx, cond)? != 0.0 {
                    self.go_to(cx, at, target)?;
                }
            }
            Stmt::Assigns { first, count } => {
                for pair in cx.deck.pairs_of(first, count) {
                    self.assign(cx, block, pair.left, pair.right)?;
                }
            }
            Stmt::Ifs { first, count } => {
                for pair in cx.deck.pairs_of(first, count) {
                    if self.number(cx, pair.left)? != 0.0 {
                        self.go_to(cx, at, pair.right)?;
                        break;
                    }
                }
            }
            Stmt::Call { name, repeats } => self.call_named(cx, name, repeats)?,
            Stmt::Message(text) => self.queue.push(Canon::Show { text: cx.deck.text(text).to_owned() }),
            Stmt::IfThen { cond, to, value } => {
                if self.number(cx, cond)? != 0.0 {
                    self.assign(cx, block, to, value)?;
                }
            }
            Stmt::Goto { target, .. } => self.go_to(cx, at, target)?,
            Stmt::While { cond, .. } => {
                let end = self.partner(cx, at)?;
                let goes_on = match cond {
                    Some(cond) => self.number(cx, cond)? != 0.0,
                    None => true,
                };
                if !goes_on {
                    self.at = end.saturating_add(1);
                }
            }
            Stmt::End { .. } => self.at = self.partner(cx, at)?,
            Stmt::Bad(alarm) => return Err(self.bad_block(cx, block, alarm)),
        }
        self.counts.macros += 1;
        Ok(())
    }

    /// The alarm of a block that could not be read, in the words of who read it.
    #[cold]
    fn bad_block(&self, cx: &BlockContext, block: &Block, alarm: Alarm) -> Trap {
        let here = |place: Place| {
            place.file == self.file && block.span.start <= place.span.start && place.span.end <= block.span.end
        };
        let number = cx.control.alarm_number(alarm);
        let said = |finding: &&Diagnostic| finding.alarm.as_deref() == number && finding.place.is_some_and(here);
        match cx.shared.parsed.diagnostics().iter().find(said) {
            Some(finding) => Trap::repeat(alarm, finding),
            None => Trap::alarm(alarm, msg!("interp.bad-block")),
        }
    }

    /// The END of the DO in a block, or the DO of its END.
    fn partner(&self, cx: &BlockContext, at: u32) -> Run<u32> {
        match cx.shared.index.partner(self.program, at) {
            Partner::Block(partner) => Ok(partner),
            Partner::Fault(Alarm::DoNesting) => {
                let depth = u32::from(cx.control.syntax.do_depth);
                Err(Trap::alarm(Alarm::DoNesting, msg!("interp.do-nesting", depth)))
            }
            Partner::Fault(alarm) => Err(Trap::alarm(alarm, msg!("interp.do-pair"))),
        }
    }

    pub(super) fn go_to(&mut self, cx: &mut BlockContext, from: u32, target: ExprId) -> Run<()> {
        if cx.control.syntax.names().is_some() {
            self.at = cx
                .shared
                .index
                .target(target)
                .ok_or_else(|| Trap::alarm(Alarm::NoSequence, msg!("interp.no-label")).part(target))?;
            return Ok(());
        }
        let number = self.number(cx, target)?;
        self.go_to_number(cx, from, number).map_err(|trap| trap.part(target))
    }

    /// Goes on at a sequence number of the running program; `from` is the block that jumps.
    pub(super) fn go_to_number(&mut self, cx: &BlockContext, from: u32, number: f64) -> Run<()> {
        // A calculated number may miss the whole one by a last digit; no block has a number with decimals.
        let whole = (number - number.round()).abs() < WHOLE;
        let number = if whole { number.round() } else { number };
        if !cx.control.syntax.sequence_numbers().contains(&number) {
            return Err(Trap::alarm(Alarm::JumpNumber, msg!("interp.no-sequence", (number, 9))).behind(b"P"));
        }
        let found = || cx.shared.index.sequence(self.program, number as u32, from.saturating_add(1));
        let Some(to) = whole.then(found).flatten() else {
            return Err(Trap::alarm(Alarm::NoSequence, msg!("interp.no-sequence", (number, 9))).behind(b"P"));
        };
        if cx.shared.index.enters_loop(self.program, from, to) {
            return Err(Trap::alarm(Alarm::IntoLoop, msg!("interp.into-loop", (number, 0))));
        }
        self.at = to;
        Ok(())
    }
}
