//! The plant of the turning spindle: two slides, the spindle with its gear stages, and the builder's logic between them.

use super::gears::gear_times;
use super::ladder::ladder;
use super::resolved::{TurningSpindle, given_code};
use crate::controls::SpindleRules;
use crate::drives::Stage;
use crate::drives::speed::{KnobRange, STAGES};
use crate::machines::ladder::plc::{LadderPlc, Wiring};
use crate::machines::lathe::slides::IN_POSITION;
use crate::motion::{Plant, SpindlePlant};

/// The plant with the project's clamps, ramps and limits.
pub(super) fn plant(lathe: &TurningSpindle) -> Plant {
    let p = &lathe.params;
    Plant {
        axes: p.slides.plants(lathe.x_counts_diameters(), [0.5 * p.start_x, p.start_z]),
        pmc: Vec::new(),
        spindle: spindle(lathe),
        block_time: p.block_time / 1000.0,
        macro_time: p.macro_time / 1000.0,
        preread: p.preread as u8,
        in_position: IN_POSITION,
        stock: 0.5 * p.stock_diameter,
    }
}

fn spindle(lathe: &TurningSpindle) -> SpindlePlant {
    let p = &lathe.params;
    let analog = p.analog(p.stage_1, &lathe.control.analog_output);
    let rules = SpindleRules {
        lock: given_code(p.lock_code).or(lathe.rules().lock),
        driven_tool: given_code(p.driven_code).or(lathe.rules().driven_tool),
        ..lathe.rules()
    };
    let spindle = SpindlePlant::new(analog, p.chuck_limit, p.spindle.ramp, rules);
    SpindlePlant {
        surface_low: if lathe.rules().low_always { 0.0 } else { p.lower_limit },
        // If the program cuts the keyway, it starts the driven tool itself.
        driven_tool: p.driven_tool && lathe.keyway().is_none(),
        centre: Some(0.0),
        coasting: Some(coasting(lathe)),
        positioning: lathe.positions().then(|| lathe.positioning()),
        ..spindle.with_stages(p.stages().map(Stage::new))
    }
}

/// Seconds in which the spindle coasts to rest from the speed at 10 V of each gear stage.
fn coasting(lathe: &TurningSpindle) -> [f64; STAGES] {
    let mut all = [0.0; STAGES];
    for (place, stage_speed) in all.iter_mut().zip(lathe.params.stages()) {
        *place = lathe.params.main_spindle(stage_speed).coasting(stage_speed);
    }
    all
}

/// A knob in whole percent, which the ladder turns into the positions of a code.
const ANY_POSITION: KnobRange = KnobRange { low: 0.0, high: 200.0, step: 1.0 };

/// The ladder, wired to knob, inverter and gear box.
pub(super) fn plc(lathe: &TurningSpindle) -> LadderPlc {
    let wiring = Wiring {
        knob: if lathe.rules().override_codes.is_empty() { lathe.rules().knob } else { ANY_POSITION },
        rules: lathe.rules(),
        at_speed: 1.0 - lathe.rules().tolerance(),
        meshing: gear_times(lathe).meshing,
        shift_volts: shift_volts(lathe),
        shift_speeds: shift_speeds(lathe),
    };
    LadderPlc::new(ladder(lathe), wiring, lathe.control)
}

/// Speed (r/min) up to which the gears of each stage may shift: 1.1 times the speed at the shift voltage.
fn shift_speeds(lathe: &TurningSpindle) -> [f64; STAGES] {
    let output = &lathe.control.analog_output;
    let mut all = [0.0; STAGES];
    for (place, stage_speed) in all.iter_mut().zip(lathe.params.stages()) {
        *place = 1.1 * lathe.params.analog(stage_speed, output).speed(shift_volts(lathe)).abs();
    }
    all
}

/// Share of the speed at full output with which the spindle turns while gears mesh. Engineering choice.
pub(super) const SHIFT_SHARE: f64 = 0.01;

/// Volts of that speed, above the offset at standstill (parameter No.067 of the GSK 980TDc).
pub(super) fn shift_volts(lathe: &TurningSpindle) -> f64 {
    let p = &lathe.params;
    let analog = p.analog(p.stage_1, &lathe.control.analog_output);
    analog.command(SHIFT_SHARE * p.stage_1)
}
