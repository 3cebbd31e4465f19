//! Gear change of the turning spindle: the stage changes only after the spindle has slowed down.

use macroline::machines::Samples;
use macroline::motion::{Action, Event};
use macroline::nc::Files;
use macroline::project::Project;
use macroline::view::{Readout, Verdict};

use super::{project, run_of, sheet};

/// A chuck of 400 mm: stages of 400 and 1200 r/min at 10 V, 12 s of ramp to each.
const CHUCK: [(&str, &str); 7] = [
    ("stock-diameter", "400"),
    ("start-x", "450"),
    ("stage-1", "400"),
    ("stage-2", "1200"),
    ("chuck-limit", "1200"),
    ("upper-limit", "1200"),
    ("spindle-ramp", "12"),
];

/// The lathe, with a program that changes from stage 2 to stage 1 at 1150 r/min.
fn downshift(control: &str, changes: &[(&str, &str)]) -> Project {
    let mut lathe = project(control, &[&CHUCK[..], changes].concat());
    let text = "%\nO9201\nG97 S1150\nM42\nM03\nG04 X20.\nM41\nG04 X3.\nM05\nM30\n%\n";
    lathe.edited = Some(Files::one("O9201.nc", text));
    lathe
}

/// Moments (s) at which M41 puts the shift voltage out and at which stage 1 engages, and the speed (r/min) there.
fn shifted(lathe: &Project, event: Option<Event>) -> (f64, f64, f64) {
    let mut planner = run_of(lathe, event);
    planner.advance(f64::INFINITY, usize::MAX);
    let at = |t: f64| Samples::at(&planner, t).spindle;
    let step = |from: f64, found: &dyn Fn(f64) -> bool| {
        (0..12_000).map(|at| from + f64::from(at) * 0.005).find(|t| found(*t)).expect("a moment")
    };
    let engaged = step(0.0, &|t| at(t).stage == 2);
    let slows = step(engaged + 10.0, &|t| at(t).command.abs() < 20.0);
    let meshed = step(slows, &|t| at(t).stage == 1);
    (slows, meshed, at(meshed).actual.abs())
}

fn delay(control: &str, changes: &[(&str, &str)]) -> Readout {
    let rows = project(control, &[&CHUCK[..], changes].concat()).design().readouts;
    rows.into_iter().find(|row| row.id == "gear-delay").expect("a row")
}

#[test]
fn stage_changes_at_the_shift_speed_only() {
    for control in ["gsk-980tdc", "fanuc-0i-tf", "knd-k2000t"] {
        let (slows, meshed, speed) = shifted(&downshift(control, &[]), None);
        // 0.1 V of 10 V is 12 r/min, and the contact closes at a tenth above it: t · n / n10 without that.
        let needed = 12.0 * (1150.0 - 13.2) / 1200.0;
        assert!((needed..needed + 0.05).contains(&(meshed - slows)), "{control}: {} s, not {needed}", meshed - slows);
        assert!((12.0..=13.2).contains(&speed), "{control}: {speed} r/min");
    }
}

#[test]
fn stage_waits_for_a_spindle_that_coasts() {
    // Friction of 2 Nm slows the chuck in minutes, not in the ramp.
    let fault = Event { t: 20.0, action: Action::InverterFault(true) };
    let lathe = downshift("gsk-980tdc", &[]);
    let mut planner = run_of(&lathe, Some(fault));
    planner.advance(60.0, usize::MAX);
    let now = Samples::at(&planner, 40.0).spindle;
    assert!(now.stage == 2 && now.actual > 400.0, "stage {} at {} r/min", now.stage, now.actual);
}

#[test]
fn spindle_at_rest_changes_gears_within_the_set_time() {
    let lathe = downshift("gsk-980tdc", &[]);
    let mut planner = run_of(&lathe, None);
    planner.advance(f64::INFINITY, usize::MAX);
    let engaged = (0..1000).map(|at| f64::from(at) * 0.005).find(|t| Samples::at(&planner, *t).spindle.stage == 2);
    // The first delay is an eighth of 2 s.
    assert!(engaged.is_some_and(|t| t < 0.35), "{engaged:?}");
}

#[test]
fn delay_alone_has_to_last_the_ramp() {
    let row = delay("gsk-980tdc", &[]);
    // The exported ladder waits for the shift speed: the delay of the maker's own one is a fact to know.
    assert_eq!((row.value, row.verdict, row.limit), (12.0, Verdict::None, None));
    let advice = macroline::text::catalog::sentence(&row.advice[0].message);
    assert!(advice.contains("the exported one waits for the speed") && advice.contains("DT000"), "{advice}");
    let row = delay("gsk-980tdc", &[("spindle-ramp", "5")]);
    assert_eq!((row.value, row.verdict), (5.0, Verdict::Ok));
    // The chuck's limit is the highest speed of each stage.
    assert_eq!(delay("gsk-980tdc", &[("chuck-limit", "100")]).value, 3.0);
    // No parameter of other controls has such a delay.
    assert_eq!(delay("fanuc-0i-tf", &[]).verdict, Verdict::None);
    let delays = |changes: &[(&str, &str)]| {
        let all = sheet("gsk-980tdc", changes);
        let row = all.lines().find(|line| line.starts_with("DT000")).expect("a row").to_owned();
        row.split(' ').nth(1).map(str::to_owned)
    };
    assert_eq!(delays(&CHUCK).as_deref(), Some("12000"));
    assert_eq!(delays(&[("spindle-ramp", "0")]).as_deref(), Some("250"));
}

#[test]
fn reset_in_a_gear_change_does_not_shorten_it() {
    // The lathe has one gear stage on the E60.
    for control in super::machine().controls().iter().filter(|control| **control != "mitsubishi-e60") {
        let mut lathe = project(control, &[("gear-time", "8")]);
        // Before a valve has switched, while the gears mesh, and in the delay after it.
        for t in [0.5, 2.0, 7.0] {
            lathe.panel = Default::default();
            lathe.panel.add(Event { t, action: Action::Reset });
            lathe.panel.add(Event { t: t + 0.1, action: Action::Start });
            let planner = super::over_time(&lathe);
            let fast = (0..4000).map(|at| f64::from(at) * 0.005).find(|at| {
                let now = Samples::at(&planner, *at).spindle;
                now.actual.abs() > 30.0
            });
            assert!(fast.is_some_and(|fast| fast > 8.0), "{control}, reset at {t}: fast at {fast:?}");
        }
    }
}

/// The stage of the program stays engaged: of two lathes whose gears take 10 s and none the further parts take the same time.
#[test]
fn part_of_a_series_changes_no_gear() {
    for control in ["gsk-980tdc", "sinumerik-802d", "fanuc-0i-tf"] {
        let cycle = |seconds: &'static str, gear: &'static str| {
            let entries = [("gear-time", seconds), ("gear-patience", "20"), ("gear", gear), ("upper-limit", "900")];
            crate::queries::sized_without_envelope(&project(control, &entries)).cycle.unwrap()
        };
        let (slow, fast) = (cycle("10", "2"), cycle("0", "2"));
        assert!((9.0..12.0).contains(&(slow.seconds - slow.further)), "{control}: {slow:?}");
        assert!((slow.further - fast.further).abs() < 0.05, "{control}: {slow:?} {fast:?}");
        assert_eq!(slow.parts_per_hour(), 3600.0 / slow.further, "{control}");
        // The machine begins in its first stage.
        let first = cycle("10", "1");
        assert_eq!(first.seconds, first.further, "{control}");
    }
}

#[test]
fn sheet_has_the_speed_of_a_gear_change() {
    for (control, rows) in [
        ("gsk-980tdc", &["No.067 100"][..]),
        ("fanuc-0i-tf", &["3705#1 GST 1", "3732 41"]),
        ("knd-k2000t", &["3705#1 GST 1", "3732 41"]),
        ("sinumerik-802d", &["MD35010 GEAR_STEP_CHANGE_ENABLE 1", "MD35400"]),
        ("sinumerik-808d", &["MD35010 GEAR_STEP_CHANGE_ENABLE 1", "MD35400"]),
    ] {
        let sheet = sheet(control, &CHUCK);
        for row in rows {
            assert!(sheet.lines().any(|line| line.starts_with(row)), "{control}: no {row} in {sheet}");
        }
    }
}

/// An output that is full in the only stage has a remedy in one entry: the cutting speed, the speed limit that an override lifts, or the lower
/// limit.
#[test]
fn full_output_in_the_only_stage_has_a_remedy() {
    let alone = [("stage-1", "500"), ("stage-2", "0"), ("stage-3", "0"), ("stage-4", "0")];
    let mut fields = std::collections::BTreeSet::new();
    for control in super::machine().controls() {
        for entries in [
            &[("speed-mode", "fixed"), ("cutting-speed", "200")][..],
            &[("speed-mode", "fixed"), ("cutting-speed", "50"), ("lower-limit", "600")],
            &[("speed-mode", "surface"), ("override", "120"), ("upper-limit", "490")],
        ] {
            let lathe = project(control, &[&alone[..], entries].concat());
            let row = crate::queries::readout(&lathe, "stage-speed");
            if row.verdict != Verdict::Fail {
                continue;
            }
            let [entry] = &row.advice[0].entries[..] else { panic!("{control} {entries:?}: {:?}", row.advice) };
            fields.insert(entry.field);
            let after = crate::queries::readout(&lathe.with_entries(&row.advice[0].entries).unwrap(), "stage-speed");
            assert_ne!(after.verdict, Verdict::Fail, "{control} {entries:?}: {entry:?}");
        }
    }
    assert!(fields.contains("cutting-speed") && fields.contains("lower-limit"), "{fields:?}");
}
