//! Every result with limit, formula, source and advice.

use leptos::prelude::*;

use super::cards::{limit, verdict, verdict_words};
use super::model::Model;
use super::words::{figure, say, sign, t, tell, tone};
use crate::text::Diagnostic;
use crate::view::Readout;

/// The results tab.
pub(super) fn results(model: Model) -> AnyView {
    let rows = move || model.design.with(|design| design.readouts.iter().map(result).collect_view());
    let remarks = move || model.design.with(|design| design.diagnostics.iter().map(remark).collect_view());
    view! {
        <ul class="remarks">{remarks}</ul>
        <div class="results" class:old=move || !model.wrong_fields().is_empty()>{rows}</div>
    }
    .into_any()
}

fn remark(diagnostic: &Diagnostic) -> AnyView {
    let tone = tone(diagnostic.severity);
    view! { <li class=tone><i aria-hidden="true">{sign(tone)}</i> {tell(diagnostic)}</li> }.into_any()
}

fn result(readout: &Readout) -> AnyView {
    let tone = verdict(readout.verdict);
    let advice: Vec<_> = readout.advice.iter().map(|advice| view! { <li>{say(advice)}</li> }).collect();
    view! {
        <article class=format!("result {tone}") id=format!("result-{}", readout.id) tabindex="-1">
            <h3><i aria-hidden="true">{sign(tone)}</i> {t(readout.label)} <span class="hidden">{verdict_words(readout.verdict)}</span></h3>
            <p class="v">{figure(readout.value, readout.decimals)} <small>{readout.unit}</small></p>
            {limit(readout).map(|limit| view! { <p class="limit">{limit}</p> })}
            {(!readout.formula.is_empty()).then(|| view! { <p class="formula"><code>{readout.formula}</code></p> })}
            {(!advice.is_empty()).then(|| view! { <ul>{advice}</ul> })}
            <p class="source">{readout.cite.source}</p>
        </article>
    }
    .into_any()
}
