//! Remainder of the stock after all inserts have passed: the exact section, and its measures.

use std::sync::{self, OnceLock};

use super::envelope::{self, Arc, OutlinePiece, boundary};
use super::setup::CutterSetup;
use crate::math::{self, PI};

/// Lengths (mm) that differ by no more are equal: far above rounding errors, far below any tolerance of a part.
pub const SAME_LENGTH: f64 = 1e-9;

/// A section of the work in mm: the stock minus the paths of all tips. Material cut by the body of an insert beside its tip is not removed.
#[derive(Debug, Clone, PartialEq)]
pub struct Section {
    stock: f64,
    apothem: f64,
    sides: u32,
    begin: f64,
    even: bool,
    arcs: Vec<Arc>,
    /// The sides, measured once for all copies.
    measured: sync::Arc<OnceLock<Vec<Side>>>,
}

/// A side compared with its ideal plane. Deviations are positive outside of the plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Side {
    /// Nominal angle of its normal.
    pub normal: f64,
    /// Angle of the deepest pass from the nominal normal.
    pub turned: f64,
    /// Deviation on the normal.
    pub middle: f64,
    /// Least deviation of the cut surface.
    pub low: f64,
    /// Greatest deviation of the cut surface.
    pub high: f64,
}

impl Side {
    /// Flatness error in mm.
    pub fn flatness(&self) -> f64 {
        self.high - self.low
    }
}

/// The corner between two sides.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Corner {
    /// Angle of the corner; of its middle if it is stock.
    pub angle: f64,
    /// Distance from the centre.
    pub radius: f64,
    /// Whether the two sides meet; otherwise stock is left between them.
    pub meets: bool,
}

/// Maximum number of sides of a section, and of passes.
pub const MOST_SIDES: u32 = 1000;

impl Section {
    /// The section that a cutter leaves of round stock of a radius. `None` if a tip reaches the centre of the work, or with more than
    /// [`MOST_SIDES`] sides or passes.
    pub fn new(setup: &CutterSetup, stock: f64) -> Option<Section> {
        let sides = setup.sides();
        let passes = setup.inserts().saturating_mul(setup.ratio.tool().unsigned_abs());
        let most = if setup.is_even() { sides } else { passes };
        let sound = stock > 0.0 && stock < 1e6 && setup.normal(0.0).abs() < 1e6;
        if !sound || most == 0 || most > MOST_SIDES {
            return None;
        }
        Some(Section {
            stock,
            apothem: setup.distance - setup.radius,
            sides,
            begin: setup.normal(0.0),
            even: setup.is_even(),
            arcs: envelope::outline(setup, stock)?,
            measured: sync::Arc::default(),
        })
    }

    /// Radius of the stock.
    pub fn stock(&self) -> f64 {
        self.stock
    }

    /// Angle of the normal of side 0.
    pub fn begin(&self) -> f64 {
        self.begin
    }

    fn pitch(&self) -> f64 {
        2.0 * PI / f64::from(self.sides)
    }

    /// Reduces an angle to the outline's turn, from the first normal.
    fn place(&self, angle: f64) -> f64 {
        let turns = (angle - self.begin) / (2.0 * PI);
        self.begin + 2.0 * PI * (turns - turns.floor())
    }

    /// Distance of the outline from the centre at an angle.
    pub fn radius(&self, angle: f64) -> f64 {
        let angle = self.place(angle);
        let arc = self.arcs.partition_point(|arc| arc.to < angle).min(self.arcs.len().saturating_sub(1));
        self.arcs.get(arc).map_or(self.stock, |arc| arc.radius(self.stock, angle))
    }

    /// Distances of the outline from the centre at `count` even angles over one turn, from the first normal.
    pub fn radii(&self, count: usize) -> Vec<f64> {
        let sides = self.sides as usize;
        // For equal sides, half of one side is computed, mirrored and repeated.
        if self.even && count.is_multiple_of(sides) {
            let each = count / sides;
            let half = self.walk(count, each / 2 + 1);
            let side = (0..each).map(|i| half.get(i.min(each - i)).copied().unwrap_or(self.stock));
            return side.cycle().take(count).collect();
        }
        self.walk(count, count)
    }

    /// The first `take` of `count` distances.
    fn walk(&self, count: usize, take: usize) -> Vec<f64> {
        let step = 2.0 * PI / count.max(1) as f64;
        let mut radii = Vec::with_capacity(take);
        let (mut at, mut last, mut before) = (0, 0.0, 0.0);
        for i in 0..take {
            let angle = self.begin + step * i as f64;
            while at + 1 < self.arcs.len() && self.arcs[at].to < angle {
                at += 1;
            }
            radii.push(match self.arcs.get(at).and_then(|arc| arc.cut) {
                // Guess for the next σ: the same step as the last one.
                Some(piece) => {
                    (before, last) = (last, piece.sigma(angle, 2.0 * last - before));
                    piece.curve.reach(last)
                }
                None => self.stock,
            });
        }
        radii
    }

    /// A point of the outline at a fraction of an arc, 0 to 1, linear in the tool angle.
    fn on(&self, arc: &Arc, part: f64) -> (f64, f64) {
        let (angle, radius) = match arc.cut {
            Some(piece) => {
                let (from, to) = ends(arc, &piece);
                let sigma = from + (to - from) * part;
                (piece.angle(sigma), piece.curve.reach(sigma))
            }
            None => (arc.from + (arc.to - arc.from) * part, self.stock),
        };
        let (sin, cos) = math::sin_cos(angle);
        (radius * cos, radius * sin)
    }

    /// The outline as points over one turn: `each` steps along every arc, linear in the tool angle. A jump of the radius has two points.
    pub fn points(&self, each: u32) -> Vec<(f64, f64)> {
        let each = each.max(1);
        let mut points: Vec<(f64, f64)> = Vec::with_capacity(self.arcs.len() * (each as usize + 1));
        for arc in &self.arcs {
            for point in (0..=each).map(|i| self.on(arc, f64::from(i) / f64::from(each))) {
                if points.last().is_none_or(|last| math::hypot(last.0 - point.0, last.1 - point.1) > SAME_LENGTH) {
                    points.push(point);
                }
            }
        }
        points.pop();
        points
    }

    /// The outline as spans over one turn, counter-clockwise, each with its first, middle and last point in mm: `each` along a cut surface,
    /// two along the stock. At a jump of the radius there is a gap between two spans.
    pub fn spans(&self, each: u32) -> Vec<[(f64, f64); 3]> {
        let of = |arc: &Arc| {
            let count = if arc.cut.is_some() { each.max(1) } else { 2 };
            let at = |half: u32| self.on(arc, f64::from(half) / f64::from(2 * count));
            (0..count).map(|i| [2 * i, 2 * i + 1, 2 * i + 2].map(at)).collect::<Vec<_>>()
        };
        self.arcs.iter().filter(|arc| arc.to > arc.from).flat_map(of).collect()
    }

    /// Area in mm².
    pub fn area(&self) -> f64 {
        let arc = |arc: &Arc| match arc.cut {
            Some(piece) => {
                let (from, to) = ends(arc, &piece);
                (piece.curve.area(to) - piece.curve.area(from)).abs()
            }
            None => 0.5 * self.stock * self.stock * (arc.to - arc.from),
        };
        self.arcs.iter().map(arc).sum()
    }

    /// The corners; corner i is between the sides i and i + 1.
    pub fn corners(&self) -> Vec<Corner> {
        let mut corners: Vec<Corner> = (0..self.sides)
            .map(|i| Corner { angle: self.begin + self.pitch() * (f64::from(i) + 0.5), radius: 0.0, meets: true })
            .collect();
        let mut stock = vec![(0.0, 0.0); corners.len()];
        for arc in &self.arcs {
            let window = ((0.5 * (arc.from + arc.to) - self.begin) / self.pitch()) as usize;
            let (Some(corner), Some(left)) = (corners.get_mut(window), stock.get_mut(window)) else { continue };
            let (from, to) = (arc.radius(self.stock, arc.from), arc.radius(self.stock, arc.to));
            if from.max(to) > corner.radius {
                corner.radius = from.max(to);
                corner.angle = if from > to { arc.from } else { arc.to };
            }
            if arc.cut.is_none() {
                corner.meets = false;
                *left = if left.1 > left.0 { (left.0, arc.to) } else { (arc.from, arc.to) };
            }
        }
        for (corner, left) in corners.iter_mut().zip(stock) {
            if !corner.meets {
                (corner.angle, corner.radius) = (0.5 * (left.0 + left.1), self.stock);
            }
        }
        corners
    }

    /// A side, counter-clockwise from the first. A side cut away completely has the distance of the section on its normal.
    pub fn side(&self, index: usize) -> Option<Side> {
        if index >= self.sides as usize {
            return None;
        }
        let mut side = self.uncut(index);
        for arc in &self.arcs {
            if let Some(piece) = arc.cut.filter(|piece| piece.pass.side == index) {
                side.add(self, arc, &piece);
            }
        }
        Some(side.measured())
    }

    /// The sides, counter-clockwise.
    pub fn sides(&self) -> &[Side] {
        self.measured.get_or_init(|| self.measure())
    }

    fn measure(&self) -> Vec<Side> {
        let all = 0..self.sides as usize;
        if let Some(first) = self.side(0).filter(|_| self.even) {
            let turned = |index: usize| Side { normal: first.normal + self.pitch() * index as f64, ..first };
            return all.map(turned).collect();
        }
        let mut sides: Vec<CutSide> = all.map(|index| self.uncut(index)).collect();
        for arc in &self.arcs {
            let Some(piece) = arc.cut else { continue };
            if let Some(side) = sides.get_mut(piece.pass.side) {
                side.add(self, arc, &piece);
            }
        }
        sides.into_iter().map(CutSide::measured).collect()
    }

    /// A side before its first arc.
    fn uncut(&self, index: usize) -> CutSide {
        let normal = self.begin + self.pitch() * index as f64;
        let middle = self.radius(normal) - self.apothem;
        let side = Side { normal, turned: 0.0, middle, low: f64::INFINITY, high: f64::NEG_INFINITY };
        CutSide { side, deepest: f64::INFINITY }
    }

    /// Least and greatest distance of an arc from the plane of its side: `ρ cos(φ - ψ) - d`.
    fn deviations(&self, arc: &Arc, piece: &OutlinePiece, normal: f64) -> (f64, f64) {
        let off = |sigma: f64| piece.curve.reach(sigma) * math::cos(piece.angle(sigma) - normal) - self.apothem;
        let rises = |sigma: f64| {
            let (sin, cos) = math::sin_cos(piece.angle(sigma) - normal);
            piece.curve.climb(sigma) * cos > piece.curve.reach(sigma) * piece.angle_slope(sigma) * sin
        };
        let (from, to) = ends(arc, piece);
        let (mut low, mut high) = (off(from).min(off(to)), off(from).max(off(to)));
        let mut at = from;
        for i in 1..=STEPS {
            let next = from + (to - from) * f64::from(i) / f64::from(STEPS);
            // At the normal itself the slope is 0, so the direction is tested slightly beside it.
            let before = rises(at + 1e-6 * (next - at));
            if before != rises(next - 1e-6 * (next - at)) {
                let turns = off(boundary(at, next, |sigma| rises(sigma) == before));
                (low, high) = (low.min(turns), high.max(turns));
            }
            at = next;
        }
        (low, high)
    }

    /// Distance over opposite sides as measured by a micrometer, least and greatest; for an odd number of sides, twice the distance of a
    /// side from the centre.
    pub fn across_flats(&self) -> (f64, f64) {
        across(&self.sides().iter().map(|side| self.apothem + side.high).collect::<Vec<f64>>())
    }

    /// Distance over opposite corners, least and greatest; for an odd number of sides, twice the radius of a corner.
    pub fn across_corners(&self) -> (f64, f64) {
        across(&self.corners().iter().map(|corner| corner.radius).collect::<Vec<f64>>())
    }
}

/// A side while its arcs are measured.
struct CutSide {
    side: Side,
    /// Distance of its deepest pass from the centre.
    deepest: f64,
}

impl CutSide {
    /// Adds an arc of the side.
    fn add(&mut self, section: &Section, arc: &Arc, piece: &OutlinePiece) {
        let (low, high) = section.deviations(arc, piece, self.side.normal);
        self.side.low = self.side.low.min(low);
        self.side.high = self.side.high.max(high);
        if piece.curve.apothem() < self.deepest {
            self.deepest = piece.curve.apothem();
            let off = (piece.pass.normal - self.side.normal) / (2.0 * PI);
            self.side.turned = 2.0 * PI * (off - off.round());
        }
    }

    /// The side of all its arcs.
    fn measured(self) -> Side {
        let Side { middle, low, high, .. } = self.side;
        if low > high { Side { low: middle, high: middle, ..self.side } } else { self.side }
    }
}

/// The σ at both ends of an arc.
fn ends(arc: &Arc, piece: &OutlinePiece) -> (f64, f64) {
    let guess = piece.branch.sigma.0;
    (piece.sigma(arc.from, guess), piece.sigma(arc.to, guess))
}

/// Number of steps in the search of an arc for extremes of its deviation; at usual ratios an arc has one at most.
const STEPS: u32 = 16;

/// Least and greatest distance of opposite sides.
fn across(radii: &[f64]) -> (f64, f64) {
    let half = if radii.len().is_multiple_of(2) { radii.len() / 2 } else { 0 };
    let sums = radii.iter().zip(radii.iter().cycle().skip(half)).map(|(one, other)| one + other);
    sums.fold((f64::INFINITY, 0.0), |(low, high): (f64, f64), sum| (low.min(sum), high.max(sum)))
}
