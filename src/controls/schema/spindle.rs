//! Spindle rules of a control: effects of S, M3, constant surface speed and limits.

use crate::drives::speed::KnobRange;
use crate::text::Citation;

/// Spindle speed in a rapid under constant surface speed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RapidSpeed {
    /// From the start of the rapid, the speed for its end point.
    OfEnd,
    /// Unchanged, unless the next block is a cut: then the speed for the rapid's end point, as soon as that block is read.
    BeforeCutBlock,
    /// Unchanged, unless the next motion is a cut (blocks without motion may come between): then the speed for the rapid's end point, as
    /// soon as the cut is read.
    BeforeCut,
    /// Unchanged: the speed follows the position in cuts only.
    Kept,
}

/// Effect of an upper limit by G50 S on the coordinate system.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LimitPlace {
    /// Nothing.
    Nothing,
    /// The present position becomes the program's reference point; coordinates stay.
    ReferencePoint,
    /// The present position becomes work zero.
    WorkZero,
}

/// Spindle rules of a control.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpindleRules {
    /// The analog output follows S even without M03 and M04, and through reset and emergency stop; contacts switch the drive.
    pub volts_stay: bool,
    /// The analog output carries its speed-0 offset at S0 and after power-on too; otherwise it is 0 V then.
    pub offset_at_rest: bool,
    /// Spindle speed in rapids under constant surface speed.
    pub rapid: RapidSpeed,
    /// G96 sets the speed for the present tool position at once, not with the next cut.
    pub surface_at_once: bool,
    /// The upper limit of constant surface speed limits constant speeds too.
    pub surface_limit_stays: bool,
    /// G96 switches to feed per revolution.
    pub surface_per_revolution: bool,
    /// G94 and G95 end constant surface speed.
    pub feed_ends_surface: bool,
    /// When a feed code ends constant surface speed, the last S in r/min is in force again; otherwise the spindle keeps its speed.
    pub last_speed_back: bool,
    /// Range of the cutting speed S in m/min; `None`: the usual range of S.
    pub surface_range: Option<(f64, f64)>,
    /// Largest distance (mm) of work zero from the turning centre that counts as small under constant surface speed.
    pub small_offset: f64,
    /// Effect of G50 S on the coordinate system.
    pub limit_place: LimitPlace,
    /// The override applies after the limits, not before them.
    pub override_last: bool,
    /// The spindle override applies to threads.
    pub thread_override: bool,
    /// Emergency stop clears S, and with it the analog output.
    pub emergency_clears: bool,
    /// Speed tolerance for the start of a cut, as a fraction of the commanded speed, for instance 0.1; `None`: cuts do not wait.
    pub reached: Option<f64>,
    /// M05 in a block with motion acts at the end of the motion.
    pub stop_last: bool,
    /// The spindle keeps turning at reset.
    pub turns_through_reset: bool,
    /// M19 is the control's own positioning at 0°; otherwise the PLC positions.
    pub orients: bool,
    /// Spindle angles beyond a turn are taken modulo 360°; otherwise they are an alarm.
    pub angle_wraps: bool,
    /// M02 and M30 stop the spindle and set S0.
    pub end_stops: bool,
    /// A manual S acts while the program runs; otherwise it is refused.
    pub manual_in_automatic: bool,
    /// Positions of the override knob.
    pub knob: KnobRange,
    /// Codes of these positions, from the lowest up, where the PLC hands the override over as a code; empty for percent.
    pub override_codes: &'static [u8],
    /// Ranges in millivolts of the output offset parameters, at speed 0 and at full output; `None` if unknown.
    pub offsets: Option<[(f64, f64); 2]>,
    /// Range of the speed at full output of a gear stage, in r/min; `None` if unknown.
    pub stage_speeds: Option<(f64, f64)>,
    /// The minimum speed of the machine data applies to constant speeds too, not only under constant surface speed.
    pub low_always: bool,
    /// If the lower limit (G25) is above the upper one (G26), the lower one wins; otherwise the upper one.
    pub lower_wins: bool,
    /// The sign of the analog output (±10 V) may give the direction.
    pub signed_output: bool,
    /// M04 while the PLC puts out M03, and M03 while it puts out M04, are a PLC alarm: M05 has to come between.
    pub stop_between: bool,
    /// M code of the machine builder that locks the spindle at an angle; `None`: any of the builder's M codes may do so.
    pub lock: Option<u32>,
    /// M code of the machine builder that starts a driven tool; `None`: only a second spindle is a driven tool.
    pub driven_tool: Option<u32>,
    /// Source and grade.
    pub cite: Citation,
}

impl SpindleRules {
    /// Speed tolerance, as a fraction of the commanded speed: that of the control, or of the drive's own signal where cuts do not wait.
    pub fn tolerance(&self) -> f64 {
        self.reached.unwrap_or(REACHED)
    }

    /// Spindle override (%) that the control takes for a code from the PLC; none for a code without a position of the knob.
    pub fn override_of_code(&self, code: f64) -> Option<f64> {
        let at = self.override_codes.iter().position(|known| f64::from(*known) == code)?;
        Some(self.knob.low + self.knob.step * at as f64)
    }
}

/// Codes of 50 to 120 % on the 980MDi, those of a rotary switch, one bit from step to step.
pub(super) const SWITCH_CODES: &[u8] = &[7, 6, 2, 3, 1, 0, 4, 5];

/// Codes of 50 to 120 % on the 988TA, in tens of percent.
pub(super) const TENS_CODES: &[u8] = &[5, 6, 7, 8, 9, 10, 11, 12];

/// Override switch of SINUMERIK machine control panels.
pub(super) const PANEL: KnobRange = KnobRange { low: 50.0, high: 120.0, step: 5.0 };

/// Fraction of the speed within which it counts as reached, if the drive's own signal reports it to the control.
/// Source: `docs/reference/sinumerik-802d.md` section 3.2 (MD35150).
pub(super) const REACHED: f64 = 0.1;
