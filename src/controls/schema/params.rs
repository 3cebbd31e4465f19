//! Parameters of a control that a machine has to set.

use super::table::{Key, text_key};
use crate::text::{Citation, Phrase};

/// Purpose of a parameter, independent of its number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum ParamRole {
    /// Number of spindles; as yes or no: a single spindle.
    SpindleCount,
    /// Connection of the spindle; as yes or no: by analog output.
    SpindleConnection,
    /// Spindle speed at full analog output, first gear.
    SpindleLimit,
    /// Spindle speed at full analog output, gear 2 and up.
    SpindleGear(u8),
    /// Offset of the analog output at standstill.
    SpindleOffsetZero,
    /// Offset of the analog output at rated speed, or its gain there.
    SpindleOffsetRated,
    /// Analog output during a gear change.
    SpindleShiftVolts,
    /// Whether cuts wait until the spindle has reached its speed.
    SpindleReached,
    /// Delay between a new speed command and the speed-reached check.
    SpindleReachedDelay,
    /// Spindle speed clamp, first gear.
    SpindleMaximum,
    /// Smallest spindle speed.
    SpindleMinimum,
    /// Whether the output is never negative.
    SpindleUnipolar,
    /// Analog output as a fraction of full output at the speed of [`SpindleLimit`](ParamRole::SpindleLimit).
    SpindleRatedVolts,
    /// Motor turns in the gear ratio of a gear stage.
    SpindleRatioMotor,
    /// Spindle turns in the gear ratio of a gear stage.
    SpindleRatioSpindle,
    /// Maximum spindle speed of a gear stage.
    SpindleStageMaximum,
    /// Fraction of the commanded speed within which the speed counts as reached.
    SpindleTolerance,
    /// Lowest spindle speed limit by operator or program.
    SpindleLowerSet,
    /// Highest spindle speed limit by operator or program.
    SpindleUpperSet,
    /// Highest speed under constant surface speed.
    SpindleSurfaceLimit,
    /// Spindle speed for positioning.
    PositioningSpeed,
    /// Spindle acceleration for positioning.
    PositioningAcceleration,
    /// Direction of the search for the spindle's zero mark; as yes or no: clockwise.
    PositioningClockwise,
    /// Whether gears are shifted by M codes.
    GearShift,
    /// Time until the old gear disengages.
    GearShiftBefore,
    /// Time between the new gear and the voltage of the commanded speed.
    GearShiftAfter,
    /// Whether M05 in a block with motion stops the spindle at the end of the motion.
    StopLast,
    /// Whether the output goes to 0 V at M05.
    VoltsOffAtStop,
    /// Whether the spindle keeps turning at reset.
    TurnsThroughReset,
    /// Whether a spindle encoder is fitted.
    SpindleEncoder,
    /// Whether words of the axis count diameters.
    AxisDiameter,
    /// Rapid traverse of an axis.
    AxisRapid,
    /// Cutting feed clamp of an axis.
    AxisClamp,
    /// Kind of acceleration of an axis; as yes or no: linear.
    AxisAcceleration,
    /// Time constant of linear acceleration for cutting feed.
    AxisTimeConstant,
    /// Position gain of an axis.
    AxisPositionGain,
    /// Soft limits of an axis; as yes or no: there are any.
    AxisSoftLimits,
    /// In-position width.
    AxisInPosition,
    /// Rotary axis.
    AxisRotary,
    /// Whether the coordinates of a rotary axis restart with each turn, for an endless axis.
    AxisRollOver,
    /// Whether the displayed coordinates restart, too.
    AxisRollDisplay,
    /// Whether absolute words of an endless rotary axis take the shorter way.
    AxisShortWay,
    /// Units per turn, after which the coordinates restart.
    AxisTurn,
    /// Travel per turn of screw or roller.
    Lead,
    /// Travel per turn of screw or roller in whole millimetres.
    WholeLead,
    /// Turns of screw or roller in the ratio of the gear.
    LoadTurns,
    /// Motor turns in the ratio of the gear.
    MotorTurns,
    /// Encoder counts per motor turn.
    EncoderCounts,
    /// Numerator of the ratio of encoder counts to output units.
    CountsOver,
    /// Denominator of the ratio of encoder counts to output units.
    CountsUnder,
    /// Command units to detection units.
    CommandMultiplier,
    /// Detection units between two marks of the encoder.
    ReferenceCounts,
    /// Numerator of the ratio of detection units to counts.
    FeedGearOver,
    /// Denominator of the ratio of detection units to counts.
    FeedGearUnder,
    /// Command unit; as yes or no: 0.001 mm.
    CommandUnit,
    /// Meaning of a word without a decimal point.
    DecimalPoint,
    /// Whether a one-digit F selects a stored feed.
    FeedOneDigit,
    /// Check method of exact stop.
    ExactStopCheck,
    /// Common variables emptied at reset.
    VariablesAtReset,
    /// Common variables emptied at power-on.
    VariablesAtPowerOn,
    /// Edit protection for the machine builder's program numbers.
    EditLock,
    /// Macro blocks stop in single block.
    MacroSingle,
}

/// A parameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ParamDef {
    /// Purpose of the parameter.
    pub role: ParamRole,
    /// Number in the control's spelling, for instance `#3001`.
    pub number: &'static str,
    /// Short name on the screen, for instance `slimt1`.
    pub name: &'static str,
    /// Unit, or empty.
    pub unit: &'static str,
    /// Description.
    pub text: Phrase,
    /// Values for yes and no, for roles that are a question.
    pub answers: (&'static str, &'static str),
    /// The value counts diameters for an axis whose words do.
    pub diameter: bool,
    /// Source and grade.
    pub cite: Citation,
}

impl ParamDef {
    /// The row, with a value that counts diameters for an axis whose words do.
    pub(in crate::controls) const fn in_diameters(self) -> ParamDef {
        ParamDef { diameter: true, ..self }
    }

    /// The row, with values for yes and no other than 1 and 0.
    pub(in crate::controls) const fn answered(self, yes: &'static str, no: &'static str) -> ParamDef {
        ParamDef { answers: (yes, no), ..self }
    }

    /// Parameter value for yes or no.
    pub fn answer(&self, yes: bool) -> &'static str {
        if yes { self.answers.0 } else { self.answers.1 }
    }
}

/// A row of a parameter.
pub(in crate::controls) const fn param(
    role: ParamRole,
    number: &'static str,
    name: &'static str,
    unit: &'static str,
    text: &'static str,
    cite: Citation,
) -> ParamDef {
    ParamDef { role, number, name, unit, text: Phrase::new(text), answers: ("1", "0"), diameter: false, cite }
}

impl ParamDef {
    /// Whether the table is sorted, for binary search.
    pub const SORTED: bool = false;

    /// Key for replacing a family's row by the control's own row of the same number.
    pub const fn key(&self) -> Key {
        text_key(self.number.as_bytes())
    }

    /// The key of an entry in a row list, by parameter number.
    pub const fn listed_key(word: &[u8]) -> Key {
        text_key(word)
    }
}
