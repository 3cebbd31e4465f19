//! One pass over all words: warnings about single blocks, and facts for the other checks.

use super::super::ast::{Block, Program, Stmt, TextId, Word, WordValue};
use super::super::codes::are_data;
use super::again::Rivals;
use super::context::Lint;
use super::facts::{Call, Facts, ProgramFacts};
use super::feed_unit::FeedUnit;
use super::feeds::Feeds;
use super::messages;
use super::points::Points;
use super::roles::{CALL, DATA, DWELL, END, RETURN, Roles, SUB, SURFACE};
use super::short::Short;
use crate::controls::address::LETTERS;
use crate::controls::{Address, AddressSet, Alarm};
use crate::msg;
use crate::nc::lex::names::meant_name;
use crate::nc::lex::spelling::zero_as_letter;
use crate::text::{Place, either};

/// Visits every word once.
pub(super) fn survey(lint: &mut Lint, roles: &Roles) -> Facts {
    let programs = lint.deck.programs.len();
    let facts = Facts { programs: vec![ProgramFacts::default(); programs], ..Facts::default() };
    let mut survey = Survey {
        roles,
        increments: lint.increments(),
        rivals: Rivals::new(lint),
        facts,
        feeds: Feeds::default(),
        unit: FeedUnit::default(),
    };
    survey.facts.errors(lint);
    for (index, program) in (0..).zip(&lint.deck.programs) {
        survey.program(lint, index, program);
    }
    survey.feeds.report(lint, &survey.facts);
    survey.facts
}

/// State of the pass.
struct Survey<'a> {
    roles: &'a Roles<'a>,
    /// Addresses that count increments: in dimensions, and in macro arguments.
    increments: [AddressSet; 2],
    /// Words of a block that take the place of each other.
    rivals: Rivals,
    facts: Facts,
    feeds: Feeds,
    unit: FeedUnit,
}

/// State of the pass in one program.
struct InProgram {
    index: u32,
    points: Points,
    short: Short,
    /// A block so far may jump, or does not parse.
    forks: bool,
    /// Blocks without a code are data for the control.
    data: bool,
}

impl Survey<'_> {
    fn program(&mut self, lint: &mut Lint, index: u32, program: &Program) {
        let short = Short::new(lint, self.increments[0]);
        let mut here = InProgram { index, points: Points::new(self.increments), short, forks: false, data: false };
        self.feeds.program();
        self.unit.program(lint, index);
        let mut bends = false;
        for (at, block) in (program.first..).zip(lint.deck.blocks_of(program)) {
            if !matches!(block.stmt, Stmt::Words { .. }) {
                bends |= block.stmt != Stmt::Empty;
                self.statement(lint, &mut here, (at, block));
            } else if self.words(lint, &mut here, (at, block)) {
                bends |= at + 1 < program.end;
            }
        }
        if let Some(part) = self.facts.programs.get_mut(index as usize) {
            part.bends = bends;
        }
        here.short.report(lint);
        here.points.report(lint);
    }

    /// Records a statement other than words.
    fn statement(&mut self, lint: &mut Lint, here: &mut InProgram, (at, block): (u32, &Block)) {
        if let Stmt::Bad(_) = block.stmt {
            let unit = self.facts.bad_block(lint, (here.index, at), block);
            self.feeds.bad_block(unit);
        }
        self.unit.statement(block.stmt);
        here.forks |= !matches!(block.stmt, Stmt::Empty | Stmt::Assign { .. } | Stmt::Message(_) | Stmt::Call { .. });
        messages::length(lint, at, block);
        if let Stmt::Call { name, .. } = block.stmt {
            match lint.programs.name(lint.deck.text(Some(name))) {
                Some(to) => {
                    if to == here.index && !here.forks && block.skip == 0 {
                        lint.own_call(lint.place(at, lint.parsed.text_span(name)));
                    }
                    self.facts.call(Call { block: at, from: here.index, to, with_locals: false });
                }
                None => lint.missing_name(at, block, name),
            }
        }
        here.short.macro_block(&block.stmt);
    }

    /// Records a block of words; returns whether it calls, returns or ends.
    fn words(&mut self, lint: &mut Lint, here: &mut InProgram, (at, block): (u32, &Block)) -> bool {
        let words = lint.deck.words_of(block);
        if here.data && are_data(words) {
            return false;
        }
        let (mut bits, mut counts, mut feed) = (0, false, None);
        let (mut letters, mut again, mut codes) = (AddressSet::EMPTY, false, 0);
        for word in words {
            again |= !letters.insert(word.letter) && self.rivals.overwrites(word.letter);
            codes += u32::from(word.letter == Address::G);
            if matches!(word.letter, Address::G | Address::M | Address::Name) {
                bits |= self.roles.word(word);
            } else if let WordValue::Number(number) = word.value {
                counts |= here.points.counts(word.letter, number);
                if word.letter == Address::F {
                    feed = Some((word, number));
                }
            }
        }
        here.data = bits & DATA != 0 && lint.parsed.codes().opens_data(words);
        self.facts.surface |= bits & SURFACE != 0;
        if bits & (DWELL | CALL) == DWELL {
            lint.dwell_times(self.roles, (at, block), words);
        }
        if bits & CALL != 0 {
            lint.call_words(self.roles, (at, block), words);
        } else {
            if again {
                lint.word_again(at, block, words, self.rivals);
            }
            if bits & DWELL == 0 && self.rivals.may_meet(letters, codes) {
                lint.rivals(at, block, words);
            }
        }
        here.points.block(at, block, words, bits, counts);
        self.feeds.block(lint, self.roles, (at, block), (words, bits), (letters, feed));
        self.unit.block(lint, (at, block), words, bits);
        here.short.block((at, block), words, bits);
        let goes = bits & (CALL | SUB | RETURN | END) != 0;
        if goes {
            let known = self.facts.calls.len();
            self.facts.note(lint, self.roles, (here.index, at), words, bits);
            let own = self.facts.calls.get(known).is_some_and(|call| call.to == here.index);
            if own
                && letters.contains(Address::P)
                && !(here.forks || block.skip > 0 || lint.control.raises(Alarm::OwnCall))
            {
                lint.own_call(lint.written_word(at, words, Address::P).0);
            }
            here.forks |= bits & (RETURN | END) != 0;
        }
        goes
    }
}

impl Lint<'_> {
    /// Reports a dwell without its time, or with times of two addresses, of which the last one counts here. The reader reports both in a
    /// language with names.
    #[cold]
    fn dwell_times(&mut self, roles: &Roles, (at, block): (u32, &Block), words: &[Word]) {
        let syntax = &self.control.syntax;
        let Some(code) = words.iter().find(|word| word.letter == Address::G && roles.word(word) & DWELL != 0) else {
            return;
        };
        if syntax.names().is_some() {
            return;
        }
        let mut times = words.iter().filter(|word| syntax.dwell_addresses.contains(word.letter)).rev();
        let Some(last) = times.next() else {
            let letters = LETTERS.into_iter().filter(|letter| syntax.dwell_addresses.contains(*letter));
            let letters: Vec<String> = letters.map(|letter| letter.to_string()).collect();
            let (place, code) = self.written(at, code.span(block));
            self.warn(place, msg!("lint.dwell-without-time", code, addresses = either(&letters)));
            return;
        };
        // A block with a `/` in its middle may have two times on purpose.
        let skips = words.iter().any(|word| word.letter == Address::Skip);
        if let Some(lost) = times.find(|word| word.letter != last.letter && !skips) {
            let lost = self.written(at, lost.span(block)).1;
            let (place, word) = self.written(at, last.span(block));
            self.warn(place, msg!("lint.dwell-again", word, lost));
        }
    }

    /// Reports a call of the program in which it is, on a control without an alarm for it.
    fn own_call(&mut self, place: Place) {
        let call = self.parsed.text(place);
        self.warn(place, msg!("lint.calls-own-program", call));
    }

    /// Reports a call of a name missing in these files, unless the reader has reported the block.
    fn missing_name(&mut self, at: u32, block: &Block, name: TextId) {
        let place = self.place(at, block.span);
        if self.is_full()
            || self.parsed.diagnostics().iter().filter_map(|finding| finding.place).any(|other| place.covers(other))
        {
            return;
        }
        let place = self.place(at, self.parsed.text_span(name));
        let alarm = self.control.alarm_number(Alarm::NoProgram).unwrap_or("");
        let program = self.deck.text(Some(name));
        let zero = zero_as_letter(program).then(|| program.replace(['O', 'o'], "0"));
        let meant = || self.control.syntax.names().and_then(|names| meant_name(names, program, false));
        let meant = zero.or_else(meant);
        if let Some(finding) = self.warn(place, msg!("lint.no-such-program", program, alarm)) {
            finding.hints.extend(meant.map(|code| msg!("nc.hint.code-meant", code)));
        }
    }
}
