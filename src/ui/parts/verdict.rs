//! A result as one line: sign, name, value, limit with a bar to it, and the repair as a button.

use leptos::prelude::*;

use crate::text::number::filled;
use crate::ui::state::Page;
use crate::ui::words::{figure, four_digits, limit_sign, limit_text, say, sign, t, verdict_tone, verdict_words};
use crate::view::Readout;

/// A result in words.
#[derive(Debug, Clone, PartialEq)]
struct Line {
    tone: &'static str,
    title: String,
    value: String,
    unit: &'static str,
    judged: String,
    limit: String,
    /// Percents of the bar: the value and its limit.
    bar: Option<(String, String)>,
    repair: Option<Repair>,
}

/// The words of the button that carries out an advice, and the fields that it sets.
type Repair = (String, Vec<(&'static str, String)>);

impl Line {
    fn of(readout: Readout) -> Line {
        let readout = readout.shown();
        let tone = verdict_tone(readout.verdict);
        let advice = readout.advice.first().map(|advice| say(&advice.message));
        let percent = |share: f64| filled("#%", &[share]);
        Line {
            tone,
            title: advice.unwrap_or_else(|| format!("{} {}", figure(readout.value, readout.decimals), readout.unit)),
            value: four_digits(readout.value, readout.decimals),
            unit: readout.unit,
            judged: format!("{} {}", verdict_words(readout.verdict), limit_text(&readout).unwrap_or_default()),
            limit: limit_sign(&readout).unwrap_or_default(),
            bar: readout.bar().map(|(part, limit)| (percent(part), percent(limit))),
            repair: readout.advice.iter().find_map(|advice| Some((say(advice.button.as_ref()?), advice.sets.clone()))),
        }
    }
}

/// The line; a click leads to the result among all results, the button carries out the best advice. What has not changed in it is not written
/// again: while a field is dragged it changes with every step.
#[component]
pub(crate) fn VerdictLine(
    /// The result; always the same one.
    #[prop(into)]
    readout: Signal<Readout>,
    /// Opens the result.
    #[prop(into)]
    open: Callback<()>,
) -> impl IntoView {
    let page = Page::here();
    let (id, label) = readout.with_untracked(|readout| (readout.id, readout.label));
    let line = Memo::new(move |_| Line::of(readout.get()));
    let title = move || line.with(|line| line.title.clone());
    let bar = move || line.with(|line| line.bar.clone().unwrap_or_default());
    let repair = Memo::new(move |_| line.with(|line| line.repair.clone()));
    let repair = move || {
        repair.get().map(|(words, sets)| {
            view! {
                <button type="button" class="repair" title=title on:click=move |_| page.take_entries(&sets)>{words}</button>
            }
        })
    };
    view! {
        <div
            class=move || line.with(|line| format!("card {}", line.tone))
            on:pointerenter=move |_| page.show_causes(Some(id)) on:pointerleave=move |_| page.show_causes(None)
            on:focusin=move |_| page.show_causes(Some(id)) on:focusout=move |_| page.show_causes(None)
            class:plain=move || line.with(|line| line.bar.is_none()) style:--part=move || bar().0 style:--limit=move || bar().1>
            <button type="button" class="to-result" title=title on:click=move |_| open.run(())>
                <i class="s" aria-hidden="true">{move || sign(line.with(|line| line.tone))}</i>
                <span class="k">{t(label)}</span>
                <span class="v">
                    {move || line.with(|line| line.value.clone())} " " <small>{move || line.with(|line| line.unit)}</small>
                </span>
                <span class="hidden">{move || line.with(|line| line.judged.clone())}</span>
                <span class="n" aria-hidden="true">{move || line.with(|line| line.limit.clone())}</span>
            </button>
            {repair}
        </div>
    }
}

/// A line for each of these results, in their order; those that stay are changed in place.
#[component]
pub(crate) fn VerdictLines(
    /// The results.
    #[prop(into)]
    readouts: Signal<Vec<Readout>>,
) -> impl IntoView {
    let page = Page::here();
    let own = move |id: &str| readouts.with(|readouts| readouts.iter().find(|readout| readout.id == id).cloned());
    let line = move |first: Readout| {
        let id = first.id;
        // Where the result has gone, its line is about to go.
        let readout =
            Memo::new(move |last: Option<&Readout>| own(id).or_else(|| last.cloned()).unwrap_or_else(|| first.clone()));
        view! { <VerdictLine readout=readout open=move || page.show_result(id) /> }
    };
    view! { <For each=move || readouts.get() key=|readout| readout.id children=line /> }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::testing::{Bench, InInches, mount, project, settled};
    use crate::view::{Limit, Verdict};

    fn readout(id: &str) -> Readout {
        project().design().readouts.into_iter().find(|readout| readout.id == id).unwrap()
    }

    async fn line(readout: Readout) -> Bench {
        mount(move || view! { <VerdictLine readout=RwSignal::new(readout.clone()) open=|| () /> }).await
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
        assert!(!bench.page.can.get_untracked().0);
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
        let opened = RwSignal::new(false);
        let bench =
            mount(move || view! { <VerdictLine readout=RwSignal::new(readout("line-speed")) open=move || opened.set(true) /> }).await;
        bench.press(".to-result").await;
        assert!(opened.get_untracked());
    }
}
