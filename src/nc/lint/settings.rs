//! Settings of switches that are free text: what of them cannot be meant.

use super::Lint;
use crate::controls::Switches;
use crate::controls::macros::{CALL_PARAMETERS, SEPARATORS, setting};
use crate::msg;
use crate::text::Diagnostic;

/// Settings of calls by code that bind nothing: leaving one out changes no call.
pub(super) fn call_parameters(lint: &mut Lint) {
    let control = lint.control;
    let text = lint.parsed.switches().get(control.switches, CALL_PARAMETERS).unwrap_or("");
    let pieces: Vec<&str> = text.split(SEPARATORS).filter(|piece| !piece.is_empty()).collect();
    let calls = |pieces: &[&str]| control.code_calls(&Switches(vec![(CALL_PARAMETERS.to_owned(), pieces.join(" "))]));
    let all = calls(&pieces);
    for (at, piece) in pieces.iter().enumerate() {
        let mut others = pieces.clone();
        others.remove(at);
        // A parameter that is 0 is not set, and may be told so.
        let none = setting(piece).is_some_and(|(number, value)| value == 0 && control.macros.has_parameter(number));
        if !none && calls(&others) == all {
            lint.found.push(Diagnostic::warning(msg!("lint.call-parameter", *piece)));
        }
    }
}
