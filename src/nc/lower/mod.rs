//! Named rewrites of forms missing on a control; applying them twice changes nothing more.
//!
//! | rewrite | where the control lacks | becomes |
//! |---|---|---|
//! | `plain_texts` | small letters, brackets, `%`, `;` and foreign characters in comments | capitals, `[ ]`, spaces, `?` |
//! | `fold_signs` | nothing; one spelling for one thing | the sign of a constant is part of it |
//! | `drop_points` | the point in numbers of whole-number addresses | the number without it |
//! | `replace_if_then` | `IF … THEN` | a jump over the assignment on the opposite condition |
//! | `other_forms`: | | |
//! | … squares | the square function | `x*x` |
//! | … powers | `POW` | `EXP[b*LN[a]]` |
//! | … added points | `ADP` | the number alone |
//! | … `MOD` | `MOD` | `a-FIX[a/b]*b` |
//! | … `ATAN` of two numbers | the form with two numbers | `2*ATAN[y/[SQRT[x*x+y*y]+x]]` |
//! | … `ATAN` of one number | the form with one number | `ATAN[a]/[1]` |
//! | `clip_texts` | long blocks and messages | comments clipped |

mod characters;
mod other_forms;
mod symbolic;

use std::collections::BTreeMap;

use crate::controls::options::CommentCharacters;
use crate::controls::{Address, Alarm, Control};
use crate::nc::ast::{self, BadBlock, Block, Deck, Expr, Extent, JumpDirection, Stmt, TextId, WordValue};
use crate::nc::dec::Dec;
use crate::nc::write::{is_message, text_length};
use crate::text::Span;
use characters::shown;
use other_forms::other_forms;
use symbolic::{adapt_to_names, replace_names};

/// Rewrites the deck to forms that the control has.
pub fn lower(deck: &Deck, control: &Control) -> Deck {
    lower_with_origins(deck, control, CommentCharacters::Ascii).0
}

/// Rewrites the deck to forms that the control has; for each new block returns the index of its original.
pub(super) fn lower_with_origins(deck: &Deck, control: &Control, characters: CommentCharacters) -> (Deck, Vec<u32>) {
    let mut low = deck.clone();
    if control.syntax.names().is_none() {
        plain_texts(&mut low, characters);
    }
    fold_signs(&mut low);
    if control.syntax.point_alarm {
        drop_points(&mut low, control);
    }
    let mut origins = (0..low.blocks.len() as u32).collect();
    if !control.syntax.if_then && low.blocks.iter().any(|block| matches!(block.stmt, Stmt::IfThen { .. })) {
        origins = replace_if_then(&mut low);
    }
    match &control.syntax.names() {
        Some(names) => adapt_to_names(&mut low, (control, characters), names, &mut origins),
        None => replace_names(&mut low, control),
    }
    other_forms(&mut low, control);
    clip_texts(&mut low, control, characters);
    (low, origins)
}

fn plain_texts(deck: &mut Deck, characters: CommentCharacters) {
    for comment in &mut deck.texts {
        let plain = |c: char| match c {
            '(' => '[',
            ')' => ']',
            '%' | ';' => ' ',
            c => shown(c, characters).to_ascii_uppercase(),
        };
        *comment = comment.chars().map(plain).collect();
    }
    for program in deck.programs.iter_mut().filter(|program| program.number == 0) {
        program.title = None;
    }
}

fn fold_signs(deck: &mut Deck) {
    let whole = |dec: Dec| Dec { point: dec.point || dec.scale > 0, ..dec };
    for at in 0..deck.exprs.len() {
        let rewritten = match deck.exprs[at] {
            Expr::Number(number) => Expr::Number(whole(number)),
            // Children come before their parents, so the inner sign is already rewritten.
            Expr::Negate(inner) => match deck.expr(inner) {
                Expr::Number(number) => Expr::Number(Dec { mantissa: number.mantissa.saturating_neg(), ..number }),
                _ => continue,
            },
            _ => continue,
        };
        deck.exprs[at] = rewritten;
    }
    for word in &mut deck.words {
        if let WordValue::Number(number) = &mut word.value {
            *number = whole(*number);
        }
    }
}

fn drop_points(deck: &mut Deck, control: &Control) {
    for word in deck.words.iter_mut().filter(|word| word.letter != Address::G) {
        if let WordValue::Number(number @ Dec { scale: 0, .. }) = &mut word.value {
            number.point &= !control.syntax.integer_addresses.contains(word.letter);
        }
    }
}

/// `IF[c]THEN #1=2` becomes `IF[not c]GOTOn`, `#1=2`, and a block `Nn` unless the next block has a number.
fn replace_if_then(deck: &mut Deck) -> Vec<u32> {
    let old = core::mem::take(&mut deck.blocks);
    let mut origins = Vec::with_capacity(old.len());
    let mut programs = core::mem::take(&mut deck.programs);
    for program in &mut programs {
        let blocks = old.get(program.first as usize..program.end as usize).unwrap_or_default();
        let mut numbers = BTreeMap::<u32, u32>::new();
        for number in blocks.iter().filter_map(|block| block.number) {
            *numbers.entry(number).or_default() += 1;
        }
        let mut unused = ast::fresh_numbers().filter(|number| !numbers.contains_key(number));
        let first = deck.blocks.len() as u32;
        for (at, block) in blocks.iter().enumerate() {
            let origin = program.first + at as u32;
            let Stmt::IfThen { cond, to, value } = block.stmt else {
                deck.blocks.push(*block);
                origins.push(origin);
                continue;
            };
            let next = blocks.get(at + 1).filter(|next| next.skip == 0).and_then(|next| next.number);
            let next = next.filter(|next| numbers.get(next) == Some(&1));
            let Some(number) = next.or_else(|| unused.next()) else {
                // Every number is taken, so that no block is left to jump to.
                deck.blocks.push(Block { stmt: Stmt::Bad(BadBlock::built(Alarm::NoSequence)), ..*block });
                origins.push(origin);
                continue;
            };
            let cond = deck.add_opposite(cond);
            let target = deck.add_expr(Expr::Number(Dec::int(number.into())));
            let keyword = Extent::default();
            let jump = Stmt::If { cond, target, way: JumpDirection::Around, keyword };
            let block = Block { span: Span::default(), number_at: Extent::default(), ..*block };
            deck.blocks.push(Block { stmt: jump, comment: None, ..block });
            deck.blocks.push(Block { stmt: Stmt::Assign { to, value }, number: None, label: None, ..block });
            origins.extend([origin; 2]);
            if next.is_none() {
                deck.blocks.push(Block { number: Some(number), ..Block::EMPTY });
                origins.push(origin);
            }
        }
        (program.first, program.end) = (first, deck.blocks.len() as u32);
    }
    deck.programs = programs;
    origins
}

/// Shortens comments, to keep blocks below the control's length and messages within its screen.
fn clip_texts(deck: &mut Deck, control: &Control, characters: CommentCharacters) {
    let clip = |deck: &mut Deck, text, room| clip(deck, text, room, characters);
    let room = control.syntax.block_chars.saturating_sub(1);
    for at in 0..deck.programs.len() {
        let Some((title, number)) = deck.programs.get(at).and_then(|p| Some((p.title?, p.number))) else { continue };
        clip(deck, title, room.saturating_sub(number.to_string().len() + 3));
    }
    for at in 0..deck.blocks.len() {
        let Some(block) = deck.blocks.get(at).copied() else { continue };
        if let (Stmt::Message(Some(text)), true) = (block.stmt, control.syntax.names().is_some()) {
            clip(deck, text, control.syntax.message_chars);
        }
        let Some(comment) = block.comment else { continue };
        let message = is_message(deck, control, &block);
        if characters.length(deck.text(Some(comment))) <= (if message { control.syntax.message_chars } else { 0 }) {
            continue;
        }
        let before = text_length(deck, control, &block);
        let gap = usize::from(before > 0 && !message);
        let room = room.saturating_sub(before + gap + 2);
        let room = if message { room.min(control.syntax.message_chars) } else { room };
        clip(deck, comment, room);
    }
}

/// Shortens a text to a number of bytes; it contains only characters of the control here.
fn clip(deck: &mut Deck, comment: TextId, mut room: usize, characters: CommentCharacters) {
    if let Some(text) = deck.text_mut(comment).filter(|text| characters.length(text) > room) {
        let fits = |c: &char| {
            let width = characters.width(*c);
            let fits = width <= room;
            room = if fits { room - width } else { 0 };
            fits
        };
        *text = text.chars().take_while(fits).collect::<String>().trim_end().into();
    }
}
