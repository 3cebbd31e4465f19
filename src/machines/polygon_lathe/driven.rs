//! The drives of the polygon lathe for the sizing: motors of work, tool and slides, and the phase between work and tool as a gauge.

use super::axes::PolygonAxis;
use super::demand::DemandKind;
use super::load::ForceLimits;
use super::params::Params;
use super::path::{self, PassStep, time};
use super::resolved::{PolygonLathe, TOOL, WORK};
use crate::drives::load::{Load, through_gear};
use crate::drives::servo::{Acceptance, FittedMotor, Servo};
use crate::drives::shaft_motion::Strikes;
use crate::machines::driven::{CoastedAxes, DrivenAxis, GaugeRow};
use crate::machines::lathe::knobs;
use crate::machines::lathe::slides::{self, HasSlides, ServoSlide, SlideAxes, SlideDuty, SlidePasses};
use crate::math::PI;
use crate::motion::Mover;
use crate::view::Advice;

/// Limits without a reserve: the form has none beyond its peak torque.
const NO_RESERVE: Acceptance = Acceptance { inertia_ratio: f64::INFINITY, peak: 1.0, effective: 1.0 };

/// The motors of work and tool, under the mean torque of all cuts and the greatest strike while the slide is in the stock, and those of the
/// slides.
pub(super) fn axes(lathe: &PolygonLathe) -> Vec<DrivenAxis> {
    let driven = |id, name, at, axis: PolygonAxis| {
        let p = &lathe.params;
        // Motor speed over that of the axis.
        let (gear, efficiency) = (p.axes[axis].turns_per_motor_turn().recip(), p.drive_efficiency / 100.0);
        let drive = p.drive(axis);
        let rated = drive.motor.torque(0.0) / (gear * efficiency);
        let at_motor = |torque| through_gear(torque, gear, efficiency);
        let (mean, peak) = (at_motor(lathe.mean_torque(axis)), at_motor(lathe.demand(axis, DemandKind::Peak).0));
        let friction = through_gear(drive.friction, gear, efficiency);
        let strikes = Strikes::new(peak, mean);
        // The form has torque and inertia at the output of the gear, rotor included; its torque already includes the losses of the gear.
        let motor = Servo {
            rated,
            stall: rated,
            peak: rated * p.drive_peak / 100.0,
            rated_speed: p.axes[axis].base,
            top_speed: p.axes[axis].top,
            rotor: 0.0,
        };
        DrivenAxis {
            id,
            name,
            mover: Mover::Turned(at),
            radians_per_unit: gear * PI / 180.0,
            load: Load { inertia: drive.inertia / (gear * gear), torque: friction, efficiency },
            standstill_torque: 0.0,
            weight: 0.0,
            strikes: Strikes { peak: strikes.peak + friction, ..strikes },
            taut_torque: 0.0,
            cut: Some(mean),
            continuous_cut_torque: None,
            starts_per_minute: 0.0,
            // Wheels of the lathe itself.
            gear: None,
            fitted: FittedMotor { motor, limits: NO_RESERVE.derated(p.site_share / 100.0) },
            site_share: p.site_share / 100.0,
            fields: None,
        }
    };
    let in_ratio = [
        driven("work", "polygon.drive.work", WORK, PolygonAxis::Work),
        driven("tool", "polygon.drive.tool", TOOL, PolygonAxis::Tool),
    ];
    in_ratio.into_iter().chain(slides::axes(lathe)).collect()
}

/// Starts per minute of the slide with more starts, over the passes of all polygons and turned ends.
fn starts_per_minute(lathe: &PolygonLathe) -> f64 {
    let (p, rapids) = (&lathe.params, [lathe.params.slides.x.rapid, lathe.params.slides.z.rapid]);
    let of = |p: &Params, steps: Vec<PassStep>, rpm: f64| {
        let begin = (p.clear_diameter(), p.clearance);
        let motions = steps.len() as f64;
        (path::starts(begin, &steps), time(begin, steps.into_iter(), rpm, rapids), motions)
    };
    let polygons = lathe.polygons().filter(|lathe| lathe.derived.cuts);
    let polygons = polygons.map(|lathe| of(&lathe.params, lathe.params.all_steps().collect(), 0.0));
    let ends = p.turned_ends.iter().filter(|end| end.on);
    let ends = ends.flat_map(|end| [end.steps(p), end.thread(p)].map(|steps| of(p, steps, end.speed)));
    let (starts, seconds, motions) =
        polygons.chain(ends).fold((0.0, 0.0, 0.0), |all, next| (all.0 + next.0, all.1 + next.1, all.2 + next.2));
    SlidePasses { starts, motions, seconds }.starts_per_minute(p.slides.time_constant)
}

impl HasSlides for PolygonLathe {
    fn slides(&self) -> [ServoSlide; 2] {
        self.params.slides.servos(SlideDuty {
            axes: SlideAxes { x: self.cross(), z: self.along() },
            site_share: self.params.site_share,
            cutting_force: self.greatest_force(),
            starts_per_minute: starts_per_minute(self),
            x_cuts_downhill: false,
        })
    }

    fn slides_at_highest_feed(&self) -> Option<(f64, [ServoSlide; 2])> {
        self.at_highest_feed().map(|(percent, lathe)| (percent, lathe.slides()))
    }

    fn with_feeds_of_force(&self, share: f64, advice: Advice) -> Advice {
        let fed = self.with_most_feed();
        let most = share * fed.greatest_force();
        knobs::setting_feeds(advice, self.feeds_below(fed, ForceLimits::of_all(most)))
    }
}

/// Gauge: phase of the tool ahead of its ratio to the work, only while a polygon is cut. At other times the axes are at
/// rest, run up, or turn to other start angles.
pub(super) const GAUGES: &[GaugeRow<PolygonLathe>] = &[GaugeRow {
    id: "phase",
    label: "polygon.gauge.phase",
    unit: "°",
    decimals: 3,
    limit: |_| None,
    field: None,
    value: |lathe, now| if lathe.cuts_flats(now) { lathe.phase(now).abs() } else { 0.0 },
}];

/// Work and tool after a power failure at the speeds of the first polygon: the phase between them at rest, and the time
/// until then.
pub(super) fn without_supply(lathe: &PolygonLathe) -> Option<CoastedAxes> {
    let gauge = GAUGES.first()?.gauge(lathe, lathe.derived.angles.coast_phase.abs());
    let speeds = [lathe.params.work_speed(), lathe.params.tool_speed()];
    let seconds = speeds.into_iter().zip(lathe.params.coasting_deceleration());
    let seconds = seconds.map(|(speed, deceleration)| speed.abs() / deceleration);
    lathe.derived.cuts.then(|| CoastedAxes { seconds: seconds.fold(0.0, f64::max), gauge })
}
