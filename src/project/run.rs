//! A run from its beginning to its end: of a project, or of bare programs on the control's bench.

use std::rc::Rc;

use serde_json::{Map, Value as Json, json};

use super::program::Written;
pub use super::setting::Setting;
use super::{Project, io_names};
use crate::controls::{Control, Dialect, Syntax, VarKind};
use crate::interp::canon::{AXES, Line};
use crate::interp::world::MachineAtRest;
use crate::interp::{End, Interp, StartProgram, Step};
use crate::machines::ControlContext;
use crate::motion::{
    Action, AxisPlant, AxisState, BenchPlc, Budget, Event, PMC_AXES, Panel, Planner, Plant, Plc, Retention, RunEnd,
    Setup, SpindlePlant,
};
use crate::msg;
use crate::nc::Parsed;
use crate::text::catalog::{number_text, sentence, words};
use crate::text::{Diagnostic, clauses};

/// A planned run of the interpreter.
pub type Run = Planner<Interp>;

/// Steps that the program which sets the project's values may take.
const SETUP_STEPS: u32 = 100_000;

/// Events that are planned at a time.
const SLICE: usize = 4096;

/// A variable as the control's screen shows it at time `t` (s); `None` is vacant. A bit of the PLC interface is taken from its word; words
/// that were never written are 0.
pub fn shown(run: &Run, control: &Control, number: u32, t: f64) -> Option<f64> {
    run.variable_at(number, t).or_else(|| match control.var(number)?.kind {
        VarKind::InputBit | VarKind::OutputBit => {
            let (word, bit) = control.word_of_bit(number)?;
            Some((run.variable_at(word, t).unwrap_or(0.0) as i64 >> bit & 1) as f64)
        }
        VarKind::InputWord(_) | VarKind::OutputWord(_) | VarKind::ExchangeWord => Some(0.0),
        _ => None,
    })
}

/// Variables that the operator sets: before the start, and at the panel.
pub fn set_by_operator(settings: &[Setting], panel: &Panel, control: &Control) -> Vec<u32> {
    let events = panel.events().iter().filter_map(|event| match event.action {
        Action::Variable(number, Some(_)) => Some(number),
        _ => None,
    });
    settings.iter().filter_map(|setting| setting.number(control)).chain(events).collect()
}

/// The number of a program from its name, with or without a letter of the control: `O9101`, `9101`, `o9101.nc`.
pub fn program_number(name: &str, syntax: &Syntax) -> Option<u32> {
    let stem = name.split('.').next()?.to_ascii_uppercase();
    let of_number =
        stem.strip_prefix(|c: char| u8::try_from(c).is_ok_and(|byte| syntax.program_letters.contains(&byte)));
    let of_name = || syntax.names()?.numbered.iter().find_map(|letters| stem.strip_prefix(letters));
    of_number.or_else(of_name).unwrap_or(&stem).parse().ok()
}

/// The program that a text names: `O9101`, or a name where programs have names.
pub fn program_meant(name: &str, parsed: &Parsed) -> Option<StartProgram> {
    match parsed.control().syntax.names() {
        Some(_) => parsed.deck().program_named(name.split('.').next()?).map(StartProgram::Nth),
        None => program_number(name, &parsed.control().syntax).map(StartProgram::Program),
    }
}

/// Options of a run.
pub struct RunOptions<'a> {
    /// Program to start; without it the main program, or the first program of the first file.
    pub start: Option<StartProgram>,
    /// Variables and inputs set before the start; those that the control lacks are left out ([`Setting::action`]).
    pub settings: &'a [Setting],
    /// Budgets.
    pub limits: Budget,
    /// Parts of the run that are kept.
    pub keep: Retention,
}

/// The run of a project: its values are set by its own setup program, then its main program starts on its plant.
pub fn of_project(project: &Project, written: &Written, begin: &RunOptions) -> Run {
    let start = begin.start.unwrap_or(StartProgram::Program(written.main));
    let mut interp = Interp::new(Rc::clone(&written.parsed), start);
    let unset = set_up(&mut interp, project, written);
    let machine = project.prepared();
    started((interp, unset), (&machine.plant(), machine.plc()), panel_of(project), begin)
}

/// The operator's actions of a run: the form sets the knob, which the operator may turn later.
fn panel_of(project: &Project) -> Panel {
    let knob = project.prepared().panel().spindle_override;
    let knob = knob.map(|percent| Event { t: 0.0, action: Action::SpindleOverride(percent) });
    Panel::new(knob.into_iter().chain(project.panel.events().iter().cloned()))
}

/// Replans the run of a project, begun without settings, from the earliest changed action of the operator. Returns false if the run keeps
/// no checkpoint to go back to.
pub fn replan(run: &mut Run, project: &Project) -> bool {
    let dialect = Rc::clone(run.program().parsed().dialect());
    run.replace_panel(io_names::panel(&panel_of(project), project.control, &dialect))
}

/// The run of bare programs, with the switches that they were read with: on the control's bench, or on the plant of a project.
pub fn of_programs(parsed: Rc<Parsed>, plant: Option<&Project>, panel: Panel, begin: &RunOptions) -> Run {
    let control = parsed.control();
    let start = begin.start.unwrap_or_default();
    let (switches, dialect) = (parsed.switches().clone(), Rc::clone(parsed.dialect()));
    let interp = Interp::new(parsed, start);
    let (plant, plc) = match plant {
        Some(project) => {
            let machine = project.machine.prepare(&project.values, ControlContext { control, switches: &switches });
            (machine.plant(), machine.plc())
        }
        None => bench(control, &dialect),
    };
    started((interp, None), (&plant, plc), panel, begin)
}

/// Begins a run of a program, with a finding about its values, on a plant with its PLC.
fn started(
    (mut interp, unset): (Interp, Option<Diagnostic>),
    (plant, plc): (&Plant, Box<dyn Plc>),
    mut panel: Panel,
    begin: &RunOptions,
) -> Run {
    let control = interp.control();
    let dialect = Rc::clone(interp.parsed().dialect());
    for setting in begin.settings {
        match setting.action(control, &dialect) {
            Some(Action::Variable(number, value)) => drop(interp.set_variable(number, value)),
            // Inputs are written by the PLC, so they are forced from the start.
            Some(action) => {
                panel.add(Event { t: 0.0, action });
            }
            None => {}
        }
    }
    let panel = io_names::panel(&panel, control, &dialect);
    let findings = unset.into_iter().collect();
    Planner::new(Setup {
        program: interp,
        control,
        plant,
        plc,
        panel,
        limits: begin.limits,
        keep: begin.keep,
        findings,
    })
}

/// Sets the variables to the values of the project's setup program, run on a machine at rest. Returns the alarm with which it ends, or a
/// finding if it does not end: the variables behind that block are not set.
fn set_up(interp: &mut Interp, project: &Project, written: &Written) -> Option<Diagnostic> {
    let number = written.setup?;
    let mut setup = Interp::new(Rc::clone(&written.parsed), StartProgram::Program(number));
    let mut world = MachineAtRest::default();
    let ended = (0..SETUP_STEPS).find_map(|_| match setup.step(&mut world) {
        Step::Ended(end) => Some(end),
        _ => None,
    });
    let unset = match ended {
        Some(End::Alarm(alarm)) => Some(*alarm),
        Some(_) => None,
        None => Some(Diagnostic::error(msg!("run.endless-setup", steps = SETUP_STEPS))),
    };
    for row in project.control.vars.iter().filter(|row| matches!(row.kind, VarKind::Common | VarKind::Retained)) {
        for number in row.first..=row.last {
            if let Some(value) = setup.variable(number) {
                interp.set_variable(number, Some(value));
            }
        }
    }
    unset
}

/// The bench of a control as a plant with its PLC.
fn bench(control: &'static Control, dialect: &Dialect) -> (Plant, Box<dyn Plc>) {
    let bench = &control.bench;
    let axes = bench.axes.iter().map(|axis| AxisPlant {
        letter: Some(axis.letter),
        rotary: control.axis(axis.letter).is_some_and(|at| control.axes[at].rotary),
        endless: control.axis(axis.letter).is_some_and(|at| dialect.is_rotary(at)),
        diameter: control.axis(axis.letter).is_some_and(|at| dialect.counts_diameters(at)),
        rapid: axis.rapid,
        clamp: axis.clamp,
        time_constant: axis.time_constant,
        position_gain: axis.position_gain,
        home: 0.0,
    });
    let plant = Plant {
        axes: axes.collect(),
        pmc: Vec::new(),
        spindle: SpindlePlant::bench(control, dialect.spindle()),
        block_time: control.timing.block,
        macro_time: control.timing.macro_block,
        preread: control.timing.preread,
        in_position: bench.in_position,
        stock: 0.0,
    };
    (plant, Box::new(BenchPlc::new(bench, &dialect.spindle())))
}

/// End of a run and its results.
pub struct RunSummary {
    /// Reason of the end.
    pub ended: RunEnd,
    /// Blocks read.
    pub blocks: u64,
    /// Machine time in seconds at which the program ended or stopped.
    pub time: f64,
    /// Machine time in seconds at which axes and spindle had settled after `time`.
    pub standstill: f64,
    /// Alarms and remarks of the run.
    pub diagnostics: Vec<Diagnostic>,
    /// Variables that are set, by the control's names, in the order of their numbers.
    pub variables: Vec<(String, f64)>,
    /// Commanded positions at standstill as words count them, by axis letter, mm or degrees.
    pub axes: Vec<(char, f64)>,
    /// The program's reference point: where the axes were at the last G50 or G92, by axis letter as words count it in the machine frame.
    pub reference: Option<Vec<(char, f64)>>,
    /// The spindle at standstill.
    pub spindle: crate::motion::SpindleState,
    /// Axes that the PLC turns, where the machine [names](RunSummary::with_turned) them.
    pub turned: Vec<TurnedAxis>,
    /// The axes of the PLC at standstill.
    pmc: [AxisState; PMC_AXES],
}

/// An axis that the PLC turns, at the end of a run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TurnedAxis {
    /// Name of the axis, for instance `work`.
    pub name: &'static str,
    /// Speed in r/min, signed.
    pub rpm: f64,
    /// Angle in degrees, from 0 to 360.
    pub angle: f64,
}

/// Plans a run until a time (s) or to its end; returns the reason of the end.
pub(in crate::project) fn plan(run: &mut Run, until: f64) -> Option<RunEnd> {
    while run.timeline().end() < until {
        if let Some(ended) = run.advance(until, SLICE).ended {
            return Some(ended);
        }
    }
    None
}

/// Plans a run to its end.
pub(in crate::project) fn finish(run: &mut Run) -> RunEnd {
    loop {
        if let Some(ended) = run.advance(f64::INFINITY, SLICE).ended {
            return ended;
        }
    }
}

/// Reaction of a run to a stop of the program (M00, M01, a message).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AtStop {
    /// The run is over.
    End,
    /// Cycle start is pressed at once.
    CycleStart,
}

/// Runs to the end and hands every command, as a line of the canonical log, to `log` as it begins. Fails only where `log` does.
pub fn to_end<E>(run: &mut Run, at_stop: AtStop, mut log: impl FnMut(Line) -> Result<(), E>) -> Result<RunSummary, E> {
    let names = run.program().names();
    let mut answered = None;
    let ended = loop {
        let progress = run.advance(f64::INFINITY, SLICE);
        for (_, canon, _) in run.take_log() {
            log(canon.line(names))?;
        }
        let Some(ended) = progress.ended else { continue };
        let blocks = run.blocks();
        let here = Some((blocks.nc, blocks.macros));
        // A stop that cycle start does not end waits for something else.
        if ended != RunEnd::Stop || at_stop == AtStop::End || answered == here {
            break ended;
        }
        answered = here;
        let t = run.ended_at().unwrap_or(progress.planned_to);
        run.event(Event { t, action: Action::Start });
    };
    let standstill = run.timeline().end();
    let (last, words) = (run.timeline().at(standstill), run.timeline().words_at(standstill));
    let blocks = run.blocks();
    let lettered =
        |words: [f64; AXES]| names.axes.iter().zip(words).map(|(row, at)| (row.letter.byte().into(), at)).collect();
    Ok(RunSummary {
        ended,
        blocks: blocks.nc + blocks.macros,
        time: run.ended_at().unwrap_or(standstill),
        standstill,
        diagnostics: run.diagnostics().to_vec(),
        variables: run.program().variables().collect(),
        axes: lettered(words),
        reference: run.reference_point().map(lettered),
        spindle: last.spindle,
        turned: Vec::new(),
        pmc: last.pmc,
    })
}

impl RunSummary {
    /// With the axes that the PLC turns, by their names in the order of the plant.
    pub fn with_turned(mut self, names: &[&'static str]) -> RunSummary {
        let axis = |(name, axis): (&&'static str, &AxisState)| TurnedAxis {
            name,
            rpm: axis.feed / 360.0,
            angle: axis.actual.rem_euclid(360.0),
        };
        self.turned = names.iter().zip(&self.pmc).map(axis).collect();
        self
    }

    /// Id of the end's reason in JSON.
    pub fn word(&self) -> &'static str {
        match self.ended {
            RunEnd::ProgramEnd => "program-end",
            RunEnd::Stop => "stop",
            RunEnd::Alarm(_) => "alarm",
            RunEnd::Blocks => "blocks",
            RunEnd::Seconds => "seconds",
        }
    }

    /// The end as an object, without diagnostics and log.
    pub fn json(&self) -> Json {
        let variables: Map<String, Json> =
            self.variables.iter().map(|(name, value)| (name.clone(), json!(value + 0.0))).collect();
        let places = |axes: &[(char, f64)]| -> Map<String, Json> {
            axes.iter().map(|(axis, at)| (axis.to_string(), json!(clean(*at)))).collect()
        };
        let turned: Map<String, Json> = self
            .turned
            .iter()
            .map(|axis| (axis.name.to_owned(), json!({ "rpm": clean(axis.rpm), "angle_deg": clean(axis.angle) })))
            .collect();
        let mut end = json!({
            "ended": self.word(),
            "blocks": self.blocks,
            "time_s": clean(self.time),
            "standstill_s": clean(self.standstill),
            "diagnostics": [],
            "variables": variables,
            "axes": places(&self.axes),
            "reference_point": self.reference.as_deref().map(places),
            "spindle": {
                "rpm": clean(self.spindle.command), "volts": clean(self.spindle.volts),
                "volts_command": clean(self.spindle.volts_command), "gear": self.spindle.stage,
                "angle_deg": self.spindle.held.then(|| clean(self.spindle.angle)),
            },
        });
        if !turned.is_empty() {
            end["turned"] = Json::Object(turned);
        }
        end
    }

    /// The end as one line for people.
    pub fn text(&self) -> String {
        let axes: Vec<String> = self.axes.iter().map(|(axis, at)| format!("{axis}{}", number_text(*at, 3))).collect();
        let turned = self
            .turned
            .iter()
            .map(|axis| msg!("project.run.turned", axis = words(axis.name), speed = (axis.rpm, 1), angle = axis.angle));
        let ended = match self.ended {
            RunEnd::ProgramEnd => words("project.run.program-end"),
            RunEnd::Stop => words("project.run.stop"),
            RunEnd::Alarm(_) => words("project.run.alarm"),
            RunEnd::Blocks => words("project.run.blocks"),
            RunEnd::Seconds => words("project.run.seconds"),
        };
        let end =
            msg!("project.run.end", end = ended, count = self.blocks.to_string(), time = format!("{:.3}", self.time));
        clauses([sentence(&end), axes.join(" ")].into_iter().chain(turned.map(|axis| sentence(&axis))))
    }
}

/// Rounds to twelve decimals; `-0` becomes 0.
fn clean(value: f64) -> f64 {
    if value.abs() < 1e3 { (value * 1e12).round() / 1e12 + 0.0 } else { value }
}
