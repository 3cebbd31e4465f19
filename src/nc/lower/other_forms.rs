//! Operators and functions in forms that the control has: `MOD`, `ATAN`, powers, squares.

use crate::controls::Control;
use crate::controls::syntax::{Function, Syntax};
use crate::nc::ast::{Deck, Expr, ExprId, Op, Stmt, WordValue};
use crate::nc::dec::Dec;

/// Rewrites operators and functions missing on the control.
pub(super) fn other_forms(deck: &mut Deck, control: &Control) {
    let syntax = &control.syntax;
    if !deck.exprs.iter().any(|expr| lacks(syntax, expr)) {
        return;
    }
    // New parts are inserted before their parent, so every index moves.
    let mut new = Rewritten { exprs: Vec::with_capacity(deck.exprs.len() + 3), moved: Vec::new() };
    new.moved.reserve(deck.exprs.len());
    for expr in &deck.exprs {
        let moved = new.moved(*expr);
        let id = if lacks(syntax, expr) { new.other_form(moved) } else { new.push(moved) };
        new.moved.push(id);
    }
    each_expression(deck, &mut |id| *id = new.at(*id));
    deck.exprs = new.exprs;
}

/// Whether the control lacks the operator or function of an expression.
fn lacks(syntax: &Syntax, expr: &Expr) -> bool {
    match expr {
        Expr::Binary(Op::Modulo, ..) => !syntax.modulo,
        Expr::Binary(Op::Atan, ..) => !syntax.atan.takes_two(),
        Expr::Binary(Op::Power, ..) => !syntax.has(Function::Power),
        Expr::Call(Function::Atan, _) => !syntax.atan.takes_one(),
        Expr::Call(function @ (Function::Square | Function::AddPoint), _) => !syntax.has(*function),
        _ => false,
    }
}

/// The new expressions, and the new index of each old one.
struct Rewritten {
    exprs: Vec<Expr>,
    moved: Vec<ExprId>,
}

impl Rewritten {
    fn push(&mut self, expr: Expr) -> ExprId {
        self.exprs.push(expr);
        ExprId(self.exprs.len() as u32 - 1)
    }

    fn at(&self, old: ExprId) -> ExprId {
        self.moved.get(old.0 as usize).copied().unwrap_or(old)
    }

    /// An expression with the new indices of its parts.
    fn moved(&self, expr: Expr) -> Expr {
        match expr {
            Expr::Number(_) | Expr::Label(_) | Expr::Var(_) => expr,
            Expr::Indirect(inner) => Expr::Indirect(self.at(inner)),
            Expr::Negate(inner) => Expr::Negate(self.at(inner)),
            Expr::Call(function, inner) => Expr::Call(function, self.at(inner)),
            Expr::Binary(op, left, right) => Expr::Binary(op, self.at(left), self.at(right)),
        }
    }

    /// Rewrites an expression with other operators and functions.
    fn other_form(&mut self, expr: Expr) -> ExprId {
        match expr {
            Expr::Call(Function::Square, inner) => self.push(Expr::Binary(Op::Multiply, inner, inner)),
            Expr::Call(Function::AddPoint, inner) => inner,
            Expr::Call(Function::Atan, inner) => {
                let one = self.push(Expr::Number(Dec::int(1)));
                self.push(Expr::Binary(Op::Atan, inner, one))
            }
            Expr::Binary(Op::Modulo, left, right) => self.remainder(left, right),
            Expr::Binary(Op::Power, base, exponent) => self.power(base, exponent),
            Expr::Binary(Op::Atan, y, x) => self.half_angle(y, x),
            other => self.push(other),
        }
    }

    /// `a MOD b = a - FIX(a/b) · b`
    fn remainder(&mut self, left: ExprId, right: ExprId) -> ExprId {
        let ratio = self.push(Expr::Binary(Op::Divide, left, right));
        let whole = self.push(Expr::Call(Function::Fix, ratio));
        let multiple = self.push(Expr::Binary(Op::Multiply, whole, right));
        self.push(Expr::Binary(Op::Subtract, left, multiple))
    }

    /// `a^b = EXP(b · LN(a))`, for a > 0; the control raises an alarm for other bases.
    fn power(&mut self, base: ExprId, exponent: ExprId) -> ExprId {
        let logarithm = self.push(Expr::Call(Function::Ln, base));
        let product = self.push(Expr::Binary(Op::Multiply, exponent, logarithm));
        self.push(Expr::Call(Function::Exp, product))
    }

    /// `ATAN2(y, x) = 2 · ATAN(y / (√(x² + y²) + x))`, −180° < result < 180°; it divides by zero for y = 0, x ≤ 0.
    fn half_angle(&mut self, y: ExprId, x: ExprId) -> ExprId {
        let squares = [x, y].map(|side| self.push(Expr::Binary(Op::Multiply, side, side)));
        let sum = self.push(Expr::Binary(Op::Add, squares[0], squares[1]));
        let distance = self.push(Expr::Call(Function::Sqrt, sum));
        let base = self.push(Expr::Binary(Op::Add, distance, x));
        let ratio = self.push(Expr::Binary(Op::Divide, y, base));
        let half = self.push(Expr::Call(Function::Atan, ratio));
        let two = self.push(Expr::Number(Dec::int(2)));
        self.push(Expr::Binary(Op::Multiply, two, half))
    }
}

/// Visits every reference to an expression from blocks, words, assignments and jumps.
fn each_expression(deck: &mut Deck, visit: &mut dyn FnMut(&mut ExprId)) {
    for block in &mut deck.blocks {
        match &mut block.stmt {
            Stmt::Assign { to, value } => [to, value].into_iter().for_each(&mut *visit),
            Stmt::IfThen { cond, to, value } => [cond, to, value].into_iter().for_each(&mut *visit),
            Stmt::If { cond, target, .. } => [cond, target].into_iter().for_each(&mut *visit),
            Stmt::Goto { target: id, .. }
            | Stmt::Call { repeats: Some(id), .. }
            | Stmt::While { cond: Some(id), .. } => visit(id),
            _ => {}
        }
    }
    for word in &mut deck.words {
        if let WordValue::Expr(value) = &mut word.value {
            visit(value);
        }
    }
    for assignment in &mut deck.assignments {
        visit(&mut assignment.to);
        visit(&mut assignment.value);
    }
    for jump in &mut deck.jumps {
        jump.cond.iter_mut().for_each(&mut *visit);
        visit(&mut jump.target);
    }
}
