//! From the first module to the whole one: what a person asks for is done here, or there with the project as it stands.
//!
//! boot.js loads the whole module beside the first one, which works on meanwhile. In a moment in which nobody types or drags the whole one
//! asks for the state and puts its page in the place of the first one's, all in one task: nothing that is done at the page is lost, no
//! frame is between the two, and the next key finds its field. Whoever asks for something else meanwhile gets what he asked for last.

use leptos::wasm_bindgen::JsValue;
use leptos::wasm_bindgen::closure::Closure;

use super::dom;
use super::files;
use super::model::{Model, Notice};
use super::program::Shown;
use super::script::{call, get, list, object, rows, table, text};
use super::side;
use super::words::{say, t};
use crate::controls::{self, WHOLE};
use crate::machines;
use crate::msg;
use crate::nc::File;
use crate::project::Project;

/// Where it is kept which module the project needs, for boot.js.
const KEY: &str = "macroline.module";

/// Turns after which the effects of a page that was just made are done: each may make a part that has effects of its own.
const TURNS: u32 = 6;

/// What a person asks for, and what any module may lack.
#[derive(Clone)]
pub(super) enum Wish {
    /// The control of an id, for the present machine.
    Control(&'static str),
    /// The machine of an id.
    Machine(&'static str),
    /// What is in files: a project, or programs.
    Files(Vec<File>),
}

impl Wish {
    /// Does it, where this module can; else says false.
    fn grant(&self, model: Model) -> bool {
        match self {
            Wish::Control(id) => {
                let found = controls::find(id);
                if let Some(control) = found {
                    // It may have been asked for before its machine was there.
                    if model.project.with_untracked(|project| project.machine.controls().contains(id)) {
                        model.edit("", |project| project.move_to(control));
                    } else {
                        model.notify("warn", say(&msg!("page.not-on-machine", control.name)));
                    }
                }
                found.is_some()
            }
            Wish::Machine(id) if *id == model.machine.get_untracked() => true,
            Wish::Machine(id) => {
                let fresh = Project::of(id, None);
                let there = fresh.is_some();
                fresh.into_iter().for_each(|project| model.replace(project));
                there
            }
            Wish::Files(files) => files::read(model, files),
        }
    }

    /// What it is called.
    fn what(&self) -> &'static str {
        match self {
            Wish::Control(id) => controls::listed(id).map_or("", |row| row.name),
            Wish::Machine(id) => machines::listed(id).map_or("", |row| t(row.name)),
            Wish::Files(_) => t("page.loading-files"),
        }
    }
}

/// Does what a person asks for, in whichever module can.
pub(super) fn ask(model: Model, wish: Wish) {
    let before = model.wishes.get_untracked();
    let mut wishes = before.clone();
    // What is asked for last counts. A control is asked for on the machine, or with the files, that are asked for already.
    match wish {
        Wish::Control(_) => wishes.retain(|other| !matches!(other, Wish::Control(_))),
        _ => wishes.clear(),
    }
    if (wishes.is_empty() && wish.grant(model)) || WHOLE {
        if before.is_empty() {
            return;
        }
    } else {
        wishes.push(wish);
    }
    let what: Vec<&str> = wishes.iter().map(Wish::what).collect();
    let told = if what.is_empty() { String::new() } else { say(&msg!("page.loading", what.join(", "))) };
    model.wishes.set(wishes);
    model.dismiss(t("page.not-loaded"));
    // boot.js asks once for the state, or says what failed.
    let hand = move |failed: JsValue| {
        if failed.is_undefined() {
            return state(model);
        }
        if !model.wishes.with_untracked(Vec::is_empty) {
            model.wishes.set(Vec::new());
            model.notify("fail", t("page.not-loaded").to_owned());
        }
        failed
    };
    open(&Closure::<dyn Fn(JsValue) -> JsValue>::new(hand).into_js_value(), &told);
}

/// The machine that the page has, or that is asked for.
pub(super) fn machine(model: Model) -> &'static str {
    let present = model.machine.get();
    model.wishes.with(|wishes| {
        wishes.iter().find_map(|wish| if let Wish::Machine(id) = wish { Some(*id) } else { None }).unwrap_or(present)
    })
}

/// The control that the project has, or that is asked for.
pub(super) fn control(model: Model) -> &'static str {
    let present = model.project.with(|project| project.control.id);
    model.wishes.with(|wishes| {
        wishes.iter().find_map(|wish| if let Wish::Control(id) = wish { Some(*id) } else { None }).unwrap_or(present)
    })
}

/// Opens the page with the whole module in place of this one, which has not begun yet.
pub(super) fn instead() {
    open(&JsValue::UNDEFINED, "");
}

/// `told` stands in the page meanwhile; without it what was asked for before is not wanted any more.
fn open(hand: &JsValue, told: &str) {
    let _ = call(&js_sys::global(), "whole", &[hand, &told.into()]);
}

/// Keeps which module a project needs.
pub(super) fn keep(project: &Project) {
    let (machine, control) = (machines::listed(project.machine.id()), controls::listed(project.control.id));
    let first = !WHOLE || machine.is_some_and(|row| row.first) && control.is_some_and(|row| row.first);
    dom::store(KEY, if first { "first" } else { "whole" });
}

/// All that the other module has to know. This one rests from now on.
fn state(model: Model) -> JsValue {
    let player = model.player;
    let playing = player.playing.get_untracked();
    player.playing.set(false);
    model.aside.end();
    let [past, future] = model.steps().map(|steps| list(steps.iter().map(|project| project.to_json().into())));
    let notices = model.notices.with_untracked(|notices| {
        table(notices.iter().map(|notice| {
            let (name, content) = notice.file.clone().unwrap_or_default();
            vec![notice.tone.into(), notice.text.as_str().into(), name.into(), content.into()]
        }))
    });
    let mut files = Vec::new();
    let wishes = model.wishes.get_untracked().into_iter().map(|wish| {
        let (kind, id) = match wish {
            Wish::Control(id) => ("control", id),
            Wish::Machine(id) => ("machine", id),
            Wish::Files(all) => {
                files = all;
                ("files", "")
            }
        };
        vec![kind.into(), id.into()]
    });
    let wishes = table(wishes);
    object([
        ("project", model.project.with_untracked(Project::to_json).into()),
        ("past", past),
        ("future", future),
        ("notices", notices),
        ("tab", side::number(model.tab.get_untracked()).into()),
        ("file", (model.file.get_untracked() as u32).into()),
        ("editor", (model.shown.get_untracked() == Shown::Editor).into()),
        ("t", player.head().into()),
        ("speed", player.speed.get_untracked().into()),
        ("playing", playing.into()),
        ("wishes", wishes),
        ("files", table(files.iter().map(|file| vec![file.name.as_str().into(), file.text.as_str().into()]))),
    ])
}

/// What the first module hands over, where it had the page before.
pub(super) struct Handed(JsValue);

/// Takes the page over from the first module; none where this one opens it.
pub(super) fn handed() -> Option<Handed> {
    let state = call(&js_sys::global(), "handed", &[]).ok().filter(|_| WHOLE)?;
    (!state.is_undefined()).then_some(Handed(state))
}

impl Handed {
    /// The project and the notices; none where the project does not read.
    pub(super) fn project(&self) -> Option<(Option<Project>, Vec<Notice>)> {
        let project = Project::from_json(&text(&self.0, "project")).project?;
        let tones = ["info", "warn", "fail"];
        let notice = |[tone, text, name, content]: [String; 4]| {
            let file = (!name.is_empty()).then_some((super::store::ASIDE_FILE, content));
            Notice { tone: tones.into_iter().find(|one| *one == tone).unwrap_or_default(), text, file }
        };
        let notices = rows(&self.0, "notices").into_iter().map(notice).collect();
        Some((Some(project), notices))
    }

    /// Goes on where the first module was: history, tab, play head, and what was asked for.
    pub(super) fn go_on(self, model: Model) {
        let number = |name| get(&self.0, name).as_f64().unwrap_or_default();
        let steps = |name| {
            let steps = js_sys::Array::from(&get(&self.0, name));
            steps.iter().filter_map(|step| Project::from_json(&step.as_string()?).project).collect()
        };
        model.set_steps([steps("past"), steps("future")]);
        model.tab.set(side::numbered(number("tab") as u32));
        model.file.set(number("file") as usize);
        if get(&self.0, "editor").is_truthy() {
            model.shown.set(Shown::Editor);
        }
        let player = model.player;
        player.speed.set(number("speed"));
        player.seek(number("t"));
        if get(&self.0, "playing").is_truthy() {
            player.toggle();
        }
        let wish = |[kind, id]: [String; 2]| match kind.as_str() {
            "control" => controls::listed(&id).map(|row| Wish::Control(row.id)),
            "machine" => machines::listed(&id).map(|row| Wish::Machine(row.id)),
            _ => {
                let files = rows(&self.0, "files").into_iter().map(|[name, text]| File { name, text });
                Some(Wish::Files(files.collect()))
            }
        };
        let wishes: Vec<Wish> = rows(&self.0, "wishes").into_iter().filter_map(wish).collect();
        wasm_bindgen_futures::spawn_local(async move {
            for _ in 0..TURNS {
                leptos::task::tick().await;
            }
            // Where a person was and what he was typing stands in the page that he knows, before that becomes another one.
            let _ = call(&js_sys::global(), "again", &[]);
            wishes.into_iter().for_each(|wish| ask(model, wish));
        });
    }
}
