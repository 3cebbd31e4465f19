//! Parameters of a control that a machine has to set.

use crate::text::Citation;

/// What a parameter is for, independent of its number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum ParamRole {
    /// How many spindles there are.
    SpindleCount,
    /// How the spindle is connected (analog, bus).
    SpindleConnection,
    /// Spindle speed at full analog output, first gear.
    SpindleLimit,
    /// Spindle speed clamp, first gear.
    SpindleMaximum,
    /// Smallest spindle speed.
    SpindleMinimum,
    /// Whether a spindle encoder is fitted.
    SpindleEncoder,
    /// Rapid traverse of an axis.
    AxisRapid,
    /// Cutting feed clamp of an axis.
    AxisClamp,
    /// Kind of acceleration of an axis.
    AxisAcceleration,
    /// Time constant of linear acceleration for cutting feed.
    AxisTimeConstant,
    /// Position gain of an axis.
    AxisPositionGain,
    /// Soft limits of an axis (equal: none).
    AxisSoftLimits,
    /// In-position width.
    AxisInPosition,
    /// Rotary axis.
    AxisRotary,
    /// Command unit.
    CommandUnit,
    /// Meaning of a word without a decimal point.
    DecimalPoint,
    /// F with one digit.
    FeedOneDigit,
    /// Check method of exact stop.
    ExactStopCheck,
    /// Common variables emptied at reset.
    VariablesAtReset,
    /// Common variables emptied at power-on.
    VariablesAtPowerOn,
    /// Protection of the program numbers of the builder.
    EditLock,
    /// Macro blocks stop in single block.
    MacroSingle,
}

/// A parameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ParamDef {
    /// What it is for.
    pub role: ParamRole,
    /// Number as it is written, for instance `#3001`.
    pub number: &'static str,
    /// Short name on the screen, for instance `slimt1`.
    pub name: &'static str,
    /// Unit, or empty.
    pub unit: &'static str,
    /// What it does.
    pub text: &'static str,
    /// Source and grade.
    pub cite: Citation,
}

/// A row of a parameter.
pub(super) const fn param(
    role: ParamRole,
    number: &'static str,
    name: &'static str,
    unit: &'static str,
    text: &'static str,
    cite: Citation,
) -> ParamDef {
    ParamDef { role, number, name, unit, text, cite }
}
