//! Planning on from a checkpoint equals planning from zero.

use macroline::controls::spindle::RapidSpeed;
use macroline::drives::speed::SpeedLimit;
use macroline::drives::{Approach, Positioning, Stage};
use proptest::prelude::*;

use super::*;

fn action() -> impl Strategy<Value = Action> {
    prop_oneof![
        4 => (0u32..=15).prop_map(|tens| Action::SpindleOverride(f64::from(tens) * 10.0)),
        3 => (0u32..=15).prop_map(|tens| Action::FeedOverride(f64::from(tens) * 10.0)),
        1 => (0u32..=10).prop_map(|tens| Action::RapidOverride(f64::from(tens) * 10.0)),
        3 => Just(Action::Start),
        2 => Just(Action::Hold),
        1 => Just(Action::Reset),
        1 => Just(Action::EmergencyStop),
        1 => Just(Action::ProgramZeroReturn),
        1 => any::<bool>().prop_map(Action::SingleBlock),
        1 => (-1500.0..1500.0).prop_map(Action::ManualSpeed),
        1 => (100.0..1500.0).prop_map(|rpm| Action::SpeedLimit(SpeedLimit::Upper, rpm)),
        1 => (0.0..200.0).prop_map(|value| Action::Input("#1033".into(), value)),
        1 => (0.0..5000.0).prop_map(|value| Action::Variable(102, Some(value))),
    ]
}

fn busy() -> Vec<Line> {
    let feed = Feed::PerRevolution(4.0);
    let aside = Canon::Linear { to: target(0.0, 5.0), feed: Feed::PerMinute(1200.0), exact: false };
    vec![
        m3(1200.0),
        Line::Input(100, 1033),
        Line::Add(100, 3000.0),
        Line::Step([8_000, 60_000], 100),
        Line::Step([8_001, -60_000], 100),
        rapid(0.0, 3.0),
        one(Canon::Arc { to: target(0.0, 3.0), plane: (0, 1), center: (9e3, 9e3), clockwise: true, feed, exact: true }),
        Line::Add(101, 1.0),
        Line::Position(103),
        one(Canon::Gear { stage: 2 }),
        Line::Nc(vec![Canon::Orient { angle: 70.0, approach: Approach::Direct }, aside]),
        m4(900.0),
        one(Canon::SpeedLimit { limit: SpeedLimit::Surface, rpm: 1100.0 }),
        one(Canon::SurfaceSpeed { speed: 60.0, axis: 0, zero: -9_000 }),
        linear(30.0, 6.0, 4000.0),
        one(Canon::Linear { to: target(5.0, 6.0), feed, exact: false }),
        one(Canon::SuppressWaits { single_block: true, fin: true }),
        one(Canon::Thread { to: target(0.0, 9.0), lead: 2.0 }),
        one(Canon::ConstantSpeed),
        one(Canon::Auxiliary { code: 10 }),
        one(Canon::SuppressWaits { single_block: false, fin: false }),
        one(Canon::Dwell { seconds: 0.2 }),
        one(Canon::DwellTurns { turns: 3.3 }),
        Line::Goto(1),
    ]
}

/// The first axis counts diameters.
fn lathe() -> Plant {
    let mut plant = plant();
    plant.axes[0].diameter = true;
    let spindle = plant.spindle.with_stages([1480.0, 2000.0].map(Stage::new));
    let positioning = Some(Positioning { speed: 400.0, acceleration: 900.0, clockwise: false });
    plant.spindle = SpindlePlant { positioning, ..spindle };
    plant.spindle.rules.reached = Some(0.2);
    plant.spindle.rules.rapid = RapidSpeed::BeforeCut;
    plant
}

/// All of a moment, to the bit.
fn bits(planner: &Planner<Script>, t: f64) -> String {
    let now = planner.timeline().at(t);
    let mut out = format!("{t} {:?} {:?}", now.mode, now.block);
    let spindle = now.spindle;
    let mut numbers = vec![spindle.command, spindle.actual, spindle.volts, spindle.turns, spindle.angle];
    numbers.extend([f64::from(spindle.stage), f64::from(spindle.held), spindle.surface_speed.unwrap_or(-1.0)]);
    for axis in &now.axes[..2] {
        numbers.extend([axis.position, axis.actual, axis.feed, axis.acceleration]);
    }
    numbers.extend([100, 101, 102, 103].map(|number| planner.variable_at(number, t).unwrap_or(-1.0)));
    for number in numbers {
        out.push_str(&format!(" {:x}", number.to_bits()));
    }
    out
}

#[test]
fn replanning_script_loops_within_the_sampled_time() {
    let mut planner = planner(&lathe(), vec![], busy());
    planner.advance(9.0, usize::MAX);
    let (mut t, mut lines) = (0.0, Vec::new());
    while let Some(next) = planner.timeline().next_block(t) {
        t = next;
        lines.extend(planner.timeline().block_at(t).map(|place| place.span.start));
    }
    assert!(lines.contains(&21), "{lines:?}");
}

#[test]
fn replaced_actions_keep_the_plan_before_the_first_change() {
    let events = || vec![at(2.0, Action::FeedOverride(80.0)), at(7.5, Action::FeedOverride(60.0))];
    let mut planner = planner(&lathe(), events(), busy());
    planner.advance(9.0, usize::MAX);
    let mut moved = Panel::new(events());
    assert_eq!(moved.replace(1, at(8.0, Action::FeedOverride(60.0))), Some(1));
    assert!(planner.replace_panel(moved.clone()));
    assert_eq!(planner.timeline().end(), 7.0, "the checkpoint before 7.5 s");
    planner.advance(9.0, usize::MAX);
    assert!(planner.replace_panel(moved) && planner.timeline().end() == 9.0, "equal actions change nothing");
}

#[test]
fn run_of_which_only_the_log_is_kept_takes_no_other_actions() {
    let plc = Box::new(bench_plc(0.05, Some(1033)));
    let (plant, panel) = (plant(), Panel::new([]));
    let limits = Budget { blocks: 1_000_000, seconds: 3600.0 };
    let program = Script::new(busy());
    let mut planner = Planner::new(Setup {
        program,
        control: control(),
        plant: &plant,
        plc,
        panel,
        limits,
        keep: Retention::Log,
        findings: Vec::new(),
    });
    assert!(!planner.replace_panel(Panel::new([at(1.0, Action::Hold)])));
    assert!(planner.panel().events().is_empty());
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, ..ProptestConfig::default() })]

    #[test]
    fn replanning_equals_planning_from_zero_to_the_bit(
        events in prop::collection::vec((0.0f64..9.0, action()), 1..8),
        whole in any::<bool>(),
        ahead in 0.0f64..3.0,
        budget in 1usize..500,
    ) {
        // Some events fall on whole seconds, where the checkpoints are.
        let events: Vec<Event> =
            events.into_iter().map(|(t, action)| at(if whole { t.round() } else { t }, action)).collect();
        let horizon = 11.0;
        // Of two turns of a knob at one time the last one counts, as in the panel below.
        let mut acted = Panel::default();
        events.iter().for_each(|event| { acted.act(event.clone()); });
        let mut once = planner(&lathe(), acted.events().to_vec(), busy());
        once.advance(horizon, usize::MAX);
        let mut bit_by_bit = planner(&lathe(), vec![], busy());
        for event in events {
            let until = event.t + ahead;
            while bit_by_bit.advance(until, budget).planned_to < until {
                if bit_by_bit.advance(until, budget).ended.is_some() {
                    break;
                }
            }
            bit_by_bit.event(event);
        }
        bit_by_bit.advance(horizon, usize::MAX);
        for i in 0..=1100 {
            let t = f64::from(i) * 0.01;
            prop_assert_eq!(bits(&once, t), bits(&bit_by_bit, t));
        }
        prop_assert_eq!(once.diagnostics(), bit_by_bit.diagnostics());
        prop_assert_eq!(once.starved(), bit_by_bit.starved());
        prop_assert_eq!(once.timeline().end(), bit_by_bit.timeline().end());
    }

    #[test]
    fn replaced_actions_plan_as_from_zero_to_the_bit(
        before in prop::collection::vec((0.0f64..9.0, action()), 0..6),
        after in prop::collection::vec((0.0f64..9.0, action()), 0..6),
        kept in 0.0f64..9.0,
        until in 0.0f64..11.0,
        whole in any::<bool>(),
    ) {
        let panel = |events: Vec<(f64, Action)>| -> Vec<Event> {
            events.into_iter().map(|(t, action)| at(if whole { t.round() } else { t }, action)).collect()
        };
        let (before, mut after) = (panel(before), panel(after));
        // Actions up to a time stay, as in an edited list.
        after.retain(|event| event.t > kept);
        after.splice(0..0, before.iter().filter(|event| event.t <= kept).cloned());
        let mut once = planner(&lathe(), after.clone(), busy());
        once.advance(11.0, usize::MAX);
        let mut replaced = planner(&lathe(), before, busy());
        replaced.advance(until, usize::MAX);
        prop_assert!(replaced.replace_panel(Panel::new(after)));
        replaced.advance(11.0, usize::MAX);
        for i in 0..=1100 {
            let t = f64::from(i) * 0.01;
            prop_assert_eq!(bits(&once, t), bits(&replaced, t));
        }
        prop_assert_eq!(once.diagnostics(), replaced.diagnostics());
        prop_assert_eq!(once.timeline().end(), replaced.timeline().end());
    }

    #[test]
    fn positions_and_speeds_never_jump(events in prop::collection::vec((0.0f64..9.0, action()), 0..8)) {
        let mut planner = planner(&lathe(), events.into_iter().map(|(t, action)| at(t, action)).collect(), busy());
        planner.advance(10.0, usize::MAX);
        let mut before = planner.timeline().at(0.0);
        for i in 1..=10_000 {
            let now = planner.timeline().at(f64::from(i) * 0.001);
            for k in 0..2 {
                let (old, new) = (before.axes[k], now.axes[k]);
                // At most the rapid rate (here above the feeds); acceleration at most rate over time constant, either way.
                prop_assert!((new.position - old.position).abs() <= 120e3 / 60.0 * 0.001);
                prop_assert!((new.feed - old.feed).abs() / 60.0 <= 2.0 * 120e3 / 60.0 / TAU * 0.001);
                prop_assert!(new.position.is_finite() && new.actual.is_finite());
            }
            // The second stage changes its speed fastest.
            prop_assert!((now.spindle.actual - before.spindle.actual).abs() <= 1000.0 * 0.001 + 1e-9);
            before = now;
        }
    }
}
