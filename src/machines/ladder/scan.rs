//! One scan of a ladder: every rung in its order, on the image of signals, numbers and timers.

use std::collections::{BTreeMap, BTreeSet};

use super::{Bit, DECODED, Ladder, Operator, PlcNumber, Rung, RungAction, RungContact};
use crate::controls::interface::SignalRole;

/// Signals, numbers and running timers of a PLC.
#[derive(Debug, Clone, Default)]
pub struct Image {
    on: BTreeSet<Bit>,
    numbers: BTreeMap<PlcNumber, f64>,
    /// Time (s) since which the condition of each timer holds.
    timers: BTreeMap<&'static str, f64>,
    /// Whether any signal or number has changed since the last query.
    changed: bool,
}

impl Image {
    /// Whether a signal is on.
    pub fn is_on(&self, bit: Bit) -> bool {
        self.on.contains(&bit)
    }

    /// Switches a signal.
    pub fn set(&mut self, bit: Bit, on: bool) {
        self.changed |= if on { self.on.insert(bit) } else { self.on.remove(&bit) };
    }

    /// Value of a number; 0 if nothing has written it.
    pub fn number(&self, word: PlcNumber) -> f64 {
        match word {
            PlcNumber::Constant(value) => f64::from(value),
            _ => self.numbers.get(&word).copied().unwrap_or(0.0),
        }
    }

    /// Writes a number.
    pub fn put(&mut self, word: PlcNumber, value: f64) {
        self.changed |= self.numbers.insert(word, value) != Some(value);
    }

    /// Whether any signal or number has changed since the last call.
    pub fn take_changed(&mut self) -> bool {
        core::mem::take(&mut self.changed)
    }

    /// Runs a timer from time `t` (s) on, or resets it unless `runs`; returns the time since which it runs.
    fn time(&mut self, name: &'static str, t: f64, runs: bool) -> Option<f64> {
        let since = self.timers.get(name).copied();
        self.changed |= since.is_some() != runs;
        if !runs {
            self.timers.remove(name);
            return None;
        }
        Some(*self.timers.entry(name).or_insert(t))
    }

    fn closed(&self, contact: &RungContact) -> bool {
        self.is_on(contact.bit) != contact.opens
    }
}

impl Rung {
    /// Whether the condition holds.
    fn holds(&self, image: &Image) -> bool {
        self.when.iter().any(|branch| branch.iter().all(|contact| image.closed(contact)))
    }
}

impl Ladder {
    /// Executes every rung once at time `t` (s).
    pub fn scan(&self, t: f64, image: &mut Image) {
        for rung in self.rungs.iter() {
            let holds = rung.holds(image);
            match rung.action {
                RungAction::Coil(bit) => image.set(bit, holds),
                RungAction::Below { number, than, coil } => {
                    let is_below = image.number(number) < f64::from(than);
                    image.set(coil, holds && is_below);
                }
                RungAction::Timer(name, ms) => {
                    let since = image.time(name, t, holds);
                    image.set(Bit::Timer(name), since.is_some_and(|since| t >= since + seconds(ms)));
                }
                RungAction::Move { from, to, .. } if holds => image.put(to, image.number(from)),
                RungAction::Compute { operator, left, right, to, .. } if holds => {
                    let value = computed(operator, image.number(left), image.number(right));
                    image.put(to, value);
                }
                RungAction::Convert { from, to, table } if holds => {
                    let place = image.number(from);
                    let entry = table.into_iter().enumerate().find(|(at, _)| *at as f64 == place);
                    if let Some((_, entry)) = entry {
                        image.put(to, f64::from(entry));
                    }
                }
                RungAction::Move { .. } | RungAction::Compute { .. } | RungAction::Convert { .. } => {}
                RungAction::Decode { first } => {
                    let code = image.number(PlcNumber::Signal(SignalRole::MCode));
                    for function in first..first + DECODED {
                        image.set(Bit::Decoded(function), holds && code == f64::from(function));
                    }
                }
            }
        }
    }

    /// The time (s) at which the next timer closes its contact.
    pub fn due(&self, image: &Image) -> Option<f64> {
        let runs = |rung: &Rung| match rung.action {
            RungAction::Timer(name, ms) if !image.is_on(Bit::Timer(name)) => {
                Some(image.timers.get(name)? + seconds(ms))
            }
            _ => None,
        };
        self.rungs.iter().filter_map(runs).reduce(f64::min)
    }

    /// Whether a coil or a timer other than `aside` would change with this signal.
    pub fn waits_for(&self, image: &Image, bit: Bit, aside: Bit) -> bool {
        let turned = |contact: &RungContact| image.closed(contact) != (contact.bit == bit);
        let holds = |rung: &Rung| rung.when.iter().any(|branch| branch.iter().all(turned));
        let acts = |rung: &&Rung| {
            rung.when.iter().flatten().any(|contact| contact.bit == bit) && rung.action != RungAction::Coil(aside)
        };
        self.rungs.iter().filter(acts).any(|rung| rung.holds(image) != holds(rung))
    }
}

/// Preset of a timer in seconds.
fn seconds(ms: u32) -> f64 {
    f64::from(ms) / 1000.0
}

fn computed(operator: Operator, left: f64, right: f64) -> f64 {
    match operator {
        Operator::Add => left + right,
        Operator::Multiply => left * right,
        Operator::Divide if right == 0.0 => 0.0,
        Operator::Divide => (left / right).trunc(),
    }
}
