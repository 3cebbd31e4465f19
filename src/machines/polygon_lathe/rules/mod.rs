//! The rules of the polygon lathe, as rows: result, limit, remedy.

mod angles;
mod cutter;
mod drives;
mod feeds;
mod place;
mod scaling;
mod speeds;
mod threads;
mod turned;

use super::bending;
use super::citations::{RUN_IN, RUN_OUT};
use super::main_spindle;
use super::resolved::PolygonLathe;
use crate::machines::verdict::Rule;
use crate::text::{Citation, Grade};

/// Source of a drive's ratings: its data sheet.
const MOTOR: Citation = Citation::new("data sheet of the motor; curve by base speed", Grade::Inferred);

/// All rules that judge a result.
pub(super) const RULES: &[Rule<PolygonLathe>] = &[
    Rule::new("x-scaling-drift", scaling::scaling_x, Citation::new("ribbon line facts, 10", Grade::Inferred)),
    Rule::new("z-scaling-drift", scaling::scaling_z, Citation::new("ribbon line facts, 10", Grade::Inferred)),
    Rule::new("work-scaling-drift", scaling::scaling_work, Citation::new("ribbon line facts, 10", Grade::Inferred)),
    Rule::new("tool-scaling-drift", scaling::scaling_tool, Citation::new("ribbon line facts, 10", Grade::Inferred)),
    Rule::new("sides", cutter::sides, Citation::new("polygon turning facts 3.2", Grade::Inferred)),
    Rule::new("flatness", cutter::flatness, Citation::new("polygon turning facts 3.3", Grade::Inferred)),
    Rule::new(
        "curvature",
        cutter::hollow,
        Citation::new(
            "polygon turning facts 3.3; 928Ti sheet on polygons: the wrong sense makes hollow sides",
            Grade::Sister,
        ),
    ),
    Rule::new("across-corners", cutter::corners, Citation::new("polygon turning facts 3.3", Grade::Inferred)),
    Rule::new("relief", cutter::relief, Citation::new("polygon turning facts 3.4", Grade::Inferred)),
    Rule::new("tool-speed", speeds::tool_speed, Citation::new("greatest speed of the tool axis", Grade::Manual)),
    Rule::new("work-speed", speeds::work_speed, Citation::new("greatest speed of the work axis", Grade::Manual)),
    Rule::new("slowest-cut", speeds::slowest, Citation::new("what suits insert and material", Grade::Inferred)),
    Rule::new("fastest-cut", speeds::fastest, Citation::new("what suits insert and material", Grade::Inferred)),
    Rule::new("end-fastest-cut", speeds::fastest_end, Citation::new("what suits insert and material", Grade::Inferred)),
    Rule::new("distance", place::distance, Citation::new("travel of the slide", Grade::Manual)),
    Rule::new("reach", place::reach, Citation::new("mechanics", Grade::Inferred)),
    Rule::new("orientation-error", angles::orientation, Citation::new("polygon turning facts 3.1", Grade::Inferred)),
    Rule::new("phase", angles::phase, Citation::new("servo lag behind linear acceleration", Grade::Inferred)),
    Rule::new("coast-phase", angles::coast, Citation::new("friction", Grade::Inferred)),
    Rule::new("insert-depth", angles::insert, Citation::new("polygon turning facts 3.1", Grade::Inferred)),
    Rule::new("insert-turn", angles::insert_turn, Citation::new("polygon turning facts 3.1", Grade::Inferred)),
    Rule::new("twist", angles::twist, Citation::new("polygon turning paper: D and Q are whole numbers", Grade::Manual)),
    Rule::new("before-run-in", threads::run_in_before, RUN_IN),
    Rule::new("after-run-in", threads::run_in_after, RUN_IN),
    Rule::new("before-run-out", threads::run_out_before, RUN_OUT),
    Rule::new("after-run-out", threads::run_out_after, RUN_OUT),
    Rule::new("after-reached", turned::reached, Citation::new("mechanics", Grade::Inferred)),
    Rule::new("feed", feeds::clamp, Citation::new("cutting feed clamp, a parameter", Grade::Inferred)),
    Rule::new("infeed", feeds::infeed_clamp, Citation::new("cutting feed clamp, a parameter", Grade::Inferred)),
    Rule::new("free-length", place::jaws, Citation::new("mechanics", Grade::Inferred)),
    Rule::new("finish-feed", feeds::finish_clamp, Citation::new("cutting feed clamp, a parameter", Grade::Inferred)),
    Rule::new("mark-pitch", feeds::finish_marks, Citation::new("polygon turning facts 3.2", Grade::Inferred)),
    Rule::new("rough-mark-pitch", feeds::rough_marks, Citation::new("polygon turning facts 3.2", Grade::Inferred)),
    Rule::new("bending", bending::judge, Citation::new("polygon turning facts 3.13", Grade::Open)),
    Rule::new("tool-torque", drives::tool_peak, MOTOR),
    Rule::new("tool-torque-effective", drives::tool_effective, MOTOR),
    Rule::new("tool-power", drives::tool_power, MOTOR),
    Rule::new("tool-run-up", drives::tool_run_up, MOTOR),
    Rule::new("work-torque", drives::work_peak, MOTOR),
    Rule::new("work-torque-effective", drives::work_effective, MOTOR),
    Rule::new("work-power", drives::work_power, MOTOR),
    Rule::new("work-run-up", drives::work_run_up, MOTOR),
    Rule::new(
        "main-top-speed",
        main_spindle::judge_speed,
        Citation::new("greatest speed of the work axis", Grade::Manual),
    ),
    Rule::new("main-least-volts", main_spindle::judge_volts, Citation::new("engineering choice", Grade::Inferred)),
    Rule::new("main-torque", main_spindle::judge_torque, MOTOR),
    Rule::new(
        "main-shortest-ramp",
        main_spindle::judge_ramp,
        Citation::new("turning spindle facts, 5", Grade::Inferred),
    ),
];
