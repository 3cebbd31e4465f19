//! Texts of help that come from no row of a table: manuals of machines and controls, causes of alarms, terms.
//! The page loads their files when help is first opened.

use crate::text::catalog::{self, Language};

/// A piece of a text: words, or a link.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Piece {
    /// The words; in a link, the name of its target.
    pub words: String,
    /// Full id of the link's target; empty for words alone.
    pub to: String,
}

/// A paragraph, or a step of a list.
pub type Text = Vec<Piece>;

/// The texts of help in one language.
#[derive(Debug, Clone, Copy)]
pub struct Texts {
    /// Manual, in the format of the catalogs.
    pub manual: &'static str,
    /// The glossary of both languages, Markdown.
    pub glossary: &'static str,
}

impl Texts {
    /// The texts of a language, as they are in the repository. The page carries none: it loads them.
    #[cfg(any(not(feature = "web"), test))]
    pub fn shipped(language: Language) -> Texts {
        let manual = match language {
            Language::English => include_str!("../../text/help/help-en.properties"),
            Language::Chinese => include_str!("../../text/help/help-zh.properties"),
        };
        Texts { manual, glossary: include_str!("../../../docs/glossary.md") }
    }

    /// Names of the manual's and the glossary's files in a language.
    pub fn files(language: Language) -> (String, &'static str) {
        (format!("help-{}.properties", language.code()), "glossary.md")
    }

    /// The words of a key; the key itself if the file lacks it.
    pub fn words(&self, key: &'static str) -> &'static str {
        catalog::words_of(self.manual, key).unwrap_or(key)
    }

    /// The text of a key, if there is one.
    pub(super) fn text(&self, key: &str) -> Option<Text> {
        catalog::words_of(self.manual, key).map(linked)
    }

    /// The texts `key.1`, `key.2` and so on.
    pub(super) fn list(&self, key: &str) -> Vec<Text> {
        (1..).map_while(|number: u32| self.text(&format!("{key}.{number}"))).collect()
    }
}

/// A text without links.
pub(super) fn plain(words: impl Into<String>) -> Text {
    vec![Piece { words: words.into(), to: String::new() }]
}

/// Links to ids, one after the other.
pub(super) fn links(ids: impl IntoIterator<Item = String>) -> Text {
    let mut text = Text::new();
    for id in ids {
        if !text.is_empty() {
            text.extend(plain(" · "));
        }
        text.push(Piece { words: String::new(), to: id });
    }
    text
}

/// A text whose links are `{id}`.
fn linked(sentence: &str) -> Text {
    let mut text = Text::new();
    let mut rest = sentence;
    while let Some((before, tail)) = rest.split_once('{') {
        let Some((id, behind)) = tail.split_once('}') else { break };
        text.extend(plain(before));
        text.push(Piece { words: String::new(), to: id.to_owned() });
        rest = behind;
    }
    text.extend(plain(rest));
    text.retain(|piece| !piece.words.is_empty() || !piece.to.is_empty());
    text
}

/// The words of a text.
pub fn words(text: &Text) -> String {
    text.iter().map(|piece| piece.words.as_str()).collect()
}

/// A name of the code as a word of an id: `NoFeed` is `no-feed`.
pub(super) fn id_of(name: &str) -> String {
    let mut id = String::new();
    for c in name.chars() {
        if c.is_ascii_uppercase() && !id.is_empty() {
            id.push('-');
        }
        id.push(c.to_ascii_lowercase());
    }
    id
}
