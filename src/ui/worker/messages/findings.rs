//! Findings as messages: the catalog of the other end has their sentences.

use serde::{Deserialize, Serialize};

use crate::controls::Control;
use crate::text::{Diagnostic, DiagnosticKind, FileId, Fix, Message, MessageValue, Place, Severity, Span, catalog};

/// A [`Diagnostic`] with its static texts as owned ones.
#[derive(Debug, Serialize, Deserialize)]
pub(crate) struct Finding {
    message: Sentence,
    /// Place in [`Severity::ALL`].
    severity: u8,
    /// Place in [`DiagnosticKind::ALL`].
    kind: u8,
    alarm: Option<String>,
    wording: Option<u16>,
    place: Option<Range>,
    hints: Vec<Sentence>,
    fixes: Vec<(Sentence, Vec<(Range, String)>)>,
}

/// Id of a message, and the names of its places with their values as they are shown.
#[derive(Debug, Serialize, Deserialize)]
struct Sentence(String, Vec<(String, String)>);

/// File, start and end of a place.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(crate) struct Range(u16, u32, u32);

impl From<&Message> for Sentence {
    fn from(message: &Message) -> Sentence {
        let shown = |(name, value): &(&str, MessageValue)| ((*name).to_owned(), catalog::plain(value).into_owned());
        Sentence(message.id.to_owned(), message.values.iter().map(shown).collect())
    }
}

impl Sentence {
    /// The message; `None` where the catalog lacks its id. Values without a place in its sentence are left out.
    fn message(self) -> Option<Message> {
        let id = catalog::id(&self.0)?;
        let values = self.1.into_iter();
        let values = values.filter_map(|(name, text)| Some((catalog::place(id, &name)?, MessageValue::Text(text))));
        Some(Message { id, values: values.collect() })
    }
}

impl From<Place> for Range {
    fn from(place: Place) -> Range {
        Range(place.file.0, place.span.start, place.span.end)
    }
}

impl From<Range> for Place {
    fn from(Range(file, start, end): Range) -> Place {
        Place { file: FileId(file), span: Span { start, end } }
    }
}

impl Finding {
    /// The diagnostic as a message; its wording is the number of the row in the control's table of alarms.
    pub(in crate::ui::worker) fn new(found: &Diagnostic, control: &Control) -> Finding {
        let shown = (found.alarm.as_deref(), found.wording);
        let row = control.alarms.iter().position(|row| (Some(row.number), Some(row.text)) == shown);
        let edits = |fix: &Fix| fix.edits.iter().map(|(place, text)| ((*place).into(), text.clone())).collect();
        Finding {
            message: (&found.message).into(),
            severity: found.severity as u8,
            kind: found.kind as u8,
            alarm: found.alarm.as_deref().map(str::to_owned),
            wording: row.and_then(|row| u16::try_from(row).ok()),
            place: found.place.map(Range::from),
            hints: found.hints.iter().map(Sentence::from).collect(),
            fixes: found.fixes.iter().map(|fix| ((&fix.title).into(), edits(fix))).collect(),
        }
    }

    /// The diagnostic; its wording is that of the control's own row. `None` where the catalog lacks its sentence.
    pub(in crate::ui::worker) fn diagnostic(self, control: &Control) -> Option<Diagnostic> {
        let message = self.message.message()?;
        let (severity, kind) = (usize::from(self.severity), usize::from(self.kind));
        let mut found = Diagnostic::error(message).kind(*DiagnosticKind::ALL.get(kind)?);
        found.severity = *Severity::ALL.get(severity)?;
        found.place = self.place.map(Place::from);
        found.alarm = self.alarm.map(Into::into);
        found.wording = self.wording.and_then(|row| control.alarms.get(usize::from(row))).map(|row| row.text);
        found.hints.extend(self.hints.into_iter().filter_map(Sentence::message));
        for (title, edits) in self.fixes {
            let Some(title) = title.message() else { continue };
            found.fixes.push(Fix { title, edits: edits.into_iter().map(|(at, text)| (at.into(), text)).collect() });
        }
        Some(found)
    }
}

#[cfg(test)]
mod tests {
    use wasm_bindgen_test::wasm_bindgen_test;

    use super::*;
    use crate::ui::testing::project;

    #[wasm_bindgen_test]
    fn finding_is_the_same_on_both_ends() {
        let control = project().control;
        let place = Place { file: FileId(1), span: Span { start: 2, end: 5 } };
        let row = control.alarms.last().map(|row| (row.number, row.text));
        let sent = Diagnostic::warning(crate::msg!("page.more-findings", count = 5.0))
            .at(place)
            .alarm(row)
            .hint(crate::msg!("page.taken"))
            .kind(DiagnosticKind::Starved)
            .fix(crate::msg!("page.mended"), vec![(place, "X1.".to_owned())]);
        let wire = serde_wasm_bindgen::to_value(&Finding::new(&sent, control)).unwrap();
        let got = serde_wasm_bindgen::from_value::<Finding>(wire).unwrap().diagnostic(control).unwrap();
        assert_eq!(crate::ui::words::tell_alarm(&got), crate::ui::words::tell_alarm(&sent));
        assert_eq!((got.severity, got.kind, got.place), (sent.severity, sent.kind, sent.place));
        assert_eq!(got.fixes[0].edits, sent.fixes[0].edits);
    }

    #[wasm_bindgen_test]
    fn value_crosses_only_by_a_name_of_its_sentence() {
        let values = [("count", "5"), ("speed", "7")].map(|(name, text)| (name.to_owned(), text.to_owned()));
        let got = Sentence("page.more-findings".to_owned(), values.into()).message().unwrap();
        assert_eq!(got.values, [("count", MessageValue::Text("5".to_owned()))]);
    }
}
