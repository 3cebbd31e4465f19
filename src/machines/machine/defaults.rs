//! Values and settings of a new project that differ from the defaults of form and control.

use crate::controls::options::{CommonAtReset, SwitchChoice};
use crate::controls::{Control, Switches};
use crate::machines::form::{Value, Values};

/// Values and settings of a new project that differ from the defaults of form and control.
#[derive(Debug, Clone, Default)]
pub struct Defaults {
    /// Values by field id.
    pub values: Values,
    /// Settings that the machine needs.
    pub switches: Switches,
}

impl Defaults {
    /// Block time and macro time (ms) and pre-read blocks of the control.
    pub fn timing(control: &Control) -> Defaults {
        let mut start = Defaults::default();
        for (id, value) in [
            ("block-time", control.timing.block * 1000.0),
            ("macro-time", control.timing.macro_block * 1000.0),
            ("preread", f64::from(control.timing.preread)),
        ] {
            start.number(id, value);
        }
        start
    }

    /// Sets a number of the form, rounded to thousandths.
    pub fn number(&mut self, id: &str, value: f64) {
        self.values.insert(id.to_owned(), Value::Number((value * 1000.0).round() / 1000.0));
    }

    /// Keeps common variables at reset: a second start needs the values that the first one set.
    pub fn keep_common(&mut self, control: &Control) {
        self.set(control, CommonAtReset::Kept);
    }

    /// Sets an open point of the control, unless the setting is its default.
    pub fn set<C: SwitchChoice>(&mut self, control: &Control, choice: C) {
        let setting = choice.option().id;
        if let Some(row) = control.switch(C::SWITCH).filter(|row| row.takes(setting)) {
            self.switches.set(row, setting);
        }
    }
}
