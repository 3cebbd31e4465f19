//! A sizing as sheets, for page, report and command line.

use super::choice::Candidate;
use super::envelope::EnvelopeRow;
use super::tell::{grade, with_unit};
use super::{BillRow, Growth, SizedAxis, Sizing};
use crate::drives::parts::PartGrade;
use crate::machines::sheets::{row, say};
use crate::math::PI;
use crate::text::catalog::{Language, number_text, sentence};
use crate::text::{Citation, Grade};
use crate::view::{Row, Sheet, TorqueWords, Verdict};

const RUNS: Citation = Citation::new("run of the program in the virtual control", Grade::Inferred);
const RUNS_OF_FORM: Citation = Citation::new("results with other entries of the form", Grade::Inferred);
const CATALOGUE: Citation = Citation::new("catalogue of parts, with the source of each row", Grade::Inferred);

/// Motors of an axis in an offer.
const OFFERED: usize = 5;

impl Sizing {
    /// The sheets: what there is to buy, what limits, what happens in operation, and the motors of each axis.
    pub fn sheets(&self) -> Vec<Sheet> {
        let mut sheets = vec![self.bill_sheet(), self.limit_sheet(), self.envelope_sheet()];
        sheets.extend(self.axes.iter().flat_map(|axis| [asked(axis), Some(motors(axis))]).flatten());
        sheets.retain(|sheet| !sheet.rows.is_empty());
        sheets
    }

    /// The sheets of an offer: those, with the motors that an engineer would look at first.
    pub fn offer(&self) -> Vec<Sheet> {
        let mut sheets = self.sheets();
        sheets.iter_mut().filter(|sheet| sheet.id == "motors").for_each(|sheet| sheet.rows.truncate(OFFERED));
        sheets
    }

    /// The bill of materials.
    pub fn bill_sheet(&self) -> Sheet {
        let cells = |of: &BillRow| {
            let cells = [say(of.item), of.axis.map(say).unwrap_or_default(), of.part.clone(), of.quantity.to_string()];
            row(cells, Citation { grade: known(of.grade), ..CATALOGUE })
        };
        Sheet {
            id: "bill",
            title: "sheet.bill",
            columns: vec!["sheet.item", "sheet.axis", "sheet.part", "sheet.quantity"],
            rows: self.bill.iter().map(cells).collect(),
            drawing: String::new(),
        }
    }

    fn limit_sheet(&self) -> Sheet {
        let cells = |of: &Growth| {
            let binding = of.binding.map_or_else(|| say("size.no-limit"), |binding| say(binding.1));
            let margin = format!("{:+.1} %", 100.0 * of.margin);
            row([say(of.label), with_unit(of.value, 3, of.unit), margin, binding], RUNS_OF_FORM)
        };
        let fastest = self.fastest.as_ref().map(|fastest| {
            let speed = with_unit(fastest.value.0, fastest.decimals, fastest.value.1);
            let label = format!("{}: {}", say("size.fastest"), say(fastest.result.1));
            let cells = [label, speed, String::new(), say(fastest.binding.1)];
            Row { sets: vec![fastest.entry.clone()], ..row(cells, RUNS_OF_FORM) }
        });
        Sheet {
            id: "limits",
            title: "sheet.limits",
            columns: vec!["sheet.grows", "sheet.until", "sheet.margin", "sheet.binds"],
            rows: self.limits.iter().map(cells).chain(fastest).collect(),
            drawing: String::new(),
        }
    }

    fn envelope_sheet(&self) -> Sheet {
        let cells = |of: &EnvelopeRow| {
            let quantity = match of.axis {
                Some(axis) => format!("{}, {}", say(of.label), say(axis)),
                None => say(of.label),
            };
            let limit = of.limit.map_or(String::new(), |limit| {
                let shown = number_text(limit.value(), of.decimals);
                sentence(Language::English, &limit.message(shown))
            });
            let verdict = match of.verdict {
                Verdict::None => None,
                Verdict::Ok => Some(say("size.holds")),
                Verdict::Warn | Verdict::Fail => Some(say("size.fails")),
            };
            let worst = of.is_worst.then(|| say("size.worst"));
            let verdict: Vec<String> = verdict.into_iter().chain(worst).collect();
            row(
                [say(of.event.name()), quantity, with_unit(of.value, of.decimals, of.unit), limit, verdict.join(", ")],
                RUNS,
            )
        };
        Sheet {
            id: "envelope",
            title: "sheet.envelope",
            columns: vec!["sheet.event", "sheet.quantity-watched", "sheet.value", "sheet.limit", "sheet.verdict"],
            rows: self.envelope.iter().map(cells).collect(),
            drawing: String::new(),
        }
    }
}

/// How well a part is known, by the grades of sheets.
fn known(of: PartGrade) -> Grade {
    match of {
        PartGrade::Manual | PartGrade::DataSheet => Grade::Manual,
        PartGrade::Secondary | PartGrade::Entered => Grade::Inferred,
        PartGrade::Open => Grade::Open,
    }
}

/// What the run asks of the motor that the form has, with its chart.
fn asked(axis: &SizedAxis) -> Option<Sheet> {
    let (work, chart) = (axis.work?, axis.chart.as_ref()?);
    let (continuous, peak, effective, at) =
        (say("size.continuous"), say("size.peak"), say("size.effective"), say("size.at"));
    let words = TorqueWords { continuous: &continuous, peak: &peak, effective: &effective, at: &at };
    let cells = [
        (
            "size.torque",
            format!("{} ({} {} s)", with_unit(work.peak.0, 3, "Nm"), say("size.at"), number_text(work.peak.1, 2)),
        ),
        ("size.effective", with_unit(work.effective, 3, "Nm")),
        ("size.speed", with_unit(work.speed * 30.0 / PI, 0, "r/min")),
        ("size.given", with_unit(work.given, 1, "J")),
        ("size.returned", with_unit(work.returned, 1, "J")),
    ];
    Some(Sheet {
        id: "asked",
        title: axis.name,
        columns: vec!["sheet.quantity-watched", "sheet.value"],
        rows: cells.into_iter().map(|(label, value)| row([say(label), value], RUNS)).collect(),
        drawing: chart.svg(&words),
    })
}

/// The motors of an axis; a click takes one into the form.
fn motors(axis: &SizedAxis) -> Sheet {
    let share = |share: Option<f64>| share.map_or(String::new(), |share| format!("{:.0} %", 100.0 * share));
    let cells = |of: &Candidate| {
        let part = &of.part;
        let inertia = of.shares.filter(|shares| shares.inertia_ratio > 0.0);
        let answer = match &of.refusal {
            None => say("size.passes"),
            Some(refusal) => sentence(Language::English, &refusal.message),
        };
        let cells = [
            format!("{} {}", part.maker, part.model),
            share(of.shares.map(|shares| shares.effective)),
            share(of.shares.map(|shares| shares.peak)),
            share(of.regenerative),
            inertia.map_or(String::new(), |shares| format!("{:.1}", shares.inertia_ratio)),
            of.amplifier.as_ref().map_or(String::new(), |part| part.model.clone()),
            grade(part.evidence.grade).to_owned(),
            answer,
        ];
        let cite = Citation { grade: known(part.evidence.grade), ..of.limits.cite };
        Row { sets: of.entries.clone(), ..row(cells, cite) }
    };
    Sheet {
        id: "motors",
        // Behind the sheet with its name.
        title: if axis.chart.is_some() { "sheet.motors" } else { axis.name },
        columns: vec![
            "sheet.motor",
            "sheet.effective-load",
            "sheet.peak-load",
            "sheet.regenerative-load",
            "sheet.inertia-ratio",
            "sheet.amplifier",
            "sheet.evidence",
            "sheet.answer",
        ],
        rows: axis.candidates.iter().map(cells).collect(),
        drawing: String::new(),
    }
}
