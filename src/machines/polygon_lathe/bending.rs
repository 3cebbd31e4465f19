//! Bending of the work between jaws and cutter, under the force of an insert or of the tool that turns an end.

use super::load::{ForceLimits, PolygonFeed, PolygonLoad};
use super::params::{FIELDS, Params};
use super::resolved::PolygonLathe;
use super::turned_end_form::TurnedEnd;
use crate::drives::bending::{NOTABLE, cantilever};
use crate::drives::cutting::LEAST_DEPTH;
use crate::machines::form::entry::{at_least, at_most};
use crate::machines::lathe::knobs;
use crate::machines::verdict::{Judgement, fail, ok, warn};
use crate::math;
use crate::msg;
use crate::text::Diagnostic;
use crate::view::Advice;
use crate::view::Limit::AtMost;

/// Least share of the present forces that is sought for even flats.
const LEAST_SHARE: f64 = 0.001;

/// A section of the bar that is thinner than its stock: distances of both ends from the face, and its diameter, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Thinner {
    from: f64,
    to: f64,
    diameter: f64,
}

impl TurnedEnd {
    /// The end as a thinner section of the bar; `None` if it is not turned.
    fn thinner(&self) -> Option<Thinner> {
        self.on.then_some(Thinner { from: 0.0, to: self.length, diameter: self.diameter })
    }
}

impl PolygonLathe {
    /// Length (mm) of the bar from face to jaws: that of the form, or, if it is unknown, the least that the cutter
    /// needs.
    fn free_length(&self) -> f64 {
        if self.params.free_length > 0.0 { self.params.free_length } else { self.length_to_jaws() }
    }

    /// Deflection (mm) of the bar under a transverse force (N) at the distance `behind` (mm) from the face; `free`:
    /// distance (mm) of the jaws from the face; `thinner`: sections with a smaller diameter.
    fn deflection(&self, force: f64, behind: f64, free: f64, thinner: &[Thinner]) -> f64 {
        let ends = thinner.iter().flat_map(|part| [part.from, part.to]).filter(|end| (behind..free).contains(end));
        let mut places: Vec<f64> = ends.chain([behind, free.max(behind)]).collect();
        places.sort_by(f64::total_cmp);
        let steps = places.windows(2).filter_map(|pair| {
            let [from, to] = pair else { return None };
            let here = thinner.iter().filter(|part| part.from <= *from && *to <= part.to);
            Some((to - from, here.map(|part| part.diameter).fold(self.params.stock_diameter, f64::min)))
        });
        cantilever(force, self.params.material.elasticity(), steps)
    }

    /// The polygons as thinner sections of the bar, of the greatest circle in them, which underestimates their stiffness.
    fn flats(&self) -> impl Iterator<Item = Thinner> {
        let part = |p: &Params| Thinner { from: p.from_face, to: p.far_end(), diameter: p.circle_in_flats() };
        self.polygons().map(move |lathe| part(&lathe.params))
    }

    /// The thinner sections of the bar while a polygon is cut: all flats, and the end turned before them.
    fn thinner_in_flats(&self) -> Vec<Thinner> {
        let [before, _] = &*self.params.turned_ends;
        self.flats().chain(before.thinner()).collect()
    }

    /// Greatest deflection (mm) of the work that stays on the flats, with the free length `free` (mm). The force acts at the near end of each
    /// polygon.
    fn bending_of(&self, free: f64) -> f64 {
        let thinner = self.thinner_in_flats();
        let left = |lathe: &PolygonLathe| self.left_on_flats(lathe, &lathe.derived.load, free, &thinner);
        self.polygons().map(left).fold(0.0, f64::max)
    }

    /// The same for the cuts of one polygon.
    fn left_on_flats(&self, lathe: &PolygonLathe, load: &PolygonLoad, free: f64, thinner: &[Thinner]) -> f64 {
        let give = self.deflection(1.0, lathe.params.from_face, free, thinner);
        let down = give * load.force_together(PolygonFeed::Infeed) - lathe.params.left_by_infeed();
        load.left_by_passes(give).max(down)
    }

    /// Greatest forces (N) of the cuts at each feed that leave at most the flatness tolerance on the flats; infinite where those of the form do.
    fn forces_within_flatness(&self) -> [f64; 3] {
        let (free, thinner) = (self.free_length(), self.thinner_in_flats());
        let of = |lathe: &PolygonLathe| {
            let (load, flatness) = (&lathe.derived.load, lathe.params.flatness);
            let give = self.deflection(1.0, lathe.params.from_face, free, &thinner);
            let is_even = |share: f64| load.left_by_passes(share * give) <= flatness;
            let share =
                if is_even(1.0) { None } else { math::greatest_share(LEAST_SHARE, is_even).or(Some(LEAST_SHARE)) };
            let along = |feed| share.map_or(f64::INFINITY, |share| share * load.force_together(feed));
            let down = (flatness + lathe.params.left_by_infeed()) / give;
            [along(PolygonFeed::Roughing), along(PolygonFeed::Finishing), down]
        };
        let least = |all: [f64; 3], next: [f64; 3]| core::array::from_fn(|feed| all[feed].min(next[feed]));
        self.polygons().map(of).fold([f64::INFINITY; 3], least)
    }

    /// Greatest deflection (mm) of the work that stays on the flats.
    pub(super) fn bending(&self) -> f64 {
        self.bending_of(self.free_length())
    }

    /// Greatest depth of a pass (mm) with which the flats are even enough; `None` if the number of passes does not allow such a depth.
    fn shallower(&self) -> Option<f64> {
        let (free, thinner, present) = (self.free_length(), self.thinner_in_flats(), self.params.depth);
        let bends = |depth: f64| {
            let left = |lathe: &PolygonLathe| {
                let p = Params { depth, ..lathe.params.clone() };
                let sizes: Vec<f64> = (1..=p.passes() as u32).map(|pass| p.size(f64::from(pass))).collect();
                self.left_on_flats(lathe, &p.cutting_torques(&sizes), free, &thinner)
            };
            self.polygons().map(left).fold(0.0, f64::max)
        };
        let least = LEAST_DEPTH.max(self.params.stock_diameter / 2.0 / super::passes::PASSES);
        if least >= present {
            return None;
        }
        let share = math::greatest_share(least / present, |share| bends(share * present) <= self.params.flatness)?;
        Some(present * share)
    }
}

impl Params {
    /// What the infeed leaves for the last pass, mm.
    fn left_by_infeed(&self) -> f64 {
        if self.passes() <= 1.0 { 0.0 } else { self.allowance }
    }
}

impl PolygonLoad {
    /// Deflection (mm) that the passes leave on the flats of a bar that gives way by `give` (mm/N). A pass of the depth d leaves
    /// `c (d + u) / (1 + c)` of the depth and of what the pass before has left, u: the bar springs back by the compliance c of mm per mm of
    /// depth, and the force is that of the layer that is really cut. Source: polygon turning facts 3.9.
    fn left_by_passes(&self, give: f64) -> f64 {
        let left = |left: f64, (at, depth): (usize, &f64)| {
            let is_last = at + 1 == self.layers.len();
            let feed = if is_last { PolygonFeed::Finishing } else { PolygonFeed::Roughing };
            let compliance = give * self.at(feed).per_depth * self.at_once.max(1.0);
            compliance * (depth + left) / (1.0 + compliance)
        };
        self.layers.iter().enumerate().fold(0.0, left)
    }
}

/// Bending of each turned end under its cutting force. The model is a bar of the end's diameter from face to shoulder,
/// and behind it the stock with the flats and the other end if they are cut before. An error if the end deflects by
/// more than the depth of cut, a warning above [`NOTABLE`], `None` if it is stiff enough.
pub(super) fn of_ends(lathe: &PolygonLathe) -> [Option<Diagnostic>; 2] {
    let p = &lathe.params;
    let [before, after] = &*p.turned_ends;
    let flats = lathe.thinner_in_flats();
    [(before, Vec::new()), (after, flats)].map(|(end, cut_before)| {
        let thinner: Vec<Thinner> = cut_before.into_iter().chain(end.thinner()).collect();
        let bending = lathe.deflection(lathe.end_force(end), 0.0, lathe.free_length(), &thinner);
        if !end.on || bending <= NOTABLE {
            return None;
        }
        let (deflection, depth) = ((bending, 2), (end.depth, 3));
        Some(if bending > end.depth {
            Diagnostic::error(msg!("polygon.end-gives-way", bending = deflection, depth))
        } else {
            Diagnostic::warning(msg!("polygon.end-bends", bending = deflection))
        })
    })
}

/// Judges bending against the tolerance of the flats; the remedies are a shorter free length or a smaller depth, if one
/// of them suffices.
pub(super) fn judge(lathe: &PolygonLathe) -> Option<Judgement> {
    let p = &lathe.params;
    let (bending, limit) = (lathe.bending(), AtMost(p.flatness));
    if bending <= p.flatness {
        let fed = lathe.at_highest_feed().map(|(percent, fed)| (percent, fed, fed.bending()));
        return match fed.filter(|(_, _, bending)| *bending > p.flatness) {
            Some((percent, fed, bending)) => {
                let (percent, bending, limit_there) = ((percent, 0), (bending, 3), (p.flatness, 4));
                let message = msg!("polygon.bends-at-feed-knob", percent, bending, limit = limit_there);
                let sets = lathe.feeds_below(fed, ForceLimits::of_flats(fed.forces_within_flatness()));
                warn(limit, [knobs::setting_feeds(message.into(), sets)])
            }
            None => ok(limit),
        };
    }
    let (free, needed) = (lathe.free_length(), at_least(FIELDS, "free-length", lathe.length_to_jaws()));
    let (bending, limit_there) = ((bending, 3), (p.flatness, 4));
    let fact = if needed.value < free {
        let (length, needed) = ((free, 1), (needed.value, 1));
        msg!("polygon.work-bends", bending, limit = limit_there, length, needed)
    } else {
        msg!("polygon.shortest-work-bends", bending, limit = limit_there, needed = (needed.value, 1))
    };
    let fact = Advice::from(fact);
    let fed = lathe.with_most_feed();
    let is_short_enough = needed.value < free && fed.bending_of(needed.value) <= p.flatness;
    let advice = if is_short_enough {
        fact.setting(msg!("advice.set-free-length", length = needed.text.as_str()), [needed])
    } else if let Some(depth) = fed.shallower() {
        let set = at_most(FIELDS, "depth", depth);
        fact.setting(msg!("advice.set-depth", depth = set.text.as_str()), [set])
    } else {
        knobs::setting_feeds(fact, lathe.feeds_below(fed, ForceLimits::of_flats(fed.forces_within_flatness())))
    };
    fail(limit, [advice])
}
