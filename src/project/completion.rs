//! Completion proposals at a place of a program: codes, variables, words of the macro language, targets of jumps, programs to call.

use super::meaning::{Meaning, Table, Words};
use crate::controls::{Address, Code, CodeId, Control};
use crate::nc::symbols::Symbols;
use crate::nc::{Block, Deck, Parsed, Program, TokenKind, keywords, tokens};
use crate::text::{FileId, LineIndex, Span, utf16};

/// Kind of a proposal.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ProposalKind {
    /// A G or M code, or a code that is a name.
    Code,
    /// A variable.
    Variable,
    /// A statement, a comparison or an operator.
    Keyword,
    /// A function.
    Function,
    /// An address of several letters.
    Address,
    /// Number or label of a block.
    Block,
    /// Number or name of a program.
    Program,
}

/// One proposal.
#[derive(Debug, Clone, PartialEq)]
pub struct Proposal {
    /// Text that replaces [`Completion::replaces`].
    pub text: String,
    /// Kind of the proposal.
    pub kind: ProposalKind,
    /// Title of a program, text of a block; else empty.
    pub detail: String,
    /// Meaning of the proposal, if it has a row.
    pub meaning: Option<Meaning>,
}

impl Proposal {
    /// The line beside it: the first sentence of its meaning, else its detail.
    pub fn line(&self) -> String {
        self.meaning.as_ref().and_then(Meaning::first).unwrap_or_else(|| self.detail.clone())
    }
}

/// Proposals for a place.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Completion {
    /// Bytes of the file that a proposal replaces: the typed prefix.
    pub replaces: Span,
    /// In the order of the control's tables.
    pub proposals: Vec<Proposal>,
}

/// Variables of a range that are proposed one by one; of a larger range only those that the machine or the programs name.
const FEW: u32 = 8;

/// Kind of the unfinished text at the end of a line.
enum Typed {
    /// A comment, or a number that nothing proposes.
    Nothing,
    /// Number or label as the target of a jump.
    Target,
    /// Number of a program in P of a call.
    Called,
    /// A word or its beginning.
    Word,
}

/// Proposals at a byte of a file. Total.
pub fn at(words: &Words, parsed: &Parsed, file: FileId, byte: u32) -> Completion {
    let Some(text) = parsed.files().get(file).map(|file| file.text.as_str()) else { return Completion::default() };
    let byte = utf16::boundary(text, byte);
    let lines = LineIndex::new(text);
    let start = lines.start(lines.line_of(byte));
    let line = Span::new(start.min(byte), byte).of(text);
    let (typed, from) = typed(line, words.control());
    let prefix = line.get(from..).unwrap_or("").to_ascii_uppercase();
    let all = Proposals { words, parsed, file, byte, prefix: &prefix };
    let proposals = match typed {
        Typed::Nothing => Vec::new(),
        Typed::Target => all.targets(),
        Typed::Called => all.programs(),
        Typed::Word => all.words_of_a_block(),
    };
    // A number is replaced as a whole, with its digits behind the place.
    let behind = text.get(byte as usize..).unwrap_or("").bytes().take_while(u8::is_ascii_digit).count() as u32;
    let behind = if matches!(typed, Typed::Target | Typed::Called) { behind } else { 0 };
    Completion { replaces: Span::new(start.min(byte) + from as u32, byte + behind), proposals }
}

/// Kind of the unfinished text at the end of a line, and its first byte.
fn typed(line: &str, control: &Control) -> (Typed, usize) {
    let pieces = tokens(line, control);
    let open = pieces.last().filter(|(span, _)| span.end as usize == line.len());
    if open.is_some_and(|(_, kind)| *kind == TokenKind::Comment) {
        return (Typed::Nothing, line.len());
    }
    let named = control.syntax.names().is_some();
    let in_word = |c: char| c.is_ascii_alphabetic() || named && (c == '_' || c.is_ascii_digit());
    let letters = line.trim_end_matches(in_word).len();
    // A name does not begin with a digit.
    let letters = letters + line.get(letters..).unwrap_or("").chars().take_while(char::is_ascii_digit).count();
    let last = open.map_or(line.len(), |(span, _)| span.start as usize);
    let after_jump = |from: usize| {
        let before = pieces.iter().rfind(|(span, _)| span.end as usize <= from);
        before.is_some_and(|(span, kind)| {
            *kind == TokenKind::Keyword && span.of(line).get(..4).is_some_and(|word| word.eq_ignore_ascii_case("GOTO"))
        })
    };
    let calls = |from: usize| {
        let before = pieces.iter().rfind(|(span, _)| span.end as usize <= from);
        before.is_some_and(|(span, _)| span.of(line).eq_ignore_ascii_case("P")) && calls(line, &pieces, control)
    };
    match open.map(|(_, kind)| *kind) {
        Some(TokenKind::Number) if after_jump(last) => (Typed::Target, last),
        Some(TokenKind::Number) if calls(last) => (Typed::Called, last),
        Some(TokenKind::Number | TokenKind::Sequence) if !after_jump(last) => (Typed::Nothing, line.len()),
        Some(TokenKind::Code | TokenKind::Variable) => (Typed::Word, last),
        Some(TokenKind::Operator) if line.ends_with(control.syntax.variable) => (Typed::Word, last),
        Some(TokenKind::Address) if calls(line.len()) => (Typed::Called, line.len()),
        _ if letters < line.len() && after_jump(letters) => (Typed::Target, letters),
        Some(_) if letters < line.len() => (Typed::Word, letters),
        _ if after_jump(line.len()) => (Typed::Target, line.len()),
        _ => (Typed::Word, line.len()),
    }
}

/// Whether a line has a code that calls the program with the number in P.
fn calls(line: &str, pieces: &[(Span, TokenKind)], control: &Control) -> bool {
    let calls = |code: Code| matches!(code, Code::SubCall | Code::MacroCall | Code::MacroModal | Code::MacroModalBlock);
    let codes = pieces.iter().filter(|(_, kind)| *kind == TokenKind::Code);
    codes
        .filter_map(|(span, _)| control.code_written(span.of(line)))
        .any(|id| control.code(id).is_some_and(|row| calls(row.code)))
}

/// A place with its typed prefix, in capitals.
struct Proposals<'a> {
    words: &'a Words<'a>,
    parsed: &'a Parsed,
    file: FileId,
    byte: u32,
    prefix: &'a str,
}

impl Proposals<'_> {
    fn control(&self) -> &'static Control {
        self.words.control()
    }

    /// Proposal of a text, if it begins with the prefix.
    fn word(&self, text: String, kind: ProposalKind) -> Option<Proposal> {
        let meaning = || self.words.meaning(&text, Table::Program);
        text.to_ascii_uppercase().starts_with(self.prefix).then(|| Proposal {
            meaning: meaning(),
            text: text.clone(),
            kind,
            detail: String::new(),
        })
    }

    /// The program at the place.
    fn here(&self) -> Option<&Program> {
        let deck = self.parsed.deck();
        let begins = |program: &Program| deck.blocks_of(program).first().map_or(0, |block| block.span.start);
        let mut own = deck.programs.iter().filter(|program| program.file == self.file);
        own.rfind(|program| program.span.start.min(begins(program)) <= self.byte)
    }

    /// The prefix of a number without its leading zeros: `012` of a call means 12.
    fn prefix_value(&self) -> &str {
        self.prefix.trim_start_matches('0')
    }

    /// Numbers and labels of the program's blocks.
    fn targets(&self) -> Vec<Proposal> {
        let deck = self.parsed.deck();
        let Some(text) = self.parsed.files().get(self.file).map(|file| file.text.as_str()) else { return Vec::new() };
        let blocks = self.here().map_or(&[][..], |program| deck.blocks_of(program));
        // On a control whose blocks have names, a switch decides whether a jump can go to a block number.
        let named = self.control().syntax.names().is_some();
        let by_number = !named || self.parsed.dialect().reading.number_jumps;
        let letter = if named { "N" } else { "" };
        let number = |block: &Block| block.number.filter(|_| by_number).map(|number| format!("{letter}{number}"));
        let names = |block: &Block| {
            let label = Some(deck.text(block.label).to_owned()).filter(|label| !label.is_empty());
            let detail = block.span.of(text).to_owned();
            label.into_iter().chain(number(block)).map(move |name| (name, detail.clone())).collect::<Vec<_>>()
        };
        let value = self.prefix_value();
        let typed = |(name, _): &(String, String)| name.starts_with(value);
        let proposal = |(text, detail)| Proposal { text, kind: ProposalKind::Block, detail, meaning: None };
        blocks.iter().flat_map(names).filter(typed).map(proposal).collect()
    }

    /// Numbers of the programs, for P of a call.
    fn programs(&self) -> Vec<Proposal> {
        let deck = self.parsed.deck();
        let numbered = deck.programs.iter().filter(|program| program.number > 0);
        let all = numbered.map(|program| (program.number.to_string(), deck.text(program.title).to_owned()));
        let value = self.prefix_value();
        let typed = all.filter(|(number, _)| number.starts_with(value));
        typed.map(|(text, detail)| Proposal { text, kind: ProposalKind::Program, detail, meaning: None }).collect()
    }

    /// Codes, variables and words; in a language with names also its addresses and the programs.
    fn words_of_a_block(&self) -> Vec<Proposal> {
        let mut all = self.codes();
        all.extend(self.variables());
        all.extend(
            keywords(self.control()).into_iter().filter_map(|word| self.word(word.to_owned(), ProposalKind::Keyword)),
        );
        let functions = self.control().syntax.functions.iter();
        all.extend(functions.filter_map(|(word, _)| self.word((*word).to_owned(), ProposalKind::Function)));
        if let Some(names) = self.control().syntax.names() {
            let addresses = names.addresses.iter().filter(|row| row.1 != Address::Name);
            all.extend(addresses.filter_map(|row| self.word(row.0.to_owned(), ProposalKind::Address)));
            let deck: &Deck = self.parsed.deck();
            let programs = deck.programs.iter().map(|program| deck.text(program.name).to_owned());
            let programs =
                programs.filter(|name| !name.is_empty()).filter_map(|name| self.word(name, ProposalKind::Program));
            all.extend(programs.map(|found| Proposal { meaning: None, ..found }));
        }
        all
    }

    /// Codes that the switches leave on. Numbers have two digits, except after a prefix without the leading zero.
    fn codes(&self) -> Vec<Proposal> {
        let codes = self.parsed.codes();
        let own = self.control().codes.iter().map(|row| row.id).filter(|id| codes.row(*id).is_some());
        let bound = codes.calls().iter().map(|call| call.code).filter(|id| codes.row(*id).is_none());
        let one_digit = self.prefix.get(1..2).is_some_and(|digit| digit != "0");
        let name = |id: CodeId| match id {
            CodeId::G(number) if number.integer() < 10 && !one_digit => format!("G0{number}"),
            CodeId::M(number @ 0..10) if !one_digit => format!("M0{number}"),
            id => self.control().code_name(id),
        };
        own.chain(bound).filter_map(|id| self.word(name(id), ProposalKind::Code)).collect()
    }

    /// Variables that the machine or the programs name, and all variables of small ranges.
    fn variables(&self) -> Vec<Proposal> {
        let sign = self.control().syntax.variable;
        if !self.prefix.is_empty() && !self.prefix.starts_with(sign) {
            return Vec::new();
        }
        let mut numbers = Symbols::new(self.parsed).variables();
        numbers.extend(self.words.variables().into_iter().map(|row| row.number));
        let small = self.control().vars.iter().filter(|row| row.last - row.first < FEW);
        numbers.extend(small.flat_map(|row| row.first..=row.last));
        // The prefix may itself be the whole number of a known variable, which is no proposal.
        let known = |number: &u32| self.control().var(*number).is_some();
        let names = numbers.into_iter().filter(known).map(|number| self.control().variable(number));
        names.filter(|name| name != self.prefix).filter_map(|name| self.word(name, ProposalKind::Variable)).collect()
    }
}
