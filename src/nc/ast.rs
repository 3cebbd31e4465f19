//! Syntax tree of programs as written, stored in arenas of small rows.
//!
//! Blocks and their parts keep their places in the text; built and rewritten ones have none.

use crate::controls::{Address, Alarm, Control, VarKind};
use core::num::NonZeroU32;

use super::dec::Dec;
use crate::controls::syntax::Function;
use crate::text::{FileId, Span};

/// Index of an expression in [`Deck::exprs`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct ExprId(pub u32);

/// A text of a deck: comment, message or name.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct TextId(NonZeroU32);

impl TextId {
    /// Index in [`Deck::texts`].
    pub(super) fn index(self) -> usize {
        self.0.get() as usize - 1
    }
}

/// All programs of all files.
#[derive(Debug, Clone, Default)]
pub struct Deck {
    /// Programs in file order.
    pub programs: Vec<Program>,
    /// Blocks of all programs, a program's blocks side by side.
    pub blocks: Vec<Block>,
    /// Words of all blocks, a block's words side by side.
    pub words: Vec<Word>,
    /// Expressions; children come before their parents.
    pub exprs: Vec<Expr>,
    /// Assignments of blocks with several of them, a block's side by side.
    pub assignments: Vec<Assignment>,
    /// Jumps of blocks with several of them, a block's side by side.
    pub jumps: Vec<Jump>,
    /// Comments and messages without brackets, names of programs and labels.
    pub texts: Vec<Box<str>>,
}

/// One program.
#[derive(Debug, Clone, PartialEq)]
pub struct Program {
    /// File that contains it.
    pub file: FileId,
    /// Number after `O`, or in a name such as `L9100`; 0 without one.
    pub number: u32,
    /// Name, in a language with names.
    pub name: Option<TextId>,
    /// Marked as a subprogram by its name.
    pub sub: bool,
    /// Comment after the program number.
    pub title: Option<TextId>,
    /// Place of the program number.
    pub span: Span,
    /// First block in [`Deck::blocks`].
    pub first: u32,
    /// One past the last block.
    pub end: u32,
}

/// One block.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Block {
    /// Bytes of the block without the line end; empty for a built block.
    pub span: Span,
    /// Sequence number.
    pub number: Option<u32>,
    /// Bytes of the sequence number with its `N` or `:`.
    pub number_at: Extent,
    /// Statement.
    pub stmt: Stmt,
    /// First comment in the block.
    pub comment: Option<TextId>,
    /// Label, in a language with labels.
    pub label: Option<TextId>,
    /// Optional block skip: 0 none, 1 `/` or `/1`, 2 `/2` ….
    pub skip: u8,
    /// Main block: its number is written after `:` instead of `N`.
    pub main: bool,
}

impl Block {
    /// A built block without content.
    pub(super) const EMPTY: Block = Block {
        span: Span { start: 0, end: 0 },
        number: None,
        number_at: Extent { offset: 0, len: 0 },
        stmt: Stmt::Empty,
        comment: None,
        label: None,
        skip: 0,
        main: false,
    };
}

/// Statement of a block.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Stmt {
    /// Only a number or a comment.
    Empty,
    /// NC words `words[first..first + count]`.
    Words {
        /// First word.
        first: u32,
        /// Number of words.
        count: u16,
    },
    /// `to = value`; `to` is [`Expr::Var`] or [`Expr::Indirect`].
    Assign {
        /// The variable.
        to: ExprId,
        /// New value of the variable.
        value: ExprId,
    },
    /// Several assignments `assignments[first..first + count]`, executed from left to right.
    Assigns {
        /// First assignment.
        first: u32,
        /// Number of assignments.
        count: u16,
    },
    /// `IF [cond] GOTO target`.
    If {
        /// The condition.
        cond: ExprId,
        /// Sequence number or [`Expr::Label`] to go to.
        target: ExprId,
        /// Direction of the search for the target.
        way: JumpDirection,
        /// Bytes of `GOTOF` or `GOTOB`; none of `GOTO`.
        keyword: Extent,
    },
    /// Several jumps with conditions `jumps[first..first + count]`; the first true condition jumps.
    Ifs {
        /// First jump.
        first: u32,
        /// Number of jumps.
        count: u16,
    },
    /// `IF [cond] THEN to = value`.
    IfThen {
        /// The condition.
        cond: ExprId,
        /// The variable.
        to: ExprId,
        /// New value of the variable.
        value: ExprId,
    },
    /// `GOTO target`.
    Goto {
        /// Sequence number or [`Expr::Label`] to go to.
        target: ExprId,
        /// Direction of the search for the target.
        way: JumpDirection,
        /// Bytes of `GOTOF` or `GOTOB`; none of `GOTO`.
        keyword: Extent,
    },
    /// A call of a program by its name.
    Call {
        /// The name.
        name: TextId,
        /// Number of runs; `None` is one.
        repeats: Option<ExprId>,
    },
    /// A message to the operator without a stop; `None` clears the last message.
    Message(Option<TextId>),
    /// `WHILE [cond] DO label`, or `DO label` without a condition.
    While {
        /// The condition; `None` is an endless loop.
        cond: Option<ExprId>,
        /// Number of the loop.
        label: u16,
        /// Bytes of `DO label`.
        keyword: Extent,
    },
    /// `END label`.
    End {
        /// Number of the loop.
        label: u16,
        /// Bytes of `END label`.
        keyword: Extent,
    },
    /// A block with an error; executing it raises its alarm.
    Bad(BadBlock),
}

/// Bytes of a part of a block, from the start of the block; empty in a built block.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Extent {
    /// First byte.
    pub offset: u16,
    /// Number of bytes.
    pub len: u16,
}

impl Extent {
    /// The bytes in the file of the block.
    pub fn span(self, block: &Block) -> Span {
        let start = block.span.start.saturating_add(u32::from(self.offset));
        Span::new(start, start.saturating_add(u32::from(self.len)))
    }
}

/// The first error of a block that does not parse.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct BadBlock {
    /// The alarm of the error.
    pub alarm: Alarm,
    /// Bytes of the file marked by the reader's finding; empty for a built block.
    pub finding: Span,
}

impl BadBlock {
    /// An error of a built block, without a finding.
    pub(super) fn built(alarm: Alarm) -> BadBlock {
        BadBlock { alarm, finding: Span::default() }
    }
}

/// Direction of a jump's search for its target.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum JumpDirection {
    /// To the end of the program, then from its start.
    Around,
    /// Toward the end of the program only.
    Forward,
    /// Toward the start of the program only.
    Backward,
}

impl JumpDirection {
    /// Whether a jump in block `from` finds its target in block `to` of the same program.
    pub(super) fn reaches(self, from: usize, to: usize) -> bool {
        match self {
            JumpDirection::Around => true,
            JumpDirection::Forward => to > from,
            JumpDirection::Backward => to <= from,
        }
    }

    /// Keyword of a jump in this direction only, and the keyword of the other direction.
    pub(crate) fn keywords(self) -> (&'static str, &'static str) {
        if self == JumpDirection::Forward { ("GOTOF", "GOTOB") } else { ("GOTOB", "GOTOF") }
    }

    /// Target of a jump in block `from`, among the blocks `places` of one name in rising order: the nearest one in its direction.
    pub(crate) fn nearest(self, from: usize, places: &[usize]) -> Option<usize> {
        let after = places.partition_point(|to| *to <= from);
        places.get(self.choice(after, places.len())?).copied()
    }

    /// Index of the nearest of `count` blocks, of which the one at `after` is the first behind the jump.
    pub(super) fn choice(self, after: usize, count: usize) -> Option<usize> {
        match self {
            JumpDirection::Around if after == count => Some(0),
            JumpDirection::Around | JumpDirection::Forward => Some(after),
            JumpDirection::Backward => after.checked_sub(1),
        }
    }
}

/// An assignment of a block.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Assignment {
    /// The variable: [`Expr::Var`] or [`Expr::Indirect`].
    pub to: ExprId,
    /// New value of the variable.
    pub value: ExprId,
}

/// A jump of a block.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Jump {
    /// The condition; `None` without one.
    pub cond: Option<ExprId>,
    /// Sequence number or [`Expr::Label`] to go to.
    pub target: ExprId,
    /// Direction of the search for the target.
    pub way: JumpDirection,
    /// Bytes of `GOTOF` or `GOTOB`; none of `GOTO`.
    pub keyword: Extent,
}

/// Dimensioning of a word's value by its own notation: `X=IC(5)`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Dimensioning {
    /// By the codes in force.
    #[default]
    Plain,
    /// `AC( )`: absolute.
    Absolute,
    /// `IC( )`: incremental.
    Incremental,
    /// `DC( )`: absolute, by the shortest way.
    Shortest,
    /// `ACP( )`: absolute, turning in the positive direction.
    Positive,
    /// `ACN( )`: absolute, turning in the negative direction.
    Negative,
}

/// An address and its value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Word {
    /// The address.
    pub letter: Address,
    /// Length of the word in bytes.
    pub len: u8,
    /// Start of the word, in bytes from the start of its block.
    pub offset: u16,
    /// Index of the address: 1 in `S1=500` and `SPOS[1]=0`.
    pub index: Option<u8>,
    /// Dimensioning of the value.
    pub form: Dimensioning,
    /// Value of the word.
    pub value: WordValue,
}

/// Value after an address letter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum WordValue {
    /// A number.
    Number(Dec),
    /// A variable or an expression.
    Expr(ExprId),
}

/// An expression.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Expr {
    /// A constant.
    Number(Dec),
    /// A label as a jump target, without a value.
    Label(TextId),
    /// `#n` or `Rn`.
    Var(u32),
    /// `#[expr]`, `##n` or `R[expr]`.
    Indirect(ExprId),
    /// `-expr`.
    Negate(ExprId),
    /// `left op right`.
    Binary(Op, ExprId, ExprId),
    /// `FUNCTION[expr]`.
    Call(Function, ExprId),
}

/// A binary operator.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Op {
    /// `+`
    Add,
    /// `-`
    Subtract,
    /// `*`
    Multiply,
    /// `/`
    Divide,
    /// `MOD`
    Modulo,
    /// `AND`, bit by bit.
    And,
    /// `ATAN[left]/[right]`, in degrees.
    Atan,
    /// `POW[left,right]`: left to the power of right.
    Power,
    /// `OR`, bit by bit.
    Or,
    /// `XOR`, bit by bit.
    Xor,
    /// `EQ`
    Equal,
    /// `NE`
    NotEqual,
    /// `GT`
    Greater,
    /// `GE`
    GreaterEqual,
    /// `LT`
    Less,
    /// `LE`
    LessEqual,
}

impl Op {
    /// The comparison that is true exactly when this one is false, vacant variables included; other operators are unchanged.
    pub fn opposite(self) -> Op {
        match self {
            Op::Equal => Op::NotEqual,
            Op::NotEqual => Op::Equal,
            Op::Greater => Op::LessEqual,
            Op::GreaterEqual => Op::Less,
            Op::Less => Op::GreaterEqual,
            Op::LessEqual => Op::Greater,
            other => other,
        }
    }
}

/// Candidates for new sequence numbers of jump targets, high numbers first.
pub(super) fn fresh_numbers() -> impl Iterator<Item = u32> {
    (9001..=9999).chain(1..=9000)
}

impl Word {
    /// A built word, without a place.
    pub const fn new(letter: Address, value: WordValue) -> Word {
        Word { letter, len: 0, offset: 0, index: None, form: Dimensioning::Plain, value }
    }

    /// The bytes of the word in its file.
    pub fn span(&self, block: &Block) -> Span {
        let start = block.span.start.saturating_add(u32::from(self.offset));
        Span::new(start, start.saturating_add(u32::from(self.len)))
    }
}

impl Deck {
    /// Releases unused memory reserved for reading.
    pub(crate) fn shrink(&mut self) {
        self.programs.shrink_to_fit();
        self.blocks.shrink_to_fit();
        self.words.shrink_to_fit();
        self.exprs.shrink_to_fit();
        self.assignments.shrink_to_fit();
        self.jumps.shrink_to_fit();
        self.texts.shrink_to_fit();
    }

    /// Words of a block; empty for other statements.
    #[inline]
    pub fn words_of(&self, block: &Block) -> &[Word] {
        match block.stmt {
            Stmt::Words { first, count } => &self.words[first as usize..first as usize + count as usize],
            _ => &[],
        }
    }

    /// The blocks of a program.
    pub fn blocks_of(&self, program: &Program) -> &[Block] {
        &self.blocks[program.first as usize..program.end as usize]
    }

    /// An expression.
    #[inline]
    pub fn expr(&self, id: ExprId) -> Expr {
        self.exprs[id.0 as usize]
    }

    /// Whether a comparison of two constants is true; `None` for other conditions.
    pub(super) fn holds(&self, cond: ExprId) -> Option<bool> {
        let Expr::Binary(op, left, right) = self.expr(cond) else { return None };
        let (Expr::Number(left), Expr::Number(right)) = (self.expr(left), self.expr(right)) else { return None };
        let (left, right) = (left.to_f64(), right.to_f64());
        match op {
            Op::Equal => Some(left == right),
            Op::NotEqual => Some(left != right),
            Op::Greater => Some(left > right),
            Op::GreaterEqual => Some(left >= right),
            Op::Less => Some(left < right),
            Op::LessEqual => Some(left <= right),
            _ => None,
        }
    }

    /// Value of a formula of constants, sums and products; `None` for other formulas.
    pub(super) fn constant(&self, id: ExprId) -> Option<f64> {
        match self.expr(id) {
            Expr::Number(number) => Some(number.to_f64()),
            Expr::Negate(inner) => self.constant(inner).map(|value| -value),
            Expr::Binary(op, left, right) => {
                let (left, right) = (self.constant(left)?, self.constant(right)?);
                match op {
                    Op::Add => Some(left + right),
                    Op::Subtract => Some(left - right),
                    Op::Multiply => Some(left * right),
                    Op::Divide if right != 0.0 => Some(left / right),
                    _ => None,
                }
            }
            _ => None,
        }
    }

    /// A text; empty for `None`.
    pub fn text(&self, id: Option<TextId>) -> &str {
        id.and_then(|id| self.texts.get(id.index())).map_or("", |text| text)
    }

    /// Mutable access to a text.
    pub fn text_mut(&mut self, id: TextId) -> Option<&mut Box<str>> {
        self.texts.get_mut(id.index())
    }

    /// Adds an expression.
    pub(super) fn add_expr(&mut self, expr: Expr) -> ExprId {
        self.exprs.push(expr);
        ExprId(self.exprs.len() as u32 - 1)
    }

    /// Adds the opposite of a condition: the opposite comparison, or `cond == 0` for a value.
    pub(super) fn add_opposite(&mut self, cond: ExprId) -> ExprId {
        match self.expr(cond) {
            Expr::Binary(op, left, right) if op.opposite() != op => {
                self.add_expr(Expr::Binary(op.opposite(), left, right))
            }
            _ => {
                let zero = self.add_expr(Expr::Number(Dec::int(0)));
                self.add_expr(Expr::Binary(Op::Equal, cond, zero))
            }
        }
    }

    /// Adds a text.
    pub(super) fn add_text(&mut self, text: impl Into<Box<str>>) -> TextId {
        self.texts.push(text.into());
        TextId(NonZeroU32::new(self.texts.len() as u32).unwrap_or(NonZeroU32::MIN))
    }

    /// The assignments of [`Stmt::Assigns`].
    pub fn assignments_at(&self, first: u32, count: u16) -> &[Assignment] {
        several(&self.assignments, first, count)
    }

    /// The jumps of [`Stmt::Ifs`].
    pub fn jumps_at(&self, first: u32, count: u16) -> &[Jump] {
        several(&self.jumps, first, count)
    }

    /// Jumps of a block.
    pub fn jumps_of(&self, stmt: Stmt) -> impl Iterator<Item = Jump> {
        let one = match stmt {
            Stmt::If { cond, target, way, keyword } => Some(Jump { cond: Some(cond), target, way, keyword }),
            Stmt::Goto { target, way, keyword } => Some(Jump { cond: None, target, way, keyword }),
            _ => None,
        };
        let several = match stmt {
            Stmt::Ifs { first, count } => self.jumps_at(first, count),
            _ => &[],
        };
        one.into_iter().chain(several.iter().copied())
    }

    /// Whether an assignment to `to` raises a user alarm, so that the program ends there.
    pub(super) fn raises_alarm(&self, control: &Control, to: ExprId) -> bool {
        let Expr::Var(number) = self.expr(to) else { return false };
        control.var(number).is_some_and(|row| row.kind == VarKind::AlarmMessage)
    }

    /// Unconditional assignments of a block.
    pub fn assignments_of(&self, stmt: Stmt) -> impl Iterator<Item = Assignment> {
        let one = match stmt {
            Stmt::Assign { to, value } => Some(Assignment { to, value }),
            _ => None,
        };
        let several = match stmt {
            Stmt::Assigns { first, count } => self.assignments_at(first, count),
            _ => &[],
        };
        one.into_iter().chain(several.iter().copied())
    }

    /// Index of the first program with a name, ignoring case.
    pub fn program_named(&self, name: &str) -> Option<u32> {
        let at =
            self.programs.iter().position(|row| row.name.is_some() && self.text(row.name).eq_ignore_ascii_case(name));
        at.map(|at| at as u32)
    }

    /// The first program with a number.
    pub fn program(&self, number: u32) -> Option<&Program> {
        self.programs.iter().find(|program| program.number == number)
    }
}

/// `list[first..first + count]`; empty beyond the end.
fn several<T>(list: &[T], first: u32, count: u16) -> &[T] {
    let first = first as usize;
    list.get(first..first + usize::from(count)).unwrap_or_default()
}
