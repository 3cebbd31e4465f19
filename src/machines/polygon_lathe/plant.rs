//! The plant of the polygon lathe: two slides, and the axes of work and tool that the PMC turns.

use super::resolved::PolygonLathe;
use crate::drives::Stage;
use crate::drives::speed::STAGES;
use crate::machines::lathe::slides::IN_POSITION;
use crate::motion::{AxisPlant, Plant, SpindlePlant};

/// The main spindle if the program turns the bar with it; else the spindle of the control's test bench, at rest.
fn spindle(lathe: &PolygonLathe) -> SpindlePlant {
    let bench = SpindlePlant::bench(lathe.control, lathe.dialect.spindle());
    if !lathe.has_main_spindle() {
        return bench;
    }
    let (speed, ramp) = (lathe.params.main_speed, lathe.params.main.ramp);
    let coasting = lathe.params.main_spindle().coasting(speed);
    SpindlePlant {
        analog: lathe.control.analog_output.with_speed(speed),
        speed_clamp: lathe.params.main_clamp(),
        ramp,
        coasting: Some([coasting; STAGES]),
        ..bench
    }
    .with_stages([Stage::new(speed)])
}

/// The plant with the project's clamps and time constants.
pub(super) fn plant(lathe: &PolygonLathe) -> Plant {
    let p = &lathe.params;
    let turns = |ms: f64, position_gain: f64| AxisPlant { time_constant: ms / 1000.0, position_gain, ..AxisPlant::PMC };
    Plant {
        axes: p.slides.plants(lathe.x_counts_diameters(), [0.5 * p.start_x, p.start_z]),
        pmc: vec![
            turns(p.axes.work.time_constant, p.axes.work.gain),
            turns(p.axes.tool.time_constant, p.axes.tool.gain),
        ],
        spindle: spindle(lathe),
        block_time: p.block_time / 1000.0,
        macro_time: p.macro_time / 1000.0,
        preread: p.preread as u8,
        in_position: IN_POSITION,
        stock: 0.5 * p.stock_diameter,
    }
}
