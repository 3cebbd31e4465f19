//! The types of the tables: the facts that describe a control, each row with source and grade.

pub mod table;

pub mod address;

pub mod syntax;

pub mod code;

pub mod vars;

pub mod macros;

pub mod limits;

pub mod alarm;

pub mod options;

pub mod switch;

pub mod params;

pub mod interface;

pub mod analog_output;

pub mod scaling;

pub mod bench;

pub mod spindle;

pub mod drive;

pub mod characters;

pub mod control;

pub mod dialect;

pub use address::{Address, AddressSet};
pub use alarm::{Alarm, AlarmDef};
pub use analog_output::AnalogOutput;
pub use bench::Bench;
pub use code::{Code, CodeDef, CodeId, CodeNumber, Group, Point};
pub use control::{AxisDef, Control};
pub use dialect::Dialect;
pub use drive::{DriveRole, DriveSystem};
pub use interface::Signal;
pub use limits::{FeedKnob, Limits, Timing};
pub use macros::Macros;
pub use params::{ParamDef, ParamRole, ParamUnit};
pub use scaling::{AxisScaling, ScalingKind};
pub use spindle::SpindleRules;
pub use switch::{Switch, Switches};
pub use syntax::Syntax;
pub use vars::{VarKind, VarRange};
