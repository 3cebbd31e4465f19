//! Occurrences of programs, blocks and variables in a program, for definitions, references and outlines in an editor.

use std::collections::{BTreeMap, BTreeSet};

use super::ast::{Assignment, Block, Deck, Expr, ExprId, Jump, JumpDirection, Program, Stmt, TextId, Word, WordValue};
use super::block_index::{SequenceNumbers, labels_of};
use super::dec::Dec;
use super::lex::tokens::{TokenKind, tokens};
use super::parsed::Parsed;
use super::program_names::{ProgramNames, split_repeats};
use crate::controls::macros::{ARGUMENT, CallKind};
use crate::controls::syntax::Operation;
use crate::controls::{Address, Code, Control, VarKind};
use crate::text::{FileId, Place, Span};

/// A named object of programs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Symbol {
    /// A program, by its index in the deck.
    Program(u32),
    /// A block with a number or a label, by its index in the deck.
    Block(u32),
    /// A variable common to all programs.
    Variable(u32),
    /// A local variable of programs that share a level.
    Local {
        /// Index of the first of these programs.
        program: u32,
        /// Number of the variable.
        number: u32,
    },
}

/// Role of an occurrence of a symbol.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Role {
    /// Program header, block number or label.
    Definition,
    /// Assignment of the variable.
    Write,
    /// Argument of a call, which sets the variable of the called program.
    Argument,
    /// Reading of the variable.
    Read,
    /// Jump to the block, or another use of its number.
    Jump,
    /// Call of the program.
    Call,
}

/// One occurrence of a symbol.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Occurrence {
    /// The bytes of the name.
    pub place: Place,
    /// The symbol.
    pub symbol: Symbol,
    /// Role of the occurrence.
    pub role: Role,
}

/// A program, a block or a variable in the outline of a file.
#[derive(Debug, Clone, PartialEq)]
pub struct OutlineItem {
    /// The symbol.
    pub symbol: Symbol,
    /// Name as written in the program.
    pub name: String,
    /// Title of the program, or text of the block.
    pub detail: String,
    /// All bytes of the program, or of the block.
    pub whole: Span,
    /// The bytes of the name.
    pub span: Span,
    /// Blocks and variables of a program.
    pub children: Vec<OutlineItem>,
}

/// All occurrences of symbols in a set of files.
#[derive(Debug, Clone)]
pub struct Symbols {
    /// In the order of the text.
    all: Vec<Occurrence>,
    /// Definition of each symbol: header of a program, number or label of a block, first assignment of a variable.
    defined: BTreeMap<Symbol, Place>,
}

impl Symbols {
    /// Collects the occurrences of a deck.
    pub fn new(parsed: &Parsed) -> Symbols {
        let mut reader = SymbolReader::new(parsed);
        for (index, program) in parsed.deck.programs.iter().enumerate() {
            reader.program(index as u32, program);
        }
        let all = reader.finish();
        let mut defined = BTreeMap::new();
        for wanted in [&[Role::Definition][..], &[Role::Write, Role::Argument]] {
            for row in all.iter().filter(|row| wanted.contains(&row.role)) {
                defined.entry(row.symbol).or_insert(row.place);
            }
        }
        Symbols { all, defined }
    }

    /// The narrowest occurrence at a byte of a file; the position directly after a name counts too.
    pub fn at(&self, file: FileId, byte: u32) -> Option<Occurrence> {
        let here = self.all.iter().filter(|row| {
            let Span { start, end } = row.place.span;
            row.place.file == file && (start..=end).contains(&byte)
        });
        // A name that begins at the byte comes before one that ends there.
        here.min_by_key(|row| (row.place.span.end == byte, row.place.span.end - row.place.span.start)).copied()
    }

    /// All occurrences of a symbol, in text order.
    pub fn of(&self, symbol: Symbol) -> impl Iterator<Item = &Occurrence> {
        self.all.iter().filter(move |row| row.symbol == symbol)
    }

    /// Definition of a symbol: header of a program, number or label of a block, first assignment of a variable.
    pub fn definition(&self, symbol: Symbol) -> Option<Place> {
        self.defined.get(&symbol).copied()
    }

    /// Numbers of all variables that occur.
    pub fn variables(&self) -> BTreeSet<u32> {
        let number = |row: &Occurrence| match row.symbol {
            Symbol::Variable(number) | Symbol::Local { number, .. } => Some(number),
            _ => None,
        };
        self.all.iter().filter_map(number).collect()
    }

    /// Outline of a file: programs, and below each of them the blocks with labels, calls or jumps to them, and the first assignment of each
    /// variable.
    pub fn outline(&self, parsed: &Parsed, file: FileId) -> Vec<OutlineItem> {
        let deck = &parsed.deck;
        let targets: BTreeSet<Symbol> =
            self.all.iter().filter(|row| row.role == Role::Jump).map(|row| row.symbol).collect();
        let programs = deck.programs.iter().enumerate().filter(|(_, program)| program.file == file);
        let entry = |(index, program): (usize, &Program)| {
            let symbol = Symbol::Program(index as u32);
            let span = self.definition(symbol)?.span;
            let blocks = deck.blocks_of(program);
            let whole = blocks.last().map_or(span, |last| span.to(last.span));
            let mut assigned = BTreeSet::new();
            let mut children = Vec::new();
            for (at, block) in (program.first..).zip(blocks) {
                let from = (file, block.span.start);
                let first = self.all.partition_point(|row| (row.place.file, row.place.span.start) < from);
                let inside = self.all.get(first..).unwrap_or_default().iter();
                let inside = inside.take_while(|row| row.place.file == file && row.place.span.start < block.span.end);
                let calls = inside.clone().any(|row| row.role == Role::Call);
                let own = inside.clone().find(|row| row.symbol == Symbol::Block(at));
                let named = own.filter(|_| calls || block.label.is_some() || targets.contains(&Symbol::Block(at)));
                let sets = inside.filter(|row| row.role == Role::Write && assigned.insert(row.symbol));
                children.extend(named.into_iter().chain(sets).map(|row| OutlineItem {
                    symbol: row.symbol,
                    name: parsed.text(row.place).to_owned(),
                    detail: parsed.text(Place { file, span: block.span }).to_owned(),
                    whole: block.span,
                    span: row.place.span,
                    children: Vec::new(),
                }));
            }
            let name = match deck.text(program.name) {
                "" => parsed.text(Place { file, span }).to_owned(),
                name => name.to_owned(),
            };
            let name = if name.is_empty() { parsed.files.get(file)?.name.clone() } else { name };
            Some(OutlineItem { symbol, name, detail: deck.text(program.title).to_owned(), whole, span, children })
        };
        programs.filter_map(entry).collect()
    }
}

/// A block number that is resolved when all calls are known.
struct Return {
    place: Place,
    number: u32,
    /// The returning program: the number belongs to one of its callers.
    from: u32,
}

struct SymbolReader<'a> {
    parsed: &'a Parsed,
    deck: &'a Deck,
    control: &'static Control,
    names: ProgramNames<'a>,
    /// Numbered blocks of each program.
    numbers: Vec<SequenceNumbers>,
    /// Blocks of the labels of each program.
    labels: Vec<BTreeMap<&'a str, Vec<usize>>>,
    found: Vec<Occurrence>,
    returns: Vec<Return>,
    /// Called programs and their callers.
    calls: Vec<(u32, u32)>,
    /// First of the programs that share local variables, by program.
    level: Vec<u32>,
}

/// The block being read.
#[derive(Clone, Copy)]
struct Here<'a> {
    program: u32,
    file: FileId,
    /// Index of the block in its program.
    at: usize,
    block: &'a Block,
}

impl<'a> SymbolReader<'a> {
    fn new(parsed: &'a Parsed) -> SymbolReader<'a> {
        let deck = &parsed.deck;
        let programs = || deck.programs.iter().map(|program| deck.blocks_of(program));
        SymbolReader {
            parsed,
            deck,
            control: parsed.control,
            names: ProgramNames::new(deck),
            numbers: programs().map(|blocks| SequenceNumbers::new(blocks, 0)).collect(),
            labels: programs().map(|blocks| labels_of(deck, blocks)).collect(),
            found: Vec::new(),
            returns: Vec::new(),
            calls: Vec::new(),
            level: (0..deck.programs.len() as u32).collect(),
        }
    }

    fn add(&mut self, place: Place, symbol: Symbol, role: Role) {
        self.found.push(Occurrence { place, symbol, role });
    }

    fn program(&mut self, index: u32, program: &Program) {
        let file = program.file;
        self.add(Place { file, span: program.span }, Symbol::Program(index), Role::Definition);
        let deck = self.deck;
        for (at, block) in deck.blocks_of(program).iter().enumerate() {
            let here = Here { program: index, file, at, block };
            self.own_name(here, program.first + at as u32);
            match block.stmt {
                Stmt::Words { .. } => self.words(here, deck.words_of(block)),
                Stmt::Bad(_) => self.unread(here),
                Stmt::Call { name, repeats } => self.call_by_name(here, name, repeats),
                Stmt::IfThen { cond, to, value } => {
                    self.read(here, cond);
                    self.read(here, value);
                    self.write(here, to);
                }
                Stmt::While { cond: Some(cond), .. } => self.read(here, cond),
                stmt => {
                    for Assignment { to, value } in deck.assignments_of(stmt) {
                        self.read(here, value);
                        self.write(here, to);
                    }
                    for Jump { cond, target, way, .. } in deck.jumps_of(stmt) {
                        cond.into_iter().for_each(|cond| self.read(here, cond));
                        let to = match deck.expr(target) {
                            Expr::Number(number) => self.numbered(index, number, at, way),
                            Expr::Label(name) => {
                                let labels = self.labels.get(index as usize);
                                let places = labels.and_then(|labels| labels.get(deck.text(Some(name))));
                                places.and_then(|places| way.nearest(at, places)).map(|to| to as u32)
                            }
                            _ => None,
                        };
                        match (to, self.span(here, target)) {
                            (Some(to), Some(place)) => {
                                self.add(place, Symbol::Block(program.first + to), Role::Jump);
                            }
                            _ => self.read(here, target),
                        }
                    }
                }
            }
        }
    }

    /// Records number and label of a block.
    fn own_name(&mut self, here: Here, at: u32) {
        let number = here.block.number.map(|_| here.block.number_at.span(here.block));
        let label = here.block.label.map(|label| self.parsed.text_span(label));
        for span in number.into_iter().chain(label) {
            self.add(Place { file: here.file, span }, Symbol::Block(at), Role::Definition);
        }
    }

    /// Tokens of a block, with their places in the file.
    fn pieces(&self, here: Here) -> Vec<(Span, TokenKind)> {
        let start = here.block.span.start;
        let text = self.parsed.text(Place { file: here.file, span: here.block.span });
        let moved = |(span, kind): (Span, TokenKind)| (Span::new(start + span.start, start + span.end), kind);
        tokens(text, self.control).into_iter().map(moved).collect()
    }

    /// The place of an expression of a block.
    fn span(&self, here: Here, id: ExprId) -> Option<Place> {
        let span = self.parsed.expr_span(Place { file: here.file, span: here.block.span }, id)?;
        Some(Place { file: here.file, span })
    }

    fn variable(&self, program: u32, number: u32) -> Symbol {
        match self.control.var(number) {
            Some(row) if row.kind == VarKind::Local => Symbol::Local { program, number },
            _ => Symbol::Variable(number),
        }
    }

    /// Records the variables of a formula.
    fn read(&mut self, here: Here, id: ExprId) {
        match self.deck.expr(id) {
            Expr::Var(number) => {
                if let Some(place) = self.span(here, id) {
                    self.add(place, self.variable(here.program, number), Role::Read);
                }
            }
            Expr::Indirect(inner) | Expr::Negate(inner) | Expr::Call(_, inner) => self.read(here, inner),
            Expr::Binary(_, left, right) => {
                self.read(here, left);
                self.read(here, right);
            }
            Expr::Number(_) | Expr::Label(_) => {}
        }
    }

    fn write(&mut self, here: Here, id: ExprId) {
        match (self.deck.expr(id), self.span(here, id)) {
            (Expr::Var(number), Some(place)) => self.add(place, self.variable(here.program, number), Role::Write),
            _ => self.read(here, id),
        }
    }

    /// Records the variables of a block that does not parse.
    fn unread(&mut self, here: Here) {
        for (span, kind) in self.pieces(here) {
            let place = Place { file: here.file, span };
            let number = self.parsed.text(place).get(1..).and_then(|digits| digits.parse().ok());
            if let (TokenKind::Variable, Some(number)) = (kind, number) {
                self.add(place, self.variable(here.program, number), Role::Read);
            }
        }
    }

    fn call_by_name(&mut self, here: Here, name: TextId, repeats: Option<ExprId>) {
        repeats.into_iter().for_each(|repeats| self.read(here, repeats));
        let (deck, span) = (self.deck, self.parsed.text_span(name));
        let name = deck.text(Some(name));
        let Some(to) = self.names.name(name).or_else(|| deck.program_named(name)) else { return };
        self.add(Place { file: here.file, span }, Symbol::Program(to), Role::Call);
        self.calls.push((to, here.program));
    }

    /// The block of a program that a jump to a number in block `from` finds.
    fn numbered(&self, program: u32, number: Dec, from: usize, way: JumpDirection) -> Option<u32> {
        let number = number.to_f64();
        let whole = number.fract() == 0.0 && (0.0..4e9).contains(&number);
        let numbers = self.numbers.get(program as usize).filter(|_| whole)?;
        numbers.target(number as u32, from as u32, way)
    }

    /// Records a word that refers to a block of a program by its number.
    fn names_block(&mut self, here: Here, word: &Word, program: u32, from: usize) {
        let WordValue::Number(number) = word.value else { return };
        let to = self.numbered(program, number, from, JumpDirection::Around);
        let first = self.deck.programs.get(program as usize).map(|program| program.first);
        if let (Some(to), Some(first)) = (to, first) {
            let place = Place { file: here.file, span: word.span(here.block) };
            self.add(place, Symbol::Block(first + to), Role::Jump);
        }
    }

    /// Records the variables, calls and references to blocks of NC words.
    fn words(&mut self, here: Here, words: &[Word]) {
        let word = |letter: Address| words.iter().rfind(|word| word.letter == letter);
        let codes = &self.parsed.codes;
        let code =
            |wanted: &[Code]| words.iter().any(|word| codes.row_of(word).is_some_and(|row| wanted.contains(&row.code)));
        let function = word(Address::H).filter(|_| code(&[Code::MacroCall])).and_then(|word| {
            let WordValue::Number(number) = word.value else { return None };
            let row = self.control.macros.functions.iter().find(|row| f64::from(row.0) == number.to_f64());
            row.map(|row| row.1)
        });
        let sets =
            |word: &Word| word.letter == Address::P && function.is_some_and(|it| !it.jumps() && it != Operation::Alarm);
        for word in words {
            if let WordValue::Expr(id) = word.value {
                if sets(word) { self.write(here, id) } else { self.read(here, id) }
            }
        }
        if let Some(function) = function {
            if let Some(word) = word(Address::P).filter(|_| function.jumps()) {
                self.names_block(here, word, here.program, here.at);
            }
            return;
        }
        if let Some((by, call)) = words.iter().find_map(|word| Some((word, codes.call_of(word)?))) {
            self.call(here, words, by, self.names.number(call.program), call.kind);
        } else if code(&[Code::MacroCall, Code::MacroModal, Code::MacroModalBlock]) {
            let to = word(Address::P).and_then(|word| self.program_of(word, CallKind::Macro));
            word(Address::P).into_iter().for_each(|by| self.call(here, words, by, to, CallKind::Macro));
        } else if code(&[Code::SubCall]) {
            let to = word(Address::P).and_then(|word| self.program_of(word, CallKind::Sub));
            word(Address::P).into_iter().for_each(|by| self.call(here, words, by, to, CallKind::Sub));
            if let Some(entry) = word(Address::H).filter(|_| self.control.macros.sub_sequence) {
                self.names_block(here, entry, to.unwrap_or(here.program), usize::MAX);
            }
        } else if code(&[Code::Roughing]) {
            for word in [Address::P, Address::Q].into_iter().filter_map(word) {
                self.names_block(here, word, here.program, here.at);
            }
        } else if code(&[Code::SubEnd])
            && let Some(Word { value: WordValue::Number(number), .. }) = word(Address::P)
            && let Some(place) = word(Address::P).map(|word| Place { file: here.file, span: word.span(here.block) })
        {
            self.returns.push(Return { place, number: number.to_f64() as u32, from: here.program });
        }
    }

    /// Index of the program with the number in P; repeats of a subprogram may precede the number.
    fn program_of(&self, word: &Word, kind: CallKind) -> Option<u32> {
        let WordValue::Number(number) = word.value else { return None };
        let number = number.to_f64();
        let whole = (number.fract() == 0.0 && (1.0..4e9).contains(&number)).then_some(number as u32)?;
        let repeats = kind == CallKind::Sub && self.control.macros.repeats_in_p;
        self.names.number(whole).or_else(|| self.names.number(split_repeats(whole).1).filter(|_| repeats))
    }

    /// Records a call of a program by a word.
    fn call(&mut self, here: Here, words: &[Word], by: &Word, to: Option<u32>, kind: CallKind) {
        let Some(to) = to else { return };
        self.add(Place { file: here.file, span: by.span(here.block) }, Symbol::Program(to), Role::Call);
        self.calls.push((to, here.program));
        if kind == CallKind::Sub {
            let (from, to) = (self.level_of(here.program), self.level_of(to));
            if let Some(level) = self.level.get_mut(from.max(to) as usize) {
                *level = from.min(to);
            }
            return;
        }
        // A second I, J or K is an argument of another set.
        let once = |letter: Address| words.iter().filter(|word| word.letter == letter).count() == 1;
        for word in words {
            let number = ARGUMENT.get(word.letter as usize).map_or(0, |&number| u32::from(number));
            let other =
                matches!(word.letter, Address::G | Address::L | Address::M | Address::N | Address::O | Address::P);
            if number != 0 && !other && once(word.letter) && word.span(here.block) != by.span(here.block) {
                let place = Place { file: here.file, span: word.span(here.block) };
                self.add(place, self.variable(to, number), Role::Argument);
            }
        }
    }

    /// First of the programs that share local variables with a program, with path halving.
    fn level_of(&mut self, program: u32) -> u32 {
        let mut at = program as usize;
        while let Some(&next) = self.level.get(at).filter(|next| **next as usize != at) {
            let beyond = self.level.get(next as usize).copied().unwrap_or(next);
            if let Some(level) = self.level.get_mut(at) {
                *level = beyond;
            }
            at = beyond as usize;
        }
        at as u32
    }

    /// All occurrences, in text order.
    fn finish(mut self) -> Vec<Occurrence> {
        self.calls.sort_unstable();
        self.calls.dedup();
        for Return { place, number, from } in core::mem::take(&mut self.returns) {
            let first = self.calls.partition_point(|call| call.0 < from);
            let callers = self.calls.get(first..).unwrap_or_default().iter().take_while(|call| call.0 == from);
            let found = callers.filter_map(|&(_, caller)| {
                let at = self.numbers.get(caller as usize)?.find(number, 0)?;
                Some(self.deck.programs.get(caller as usize)?.first + at)
            });
            if let Some(block) = found.min() {
                self.add(place, Symbol::Block(block), Role::Jump);
            }
        }
        let levels: Vec<u32> = (0..self.level.len() as u32).map(|program| self.level_of(program)).collect();
        for row in &mut self.found {
            if let Symbol::Local { program, .. } = &mut row.symbol {
                *program = levels.get(*program as usize).copied().unwrap_or(*program);
            }
        }
        self.found.sort_by_key(|row| (row.place.file, row.place.span.start));
        self.found
    }
}
