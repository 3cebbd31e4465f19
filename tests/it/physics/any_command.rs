//! Any commands on any plant: the run ends, and nothing panics.

use macroline::drives::speed::SpeedLimit;
use macroline::drives::{Approach, Positioning, SpeedRange, Stage};
use proptest::prelude::*;

use super::*;

/// Numbers that formulas may not handle: NaN, infinite, huge and tiny ones.
fn number() -> impl Strategy<Value = f64> {
    prop_oneof![
        3 => -1e4..1e4f64,
        1 => prop::sample::select(vec![0.0, -0.0, 1e-300, 1e300, f64::NAN, f64::INFINITY, f64::NEG_INFINITY]),
    ]
}

fn goal() -> impl Strategy<Value = Target> {
    let place = prop_oneof![4 => -100_000i64..100_000, 1 => any::<i64>()];
    (prop::array::uniform6(place), any::<u8>()).prop_map(|(position, mask)| Target { position, mask })
}

fn feed() -> impl Strategy<Value = Feed> {
    (number(), any::<bool>()).prop_map(|(f, turns)| if turns { Feed::PerRevolution(f) } else { Feed::PerMinute(f) })
}

fn limit() -> impl Strategy<Value = SpeedLimit> {
    prop::sample::select(vec![SpeedLimit::Lower, SpeedLimit::Upper, SpeedLimit::Surface])
}

fn approach() -> impl Strategy<Value = Approach> {
    use Approach::{Clockwise, CounterClockwise, Direct, Incremental};
    prop::sample::select(vec![Direct, Clockwise, CounterClockwise, Incremental])
}

fn rotation() -> impl Strategy<Value = Rotation> {
    prop::sample::select(vec![Rotation::Stopped, Rotation::Clockwise, Rotation::CounterClockwise])
}

fn canon() -> impl Strategy<Value = Canon> {
    let arc = (goal(), any::<(u8, u8)>(), number(), number(), any::<bool>(), feed(), any::<bool>());
    prop_oneof![
        goal().prop_map(|to| Canon::Rapid { to }),
        (goal(), feed(), any::<bool>()).prop_map(|(to, feed, exact)| Canon::Linear { to, feed, exact }),
        arc.prop_map(|(to, (a, b), x, y, clockwise, feed, exact)| {
            Canon::Arc { to, plane: (a % 8, b % 8), center: (x, y), clockwise, feed, exact }
        }),
        number().prop_map(|seconds| Canon::Dwell { seconds }),
        number().prop_map(|turns| Canon::DwellTurns { turns }),
        number().prop_map(|rpm| Canon::SpindleSpeed { rpm }),
        rotation().prop_map(|rotation| Canon::SpindleDirection { rotation }),
        any::<u32>().prop_map(|code| Canon::Auxiliary { code }),
        (goal(), number()).prop_map(|(to, lead)| Canon::Thread { to, lead }),
        (number(), any::<u8>(), any::<i64>()).prop_map(|(speed, axis, zero)| Canon::SurfaceSpeed {
            speed,
            axis: axis % 8,
            zero
        }),
        (limit(), number()).prop_map(|(limit, rpm)| Canon::SpeedLimit { limit, rpm }),
        any::<u8>().prop_map(|stage| Canon::Gear { stage: stage % 7 }),
        (number(), approach()).prop_map(|(angle, approach)| Canon::Orient { angle, approach }),
        Just(Canon::ConstantSpeed),
        any::<(bool, bool)>().prop_map(|(single_block, fin)| Canon::SuppressWaits { single_block, fin }),
        Just(Canon::OptionalStop),
    ]
}

fn any_plant() -> impl Strategy<Value = Plant> {
    (prop::array::uniform8(number()), any::<u8>(), 0usize..9).prop_map(|(n, small, axes)| {
        let diameter = small % 2 == 0;
        let axis = AxisPlant {
            diameter,
            rapid: n[0],
            clamp: n[1],
            time_constant: n[2],
            position_gain: n[3],
            ..axis(Address::X)
        };
        let mut plant = plant();
        plant.axes = vec![axis; axes];
        plant.spindle.stages =
            [Stage { rated: n[4], range: SpeedRange::new(n[5], n[6]), automatic: SpeedRange::new(n[7], n[0]) }; 5];
        plant.spindle.stage_count = small;
        plant.spindle.positioning =
            (small % 3 > 0).then_some(Positioning { speed: n[1], acceleration: n[2], clockwise: diameter });
        plant.spindle.analog =
            Analog { rated_volts: n[0], offset_zero: n[1], offset_rated: n[2], ..plant.spindle.analog };
        plant.spindle.rules.reached = (small % 5 == 0).then_some(n[3]);
        plant.spindle.rules.override_last = small % 7 < 3;
        plant.spindle.surface_low = n[1];
        plant.spindle.speed_clamp = n[5];
        plant.spindle.analog.bits = small;
        plant.spindle.ramp = n[6];
        plant.spindle.gain = n[3];
        plant.spindle.slip = n[7];
        plant.preread = small;
        (plant.block_time, plant.macro_time, plant.in_position) = (n[6], n[7], n[0]);
        plant
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 128, ..ProptestConfig::default() })]

    #[test]
    fn any_commands_on_any_plant_end(
        commands in prop::collection::vec(canon(), 1..12),
        plant in any_plant(),
        percent in number(),
        t in number(),
    ) {
        let events = vec![
            at(t, Action::FeedOverride(percent)),
            at(0.5, Action::SpindleOverride(percent)),
            at(t, Action::ManualSpeed(percent)),
        ];
        let mut planner = planner(&plant, events, commands.into_iter().map(one).collect());
        let mut slices = 0;
        while planner.advance(f64::INFINITY, 10_000).ended.is_none() {
            slices += 1;
            prop_assert!(slices < 1000, "it goes on and on at {}", planner.timeline().end());
        }
        for i in 0..50 {
            planner.timeline().at(f64::from(i) * planner.timeline().end() / 50.0);
        }
    }
}
