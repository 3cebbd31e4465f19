//! A ladder as an instruction list in the language of the control's PLC.

use super::{Bit, Branches, DECODED, Ladder, Operator, PlcNumber, PlcWidth, Rung, RungAction};
use crate::controls::interface::{PlcLanguage, SignalRole};

/// Words of an instruction list for contacts: first, its inverse; next in series, its inverse; parallel, its inverse; joining a branch.
struct Words {
    load: [&'static str; 2],
    and: [&'static str; 2],
    or: [&'static str; 2],
    /// First contact of a further branch.
    branch: [&'static str; 2],
    join: &'static str,
    coil: &'static str,
}

fn words(language: PlcLanguage) -> Words {
    match language {
        PlcLanguage::Pmc => Words {
            load: ["RD", "RD.NOT"],
            and: ["AND", "AND.NOT"],
            or: ["OR", "OR.NOT"],
            branch: ["RD.STK", "RD.NOT.STK"],
            join: "OR.STK",
            coil: "WRT",
        },
        PlcLanguage::Gsk | PlcLanguage::Melsec => Words {
            load: ["LD", "LDI"],
            and: ["AND", "ANI"],
            or: ["OR", "ORI"],
            branch: ["LD", "LDI"],
            join: "ORB",
            coil: "OUT",
        },
        PlcLanguage::Step7 => Words {
            load: ["LD", "LDN"],
            and: ["A", "AN"],
            or: ["O", "ON"],
            branch: ["LD", "LDN"],
            join: "OLD",
            coil: "=",
        },
    }
}

impl Ladder {
    /// The instructions of a rung, contacts first.
    pub fn instructions(&self, rung: &Rung) -> Vec<String> {
        let melsec_decoding = matches!(rung.action, RungAction::Decode { .. }) && self.language == PlcLanguage::Melsec;
        let mut list = if melsec_decoding { Vec::new() } else { self.contacts(&rung.when) };
        list.extend(self.action(rung));
        list
    }

    fn contacts(&self, when: &Branches) -> Vec<String> {
        let words = words(self.language);
        let mut list = Vec::new();
        for (number, branch) in when.iter().enumerate() {
            let alone = branch.len() == 1;
            for (place, contact) in branch.iter().enumerate() {
                let word = match (number, place) {
                    (0, 0) => words.load,
                    (_, 0) if alone => words.or,
                    (_, 0) => words.branch,
                    _ => words.and,
                };
                list.push(format!("{} {}", word[usize::from(contact.opens)], self.bit(contact.bit)));
            }
            if number > 0 && !alone {
                list.push(words.join.to_owned());
            }
        }
        list
    }

    fn action(&self, rung: &Rung) -> Vec<String> {
        let coil = |bit: Bit| format!("{} {}", words(self.language).coil, self.bit(bit));
        match rung.action {
            RungAction::Coil(bit) => vec![coil(bit)],
            RungAction::Timer(name, ms) => self.timer(Bit::Timer(name), ms),
            RungAction::Move { from, to, width } => vec![self.moved(from, to, width)],
            RungAction::Compute { operator, left, right, to, width } => {
                self.computed(operator, [left, right, to], width)
            }
            RungAction::Convert { from, to, table } => vec![self.converted(from, to, &table)],
            RungAction::Below { number, than, coil: to } => {
                let compared = self.compared(number, than);
                compared.into_iter().chain([coil(to)]).collect()
            }
            RungAction::Decode { first } => self.decoded(rung, first),
        }
    }

    fn timer(&self, bit: Bit, ms: u32) -> Vec<String> {
        let (device, count) = (self.bit(bit), ms.div_ceil(self.language.timer_unit()));
        match self.language {
            PlcLanguage::Pmc => {
                vec![format!("SUB 24 TMRB {} {count}", self.timer_number(bit)), format!("WRT {device}")]
            }
            PlcLanguage::Gsk => vec![format!("TMRB {device} {count}")],
            PlcLanguage::Melsec => vec![format!("OUT {device} K{count}")],
            PlcLanguage::Step7 => vec![format!("TON {device}, +{count}")],
        }
    }

    /// Number of a timer, from 1.
    fn timer_number(&self, bit: Bit) -> usize {
        1 + self.bits.iter().filter(|row| matches!(row.0, Bit::Timer(_)) && row.0 < bit).count()
    }

    fn operand(&self, word: PlcNumber) -> String {
        match (word, self.language) {
            (PlcNumber::Constant(value), PlcLanguage::Step7) => format!("{value:+}"),
            (PlcNumber::Constant(value), _) => format!("K{value}"),
            _ => self.word(word).to_owned(),
        }
    }

    /// Size of a number in bytes: one for an override, except in the 16-bit registers of the E60.
    fn bytes(&self, to: PlcNumber, width: PlcWidth) -> u32 {
        let role = if let PlcNumber::Signal(role) = to { Some(role) } else { None };
        match role {
            Some(SignalRole::SpindleOverride | SignalRole::SpindleOverrideCode | SignalRole::FeedOverride) => 1,
            _ => match width {
                PlcWidth::Word => 2,
                PlcWidth::DoubleWord => 4,
            },
        }
    }

    fn moved(&self, from: PlcNumber, to: PlcNumber, width: PlcWidth) -> String {
        let (bytes, from, to) = (self.bytes(to, width), self.operand(from), self.operand(to));
        match self.language {
            PlcLanguage::Step7 if bytes == 1 => format!("MOV_B {}, {to}", low_byte(&from)),
            PlcLanguage::Pmc if from.starts_with('K') => format!("SUB 40 NUMEB {bytes} {from} {to}"),
            PlcLanguage::Pmc => format!("SUB 45 MOVN {bytes} {from} {to}"),
            PlcLanguage::Gsk => format!("MOVN {bytes} {from} {to}"),
            PlcLanguage::Melsec => {
                format!("{} {from} {to}", if width == PlcWidth::DoubleWord { "DMOV" } else { "MOV" })
            }
            PlcLanguage::Step7 => {
                format!("{} {from}, {to}", if width == PlcWidth::DoubleWord { "MOV_DW" } else { "MOV_W" })
            }
        }
    }

    fn computed(&self, operator: Operator, words: [PlcNumber; 3], width: PlcWidth) -> Vec<String> {
        let (bytes, [left, right, to]) = (self.bytes(words[2], width), words.map(|word| self.operand(word)));
        let (name, sub, sign) = match operator {
            Operator::Add => ("ADDB", 36, '+'),
            Operator::Multiply => ("MULB", 38, '*'),
            Operator::Divide => ("DIVB", 39, '/'),
        };
        match self.language {
            PlcLanguage::Pmc => vec![format!("SUB {sub} {name} {bytes} {left} {right} {to}")],
            PlcLanguage::Gsk => vec![format!("{name} {bytes} {left} {right} {to}")],
            PlcLanguage::Melsec => {
                vec![format!("{}{sign} {left} {right} {to}", if width == PlcWidth::DoubleWord { "D" } else { "" })]
            }
            PlcLanguage::Step7 => {
                let kind = if width == PlcWidth::DoubleWord { 'D' } else { 'I' };
                vec![self.moved(words[0], words[2], width), format!("{sign}{kind} {right}, {to}")]
            }
        }
    }

    /// Contacts that close while a number is smaller than a constant. Source: `docs/reference/plc.md`, section 4.
    fn compared(&self, number: PlcNumber, than: i32) -> Vec<String> {
        let (left, right) = (self.operand(number), self.operand(PlcNumber::Constant(than)));
        match self.language {
            // The comparison sets a bit of the register for results, where the first number is the smaller one.
            PlcLanguage::Pmc | PlcLanguage::Gsk => {
                let sub = if self.language == PlcLanguage::Pmc { "SUB 32 " } else { "" };
                let load = words(self.language).load[0];
                vec![
                    format!("{sub}COMPB {} {left} {right}", self.bytes(number, PlcWidth::Word)),
                    format!("{load} R9000.1"),
                ]
            }
            PlcLanguage::Melsec => vec![format!("AND< {left} {right}")],
            // Numbers are whole: smaller than 50 is at most 49.
            PlcLanguage::Step7 => vec![format!("AW<= {left}, {}", self.operand(PlcNumber::Constant(than - 1)))],
        }
    }

    /// A table with its number of entries, place, result and entries. Only controls with codes of an override need it.
    fn converted(&self, from: PlcNumber, to: PlcNumber, table: &[u8]) -> String {
        let sub = if self.language == PlcLanguage::Pmc { "SUB 27 " } else { "" };
        let entries: Vec<String> = table.iter().map(u8::to_string).collect();
        // What is read as a word later is written as a word.
        let bytes = if matches!(to, PlcNumber::Data(_)) { 2 } else { 1 };
        format!("{sub}CODB {bytes} {} {} {} {}", table.len(), self.operand(from), self.operand(to), entries.join(" "))
    }

    /// Eight M functions by one instruction, or each by a comparison.
    fn decoded(&self, rung: &Rung, first: u32) -> Vec<String> {
        let code = self.word(PlcNumber::Signal(SignalRole::MCode));
        let used = (first..first + DECODED).map(Bit::Decoded).filter(|bit| !self.bit(*bit).is_empty());
        match self.language {
            PlcLanguage::Pmc | PlcLanguage::Gsk => {
                let byte = self.decoded_byte(first);
                let sub = if self.language == PlcLanguage::Pmc { "SUB 25 " } else { "" };
                vec![format!("{sub}DECB 1 {code} {first} {byte}")]
            }
            // Each M function has a bit of its own, and none is decoded.
            PlcLanguage::Step7 => Vec::new(),
            PlcLanguage::Melsec => used
                .flat_map(|bit| {
                    let Bit::Decoded(function) = bit else { return Vec::new() };
                    let mut list = self.contacts(&rung.when);
                    list.push(format!("AND= {code} K{function}"));
                    list.push(format!("OUT {}", self.bit(bit)));
                    list
                })
                .collect(),
        }
    }

    /// The byte of relays that eight M functions are decoded into.
    fn decoded_byte(&self, first: u32) -> &str {
        let used = (first..first + DECODED).map(|function| self.bit(Bit::Decoded(function)));
        used.filter_map(|device| device.split_once('.')).map(|parts| parts.0).next().unwrap_or("")
    }
}

/// The low byte of a word of data: `VW100` is `VB100` and `VB101`.
fn low_byte(word: &str) -> String {
    match word.strip_prefix("VW").and_then(|number| number.parse::<u32>().ok()) {
        Some(number) => format!("VB{}", number + 1),
        None => word.to_owned(),
    }
}
