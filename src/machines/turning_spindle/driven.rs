//! The drives of the turning spindle for the sizing: its motor on the inverter, encoder and slides, and its speed as a gauge.

use super::derive::Derived;
use super::params::{FIELDS, Output, Params, Path};
use super::resolved::TurningSpindle;
use super::run_up;
use crate::drives::cutting;
use crate::drives::load::{Load, through_gear};
use crate::machines::driven::{GaugeRow, InverterDrive, SpindleEncoder};
use crate::machines::form::entry::at_most;
use crate::machines::lathe::knobs;
use crate::machines::lathe::slides::{HasSlides, ServoSlide, SlideAxes, SlideDuty, SlidePasses};
use crate::math::RPM;
use crate::msg;
use crate::text::Message;
use crate::view::{Advice, Limit};

/// The spindle's motor under cut and friction at the largest diameter of the cut, where their torque is greatest; none
/// if the cutting force is not known. The rest of its demand comes from the run.
pub(super) fn inverter(lathe: &TurningSpindle) -> Option<InverterDrive> {
    let (p, d) = (&lathe.params, &lathe.derived);
    if p.cutting_force <= 0.0 || d.stage.speed <= 0.0 {
        return None;
    }
    let gear = gear(lathe);
    Some(InverterDrive {
        id: "spindle",
        name: NAME,
        torque: through_gear(d.load.torque, gear, p.efficiency / 100.0),
        speed: d.speeds.largest_whole * gear,
        // The inverter is set to this speed at 10 V, independently of the program.
        top_speed: p.spindle.top,
        site_share: p.site_share / 100.0,
        brake: 0.0,
        cycle: None,
        radians_per_rpm: gear * RPM,
        load_at_motor: load_at_motor(lathe),
        rotor: p.spindle.rotor,
        // Stages of the headstock.
        gear: None,
        full: None,
        cooled_at: cooled_at(lathe),
        fields: None,
    })
}

/// Catalog id of the name of the drive.
pub(super) const NAME: &str = "turning.drive.spindle";

/// Speed of the motor over that of the spindle in the program's gear stage.
pub(super) fn gear(lathe: &TurningSpindle) -> f64 {
    lathe.params.spindle.gear(lathe.derived.stage.speed)
}

/// Speed (r/min) of the motor at the largest diameter of the cut, where it turns slowest.
pub(super) fn motor_speed(lathe: &TurningSpindle, d: &Derived) -> f64 {
    d.speeds.largest_whole * gear(lathe)
}

/// Lowest speed (r/min) at which the fan on the motor's shaft has to cool it in the cut: with the knob at its lowest position. None with
/// forced cooling.
fn cooled_at(lathe: &TurningSpindle) -> Option<f64> {
    let slow = lathe.at_lowest_knob();
    let slowest = slow.map_or(f64::INFINITY, |(_, slow)| motor_speed(lathe, slow));
    (!lathe.params.spindle.forced_cooling).then(|| slowest.min(motor_speed(lathe, &lathe.derived)))
}

/// Chuck and work at the motor, against the friction of the spindle.
pub(super) fn load_at_motor(lathe: &TurningSpindle) -> Load {
    let p = &lathe.params;
    p.spindle.load_at_motor(p.spindle_gear(lathe.derived.stage.speed), p.spindle_inertia + p.work_inertia())
}

/// The encoder of the spindle, for the greatest speed that the knob allows: it is on the spindle and measures its speed
/// in every gear stage.
pub(super) fn encoder(lathe: &TurningSpindle) -> SpindleEncoder {
    let of = &lathe.params.encoder;
    SpindleEncoder { name: NAME, speed: run_up::greatest_turned_speed(lathe) * of.ratio(), lines: of.lines }
}

/// Abilities of the inverter that the catalogue does not list: a speed input of both signs, and the feedback for a
/// position loop.
pub(super) fn inverter_abilities(lathe: &TurningSpindle) -> Vec<Message> {
    let both_signs = (lathe.params.output == Output::Bipolar).then(|| msg!("size.bill.bipolar-input"));
    let feedback = lathe.positions().then(|| msg!("size.bill.encoder-feedback"));
    both_signs.into_iter().chain(feedback).collect()
}

/// Starts of a slide in a pass: two, for the way to its place or the cut, and for the way back. Along a taper X starts
/// three times, for approach, cut and way back, and once more if it reverses for the shoulder of a falling cone.
fn starts_of_a_pass(p: &Params) -> f64 {
    if p.path != Path::Taper {
        return 2.0;
    }
    if p.finished_diameter > p.large_diameter { 4.0 } else { 3.0 }
}

/// Motions of a pass.
const MOTIONS: f64 = 4.0;

/// Starts per minute of the slides over all passes, with the knob at its highest position.
fn starts_per_minute(lathe: &TurningSpindle) -> f64 {
    let (p, d) = (&lathe.params, &lathe.derived);
    let fast = lathe.at_highest_knob().map_or(f64::INFINITY, |(_, fast)| fast.times.cutting);
    // The return over the whole cut, along its longer axis.
    let length = p.cuts(1.0).map(|cut| cut.length).sum::<f64>();
    let rapid = if p.path == Path::Facing { p.slides.x.rapid } else { p.slides.z.rapid };
    let back = 60.0 * if p.path == Path::Taper { p.length + p.clearance } else { length } / rapid;
    let dwell = lathe.dwell_of_passes().map_or(0.0, |per_speed| per_speed * p.upper_limit);
    let seconds = d.times.cutting.min(fast) + d.cut.passes * (back + dwell);
    let passes = d.cut.passes;
    let all = SlidePasses { starts: starts_of_a_pass(p) * passes, motions: MOTIONS * passes, seconds };
    all.starts_per_minute(p.slides.time_constant)
}

impl HasSlides for TurningSpindle {
    fn slides(&self) -> [ServoSlide; 2] {
        self.params.slides.servos(SlideDuty {
            axes: SlideAxes { x: self.cross(), z: self.along() },
            site_share: self.params.site_share,
            cutting_force: self.params.cutting_force,
            starts_per_minute: starts_per_minute(self),
            x_cuts_downhill: self.params.path == Path::Facing,
        })
    }

    fn slides_at_highest_feed(&self) -> Option<(f64, [ServoSlide; 2])> {
        self.at_highest_feed().map(|(percent, lathe)| (percent, lathe.slides()))
    }

    fn with_feeds_of_force(&self, share: f64, advice: Advice) -> Advice {
        let exponent = self.params.material.kienzle().map(|row| row.exponent);
        let set =
            exponent.map(|exponent| at_most(FIELDS, "feed", self.params.feed * cutting::feed_share(share, exponent)));
        knobs::setting_feeds(advice, set.into_iter().collect())
    }
}

/// Highest allowed speed of the spindle, r/min. It includes the operator's limit where the control does not hold that
/// limit itself: at a fixed speed, and with an override that acts after the limits.
fn highest_speed(lathe: &TurningSpindle) -> f64 {
    let p = &lathe.params;
    if lathe.surface() && !lathe.rules().override_last { p.chuck_limit } else { p.chuck_limit.min(p.upper_limit) }
}

/// Quantity checked during operation: the speed of the spindle.
pub(super) const GAUGES: &[GaugeRow<TurningSpindle>] = &[GaugeRow {
    id: "speed",
    label: "turning.gauge.speed",
    unit: "r/min",
    decimals: 1,
    limit: |lathe| Some(Limit::AtMost(highest_speed(lathe))),
    field: None,
    value: |_, now| now.spindle.actual.abs(),
}];
