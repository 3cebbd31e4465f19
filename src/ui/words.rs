//! Sentences of the page in the language of the user.

use core::fmt;

use serde::{Deserialize, Serialize};

use crate::controls::Control;
use crate::motion::{Mode, RunEnd};
use crate::text::catalog;
use crate::text::number;
use crate::text::{Diagnostic, Message, Phrase, Severity, sentences};
use crate::view::{Readout, Verdict};

/// The words of a catalog id.
pub(crate) fn t(id: &'static str) -> &'static str {
    catalog::words(id)
}

/// Name of a project, or the word for one without a name.
pub(crate) fn shown_name(name: &str) -> &str {
    if name.trim().is_empty() { t("page.untitled") } else { name }
}

/// Whether a text has all words of a search, in upper or lower case.
pub(crate) fn has_all_words(text: &str, search: &str) -> bool {
    let text = text.to_lowercase();
    search.to_lowercase().split_whitespace().all(|word| text.contains(word))
}

/// A message as a sentence.
pub(crate) fn sentence(message: &Message) -> String {
    catalog::sentence(message)
}

/// Message and hints of a diagnostic in one line.
pub(crate) fn sentence_with_hints(diagnostic: &Diagnostic) -> String {
    sentences([&diagnostic.message].into_iter().chain(&diagnostic.hints).map(sentence))
}

/// Weight of a sentence, a verdict or a state: its colour and its sign.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub(crate) enum Tone {
    /// Nothing is judged.
    Plain,
    /// Good.
    Ok,
    /// Worth knowing.
    Info,
    /// To be checked.
    Warn,
    /// Wrong.
    Fail,
}

impl Tone {
    /// Class of the style sheet.
    pub(crate) fn class(self) -> &'static str {
        match self {
            Tone::Plain => "none",
            Tone::Ok => "ok",
            Tone::Info => "info",
            Tone::Warn => "warn",
            Tone::Fail => "fail",
        }
    }

    /// Sign, so that colour is not the only mark.
    pub(crate) fn sign(self) -> &'static str {
        match self {
            Tone::Plain => Verdict::None.sign(),
            Tone::Ok => Verdict::Ok.sign(),
            Tone::Info => "ⓘ",
            Tone::Warn => Verdict::Warn.sign(),
            Tone::Fail => Verdict::Fail.sign(),
        }
    }
}

impl fmt::Display for Tone {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.class())
    }
}

impl From<Severity> for Tone {
    fn from(severity: Severity) -> Tone {
        match severity {
            Severity::Error => Tone::Fail,
            Severity::Warning => Tone::Warn,
            Severity::Info => Tone::Info,
        }
    }
}

impl From<Verdict> for Tone {
    fn from(verdict: Verdict) -> Tone {
        match verdict {
            Verdict::None => Tone::Plain,
            Verdict::Ok => Tone::Ok,
            Verdict::Warn => Tone::Warn,
            Verdict::Fail => Tone::Fail,
        }
    }
}

impl From<Mode> for Tone {
    fn from(mode: Mode) -> Tone {
        match mode {
            Mode::Running => Tone::Ok,
            Mode::Alarm | Mode::EmergencyStop => Tone::Fail,
            Mode::Hold | Mode::Stopped => Tone::Warn,
            Mode::WaitFin | Mode::Dwell | Mode::Ended => Tone::Info,
        }
    }
}

/// Number and wording of the control's alarm, then message and hints.
pub(crate) fn tell_alarm(diagnostic: &Diagnostic) -> String {
    let alarm = diagnostic.alarm.iter().map(|number| number.as_ref()).chain(diagnostic.wording.map(Phrase::words));
    alarm.map(|part| format!("{part} ")).collect::<String>() + &sentence_with_hints(diagnostic)
}

/// Why a run is over; after a reset a stop waits at the start of the program.
pub(crate) fn end_words(end: &RunEnd, is_reset: bool) -> String {
    match end {
        RunEnd::ProgramEnd => t("page.end-program").to_owned(),
        RunEnd::Stop if is_reset => t("page.end-reset").to_owned(),
        RunEnd::Stop => t("page.end-stop").to_owned(),
        RunEnd::Alarm(alarm) => tell_alarm(alarm),
        RunEnd::Blocks | RunEnd::Seconds => t("page.end-budget").to_owned(),
    }
}

/// The value of a variable as the control shows it.
pub(crate) fn value_of(control: &Control, value: Option<f64>, decimals: u8) -> String {
    match value {
        None if control.has_vacant() => t("page.vacant").to_owned(),
        value => short(value.unwrap_or_default(), decimals),
    }
}

/// A number with a fixed count of decimals, for figures on the screen.
pub(crate) fn figure(number: f64, decimals: u8) -> String {
    if !number.is_finite() {
        return "–".to_owned();
    }
    number::figure(number, decimals)
}

/// Number with at most `decimals` decimals.
pub(crate) fn short(number: f64, decimals: u8) -> String {
    number::short(number, decimals)
}

/// A machine time as minutes, seconds and tenths of milliseconds.
pub(crate) fn clock(seconds: f64) -> String {
    let ticks = (seconds.max(0.0) * 1e4) as u64;
    let (minutes, rest) = (ticks / 600_000, ticks % 600_000);
    format!("{minutes:02}:{:02}.{:04}", rest / 10_000, rest % 10_000)
}

/// Seconds of a time as it is written: `12.5`, `12.5 s`, or as [`clock`] writes it, `00:12.5`.
pub(crate) fn read_clock(text: &str) -> Option<f64> {
    let text = text.trim().trim_end_matches(['s', 'S']).trim_end();
    let (minutes, seconds) = text
        .split_once([':', '：'])
        .map_or((Some(0.0), text), |(minutes, seconds)| (minutes.trim().parse::<u32>().ok().map(f64::from), seconds));
    let seconds = number::read(seconds).filter(|seconds| *seconds >= 0.0)?;
    Some(60.0 * minutes? + seconds)
}

/// A day with its time, as people of the language write it; empty where it is not known.
pub(crate) fn day(milliseconds: f64) -> String {
    if milliseconds <= 0.0 {
        return String::new();
    }
    let style = js_sys::Object::new();
    for (part, length) in [("dateStyle", "medium"), ("timeStyle", "short")] {
        let _ = js_sys::Reflect::set(&style, &part.into(), &length.into());
    }
    js_sys::Date::new(&milliseconds.into()).to_locale_string(t("page.locale"), &style).into()
}

/// A speed of the film as `1/20 ×`, `2 ×`.
pub(crate) fn speed_text(speed: f64) -> String {
    if speed < 1.0 { number::filled("1/# ×", &[1.0 / speed]) } else { number::filled("# ×", &[speed]) }
}

/// Counts of errors, warnings and remarks.
pub(crate) fn counts<'a>(diagnostics: impl IntoIterator<Item = &'a Diagnostic>) -> [(Severity, usize); 3] {
    let mut all = [Severity::Error, Severity::Warning, Severity::Info].map(|severity| (severity, 0));
    for found in diagnostics {
        all.iter_mut().filter(|(severity, _)| *severity == found.severity).for_each(|(_, count)| *count += 1);
    }
    all
}

/// Words of a verdict, for screen readers.
pub(crate) fn verdict_words(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::None => "",
        Verdict::Ok => t("page.verdict-ok"),
        Verdict::Warn => t("page.verdict-warn"),
        Verdict::Fail => t("page.verdict-fail"),
    }
}

/// Catalog id of the control's mode.
pub(crate) fn mode_words(mode: Mode) -> &'static str {
    match mode {
        Mode::Running => "page.mode-running",
        Mode::Hold => "page.mode-hold",
        Mode::Stopped => "page.mode-stopped",
        Mode::WaitFin => "page.mode-wait-fin",
        Mode::Dwell => "page.mode-dwell",
        Mode::Ended => "page.mode-ended",
        Mode::Alarm => "page.mode-alarm",
        Mode::EmergencyStop => "page.mode-estop",
    }
}

/// A number with four significant digits where its row has as many; small ones with the decimals of the row.
pub(crate) fn four_digits(number: f64, decimals: u8) -> String {
    number::four_digits(number, decimals)
}

/// The limit of a result in its shortest form: `≤ 20 000`.
pub(crate) fn limit_sign(readout: &Readout) -> Option<String> {
    readout.limit.map(|limit| {
        // Beside a value of four digits.
        let decimals = number::decimals_of_four(limit.value(), readout.decimals);
        format!("{} {}", limit.sign(), short(limit.value(), decimals))
    })
}

/// Limit of a result as text, with the decimals of its value.
pub(crate) fn limit_text(readout: &Readout) -> Option<String> {
    readout.limit.map(|limit| sentence(&limit.message(short(limit.value(), readout.decimals))))
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;

    /// Thin spaces as plain ones.
    fn plain(text: &str) -> String {
        text.replace('\u{202f}', " ")
    }

    #[wasm_bindgen_test]
    fn four_digits_drops_decimals_of_large_numbers() {
        let shown = [(15079.645, 3), (480.04, 1), (31.831, 3), (8.1074, 3)].map(|(n, d)| plain(&four_digits(n, d)));
        assert_eq!(shown, ["15 080", "480.0", "31.83", "8.107"]);
    }

    #[wasm_bindgen_test]
    fn stop_after_a_reset_begins_the_program_anew() {
        let words = [false, true].map(|is_reset| end_words(&RunEnd::Stop, is_reset));
        assert_eq!(words, [t("page.end-stop"), t("page.end-reset")]);
    }

    #[wasm_bindgen_test]
    fn four_digits_keeps_the_decimals_of_small_numbers() {
        assert_eq!((four_digits(0.05, 3), four_digits(6.0, 0)), ("0.050".to_owned(), "6".to_owned()));
    }

    #[wasm_bindgen_test]
    fn clock_has_minutes_and_four_decimals() {
        assert_eq!([0.0, 61.5, 3599.99995].map(clock), ["00:00.0000", "01:01.5000", "59:59.9999"]);
        let read = ["12.5", "2,5 s", "01:01.5", "0:12", "abc", "-3", "1:2:3"].map(read_clock);
        assert_eq!(read, [Some(12.5), Some(2.5), Some(61.5), Some(12.0), None, None, None]);
        assert_eq!(clock(-1.0), "00:00.0000");
    }

    #[wasm_bindgen_test]
    fn slow_speed_is_written_as_a_fraction() {
        assert_eq!([0.05, 0.5, 1.0, 10.0].map(speed_text), ["1/20 ×", "1/2 ×", "1 ×", "10 ×"]);
    }

    #[wasm_bindgen_test]
    fn short_drops_only_zeros_behind_the_point() {
        assert_eq!([short(2.50, 3), short(100.0, 0), short(100.0, 2)], ["2.5", "100", "100"]);
    }

    #[wasm_bindgen_test]
    fn number_without_a_value_is_a_dash() {
        assert_eq!(figure(f64::NAN, 3), "–");
        assert_eq!(figure(f64::INFINITY, 3), "–");
    }

    #[wasm_bindgen_test]
    fn every_tone_has_a_sign_of_its_own() {
        let signs: std::collections::BTreeSet<_> =
            [Tone::Ok, Tone::Warn, Tone::Fail, Tone::Info].map(Tone::sign).into();
        assert_eq!(signs.len(), 4);
        assert!(!signs.contains(""));
    }

    #[wasm_bindgen_test]
    fn findings_are_counted_by_severity() {
        let found = [Diagnostic::error(crate::msg!("page.vacant")), Diagnostic::info(crate::msg!("page.vacant"))];
        assert_eq!(counts(&found).map(|row| row.1), [1, 0, 1]);
    }
}
