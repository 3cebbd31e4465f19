//! Variable store in pages, which copies of a run share until one of them writes.

use std::rc::Rc;

/// Vacant variable. No calculation yields NaN: a result that is not a number is an alarm.
pub(super) const VACANT: f64 = f64::NAN;

/// Number of local variables of a macro level.
pub(super) const LOCALS: usize = 33;
/// Values of one level, `#1` first.
pub(super) type Locals = [f64; LOCALS];

const PAGE: usize = 32;

/// All variables stored by the interpreter.
#[derive(Debug, Clone)]
pub(super) struct VariableStore {
    pages: Vec<Rc<[f64; PAGE]>>,
    /// Local variables of the main program and of each macro level entered so far.
    levels: Vec<Rc<Locals>>,
    level: usize,
}

/// Local variables of a level without arguments.
fn no_locals() -> Rc<Locals> {
    Rc::new([VACANT; LOCALS])
}

impl VariableStore {
    /// `count` vacant variables and vacant locals.
    pub(super) fn new(count: u32) -> VariableStore {
        let page = Rc::new([VACANT; PAGE]);
        VariableStore { pages: vec![page; (count as usize).div_ceil(PAGE)], levels: vec![no_locals()], level: 0 }
    }

    /// Reads a variable of the store.
    #[inline]
    pub(super) fn common(&self, slot: u16) -> f64 {
        self.pages.get(slot as usize / PAGE).map_or(VACANT, |page| page[slot as usize % PAGE])
    }

    /// Writes a variable of the store.
    #[inline]
    pub(super) fn set_common(&mut self, slot: u16, value: f64) {
        if let Some(page) = self.pages.get_mut(slot as usize / PAGE) {
            Rc::make_mut(page)[slot as usize % PAGE] = value;
        }
    }

    /// A local variable of the present level, by index from 0.
    #[inline]
    pub(super) fn local(&self, index: u8) -> f64 {
        self.levels.get(self.level).and_then(|locals| locals.get(index as usize)).copied().unwrap_or(VACANT)
    }

    /// Writes a local variable of the present level.
    #[inline]
    pub(super) fn set_local(&mut self, index: u8, value: f64) {
        let locals = self.levels.get_mut(self.level).map(Rc::make_mut);
        if let Some(place) = locals.and_then(|locals| locals.get_mut(index as usize)) {
            *place = value;
        }
    }

    /// The present level, from 0.
    pub(super) fn level(&self) -> usize {
        self.level
    }

    /// The local variables of a level.
    pub(super) fn locals_of(&self, level: usize) -> Locals {
        self.levels.get(level).map_or([VACANT; LOCALS], |locals| **locals)
    }

    /// Enters a macro level with its arguments. With `keep`, a local variable without an argument keeps its last value on this level.
    pub(super) fn enter(&mut self, arguments: &Rc<Locals>, keep: bool) {
        self.level += 1;
        self.arguments(arguments, keep);
    }

    /// Sets the arguments of the present level, also for a repeat.
    pub(super) fn arguments(&mut self, arguments: &Rc<Locals>, keep: bool) {
        match self.levels.get_mut(self.level) {
            Some(locals) if keep => {
                for (place, value) in Rc::make_mut(locals).iter_mut().zip(arguments.iter()) {
                    if !value.is_nan() {
                        *place = *value;
                    }
                }
            }
            Some(locals) => *locals = Rc::clone(arguments),
            None => self.levels.push(Rc::clone(arguments)),
        }
    }

    /// Leaves a macro level.
    pub(super) fn leave(&mut self) {
        self.level = self.level.saturating_sub(1);
    }
}
