//! Sheets for the machine builder: parameters, registers between PLC and control, and the ladder of figure 1.

use super::params::{OverrideForm, PrintAxis, Wait};
use super::program;
use super::resolved::RibbonLine;
use super::stops::reactions;
use crate::controls::ParamRole;
use crate::controls::interface::SignalRole;
use crate::machines::scaling;
use crate::machines::sheets::{self, AxisUnits, ParamValue, row, say};
use crate::machines::stops;
use crate::text::number::Plain;
use crate::text::{Citation, Grade};
use crate::view::Sheet;
use crate::view::ladder::{self, Contact, Rung};

/// All sheets.
pub(super) fn sheets(line: &RibbonLine) -> Vec<Sheet> {
    vec![parameters(line), interface(line), ladder(line), stops::sheet(&reactions(line))]
}

/// Parameters with their values for this project.
fn parameters(line: &RibbonLine) -> Sheet {
    let p = &line.p;
    let print: &str = &p.print_axis.address().to_string();
    let number = |value: f64| ParamValue::Number(value);
    let per_axis = |x: f64, y: f64| vec![("X", number(x)), (print, number(y))];
    let one = |setting: ParamValue| vec![("", setting)];
    let both = |on: bool| vec![("X", ParamValue::Answer(on)), (print, ParamValue::Answer(on))];
    // Axes whose coordinates roll over are rotary ones to the control, whatever their words count.
    let [pull_rolls, print_rolls] = line.rolls_over();
    let rolling: Vec<&str> = [("X", pull_rolls), (print, print_rolls)].into_iter().filter_map(rolls).collect();
    let each = |value: fn() -> ParamValue| rolling.iter().map(|axis| (*axis, value())).collect::<Vec<_>>();
    let mut turning: Vec<_> = each(|| ParamValue::Answer(true));
    if !print_rolls && p.print_axis != PrintAxis::Z {
        turning.push((print, ParamValue::Answer(false)));
    }
    let yes = |on: bool| one(ParamValue::Answer(on));
    let mut values = vec![
        (ParamRole::SpindleCount, yes(true)),
        (ParamRole::SpindleConnection, yes(true)),
        (ParamRole::SpindleLimit, one(number(p.speed_at_10v))),
        (ParamRole::SpindleMaximum, one(number(p.top_speed()))),
        (ParamRole::SpindleMinimum, one(number(0.0))),
        (ParamRole::SpindleEncoder, yes(p.spindle_encoder)),
        (ParamRole::AxisDiameter, vec![("X", ParamValue::Answer(line.pull_words() == 2))]),
        (ParamRole::AxisRotary, turning),
        (ParamRole::AxisRollOver, each(|| ParamValue::Answer(true))),
        (ParamRole::AxisRollDisplay, each(|| ParamValue::Answer(true))),
        (ParamRole::AxisShortWay, each(|| ParamValue::Answer(false))),
        (ParamRole::AxisTurn, each(|| ParamValue::Number(360.0))),
        (ParamRole::AxisRapid, per_axis(p.rapid_x, p.rapid_y)),
        (ParamRole::AxisClamp, per_axis(p.clamp_x, p.clamp_y)),
        (ParamRole::AxisAcceleration, both(true)),
        (ParamRole::AxisTimeConstant, per_axis(p.time_constant_x, p.time_constant_y)),
        (ParamRole::AxisPositionGain, per_axis(p.position_gain_x, p.position_gain_y)),
        (ParamRole::AxisInPosition, per_axis(p.in_position, p.in_position)),
        (ParamRole::AxisSoftLimits, both(false)),
        (ParamRole::CommandUnit, yes(true)),
        (ParamRole::FeedOneDigit, yes(false)),
        (ParamRole::VariablesAtReset, yes(false)),
        (ParamRole::VariablesAtPowerOn, yes(false)),
        (ParamRole::EditLock, yes(false)),
        (ParamRole::MacroSingle, yes(false)),
    ];
    values.extend(scaling::parameters(line.control, &line.drives(print)));
    let axes = AxisUnits { cross_words: f64::from(line.pull_words()), rotary: &rolling };
    sheets::parameters(line.control, &axes, values)
}

/// The axis, if it rolls over.
fn rolls((axis, rolls): (&str, bool)) -> Option<&str> {
    rolls.then_some(axis)
}

/// Registers between PLC and control, as far as the control has them: who writes, who reads, what for.
fn interface(line: &RibbonLine) -> Sheet {
    let (p, input) = (&line.p, line.input());
    let (plc, nc, text) = (say("ribbon.plc.plc"), say("ribbon.plc.control"), say("ribbon.plc.program"));
    let number = |variable: u32| format!("#{variable}");
    let mut rows = Vec::new();
    let mut add = |role: SignalRole, variable: String, writes: &str, reads: &str, unit: &str, what: String| {
        if let Some((device, cite)) = line.dialect.device(line.control, role) {
            rows.push(row([device, variable, writes.to_owned(), reads.to_owned(), unit.to_owned(), what], cite));
        }
    };
    add(SignalRole::SpindleOverride, String::new(), &plc, &nc, "%", say("ribbon.plc.override"));
    add(SignalRole::SpindleOverrideCode, String::new(), &plc, &nc, "", say("ribbon.plc.override-code"));
    let (unit, what) = match p.override_form {
        OverrideForm::Percent => ("%", say("ribbon.plc.percent")),
        OverrideForm::FinalSpeed => ("r/min", say("ribbon.plc.final")),
    };
    add(SignalRole::MacroInputLow(input), number(input), &plc, &text, unit, what);
    add(SignalRole::MacroInputHigh(input), number(input), &plc, &text, "", say("ribbon.plc.high"));
    let off = if program::overrides_can_be_off(line) { "ribbon.plc.feed" } else { "ribbon.plc.feed-acts" };
    add(SignalRole::FeedOverride, String::new(), &plc, &nc, "%", say(off));
    if p.override_form == OverrideForm::FinalSpeed {
        add(SignalRole::SpindleFinal, String::new(), &nc, &plc, "r/min", say("ribbon.plc.read-final"));
    }
    let open = Citation::new("devices of the ladder: the builder's", Grade::Open);
    if p.knob_is_locked() {
        let lock = say("ribbon.plc.override-locked");
        rows.push(row(["OVERRIDE".to_owned(), String::new(), plc.clone(), nc.clone(), "%".to_owned(), lock], LOCK));
    }
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
    for (device, writes, reads, what) in stop_signals(line) {
        let who = |writer: Side| match writer {
            Side::Plc => say("ribbon.plc.plc"),
            Side::Control => say("ribbon.plc.control"),
            Side::Machine => say("ribbon.plc.machine"),
        };
        rows.push(row([device.to_owned(), String::new(), who(writes), who(reads), String::new(), say(what)], SIGNALS));
    }
    sheets::interface(rows)
}

const LOCK: Citation = Citation::new("ribbon line facts, 8", Grade::Inferred);

const SIGNALS: Citation = Citation::new("ribbon line facts, 7; names of the signals", Grade::Sister);

/// Who writes or reads a signal.
#[derive(Clone, Copy)]
enum Side {
    Plc,
    Control,
    Machine,
}

/// Signals of the stops, by FANUC's names: device, writer, reader, use.
fn stop_signals(line: &RibbonLine) -> Vec<(&'static str, Side, Side, &'static str)> {
    let mut all = vec![
        ("STL", Side::Control, Side::Plc, "ribbon.plc.stl"),
        ("RST", Side::Control, Side::Plc, "ribbon.plc.rst"),
        ("DM30", Side::Control, Side::Plc, "ribbon.plc.dm30"),
        ("*SSTP", Side::Plc, Side::Control, "ribbon.plc.sstp"),
    ];
    if !line.in_step() {
        all.push(("*IT", Side::Plc, Side::Control, "ribbon.plc.it"));
    }
    all.push(("*ESP", Side::Machine, Side::Control, "ribbon.plc.esp"));
    all
}

/// Rungs that stop the unwinder with the axes, and hold the axes at the restart; the simulated PLC does the same by [`super::stops::unwinder`].
fn stop_rungs(line: &RibbonLine) -> Vec<Rung> {
    let closes = |device: &str| Contact::closes(device);
    let opens = |device: &str| Contact { device: device.to_owned(), inverted: true };
    let rung = |contacts, output: &str, note| Rung { contacts, output: output.to_owned(), note: say(note) };
    let mut rungs = vec![
        rung(vec![closes("STL")], "SET M200", "ribbon.ladder.runs"),
        rung(vec![closes("DM30")], "RST M200", "ribbon.ladder.ends"),
        rung(vec![closes("RST")], "RST M200", "ribbon.ladder.reset"),
        rung(vec![closes("M200"), opens("STL")], "OUT M201", "ribbon.ladder.interrupted"),
        rung(vec![opens("M201")], "OUT *SSTP", "ribbon.ladder.stop"),
    ];
    if line.in_step() {
        return rungs;
    }
    rungs.push(rung(vec![closes("M201")], "SET M202", "ribbon.ladder.wait"));
    let (tenths, note, up) = match line.p.wait {
        Wait::Dwell => ((line.p.dwell * 10.0).ceil().max(1.0), "ribbon.ladder.dwell", vec![closes("T20")]),
        // The inverter may report the speed 0 as reached until it sees the new one.
        Wait::Fin => (1.0, "ribbon.ladder.settle", vec![closes("T20"), closes("SU")]),
    };
    let timer = format!("OUT T20 K{}", Plain(tenths, 0));
    rungs.push(rung(vec![closes("M202"), opens("M201")], &timer, note));
    rungs.push(rung(up, "RST M202", "ribbon.ladder.waited"));
    rungs.push(rung(vec![closes("RST")], "RST M202", "ribbon.ladder.reset"));
    rungs.push(rung(vec![opens("M202")], "OUT *IT", "ribbon.ladder.axes"));
    rungs
}

/// The rungs of the paper's figure 1, and FIN; rungs need a register of the control.
fn rungs(line: &RibbonLine) -> Vec<Rung> {
    let p = &line.p;
    let name = |role| line.dialect.device(line.control, role).map(|(device, _)| device);
    let register = name(SignalRole::SpindleOverride);
    let (low, high) = (name(SignalRole::MacroInputLow(line.input())), name(SignalRole::MacroInputHigh(line.input())));
    let low = low.unwrap_or_else(|| format!("#{}", line.input()));
    let always = || vec![Contact::closes("ON")];
    let rung = |contacts, output: String, note| Rung { contacts, output, note: say(note) };
    let mut rungs = Vec::new();
    let step = p.knob_step.percent();
    let mut knob = "D100".to_owned();
    if step > 1.0 {
        let (half, step) = (Plain((step / 2.0).floor(), 0), Plain(step, 3));
        rungs.push(rung(always(), format!("+ D100 K{half} D101"), "ribbon.ladder.half"));
        rungs.push(rung(always(), format!("/ D101 K{step} D102"), "ribbon.ladder.divide"));
        rungs.push(rung(always(), format!("* D102 K{step} D104"), "ribbon.ladder.multiply"));
        knob = "D104".to_owned();
    }
    if p.knob_is_locked() {
        let target = register.unwrap_or_else(|| "OVERRIDE".to_owned());
        let free = vec![Contact { device: "M200".to_owned(), inverted: true }];
        rungs.push(rung(free, format!("MOV {knob} {target}"), "ribbon.ladder.override"));
        rungs.push(rung(vec![Contact::closes("M200")], format!("MOV K100 {target}"), "ribbon.ladder.locked"));
    } else if let Some(register) = register {
        rungs.push(rung(always(), format!("MOV {knob} {register}"), "ribbon.ladder.override"));
        knob = register;
    }
    match (p.override_form, name(SignalRole::SpindleFinal)) {
        (OverrideForm::FinalSpeed, Some(from)) => {
            rungs.push(rung(always(), format!("DMOV {from} {low}"), "ribbon.ladder.final"));
        }
        _ if line.handed().is_none() => {}
        _ => {
            let note = if high.is_some() { "ribbon.ladder.low" } else { "ribbon.ladder.word" };
            rungs.push(rung(always(), format!("MOV {knob} {low}"), note));
            if let Some(high) = high {
                rungs.push(rung(always(), format!("MOV K0 {high}"), "ribbon.ladder.high"));
            }
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
    rungs.extend(stop_rungs(line));
    rungs
}

/// Figure 1 as an instruction list, with its drawing.
fn ladder(line: &RibbonLine) -> Sheet {
    let rungs = rungs(line);
    let cite = Citation::new(
        "ribbon dot-printing paper, figure 1: R148 to R74; instructions by the usual list of the maker",
        Grade::Inferred,
    );
    let mut rows = Vec::new();
    let mut add = |instruction: String, note: String| {
        let number = rows.len().to_string();
        rows.push(row([number, instruction, note], cite));
    };
    for rung in &rungs {
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
        columns: vec!["ribbon.sheet.step", "ribbon.sheet.instruction", "sheet.use"],
        rows,
        drawing: ladder::svg(&rungs),
    }
}
