//! A value that the page follows: little code for each type, as all that reacts is one trigger.

use std::cell::RefCell;

use leptos::prelude::*;

/// A value of the page that lasts as long as the page, and what follows it. A handle: copies mean the same.
pub(super) struct Local<T: 'static> {
    value: &'static RefCell<T>,
    changed: Trigger,
}

impl<T> Clone for Local<T> {
    fn clone(&self) -> Local<T> {
        *self
    }
}

impl<T> Copy for Local<T> {}

impl<T> Local<T> {
    /// A value. It is never freed: there is one page.
    pub(super) fn new(value: T) -> Local<T> {
        Local { value: Box::leak(Box::new(RefCell::new(value))), changed: Trigger::new() }
    }

    /// Follows the value.
    pub(super) fn track(self) {
        self.changed.track();
    }

    /// Reads the value and follows it.
    pub(super) fn with<R>(self, read: impl FnOnce(&T) -> R) -> R {
        self.changed.track();
        read(&self.value.borrow())
    }

    /// Reads the value as it is.
    pub(super) fn with_untracked<R>(self, read: impl FnOnce(&T) -> R) -> R {
        read(&self.value.borrow())
    }

    /// Changes the value without telling anybody.
    pub(super) fn quietly<R>(self, change: impl FnOnce(&mut T) -> R) -> R {
        change(&mut self.value.borrow_mut())
    }

    /// Another value.
    pub(super) fn set(self, value: T) {
        drop(self.value.replace(value));
        self.changed.notify();
    }

    /// Changes the value.
    pub(super) fn update(self, change: impl FnOnce(&mut T)) {
        change(&mut self.value.borrow_mut());
        self.changed.notify();
    }
}

impl<T: PartialEq> Local<T> {
    /// Another value; nobody is told where it is the same.
    pub(super) fn put(self, value: T) {
        let same = *self.value.borrow() == value;
        if !same {
            self.set(value);
        }
    }
}

impl<T: Clone> Local<T> {
    /// The value, followed.
    pub(super) fn get(self) -> T {
        self.with(T::clone)
    }

    /// The value as it is.
    pub(super) fn get_untracked(self) -> T {
        self.with_untracked(T::clone)
    }
}
