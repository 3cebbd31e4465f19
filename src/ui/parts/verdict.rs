//! A result as one line: sign, name, value, limit with a bar to it, and the repair as a button.

use leptos::prelude::*;

use crate::text::number::filled;
use crate::ui::state::Page;
use crate::ui::words::{Tone, figure, limit_sign, limit_text, sentence, t, verdict_words};
use crate::view::{Advice, Readout};

/// Tooltip of a result: its advice, or its figure in full.
fn title(readout: &Readout) -> String {
    let advice = readout.advice.first().map(|advice| sentence(&advice.message));
    advice.unwrap_or_else(|| format!("{} {}", figure(readout.value, readout.decimals_apart()), readout.unit))
}

/// The line: a click leads to the result among all results, the button carries out the best advice. Unchanged parts are not written again,
/// because a dragged field changes the line with every step.
#[component]
fn VerdictLine(
    /// The result; always the same one.
    readout: Memo<Readout>,
) -> impl IntoView {
    let page = Page::here();
    let (id, label) = readout.with_untracked(|readout| (readout.id, readout.label));
    let shown = Memo::new(move |_| readout.get().shown());
    let of = move |what: fn(&Readout) -> String| move || shown.with(what);
    let class = |readout: &Readout| {
        let bar = if readout.bar().is_none() { " plain" } else { "" };
        format!("card {}{bar}", Tone::from(readout.verdict))
    };
    let part = |readout: &Readout| filled("#%", &[readout.bar().unwrap_or_default().0]);
    let limit = |readout: &Readout| filled("#%", &[readout.bar().unwrap_or_default().1]);
    let judged =
        |readout: &Readout| format!("{} {}", verdict_words(readout.verdict), limit_text(readout).unwrap_or_default());
    let repair = move || {
        let advised = |readout: &Readout| {
            let repair = |advice: &Advice| Some((sentence(advice.button.as_ref()?), advice.entries.clone()));
            Some((readout.advice.iter().find_map(repair)?, title(readout)))
        };
        shown.with(advised).map(|((words, sets), title)| {
            view! {
                <button type="button" class="repair" title=title on:click=move |_| page.take_entries(&sets)>{words}</button>
            }
        })
    };
    view! {
        <div
            class=of(class) style:--part=of(part) style:--limit=of(limit)
            on:pointerenter=move |_| page.show_causes(Some(id)) on:pointerleave=move |_| page.show_causes(None)
            on:focusin=move |_| page.show_causes(Some(id)) on:focusout=move |_| page.show_causes(None)>
            <button type="button" class="to-result" title=of(title) on:click=move |_| page.show_result(id)>
                <i class="s" aria-hidden="true">{of(|readout| Tone::from(readout.verdict).sign().to_owned())}</i>
                <span class="k">{t(label)}</span>
                <span class="v">
                    <b>{of(Readout::value_text)}</b> " " <small>{of(|readout| readout.unit.to_owned())}</small>
                </span>
                <span class="hidden">{of(judged)}</span>
                <span class="n" aria-hidden="true">{of(|readout| limit_sign(readout).unwrap_or_default())}</span>
            </button>
            {repair}
        </div>
    }
}

/// One line for each result, in their order; lines of results that stay are changed in place.
#[component]
pub(crate) fn VerdictLines(
    /// The results.
    #[prop(into)]
    readouts: Signal<Vec<Readout>>,
) -> impl IntoView {
    let own = move |id: &str| readouts.with(|readouts| readouts.iter().find(|readout| readout.id == id).cloned());
    let line = move |first: Readout| {
        let id = first.id;
        // A result that no longer exists keeps its last value until its line is removed.
        let readout =
            Memo::new(move |last: Option<&Readout>| own(id).or_else(|| last.cloned()).unwrap_or_else(|| first.clone()));
        view! { <VerdictLine readout=readout /> }
    };
    view! { <For each=move || readouts.get() key=|readout| readout.id children=line /> }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::state::view::Tab;
    use crate::ui::testing::{InInches, ViewBench, mount, project, settled};
    use crate::view::{Limit, Verdict};

    fn readout(id: &str) -> Readout {
        project().design().readouts.into_iter().find(|readout| readout.id == id).unwrap()
    }

    async fn line(readout: Readout) -> ViewBench {
        mount(move || view! { <VerdictLines readouts=RwSignal::new(vec![readout.clone()]) /> }).await
    }

    #[wasm_bindgen_test]
    async fn verdict_has_sign_tone_and_words() {
        for (verdict, tone, sign) in
            [(Verdict::Ok, "ok", "✓"), (Verdict::Warn, "warn", "▲"), (Verdict::Fail, "fail", "✕")]
        {
            let bench = line(Readout { verdict, ..readout("line-speed") }).await;
            assert!(bench.has(&format!(".card.{tone}")), "{tone}");
            assert_eq!(bench.text(".s"), sign);
            assert!(bench.text(".hidden").contains(verdict_words(verdict)));
        }
    }

    #[wasm_bindgen_test]
    async fn value_is_shown_with_four_digits_and_unit() {
        let bench = line(Readout { value: 15079.645, ..readout("line-speed") }).await;
        assert_eq!(bench.text(".v").replace('\u{202f}', ""), "15080 mm/min");
    }

    #[wasm_bindgen_test]
    async fn value_and_limit_are_shown_in_inches() {
        let _inches = InInches::new();
        let limited = Readout { value: 2540.0, limit: Some(Limit::AtMost(5080.0)), ..readout("line-speed") };
        let bench = line(limited).await;
        assert_eq!((bench.text(".v"), bench.text(".n")), ("100.0 in/min".to_owned(), "≤ 200".to_owned()));
    }

    #[wasm_bindgen_test]
    async fn bar_shows_value_and_limit_as_parts() {
        let limited = readout("line-speed");
        let limit = limited.limit.unwrap().value();
        let bench = line(Readout { value: limit / 2.0, ..limited }).await;
        let part = |name| bench.style(".card", name).trim_end_matches('%').parse::<f64>().unwrap();
        assert!((part("--limit") - 100.0 / 1.15).abs() < 0.01, "{}", part("--limit"));
        assert!((part("--part") - 50.0 / 1.15).abs() < 0.01, "{}", part("--part"));
        assert!(!bench.has(".plain"));
    }

    #[wasm_bindgen_test]
    async fn result_without_a_limit_has_no_bar() {
        let bench = line(Readout { limit: None, ..readout("line-speed") }).await;
        assert!(bench.has(".card.plain"));
    }

    #[wasm_bindgen_test]
    async fn repair_button_changes_the_form_in_one_step() {
        let advised = Readout {
            advice: vec![
                crate::view::Advice::from(crate::msg!("page.not-a-value"))
                    .setting(crate::msg!("page.taken"), [("pitch", "9".to_owned()), ("heads", "7".to_owned())]),
            ],
            ..readout("line-speed")
        };
        let bench = line(advised).await;
        assert_eq!(bench.attribute(".repair", "title"), t("page.not-a-value"));
        bench.press(".repair").await;
        assert_eq!(bench.setting("heads"), Some(crate::machines::form::Value::Number(7.0)));
        bench.page.undo();
        assert_eq!(bench.setting("pitch"), Some(crate::machines::form::Value::Number(8.0)));
        assert!(!bench.page.undoable.get_untracked().undo);
    }

    #[wasm_bindgen_test]
    async fn line_of_a_result_changes_in_place() {
        let readouts = RwSignal::new(vec![readout("line-speed"), readout("vector-feed")]);
        let bench = mount(move || view! { <VerdictLines readouts=readouts /> }).await;
        let lines = bench.all(".to-result");
        readouts.update(|all| (all[0].value, all[0].verdict) = (15079.645, Verdict::Fail));
        settled().await;
        assert_eq!(
            (bench.text(".v").replace('\u{202f}', ""), bench.text(".s")),
            ("15080 mm/min".to_owned(), "✕".to_owned())
        );
        assert!(lines.iter().all(|line| line.is_connected()));
        readouts.update(|all| all.truncate(1));
        settled().await;
        assert_eq!(lines.iter().map(|line| line.is_connected()).collect::<Vec<_>>(), [true, false]);
    }

    #[wasm_bindgen_test]
    async fn line_opens_its_result() {
        let bench = line(readout("line-speed")).await;
        bench.press(".to-result").await;
        assert_eq!(bench.page.view.tab.get_untracked(), Tab::Results);
    }
}
