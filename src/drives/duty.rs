//! Duty types of electric machines, and the pause between two runs, as far as it counts for the heating of a motor.

/// Duty type of an electric machine by IEC 60034-1, for a drive that turns under load or is at rest.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DutyType {
    /// S1: continuous duty.
    Continuous,
    /// S3: periodic duty with standstill; cyclic duration factor, %: 15, 25, 40 or 60.
    Intermittent(u8),
    /// S6: periodic duty without standstill, alternately loaded and idle; cyclic duration factor, %: 15, 25, 40 or 60.
    Periodic(u8),
}

/// Share of turning time from which a drive counts as turning without standstill. Chosen here, without a source.
const WITHOUT_STANDSTILL: f64 = 0.98;

/// Longest cycle of S3 and S6, seconds.
const LONGEST_CYCLE: f64 = 600.0;

/// Part of a pause (s) after a run that counts for the heating of a motor: a cycle has at most 10 min, because in a longer run the motor
/// reaches its final temperature whatever the pause. Source: sizing facts 2.8.
pub fn counted_pause(run: f64, pause: f64) -> f64 {
    pause.min((LONGEST_CYCLE - run).max(0.0))
}

/// Effective torque in Nm of a run and the following pause: `√((T² t + T_hold² t_pause) / (t + t_pause))`, from the effective torque and
/// the duration (s) of the run and the holding torque at standstill. For a pause of 10 min or more, a duty of its own, the result is at
/// least the holding torque.
/// Source: sizing facts 2.2 (7-9) and 2.8.
pub fn with_pause(effective: f64, run: f64, pause: f64, hold: f64) -> f64 {
    let counted = counted_pause(run, pause);
    let over_both = if counted > 0.0 {
        ((effective * effective * run + hold * hold * counted) / (run + counted)).sqrt()
    } else {
        effective
    };
    if pause >= LONGEST_CYCLE { over_both.max(hold.abs()) } else { over_both }
}

/// Duty type of a drive that turns for the share `turning` of a cycle and is loaded for the share `loaded`, both 0 to 1: the smallest
/// cyclic duration factor of the standard that covers it. Source: sizing facts 2.8, from memory.
pub fn duty_type(turning: f64, loaded: f64, cycle: f64) -> DutyType {
    if cycle > LONGEST_CYCLE {
        return DutyType::Continuous;
    }
    let covering = |share: f64| [15, 25, 40, 60].into_iter().find(|factor| share <= f64::from(*factor) / 100.0);
    match (covering(turning), covering(loaded)) {
        (Some(factor), _) => DutyType::Intermittent(factor),
        (None, Some(factor)) if turning >= WITHOUT_STANDSTILL => DutyType::Periodic(factor),
        _ => DutyType::Continuous,
    }
}
