//! Every result with limit, formula, source and advice.

use super::cards::{limit, verdict, verdict_words};
use super::el::{El, button, el};
use super::files::go_to;
use super::model::Model;
use super::words::{figure, say, sign, t, tell, tone};
use crate::text::{Diagnostic, DiagnosticKind, Message, MessageValue};
use crate::view::Readout;

/// The results tab.
pub(super) fn results(model: Model) -> Vec<El> {
    let remarks =
        move || model.design.with(|design| design.diagnostics.iter().map(|told| remark(model, told)).collect());
    let rows =
        move || model.design.with(|design| design.readouts.iter().map(|readout| result(model, readout)).collect());
    vec![el("ul.remarks").swap(remarks), el("div.results").mark("old", move || model.is_stale()).swap(rows)]
}

fn remark(model: Model, told: &Diagnostic) -> El {
    let tone = tone(told.severity);
    let row = el("li").at("class", tone);
    match &told.message.values[..] {
        [MessageValue::Number(..), MessageValue::Text(ids)] if told.kind == DiagnosticKind::AssumedFacts => {
            row.add(&[assumed(model, mark_of(tone), told, ids)])
        }
        _ => row.add(&[mark_of(tone)]).text(" ").text(&tell(told)),
    }
}

/// Facts that are only assumed, folded up: there are many, and each leads to its field.
fn assumed(model: Model, mark: El, told: &Diagnostic, ids: &str) -> El {
    let message = Message { id: "page.assumed-facts", values: told.message.values.clone() };
    let fields = model.project.with_untracked(|project| project.machine.fields());
    let named = fields.into_iter().filter(|field| ids.split([',', ' ']).any(|id| id == field.id));
    let links: Vec<El> = named.map(|field| button("button.link", t(field.label), move || go_to(field.id))).collect();
    let summary = el("summary").add(&[mark, el("span").text(&say(&message))]);
    el("details").add(&[summary, el("div.chips").add(&links)])
}

fn mark_of(tone: &str) -> El {
    el("i").at("aria-hidden", "true").text(sign(tone))
}

fn result(model: Model, readout: &Readout) -> El {
    let tone = verdict(readout.verdict);
    let title = el("h3").add(&[mark_of(tone)]).text(" ").text(t(readout.label));
    let title = title.add(&[el("span.hidden").text(verdict_words(readout.verdict))]);
    let value =
        el("p.v").text(&figure(readout.value, readout.decimals)).text(" ").add(&[el("small").text(readout.unit)]);
    let mut parts = vec![title, value];
    parts.extend(limit(readout).map(|limit| el("p.limit").text(&limit)));
    if !readout.formula.is_empty() {
        parts.push(el("p.formula").add(&[el("code").text(&model.spelled(readout.formula))]));
    }
    if !readout.advice.is_empty() {
        let rows: Vec<El> = readout.advice.iter().map(|advice| el("li").text(&say(&advice.message))).collect();
        parts.push(el("ul").add(&rows));
    }
    parts.push(el("p.source").text(readout.cite.source));
    let id = format!("result-{}", readout.id);
    el("article").at("class", &format!("result {tone}")).at("id", &id).at("tabindex", "-1").add(&parts)
}
