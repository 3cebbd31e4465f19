//! A single expression or condition, as typed for a breakpoint or in a debugger.

use crate::controls::Alarm;
use crate::nc::ast::{Deck, Expr, ExprId};
use crate::nc::parse::failure::Read;
use crate::nc::parse::reader::Reader;
use crate::nc::parse::tables::Tables;
use crate::nc::parsed::Parsed;
use crate::text::{Diagnostic, FileId};

/// An expression (`#100*#1033/100`) or a condition (`#120 LE 3`) parsed without errors; only [`formula`] makes one.
#[derive(Debug, Clone)]
pub struct ParsedFormula {
    deck: Deck,
    root: ExprId,
}

impl ParsedFormula {
    /// Deck with the expression tree.
    pub fn deck(&self) -> &Deck {
        &self.deck
    }

    /// Root of the expression tree.
    pub fn root(&self) -> ExprId {
        self.root
    }
}

/// Parses one expression or condition as in a block of `program`, with its control and settings. A condition may be written with or without
/// its brackets. The place of an error counts from the start of the text, in file 0.
pub fn formula(text: &str, program: &Parsed) -> Result<ParsedFormula, Box<Diagnostic>> {
    let control = program.control();
    let tables = Tables::new(control, program.dialect(), program.codes());
    let read = |bracketed: bool| {
        let mut reader = Reader::new(control, &tables, FileId(0), text, Deck::default());
        reader.take_line(text.as_bytes(), 0);
        let mut wrong = match (reader.whole_line(bracketed), reader.findings.list.pop()) {
            (Ok(root), None) => return Ok(ParsedFormula { deck: reader.deck, root }),
            (Ok(_), Some(found)) => found,
            (Err(failure), _) => failure.finding,
        };
        wrong.fixes.clear();
        Err(Box::new(wrong))
    };
    read(false)
        .or_else(|wrong| if text.trim_start().starts_with('[') { read(true).map_err(|_| wrong) } else { Err(wrong) })
}

impl Reader<'_> {
    /// Reads the whole line as an expression or a condition.
    fn whole_line(&mut self, bracketed: bool) -> Read<ExprId> {
        self.pass_blanks();
        let start = self.cursor.at;
        if self.names().is_some() {
            let root = self.symbolic_condition()?;
            self.pass_blanks();
            return if self.cursor.ended() { Ok(root) } else { Err(self.unexpected()) };
        }
        let mut root = if bracketed { self.condition(Alarm::IfSentence, "")? } else { self.formula()? };
        if let Some(op) = self.comparison(Alarm::IfSentence) {
            let right = self.formula()?;
            root = self.add_expr(Expr::Binary(op, root, right), start)?;
        }
        self.pass_blanks();
        if self.cursor.ended() { Ok(root) } else { Err(self.unexpected()) }
    }
}
