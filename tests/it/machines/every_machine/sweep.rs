//! For any form the design is sound; without errors its program and its run are sound too: fields at their ends, and random forms.

use macroline::machines::form::{FieldInfo, FieldKindInfo, Value};
use macroline::machines::{self, AnyMachine};
use macroline::motion::{Budget, Retention, RunEnd};
use macroline::project::Project;
use macroline::project::run::{self, RunOptions};
use macroline::text::catalog::{number_text, sentence};
use macroline::text::{Message, Severity};
use macroline::view::{Readout, Verdict};

/// Random forms of each machine on each control.
const RANDOM: usize = 300;

/// Blocks of a run, and seconds of the machine: enough for every kind of block that a program has.
const BUDGET: Budget = Budget { blocks: 300, seconds: 30.0 };

/// Findings that end or slow a run, each by words of its sentence, with the results of the design: at least one of them
/// must have failed.
const JUDGED: &[(&str, &[&str])] = &[
    // Alarms that the program raises.
    ("ABOVE LIMIT", &["vector-feed", "feed-per-revolution"]),
    ("ABOVE CLAMP", &["line-speed", "x-feed", "y-feed"]),
    ("BELOW A PITCH", &["length-error"]),
    ("NO WHOLE PITCHES", &["length-error"]),
    ("coordinates of this control end", &["range-time"]),
    ("THE WORK WOULD TURN TOO FAST", &["work-speed"]),
    ("THE TOOL WOULD TURN TOO FAST", &["tool-speed"]),
    // Controls without alarms for programs stop with a message.
    ("waits for the operator", &["vector-feed", "feed-per-revolution", "line-speed", "block-time", "length-error"]),
    // The machine deviates from its commands.
    ("commanded speed", &["volts", "stage-speed", "speed-smallest", "lower-limit", "override"]),
    ("the control slows the whole block", &["feed-top", "feed-per-revolution"]),
    ("The axes stop between blocks", &["block-time", "cutting-time"]),
    ("The spindle stands still", &["block-time"]),
    ("The gear is not in position", &["stage"]),
    // A contact of the machine holds the program. M5 waits for the slower axis, so that unequal time constants fill the loop.
    ("The loop is at its longest limit", &["loop-needed", "slack-rate", "slack-rate-rated", "register-error"]),
    ("The ribbon is taut to its limit", &["tension", "nip-use", "slack-rate", "slack-rate-rated"]),
    ("The reel is at its end", &["reel-products"]),
];

/// A fixed sequence that looks random.
struct Random(u64);

impl Random {
    fn below(&mut self, n: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % n
    }

    /// A number of a range, often near its lower end.
    fn within(&mut self, min: f64, max: f64, decimals: u8) -> f64 {
        let share = self.below(1001) as f64 / 1000.0;
        let low = share * share * share;
        let share = if self.below(2) == 0 { share } else { low * low };
        number_text(min + (max - min) * share, decimals).parse().unwrap()
    }

    fn value(&mut self, field: &FieldInfo) -> Value {
        match field.kind {
            FieldKindInfo::Number { min, max, decimals, .. } if self.below(4) > 0 => {
                Value::Number(self.within(min, max, decimals))
            }
            _ => {
                let mut ends = ends(field);
                ends.swap_remove(self.below(ends.len()))
            }
        }
    }
}

/// Values at the ends of a field: least, greatest and default number; each choice; both states of a check mark; empty text, the longest,
/// and one that a program cannot hold.
pub(super) fn ends(field: &FieldInfo) -> Vec<Value> {
    let text = |text: &str| Value::Text(text.to_owned());
    match field.kind {
        FieldKindInfo::Number { min, max, default, .. } => [min, max, default].map(Value::Number).to_vec(),
        FieldKindInfo::Flag(_) => [false, true].map(Value::Flag).to_vec(),
        FieldKindInfo::Choice(options) => options.iter().map(|(id, _)| text(id)).collect(),
        FieldKindInfo::Text(most) => vec![text(""), text(&"A".repeat(most)), text("(ö; %O1) N1 M30")],
    }
}

/// Forms of a machine on a control: each field alone at each of its ends, then several at random.
pub(super) fn forms(machine: &dyn AnyMachine, control: &str) -> Vec<Project> {
    let fields = machine.fields();
    let plain = Project::of(machine.id(), Some(control)).unwrap();
    let mut random = Random(7);
    let alone = fields.iter().flat_map(|field| ends(field).into_iter().map(move |value| vec![(field, value)]));
    let several = (0..RANDOM).map(|_| {
        let rarely = 2 + random.below(12);
        let mut some = Vec::new();
        for field in &fields {
            if random.below(rarely) == 0 {
                some.push((field, random.value(field)));
            }
        }
        some
    });
    let changes: Vec<Vec<(&FieldInfo, Value)>> = alone.chain(several).collect();
    let changed = |changes: Vec<(&FieldInfo, Value)>| {
        let mut project = plain.clone();
        project.values.extend(changes.into_iter().map(|(field, value)| (field.id.to_owned(), value)));
        project
    };
    changes.into_iter().map(changed).collect()
}

fn english(message: &Message) -> String {
    sentence(message)
}

/// Whether a sentence has a number with an exponent, one that is not finite, or a limit of 0 r/min or 0 m/min.
fn is_absurd(text: &str) -> bool {
    let exponent =
        text.as_bytes().windows(3).any(|at| at[0].is_ascii_digit() && at[1] == b'e' && at[2].is_ascii_digit());
    exponent
        || ["NaN", "∞", ": 0 r/min", "at most 0 r/min", "be 0 at most", "at 0 m/min"]
            .iter()
            .any(|one| text.contains(one))
}

/// Describes a result that is not a sound number; only times may be endless.
fn unsound(row: &Readout) -> Option<String> {
    let endless = row.value == f64::INFINITY && matches!(row.unit, "s" | "ms");
    let plain = row.value.is_finite() && row.value.abs() < 1e15;
    let sound = (endless || plain) && row.limit.is_none_or(|limit| limit.value().is_finite());
    (!sound).then(|| format!("{} is {}, limit {:?}", row.id, row.value, row.limit))
}

/// Whether blocks take longer than on any control: single results do not count the blocks in front of a motion.
fn is_slower_than_any_control(project: &Project) -> bool {
    let above = |id: &str, most: f64| matches!(project.values.get(id), Some(Value::Number(value)) if *value > most);
    above("block-time", 500.0) || above("macro-time", 100.0)
}

/// Faults of a form: in its design, its program or its run.
fn faults(project: &Project) -> Vec<String> {
    let design = project.design();
    let messages = design.diagnostics.iter().flat_map(|found| [&found.message].into_iter().chain(&found.hints));
    let advice = design.readouts.iter().flat_map(|row| &row.advice);
    let advice = advice.flat_map(|advice| [&advice.message].into_iter().chain(&advice.button));
    let texts = advice.chain(messages).map(english);
    let mut faults: Vec<String> = texts.filter(|text| is_absurd(text)).collect();
    faults.extend(design.readouts.iter().filter_map(unsound));
    if design.diagnostics.iter().any(|found| found.severity == Severity::Error) {
        return faults;
    }
    if is_slower_than_any_control(project) {
        return faults;
    }
    let written = project.written();
    let review = written.diagnostics.iter().cloned().chain(project.advice(&written));
    faults.extend(review.map(|found| format!("review: {}", english(&found.message))));
    let begin = RunOptions { start: None, settings: &[], limits: BUDGET, keep: Retention::Log };
    let mut planner = run::of_project(project, &written, &begin);
    let ended = planner.advance(f64::INFINITY, usize::MAX).ended;
    let mut events: Vec<String> = match ended {
        Some(RunEnd::ProgramEnd | RunEnd::Blocks | RunEnd::Seconds) => Vec::new(),
        // A part with a keyway: the program stops for it.
        Some(RunEnd::Stop) if project.values.get("keyway") == Some(&Value::Flag(true)) => Vec::new(),
        // Its contact is among the findings.
        Some(RunEnd::Stop) if planner.is_held_by_plc() => Vec::new(),
        Some(RunEnd::Alarm(alarm)) => vec![english(&alarm.message)],
        Some(RunEnd::Stop) => vec!["waits for the operator".to_owned()],
        None => vec!["does not end".to_owned()],
    };
    let warnings = planner.diagnostics().iter().filter(|found| found.severity != Severity::Info);
    events.extend(
        warnings.filter(|found| found.message.id != "motion.out-of-blocks").map(|found| english(&found.message)),
    );
    let judged = |id: &&str| {
        design.readouts.iter().any(|row| row.id == *id && row.verdict >= Verdict::Warn)
            || design.diagnostics.iter().any(|found| found.severity == Severity::Warning && found.field == Some(id))
    };
    // A reel that lasts less than the run does ends in it.
    let lasts = |row: &Readout| row.id == "reel-time" && row.value < BUDGET.seconds;
    let spent = design.readouts.iter().any(lasts);
    let is_judged = |event: &String| {
        spent && event.contains("The reel is at its end")
            || JUDGED.iter().any(|(part, results)| event.contains(part) && results.iter().any(judged))
    };
    faults.extend(events.into_iter().filter(|event| !is_judged(event)).map(|event| format!("run: {event}")));
    faults
}

/// Values of a form that differ from a new one.
pub(super) fn changes(project: &Project) -> String {
    let plain = Project::of(project.machine.id(), Some(project.control.id)).unwrap();
    let differs = project.values.iter().filter(|(id, value)| plain.values.get(id.as_str()) != Some(value));
    differs.map(|(id, value)| format!(" {id}={value:?}")).collect()
}

fn sweep(machine: &str) {
    let machine = machines::find(machine).unwrap();
    let mut found: Vec<String> = Vec::new();
    for control in machine.controls() {
        for project in forms(machine, control) {
            let faults = faults(&project);
            let about = || format!("{} on {control},{}", machine.id(), changes(&project));
            found.extend(faults.into_iter().map(|fault| format!("{fault}\n    {}", about())));
        }
    }
    assert!(found.is_empty(), "{} faults:\n{}", found.len(), found[..found.len().min(40)].join("\n"));
}

/// A test for each machine: they run side by side.
macro_rules! sweeps {
    ($($name:ident: $machine:literal,)*) => {
        $(
            #[test]
            fn $name() {
                sweep($machine);
            }
        )*

        #[test]
        fn every_machine_is_swept() {
            let swept = [$($machine),*];
            assert!(machines::ALL.iter().map(|machine| machine.id()).eq(swept), "{swept:?}");
        }
    };
}

sweeps! {
    any_ribbon_line_is_sound_and_its_program_clean: "ribbon-line",
    any_turning_spindle_is_sound_and_its_program_clean: "turning-spindle",
    any_polygon_lathe_is_sound_and_its_program_clean: "polygon-lathe",
}
