//! Rewrites to languages with names, and of names in languages without.
//!
//! | rewrite | where | becomes |
//! |---|---|---|
//! | `texts` | foreign characters in comments, quotes in messages | `?`, `'` |
//! | `programs` | a program without a name | `L9100`, `MPF1` |
//! | `plain_whole_numbers` | the point of a whole number | the number without it |
//! | `jumps` | loops, jumps to block numbers | jumps to labels |
//! | `titles` | the comment after a program's number | a block of its own |
//! | `replace_names` | calls by name, messages, statements without a form there | `M98`, a comment |

use std::collections::{BTreeMap, BTreeSet};

use crate::controls::Address;
use crate::controls::options::CommentCharacters;
use crate::controls::syntax::Names;
use crate::controls::{Alarm, Code, CodeId, Control};
use crate::nc::ast::{BadBlock, Block, Deck, Expr, Extent, JumpDirection, Program, Stmt, TextId, Word, WordValue};
use crate::nc::codes::code_of;
use crate::nc::dec::Dec;
use crate::nc::lex::names::number_in;
use crate::nc::lower::characters::shown;
use crate::text::Span;

/// All rewrites for a language with names; `origins` is updated with the blocks.
pub(super) fn adapt_to_names(
    deck: &mut Deck,
    (control, characters): (&Control, CommentCharacters),
    names: &Names,
    origins: &mut Vec<u32>,
) {
    texts(deck, characters);
    programs(deck, control, names);
    plain_whole_numbers(deck, names);
    jumps(deck, origins);
    titles(deck, origins);
}

fn rewrite(deck: &mut Deck, id: Option<TextId>, change: impl Fn(char) -> char) {
    if let Some(text) = id.and_then(|id| deck.text_mut(id)) {
        *text = text.chars().map(change).collect::<String>().trim_end().into();
    }
}

fn texts(deck: &mut Deck, characters: CommentCharacters) {
    let plain = |c| shown(c, characters);
    for at in 0..deck.blocks.len() {
        let block = deck.blocks[at];
        rewrite(deck, block.comment, plain);
        if let Stmt::Message(text) = block.stmt {
            rewrite(deck, text, |c| if c == '"' { '\'' } else { plain(c) });
        }
    }
    for at in 0..deck.programs.len() {
        rewrite(deck, deck.programs[at].title, plain);
    }
}

/// Gives every program a name with its number in it.
fn programs(deck: &mut Deck, control: &Control, names: &Names) {
    for at in 0..deck.programs.len() {
        let program = deck.programs[at].clone();
        if program.name.is_some() {
            continue;
        }
        let sub = program.sub || returns(deck, control, &program);
        let name = match program.number {
            0 => "PROGRAM".to_owned(),
            number => format!("{}{number}", if sub { "L" } else { names.endings[0] }),
        };
        let number = number_in(names, &name);
        let name = Some(deck.add_text(name));
        deck.programs[at] = Program { name, sub, number, ..program };
    }
}

/// Whether a program returns and has no program end.
fn returns(deck: &Deck, control: &Control, program: &Program) -> bool {
    let (mut returns, mut ends) = (false, false);
    for word in deck.blocks_of(program).iter().flat_map(|block| deck.words_of(block)) {
        let Some(id @ (CodeId::M(_) | CodeId::Named(_))) = code_of(word) else { continue };
        match control.code(id).map(|row| row.code) {
            Some(Code::SubEnd | Code::Return) => returns = true,
            Some(Code::End | Code::EndRewind) => ends = true,
            _ => {}
        }
    }
    returns && !ends
}

/// Removes the point of whole numbers unless they are too large without it; a constant expression as a word's value becomes a number.
fn plain_whole_numbers(deck: &mut Deck, names: &Names) {
    let plain = |number: Dec| match number.scale {
        0 => Dec { point: number.mantissa.unsigned_abs() > names.whole_max.unsigned_abs(), ..number },
        _ => number,
    };
    for expr in &mut deck.exprs {
        if let Expr::Number(number) = expr {
            *number = plain(*number);
        }
    }
    for word in &mut deck.words {
        let number = match word.value {
            WordValue::Number(number) => Some(number),
            WordValue::Expr(id) => match deck.exprs.get(id.0 as usize) {
                Some(Expr::Number(number)) => Some(*number),
                _ => None,
            },
        };
        if let Some(number) = number {
            word.value = WordValue::Number(plain(number));
        }
    }
}

/// Rewrites loops and jumps to numbers as jumps to labels.
fn jumps(deck: &mut Deck, origins: &mut Vec<u32>) {
    let round = |way: JumpDirection| way == JumpDirection::Around;
    let strange = |block: &Block| match block.stmt {
        Stmt::While { .. } | Stmt::End { .. } => true,
        Stmt::If { way, .. } | Stmt::Goto { way, .. } => round(way),
        _ => false,
    };
    if !deck.blocks.iter().any(strange) {
        return;
    }
    rebuild(deck, origins, |deck, _, (blocks, origin), origins| {
        Labels::new(deck, blocks).write(deck, blocks, origin, origins);
    });
}

/// Writes every program anew: `write` gets the deck, the program, its present blocks with their origins, and the list of the new origins.
fn rebuild(
    deck: &mut Deck,
    origins: &mut Vec<u32>,
    write: impl Fn(&mut Deck, &mut Program, (&[Block], &[u32]), &mut Vec<u32>),
) {
    let old = core::mem::take(&mut deck.blocks);
    let from = core::mem::take(origins);
    let mut programs = core::mem::take(&mut deck.programs);
    for program in &mut programs {
        let range = program.first as usize..program.end as usize;
        let present = (old.get(range.clone()).unwrap_or_default(), from.get(range).unwrap_or_default());
        let first = deck.blocks.len() as u32;
        write(deck, program, present, origins);
        (program.first, program.end) = (first, deck.blocks.len() as u32);
    }
    deck.programs = programs;
}

/// Targets of the jumps of a program, and their labels.
struct Labels {
    /// Label in front of each block, and after the last one.
    before: Vec<Option<TextId>>,
    /// Target block of each jump; for the exit of a loop the block after its END.
    to: Vec<Option<usize>>,
}

impl Labels {
    fn new(deck: &mut Deck, blocks: &[Block]) -> Labels {
        let numbers = numbered(blocks);
        let mut to = vec![None; blocks.len()];
        let mut open: Vec<(u16, usize)> = Vec::new();
        for (at, block) in blocks.iter().enumerate() {
            match block.stmt {
                Stmt::While { label, .. } => open.push((label, at)),
                Stmt::End { label, .. } => {
                    if let Some((_, start)) = open.pop_if(|row| row.0 == label) {
                        to[at] = Some(start);
                        to[start] = Some(at + 1);
                    }
                }
                Stmt::If { target, way: JumpDirection::Around, .. }
                | Stmt::Goto { target, way: JumpDirection::Around, .. } => {
                    if let Expr::Number(Dec { mantissa: number, scale: 0, .. }) = deck.expr(target) {
                        let places = numbers.get(&number).map_or(&[][..], Vec::as_slice);
                        to[at] = JumpDirection::Around.nearest(at, places);
                    }
                }
                _ => {}
            }
        }
        let mut before: Vec<Option<TextId>> = blocks.iter().map(|block| block.label).chain([None]).collect();
        let mut taken: BTreeSet<String> = before.iter().flatten().map(|id| deck.text(Some(*id)).to_owned()).collect();
        let mut others = (1..1_000_000).map(|k| format!("LC{k}"));
        for target in to.clone().into_iter().flatten() {
            if before.get(target).is_some_and(Option::is_none) {
                let number = blocks.get(target).and_then(|block| block.number);
                let wished = number.into_iter().map(|number| format!("LB{number}"));
                let mut names = wished.chain(&mut others);
                let name = names.find(|name| name.len() <= 8 && !taken.contains(name)).unwrap_or_default();
                taken.insert(name.clone());
                before[target] = Some(deck.add_text(name));
            }
        }
        Labels { before, to }
    }

    /// Writes the blocks of the program with labels and rewritten jumps.
    fn write(&self, deck: &mut Deck, blocks: &[Block], from: &[u32], origins: &mut Vec<u32>) {
        for (at, block) in blocks.iter().enumerate() {
            let origin = from.get(at).copied().unwrap_or(0);
            let label = self.before.get(at).copied().flatten();
            let mut block = Block { label, ..*block };
            let stmt = self.jump(deck, blocks, at);
            if stmt != block.stmt || label != blocks[at].label {
                block.span = Span::default();
            }
            block.stmt = stmt;
            deck.blocks.push(block);
            origins.push(origin);
        }
        // A loop at the end of the program exits to after it.
        if let Some(label) = self.before.last().copied().flatten() {
            deck.blocks.push(Block { label: Some(label), ..Block::EMPTY });
            origins.push(from.last().copied().unwrap_or(0));
        }
    }

    /// The statement of a block, with its jump to a label.
    fn jump(&self, deck: &mut Deck, blocks: &[Block], at: usize) -> Stmt {
        let stmt = blocks[at].stmt;
        let to = self.to.get(at).copied().flatten();
        let way = if to.is_some_and(|to| to <= at) { JumpDirection::Backward } else { JumpDirection::Forward };
        let label = to.and_then(|to| self.before.get(to).copied().flatten());
        match (stmt, label) {
            (Stmt::While { cond: None, .. }, Some(_)) => Stmt::Empty,
            (Stmt::While { cond: Some(cond), .. }, Some(label)) => {
                let target = deck.add_expr(Expr::Label(label));
                let cond = deck.add_opposite(cond);
                Stmt::If { cond, target, way, keyword: Extent::default() }
            }
            (Stmt::End { .. }, Some(label)) => {
                Stmt::Goto { target: deck.add_expr(Expr::Label(label)), way, keyword: Extent::default() }
            }
            (Stmt::If { cond, way: JumpDirection::Around, .. }, Some(label)) => {
                Stmt::If { cond, target: deck.add_expr(Expr::Label(label)), way, keyword: Extent::default() }
            }
            (Stmt::Goto { way: JumpDirection::Around, .. }, Some(label)) => {
                Stmt::Goto { target: deck.add_expr(Expr::Label(label)), way, keyword: Extent::default() }
            }
            (
                Stmt::If { target, way: JumpDirection::Around, .. }
                | Stmt::Goto { target, way: JumpDirection::Around, .. },
                None,
            ) => {
                // A missing number becomes a label, for the control to report. A calculated number has no label.
                let number = match deck.expr(target) {
                    Expr::Number(Dec { mantissa: number @ 0..=999_999, scale: 0, .. }) => number,
                    _ => return Stmt::Bad(BadBlock::built(Alarm::NoSequence)),
                };
                let label = deck.add_text(format!("LB{number}"));
                let (target, way) = (deck.add_expr(Expr::Label(label)), JumpDirection::Forward);
                match stmt {
                    Stmt::If { cond, .. } => Stmt::If { cond, target, way, keyword: Extent::default() },
                    _ => Stmt::Goto { target, way, keyword: Extent::default() },
                }
            }
            // A loop without its other end.
            (Stmt::While { .. } | Stmt::End { .. }, None) => Stmt::Bad(BadBlock::built(Alarm::DoPair)),
            (stmt, _) => stmt,
        }
    }
}

/// Blocks of a program by number, in rising order.
fn numbered(blocks: &[Block]) -> BTreeMap<i64, Vec<usize>> {
    let mut numbers = BTreeMap::<i64, Vec<usize>>::new();
    for (at, block) in blocks.iter().enumerate() {
        if let Some(number) = block.number {
            numbers.entry(number.into()).or_default().push(at);
        }
    }
    numbers
}

/// Turns the comment after a program's number into a block.
fn titles(deck: &mut Deck, origins: &mut Vec<u32>) {
    if deck.programs.iter().all(|program| program.title.is_none()) {
        return;
    }
    rebuild(deck, origins, |deck, program, (blocks, origin), origins| {
        if let Some(comment) = program.title.take() {
            deck.blocks.push(Block { comment: Some(comment), ..Block::EMPTY });
            // In a program without blocks the title has no original block.
            origins.push(origin.first().copied().unwrap_or(u32::MAX));
        }
        deck.blocks.extend(blocks);
        origins.extend(origin);
    });
}

/// Rewrites a deck for a language without names.
pub(super) fn replace_names(deck: &mut Deck, control: &Control) {
    let row = control.codes.iter().find_map(|row| match row.id {
        CodeId::M(number) if row.code == Code::SubCall => Some(number),
        _ => None,
    });
    for program in &mut deck.programs {
        (program.name, program.sub) = (None, false);
    }
    for at in 0..deck.blocks.len() {
        let block = deck.blocks[at];
        let stmt = match block.stmt {
            Stmt::Message(text) => {
                let comment = block.comment.or(text);
                deck.blocks[at] = Block { comment, ..block };
                Stmt::Empty
            }
            Stmt::Call { name, repeats } => {
                let number = deck.text(Some(name)).strip_prefix('L').and_then(|digits| digits.parse::<u32>().ok());
                match row.zip(number) {
                    Some((row, number)) => {
                        let first = deck.words.len() as u32;
                        let mut word = |letter, value| deck.words.push(Word::new(letter, value));
                        word(Address::M, WordValue::Number(Dec::int(row.into())));
                        word(Address::P, WordValue::Number(Dec::int(number.into())));
                        if let Some(repeats) = repeats {
                            let value = match deck.exprs.get(repeats.0 as usize) {
                                Some(Expr::Number(number)) => WordValue::Number(*number),
                                _ => WordValue::Expr(repeats),
                            };
                            word(Address::L, value);
                        }
                        Stmt::Words { first, count: 2 + u16::from(repeats.is_some()) }
                    }
                    None => Stmt::Bad(BadBlock::built(Alarm::NoProgram)),
                }
            }
            Stmt::Ifs { .. } => Stmt::Bad(BadBlock::built(Alarm::Format)),
            stmt => stmt,
        };
        deck.blocks[at].stmt = stmt;
        (deck.blocks[at].label, deck.blocks[at].main) = (None, false);
        if stmt != block.stmt {
            deck.blocks[at].span = Span::default();
        }
    }
}
