//! Writing a program: what the programs of all machines have in common.

use super::{Machine, settings};
use crate::controls::{Code, CodeId, Control, VarKind};
use crate::nc::build::{Builder, NewWord, g, m, real, v};

/// What wrote the program, and the settings it was written from.
pub(super) fn header<M: Machine>(b: &mut Builder, params: &M::Params, control: &Control) {
    b.comment(concat!("WRITTEN BY MACROLINE ", env!("CARGO_PKG_VERSION")));
    for text in settings::write::<M>(params, control) {
        b.comment(&text);
    }
}

/// Codes of the control for what is wanted, as far as it has them.
pub(super) fn codes(control: &Control, wanted: impl IntoIterator<Item = Code>) -> Vec<NewWord> {
    let word = |code: Code| {
        let row = control.codes.iter().find(|row| row.code == code)?;
        match row.id {
            CodeId::G(number) => Some(g(number.integer())),
            CodeId::M(number) => Some(m(number)),
            CodeId::Named(_) => None,
        }
    };
    wanted.into_iter().filter_map(word).collect()
}

/// An operator's variable, and whether only whole numbers make sense.
pub(super) type Entry = (u32, bool);

/// Every entry above zero, whole where it counts; else on to [`alarms`].
pub(super) fn guards(b: &mut Builder, entries: &[Entry]) {
    for (at, (entry, _)) in (1..).zip(entries) {
        b.n(at).if_goto(v(*entry).le(0), 900 + at);
    }
    for (at, (entry, _)) in (entries.len() as u32 + 1..).zip(entries.iter().filter(|(_, whole)| *whole)) {
        b.n(at).if_goto((v(*entry) - v(*entry).round()).abs().gt(real(0.0001, 4)), 900 + at);
    }
}

/// What the operator reads where an entry cannot be.
pub(super) fn alarms(b: &mut Builder, control: &Control, entries: &[Entry]) {
    for (at, (entry, _)) in (1..).zip(entries) {
        alarm(b, control, at, &format!("{} MUST BE ABOVE ZERO", control.variable(*entry)));
    }
    for (at, (entry, _)) in (entries.len() as u32 + 1..).zip(entries.iter().filter(|(_, whole)| *whole)) {
        alarm(b, control, at, &format!("{} MUST BE A WHOLE NUMBER", control.variable(*entry)));
    }
}

/// Whether a program can raise an alarm of its own.
pub(super) fn has_alarms(control: &Control) -> bool {
    control.vars.iter().any(|row| row.kind == VarKind::AlarmMessage)
}

/// The program stops with a text: as its own alarm, or as a message and a stop, again and again until reset, where the control has no such alarms.
pub(super) fn alarm(b: &mut Builder, control: &Control, number: u32, text: &str) {
    b.n(900 + number);
    if has_alarms(control) {
        b.alarm(number, text);
    } else {
        b.show(text);
        b.words([m(0)]);
        b.goto(900 + number);
    }
}
