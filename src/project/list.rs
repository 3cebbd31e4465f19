//! Machines, controls and results as lists: for people and for programs.

use serde_json::{Value as Json, json};

use crate::controls;
use crate::controls::options::SwitchOption;
use crate::machines;
use crate::machines::examples::Example;
use crate::text::catalog::{number_text, sentence, words};
use crate::text::number::Fixed;
use crate::view::{Limit, Readout, Verdict};

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
            "volts": c.bench.volts_full, "output_bits": c.bench.output_bits, "ramp_s": c.bench.ramp },
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

/// The same for people.
pub fn text() -> String {
    let mut out = String::from("machines\n");
    for machine in machines::ALL {
        let name = words(machine.name());
        out += &format!("  {:<20} {name}; controls: {}\n", machine.id(), machine.controls().join(", "));
        out += &format!("  {:<20} examples, the first that of a new project:\n", "");
        for example in machine.examples() {
            out += &format!("  {:<20}   {:<15} {}\n", "", example.id, words(example.about));
        }
    }
    out += "controls\n";
    for control in controls::ALL {
        let bench = &control.bench;
        out += &format!("  {:<20} {}\n", control.id, control.name);
        let axes = bench.axes.iter().map(|a| {
            let unit = if rotary(control, a.letter) { "°/min" } else { "mm/min" };
            format!("{} to {} {unit}", a.letter, number_text(a.clamp, 3))
        });
        out += &format!(
            "  {:<20} bench: {}; spindle {} r/min at {} V, ramp {} s\n",
            "",
            axes.collect::<Vec<_>>().join(", "),
            number_text(bench.gears.first().copied().unwrap_or(0.0), 3),
            number_text(bench.volts_full, 3),
            number_text(bench.ramp, 3),
        );
        out += &format!("  {:<20} switches, each with the ids of its settings, the default first:\n", "");
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
        return "any text".to_owned();
    }
    switch.options().iter().map(|option| option.id).collect::<Vec<_>>().join(" | ")
}

/// A verdict as it is written.
pub fn verdict_word(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::None => "none",
        Verdict::Ok => "ok",
        Verdict::Warn => "warn",
        Verdict::Fail => "fail",
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

/// Results as lines: verdict, label, value, unit, limit, advice.
pub fn readouts_text(readouts: &[Readout]) -> String {
    let mut out = String::new();
    for r in readouts {
        let label = words(r.label);
        let value = Fixed(r.value, r.decimals).to_string();
        let limit = r.limit.map_or(String::new(), |limit| {
            let shown = number_text(limit.value(), r.decimals.max(3));
            format!("  ({})", sentence(&limit.message(shown)))
        });
        let sign = match r.verdict {
            Verdict::None => "   -",
            Verdict::Ok => "  ok",
            Verdict::Warn => "warn",
            Verdict::Fail => "FAIL",
        };
        out += &format!("{sign}  {label:<38} {value:>14} {}{limit}\n", r.unit);
        for advice in &r.advice {
            out += &format!("        {}\n", sentence(&advice.message));
        }
    }
    out
}
