//! Every result with limit, formula, source and advice.

use leptos::prelude::*;

use super::repair::RepairAll;
use crate::project::origins::assumed_facts;
use crate::text::{Diagnostic, DiagnosticKind, Message, headed};
use crate::ui::dom::go_to_field;
use crate::ui::state::Page;
use crate::ui::words::{Tone, figure, limit_text, sentence, sentence_with_hints, t, verdict_words};
use crate::view::Readout;

/// The results tab.
#[component]
pub(crate) fn ResultsTab() -> impl IntoView {
    let page = Page::here();
    let design = page.results.design;
    let remarks = move || {
        let design = design.get();
        design.diagnostics.iter().map(|finding| view! { <Remark finding=finding.clone() /> }).collect_view()
    };
    let rows = move || {
        let design = design.get();
        design.readouts.iter().map(|readout| view! { <Row readout=readout.clone() /> }).collect_view()
    };
    view! {
        <RepairAll />
        <ul class="remarks">{remarks}</ul>
        <div class="results" class:old=move || page.is_stale()>{rows}</div>
    }
}

/// A remark about the machine's values.
#[component]
fn Remark(
    /// The remark.
    finding: Diagnostic,
) -> impl IntoView {
    let tone = Tone::from(finding.severity);
    let mark = view! { <i aria-hidden="true">{tone.sign()}</i> };
    let body = match finding.kind {
        DiagnosticKind::AssumedFacts => {
            let message = Message { id: "page.assumed-facts", ..finding.message.clone() };
            view! {
                <details>
                    <summary>{mark}<span>{sentence(&message)}</span></summary>
                    <AssumedFields />
                </details>
            }
            .into_any()
        }
        _ => view! { <p class="hangs">{mark}<span>{sentence_with_hints(&finding)}</span></p> }.into_any(),
    };
    view! { <li class=tone.class()>{body}</li> }
}

/// Facts that are only assumed; each leads to its field.
#[component]
fn AssumedFields() -> impl IntoView {
    let (fields, ids) =
        Page::here().project.with_untracked(|project| (project.machine.fields(), assumed_facts(project)));
    let named = fields.into_iter().filter(|field| ids.contains(&field.id));
    let link = |field: crate::machines::form::FieldInfo| {
        view! { <button type="button" class="link" on:click=move |_| go_to_field(field.id)>{t(field.label)}</button> }
    };
    view! { <div class="chips">{named.map(link).collect_view()}</div> }
}

/// A result.
#[component]
fn Row(
    /// The result.
    readout: Readout,
) -> impl IntoView {
    let (page, id) = (Page::here(), readout.id);
    let readout = readout.shown();
    let tone = Tone::from(readout.verdict);
    let limit = limit_text(&readout).map(|limit| view! { <p class="limit">{limit}</p> });
    let more = headed(t(readout.label), t("help.more"));
    let formula = (!readout.formula.is_empty())
        .then(|| view! { <p class="formula"><code>{page.spelled(readout.formula.words())}</code></p> });
    let advice = (!readout.advice.is_empty()).then(|| {
        let rows = readout.advice.iter().map(|advice| view! { <li>{sentence(&advice.message)}</li> });
        view! { <ul>{rows.collect_view()}</ul> }
    });
    view! {
        <article
            class=format!("result {tone}") id=format!("result-{id}") tabindex="-1"
            on:pointerenter=move |_| page.show_causes(Some(id)) on:pointerleave=move |_| page.show_causes(None)
            on:focusin=move |_| page.show_causes(Some(id)) on:focusout=move |_| page.show_causes(None)
        >
            <h3>
                <i aria-hidden="true">{tone.sign()}</i> " " {t(readout.label)}
                <span class="hidden">" " {verdict_words(readout.verdict)}</span>
            </h3>
            <p class="v">{figure(readout.value, readout.decimals_apart())} " " <small>{readout.unit}</small></p>
            {limit}
            {formula}
            {advice}
            <p class="source">
                {readout.cite.source.words()} " "
                <button type="button" class="link" aria-label=more on:click=move |_| page.view.explain(format!("result.{id}"))>
                    {t("help.more")}
                </button>
            </p>
        </article>
    }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::testing::{ViewBench, mount, settled};
    use crate::view::Verdict;

    async fn results() -> ViewBench {
        mount(|| view! { <ResultsTab /> <input id="heads" /> }).await
    }

    #[wasm_bindgen_test]
    async fn every_result_has_value_tone_and_source() {
        let bench = results().await;
        let design = bench.page.results.design.get_untracked();
        assert_eq!(bench.all("article").len(), design.readouts.len());
        for readout in &design.readouts {
            let row = format!("#result-{}", readout.id);
            assert!(bench.has(&format!("{row}.{}", Tone::from(readout.verdict))), "{row}");
            assert!(bench.text(&format!("{row} .v")).starts_with(&figure(readout.value, readout.decimals)), "{row}");
            assert!(bench.text(&format!("{row} .source")).starts_with(readout.cite.source.words().trim()));
        }
        for readout in &design.readouts {
            bench.press(&format!("#result-{} .source .link", readout.id)).await;
            assert_eq!(bench.page.view.help_at.get_untracked(), format!("result.{}", readout.id));
        }
    }

    #[wasm_bindgen_test]
    async fn failed_result_has_words_and_advice() {
        let bench = results().await;
        let mut design = (*bench.page.results.design.get_untracked()).clone();
        design.readouts.truncate(1);
        let first = &mut design.readouts[0];
        first.verdict = Verdict::Fail;
        first.advice = vec![crate::msg!("page.not-a-value").into()];
        bench.page.results.design.set(std::rc::Rc::new(design));
        settled().await;
        assert!(bench.text("article.fail h3").contains(t("page.verdict-fail")));
        assert_eq!(bench.text("article li"), t("page.not-a-value"));
    }

    #[wasm_bindgen_test]
    async fn assumed_facts_lead_to_their_fields() {
        let bench = results().await;
        bench.press_button(t(crate::ui::testing::field("heads").label)).await;
        assert_eq!(document().active_element().unwrap().id(), "heads");
    }

    #[wasm_bindgen_test]
    async fn results_are_old_while_an_entry_is_wrong() {
        let bench = results().await;
        assert!(!bench.has(".results.old"));
        bench.page.entries.refuse("pitch", *crate::ui::testing::field("pitch").read_metric("x").unwrap_err());
        settled().await;
        assert!(bench.has(".results.old"));
    }
}
