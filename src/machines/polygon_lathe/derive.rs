//! The formulas of the polygon lathe, each once: results that need no run.

use super::load::PolygonLoad;
use super::params::Params;
use crate::drives::polygon::choose::{self, Choice};
use crate::drives::polygon::cut::{self, InsertLoad};
use crate::drives::polygon::{CutterSetup, Ratio, Section};
use crate::math::PI;

/// Degrees in a radian.
const DEGREES: f64 = 180.0 / PI;

/// The results. Lengths in mm, angles in degrees, speeds of axes in r/min, times in s; other units at their fields.
#[derive(Debug, Clone, Default)]
pub(super) struct Derived {
    /// The inserts cut a section out of the stock.
    pub cuts: bool,
    pub sides: f64,
    pub ratio: f64,
    /// Greatest distance across flats, as a micrometer measures it.
    pub across_flats: f64,
    /// Least and greatest deviation of any side from its plane.
    pub deviation: (f64, f64),
    pub flatness: f64,
    /// Greatest deviation where all inserts are in their places: above 0 the sides are hollow.
    pub hollow: f64,
    /// Curvature of the sides, 1/mm; positive for crowned sides.
    pub curvature: f64,
    pub corner: f64,
    pub across_corners: f64,
    /// Whether the sides meet in the stock.
    pub meets: bool,
    /// Area of the section, mm².
    pub area: f64,
    pub distance: f64,
    /// How far the body of the cutter would be in the stock if it were as large as the tip circle.
    pub reach: f64,
    pub offset: f64,
    /// Greatest relief that a pass needs (°), and the number of that pass, from 1.
    pub relief_needed: f64,
    pub relief_pass: f64,
    /// The inserts face in the direction of a cutter that turns in the sense of the work.
    pub faces_forward: bool,
    pub work_speed: f64,
    pub tool_speed: f64,
    /// Least cutting speed, m/min.
    pub slowest_cut: f64,
    /// Greatest cutting speed, m/min.
    pub fastest_cut: f64,
    pub orientation: f64,
    pub orientation_error: f64,
    /// Start angle A of the work for the wanted orientation.
    pub work_start: f64,
    /// Phase of the tool against the work, degrees of the tool; negative for a lag.
    pub phase: f64,
    /// Rotation of the polygon by the phase, degrees of the work.
    pub phase_on_work: f64,
    /// Phase of the tool after both have coasted to rest.
    pub coast_phase: f64,
    pub least_across_flats: f64,
    /// Whether all inserts are in their places.
    pub even: bool,
    /// The insert with the greatest radial error: its number, and the error.
    pub insert_depth: (f64, f64),
    /// The insert with the greatest angular error: its number, and the rotation of its sides.
    pub insert_turn: (f64, f64),
    /// Twist over the length, degrees.
    pub twist: f64,
    /// Speed of the tool that the twist needs during the last pass.
    pub twist_speed: f64,
    pub passes: f64,
    /// Feed of roughing, mm/min.
    pub feed: f64,
    /// Feed of finishing, mm/min.
    pub finish_feed: f64,
    /// Feed down into the stock, mm/min.
    pub infeed: f64,
    /// Length from face to jaws that the cutter needs.
    pub length_to_jaws: f64,
    pub mark_pitch: f64,
    pub ready: f64,
    pub cutting_time: f64,
    /// Force and torque of the cuts.
    pub load: PolygonLoad,
}

impl Derived {
    /// Computes the results for passes of these `sizes` across flats; X words count `x_per_mm` units per mm of the slide.
    pub(super) fn new(p: &Params, sizes: &[f64], x_per_mm: f64) -> Derived {
        let passes = sizes.len() as f64;
        let rough = p.per_minute(p.feed);
        let finish = p.per_minute(p.finish_feed);
        let whole = Derived {
            ratio: p.ratio().map_or(0.0, Ratio::value),
            work_speed: p.work_speed(),
            tool_speed: p.tool_speed(),
            offset: -p.tip_radius * x_per_mm,
            distance: 0.5 * p.across_flats + p.tip_radius,
            reach: p.reach(),
            passes,
            feed: rough,
            finish_feed: finish,
            infeed: p.per_minute(p.infeed),
            length_to_jaws: p.far_end() + p.clearance,
            ready: p.index_time() + 2.0 * p.settling(),
            cutting_time: p.cutting_time(),
            ..Derived::default()
        };
        let cut = p.setup(p.across_flats).zip(p.section());
        let cut = cut.filter(|_| p.across_flats < p.stock_diameter);
        cut.map_or_else(|| whole.clone(), |(setup, section)| whole.clone().with(p, sizes, &setup, &section))
    }

    /// Adds the results of the section.
    fn with(self, p: &Params, sizes: &[f64], setup: &CutterSetup, section: &Section) -> Derived {
        let Some(curve) = setup.curve(0) else { return self };
        let sides = section.sides();
        let (low, high) = sides
            .iter()
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), side| (low.min(side.low), high.max(side.high)));
        let corners = section.corners();
        let (relief_pass, cut) = p.cuts(setup, sizes).into_iter().fold((0.0, None), |(worst, all), (pass, cut)| {
            let more = all.is_none_or(|all: InsertLoad| cut.relief > all.relief);
            (if more { pass } else { worst }, Some(all.map_or(cut, |all| all.worst(cut))))
        });
        let Some(cut) = cut else { return self };
        let speed = self.work_speed.abs();
        let pitch = 360.0 / f64::from(setup.sides());
        let near = |angle: f64| angle - pitch * (angle / pitch).round();
        let phase = p.phase();
        let on_work = phase / self.ratio;
        let orientation = setup.normal(0.0) * DEGREES;
        let worst = |error: fn((f64, f64)) -> f64| {
            let errors = (0..setup.tips.len()).map(|insert| (insert as f64 + 1.0, error(setup.error(insert))));
            errors.fold((0.0_f64, 0.0_f64), |worst, next| if next.1.abs() > worst.1.abs() { next } else { worst })
        };
        let (depth, turn) = (worst(|error| error.0), worst(|error| error.1));
        let even = setup.is_even();
        let in_place = (!even).then(|| CutterSetup::even(p.across_flats, p.tip_radius, setup.ratio, setup.inserts()));
        let in_place = in_place.and_then(|setup| Section::new(&setup, 0.5 * p.blank())?.side(0));
        let twists = p.lead != 0.0;
        let twist_speed = cut::helical_tool_speed(setup.ratio, self.work_speed, -self.finish_feed, p.lead);
        Derived {
            cuts: true,
            sides: f64::from(setup.sides()),
            across_flats: section.across_flats().1,
            deviation: (low, high),
            flatness: sides.iter().map(|side| side.flatness()).fold(0.0, f64::max),
            hollow: in_place.map_or(high, |side| side.high),
            curvature: curve.curvature(),
            corner: corners.iter().map(|corner| corner.radius).fold(0.0, f64::max),
            across_corners: section.across_corners().1,
            meets: corners.iter().all(|corner| corner.meets),
            area: section.area(),
            relief_needed: cut.relief * DEGREES,
            relief_pass,
            faces_forward: curve.faces_forward(),
            slowest_cut: speed * cut.speeds.0,
            fastest_cut: speed * cut.speeds.1,
            orientation: orientation.rem_euclid(pitch),
            orientation_error: near(orientation + on_work - p.orientation),
            work_start: near(setup.work_start_for(p.orientation / DEGREES) * DEGREES + on_work),
            phase,
            phase_on_work: on_work,
            coast_phase: p.coast_phase(),
            least_across_flats: section.across_flats().0,
            even,
            insert_depth: depth,
            insert_turn: (turn.0, turn.1 * DEGREES / self.ratio),
            twist: if twists { cut::twist(p.length, p.lead) * DEGREES } else { 0.0 },
            twist_speed: if twists { twist_speed } else { self.tool_speed },
            load: p.load(sizes),
            mark_pitch: cut::mark_pitch(setup.ratio, setup.inserts(), p.finish_feed),
            ..self
        }
    }
}

/// All cutters and ratios for the polygon, the best first.
pub(super) fn choices(p: &Params, sizes: &[f64]) -> Vec<Choice> {
    choose::choices(&p.wanted(sizes), &p.means())
}

/// Cutters and ratios for the tip circle of the form alone: fast enough for every keystroke.
pub(super) fn choices_on_tip_circle(p: &Params, sizes: &[f64]) -> Vec<Choice> {
    let mut means = p.means();
    for cutter in &mut means.cutters {
        cutter.radius = (p.tip_radius, p.tip_radius);
    }
    choose::choices(&p.wanted(sizes), &means)
}
