//! A result as one line: sign, name, value, limit with a bar to it, and the repair as a button.

use leptos::prelude::*;

use crate::text::number::filled;
use crate::ui::state::Page;
use crate::ui::words::{figure, four_digits, limit_sign, limit_text, say, sign, t, verdict_tone, verdict_words};
use crate::view::Readout;

/// The bar of a result: filled part and place of the limit, both in percent of the line.
fn bar(readout: &Readout) -> Option<(f64, f64)> {
    let (value, limit) = (readout.value.abs(), readout.limit?.value().abs());
    let most = 1.15 * value.max(limit);
    (most.is_finite() && most > 0.0).then(|| (100.0 * value / most, 100.0 * limit / most))
}

/// The line; a click leads to the result among all results, the button carries out the best advice.
#[component]
pub(crate) fn VerdictLine(
    /// The result.
    readout: Readout,
    /// Opens the result.
    open: impl Fn() + 'static,
) -> impl IntoView {
    let page = Page::here();
    let tone = verdict_tone(readout.verdict);
    let advice = readout.advice.first().map(|advice| say(&advice.message));
    let title = advice.unwrap_or_else(|| format!("{} {}", figure(readout.value, readout.decimals), readout.unit));
    let repair = readout.advice.iter().find_map(|advice| Some((say(advice.button.as_ref()?), advice.sets.clone())));
    let repair = repair.map(|(words, sets)| {
        view! {
            <button type="button" class="repair" title=title.clone() on:click=move |_| page.take_entries(&sets)>{words}</button>
        }
    });
    let bar = bar(&readout);
    let (part, limit) = bar.unwrap_or_default();
    let percent = |share: f64| filled("#%", &[share]);
    view! {
        <div class=format!("card {tone}") class:plain=bar.is_none() style:--part=percent(part) style:--limit=percent(limit)>
            <button type="button" class="to-result" title=title on:click=move |_| open()>
                <i class="s" aria-hidden="true">{sign(tone)}</i>
                <span class="k">{t(readout.label)}</span>
                <span class="v">{four_digits(readout.value, readout.decimals)}" "<small>{readout.unit}</small></span>
                <span class="hidden">{verdict_words(readout.verdict)} " " {limit_text(&readout)}</span>
                <span class="n" aria-hidden="true">{limit_sign(&readout)}</span>
            </button>
            {repair}
        </div>
    }
}
