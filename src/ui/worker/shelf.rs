//! The list of projects as HTML: each with its picture, what can be done with it, and its versions. Rows are hostile until checked.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;

use super::documents::tagged;
use super::messages::{BEFORE_PROGRAM, BEFORE_VERSION, OTHER_TAB, Shelf, ShelfState};
use crate::msg;
use crate::project::Project;
use crate::project::changes::changes_in_words;
use crate::project::drawing;
use crate::project::saved::with_line;
use crate::text::clauses;
use crate::ui::words::{day, say, t};
use crate::view::svg::{Theme, escape, picture};

/// Version of the states that this page reads.
const VERSION: f64 = 1.0;

/// Pictures that are drawn: of the projects that were kept last.
const PICTURES: usize = 40;

/// Notes of versions that the page has kept by itself, with the catalog ids of their sentences.
const NOTES: [(&str, &str); 3] = [
    (BEFORE_PROGRAM, "projects.before-program"),
    (BEFORE_VERSION, "projects.before-version"),
    (OTHER_TAB, "page.aside-other-tab"),
];

/// The projects as items of a list: the present one, the others from the last kept to the first, and the states that were set aside.
pub(in crate::ui) fn list(present: &Project, shelf: &Shelf) -> String {
    let mut out = String::new();
    let mut projects: Vec<&ShelfState> = shelf.states.iter().filter(|state| state.of.is_empty()).collect();
    projects.sort_by(|a, b| b.at.total_cmp(&a.at).then_with(|| a.id.cmp(&b.id)));
    let now = ShelfState { id: shelf.present.clone(), text: present.to_json(), ..ShelfState::default() };
    let others = projects.into_iter().filter(|state| state.id != now.id);
    for (at, state) in std::iter::once(&now).chain(others).chain(&shelf.aside).enumerate() {
        item(&mut out, present, shelf, state, at < PICTURES);
    }
    out
}

/// The project of a state, or why it does not read.
fn read(state: &ShelfState) -> Result<Project, String> {
    if state.version > VERSION {
        return Err(t("projects.newer").to_owned());
    }
    let loaded = Project::from_json(&state.text);
    let reason = || loaded.diagnostics.first().map(|found| with_line(found, &state.text)).unwrap_or_default();
    loaded.project.clone().ok_or_else(reason)
}

/// One project.
fn item(out: &mut String, present: &Project, shelf: &Shelf, state: &ShelfState, pictured: bool) {
    let is_present = state.id == shelf.present;
    let is_aside = shelf.aside.iter().any(|aside| aside.id == state.id);
    let project = read(state);
    let (name, kind) = match &project {
        Ok(project) => (name_of(project), clauses([t(project.machine.name()), project.control.name])),
        Err(reason) => (t("page.aside-unread").to_owned(), reason.clone()),
    };
    out.push_str("<li data-id=\"");
    escape(out, &state.id);
    out.push_str("\" data-words=\"");
    escape(out, &format!("{name} {kind}").to_lowercase());
    out.push_str(if is_present { "\" class=\"present\">" } else { "\">" });
    out.push_str("<span class=\"mini\">");
    if let (Ok(project), true) = (&project, pictured) {
        out.push_str("<img alt=\"\" src=\"data:image/svg+xml;base64,");
        out.push_str(&STANDARD.encode(miniature(project, shelf.dark)));
        out.push_str("\">");
    }
    out.push_str("</span><div class=\"what\">");
    match &project {
        Ok(project) if !is_aside => {
            out.push_str(
                "<input type=\"text\" maxlength=\"120\" autocomplete=\"off\" data-act=\"rename\" aria-label=\"",
            );
            escape(out, t("page.name"));
            out.push_str("\" placeholder=\"");
            escape(out, t("page.untitled"));
            out.push_str("\" value=\"");
            escape(out, &project.name);
            out.push_str("\">");
        }
        _ => tagged(out, "b", &name),
    }
    tagged(out, "small", &kind);
    let when = if is_present { t("projects.present").to_owned() } else { day(state.at) };
    tagged(out, "small", &clauses([when.as_str(), note(state)].into_iter().filter(|part| !part.is_empty())));
    out.push_str("</div><div class=\"acts\">");
    let acts: &[(&str, &'static str)] = match (&project, is_aside, is_present) {
        (Ok(_), false, true) => &[("duplicate", "projects.duplicate"), ("save", "page.save-file")],
        (Ok(_), false, false) => &[
            ("open", "page.open"),
            ("compare", "projects.compare"),
            ("duplicate", "projects.duplicate"),
            ("save", "page.save-file"),
            ("delete", "page.delete"),
        ],
        (Ok(_), true, _) => &[("open", "page.open"), ("save", "page.save-file"), ("delete", "page.delete")],
        (Err(_), ..) => &[("save", "page.save-file"), ("delete", "page.delete")],
    };
    acts.iter().for_each(|(act, words)| button(out, act, words, &name));
    out.push_str("</div>");
    if let (Ok(project), false) = (&project, is_aside) {
        versions(out, project, shelf, state, is_present);
    }
    if is_present {
        steps(out, present, &shelf.steps);
    }
    out.push_str("</li>");
}

/// The versions of a project, the last kept first, each with what became of it since; and the field that keeps one of the present project.
fn versions(out: &mut String, project: &Project, shelf: &Shelf, of: &ShelfState, is_present: bool) {
    let mut kept: Vec<&ShelfState> = shelf.states.iter().filter(|state| state.of == of.id).collect();
    if kept.is_empty() && !is_present {
        return;
    }
    kept.sort_by(|a, b| b.at.total_cmp(&a.at));
    out.push_str("<details class=\"versions\"><summary>");
    escape(out, &say(&msg!("projects.versions", count = kept.len() as u32)));
    out.push_str("</summary>");
    if is_present {
        out.push_str("<div class=\"keep\"><input id=\"version-note\" type=\"text\" maxlength=\"120\" autocomplete=\"off\" aria-label=\"");
        escape(out, t("projects.note"));
        out.push_str("\" placeholder=\"");
        escape(out, t("projects.note"));
        out.push_str("\">");
        button(out, "keep", "projects.keep", "");
        out.push_str("</div>");
    }
    out.push_str("<ul>");
    for state in kept {
        out.push_str("<li data-id=\"");
        escape(out, &state.id);
        out.push_str("\"><div class=\"what\">");
        let when = day(state.at);
        let head = if state.note.is_empty() { when.as_str() } else { note(state) };
        tagged(out, "b", head);
        let version = read(state);
        let about = match &version {
            Ok(version) => changes_in_words(version, project),
            Err(reason) => reason.clone(),
        };
        if !state.note.is_empty() {
            tagged(out, "small", &when);
        }
        tagged(out, "small", &about);
        out.push_str("</div><div class=\"acts\">");
        if version.is_ok() {
            button(out, "open", "page.open", head);
            button(out, "compare", "projects.compare", head);
        }
        button(out, "save", "page.save-file", head);
        button(out, "delete", "page.delete", head);
        out.push_str("</div></li>");
    }
    out.push_str("</ul></details>");
}

/// The steps of undo of the present project, the last one first: each with what it has changed, and leading there.
fn steps(out: &mut String, present: &Project, [past, future]: &[Vec<String>; 2]) {
    let project = |text: &String| Project::from_json(text).project;
    let (past, future): (Vec<_>, Vec<_>) =
        (past.iter().filter_map(project).collect(), future.iter().rev().filter_map(project).collect());
    let now = past.len();
    if now == 0 && future.is_empty() {
        return;
    }
    let states: Vec<&Project> = past.iter().chain([present]).chain(&future).collect();
    out.push_str("<details class=\"versions steps\"><summary>");
    escape(out, &say(&msg!("projects.steps", count = states.len() as u32 - 1)));
    out.push_str("</summary><ul>");
    for (at, state) in states.iter().enumerate().rev() {
        let before = at.checked_sub(1).and_then(|before| states.get(before));
        let words = before.map_or_else(|| t("projects.began").to_owned(), |before| changes_in_words(before, state));
        if at == now {
            out.push_str("<li aria-current=\"step\">");
            tagged(out, "b", &words);
            tagged(out, "small", t("variants.now"));
        } else {
            let undone = if at > now { " class=\"undone\"" } else { "" };
            out.push_str(&format!(
                "<li{undone}><button type=\"button\" class=\"link\" data-act=\"go:{}\">",
                at as i64 - now as i64
            ));
            escape(out, &words);
            out.push_str("</button>");
            if at > now {
                tagged(out, "small", t("projects.undone"));
            }
        }
        out.push_str("</li>");
    }
    out.push_str("</ul></details>");
}

/// A button: what it does, and the name of what it does that to for those who do not see where it is.
fn button(out: &mut String, act: &str, words: &'static str, about: &str) {
    out.push_str(&format!("<button type=\"button\" data-act=\"{act}\""));
    if !about.is_empty() {
        out.push_str(" aria-label=\"");
        escape(out, &format!("{} {about}", t(words)));
        out.push('"');
    }
    out.push('>');
    escape(out, t(words));
    out.push_str("</button>");
}

/// The note of a state; the page's own are sentences of the catalog.
fn note(state: &ShelfState) -> &str {
    NOTES.iter().find(|(note, _)| *note == state.note).map_or(&state.note, |(_, words)| t(words))
}

fn name_of(project: &Project) -> String {
    if project.name.is_empty() { t("page.untitled").to_owned() } else { project.name.clone() }
}

/// The drawing of a project before its start, without labels, which nobody could read at this size.
fn miniature(project: &Project, dark: bool) -> String {
    let (mut scene, pose) = drawing::at(project, 0.0);
    scene.nodes.retain(|node| node.label == 0);
    picture(&scene, &pose, if dark { Theme::Dark } else { Theme::Light })
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::testing::project;

    fn state(id: &str, of: &str, at: f64, text: String) -> ShelfState {
        ShelfState { id: id.to_owned(), of: of.to_owned(), at, version: VERSION, note: String::new(), text }
    }

    fn named(name: &str) -> String {
        project().with_name(name).to_json()
    }

    fn listed(states: Vec<ShelfState>) -> String {
        let steps = [vec![named("Order 7")], vec![named("Order 9"), named("Order 8")]];
        list(&project(), &Shelf { present: "p1".to_owned(), states, aside: Vec::new(), steps, dark: false })
    }

    #[wasm_bindgen_test]
    fn present_project_is_first_and_the_last_kept_follows() {
        let html = listed(vec![
            state("p2", "", 1.0, named("Order 2")),
            state("p1", "", 9.0, named("Before")),
            state("p3", "", 2.0, named("Order 3")),
        ]);
        let at = |id: &str| html.find(&format!("<li data-id=\"{id}\"")).unwrap();
        assert!(at("p1") < at("p3") && at("p3") < at("p2"));
        assert!(!html.contains("value=\"Before\""), "the shelf has an older state of the present project");
    }

    #[wasm_bindgen_test]
    fn names_and_ids_are_escaped() {
        let html = listed(vec![state("\"><script>", "", 1.0, named("<img src=x>"))]);
        assert!(!html.contains("<script") && !html.contains("<img src=x"), "{html:.3000}");
    }

    #[wasm_bindgen_test]
    fn state_that_does_not_read_can_be_saved_and_deleted_only() {
        let newer = ShelfState { version: 2.0, ..state("p2", "", 1.0, named("Order 2")) };
        for (broken, reason) in [(state("p2", "", 1.0, "{".to_owned()), ""), (newer, t("projects.newer"))] {
            let html = listed(vec![broken]);
            let (_, row) = html.split_once("<li data-id=\"p2\"").unwrap();
            assert!(row.contains("\"save\"") && row.contains("\"delete\"") && row.contains(reason));
            assert!(!row.contains("\"open\"") && !row.contains("<img"), "{row}");
        }
    }

    #[wasm_bindgen_test]
    fn steps_lead_back_and_forth_with_what_they_changed() {
        let html = listed(Vec::new());
        let at = |act: &str, words: &str| {
            html.find(&format!("data-act=\"{act}\">{words}<")).unwrap_or_else(|| panic!("{act} {words}: {html:.4000}"))
        };
        let last = at("go:2", "Name Order 9");
        assert!(last < at("go:1", "Name Order 8") && last < at("go:-1", t("projects.began")));
        assert!(html.contains(&format!("aria-current=\"step\"><b>{}<", t("changes.no-name"))));
    }

    #[wasm_bindgen_test]
    fn version_says_what_has_become_of_it() {
        let mut before = project();
        before.name = "Order 7".to_owned();
        let html = listed(vec![state("v1", "p1", 1.0, before.to_json())]);
        assert!(html.contains(t("changes.no-name")), "{html:.1000}");
    }
}
