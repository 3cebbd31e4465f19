//! The few results that stand above the drawing, with sign, colour, limit and the best advice.

use super::el::{El, button, el};
use super::model::Model;
use super::words::{figure, say, short, sign, t};
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
    readout.limit.map(|limit| format!("{} {}", t("page.limit"), short(limit.value(), readout.decimals)))
}

/// The cards.
pub(super) fn cards(model: Model) -> El {
    let content = move || {
        let design = model.design.get();
        design.readouts.iter().filter(|readout| readout.headline).map(|readout| card(model, readout)).collect()
    };
    let stale = el("p.stale").text(t("page.stale-short"));
    el("section.cards")
        .label(t("page.headline"))
        .mark("old", move || model.is_stale())
        .add(&[el("div.row").swap(content), stale])
}

/// One of them.
pub(super) fn card(model: Model, readout: &Readout) -> El {
    let tone = verdict(readout.verdict);
    let advice = readout.advice.first().map(|advice| say(&advice.message));
    let holds = verdict_words(readout.verdict);
    let detail = advice.clone().or_else(|| limit(readout));
    // Beside a sentence or a limit the sign is enough for those who see it.
    let words = el(if detail.is_some() { "span.hidden" } else { "span" }).text(holds);
    let id = readout.id;
    let value = el("span.v").text(&figure(readout.value, readout.decimals)).add(&[el("small").text(readout.unit)]);
    let note = el("span.n").add(&[el("i").at("aria-hidden", "true").text(sign(tone)), words]);
    let card = button("button.card", "", move || model.show_result(id));
    card.at("class", &format!("card {tone}")).at("title", &advice.unwrap_or_default()).add(&[
        el("span.k").text(t(readout.label)),
        value,
        note.text(&detail.unwrap_or_default()),
    ])
}
