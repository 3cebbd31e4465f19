//! What the machine builder sets beside the program: parameters, registers between PLC and control, and the ladder of figure 1.

use super::params::{OverrideForm, Params, Wait, YUnit};
use super::program::INPUT;
use super::show;
use crate::controls::interface::SignalRole;
use crate::controls::{Control, ParamDef, ParamRole, Switches};
use crate::text::catalog::{Language, words};
use crate::text::number::Plain;
use crate::text::{Citation, Grade};
use crate::view::ladder::{Contact, Rung};
use crate::view::{Row, Sheet};

/// All sheets.
pub(super) fn sheets(p: &Params, control: &Control, switches: &Switches) -> Vec<Sheet> {
    let device = |role| device(control, switches, role);
    vec![parameters(p, control), interface(p, device), ladder(p, device)]
}

fn say(id: &'static str) -> String {
    words(Language::English, id).to_owned()
}

fn row(cells: impl Into<Vec<String>>, cite: Citation) -> Row {
    Row { cells: cells.into(), grade: cite.grade, source: cite.source }
}

/// Parameters with their values for this project.
fn parameters(p: &Params, control: &Control) -> Sheet {
    let degrees = p.y_unit == YUnit::Degrees;
    let per_axis = |x: f64, y: f64| vec![("X", show(x, 3)), ("Y", show(y, 3))];
    let one = |value: String| vec![("", value)];
    let values: Vec<(ParamRole, Vec<(&str, String)>)> = vec![
        (ParamRole::SpindleCount, one("1".to_owned())),
        (ParamRole::SpindleConnection, one("2".to_owned())),
        (ParamRole::SpindleLimit, one(show(p.speed_at_10v, 3))),
        (ParamRole::SpindleMaximum, one(show(p.top_speed(), 3))),
        (ParamRole::SpindleMinimum, one("0".to_owned())),
        (ParamRole::SpindleEncoder, one("0".to_owned())),
        (ParamRole::AxisRotary, vec![("X", "0".to_owned()), ("Y", u8::from(degrees).to_string())]),
        (ParamRole::AxisRapid, per_axis(p.rapid_x, p.rapid_y)),
        (ParamRole::AxisClamp, per_axis(p.clamp_x, p.clamp_y)),
        (ParamRole::AxisAcceleration, vec![("X", "11".to_owned()), ("Y", "11".to_owned())]),
        (ParamRole::AxisTimeConstant, per_axis(p.time_constant_x, p.time_constant_y)),
        (ParamRole::AxisPositionGain, per_axis(p.position_gain_x, p.position_gain_y)),
        (ParamRole::AxisInPosition, per_axis(p.in_position, p.in_position)),
        (ParamRole::AxisSoftLimits, vec![("X", "0 / 0".to_owned()), ("Y", "0 / 0".to_owned())]),
        (ParamRole::CommandUnit, one("10".to_owned())),
        (ParamRole::FeedOneDigit, one("0".to_owned())),
        (ParamRole::VariablesAtReset, one("0".to_owned())),
        (ParamRole::VariablesAtPowerOn, one("0".to_owned())),
        (ParamRole::EditLock, one("0".to_owned())),
        (ParamRole::MacroSingle, one("0".to_owned())),
    ];
    let rows = values
        .into_iter()
        .filter_map(|(role, values)| Some((control.param(role)?, values)))
        .flat_map(|(def, values)| values.into_iter().map(move |value| parameter(def, value, degrees)))
        .collect();
    Sheet {
        id: "parameters",
        title: "ribbon.sheet.parameters",
        columns: vec![
            "ribbon.sheet.number",
            "ribbon.sheet.name",
            "ribbon.sheet.axis",
            "ribbon.sheet.value",
            "ribbon.sheet.unit",
            "ribbon.sheet.meaning",
        ],
        rows,
        ladder: Vec::new(),
    }
}

fn parameter(def: &ParamDef, (axis, value): (&str, String), degrees: bool) -> Row {
    let unit = if degrees && axis == "Y" { def.unit.replace("mm", "°") } else { def.unit.to_owned() };
    row([def.number.to_owned(), def.name.to_owned(), axis.to_owned(), value, unit, def.text.to_owned()], def.cite)
}

/// A register's device, or a dash where the control has none for the role.
fn device(control: &Control, switches: &Switches, role: SignalRole) -> (String, Citation) {
    control.device(role, switches).unwrap_or_else(|| ("-".to_owned(), Citation::new("", Grade::Open)))
}

/// Registers between PLC and control: who writes, who reads, what for.
fn interface(p: &Params, device: impl Fn(SignalRole) -> (String, Citation)) -> Sheet {
    let (plc, nc, program) = (say("ribbon.plc.plc"), say("ribbon.plc.control"), say("ribbon.plc.program"));
    let number = |variable: u32| format!("#{variable}");
    let mut rows = Vec::new();
    let mut add = |role: SignalRole, variable: String, writes: &str, reads: &str, unit: &str, what: String| {
        let (device, cite) = device(role);
        rows.push(row([device, variable, writes.to_owned(), reads.to_owned(), unit.to_owned(), what], cite));
    };
    add(SignalRole::SpindleOverride, String::new(), &plc, &nc, "%", say("ribbon.plc.override"));
    let (unit, what) = match p.override_form {
        OverrideForm::Percent => ("%", say("ribbon.plc.percent")),
        OverrideForm::FinalSpeed => ("r/min", say("ribbon.plc.final")),
    };
    add(SignalRole::MacroInputLow(INPUT), number(INPUT), &plc, &program, unit, what);
    add(SignalRole::MacroInputHigh(INPUT), number(INPUT), &plc, &program, "", say("ribbon.plc.high"));
    add(SignalRole::FeedOverride, String::new(), &plc, &nc, "%", say("ribbon.plc.feed"));
    if p.override_form == OverrideForm::FinalSpeed {
        add(SignalRole::SpindleFinal, String::new(), &nc, &plc, "r/min", say("ribbon.plc.read-final"));
    }
    let open = Citation::new("devices of the ladder: the builder's", Grade::Open);
    let fin = match p.wait {
        Wait::Dwell => say("ribbon.plc.fin"),
        Wait::Fin => say("ribbon.plc.fin-at-speed"),
    };
    rows.push(row(["FIN".to_owned(), String::new(), plc.clone(), nc, String::new(), fin], open));
    if p.wait == Wait::Fin {
        let inverter = say("ribbon.plc.inverter");
        rows.push(row(
            ["SU".to_owned(), String::new(), inverter, plc, String::new(), say("ribbon.plc.at-speed")],
            open,
        ));
    }
    Sheet {
        id: "interface",
        title: "ribbon.sheet.interface",
        columns: vec![
            "ribbon.sheet.device",
            "ribbon.sheet.variable",
            "ribbon.sheet.writes",
            "ribbon.sheet.reads",
            "ribbon.sheet.unit",
            "ribbon.sheet.use",
        ],
        rows,
        ladder: Vec::new(),
    }
}

/// The rungs of the paper's figure 1, and FIN.
fn rungs(p: &Params, device: impl Fn(SignalRole) -> (String, Citation)) -> Vec<Rung> {
    let name = |role| device(role).0;
    let register = name(SignalRole::SpindleOverride);
    let (low, high) = (name(SignalRole::MacroInputLow(INPUT)), name(SignalRole::MacroInputHigh(INPUT)));
    let always = || vec![Contact::closes("ON")];
    let rung = |contacts, output: String, note| Rung { contacts, output, note: say(note) };
    let mut rungs = Vec::new();
    let step = p.knob_step.percent();
    if step > 1.0 {
        let (half, step) = (Plain((step / 2.0).floor(), 0), Plain(step, 3));
        rungs.push(rung(always(), format!("+ D100 K{half} D101"), "ribbon.ladder.half"));
        rungs.push(rung(always(), format!("/ D101 K{step} D102"), "ribbon.ladder.divide"));
        rungs.push(rung(always(), format!("* D102 K{step} D104"), "ribbon.ladder.multiply"));
        rungs.push(rung(always(), format!("MOV D104 {register}"), "ribbon.ladder.override"));
    } else {
        rungs.push(rung(always(), format!("MOV D100 {register}"), "ribbon.ladder.override"));
    }
    match p.override_form {
        OverrideForm::Percent => {
            rungs.push(rung(always(), format!("MOV {register} {low}"), "ribbon.ladder.low"));
            rungs.push(rung(always(), format!("MOV K0 {high}"), "ribbon.ladder.high"));
        }
        OverrideForm::FinalSpeed => {
            let from = name(SignalRole::SpindleFinal);
            rungs.push(rung(always(), format!("DMOV {from} {low}"), "ribbon.ladder.final"));
        }
    }
    let strobe = |device: &str| vec![Contact::closes(device)];
    rungs.push(rung(strobe("S STROBE"), "OUT FIN".to_owned(), "ribbon.ladder.fin"));
    match p.wait {
        Wait::Dwell => rungs.push(rung(strobe("M STROBE"), "OUT FIN".to_owned(), "ribbon.ladder.fin")),
        Wait::Fin => {
            let contacts = vec![Contact::closes("M STROBE"), Contact::closes("M03"), Contact::closes("SU")];
            rungs.push(rung(contacts, "OUT FIN".to_owned(), "ribbon.ladder.fin-at-speed"));
            let other = vec![Contact::closes("M STROBE"), Contact { device: "M03".to_owned(), inverted: true }];
            rungs.push(rung(other, "OUT FIN".to_owned(), "ribbon.ladder.fin"));
        }
    }
    rungs
}

/// Figure 1 as an instruction list, with its drawing.
fn ladder(p: &Params, device: impl Fn(SignalRole) -> (String, Citation)) -> Sheet {
    let ladder = rungs(p, device);
    let cite =
        Citation::new("paper, figure 1: R148 to R74; instructions by the usual list of the maker", Grade::Inferred);
    let mut rows = Vec::new();
    let mut add = |instruction: String, note: String| {
        let number = rows.len().to_string();
        rows.push(row([number, instruction, note], cite));
    };
    for rung in &ladder {
        for (at, contact) in rung.contacts.iter().enumerate() {
            let word = match (at, contact.inverted) {
                (0, false) => "LD",
                (0, true) => "LDI",
                (_, false) => "AND",
                (_, true) => "ANI",
            };
            add(format!("{word} {}", contact.device), String::new());
        }
        add(rung.output.clone(), rung.note.clone());
    }
    Sheet {
        id: "ladder",
        title: "ribbon.sheet.ladder",
        columns: vec!["ribbon.sheet.step", "ribbon.sheet.instruction", "ribbon.sheet.use"],
        rows,
        ladder,
    }
}
