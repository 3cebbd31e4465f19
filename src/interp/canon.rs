//! Canonical commands: the narrow waist between language and machine, in the words of the trade.
//!
//! Positions are whole command increments (0.001 mm or 0.001° on most controls) in the machine frame, so that a million
//! incremental blocks add up exactly. They count what words count: on an axis that is programmed in diameters, diameters. Each variant's `Display` line is the test oracle.

use core::fmt;

use crate::controls::AxisDef;
use crate::drives::Approach;
use crate::drives::speed::SpeedLimit;
use crate::text::number::Plain;

/// Axes that a control can have at most.
pub const AXES: usize = 6;

/// Where axes go. Axes outside the mask keep their position.
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
        /// Where to.
        to: Target,
    },
    /// Straight cutting feed.
    Linear {
        /// Where to.
        to: Target,
        /// How fast along the path.
        feed: Feed,
        /// Whether the axes stop and are checked in position at the end (G09, G61).
        exact: bool,
    },
    /// Thread cutting: straight, in step with the spindle, without feed override or hold.
    Thread {
        /// Where to.
        to: Target,
        /// Along the path, in mm per spindle revolution.
        lead: f64,
    },
    /// A circular arc in the plane of two axes; other programmed axes move in proportion (helix).
    Arc {
        /// Where to.
        to: Target,
        /// The two axes of the plane, as indices.
        plane: (u8, u8),
        /// Centre in the plane, in command increments, machine frame.
        center: (f64, f64),
        /// Clockwise seen from the positive third axis.
        clockwise: bool,
        /// How fast along the path.
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
    /// The present position is from now on this work position; machine positions do not change. Says only that it happened.
    Preset {
        /// Work position in command increments.
        to: Target,
    },
    /// Spindle speed in r/min (S word), never negative; acts with the next or present direction.
    SpindleSpeed {
        /// r/min, before override, gears and clamps.
        rpm: f64,
    },
    /// Constant surface speed from now on, in m/min (G96): the spindle follows the diameter, which is twice the distance of an axis
    /// from its work zero. Said again when that zero moves.
    SurfaceSpeed {
        /// m/min.
        speed: f64,
        /// Index of the axis that is square to the spindle: X on a lathe.
        axis: u8,
        /// Its work zero in command increments, machine frame.
        zero: i64,
    },
    /// No constant surface speed any more (G97); the spindle keeps the speed that it has.
    ConstantSpeed,
    /// A limit of the spindle speed in r/min (G25, G26, G50 S, G92 S, LIMS). It stays until another one is given.
    SpeedLimit {
        /// Which.
        limit: SpeedLimit,
        /// r/min.
        rpm: f64,
    },
    /// Gear stage of the spindle (M41 …), 0 for one that each S selects (M40); the program waits for FIN.
    Gear {
        /// From 1.
        stage: u8,
    },
    /// The spindle goes to an angle, beside the motion of its block, and is held there until a direction or stop is given (SPOS). The next
    /// block begins when it is there.
    Orient {
        /// Degrees, clockwise from the zero mark; [`Approach::Incremental`]: from where it is.
        angle: f64,
        /// Which way it goes.
        approach: Approach,
    },
    /// Spindle turns clockwise (1), counter-clockwise (-1) or stops (0): M03, M04, M05.
    SpindleDirection {
        /// 1, -1 or 0.
        sign: i8,
    },
    /// Another spindle than the machine's own turns clockwise (1), counter-clockwise (-1) or stops (0): a driven tool. Nothing else of it is
    /// simulated.
    OtherSpindle {
        /// Its number.
        spindle: u8,
        /// 1, -1 or 0.
        sign: i8,
    },
    /// An M code that is the PLC's; the program waits for FIN.
    Auxiliary {
        /// The number behind M.
        code: u32,
    },
    /// A tool code (T) for the PLC; the program waits for FIN.
    Tool {
        /// The number behind T.
        code: u32,
    },
    /// A macro variable that is an output to the PLC.
    Output {
        /// Variable number.
        variable: u32,
        /// Its value.
        value: f64,
    },
    /// Which of feed hold, cutting override and exact stop check the program has switched off (`#3004`).
    Suppress {
        /// Feed hold has no effect.
        hold: bool,
        /// Cutting feed override is taken as 100 %.
        feed_override: bool,
        /// G09 and G61 do not wait.
        exact: bool,
    },
    /// Whether single block stop and the wait for FIN are switched off (`#3003`).
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
    /// Stop with a message on the screen (`#3006`); cycle start goes on.
    Message {
        /// Text for the operator.
        text: String,
    },
    /// Message on the screen while the program goes on; an empty one takes the last away (MSG).
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

/// Names and scale that a [`Canon`] needs to be written as a line.
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

/// At most six decimals.
fn decimal(value: f64) -> Plain {
    Plain(value, 6)
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
    /// Whether it acts when its block is read, as macro statements do; all others wait for those before them.
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

    /// Whether it sets an axis or a spindle in motion.
    pub fn moves(&self) -> bool {
        match self {
            Canon::Orient { .. } => true,
            Canon::SpindleDirection { sign } | Canon::OtherSpindle { sign, .. } => *sign != 0,
            _ => self.is_cut().is_some(),
        }
    }

    /// The command as one line of the canonical log, for instance `linear X8 Y62.832 F119391.393`.
    pub fn line<'a>(&'a self, names: CanonNames<'a>) -> Line<'a> {
        Line { canon: self, names }
    }
}

/// A command with the names it needs to be written; see [`Canon::line`].
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
    /// Writes the line where pieces cost least: a run writes one for every command.
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
            Canon::SpindleDirection { sign: 1 } => f.write_str("spindle-cw"),
            Canon::SpindleDirection { sign: -1 } => f.write_str("spindle-ccw"),
            Canon::SpindleDirection { .. } => f.write_str("spindle-stop"),
            Canon::OtherSpindle { spindle, sign } => {
                write!(f, "other-spindle {spindle} {}", ["ccw", "stop", "cw"][(sign.signum() + 1) as usize])
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
