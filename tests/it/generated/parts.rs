//! Parts of generated programs in every language.

use macroline::controls::{Address, Code};

use super::dice::Dice;

/// An arc from one quadrant point of a circle to another, in units of the circle's own axes.
pub(crate) struct Arc {
    pub(crate) plane: Code,
    /// Letter, distance to the end, distance to the centre: of the first axis of the plane, and of the second.
    pub(crate) axes: [(Address, i32, i32); 2],
    pub(crate) clockwise: bool,
    pub(crate) radius: i32,
    /// Quarters of the circle, 0 for the full circle.
    pub(crate) quarters: usize,
}

impl Arc {
    /// An arc in one of these planes.
    pub(crate) fn of(dice: &mut Dice, planes: &[Plane]) -> Arc {
        let (plane, first, second) = dice.pick(planes);
        let clockwise = dice.rarely(128);
        let radius = 1 + dice.below(20) as i32;
        let (from, to) = (dice.below(4), dice.below(4));
        let corner = |quarter: usize| [(1, 0), (0, 1), (-1, 0), (0, -1)][quarter];
        let ((ax, ay), (bx, by)) = (corner(from), corner(to));
        let quarters = if clockwise { from + 4 - to } else { to + 4 - from } % 4;
        let axes = [(first, (bx - ax) * radius, -ax * radius), (second, (by - ay) * radius, -ay * radius)];
        Arc { plane, axes, clockwise, radius, quarters }
    }

    pub(crate) fn code(&self) -> Code {
        if self.clockwise { Code::ArcCw } else { Code::ArcCcw }
    }

    /// The radius as a word: negative for an arc longer than half the circle.
    pub(crate) fn signed_radius(&self) -> i32 {
        if self.quarters == 3 { -self.radius } else { self.radius }
    }
}

/// A plane and its two axes.
pub(crate) type Plane = (Code, Address, Address);

/// All planes.
pub(crate) const PLANES: [Plane; 3] = [
    (Code::PlaneXy, Address::X, Address::Y),
    (Code::PlaneZx, Address::Z, Address::X),
    (Code::PlaneYz, Address::Y, Address::Z),
];

/// The address of the centre of an arc along an axis: I for X.
pub(crate) fn center(axis: Address) -> Address {
    match axis {
        Address::X => Address::I,
        Address::Y => Address::J,
        _ => Address::K,
    }
}

/// A modal code, with the feed word that it needs.
pub(crate) fn mode(dice: &mut Dice) -> (Code, &'static str) {
    use Code::{
        Absolute, Cutting, ExactStop, FeedPerMinute, FeedPerRevolution, Inch, Incremental, Metric, PlaneXy, PlaneZx,
    };
    let code = dice.pick(&[
        ExactStop,
        Cutting,
        FeedPerMinute,
        FeedPerRevolution,
        Inch,
        Metric,
        Absolute,
        Incremental,
        PlaneXy,
        PlaneZx,
        Cutting,
        FeedPerMinute,
        Metric,
    ]);
    let feed = match code {
        FeedPerMinute => " F400.",
        FeedPerRevolution => " F.2 S1000 M3",
        _ => "",
    };
    (code, feed)
}
