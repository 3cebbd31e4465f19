//! What the page says, in the language of the user.

use crate::controls::Control;
use crate::motion::RunEnd;
use crate::text::catalog::{self, Language};
use crate::text::number;
use crate::text::{Diagnostic, Grade, Message, Severity};

/// The words of a catalog id.
pub(super) fn t(id: &'static str) -> &'static str {
    catalog::words(Language::English, id)
}

/// A message as a sentence.
pub(super) fn say(message: &Message) -> String {
    catalog::sentence(Language::English, message)
}

/// What is wrong and what is allowed, in one line.
pub(super) fn tell(diagnostic: &Diagnostic) -> String {
    let mut text = say(&diagnostic.message);
    for hint in &diagnostic.hints {
        text.push(' ');
        text.push_str(&say(hint));
    }
    text
}

/// The class of a severity.
pub(super) fn tone(severity: Severity) -> &'static str {
    match severity {
        Severity::Error => "fail",
        Severity::Warning => "warn",
        Severity::Info => "info",
    }
}

/// How well a fact is known.
pub(super) fn grade(grade: Grade) -> &'static str {
    match grade {
        Grade::Manual => t("page.grade-manual"),
        Grade::Sister => t("page.grade-sister"),
        Grade::Measured => t("page.grade-measured"),
        Grade::Inferred => t("page.grade-inferred"),
        Grade::Open => t("page.grade-open"),
    }
}

/// The sign of a class, so that nothing is said by colour alone.
pub(super) fn sign(tone: &str) -> &'static str {
    match tone {
        "ok" => "✓",
        "warn" => "▲",
        "fail" => "✕",
        "info" => "ⓘ",
        _ => "",
    }
}

/// The same behind the alarm that the control shows.
pub(super) fn tell_alarm(diagnostic: &Diagnostic) -> String {
    let alarm = diagnostic.alarm.iter().map(|number| number.as_ref()).chain(diagnostic.wording);
    alarm.map(|part| format!("{part} ")).collect::<String>() + &tell(diagnostic)
}

/// Why a run is over.
pub(super) fn end_words(end: &RunEnd) -> String {
    match end {
        RunEnd::ProgramEnd => t("page.end-program").to_owned(),
        RunEnd::Stop => t("page.end-stop").to_owned(),
        RunEnd::Alarm(alarm) => tell_alarm(alarm),
        RunEnd::Blocks | RunEnd::Seconds => t("page.end-budget").to_owned(),
    }
}

/// The value of a variable as the control shows it.
pub(super) fn value_of(control: &Control, value: Option<f64>, decimals: u8) -> String {
    match value {
        None if control.has_vacant() => t("page.vacant").to_owned(),
        value => short(value.unwrap_or_default(), decimals),
    }
}

/// A number with a fixed count of decimals and thin spaces between thousands.
pub(super) fn figure(number: f64, decimals: u8) -> String {
    if !number.is_finite() {
        return "–".to_owned();
    }
    number::figure(number, decimals)
}

/// A number with at most so many decimals.
pub(super) fn short(number: f64, decimals: u8) -> String {
    let text = figure(number, decimals);
    if text.as_bytes().contains(&b'.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}

/// A machine time as minutes, seconds and tenths of milliseconds.
pub(super) fn clock(seconds: f64) -> String {
    let ticks = (seconds.max(0.0) * 1e4) as u64;
    let (minutes, rest) = (ticks / 600_000, ticks % 600_000);
    format!("{minutes:02}:{:02}.{:04}", rest / 10_000, rest % 10_000)
}
