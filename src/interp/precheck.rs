//! Static pre-check: interprets each block in isolation with constants only and reports the alarms that any run would raise.

use crate::controls::Address;
use std::cell::RefCell;
use std::mem;
use std::rc::Rc;

use super::context::BlockContext;
use super::error::{Run, Trap};
use super::modal::Modal;
use super::state::RunState;
use super::world::{Still, World};
use super::{Interp, StartProgram};
use crate::controls::macros::CallKind;
use crate::controls::{Alarm, Code, CodeDef, Group, VarKind};
use crate::nc::{Block, Dec, Expr, ExprId, Parsed, Stmt, Word, WordValue};
use crate::text::{Diagnostic, DiagnosticKind, Place, Severity};

/// Findings that are listed.
const FINDINGS: usize = 1000;

/// Findings after which nothing is listed but alarms.
const REMARKS: usize = 200;

/// The alarms that blocks of read programs will raise whenever they run, and what the run will remark of them, in the order of the text:
/// where a block depends on what is not known before, nothing is said. What the reader has said of a block stands for all of it.
pub fn precheck(parsed: &Rc<Parsed>) -> Vec<Diagnostic> {
    let Interp { shared, state } = Interp::new(Rc::clone(parsed), StartProgram::First);
    let deck = parsed.deck();
    let heard = RefCell::new(Vec::new());
    let mut world = Listener { still: Still::default(), heard: &heard };
    let cx = BlockContext { shared: &shared, control: shared.control, deck, world: &mut world, parts: 1.0 };
    let mut oracle = Oracle::new(cx, state, &heard);
    let errors = parsed.diagnostics().iter().filter(|finding| finding.severity == Severity::Error);
    let errors: Vec<Place> = errors.filter_map(|finding| finding.place).collect();
    let mut found: Vec<Diagnostic> = Vec::new();
    for (index, program) in deck.programs.iter().enumerate() {
        oracle.state.go_to_program(deck, index as u32);
        for (at, block) in (program.first..).zip(deck.blocks_of(program)) {
            oracle.block(at, block);
            let here = Place { file: program.file, span: block.span };
            if found.len() >= REMARKS {
                // Room is for what stops a run.
                oracle.told.retain(|finding| finding.severity == Severity::Error);
            }
            if !oracle.told.is_empty() && !errors.iter().any(|error| error.meets(here)) {
                found.append(&mut oracle.told);
            }
            oracle.told.clear();
            heard.take();
        }
        if found.len() >= FINDINGS {
            found.truncate(FINDINGS);
            break;
        }
    }
    Diagnostic::in_order(&mut found);
    found
}

/// Whether the meaning of words depends on this code.
fn matters(row: &CodeDef) -> bool {
    use Code::{FeedPerMinute, FeedPerRevolution, Inch, Metric, SurfaceSpeed, SurfaceSpeedOff};
    matches!(row.group, Group::Motion | Group::Cycle)
        || matches!(row.code, FeedPerMinute | FeedPerRevolution | Inch | Metric | SurfaceSpeed | SurfaceSpeedOff)
}

/// What [`matters`] of a modal state.
fn key(modal: &Modal) -> ([bool; 5], u8) {
    let words = match modal.motion {
        _ if modal.cycle => 0,
        Code::NotSimulated => 0,
        Code::Thread => 1,
        Code::ArcCw | Code::ArcCcw => 2,
        Code::ArcThrough | Code::ArcTangent => 4,
        Code::Tapping => 5,
        _ => 3,
    };
    let leads = matches!(modal.motion, Code::Thread | Code::Tapping);
    ([modal.inch, modal.inch_feed, modal.per_revolution, modal.spindle.surface, leads], words)
}

/// What a block of words does that can be known before, beyond its values.
const ACTS: [Alarm; 15] = [
    // Behind H; what stands behind P of a return is looked for in the program that has called.
    Alarm::NoSequence,
    // Known where P is.
    Alarm::JumpNumber,
    Alarm::RepeatRange,
    Alarm::NoCallProgram,
    Alarm::OwnCall,
    Alarm::SpindleAngle,
    Alarm::SurfaceRange,
    // Functions by number.
    Alarm::DivisionByZero,
    Alarm::Calculation,
    Alarm::SquareRoot,
    Alarm::Tangent,
    Alarm::Overflow,
    Alarm::NotWhole,
    Alarm::ReadOnly,
    Alarm::VacantWritten,
];

/// What writing to a variable comes to; its own alarm a program means to raise.
const WRITES: [Alarm; 4] = [Alarm::VariableRange, Alarm::ReadOnly, Alarm::VacantWritten, Alarm::VariableSide];

/// A machine at rest that keeps what is remarked.
struct Listener<'a> {
    still: Still,
    heard: &'a RefCell<Vec<Diagnostic>>,
}

impl World for Listener<'_> {
    fn input(&mut self, variable: u32) -> f64 {
        self.still.input(variable)
    }

    fn clock_ms(&mut self, run: bool) -> f64 {
        self.still.clock_ms(run)
    }

    fn position(&mut self, axis: usize) -> f64 {
        self.still.position(axis)
    }

    fn block_skip(&mut self, number: u8) -> bool {
        self.still.block_skip(number)
    }

    fn remark(&mut self, remark: Diagnostic) {
        self.heard.borrow_mut().push(remark);
    }
}

struct Oracle<'a> {
    cx: BlockContext<'a>,
    /// Remarks since they were last taken.
    heard: &'a RefCell<Vec<Diagnostic>>,
    /// A run that does no more than read its blocks, in the order of the text.
    state: RunState,
    /// Of each expression, whether it has the same value in every run.
    constant: Vec<bool>,
    /// The modal states that blocks can meet, as far as they matter.
    modals: Vec<Modal>,
    /// Words are what they look like: no modal call takes them for its arguments.
    words: bool,
    /// What is wrong with the block at hand.
    told: Vec<Diagnostic>,
    /// The block of words before, where nothing was to be said of it.
    clean: Vec<Clean>,
}

/// Cache: a word already checked without findings, and the value range for which that holds.
struct Clean {
    word: Word,
    least: i64,
    most: i64,
    /// Whether the range may grow: true for lengths and feeds; any other number may have a meaning of its own.
    ranges: bool,
}

impl Clean {
    /// Whether a word differs from this one in its value at most.
    fn is_like(&self, word: &Word) -> bool {
        let (WordValue::Number(a), WordValue::Number(b)) = (self.word.value, word.value) else { return false };
        (self.word.letter, self.word.index, self.word.form, a.scale, a.point)
            == (word.letter, word.index, word.form, b.scale, b.point)
            && (self.ranges || a.mantissa == b.mantissa)
    }

    fn holds(&self, word: &Word) -> bool {
        matches!(word.value, WordValue::Number(n) if (self.least..=self.most).contains(&n.mantissa))
            && self.is_like(word)
    }
}

impl<'a> Oracle<'a> {
    fn new(cx: BlockContext<'a>, state: RunState, heard: &'a RefCell<Vec<Diagnostic>>) -> Oracle<'a> {
        let mut constant: Vec<bool> = Vec::with_capacity(cx.deck.exprs.len());
        for expr in &cx.deck.exprs {
            let known = |id: &ExprId| constant.get(id.0 as usize).copied().unwrap_or(false);
            constant.push(match expr {
                Expr::Number(_) => true,
                Expr::Var(number) => cx.control.var(*number).is_some_and(|row| row.kind == VarKind::Vacant),
                Expr::Label(_) | Expr::Indirect(_) => false,
                Expr::Negate(x) | Expr::Call(_, x) => known(x),
                Expr::Binary(_, left, right) => known(left) && known(right),
            });
        }
        let modals = vec![state.modal.clone()];
        let mut oracle =
            Oracle { cx, heard, state, constant, modals, words: true, told: Vec::new(), clean: Vec::new() };
        oracle.note_codes();
        oracle
    }

    /// Finds the modal states that the codes of all programs can bring about.
    fn note_codes(&mut self) {
        let control = self.cx.control;
        let mut rows: Vec<&CodeDef> = Vec::new();
        let mut any = false;
        for word in self.cx.deck.words.iter().filter(|word| is_code(word)) {
            let WordValue::Number(_) = word.value else {
                any = true;
                continue;
            };
            if let Some(row) = self.cx.codes().row_of(word) {
                self.words &= row.code != Code::MacroModalBlock;
                if matters(row) && !rows.iter().any(|other| core::ptr::eq(*other, row)) {
                    rows.push(row);
                }
            }
        }
        self.words &= self.cx.codes().calls().iter().all(|call| call.kind != CallKind::ModalBlock);
        if any {
            rows = control.codes.iter().filter(|row| matters(row)).collect();
        }
        let mut at = 0;
        while let Some(modal) = self.modals.get(at).cloned() {
            for row in &rows {
                let mut next = modal.clone();
                next.set(control, row);
                if self.modals.iter().all(|other| key(other) != key(&next)) {
                    self.modals.push(next);
                }
            }
            at += 1;
        }
    }

    /// Notes what is wrong with a block in every run.
    fn block(&mut self, at: u32, block: &Block) {
        let deck = self.cx.deck;
        match block.stmt {
            Stmt::Words { .. } => {
                let words = deck.words_of(block);
                for word in words {
                    if let WordValue::Expr(id) = word.value {
                        self.formula(block, id);
                    }
                }
                if self.words {
                    self.block_words(at, block, words);
                }
            }
            Stmt::IfThen { cond, to, value } => {
                self.formula(block, cond);
                self.formula(block, value);
                self.assigned(block, to, value);
            }
            Stmt::While { cond, .. } => cond.into_iter().for_each(|id| self.formula(block, id)),
            Stmt::Call { repeats, .. } => repeats.into_iter().for_each(|id| self.formula(block, id)),
            stmt => {
                for (to, value) in deck.assigned_in(stmt) {
                    self.formula(block, value);
                    self.assigned(block, to, value);
                }
                for (cond, target, _) in deck.jumps_of(stmt) {
                    cond.into_iter().chain([target]).for_each(|id| self.formula(block, id));
                    if self.is_constant(target) {
                        let jumped = self.state.go_to(&mut self.cx, at, target);
                        self.tell(
                            block,
                            jumped,
                            &[Alarm::IntoLoop, Alarm::JumpNumber, Alarm::GotoTarget, Alarm::NoSequence],
                        );
                    }
                }
            }
        }
    }

    fn is_constant(&self, id: ExprId) -> bool {
        self.constant.get(id.0 as usize).copied().unwrap_or(false)
    }

    /// What a run says that ends in one of these alarms, or in any where none are named.
    fn finding(&self, block: &Block, outcome: Run<()>, alarms: &[Alarm]) -> Option<Diagnostic> {
        let Err(Trap::Alarm(mut fault)) = outcome else { return None };
        if !alarms.is_empty() && !alarms.contains(&fault.kind()) {
            return None;
        }
        fault.locate(self.cx.deck, block);
        Some(fault.diagnostic(&self.cx.shared.parsed, Place { file: self.state.file, span: block.span }))
    }

    fn tell(&mut self, block: &Block, outcome: Run<()>, alarms: &[Alarm]) {
        let finding = self.finding(block, outcome, alarms);
        self.note(finding);
    }

    /// Keeps one finding per place.
    fn note(&mut self, finding: Option<Diagnostic>) {
        self.told.extend(finding.filter(|finding| self.told.iter().all(|other| other.place != finding.place)));
    }

    /// Writes to the variable of an assignment, where it is known and more than a store.
    fn assigned(&mut self, block: &Block, to: ExprId, value: ExprId) {
        use VarKind::{Common, Kept, Local, Retained};
        let kept = |number| {
            self.cx.control.var(number).is_some_and(|row| matches!(row.kind, Local | Common | Retained | Kept))
        };
        match self.cx.deck.expr(to) {
            Expr::Var(number) if kept(number) => return,
            Expr::Indirect(x) => {
                self.formula(block, x);
                if !self.is_constant(x) {
                    return;
                }
            }
            _ => {}
        }
        let mut state = self.state.clone();
        let outcome = if self.is_constant(value) {
            state.assign(&mut self.cx, block, to, value)
        } else {
            let number = state.variable_of(&mut self.cx, to);
            number.and_then(|number| state.write(&mut self.cx, block, number, 0.0).map_err(|trap| trap.part(to)))
        };
        match outcome {
            // Another value may be remarked or not.
            Ok(()) if self.is_constant(value) => self.told.extend(self.heard.take()),
            outcome => self.tell(block, outcome, &WRITES),
        }
    }

    /// Calculates the constant parts of a formula.
    fn formula(&mut self, block: &Block, id: ExprId) {
        let expr = self.cx.deck.expr(id);
        if self.is_constant(id) {
            if !matches!(expr, Expr::Number(_) | Expr::Var(_)) {
                let value = self.state.value(&mut self.cx, id).map(|_| ());
                self.tell(block, value, &[]);
            }
            return;
        }
        match expr {
            Expr::Number(_) | Expr::Label(_) | Expr::Var(_) => {}
            Expr::Indirect(x) if self.is_constant(x) => {
                let value = self.state.value(&mut self.cx, id).map(|_| ());
                self.tell(block, value, &[]);
            }
            Expr::Indirect(x) | Expr::Negate(x) | Expr::Call(_, x) => self.formula(block, x),
            Expr::Binary(op, left, right) => {
                self.formula(block, left);
                if self.is_constant(right) {
                    let value = self.state.operand(&mut self.cx, op, right);
                    self.tell(block, value, &[]);
                } else {
                    self.formula(block, right);
                }
            }
        }
    }

    fn is_known(&self, word: &Word) -> bool {
        match word.value {
            WordValue::Number(_) => true,
            WordValue::Expr(id) => self.is_constant(id),
        }
    }

    /// Notes that nothing is to be said of a block; `before` is what it was for the blocks in front of it.
    fn note_clean(&mut self, words: &[Word], before: Vec<Clean>) {
        self.clean = before;
        if self.clean.len() != words.len() || !self.clean.iter().zip(words).all(|(clean, word)| clean.is_like(word)) {
            self.clean.clear();
        }
        for (at, word) in words.iter().enumerate() {
            let WordValue::Number(Dec { mantissa, .. }) = word.value else { return self.clean.clear() };
            match self.clean.get_mut(at) {
                Some(clean) => (clean.least, clean.most) = (clean.least.min(mantissa), clean.most.max(mantissa)),
                None => {
                    let ranges = matches!(word.letter, Address::F | Address::I | Address::J | Address::K)
                        || self.cx.shared.index.axis(word.letter).is_some();
                    self.clean.push(Clean { word: *word, least: mantissa, most: mantissa, ranges });
                }
            }
        }
    }

    fn block_words(&mut self, at: u32, block: &Block, words: &[Word]) {
        // Long programs repeat one form of block with other numbers. Its codes are in force already, and its numbers lie between such
        // of which nothing was to be said.
        if self.clean.len() == words.len() && self.clean.iter().zip(words).all(|(clean, word)| clean.holds(word)) {
            return;
        }
        let before = mem::take(&mut self.clean);
        let open = words.iter().filter(|word| !self.is_known(word));
        let (mut all, mut codes, mut results) = (true, true, true);
        for word in open {
            all = false;
            codes &= !is_code(word);
            results &= word.letter == Address::P;
        }
        // The meaning of the other words depends on the open code.
        if !codes {
            return;
        }
        let known: Vec<Word>;
        let told = if all {
            words
        } else {
            known = words.iter().filter(|word| self.is_known(word)).copied().collect();
            &known
        };
        self.heard.take();
        let read = self.state.read_words(&mut self.cx, block, told);
        let heard = self.heard.take();
        let quiet = heard.is_empty();
        if all && read.is_ok() && !quiet {
            self.remarked(block, words, heard);
        }
        match read {
            Ok(None) => {}
            // P of a function names its result.
            Ok(Some(calls)) => {
                if all && words.iter().any(|word| word.letter == Address::Q) {
                    self.contour(at, block, words);
                }
                let function = !all && results && calls && self.state.is_function(&self.cx, words);
                let spindle = || words.iter().any(|word| matches!(word.letter, Address::S | Address::Spos));
                if function || all && (calls || spindle()) {
                    let first = if !all { 2 } else { usize::from(words.iter().all(|word| word.letter != Address::H)) };
                    let acts = ACTS.get(first..).unwrap_or_default();
                    let finding = self.always(block, acts, &mut |state, cx| state.words(cx, at, block, words));
                    self.note(finding);
                } else if all && quiet {
                    self.note_clean(words, before);
                }
            }
            Err(_) => {
                let mut together =
                    |state: &mut RunState, cx: &mut BlockContext| state.read_words(cx, block, told).map(|_| ());
                let finding = self.always(block, &[Alarm::ArgumentSets], &mut together);
                self.note(finding);
                for (at, word) in told.iter().enumerate() {
                    let alone = told.iter().enumerate().filter(|row| row.0 == at || is_code(row.1));
                    let alone: Vec<Word> = alone.map(|row| *row.1).collect();
                    let span = word.span(block);
                    let finding =
                        self.always(block, &[], &mut |state, cx| state.read_words(cx, block, &alone).map(|_| ()));
                    let inside = |place: Place| span.start <= place.span.start && place.span.end <= span.end;
                    self.note(finding.filter(|finding| finding.place.is_some_and(inside)));
                }
            }
        }
    }

    /// The contour that a cycle passes over.
    fn contour(&mut self, at: u32, block: &Block, words: &[Word]) {
        // What else comes of it depends on the state.
        let _ = self.state.clone().words(&mut self.cx, at, block, words);
        self.told.extend(self.heard.take().into_iter().filter(|remark| remark.kind == DiagnosticKind::Contour));
    }

    /// What is remarked of a block in every modal state.
    fn remarked(&mut self, block: &Block, words: &[Word], mut heard: Vec<Diagnostic>) {
        for modal in &self.modals {
            let mut state = self.state.clone();
            state.modal.clone_from(modal);
            if state.read_words(&mut self.cx, block, words).is_err() {
                return;
            }
            let others = self.heard.take();
            heard.retain(|remark| others.contains(remark));
        }
        self.told.append(&mut heard);
    }

    /// What is said in every modal state: as the order of the text has it, and all others.
    fn always(
        &mut self,
        block: &Block,
        alarms: &[Alarm],
        run: &mut dyn FnMut(&mut RunState, &mut BlockContext) -> Run<()>,
    ) -> Option<Diagnostic> {
        let mut said: Option<Diagnostic> = None;
        for at in 0..=self.modals.len() {
            let mut state = self.state.clone();
            if let Some(modal) = at.checked_sub(1).and_then(|at| self.modals.get(at)) {
                state.modal.clone_from(modal);
            }
            let outcome = run(&mut state, &mut self.cx);
            let finding = self.finding(block, outcome, alarms)?;
            if said.as_ref().is_some_and(|said| (&said.alarm, said.place) != (&finding.alarm, finding.place)) {
                return None;
            }
            said.get_or_insert(finding);
        }
        said
    }
}

fn is_code(word: &Word) -> bool {
    matches!(word.letter, Address::G | Address::Name)
}
