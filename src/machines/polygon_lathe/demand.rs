//! Demand of the whole part on the drives of work and tool, and their limits: the worst case over all polygons and feeds.

use super::axes::PolygonAxis;
use super::load::PolygonFeed;
use super::resolved::PolygonLathe;
use super::turned_end_form::TurnedEnd;
use crate::drives::cutting::{Chip, CuttingEdge};
use crate::drives::spindle_motor::{power, run_up_torque};

/// Kind of demand on the motor of work or tool.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum DemandKind {
    /// Greatest torque of the cut, Nm.
    Peak,
    /// Mean torque of the cut, Nm.
    Mean,
    /// Effective torque of the cut, Nm: an interrupted cut heats a motor more than its mean torque.
    Effective,
    /// Mean power of the cut, kW.
    Power,
    /// Torque of the run-up, Nm.
    RunUp,
}

impl PolygonLathe {
    /// Demand on an axis and its limit with this polygon at a feed.
    fn demand_at(&self, axis: PolygonAxis, kind: DemandKind, feed: PolygonFeed) -> (f64, f64) {
        let torque = self.derived.load.at(feed).torque[axis as usize];
        let drive = self.params.drive(axis);
        let (continuous, most) = self.params.torques_of(&drive);
        match kind {
            DemandKind::Peak => (torque.peak, most),
            DemandKind::Mean => (torque.mean, continuous),
            // Strikes of one torque during the share c of the time: T √c, with c the mean over the peak. Source: sizing facts, section 7.
            DemandKind::Effective => ((torque.peak * torque.mean).sqrt(), continuous),
            DemandKind::Power => (power(torque.mean, drive.speed), drive.motor.power * self.params.site_share / 100.0),
            DemandKind::RunUp => {
                let drive = self.params.fastest_drive(axis);
                (run_up_torque(drive.inertia, drive.speed, drive.ramp, drive.gain), self.params.torques_of(&drive).1)
            }
        }
    }

    /// Demand on an axis and its limit, where their ratio is greatest: over all polygons and feeds.
    pub(super) fn demand(&self, axis: PolygonAxis, kind: DemandKind) -> (f64, f64) {
        let of = |lathe: &PolygonLathe, feed| lathe.demand_at(axis, kind, feed);
        let all = self.polygons().flat_map(|lathe| PolygonFeed::ALL.map(|feed| of(lathe, feed)));
        // Friction may leave a limit of 0: any demand then has an infinite share.
        let share = |(demand, limit): (f64, f64)| if demand > 0.0 { demand / limit } else { 0.0 };
        let first = (0.0, f64::INFINITY);
        all.fold(first, |worst, next| if worst == first || share(next) > share(worst) { next } else { worst })
    }

    /// Mean torque (Nm) of the cuts of all polygons about an axis, over the time in which the slide moves at feed: the energy of a part counts
    /// each pass with its own torque, while [`DemandKind::Mean`] is that of the heaviest.
    pub(super) fn mean_torque(&self, axis: PolygonAxis) -> f64 {
        let all = self.polygons().map(|lathe| (lathe.derived.load.impulse[axis as usize], lathe.derived.times.cutting));
        let (impulse, seconds) = all.fold((0.0, 0.0), |sum, next| (sum.0 + next.0, sum.1 + next.1));
        if seconds > 0.0 { impulse / seconds } else { 0.0 }
    }

    /// Greatest ratio, over all polygons, of demand to limit of an axis at a feed.
    pub(super) fn excess(&self, axis: PolygonAxis, kind: DemandKind, feed: PolygonFeed) -> f64 {
        self.polygons()
            .map(|lathe| lathe.demand_at(axis, kind, feed))
            .map(|(demand, limit)| demand / limit)
            .fold(0.0, f64::max)
    }

    /// Greatest cutting force of an insert, N.
    pub(super) fn force(&self) -> f64 {
        self.polygons().flat_map(|lathe| lathe.derived.load.cuts).map(|cut| cut.force).fold(0.0, f64::max)
    }

    /// Greatest force (N) of any cut on the work, of all inserts at once and of turned ends.
    pub(super) fn greatest_force(&self) -> f64 {
        let flats = PolygonFeed::ALL.map(|feed| self.force_at(feed));
        flats.into_iter().fold(self.greatest_end_force(), f64::max)
    }

    /// Greatest force (N) of the cuts at a feed, of all inserts at once.
    pub(super) fn force_at(&self, feed: PolygonFeed) -> f64 {
        self.polygons().map(|lathe| lathe.derived.load.force_together(feed)).fold(0.0, f64::max)
    }

    /// Cutting force (N) of turning an end: the chip is as wide as the cut is deep, and as thick as the feed.
    pub(super) fn end_force(&self, end: &TurnedEnd) -> f64 {
        let chip = Chip { depth: end.depth, feed: end.feed };
        self.params.specific().force(chip, CuttingEdge { angle: 90.0, rake: self.params.rake })
    }

    /// Greatest cutting force of turning an end, N; 0 without turned ends.
    pub(super) fn greatest_end_force(&self) -> f64 {
        self.params.turned_ends.iter().filter(|end| end.on).map(|end| self.end_force(end)).fold(0.0, f64::max)
    }

    /// Shortest ramp (s) with which both drives can run up to every speed of the program.
    pub(super) fn ramp(&self) -> f64 {
        let both = self
            .polygons()
            .flat_map(|lathe| [PolygonAxis::Work, PolygonAxis::Tool].map(|axis| lathe.params.ramp(axis)));
        both.fold(0.0, f64::max)
    }
}
