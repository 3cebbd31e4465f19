//! One step of a run: the next command of the last block, or the next block.

use super::canon::Canon;
use super::context::{BlockContext, Shared};
use super::error::Trap;
use super::frame::CalledBy;
use super::state::RunState;
use super::step::{End, Step};
use super::world::World;
use crate::controls::{Alarm, Code};
use crate::msg;
use crate::text::{Place, Span};

impl RunState {
    /// Reads at most one block, or returns one more command of the last.
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
        match self.execute_block(&mut cx, at, block) {
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

    #[inline]
    fn hand_out(&mut self, shared: &Shared, canon: Canon) -> Step {
        if shared.executing {
            self.issued.note(&canon, &self.modal);
        }
        Step::Command(canon, self.place)
    }

    #[cold]
    pub(super) fn fail(&mut self, shared: &Shared, trap: Trap) -> Step {
        self.queue.clear();
        if let Trap::Alarm(fault) = trap {
            let own = fault.kind() == Alarm::User;
            let mut found = fault.diagnostic(&shared.parsed, self.place);
            if let Some((call, program)) = self.calling_block(shared).filter(|_| own) {
                found.place = Some(call);
                found.hints.push(msg!("interp.hint-raised-in", program));
            }
            self.ended = Some(End::Alarm(Box::new(found)));
        }
        self.over()
    }

    /// The block with the code that called the running program, and that program's number: alarms are located at the code's block.
    #[cold]
    fn calling_block(&self, shared: &Shared) -> Option<(Place, u32)> {
        let deck = shared.parsed.deck();
        let frame = self.frames.iter().find(|frame| frame.called_by == CalledBy::Code)?;
        let block = deck.blocks.get(frame.back.checked_sub(1)? as usize)?;
        let file = deck.programs.get(frame.program as usize)?.file;
        Some((Place { file, span: block.span }, deck.programs.get(self.program as usize)?.number))
    }

    #[cold]
    fn over(&self) -> Step {
        Step::Ended(self.ended.clone().unwrap_or(End::Program))
    }

    /// The blocks of the program are used up without a program end.
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
            msg!("interp.hint-end-main", code = name(Code::EndRewind))
        } else {
            msg!("interp.hint-end-sub", code = name(Code::SubEnd))
        };
        let number = program.map_or(0, |program| program.number).to_string();
        let name = program.and_then(|program| program.name).map(|name| cx.deck.text(Some(name)).to_owned());
        let message = msg!("interp.no-end", program = name.unwrap_or(number), code = cx.control.program_ends());
        self.fail(cx.shared, Trap::alarm(Alarm::NoProgramEnd, message).hint(hint))
    }
}
