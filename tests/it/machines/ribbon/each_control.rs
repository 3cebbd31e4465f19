//! The ribbon line on every control: one motion, each control's own words.

use expect_test::{Expect, expect};
use macroline::controls::Address;
use macroline::interp::Interp;
use macroline::machines::ControlContext;
use macroline::machines::form::{Origins, Values};
use macroline::motion::{Action, Budget, Event, Panel, Planner, Retention, RunEnd};
use macroline::project::run::{self, RunOptions};
use macroline::project::{Project, import};
use macroline::text::catalog::sentence;
use macroline::text::{Diagnostic, Severity};
use macroline::view::{Limit, Verdict};

use super::{at_defaults, controls, machine, values};

/// The lathe controls that count everything: absolute words X, incremental words U.
fn lathes() -> impl Iterator<Item = &'static str> {
    let lathe = |control: &&macroline::controls::Control| control.axes.iter().any(|axis| axis.incremental.is_some());
    controls().filter(lathe).map(|control| control.id)
}

pub(super) fn project(control: &str, changes: &[(&str, &str)]) -> Project {
    let mut project = Project::of_form(machine(), macroline::controls::find(control).unwrap());
    project.values.extend(values(changes));
    project
}

/// The project over time, to its end.
pub(in crate::machines) fn over_time(project: &Project, events: Vec<Event>) -> Planner<Interp> {
    let mut planner = begun(project, events);
    planner.advance(f64::INFINITY, usize::MAX);
    planner
}

/// The run of the project at its begin.
pub(in crate::machines) fn begun(project: &Project, events: Vec<Event>) -> Planner<Interp> {
    let mut project = project.clone();
    for event in events {
        project.panel.add(event);
    }
    let limits = Budget { blocks: 10_000_000, seconds: 3600.0 };
    let begin = RunOptions { start: None, settings: &[], limits, keep: Retention::Timeline };
    run::of_project(&project, &project.written(), &begin)
}

pub(in crate::machines) fn ended(planner: &mut Planner<Interp>) -> RunEnd {
    planner.advance(f64::INFINITY, usize::MAX).ended.unwrap()
}

/// When the first cutting block begins.
pub(super) fn first_cut(project: &Project, planner: &Planner<Interp>) -> f64 {
    let files = project.written().files;
    let mut t = 0.0;
    loop {
        t = planner.timeline().next_block(t).expect("it cuts");
        let place = planner.timeline().block_at(t).unwrap();
        if files.0[place.file.0 as usize].text[place.span.start as usize..place.span.end as usize]
            .split_whitespace()
            .any(|word| matches!(word, "G01" | "G1"))
        {
            return t;
        }
    }
}

/// Indices of the pull axis and the print roller's.
fn axes(project: &Project, print: Address) -> [usize; 2] {
    [project.control.axis(Address::X).unwrap(), project.control.axis(print).unwrap()]
}

fn sentences(found: &[Diagnostic]) -> Vec<String> {
    found.iter().map(|d| sentence(&d.message)).collect()
}

#[test]
fn case_that_all_controls_accept_moves_alike() {
    // Block times are set equal, because they belong to the control, not to the machine.
    let same = [("block-time", "7.1"), ("macro-time", "3"), ("preread", "5"), ("spindle-speed", "100")];
    let changes: Vec<_> = same.into_iter().chain([("pitch-count", "20")]).collect();
    let degrees: Vec<_> = changes.iter().copied().chain([("print-axis", "c"), ("y-unit", "degrees")]).collect();
    for (changes, print) in [(changes, Address::Y), (degrees, Address::C)] {
        let mut moved: Vec<Vec<[f64; 2]>> = Vec::new();
        for control in controls() {
            let project = project(control.id, &changes);
            let planner = over_time(&project, vec![]);
            assert_eq!(planner.starved(), 0);
            // The print roller of a control without diameter words is always on Y.
            let lathe = control.axes.iter().any(|axis| axis.letter == Address::X && axis.diameter);
            let letter = if lathe && control.axis(print).is_some() { print } else { Address::Y };
            let axes = axes(&project, letter);
            let begin = first_cut(&project, &planner);
            let at = |t: f64| axes.map(|k| planner.timeline().at(begin + t).axes[k].position);
            moved.push((0..500).map(|i| at(f64::from(i) * 0.02)).collect());
        }
        let last = moved[0][499];
        assert!((last[0] - 160.0).abs() < 1e-9, "20 pitches of 8 mm: {last:?}");
        for other in &moved[1..] {
            for (a, b) in moved[0].iter().zip(other) {
                assert!((a[0] - b[0]).abs() < 1e-6 && (a[1] - b[1]).abs() < 1e-6, "{a:?} {b:?}");
            }
        }
    }
}

#[test]
fn x_words_count_diameter_or_radius_by_switch() {
    for (id, setting, word) in [
        ("gsk-980tdc", "diameter", "N31 #129=#107*#128*2 (X PER BLOCK, DIAMETER)"),
        ("knd-k2000t", "radius", "N31 #129=#107*#128 (X PER BLOCK)"),
    ] {
        let mut project = project(id, &[("spindle-speed", "100"), ("pitch-count", "3")]);
        project.switches.0.push(("diameter".to_owned(), setting.to_owned()));
        assert!(project.written().files.0[0].text.contains(word));
        let planner = over_time(&project, vec![]);
        let end = planner.timeline().end();
        assert!((planner.timeline().at(end).axes[0].position - 24.0).abs() < 1e-9);
        assert_eq!(planner.timeline().words_at(end)[0], if setting == "radius" { 24.0 } else { 48.0 });
    }
}

#[test]
fn feed_above_control_range_names_the_possible_speed() {
    let fast = project("gsk-980tdc", &[]);
    let design = fast.design();
    let feed = design.readouts.iter().find(|row| row.id == "vector-feed").unwrap();
    assert_eq!((feed.verdict, feed.limit), (Verdict::Fail, Some(Limit::AtMost(15_000.0 / 1.2))));
    let advice: Vec<_> = feed.advice.iter().map(|advice| sentence(&advice.message)).collect();
    assert_eq!(
        advice,
        [
            "the control takes 15000: at most 150 r/min",
            "That makes another result fail: Grip of the nip in use.",
            "The vector feed would be 119391.393 mm/min, the control takes 15000 at most.",
            "At most 150 r/min of the unwinder keep within the limits of the axes and of F: as its S, and as its clamp, beyond which the knob cannot go.",
            "Or take the feed per revolution, F99.493 mm: the range of F per minute does not bind it. It needs a spindle encoder on the unwinder.",
        ]
    );
    // The text is read all the same, and stops before anything moves.
    let export = fast.export();
    assert!(export.files.iter().map(|exported| &exported.file).any(|file| file.name == "O9101.nc"));
    assert!(sentences(&export.diagnostics).iter().any(|text| text.starts_with("The vector feed would be 119391.393")));
    let mut stopped = over_time(&fast, vec![]);
    let RunEnd::Alarm(alarm) = ended(&mut stopped) else { panic!("it stops") };
    assert_eq!(sentence(&alarm.message), "The program raises its alarm 20: FEED #115 ABOVE LIMIT #119");
    assert_eq!(stopped.timeline().at(stopped.timeline().end()).spindle.command, 0.0);
    // The speed that the message names runs through.
    let mut slow = over_time(&project("gsk-980tdc", &[("spindle-speed", "150"), ("pitch-count", "5")]), vec![]);
    assert_eq!(ended(&mut slow), RunEnd::ProgramEnd);
    // The K2000T runs at S1200 as the E60 does.
    for id in ["mitsubishi-e60", "knd-k2000t"] {
        let mut runs = over_time(&project(id, &[("pitch-count", "5")]), vec![]);
        assert_eq!(ended(&mut runs), RunEnd::ProgramEnd, "{id}");
    }
}

#[test]
fn f_range_on_the_802d_is_reported_with_its_numbers() {
    for (rpm, fits) in [("600", true), ("1000", true), ("1005", true), ("1006", false), ("1200", false)] {
        let project = project(
            "sinumerik-802d",
            &[("spindle-speed", rpm), ("speed-clamp", rpm), ("pitch-count", "5"), ("spindle-encoder", "true")],
        );
        let design = project.design();
        let feed = design.readouts.iter().find(|row| row.id == "vector-feed").unwrap();
        assert_eq!((feed.verdict == Verdict::Fail, feed.limit), (!fits, Some(Limit::AtMost(99_999.999))), "{rpm}");
        let mut planner = over_time(&project, vec![]);
        assert_eq!(ended(&mut planner) == RunEnd::ProgramEnd, fits, "{rpm}");
        if rpm == "1200" {
            let advice: Vec<_> = feed.advice.iter().map(|advice| sentence(&advice.message)).collect();
            expect![[r#"
                the control takes 99999.999: at most 1005 r/min
                The vector feed would be 119391.393 mm/min, the control takes 99999.999 at most.
                At most 1005 r/min of the unwinder keep within the limits of the axes and of F: as its S, and as its clamp, beyond which the knob cannot go.
                Or take the feed per revolution, F99.493 mm: the range of F per minute does not bind it. It needs a spindle encoder on the unwinder.
            "#]].assert_eq(&(advice.join("\n") + "\n"));
        }
    }
}

#[test]
fn feed_per_revolution_follows_the_unwinder_everywhere() {
    let knob = |t: f64, percent: f64| Event { t, action: Action::SpindleOverride(percent) };
    for control in controls() {
        let changes =
            [("feed-form", "per-revolution"), ("spindle-encoder", "true"), ("dwell", "0"), ("pitches-per-block", "3")];
        let project = project(control.id, &changes);
        let mut planner = over_time(&project, vec![knob(4.0, 50.0), knob(8.0, 110.0)]);
        assert_eq!(ended(&mut planner), RunEnd::ProgramEnd, "{}", control.id);
        assert_eq!(planner.starved(), 0);
        let now = |t: f64| planner.timeline().at(t);
        // K of ribbon per turn at any position of the knob and any slip of the motor; F is read in steps of 0.001.
        for (from, to) in [(3.0, 3.9), (6.0, 7.9), (10.0, 11.9)] {
            let pulled = now(to).axes[0].position - now(from).axes[0].position;
            let turns = now(to).spindle.turns - now(from).spindle.turns;
            assert!((pulled / turns / 12.566370614 - 1.0).abs() < 1e-5, "{}: {}", control.id, pulled / turns);
        }
        // In ramps, too: the loop never takes more than the lag of X at 110 %, half its time constant and its gain, and the turns of the
        // unwinder before the program has read its first block.
        let end = planner.ended_at().unwrap() - 0.5;
        let charts = project.prepared().charts(&planner, 0.0, end, 2000);
        let slack = &charts.iter().find(|chart| chart.id == "slack").unwrap().series[0].points;
        let lag = 280.0 * (0.05 + 1.0 / 33.0) + 4.0;
        let most = slack.iter().map(|(_, mm)| *mm).fold(0.0, f64::max);
        let least = slack.iter().map(|(_, mm)| *mm).fold(0.0, f64::min);
        assert!(least > -0.01 && most < lag, "{}: {least} to {most}", control.id);
    }
}

#[test]
fn feed_per_revolution_without_encoder_is_an_error() {
    for control in controls() {
        let project = project(control.id, &[("feed-form", "per-revolution")]);
        let export = project.export();
        assert!(export.files.is_empty());
        let error = export.diagnostics.iter().find(|d| d.severity == Severity::Error).unwrap();
        assert_eq!(error.field, Some("spindle-encoder"));
    }
}

#[test]
fn feed_per_revolution_design_equals_its_run() {
    for (dwell, ramp) in [("0", "2"), ("0.5", "2"), ("2", "1")] {
        let project = project(
            "knd-k2000t",
            &[
                ("feed-form", "per-revolution"),
                ("spindle-encoder", "true"),
                ("dwell", dwell),
                ("inverter-ramp", ramp),
                ("no-load-speed", "1480"),
                ("rated-load-speed", "1480"),
            ],
        );
        let planner = over_time(&project, vec![]);
        let design = project.design();
        let result = |id: &str| design.readouts.iter().find(|row| row.id == id).unwrap().value;
        let charts = project.prepared().charts(&planner, 0.0, 15.0, 1501);
        let slack = charts.iter().find(|chart| chart.id == "slack").unwrap().series[0].points[1000].1;
        // A scan of the PLC and the steps of F.
        assert!((slack - result("slack-start")).abs() < 1.0, "{dwell} {ramp}: {slack} {}", result("slack-start"));
        let end = planner.ended_at().unwrap();
        // FIN of S, M3 and M5, the ramp's remainder, and the program's own blocks.
        assert!((end - result("product-time")).abs() < 0.3, "{dwell} {ramp}: {end} {}", result("product-time"));
    }
}

#[test]
fn plc_passes_the_override_in_the_controls_word() {
    for (id, word) in [("mitsubishi-e60", 1033), ("gsk-980tdc", 1032), ("knd-k2000t", 1032)] {
        let project = project(id, &[("spindle-speed", "100")]);
        let knob = Event { t: 2.0, action: Action::SpindleOverride(80.0) };
        let planner = over_time(&project, vec![knob]);
        assert_eq!((planner.variable_at(word, 1.9), planner.variable_at(word, 2.1)), (Some(100.0), Some(80.0)), "{id}");
        assert_eq!(planner.timeline().at(3.0).spindle.command, 80.0);
        let rows = project.prepared().variables();
        assert!(rows.iter().any(|row| row.number == word));
    }
}

#[test]
fn second_start_prints_again() {
    for control in controls() {
        let project = project(control.id, &[("spindle-speed", "100"), ("pitch-count", "5")]);
        let mut planner = over_time(&project, vec![]);
        let end = planner.timeline().end();
        planner.event(Event { t: end + 1.0, action: Action::Start });
        assert_eq!(ended(&mut planner), RunEnd::ProgramEnd, "{}", control.id);
        assert!((planner.timeline().at(planner.timeline().end()).axes[0].position - 80.0).abs() < 1e-9);
    }
}

#[test]
fn fields_without_a_choice_are_hidden() {
    let hidden = |id: &str, changes: &[(&str, &str)]| {
        machine().prepare(&values(changes), at_defaults(macroline::controls::find(id).unwrap())).hidden().join(" ")
    };
    assert_eq!(hidden("mitsubishi-e60", &[]), "knob-use encoder-lines encoder-turns spindle-turns print-axis rest");
    assert_eq!(
        hidden("mitsubishi-e60", &[("print-axis", "c")]),
        "knob-use encoder-lines encoder-turns spindle-turns print-axis rest"
    );
    assert_eq!(
        hidden("gsk-980tdc", &[]),
        "override-form knob-use encoder-lines encoder-turns spindle-turns rest path-mode"
    );
    assert_eq!(
        hidden("gsk-980tdc", &[("print-axis", "c")]),
        "override-form knob-use encoder-lines encoder-turns spindle-turns y-unit rest path-mode"
    );
    assert_eq!(
        hidden("knd-k2000t", &[("print-axis", "z")]),
        "override-form knob-use encoder-lines encoder-turns spindle-turns y-unit rest"
    );
}

#[test]
fn values_that_a_control_lacks_have_no_effect() {
    let chosen =
        [("override-form", "final-speed"), ("path-mode", "exact-stop"), ("print-axis", "c"), ("y-unit", "degrees")];
    let text = |id: &str, changes: &[(&str, &str)]| -> String {
        let files = project(id, changes).written().files.0;
        let lines = files.iter().flat_map(|file| file.text.lines()).filter(|line| !line.starts_with('('));
        lines.collect::<Vec<_>>().join("\n")
    };
    // Neither a final speed nor an exact stop; C counts degrees with any unit of Y.
    assert_eq!(text("gsk-980tdc", &chosen), text("gsk-980tdc", &chosen[2..3]));
    assert_eq!(text("mitsubishi-e60", &chosen[2..3]), text("mitsubishi-e60", &[]));
}

#[test]
fn change_of_control_keeps_the_values() {
    let mut project = project("mitsubishi-e60", &[("pitch", "12.5"), ("heads", "47")]);
    project.switches.0.push(("macro-input-base".to_owned(), "R172".to_owned()));
    project.switches.0.push(("locals-of-calls".to_owned(), "kept".to_owned()));
    let before = project.clone();
    for id in lathes() {
        project.move_to(macroline::controls::find(id).unwrap());
        assert!(project.values == before.values);
        // Settings that the other control lacks are dropped; settings that the line needs there are added.
        let setting = |id: &str| project.switches.setting(project.control.switch(id).unwrap());
        assert_eq!((setting("locals-of-calls"), setting("common-at-reset")), ("kept", "kept"));
        let back = Project::from_json(&project.to_json());
        assert!(back.diagnostics.is_empty() && back.project.unwrap() == project);
    }
}

#[test]
fn change_of_control_keeps_knobs_and_drops_actions_of_the_run() {
    let mut project = project("mitsubishi-e60", &[]);
    let event = |t, action| Event { t, action };
    project.panel = Panel::new([
        event(0.0, Action::SpindleOverride(80.0)),
        event(1.0, Action::Hold),
        event(2.0, Action::EmergencyStop),
        event(3.0, Action::Variable(107, Some(9.0))),
        event(4.0, Action::SingleBlock(true)),
    ]);
    project.move_to(macroline::controls::find("sinumerik-802d").unwrap());
    let kept = [event(0.0, Action::SpindleOverride(80.0)), event(4.0, Action::SingleBlock(true))];
    assert_eq!(project.panel.events(), kept);
}

#[test]
fn new_project_has_times_and_ranges_of_its_control() {
    let value = |id: &str, field: &str| project(id, &[]).values.get(field).cloned();
    for (field, text) in [("block-time", "8"), ("macro-time", "4"), ("preread", "3"), ("feed-limit", "15000")] {
        assert_eq!(value("gsk-980tdc", field), values(&[(field, text)]).get(field).cloned());
    }
    let fields = machine().fields();
    let e60 = project("mitsubishi-e60", &[]).values;
    assert!(
        fields.iter().all(|field| e60.get(field.id) == Some(&field.default())),
        "the paper's machine is the default"
    );
}

#[test]
fn dropped_program_selects_its_control() {
    let present = project("mitsubishi-e60", &[]);
    for id in lathes() {
        let wanted = project(id, &[("pitch", "12.5"), ("print-axis", "c"), ("spindle-speed", "100")]);
        for file in wanted.written().files.0 {
            let opened = import::open(&present, std::slice::from_ref(&file)).project.unwrap();
            assert_eq!(opened.control.id, id);
            assert!(opened.values == wanted.values && opened.edited.is_none(), "{}", file.name);
        }
    }
}

pub(super) fn rows(on: ControlContext, changes: &[(&str, &str)], id: &str) -> String {
    let sheets = machine().prepare(&values(changes), on).sheets();
    let sheet = sheets.into_iter().find(|sheet| sheet.id == id).unwrap();
    sheet.rows.iter().map(|row| row.cells.join(" | ") + "\n").collect()
}

fn check(control: &str, changes: &[(&str, &str)], sheet: &str, wanted: Expect) {
    wanted.assert_eq(&rows(at_defaults(macroline::controls::find(control).unwrap()), changes, sheet));
}

#[test]
fn lathe_parameter_sheets_match_their_goldens() {
    check(
        "gsk-980tdc",
        &[("print-axis", "c"), ("spindle-encoder", "true")],
        "parameters",
        expect![[r#"
            No.001#1 |  |  | 0 |  | 0: 0.001 mm (IS-B), 1: 0.0001 mm (IS-C)
            No.001#2 |  | X | 0 |  | words of X: 0 diameters, 1 radii
            No.001#4 |  |  | 1 |  | 1: analog voltage, 0: gears by contacts
            No.005#4 |  |  | 1 |  | M30: 1 goes back to the first block, 0 stays at the end
            No.007#6 |  |  | 0 |  | 0: smooth from block to block, 1: each block ends in position
            No.015 | CMR | X | 113 |  | numerator: counts of the encoder per turn of the motor
            No.015 | CMR | C | 25 |  | numerator: counts of the encoder per turn of the motor
            No.016 | CMD | X | 71 |  | denominator: output units of 0.001 mm per turn (X by diameters: 0.0005 mm), both in lowest terms
            No.016 | CMD | C | 18 |  | denominator: output units of 0.001 mm per turn (X by diameters: 0.0005 mm), both in lowest terms
            No.022 |  | X | 20000 | mm/min | rapid traverse
            No.022 |  | C | 150000 | °/min | rapid traverse
            No.027 |  | X | 40000 | mm/min | upper limit of the cutting feed; of X as diameter
            No.027 |  | C | 150000 | °/min | upper limit of the cutting feed; of X as diameter
            No.029 |  | X | 100 | ms | time constant of acceleration, cutting feed, 10 to 4000
            No.029 |  | C | 100 | ms | time constant of acceleration, cutting feed, 10 to 4000
            No.037 |  |  | 1480 | r/min | spindle speed at 10 V, gear 1
            No.043 |  |  | 0 | r/min | smallest spindle speed at constant surface speed
            No.069 |  |  | 1 |  | 1: spindle encoder fitted
            No.070 |  |  | 1024 |  | lines of the spindle encoder, 100 to 10000
            No.072 |  |  | 0 | ms | delay until the signal of reached speed is looked at
            No.075 |  |  | 1480 | r/min | spindle speed clamp, 0: none
            No.175#6 |  |  | 0 |  | 1: cuts wait for the signal of reached speed
            No.187#0 |  | C | 01 |  | kind of the additional axes: 00 linear, 01 and 11 rotary, 10 none
            No.196#4 |  |  | 0 |  | 1: several spindles
            No.252 |  | X | 0 |  | acceleration of cutting feed: 0 linear, 1 S-shaped
            No.252 |  | C | 0 |  | acceleration of cutting feed: 0 linear, 1 S-shaped
            K10 RESB |  |  | 1 |  | reset: 1 goes back to the first block, 0 stays in the program; for the maker's own ladder
        "#]],
    );
    check(
        "knd-k2000t",
        &[("print-axis", "z")],
        "parameters",
        expect![[r#"
            1006#3 | DIA | X | 1 |  | 1: words of the axis count diameters
            1420 |  | X | 20000 | mm/min | rapid traverse
            1420 |  | Z | 150000 | mm/min | rapid traverse
            1422 |  |  | 151328 | mm/min | upper limit of the cutting feed along the path
            1430 |  | X | 20000 | mm/min | upper limit of the cutting feed of an axis
            1430 |  | Z | 150000 | mm/min | upper limit of the cutting feed of an axis
            1601#5 | NCI |  | 0 |  | 0: in-position check at deceleration, 1: none
            1610#0 | CTL | X | 1 |  | acceleration of cutting feed: 0 exponential, 1 linear
            1610#0 | CTL | Z | 1 |  | acceleration of cutting feed: 0 exponential, 1 linear
            1620 |  | X | 100 | ms | time constant of acceleration, rapid traverse
            1620 |  | Z | 100 | ms | time constant of acceleration, rapid traverse
            1622 |  | X | 100 | ms | time constant of acceleration, cutting feed
            1622 |  | Z | 100 | ms | time constant of acceleration, cutting feed
            1820 | CMR | X | 102 |  | command to detection units: 2 is 1, 102 is 1/2 (diameters)
            1820 | CMR | Z | 2 |  | command to detection units: 2 is 1, 102 is 1/2 (diameters)
            1821 |  | X | 3550000 |  | reference counter: detection units per turn of the motor
            1821 |  | Z | 60997159 |  | reference counter: detection units per turn of the motor
            1825 |  | X | 3300 | 0.01/s | servo loop gain
            1825 |  | Z | 3300 | 0.01/s | servo loop gain
            1826 |  | X | 20 | 0.001 mm | in-position width
            1826 |  | Z | 20 | 0.001 mm | in-position width
            2084 | N | X | 71 |  | flexible feed gear, numerator: detection units per turn of the motor
            2084 | N | Z | 2362 |  | flexible feed gear, numerator: detection units per turn of the motor
            2085 | M | X | 2260 |  | its denominator: 1 000 000 counts, both in lowest terms
            2085 | M | Z | 31327 |  | its denominator: 1 000 000 counts, both in lowest terms
            2179 |  | X | 113 |  | denominator of the reference counter, where it is no whole number
            2179 |  | Z | 809 |  | denominator of the reference counter, where it is no whole number
            3202#4 | NE9 |  | 0 |  | 1: programs 9000 to 9999 cannot be edited; 0 to load O9120
            3701#1 | ISI |  | 1 |  | 0: serial spindle, 1: analog; or 3716#0, where 0 is analog
            3708#0 | SAR |  | 0 |  | 1: cuts wait for the signal of reached speed
            3740 |  |  | 0 | ms | delay until the signal of reached speed is looked at
            3741 |  |  | 1480 | r/min | spindle speed at 10 V, gear 1
            3771 |  |  | 0 | r/min | smallest spindle speed at constant surface speed
            3772 |  |  | 1480 | r/min | spindle speed clamp, 0: none
            4002#1 |  |  | 0 |  | 1: encoder of a serial spindle fitted; an analog one has none
            6000#5 | SBM |  | 0 |  | 1: macro blocks stop in single block
            6001#6 | CCV |  | 1 |  | 0: #100 to #199 become vacant at reset
        "#]],
    );
}

#[test]
fn operator_notes_of_each_control_match() {
    let warnings = |id: &str| -> String {
        let design = machine()
            .prepare(&Values::new(), at_defaults(macroline::controls::find(id).unwrap()))
            .design(&Origins::new());
        let infos =
            design.diagnostics.iter().filter(|d| d.severity == Severity::Info && d.message.id != "form.assumed");
        infos.map(|d| sentence(&d.message) + "\n").collect()
    };
    expect![[""]].assert_eq(&warnings("mitsubishi-e60"));
    expect![[r#"
        This control forgets #100 and up at power-off: run O9102 once after each power-on.
    "#]]
    .assert_eq(&warnings("gsk-980tdc"));
    // K · 1200 r/min of the published machine: 251 mm/s, 310 with the knob at its highest position.
    expect![[r#"
        The PLC fixes the feed override at 100 %, which no manual at hand confirms for this control; the position 0 % still stops the axes. The unwinder keeps its 251 mm/s, and the loop of 500 mm is full after 2 s.
    "#]].assert_eq(&warnings("sinumerik-808d"));
    expect![[r#"
        This control forgets #100 and up at power-off: run O9102 once after each power-on.
    "#]]
    .assert_eq(&warnings("knd-k2000t"));
}
