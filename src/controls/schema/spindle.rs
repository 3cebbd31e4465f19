//! How a control commands its spindle: what S, M3, constant surface speed and limits do on it.

use crate::drives::speed::Steps;
use crate::text::Citation;

/// The speed in a rapid under constant surface speed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RapidSpeed {
    /// That of its end, from its beginning on.
    OfEnd,
    /// Unchanged, unless the next block is a cut: then that of its end, as soon as that block is read.
    BeforeCutBlock,
    /// Unchanged, unless the next motion is a cut, blocks without motion between them: then that of its end, as soon as the cut is read.
    BeforeCut,
    /// Unchanged: the speed follows the axis in cuts alone.
    Kept,
}

/// What an upper limit by G50 S does besides with the position.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LimitPlace {
    /// Nothing.
    Nothing,
    /// The present position is the reference point of the program from now on; coordinates stay.
    ReferencePoint,
    /// The present position is work zero from now on.
    WorkZero,
}

/// Rules of the spindle. Flags name what happens where they are set.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpindleRules {
    /// The voltage of S stands without M03 and M04, and through reset and emergency stop; contacts switch the drive.
    pub volts_stay: bool,
    /// The offset of the output at speed 0 is put out at S0 and after power-on too; else these are 0 V.
    pub offset_at_rest: bool,
    /// Rapids under constant surface speed.
    pub rapid: RapidSpeed,
    /// G96 sets the speed for where the tool is at once, not with the next cut.
    pub surface_at_once: bool,
    /// The upper limit of constant surface speed holds constant speeds too.
    pub surface_limit_stays: bool,
    /// G96 counts feed per revolution.
    pub surface_per_revolution: bool,
    /// G94 and G95 end constant surface speed.
    pub feed_ends_surface: bool,
    /// Where they do, the last S in r/min is in force again; else the spindle keeps its speed.
    pub last_speed_back: bool,
    /// Least and largest cutting speed behind S in m/min; `None` where S has the same range as always.
    pub surface_range: Option<(f64, f64)>,
    /// Distance (mm) of work zero from the turning centre up to which constant surface speed counts as exact enough.
    pub small_offset: f64,
    /// What G50 S does with the position.
    pub limit_place: LimitPlace,
    /// The override acts behind the limits, not before them.
    pub override_last: bool,
    /// The spindle override acts on threads.
    pub thread_override: bool,
    /// Emergency stop takes S away, and with it the voltage.
    pub emergency_clears: bool,
    /// A cut begins when the speed is within this part of what is commanded, for instance 0.1; `None`: at once.
    pub reached: Option<f64>,
    /// M05 beside a motion acts at its end.
    pub stop_last: bool,
    /// The spindle goes on through reset.
    pub turns_through_reset: bool,
    /// M19 is the control's own positioning at 0°, not the PLC's.
    pub orients: bool,
    /// Angles beyond a turn are taken back into it; else they are an alarm.
    pub angle_wraps: bool,
    /// M02 and M30 stop the spindle and leave S0.
    pub end_stops: bool,
    /// S given by hand acts while the program runs; else it is refused.
    pub manual_in_automatic: bool,
    /// Positions of the override knob.
    pub knob: Steps,
    /// Millivolts that the parameters of the output's offsets may be, at speed 0 and at full output; `None` where no row has them.
    pub offsets: Option<[(f64, f64); 2]>,
    /// Speeds at full output that a gear stage may have, in r/min; `None` where no row says.
    pub stage_speeds: Option<(f64, f64)>,
    /// The lowest speed of the machine's data holds constant speeds too, not only those of a surface speed.
    pub low_always: bool,
    /// A lower limit above the upper one (G25 above G26) holds the speed; else the upper one does.
    pub lower_wins: bool,
    /// The analog output may carry the direction as its sign (±10 V).
    pub signed_output: bool,
    /// M04 while the PLC puts out M03, or the other way round, is an alarm of the PLC: M05 has to come between.
    pub stop_between: bool,
    /// M code of the machine builder that locks the spindle at an angle; `None`: any code of his is taken for it.
    pub lock: Option<u32>,
    /// M code of the machine builder that starts a driven tool; `None`: only another spindle is one.
    pub driven_tool: Option<u32>,
    /// Source and grade.
    pub cite: Citation,
}

/// The override switch of machine control panels.
pub(super) const PANEL: Steps = Steps { low: 50.0, high: 120.0, step: 5.0 };

/// Part of the speed within which it counts as reached, where the drive's own signal tells the control.
/// Source: `reference/sinumerik-802d.md` section 3.2 (MD35150).
pub(crate) const REACHED: f64 = 0.1;
