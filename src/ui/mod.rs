//! The shell: signals and DOM, not one formula.

mod about;

mod cards;

mod charts;

mod checker;

mod dom;

mod editor;

mod field;

mod files;

mod form;

mod hand;

mod header;

mod help;

mod keys;

mod listing;

mod model;

mod player;

mod program;

mod results;

mod script;

mod sheets;

mod side;

mod stage;

mod store;

mod transport;

mod variables;

mod words;

use leptos::html;
use leptos::prelude::*;

use about::about_popup;
use cards::cards;
use charts::chart_pane;
use checker::check_dialog;
use files::export_dialog;
use form::form;
use hand::hand;
use header::header;
use help::help_dialog;
use model::{Model, Notice};
use side::side;
use stage::Stage;
use transport::{mode_tone, mode_words, transport};
use words::{sign, t};

pub use checker::work;

/// The page.
#[component]
pub fn App() -> impl IntoView {
    let (project, found) = store::load();
    let Some(project) = project else { return ().into_any() };
    let model = Model::new(project, found);
    keys::listen(model);
    files::listen(model);
    model.player.settle();
    view! {
        {header(model)}
        {notices(model)}
        <main class="page">
            {form(model)}
            <div class="centre">
                {cards(model)}
                {drawing(model)}
                {transport(model)}
                {hand(model)}
                {chart_pane(model)}
            </div>
            {side(model)}
        </main>
        {about_popup(model)}
        {export_dialog(model)}
        {help_dialog(model)}
        {check_dialog(model)}
        <div class="hidden" role="status">{move || model.said.get()}</div>
    }
    .into_any()
}

/// The machine.
fn drawing(model: Model) -> AnyView {
    let player = model.player;
    let host: NodeRef<html::Div> = NodeRef::new();
    let mode = Memo::new(move |_| player.now.with(|now| now.mode));
    let strobe = move |event| {
        player.strobe.set(event_target_checked(&event));
        player.ask();
    };
    Effect::new(move |_| {
        let Some(host) = host.get() else { return };
        model.scene.with(|scene| {
            host.set_inner_html(&stage::svg(scene));
            player.set_stage(Some(Stage::new(&host, scene)));
        });
    });
    view! {
        <section class="pane drawing" id="machine" aria-label=t("page.drawing")>
            <div class="stage" node_ref=host></div>
            <span class=move || format!("mode {}", mode_tone(mode.get()))>{move || mode_words(mode.get())}</span>
            <label class="check strobe"><input type="checkbox" prop:checked=move || player.strobe.get() on:change=strobe />{t("page.strobe")}</label>
        </section>
    }
    .into_any()
}

/// What the user has to know until it is dismissed.
fn notices(model: Model) -> AnyView {
    let rows = move || model.notices.get().into_iter().map(|notice| row(model, notice)).collect_view();
    view! { <div class="notices" aria-live="polite">{rows}</div> }.into_any()
}

fn row(model: Model, notice: Notice) -> AnyView {
    let text = notice.text.clone();
    let dismiss = move |_| model.notices.update(|notices| notices.retain(|other| other.text != text));
    let file = notice.file.map(|(name, content)| {
        let save = move |_| dom::download(name, "text/plain", content.as_bytes());
        view! { <button type="button" on:click=save>{t("page.save-file")}</button> }
    });
    view! {
        <div class=format!("notice {}", notice.tone)>
            <p><i aria-hidden="true">{sign(notice.tone)}</i> {notice.text}</p>
            {file}
            <button type="button" class="icon" aria-label=t("page.dismiss") on:click=dismiss>"✕"</button>
        </div>
    }
    .into_any()
}

/// Tells in plain DOM that the page has stopped: after a panic no signal works any more.
pub fn broken(reason: &str) {
    let Some(body) = web_sys::window().and_then(|window| window.document()?.body()) else { return };
    let Ok(told) = document().create_element("p") else { return };
    told.set_class_name("broken");
    told.set_text_content(Some(&words::say(&crate::msg!("page.broken", reason))));
    let _ = body.prepend_with_node_1(&told);
}
