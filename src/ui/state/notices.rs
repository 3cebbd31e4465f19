//! Messages to the user: notices until they are dismissed, and sentences for screen readers.

use leptos::prelude::*;

/// A message that stays until it is dismissed.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Notice {
    /// Class: `info`, `warn`, `fail`.
    pub tone: &'static str,
    /// The sentence.
    pub text: String,
    /// A file that goes with it: name and content.
    pub file: Option<(&'static str, String)>,
}

/// The messages. A handle: copies mean the same.
#[derive(Clone, Copy)]
pub(crate) struct Notices {
    /// Shown until they are dismissed.
    pub list: RwSignal<Vec<Notice>>,
    /// The last sentence for screen readers.
    pub said: RwSignal<String>,
}

impl Notices {
    /// Begins with these.
    pub(crate) fn new(list: Vec<Notice>) -> Notices {
        Notices { list: RwSignal::new(list), said: RwSignal::new(String::new()) }
    }

    /// Shows a notice.
    pub(crate) fn notify(self, tone: &'static str, text: String) {
        self.said.set(text.clone());
        self.list.update(|list| {
            list.retain(|notice| notice.text != text);
            list.push(Notice { tone, text, file: None });
        });
    }

    /// Takes a notice away.
    pub(crate) fn dismiss(self, text: &str) {
        self.list.update(|list| list.retain(|notice| notice.text != text));
    }

    /// Says a sentence to screen readers.
    pub(crate) fn say(self, text: impl Into<String>) {
        self.said.set(text.into());
    }
}
