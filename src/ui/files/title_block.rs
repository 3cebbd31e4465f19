//! The entries of the report's title block, at the export.

use leptos::prelude::*;

use crate::project::name::NAME_LENGTH;
use crate::ui::state::Page;
use crate::ui::words::{sentence, t};
use crate::view::report::TitleBlock;

/// Reads and writes an entry of the title block.
type Entry = fn(&mut TitleBlock) -> &mut String;

/// The entries of the report's title block, which are saved with the project. A change makes the documents again.
#[component]
pub(super) fn TitleBlockFields() -> impl IntoView {
    let page = Page::here();
    let entries: [(&'static str, Entry); 3] = [
        ("form.report.author", |block| &mut block.author),
        ("form.report.number", |block| &mut block.number),
        ("form.report.revision", |block| &mut block.revision),
    ];
    let row = |(label, entry): (&'static str, Entry)| {
        let value = move || page.project.with(|project| entry(&mut project.title_block.clone()).clone());
        let change = move |text| page.edit(|project| *entry(&mut project.title_block) = text);
        view! { <TitleBlockEntry label value change /> }
    };
    // Another machine may have no customer.
    let has_customer = Memo::new(move |_| page.project.with(|project| project.customer().is_some()));
    let customer = move || {
        let value = move || page.project.with(|project| project.customer().unwrap_or_default().to_owned());
        let change = move |text: String| page.edit(|project| project.set_customer(&text));
        has_customer.get().then(|| view! { <TitleBlockEntry label="form.customer" value change /> })
    };
    let in_program = move || {
        let short = page.project.with(|project| project.shortened_customer().map(str::to_owned))?;
        Some(sentence(&crate::msg!("page.customer-in-program", name = short)))
    };
    view! {
        <fieldset class="title-block">
            <legend>{t("page.title-block")}</legend>
            {customer}
            {entries.into_iter().map(row).collect_view()}
            <p class="in-program" role="status">{in_program}</p>
        </fieldset>
    }
}

/// An entry of the title block.
#[component]
fn TitleBlockEntry(
    /// Catalog id of its label.
    label: &'static str,
    /// Text of the entry.
    value: impl Fn() -> String + Send + 'static,
    /// Takes another text.
    change: impl Fn(String) + 'static,
) -> impl IntoView {
    let page = Page::here();
    let change = move |event| {
        change(event_target_value(&event));
        page.view.exporting.set(true);
    };
    view! { <label>{t(label)}<input type="text" maxlength=NAME_LENGTH.to_string() prop:value=value on:change=change /></label> }
}
