//! Demand of the whole part on the drives of work and tool, and their limits: the worst of all polygons and feeds.

use super::load::{FEEDS, Spindle};
use super::params::Slot;
use super::resolved::PolygonLathe;
use crate::drives::cutting::kienzle;
use crate::drives::spindle_motor::{power, run_up};

/// Quantity of a spindle's demand.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Asked {
    /// Greatest torque of the cut, Nm.
    Peak,
    /// Mean torque of the cut, Nm.
    Mean,
    /// Effective torque of the cut, Nm: strikes heat a motor more than their mean.
    Effective,
    /// Mean power of the cut, kW.
    Power,
    /// Torque of the run-up, Nm.
    RunUp,
}

impl PolygonLathe {
    /// Demand on a spindle at a feed with this polygon, and its limit.
    fn asked(&self, spindle: Spindle, asked: Asked, feed: usize) -> (f64, f64) {
        let torque = self.d.load.cuts[feed].torque[spindle as usize];
        let drive = self.p.drive(spindle);
        let (continuous, most) = self.p.torques(spindle);
        match asked {
            Asked::Peak => (torque.peak, most),
            Asked::Mean => (torque.mean, continuous),
            // Strikes of one torque during the share c of the time: T √c, with c the mean over the peak. Source: sizing facts, section 7.
            Asked::Effective => ((torque.peak * torque.mean).sqrt(), continuous),
            Asked::Power => (power(torque.mean, drive.speed), drive.motor.power * self.p.site_share / 100.0),
            Asked::RunUp => (run_up(drive.inertia, drive.speed, drive.ramp, drive.gain), most),
        }
    }

    /// Demand on a spindle and its limit, where their ratio is greatest: over all polygons and feeds.
    pub(super) fn demand(&self, spindle: Spindle, asked: Asked) -> (f64, f64) {
        let all = self.polygons().flat_map(|lathe| (0..FEEDS.len()).map(move |feed| lathe.asked(spindle, asked, feed)));
        all.fold((0.0, f64::INFINITY), |worst, next| {
            if next.0 * worst.1 > worst.0 * next.1 || worst.1.is_infinite() { next } else { worst }
        })
    }

    /// How many times its limit the cuts of a feed ask of a spindle, of all polygons the most.
    pub(super) fn excess(&self, spindle: Spindle, asked: Asked, feed: usize) -> f64 {
        self.polygons()
            .map(|lathe| lathe.asked(spindle, asked, feed))
            .map(|(asked, limit)| asked / limit)
            .fold(0.0, f64::max)
    }

    /// Greatest cutting force of an insert, N.
    pub(super) fn force(&self) -> f64 {
        self.polygons().flat_map(|lathe| lathe.d.load.cuts).map(|cut| cut.force).fold(0.0, f64::max)
    }

    /// Cutting force (N) of a slot: the chip is as wide as the cut is deep, and as thick as the feed.
    pub(super) fn slot_force(&self, slot: &Slot) -> f64 {
        let row = self.p.specific();
        kienzle(row.unit_force, row.exponent, (slot.depth, slot.feed), (90.0, self.p.rake))
    }

    /// Greatest cutting force of a slot, N; 0 without slots.
    pub(super) fn slots_force(&self) -> f64 {
        self.p.slots.iter().filter(|slot| slot.on).map(|slot| self.slot_force(slot)).fold(0.0, f64::max)
    }

    /// The shortest ramp (s) in which both drives run up to every speed of the program.
    pub(super) fn ramp(&self) -> f64 {
        let both =
            self.polygons().flat_map(|lathe| [Spindle::Work, Spindle::Tool].map(|spindle| lathe.p.ramp(spindle)));
        both.fold(0.0, f64::max)
    }
}
