//! From commands to time: the planner steps the interpreter, the timeline gives the machine at any moment.
//!
//! # Scope and limits of the simulation
//!
//! * **Reading ahead.** Each block costs the control its block time; at most `preread` blocks are read and not yet begun. Macro
//!   statements, inputs, `#3004` and macro outputs act when they are read, so a knob acts as late as on the machine. M00, M01, M02,
//!   M30 and messages stop the reading until they are executed.
//! * **Axes.** A path of constant feed, slowed as a whole where an axis would exceed its clamp; then acceleration "linear by time
//!   constant" (a moving average per axis) and the lag of the position loop. G64 begins a block when the unfiltered path of the one
//!   before ends; G61 and G09 wait until the command rests and the axes are in position; a rapid waits until the command rests.
//!   Dwell and S, M and T codes wait until the command rests. A block that is not ready in time lets the axes stop.
//! * **Diameters.** Words of an axis may count diameters. Values on the program's side (targets, centres of arcs, positions read by the
//!   program) count diameters then; plant, feeds, clamps, timeline and snapshots count the travel of the slide.
//! * **In step with the spindle.** Feed per revolution and threads follow the actual speed, in steps of 10 ms while it changes; at
//!   standstill they wait. Override and hold do not act on a thread. Under constant surface speed the spindle follows the diameter of a
//!   cut at its commanded position after acceleration: its command is computed every 10 ms, more often where the diameter changes fast
//!   or a limit begins, and is linear in between. In a rapid it has the speed of the rapid's end, or waits for the next cut.
//! * **Spindle.** S times override within its limits; the snapshot shows the active limit. The inverter follows in a straight ramp, with
//!   slip. Override acts at once. The PLC shifts gears: it receives the wanted stage and reports the engaged one. Positioning runs beside
//!   the motion of its block, which ends when both are finished. The [rules](crate::controls::SpindleRules) of a control hold its
//!   behaviour at M30, at reset, without M03, in threads and before cuts.
//! * **Web.** A regulator in the inverter may trim the speed by the web between spindle and axis: sampled while the program runs and the
//!   spindle turns; a trim becomes a ramp as long as the time between two samples. S and volts stay.
//! * **PLC.** Scanned when one of its inputs has changed and at the times it requests; the codes of one block are put out together and end
//!   with FIN.
//! * **PMC axes.** Axes moved by the PLC alone: it gives their speeds; acceleration and lag are those of any axis. Hold and the program's
//!   clamps do not act on them; overrides, reset and emergency stop act if the PLC lets them. A drive switched off by emergency stop
//!   coasts if the machine's PLC gives the coasting speeds; otherwise it stops over its time constant.
//! * **End.** When the program ends or stops, at an alarm, hold, reset or emergency stop, the timeline continues until the axes and spindle
//!   have settled; a spindle that keeps turning settles at its speed.
//! * **Operator.** Feed hold lets dwell and codes finish. Reset breaks off: the axes stop over their time constants. Cycle start at the
//!   exact time of a stop answers that stop; other actions come before the machine's events of the same time. Program zero return moves
//!   the axes while no program runs; feed hold ends it, and it has to be started again.

// Inputs and outputs.
mod input_name;
pub mod panel;
pub mod plant;
pub mod plc;
pub mod program;
pub mod setup;
pub mod snapshot;

// The record over time.
pub mod milestones;
mod path;
mod records;
pub mod run_segments;
mod spindle;
mod time_series;
pub mod timeline;

// State and plant of a simulation.
mod checked_plant;
mod exec;
mod moves;
mod once;
mod sim;
mod spindle_control;
mod state;

// Handling of events.
mod contacts;
mod dwell;
mod events;
mod executor;
mod feed;
mod operator;
mod orienting;
mod pmc;
mod reader;
mod signals;
mod spindle_speed;
mod standstill;
mod strobe;
mod surface_speed;
mod web_regulator;
mod zero_return;

// Runs.
pub mod fork;
pub mod gate;
pub mod plan;

pub use gate::Gate;
pub use input_name::InputName;
pub use milestones::Milestone;
pub use panel::{Action, ActionValue, Event, Panel};
pub use plan::Planner;
pub use plant::{AxisPlant, PMC_AXES, Plant, SpindlePlant, WebRegulator};
pub use plc::{
    BenchPlc, GearShift, OverrideKnobs, Plc, PlcAlarm, PlcOrders, PlcSignals, ProgramState, SpindleOrders, Strobes,
    WordPart,
};
pub use program::RunningProgram;
pub use run_segments::{Mover, RunSegment};
pub use setup::{Budget, GatedProgress, PlanProgress, Retention, RunEnd, Setup};
pub use snapshot::{AxisState, Mode, Snapshot, SpindleState};
pub use timeline::{Timeline, Visit};
