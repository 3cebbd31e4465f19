//! Index of a deck's programs by number and by name.

use std::ops::{Div, Rem};

use super::ast::Deck;

/// The first program of each number and of each name.
pub(in crate::nc) struct ProgramNames<'a> {
    /// (number, index of the program), sorted.
    numbers: Vec<(u32, u32)>,
    /// (name in capitals, index of the program), sorted.
    names: Vec<(&'a str, u32)>,
}

/// Index of the first program with a key, in a sorted list.
fn first<K: Ord + Copy>(list: &[(K, u32)], key: K) -> Option<u32> {
    let at = list.partition_point(|row| row.0 < key);
    list.get(at).filter(|row| row.0 == key).map(|row| row.1)
}

/// The number in P of a call, split into the digits in front of the last four, which count repeats, and the program number in the last four.
pub(in crate::nc) fn split_repeats<N: Copy + Div<Output = N> + Rem<Output = N> + From<u16>>(p: N) -> (N, N) {
    let programs = N::from(10_000);
    (p / programs, p % programs)
}

impl<'a> ProgramNames<'a> {
    pub(in crate::nc) fn new(deck: &'a Deck) -> ProgramNames<'a> {
        let mut numbers: Vec<(u32, u32)> = deck.programs.iter().map(|program| program.number).zip(0..).collect();
        numbers.sort_unstable();
        let named = deck.programs.iter().zip(0..).filter(|(program, _)| program.name.is_some());
        let mut names: Vec<(&str, u32)> = named.map(|(program, at)| (deck.text(program.name), at)).collect();
        names.sort_unstable();
        ProgramNames { numbers, names }
    }

    /// Index of the first program with a number.
    pub(in crate::nc) fn number(&self, number: u32) -> Option<u32> {
        first(&self.numbers, number)
    }

    /// Index of the first program with a name, in capitals.
    pub(in crate::nc) fn name(&self, name: &str) -> Option<u32> {
        first(&self.names, name)
    }
}
