//! A sizing in sections: a subject each, with its answer in one line and the sheets behind it.

use super::envelope::EnvelopeRow;
use super::{BillRow, Cycle, Growth, SizedAxis, Sizing};
use crate::drives::parts::Part;
use crate::machines::driven::devices::BillItem;
use crate::machines::sheets::say;
use crate::msg;
use crate::text::catalog::sentence;
use crate::text::{Message, headed, listed, units};
use crate::view::{Limit, Sheet, SheetKind, Verdict};

/// A section of a sizing.
#[derive(Debug, Clone, PartialEq)]
pub struct SizingSection {
    /// Id, for instance `envelope`; that of the axis for its motors.
    pub id: &'static str,
    /// Catalog id of its title.
    pub title: &'static str,
    /// Verdict of the answer.
    pub verdict: Verdict,
    /// The answer in words.
    pub answer: String,
    /// Its sheets.
    pub sheets: Vec<Sheet>,
}

impl Sizing {
    /// The sections, in the order in which a machine is sized: how it is operated, what limits it, its axes, its time, what is uncertain,
    /// what is to be ordered and wired. Those without a row are left out.
    pub fn sections(&self) -> Vec<SizingSection> {
        let section = |id, title, (verdict, answer), sheets: Vec<Sheet>| SizingSection {
            id,
            title,
            verdict,
            answer,
            sheets: sheets.into_iter().filter(|sheet| !sheet.rows.is_empty()).collect(),
        };
        let axis = |axis: &SizedAxis| section(axis.id, axis.name, self.motor_answer(axis), self.axis_sheets(axis));
        let mut sections = vec![
            section(
                "envelope",
                "size.section.envelope",
                self.envelope_answer(),
                vec![self.worst_sheet(), self.envelope_sheet()],
            ),
            section("limits", "sheet.limits", self.limit_answer(), vec![self.limit_sheet()]),
        ];
        sections.extend(self.axes.iter().map(axis));
        sections.extend([
            section("cycle", "sheet.cycle", (Verdict::None, self.cycle_answer()), vec![self.cycle_sheet()]),
            section("tornado", "size.section.facts", self.facts_answer(), vec![self.tornado_sheet()]),
            section("bill", "size.section.bill", self.bill_answer(), vec![self.bill_sheet()]),
            section("terminals", "size.section.terminals", self.terminal_answer(), vec![self.terminal_sheet()]),
        ]);
        sections.retain(|section| !section.sheets.is_empty());
        sections
    }

    /// The sheets of all sections; the operating envelope has every event.
    pub fn sheets(&self) -> Vec<Sheet> {
        let sheets = self.sections().into_iter().flat_map(|section| section.sheets);
        sheets.filter(|sheet| sheet.kind != SheetKind::Worst).collect()
    }

    /// The quantities beyond their limits, or the one nearest to its limit.
    fn envelope_answer(&self) -> (Verdict, String) {
        let failing: Vec<&EnvelopeRow> = self.worst().into_iter().filter(|row| row.verdict == Verdict::Fail).collect();
        if !failing.is_empty() {
            let beyond = failing.iter().map(|row| headed(row.quantity.name(), say(row.event.name())));
            return (Verdict::Fail, sentence(&msg!("size.answer.beyond", quantities = listed(beyond))));
        }
        let share = |row: &EnvelopeRow| match row.limit {
            Some(Limit::AtMost(limit)) if limit > 0.0 => Some(row.value / limit),
            _ => None,
        };
        let nearest = self.worst().into_iter().filter_map(|row| Some((share(row)?, row)));
        let answer = nearest.max_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, row)| {
            let limit = row.limit.map_or(0.0, Limit::value);
            let [value, limit] = [row.value, limit].map(|value| units::text(value, row.decimals, row.unit));
            let event = say(row.event.name());
            sentence(&msg!("size.answer.within", quantity = row.quantity.name(), value, limit, event))
        });
        (Verdict::Ok, answer.unwrap_or_else(|| say("size.answer.no-limit")))
    }

    /// The worst value of each quantity over all events.
    pub fn worst(&self) -> Vec<&EnvelopeRow> {
        let worst = self.envelope.iter().filter(|row| !row.is_heat());
        let mut found: Vec<&EnvelopeRow> = Vec::new();
        for row in worst {
            match found.iter_mut().find(|known| known.quantity == row.quantity) {
                None => found.push(row),
                Some(known) if row.is_worst && !known.is_worst => *known = row,
                Some(_) => {}
            }
        }
        found
    }

    /// The limit with the least margin.
    fn limit_answer(&self) -> (Verdict, String) {
        if self.limits.is_empty() {
            return (Verdict::None, say("size.at-rest"));
        }
        let next = self.limits.iter().filter(|growth| growth.holds && growth.binding.is_some());
        let answer = next.min_by(|a, b| a.margin.total_cmp(&b.margin)).map(next_limit);
        let fails = self.limits.iter().any(|growth| !growth.holds || !growth.failing_anyway.is_empty());
        let verdict = if fails { Verdict::Warn } else { Verdict::None };
        (verdict, answer.unwrap_or_else(|| say(if fails { "size.none-holds" } else { "size.no-limit" })))
    }

    /// The ordered or proposed motor of an axis with its loads.
    fn motor_answer(&self, axis: &SizedAxis) -> (Verdict, String) {
        let of_axis = |item| self.bill.iter().find(|row| row.axis == Some(axis.name) && row.item == item);
        let Some(row) = of_axis(BillItem::Motor) else { return (Verdict::None, String::new()) };
        let order = match (&row.refusal, row.model.is_empty()) {
            (Some(_), _) => Verdict::Fail,
            (None, true) => Verdict::Warn,
            (None, false) => Verdict::Ok,
        };
        if let Some(run) = &self.truncated {
            // A run that was cut short has not asked all of the motor.
            return (order.max(Verdict::Warn), sentence(&run.message()));
        }
        let verdict = order.max(self.heat(axis).map_or(Verdict::None, |heat| heat.verdict));
        let is_listed = |part: &Part| part.maker == row.maker && part.model == row.model;
        let candidate = axis.candidates.iter().find(|candidate| is_listed(&candidate.part));
        let motor = row.part();
        let message = match candidate.and_then(|candidate| candidate.shares) {
            _ if row.refusal.is_some() => msg!("size.answer.motor-refused", motor),
            Some(shares) => msg!(
                "size.answer.motor",
                motor,
                effective = (100.0 * shares.effective, 0),
                peak = (100.0 * shares.peak, 0)
            ),
            None => return (verdict, motor),
        };
        (verdict, sentence(&message))
    }

    fn cycle_answer(&self) -> String {
        let answer = |cycle: Cycle| {
            let [time, mean] = [cycle.seconds, cycle.mean()].map(|seconds| units::text(seconds, 1, "s"));
            let parts = (cycle.parts_per_hour(), 1);
            sentence(&if mean == time {
                msg!("size.answer.cycle", time, parts)
            } else {
                msg!("size.answer.cycle-mean", time, mean, parts)
            })
        };
        self.cycle.map(answer).or_else(|| Some(sentence(&self.truncated.as_ref()?.message()))).unwrap_or_default()
    }

    fn facts_answer(&self) -> (Verdict, String) {
        match self.sensitivities.len() {
            0 => (Verdict::Ok, say("size.answer.no-fact")),
            count => (Verdict::Warn, sentence(&msg!("size.answer.facts", count = count as u32))),
        }
    }

    fn bill_answer(&self) -> (Verdict, String) {
        let open = |row: &&BillRow| row.model.is_empty() || row.refusal.is_some() || !row.open.is_empty();
        let (count, open) = (self.bill.len() as u32, self.bill.iter().filter(open).count() as u32);
        (Verdict::None, sentence(&msg!("size.answer.bill", count, open)))
    }

    fn terminal_answer(&self) -> (Verdict, String) {
        (Verdict::None, sentence(&msg!("size.answer.terminals", count = self.terminals.len() as u32)))
    }
}

/// A growth up to its limit: `Spindle speed S up to 23 % more, then Analog output`.
fn next_limit(growth: &Growth) -> String {
    let (quantity, result) = (say(growth.label), say(growth.binding.map_or("", |binding| binding.label)));
    let percent = (100.0 * growth.margin).round();
    let message: Message = if percent > 0.0 {
        msg!("size.answer.limit", quantity, percent, result)
    } else if percent < 0.0 {
        msg!("size.answer.limit-passed", quantity, percent = -percent, result)
    } else {
        msg!("size.answer.limit-reached", quantity, result)
    };
    sentence(&message)
}
