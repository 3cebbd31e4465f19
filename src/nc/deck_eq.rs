//! Equality of decks, ignoring places, the order in the arenas, and blank blocks.

use super::ast::{Block, Deck, Expr, ExprId, Pair, Stmt, TextId, WordValue};

impl Deck {
    /// Whether both contain the same programs, block by block.
    pub fn same_as(&self, other: &Deck) -> bool {
        self.programs.len() == other.programs.len()
            && self.programs.iter().zip(&other.programs).all(|(a, b)| {
                let said = |deck: &Deck, text: Option<TextId>| text.map(|_| deck.text(text).to_owned());
                let mut left = self.blocks_of(a).iter().filter(|block| has_text(block));
                let mut right = other.blocks_of(b).iter().filter(|block| has_text(block));
                let titles = said(self, a.title) == said(other, b.title);
                let names = said(self, a.name) == said(other, b.name);
                (a.number, a.sub) == (b.number, b.sub)
                    && titles
                    && names
                    && loop {
                        match (left.next(), right.next()) {
                            (None, None) => break true,
                            (Some(x), Some(y)) if self.same_block(x, other, y) => {}
                            _ => break false,
                        }
                    }
            })
    }

    fn same_block(&self, x: &Block, other: &Deck, y: &Block) -> bool {
        let same = |a: ExprId, b: ExprId| self.same_expr(a, other, b);
        let stmts = match (x.stmt, y.stmt) {
            (Stmt::Empty, Stmt::Empty) => true,
            (Stmt::Words { .. }, Stmt::Words { .. }) => {
                let (a, b) = (self.words_of(x), other.words_of(y));
                a.len() == b.len()
                    && a.iter().zip(b).all(|(a, b)| {
                        (a.letter, a.index, a.form) == (b.letter, b.index, b.form)
                            && match (a.value, b.value) {
                                (WordValue::Number(a), WordValue::Number(b)) => a == b,
                                (WordValue::Expr(a), WordValue::Expr(b)) => same(a, b),
                                _ => false,
                            }
                    })
            }
            (Stmt::Assign { to, value }, Stmt::Assign { to: to2, value: value2 }) => {
                same(to, to2) && same(value, value2)
            }
            (Stmt::Assigns { first, count }, Stmt::Assigns { first: first2, count: count2 })
            | (Stmt::Ifs { first, count }, Stmt::Ifs { first: first2, count: count2 }) => {
                let (a, b) = (self.pairs_of(first, count), other.pairs_of(first2, count2));
                let pair = |a: &Pair, b: &Pair| a.way == b.way && same(a.left, b.left) && same(a.right, b.right);
                a.len() == b.len() && a.iter().zip(b).all(|(a, b)| pair(a, b))
            }
            (Stmt::If { cond, target, way, .. }, Stmt::If { cond: cond2, target: target2, way: way2, .. }) => {
                way == way2 && same(cond, cond2) && same(target, target2)
            }
            (Stmt::IfThen { cond, to, value }, Stmt::IfThen { cond: cond2, to: to2, value: value2 }) => {
                same(cond, cond2) && same(to, to2) && same(value, value2)
            }
            (Stmt::Goto { target, way, .. }, Stmt::Goto { target: target2, way: way2, .. }) => {
                way == way2 && same(target, target2)
            }
            (Stmt::Call { name, repeats }, Stmt::Call { name: name2, repeats: repeats2 }) => {
                self.text(Some(name)) == other.text(Some(name2))
                    && match (repeats, repeats2) {
                        (None, None) => true,
                        (Some(a), Some(b)) => same(a, b),
                        _ => false,
                    }
            }
            (Stmt::Message(a), Stmt::Message(b)) => a.is_some() == b.is_some() && self.text(a) == other.text(b),
            (Stmt::While { cond, label, .. }, Stmt::While { cond: cond2, label: label2, .. }) => {
                label == label2
                    && match (cond, cond2) {
                        (None, None) => true,
                        (Some(a), Some(b)) => same(a, b),
                        _ => false,
                    }
            }
            (Stmt::End { label, .. }, Stmt::End { label: label2, .. }) => label == label2,
            (Stmt::Bad(a), Stmt::Bad(b)) => a.alarm == b.alarm,
            _ => false,
        };
        let texts = x.comment.map(|_| self.text(x.comment)) == y.comment.map(|_| other.text(y.comment));
        let labels = x.label.map(|_| self.text(x.label)) == y.label.map(|_| other.text(y.label));
        stmts && texts && labels && (x.number, x.skip, x.main) == (y.number, y.skip, y.main)
    }

    fn same_expr(&self, a: ExprId, other: &Deck, b: ExprId) -> bool {
        match (self.expr(a), other.expr(b)) {
            (Expr::Number(a), Expr::Number(b)) => a == b,
            (Expr::Label(a), Expr::Label(b)) => self.text(Some(a)) == other.text(Some(b)),
            (Expr::Var(a), Expr::Var(b)) => a == b,
            (Expr::Indirect(a), Expr::Indirect(b)) | (Expr::Negate(a), Expr::Negate(b)) => self.same_expr(a, other, b),
            (Expr::Call(f, a), Expr::Call(g, b)) => f == g && self.same_expr(a, other, b),
            (Expr::Binary(f, a, c), Expr::Binary(g, b, d)) => {
                f == g && self.same_expr(a, other, b) && self.same_expr(c, other, d)
            }
            _ => false,
        }
    }
}

/// Whether a block has text. A block without text is not written, so it is missing when the text is parsed.
fn has_text(block: &Block) -> bool {
    block.stmt != Stmt::Empty
        || block.number.is_some()
        || block.label.is_some()
        || block.comment.is_some()
        || block.skip != 0
}
