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
    /// Whether the signal of the shift speed belongs to gear changes.
    ShiftBySignal,
    /// Output of the shift speed as a share of 4095.
    SpindleShiftCode,
    /// Motor speed while gears are shifted.
    MotorShiftSpeed,
    /// Whether cuts wait until the spindle has reached its speed.
    SpindleReached,
    /// Delay between a new speed command and the speed-reached check.
    SpindleReachedDelay,
    /// Spindle speed clamp of all gears.
    SpindleMaximum,
    /// Spindle speed clamp of a gear, where each has its own.
    SpindleGearMaximum(u8),
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
    /// Reset brings the program back to its first block.
    RewindAtReset,
    /// The end of the program brings it back to its first block.
    RewindAtEnd,
    /// Whether the PLC writes the spindle override in a code instead of percent.
    OverrideIsCoded,
    /// Whether a spindle encoder is fitted.
    SpindleEncoder,
    /// Lines per turn of the spindle encoder.
    SpindleEncoderLines,
    /// Whether the spindle encoder is on the spindle and not on its motor.
    SpindleEncoderDirect,
    /// Turns of the encoder in its ratio to the spindle.
    SpindleEncoderTurns,
    /// Turns of the spindle in that ratio.
    SpindleEncoderSpindleTurns,
    /// High bit of the ratio of spindle to encoder: 1, 2, 4 or 8 turns of the spindle per turn of the encoder.
    SpindleEncoderHigh,
    /// Low bit of that ratio.
    SpindleEncoderLow,
    /// Whether words of the axis count diameters.
    AxisDiameter,
    /// Rapid traverse of an axis.
    AxisRapid,
    /// Cutting feed clamp of an axis.
    AxisClamp,
    /// Cutting feed clamp along the path, of all axes together.
    PathClamp,
    /// Kind of acceleration of an axis; as yes or no: linear.
    AxisAcceleration,
    /// Time constant of linear acceleration for rapid traverse.
    RapidTimeConstant,
    /// Time constant of linear acceleration for cutting feed.
    AxisTimeConstant,
    /// Greatest acceleration of an axis, where a control has no time constant.
    AxisGreatestAcceleration,
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
    /// Detection units between two marks of the encoder; numerator where they are no whole number.
    ReferenceCounts,
    /// Denominator of the detection units between two marks.
    ReferenceCountsUnder,
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

/// Unit of a parameter's value.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum ParamUnit {
    /// No unit: a number of pieces, a ratio, a choice.
    Plain,
    /// Digits of a hexadecimal number.
    Hexadecimal,
    /// mm.
    Mm,
    /// 0.001 mm.
    ThousandthMm,
    /// 0.1 µm.
    TenthMicrometre,
    /// mm/min.
    MmPerMinute,
    /// mm/min; r/min of a rotary axis.
    MmOrTurnsPerMinute,
    /// m/s²; rev/s² of a rotary axis.
    MetresPerSecondSquared,
    /// °.
    Degrees,
    /// r/min.
    TurnsPerMinute,
    /// rev/s².
    TurnsPerSecondSquared,
    /// ms.
    Milliseconds,
    /// 1/s.
    PerSecond,
    /// 0.01/s.
    HundredthPerSecond,
    /// 1000/min.
    ThousandPerMinute,
    /// Pulses per revolution.
    PulsesPerTurn,
    /// Thousand pulses per revolution.
    KilopulsesPerTurn,
    /// Pulses of a length or a voltage that the manual at hand does not name.
    Pulses,
    /// mV.
    Millivolts,
    /// %.
    Percent,
    /// 0.1 %.
    TenthPercent,
}

impl ParamUnit {
    /// The unit as shown, or empty.
    pub const fn text(self) -> &'static str {
        match self {
            ParamUnit::Plain => "",
            ParamUnit::Hexadecimal => "hex",
            ParamUnit::Mm => "mm",
            ParamUnit::ThousandthMm => "0.001 mm",
            ParamUnit::TenthMicrometre => "0.1 µm",
            ParamUnit::MmPerMinute | ParamUnit::MmOrTurnsPerMinute => "mm/min",
            ParamUnit::MetresPerSecondSquared => "m/s²",
            ParamUnit::Degrees => "°",
            ParamUnit::TurnsPerMinute => "r/min",
            ParamUnit::TurnsPerSecondSquared => "rev/s²",
            ParamUnit::Milliseconds => "ms",
            ParamUnit::PerSecond => "1/s",
            ParamUnit::HundredthPerSecond => "0.01/s",
            ParamUnit::ThousandPerMinute => "1000/min",
            ParamUnit::PulsesPerTurn => "p/rev",
            ParamUnit::KilopulsesPerTurn => "kp/rev",
            ParamUnit::Pulses => "pulses",
            ParamUnit::Millivolts => "mV",
            ParamUnit::Percent => "%",
            ParamUnit::TenthPercent => "0.1 %",
        }
    }

    /// The unit as shown for a rotary axis, whose units are degrees.
    pub const fn rotary_text(self) -> &'static str {
        match self {
            ParamUnit::Mm => "°",
            ParamUnit::ThousandthMm => "0.001 °",
            ParamUnit::MmPerMinute => "°/min",
            ParamUnit::MmOrTurnsPerMinute => "r/min",
            ParamUnit::MetresPerSecondSquared => "rev/s²",
            other => other.text(),
        }
    }

    /// Units per unit of a machine's form (mm, mm/min, mm/s², °, r/min, r/min per second, ms, 1/s, p/rev, mV, %); `None` where the length or
    /// the voltage of the unit is unknown.
    pub const fn per_form_unit(self) -> Option<f64> {
        match self {
            ParamUnit::Plain
            | ParamUnit::Hexadecimal
            | ParamUnit::Mm
            | ParamUnit::MmPerMinute
            | ParamUnit::MmOrTurnsPerMinute
            | ParamUnit::Degrees
            | ParamUnit::TurnsPerMinute
            | ParamUnit::Milliseconds
            | ParamUnit::PerSecond
            | ParamUnit::PulsesPerTurn
            | ParamUnit::Millivolts
            | ParamUnit::Percent => Some(1.0),
            ParamUnit::ThousandthMm => Some(1000.0),
            ParamUnit::TenthMicrometre => Some(10_000.0),
            ParamUnit::HundredthPerSecond => Some(100.0),
            ParamUnit::TenthPercent => Some(10.0),
            ParamUnit::KilopulsesPerTurn | ParamUnit::MetresPerSecondSquared => Some(0.001),
            // 60 s of a minute by a thousand.
            ParamUnit::ThousandPerMinute => Some(0.06),
            ParamUnit::TurnsPerSecondSquared => Some(1.0 / 60.0),
            ParamUnit::Pulses => None,
        }
    }

    /// Units per unit of a machine's form for a rotary axis, whose form counts degrees.
    pub const fn per_rotary_form_unit(self) -> Option<f64> {
        match self {
            ParamUnit::MmOrTurnsPerMinute | ParamUnit::MetresPerSecondSquared => Some(1.0 / 360.0),
            other => other.per_form_unit(),
        }
    }
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
    /// Unit of its value.
    pub unit: ParamUnit,
    /// Description.
    pub text: Phrase,
    /// Values for yes and no, for roles that are a question.
    pub answers: (&'static str, &'static str),
    /// The value counts diameters for an axis whose words do.
    pub diameter: bool,
    /// Least and greatest value that the control takes, where its manual says so.
    pub range: Option<(f64, f64)>,
    /// Source and grade.
    pub cite: Citation,
}

impl ParamDef {
    /// The row, with the range of its value.
    pub(in crate::controls) const fn within(self, least: f64, most: f64) -> ParamDef {
        ParamDef { range: Some((least, most)), ..self }
    }

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
    unit: ParamUnit,
    text: &'static str,
    cite: Citation,
) -> ParamDef {
    ParamDef {
        role,
        number,
        name,
        unit,
        text: Phrase::new(text),
        answers: ("1", "0"),
        diameter: false,
        range: None,
        cite,
    }
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
