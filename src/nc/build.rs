//! Building a program in Rust: formulas with operators, blocks in order, a [`Deck`] at the end.
//!
//! ```
//! use macroline::nc::build::*;
//! let mut b = Builder::new();
//! b.program(9100, "RIBBON");
//! b.n(10).assign(104, v(100) * v(1033) / 100);
//! b.n(11).if_goto(v(104).le(v(116)), 13);
//! b.n(12).assign(104, v(116));
//! b.n(13).words([g(91), g(1), x(v(107) * v(121)), f(v(115))]);
//! b.words([m(99)]);
//! let deck = b.finish();
//! assert_eq!(deck.blocks.len(), 5);
//! ```

use super::ast::{Block, Deck, Expr, ExprId, Extent, JumpDirection, Op, Program, Stmt, TextId, Word, WordValue};
use super::dec::Dec;
use crate::controls::Address;
use crate::controls::syntax::Function;
use crate::text::{FileId, Span};

/// An expression under construction.
#[derive(Debug, Clone, PartialEq)]
pub enum Formula {
    /// A constant.
    Number(Dec),
    /// `#n`.
    Var(u32),
    /// `#[formula]`.
    Indirect(Box<Formula>),
    /// `-formula`.
    Negate(Box<Formula>),
    /// `left op right`.
    Binary(Op, Box<Formula>, Box<Formula>),
    /// `FUNCTION[formula]`.
    Call(Function, Box<Formula>),
}

/// A comparison for [`Builder::if_goto`], [`Builder::if_then`] and [`Builder::while_do`].
#[derive(Debug, Clone, PartialEq)]
pub struct Condition(Formula);

/// The variable `#n`.
pub fn v(number: u32) -> Formula {
    Formula::Var(number)
}

/// The variable with a calculated number: `#[formula]`.
pub fn v_at(number: impl Into<Formula>) -> Formula {
    Formula::Indirect(Box::new(number.into()))
}

/// A constant with a decimal point: the decimal nearest to `value`, with at most `decimals` decimals. 0 for NaN, infinity, and more than 18
/// digits.
pub fn real(value: f64, decimals: u8) -> Formula {
    Formula::Number(Dec::from_f64(value, decimals).unwrap_or(Dec::new(0, 0)))
}

impl From<i32> for Formula {
    /// A whole number without a point. After an axis letter it counts command increments; use [`real`] there.
    fn from(value: i32) -> Formula {
        Formula::Number(Dec::int(value.into()))
    }
}

impl From<u32> for Formula {
    /// A whole number without a point.
    fn from(value: u32) -> Formula {
        Formula::Number(Dec::int(value.into()))
    }
}

impl From<Dec> for Formula {
    fn from(value: Dec) -> Formula {
        Formula::Number(value)
    }
}

macro_rules! operators {
    ($($trait:ident $method:ident $op:ident;)*) => {$(
        impl<R: Into<Formula>> core::ops::$trait<R> for Formula {
            type Output = Formula;
            fn $method(self, right: R) -> Formula {
                self.binary(Op::$op, right)
            }
        }
    )*};
}

operators! {
    Add add Add;
    Sub sub Subtract;
    Mul mul Multiply;
    Div div Divide;
    Rem rem Modulo;
}

impl core::ops::Neg for Formula {
    type Output = Formula;
    fn neg(self) -> Formula {
        Formula::Negate(Box::new(self))
    }
}

impl Formula {
    fn binary(self, op: Op, right: impl Into<Formula>) -> Formula {
        Formula::Binary(op, Box::new(self), Box::new(right.into()))
    }

    fn call(self, function: Function) -> Formula {
        Formula::Call(function, Box::new(self))
    }

    /// `self EQ right`; on most controls for whole numbers only.
    pub fn eq(self, right: impl Into<Formula>) -> Condition {
        Condition(self.binary(Op::Equal, right))
    }

    /// `self NE right`; on most controls for whole numbers only.
    pub fn ne(self, right: impl Into<Formula>) -> Condition {
        Condition(self.binary(Op::NotEqual, right))
    }

    /// `self GT right`.
    pub fn gt(self, right: impl Into<Formula>) -> Condition {
        Condition(self.binary(Op::Greater, right))
    }

    /// `self GE right`.
    pub fn ge(self, right: impl Into<Formula>) -> Condition {
        Condition(self.binary(Op::GreaterEqual, right))
    }

    /// `self LT right`.
    pub fn lt(self, right: impl Into<Formula>) -> Condition {
        Condition(self.binary(Op::Less, right))
    }

    /// `self LE right`.
    pub fn le(self, right: impl Into<Formula>) -> Condition {
        Condition(self.binary(Op::LessEqual, right))
    }

    /// Square root.
    pub fn sqrt(self) -> Formula {
        self.call(Function::Sqrt)
    }

    /// Absolute value.
    pub fn abs(self) -> Formula {
        self.call(Function::Abs)
    }

    /// Rounded half away from zero.
    pub fn round(self) -> Formula {
        self.call(Function::Round)
    }

    /// Rounded toward zero.
    pub fn fix(self) -> Formula {
        self.call(Function::Fix)
    }

    /// Any other function.
    pub fn apply(self, function: Function) -> Formula {
        self.call(function)
    }
}

/// A word under construction: letter, value, and an index of the letter.
#[derive(Debug, Clone, PartialEq)]
pub struct NewWord(Address, Formula, Option<u8>);

/// A word of any address.
pub fn word(letter: Address, value: impl Into<Formula>) -> NewWord {
    NewWord(letter, value.into(), None)
}

/// A word with an indexed address: `S2=800`.
pub fn indexed(letter: Address, index: u8, value: impl Into<Formula>) -> NewWord {
    NewWord(letter, value.into(), Some(index))
}

macro_rules! words {
    ($($name:ident $letter:expr;)*) => {$(
        #[doc = concat!("The word `", stringify!($name), "` …, in capitals.")]
        pub fn $name(value: impl Into<Formula>) -> NewWord {
            NewWord($letter, value.into(), None)
        }
    )*};
}

words! {
    f Address::F;
    g Address::G;
    l Address::L;
    m Address::M;
    p Address::P;
    s Address::S;
    x Address::X;
    y Address::Y;
    z Address::Z;
}

/// Collects blocks; see the [module](self).
#[derive(Debug, Clone, Default)]
pub struct Builder {
    deck: Deck,
    number: Option<u32>,
    skip: u8,
}

impl Builder {
    /// An empty builder.
    pub fn new() -> Builder {
        Builder::default()
    }

    /// Starts a program in its own file; an empty title is omitted.
    pub fn program(&mut self, number: u32, title: &str) -> &mut Builder {
        let title = (!title.is_empty()).then(|| self.text(title));
        let file = FileId(self.deck.programs.len().min(u16::MAX as usize) as u16);
        let at = self.deck.blocks.len() as u32;
        let (name, sub, span) = (None, false, Span::default());
        self.deck.programs.push(Program { file, number, name, sub, title, span, first: at, end: at });
        self
    }

    /// Gives the next block a sequence number.
    pub fn n(&mut self, number: u32) -> &mut Builder {
        self.number = Some(number);
        self
    }

    /// Gives the next block an optional block skip, 1 to 9.
    pub fn skip(&mut self, switch: u8) -> &mut Builder {
        self.skip = switch.clamp(1, 9);
        self
    }

    /// A block of NC words.
    pub fn words(&mut self, words: impl IntoIterator<Item = NewWord>) -> &mut Builder {
        let first = self.deck.words.len() as u32;
        for NewWord(letter, value, index) in words.into_iter().take(u16::MAX as usize) {
            let value = match value {
                Formula::Number(number) => WordValue::Number(number),
                other => WordValue::Expr(self.intern(other)),
            };
            self.deck.words.push(Word { index, ..Word::new(letter, value) });
        }
        let count = (self.deck.words.len() as u32 - first) as u16;
        self.push(if count == 0 { Stmt::Empty } else { Stmt::Words { first, count } })
    }

    /// `#to = value`.
    pub fn assign(&mut self, to: u32, value: impl Into<Formula>) -> &mut Builder {
        let to = self.add(Expr::Var(to));
        let value = self.intern(value.into());
        self.push(Stmt::Assign { to, value })
    }

    /// `#[to] = value`.
    pub fn assign_at(&mut self, to: impl Into<Formula>, value: impl Into<Formula>) -> &mut Builder {
        let to = self.intern(v_at(to));
        let value = self.intern(value.into());
        self.push(Stmt::Assign { to, value })
    }

    /// `IF [condition] GOTO target`.
    pub fn if_goto(&mut self, condition: Condition, target: impl Into<Formula>) -> &mut Builder {
        let cond = self.intern(condition.0);
        let target = self.intern(target.into());
        self.push(Stmt::If { cond, target, way: JumpDirection::Around, keyword: Extent::default() })
    }

    /// `IF [condition] THEN #to = value`.
    pub fn if_then(&mut self, condition: Condition, to: u32, value: impl Into<Formula>) -> &mut Builder {
        let cond = self.intern(condition.0);
        let to = self.add(Expr::Var(to));
        let value = self.intern(value.into());
        self.push(Stmt::IfThen { cond, to, value })
    }

    /// `GOTO target`.
    pub fn goto(&mut self, target: impl Into<Formula>) -> &mut Builder {
        let target = self.intern(target.into());
        self.push(Stmt::Goto { target, way: JumpDirection::Around, keyword: Extent::default() })
    }

    /// `WHILE [condition] DO label`.
    pub fn while_do(&mut self, condition: Condition, label: u16) -> &mut Builder {
        let cond = Some(self.intern(condition.0));
        self.push(Stmt::While { cond, label, keyword: Extent::default() })
    }

    /// `DO label`: a loop without condition.
    pub fn do_forever(&mut self, label: u16) -> &mut Builder {
        self.push(Stmt::While { cond: None, label, keyword: Extent::default() })
    }

    /// `END label`.
    pub fn end_do(&mut self, label: u16) -> &mut Builder {
        self.push(Stmt::End { label, keyword: Extent::default() })
    }

    /// Calls a program by its number, with an optional number of repeats: `M98 P`, or a call by name.
    pub fn call(&mut self, program: u32, repeats: Option<u32>) -> &mut Builder {
        let name = self.text(&format!("L{program}"));
        let repeats = repeats.map(|times| self.intern(times.into()));
        self.push(Stmt::Call { name, repeats })
    }

    /// A message to the operator without a stop; a comment on controls without such messages.
    pub fn show(&mut self, text: &str) -> &mut Builder {
        let text = self.text(text);
        self.push(Stmt::Message(Some(text)))
    }

    /// `MSG()`: ends the message.
    pub fn end_message(&mut self) -> &mut Builder {
        self.push(Stmt::Message(None))
    }

    /// `#3000 = number (text)`: the control's own alarm with a message.
    pub fn alarm(&mut self, number: u32, text: &str) -> &mut Builder {
        self.assign(3000, number).note(text)
    }

    /// `#3006 = number (text)`: stop with a message.
    pub fn message(&mut self, number: u32, text: &str) -> &mut Builder {
        self.assign(3006, number).note(text)
    }

    /// A comment block.
    pub fn comment(&mut self, text: &str) -> &mut Builder {
        self.push(Stmt::Empty).note(text)
    }

    /// Adds a comment to the last block.
    pub fn note(&mut self, text: &str) -> &mut Builder {
        let comment = self.text(text);
        if let Some(block) = self.deck.blocks.last_mut() {
            block.comment = Some(comment);
        }
        self
    }

    /// The finished deck.
    pub fn finish(self) -> Deck {
        self.deck
    }

    fn text(&mut self, text: &str) -> TextId {
        self.deck.add_text(text)
    }

    fn add(&mut self, expr: Expr) -> ExprId {
        self.deck.add_expr(expr)
    }

    fn intern(&mut self, formula: Formula) -> ExprId {
        let expr = match formula {
            Formula::Number(number) => Expr::Number(number),
            Formula::Var(number) => Expr::Var(number),
            Formula::Indirect(inner) => Expr::Indirect(self.intern(*inner)),
            Formula::Negate(inner) => Expr::Negate(self.intern(*inner)),
            Formula::Binary(op, left, right) => {
                let left = self.intern(*left);
                Expr::Binary(op, left, self.intern(*right))
            }
            Formula::Call(function, inner) => Expr::Call(function, self.intern(*inner)),
        };
        self.add(expr)
    }

    fn push(&mut self, stmt: Stmt) -> &mut Builder {
        if self.deck.programs.is_empty() {
            self.program(0, "");
        }
        let (number, skip) = (self.number.take(), core::mem::take(&mut self.skip));
        self.deck.blocks.push(Block {
            span: Span::default(),
            number,
            number_at: Extent::default(),
            stmt,
            comment: None,
            label: None,
            skip,
            main: false,
        });
        if let Some(program) = self.deck.programs.last_mut() {
            program.end = self.deck.blocks.len() as u32;
        }
        self
    }
}
