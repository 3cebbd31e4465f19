//! Tree to text, as the control takes it: one program a file, capitals, brackets only where precedence needs them.

use super::ast::{Block, Deck, Expr, ExprId, Op, Program, Stmt, TextId, WordValue};
use super::dec::Dec;
use super::emit_names::named_operator;
use super::files::{File, Files};
use super::lower::{is_message, lowered};
use super::parsed::Parsed;
use crate::controls::Control;
use crate::controls::syntax::{Function, Percent, RoundBrackets};
use crate::msg;
use crate::text::lines::line_end;
use crate::text::{Diagnostic, FileId, Place, Span};

/// Trees deeper than this are no formulas; reading stops at as many parts.
const DEPTH: u32 = 250;

/// The level at which no operator stands bare.
pub(super) const FACTOR: u8 = 6;

/// Longest text of a block that is still written out.
const BLOCK_TEXT: usize = 10_000;

/// What ends a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Newline {
    /// LF.
    #[default]
    Lf,
    /// CR LF.
    CrLf,
}

impl Newline {
    /// The characters.
    pub fn text(self) -> &'static str {
        match self {
            Newline::Lf => "\n",
            Newline::CrLf => "\r\n",
        }
    }
}

/// Written programs.
#[derive(Debug, Clone, Default)]
pub struct Emitted {
    /// One file per program.
    pub files: Files,
    /// Where each block of the deck stands.
    pub places: Vec<Place>,
    /// What could not be written as it was meant.
    pub diagnostics: Vec<Diagnostic>,
}

/// Writes a deck with LF line ends. What the control lacks is rewritten first, see [`lower`](super::lower()). Total.
pub fn emit(deck: &Deck, control: &Control) -> Emitted {
    emit_with(deck, control, Newline::Lf)
}

/// Writes a deck. Total.
pub fn emit_with(deck: &Deck, control: &Control, newline: Newline) -> Emitted {
    let (low, origins) = lowered(deck, control);
    let mut out = Emitted { places: vec![Place::default(); deck.blocks.len()], ..Emitted::default() };
    let eol = newline.text();
    for (index, program) in low.programs.iter().enumerate() {
        let file = FileId(index.min(u16::MAX as usize) as u16);
        let mut w = Writer { deck: &low, control, text: String::new(), start: 0, too_deep: false };
        if control.syntax.percent == Percent::Both {
            w.text.push('%');
            w.text.push_str(eol);
        }
        if let Some(names) = &control.syntax.names() {
            w.head(names, program, eol);
        } else if program.number != 0 {
            let letter = control.syntax.program_letters.first().copied().unwrap_or(b'O');
            w.text.push_str(&format!("{}{}", letter as char, program.number));
            w.comment(program.title, false);
            w.text.push_str(eol);
        }
        for index in program.first as usize..program.end as usize {
            let Some(block) = low.blocks.get(index) else { continue };
            w.block(block);
            let place = Place { file, span: Span::new(w.start as u32, w.text.len() as u32) };
            let written = w.text.len() - w.start;
            let block_diagnostic = if matches!(block.stmt, Stmt::Bad(_)) {
                Some(Diagnostic::error(msg!("nc.unreadable-block")))
            } else if w.too_deep {
                Some(Diagnostic::error(msg!("nc.formula-too-long", DEPTH)))
            } else if written >= control.syntax.block_chars {
                Some(Diagnostic::warning(msg!("nc.long-block", written as u32, control.syntax.block_chars as u32 - 1)))
            } else if shortened(deck, &low, block) {
                Some(Diagnostic::warning(msg!("nc.clipped-text", w.deck.text(block.comment))))
            } else {
                None
            };
            out.diagnostics.extend(block_diagnostic.map(|d| d.at(place)));
            let origin = origins.get(index).map_or(index, |&origin| origin as usize);
            if let Some(slot) = out.places.get_mut(origin) {
                // A block that became several goes from the first to the last of them.
                let start = if *slot == Place::default() { place.span.start } else { slot.span.start };
                *slot = Place { span: Span::new(start, place.span.end), ..place };
            }
            if written > 0 {
                w.text.push_str(eol);
            }
        }
        if control.syntax.percent != Percent::Head {
            w.text.push('%');
            w.text.push_str(eol);
        }
        let name = file_name(&low, program, control, &out.files);
        out.files.0.push(File { name, text: w.text });
    }
    out
}

/// Whether lowering cut the comment of a block; it keeps the indices of comments.
fn shortened(before: &Deck, after: &Deck, block: &Block) -> bool {
    before.text(block.comment).chars().count() > after.text(block.comment).chars().count()
}

/// `O9100.nc`, `L9100.SPF`; a second program of a name becomes `O9100-2.nc`.
fn file_name(deck: &Deck, program: &Program, control: &Control, files: &Files) -> String {
    let extension = match &control.syntax.names() {
        Some(names) => names.endings[usize::from(program.sub)],
        None => control.syntax.extension,
    };
    let stem = match (program.name, program.number) {
        (Some(_), _) => deck.text(program.name).to_owned(),
        (None, 0) => "PROGRAM".to_owned(),
        (None, number) => format!("O{number}"),
    };
    let named = |name: &str| files.0.iter().any(|file| file.name == name);
    let mut name = format!("{stem}.{extension}");
    let mut twin = 2;
    while named(&name) {
        name = format!("{stem}-{twin}.{extension}");
        twin += 1;
    }
    name
}

/// Writes parsed files with some blocks changed: `deck` is the parsed deck in which every changed block has the span
/// `Span::default()`. All other bytes stay as they were. Total.
pub fn emit_parsed(parsed: &Parsed, deck: &Deck) -> Emitted {
    let mut files = parsed.files().clone();
    let (low, origins) = lowered(deck, parsed.control());
    let mut places: Vec<Place> = Vec::with_capacity(deck.blocks.len());
    let mut texts: Vec<(String, usize)> = vec![(String::new(), 0); files.0.len()];
    for program in &parsed.deck().programs {
        let Some((file, (text, copied))) = parsed.files().get(program.file).zip(texts.get_mut(program.file.0 as usize))
        else {
            continue;
        };
        for index in program.first as usize..program.end as usize {
            let from = origins.partition_point(|&origin| (origin as usize) < index);
            let Some((old, new)) = parsed.deck().blocks.get(index).zip(low.blocks.get(from)) else { continue };
            let lines = low.blocks.iter().zip(&origins).skip(from).take_while(|(_, origin)| **origin as usize == index);
            let (from, to) = (old.span.start as usize, old.span.end as usize);
            text.push_str(file.text.get(*copied..from).unwrap_or(""));
            let start = text.len() as u32;
            if new.span == Span::default() {
                let mut w =
                    Writer { deck: &low, control: parsed.control(), text: String::new(), start: 0, too_deep: false };
                for (at, (block, _)) in lines.enumerate() {
                    if at > 0 {
                        w.text.push_str(line_end(&file.text));
                    }
                    w.block(block);
                }
                text.push_str(&w.text);
            } else {
                text.push_str(file.text.get(from..to).unwrap_or(""));
            }
            *copied = to;
            places.push(Place { file: program.file, span: Span::new(start, text.len() as u32) });
        }
    }
    for (file, (mut text, copied)) in files.0.iter_mut().zip(texts) {
        text.push_str(file.text.get(copied..).unwrap_or(""));
        file.text = text;
    }
    Emitted { files, places, diagnostics: Vec::new() }
}

/// The length of a block's text without its comment.
pub(super) fn text_length(deck: &Deck, control: &Control, block: &Block) -> usize {
    let mut w = Writer { deck, control, text: String::new(), start: 0, too_deep: false };
    w.block(&Block { comment: None, ..*block });
    w.text.len()
}

pub(super) struct Writer<'a> {
    pub(super) deck: &'a Deck,
    pub(super) control: &'a Control,
    pub(super) text: String,
    /// Where the block starts.
    start: usize,
    pub(super) too_deep: bool,
}

impl Writer<'_> {
    fn block(&mut self, block: &Block) {
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
            return self.named_block(block);
        }
        match block.stmt {
            // What has no form here is left out by `lower`.
            Stmt::Empty | Stmt::Bad(_) | Stmt::Ifs { .. } => {}
            Stmt::Assigns { first, count } => {
                for (at, pair) in self.deck.pairs_of(first, count).iter().enumerate() {
                    self.text.push_str(if at > 0 { " " } else { "" });
                    self.assignment(pair.left, pair.right);
                }
            }
            Stmt::Call { .. } | Stmt::Message(_) => {}
            Stmt::Words { .. } => self.words(block),
            Stmt::Assign { to, value } => self.assignment(to, value),
            Stmt::If { cond, target, .. } => {
                self.text.push_str("IF[");
                self.expr(cond, 0, true, 0);
                self.text.push_str("]GOTO");
                self.expr(target, 0, true, 0);
            }
            Stmt::IfThen { cond, to, value } => {
                self.text.push_str("IF[");
                self.expr(cond, 0, true, 0);
                self.text.push_str("]THEN ");
                self.assignment(to, value);
            }
            Stmt::Goto { target, .. } => {
                self.text.push_str("GOTO");
                self.expr(target, 0, true, 0);
            }
            Stmt::While { cond, label } => {
                if let Some(cond) = cond {
                    self.text.push_str("WHILE[");
                    self.expr(cond, 0, true, 0);
                    self.text.push(']');
                }
                self.text.push_str(&format!("DO{label}"));
            }
            Stmt::End { label } => self.text.push_str(&format!("END{label}")),
        }
        let spaced = self.text.len() > self.start && !is_message(self.deck, self.control, block);
        self.comment(block.comment, spaced);
    }

    pub(super) fn assignment(&mut self, to: ExprId, value: ExprId) {
        self.expr(to, FACTOR, true, 0);
        self.text.push('=');
        self.expr(value, 0, true, 0);
    }

    pub(super) fn comment(&mut self, comment: Option<TextId>, spaced: bool) {
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

    fn words(&mut self, block: &Block) {
        for (index, word) in self.deck.words_of(block).iter().enumerate() {
            if index > 0 {
                self.text.push(' ');
            }
            self.text.push(word.letter as char);
            match word.value {
                // The first switch of a skip in the middle of a block goes without its number.
                WordValue::Number(Dec { mantissa: 1, .. }) if word.letter == b'/' => {}
                // G codes have two digits in every manual.
                WordValue::Number(number @ Dec { mantissa: 0..10, scale: 0, .. }) if word.letter == b'G' => {
                    self.text.push_str(&format!("0{number}"));
                }
                WordValue::Number(number) => self.text.push_str(&number.to_string()),
                WordValue::Expr(value) => match self.deck.expr(value) {
                    Expr::Var(_) | Expr::Indirect(_) => self.expr(value, FACTOR, true, 0),
                    _ => self.bracketed(value, 0),
                },
            }
        }
    }

    pub(super) fn function_name(&mut self, function: Function) {
        let row = self.control.syntax.functions.iter().find(|(_, other)| *other == function);
        let name = row.map_or_else(|| format!("{function:?}").to_ascii_uppercase(), |(name, _)| (*name).to_owned());
        self.text.push_str(&name);
    }

    fn bracketed(&mut self, id: ExprId, depth: u32) {
        let round = self.control.syntax.round == RoundBrackets::Group;
        self.text.push(if round { '(' } else { '[' });
        self.expr(id, 0, true, depth + 1);
        self.text.push(if round { ')' } else { ']' });
    }

    /// Writes an expression where operators of at least `level` may stand bare, from comparisons at 0 to none at [`FACTOR`]; a sign
    /// only at the head of a bracket or block (`lead`).
    pub(super) fn expr(&mut self, id: ExprId, level: u8, lead: bool, depth: u32) {
        if depth > DEPTH || self.text.len() - self.start > BLOCK_TEXT {
            self.too_deep = true;
            self.text.push('0');
            return;
        }
        match self.deck.expr(id) {
            Expr::Number(number) if number.mantissa < 0 && !lead => self.bracketed(id, depth),
            Expr::Label(name) => self.text.push_str(self.deck.text(Some(name))),
            Expr::Number(number) => self.text.push_str(&number.to_string()),
            Expr::Var(number) => self.text.push_str(&self.control.variable(number)),
            Expr::Indirect(inner) => {
                self.text.push(self.control.syntax.variable);
                self.text.push('[');
                self.expr(inner, 0, true, depth + 1);
                self.text.push(']');
            }
            Expr::Negate(_) if !lead => self.bracketed(id, depth),
            Expr::Negate(inner) => {
                self.text.push('-');
                match self.deck.expr(inner) {
                    Expr::Var(_) | Expr::Indirect(_) | Expr::Call(..) => self.expr(inner, FACTOR, false, depth + 1),
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
            Expr::Binary(op, left, right) => {
                let (own, sign) = if self.control.syntax.names().is_some() { named_operator(op) } else { operator(op) };
                if own < level {
                    return self.bracketed(id, depth);
                }
                self.expr(left, own, lead, depth + 1);
                self.text.push_str(sign);
                self.expr(right, own + 1, false, depth + 1);
            }
        }
    }
}

/// Level and spelling of an operator.
fn operator(op: Op) -> (u8, &'static str) {
    match op {
        Op::Add => (1, "+"),
        Op::Subtract => (1, "-"),
        Op::Or => (1, " OR "),
        Op::Xor => (1, " XOR "),
        Op::Multiply => (2, "*"),
        Op::Divide | Op::Atan => (2, "/"),
        Op::And => (2, " AND "),
        Op::Modulo => (2, " MOD "),
        Op::Equal => (0, " EQ "),
        Op::NotEqual => (0, " NE "),
        Op::Greater => (0, " GT "),
        Op::GreaterEqual => (0, " GE "),
        Op::Less => (0, " LT "),
        Op::LessEqual => (0, " LE "),
    }
}
