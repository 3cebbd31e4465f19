//! A delayed call; a later call replaces the one that waits.

use std::time::Duration;

use leptos::prelude::*;

/// A delayed call. Another call replaces it, and it is dropped with the component that owns it. A handle: copies share the call.
#[derive(Clone, Copy)]
pub(crate) struct Delayed(StoredValue<Option<TimeoutHandle>>);

impl Delayed {
    /// Nothing is called yet.
    pub(crate) fn new() -> Delayed {
        let delayed = Delayed(StoredValue::new(None));
        on_cleanup(move || {
            delayed.cancel();
        });
        delayed
    }

    /// Calls `work` after a delay, in place of the call that waits.
    pub(crate) fn call(self, work: impl FnOnce() + 'static, delay: Duration) {
        self.cancel();
        let ended = move || {
            self.0.try_set_value(None);
            work();
        };
        self.0.set_value(set_timeout_with_handle(ended, delay).ok());
    }

    /// Cancels the call; returns whether one was waiting.
    pub(crate) fn cancel(self) -> bool {
        let timer = self.0.try_update_value(Option::take).flatten();
        timer.inspect(TimeoutHandle::clear).is_some()
    }
}
