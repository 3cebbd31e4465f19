//! A sizing in words and for programs.

use serde_json::{Value as Json, json};

use super::choice::Candidate;
use super::envelope::{EnvelopeRow, HoldingLimit};
use super::gears::{GearCandidate, SizedGear};
use super::growth::{ResultName, no_fastest};
use super::{BillRow, Fastest, Growth, SizedAxis, Sizing, Swing, TerminalRow, Tornado};
use crate::drives::gear::GearDuty;
use crate::drives::parts::{Part, PartGrade, Status};
use crate::project::list::verdict_word;
use crate::project::sensitivity::Flip;
use crate::text::catalog::{sentence, words};
use crate::view::{FieldEntry, Limit, Sheet, SheetKind};

/// Word of a part's grade in a table of parts.
pub(super) fn grade(grade: PartGrade) -> &'static str {
    PartGrade::WORDS.iter().find(|row| row.1 == grade).map_or("", |row| row.0)
}

/// Word of a part's status in a table of parts.
fn status(status: Option<Status>) -> &'static str {
    Status::WORDS.iter().find(|row| Some(row.1) == status).map_or("unknown", |row| row.0)
}

/// A share in percent.
fn percent(share: f64) -> f64 {
    100.0 * share
}

impl Sizing {
    /// The sizing as an object. Loads are in percent of the motor's ratings.
    pub fn json(&self) -> Json {
        json!({
            "axes": self.axes.iter().map(axis).collect::<Vec<_>>(),
            "cycle": self.cycle.map(|cycle| json!({
                "time_s": cycle.seconds, "further_s": cycle.further, "pause_s": cycle.pause, "change_s": cycle.between_parts, "parts_per_hour": cycle.parts_per_hour(), "energy_given_j": cycle.energy.map(|energy| energy.given),
                "energy_returned_j": cycle.energy.map(|energy| energy.returned),
                "energy_returned_on_one_bus_j": cycle.energy.map(|energy| energy.returned_on_one_bus),
            })),
            "cut": self.truncated.as_ref().map(|run| json!({ "at_s": run.at, "reason": sentence(&run.message()) })),
            "envelope": self.envelope.iter().map(event).collect::<Vec<_>>(),
            "would_hold": self.holding_limits.iter().map(holding_limit).collect::<Vec<_>>(),
            "limits": self.limits.iter().map(limit).collect::<Vec<_>>(),
            "inverse": self.fastest.as_ref().map(fastest),
            "inverse_reason": no_fastest(&self.limits, self.fastest.as_ref()).as_ref().map(sentence),
            "sensitivities": self.sensitivities.iter().map(flip).collect::<Vec<_>>(),
            "tornado": self.tornadoes.iter().map(tornado).collect::<Vec<_>>(),
            "bom": self.bill.iter().map(bill).collect::<Vec<_>>(),
            "terminals": self.terminals.iter().map(terminal).collect::<Vec<_>>(),
        })
    }
}

fn axis(axis: &SizedAxis) -> Json {
    let demand = axis.motor_load.map(|load| {
        json!({
            "peak_torque_nm": load.peak.torque, "peak_at_s": load.peak.t,
            "peak_at_knob_percent": axis.knob.filter(|_| axis.peak_is_at_knob),
            "peak_at_feed_percent": axis.peak_feed, "effective_torque_nm": load.effective,
            "current_per_torque_a_nm": axis.ampere_per_torque,
            "speed_rad_s": load.speed, "energy_given_j": load.given, "energy_returned_j": load.returned,
        })
    });
    json!({
        "axis": axis.id,
        "name": words(axis.name),
        "turning": percent(axis.turning),
        "loaded": percent(axis.loaded),
        "least": axis.least().map(Part::name),
        "asked": demand,
        "shortage": axis.shortage().map(|shortage| sentence(&shortage)),
        "candidates": axis.candidates.iter().map(candidate).collect::<Vec<_>>(),
        "gear": axis.gear.as_ref().map(gear),
    })
}

fn candidate(candidate: &Candidate) -> Json {
    let Candidate { part, shares, .. } = candidate;
    json!({
        "maker": part.maker,
        "model": part.model,
        "passes": candidate.refusal.is_none(),
        "reason": candidate.refusal.as_ref().map(|refusal| sentence(&refusal.message)),
        "effective_load": shares.map(|shares| percent(shares.effective)),
        "peak_load": shares.map(|shares| percent(shares.peak)),
        "regenerative_load": candidate.regenerative.map(percent),
        "inertia_ratio": shares.map(|shares| shares.inertia_ratio),
        "status": status(part.status),
        "grade": grade(part.evidence.grade),
        "resistor_w": candidate.resistor.as_ref().map(|resistor| resistor.demand.mean),
        "resistor": candidate.resistor.as_ref().and_then(|resistor| Some(resistor.part.as_ref()?.name())),
        "amplifier": candidate.amplifier.as_ref().map(Part::name),
        "entries": entries(&candidate.entries),
    })
}

fn gear(gear: &SizedGear) -> Json {
    let GearDuty { peak, mean, speed, mean_speed } = gear.duty;
    let candidate = |of: &GearCandidate| {
        let load = |asked: f64, has: Option<f64>| has.map(|has| percent(asked / has));
        json!({
            "maker": of.part.maker, "model": of.part.model, "passes": of.reason.is_none(),
            "reason": of.refusal().map(|refusal| sentence(&refusal)),
            "mean_load": load(mean, of.ratings.rated_torque), "peak_load": load(peak, of.ratings.peak_torque),
            "mean_speed_load": load(mean_speed, of.ratings.rated_speed), "speed_load": load(speed, of.ratings.top_speed),
            "status": status(of.part.status), "grade": grade(of.part.evidence.grade), "entries": entries(&of.entries),
        })
    };
    json!({
        "ratio": gear.ratio, "mean_torque_nm": mean, "peak_torque_nm": peak, "mean_input_rpm": mean_speed, "input_rpm": speed,
        "next_ratios": gear.next_ratios, "candidates": gear.candidates.iter().map(candidate).collect::<Vec<_>>(),
    })
}

/// Entries of the form with a part, by the ids of the fields.
fn entries(of: &[FieldEntry]) -> serde_json::Map<String, Json> {
    of.iter().map(|entry| (entry.field.to_owned(), Json::from(entry.text.as_str()))).collect()
}

fn event(row: &EnvelopeRow) -> Json {
    json!({
        "event": row.event.id(), "id": row.quantity.id(), "value": row.value, "unit": row.unit,
        "limit": row.limit.map(Limit::value), "bound": row.limit.map(Limit::bound),
        "verdict": verdict_word(row.verdict), "worst": row.is_worst, "knob_percent": row.knob, "feed_percent": row.feed, "more_than_value": row.is_truncated,
    })
}

fn holding_limit(of: &HoldingLimit) -> Json {
    json!({
        "id": of.quantity.id(), "value": of.value, "unit": of.unit, "more_than_value": of.is_truncated,
        "field": of.entry.as_ref().map(|entry| entry.field), "entry": of.entry.as_ref().map(|entry| entry.text.as_str()),
    })
}

fn limit(row: &Growth) -> Json {
    json!({
        "quantity": row.field, "limit": row.binding.map(|binding| binding.id), "margin": row.holds.then_some(row.margin),
        "value": row.holds.then_some(row.value), "unit": row.unit, "more_is_unused": row.more_is_unused,
        "fails_with_less_too": ids(&row.failing_anyway),
    })
}

fn fastest(fastest: &Fastest) -> Json {
    json!({
        "line_speed": fastest.value, "unit": fastest.unit, "result": fastest.result.id, "binding": fastest.binding.id,
        "field": fastest.entry.field, "entry": fastest.entry.text, "fails_with_less_too": ids(&fastest.failing_anyway),
    })
}

fn ids(results: &[ResultName]) -> Vec<&'static str> {
    results.iter().map(|result| result.id).collect()
}

fn flip(flip: &Flip) -> Json {
    json!({
        "input": flip.field, "result": flip.readout, "factor": flip.factor,
        "flips": { "from": verdict_word(flip.from), "to": verdict_word(flip.to) },
    })
}

fn tornado(of: &Tornado) -> Json {
    let bar = |swing: &Swing| json!({ "input": swing.field, "low": percent(swing.low), "high": percent(swing.high) });
    json!({ "result": of.readout.id, "limit_use": percent(of.share), "bars": of.swings.iter().map(bar).collect::<Vec<_>>() })
}

fn terminal(row: &TerminalRow) -> Json {
    json!({ "terminal": row.terminal, "signal": row.signal, "from": row.from.text(), "to": row.to.text() })
}

fn bill(row: &BillRow) -> Json {
    let open: Vec<String> = row.open.iter().map(sentence).collect();
    let open = (!open.is_empty()).then(|| open.join(" · "));
    json!({
        "item": words(row.item.name()), "axis": row.axis.map(words), "part": row.part(), "maker": row.maker, "model": row.model, "asked": row.asked, "proposal": row.proposed,
        "quantity": row.quantity, "refused": row.refusal.as_ref().map(sentence), "open": open, "status": status(row.status), "grade": grade(row.grade), "source": row.source,
    })
}

/// Number of motors listed for an axis: passing ones, and the first that do not.
const SHOWN: usize = 8;

impl Sizing {
    /// The sizing as lines.
    pub fn text(&self) -> String {
        let rows = |sheet: &Sheet| if sheet.kind == SheetKind::Choice { SHOWN } else { usize::MAX };
        self.sheets().iter().map(|sheet| sheet_text(sheet, rows(sheet))).collect()
    }
}

/// A sheet as lines: its title, and at most `rows` of its rows.
pub fn sheet_text(sheet: &Sheet, rows: usize) -> String {
    let mut out = format!("{}\n", words(sheet.title));
    for row in sheet.rows.iter().take(rows) {
        let cells: Vec<&str> = row.cells.iter().map(String::as_str).filter(|cell| !cell.is_empty()).collect();
        out += &format!("  {}\n", cells.join("  "));
    }
    out.push('\n');
    out
}
