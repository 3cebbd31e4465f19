//! The prepared machine of a project: kept until machine, control, values or settings change.

use std::sync::{Arc, Mutex, PoisonError};

use crate::controls::Switches;
use crate::machines::form::Values;
use crate::machines::{AnyMachine, ControlContext, PreparedMachine};

/// The last prepared machine, with all of its inputs. A clone of a project shares it.
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

impl Memo {
    /// The machine with these values on a control, prepared once per change.
    pub(super) fn prepared(
        &self,
        machine: &dyn AnyMachine,
        values: &Values,
        on: ControlContext<'_>,
    ) -> Arc<PreparedMachine> {
        let mut memo = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(entry) = &*memo
            && entry.machine == machine.id()
            && entry.control == on.control.id
            && entry.values == *values
            && entry.switches == *on.switches
        {
            return Arc::clone(&entry.prepared);
        }
        let prepared = Arc::new(machine.prepare(values, on));
        *memo = Some(Entry {
            machine: machine.id(),
            control: on.control.id,
            values: values.clone(),
            switches: on.switches.clone(),
            prepared: Arc::clone(&prepared),
        });
        prepared
    }
}
