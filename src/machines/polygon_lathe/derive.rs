//! The formulas of the polygon lathe, each once: results that need no run.

use super::load::PolygonLoad;
use super::params::Params;
use crate::drives::polygon::choose::{Choice, choices};
use crate::drives::polygon::cut::{self, InsertLoad};
use crate::drives::polygon::{CutterSetup, Ratio, Section};
use crate::math::{self, PI};

/// Greatest number of passes.
pub(super) const PASSES: f64 = 60.0;

/// Degrees in a radian.
const DEGREES: f64 = 180.0 / PI;

/// The results. Lengths in mm, angles in degrees, speeds in r/min, times in s.
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
    pub slowest_cut: f64,
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
    pub feed: f64,
    pub finish_feed: f64,
    pub infeed: f64,
    /// Length of stock between face and jaws that the cutter needs.
    pub free_length: f64,
    pub mark_pitch: f64,
    pub ready: f64,
    pub cutting_time: f64,
    /// Force and torque of the cuts.
    pub load: PolygonLoad,
}

impl Params {
    /// Depth of all roughing passes, on the radius.
    fn rough(&self) -> f64 {
        (0.5 * (self.stock_diameter - self.across_flats) - self.allowance).max(0.0)
    }

    /// How far the tips go into the stock, mm: `(stock - AF) / 2`. The body of the cutter, `h` behind the tips, touches stock beside the
    /// polygon if this reach is more than `h`. Source: mechanics, with the distance of the axes a = AF/2 + r and a body of the radius r -
    /// h.
    fn reach(&self) -> f64 {
        (0.5 * (self.stock_diameter - self.across_flats)).max(0.0)
    }

    /// Number of passes; the last one finishes.
    pub(super) fn passes(&self) -> f64 {
        // Nine decimals: 0.3 / 0.1 is three passes.
        1.0 + math::clamp(math::whole_up(self.rough() / self.depth), 0.0, PASSES)
    }

    /// Across flats after a pass (from 1).
    pub(super) fn size(&self, pass: f64) -> f64 {
        let rough = self.across_flats + 2.0 * self.allowance;
        if pass >= self.passes() {
            self.across_flats
        } else {
            (self.stock_diameter - 2.0 * pass * self.depth).max(rough)
        }
    }

    /// Feed of a pass in mm for each turn of the work.
    pub(super) fn feed_of(&self, pass: f64) -> f64 {
        if pass >= self.passes() { self.finish_feed } else { self.feed }
    }

    /// Speed of the work in r/min, signed: `n = B · D`. Source: K2000T facts 2.
    pub(super) fn work_speed(&self) -> f64 {
        self.speed * self.work_ratio
    }

    /// Speed of the tool in r/min, signed: `n = B · Q`. Source: K2000T facts 2.
    pub(super) fn tool_speed(&self) -> f64 {
        self.speed * self.tool_ratio
    }

    /// F in mm/min for a feed for each turn of the work.
    pub(super) fn per_minute(&self, feed: f64) -> f64 {
        feed * self.work_speed().abs()
    }

    /// Settling time of both axes, s: `max(τ) + 8 / min(K)`, with time constants τ [s] and position gains K [1/s].
    pub(super) fn settling(&self) -> f64 {
        self.work_time_constant.max(self.tool_time_constant) / 1000.0 + 8.0 / self.work_gain.min(self.tool_gain)
    }

    /// Phase of the tool ahead of the work at speed, degrees of the tool: `6 n_tool · ((τ_w/2 + 1/K_w) - (τ_t/2 + 1/K_t))`, with time
    /// constants τ [s] and gains K [1/s] of work and tool. Source: servo lag after linear acceleration.
    pub(super) fn phase(&self) -> f64 {
        let lag = |ms: f64, gain: f64| 0.5 * ms / 1000.0 + 1.0 / gain;
        let early = lag(self.work_time_constant, self.work_gain) - lag(self.tool_time_constant, self.tool_gain);
        6.0 * self.tool_speed() * early + 0.0
    }

    /// Deceleration of work and tool by friction with the drives off, r/min per second.
    pub(super) fn coasting(&self) -> [f64; 2] {
        [self.work_limit / self.work_coast, self.tool_limit / self.tool_coast]
    }

    /// Phase of the tool ahead of the work after coasting to rest, degrees of the tool: each axis turns by `3 n² / a` degrees, with speed n
    /// [r/min] and deceleration a [r/min per second].
    pub(super) fn coast_phase(&self) -> f64 {
        let [work, tool] = self.coasting();
        let left = |rpm: f64, slows: f64| 3.0 * rpm * rpm.abs() / slows;
        let ratio = self.tool_ratio / self.work_ratio;
        left(self.tool_speed(), tool) - ratio * left(self.work_speed(), work) + 0.0
    }

    /// Time of the axes to their start angles, s: `max(|A|, |E|) / (6 n_index)`.
    pub(super) fn index_time(&self) -> f64 {
        self.work_start.abs().max(self.tool_start.abs()) / (6.0 * self.index_speed)
    }
}

impl Derived {
    /// Computes the results for passes of these `sizes` across flats; X words count `cross_words` units per mm of the slide.
    pub(super) fn new(p: &Params, sizes: &[f64], cross_words: f64) -> Derived {
        let passes = sizes.len() as f64;
        let rough = p.per_minute(p.feed);
        let finish = p.per_minute(p.finish_feed);
        let whole = Derived {
            ratio: p.ratio().map_or(0.0, Ratio::value),
            work_speed: p.work_speed(),
            tool_speed: p.tool_speed(),
            offset: -p.tip_radius * cross_words,
            distance: 0.5 * p.across_flats + p.tip_radius,
            reach: p.reach(),
            passes,
            feed: rough,
            finish_feed: finish,
            infeed: p.per_minute(p.infeed),
            free_length: p.far_end() + p.clearance,
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
        let in_place = in_place.and_then(|setup| Section::new(&setup, 0.5 * p.stock_diameter)?.side(0));
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
pub(super) fn ways(p: &Params, sizes: &[f64]) -> Vec<Choice> {
    choices(&p.wanted(sizes), &p.means())
}

/// Cutters and ratios for the tip circle of the form alone: fast enough for every keystroke.
pub(super) fn ways_as_set(p: &Params, sizes: &[f64]) -> Vec<Choice> {
    let mut means = p.means();
    for cutter in &mut means.cutters {
        cutter.radius = (p.tip_radius, p.tip_radius);
    }
    choices(&p.wanted(sizes), &means)
}
