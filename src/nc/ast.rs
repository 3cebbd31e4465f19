//! The tree of a program: what was written, not what the machine would do. Small rows in four arenas.
//!
//! A parsed deck keeps the bytes of every block; a block that an edit or a rewrite touched loses them and is written anew.

use super::dec::Dec;
use crate::controls::syntax::Function;
use crate::text::{FileId, Span};

/// Index of an expression in [`Deck::exprs`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct ExprId(pub u32);

/// All programs of all files.
#[derive(Debug, Clone, Default)]
pub struct Deck {
    /// Programs in file order.
    pub programs: Vec<Program>,
    /// Blocks of all programs, a program's blocks side by side.
    pub blocks: Vec<Block>,
    /// Words of all blocks, a block's words side by side.
    pub words: Vec<Word>,
    /// Expressions; children stand before their parents.
    pub exprs: Vec<Expr>,
    /// Texts of comments and messages, without brackets.
    pub comments: Vec<Box<str>>,
}

/// One program.
#[derive(Debug, Clone, PartialEq)]
pub struct Program {
    /// File that it stands in.
    pub file: FileId,
    /// Number behind `O`; 0 where the file has none.
    pub number: u32,
    /// Comment behind the number, index in [`Deck::comments`].
    pub title: Option<u32>,
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
    /// Bytes of the block without the line end; empty for a block that was built.
    pub span: Span,
    /// Sequence number.
    pub number: Option<u32>,
    /// What it says.
    pub stmt: Stmt,
    /// First comment in the block, index in [`Deck::comments`].
    pub comment: Option<u32>,
    /// Optional block skip: 0 none, 1 `/` or `/1`, 2 `/2` ….
    pub skip: u8,
}

/// What a block says.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Stmt {
    /// Nothing but a number or a comment.
    Empty,
    /// NC words `words[first..first + count]`.
    Words {
        /// First word.
        first: u32,
        /// How many.
        count: u16,
    },
    /// `to = value`; `to` is [`Expr::Var`] or [`Expr::Indirect`].
    Assign {
        /// The variable.
        to: ExprId,
        /// Its new value.
        value: ExprId,
    },
    /// `IF [cond] GOTO target`.
    If {
        /// The condition.
        cond: ExprId,
        /// Sequence number to go to.
        target: ExprId,
    },
    /// `IF [cond] THEN to = value`.
    IfThen {
        /// The condition.
        cond: ExprId,
        /// The variable.
        to: ExprId,
        /// Its new value.
        value: ExprId,
    },
    /// `GOTO target`.
    Goto(ExprId),
    /// `WHILE [cond] DO label`, or `DO label` without a condition.
    While {
        /// The condition; `None` is for ever.
        cond: Option<ExprId>,
        /// Number of the loop.
        label: u16,
    },
    /// `END label`.
    End {
        /// Number of the loop.
        label: u16,
    },
    /// A block with an error, already reported; running into it is its alarm.
    Bad(crate::controls::Alarm),
}

/// An address and its value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Word {
    /// Address letter, upper case; `/` with a number for an optional block skip from here to the end of the block.
    pub letter: u8,
    /// Bytes of the word.
    pub len: u8,
    /// Where the word starts, in bytes behind the start of its block.
    pub offset: u16,
    /// What stands behind the letter.
    pub value: WordValue,
}

/// What stands behind an address letter.
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
    /// `#n`.
    Var(u32),
    /// `#[expr]` or `##n`.
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
    /// The comparison that holds exactly where this one does not, with vacant variables too; other operators stay.
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

/// Sequence numbers that are given out to jump to, where a program does not have them: the high ones first.
pub(super) fn fresh_numbers() -> impl Iterator<Item = u32> {
    (9001..=9999).chain(1..=9000)
}

impl Word {
    /// The bytes of the word in its file.
    pub fn span(&self, block: &Block) -> Span {
        let start = block.span.start.saturating_add(u32::from(self.offset));
        Span::new(start, start.saturating_add(u32::from(self.len)))
    }
}

impl Deck {
    /// Gives back the room that reading reserved and did not need.
    pub(crate) fn shrink(&mut self) {
        self.programs.shrink_to_fit();
        self.blocks.shrink_to_fit();
        self.words.shrink_to_fit();
        self.exprs.shrink_to_fit();
        self.comments.shrink_to_fit();
    }

    /// The words of a block; none where it has other text.
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
    pub fn expr(&self, id: ExprId) -> Expr {
        self.exprs[id.0 as usize]
    }

    /// A comment or message by its index; empty where there is none.
    pub fn comment(&self, index: Option<u32>) -> &str {
        index.and_then(|index| self.comments.get(index as usize)).map_or("", |text| text)
    }

    /// The first program with a number.
    pub fn program(&self, number: u32) -> Option<&Program> {
        self.programs.iter().find(|program| program.number == number)
    }
}
