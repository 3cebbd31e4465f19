//! The program of the ribbon line, run as the text that goes to the machine.

use std::path::PathBuf;
use std::rc::Rc;

use super::ribbon_line::{control, machine, values};
use expect_test::expect_file;
use macroline::controls::Switches;
use macroline::interp::world::Still;
use macroline::interp::{self, Canon, End, Interp, Start};
use macroline::machines::form::{FieldInfo, KindInfo, Origins, Value, Values};
use macroline::machines::{self, Plan, settings};
use macroline::math::{self, PI, hypot};
use macroline::motion::{Action, Event, Keep, Limits, Mode, Panel, Planner, RunEnd, Setup};
use macroline::nc::{self, Emitted, Parsed};
use macroline::text::Severity;
use macroline::text::catalog::{Language, sentence};
use proptest::prelude::*;

fn plan(values: &Values) -> (Plan, Emitted) {
    let plan = machine().plan(values, control());
    let emitted = nc::emit(&plan.deck, control());
    (plan, emitted)
}

#[track_caller]
fn parsed(values: &Values) -> (Plan, Rc<Parsed>) {
    let (plan, emitted) = plan(values);
    let parsed = nc::parse(&emitted.files, control());
    let findings: Vec<_> = emitted.diagnostics.iter().chain(parsed.diagnostics()).collect();
    let said = |d: &&macroline::text::Diagnostic| format!("{:?}: {}", d.place, sentence(Language::English, &d.message));
    assert!(findings.is_empty(), "{:#?}", findings.iter().map(said).collect::<Vec<_>>());
    (plan, Rc::new(parsed))
}

fn world(percent: f64) -> Still {
    Still { inputs: vec![(1033, percent)], positions: [0.0; 6], block_skip: false }
}

/// The run program behind the set-up program, as on the machine: variables stay.
#[track_caller]
fn ready(values: &Values) -> Interp {
    let (plan, parsed) = parsed(values);
    let mut setup = Interp::new(parsed.clone(), Start::Program(plan.setup), &Switches::default());
    assert_eq!(interp::run(&mut setup, &mut world(100.0), 1000, |_, _| {}), Some(End::Program));
    let mut run = Interp::new(parsed, Start::Program(plan.main), &Switches::default());
    for (name, value) in setup.variables() {
        run.set_variable(name[1..].parse().unwrap(), Some(value));
    }
    run
}

/// What a run printed.
#[derive(Debug, Default, PartialEq)]
struct Printed {
    blocks: usize,
    x: f64,
    y: f64,
    feeds: Vec<f64>,
}

#[track_caller]
fn print(run: &mut Interp, percent: f64) -> Printed {
    let mut printed = Printed::default();
    let end = interp::run(run, &mut world(percent), 100_000_000, |canon, _| {
        if let Canon::Linear { to, feed: macroline::interp::Feed::PerMinute(feed), .. } = canon {
            printed.blocks += 1;
            printed.x = to.position[0] as f64 / 1000.0;
            printed.y = to.position[1] as f64 / 1000.0;
            if printed.feeds.last() != Some(feed) {
                printed.feeds.push(*feed);
            }
        }
    });
    assert_eq!(end, Some(End::Program));
    printed
}

#[track_caller]
fn near(value: f64, wanted: f64, tolerance: f64) {
    assert!((value - wanted).abs() <= tolerance, "{value}, expected {wanted} ± {tolerance}");
}

fn variable(run: &Interp, number: u32) -> f64 {
    run.variable(number).unwrap_or(f64::NAN)
}

#[test]
fn programs_as_they_go_to_the_machine() {
    let cases: &[(&str, &[(&str, &str)])] = &[
        ("default", &[]),
        ("published", &[("variant", "published"), ("pi", "3.14")]),
        (
            "degrees",
            &[
                ("y-unit", "degrees"),
                ("heads", "7"),
                ("wait", "fin"),
                ("override-form", "final-speed"),
                ("customer", "Müller (Köln) 100%"),
                ("product", "tape 8"),
            ],
        ),
    ];
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/data/machines/ribbon-line/mitsubishi-e60");
    for (name, changes) in cases {
        let (_, parsed) = parsed(&values(changes));
        for file in &parsed.files().0 {
            expect_file![folder.join(name).join(&file.name)].assert_eq(&file.text);
        }
    }
}

#[test]
fn the_papers_figures_by_running_the_text() {
    let mut run = ready(&values(&[]));
    let printed = print(&mut run, 100.0);
    assert_eq!((printed.blocks, printed.x), (500, 4000.0));
    near(printed.y, 500.0 * 62.831853071796, 0.001);
    near(variable(&run, 105), 15079.644737, 15079.644737 * 2e-9);
    near(variable(&run, 110), 62.831853, 1e-6);
    near(variable(&run, 115), 119391.393301, 119391.393301 * 2e-9);
    let mut run = ready(&values(&[("pi", "3.14")]));
    print(&mut run, 100.0);
    near(variable(&run, 105), 15072.0, 1e-9);
    near(variable(&run, 110), 62.8, 1e-12);
    near(variable(&run, 115), 119271.336603, 1e-6);
}

#[test]
fn the_final_speed_is_taken_as_it_is_and_stops_at_the_clamp() {
    for (word, speed) in [(960.0, 960.0), (1480.0, 1480.0), (1600.0, 1480.0)] {
        let mut run = ready(&values(&[("override-form", "final-speed"), ("pitch-count", "5")]));
        print(&mut run, word);
        near(variable(&run, 104), speed, 1e-9);
        near(variable(&run, 115), 119391.393301 / 1200.0 * speed, 0.001);
    }
}

#[test]
fn a_product_is_changed_by_variables_alone() {
    for variant in ["ready-made", "published"] {
        let mut run = ready(&values(&[("variant", variant)]));
        print(&mut run, 100.0);
        // The operator's screen between two starts: pitch, heads and count.
        for (number, value) in [(107, 10.0), (109, 47.0), (120, 30.0)] {
            run.set_variable(number, Some(value));
        }
        run.reset();
        let printed = print(&mut run, 100.0);
        assert_eq!(printed.blocks, 30);
        near(variable(&run, 110), PI * 120.0 / 47.0, 1e-7);
        near(variable(&run, 115), variable(&run, 105) * hypot(10.0, variable(&run, 110)) / 10.0, 1e-6);
        for (number, value) in [
            (100, 1200.0),
            (101, 25.0),
            (102, 100.0),
            (107, 10.0),
            (109, 47.0),
            (111, 120.0),
            (116, 1480.0),
            (119, 1e6),
            (120, 30.0),
            (121, 1.0),
        ] {
            assert_eq!(run.variable(number), Some(value), "the program wrote the operator's #{number}");
        }
    }
}

#[test]
fn a_second_start_prints_again() {
    let mut run = ready(&values(&[]));
    for _ in 0..2 {
        let before = run.position()[0];
        assert_eq!(print(&mut run, 100.0).blocks, 500);
        assert_eq!(run.position()[0] - before, 4_000_000);
        run.reset();
    }
}

#[test]
fn five_hundred_pitches_by_any_number_a_block_are_five_hundred() {
    for pitches in 1..=60 {
        let mut run = ready(&values(&[("pitches-per-block", &pitches.to_string())]));
        let printed = print(&mut run, 100.0);
        assert_eq!(printed.x, 4000.0, "by {pitches}");
        assert_eq!(printed.blocks, 500usize.div_ceil(pitches), "by {pitches}");
        near(printed.y, 500.0 * 62.831853071796, 0.001);
        assert_eq!(printed.feeds.len(), 1, "one feed: {:?}", printed.feeds);
    }
}

#[test]
fn y_after_a_million_pitches_is_within_one_increment() {
    for changes in
        [&[("pitch-count", "1000000")][..], &[("pitch-count", "1000000"), ("y-unit", "degrees"), ("heads", "7")]]
    {
        let mut run = ready(&values(changes));
        let printed = print(&mut run, 100.0);
        near(printed.y, variable(&run, 110) * 1e6, 0.001);
        assert_eq!(printed.x, 8e6);
    }
}

#[test]
fn entries_that_cannot_be_raise_the_controls_alarm_with_a_message() {
    for (number, value, text) in [
        (101, None, "#101 MUST BE ABOVE ZERO"),
        (107, Some(0.0), "#107 MUST BE ABOVE ZERO"),
        (111, Some(-120.0), "#111 MUST BE ABOVE ZERO"),
        (109, Some(2.5), "#109 MUST BE A WHOLE NUMBER"),
        (120, Some(0.0), "#120 MUST BE ABOVE ZERO"),
        (119, Some(1000.0), "FEED #115 ABOVE LIMIT #119"),
    ] {
        for variant in ["ready-made", "published"] {
            let mut run = ready(&values(&[("variant", variant)]));
            run.set_variable(number, value);
            match interp::run(&mut run, &mut world(100.0), 100_000, |canon, _| {
                assert!(!matches!(canon, Canon::SpindleDirection { .. }))
            }) {
                Some(End::Alarm(alarm)) => {
                    assert_eq!(alarm.alarm.as_deref(), Some("P277"));
                    let said = sentence(Language::English, &alarm.message);
                    assert!(said.contains(text), "{said}");
                }
                other => panic!("#{number}: {other:?}"),
            }
        }
    }
}

/// Blocks read from one pitch to the next, in the middle of a run.
#[test]
fn the_blocks_of_a_pass_are_counted_right() {
    for (variant, nc, macros) in [("ready-made", 1, 7), ("published", 1, 15)] {
        let mut run = ready(&values(&[("variant", variant)]));
        let mut counts = Vec::new();
        while counts.len() < 20 {
            if let macroline::interp::Step::Command(Canon::Linear { .. }, _) = run.step(&mut world(100.0)) {
                counts.push(run.blocks());
            }
        }
        let (a, b) = (counts[10], counts[11]);
        assert_eq!((b.nc - a.nc, b.macros - a.macros), (nc, macros), "{variant}");
        near(result(&values(&[("variant", variant)]), "block-needed"), 7.1 * nc as f64 + 3.0 * macros as f64, 1e-9);
    }
}

#[test]
fn a_dropped_program_restores_the_form() {
    let changes: &[(&str, &str)] = &[
        ("pitch", "12.5"),
        ("heads", "11"),
        ("y-unit", "degrees"),
        ("dancer", "true"),
        ("variant", "published"),
        ("pi", "3.14"),
        ("customer", "ACME 12"),
        ("reduction-ratio", "24.123456"),
        ("knob-step", "10"),
    ];
    let wanted = values(changes);
    let (_, emitted) = plan(&wanted);
    let fields = |id: &str| machines::find(id).map(|machine| machine.fields());
    for file in &emitted.files.0 {
        let (id, read) = settings::read(&file.text, fields).unwrap();
        assert_eq!(id, "ribbon-line");
        for (id, value) in wanted.iter() {
            assert_eq!(read.get(id), Some(value), "{id} of {}", file.name);
        }
        // What is not written has its default: the essential ones are written always.
        assert_eq!(read.iter().count(), wanted.iter().count() + 3, "{read:?}");
    }
    assert_eq!(settings::read("O1(NOTHING)\nM30", fields), None);
    assert_eq!(settings::read("(MACROLINE NO-MACHINE 1)", fields), None);
}

/// The run over time, `setup` done.
fn planned(values: &Values, events: Vec<Event>) -> Planner<Interp> {
    let plant = machine().plant(values, control());
    Planner::new(Setup {
        program: ready(values),
        control: control(),
        plant: &plant,
        plc: machine().plc(values, control(), &Switches::default()),
        panel: Panel::new(events),
        limits: Limits { blocks: 10_000_000, seconds: 3600.0 },
        keep: Keep::Timeline,
    })
}

fn result(values: &Values, id: &str) -> f64 {
    let design = machine().design(values, &Origins::new(), control());
    design.readouts.into_iter().find(|readout| readout.id == id).unwrap().value
}

#[test]
fn the_line_runs_at_the_designed_speed_without_a_stop_between_pitches() {
    for wait in ["dwell", "fin"] {
        let values = values(&[("wait", wait)]);
        let mut run = planned(&values, vec![]);
        let progress = run.advance(3600.0, 10_000_000);
        assert_eq!((progress.ended, run.starved()), (Some(RunEnd::ProgramEnd), 0));
        let middle = run.timeline().at(10.0);
        // Y words are rounded to 0.001 mm, and with them the direction of each block.
        near(middle.axes[0].feed, 15079.644737, 0.3);
        near(middle.axes[1].feed, 118435.25, 2.0);
        near(middle.spindle.volts, 8.107, 0.0005);
        near(middle.spindle.actual, 1214.616, 0.2);
        // The design's time of a product: first pull to last, and the wait.
        let end = run.timeline().end();
        near(end, result(&values, "product-time"), 2.6);
    }
}

#[test]
fn slack_in_the_run_is_the_designs() {
    for (dwell, wait) in [("2", "dwell"), ("0.5", "dwell"), ("5", "dwell"), ("2", "fin")] {
        // Without slip: with it the slack grows while X waits, too.
        let values =
            values(&[("dwell", dwell), ("wait", wait), ("no-load-speed", "1480"), ("rated-load-speed", "1480")]);
        let mut run = planned(&values, vec![]);
        run.advance(3600.0, 10_000_000);
        let end = run.timeline().end();
        let charts = machine().charts(&values, run.timeline(), 0.0, end, 2001);
        let slack = &charts.iter().find(|chart| chart.id == "slack").unwrap().series[0].points;
        let (middle, last) = (slack[1200].1, slack[2000].1);
        // The 12 bits of the output unwind 0.1 r/min less than is asked for: 0.25 mm in the time of a run.
        // A PLC that waits for the speed looks every 10 ms.
        let scan = if wait == "fin" { 2.6 } else { 0.0 };
        near(middle, result(&values, "slack-start"), 0.4 + scan);
        // M30 does not wait for the unwinder: its ramp of 1.6216 s has run for the 50 ms of FIN and lays down the rest.
        let rest = 251.327 * (1.6216 - 0.05) * (1.6216 - 0.05) / 1.6216 / 2.0;
        near(last - middle + rest, result(&values, "slack-stop"), 0.6);
    }
}

fn spindle_override(t: f64, percent: f64) -> Event {
    Event { t, action: Action::SpindleOverride(percent) }
}

#[test]
fn a_turned_knob_changes_x_and_spindle_alike() {
    let mut run = planned(&values(&[]), vec![spindle_override(8.0, 50.0), spindle_override(14.0, 110.0)]);
    run.advance(3600.0, 10_000_000);
    for (t, speed) in [(7.5, 1200.0), (12.0, 600.0), (17.0, 1320.0)] {
        let now = run.timeline().at(t);
        near(now.axes[0].feed, speed * 12.566370614, 0.3);
        near(now.spindle.command, speed, 1e-6);
    }
}

#[test]
fn override_0_waits_and_goes_on() {
    let mut run =
        planned(&values(&[("pitch-count", "200")]), vec![spindle_override(5.0, 0.0), spindle_override(60.0, 100.0)]);
    let progress = run.advance(3600.0, 10_000_000);
    assert_eq!(progress.ended, Some(RunEnd::ProgramEnd));
    let still = run.timeline().at(50.0);
    assert_eq!((still.axes[0].feed, still.mode), (0.0, Mode::Dwell));
    near(run.timeline().at(run.timeline().end()).axes[0].position, 1600.0, 1e-9);
    let blocks = run.blocks();
    assert!(blocks.nc + blocks.macros < 40_000, "the loop spins: {blocks:?}");
}

#[test]
fn entries_changed_while_it_runs_act_at_once() {
    let set = |number, value| Event { t: 6.0, action: Action::Variable(number, Some(value)) };
    // Pitch by 2 up and heads by 2 down: a mere sum of the entries would not notice.
    let mut run = planned(&values(&[]), vec![set(107, 10.0), set(109, 4.0)]);
    run.advance(3600.0, 10_000_000);
    let (a, b) = (run.timeline().at(8.0), run.timeline().at(9.0));
    let (x, y) = (b.axes[0].position - a.axes[0].position, b.axes[1].position - a.axes[1].position);
    near(x, 251.3274, 0.001);
    near(y / x, PI * 120.0 / 4.0 / 10.0, 1e-4);
    // The count of pitches is kept: some of 8 mm, the rest of 10.
    let end = run.timeline().at(run.timeline().end());
    let at = |pitches: f64| pitches * 8.0 + (500.0 - pitches) * 10.0;
    let pitches = (at(0.0) - end.axes[0].position) / 2.0;
    near(pitches, pitches.round(), 1e-6);
    assert!((100.0..140.0).contains(&pitches), "{pitches}");
}

#[test]
fn s_changed_while_it_runs_is_commanded_again() {
    let mut run = planned(&values(&[]), vec![Event { t: 6.0, action: Action::Variable(100, Some(900.0)) }]);
    run.advance(3600.0, 10_000_000);
    let now = run.timeline().at(12.0);
    near(now.spindle.command, 900.0, 1e-9);
    near(now.axes[0].feed, 900.0 * 12.566370614, 0.3);
}

/// Any value that a field takes; numbers evenly over their orders of magnitude.
fn any_value(field: FieldInfo) -> BoxedStrategy<(String, Value)> {
    let id = field.id.to_owned();
    let value = match field.kind {
        KindInfo::Number { min, max, decimals, .. } => {
            let scale: f64 = format!("1e{decimals}").parse().unwrap();
            let low = min.max(1.0 / scale);
            (0.0f64..=1.0, 0u8..20)
                .prop_map(move |(at, edge)| match edge {
                    0 => Value::Number(min),
                    1 => Value::Number(max),
                    _ => Value::Number(
                        ((low * math::exp(math::ln(max / low) * at) * scale).round() / scale).clamp(min, max),
                    ),
                })
                .boxed()
        }
        KindInfo::Flag(_) => any::<bool>().prop_map(Value::Flag).boxed(),
        KindInfo::Choice(options) => (0..options.len()).prop_map(|at| Value::Text(options[at].0.to_owned())).boxed(),
        KindInfo::Text(max) => {
            "[ -~äß%\n()]{0,40}".prop_map(move |text| Value::Text(text.chars().take(max).collect())).boxed()
        }
    };
    value.prop_map(move |value| (id.clone(), value)).boxed()
}

/// Any settings with which the program can be exported and is done after 300 pitches at most.
fn any_settings() -> impl Strategy<Value = Values> {
    let fields: Vec<_> = machine().fields().into_iter().map(any_value).collect();
    (fields, 1u32..300).prop_map(|(settings, count)| {
        let mut values: Values = settings.into_iter().collect();
        let number = |value: f64| Value::Number((value * 1000.0).round() / 1000.0);
        for id in ["clamp-x", "clamp-y", "feed-limit"] {
            values.insert(id.to_owned(), Value::Number(1e7));
        }
        values.insert("job".to_owned(), Value::Text("pitch-count".to_owned()));
        values.insert("pitch-count".to_owned(), number(f64::from(count)));
        // As fast as the control can read F.
        let share = 0.99e6 / result(&values, "vector-feed");
        for id in ["reduction-ratio", "press-roller-diameter"] {
            let Some(Value::Number(was)) = values.get(id) else { continue };
            let slower = if id == "reduction-ratio" { was / share.min(1.0) } else { *was };
            values.insert(id.to_owned(), number(slower.min(10_000.0)));
        }
        values
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(256))]

    /// Whatever the settings: the control has nothing to say about the text, it runs to the numbers of the closed form, it writes
    /// none of the operator's variables, and dropped again it restores the form.
    #[test]
    fn any_settings_give_a_clean_program_that_runs_to_the_closed_form(values in any_settings()) {
        let design = machine().design(&values, &Origins::new(), control());
        prop_assume!(design.diagnostics.iter().all(|d| d.severity != Severity::Error));
        let (_, parsed) = parsed(&values);
        for file in &parsed.files().0 {
            let (_, read) = settings::read(&file.text, |id| machines::find(id).map(|machine| machine.fields())).unwrap();
            for (id, value) in read.iter() {
                if !matches!(value, Value::Text(_)) {
                    prop_assert_eq!(values.get(id), Some(value), "{}", id);
                }
            }
        }
        let mut run = ready(&values);
        let entries: Vec<_> = run.variables().collect();
        let Some(Value::Number(knob)) = values.get("override") else { unreachable!() };
        let Some(Value::Text(step)) = values.get("knob-step") else { unreachable!() };
        let step: f64 = step.parse().unwrap();
        let percent = (knob / step).round() * step;
        prop_assume!(percent > 0.0);
        let final_speed = values.get("override-form") == Some(&Value::Text("final-speed".to_owned()));
        let printed = print(&mut run, if final_speed { result(&values, "actual-speed") } else { percent });
        for (name, value) in entries {
            let number = name[1..].parse().unwrap();
            prop_assert_eq!(run.variable(number), Some(value), "{} was written", name);
        }
        // The digits of π in the text are 2e-10 off, and the vector feed has them twice.
        for (number, id) in [(104, "actual-speed"), (105, "line-speed"), (110, "y-stroke"), (115, "vector-feed")] {
            let wanted = result(&values, id);
            near(variable(&run, number), wanted, wanted * 1e-9);
        }
        near(printed.x, result(&values, "product-length"), 1e-6);
        near(printed.y, variable(&run, 110) * result(&values, "dots-per-product"), 0.001);
    }
}
