//! The formulas of the polygon lathe, each once: results that need no run, by subject.
//!
//! Lengths in mm, angles in degrees, speeds of axes in r/min, times in s unless noted otherwise.

mod angles;
mod cut;
mod feeds;
mod inserts;
mod place;
mod section;
mod speeds;
mod times;
mod twist;

use super::load::PolygonLoad;
use super::params::Params;
use angles::WorkAngles;
use cut::PolygonCut;
use feeds::PolygonFeeds;
use inserts::InsertDemands;
use place::CutterPlace;
use section::SectionFigures;
use speeds::PolygonSpeeds;
use times::PolygonTimes;
use twist::Twist;

/// The results; those of section, inserts, angles, twist and load are 0 where the inserts cut no section.
#[derive(Debug, Clone)]
pub(super) struct Derived {
    /// Whether the inserts cut a section out of the stock.
    pub cuts: bool,
    pub speeds: PolygonSpeeds,
    pub place: CutterPlace,
    pub feeds: PolygonFeeds,
    pub times: PolygonTimes,
    pub section: SectionFigures,
    pub inserts: InsertDemands,
    pub angles: WorkAngles,
    pub twist: Twist,
    /// Force and torque of the cuts.
    pub load: PolygonLoad,
}

impl Derived {
    /// Computes the results for passes of these `sizes` across flats (mm); `x_per_mm`: units of X words per mm of the
    /// slide.
    pub(super) fn new(p: &Params, sizes: &[f64], x_per_mm: f64) -> Derived {
        let speeds = PolygonSpeeds::new(p);
        let feeds = PolygonFeeds::new(p);
        let cut = PolygonCut::new(p, sizes);
        let cut = cut.as_ref();
        Derived {
            cuts: cut.is_some(),
            place: CutterPlace::new(p, x_per_mm),
            times: PolygonTimes::new(p, sizes),
            section: cut.map_or_else(SectionFigures::default, |cut| SectionFigures::new(p, cut)),
            inserts: cut.map_or_else(InsertDemands::default, |cut| InsertDemands::new(p, cut, &speeds)),
            angles: cut.map_or_else(WorkAngles::default, |cut| WorkAngles::new(p, cut, &speeds)),
            twist: cut.map_or_else(Twist::default, |cut| Twist::new(p, cut, &speeds, &feeds)),
            load: cut.map_or_else(PolygonLoad::default, |_| p.cutting_torques(sizes)),
            speeds,
            feeds,
        }
    }
}
