//! Checks of single words: numbers without a point, F0; and which programs call, return and end.

use super::super::ast::{Block, Stmt, Word, WordValue};
use super::super::dec::{Dec, POW10};
use super::roles::{
    CALL, CURVED, DWELL, EACH_BLOCK, END, INCH, LINEAR, OTHER_FEED, PER_MINUTE, RAPID, RETURN, Roles, SPECIAL, SUB,
};
use super::short::Short;
use super::{Lint, NONE, messages};
use crate::controls::Address;
use crate::controls::AddressSet;
use crate::controls::{Alarm, Code, ParamRole};
use crate::msg;
use crate::text::catalog::number_text;
use crate::text::{Fix, Message, Place, Severity, Span};

/// Programs from this number on are the builder's and the user's standard programs: they are on the machine, and they are called.
const STANDARD: u32 = 8000;

/// Words that are told to overwrite others.
const AGAIN: usize = 20;

/// Programs that are told to be missing.
const MISSED: usize = 100;

/// Places of one kind that a fix reaches.
const PLACES: usize = 1000;

/// Increments from which on a number without a point is meant as it is: in 0.001 mm, nobody who forgets points programs ten metres, and
/// nobody who counts increments does without a centimetre.
const DELIBERATE: u64 = 10_000;

/// Increments of a dwell from which on it is meant as it is.
const DELIBERATE_DWELL: u64 = 100;

/// Feeds per minute below this are meant per revolution: nobody cuts two millimetres a minute.
const SLOWEST: f64 = 2.0;

/// Feeds per revolution above this are meant per minute.
const COARSEST: f64 = 20.0;

/// What a program is to the others.
#[derive(Clone, Copy, Default)]
pub(super) struct Part {
    /// It has a program end.
    pub(super) ends: bool,
    /// It is called in these files.
    pub(super) called: bool,
    /// The words of blocks are its arguments.
    pub(super) each_block: bool,
    /// A block in it may go elsewhere than to the next.
    pub(super) bends: bool,
    /// There is an error in it.
    pub(super) faulty: bool,
    /// Returns of it, `M99`, and the block of the last one.
    returns: u32,
    return_at: u32,
}

impl Part {
    /// Whether it is worth while to follow its jumps, and they are known.
    pub(super) fn follows(&self) -> bool {
        self.bends && !self.faulty
    }
}

/// A call of a program by its number.
#[derive(Clone, Copy)]
pub(super) struct Call {
    pub(super) block: u32,
    /// Indices of the programs.
    pub(super) from: u32,
    pub(super) to: u32,
    /// With arguments, else as a subprogram that shares its caller's locals.
    pub(super) with_locals: bool,
}

/// What one look at all words has told.
#[derive(Default)]
pub(super) struct Facts {
    /// One for each program.
    pub(super) parts: Vec<Part>,
    /// In the order of the blocks.
    pub(super) calls: Vec<Call>,
    /// Programs are called by calculated numbers: any of them may be meant.
    pub(super) any_called: bool,
    /// Sequence numbers that calls and returns name, with the program or [`NONE`] for any.
    pub(super) entries: Vec<(u32, u32)>,
    /// Calls or returns go to calculated sequence numbers.
    pub(super) any_entry: bool,
    /// Numbers of programs that are called and not here.
    missed: Vec<u32>,
    /// Blocks that do not read, with the indices of their programs.
    pub(super) bad: Vec<(u32, u32)>,
    /// Variables and jumps are written as `G65 H`, which nothing here follows.
    pub(super) functions: bool,
}

/// Numbers of one kind behind one letter that have no point.
struct Pointless {
    kind: u32,
    letter: Address,
    count: usize,
    block: u32,
    words: Vec<(Span, Dec)>,
}

/// Looks at every word once.
pub(super) fn survey(lint: &mut Lint, roles: &Roles) -> Facts {
    let deck = lint.deck;
    let mut facts = Facts { parts: vec![Part::default(); deck.programs.len()], ..Facts::default() };
    facts.errors(lint);
    let increments = lint.increments();
    let values = lint.values();
    let mut units = Units::default();
    let mut cutting = Cutting::default();
    for (index, program) in (0..).zip(&deck.programs) {
        let mut pointless: Vec<Pointless> = Vec::new();
        // The program counts increments, and knows it; or inches, of which nothing is said.
        let mut deliberate = false;
        let mut no_feed = false;
        let mut linear = false;
        let mut short = Short::new(lint, increments[0]);
        let mut bends = false;
        for (at, block) in (program.first..).zip(deck.blocks_of(program)) {
            if !matches!(block.stmt, Stmt::Words { .. }) {
                bends |= block.stmt != Stmt::Empty;
                if let Stmt::Bad(_) = block.stmt {
                    cutting.feeds = true;
                    units.written |= facts.bad_block(lint, (index, at), block);
                }
                messages::length(lint, at, block);
                if let Stmt::Call { name, .. } = block.stmt {
                    match lint.programs.name(deck.text(Some(name))) {
                        Some(to) => facts.call(Call { block: at, from: index, to, with_locals: false }),
                        None => lint.missing_name(at, block, deck.text(Some(name))),
                    }
                }
                short.macro_block(&block.stmt);
                continue;
            }
            let words = deck.words_of(block);
            let (mut bits, mut counts, mut feed) = (0, false, None);
            let (mut letters, mut again) = (AddressSet::EMPTY, false);
            for word in words {
                again |= !letters.insert(word.letter) && values.contains(word.letter);
                if matches!(word.letter, Address::G | Address::M | Address::Name) {
                    bits |= roles.word(word);
                } else if let WordValue::Number(dec) = word.value {
                    counts |= !dec.point && dec.mantissa != 0 && increments[0].contains(word.letter);
                    if word.letter == Address::F {
                        feed = Some((word, dec));
                    }
                }
            }
            cutting.feeds |= letters.contains(Address::F);
            if cutting.first.is_none() && bits & LINEAR != 0 && bits & CALL == 0 {
                let moves = |word: &Word| lint.control.axis_letters().any(|letter| letter == word.letter);
                let code = words
                    .iter()
                    .find(|word| matches!(word.letter, Address::G | Address::Name) && roles.word(word) & LINEAR != 0);
                cutting.first = code.filter(|_| words.iter().any(moves)).map(|word| (at, word.span(block)));
            }
            if again && bits & CALL == 0 {
                lint.word_again(at, block, words, values);
            }
            deliberate |= bits & INCH != 0;
            if counts && !deliberate && bits & SPECIAL == 0 {
                let increments = increments[usize::from(bits & CALL != 0)];
                deliberate = collect(&mut pointless, at, block, words, bits & (CALL | DWELL), increments);
            }
            units.written |= bits & (PER_MINUTE | OTHER_FEED | INCH) != 0;
            if bits & (RAPID | LINEAR | CURVED) != 0 {
                linear = bits & LINEAR != 0;
            }
            if let Some((word, dec)) = feed
                && linear
                && bits & (CALL | DWELL | SPECIAL) == 0
            {
                units.feeds.extend((units.feeds.len() < PLACES).then(|| (at, word.span(block), dec)));
            }
            let zero = feed.filter(|(_, dec)| dec.mantissa == 0).map(|(word, _)| word);
            if let Some(word) = zero.filter(|_| bits & (CALL | DWELL) == 0 && !no_feed) {
                no_feed = true;
                let digit = lint.control.param(ParamRole::FeedOneDigit).map_or("", |row| row.number);
                let id = match digit {
                    "" => "lint.feed-zero",
                    _ if lint.parsed.dialect().running.feed_zero_rapid => "lint.feed-zero-rapid",
                    _ => "lint.feed-zero-digit",
                };
                lint.say(at, word.span(block), id, &[digit], "");
            }
            short.block((at, block), words, bits);
            if bits & (CALL | SUB | RETURN | END) != 0 {
                bends |= at + 1 < program.end;
                facts.note(lint, roles, (index, at), words, bits);
            }
        }
        if let Some(part) = facts.parts.get_mut(index as usize) {
            part.bends = bends;
        }
        short.tell(lint);
        for row in pointless.iter().filter(|_| !deliberate) {
            row.tell(lint);
        }
    }
    units.tell(lint);
    // Who is called and not here may set it, or who calls.
    let silent = cutting.feeds || !facts.missed.is_empty() || facts.any_called;
    if let Some((at, span)) = cutting.first.filter(|_| !silent && facts.parts.iter().any(|part| part.ends)) {
        let alarm = lint.control.alarm_number(Alarm::NoFeed).unwrap_or("");
        lint.say(at, span, "lint.no-feed", &[alarm], "");
    }
    facts
}

/// Cutting motions, and whether anything can set a feed.
#[derive(Default)]
struct Cutting {
    feeds: bool,
    /// The first code of one, with its block.
    first: Option<(u32, Span)>,
}

/// Notes the numbers without a point of a block; true where one shows that the program counts increments.
#[cold]
fn collect(
    rows: &mut Vec<Pointless>,
    at: u32,
    block: &Block,
    words: &[Word],
    kind: u32,
    increments: AddressSet,
) -> bool {
    for word in words {
        let WordValue::Number(dec) = word.value else { continue };
        let letter = word.letter;
        let size = dec.mantissa.unsigned_abs();
        if dec.point || size == 0 || !increments.contains(letter) || kind == DWELL && size >= DELIBERATE_DWELL {
            continue;
        }
        if size >= DELIBERATE {
            return true;
        }
        let known = rows.iter().position(|row| row.kind == kind && row.letter == letter);
        if known.is_none() {
            rows.push(Pointless { kind, letter, count: 0, block: at, words: Vec::new() });
        }
        if let Some(row) = known.map_or(rows.len().checked_sub(1), Some).and_then(|at| rows.get_mut(at)) {
            row.count += 1;
            if row.count <= PLACES {
                row.words.push((word.span(block), dec));
            }
        }
    }
    false
}

impl Facts {
    /// Notes calls, returns and ends of a block, both by index.
    fn note(&mut self, lint: &mut Lint, roles: &Roles, (program, block): (u32, u32), words: &[Word], bits: u32) {
        let number = |letter: Address| words.iter().find(|word| word.letter == letter).map(|word| whole(word.value));
        let Some(part) = self.parts.get_mut(program as usize) else { return };
        part.ends |= bits & END != 0;
        if bits & RETURN != 0 {
            part.returns += 1;
            part.return_at = block;
            self.entry(NONE, number(Address::P));
        }
        let macros = &lint.control.macros;
        if bits & CALL != 0 && !macros.functions.is_empty() && number(Address::H).is_some() {
            self.functions = true;
        } else if bits & (CALL | SUB) != 0 {
            let sub = bits & SUB != 0;
            let to = match (roles.called(words), number(Address::P)) {
                (Some(number), _) => lint.programs.number(number),
                (None, Some(Some(number))) => {
                    let called = if sub && macros.repeats_in_p { number % 10_000 } else { number };
                    let to = lint.programs.number(called);
                    // Of repeats in P the reader tells.
                    if to.is_none() && (called <= 9999 || lint.programs.number(called % 10_000).is_none()) {
                        self.missing(lint, block, words, called);
                    }
                    to
                }
                (None, None) => {
                    if sub && macros.sub_sequence && number(Address::H).is_none() {
                        lint.say_word(block, words, Address::M, "lint.calls-itself", &[]);
                    }
                    sub.then_some(program)
                }
                (None, Some(None)) => {
                    self.any_called = true;
                    None
                }
            };
            if sub && macros.sub_sequence {
                self.entry(to.unwrap_or(NONE), number(Address::H));
            }
            if let Some(to) = to
                && let Some(part) = self.parts.get_mut(to as usize)
            {
                part.each_block |= bits & EACH_BLOCK != 0;
                self.call(Call { block, from: program, to, with_locals: !sub });
            }
        }
    }

    /// A call of a program that is in none of the files, each such program once. Those from 8000 on are the builder's and the user's
    /// standard programs: they are on the machine.
    fn missing(&mut self, lint: &mut Lint, block: u32, words: &[Word], number: u32) {
        if !self.missed.contains(&number) && self.missed.len() < MISSED {
            self.missed.push(number);
            let alarm = lint.control.alarm_number(Alarm::NoProgram).unwrap_or("");
            lint.say_word(block, words, Address::P, "lint.no-such-program", &[&format!("O{number}"), alarm]);
            if let Some(finding) = lint.found.last_mut().filter(|_| number >= STANDARD) {
                finding.severity = Severity::Info;
            }
        }
    }

    fn call(&mut self, call: Call) {
        if let Some(part) = self.parts.get_mut(call.to as usize) {
            // A program that calls itself has no other caller by that.
            part.called |= call.to != call.from;
            self.calls.push(call);
        }
    }

    /// A sequence number behind P of a return or H of a call.
    fn entry(&mut self, program: u32, number: Option<Option<u32>>) {
        match number {
            Some(Some(label)) => self.entries.push((program, label)),
            Some(None) => self.any_entry = true,
            None => {}
        }
    }

    /// A main program that returns starts again for ever. Whether a program is one is known of the started program; of others only where
    /// nothing here can be one.
    pub(super) fn main_returns(&self, lint: &mut Lint) {
        if lint.control.macros.main_ends {
            return;
        }
        let ends = self.any_called || self.parts.iter().any(|part| part.ends);
        let main = match lint.start {
            Some(number) => lint.programs.number(number),
            None => lint.deck.programs.first().filter(|row| row.number < STANDARD && !ends).map(|_| 0),
        };
        let end = lint.control.codes.iter().find(|row| row.code == Code::EndRewind);
        if let (Some(main), Some(end)) = (main, end)
            && let Some(part) = self.parts.get(main as usize)
            && part.returns > 0
            && !part.faulty
            && !part.called
            && !part.ends
            && let Some(block) = lint.deck.blocks.get(part.return_at as usize)
            && let Some(word) = lint.deck.words_of(block).iter().find(|word| word.letter == Address::M)
        {
            let span = word.span(block);
            let end = lint.control.code_name(end.id);
            lint.say(part.return_at, span, "lint.main-returns", &[&end], "");
            if part.returns == 1 {
                lint.fix(msg!("nc.fix.end-main", end.as_str()), &[(span, Dec::default())], &|_| end.clone());
            }
        }
    }
}

/// A whole number that is written as one.
pub(super) fn whole(value: WordValue) -> Option<u32> {
    let WordValue::Number(dec) = value else { return None };
    let unit = POW10[dec.scale.min(18) as usize];
    if dec.mantissa % unit == 0 { u32::try_from(dec.mantissa / unit).ok() } else { None }
}

/// Feeds of straight lines, and whether any program says what they are per.
#[derive(Default)]
struct Units {
    written: bool,
    feeds: Vec<(u32, Span, Dec)>,
}

impl Units {
    /// Where nothing says what F is per, it is what it is after power-on: one look at its size shows whether that was meant.
    fn tell(&self, lint: &mut Lint) {
        let mut startup = lint.parsed.dialect().startup.iter().filter_map(|id| lint.control.code(*id));
        let revolution = startup.any(|row| row.code == Code::FeedPerRevolution);
        let (id, other) = match revolution {
            true => ("lint.feed-per-revolution", Code::FeedPerMinute),
            false => ("lint.feed-per-minute", Code::FeedPerRevolution),
        };
        let strange = |dec: &Dec| {
            let feed = dec.to_f64();
            if revolution { feed > COARSEST } else { feed > 0.0 && feed < SLOWEST }
        };
        // One feed of a usual size, and the unit is meant.
        if self.written || self.feeds.iter().any(|(_, _, dec)| !strange(dec)) {
            return;
        }
        let row = lint.control.codes.iter().find(|row| row.code == other);
        if let (Some(&(at, span, dec)), Some(row)) = (self.feeds.first(), row) {
            let code = lint.control.code_name(row.id);
            let count = number_text(self.feeds.len() as f64, 0);
            lint.say(at, span, id, &[&number_text(dec.to_f64(), 6), &code, &count], "");
            lint.fix(msg!("lint.fix.unit", code.as_str()), &[(span, dec)], &|dec| format!("{code} F{dec}"));
        }
    }
}

impl Pointless {
    fn tell(&self, lint: &mut Lint) {
        let Some(&(span, dec)) = self.words.first() else { return };
        let step = lint.control.limits.increment;
        let letter = self.letter.to_string();
        let rotary = lint.control.axis(self.letter).is_some_and(|axis| lint.control.axes[axis].rotary);
        let id = match self.kind {
            DWELL => "lint.no-point-dwell",
            CALL => "lint.no-point-argument",
            _ => "lint.no-point",
        };
        let value = number_text(dec.to_f64() * step, 6);
        let unit = if rotary { "°" } else { "mm" };
        let count = number_text(self.count as f64, 0);
        lint.say(self.block, span, id, &[&value, unit, &count, &letter], "");
        let meant = |dec: Dec| format!("{letter}{}", Dec { point: true, ..dec });
        if self.count == self.words.len() {
            lint.fix(msg!("lint.fix.point", meant(dec)), &self.words, &meant);
            // As it is now: the control's increments are thousandths.
            let present = |dec: Dec| format!("{letter}{}", number_text(dec.to_f64() * step, 9));
            lint.fix(msg!("lint.fix.present", present(dec)), &self.words, &present);
        }
    }
}

impl Lint<'_> {
    /// Addresses whose values overwrite each other in a block, where that is no alarm.
    fn values(&self) -> AddressSet {
        if self.control.syntax.address_twice || self.control.syntax.names().is_some() {
            return AddressSet::EMPTY;
        }
        self.control.axis_letters().chain([Address::F, Address::S, Address::T]).collect()
    }

    /// The second word of an address in a block.
    #[cold]
    fn word_again(&mut self, at: u32, block: &Block, words: &[Word], values: AddressSet) {
        // In front of a skip in the middle of the block it may be meant.
        if self.again >= AGAIN || words.iter().any(|word| word.letter == Address::Skip) {
            return;
        }
        for (index, word) in words.iter().enumerate() {
            let earlier = words.iter().take(index).rfind(|other| other.letter == word.letter);
            if let Some(earlier) = earlier.filter(|_| values.contains(word.letter)) {
                self.again += 1;
                let place = self.place(at, earlier.span(block));
                let text = self.parsed.text(place).to_owned();
                self.say(at, word.span(block), "lint.word-again", &[&text], "");
            }
        }
    }

    /// Says a sentence about the word with a letter in a block, or the block itself.
    fn say_word(&mut self, block: u32, words: &[Word], letter: Address, id: &'static str, more: &[&str]) {
        let Some(row) = self.deck.blocks.get(block as usize) else { return };
        let span = words.iter().find(|word| word.letter == letter).map_or(row.span, |word| word.span(row));
        self.say(block, span, id, more, "");
    }

    /// A call by a name that no program here has, where the reader has nothing to say of it.
    fn missing_name(&mut self, at: u32, block: &Block, name: &str) {
        let place = self.place(at, block.span);
        let within = |other: Place| {
            other.file == place.file && place.span.start <= other.span.start && other.span.end <= place.span.end
        };
        if self.parsed.diagnostics().iter().filter_map(|finding| finding.place).any(within) {
            return;
        }
        let text = self.parsed.text(place).to_ascii_uppercase();
        let start = place.span.start + text.rfind(name).unwrap_or(0) as u32;
        let span = Span::new(start, (start + name.len() as u32).min(place.span.end));
        let alarm = self.control.alarm_number(Alarm::NoProgram).unwrap_or("");
        self.say(at, span, "lint.no-such-program", &[name, alarm], "");
    }

    /// Mends the last finding by another text for each of these words of its file.
    fn fix(&mut self, title: Message, words: &[(Span, Dec)], text: &dyn Fn(Dec) -> String) {
        if let Some(finding) = self.found.last_mut()
            && let Some(place) = finding.place
        {
            let edits = words.iter().map(|&(span, dec)| (Place { span, ..place }, text(dec))).collect();
            finding.fixes.push(Fix { title, edits });
        }
    }
}
