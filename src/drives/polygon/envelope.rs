//! The section as arcs: remainder of the stock after all passes, found arc by arc, each exact to rounding.

use super::curve::{Branch, Curve};
use super::setup::{CutterSetup, Pass};
use crate::math::{self, PI};

/// Half of a pass on one side of its normal, over one branch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct OutlinePiece {
    pub(super) curve: Curve,
    pub(super) branch: Branch,
    pub(super) pass: Pass,
    /// Angle of the normal on the section.
    normal: f64,
    /// +1 counter-clockwise of the normal, -1 clockwise.
    hand: f64,
}

/// A part of the outline between two angles: cut by one piece, or remaining stock. Its radius is monotonic.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Arc {
    pub(super) from: f64,
    pub(super) to: f64,
    pub(super) cut: Option<OutlinePiece>,
}

impl OutlinePiece {
    /// The σ at an angle of the section.
    pub(super) fn sigma(&self, angle: f64, guess: f64) -> f64 {
        self.curve.sigma(&self.branch, self.hand * (angle - self.normal), guess)
    }

    /// Angle on the section at σ.
    pub(super) fn angle(&self, sigma: f64) -> f64 {
        self.normal + self.hand * self.curve.angle(&self.branch, sigma)
    }

    /// Derivative of that angle with respect to σ.
    pub(super) fn angle_slope(&self, sigma: f64) -> f64 {
        self.hand * self.curve.angle_slope(&self.branch, sigma)
    }

    /// The arc cut out of uncut stock.
    fn arc(self) -> Arc {
        let ends = [self.branch.angle.0, self.branch.angle.1].map(|angle| self.normal + self.hand * angle);
        Arc { from: ends[0].min(ends[1]), to: ends[0].max(ends[1]), cut: Some(self) }
    }

    /// The piece, turned to another side.
    fn moved(self, by: f64) -> OutlinePiece {
        OutlinePiece { normal: self.normal + by, ..self }
    }
}

impl Arc {
    /// Distance of the outline from the centre at an angle within the arc.
    pub(super) fn radius(&self, stock: f64, angle: f64) -> f64 {
        self.cut.map_or(stock, |piece| piece.curve.reach(piece.sigma(angle, piece.branch.sigma.0)))
    }
}

/// Rounding errors of a radius (mm) and of an angle (rad).
const ROUNDING: f64 = 1e-12;

/// Appends an arc to the outline.
fn push(arcs: &mut Vec<Arc>, arc: Arc) {
    let sliver = arc.to - arc.from <= ROUNDING;
    match arcs.last_mut() {
        Some(last) if sliver || last.cut == arc.cut => last.to = arc.to,
        None if sliver => {}
        _ => arcs.push(arc),
    }
}

/// Removes the material that a new arc cuts deeper. Within one arc both radii are monotonic: in opposite directions they cross once at
/// most, and in the same direction their ends show which one is deeper.
fn lower(arcs: Vec<Arc>, new: Arc, stock: f64) -> Vec<Arc> {
    let mut out = Vec::with_capacity(arcs.len() + 2);
    for arc in arcs {
        let (from, to) = (arc.from.max(new.from), arc.to.min(new.to));
        if from >= to {
            push(&mut out, arc);
            continue;
        }
        let deeper = |angle: f64| new.radius(stock, angle) < arc.radius(stock, angle) - ROUNDING;
        let (first, last) = (deeper(from), deeper(to));
        let cross = if first == last { to } else { boundary(from, to, |angle| deeper(angle) == first) };
        let one = |new_one: bool, from: f64, to: f64| Arc { from, to, cut: if new_one { new.cut } else { arc.cut } };
        push(&mut out, Arc { to: from, ..arc });
        push(&mut out, one(first, from, cross));
        push(&mut out, one(last, cross, to));
        push(&mut out, Arc { from: to, ..arc });
    }
    out
}

/// Halvings until the ends of an interval of angles are neighbours.
const HALVINGS: u32 = 60;

/// The boundary between `from`, where `holds` is true, and `to`, where it is false.
pub(super) fn boundary(from: f64, to: f64, holds: impl Fn(f64) -> bool) -> f64 {
    let (from, to) = math::bisect(from, to, HALVINGS, holds);
    0.5 * (from + to)
}

/// Both halves of a pass within the stock, in the order of their angles.
fn pieces(curve: Curve, pass: Pass, stock: f64) -> impl Iterator<Item = OutlinePiece> {
    let halves = curve.branches(stock).into_iter().filter(|branch| !branch.is_empty());
    halves
        .flat_map(move |branch| [-1.0, 1.0].map(|hand| OutlinePiece { curve, branch, pass, normal: pass.normal, hand }))
}

/// The outline over one turn, from the normal of side 0.
pub(super) fn outline(setup: &CutterSetup, stock: f64) -> Option<Vec<Arc>> {
    let begin = setup.normal(0.0);
    let whole = Arc { from: begin, to: begin + 2.0 * PI, cut: None };
    if setup.is_even() { even(setup, whole, stock) } else { uneven(setup, whole, stock) }
}

/// Outline for evenly spaced inserts on one circle: half of one side, mirrored and repeated.
fn even(setup: &CutterSetup, whole: Arc, stock: f64) -> Option<Vec<Arc>> {
    let (sides, curve) = (setup.sides(), setup.curve(0)?);
    let pitch = 2.0 * PI / f64::from(sides);
    let pass = Pass { insert: 0, side: 0, normal: whole.from };
    // From the normal to the corner, where the next side begins.
    let mut half = vec![Arc { from: whole.from, to: whole.from + 0.5 * pitch, cut: None }];
    for piece in pieces(curve, pass, stock).filter(|piece| piece.hand > 0.0) {
        half = lower(half, piece.arc(), stock);
    }
    let mut arcs = Vec::with_capacity(half.len() * sides as usize * 2);
    let owner = cutters(setup);
    for side in 0..sides {
        let at = f64::from(side) * pitch;
        let place = |arc: &Arc, (from, to): (f64, f64), by: f64, side: u32, hand: f64| {
            let insert = owner.get(side as usize).copied().unwrap_or_default();
            let pass = Pass { insert, side: side as usize, normal: whole.from + f64::from(side) * pitch };
            Arc { from, to, cut: arc.cut.map(|piece| OutlinePiece { hand, pass, ..piece.moved(by) }) }
        };
        for arc in &half {
            push(&mut arcs, place(arc, (arc.from + at, arc.to + at), at, side, 1.0));
        }
        let next = at + pitch;
        let mirrored = |angle: f64| 2.0 * whole.from + next - angle;
        for arc in half.iter().rev() {
            push(&mut arcs, place(arc, (mirrored(arc.to), mirrored(arc.from)), next, (side + 1) % sides, -1.0));
        }
    }
    Some(arcs)
}

/// The first insert that cuts each side.
fn cutters(setup: &CutterSetup) -> Vec<usize> {
    let mut owner = vec![usize::MAX; setup.sides() as usize];
    for pass in setup.passes() {
        owner[pass.side] = owner[pass.side].min(pass.insert);
    }
    owner
}

/// Outline for inserts off their places: all passes in turn.
fn uneven(setup: &CutterSetup, whole: Arc, stock: f64) -> Option<Vec<Arc>> {
    let mut arcs = vec![whole];
    for pass in setup.passes() {
        for piece in pieces(setup.curve(pass.insert)?, pass, stock) {
            // Reduced to the outline's turn, with copies one turn before and after for pieces across its ends.
            let turns = ((pass.normal - whole.from) / (2.0 * PI)).floor();
            for turn in [-1.0, 0.0, 1.0] {
                let new = piece.moved((turn - turns) * 2.0 * PI).arc();
                let new = Arc { from: new.from.max(whole.from), to: new.to.min(whole.to), ..new };
                if new.from < new.to {
                    arcs = lower(arcs, new, stock);
                }
            }
        }
    }
    Some(arcs)
}
