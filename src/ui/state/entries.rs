//! Entries of the form that are not valid values.

use leptos::prelude::*;

use crate::text::Diagnostic;

/// Invalid entries of the form; the project keeps the last valid values. A handle: copies share its state.
#[derive(Clone, Copy)]
pub(crate) struct Entries {
    /// Fields whose text is wrong, with the reason.
    pub invalid: RwSignal<Vec<Diagnostic>, LocalStorage>,
    /// Counts the times that every field has to show its value again.
    pub reread: RwSignal<u32>,
}

impl Entries {
    /// Nothing wrong.
    pub(crate) fn new() -> Entries {
        Entries { invalid: RwSignal::new_local(Vec::new()), reread: RwSignal::new(0) }
    }

    /// Notes that the text of a field is wrong.
    pub(crate) fn refuse(self, id: &'static str, problem: Diagnostic) {
        self.invalid.update(|invalid| {
            invalid.retain(|other| other.field != Some(id));
            invalid.push(problem.about(id));
        });
    }

    /// Records that the field has a valid value, which replaces an invalid text.
    pub(crate) fn accept(self, id: &'static str) {
        if self.invalid.with_untracked(|invalid| of_field(invalid, id).is_some()) {
            self.invalid.update(|invalid| invalid.retain(|other| other.field != Some(id)));
            self.show_again();
        }
    }

    /// The reason why the text of a field is wrong.
    pub(crate) fn refused(self, id: &str) -> Option<Diagnostic> {
        self.invalid.with(|invalid| of_field(invalid, id).cloned())
    }

    /// Every field shows its value again.
    pub(crate) fn show_again(self) {
        self.reread.update(|count| *count += 1);
    }
}

/// The diagnostic about a field.
pub(crate) fn of_field<'d>(diagnostics: &'d [Diagnostic], field: &str) -> Option<&'d Diagnostic> {
    diagnostics.iter().find(|d| d.field == Some(field))
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;

    #[wasm_bindgen_test]
    fn field_has_one_reason_until_it_is_accepted() {
        let entries = Entries::new();
        ["page.broken", "page.not-a-value"].into_iter().for_each(|_| {
            entries.refuse("pitch", Diagnostic::error(crate::msg!("page.not-a-value")));
        });
        assert_eq!(entries.invalid.with_untracked(Vec::len), 1);
        entries.accept("heads");
        assert!(entries.refused("pitch").is_some());
        entries.accept("pitch");
        assert!(entries.refused("pitch").is_none());
    }
}
