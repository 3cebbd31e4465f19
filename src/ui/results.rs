//! Every result with limit, formula, source and advice.

use super::cards::{limit, verdict, verdict_words};
use super::el::{El, el};
use super::model::Model;
use super::words::{figure, say, sign, t, tell, tone, written};
use crate::text::Diagnostic;
use crate::view::Readout;

/// The results tab.
pub(super) fn results(model: Model) -> Vec<El> {
    let remarks = move || model.design.with(|design| design.diagnostics.iter().map(remark).collect());
    let rows =
        move || model.design.with(|design| design.readouts.iter().map(|readout| result(model, readout)).collect());
    vec![el("ul.remarks").swap(remarks), el("div.results").mark("old", move || model.is_stale()).swap(rows)]
}

fn remark(diagnostic: &Diagnostic) -> El {
    let tone = tone(diagnostic.severity);
    el("li").at("class", tone).add(&[mark_of(tone)]).text(" ").text(&tell(diagnostic))
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
        parts.push(el("p.formula").add(&[el("code").text(&written(model, readout.formula))]));
    }
    if !readout.advice.is_empty() {
        let rows: Vec<El> = readout.advice.iter().map(|advice| el("li").text(&say(advice))).collect();
        parts.push(el("ul").add(&rows));
    }
    parts.push(el("p.source").text(readout.cite.source));
    let id = format!("result-{}", readout.id);
    el("article").at("class", &format!("result {tone}")).at("id", &id).at("tabindex", "-1").add(&parts)
}
