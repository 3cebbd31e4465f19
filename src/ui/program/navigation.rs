//! Requests of the editor: completion proposals, lists of places and findings, definitions. The worker reads the program for them.

use std::rc::Rc;

use js_sys::{Function, Promise};
use leptos::prelude::*;
use leptos::wasm_bindgen::JsValue;
use leptos::wasm_bindgen::closure::Closure;

use crate::msg;
use crate::text::{FileId, LineIndex, Place, utf16};
use crate::ui::dom::script::{object, set, table};
use crate::ui::state::Page;
use crate::ui::words::{Tone, sentence, t, tell_alarm};
use crate::ui::worker::client::Client;
use crate::ui::worker::messages::{
    Ask, Caret, Complete, FindDefinition, FindUses, NamedPlace, Places, Proposals, WriteOutline,
};

/// Findings in a list at most.
const FINDINGS: usize = 500;

/// Target of a row of a list.
#[derive(Clone, Copy)]
enum Choice {
    /// The place is shown.
    Show(Place),
    /// The fix of a finding is applied, both by their numbers.
    Fix(usize, usize),
}

/// A row of a list: name, text, whether it belongs to the row above.
type Row = (String, String, bool);

/// Requests of the editor. A handle: copies share its state.
#[derive(Clone, Copy)]
struct Navigation {
    page: Page,
    worker: Client,
    /// Targets of the last list's rows.
    choices: StoredValue<Vec<Choice>>,
}

impl Navigation {
    /// The place in the chosen file at a count of UTF-16 units.
    fn caret(self, units: &JsValue) -> Caret {
        Caret { file: self.page.view.file.get_untracked() as u16, units: units.as_f64().unwrap_or_default() as u32 }
    }

    /// Requests places of the program from the worker; `then` gets them unless the text has changed meanwhile.
    fn places(self, ask: impl Ask<Answer = Places>, then: impl FnOnce(Option<Places>) + 'static) {
        let program = self.page.program;
        self.page.take_typed();
        let before = program.written.get_untracked();
        let then = move |places| {
            let same = program.written.try_with_untracked(|written| Rc::ptr_eq(written, &before));
            let typed = program.typed.try_with_value(Option::is_some);
            match places {
                Some(places) if same == Some(true) && typed == Some(false) => then(Some(places)),
                Some(_) => then(None),
                None => {
                    self.page.notices.notify(Tone::Warn, t("page.no-answer").to_owned());
                    then(None);
                }
            }
        };
        self.page.project.with_untracked(|project| self.worker.ask(project, ask, then));
    }

    /// Returns a promise of the completion proposals at a place.
    fn complete(self, units: &JsValue) -> JsValue {
        let ask = Complete(self.caret(units));
        let project = self.page.typed_project();
        promise(move |done| {
            self.worker.ask(&project, ask, move |found| {
                let Some(Proposals { from, few, rows }) = found else {
                    return done(JsValue::NULL);
                };
                let rows = table(rows.into_iter().map(|(text, line)| vec![text.into(), line.into()]));
                done(object([("from", from.into()), ("few", few.into()), ("rows", rows)]));
            });
        })
    }

    /// Shows where the name at a place is defined.
    fn define(self, units: &JsValue) {
        self.places(FindDefinition(self.caret(units)), move |found| {
            match found.map(|found| found.rows.into_iter().next()) {
                Some(Some(row)) => self.page.show_place(row.place.into()),
                Some(None) => self.page.notices.confirm(t("page.no-definition").to_owned()),
                None => {}
            }
        });
    }

    /// Returns a promise of a list, by its name; null if it would be empty, undefined if it has to be requested again later.
    fn list(self, name: &JsValue, units: &JsValue) -> JsValue {
        match name.as_string().as_deref() {
            Some("uses") => self.list_places(FindUses(self.caret(units)), "page.uses", "page.no-definition"),
            Some("outline") => self.list_places(WriteOutline, "page.go-to-place", "page.nothing-found"),
            _ => Promise::resolve(&self.findings(units)).into(),
        }
    }

    /// Returns a promise of the list of places with this title; `empty` is said where there are none.
    fn list_places(
        self,
        ask: impl Ask<Answer = Places> + 'static,
        title: &'static str,
        empty: &'static str,
    ) -> JsValue {
        promise(move |done| {
            self.places(ask, move |found| {
                let Some(Places { count, rows }) = found else { return done(JsValue::NULL) };
                let row =
                    |NamedPlace { name, text, below, place }| ((name, text, below), Choice::Show(Place::from(place)));
                done(self.shown(title, empty, count as usize, rows.into_iter().map(row).collect(), 0));
            });
        })
    }

    /// The findings of all files with their fixes, the first one from a place on chosen; undefined while the text is being read.
    fn findings(self, units: &JsValue) -> JsValue {
        let typed = self.page.program.typed.with_value(Option::is_some);
        self.page.take_typed();
        if typed || self.page.program.pending.get_untracked() {
            return JsValue::UNDEFINED;
        }
        let Caret { file, units } = self.caret(units);
        let written = self.page.program.written.get_untracked();
        let text = written.files.get(FileId(file)).map_or("", |file| file.text.as_str());
        let here = (FileId(file), utf16::byte(text, units));
        let lines: Vec<LineIndex> = written.files.0.iter().map(|file| LineIndex::new(&file.text)).collect();
        let found = self.page.program.findings.get_untracked();
        let (mut rows, mut chosen) = (Vec::new(), None);
        for (number, finding) in found.iter().enumerate().take(FINDINGS) {
            let Some(place) = finding.place else { continue };
            let (Some(file), Some(lines)) = (written.files.get(place.file), lines.get(usize::from(place.file.0)))
            else {
                continue;
            };
            let end = (place.file, place.span.end);
            if end >= here && chosen.is_none_or(|(nearest, _)| end < nearest) {
                chosen = Some((end, rows.len()));
            }
            let line =
                sentence(&msg!("page.at-line", file = file.name.as_str(), line = lines.line_of(place.span.start)));
            let name = format!("{} {line}", Tone::from(finding.severity).sign());
            rows.push(((name, tell_alarm(finding), false), Choice::Show(place)));
            let fixes = finding.fixes.iter().enumerate();
            rows.extend(fixes.map(|(at, fix)| ((sentence(&fix.title), String::new(), true), Choice::Fix(number, at))));
        }
        self.shown("page.findings", "page.no-findings", rows.len(), rows, chosen.map_or(0, |(_, row)| row))
    }

    /// A list as the editor takes it, its choices kept; null and a notice where it is empty.
    fn shown(
        self,
        title: &'static str,
        empty: &'static str,
        count: usize,
        rows: Vec<(Row, Choice)>,
        at: usize,
    ) -> JsValue {
        if rows.is_empty() {
            self.page.notices.confirm(t(empty).to_owned());
            return JsValue::NULL;
        }
        let title = if count > rows.len() {
            sentence(&msg!("page.list-cut", title = t(title), shown = rows.len() as u32, all = count as u32))
        } else {
            t(title).to_owned()
        };
        let (rows, choices): (Vec<Row>, Vec<Choice>) = rows.into_iter().unzip();
        self.choices.set_value(choices);
        let rows = table(rows.into_iter().map(|(name, text, below)| vec![name.into(), text.into(), below.into()]));
        object([("title", title.into()), ("rows", rows), ("at", (at as u32).into())])
    }

    /// Takes a row of the last list.
    fn choose(self, row: &JsValue) {
        let row = row.as_f64().unwrap_or_default() as usize;
        match self.choices.with_value(|choices| choices.get(row).copied()) {
            Some(Choice::Show(place)) => self.page.show_place(place),
            Some(Choice::Fix(finding, fix)) => self.page.apply_fix(finding, fix),
            None => {}
        }
    }
}

/// Returns a promise; `ask` gets the function that resolves it.
fn promise(ask: impl FnOnce(Box<dyn FnOnce(JsValue)>) + 'static) -> JsValue {
    let mut ask = Some(ask);
    let executor = &mut |resolve: Function, _| {
        let done = move |value: JsValue| drop(resolve.call1(&JsValue::NULL, &value));
        if let Some(ask) = ask.take() {
            ask(Box::new(done));
        }
    };
    Promise::new(executor).into()
}

/// Adds the handlers of the editor's requests to its options.
pub(super) fn add(page: Page, options: &JsValue) {
    let all = Navigation { page, worker: Client::here(), choices: StoredValue::new(Vec::new()) };
    let function = |name: &str, answer: Box<dyn Fn(JsValue, JsValue) -> JsValue>| {
        set(options, name, &Closure::<dyn Fn(JsValue, JsValue) -> JsValue>::new(answer).into_js_value());
    };
    function("complete", Box::new(move |at, _| all.complete(&at)));
    function("list", Box::new(move |name, at| all.list(&name, &at)));
    let define = move |at: JsValue, _: JsValue| {
        all.define(&at);
        JsValue::UNDEFINED
    };
    function("define", Box::new(define));
    let choose = move |row: JsValue, _: JsValue| {
        all.choose(&row);
        JsValue::UNDEFINED
    };
    function("choose", Box::new(choose));
    let [find, close, none] = ["page.find", "page.close", "page.nothing-found"].map(|id| JsValue::from(t(id)));
    set(options, "words", &object([("find", find), ("close", close), ("none", none)]));
}

#[cfg(test)]
mod tests {
    use js_sys::Array;
    use leptos::wasm_bindgen::JsCast;
    use wasm_bindgen_futures::JsFuture;
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::text::{Diagnostic, Span};
    use crate::ui::dom::script::call;
    use crate::ui::testing::{ViewBench, mount, settled, work_here};

    /// A page, and the options of its editor.
    async fn editor() -> (ViewBench, JsValue) {
        let options = object([]);
        let given = options.clone();
        let bench = mount(move || add(Page::here(), &given)).await;
        work_here(bench.worker);
        (bench, options)
    }

    /// The rows that a promise brings; none where it brings null.
    async fn rows(promise: JsValue) -> Vec<Vec<JsValue>> {
        let found = JsFuture::from(promise.unchecked_into::<Promise>()).await.unwrap();
        let rows = js_sys::Reflect::get(&found, &"rows".into()).unwrap_or_default();
        let rows = rows.dyn_into::<Array>().unwrap_or_default();
        rows.iter().map(|row| row.unchecked_into::<Array>().to_vec()).collect()
    }

    /// UTF-16 units before the end of a text in the first file.
    fn behind(bench: &ViewBench, text: &str) -> JsValue {
        let all = bench.page.program.text(0);
        ((all.find(text).unwrap() + text.len()) as u32).into()
    }

    #[wasm_bindgen_test]
    async fn proposals_are_those_for_the_text_in_the_editor() {
        let (bench, options) = editor().await;
        bench.page.program.typed.set_value(Some((0, "O9100\nG0".to_owned())));
        let found = rows(call(&options, "complete", &[&8.into(), &JsValue::NULL]).unwrap()).await;
        assert_eq!(found[0][0], JsValue::from("G00"));
        assert!(found.iter().all(|row| row[1].as_string().is_some_and(|line| !line.is_empty())));
        assert!(!bench.page.program.edited.get_untracked(), "asking takes nothing into the project");
    }

    #[wasm_bindgen_test]
    async fn row_of_a_list_shows_its_place() {
        let (bench, options) = editor().await;
        let at = behind(&bench, "#104");
        let found = rows(call(&options, "list", &[&"uses".into(), &at]).unwrap()).await;
        assert!(found.len() > 2, "{}", found.len());
        call(&options, "choose", &[&1.into()]).unwrap();
        let place = bench.page.view.sought.get_untracked().unwrap();
        assert_eq!(place.span.of(&bench.page.program.text(place.file.0.into())), "#104");
    }

    #[wasm_bindgen_test]
    async fn row_of_a_fix_applies_it() {
        let (bench, options) = editor().await;
        let place = Place { file: FileId(0), span: Span { start: 0, end: 1 } };
        let found = Diagnostic::error(msg!("page.not-a-value")).at(place);
        bench.page.program.findings.set(vec![found.fix(msg!("page.taken"), vec![(place, "(fixed)".to_owned())])]);
        settled().await;
        let found = rows(call(&options, "list", &[&"findings".into(), &0.into()]).unwrap()).await;
        assert_eq!(found.iter().map(|row| row[2].as_bool()).collect::<Vec<_>>(), [Some(false), Some(true)]);
        call(&options, "choose", &[&1.into()]).unwrap();
        assert!(bench.page.program.text(0).starts_with("(fixed)"));
    }

    #[wasm_bindgen_test]
    async fn place_without_a_name_gives_a_notice() {
        let (bench, options) = editor().await;
        let nowhere = JsValue::from(0);
        assert_eq!(rows(call(&options, "list", &[&"uses".into(), &nowhere]).unwrap()).await.len(), 0);
        call(&options, "define", &[&nowhere]).unwrap();
        assert_eq!(bench.page.notices.list.with_untracked(Vec::len), 1);
        assert_eq!(bench.page.notices.announcement.get_untracked(), t("page.no-definition"));
        assert_eq!(bench.page.view.sought.get_untracked(), None);
    }
}
