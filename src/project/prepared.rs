//! The prepared machine of a project: kept until machine, control, values or settings change.

use std::sync::{Arc, Mutex, PoisonError};

use super::Project;
use crate::controls::Switches;
use crate::machines::PreparedMachine;
use crate::machines::form::Values;

/// The machine that was prepared last, with everything that it was prepared from. A clone of a project shares it.
#[derive(Debug, Default)]
pub(super) struct Memo(Mutex<Option<Entry>>);

#[derive(Debug, Clone)]
struct Entry {
    machine: &'static str,
    control: &'static str,
    values: Values,
    switches: Switches,
    prepared: Arc<PreparedMachine>,
}

impl Clone for Memo {
    fn clone(&self) -> Memo {
        Memo(Mutex::new(self.0.lock().unwrap_or_else(PoisonError::into_inner).clone()))
    }
}

impl Project {
    /// The machine with the project's values on its control, prepared once per change.
    pub fn prepared(&self) -> Arc<PreparedMachine> {
        let mut memo = self.memo.0.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(entry) = &*memo
            && entry.machine == self.machine.id()
            && entry.control == self.control.id
            && entry.values == self.values
            && entry.switches == self.switches
        {
            return Arc::clone(&entry.prepared);
        }
        let prepared = Arc::new(self.machine.prepare(&self.values, self.on()));
        *memo = Some(Entry {
            machine: self.machine.id(),
            control: self.control.id,
            values: self.values.clone(),
            switches: self.switches.clone(),
            prepared: Arc::clone(&prepared),
        });
        prepared
    }
}
