//! The few results that stand above the drawing, with sign, colour, limit and the best advice.

use leptos::prelude::*;

use super::model::Model;
use super::words::{figure, say, sign, t};
use crate::view::{Readout, Verdict};

/// The class of a verdict.
pub(super) fn verdict(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::None => "none",
        Verdict::Ok => "ok",
        Verdict::Warn => "warn",
        Verdict::Fail => "fail",
    }
}

/// The words of a verdict, for those who do not see the sign.
pub(super) fn verdict_words(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::None => "",
        Verdict::Ok => t("page.verdict-ok"),
        Verdict::Warn => t("page.verdict-warn"),
        Verdict::Fail => t("page.verdict-fail"),
    }
}

/// Limit of a readout, as it stands below the value.
pub(super) fn limit(readout: &Readout) -> Option<String> {
    readout.limit.map(|limit| format!("{} {}", t("page.limit"), limit_text(limit, readout.decimals)))
}

/// A limit with no more decimals than it needs.
fn limit_text(limit: f64, decimals: u8) -> String {
    let text = figure(limit, decimals);
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}

/// The cards.
pub(super) fn cards(model: Model) -> AnyView {
    let cards = move || {
        let design = model.design.get();
        design.readouts.iter().filter(|readout| readout.headline).map(|readout| card(model, readout)).collect_view()
    };
    view! {
        <section class="cards" class:old=move || !model.wrong_fields().is_empty() aria-label=t("page.headline")>
            {cards}
            <p class="stale shown">{t("page.stale-short")}</p>
        </section>
    }
    .into_any()
}

fn card(model: Model, readout: &Readout) -> AnyView {
    let tone = verdict(readout.verdict);
    let advice = readout.advice.first().map(say);
    let detail = advice.clone().or_else(|| limit(readout)).unwrap_or_default();
    let open = {
        let id = readout.id;
        move |_| super::side::open_result(model, id)
    };
    view! {
        <button type="button" class=format!("card {tone}") title=advice on:click=open>
            <span class="k">{t(readout.label)}</span>
            <span class="v">{figure(readout.value, readout.decimals)} <small>{readout.unit}</small></span>
            <span class="n"><i aria-hidden="true">{sign(tone)}</i> <span class="hidden">{verdict_words(readout.verdict)}</span> {detail}</span>
        </button>
    }
    .into_any()
}
