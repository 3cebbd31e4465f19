//! The explorer: a value that is dragged shows at once what comes of it, the form takes it when it is let go; a click on a listed way takes that.

use std::sync::Arc;

use leptos::wasm_bindgen::JsCast;
use web_sys::Element;

use super::cards::card;
use super::charts::figure_of;
use super::el::{El, el, number};
use super::local::Local;
use super::model::Model;
use super::words::t;
use super::{scene_view, sheets};
use crate::machines::PreparedMachine;
use crate::machines::form::{FieldInfo, KindInfo, Values};
use crate::project::Project;
use crate::text::catalog::number_text;
use crate::text::number::filled;
use crate::view::{Explorer, Knob, Readout};

/// Whether there is something to drag on the machine.
pub(super) fn explores(model: Model) -> bool {
    model.machine.track();
    model.project.with_untracked(|project| project.machine.explores())
}

/// The machine with dragged values, or with those of the form.
fn prepared(project: &Project, draft: Option<&Values>) -> Arc<PreparedMachine> {
    match draft {
        Some(values) => Arc::new(project.machine.prepare(values, project.on())),
        None => project.prepared(),
    }
}

/// Sets fields to what is typed there.
fn set<'t>(project: &Project, values: &mut Values, sets: impl IntoIterator<Item = (&'t str, &'t str)>) {
    let fields = project.machine.fields();
    for (id, text) in sets {
        if let Some(value) = fields.iter().find(|field| field.id == id).and_then(|field| field.read(text).ok()) {
            values.insert(id.to_owned(), value);
        }
    }
}

/// Takes values into the form: a step of the history, one with those of the same key that follow at once.
fn take(model: Model, key: &str, values: Values) {
    // What is typed there and wrong gives way.
    let changed: Vec<FieldInfo> = model.project.with_untracked(|project| {
        let changed = |field: &FieldInfo| values.get(field.id) != project.values.get(field.id);
        project.machine.fields().into_iter().filter(changed).collect()
    });
    changed.iter().for_each(|field| model.forgive(field.id));
    model.edit(key, |project| project.values = values);
    model.say(t("page.taken"));
}

/// Sliders, what comes of them, and the ways that are listed.
pub(super) fn explore(model: Model) -> Vec<El> {
    if !explores(model) {
        return Vec::new();
    }
    // What is dragged and not yet in the form.
    let draft: Local<Option<Values>> = Local::new(None);
    let seen = Local::new(Explorer::default());
    let readouts: Local<Vec<Readout>> = Local::new(Vec::new());
    let shape = el("div.shape");
    let plots = el("div.plots");
    let (scene, charts) = (shape.dom().clone(), plots.dom().clone());
    let draw = move || {
        let (machine, design) = model.project.with(|project| {
            let machine = draft.with(|draft| prepared(project, draft.as_ref()));
            let design = machine.design(&project.provenance);
            (machine, design)
        });
        let found = machine.explorer().unwrap_or_default();
        readouts.set(design.readouts);
        scene.set_inner_html(&scene_view::svg(&found.scene));
        let mut out = String::new();
        found.charts.iter().for_each(|chart| figure_of(&mut out, chart));
        charts.set_inner_html(&out);
        seen.set(found);
    };
    let results = move || {
        readouts.with(|readouts| {
            readouts.iter().filter(|readout| readout.headline).map(|readout| card(model, readout)).collect()
        })
    };
    let (fields, first) = model
        .project
        .with_untracked(|project| (project.machine.fields(), project.prepared().explorer().unwrap_or_default().knobs));
    let info = |knob: &Knob| fields.iter().find(|field| field.id == knob.field);
    let knobs: Vec<El> = first
        .iter()
        .enumerate()
        .filter_map(|(at, knob)| Some(slider(model, draft, seen, at, knob.clone(), info(knob)?)))
        .collect();
    let ways = sheets::sheets(model, |sheets| &sheets.ways).on("click", move |event| {
        let target = event.target().and_then(|target| target.dyn_into::<Element>().ok());
        let row = target.and_then(|target| target.closest("[data-sets]").ok().flatten());
        let Some(sets) = row.and_then(|row| row.get_attribute("data-sets")) else { return };
        let mut values = model.project.with_untracked(|project| project.values.clone());
        let sets = sets.split(';').filter_map(|set| set.split_once('='));
        model.project.with_untracked(|project| set(project, &mut values, sets));
        draft.set(None);
        take(model, "", values);
    });
    vec![
        el("p.lead").text(t("page.explore-lead")),
        shape.run(draw),
        el("div.knobs").add(&knobs),
        el("div.row").swap(results),
        ways,
        plots,
    ]
}

fn slider(
    model: Model,
    draft: Local<Option<Values>>,
    seen: Local<Explorer>,
    at: usize,
    first: Knob,
    info: &FieldInfo,
) -> El {
    let field = first.field;
    let knob = move || seen.with(|seen| seen.knobs.get(at).cloned()).unwrap_or_else(|| first.clone());
    let [low, high, step, value, part, shown] = core::array::from_fn(|_| knob.clone());
    let plain = |number: f64| number_text(number, 6);
    let id = format!("explore-{field}");
    let input = el("input").at("type", "range").at("id", &id);
    let style = input.html().clone();
    let part = move || {
        let Knob { range: (low, high), value, .. } = part();
        let _ = style.style().set_property("--part", &filled("#%", &[(value - low) / (high - low) * 100.0]));
    };
    let dragged = move |event| {
        let Some(number) = number(&event) else { return };
        let along = seen.with_untracked(|seen| seen.knobs.get(at).map(|knob| knob.along.clone())).unwrap_or_default();
        let mut values = draft.get_untracked().unwrap_or_else(|| model.project.with_untracked(|p| p.values.clone()));
        let text = plain(number);
        let along = along.iter().map(|(id, text)| (*id, text.as_str())).chain([(field, text.as_str())]);
        model.project.with_untracked(|project| set(project, &mut values, along));
        draft.set(Some(values));
    };
    let dropped = move |_| {
        if let Some(values) = draft.get_untracked() {
            draft.set(None);
            take(model, field, values);
        }
    };
    let unit = if let KindInfo::Number { unit, .. } = &info.kind { *unit } else { "" };
    let input = input
        .bind("min", move || plain(low().range.0))
        .bind("max", move || plain(high().range.1))
        .bind("step", move || plain(step().step))
        .valued(move || plain(value().value))
        .run(part)
        .on("input", dragged)
        .on("change", dropped);
    el("div.knob").add(&[
        el("label").at("for", &id).text(t(info.label)),
        input,
        el("output").at("for", &id).live(move || format!("{} {unit}", plain(shown().value))),
    ])
}
