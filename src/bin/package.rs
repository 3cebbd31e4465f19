//! The package of the core for JavaScript: its module, which `package/index.js` loads.

use macroline::project::package::{self, EarlyRefusal, StepAnswers};
use macroline::text::catalog::{self, Language};
use wasm_bindgen::prelude::wasm_bindgen;

/// Selects a language; returns the refusal, in English, if there is no such language.
fn speak(code: &str) -> Option<String> {
    let language = Language::of_code(code);
    catalog::speak(language.unwrap_or(Language::English).sentences());
    language.is_none().then(|| EarlyRefusal::Language.answer(code))
}

/// Answers a request in a language; see [`package::answer`].
#[wasm_bindgen]
pub fn answer(language: &str, ask: &str, request: &str) -> String {
    speak(language).unwrap_or_else(|| package::answer(ask, request))
}

/// Characters of a request at most.
#[wasm_bindgen]
pub fn most() -> u32 {
    package::MAX_REQUEST
}

/// The answer to a request that cannot be passed on: `too-large`, `freed`, `broken`; any other reason means that it is not JSON.
#[wasm_bindgen]
pub fn refusal(language: &str, why: &str, text: &str) -> String {
    let unasked = match why {
        "too-large" => EarlyRefusal::TooLarge,
        "freed" => EarlyRefusal::Freed,
        "broken" => EarlyRefusal::Broken,
        _ => EarlyRefusal::Unreadable,
    };
    speak(language).unwrap_or_else(|| unasked.answer(text))
}

/// A session of the debugger.
#[wasm_bindgen(js_name = Session)]
pub struct StepSession {
    language: String,
    steps: Option<StepAnswers>,
    first: String,
}

#[wasm_bindgen(js_class = Session)]
impl StepSession {
    /// Begins a session; its first stop is [`StepSession::first`].
    #[wasm_bindgen(constructor)]
    pub fn new(language: String, request: &str) -> StepSession {
        let (steps, first) = match speak(&language) {
            Some(answer) => (None, answer),
            None => StepAnswers::new(request),
        };
        StepSession { language, steps, first }
    }

    /// The first stop, or the reason why there is no session.
    pub fn first(&mut self) -> String {
        core::mem::take(&mut self.first)
    }

    /// Carries out a command.
    pub fn answer(&mut self, command: &str) -> String {
        // The language was there when the session began.
        let _ = speak(&self.language);
        match &mut self.steps {
            Some(steps) => steps.answer(command),
            None => EarlyRefusal::Freed.answer(""),
        }
    }
}

// The module is started by `package/index.js`.
fn main() {}
