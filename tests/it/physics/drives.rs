//! The formulas of a lathe's spindle against the printed values: volts, limits, angles, cutting times.

use macroline::drives::cutting::torque;
use macroline::drives::orient::{Approach, Travel, first_travel, travel};
use macroline::drives::speed::{KnobRange, limit_diameter, stage_for, surface_rpm, surface_speed};
use macroline::drives::{Analog, Bound, SpeedLimits, SpeedRange, Stage};

use super::*;

#[test]
fn signed_output_matches_the_fact_sheet() {
    // sinumerik-802d.md section 4: 80 % of 10 V at 3000 r/min, ±10 V.
    let analog = Analog {
        rated_speed: 3000.0,
        rated_volts: 8.0,
        volts_max: 10.0,
        bipolar: true,
        ..Analog::unipolar(3000.0, 10.0)
    };
    for (rpm, volts) in
        [(1200.0, 3.2), (-1200.0, -3.2), (3000.0, 8.0), (3750.0, 10.0), (4000.0, 10.0), (-4000.0, -10.0), (0.0, 0.0)]
    {
        close(analog.command(rpm), volts, 1e-12);
        assert!((analog.output(rpm) - volts).abs() <= 10.0 / 4095.0 / 2.0 + 1e-12);
    }
    assert_eq!((analog.code(4000.0), analog.code(-4000.0)), (4095, -4095));
    close(analog.top_speed(), 3750.0, 1e-12);
}

#[test]
fn output_offsets_shift_both_ends_of_the_line() {
    // gsk-980tdc.md section 1.1: mV = c0 + (10000 + c10 - c0) n / n_max, 0 to 10000.
    let analog = Analog { offset_zero: 0.05, offset_rated: -0.1, ..Analog::unipolar(2000.0, 10.0) };
    close(analog.command(0.0), 0.05, 1e-12);
    close(analog.command(2000.0), 9.9, 1e-12);
    close(analog.command(1000.0), (0.05 + 9.9) / 2.0, 1e-12);
    close(analog.speed(analog.command(777.0)), 777.0, 1e-12);
    let high = Analog { offset_rated: 0.2, ..Analog::unipolar(2000.0, 10.0) };
    assert_eq!(high.command(2000.0), 10.0);
    close(high.top_speed(), 2000.0 / 1.02, 1e-12);
    let low = Analog { offset_zero: -0.3, ..Analog::unipolar(2000.0, 10.0) };
    assert_eq!(low.command(10.0), 0.0);
}

#[test]
fn surface_speeds_match_the_manual() {
    for (diameter, rpm) in [(100.0, 955.0), (50.0, 1910.0), (80.0, 1194.0)] {
        assert_eq!(surface_rpm(300.0, diameter).round(), rpm);
    }
    close(surface_rpm(180.0, 84.0), 682.093, 1e-6);
    close(surface_rpm(180.0, -84.0), 682.093, 1e-6);
    close(limit_diameter(180.0, 2500.0), 22.918312, 1e-7);
    assert_eq!((surface_rpm(100.0, 0.0), surface_rpm(0.0, 0.0)), (f64::INFINITY, 0.0));
    close(surface_speed(surface_rpm(123.0, 45.0), 45.0), 123.0, 1e-12);
}

/// The machine of the sheet's table: MD35100 3500, MD35130 2800, MD35140 30, G25 S50, G26 S3000, LIMS 2500.
fn sheet(surface: bool) -> SpeedLimits {
    SpeedLimits {
        machine: 3500.0,
        gear: SpeedRange::new(30.0, 2800.0),
        set: SpeedRange::new(50.0, 3000.0),
        surface: SpeedRange::new(0.0, if surface { 2500.0 } else { f64::INFINITY }),
    }
}

#[test]
fn speed_limits_match_the_table_and_name_the_binding_one() {
    // sinumerik-802d.md section 7.
    let constant = sheet(false);
    assert_eq!(constant.limit(3200.0), (2800.0, Bound::Gear));
    assert_eq!(constant.limit(2700.0), (2700.0, Bound::None));
    assert_eq!(sheet(true).limit(2700.0), (2500.0, Bound::Surface));
    assert_eq!(constant.limit(2600.0 * 1.2), (2800.0, Bound::Gear));
    assert_eq!(constant.limit(20.0), (50.0, Bound::Lower));
    assert_eq!(constant.limit(0.0), (0.0, Bound::None));
    close(sheet(true).limit(surface_rpm(180.0, 84.0) * 0.8).0, 545.674, 1e-6);
    for diameter in [10.0, 0.0] {
        assert_eq!(sheet(true).limit(surface_rpm(180.0, diameter)), (2500.0, Bound::Surface));
    }
    // The upper limit wins over a lower one above it.
    let crossed = SpeedLimits { set: SpeedRange::new(900.0, 400.0), ..SpeedLimits::NONE };
    assert_eq!((crossed.limit(600.0), crossed.limit(20.0)), ((400.0, Bound::Upper), (400.0, Bound::Upper)));
    let each = |limits: SpeedLimits, rpm| limits.limit(rpm).1;
    assert_eq!(each(SpeedLimits { machine: 10.0, ..SpeedLimits::NONE }, 11.0), Bound::Machine);
    assert_eq!(each(SpeedLimits { gear: SpeedRange::new(10.0, 99.0), ..SpeedLimits::NONE }, 1.0), Bound::GearLow);
    assert_eq!(each(SpeedLimits { surface: SpeedRange::new(10.0, 99.0), ..SpeedLimits::NONE }, 1.0), Bound::SurfaceLow);
}

#[test]
fn positioning_travel_matches_the_table() {
    use Approach::{Clockwise, CounterClockwise, Direct, Incremental};
    // sinumerik-802d.md section 3.6: angle, target, sign of the rotation, approach, angle to go.
    let table = [
        (10.0, 90.0, 1.0, Direct, 80.0),
        (10.0, 90.0, -1.0, Direct, -280.0),
        (350.0, 20.0, 0.0, Direct, 30.0),
        (20.0, 350.0, 0.0, Direct, -30.0),
        (20.0, 350.0, 1.0, Direct, 330.0),
        (20.0, 350.0, -1.0, Direct, -30.0),
        (0.0, 180.0, 0.0, Direct, 180.0),
        (100.0, 50.0, 0.0, Clockwise, 310.0),
        (100.0, 50.0, 0.0, CounterClockwise, -50.0),
        (100.0, 50.0, 0.0, Direct, -50.0),
        (100.0, -450.0, 1.0, Incremental, -450.0),
        (50.0, 50.0, 0.0, Clockwise, 0.0),
        (50.0, 50.0, 0.0, CounterClockwise, 0.0),
    ];
    for (from, to, sign, approach, way) in table {
        assert_eq!(travel(from, to, approach, Rotation::of(sign)), way, "{from} {to} {sign} {approach:?}");
    }
    // Not synchronised: over the zero mark first.
    assert_eq!(first_travel(0.0, 90.0, true), 450.0);
    assert_eq!(first_travel(300.0, 90.0, true), 150.0);
    assert_eq!(first_travel(300.0, 90.0, false), -570.0);
    assert_eq!(first_travel(0.0, 0.0, false), -360.0);
}

#[test]
fn positioning_travel_leaves_room_to_brake() {
    // Turns: the area under the speed.
    let covered = |travel: &Travel, rpm: f64| {
        ((rpm + travel.peak) * 0.5 * travel.to_peak + travel.peak * travel.steady + travel.peak * 0.5 * travel.to_rest)
            / 60.0
    };
    for (turns, rpm) in [(0.1, 0.0), (0.5, 0.0), (3.0, 0.0), (0.2, 50.0), (0.9, 1000.0), (0.0, 300.0), (1.25, 0.0)] {
        let travel = Travel::new(turns, rpm, 100.0, 300.0, 200.0);
        close(covered(&travel, rpm), turns + travel.more, 1e-12);
        assert!(travel.peak <= 100.0 && travel.steady >= 0.0 && travel.more == travel.more.trunc());
        // Without the last added turn there would be no room.
        assert!(travel.more == 0.0 || rpm > 0.0 && travel.steady < 60.0 / 100.0);
    }
}

#[test]
fn gear_is_kept_where_it_fits_else_selected_by_speed() {
    let stage = |low, high| Stage { automatic: SpeedRange::new(low, high), ..Stage::new(high) };
    let stages = [stage(0.0, 400.0), stage(300.0, 1000.0), stage(900.0, 3000.0)];
    let chosen = [(1, 350.0), (2, 350.0), (3, 350.0), (1, 950.0), (3, 950.0), (2, 3001.0), (9, 5.0)];
    let stage = chosen.map(|(present, rpm)| stage_for(&stages, present, rpm));
    assert_eq!(stage, [Some(1), Some(2), Some(1), Some(2), Some(3), None, Some(1)]);
}

#[test]
fn knob_value_snaps_to_its_steps() {
    let knob = KnobRange { low: 50.0, high: 120.0, step: 10.0 };
    assert_eq!([0.0, 54.0, 55.0, 99.0, 130.0].map(|percent| knob.nearest(percent)), [50.0, 50.0, 60.0, 100.0, 120.0]);
    assert_eq!(KnobRange { low: 0.0, high: 200.0, step: 0.0 }.nearest(83.758), 83.758);
}

#[test]
fn cutting_times_match_the_fact_sheet() {
    // sinumerik-802d.md section 7, N100: X84 to, 0.2 mm, 180 m/min, at most 2500 r/min.
    let face = Cut { diameters: (84.0, -1.6), length: 42.8, feed: 0.2 };
    close(face.surface_time(180.0, (0.0, 2500.0)), 10.019832, 1e-7);
    let free = Cut { diameters: (84.0, limit_diameter(180.0, 2500.0)), ..face };
    let length = (84.0 - free.diameters.1) / 2.0;
    close(Cut { length, ..free }.surface_time(180.0, (0.0, 2500.0)), 8.548733, 1e-6);
    close(
        Cut { diameters: (50.0, 50.0), length: 100.0, feed: 0.1 }.surface_time(100.0, (0.0, 9e9)),
        100.0 / (0.1 * 636.619_772) * 60.0,
        1e-8,
    );
}

#[test]
fn cutting_time_equals_the_integral_over_the_path() {
    let cuts = [(84.0, -1.6, 42.8), (30.0, 90.0, 60.0), (60.0, 61.0, 200.0), (-20.0, 40.0, 30.0), (80.0, 20.0, 30.0)];
    for (from, to, length) in cuts {
        for limits in [(0.0, 2500.0), (700.0, 900.0), (0.0, 100.0), (5000.0, 6000.0), (400.0, 1e9)] {
            let cut = Cut { diameters: (from, to), length, feed: 0.2 };
            let n = 200_000;
            let sum: f64 = (0..n)
                .map(|i| {
                    let diameter: f64 = from + (to - from) * (f64::from(i) + 0.5) / f64::from(n);
                    60.0 * length / f64::from(n) / (0.2 * surface_rpm(180.0, diameter).max(limits.0).min(limits.1))
                })
                .sum();
            close(cut.surface_time(180.0, limits), sum, 1e-6);
        }
    }
    // A cut to the diameter after half of the time takes half of the time.
    let cut = Cut { diameters: (80.0, 30.0), length: 25.0, feed: 0.2 };
    let half = cut.surface_time(180.0, (0.0, 1e9)) / 2.0;
    let there = surface_diameter(&cut, 180.0, half);
    let part = Cut { diameters: (80.0, there), length: (80.0 - there) / 2.0, feed: 0.2 };
    close(part.surface_time(180.0, (0.0, 1e9)), half, 1e-12);
}

#[test]
fn power_equals_torque_times_speed() {
    let (force, diameter) = (2000.0, 60.0);
    let rpm = surface_rpm(150.0, diameter);
    close(torque(force, diameter) * 2.0 * math::PI * rpm / 60.0, 5000.0, 1e-12);
}
