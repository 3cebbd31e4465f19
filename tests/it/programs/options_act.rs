//! Each option of a switch makes a visible difference: in alarms, in the canonical log, or in a run.

use std::rc::Rc;

use macroline::controls::options::{StartupPath, SwitchKind};
use macroline::controls::switch::switch;
use macroline::controls::{ALL, Control, Switch, Switches};
use macroline::machines::form::Value;
use macroline::motion::{Action, Budget, Event, Panel, Retention};
use macroline::nc::{self, Files};
use macroline::project::Project;
use macroline::project::run::{self, Run, RunOptions};
use macroline::text::{Citation, Grade};

use super::{fixtures, log_of, settings, start_on};

/// Switches whose options no program distinguishes: control, maker or nothing for all, switch, and reason. An entry that a program does
/// distinguish fails the test.
const NEVER_DISTINGUISHED: &[(&str, &str, &str)] = &[
    ("fanuc", "pmc-override", "no machine turns PMC axes on this control"),
    ("gsk", "override-code", "ladder and control change together: machines/ladder/wired.rs"),
    ("", "comment-characters", "comments move nothing: comments.rs"),
];

/// Programs beside the fixtures that set the switch: control, maker or nothing for all, switch, text.
const PROGRAMS: &[(&str, &str, &str)] = &[
    ("mitsubishi-e60", "macro-input-base", "O1\n#100=#1032\n#101=#1033\nM30\n"),
    ("mitsubishi-e60", "feed-zero", "O1\nG01 X5. F0\nM30\n"),
    ("gsk-980tdc", "override-order", "O1\nM41\nG50 S500\nG96 S200 M03\nG00 X10.\nG04 X3.\nM30\n"),
    ("gsk-980tdc", "volts-at-emergency-stop", "O1\nM41\nM03 S500\nG04 X5.\nM30\n"),
    ("gsk-980tdc", "speed-in-rapid", "O1\nM41\nG50 S900\nG00 X90.\nG96 S100 M03\nG04 X3.\nG00 X40.\nG04 X3.\nM30\n"),
    ("gsk-980tdc", "m03-m04", "O1\nM41\nM03 S300\nG04 X2.\nM04\nG04 X2.\nM30\n"),
    ("gsk-980tdc", "spindle-at-end", "O1\nM41\nM03 S500\nM30\n"),
    ("", "common-at-reset", "O1\n#101=#100\n#100=5\nG04 X3.\nM30\n"),
    ("mitsubishi-e60", "manual-s", "O1\nS500 M03\nG04 X3.\nM30\n"),
    ("gsk", "manual-s", "O1\nM41\nM03 S500\nG04 X3.\nM30\n"),
    ("knd", "manual-s", "O1\nM03 S500\nG04 X3.\nM30\n"),
    ("fanuc", "manual-s", "O1\nM03 S500\nG04 X3.\nM30\n"),
    ("sinumerik", "manual-s", "S500 M3\nG4 F3\nM2\n"),
    ("mitsubishi-e60", "coordinate-range", "O1\nG91\nG00 Y60000.\nG92 Y0\nY60000.\nY60000.\nM30\n"),
    ("gsk", "coordinate-range", "O1\nG00 W60000.\nG50 Z0\nG00 W60000.\nW60000.\nM30\n"),
    ("knd", "coordinate-range", "O1\nG00 W60000.\nG50 Z0\nG00 W60000.\nW60000.\nM30\n"),
    ("fanuc-0i-tf", "coordinate-range", "O1\nG00 W600000.\nG50 Z0\nG00 W600000.\nW600000.\nM30\n"),
    ("fanuc-0i-mf", "coordinate-range", "O1\nG91\nG00 Y600000.\nG92 Y0\nY600000.\nY600000.\nM30\n"),
    ("sinumerik", "coordinate-range", "G91\nG0 Z60000\nTRANS Z60000\nG0 Z60000\nZ60000\nM2\n"),
    ("sinumerik", "speed-reached", "S1000 M3\nG1 X10 F0.5\nM2\n"),
    ("sinumerik", "lims-in-g97", "LIMS=500\nG97 S1000 M3\nG4 F3\nM2\n"),
    ("sinumerik", "g96-apply-at-activation", "G0 X100\nG96 S100 M3\nG4 F3\nM2\n"),
    ("sinumerik", "rapid-look-ahead", "G0 X100\nG96 S100 M3 F0.2\nG4 F3\nG0 X20\nM8\nG1 Z-5\nM2\n"),
    ("sinumerik", "small-offset", "G0 X100\nTRANS X0.6\nG96 S100 M3\nM2\n"),
    ("sinumerik", "small-offset", "G0 X100\nTRANS X0.1\nG96 S100 M3\nM2\n"),
    ("sinumerik", "spindle-knob", "S500 M3\nG4 F3\nM2\n"),
    ("sinumerik", "spindle-lock", "G94\nSPOS=90\nM55\nG1 X10 F100\nM2\n"),
    ("sinumerik", "driven-tool", "G94\nSPOS=90\nM81\nM24\nG1 X10 F100\nM2\n"),
    ("sinumerik", "block-length", LONG),
];

/// A block of more than 200 characters.
const LONG: &str = concat!(
    "R1=1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1",
    "+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1",
    "+1+1+1+1+1+1\nM2\n"
);

/// Programs on the plant of a machine: control, switch, machine, text; without a text the machine's own program.
const ON_MACHINES: &[(&str, &str, &str, &str)] = &[
    ("gsk-980tdc", "offset-at-rest", "turning-spindle", "O1\nM41\nM03 S300\nG04 X2.\nS0\nG04 X2.\nM30\n"),
    ("knd-k2000t", "pmc-override", "polygon-lathe", ""),
];

/// The settings of a switch that are compared; of a text the default and that of a fixture.
fn options<'a>(row: &Switch, source: &'a str) -> Vec<&'a str> {
    if row.is_text() {
        let set = settings(source).into_iter().find(|(id, _)| *id == row.id());
        return vec![row.default(), set.map_or(other_text(row), |(_, value)| value)];
    }
    row.options().iter().map(|option| option.id).collect()
}

/// A text that a switch can be set to besides its default.
fn other_text(row: &Switch) -> &'static str {
    match row.kind {
        SwitchKind::SpindleLock(_) => "M81",
        SwitchKind::DrivenTool(_) => "M24",
        _ => "X",
    }
}

/// Actions of an operator while the program runs.
fn panels() -> Vec<Panel> {
    let panel =
        |events: &[(f64, Action)]| Panel::new(events.iter().map(|(t, action)| Event { t: *t, action: action.clone() }));
    let registers = ["R72", "R172", "R24", "R124", "R6436"];
    let inputs = registers.iter().zip([1.0, 2.0, 3.0, 4.0, 5.0]);
    let inputs: Vec<_> = inputs.map(|(name, value)| (0.0, Action::Input((*name).into(), value))).collect();
    vec![
        panel(&inputs),
        panel(&[(0.0, Action::SpindleOverride(150.0)), (0.0, Action::FeedOverride(50.0))]),
        panel(&[(1.0, Action::Reset), (2.0, Action::Start)]),
        panel(&[(1.0, Action::EmergencyStop)]),
        panel(&[(1.0, Action::ManualSpeed(200.0))]),
    ]
}

const OPTIONS: RunOptions = RunOptions {
    start: None,
    settings: &[],
    limits: Budget { blocks: 2000, seconds: 60.0 },
    keep: Retention::Timeline,
};

/// State of machine and variables at some moments of a run.
fn moments(mut run: Run) -> String {
    let progress = run.advance(60.0, 100_000);
    let mut text = format!("{progress:?} {} {:?}\n", run.timeline().end(), run.diagnostics());
    for at in 0..80 {
        let t = 0.15 * f64::from(at);
        let now = run.timeline().at(t);
        let variables: Vec<Option<f64>> = (100..104).map(|number| run.variable_at(number, t)).collect();
        text += &format!(
            "{:?} {:?} {:?} {:?} {variables:?}\n",
            now.mode,
            now.axes.map(|axis| axis.position),
            now.pmc,
            now.spindle
        );
    }
    text
}

/// Runs on the bench, or on the plant of a project; without a text the project's own program.
fn runs(control: &'static Control, plant: Option<&Project>, source: &str, switches: &Switches) -> String {
    let run = |panel: Panel| match plant {
        Some(project) if source.is_empty() => {
            let mut project = project.clone();
            project.switches = switches.clone();
            project.panel = panel;
            run::of_project(&project, &project.written(), &OPTIONS)
        }
        _ => {
            let parsed = Rc::new(nc::parse_with(&Files::one("test.nc", source), control, switches));
            run::of_programs(parsed, plant, panel, &OPTIONS)
        }
    };
    panels().into_iter().map(|panel| moments(run(panel))).collect()
}

/// Pairs of options that give different runs of a program.
fn distinguished_by(control: &'static Control, row: &Switch, machine: &str, source: &str) -> Vec<bool> {
    let options = options(row, source);
    let others: Vec<(&str, &str)> = settings(source).into_iter().filter(|(id, _)| *id != row.id()).collect();
    let set = |option| [&others[..], &[(row.id(), option)]].concat();
    let mut outcomes: Vec<String> =
        options.iter().map(|option| log_of(source, &mut start_on(control, source, &set(option)))).collect();
    if !pairs(outcomes.len()).all(|(one, other)| outcomes[one] != outcomes[other]) {
        let mut plant = Project::of(machine, Some(control.id));
        // An offset of the analog output shows in the volts at rest.
        if let Some(project) = plant.as_mut().filter(|_| machine == "turning-spindle") {
            project.values.insert("offset-zero".to_owned(), Value::Number(20.0));
        }
        for (option, outcome) in options.iter().zip(&mut outcomes) {
            let switches = set(option).iter().map(|(id, value)| ((*id).to_owned(), (*value).to_owned())).collect();
            *outcome += &runs(control, plant.as_ref(), source, &Switches(switches));
        }
    }
    pairs(outcomes.len()).map(|(one, other)| outcomes[one] != outcomes[other]).collect()
}

fn pairs(count: usize) -> impl Iterator<Item = (usize, usize)> {
    (0..count).flat_map(move |one| (one + 1..count).map(move |other| (one, other)))
}

/// The programs that set a switch, with the machine that each runs on; without one the bench.
fn programs(control: &Control, row: &Switch, fixtures: &[String]) -> Vec<(&'static str, String)> {
    let is = |id: &str, switch: &str| control.id.starts_with(id) && switch == row.id();
    let set = fixtures.iter().filter(|source| settings(source).iter().any(|(id, _)| *id == row.id()));
    let own = PROGRAMS.iter().filter(|(id, switch, _)| is(id, switch)).map(|(_, _, text)| ("", (*text).to_owned()));
    let machines = ON_MACHINES.iter().filter(|(id, switch, ..)| is(id, switch));
    let machines = machines.map(|(_, _, machine, text)| (*machine, (*text).to_owned()));
    own.chain(machines).chain(set.map(|source| ("", source.clone()))).collect()
}

/// The pairs of options of a switch that no program distinguishes.
fn alike(control: &'static Control, row: &Switch, fixtures: &[String]) -> Vec<String> {
    let pairs: Vec<(usize, usize)> = pairs(options(row, "").len()).collect();
    let mut distinguished = vec![false; pairs.len()];
    for (machine, source) in programs(control, row, fixtures) {
        for (known, now) in distinguished.iter_mut().zip(distinguished_by(control, row, machine, &source)) {
            *known |= now;
        }
        if distinguished.iter().all(|known| *known) {
            break;
        }
    }
    let options = options(row, "");
    let alike = pairs.into_iter().zip(distinguished).filter(|(_, known)| !known);
    alike.map(|((one, other), _)| format!("{} = {}", options[one], options[other])).collect()
}

fn sources(control: &Control) -> Vec<String> {
    ["ok", "bad"].iter().flat_map(|kind| fixtures(control, kind)).map(|(_, source)| source).collect()
}

#[test]
fn each_option_changes_what_a_program_does() {
    let mut idle = Vec::new();
    for control in ALL {
        let fixtures = sources(control);
        for row in control.switches {
            let known =
                NEVER_DISTINGUISHED.iter().any(|(of, switch, _)| control.id.starts_with(of) && *switch == row.id());
            let alike = alike(control, row, &fixtures);
            if alike.is_empty() == known {
                idle.push(format!("{} {}: {}", control.id, row.id(), alike.join(", ")));
            }
        }
    }
    let mend = "add a program to PROGRAMS that distinguishes them, or to NEVER_DISTINGUISHED why none can; remove rows that a program distinguishes";
    assert!(idle.is_empty(), "options that make no difference; {mend}:\n{}", idle.join("\n"));
}

#[test]
fn option_without_effect_is_found() {
    let control = ALL[0];
    let planted = switch(StartupPath::of(&[StartupPath::G60, StartupPath::G64]), Citation::new("none", Grade::Open));
    let programs = ["O1\nG61\nG01 X10. F100\nM30\n".to_owned(), "(SET startup-path G64)\nO1\nM30\n".to_owned()];
    assert_eq!(alike(control, &planted, &programs), ["G60 = G64"]);
}
