//! The plant of the cut-to-length feeder: one slide, and the parameters that the builder sets for it.

use macroline::controls::ParamRole;
use macroline::machines::sheets::{AxisValues, ParamValue};
use macroline::motion::{AxisPlant, Plant, SpindlePlant};

use super::resolved::{CutToLength, FEED_AXIS};

/// The plant with the clamp and the time constant of the form.
pub(super) fn plant(feeder: &CutToLength) -> Plant {
    let p = &feeder.params;
    let axis = AxisPlant {
        letter: Some(FEED_AXIS),
        rotary: false,
        endless: false,
        diameter: false,
        rapid: p.clamp,
        clamp: p.clamp,
        time_constant: p.time_constant / 1000.0,
        position_gain: p.position_gain,
        home: 0.0,
    };
    Plant {
        axes: vec![axis],
        pmc: Vec::new(),
        spindle: SpindlePlant::bench(feeder.control, feeder.dialect.spindle()),
        block_time: p.block_time / 1000.0,
        macro_time: p.macro_time / 1000.0,
        preread: p.preread as u8,
        in_position: 0.02,
        stock: 0.0,
    }
}

/// Parameters of the control with their values.
pub(super) fn parameters(feeder: &CutToLength) -> Vec<(ParamRole, AxisValues<'static>)> {
    let p = &feeder.params;
    let slide = |value: f64| vec![("Z", ParamValue::Number(value))];
    vec![
        (ParamRole::AxisRapid, slide(p.clamp)),
        (ParamRole::AxisClamp, slide(p.clamp)),
        (ParamRole::AxisTimeConstant, slide(p.time_constant)),
        (ParamRole::AxisPositionGain, slide(p.position_gain)),
    ]
}
