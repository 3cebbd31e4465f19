//! Messages to the user: notices until they are dismissed, and sentences for screen readers.

use std::time::Duration;

use leptos::prelude::*;

use crate::ui::dom::delayed::Delayed;
use crate::ui::words::Tone;

/// Time after which a confirmation without a button leaves the drawing free again; it was announced, and what it says is on the page.
const CONFIRMED: Duration = Duration::from_secs(8);

/// A button of a notice: catalog id of its words, and its action.
pub(crate) type NoticeAction = (&'static str, Callback<()>);

/// A message to the user.
#[derive(Debug, Clone)]
pub(crate) struct Notice {
    /// Weight.
    pub tone: Tone,
    /// The sentence.
    pub text: String,
    /// Attached file: name and content.
    pub file: Option<(&'static str, String)>,
    /// Action that the notice offers.
    pub offer: Option<NoticeAction>,
    /// Whether the notice is about the present project, and disappears with it.
    pub of_project: bool,
    /// Whether the notice only confirms an action: the next confirmation replaces it, the next change removes it.
    pub confirms: bool,
}

impl Notice {
    /// A sentence alone.
    pub(crate) fn new(tone: Tone, text: String) -> Notice {
        Notice { tone, text, file: None, offer: None, of_project: false, confirms: false }
    }

    /// Whether the notice only confirms, without action and file.
    fn goes_by_itself(&self) -> bool {
        self.confirms && self.offer.is_none() && self.file.is_none()
    }

    /// Attaches a file: name and content.
    pub(crate) fn with_file(self, name: &'static str, content: String) -> Notice {
        Notice { file: Some((name, content)), ..self }
    }
}

/// The messages. A handle: copies share its state.
#[derive(Clone, Copy)]
pub(crate) struct Notices {
    /// Messages shown: each until the user dismisses it; a confirmation disappears by itself.
    pub list: RwSignal<Vec<Notice>>,
    /// The last sentence for screen readers.
    pub announcement: RwSignal<String>,
    /// Takes the shown confirmation away.
    end_of_confirmation: Delayed,
}

impl Notices {
    /// Begins with these.
    pub(crate) fn new(list: Vec<Notice>) -> Notices {
        Notices {
            list: RwSignal::new(list),
            announcement: RwSignal::new(String::new()),
            end_of_confirmation: Delayed::new(),
        }
    }

    /// Shows a notice.
    pub(crate) fn notify(self, tone: Tone, text: String) {
        self.show(Notice::new(tone, text));
    }

    /// Confirms an action, in place of the confirmation before it, until the next change.
    pub(crate) fn confirm(self, text: String) {
        self.confirm_as(Tone::Info, text);
    }

    /// Confirms an action that has a remark of this weight.
    pub(crate) fn confirm_as(self, tone: Tone, text: String) {
        self.show(Notice { confirms: true, ..Notice::new(tone, text) });
    }

    /// Shows a notice with its file and its button.
    pub(crate) fn show(self, shown: Notice) {
        self.announcement.set(shown.text.clone());
        if shown.goes_by_itself() {
            self.end_of_confirmation
                .call(move || self.list.update(|list| list.retain(|notice| !notice.goes_by_itself())), CONFIRMED);
        }
        self.list.update(|list| {
            list.retain(|notice| notice.text != shown.text && !(notice.confirms && shown.confirms));
            list.push(shown);
        });
    }

    /// Takes the notices about the present project away.
    pub(crate) fn leave_project(self) {
        self.list.update(|list| list.retain(|notice| !notice.of_project));
    }

    /// Takes the confirmations of earlier actions away.
    pub(crate) fn leave_action(self) {
        self.list.update(|list| list.retain(|notice| !notice.confirms));
    }

    /// Takes a notice away.
    pub(crate) fn dismiss(self, text: &str) {
        self.list.update(|list| list.retain(|notice| notice.text != text));
    }

    /// Announces a sentence to screen readers.
    pub(crate) fn announce(self, text: impl Into<String>) {
        self.announcement.set(text.into());
    }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;

    #[wasm_bindgen_test]
    fn same_notice_is_shown_once_and_announced_again() {
        let notices = Notices::new(Vec::new());
        notices.notify(Tone::Warn, "a".to_owned());
        notices.notify(Tone::Warn, "b".to_owned());
        notices.notify(Tone::Fail, "a".to_owned());
        let list = notices.list.get_untracked();
        assert_eq!(list.iter().map(|notice| notice.text.as_str()).collect::<Vec<_>>(), ["b", "a"]);
        assert_eq!((list[1].tone, notices.announcement.get_untracked().as_str()), (Tone::Fail, "a"));
    }

    #[wasm_bindgen_test]
    fn dismissed_notice_leaves_the_others() {
        let notices = Notices::new(Vec::new());
        ["a", "b"].into_iter().for_each(|text| notices.notify(Tone::Info, text.to_owned()));
        notices.dismiss("a");
        assert_eq!(notices.list.with_untracked(|list| list.iter().map(|n| n.text.clone()).collect::<Vec<_>>()), ["b"]);
    }

    #[wasm_bindgen_test]
    fn confirmation_takes_the_place_of_the_last_one_alone() {
        let notices = Notices::new(Vec::new());
        notices.notify(Tone::Info, "row 2".to_owned());
        notices.notify(Tone::Info, "row 5".to_owned());
        ["opened", "mended"].into_iter().for_each(|text| notices.confirm(text.to_owned()));
        let shown = notices.list.with_untracked(|list| list.iter().map(|n| n.text.clone()).collect::<Vec<_>>());
        assert_eq!(shown, ["row 2", "row 5", "mended"]);
        // The next change makes the confirmation stale.
        notices.leave_action();
        assert_eq!(notices.list.with_untracked(Vec::len), 2);
    }

    #[wasm_bindgen_test]
    fn notice_about_a_project_is_gone_with_it() {
        let notices = Notices::new(Vec::new());
        notices.show(Notice { of_project: true, ..Notice::new(Tone::Warn, "a".to_owned()) });
        notices.notify(Tone::Warn, "b".to_owned());
        notices.leave_project();
        assert_eq!(notices.list.with_untracked(|list| list.iter().map(|n| n.text.clone()).collect::<Vec<_>>()), ["b"]);
    }
}
