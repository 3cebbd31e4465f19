//! The shell: signals and DOM, not one formula.

mod field_help;

mod cards;

mod charts;

mod chart_pane;

mod checker;

mod debug;

mod dom;

mod editor;

mod el;

mod explore;

mod field;

mod files;

mod form;

mod operator_panel;

mod header;

mod help;

mod keys;

mod listing;

mod local;

mod model;

mod player;

mod program;

mod results;

mod script;

mod sheets;

mod side;

mod scene_view;

mod state;

mod store;

mod transport;

mod variables;

mod debug_session;

mod walk;

mod words;

mod worker;

use leptos::html;
use leptos::prelude::*;

use cards::cards;
use chart_pane::chart_pane;
use checker::check_dialog;
use el::{El, button, check, el, icon_button};
use field_help::about_popup;
use files::export_dialog;
use form::form;
use header::header;
use help::help_dialog;
use model::Model;
use operator_panel::hand;
use scene_view::Stage;
use side::side;
use state::Notice;
use transport::{mode_tone, mode_words, transport};
use words::{sign, t, tell_alarm};

use crate::motion::RunEnd;
use crate::project::check::reported;

pub use worker::server::work;

/// Opens the page. A panic is reported in its place.
pub fn open() {
    std::panic::set_hook(Box::new(|panic| {
        web_sys::console::error_1(&panic.to_string().into());
        broken(&panic.to_string());
    }));
    leptos::mount::mount_to_body(App);
}

/// The page.
#[component]
pub fn App() -> impl IntoView {
    let host: NodeRef<html::Div> = NodeRef::new();
    host.on_load(|host| {
        if let Some(page) = page() {
            let _ = host.append_child(page.dom());
        }
    });
    view! { <div class="app" node_ref=host></div> }
}

/// All of the page.
fn page() -> Option<El> {
    let (project, found) = store::load();
    let model = Model::new(project?, found);
    debug::restore(model);
    store::keep(model);
    worker::diagnostics::follow(model);
    keys::listen(model);
    files::listen(model);
    model.player.settle();
    let centre =
        el("div.centre").add(&[cards(model), drawing(model), transport(model), hand(model), chart_pane(model)]);
    Some(el("div.app").add(&[
        header(model),
        notices(model),
        el("main.page").add(&[form(model), centre, side(model)]),
        about_popup(model),
        export_dialog(model),
        help_dialog(model),
        check_dialog(model),
        el("div.hidden").at("role", "status").live(move || model.said.get()),
    ]))
}

/// The machine.
fn drawing(model: Model) -> El {
    let player = model.player;
    let stage = el("div.stage").at("tabindex", "0").at("role", "group").label(t("page.drawing"));
    let host = stage.dom().clone();
    let draw = move || {
        model.scene.with(|scene| {
            host.set_inner_html(&scene_view::svg(scene));
            player.set_stage(Some(Stage::new(&host, scene)));
        });
    };
    let mode = move || player.now.with(|now| now.mode);
    let option = move |on| {
        player.option.set(on);
        player.ask();
    };
    el("section.pane.drawing#machine").label(t("page.drawing")).add(&[
        stage.run(draw),
        el("span")
            .bind("class", move || format!("mode {}", mode_tone(mode())))
            .live(move || mode_words(mode()).to_owned()),
        el("p.why").at("role", "status").live(move || why(model)),
        el("div.strobe").swap(move || {
            let label = model.scene.with(|scene| scene.option);
            label.into_iter().map(|label| check(t(label), move || player.option.get(), option)).collect()
        }),
    ])
}

/// Why the machine stands at the end of what is planned.
fn why(model: Model) -> String {
    let (at, (planned, _)) = (model.player.now.with(|now| now.t), model.player.planned.get());
    match model.player.ended.get().filter(|_| at >= planned) {
        // In the words that stand at its place in the program.
        Some(RunEnd::Alarm(alarm)) => {
            model.findings.with(|findings| tell_alarm(reported(findings, &alarm).unwrap_or(&alarm)))
        }
        end => end.map_or_else(String::new, |end| words::end_words(&end)),
    }
}

/// What the user has to know until it is dismissed.
fn notices(model: Model) -> El {
    let rows = move || model.notices.get().into_iter().map(|notice| row(model, notice)).collect();
    el("div.notices").at("aria-live", "polite").swap(rows)
}

fn row(model: Model, notice: Notice) -> El {
    let text = notice.text.clone();
    let dismiss = move || model.dismiss(&text);
    let save = notice.file.map(|(name, content)| {
        button("button", t("page.save-file"), move || dom::download(name, "text/plain", content.as_bytes()))
    });
    let mark = el("i").at("aria-hidden", "true").text(sign(notice.tone));
    el("div")
        .at("class", &format!("notice {}", notice.tone))
        .add(&[el("p").add(&[mark]).text(" ").text(&notice.text)])
        .maybe(save)
        .add(&[icon_button("button.icon", "✕", t("page.dismiss"), dismiss)])
}

/// Tells in plain DOM that the page has stopped: after a panic no signal works any more.
fn broken(reason: &str) {
    let Some(body) = web_sys::window().and_then(|window| window.document()?.body()) else { return };
    let Ok(told) = document().create_element("p") else { return };
    told.set_class_name("broken");
    told.set_text_content(Some(&words::say(&crate::msg!("page.broken", reason))));
    let _ = body.prepend_with_node_1(&told);
}
