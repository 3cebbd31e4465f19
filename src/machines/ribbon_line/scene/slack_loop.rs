//! The shape of the free loop: its length is that of the ribbon between the nips, so the drawn loop has the depth of its slack.
//!
//! The ribbon leaves the nip of each roller on its surface, over the angle θ, runs straight down at θ, and turns in an arc of radius ρ:
//!
//! ```text
//! d = r1 + r2 + g                 distance of the nips [mm], with the gap g between the rollers
//! k d = r1 + r2 + 2 ρ             k just below 1, less where the radii differ, so that both straight parts are longer than 0
//! L(θ) = d (k θ + (1 - k sin θ) / cos θ)          length of the ribbon
//! s(θ) = L(θ) - d                                 slack; ds/dθ = d sin θ (1 - k sin θ) / cos² θ > 0
//! l1 - l2 = (r2 - r1) tan(θ/2)                    straight parts, so that both ends of the arc meet
//! h(θ) = (r1 + ρ) (1 - cos θ) + l1 sin θ          depth below the nips
//! ```

use super::web::Web;
use crate::math::{self, PI};

/// The loop between two rollers whose nips are at height 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct SlackLoop {
    /// Distance of the nips, mm.
    pub(crate) distance: f64,
    /// Radii of the rollers, mm.
    radii: (f64, f64),
    /// (r1 + r2 + 2 ρ) / d.
    k: f64,
    /// Radius of the arc at the bottom, mm.
    rho: f64,
    /// Drawn slack per mm of slack: 1 but for loops deeper than the machine is high.
    pub(crate) share: f64,
}

/// Greatest k: the sides are almost vertical.
const UPRIGHT: f64 = 0.999;

/// Greatest radius of a roller in the loop as a share of that of the arc.
const ROLLER_SHARE: f64 = 0.75;

impl SlackLoop {
    /// The loop between rollers of these radii with a gap between them, in which a slack of `capacity` hangs no deeper than `room`.
    pub(crate) fn new((r1, r2): (f64, f64), gap: f64, capacity: f64, room: f64) -> SlackLoop {
        let distance = r1 + gap + r2;
        let uneven = (r1 - r2) / distance;
        let k = UPRIGHT.min((1.0 - uneven * uneven).max(0.0).sqrt());
        let rho = (0.5 * (k * distance - r1 - r2)).max(0.0);
        let whole = SlackLoop { distance, radii: (r1, r2), k, rho, share: 1.0 };
        let most = whole.slack_at_depth(room);
        SlackLoop { share: if capacity > most { most / capacity } else { 1.0 }, ..whole }
    }

    /// Angle (rad) at which a quantity that grows with it exceeds a limit.
    fn angle_where(exceeds: impl Fn(f64) -> bool) -> f64 {
        math::last_holding(0.0, 0.5 * PI, 48, |angle| !exceeds(angle))
    }

    /// s(θ) over d.
    fn relative_slack(&self, angle: f64) -> f64 {
        let (s, c) = math::sin_cos(angle);
        self.k * angle + (1.0 - self.k * s) / c - 1.0
    }

    /// θ of a slack, rad; 0 for a tight ribbon.
    fn angle(&self, slack: f64) -> f64 {
        let wanted = slack * self.share / self.distance;
        if wanted <= 0.0 { 0.0 } else { SlackLoop::angle_where(|angle| self.relative_slack(angle) > wanted) }
    }

    /// Straight parts at θ.
    fn straights(&self, angle: f64) -> (f64, f64) {
        let (s, c) = math::sin_cos(angle);
        let both = self.distance * (1.0 - self.k * s) / c;
        let apart = (self.radii.1 - self.radii.0) * s / (1.0 + c);
        (0.5 * (both + apart), 0.5 * (both - apart))
    }

    /// h(θ).
    fn depth_at(&self, angle: f64) -> f64 {
        let (s, c) = math::sin_cos(angle);
        (self.radii.0 + self.rho) * (1.0 - c) + self.straights(angle).0 * s
    }

    /// Depth of the loop below the nips at a slack, mm of the drawing.
    pub(crate) fn depth(&self, slack: f64) -> f64 {
        self.depth_at(self.angle(slack))
    }

    /// Slack (mm) of a loop of this depth (mm of the drawing).
    pub(crate) fn slack_at_depth(&self, depth: f64) -> f64 {
        let angle = SlackLoop::angle_where(|angle| self.depth_at(angle) > depth);
        self.relative_slack(angle) * self.distance / self.share
    }

    /// Lowest point of the loop at a slack, from the first nip, mm of the drawing.
    pub(crate) fn lowest(&self, slack: f64) -> (f64, f64) {
        let angle = self.angle(slack);
        let (s, c) = math::sin_cos(angle);
        let (l1, _) = self.straights(angle);
        (self.radii.0 * s + l1 * c + self.rho * s, self.depth_at(angle))
    }

    /// Greatest radius of a roller that lies in the loop, mm.
    pub(crate) fn largest_roller_radius(&self) -> f64 {
        ROLLER_SHARE * self.rho
    }

    /// The ribbon from nip to nip, the first at (`x`, 0).
    pub(crate) fn web(&self, x: f64, slack: f64) -> Web {
        let angle = self.angle(slack);
        let (s, c) = math::sin_cos(angle);
        let (r1, r2) = self.radii;
        let (l1, _) = self.straights(angle);
        let mut web = Web::from((x, 0.0));
        if angle <= 0.0 {
            web.line((x + self.distance, 0.0));
            return web;
        }
        let leaves = (x + r1 * s, r1 * (1.0 - c));
        let turns = (leaves.0 + l1 * c, leaves.1 + l1 * s);
        let rises = (turns.0 + 2.0 * self.rho * s, turns.1);
        let meets = (x + self.distance - r2 * s, r2 * (1.0 - c));
        web.clockwise(leaves, r1);
        web.line(turns);
        web.counter_clockwise(rises, self.rho);
        web.line(meets);
        web.clockwise((x + self.distance, 0.0), r2);
        web
    }
}
