//! The section that the inserts cut: sides, corners and their deviations.

use super::cut::PolygonCut;
use crate::drives::polygon::{CutterSetup, Section};
use crate::machines::polygon_lathe::params::Params;

/// Figures of the section, mm unless noted otherwise.
#[derive(Debug, Clone, PartialEq, Default)]
pub(in crate::machines::polygon_lathe) struct SectionFigures {
    pub sides: f64,
    /// Greatest and least distance across flats, as measured by a micrometer.
    pub across_flats: f64,
    pub least_across_flats: f64,
    /// Least and greatest deviation of any side from its plane.
    pub deviation: (f64, f64),
    pub flatness: f64,
    /// Greatest deviation of the sides if all inserts are in their places; above 0 the sides are hollow.
    pub hollow: f64,
    /// Curvature of the sides, 1/mm; positive for crowned sides.
    pub curvature: f64,
    /// Greatest distance of a corner from the centre.
    pub corner: f64,
    pub across_corners: f64,
    /// Whether the sides meet in the stock.
    pub meets: bool,
    /// Area, mm².
    pub area: f64,
    /// Whether all inserts are in their places.
    pub even: bool,
}

impl SectionFigures {
    pub(super) fn new(p: &Params, cut: &PolygonCut) -> SectionFigures {
        let PolygonCut { setup, section, curve, .. } = cut;
        let sides = section.sides();
        let (low, high) = sides
            .iter()
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), side| (low.min(side.low), high.max(side.high)));
        let corners = section.corners();
        let even = setup.is_even();
        let in_place = (!even).then(|| CutterSetup::even(p.across_flats, p.tip_radius, setup.ratio, setup.inserts()));
        let in_place = in_place.and_then(|setup| Section::new(&setup, 0.5 * p.blank())?.side(0));
        SectionFigures {
            sides: f64::from(setup.sides()),
            across_flats: section.across_flats().1,
            least_across_flats: section.across_flats().0,
            deviation: (low, high),
            flatness: sides.iter().map(|side| side.flatness()).fold(0.0, f64::max),
            hollow: in_place.map_or(high, |side| side.high),
            curvature: curve.curvature(),
            corner: corners.iter().map(|corner| corner.radius).fold(0.0, f64::max),
            across_corners: section.across_corners().1,
            meets: corners.iter().all(|corner| corner.meets),
            area: section.area(),
            even,
        }
    }
}
