//! A result as one line: sign, name, value, limit with a bar to it, and the repair as a button.

use leptos::prelude::*;

use crate::text::number::filled;
use crate::ui::state::Page;
use crate::ui::words::{figure, four_digits, limit_sign, limit_text, say, sign, t, verdict_tone, verdict_words};
use crate::view::Readout;

/// The line; a click leads to the result among all results, the button carries out the best advice.
#[component]
pub(crate) fn VerdictLine(
    /// The result.
    readout: Readout,
    /// Opens the result.
    #[prop(into)]
    open: Callback<()>,
) -> impl IntoView {
    let readout = readout.shown();
    let (page, id) = (Page::here(), readout.id);
    let tone = verdict_tone(readout.verdict);
    let advice = readout.advice.first().map(|advice| say(&advice.message));
    let title = advice.unwrap_or_else(|| format!("{} {}", figure(readout.value, readout.decimals), readout.unit));
    let repair = readout.advice.iter().find_map(|advice| Some((say(advice.button.as_ref()?), advice.sets.clone())));
    let repair = repair.map(|(words, sets)| {
        view! {
            <button type="button" class="repair" title=title.clone() on:click=move |_| page.take_entries(&sets)>{words}</button>
        }
    });
    let bar = readout.bar();
    let (part, limit) = bar.unwrap_or_default();
    let percent = |share: f64| filled("#%", &[share]);
    view! {
        <div
            class=format!("card {tone}")
            on:pointerenter=move |_| page.show_causes(Some(id)) on:pointerleave=move |_| page.show_causes(None)
            on:focusin=move |_| page.show_causes(Some(id)) on:focusout=move |_| page.show_causes(None)
            class:plain=bar.is_none() style:--part=percent(part) style:--limit=percent(limit)>
            <button type="button" class="to-result" title=title on:click=move |_| open.run(())>
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

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::testing::{Bench, InInches, mount, project};
    use crate::view::{Limit, Verdict};

    fn readout(id: &str) -> Readout {
        project().design().readouts.into_iter().find(|readout| readout.id == id).unwrap()
    }

    async fn line(readout: Readout) -> Bench {
        mount(move || view! { <VerdictLine readout=readout open=|| () /> }).await
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
    async fn line_opens_its_result() {
        let opened = RwSignal::new(false);
        let bench =
            mount(move || view! { <VerdictLine readout=readout("line-speed") open=move || opened.set(true) /> }).await;
        bench.press(".to-result").await;
        assert!(opened.get_untracked());
    }
}
