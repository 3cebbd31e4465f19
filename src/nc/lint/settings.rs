//! Free text settings of switches: parts without effect.

use super::context::Lint;
use crate::controls::options::CallParameters;
use crate::msg;
use crate::text::{Diagnostic, DiagnosticKind};

/// Reports parts of text settings that could not be read, or bind nothing.
pub(super) fn idle_texts(lint: &mut Lint) {
    for (id, part) in lint.parsed.dialect().idle_texts(lint.control) {
        let message = match id {
            CallParameters::ID => msg!("lint.call-parameter", text = part),
            _ => msg!("lint.setting-unread", text = part, switch = id),
        };
        lint.found.push(Diagnostic::warning(message).kind(DiagnosticKind::Lint));
    }
}
