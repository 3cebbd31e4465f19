//! Pages of help as HTML, and search in them. Help is made at the first request, and kept for the same machine and control.

use std::cell::RefCell;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;

use super::messages::{FoundHelp, HelpPageHtml, Hit, ReadHelp};
use super::sheet_html::tagged;
use crate::machines;
use crate::project::Project;
use crate::project::help::content::{HelpEntry, HelpPage, HelpPlace, HelpSection};
use crate::project::help::texts::{Text, Texts};
use crate::project::help::{Help, explain, pages};
use crate::text::Grade;
use crate::ui::words::t;
use crate::view::Theme;
use crate::view::svg::escape;

/// The help that was asked for last, with the ids of its machine and control.
struct Kept {
    machine: &'static str,
    control: &'static str,
    help: Help,
}

thread_local! {
    static KEPT: RefCell<Option<Kept>> = const { RefCell::new(None) };
}

/// Characters of a hit's text that are shown.
const SHOWN: usize = 120;

fn with<T>(project: &Project, texts: &Texts, ask: impl FnOnce(&Help) -> T) -> T {
    KEPT.with_borrow_mut(|kept| {
        let (machine, control) = (project.machine.id(), project.control.id);
        let fits = |kept: &Kept| kept.machine == machine && kept.control == control;
        let kept = match kept.take().filter(fits) {
            Some(known) => kept.insert(known),
            None => kept.insert(Kept { machine, control, help: Help::new(project.machine, project.control, texts) }),
        };
        ask(&kept.help)
    })
}

/// The page with this id, or with a section or entry of this id; otherwise the page of the present machine. `theme` is that of its
/// drawing.
pub(super) fn page(project: &Project, texts: &Texts, ReadHelp { id, theme }: &ReadHelp) -> HelpPageHtml {
    with(project, texts, |help| {
        let own = help.pages.iter().find(|page| page.id == id);
        let place = if own.is_none() { help.find(id) } else { None };
        let page = own.or(place.map(|place| place.page)).or(help.pages.first());
        let mut html = String::new();
        page.iter().for_each(|page| write(&mut html, page, *theme));
        HelpPageHtml {
            page: page.map_or_else(String::new, |page| page.id.to_owned()),
            title: page.map_or_else(String::new, |page| page.title.clone()),
            anchor: place.map_or_else(String::new, |place| anchor(&place.id())),
            html,
            pages: help.pages.iter().map(|page| (page.id.to_owned(), page.title.clone())).collect(),
        }
    })
}

/// Search results of a query, the best first; where no place has all of its words, those that have some.
pub(super) fn found(project: &Project, texts: &Texts, query: &str) -> FoundHelp {
    with(project, texts, |help| {
        let hit = |place: &HelpPlace| Hit {
            id: place.id(),
            title: explain::title(place),
            page: place.page.title.clone(),
            text: place.excerpt(query, SHOWN),
        };
        let hits: Vec<Hit> = help.search(query).iter().map(hit).collect();
        if hits.is_empty() {
            FoundHelp { has_all_words: false, hits: help.nearest(query).iter().map(hit).collect() }
        } else {
            FoundHelp { has_all_words: true, hits }
        }
    })
}

/// The `id` of the element of a place, by its full id. An `id` has no space.
fn anchor(id: &str) -> String {
    format!("help-{}", id.split_once('/').map_or(id, |(_, id)| id).replace(' ', "_"))
}

fn write(out: &mut String, page: &HelpPage, theme: Theme) {
    open(out, "nav class=\"contents\"", "aria-label", t("help.contents"));
    for section in &page.sections {
        link(out, &format!("{}/{}", page.id, section.id), &section.title);
    }
    out.push_str("</nav>");
    for section in &page.sections {
        open(out, "section tabindex=\"-1\"", "id", &anchor(&section.id));
        tagged(out, "h3", &section.title);
        section.text.iter().for_each(|text| paragraph(out, "p", text));
        if !section.steps.is_empty() {
            out.push_str("<ol class=\"steps\">");
            section.steps.iter().for_each(|step| paragraph(out, "li", step));
            out.push_str("</ol>");
        }
        if !section.parts.is_empty() {
            parts(out, page, section, theme);
        }
        section.entries.iter().for_each(|e| entry(out, e));
        out.push_str("</section>");
    }
}

/// The drawing with its numbered parts. It is a separate picture, because its gradients have the same names as gradients on the page.
/// Printed pages are never dark.
fn parts(out: &mut String, page: &HelpPage, section: &HelpSection, theme: Theme) {
    let Some(machine) = machines::find(page.id) else { return };
    let mut picture = |theme: Theme, class: &str| {
        let data = STANDARD.encode(pages::drawing(machine, page.control, theme));
        open(out, &format!("img class=\"{class}\" src=\"data:image/svg+xml;base64,{data}\""), "alt", &page.title);
    };
    if theme == Theme::Dark {
        picture(theme, "on-screen");
        picture(Theme::Light, "on-paper");
    } else {
        picture(theme, "");
    }
    out.push_str("<ol class=\"parts\">");
    section.parts.iter().for_each(|part| tagged(out, "li", part));
    out.push_str("</ol>");
}

fn entry(out: &mut String, entry: &HelpEntry) {
    open(out, "article tabindex=\"-1\"", "id", &anchor(&entry.id));
    out.push_str("<h4>");
    if !entry.word.is_empty() {
        tagged(out, "code", &entry.word);
        out.push(' ');
    }
    escape(out, &entry.title);
    out.push_str("</h4>");
    entry.text.iter().for_each(|text| paragraph(out, "p", text));
    if !entry.facts.is_empty() {
        out.push_str("<dl>");
        for fact in &entry.facts {
            tagged(out, "dt", fact.name);
            paragraph(out, "dd", &fact.value);
        }
        out.push_str("</dl>");
    }
    if let Some(cite) = entry.cite {
        out.push_str(if cite.grade == Grade::Open { "<p class=\"source open\">" } else { "<p class=\"source\">" });
        escape(out, cite.source.words());
        out.push_str(" · ");
        escape(out, cite.grade.words());
        out.push_str("</p>");
    }
    out.push_str("</article>");
}

fn paragraph(out: &mut String, tag: &str, text: &Text) {
    out.push_str(&format!("<{tag}>"));
    for piece in text {
        if piece.to.is_empty() {
            escape(out, &piece.words);
        } else {
            link(out, &piece.to, &piece.words);
        }
    }
    out.push_str(&format!("</{tag}>"));
}

fn link(out: &mut String, to: &str, words: &str) {
    open(out, "button type=\"button\" class=\"link\"", "data-help", to);
    escape(out, words);
    out.push_str("</button>");
}

/// An opening tag with an attribute whose value is escaped.
fn open(out: &mut String, tag: &str, name: &str, value: &str) {
    out.push_str(&format!("<{tag} {name}=\""));
    escape(out, value);
    out.push_str("\">");
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::text::catalog;
    use crate::ui::testing::project;

    fn shown(id: &str, theme: Theme) -> HelpPageHtml {
        page(&project(), &Texts::shipped(catalog::spoken()), &ReadHelp { id: id.to_owned(), theme })
    }

    #[wasm_bindgen_test]
    fn alarm_is_on_the_page_of_its_control_with_cause_and_source() {
        let shown = shown("alarm.P62", Theme::Light);
        assert_eq!((shown.page.as_str(), shown.anchor.as_str()), ("mitsubishi-e60", "help-alarm.P62"));
        assert!(shown.html.contains("<article tabindex=\"-1\" id=\"help-alarm.P62\"><h4><code>P62</code>"));
        assert!(shown.html.contains("p.52"));
    }

    #[wasm_bindgen_test]
    fn unknown_id_opens_the_page_of_the_machine_and_is_never_shown() {
        let shown = shown("<script>", Theme::Light);
        assert_eq!((shown.page.as_str(), shown.anchor.as_str()), ("ribbon-line", ""));
        assert!(!shown.html.contains("<script") && shown.html.contains("data:image/svg+xml;base64,"));
    }

    #[wasm_bindgen_test]
    fn dark_page_has_a_light_drawing_for_paper() {
        let [light, dark] = [Theme::Light, Theme::Dark].map(|theme| shown("ribbon-line", theme).html);
        let drawing = |html: &str, class: &str| {
            let (_, from) = html.split_once(&format!("<img class=\"{class}\" "))?;
            from.split_once('>').map(|(drawing, _)| drawing.to_owned())
        };
        assert_eq!(drawing(&dark, "on-paper"), drawing(&light, ""));
        assert!(drawing(&dark, "on-screen").is_some_and(|screen| Some(screen) != drawing(&light, "")));
    }

    #[wasm_bindgen_test]
    fn found_places_open_again() {
        let texts = Texts::shipped(catalog::spoken());
        let FoundHelp { hits, has_all_words } = found(&project(), &texts, "slack");
        assert!(hits.len() > 5 && has_all_words);
        for hit in hits.iter().filter(|hit| hit.id.contains('.')) {
            let shown = shown(&hit.id, Theme::Light);
            assert!(shown.html.contains(&format!("id=\"{}\"", shown.anchor)), "{}", hit.id);
        }
    }
}
