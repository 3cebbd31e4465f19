//! Limits and remedies of the verdicts, over the fields at their ends and over random forms.

use std::collections::{BTreeMap, BTreeSet};

use macroline::controls;
use macroline::controls::options::{OverrideOrder, SwitchChoice};
use macroline::machines::form::Value;
use macroline::machines::{self, Design};
use macroline::project::{Project, list};
use macroline::text::catalog::sentence;
use macroline::text::{MessageValue, Severity};
use macroline::view::{Advice, FieldEntry, Limit, Readout, Verdict};

use super::sweep::{changes, forms};
use crate::queries::readout;

/// Results that a clamp holds at their limit, or that have to stay below it: they fail at the limit itself.
const HELD: &[&str] = &["speed-smallest", "relief"];

/// A machine, its control, and typed entries of its form by field.
type Entered = (&'static str, &'static str, &'static [(&'static str, &'static str)]);

/// Machines whose advice is too rare for random forms.
const RARE: &[Entered] = &[
    // A shaft whose spindle is positioned faster than its inverter follows, and one whose motor hardly brakes.
    (
        "turning-spindle",
        "sinumerik-802d",
        &[
            ("path", "turning"),
            ("keyway", "true"),
            ("output", "+-10"),
            ("positioning-acceleration", "900"),
            ("spindle-ramp", "60"),
        ],
    ),
    (
        "turning-spindle",
        "sinumerik-802d",
        &[
            ("path", "turning"),
            ("keyway", "true"),
            ("output", "+-10"),
            ("positioning-acceleration", "900"),
            ("motor-braking", "5"),
            ("spindle-ramp", "0.5"),
        ],
    ),
    // 4.8995 mm per revolution in steps of 0.001, at a high speed.
    (
        "ribbon-line",
        "mitsubishi-e60",
        &[
            ("reduction-ratio", "90.8"),
            ("heads", "47"),
            ("spindle-speed", "3550"),
            ("speed-at-10v", "3600"),
            ("speed-clamp", "3600"),
            ("no-load-speed", "3600"),
            ("rated-load-speed", "3550"),
            ("feed-form", "per-revolution"),
            ("spindle-encoder", "true"),
            ("dwell", "0"),
        ],
    ),
    // A load that the motor cannot turn.
    (
        "ribbon-line",
        "mitsubishi-e60",
        &[
            ("rated-load-speed", "1"),
            ("unwinder-load", "200"),
            ("feed-form", "per-revolution"),
            ("spindle-encoder", "true"),
            ("dwell", "0"),
        ],
    ),
    // A listing that is late only while the knob turns; the ready-made program never is.
    ("ribbon-line", "mitsubishi-e60", &[("variant", "precomputed"), ("pitch", "12"), ("pitches-per-block", "2")]),
    // Short blocks behind an unwinder with a long ramp: a knob that is turned up makes X fast first.
    (
        "ribbon-line",
        "mitsubishi-e60",
        &[
            ("reduction-ratio", "50"),
            ("dancer", "true"),
            ("inverter-ramp", "6"),
            ("dwell", "2.7"),
            ("spindle-speed", "740"),
            ("pitch", "2"),
            ("heads", "180"),
            ("print-roller-diameter", "114.592"),
            ("block-time", "2"),
            ("macro-time", "0.3"),
            ("tension-before", "0.5"),
            ("pinch-force", "200"),
            ("youngs-modulus", "2000"),
            ("tensile-strength", "1500"),
            ("ribbon-thickness", "0.05"),
            ("loop-capacity", "1500"),
        ],
    ),
    // A slip that is more of a slow unwinder's speed than a dancer trims away, and a ribbon as thick as its roller is thin.
    ("ribbon-line", "mitsubishi-e60", &[("dancer", "true"), ("unwinder-load", "100"), ("knob-lowest", "10")]),
    (
        "ribbon-line",
        "mitsubishi-e60",
        &[("dancer", "true"), ("press-roller-diameter", "20"), ("ribbon-thickness", "3"), ("reduction-ratio", "10")],
    ),
    // A length that is no whole number of pitches, and a shorter last pitch that keeps it.
    ("ribbon-line", "mitsubishi-e60", &[("job", "product-length"), ("product-length", "1003"), ("rest", "alarm")]),
    // A knob that acts on the unwinder alone, although the axes could follow it.
    (
        "ribbon-line",
        "sinumerik-802d",
        &[
            ("knob-use", "free"),
            ("spindle-encoder", "true"),
            ("reduction-ratio", "90.8"),
            ("heads", "47"),
            ("dwell", "0"),
        ],
    ),
    // A gear ratio at which a turn of the unwinder feeds more than the control accepts.
    (
        "ribbon-line",
        "gsk-980tdc",
        &[("reduction-ratio", "0.01"), ("feed-form", "per-revolution"), ("spindle-encoder", "true"), ("dwell", "0")],
    ),
    // Friction that the motor overcomes at the fixed speed, but not at the speed to which the knob raises it.
    (
        "turning-spindle",
        "gsk-980tdc",
        &[
            ("path", "turning"),
            ("stock-diameter", "40"),
            ("finished-diameter", "36"),
            ("speed-mode", "fixed"),
            ("cutting-speed", "250"),
            ("motor-top", "3000"),
            ("spindle-friction", "40"),
            ("spindle-ramp", "60"),
        ],
    ),
    // A motor whose continuous torque falls with its speed.
    ("ribbon-line", "mitsubishi-e60", &[("friction-y", "9.2")]),
    // A dot roller far from its match, with a contact too short to smear.
    ("ribbon-line", "mitsubishi-e60", &[("contact-length", "0.04")]),
    // A contact so long that it leaves a cam no time.
    ("ribbon-line", "mitsubishi-e60", &[("contact-length", "8"), ("cam-law", "modified-sine")]),
    // Cams whose roller turns back, and whose motor is too weak.
    ("ribbon-line", "mitsubishi-e60", &[("heads", "100"), ("cam-law", "modified-sine")]),
    (
        "ribbon-line",
        "mitsubishi-e60",
        &[("heads", "40"), ("motor-peak-y", "3"), ("motor-stall-y", "1"), ("cam-law", "polynomial-345")],
    ),
    // A tool that turns against its work, and a ratio that leaves the sides hollow.
    ("polygon-lathe", "knd-k2000t", &[("shape", "own"), ("tool-ratio", "-2")]),
    ("polygon-lathe", "knd-k2000t", &[("shape", "own"), ("tool-ratio", "3"), ("sides", "6")]),
    // A slow cut for which a motor with a shaft fan suffices only in a stage in which the motor turns faster, and one for
    // which it suffices except at the slow end of the knob.
    (
        "turning-spindle",
        "gsk-980tdc",
        &[
            ("path", "turning"),
            ("stock-diameter", "400"),
            ("finished-diameter", "390"),
            ("depth", "2"),
            ("cutting-speed", "40"),
            ("cutting-force", "700"),
            ("stage-1", "300"),
            ("stage-2", "100"),
            ("gear", "1"),
            ("start-x", "500"),
        ],
    ),
    (
        "turning-spindle",
        "gsk-980tdc",
        &[
            ("path", "turning"),
            ("stock-diameter", "400"),
            ("finished-diameter", "390"),
            ("depth", "2"),
            ("cutting-speed", "40"),
            ("cutting-force", "510"),
            ("stage-1", "300"),
            ("stage-2", "0"),
            ("start-x", "500"),
        ],
    ),
    // A positioning that needs more torque than the motor has.
    (
        "turning-spindle",
        "sinumerik-802d",
        &[("keyway", "true"), ("output", "+-10"), ("positioning-acceleration", "5000"), ("positioning-speed", "500")],
    ),
    // A slow cut with more power than the motor has.
    (
        "turning-spindle",
        "gsk-980tdc",
        &[("material", "c45"), ("cutting-speed", "1"), ("depth", "10"), ("feed", "1"), ("motor-power", "0.2")],
    ),
    // Passes so short that the slides start often, with a light rotor.
    (
        "turning-spindle",
        "gsk-980tdc",
        &[
            ("path", "turning"),
            ("stock-diameter", "60"),
            ("finished-diameter", "40"),
            ("length", "3"),
            ("depth", "0.5"),
            ("feed", "0.6"),
            ("motor-rotor-z", "5"),
        ],
    ),
    // A turned end whose cut is too deep for the main spindle.
    (
        "polygon-lathe",
        "knd-k2000t",
        &[("from-face", "30"), ("before", "true"), ("before-depth", "6"), ("before-feed", "0.6"), ("main-power", "3")],
    ),
    // A thread that leaves its run-out no room, and one up to the shoulder.
    ("polygon-lathe", "knd-k2000t", &[("from-face", "30"), ("before", "true"), ("before-pitch", "6")]),
    (
        "polygon-lathe",
        "knd-k2000t",
        &[("from-face", "30"), ("before", "true"), ("before-pitch", "1"), ("before-thread-length", "10")],
    ),
    // Cuts for which the drives suffice except with the feed override at its highest position.
    ("polygon-lathe", "knd-k2000t", &[("feed", "0.95"), ("tool-power", "5.5")]),
    ("polygon-lathe", "knd-k2000t", &[("feed", "0.5"), ("tool-power", "2")]),
    // A fixed speed beyond the only stage.
    (
        "turning-spindle",
        "gsk-980tdc",
        &[("speed-mode", "fixed"), ("stage-1", "500"), ("stage-2", "0"), ("cutting-speed", "200")],
    ),
    // A fixed speed beyond the chosen stage, and a faster stage beside it.
    (
        "turning-spindle",
        "gsk-980tdc",
        &[("speed-mode", "fixed"), ("gear", "1"), ("stage-1", "500"), ("stage-2", "3000"), ("cutting-speed", "200")],
    ),
];

/// All forms of the sweep, and the rare ones, with a description.
fn all() -> impl Iterator<Item = (Project, String)> {
    let rare = RARE.iter().map(|(machine, control, entries)| {
        let entries: Vec<_> = entries.iter().map(|(id, text)| (*id, (*text).to_owned())).collect();
        let plain = Project::of_form(machines::find(machine).unwrap(), controls::find(control).unwrap());
        (plain.with_entries(&entries).unwrap(), format!("{machine} with {entries:?} on {control}"))
    });
    let on = machines::ALL.iter().flat_map(|machine| machine.controls().iter().map(move |id| (*machine, *id)));
    let swept = on.flat_map(|(machine, control)| {
        forms(machine, control).into_iter().map(move |project| {
            let about = format!("{} on {control},{}", machine.id(), changes(&project));
            (project, about)
        })
    });
    rare.chain(swept)
}

fn number(project: &Project, id: &str) -> f64 {
    match project.values.get(id) {
        Some(Value::Number(number)) => *number,
        other => panic!("{id}: {other:?}"),
    }
}

/// Whether an accepted value keeps its limit. Of a ratio r the smear |1 - 1/r| · c is at most the allowed one.
fn keeps(project: &Project, readout: &Readout, limit: Limit) -> bool {
    match limit {
        Limit::Equal(_) if readout.id == "surface-ratio" => {
            let smear = (1.0 - 1.0 / readout.value).abs() * number(project, "contact-length");
            smear <= number(project, "smear-limit") * (1.0 + 1e-9)
        }
        _ => limit.holds(readout.value),
    }
}

/// A verdict that contradicts its limit.
fn contradiction(project: &Project, readout: &Readout) -> Option<String> {
    let limit = readout.limit?;
    let right = match readout.verdict {
        Verdict::Ok => keeps(project, readout, limit),
        Verdict::Fail if HELD.contains(&readout.id) => !limit.holds(readout.value) || limit.value() == readout.value,
        Verdict::Fail => !limit.holds(readout.value),
        Verdict::None | Verdict::Warn => true,
    };
    (!right).then(|| format!("{} is {} with {:?}: {:?}", readout.id, readout.value, limit, readout.verdict))
}

#[track_caller]
fn none(found: &[String]) {
    assert!(found.is_empty(), "{} faults:\n{}", found.len(), found[..found.len().min(30)].join("\n"));
}

#[test]
fn ok_keeps_the_limit_and_fail_violates_it() {
    let mut found = Vec::new();
    for (project, about) in all() {
        let faults = project
            .prepared()
            .results()
            .readouts
            .iter()
            .filter_map(|row| contradiction(&project, row))
            .collect::<Vec<_>>();
        found.extend(faults.into_iter().map(|fault| format!("{fault}\n    {about}")));
    }
    none(&found);
}

/// The project with the entries of an advice.
fn taken(project: &Project, advice: &Advice) -> Project {
    let mut after = project.clone();
    let fields = project.machine.fields();
    for entry in &advice.entries {
        let field = fields.iter().find(|field| field.id == entry.field).unwrap_or_else(|| panic!("no {entry:?}"));
        let value = field.read_metric(&entry.text).unwrap_or_else(|problem| panic!("{entry:?}: {problem:?}"));
        after.values.insert(entry.field.to_owned(), value);
    }
    after
}

fn errors(design: &Design) -> usize {
    design.diagnostics.iter().filter(|found| found.severity == Severity::Error).count()
}

/// Results that fail, by their labels.
fn red(readouts: &[Readout]) -> BTreeSet<&'static str> {
    readouts.iter().filter(|row| row.verdict == Verdict::Fail).map(|row| row.label).collect()
}

/// Results that fail after an advice, by the notes after it.
fn named_red(notes: &[Advice]) -> BTreeSet<&'static str> {
    let notes = notes.iter().take_while(|note| note.message.id == "advice.turns-red");
    notes
        .filter_map(|note| match note.message.value("result") {
            Some(MessageValue::Label(label)) => Some(*label),
            _ => None,
        })
        .collect()
}

/// Advice that never has a button, and why.
const PLAIN: &[(&str, &str)] = &[
    ("advice.turns-red", "a note behind another advice"),
    ("polygon.cannot-cut", "a fact; the choice of a cutter behind it has the button"),
    ("polygon.coasts-without-supply", "a fact, no fault: no drive holds the ratio without supply"),
    ("polygon.faces-back", "a deed: inserts are turned in their holders"),
    ("polygon.hollow-sides", "a fact; the choice of a cutter behind it has the button"),
    ("polygon.less-hollow", "a fact; the choice of a cutter behind it has the button"),
    ("polygon.little-relief", "a fact; the choice of a cutter behind it has the button"),
    ("polygon.long-ramp", "what the ramp before it costs"),
    ("polygon.measure-free-length", "a deed: a distance is measured"),
    ("polygon.no-b", "no speed is a remedy"),
    ("polygon.no-better", "no way is within every limit"),
    ("polygon.no-run-out", "a deed: a longer end or another thread"),
    ("polygon.no-twist", "G512 has no word for it; the figure is for a control with G51.2"),
    ("polygon.no-twist-passes", "as polygon.no-twist, for passes with two feeds"),
    ("polygon.no-choice", "no way turns the polygon"),
    ("polygon.not-flat", "a fact; the larger cutter or the choice behind it has the button"),
    ("polygon.few-volts", "a deed: another belt, which changes torque and motor"),
    ("polygon.other-sides", "a fact; the choice of a cutter behind it has the button"),
    ("polygon.round-corners", "a fact about the stock, no fault"),
    ("polygon.scarce-relief", "a fact: relief suffices"),
    ("polygon.too-far", "a fact of the machine: another cutter or part"),
    ("polygon.too-near", "a fact of the machine: another cutter or part"),
    ("ribbon.cam-blocks-smoothed", "a deed: a cam in the drive"),
    ("ribbon.cam-blocks-too-short", "a deed: a cam in the drive"),
    ("ribbon.cam-not-written", "a fact, no fault"),
    ("ribbon.cam-turns-back", "a fact: another roller or other heads"),
    ("ribbon.effective-torque", "a deed: another motor, with all of its data"),
    ("ribbon.inertia-ratio", "a deed: another gear or motor"),
    ("ribbon.peak-torque-motor", "a deed: another motor or gear"),
    ("slides.inertia-burns-brake", "a deed: another gear or motor"),
    ("ribbon.field-weakening", "a deed: another gear or motor"),
    ("ribbon.slips-to-rest", "a deed: another gear or inverter"),
    ("ribbon.slips-when-rated", "a deed: another gear or inverter"),
    ("ribbon.feed-above-limit", "a fact; the speed behind it has the button"),
    ("ribbon.few-volts", "a fact: the speed is the product's"),
    ("ribbon.knob-stops", "a fact; the speed behind it has the button"),
    ("ribbon.loop-empties", "a fact; the dancer behind it has the button"),
    ("ribbon.loop-fills", "a fact; the dancer behind it has the button"),
    ("ribbon.low-frequency", "a deed: another gear, which changes the line"),
    ("ribbon.match-cam", "a deed: another drive"),
    ("ribbon.loop-fills-by-products", "a deed: longer products, or the loop taken up between two"),
    ("ribbon.loop-grows", "a deed: longer products, or the loop taken up between two"),
    ("ribbon.slip-beyond-trim", "a fact; the lowest position of the knob behind it has the button"),
    ("ribbon.match-cam-no-time", "a fact, no remedy"),
    ("ribbon.match-diameter-thin", "says why the diameter is no remedy"),
    ("ribbon.motor-above-rated", "a deed: the torque is checked on the data sheet"),
    ("ribbon.no-speed", "no speed is a remedy"),
    ("ribbon.not-matched", "a fact; roller, heads and pitch behind it have the buttons"),
    ("ribbon.range-endless", "a fact: parameters are set on the control"),
    ("ribbon.range-open", "a fact; the parameters behind it have the button"),
    ("ribbon.range-shifted", "a fact, no fault"),
    ("ribbon.revolution-feed-above-limit", "a deed: gear, heads or roller of the machine"),
    ("ribbon.slips", "a fact; roller, heads and pitch behind it have the buttons"),
    ("ribbon.stalls", "a deed: less load on the motor"),
    ("ribbon.stands", "a deed: the knob is turned up"),
    ("ribbon.warm-at-speed", "a deed: another motor or gear"),
    ("ribbon.y-carried", "a fact, no fault"),
    ("scaling.drifts", "a fact of gear and lead: another gear"),
    ("scaling.no-ratio", "a fact of gear and lead: another gear"),
    ("slides.inertia-at-starts", "a deed: longer passes, another screw, belt or motor"),
    ("slides.inertia-ratio", "a deed: another screw, belt or motor"),
    ("ribbon.brake-at-core", "a deed: a brake that follows the diameter"),
    ("slides.no-ramp", "a deed: another motor"),
    ("slides.weight-too-heavy", "a deed: another screw or motor, or a counterweight"),
    ("turning.few-volts-alone", "a deed: a spindle with gear stages"),
    ("turning.few-volts-lowest", "a deed: a spindle with more gear stages"),
    ("lathe.friction-stalls-at-knob", "a deed: the knob below its end"),
    ("lathe.friction-stalls", "a deed: less friction, or another motor"),
    ("turning.gear-delay-too-short", "a deed: a parameter of the control, with its value in the sheet"),
    ("turning.held-work-gives-way", "a deed: work clamped shorter, or a steady rest"),
    ("turning.limited", "a fact about the limit that the form asks for"),
    ("turning.screw-too-short", "a deed: another screw, or a start nearer to the work"),
    ("turning.overload", "a fact: the share of time is the operator's"),
    ("ribbon.range-roll-over-in-radius", "the words of X are a setting of the control, no field"),
    (
        "ribbon.taut-torque",
        "of a ribbon that a start pulls taut it has the button of the dwell, which sizing::taut tries",
    ),
];

#[test]
fn every_advice_has_a_button_that_improves_its_verdict() {
    let (mut found, mut tried) = (Vec::new(), BTreeMap::new());
    let mut without: BTreeMap<&str, String> = BTreeMap::new();
    for (project, about) in all() {
        let design = project.design();
        for readout in &design.readouts {
            for (at, advice) in readout.advice.iter().enumerate() {
                assert_eq!(advice.button.is_none(), advice.entries.is_empty(), "{}: {about}", readout.id);
                if advice.entries.is_empty() {
                    let text = || format!("{}: {}", readout.id, sentence(&advice.message));
                    without.entry(advice.message.id).or_insert_with(text);
                    continue;
                }
                *tried.entry(advice.message.id).or_insert(0) += 1;
                // The entries read as values, so the machine's own results are all that can be wrong with them.
                let after = taken(&project, advice).prepared().results();
                let row = after.readouts.iter().find(|row| row.id == readout.id);
                let verdict = row.map_or(Verdict::None, |row| row.verdict);
                if verdict >= readout.verdict || errors(&after) > errors(&design) {
                    found.push(format!(
                        "{}: {:?} to {verdict:?} by {:?}\n    {about}",
                        readout.id, readout.verdict, advice.entries
                    ));
                }
                let turned: BTreeSet<_> = red(&after.readouts).difference(&red(&design.readouts)).copied().collect();
                let named = named_red(&readout.advice[at + 1..]);
                if named != turned {
                    found.push(format!("{}: {turned:?} turn red, named {named:?}\n    {about}", readout.id));
                }
            }
        }
    }
    none(&found);
    assert!(tried.len() >= 40, "{tried:?}");
    // A remedy that does not help with one form has no button there, so only those that never have one are listed.
    let unlisted = without.iter().filter(|(id, _)| !tried.contains_key(*id) && !PLAIN.iter().any(|row| row.0 == **id));
    none(&unlisted.map(|(id, text)| format!("{id} has no button: {text}")).collect::<Vec<_>>());
    let wrong = PLAIN.iter().filter(|(id, _)| tried.contains_key(id) || !without.contains_key(id));
    none(&wrong.map(|(id, _)| format!("{id} has a button, or never comes")).collect::<Vec<_>>());
}

fn project(machine: &str, control: &str, entries: &[(&'static str, &str)]) -> Project {
    let (machine, control) = (machines::find(machine).unwrap(), macroline::controls::find(control).unwrap());
    let plain = Project::of_form(machine, control);
    let entries = entries.iter().copied().map(FieldEntry::from).collect();
    taken(&plain, &Advice { entries, button: None, message: macroline::msg!("polygon.no-b") })
}

/// Words of the buttons of a result, with their entries.
fn buttons(project: &Project, id: &str) -> Vec<String> {
    let written = |advice: &Advice| {
        let button = sentence(advice.button.as_ref()?);
        let sets: Vec<_> = advice.entries.iter().map(|entry| format!("{}={}", entry.field, entry.text)).collect();
        Some(format!("{button}: {}", sets.join(" ")))
    };
    readout(project, id).advice.iter().filter_map(written).collect()
}

#[test]
fn buttons_of_the_defaults_of_the_ribbon_line() {
    let line = project("ribbon-line", "mitsubishi-e60", &[]);
    assert_eq!(buttons(&line, "surface-ratio"), ["Set 47 heads: heads=47", "Set a pitch of 62.832 mm: pitch=62.832",]);
    assert_eq!(buttons(&line, "slack-rate"), ["Add a dancer: dancer=true"]);
    // No slack with the knob at its highest position: the wait is half of the spindle ramp to 1480 r/min, less half of the time constant, less the servo lag.
    let (ramp, tau, gain): (f64, f64, f64) = (2.0, 0.1, 33.0);
    let dwell = ramp / 2.0 - tau / 2.0 - 1.0 / gain - 0.05;
    let dwell = (dwell * 1000.0).ceil() / 1000.0;
    assert_eq!(
        buttons(&line, "loop-needed"),
        [
            "Set a loop of 1840 mm: loop-capacity=1840".to_owned(),
            format!("Set a dwell of {dwell} s; Set a loop of 1140 mm: wait=dwell dwell={dwell} loop-capacity=1140"),
            "Set a ramp of 0.558 s; Set a dwell of 0.149 s; Set a loop of 590 mm: inverter-ramp=0.558 wait=dwell dwell=0.149 loop-capacity=590"
                .to_owned(),
        ]
    );
}

#[test]
fn slower_unwinder_counts_the_override() {
    let line = project(
        "ribbon-line",
        "mitsubishi-e60",
        &[("clamp-y", "100000"), ("override", "80"), ("spindle-speed", "1300")],
    );
    // 100000 / (1000 mm of print roller per 8 mm of ribbon …): 1013 r/min of the unwinder at 80 %.
    assert_eq!(buttons(&line, "y-feed"), ["Set 1266 r/min: spindle-speed=1266 speed-clamp=1013"]);
}

#[test]
fn buttons_of_the_turning_spindle() {
    let lathe = project(
        "turning-spindle",
        "gsk-980tdc",
        &[("upper-limit", "3200.0"), ("cutting-force", "4000"), ("motor-base", "100")],
    );
    assert_eq!(buttons(&lathe, "speed-smallest"), ["Set 3000 r/min: upper-limit=3000"]);
    // F v / 60 000 = 12 kW, and 2 Nm of friction at 3000 r/min 0.63 kW; 6 kW reach the cut.
    assert_eq!(buttons(&lathe, "power"), ["Set 85 m/min: cutting-speed=85"]);
}

#[test]
fn button_takes_the_flattest_cutter() {
    let lathe = project("polygon-lathe", "knd-k2000t", &[("shape", "own"), ("sides", "6"), ("flatness", "0.5")]);
    assert_eq!(
        buttons(&lathe, "sides"),
        ["Set 3 inserts, D1 Q2: shape=own sides=6 inserts=3 work-ratio=1 tool-ratio=2 tip-radius=45"]
    );
}

#[test]
fn remedy_that_does_not_help_has_no_button() {
    // Two faults of the feed: the second clamp limits the speed, so the remedy of the first alone changes nothing.
    let line = project("ribbon-line", "mitsubishi-e60", &[("clamp-y", "1")]);
    let feed = readout(&line, "y-feed");
    assert_eq!((feed.verdict, buttons(&line, "y-feed").len()), (Verdict::Fail, 0));
    assert!(!feed.advice.is_empty());
}

#[test]
fn override_behind_the_limits_is_held_by_the_chuck() {
    let limits = [("override", "120"), ("upper-limit", "3000"), ("chuck-limit", "3000"), ("stage-2", "6000")];
    let mut lathe = project("turning-spindle", "gsk-980tdc", &limits);
    let choice = OverrideOrder::AfterLimits;
    let row = lathe.control.switch(OverrideOrder::SWITCH).unwrap();
    lathe.switches.set(row, choice.option().id);
    assert_eq!(readout(&lathe, "speed-smallest").value, 3000.0);
}

#[test]
fn value_beyond_its_limit_does_not_read_like_it() {
    let row = project("ribbon-line", "mitsubishi-e60", &[]).design().readouts.into_iter().next().unwrap();
    let with = |value, limit| Readout { value, decimals: 1, limit: Some(limit), verdict: Verdict::Fail, ..row.clone() };
    let plain = |text: String| text.replace('\u{202f}', "").replace('\u{2212}', "-");
    let texts = |readout: &Readout| (plain(readout.value_text()), list::readouts_text(std::slice::from_ref(readout)));
    for (value, limit, shown, in_full) in [
        (5000.2, Limit::AtMost(5000.0), "5000.2", "5000.2 "),
        (5000.0004, Limit::AtMost(5000.0), "5000.0004", "5000.0004 "),
        (4999.9, Limit::AtMost(5000.0), "5000", "4999.9 "),
        (49.996, Limit::AtLeast(50.0), "49.996", "49.996 "),
        (-50.01, Limit::Within(50.0), "-50.01", "-50.01 "),
    ] {
        let (four_digits, text) = texts(&with(value, limit));
        assert_eq!(four_digits, shown);
        assert!(text.contains(&format!(" {in_full}")), "{text}");
    }
    assert_eq!(with(f64::INFINITY, Limit::AtMost(1.0)).value_text(), "–");
}

#[test]
fn limits_are_written_with_their_direction() {
    let line = project("ribbon-line", "mitsubishi-e60", &[]);
    let text = list::readouts_text(&line.design().readouts);
    for phrase in ["(at most 16216.216)", "(at least ", "(within ±50)", "(exactly 1)"] {
        assert!(text.contains(phrase), "{phrase}:\n{text}");
    }
    let json = list::readouts_json(&line.design().readouts);
    let of = |id: &str| json.as_array().unwrap().iter().find(|row| row["id"] == id).unwrap();
    // 20000 mm/min with the knob at its highest position, where the clamp of 1480 r/min holds the 1200 of 100 %.
    let limit = of("x-feed")["limit"].as_f64().unwrap();
    assert!((limit - 20000.0 * 1200.0 / 1480.0).abs() < 1e-6 && of("x-feed")["bound"] == "most", "{limit}");
    assert_eq!(of("slack-rate")["bound"].as_str(), Some("within"));
    assert!(of("k")["limit"].is_null() && of("k")["bound"].is_null());
}

#[test]
fn buttons_count_one_in_the_singular() {
    let heads = |count: f64| sentence(&macroline::msg!("advice.set-heads", count));
    assert_eq!([1.0, 2.0, 0.0].map(heads), ["Set 1 head", "Set 2 heads", "Set 0 heads"]);
}
