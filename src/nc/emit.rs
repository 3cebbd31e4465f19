//! Tree to text in the control's form: one program per file, capitals, brackets only if precedence needs them.

use crate::controls::Control;
use crate::controls::options::CommentCharacters;
use crate::controls::syntax::Percent;
use crate::msg;
use crate::nc::ast::{Block, Deck, Program, Stmt};
use crate::nc::files::{File, Files};
use crate::nc::lower::lower_with_origins;
use crate::nc::write::{DEPTH, Writer};
use crate::text::{Diagnostic, FileId, Place, Span};

/// Line end.
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
    /// Place of each block of the deck.
    pub places: Vec<Place>,
    /// Findings about blocks that could not be written as intended.
    pub diagnostics: Vec<Diagnostic>,
}

/// Writes a deck with LF line ends. Forms missing on the control are rewritten first, see [`lower`](super::lower()). Total.
pub fn emit(deck: &Deck, control: &Control) -> Emitted {
    emit_with(deck, control, Newline::Lf, CommentCharacters::Ascii)
}

/// Writes a deck with a line end and the characters allowed in comments. Total.
pub fn emit_with(deck: &Deck, control: &Control, newline: Newline, characters: CommentCharacters) -> Emitted {
    let (low, origins) = lower_with_origins(deck, control, characters);
    let mut out = Emitted { places: vec![Place::default(); deck.blocks.len()], ..Emitted::default() };
    let eol = newline.text();
    for (index, program) in low.programs.iter().enumerate() {
        let file = FileId(index.min(u16::MAX as usize) as u16);
        let mut w = Writer { deck: &low, control, text: String::new(), start: 0, too_deep: false };
        write_head(&mut w, program, eol);
        let body = w.text.len();
        for index in program.first as usize..program.end as usize {
            let Some(block) = low.blocks.get(index) else { continue };
            w.block(block);
            let first = w.text.as_bytes().get(body).filter(|_| w.start == body && program.number != 0);
            if first.is_some_and(|letter| control.syntax.program_letters.contains(letter)) {
                // At the start of its own line it would start another program: `O2L1` on the E60.
                w.start = body - eol.len();
                w.text.replace_range(w.start..body, "");
            }
            let place = Place { file, span: Span::new(w.start as u32, w.text.len() as u32) };
            let written = characters.length(w.text.get(w.start..).unwrap_or_default());
            out.diagnostics.extend(finding_of_block(deck, &w, block, written).map(|finding| finding.at(place)));
            let origin = origins.get(index).map_or(index, |&origin| origin as usize);
            if let Some(slot) = out.places.get_mut(origin) {
                // A block rewritten as several extends from the first to the last of them.
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

/// Writes the lines before the blocks of a program: the start of the file, and the program's number or name.
fn write_head(w: &mut Writer, program: &Program, eol: &str) {
    let syntax = &w.control.syntax;
    if syntax.percent == Percent::Both {
        w.text.push('%');
        w.text.push_str(eol);
    }
    if let Some(names) = &syntax.names() {
        w.head(names, program, eol);
    } else if program.number != 0 {
        let letter = syntax.program_letters.first().copied().unwrap_or(b'O');
        w.text.push_str(&format!("{}{}", letter as char, program.number));
        w.comment(program.title, false);
        w.text.push_str(eol);
    }
}

/// The finding about a block that could not be written as intended. `before` is the deck before lowering, `written` the number of characters.
fn finding_of_block(before: &Deck, w: &Writer, block: &Block, written: usize) -> Option<Diagnostic> {
    let most = w.control.syntax.block_chars;
    if matches!(block.stmt, Stmt::Bad(_)) {
        Some(Diagnostic::error(msg!("nc.unreadable-block")))
    } else if w.too_deep {
        Some(Diagnostic::error(msg!("nc.formula-too-long", most = DEPTH)))
    } else if written >= most {
        Some(Diagnostic::warning(msg!("nc.long-block", count = written as u32, most = most as u32 - 1)))
    } else if shortened(before, w.deck, block) {
        Some(Diagnostic::warning(msg!("nc.clipped-text", text = w.deck.text(block.comment))))
    } else {
        None
    }
}

/// Whether lowering shortened the comment of a block. Lowering keeps the indices of comments.
fn shortened(before: &Deck, after: &Deck, block: &Block) -> bool {
    before.text(block.comment).chars().count() > after.text(block.comment).chars().count()
}

/// `O9100.nc`, `L9100.SPF`; a second program of the same name becomes `O9100-2.nc`.
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
