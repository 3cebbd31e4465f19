//! Help as data: pages of machines, controls, terms and warnings, made from their rows; each entry has an id that links lead to.

pub mod content;
mod control;
pub mod explain;
mod machine;
mod own_alarms;
pub mod pages;
pub mod search;
mod terms;
pub mod texts;

use self::content::{HelpEntry, HelpPage, HelpPlace};
pub(super) use self::terms::open;
use self::texts::{Piece, Text, Texts};
use crate::controls::Control;
use crate::machines::AnyMachine;

/// All help. The first page is that of the present machine, the second that of its control.
#[derive(Debug, Clone)]
pub struct Help {
    /// Pages.
    pub pages: Vec<HelpPage>,
}

impl Help {
    /// The help of a machine on a control, in the language of the texts.
    pub fn new(machine: &'static dyn AnyMachine, control: &'static Control, texts: &Texts) -> Help {
        let mut help = Help { pages: pages::pages(machine, control, texts) };
        help.link();
        help
    }

    /// Section or entry with an id. An id without a page is looked for on the present pages first; an alarm without a row is one that a
    /// program raises itself.
    pub fn find(&self, id: &str) -> Option<HelpPlace<'_>> {
        let of = |id: &str| match id.split_once('/') {
            Some((page, id)) => self.pages.iter().find(|one| one.id == page)?.find(id),
            None => self.pages.iter().find_map(|page| page.find(id)),
        };
        of(id).or_else(|| id.split('/').next_back()?.starts_with("alarm.").then(|| of("alarm.user"))?)
    }

    /// Full id and name of the target of an id on a page: on that page, on the page of its control, or on any.
    fn target(&self, page: &HelpPage, id: &str) -> Option<(String, String)> {
        let own = |page: &str| self.find_on(page, id);
        let place = match id.split_once('/') {
            Some((page, id)) => self.find_on(page, id),
            None => own(page.id).or_else(|| own(page.control.id)).or_else(|| self.find(id)),
        }?;
        Some((place.id(), place.name()))
    }

    fn find_on(&self, page: &str, id: &str) -> Option<HelpPlace<'_>> {
        self.pages.iter().find(|one| one.id == page)?.find(id)
    }

    /// Gives each link its full id and its words; a link without a target becomes plain words.
    fn link(&mut self) {
        let known = self.clone();
        for (page, old) in self.pages.iter_mut().zip(&known.pages) {
            let texts = page.sections.iter_mut().flat_map(|section| {
                let own = section.text.iter_mut().chain(&mut section.steps);
                own.chain(section.entries.iter_mut().flat_map(HelpEntry::texts_mut))
            });
            for text in texts {
                for piece in text.iter_mut().filter(|piece| !piece.to.is_empty()) {
                    match known.target(old, &piece.to) {
                        Some((to, name)) => *piece = Piece { to, words: name },
                        None => *piece = Piece { words: core::mem::take(&mut piece.to), to: String::new() },
                    }
                }
                space(text);
            }
        }
    }
}

/// Puts a space where a Chinese character meets a Latin letter or a digit of the next piece.
fn space(text: &mut Text) {
    let chinese = |c: char| ('\u{4e00}'..='\u{9fff}').contains(&c);
    for at in 1..text.len() {
        let Some([before, behind]) = text.get_mut(at - 1..=at) else { continue };
        let ends = before.words.chars().next_back().zip(behind.words.chars().next());
        let meet =
            |(a, b): (char, char)| chinese(a) && b.is_ascii_alphanumeric() || a.is_ascii_alphanumeric() && chinese(b);
        match ends.is_some_and(meet) {
            true if behind.to.is_empty() => behind.words.insert(0, ' '),
            true => before.words.push(' '),
            false => {}
        }
    }
}
