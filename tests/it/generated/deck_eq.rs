//! Equality of decks, ignoring places, the order in the arenas, and blank blocks.

use macroline::nc::{Assignment, Block, Deck, Expr, ExprId, Jump, Program, Stmt, TextId, Word, WordValue};

/// Whether both decks contain the same programs, block by block.
pub(crate) fn are_same(left: &Deck, right: &Deck) -> bool {
    let pair = Pair { left, right };
    let same = |a: &Program, b: &Program| pair.same_program(a, b);
    are_alike(left.programs.iter(), right.programs.iter(), same)
}

/// Two decks: the first of two arguments is from the left one, the second from the right one.
#[derive(Clone, Copy)]
struct Pair<'a> {
    left: &'a Deck,
    right: &'a Deck,
}

impl Pair<'_> {
    fn same_program(&self, a: &Program, b: &Program) -> bool {
        let written = |block: &&Block| has_text(block);
        let (left, right) =
            (self.left.blocks_of(a).iter().filter(written), self.right.blocks_of(b).iter().filter(written));
        (a.number, a.sub) == (b.number, b.sub)
            && self.same_text(a.title, b.title)
            && self.same_text(a.name, b.name)
            && are_alike(left, right, |x, y| self.same_block(x, y))
    }

    fn same_block(&self, x: &Block, y: &Block) -> bool {
        self.same_statement(x, y)
            && self.same_text(x.comment, y.comment)
            && self.same_text(x.label, y.label)
            && (x.number, x.skip, x.main) == (y.number, y.skip, y.main)
    }

    fn same_statement(&self, x: &Block, y: &Block) -> bool {
        let same = |a: ExprId, b: ExprId| self.same_expr(a, b);
        let both = |a: Option<ExprId>, b: Option<ExprId>| are_alike(a.into_iter(), b.into_iter(), same);
        match (x.stmt, y.stmt) {
            (Stmt::Empty, Stmt::Empty) => true,
            (Stmt::Words { .. }, Stmt::Words { .. }) => {
                let word = |a: &Word, b: &Word| {
                    (a.letter, a.index, a.form) == (b.letter, b.index, b.form)
                        && match (a.value, b.value) {
                            (WordValue::Number(a), WordValue::Number(b)) => a == b,
                            (WordValue::Expr(a), WordValue::Expr(b)) => same(a, b),
                            _ => false,
                        }
                };
                are_alike(self.left.words_of(x).iter(), self.right.words_of(y).iter(), word)
            }
            (Stmt::Assign { .. } | Stmt::Assigns { .. }, Stmt::Assign { .. } | Stmt::Assigns { .. }) => {
                let assignment = |a: Assignment, b: Assignment| same(a.to, b.to) && same(a.value, b.value);
                are_alike(self.left.assignments_of(x.stmt), self.right.assignments_of(y.stmt), assignment)
            }
            (
                Stmt::If { .. } | Stmt::Ifs { .. } | Stmt::Goto { .. },
                Stmt::If { .. } | Stmt::Ifs { .. } | Stmt::Goto { .. },
            ) => {
                let jump = |a: Jump, b: Jump| a.way == b.way && both(a.cond, b.cond) && same(a.target, b.target);
                are_alike(self.left.jumps_of(x.stmt), self.right.jumps_of(y.stmt), jump)
            }
            (Stmt::IfThen { cond, to, value }, Stmt::IfThen { cond: cond2, to: to2, value: value2 }) => {
                same(cond, cond2) && same(to, to2) && same(value, value2)
            }
            (Stmt::Call { name, repeats }, Stmt::Call { name: name2, repeats: repeats2 }) => {
                self.same_text(Some(name), Some(name2)) && both(repeats, repeats2)
            }
            (Stmt::Message(a), Stmt::Message(b)) => self.same_text(a, b),
            (Stmt::While { cond, label, .. }, Stmt::While { cond: cond2, label: label2, .. }) => {
                label == label2 && both(cond, cond2)
            }
            (Stmt::End { label, .. }, Stmt::End { label: label2, .. }) => label == label2,
            (Stmt::Bad(a), Stmt::Bad(b)) => a.alarm == b.alarm,
            _ => false,
        }
    }

    fn same_text(&self, a: Option<TextId>, b: Option<TextId>) -> bool {
        a.map(|_| self.left.text(a)) == b.map(|_| self.right.text(b))
    }

    fn same_expr(&self, a: ExprId, b: ExprId) -> bool {
        match (self.left.expr(a), self.right.expr(b)) {
            (Expr::Number(a), Expr::Number(b)) => a == b,
            (Expr::Label(a), Expr::Label(b)) => self.left.text(Some(a)) == self.right.text(Some(b)),
            (Expr::Var(a), Expr::Var(b)) => a == b,
            (Expr::Indirect(a), Expr::Indirect(b)) | (Expr::Negate(a), Expr::Negate(b)) => self.same_expr(a, b),
            (Expr::Call(f, a), Expr::Call(g, b)) => f == g && self.same_expr(a, b),
            (Expr::Binary(f, a, c), Expr::Binary(g, b, d)) => f == g && self.same_expr(a, b) && self.same_expr(c, d),
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

/// Whether two lists have the same length and items that are pairwise the same.
fn are_alike<T: Copy>(
    mut a: impl Iterator<Item = T>,
    mut b: impl Iterator<Item = T>,
    same: impl Fn(T, T) -> bool,
) -> bool {
    loop {
        match (a.next(), b.next()) {
            (None, None) => return true,
            (Some(a), Some(b)) if same(a, b) => {}
            _ => return false,
        }
    }
}
