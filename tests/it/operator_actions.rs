//! The operator's actions as a list: edited, kept in a file, with the values that machine and control allow.

use macroline::controls;
use macroline::drives::speed::SpeedLimit;
use macroline::motion::{Action, ActionValue, Event, Panel};
use macroline::project::Project;
use macroline::project::import::FileKind;
use macroline::project::operator::{
    available, in_steps, kind_name, name, read_time, read_value, time_step, typed_time, typed_value, unit,
};
use macroline::project::program::Written;
use macroline::project::run::{self, RunOptions};
use macroline::project::saved::{panel_from_json, panel_to_json};
use macroline::text::catalog::sentence;

fn at(t: f64, action: Action) -> Event {
    Event { t, action }
}

fn feed(t: f64, percent: f64) -> Event {
    at(t, Action::FeedOverride(percent))
}

fn on(machine: &str, control: &str) -> Project {
    Project::of(machine, Some(control)).unwrap()
}

/// All actions of a machine on a control.
fn actions(machine: &str, control: &str) -> Vec<Action> {
    available(&on(machine, control)).into_iter().flat_map(|group| group.actions).collect()
}

#[test]
fn moved_action_goes_behind_those_of_its_new_time() {
    let mut panel = Panel::new([feed(1.0, 10.0), feed(2.0, 20.0), feed(2.0, 30.0), feed(3.0, 40.0)]);
    assert_eq!(panel.replace(0, feed(2.0, 10.0)), Some(2));
    assert_eq!(panel.replace(3, feed(0.5, 40.0)), Some(0));
    assert_eq!(panel.events(), [feed(0.5, 40.0), feed(2.0, 20.0), feed(2.0, 30.0), feed(2.0, 10.0)]);
}

#[test]
fn changed_value_keeps_the_order_of_one_time() {
    let mut panel = Panel::new([feed(2.0, 20.0), feed(2.0, 30.0)]);
    assert_eq!(panel.replace(0, feed(2.0, 25.0)), Some(0));
    assert_eq!(panel.events(), [feed(2.0, 25.0), feed(2.0, 30.0)]);
}

#[test]
fn place_without_an_action_changes_nothing() {
    let mut panel = Panel::new([feed(1.0, 10.0)]);
    assert_eq!((panel.replace(1, feed(0.0, 0.0)), panel.remove(1)), (None, None));
    assert_eq!(panel.remove(0), Some(feed(1.0, 10.0)));
    assert!(panel.events().is_empty());
}

#[test]
fn times_out_of_range_are_limited_when_replaced() {
    let mut panel = Panel::new([feed(1.0, 10.0), feed(2.0, 20.0)]);
    assert_eq!(panel.replace(1, feed(-5.0, 20.0)), Some(0));
    assert_eq!(panel.replace(0, feed(f64::NAN, 20.0)), Some(0));
    assert_eq!(panel.replace(0, feed(f64::INFINITY, 20.0)), Some(1));
    assert_eq!(panel.events(), [feed(1.0, 10.0), feed(f64::MAX, 20.0)]);
}

#[test]
fn first_difference_is_the_earlier_time_of_the_two() {
    let panel = |events: &[Event]| Panel::new(events.iter().cloned());
    let one = panel(&[feed(1.0, 10.0), feed(4.0, 20.0)]);
    assert_eq!(one.differs_from(&one), None);
    assert_eq!(one.differs_from(&panel(&[feed(1.0, 10.0)])), Some(4.0));
    assert_eq!(one.differs_from(&panel(&[feed(1.0, 10.0), feed(3.0, 5.0), feed(4.0, 20.0)])), Some(3.0));
    assert_eq!(panel(&[]).differs_from(&one), Some(1.0));
}

#[test]
fn every_available_action_takes_its_own_value_and_no_other() {
    for machine in macroline::machines::ALL {
        for control in machine.controls() {
            for action in actions(machine.id(), control) {
                let own = action.value();
                assert_eq!(own.map_or(Some(action.clone()), |value| action.with_value(value)).as_ref(), Some(&action));
                for other in [ActionValue::Number(1.0), ActionValue::State(true), ActionValue::Vacant] {
                    let same_kind =
                        own.is_some_and(|own| core::mem::discriminant(&own) == core::mem::discriminant(&other));
                    let vacant = matches!(action, Action::Variable(..)) && other == ActionValue::Vacant;
                    assert_eq!(action.with_value(other).is_some(), same_kind || vacant, "{action:?} {other:?}");
                }
            }
        }
    }
}

#[test]
fn actions_are_there_where_machine_and_control_have_them() {
    let has = |machine: &str, control: &str, action: Action| actions(machine, control).contains(&action);
    let limit = |limit| Action::SpeedLimit(limit, 1000.0);
    for (machine, control, zero, limits, surface) in [
        ("ribbon-line", "mitsubishi-e60", false, false, false),
        ("turning-spindle", "gsk-980tdc", true, false, true),
        ("turning-spindle", "sinumerik-808d", false, true, true),
    ] {
        assert_eq!(has(machine, control, Action::ProgramZeroReturn), zero, "{control}");
        assert_eq!(has(machine, control, limit(SpeedLimit::Lower)), limits, "{control}");
        assert_eq!(has(machine, control, limit(SpeedLimit::Upper)), limits, "{control}");
        assert_eq!(has(machine, control, limit(SpeedLimit::Surface)), surface, "{control}");
    }
    assert!(has("ribbon-line", "mitsubishi-e60", Action::InverterFault(true)));
    let polygon = available(&Project::of("polygon-lathe", None).unwrap());
    assert!(!polygon.iter().any(|group| group.actions.contains(&Action::InverterFault(true))));
    assert!(has("ribbon-line", "mitsubishi-e60", Action::Input("#1033".into(), 0.0)));
    assert!(has("ribbon-line", "mitsubishi-e60", Action::Variable(107, Some(0.0))));
    let groups = available(&on("ribbon-line", "sinumerik-808d"));
    assert!(groups.iter().all(|group| !group.actions.is_empty()));
    assert!(groups.iter().all(|group| group.name != "operator.inputs"), "it has no inputs of macros");
}

#[test]
fn no_available_action_is_refused() {
    for machine in macroline::machines::ALL {
        for control in machine.controls() {
            let mut project = on(machine.id(), control);
            let events = actions(machine.id(), control).into_iter().map(|action| at(0.5, action));
            project.panel = Panel::new(events.filter(|event| !matches!(event.action, Action::EmergencyStop)));
            let mut run = begun(&project, &project.written());
            run.advance(2.0, usize::MAX);
            let refused =
                ["motion.nothing-to-set", "motion.no-inverter", "motion.no-zero-return", "interp.output-range"];
            let found = run.diagnostics().iter().find(|found| refused.contains(&found.message.id));
            assert_eq!(found, None, "{} {control}", machine.id());
        }
    }
}

fn begun(project: &Project, written: &Written) -> run::Run {
    let limits = macroline::motion::Budget { blocks: 1_000_000, seconds: 3600.0 };
    let keep = macroline::motion::Retention::Timeline;
    run::of_project(project, written, &RunOptions { start: None, settings: &[], limits, keep })
}

#[test]
fn replanned_run_is_that_of_the_changed_project() {
    let mut project = on("ribbon-line", "mitsubishi-e60");
    project.panel = Panel::new([feed(1.0, 80.0), at(2.0, Action::Input("R148".into(), 70.0))]);
    let written = project.written();
    let mut planned = begun(&project, &written);
    planned.advance(6.0, usize::MAX);
    project.panel.replace(1, at(4.0, Action::Input("R148".into(), 60.0)));
    assert!(run::replan(&mut planned, &project));
    planned.advance(6.0, usize::MAX);
    let mut anew = begun(&project, &written);
    anew.advance(6.0, usize::MAX);
    assert_eq!(planned.panel(), anew.panel());
    for tenth in 0..60 {
        let t = f64::from(tenth) * 0.1;
        assert_eq!(format!("{:?}", planned.timeline().at(t)), format!("{:?}", anew.timeline().at(t)), "{t} s");
    }
}

#[test]
fn typed_values_are_taken_within_their_ranges() {
    let e60 = controls::find("mitsubishi-e60").unwrap();
    let input = |name: &str| Action::Input(name.into(), 0.0);
    let cases = [
        (Action::FeedOverride(100.0), "70", Some(70.0)),
        (Action::FeedOverride(100.0), "1000", Some(1000.0)),
        (Action::FeedOverride(100.0), "1001", None),
        (Action::SpindleOverride(100.0), "-1", None),
        (Action::RapidOverride(100.0), "", None),
        (Action::ManualSpeed(0.0), "\u{2212}1\u{202f}200,5", Some(-1200.5)),
        (Action::SpeedLimit(SpeedLimit::Upper, 0.0), "-0.5", None),
        (Action::SpeedLimit(SpeedLimit::Upper, 0.0), "2500", Some(2500.0)),
        (input("#1005"), "1", Some(1.0)),
        (input("#1005"), "2", None),
        (input("#1033"), "-2147483648", Some(-2_147_483_648.0)),
        (input("#1033"), "2147483648", None),
        (input("#1033.low"), "65535", Some(65_535.0)),
        (input("R74"), "65536", None),
        (Action::Variable(107, None), "9,5", Some(9.5)),
        (Action::Variable(107, None), "many", None),
    ];
    for (action, text, expected) in cases {
        let read = read_value(&action, text, e60).ok().and_then(|read| read.value());
        assert_eq!(read, expected.map(ActionValue::Number), "{action:?} {text}");
    }
    let refusal = |action: Action| sentence(&read_value(&action, "x", e60).unwrap_err());
    assert_eq!(refusal(Action::FeedOverride(1.0)), "Feed override takes a number from 0 to 1000 %.");
    assert_eq!(refusal(input("#1005")), "#1005 takes a number from 0 to 1.");
    assert_eq!(
        refusal(Action::SpeedLimit(SpeedLimit::Upper, 0.0)),
        "Upper speed limit takes a number from 0 r/min upward."
    );
    assert_eq!(refusal(Action::ManualSpeed(0.0)), "S takes a number.");
    assert!(read_value(&Action::Reset, "1", e60).is_err() && read_value(&Action::SingleBlock(true), "1", e60).is_err());
}

#[test]
fn empty_variable_is_vacant_where_the_control_has_that() {
    for (control, value) in [("mitsubishi-e60", ActionValue::Vacant), ("sinumerik-808d", ActionValue::Number(0.0))] {
        let read = read_value(&Action::Variable(107, Some(1.0)), " ", controls::find(control).unwrap());
        assert_eq!(read.unwrap().value(), Some(value), "{control}");
    }
    assert_eq!(typed_value(&Action::Variable(107, None)), "");
}

#[test]
fn typed_times_are_seconds_from_0() {
    assert_eq!(read_time("2,5"), Ok(2.5));
    assert!(["-1", "", "soon", "1e9"].iter().all(|text| read_time(text).is_err()));
    assert_eq!([0.1 + 0.2, 2.0, 1.234_567_8].map(typed_time), ["0.3", "2", "1.234568"]);
}

#[test]
fn steps_of_an_axis_are_powers_of_ten() {
    assert_eq!([0.42, 1.0, 0.06, 20.0, 0.0].map(time_step), [0.1, 1.0, 0.01, 10.0, 1e-6]);
    assert_eq!(
        [(3.2415 + 0.1, 0.1), (0.1 + 0.2, 0.01), (14.0, 10.0), (-3.0, 1.0)].map(|(t, step)| in_steps(t, step)),
        [3.3, 0.3, 10.0, 0.0]
    );
}

#[test]
fn names_have_value_and_unit() {
    let (e60, sinumerik) = (controls::find("mitsubishi-e60").unwrap(), controls::find("sinumerik-808d").unwrap());
    let cases = [
        (Action::SpindleOverride(80.0), "Spindle override 80 %"),
        (Action::SingleBlock(true), "Single block on"),
        (Action::Reset, "Reset"),
        (Action::ManualSpeed(300.0), "S 300"),
        (Action::SpeedLimit(SpeedLimit::Upper, 300.0), "Upper speed limit 300"),
        (Action::Input("R74".into(), 5.0), "R74 = 5"),
        (Action::Variable(107, Some(9.5)), "#107 = 9.5"),
        (Action::Variable(107, None), "#107 = vacant"),
    ];
    cases.iter().for_each(|(action, words)| assert_eq!(name(action, e60), *words));
    assert_eq!(kind_name(&Action::Variable(107, None), sinumerik), "R107");
    assert_eq!(name(&Action::Variable(107, None), sinumerik), "R107 = 0");
    assert_eq!((unit(&Action::ManualSpeed(1.0)), unit(&Action::Hold)), ("r/min", ""));
}

#[test]
fn panel_file_reads_back_equal() {
    for machine in macroline::machines::ALL {
        for control in machine.controls() {
            let events =
                actions(machine.id(), control).into_iter().zip(0..).map(|(action, t)| at(f64::from(t) * 0.7, action));
            let panel = Panel::new(events);
            let text = panel_to_json(&panel);
            assert_eq!(FileKind::of(&text), FileKind::Panel);
            assert_eq!(panel_from_json(&text), (panel, vec![]));
        }
    }
    assert_eq!(panel_to_json(&Panel::new([feed(2.5, 80.0)])), "[\n  {\"t\":2.5,\"feed_override\":80}\n]\n");
    assert_eq!(panel_to_json(&Panel::default()), "[]\n");
}

#[test]
fn last_turn_up_to_a_time_counts() {
    let mut project = on("ribbon-line", "mitsubishi-e60");
    project.panel = Panel::new([feed(1.0, 50.0), at(2.0, Action::Start), feed(3.0, 70.0)]);
    assert_eq!([0.5, 1.0, 2.5, 3.5].map(|t| project.feed_override_at(t)), [100.0, 50.0, 50.0, 70.0]);
    assert_eq!(project.spindle_override_at(3.5), 100.0);
}

#[test]
fn turns_of_a_knob_at_one_time_are_one_action() {
    let mut panel = Panel::default();
    for percent in [90.0, 80.0, 70.0] {
        panel.act(Event { t: 2.0, action: Action::SpindleOverride(percent) });
        panel.act(Event { t: 2.0, action: Action::FeedOverride(percent) });
    }
    panel.act(Event { t: 2.0, action: Action::Hold });
    panel.act(Event { t: 2.0, action: Action::Hold });
    panel.act(Event { t: 3.0, action: Action::SpindleOverride(60.0) });
    let actions: Vec<_> = panel.events().iter().map(|event| event.action.clone()).collect();
    let knobs = [Action::SpindleOverride(70.0), Action::FeedOverride(70.0)];
    assert_eq!(actions, [&knobs[..], &[Action::Hold, Action::Hold, Action::SpindleOverride(60.0)]].concat());
}
