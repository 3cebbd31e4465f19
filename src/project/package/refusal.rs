//! Refused requests of the package, and their answers.

use serde_json::{Value as Json, json};

use crate::msg;
use crate::project::findings::file_findings::list_json;
use crate::project::requests::check_request::Refused;
use crate::text::Message;
use crate::text::catalog::sentence;

/// Characters of a request at most.
pub const MAX_REQUEST: u32 = 64 << 20;

/// Reason why a request is refused before it is read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EarlyRefusal {
    /// There is no such language; its code.
    Language,
    /// The request cannot be written as JSON.
    Unreadable,
    /// The request has more than [`MAX_REQUEST`] characters.
    TooLarge,
    /// The session was freed before.
    Freed,
    /// The module failed.
    Broken,
}

impl EarlyRefusal {
    /// The answer; `text` is the request's text that the sentence names.
    pub fn answer(self, text: &str) -> String {
        let message = match self {
            EarlyRefusal::Language => msg!("request.no-language", language = text, languages = "en, zh"),
            EarlyRefusal::Unreadable => msg!("request.unreadable"),
            EarlyRefusal::TooLarge => msg!("request.too-large", most = MAX_REQUEST >> 20),
            EarlyRefusal::Freed => msg!("request.freed"),
            EarlyRefusal::Broken => msg!("request.broken", reason = text),
        };
        error(&message).to_string()
    }
}

/// An answer that is an error in words.
pub(super) fn error(message: &Message) -> Json {
    json!({ "error": sentence(message), "diagnostics": [] })
}

/// Answer to a refused request: the first error of the files, with all their diagnostics.
pub(super) fn refused(why: &Refused) -> Json {
    match why {
        Refused::Choice(message) => error(message),
        Refused::Files(all) => {
            let mut list = all.iter().flat_map(|findings| &findings.list);
            let first = list.find(|finding| finding.is_error()).map(|finding| &finding.message);
            json!({ "error": first.map(sentence), "diagnostics": list_json(all) })
        }
    }
}
