//! Bending of the work between jaws and cutter, under the force of an insert or of the tool that turns an end.

use super::params::{FIELDS, Params};
use super::resolved::PolygonLathe;
use crate::drives::bending::{NOTABLE, cantilever};
use crate::drives::cutting::LEAST_DEPTH;
use crate::machines::form::entry::{at_least, at_most};
use crate::machines::knobs;
use crate::machines::verdict::{Judgement, fail, ok, warn};
use crate::math;
use crate::msg;
use crate::text::Diagnostic;
use crate::view::Advice;
use crate::view::Limit::AtMost;

impl PolygonLathe {
    /// Length (mm) of the bar from face to jaws: that of the form, or the least for the cutter.
    fn free_length(&self) -> f64 {
        if self.p.free_length > 0.0 { self.p.free_length } else { self.length_to_jaws() }
    }

    /// Deflection (mm) under a force (N) across the work at a distance from the face, of a bar that is free up to the jaws: the bar has the
    /// width across flats where a polygon is, which is less than its stiffness.
    fn deflection(&self, force: f64, behind: f64, free: f64) -> f64 {
        let mut flats: Vec<&Params> = self.polygons().map(|lathe| &lathe.p).filter(|p| p.far_end() > behind).collect();
        flats.sort_by(|a, b| a.from_face.total_cmp(&b.from_face));
        let mut at = behind;
        let mut steps = Vec::new();
        for p in flats {
            let (begin, end) = (p.from_face.max(at), p.far_end().min(free).max(at));
            let begin = begin.min(end);
            steps.extend([(begin - at, self.p.stock_diameter), (end - begin, p.across_flats)]);
            at = end;
        }
        steps.push((free - at, self.p.stock_diameter));
        cantilever(force, self.p.material.elasticity(), steps)
    }

    /// Greatest deflection (mm) of the work under its forces, at the end of each polygon towards the face, with this free length (mm).
    fn bending_of(&self, free: f64) -> f64 {
        let cuts = self.polygons().map(|lathe| {
            let force = lathe.d.load.cuts.iter().map(|cut| cut.force).fold(0.0, f64::max);
            self.deflection(force, lathe.p.from_face, free)
        });
        cuts.fold(0.0, f64::max)
    }

    /// Greatest force (N) of an insert with which no polygon bends the work by more than a deflection (mm); infinite without force.
    fn force_bending_by(&self, most: f64) -> f64 {
        let free = self.free_length();
        self.polygons().map(|lathe| most / self.deflection(1.0, lathe.p.from_face, free)).fold(f64::INFINITY, f64::min)
    }

    /// Greatest deflection (mm) of the work under the force of an insert.
    pub(super) fn bending(&self) -> f64 {
        self.bending_of(self.free_length())
    }

    /// Depth of a pass (mm) with which no force is above a share of the greatest one; none that the passes allow.
    fn shallower(&self, share: f64) -> Option<f64> {
        let limit = share * self.force();
        let force = |depth: f64| {
            let forces = self.polygons().flat_map(|lathe| {
                let p = Params { depth, ..lathe.p.clone() };
                let sizes: Vec<f64> = (1..=p.passes() as u32).map(|pass| p.size(f64::from(pass))).collect();
                p.load(&sizes).cuts.map(|cut| cut.force)
            });
            forces.fold(0.0, f64::max)
        };
        let least = LEAST_DEPTH.max(self.p.stock_diameter / 2.0 / super::passes::PASSES);
        if least >= self.p.depth {
            return None;
        }
        Some(self.p.depth * math::greatest_share(least / self.p.depth, |share| force(share * self.p.depth) <= limit)?)
    }
}

/// What the force of the cut does to each turned end, as a bar of its diameter from its shoulder to the face: an error where the end gives way
/// by more than the cut is deep, `None` where it is stiff enough.
pub(super) fn of_ends(lathe: &PolygonLathe) -> [Option<Diagnostic>; 2] {
    let p = &lathe.p;
    p.turned_ends.each_ref().map(|end| {
        let steps = [(end.length, end.diameter), (lathe.free_length() - end.length, p.stock_diameter)];
        let bending = cantilever(lathe.end_force(end), p.material.elasticity(), steps);
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

/// Bending against the tolerance of the flats, with a shorter free length or a smaller depth as a remedy where one of them suffices.
pub(super) fn judge(lathe: &PolygonLathe) -> Option<Judgement> {
    let p = &lathe.p;
    let (bending, limit) = (lathe.bending(), AtMost(p.flatness));
    if bending <= p.flatness {
        let fed = lathe.at_highest_feed().map(|(percent, fed)| (percent, fed, fed.bending()));
        return match fed.filter(|(_, _, bending)| *bending > p.flatness) {
            Some((percent, fed, bending)) => {
                let (percent, bending, limit_there) = ((percent, 0), (bending, 3), (p.flatness, 4));
                let message = msg!("polygon.bends-at-feed-knob", percent, bending, limit = limit_there);
                let sets = lathe.feeds_below(fed, fed.force_bending_by(p.flatness));
                warn(limit, [knobs::setting_feeds(message.into(), sets)])
            }
            None => ok(limit),
        };
    }
    let (free, needed) = (lathe.free_length(), at_least(FIELDS, "free-length", lathe.length_to_jaws()));
    let fact = Advice::from(msg!(
        "polygon.work-bends",
        bending = (bending, 3),
        limit = (p.flatness, 4),
        length = (free, 1),
        needed = (needed.value, 1)
    ));
    let fed = lathe.with_most_feed();
    let is_short_enough = needed.value < free && fed.bending_of(needed.value) <= p.flatness;
    let advice = if is_short_enough {
        fact.setting(msg!("advice.set-free-length", length = needed.text.as_str()), [needed])
    } else if let Some(depth) = fed.shallower(p.flatness / fed.bending()) {
        let set = at_most(FIELDS, "depth", depth);
        fact.setting(msg!("advice.set-depth", depth = set.text.as_str()), [set])
    } else {
        fact
    };
    fail(limit, [advice])
}
