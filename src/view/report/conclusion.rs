//! The conclusion of a report: draft or not, work of the machine, time of a part, whether all results hold, and the changes with which they do.

use super::document::Report;
use crate::msg;
use crate::text::catalog::{pieces, sentence, words};
use crate::text::{Message, clauses, listed, sentences};
use crate::view::svg::escape;
use crate::view::{Readout, Verdict};

/// Maximum failing results named.
const NAMED: usize = 3;

/// The conclusion as HTML, with its figures in bold.
pub(super) fn conclusion(report: &Report) -> String {
    let [draft, work, part] =
        [draft(report), Some(work(report)), part(report)].map(|message| message.as_ref().map(emphasized));
    let [verdicts, exceeded] = [Some(verdicts(report)), exceeded(report)].map(|message| message.as_ref().map(plain));
    let changes = report.repairs.messages();
    let changes = changes.iter().map(emphasized);
    sentences([draft, work, part, verdicts, exceeded].into_iter().flatten().chain(changes))
}

/// A sentence as HTML, its values in bold.
fn emphasized(message: &Message) -> String {
    let mut out = String::new();
    for piece in pieces(message) {
        let [open, close] = if piece.is_value { ["<b>", "</b>"] } else { ["", ""] };
        out.push_str(open);
        escape(&mut out, &piece.text);
        out.push_str(close);
    }
    out
}

fn plain(message: &Message) -> String {
    let mut out = String::new();
    escape(&mut out, &sentence(message));
    out
}

/// Note that errors keep the programs from being written; none without errors.
fn draft(report: &Report) -> Option<Message> {
    let count = report.diagnostics.iter().filter(|found| found.is_error()).count() as u32;
    (count > 0).then(|| msg!("form.report.draft", count))
}

/// Sentence about the work of the machine, or its headline figures if it does not work.
fn work(report: &Report) -> Message {
    let figure = |readout: &Readout| {
        format!("{} {} {}", words(readout.label), readout.value_text(), readout.unit).trim_end().to_owned()
    };
    report.summary.clone().unwrap_or_else(|| {
        let headline = report.readouts.iter().filter(|readout| readout.headline).take(3);
        msg!("form.report.figures", figures = clauses(headline.map(figure)))
    })
}

/// The time of a part, where the run reaches the end of the program.
fn part(report: &Report) -> Option<Message> {
    match &report.run.figures[..] {
        [time, parts] => {
            Some(msg!("form.report.part-takes", time = time.shown(), parts = (parts.value, parts.decimals)))
        }
        [time, mean, parts] => Some(msg!(
            "form.report.part-takes-mean",
            time = time.shown(),
            mean = mean.shown(),
            parts = (parts.value, parts.decimals)
        )),
        _ => None,
    }
}

/// Whether all results hold, or the first ones that fail.
fn verdicts(report: &Report) -> Message {
    let judged: Vec<&Readout> = report.readouts.iter().filter(|readout| readout.verdict != Verdict::None).collect();
    let failing: Vec<&str> =
        judged.iter().filter(|readout| readout.verdict == Verdict::Fail).map(|readout| words(readout.label)).collect();
    let warned = judged.iter().filter(|readout| readout.verdict == Verdict::Warn).count() as u32;
    match failing.len() {
        0 if warned > 0 => msg!("form.report.all-hold-warned", count = judged.len() as u32, warned),
        0 => msg!("form.report.all-hold", count = judged.len() as u32),
        n => {
            let names = listed(failing.iter().take(NAMED));
            let names = match n.saturating_sub(NAMED) {
                0 => names,
                others => sentence(&msg!("form.report.and-more", results = names, count = others as u32)),
            };
            msg!("form.report.some-fail", count = n as u32, all = judged.len() as u32, results = names)
        }
    }
}

/// Number of limits that the operating envelope exceeds; none if it exceeds none.
fn exceeded(report: &Report) -> Option<Message> {
    let count = report.sizing.exceeded.len() as u32;
    (count > 0).then(|| msg!("form.report.exceeded", count))
}
