//! Tree to text: block by block, brackets only if precedence needs them.

mod operators;
mod symbolic;

use crate::controls::Address;
use crate::controls::syntax::{ArcTangent, Function, RoundBrackets};
use crate::controls::{Control, VarKind};
use crate::nc::ast::{Block, Deck, Expr, ExprId, Op, Stmt, TextId, WordValue};
use crate::nc::dec::Dec;
use operators::{operator, symbolic_operator};

/// Maximum depth of a tree, equal to the parser's maximum number of parts.
pub(in crate::nc) const DEPTH: u32 = 250;

/// A minus at the start of an expression.
#[derive(Clone, Copy, PartialEq)]
enum Sign {
    /// As it is: at the start of a bracket or block.
    Plain,
    /// In brackets: after another sign or operator.
    Bracketed,
}

/// Binding level at which every operator needs brackets.
const FACTOR: u8 = 6;

/// Maximum length of a block's text.
const BLOCK_TEXT: usize = 10_000;

/// Whether the comment of a block is a message to the operator: `#3000=1(…)`.
pub fn is_message(deck: &Deck, control: &Control, block: &Block) -> bool {
    let (Stmt::Assign { to, .. } | Stmt::IfThen { to, .. }) = block.stmt else { return false };
    let Expr::Var(number) = deck.expr(to) else { return false };
    control.var(number).is_some_and(|row| matches!(row.kind, VarKind::AlarmMessage | VarKind::StopMessage))
}

/// The length of a block's text without its comment.
pub(in crate::nc) fn text_length(deck: &Deck, control: &Control, block: &Block) -> usize {
    let mut w = Writer { deck, control, text: String::new(), start: 0, too_deep: false };
    w.block(&Block { comment: None, ..*block });
    w.text.len()
}

pub(in crate::nc) struct Writer<'a> {
    pub(in crate::nc) deck: &'a Deck,
    pub(in crate::nc) control: &'a Control,
    pub(in crate::nc) text: String,
    /// Start of the block in the text.
    pub(in crate::nc) start: usize,
    pub(in crate::nc) too_deep: bool,
}

impl Writer<'_> {
    pub(in crate::nc) fn block(&mut self, block: &Block) {
        self.start = self.text.len();
        self.too_deep = false;
        match block.skip {
            0 => {}
            1 => self.text.push('/'),
            switch => self.text.push_str(&format!("/{switch}")),
        }
        if let Some(number) = block.number {
            self.text.push(if block.main { ':' } else { 'N' });
            self.text.push_str(&number.to_string());
            if block.stmt != Stmt::Empty || block.label.is_some() {
                self.text.push(' ');
            }
        }
        if self.control.syntax.names().is_some() {
            return self.symbolic_block(block);
        }
        match block.stmt {
            // `lower` has removed these.
            Stmt::Empty | Stmt::Bad(_) | Stmt::Ifs { .. } => {}
            Stmt::Assigns { first, count } => {
                for (at, assignment) in self.deck.assignments_at(first, count).iter().enumerate() {
                    self.text.push_str(if at > 0 { " " } else { "" });
                    self.assignment(assignment.to, assignment.value);
                }
            }
            Stmt::Call { .. } | Stmt::Message(_) => {}
            Stmt::Words { .. } => self.words(block),
            Stmt::Assign { to, value } => self.assignment(to, value),
            Stmt::If { cond, target, .. } => {
                self.text.push_str("IF[");
                self.formula(cond, 0);
                self.text.push_str("]GOTO");
                self.formula(target, 0);
            }
            Stmt::IfThen { cond, to, value } => {
                self.text.push_str("IF[");
                self.formula(cond, 0);
                self.text.push_str("]THEN ");
                self.assignment(to, value);
            }
            Stmt::Goto { target, .. } => {
                self.text.push_str("GOTO");
                self.formula(target, 0);
            }
            Stmt::While { cond, label, .. } => {
                if let Some(cond) = cond {
                    self.text.push_str("WHILE[");
                    self.formula(cond, 0);
                    self.text.push(']');
                }
                self.text.push_str(&format!("DO{label}"));
            }
            Stmt::End { label, .. } => self.text.push_str(&format!("END{label}")),
        }
        let spaced = self.text.len() > self.start && !is_message(self.deck, self.control, block);
        self.comment(block.comment, spaced);
    }

    pub(in crate::nc) fn assignment(&mut self, to: ExprId, value: ExprId) {
        self.expr(to, FACTOR, Sign::Plain, 0);
        self.text.push('=');
        self.formula(value, 0);
    }

    pub(in crate::nc) fn comment(&mut self, comment: Option<TextId>, spaced: bool) {
        if comment.is_some() {
            let round = self.control.syntax.round == RoundBrackets::Comment;
            if spaced {
                self.text.push(' ');
            }
            self.text.push(if round { '(' } else { ';' });
            self.text.push_str(self.deck.text(comment));
            self.text.push_str(if round { ")" } else { "" });
        }
    }

    pub(in crate::nc) fn words(&mut self, block: &Block) {
        for (index, word) in self.deck.words_of(block).iter().enumerate() {
            if index > 0 {
                self.text.push(' ');
            }
            self.text.extend(word.letter.letter());
            match word.value {
                // Skip switch 1 in the middle of a block is written without its number.
                WordValue::Number(Dec { mantissa: 1, .. }) if word.letter == Address::Skip => {}
                // G codes have two digits, as in every manual.
                WordValue::Number(number @ Dec { mantissa: 0..10, scale: 0, .. }) if word.letter == Address::G => {
                    self.text.push_str(&format!("0{number}"));
                }
                WordValue::Number(number) => self.text.push_str(&number.to_string()),
                WordValue::Expr(value) => match self.deck.expr(value) {
                    Expr::Var(_) | Expr::Indirect(_) => self.expr(value, FACTOR, Sign::Plain, 0),
                    _ => self.bracketed(value, 0),
                },
            }
        }
    }

    pub(in crate::nc) fn function_name(&mut self, function: Function) {
        let row = self.control.syntax.functions.iter().find(|(_, other)| *other == function);
        let name = row.map_or(function.usual_name(), |(name, _)| *name);
        self.text.push_str(name);
    }

    pub(in crate::nc) fn bracketed(&mut self, id: ExprId, depth: u32) {
        let round = self.control.syntax.round == RoundBrackets::Group;
        self.text.push(if round { '(' } else { '[' });
        self.formula(id, depth + 1);
        self.text.push(if round { ')' } else { ']' });
    }

    /// Writes an expression at the start of a bracket or block, where nothing of it needs brackets.
    fn formula(&mut self, id: ExprId, depth: u32) {
        self.expr(id, 0, Sign::Plain, depth);
    }

    /// Writes an expression in a position where operators of at least `level` need no brackets: from comparisons at 0 to none at
    /// [`FACTOR`].
    fn expr(&mut self, id: ExprId, level: u8, sign: Sign, depth: u32) {
        if depth > DEPTH || self.text.len() - self.start > BLOCK_TEXT {
            self.too_deep = true;
            self.text.push('0');
            return;
        }
        match self.deck.expr(id) {
            Expr::Number(number) if number.mantissa < 0 && sign == Sign::Bracketed => self.bracketed(id, depth),
            Expr::Label(name) => self.text.push_str(self.deck.text(Some(name))),
            Expr::Number(number) => self.text.push_str(&number.to_string()),
            Expr::Var(number) => self.text.push_str(&self.control.variable(number)),
            Expr::Indirect(inner) => {
                self.text.push(self.control.syntax.variable);
                self.text.push('[');
                self.formula(inner, depth + 1);
                self.text.push(']');
            }
            Expr::Negate(_) if sign == Sign::Bracketed => self.bracketed(id, depth),
            Expr::Negate(inner) => {
                self.text.push('-');
                match self.deck.expr(inner) {
                    Expr::Var(_) | Expr::Indirect(_) | Expr::Call(..) => {
                        self.expr(inner, FACTOR, Sign::Bracketed, depth + 1)
                    }
                    _ => self.bracketed(inner, depth),
                }
            }
            Expr::Call(function, inner) => {
                self.function_name(function);
                self.bracketed(inner, depth);
            }
            Expr::Binary(Op::Atan, left, right) if self.control.syntax.names().is_some() => {
                self.two_arguments(left, right, depth);
            }
            Expr::Binary(Op::Atan, left, right) => {
                self.function_name(Function::Atan);
                self.bracketed(left, depth);
                self.text.push('/');
                self.bracketed(right, depth);
            }
            // `ATAN[a]/[b]` would be the angle of two numbers.
            Expr::Binary(Op::Divide, left, right)
                if level <= operator(Op::Divide).0 && self.ends_in_arc_tangent(left) =>
            {
                self.bracketed(left, depth);
                self.text.push('/');
                self.expr(right, operator(Op::Divide).0 + 1, Sign::Bracketed, depth + 1);
            }
            Expr::Binary(Op::Power, left, right) => {
                self.function_name(Function::Power);
                self.text.push('[');
                self.formula(left, depth + 1);
                self.text.push(',');
                self.formula(right, depth + 1);
                self.text.push(']');
            }
            Expr::Binary(op, left, right) => {
                let (own, operator) =
                    if self.control.syntax.names().is_some() { symbolic_operator(op) } else { operator(op) };
                if own < level {
                    return self.bracketed(id, depth);
                }
                self.expr(left, own, sign, depth + 1);
                self.text.push_str(operator);
                self.expr(right, own + 1, Sign::Bracketed, depth + 1);
            }
        }
    }

    /// Whether a formula ends in the arc tangent of one number, on a control that also has the one of two numbers.
    fn ends_in_arc_tangent(&self, id: ExprId) -> bool {
        match self.deck.expr(id) {
            Expr::Call(Function::Atan, _) => self.control.syntax.atan == ArcTangent::OfOneOrTwo,
            Expr::Negate(inner) => self.ends_in_arc_tangent(inner),
            Expr::Binary(op, _, right) => operator(op).0 == operator(Op::Divide).0 && self.ends_in_arc_tangent(right),
            _ => false,
        }
    }
}
