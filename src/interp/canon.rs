//! Canonical commands: the only commands from the interpreter to the machine, in the trade's terms.
//!
//! Positions are whole command increments (0.001 mm or 0.001° on most controls) in the machine frame, so that a million incremental blocks
//! add up exactly. On an axis programmed in diameters they count diameters. Tests compare the `Display` line of each command.

use core::fmt;

use crate::controls::AxisDef;
use crate::drives::speed::SpeedLimit;
use crate::drives::{Approach, Rotation};
use crate::text::number::Plain;

/// Maximum axes of a control.
pub const AXES: usize = 6;

/// End point of a motion. Axes outside the mask keep their position.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Target {
    /// End point of every axis in command increments, machine frame; axes outside the mask hold their present position.
    pub position: [i64; AXES],
    /// Bit `k`: axis `k` (in the control's order) was programmed.
    pub mask: u8,
}

/// A cutting feed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Feed {
    /// Along the path, in mm/min (°/min for rotary axes alone), before override and clamps.
    PerMinute(f64),
    /// Along the path, in mm per spindle revolution.
    PerRevolution(f64),
}

/// A command to the machine.
#[derive(Debug, Clone, PartialEq)]
pub enum Canon {
    /// Positioning of all programmed axes at rapid traverse.
    Rapid {
        /// End point.
        to: Target,
    },
    /// Straight cutting feed.
    Linear {
        /// End point.
        to: Target,
        /// Feed along the path.
        feed: Feed,
        /// Whether the axes stop and are checked in position at the end (G09, G61).
        exact: bool,
    },
    /// Thread cutting: straight, in step with the spindle, without feed override or hold.
    Thread {
        /// End point.
        to: Target,
        /// Lead along the path, in mm per spindle revolution.
        lead: f64,
    },
    /// A circular arc in the plane of two axes; other programmed axes move in proportion (helix).
    Arc {
        /// End point.
        to: Target,
        /// The two axes of the plane, as indices.
        plane: (u8, u8),
        /// Centre in the plane, in command increments, machine frame.
        center: (f64, f64),
        /// Clockwise seen from the positive third axis.
        clockwise: bool,
        /// Feed along the path.
        feed: Feed,
        /// Exact stop at the end.
        exact: bool,
    },
    /// Dwell for a time in seconds.
    Dwell {
        /// Seconds.
        seconds: f64,
    },
    /// Dwell for a number of spindle revolutions (G4 S).
    DwellTurns {
        /// Turns.
        turns: f64,
    },
    /// New work position of the present position (G50, G92). Machine positions do not change; the log only records the event.
    Preset {
        /// Work position in command increments.
        to: Target,
    },
    /// Spindle speed in r/min (S word), never negative; acts with the next or present direction.
    SpindleSpeed {
        /// r/min, before override, gears and clamps.
        rpm: f64,
    },
    /// Constant surface speed on, in m/min (G96). The spindle follows the diameter, twice the distance of an axis from its work zero.
    /// Issued again when that zero moves.
    SurfaceSpeed {
        /// m/min.
        speed: f64,
        /// Index of the axis perpendicular to the spindle: X on a lathe.
        axis: u8,
        /// Work zero of the axis in command increments, machine frame.
        zero: i64,
    },
    /// Constant surface speed off (G97); the spindle keeps its present speed.
    ConstantSpeed,
    /// A limit of the spindle speed in r/min (G25, G26, G50 S, G92 S, LIMS). It stays until another one is given.
    SpeedLimit {
        /// Kind of limit.
        limit: SpeedLimit,
        /// r/min.
        rpm: f64,
    },
    /// Gear stage of the spindle (M41 and up), or 0 for automatic selection by S (M40); the program waits for FIN.
    Gear {
        /// From 1; 0 is automatic.
        stage: u8,
    },
    /// Spindle positioning (SPOS): the spindle goes to an angle during the motion of its block, and is held there until M03, M04 or M05.
    /// The next block begins when the spindle is in position.
    Orient {
        /// Degrees, clockwise from the zero mark; [`Approach::Incremental`]: from the present angle.
        angle: f64,
        /// Direction of rotation.
        approach: Approach,
    },
    /// Spindle turns or stops: M03, M04, M05.
    SpindleDirection {
        /// Commanded rotation.
        rotation: Rotation,
    },
    /// A second spindle, such as a driven tool, turns or stops. Nothing else of that spindle is simulated.
    OtherSpindle {
        /// Number of the spindle.
        spindle: u8,
        /// Commanded rotation.
        rotation: Rotation,
    },
    /// An M code for the PLC; the program waits for FIN.
    Auxiliary {
        /// Number of the M code.
        code: u32,
    },
    /// A tool code (T) for the PLC; the program waits for FIN.
    Tool {
        /// Number of the T code.
        code: u32,
    },
    /// Value of a macro output variable, written to the PLC.
    Output {
        /// Variable number.
        variable: u32,
        /// Value of the variable.
        value: f64,
    },
    /// Feed hold, cutting override and exact stop check switched off by the program (`#3004`).
    Suppress {
        /// Feed hold has no effect.
        hold: bool,
        /// Cutting feed override acts as 100 %.
        feed_override: bool,
        /// G09 and G61 do not wait.
        exact: bool,
    },
    /// Single block stop and wait for FIN switched off by the program (`#3003`).
    SuppressWaits {
        /// Single block does not stop.
        single_block: bool,
        /// M, S and T do not wait for the PLC.
        fin: bool,
    },
    /// Exact stop mode (true) or cutting mode (false): G61, G64.
    PathMode {
        /// Exact stop.
        exact: bool,
    },
    /// Stop with a message on the screen (`#3006`); cycle start continues the program.
    Message {
        /// Text for the operator.
        text: String,
    },
    /// Message on the screen without a stop (MSG); an empty one clears the last message.
    Show {
        /// Text for the operator.
        text: String,
    },
    /// M00: waits for cycle start.
    Stop,
    /// M01: waits for cycle start if the optional stop switch is on.
    OptionalStop,
    /// M02 or M30: program end; the control resets.
    End,
}

/// Axis names and scale for writing a [`Canon`] as a line.
#[derive(Debug, Clone, Copy)]
pub struct CanonNames<'a> {
    /// Axes in the control's order.
    pub axes: &'a [AxisDef],
    /// Millimetres or degrees per command increment.
    pub increment: f64,
}

impl Target {
    fn write(&self, f: &mut impl fmt::Write, names: &CanonNames) -> fmt::Result {
        for (k, axis) in names.axes.iter().enumerate().take(AXES) {
            if self.mask & (1 << k) != 0 {
                f.write_char(' ')?;
                f.write_char(axis.letter.byte().into())?;
                decimal(self.position[k] as f64 * names.increment).write(f)?;
            }
        }
        Ok(())
    }
}

/// Formats with at most six decimals.
fn decimal(value: f64) -> Plain {
    Plain(value, 6)
}

/// A rotation in the canonical log.
fn rotation_word(rotation: Rotation) -> &'static str {
    match rotation {
        Rotation::Stopped => "stop",
        Rotation::Clockwise => "cw",
        Rotation::CounterClockwise => "ccw",
    }
}

impl Feed {
    fn write(&self, f: &mut impl fmt::Write) -> fmt::Result {
        f.write_str(" F")?;
        match self {
            Feed::PerMinute(feed) => decimal(*feed).write(f),
            Feed::PerRevolution(feed) => {
                decimal(*feed).write(f)?;
                f.write_str("/rev")
            }
        }
    }
}

impl Canon {
    /// Whether the command acts when its block is read, like a macro statement. All others wait for the preceding commands.
    pub fn acts_when_read(&self) -> bool {
        matches!(self, Canon::Output { .. } | Canon::Suppress { .. } | Canon::SuppressWaits { .. })
    }

    /// Whether a motion cuts; `None` for other commands.
    pub fn is_cut(&self) -> Option<bool> {
        match self {
            Canon::Rapid { .. } => Some(false),
            Canon::Linear { .. } | Canon::Arc { .. } | Canon::Thread { .. } => Some(true),
            _ => None,
        }
    }

    /// Whether the command sets an axis or a spindle in motion.
    pub fn moves(&self) -> bool {
        match self {
            Canon::Orient { .. } => true,
            Canon::SpindleDirection { rotation } | Canon::OtherSpindle { rotation, .. } => {
                *rotation != Rotation::Stopped
            }
            _ => self.is_cut().is_some(),
        }
    }

    /// The command as one line of the canonical log, for instance `linear X8 Y62.832 F119391.393`.
    pub fn line<'a>(&'a self, names: CanonNames<'a>) -> Line<'a> {
        Line { canon: self, names }
    }
}

/// A command and the names for writing it; see [`Canon::line`].
#[derive(Debug, Clone, Copy)]
pub struct Line<'a> {
    canon: &'a Canon,
    names: CanonNames<'a>,
}

impl fmt::Display for Line<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.write(f)
    }
}

impl Line<'_> {
    /// Writes the line to any writer, without a `fmt::Formatter`: a run writes one line per command.
    pub fn write(&self, f: &mut impl fmt::Write) -> fmt::Result {
        let names = &self.names;
        let stop = |exact: bool| if exact { " exact" } else { "" };
        match self.canon {
            Canon::Rapid { to } => {
                f.write_str("rapid")?;
                to.write(f, names)
            }
            Canon::Linear { to, feed, exact } => {
                f.write_str("linear")?;
                to.write(f, names)?;
                feed.write(f)?;
                f.write_str(stop(*exact))
            }
            Canon::Thread { to, lead } => {
                f.write_str("thread")?;
                to.write(f, names)?;
                Feed::PerRevolution(*lead).write(f)
            }
            Canon::Arc { to, plane, center, clockwise, feed, exact } => {
                f.write_str(if *clockwise { "arc-cw" } else { "arc-ccw" })?;
                to.write(f, names)?;
                for (axis, center) in [(plane.0, center.0), (plane.1, center.1)] {
                    let letter = names.axes.get(axis as usize).map_or('?', |axis| axis.letter.byte().into());
                    write!(f, " c{letter}{}", decimal(center * names.increment))?;
                }
                feed.write(f)?;
                f.write_str(stop(*exact))
            }
            Canon::Dwell { seconds } => write!(f, "dwell {}s", decimal(*seconds)),
            Canon::DwellTurns { turns } => write!(f, "dwell {}rev", decimal(*turns)),
            Canon::Preset { to } => {
                f.write_str("preset")?;
                to.write(f, names)
            }
            Canon::SpindleSpeed { rpm } => write!(f, "spindle-speed {}", decimal(*rpm)),
            Canon::SurfaceSpeed { speed, axis, zero } => {
                let letter = names.axes.get(*axis as usize).map_or('?', |axis| axis.letter.byte().into());
                write!(f, "surface-speed {} {letter}{}", decimal(*speed), decimal(*zero as f64 * names.increment))
            }
            Canon::ConstantSpeed => f.write_str("constant-speed"),
            Canon::SpeedLimit { limit, rpm } => {
                f.write_str(match limit {
                    SpeedLimit::Lower => "lower-",
                    SpeedLimit::Upper => "upper-",
                    SpeedLimit::Surface => "",
                })?;
                write!(f, "speed-limit {}", decimal(*rpm))
            }
            Canon::Gear { stage: 0 } => f.write_str("gear automatic"),
            Canon::Gear { stage } => write!(f, "gear {stage}"),
            Canon::Orient { angle, approach } => {
                f.write_str("orient ")?;
                decimal(*angle).write(f)?;
                f.write_str(match approach {
                    Approach::Direct => "",
                    Approach::Clockwise => " cw",
                    Approach::CounterClockwise => " ccw",
                    Approach::Incremental => " incremental",
                })
            }
            Canon::SpindleDirection { rotation } => {
                f.write_str("spindle-")?;
                f.write_str(rotation_word(*rotation))
            }
            Canon::OtherSpindle { spindle, rotation } => {
                write!(f, "other-spindle {spindle} {}", rotation_word(*rotation))
            }
            Canon::Auxiliary { code } => write!(f, "auxiliary M{code}"),
            Canon::Tool { code } => write!(f, "tool T{code}"),
            Canon::Output { variable, value } => write!(f, "output #{variable}={}", decimal(*value)),
            Canon::Suppress { hold, feed_override, exact } => {
                write!(f, "suppress hold={hold} feed-override={feed_override} exact={exact}")
            }
            Canon::SuppressWaits { single_block, fin } => {
                write!(f, "suppress-waits single-block={single_block} fin={fin}")
            }
            Canon::PathMode { exact: true } => f.write_str("exact-stop"),
            Canon::PathMode { exact: false } => f.write_str("cutting"),
            Canon::Message { text } => write!(f, "message {text}"),
            Canon::Show { text } => write!(f, "show {text}"),
            Canon::Stop => f.write_str("stop"),
            Canon::OptionalStop => f.write_str("optional-stop"),
            Canon::End => f.write_str("end"),
        }
    }
}
