//! Times of the cut, and the rating of a motor for their duration.

use super::command::CommandedSpeed;
use super::cut::CutGeometry;
use super::speeds::CutSpeeds;
use super::stage::EngagedStage;
use crate::machines::turning_spindle::params::Params;

/// Longest time (s) for which a motor may give its overload without a pause, and the greatest share of the whole time.
/// Source: duty S6-40 % of IEC 60034-1, 4 minutes in 10.
const OVERLOAD_TIME: f64 = 240.0;
const OVERLOAD_SHARE: f64 = 0.4;

/// Times of all passes, s.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::machines::turning_spindle) struct CutTimes {
    /// At constant surface speed.
    pub surface: f64,
    /// At one speed for the whole cut.
    pub fixed: f64,
    /// As the program cuts.
    pub cutting: f64,
    /// Share (%) of the time at one speed that constant surface speed saves.
    pub saved: f64,
}

impl CutTimes {
    pub(super) fn new(
        p: &Params,
        cut: &CutGeometry,
        stage: &EngagedStage,
        command: &CommandedSpeed,
        speeds: &CutSpeeds,
    ) -> CutTimes {
        let all = || (1..=cut.passes as u32).flat_map(|pass| p.cuts(f64::from(pass)));
        let lowest = p.lower_limit.min(command.highest(stage.surface_top)) * command.after;
        let within = (lowest, speeds.high);
        let surface = all().map(|cut| cut.surface_time(speeds.held.surface(), within)).sum::<f64>();
        let fixed = all().map(|cut| cut.time_at(speeds.fixed)).sum::<f64>();
        // 100 % if the fixed speed is 0: the cut would never end.
        let comparable = fixed > 0.0 && surface.is_finite();
        CutTimes {
            surface,
            fixed,
            cutting: if p.turns_at_fixed_speed() { fixed } else { surface },
            saved: if comparable { 100.0 * (1.0 - surface / fixed) } else { 0.0 },
        }
    }

    /// Rating over the cutting time: `rated · overload` up to 240 s where the cuts are two fifths of the time with the pause, else `rated`.
    pub(in crate::machines::turning_spindle) fn for_the_cut(&self, p: &Params, rated: f64) -> f64 {
        let is_rare = self.cutting <= OVERLOAD_TIME && p.pause >= self.pause_for_overload();
        if is_rare { rated * p.motor_overload / 100.0 } else { rated }
    }

    /// Least pause (s) to the next part with which the cuts take two fifths of the time (S6-40 %), without counting the
    /// other times of the part.
    pub(in crate::machines::turning_spindle) fn pause_for_overload(&self) -> f64 {
        self.cutting * (1.0 / OVERLOAD_SHARE - 1.0)
    }
}
