//! Parameters of a control that a machine has to set.

use super::table::{Key, text_key};
use crate::text::{Citation, Phrase};

/// What a parameter is for, independent of its number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum ParamRole {
    /// How many spindles there are; whether there is a single one.
    SpindleCount,
    /// How the spindle is connected; whether by analog output.
    SpindleConnection,
    /// Spindle speed at full analog output, first gear.
    SpindleLimit,
    /// Spindle speed at full analog output, gear 2 and up.
    SpindleGear(u8),
    /// What is added to the analog output at standstill.
    SpindleOffsetZero,
    /// What is added to the analog output at its rated speed, or its gain there.
    SpindleOffsetRated,
    /// Analog output while gears are shifted.
    SpindleShiftVolts,
    /// Whether cuts wait until the spindle has reached its speed.
    SpindleReached,
    /// How long after a new speed that is looked at.
    SpindleReachedDelay,
    /// Spindle speed clamp, first gear.
    SpindleMaximum,
    /// Smallest spindle speed.
    SpindleMinimum,
    /// Whether the output is never negative.
    SpindleUnipolar,
    /// Part of the full output at the speed of [`SpindleLimit`](ParamRole::SpindleLimit).
    SpindleRatedVolts,
    /// Turns of the motor in the ratio of a gear stage.
    SpindleRatioMotor,
    /// Turns of the spindle in the ratio of a gear stage.
    SpindleRatioSpindle,
    /// Highest spindle speed of a gear stage, behind the gear.
    SpindleStageMaximum,
    /// Part of a speed within which it counts as reached.
    SpindleTolerance,
    /// Lowest speed that the operator and the program may set.
    SpindleLowerSet,
    /// Highest speed that the operator and the program may set.
    SpindleUpperSet,
    /// Highest speed under constant surface speed.
    SpindleSurfaceLimit,
    /// Speed at which the spindle goes to an angle.
    PositioningSpeed,
    /// Acceleration with which it does.
    PositioningAcceleration,
    /// Which way it looks for its zero mark; whether clockwise.
    PositioningClockwise,
    /// Whether gears are shifted by M codes.
    GearShift,
    /// Time until the old gear goes out.
    GearShiftBefore,
    /// Time until the voltage of the speed stands behind the new gear.
    GearShiftAfter,
    /// Whether M05 beside a motion stops the spindle at its end.
    StopLast,
    /// Whether the output goes to 0 V at M05.
    VoltsOffAtStop,
    /// Whether the spindle turns through a reset.
    TurnsThroughReset,
    /// Whether a spindle encoder is fitted.
    SpindleEncoder,
    /// Whether words of the axis count diameters.
    AxisDiameter,
    /// Rapid traverse of an axis.
    AxisRapid,
    /// Cutting feed clamp of an axis.
    AxisClamp,
    /// Kind of acceleration of an axis; whether linear.
    AxisAcceleration,
    /// Time constant of linear acceleration for cutting feed.
    AxisTimeConstant,
    /// Position gain of an axis.
    AxisPositionGain,
    /// Soft limits of an axis; whether there are any.
    AxisSoftLimits,
    /// In-position width.
    AxisInPosition,
    /// Rotary axis.
    AxisRotary,
    /// Whether the coordinates of a rotary axis begin anew with each turn: the axis is endless.
    AxisRollOver,
    /// Whether its displays do so, too.
    AxisRollDisplay,
    /// Whether absolute words of such an axis take the shorter way.
    AxisShortWay,
    /// Units of a turn behind which they begin anew.
    AxisTurn,
    /// Travel per turn of screw or roller.
    Lead,
    /// The same in whole millimetres.
    WholeLead,
    /// Turns of screw or roller in the ratio of the gear.
    LoadTurns,
    /// Turns of the motor in it.
    MotorTurns,
    /// Counts of the encoder per turn of the motor.
    EncoderCounts,
    /// Numerator of the ratio of encoder counts to output units.
    CountsOver,
    /// Its denominator.
    CountsUnder,
    /// Command units to detection units.
    CommandMultiplier,
    /// Detection units between two marks of the encoder.
    ReferenceCounts,
    /// Numerator of the ratio of detection units to counts.
    FeedGearOver,
    /// Its denominator.
    FeedGearUnder,
    /// Command unit; whether 0.001 mm.
    CommandUnit,
    /// Meaning of a word without a decimal point.
    DecimalPoint,
    /// Whether F with one digit is a stored feed.
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
    pub text: Phrase,
    /// Where it answers a question: what is written for yes and for no.
    pub answers: (&'static str, &'static str),
    /// For an axis whose words count diameters its value does so, too.
    pub diameter: bool,
    /// Source and grade.
    pub cite: Citation,
}

impl ParamDef {
    /// The row of a parameter that counts diameters where words do.
    pub(in crate::controls) const fn in_diameters(self) -> ParamDef {
        ParamDef { diameter: true, ..self }
    }

    /// The row with other answers than 1 for yes and 0 for no.
    pub(in crate::controls) const fn answered(self, yes: &'static str, no: &'static str) -> ParamDef {
        ParamDef { answers: (yes, no), ..self }
    }

    /// What is written for yes or no.
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
    /// Whether its table is sorted, for searches by halves.
    pub const SORTED: bool = false;

    /// What the row is about, for tables that are made of a family's rows and a control's own.
    pub const fn key(&self) -> Key {
        text_key(self.number.as_bytes())
    }

    /// The key of the row that a list names by its number.
    pub const fn listed_key(word: &[u8]) -> Key {
        text_key(word)
    }
}
