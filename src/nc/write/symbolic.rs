//! Tree to text in a language with names: headers, labels, `=` after addresses, comparisons as the weakest operators.

use super::Writer;
use crate::controls::Address;
use crate::controls::CodeId;
use crate::controls::syntax::{Function, Names};
use crate::nc::ast::{Block, Dimensioning, Expr, ExprId, Jump, JumpDirection, Program, Stmt, Word, WordValue};

impl Writer<'_> {
    /// Writes the header lines of a program.
    pub(in crate::nc) fn head(&mut self, names: &Names, program: &Program, eol: &str) {
        let (name, ending) = (self.deck.text(program.name), names.endings[usize::from(program.sub)]);
        self.text.push_str(&format!("%_N_{name}_{ending}{eol};$PATH=/_N_{ending}_DIR{eol}"));
    }

    /// Writes label and statement of a block, after its number.
    pub(super) fn symbolic_block(&mut self, block: &Block) {
        if block.label.is_some() {
            self.text.push_str(self.deck.text(block.label));
            self.text.push(':');
            if block.stmt != Stmt::Empty {
                self.text.push(' ');
            }
        }
        match block.stmt {
            // `lower` has rewritten these.
            Stmt::Empty | Stmt::Bad(_) | Stmt::IfThen { .. } | Stmt::While { .. } | Stmt::End { .. } => {}
            Stmt::Words { .. } => {
                for (at, word) in self.deck.words_of(block).iter().enumerate() {
                    self.gap(at);
                    self.symbolic_word(word);
                }
            }
            Stmt::Assign { to, value } => self.assignment(to, value),
            Stmt::Assigns { first, count } => {
                for (at, assignment) in self.deck.assignments_at(first, count).iter().enumerate() {
                    self.gap(at);
                    self.assignment(assignment.to, assignment.value);
                }
            }
            stmt @ (Stmt::If { .. } | Stmt::Ifs { .. } | Stmt::Goto { .. }) => {
                for (at, Jump { cond, target, way, .. }) in self.deck.jumps_of(stmt).enumerate() {
                    self.gap(at);
                    if let Some(cond) = cond {
                        self.text.push_str("IF ");
                        self.formula(cond, 0);
                        self.text.push(' ');
                    }
                    self.text.push_str(if way == JumpDirection::Backward { "GOTOB " } else { "GOTOF " });
                    if let Expr::Number(_) = self.deck.expr(target) {
                        self.text.push('N');
                    }
                    self.formula(target, 0);
                }
            }
            Stmt::Call { name, repeats } => {
                self.text.push_str(self.deck.text(Some(name)));
                if let Some(repeats) = repeats {
                    let formula = !matches!(self.deck.expr(repeats), Expr::Number(_));
                    self.text.push_str(if formula { " P=" } else { " P" });
                    self.formula(repeats, 0);
                }
            }
            Stmt::Message(text) => {
                let quote = if text.is_some() { "\"" } else { "" };
                self.text.push_str(&format!("MSG({quote}{}{quote})", self.deck.text(text)));
            }
        }
        let spaced = block.number.is_some() || block.label.is_some() || block.stmt != Stmt::Empty;
        self.comment(block.comment, spaced);
    }

    fn gap(&mut self, at: usize) {
        if at > 0 {
            self.text.push(' ');
        }
    }

    fn symbolic_word(&mut self, word: &Word) {
        if let (Address::Name, WordValue::Number(place)) = (word.letter, word.value) {
            let place = u16::try_from(place.mantissa).unwrap_or(u16::MAX);
            self.text.push_str(&self.control.code_name(CodeId::Named(place)));
            if let Some(index) = word.index {
                self.text.push_str(&format!("({index})"));
            }
            return;
        }
        self.text.push_str(&self.control.address(word.letter));
        if let Some(index) = word.index {
            let text = if word.letter.is_long() { format!("[{index}]") } else { index.to_string() };
            self.text.push_str(&text);
        }
        let plain = word.index.is_none() && word.form == Dimensioning::Plain && !word.letter.is_long();
        if !(plain && matches!(word.value, WordValue::Number(_))) {
            self.text.push('=');
        }
        let form = match word.form {
            Dimensioning::Plain => "",
            Dimensioning::Absolute => "AC(",
            Dimensioning::Incremental => "IC(",
            Dimensioning::Shortest => "DC(",
            Dimensioning::Positive => "ACP(",
            Dimensioning::Negative => "ACN(",
        };
        self.text.push_str(form);
        match word.value {
            WordValue::Number(number) => self.text.push_str(&number.to_string()),
            WordValue::Expr(id) => self.formula(id, 0),
        }
        self.text.push_str(if form.is_empty() { "" } else { ")" });
    }

    /// Writes `ATAN2(y,x)`.
    pub(super) fn two_arguments(&mut self, left: ExprId, right: ExprId, depth: u32) {
        self.function_name(Function::Atan);
        self.text.push('(');
        self.formula(left, depth + 1);
        self.text.push(',');
        self.formula(right, depth + 1);
        self.text.push(')');
    }
}
