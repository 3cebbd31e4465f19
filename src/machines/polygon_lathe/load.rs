//! Torque of work and tool: the interrupted cut, the run-up, and the ratings of the drives.

use super::axes::PolygonAxis;
use super::params::Params;
use crate::drives::cutting::{Chip, CuttingEdge, Kienzle};
use crate::drives::polygon::{cut, load};
use crate::drives::spindle_motor::{GearedMotor, MotorCurve, shortest_ramp};

/// A feed of the cutter, with which its cuts are made.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum PolygonFeed {
    /// Along the flats, in all passes but the last.
    Roughing,
    /// Along the flats, in the last pass.
    Finishing,
    /// Down to the flats behind the face.
    Infeed,
}

impl PolygonFeed {
    /// All of them, in the order of the form.
    pub(super) const ALL: [PolygonFeed; 3] = [PolygonFeed::Roughing, PolygonFeed::Finishing, PolygonFeed::Infeed];

    /// Its field.
    pub(super) fn field(self) -> &'static str {
        match self {
            PolygonFeed::Roughing => "feed",
            PolygonFeed::Finishing => "finish-feed",
            PolygonFeed::Infeed => "infeed",
        }
    }

    /// Its entry in a form.
    pub(super) fn entry(self, p: &Params) -> f64 {
        match self {
            PolygonFeed::Roughing => p.feed,
            PolygonFeed::Finishing => p.finish_feed,
            PolygonFeed::Infeed => p.infeed,
        }
    }
}

/// Greatest forces (N) that the cuts may have.
#[derive(Debug, Clone, Copy)]
pub(super) struct ForceLimits {
    /// Of the flats by feed, in the order of [`PolygonFeed::ALL`].
    pub flats: [f64; 3],
    /// Of the turned ends.
    pub ends: f64,
}

impl ForceLimits {
    /// Limits of the flats alone.
    pub(super) fn of_flats(flats: [f64; 3]) -> ForceLimits {
        ForceLimits { flats, ends: f64::INFINITY }
    }

    /// One limit of all cuts.
    pub(super) fn of_all(most: f64) -> ForceLimits {
        ForceLimits { flats: [most; 3], ends: most }
    }
}

/// Torque about an axis, Nm.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Torque {
    pub peak: f64,
    pub mean: f64,
}

/// The cuts at one feed: greatest force of an insert (N), its force for a layer of 1 mm (N/mm; 0 in the infeed), torque of work and tool.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct CutLoad {
    pub force: f64,
    pub per_depth: f64,
    /// Of work and tool.
    pub torque: [Torque; 2],
}

/// All cuts of a polygon.
#[derive(Debug, Clone, Default)]
pub(super) struct PolygonLoad {
    /// By feed, in the order of [`PolygonFeed::ALL`].
    pub cuts: [CutLoad; 3],
    /// Inserts in the cut at once.
    pub at_once: f64,
    /// Greatest depth of the layer of each pass, mm.
    pub layers: Vec<f64>,
    /// Angular momentum that the cuts of all passes take of work and tool, Nm s: the mean torque of each times its time.
    pub impulse: [f64; 2],
}

/// Motor of the work axis or of the tool axis, reduced to the axis through its gear.
pub(super) struct AxisMotor {
    /// Speed of the axis, r/min, signed.
    pub speed: f64,
    pub motor: MotorCurve,
    /// Moment of inertia at the axis, kg m².
    pub inertia: f64,
    /// Time constant of the ramp, s.
    pub ramp: f64,
    /// Position gain, 1/s.
    pub gain: f64,
    /// Friction (Nm) at the axis, besides the cut.
    pub friction: f64,
}

impl PolygonLoad {
    /// The cuts at a feed.
    pub(super) fn at(&self, feed: PolygonFeed) -> &CutLoad {
        &self.cuts[feed as usize]
    }

    /// Force (N) of all inserts in the cut at once at a feed, as if they pushed in one direction.
    pub(super) fn force_together(&self, feed: PolygonFeed) -> f64 {
        self.at(feed).force * self.at_once.max(1.0)
    }

    /// Raises the cuts at a feed to `cut`.
    fn raise(&mut self, feed: PolygonFeed, cut: CutLoad) {
        self.cuts[feed as usize] = self.at(feed).worst(cut);
    }
}

impl CutLoad {
    /// The greater of both in each figure.
    fn worst(self, other: CutLoad) -> CutLoad {
        let both = |a: Torque, b: Torque| Torque { peak: a.peak.max(b.peak), mean: a.mean.max(b.mean) };
        let torque = [both(self.torque[0], other.torque[0]), both(self.torque[1], other.torque[1])];
        CutLoad { force: self.force.max(other.force), per_depth: self.per_depth.max(other.per_depth), torque }
    }
}

impl Params {
    /// Specific cutting force with the wear of the edge: that of the material, or the entered one, which does not
    /// depend on the chip thickness.
    pub(super) fn specific(&self) -> Kienzle {
        let entered = Kienzle { unit_force: self.specific_force, exponent: 0.0 };
        let sharp = self.material.kienzle().unwrap_or(entered);
        Kienzle { unit_force: sharp.unit_force * self.edge_wear, ..sharp }
    }

    /// Loads of passes of these `sizes` across flats. The chip has the depth of the layer as its width and the distance
    /// of the feed marks as its thickness. In the infeed its width is that of the insert, and the levers of its force
    /// are the tip radius and the stock radius.
    pub(super) fn cutting_torques(&self, sizes: &[f64]) -> PolygonLoad {
        let Some(ratio) = self.ratio() else { return PolygonLoad::default() };
        let inserts = self.inserts as u32;
        let material = self.specific();
        let force = |depth: f64, feed: f64, angle: f64| {
            let chip = Chip { depth, feed: cut::mark_pitch(ratio, inserts, feed) };
            material.force(chip, CuttingEdge { angle, rake: self.rake })
        };
        let down = if self.is_behind_face() { force(self.insert_width, self.infeed, 90.0) } else { 0.0 };
        let mut all = PolygonLoad::default();
        for (at, pass) in self.pass_loads(sizes, ratio).iter().enumerate() {
            let last = at + 1 == sizes.len();
            let along = force(1.0, if last { self.finish_feed } else { self.feed }, self.edge_angle);
            let torque = |moment: load::Moment| Torque {
                peak: along * moment.peak / 1000.0,
                mean: along * moment.mean / 1000.0,
            };
            let lever = |lever: f64| Torque {
                peak: f64::from(pass.at_once) * down * lever / 1000.0,
                mean: pass.engaged * down * lever / 1000.0,
            };
            let torques = [torque(pass.work), torque(pass.tool)];
            let cut = CutLoad { force: along * pass.depth, per_depth: along, torque: torques };
            let plunge =
                CutLoad { force: down, per_depth: 0.0, torque: [lever(0.5 * self.blank()), lever(self.tip_radius)] };
            all.raise(if last { PolygonFeed::Finishing } else { PolygonFeed::Roughing }, cut);
            all.raise(PolygonFeed::Infeed, plunge);
            let seconds = self.times_in_cut(at as f64 + 1.0);
            for (impulse, (cut, plunge)) in all.impulse.iter_mut().zip(cut.torque.iter().zip(plunge.torque)) {
                *impulse += cut.mean * seconds[0] + plunge.mean * seconds[1];
            }
            all.layers.push(pass.depth);
            all.at_once = all.at_once.max(f64::from(pass.at_once));
        }
        all
    }

    /// Times (s) in which a pass (from 1) cuts along the flats, and down to them.
    fn times_in_cut(&self, pass: f64) -> [f64; 2] {
        let along = 60.0 * self.length / self.per_minute(self.feed_of(pass));
        let before = if pass > 1.0 { self.size(pass - 1.0) } else { self.blank() };
        let down = 60.0 * 0.5 * (before - self.size(pass)) / self.per_minute(self.infeed);
        [along, if self.is_behind_face() { down } else { 0.0 }]
    }

    /// The form with all feeds multiplied by `share`. If the work turns faster by the same factor, its speed is
    /// multiplied instead of the feeds of the flats, which are per turn of the work.
    pub(super) fn with_feeds(mut self, share: f64, work_turns_faster: bool) -> Params {
        if work_turns_faster {
            self.speed *= share;
        } else {
            self.feed *= share;
            self.finish_feed *= share;
            self.infeed *= share;
        }
        self.turned_ends.iter_mut().for_each(|end| end.feed *= share);
        self
    }

    /// Moment of inertia (kg m²) of the main motor's rotor at the spindle.
    fn main_rotor_at_spindle(&self) -> f64 {
        self.main.rotor_at_spindle(self.main_speed)
    }

    /// Moment of inertia (kg m²) that the work axis turns: the main motor, where there is one, stays on the spindle.
    pub(super) fn spindle_inertia(&self) -> f64 {
        self.axes.work.inertia + if self.turns_ends() { self.main_rotor_at_spindle() } else { 0.0 }
    }

    /// The motor of an axis, through the gear.
    pub(super) fn drive(&self, axis: PolygonAxis) -> AxisMotor {
        let form = &self.axes[axis];
        let (speed, inertia, friction) = match axis {
            PolygonAxis::Work => {
                let friction = if self.turns_ends() { self.main.friction } else { 0.0 };
                (self.work_speed(), self.spindle_inertia(), friction)
            }
            PolygonAxis::Tool => (self.tool_speed(), form.inertia, 0.0),
        };
        let motor = MotorCurve::through_gear(GearedMotor {
            power: form.power,
            base: form.base,
            top: form.top,
            spindle_top: form.reach(),
            efficiency: self.drive_efficiency / 100.0,
        });
        AxisMotor { speed, motor, inertia, ramp: form.time_constant / 1000.0, gain: form.gain, friction }
    }

    /// The motor of an axis at its greatest speed, that of the cut or of the way to its start angle: from the second part on every G512 turns
    /// there from where the part before has ended.
    pub(super) fn fastest_drive(&self, axis: PolygonAxis) -> AxisMotor {
        let drive = self.drive(axis);
        AxisMotor { speed: drive.speed.abs().max(self.index_speed), ..drive }
    }

    /// Torques (Nm) of a drive at its speed less friction: continuous at its site, and short-time.
    pub(super) fn torques_of(&self, drive: &AxisMotor) -> (f64, f64) {
        let rated = drive.motor.torque(drive.speed);
        let left = |percent: f64| (rated * percent / 100.0 - drive.friction).max(0.0);
        (left(self.site_share), left(self.drive_peak))
    }

    /// Shortest ramp (s) of an axis that the torque of its drive allows.
    pub(super) fn ramp(&self, axis: PolygonAxis) -> f64 {
        let drive = self.fastest_drive(axis);
        shortest_ramp(drive.inertia, drive.speed, self.torques_of(&drive).1)
    }
}
