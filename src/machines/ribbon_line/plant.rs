//! The plant of the ribbon line: two servo axes and the unwinder on the analog output.

use super::axes::PerAxis;
use super::coasting;
use super::params::PULL;
use super::regulator::regulator;
use super::resolved::RibbonLine;
use super::stops::unwinder;
use crate::controls::SpindleRules;
use crate::drives::speed::STAGES;
use crate::machines::stops::{Interruption, SpindleReaction};
use crate::math::PI;
use crate::motion::{AxisPlant, Plant, SpindlePlant};

/// The plant with the project's clamps, ramps and slip.
pub(super) fn plant(line: &RibbonLine) -> Plant {
    let p = &line.params;
    let (PerAxis { pull, print }, endless) = (&p.axes, line.rolls_over());
    let x = AxisPlant {
        letter: Some(PULL),
        rotary: false,
        endless: endless.pull,
        diameter: line.x_counts_diameters(),
        rapid: pull.rapid,
        clamp: pull.clamp,
        time_constant: pull.time_constant / 1000.0,
        position_gain: pull.position_gain,
        home: 0.0,
    };
    let y = AxisPlant {
        letter: Some(p.print_axis.address()),
        rotary: line.degrees(),
        endless: endless.print,
        diameter: false,
        rapid: print.rapid,
        clamp: print.clamp,
        time_constant: print.time_constant / 1000.0,
        position_gain: print.position_gain,
        home: 0.0,
    };
    Plant {
        axes: vec![x, y],
        pmc: Vec::new(),
        spindle: spindle(line),
        block_time: p.block_time / 1000.0,
        macro_time: p.macro_time / 1000.0,
        preread: p.preread as u8,
        in_position: p.in_position,
        stock: 0.0,
    }
}

/// The unwinder. The regulator of a dancer has trimmed its motor to the pull of X before: no slip, and π as the program writes it.
fn spindle(line: &RibbonLine) -> SpindlePlant {
    let p = &line.params;
    let motor = p.induction();
    let (gain, slip) =
        if p.is_regulated() { (p.program_pi() / PI, 0.0) } else { (motor.gain(), motor.slip() / p.speed_at_10v) };
    let analog = line.control.analog_output.with_speed(p.speed_at_10v);
    // The builder's ladder, not the control's, decides about M3 at reset.
    let turns_through_reset = unwinder(Interruption::Reset) == SpindleReaction::Turns;
    let rules = SpindleRules { turns_through_reset, ..line.dialect.spindle() };
    SpindlePlant {
        gain,
        slip,
        encoder: p.spindle_encoder,
        coasting: Some([coasting::ramp(line); STAGES]),
        // The ribbon's slack at the start is a result of its own.
        drives_cut: false,
        regulator: regulator(line),
        ..SpindlePlant::new(analog, p.top_speed(), p.inverter_ramp, rules)
    }
}
