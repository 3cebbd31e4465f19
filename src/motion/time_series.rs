//! Entries in time order: appended and truncated at the end, dropped at the beginning.

/// An entry valid from a time until the next entry of its series.
pub(super) trait Timed {
    /// Seconds.
    fn t(&self) -> f64;
}

/// Series of entries. Entry numbers count dropped entries too, so that they stay valid.
#[derive(Debug, Clone)]
pub(super) struct TimeSeries<T> {
    items: Vec<T>,
    forgotten: usize,
}

impl<T> Default for TimeSeries<T> {
    fn default() -> TimeSeries<T> {
        TimeSeries { items: Vec::new(), forgotten: 0 }
    }
}

/// Number of old entries dropped together.
const SLAB: usize = 4096;

impl<T: Timed> TimeSeries<T> {
    /// Number of entries, dropped ones included.
    pub(super) fn len(&self) -> usize {
        self.forgotten + self.items.len()
    }

    /// Appends an entry. It replaces an entry of the same time, which was never valid.
    #[inline(always)]
    pub(super) fn set_from(&mut self, item: T) {
        match self.items.last_mut() {
            Some(last) if last.t() == item.t() => *last = item,
            _ => self.items.push(item),
        }
    }

    /// Appends an entry; others of the same time stay.
    pub(super) fn append(&mut self, item: T) {
        self.items.push(item);
    }

    /// Removes the entries from number `len` on.
    pub(super) fn truncate(&mut self, len: usize) {
        self.items.truncate(len.saturating_sub(self.forgotten));
    }

    /// The newest entry.
    pub(super) fn last(&self) -> Option<&T> {
        self.items.last()
    }

    /// The entry valid at `t`; `None` before the first.
    pub(super) fn at(&self, t: f64) -> Option<&T> {
        self.until(t).last()
    }

    /// All entries with a time up to `t`.
    pub(super) fn until(&self, t: f64) -> &[T] {
        &self.items[..self.items.partition_point(|item| item.t() <= t)]
    }

    /// Entries from number `from` on.
    pub(super) fn from(&self, from: usize) -> &[T] {
        self.items.get(from.saturating_sub(self.forgotten)..).unwrap_or(&[])
    }

    /// A copy of the entries valid at `t` or later, up to number `len`; they keep their numbers.
    pub(super) fn part(&self, t: f64, len: usize) -> TimeSeries<T>
    where
        T: Clone,
    {
        let old = self.until(t).len().saturating_sub(1).min(len.saturating_sub(self.forgotten));
        let items = self.items.get(old..len.saturating_sub(self.forgotten)).unwrap_or_default().to_vec();
        TimeSeries { items, forgotten: self.forgotten + old }
    }

    /// Drops entries no longer valid at `t`, if there are many.
    pub(super) fn forget(&mut self, t: f64) {
        let old = self.until(t).len().saturating_sub(1);
        if old >= SLAB {
            self.items.drain(..old);
            self.forgotten += old;
        }
    }
}
