//! Machines, controls and results as lists: for people and for programs.

use serde_json::{Value as Json, json};

use crate::controls;
use crate::controls::options::SwitchOption;
use crate::machines;
use crate::machines::machine::Example;
use crate::msg;
use crate::text::catalog::{number_text, sentence, words};
use crate::text::columns::{columns, left, right};
use crate::text::listed;
use crate::text::number::Fixed;
use crate::view::{Limit, Readout, Repair, Repairs, Verdict};

/// Machines with their controls, controls with their bench plant and their open points, as an object.
pub fn json() -> Json {
    let say = |id| words(id);
    let example = |e: &Example| json!({ "id": e.id, "name": say(e.name), "about": say(e.about), "fails": e.faults.iter().map(|fault| fault.result).collect::<Vec<_>>() });
    let machine = |m: &&dyn machines::AnyMachine| {
        let examples: Vec<Json> = m.examples().iter().map(example).collect();
        json!({ "id": m.id(), "name": say(m.name()), "controls": m.controls(), "examples": examples })
    };
    let switch = |s: &controls::Switch| {
        let option = |o: &SwitchOption| json!({ "id": o.id, "label": words(o.label) });
        let options: Vec<Json> = s.options().iter().map(option).collect();
        json!({ "id": s.id(), "text": s.text(), "default": s.default(), "options": options })
    };
    let control = |c: &&controls::Control| {
        let axes: Vec<Json> = c
            .bench
            .axes
            .iter()
            .map(|a| json!({ "axis": a.letter.to_string(), "rotary": rotary(c, a.letter), "rapid": a.rapid, "clamp": a.clamp, "time_constant_s": a.time_constant, "position_gain": a.position_gain }))
            .collect();
        json!({ "id": c.id, "name": c.name, "bench": {
            "axes": axes, "speed_at_full": c.bench.gears.first(), "gears": c.bench.gears, "speed_clamp": c.bench.speed_clamp,
            "volts": c.analog_output.volts, "output_bits": c.analog_output.bits, "ramp_s": c.bench.ramp },
            "switches": c.switches.iter().map(switch).collect::<Vec<_>>() })
    };
    json!({
        "machines": machines::ALL.iter().map(machine).collect::<Vec<_>>(),
        "controls": controls::ALL.iter().map(control).collect::<Vec<_>>(),
    })
}

/// Whether an axis of the bench turns.
fn rotary(control: &controls::Control, letter: controls::Address) -> bool {
    control.axis(letter).is_some_and(|at| control.axes[at].rotary)
}

/// Machines and controls as text for people.
pub fn text() -> String {
    let mut out = format!("{}\n", words("project.list.machines"));
    for machine in machines::ALL {
        let about =
            msg!("project.list.machine", machine = words(machine.name()), controls = listed(machine.controls()));
        out += &format!("  {:<20} {}\n", machine.id(), sentence(&about));
        out += &format!("  {:<20} {}\n", "", words("project.list.examples"));
        for example in machine.examples() {
            out += &format!("  {:<20}   {:<15} {}\n", "", example.id, words(example.about));
        }
    }
    out += &format!("{}\n", words("project.list.controls"));
    for control in controls::ALL {
        let bench = &control.bench;
        out += &format!("  {:<20} {}\n", control.id, control.name);
        let axes = bench.axes.iter().map(|a| {
            let unit = if rotary(control, a.letter) { "°/min" } else { "mm/min" };
            sentence(&msg!("project.list.axis", axis = a.letter.to_string(), clamp = a.clamp, unit))
        });
        let full = bench.gears.first().copied().unwrap_or(0.0);
        let (volts, ramp) = (control.analog_output.volts, bench.ramp);
        let message = msg!("project.list.bench", axes = listed(axes), speed = full, volts, ramp);
        out += &format!("  {:<20} {}\n", "", sentence(&message));
        out += &format!("  {:<20} {}\n", "", words("project.list.switches"));
        for switch in control.switches {
            out += &format!("  {:<20}   {:<23} {}\n", "", switch.id(), switch.text());
            for option in switch.options() {
                out += &format!("  {:<20}     {:<21} {}\n", "", option.id, words(option.label));
            }
        }
    }
    out
}

/// Ids of the settings of a switch, the default first.
pub fn switch_values(switch: &controls::Switch) -> String {
    if switch.is_text() {
        return words("project.any-text").to_owned();
    }
    switch.options().iter().map(|option| option.id).collect::<Vec<_>>().join(" | ")
}

/// Id of a verdict in JSON.
pub fn verdict_word(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::None => "none",
        Verdict::Ok => "ok",
        Verdict::Warn => "warn",
        Verdict::Fail => "fail",
    }
}

/// A verdict as a word of the language in use.
pub fn verdict_text(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::None => words("project.verdict.none"),
        Verdict::Ok => words("project.verdict.ok"),
        Verdict::Warn => words("project.verdict.warn"),
        Verdict::Fail => words("project.verdict.fail"),
    }
}

/// Results as a list of objects.
pub fn readouts_json(readouts: &[Readout]) -> Json {
    let readout = |r: &Readout| {
        let advice: Vec<String> = r.advice.iter().map(|advice| sentence(&advice.message)).collect();
        json!({
            "id": r.id, "value": r.value, "unit": r.unit,
            "limit": r.limit.map(Limit::value), "bound": r.limit.map(Limit::bound),
            "verdict": verdict_word(r.verdict), "formula": r.formula, "advice": advice,
        })
    };
    Json::Array(readouts.iter().map(readout).collect())
}

/// The changes with which the failing results hold, as an object.
pub fn repairs_json(repairs: &Repairs) -> Json {
    let change = |change: &Repair| {
        let sets: serde_json::Map<String, Json> =
            change.entries.iter().map(|entry| (entry.field.to_owned(), json!(entry.text))).collect();
        json!({ "change": sentence(&change.text), "sets": sets })
    };
    let changes: Vec<Json> = repairs.changes.iter().map(change).collect();
    let new_warnings: Vec<&str> = repairs.new_warnings.iter().map(|(id, _)| *id).collect();
    json!({
        "changes": changes, "still_failing": repairs.still_failing, "errors": repairs.errors, "new_warnings": new_warnings,
    })
}

/// The changes with which the failing results hold, as a line; empty without one.
pub fn repairs_text(repairs: &Repairs) -> String {
    repairs.messages().iter().map(|message| sentence(message) + "\n").collect()
}

/// Results as lines: verdict, label, value, unit, limit, advice.
pub fn readouts_text(readouts: &[Readout]) -> String {
    let mut out = String::new();
    let signs = [verdict_text(Verdict::Ok), verdict_text(Verdict::Warn), words("project.verdict.sign-fail")];
    let signs = signs.into_iter().map(columns).max().unwrap_or(0);
    for r in readouts.iter().cloned().map(Readout::shown) {
        let label = words(r.label);
        let value = Fixed(r.value, r.decimals_apart()).to_string();
        let limit = r.limit.map_or(String::new(), |limit| {
            let shown = number_text(limit.value(), r.decimals.max(3));
            format!("  {}", sentence(&msg!("project.list.limit", limit = sentence(&limit.message(shown)))))
        });
        let sign = match r.verdict {
            Verdict::None => "-",
            Verdict::Fail => words("project.verdict.sign-fail"),
            verdict => verdict_text(verdict),
        };
        let (sign, label) = (right(sign, signs), left(label, 38));
        out += &format!("{sign}  {label} {value:>14} {}{limit}\n", r.unit);
        for advice in &r.advice {
            out += &format!("{:signs$}    {}\n", "", sentence(&advice.message));
        }
    }
    out
}
