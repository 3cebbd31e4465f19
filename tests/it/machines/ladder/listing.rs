//! An evaluator of exported instruction lists, independent of the ladders they were written from.

use std::collections::{BTreeMap, BTreeSet};

use macroline::controls::interface::PlcLanguage;

/// Bit of the register for results of the PMC: the first number of a comparison is the smaller one.
const RESULT: &str = "R9000.1";

/// A line of the list, understood.
#[derive(Debug, Clone, PartialEq)]
enum Line {
    /// Begins a rung or a branch.
    Load {
        device: String,
        not: bool,
    },
    And {
        device: String,
        not: bool,
    },
    Or {
        device: String,
        not: bool,
    },
    /// Joins a branch in parallel.
    Join,
    /// Comparison in series.
    Equal(String, String),
    /// The same: the left number is below the right one.
    Below(String, String),
    /// Sets the bit of the register for results where the left number is below the right one.
    Compare(String, String),
    Coil(String),
    /// Device and seconds; where the contact follows by a coil of its own, the device is the timer's number.
    Timer(String, f64, bool),
    /// Operator (`=` copies), operands, target.
    Number(char, Vec<String>, String),
    /// Place in a table, result, entries.
    Convert(String, String, Vec<f64>),
    Decode {
        from: String,
        first: u32,
        byte: String,
    },
    Unknown(String),
}

/// A list and the state of its PLC.
#[derive(Debug)]
pub(super) struct Listing {
    lines: Vec<Line>,
    on: BTreeMap<String, bool>,
    numbers: BTreeMap<String, f64>,
    timers: BTreeMap<String, f64>,
}

impl Listing {
    pub(super) fn new(language: PlcLanguage, text: impl Iterator<Item = String>) -> Listing {
        let read = |line: String| match language {
            PlcLanguage::Pmc => pmc(&line),
            PlcLanguage::Gsk => gsk(&line),
            PlcLanguage::Melsec => melsec(&line),
            PlcLanguage::Step7 => step7(&line),
        };
        let lines = text.map(|line| read(line.clone()).unwrap_or(Line::Unknown(line))).collect();
        Listing { lines, on: BTreeMap::new(), numbers: BTreeMap::new(), timers: BTreeMap::new() }
    }

    pub(super) fn set(&mut self, device: &str, on: bool) {
        self.on.insert(device.to_owned(), on);
    }

    pub(super) fn put(&mut self, device: &str, value: f64) {
        self.numbers.insert(device.to_owned(), value);
    }

    pub(super) fn is_on(&self, device: &str) -> bool {
        self.on.get(device).copied().unwrap_or(false)
    }

    pub(super) fn number(&self, device: &str) -> f64 {
        let constant = device.strip_prefix('K').or(device.starts_with(['+', '-']).then_some(device));
        let constant = constant.and_then(|digits| digits.parse().ok());
        constant.or(self.numbers.get(device).copied()).unwrap_or(0.0)
    }

    /// Lines that the PLC does not have.
    pub(super) fn unknown(&self) -> Vec<String> {
        let unknown = |line: &Line| if let Line::Unknown(text) = line { Some(text.clone()) } else { None };
        self.lines.iter().filter_map(unknown).collect()
    }

    /// Written devices, each with the contacts before it.
    pub(super) fn targets(&self) -> impl Iterator<Item = (String, String)> {
        let (mut all, mut contacts, mut acted) = (Vec::new(), Vec::new(), false);
        let mut last_number = None;
        for line in &self.lines {
            let target = match line {
                Line::Load { .. }
                | Line::And { .. }
                | Line::Or { .. }
                | Line::Join
                | Line::Equal(..)
                | Line::Below(..) => {
                    if core::mem::take(&mut acted) {
                        contacts.clear();
                    }
                    contacts.push(format!("{line:?}"));
                    last_number = None;
                    continue;
                }
                Line::Timer(_, _, true) | Line::Compare(..) | Line::Unknown(_) => continue,
                Line::Coil(device) | Line::Timer(device, _, false) => vec![device.clone()],
                // Copying and then computing in place is one result.
                Line::Number(_, _, to) if last_number.as_ref() == Some(to) => continue,
                Line::Number(_, _, to) => {
                    last_number = Some(to.clone());
                    vec![to.clone()]
                }
                Line::Convert(_, to, _) => vec![to.clone()],
                Line::Decode { byte, .. } => (0..8).map(|bit| format!("{byte}.{bit}")).collect(),
            };
            acted = true;
            all.extend(target.into_iter().map(|target| (target, contacts.join(" "))));
        }
        all.into_iter()
    }

    /// Whether two conditions are one contact and its inverse.
    pub(super) fn inverse(&self, one: &str, other: &str) -> bool {
        let parts = |text: &str| (text.replace("not: true", "").replace("not: false", ""), text.contains("not: true"));
        let ((one, a), (other, b)) = (parts(one), parts(other));
        one == other && a != b && one.matches("device").count() == 1
    }

    /// Everything that is read.
    pub(super) fn operands(&self) -> BTreeSet<String> {
        let mut all = BTreeSet::new();
        // The register for results belongs to the comparisons.
        let compared = |device: &String| device == RESULT;
        let constant = |word: &String| word.starts_with(['K', '+', '-']);
        for line in &self.lines {
            match line {
                Line::Load { device, .. } if compared(device) => {}
                Line::Load { device, .. } | Line::And { device, .. } | Line::Or { device, .. } => {
                    all.insert(device.clone());
                }
                Line::Equal(from, _)
                | Line::Below(from, _)
                | Line::Compare(from, _)
                | Line::Decode { from, .. }
                | Line::Convert(from, ..) => {
                    all.insert(from.clone());
                }
                Line::Number(_, operands, _) => all.extend(operands.iter().filter(|word| !constant(word)).cloned()),
                _ => {}
            }
        }
        all
    }

    /// One scan.
    pub(super) fn scan(&mut self, t: f64) {
        // The first contact after an action begins a rung; further first contacts begin branches.
        let (mut stack, mut acted): (Vec<bool>, bool) = (Vec::new(), false);
        for line in self.lines.clone() {
            let top = stack.last().copied().unwrap_or(false);
            match line {
                Line::Load { device, not } => {
                    if core::mem::take(&mut acted) {
                        stack.clear();
                    }
                    stack.push(self.is_on(&device) != not);
                    continue;
                }
                Line::And { device, not } => {
                    let on = self.is_on(&device) != not;
                    *stack.last_mut().unwrap() &= on;
                    continue;
                }
                Line::Or { device, not } => {
                    let on = self.is_on(&device) != not;
                    *stack.last_mut().unwrap() |= on;
                    continue;
                }
                Line::Join => {
                    let branch = stack.pop().unwrap();
                    *stack.last_mut().unwrap() |= branch;
                    continue;
                }
                Line::Equal(left, right) => {
                    let equal = self.number(&left) == self.number(&right);
                    *stack.last_mut().unwrap() &= equal;
                    continue;
                }
                Line::Below(left, right) => {
                    let below = self.number(&left) < self.number(&right);
                    *stack.last_mut().unwrap() &= below;
                    continue;
                }
                Line::Coil(device) => self.set(&device, top),
                Line::Timer(device, seconds, chained) => {
                    if !top {
                        self.timers.remove(&device);
                    }
                    let over = top && t >= *self.timers.entry(device.clone()).or_insert(t) + seconds;
                    if !top {
                        self.timers.remove(&device);
                    }
                    if chained {
                        *stack.last_mut().unwrap() = over;
                    } else {
                        self.set(&device, over);
                    }
                }
                // The comparison acts whatever it is behind: its result is loaded as a contact.
                Line::Compare(left, right) => {
                    let below = self.number(&left) < self.number(&right);
                    self.set(RESULT, below);
                }
                Line::Number(operator, operands, to) if top => {
                    let value = |at: usize| self.number(&operands[at]);
                    let result = match operator {
                        '+' => value(0) + value(1),
                        '*' => value(0) * value(1),
                        '/' if value(1) == 0.0 => 0.0,
                        '/' => (value(0) / value(1)).trunc(),
                        _ => value(0),
                    };
                    self.put(&to, result);
                }
                Line::Convert(from, to, table) if top => {
                    if let Some(entry) = table.get(self.number(&from) as usize) {
                        self.put(&to, *entry);
                    }
                }
                Line::Decode { from, first, byte } => {
                    let code = self.number(&from);
                    for bit in 0..8 {
                        self.set(&format!("{byte}.{bit}"), top && code == f64::from(first + bit));
                    }
                }
                Line::Number(..) | Line::Convert(..) | Line::Unknown(_) => {}
            }
            assert_eq!(stack.len(), 1, "every branch is joined");
            acted = true;
        }
    }
}

fn words(line: &str) -> Vec<&str> {
    line.split([' ', ',']).filter(|word| !word.is_empty()).collect()
}

fn contact(words: &[&str], names: [&str; 6]) -> Option<Line> {
    let [name, device] = words else { return None };
    let device = (*device).to_owned();
    let at = names.iter().position(|known| known == name)?;
    let not = at % 2 == 1;
    Some(match at / 2 {
        0 => Line::Load { device, not },
        1 => Line::And { device, not },
        _ => Line::Or { device, not },
    })
}

fn number(operator: char, words: &[&str]) -> Option<Line> {
    let (to, operands) = words.split_last()?;
    (operands.len() == if operator == '=' { 1 } else { 2 })
        .then(|| Line::Number(operator, operands.iter().map(|word| (*word).to_owned()).collect(), (*to).to_owned()))
}

/// Functional instructions of FANUC and GSK by their names.
fn function(words: &[&str]) -> Option<Line> {
    match words {
        ["MOVN" | "NUMEB", "1" | "2" | "4", rest @ ..] => number('=', rest),
        ["ADDB", "1" | "2" | "4", rest @ ..] => number('+', rest),
        ["MULB", "1" | "2" | "4", rest @ ..] => number('*', rest),
        ["DIVB", "1" | "2" | "4", rest @ ..] => number('/', rest),
        ["CODB", "1" | "2", count, from, to, rest @ ..] => {
            let entries: Option<Vec<f64>> = rest.iter().map(|entry| entry.parse().ok()).collect();
            let entries = entries.filter(|all| count.parse() == Ok(all.len()))?;
            Some(Line::Convert((*from).to_owned(), (*to).to_owned(), entries))
        }
        ["COMPB", "1" | "2" | "4", left, right] => Some(Line::Compare((*left).to_owned(), (*right).to_owned())),
        ["DECB", "1", from, first, byte] => {
            Some(Line::Decode { from: (*from).to_owned(), first: first.parse().ok()?, byte: (*byte).to_owned() })
        }
        _ => None,
    }
}

fn milliseconds(text: &str, unit: f64) -> Option<f64> {
    Some(text.parse::<f64>().ok()? * unit / 1000.0)
}

fn pmc(line: &str) -> Option<Line> {
    let words = words(line);
    match words.as_slice() {
        ["OR.STK"] => Some(Line::Join),
        ["WRT", device] => Some(Line::Coil((*device).to_owned())),
        ["RD.STK", device] => Some(Line::Load { device: (*device).to_owned(), not: false }),
        ["RD.NOT.STK", device] => Some(Line::Load { device: (*device).to_owned(), not: true }),
        ["SUB", "24", "TMRB", name, ms] => Some(Line::Timer((*name).to_owned(), milliseconds(ms, 1.0)?, true)),
        ["SUB", sub, rest @ ..] => {
            let own = [
                ("25", "DECB"),
                ("32", "COMPB"),
                ("36", "ADDB"),
                ("38", "MULB"),
                ("39", "DIVB"),
                ("40", "NUMEB"),
                ("45", "MOVN"),
            ];
            let name = rest.first()?;
            own.contains(&(sub, name)).then(|| function(rest))?
        }
        words => contact(words, ["RD", "RD.NOT", "AND", "AND.NOT", "OR", "OR.NOT"]),
    }
}

fn gsk(line: &str) -> Option<Line> {
    let words = words(line);
    match words.as_slice() {
        ["ORB"] => Some(Line::Join),
        ["OUT", device] => Some(Line::Coil((*device).to_owned())),
        ["TMRB", device, ms] => Some(Line::Timer((*device).to_owned(), milliseconds(ms, 1.0)?, false)),
        words => contact(words, ["LD", "LDI", "AND", "ANI", "OR", "ORI"]).or_else(|| function(words)),
    }
}

fn melsec(line: &str) -> Option<Line> {
    let words = words(line);
    match words.as_slice() {
        ["ORB"] => Some(Line::Join),
        ["OUT", device] => Some(Line::Coil((*device).to_owned())),
        ["OUT", device, count] => {
            Some(Line::Timer((*device).to_owned(), milliseconds(count.strip_prefix('K')?, 10.0)?, false))
        }
        ["AND<", left, right] => Some(Line::Below((*left).to_owned(), (*right).to_owned())),
        ["AND=", left, right] => Some(Line::Equal((*left).to_owned(), (*right).to_owned())),
        ["MOV" | "DMOV", rest @ ..] => number('=', rest),
        ["+" | "D+", rest @ ..] => number('+', rest),
        ["*" | "D*", rest @ ..] => number('*', rest),
        ["/" | "D/", rest @ ..] => number('/', rest),
        words => contact(words, ["LD", "LDI", "AND", "ANI", "OR", "ORI"]),
    }
}

fn step7(line: &str) -> Option<Line> {
    let words = words(line);
    let in_place = |operator: char, operand: &&str, to: &&str| {
        Some(Line::Number(operator, vec![(*to).to_owned(), (*operand).to_owned()], (*to).to_owned()))
    };
    match words.as_slice() {
        ["OLD"] => Some(Line::Join),
        // Whole numbers: at most 49 is below 50.
        ["AW<=", left, right] => {
            let right = right.parse::<i32>().ok()? + 1;
            Some(Line::Below((*left).to_owned(), format!("{right:+}")))
        }
        ["=", device] => Some(Line::Coil((*device).to_owned())),
        ["TON", device, count] => {
            Some(Line::Timer((*device).to_owned(), milliseconds(count.strip_prefix('+')?, 10.0)?, false))
        }
        ["MOV_W" | "MOV_DW", rest @ ..] => number('=', rest),
        // The low byte of a word is its second one.
        ["MOV_B", from, to] => {
            let word = from.strip_prefix("VB").and_then(|number| number.parse::<u32>().ok());
            let from = word.map_or_else(|| (*from).to_owned(), |number| format!("VW{}", number - 1));
            Some(Line::Number('=', vec![from], (*to).to_owned()))
        }
        ["+I" | "+D", operand, to] => in_place('+', operand, to),
        ["*I" | "*D", operand, to] => in_place('*', operand, to),
        ["/I" | "/D", operand, to] => in_place('/', operand, to),
        words => contact(words, ["LD", "LDN", "A", "AN", "O", "ON"]),
    }
}
