//! The plant of the turning spindle: two slides, the spindle with its gear stages, and the builder's logic between them.

use super::resolved::{ALONG, CROSS, TurningSpindle};
use crate::controls::{Address, SpindleRules};
use crate::drives::Positioning;
use crate::motion::{AxisPlant, BenchPlc, GearShift, Plant, SpindlePlant};

/// Seconds from a strobe to FIN: a few scans of the ladder.
const FIN_DELAY: f64 = 0.05;

/// The plant with the project's clamps, ramps and limits.
pub(super) fn plant(lathe: &TurningSpindle) -> Plant {
    let p = &lathe.p;
    let slide = |letter: Address, diameter: bool, rapid: f64, clamp: f64, home: f64| AxisPlant {
        letter: Some(letter),
        rotary: false,
        endless: false,
        diameter,
        rapid,
        clamp,
        time_constant: p.time_constant / 1000.0,
        position_gain: p.position_gain,
        home,
    };
    Plant {
        axes: vec![
            slide(CROSS, lathe.diameters(), p.rapid_x, p.clamp_x, 0.5 * p.start_x),
            slide(ALONG, false, p.rapid_z, p.clamp_z, p.start_z),
        ],
        pmc: Vec::new(),
        spindle: spindle(lathe),
        block_time: p.block_time / 1000.0,
        macro_time: p.macro_time / 1000.0,
        preread: p.preread as u8,
        in_position: 0.02,
        stock: 0.0,
    }
}

fn spindle(lathe: &TurningSpindle) -> SpindlePlant {
    let (p, bench) = (&lathe.p, &lathe.control.bench);
    let analog = p.analog(p.stage_1, bench.volts_full, bench.output_bits);
    let rules = SpindleRules {
        lock: (p.lock_code > 0.0).then_some(p.lock_code as u32).or(lathe.rules().lock),
        ..lathe.rules()
    };
    let spindle = SpindlePlant::new(analog, p.chuck_limit, p.spindle_ramp, rules);
    SpindlePlant {
        surface_low: if lathe.rules().low_always { 0.0 } else { p.lower_limit },
        driven_tool: p.driven_tool,
        centre: Some(0.0),
        positioning: lathe.positions().then_some(POSITIONING),
        ..spindle.with_stages(lathe.stages())
    }
}

/// FIN for S, M and T, and the gear change.
pub(super) fn plc(lathe: &TurningSpindle) -> BenchPlc {
    let p = &lathe.p;
    let mut plc = BenchPlc::new(FIN_DELAY, None);
    plc.shift =
        shift(p.gear_time, (p.gear_patience > 0.0 && p.has_gear_alarm(lathe.control)).then_some(p.gear_patience));
    plc.knob = Some(lathe.rules().knob);
    plc.stop_between = lathe.rules().stop_between;
    plc
}

/// A gear shift of `seconds`: an eighth before, half of it meshing, the rest after.
pub(super) fn shift(seconds: f64, patience: Option<f64>) -> GearShift {
    GearShift { volts: SHIFT_VOLTS, before: 0.125 * seconds, meshing: 0.5 * seconds, after: 0.375 * seconds, patience }
}

/// Positioning of the spindle; MD35300, MD35210 and MD35350 are facts of the machine, these values are assumed.
pub(super) const POSITIONING: Positioning = Positioning { speed: 100.0, acceleration: 500.0, clockwise: true };

/// Volts while gears mesh: a slow turn (GSK No.067).
pub(super) const SHIFT_VOLTS: f64 = 0.1;
