//! A project in the list: picture, name, actions, versions and steps.

use leptos::prelude::*;

use super::actions::ProjectActions;
use crate::msg;
use crate::project::name::NAME_LENGTH;
use crate::ui::words::{sentence, shown_name, t};
use crate::ui::worker::messages::{ListedProject, ListedStep, ListedVersion, ShelfPlace, ShelfState};

/// One project of the list.
#[component]
pub(super) fn ProjectItem(
    /// The list.
    actions: ProjectActions,
    /// Id of the project.
    id: String,
) -> impl IntoView {
    let id = StoredValue::new(id);
    let item = Memo::new(move |_| id.with_value(|id| actions.item(id)));
    let place = Memo::new(move |_| item.with(|item| item.place));
    let reads = Memo::new(move |_| item.with(|item| item.unread.is_none()));
    let about = move || item.with(|item| item.unread.clone().unwrap_or_else(|| item.kind.clone()));
    view! {
        <li class:present=move || place.get() == ShelfPlace::Present>
            <span class="mini">
                <Show when=move || item.with(|item| !item.picture.is_empty())>
                    <img alt="" src=move || item.with(|item| item.picture.clone()) />
                </Show>
            </span>
            <div class="what">
                <Show
                    when=move || reads.get() && place.get() != ShelfPlace::Aside
                    fallback=move || view! { <b>{move || item.with(title)}</b> }
                >
                    <input
                        type="text" maxlength=NAME_LENGTH.to_string() autocomplete="off" aria-label=t("page.name") placeholder=t("page.untitled")
                        prop:value=move || item.with(|item| item.name.clone())
                        on:change=move |event| id.with_value(|id| actions.rename(id, &event_target_value(&event)))
                    />
                </Show>
                <small>{about}</small>
                <small>{move || item.with(|item| item.kept.clone())}</small>
            </div>
            <div class="acts">
                {move || {
                    let (reads, present, aside) =
                        (reads.get(), place.get() == ShelfPlace::Present, place.get() == ShelfPlace::Aside);
                    let act = |label, shown: bool, act: fn(ProjectActions, ShelfState)| {
                        let about = Signal::derive(move || item.with(title));
                        shown.then(|| view! { <ItemButton label=label about=about press=actions.with_state(id, act) /> })
                    };
                    [
                        act("page.open", reads && !present, ProjectActions::open),
                        act("projects.compare", reads && !present && !aside, ProjectActions::compare),
                        act("projects.duplicate", reads && !aside, ProjectActions::duplicate),
                        act("page.save-file", true, ProjectActions::save),
                        act("page.delete", !present, ProjectActions::delete),
                    ]
                }}
            </div>
            <Show when=move || item.with(|item| item.place == ShelfPlace::Present || !item.versions.is_empty())>
                <Versions actions=actions item=item />
            </Show>
            <Show when=move || item.with(|item| !item.steps.is_empty())>
                <Steps actions=actions item=item />
            </Show>
        </li>
    }
}

/// The name of a project in the list.
fn title(item: &ListedProject) -> String {
    let name = match (&item.unread, item.name.as_str()) {
        (Some(_), _) => t("page.aside-unread"),
        (None, name) => shown_name(name),
    };
    name.to_owned()
}

/// A button of a project or version.
#[component]
fn ItemButton(
    /// Catalog id of its words.
    label: &'static str,
    /// Name of the project or version, for people who do not see its place.
    #[prop(into)]
    about: Signal<String>,
    /// The action.
    press: Callback<()>,
) -> impl IntoView {
    let name = move || about.with(|about| [t(label), about].join(" "));
    view! { <button type="button" aria-label=name on:click=move |_| press.run(())>{t(label)}</button> }
}

/// The versions of a project, and the field that keeps one of the present project.
#[component]
fn Versions(
    /// The list.
    actions: ProjectActions,
    /// The project.
    item: Memo<ListedProject>,
) -> impl IntoView {
    let note = RwSignal::new(String::new());
    let keep = move |_| {
        // A note that could not be kept stays.
        actions.keep(&note.get_untracked(), move || drop(note.try_set(String::new())));
    };
    let count = move || item.with(|item| item.versions.len() as u32);
    view! {
        <details class="versions">
            <summary>{move || sentence(&msg!("projects.versions", count = count()))}</summary>
            <Show when=move || item.with(|item| item.place == ShelfPlace::Present)>
                <div class="keep">
                    <input
                        type="text" maxlength=NAME_LENGTH.to_string() autocomplete="off" aria-label=t("projects.note") placeholder=t("projects.note")
                        prop:value=note on:input=move |event| note.set(event_target_value(&event))
                    />
                    <button type="button" on:click=keep>{t("projects.keep")}</button>
                </div>
            </Show>
            <ul>
                <For each=move || item.get().versions key=|version| (version.id.clone(), version.changes.clone()) let:version>
                    <Version actions=actions version=version />
                </For>
            </ul>
        </details>
    }
}

/// A version of a project.
#[component]
fn Version(
    /// The list.
    actions: ProjectActions,
    /// The version.
    version: ListedVersion,
) -> impl IntoView {
    let ListedVersion { id, name, kept, changes, unread } = version;
    let id = StoredValue::new(id);
    let reads = unread.is_none();
    let act = |label, shown: bool, act: fn(ProjectActions, ShelfState)| {
        let about = name.clone();
        shown.then(|| view! { <ItemButton label=label about=about press=actions.with_state(id, act) /> })
    };
    let acts = [
        act("page.open", reads, ProjectActions::open),
        act("projects.compare", reads, ProjectActions::compare),
        act("page.save-file", true, ProjectActions::save),
        act("page.delete", true, ProjectActions::delete),
    ];
    view! {
        <li>
            <div class="what">
                <b>{name}</b>
                {(!kept.is_empty()).then(|| view! { <small>{kept}</small> })}
                <small>{unread.unwrap_or(changes)}</small>
            </div>
            <div class="acts">{acts}</div>
        </li>
    }
}

/// The steps of undo and redo of the present project.
#[component]
fn Steps(
    /// The list.
    actions: ProjectActions,
    /// The project.
    item: Memo<ListedProject>,
) -> impl IntoView {
    let count = move || item.with(|item| item.steps.len().saturating_sub(1) as u32);
    let step = move |ListedStep { steps, changes }| match steps {
        0 => view! { <li aria-current="step"><b>{changes}</b><small>{t("variants.now")}</small></li> }.into_any(),
        steps => view! {
            <li class:undone={steps > 0}>
                <button type="button" class="link" on:click=move |_| actions.travel(steps)>{changes}</button>
                {(steps > 0).then(|| view! { <small>{t("projects.undone")}</small> })}
            </li>
        }
        .into_any(),
    };
    view! {
        <details class="versions steps">
            <summary>{move || sentence(&msg!("projects.steps", count = count()))}</summary>
            <ul>{move || item.get().steps.into_iter().map(step).collect_view()}</ul>
        </details>
    }
}
