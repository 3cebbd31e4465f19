//! Taking values into the form: from a slider, or from a row of a sheet that sets fields.

use leptos::ev::MouseEvent;
use leptos::prelude::*;

use crate::machines::form::{FieldInfo, Values};
use crate::project::Project;
use crate::ui::dom;
use crate::ui::state::{EditKey, Page};

/// Sets fields from their texts.
pub(super) fn set<'t>(project: &Project, values: &mut Values, entries: impl IntoIterator<Item = (&'t str, &'t str)>) {
    let fields = project.machine.fields();
    for (id, text) in entries {
        if let Some(value) = fields.iter().find(|field| field.id == id).and_then(|field| field.read_metric(text).ok()) {
            values.insert(id.to_owned(), value);
        }
    }
}

/// Sets values in the form: a step of the history, merged with steps of the same key, if it has one, that follow at once.
pub(super) fn take(page: Page, key: Option<EditKey>, values: Values) {
    // Invalid entries of these fields are dropped.
    let changed: Vec<FieldInfo> = page.project.with_untracked(|project| {
        let changed = |field: &FieldInfo| values.get(field.id) != project.values.get(field.id);
        project.machine.fields().into_iter().filter(changed).collect()
    });
    changed.iter().for_each(|field| page.entries.accept(field.id));
    page.edit_as(key, |project| project.values = values);
}

/// Takes the values of the clicked row into the form and says so over the drawing, because the fields may be folded; `false` if the click
/// hit no such row.
pub(super) fn take_row(page: Page, event: &MouseEvent) -> bool {
    let Some(values) = row_values(page, event) else { return false };
    if page.project.with_untracked(|project| project.values != values) {
        take(page, None, values);
        page.notices.confirm(page.notices.announcement.get_untracked());
    }
    true
}

/// Values of the form with those of the clicked row; `None` if the click hit no such row.
fn row_values(page: Page, event: &MouseEvent) -> Option<Values> {
    let row = dom::closest(event, "[data-entries]")?;
    let entries = row.get_attribute("data-entries")?;
    let entries = entries.split('\n').filter_map(|entry| entry.split_once('='));
    page.project.with_untracked(|project| {
        let mut values = project.values.clone();
        set(project, &mut values, entries);
        Some(values)
    })
}
