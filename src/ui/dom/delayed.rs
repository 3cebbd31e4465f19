//! A call after a delay, of which only the last one counts.

use std::time::Duration;

use leptos::prelude::*;

/// A delayed call: another one takes its place, and none comes once the component that has it is gone. A handle: copies share the call.
#[derive(Clone, Copy)]
pub(crate) struct Delayed(StoredValue<Option<TimeoutHandle>>);

impl Delayed {
    /// Nothing is called yet.
    pub(crate) fn new() -> Delayed {
        let delayed = Delayed(StoredValue::new(None));
        on_cleanup(move || delayed.cancel());
        delayed
    }

    /// Does something after a delay, in place of what waits.
    pub(crate) fn call(self, work: impl FnOnce() + 'static, delay: Duration) {
        self.cancel();
        self.0.set_value(set_timeout_with_handle(work, delay).ok());
    }

    /// Drops what waits.
    pub(crate) fn cancel(self) {
        self.0.update_value(|timer| timer.take().into_iter().for_each(|timer| timer.clear()));
    }
}
