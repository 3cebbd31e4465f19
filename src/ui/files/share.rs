//! The link that carries the project, and the opening of the page with one.

use leptos::html;
use leptos::prelude::*;

use super::open::show;
use crate::project::Project;
use crate::project::saved::{Loaded, is_link};
use crate::ui::dom;
use crate::ui::parts::{Dialog, DialogButton};
use crate::ui::state::Page;
use crate::ui::state::notices::Notice;
use crate::ui::words::{Tone, figure, sentence, sentence_with_hints, t};

/// Characters above which the user is warned that some mail programs cut a link. Our choice.
const LONG: usize = 2000;

/// The project of the page's address.
pub(super) fn linked() -> Option<Loaded> {
    let (_, fragment) = dom::address();
    is_link(&fragment).then(|| Project::from_link(&fragment))
}

/// Removes the link from the address once its project is stored, so that a reload shows the project as changed since.
pub(super) fn forget_link() {
    if is_link(&dom::address().1) {
        dom::forget_fragment();
    }
}

/// Notices about the project of a link.
pub(super) fn notices(linked: &Loaded) -> Vec<Notice> {
    let copy = Notice::new(Tone::Info, t("page.link-opened").to_owned());
    let found = linked.diagnostics.iter();
    let found = found.map(|found| Notice::new(Tone::from(found.severity), sentence_with_hints(found)));
    linked.project.is_some().then_some(copy).into_iter().chain(found).collect()
}

/// Opens the project of a link that is put into the address of the open page.
pub(crate) fn listen(page: Page) {
    dom::on_event("hashchange", move |_| {
        // The page may be gone.
        if !page.is_gone() {
            open(page);
        }
    });
}

fn open(page: Page) {
    let Some(linked) = linked() else { return };
    for Notice { tone, text, .. } in notices(&linked) {
        page.notices.notify(tone, text);
    }
    let Some(project) = linked.project else { return };
    show(page, project);
}

/// Saves the project as a file.
pub(super) fn save(page: Page) {
    let (name, text) = page.project.with_untracked(|project| (project.file_name("json"), project.to_json()));
    dom::download(&name, "application/json", text.as_bytes());
}

/// The button of the link.
#[component]
pub(super) fn ShareButton() -> impl IntoView {
    view! { <DialogButton id="share" label="page.share" about="page.share-about" open=Page::here().view.sharing /> }
}

/// The dialog with the link, or with the reason why there is none.
#[component]
pub(crate) fn ShareDialog() -> impl IntoView {
    let page = Page::here();
    let open = page.view.sharing;
    let link = Memo::new(move |_| open.get().then(|| page.project.with_untracked(Project::to_link)));
    let content = move || {
        Some(match link.get()? {
            Ok(fragment) => {
                let text = format!("{}#{fragment}", dom::address().0);
                let long = (text.len() > LONG).then(|| view! { <p class="warn">{t("page.link-long")}</p> });
                view! { <CopyField text=text about=LINK /> {long} }.into_any()
            }
            Err(reason) => view! { <p class="fail">{sentence(&reason)}</p> }.into_any(),
        })
    };
    // An `<iframe>` with the project, for a page of another host.
    let element = move || {
        let text = frame(&dom::address().0, &link.get()?.ok()?);
        Some(view! {
            <h3>{t("page.embed")}</h3>
            <p>{t("page.embed-about")}</p>
            <div class="share"><CopyField text=text about=ELEMENT /></div>
        })
    };
    let shared = if leads_to_this_disk(&dom::address().0) {
        view! {
            <p>{t("page.share-local")}</p>
            <p><button type="button" class="primary" on:click=move |_| save(page)>{t("page.save-about")}</button></p>
        }
        .into_any()
    } else {
        view! {
            <p>{t("page.share-about")}</p>
            <div class="share">{content}</div>
            <p>{t("page.share-file")} " " <button type="button" class="link" on:click=move |_| save(page)>{t("page.save-about")}</button></p>
            {element}
        }
        .into_any()
    };
    view! {
        <Dialog id="share-title" title=t("page.share-title") open=open close=move || open.set(false)>
            {shared}
        </Dialog>
    }
}

/// Whether an address is that of a file on this disk, which no other computer and no page of another host can open.
fn leads_to_this_disk(address: &str) -> bool {
    address.starts_with("file:")
}

/// The element that shows a project inside another page. Only `&` and `"` of the address need an escape.
fn frame(address: &str, fragment: &str) -> String {
    let address = address.replace('&', "&amp;").replace('"', "&quot;");
    format!(
        r#"<iframe src="{address}#embed&amp;{fragment}" title="macroline" width="100%" height="720" loading="lazy" style="border: 0"></iframe>"#
    )
}

/// A text to copy, by catalog ids.
struct CopyText {
    /// Id and class of the button.
    button: (&'static str, &'static str),
    /// Name of the text.
    name: &'static str,
    /// Words of the button.
    words: &'static str,
    /// Message after the text was copied to the clipboard.
    copied: &'static str,
}

/// The link.
const LINK: CopyText = CopyText {
    button: ("copy-link", "primary"),
    name: "page.share-link",
    words: "page.copy-link",
    copied: "page.link-copied",
};

/// The element for another page.
const ELEMENT: CopyText = CopyText {
    button: ("copy-frame", ""),
    name: "page.embed-frame",
    words: "page.embed-copy",
    copied: "page.embed-copied",
};

/// A text, and the button that copies it.
#[component]
fn CopyField(
    /// The text.
    text: String,
    /// Catalog ids of its name, button and message.
    about: CopyText,
) -> impl IntoView {
    let page = Page::here();
    let field: NodeRef<html::Input> = NodeRef::new();
    let said = RwSignal::new("");
    let select = move || field.get_untracked().iter().for_each(|field| field.select());
    let size = sentence(&crate::msg!("page.link-length", count = figure(text.len() as f64, 0)));
    let to_copy = text.clone();
    let copy = move |_| {
        select();
        dom::copy(&to_copy, move |copied| {
            let words = t(if copied { about.copied } else { "page.link-not-copied" });
            // The dialog may be gone.
            let _ = said.try_set(words);
            page.notices.announce(words);
        });
    };
    view! {
        <input
            node_ref=field type="text" readonly=true spellcheck="false" aria-label=t(about.name) value=text
            on:focus=move |_| select()
        />
        <div class="copies">
            <small>{size}</small>
            <span class="said">{said}</span>
            <button type="button" class=about.button.1 id=about.button.0 on:click=copy>{t(about.words)}</button>
        </div>
    }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::machines::form::Value;
    use crate::nc::Files;
    use crate::ui::testing::{ViewBench, mount, project, settled};

    async fn shared(project: Project) -> ViewBench {
        let bench = crate::ui::testing::mount_project(project, || view! { <ShareButton /> <ShareDialog /> }).await;
        bench.press("#share").await;
        bench
    }

    /// Puts a fragment into the address and opens its project.
    async fn opened(bench: &ViewBench, fragment: &str) {
        window().location().set_hash(fragment).unwrap();
        open(bench.page);
        settled().await;
    }

    #[wasm_bindgen_test]
    async fn link_of_the_dialog_carries_the_present_project() {
        let mut order = project();
        order.name = "Order 7".to_owned();
        let bench = shared(order.clone()).await;
        let link = bench.value(".share input");
        let (_, fragment) = link.split_once('#').unwrap();
        assert!(Project::from_link(fragment).project == Some(order));
        assert!(!bench.has(".share .warn"));
    }

    #[wasm_bindgen_test]
    async fn address_of_a_file_is_not_shared() {
        assert!(leads_to_this_disk("file:///media/stick/macroline.html"));
        assert!(!leads_to_this_disk(&dom::address().0) && !leads_to_this_disk("https://file.example/"));
        let bench = shared(project()).await;
        assert!(!bench.text("dialog").contains(t("page.share-local")));
    }

    #[wasm_bindgen_test]
    async fn project_too_long_for_a_link_gives_a_notice() {
        let mut order = project();
        let words = (0..4000_u32).map(|at| format!("N{at} G01 X{}.{at}\n", at * 7919 % 10_007));
        order.edited = Some(Files::one("O1.nc", words.collect::<String>()));
        let bench = shared(order).await;
        assert!(!bench.has(".share input") && bench.has(".share .fail"));
    }

    #[wasm_bindgen_test]
    async fn link_in_the_address_of_the_open_page_is_taken() {
        let bench = mount(|| ()).await;
        bench.page.set("pitch", Value::Number(9.0));
        let mut theirs = project();
        theirs.name = "Order 7".to_owned();
        opened(&bench, &theirs.to_link().unwrap()).await;
        assert!(bench.page.project.get_untracked() == theirs);
        assert_eq!(bench.notices(), [t("page.link-opened")]);
        forget_link();
        assert_eq!(dom::address().1, "");
        bench.page.undo();
        assert_eq!(bench.setting("pitch"), Some(Value::Number(9.0)));
    }

    #[wasm_bindgen_test]
    async fn cut_link_changes_nothing_and_gives_a_notice() {
        let bench = mount(|| ()).await;
        let link = project().to_link().unwrap();
        opened(&bench, link.get(..link.len() - 5).unwrap()).await;
        assert!(bench.page.project.get_untracked() == project());
        assert_eq!(bench.notices().len(), 1);
        forget_link();
    }

    #[wasm_bindgen_test]
    async fn other_fragments_stay() {
        let bench = mount(|| ()).await;
        opened(&bench, "machine").await;
        forget_link();
        assert_eq!((dom::address().1.as_str(), bench.notices().len()), ("machine", 0));
        dom::forget_fragment();
    }
}
