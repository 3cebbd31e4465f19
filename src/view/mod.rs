//! Readouts, charts, scenes and sheets as plain data, drawn last. Views are independent of the machines.

pub mod chart;

pub mod field_entry;

pub mod readout;

pub mod letters;

pub mod look;

pub mod scene;

pub mod drawing;

pub mod parts;

pub mod balloons;

pub mod ladder;

pub mod sheet;

pub mod comparison;

pub mod explorer;

pub mod svg;

pub mod outline;

pub mod csv;

pub mod plot;

pub mod tornado_chart;
pub mod torque_chart;

pub mod report;

pub use chart::{Chart, ChartAxis, ChartLimit, Series};
pub use comparison::{ComparedRow, Comparison, VariantCell};
pub use drawing::{Callout, Drawing};
pub use explorer::{Explorer, Slider};
pub use field_entry::FieldEntry;
pub use letters::Anchor;
pub use look::{Look, Paint};
pub use parts::DrawnPart;
pub use readout::{Advice, Limit, Readout, Repair, Repairs, Verdict};
pub use scene::{Font, Node, Placement, Pose, Scene, SceneGroup, Shape};
pub use sheet::{Column, Row, Sheet, SheetKind};
pub use svg::Theme;
pub use tornado_chart::{TornadoBar, TornadoChart};
pub use torque_chart::{MotorPoint, OperatingLine, TorqueChart, TorqueWords};
