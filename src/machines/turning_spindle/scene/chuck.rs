//! The chuck with its three jaws: the jaws turn with the spindle, and jaws towards the operator are in front of the part.

use super::ids::{group, node};
use super::solid::{self, FaceBlock};
use crate::math::{self, PI};
use crate::text::number::fill;
use crate::view::drawing::Drawing;
use crate::view::look::{Look, Paint};

/// Jaws of the chuck.
pub(in super::super) const JAWS: u16 = 3;
/// Paths of a jaw: sides and end of its base, sides and end of its step.
const PARTS: u16 = 4;
/// Left end of the body, and front ends of base and step of the jaws before its face.
const LEFT: f64 = 236.0;
const BASE: f64 = 18.0;
const STEP: f64 = 42.0;

/// Measures of the chuck in drawing units: it fits the stock.
#[derive(Debug, Clone, Copy)]
pub(in super::super) struct Chuck {
    /// Radius of the body.
    radius: f64,
    /// Its face.
    face: f64,
    /// Radius at which the jaws grip.
    grip: f64,
}

impl Chuck {
    /// A chuck for stock of a radius.
    pub(super) fn of(grip: f64) -> Chuck {
        let radius = math::clamp(1.42 * grip, 84.0, 139.0);
        Chuck { radius, face: LEFT + 0.46 * radius, grip }
    }

    /// Front end of the jaws.
    pub(super) fn front(&self) -> f64 {
        self.face + STEP
    }

    /// Front end of the base of the jaws, which reaches outwards as far as the body.
    pub(super) fn base_front(&self) -> f64 {
        self.face + BASE
    }

    /// Face of the chuck's body, in units of the drawing.
    pub(in super::super) fn face(&self) -> f64 {
        self.face
    }

    fn half(&self) -> f64 {
        0.15 * self.radius
    }

    /// Outer ends of step and base of the jaws.
    fn ends(&self) -> (f64, f64) {
        let base = (0.97 * self.radius).max(self.grip + 24.0);
        (self.grip + 0.55 * (base - self.grip), base)
    }

    /// Base and step of the jaw at an angle.
    fn jaw(&self, angle: f64) -> [FaceBlock; 2] {
        let (step, base) = self.ends();
        let block = |x: (f64, f64), end: f64, half: f64| FaceBlock {
            x: (self.face + x.0, self.face + x.1),
            out: (self.grip, end),
            half,
            angle,
        };
        [block((0.0, BASE), base, self.half()), block((BASE, STEP), step, 0.82 * self.half())]
    }

    /// Nose of the spindle.
    pub(super) fn draw_nose(&self, drawing: &mut Drawing) {
        drawing
            .path(solid::body(&[(190.0, 0.52 * self.radius), (LEFT, 0.52 * self.radius)]), Look::fill(Paint::DarkBar));
    }

    /// Body, with nodes for the marks and jaws that turn.
    pub(super) fn draw_body(&self, drawing: &mut Drawing) {
        drawing.path(solid::body(&[(LEFT, self.radius), (self.face, self.radius)]), Look::fill(Paint::DarkBar));
        let mut grooves = String::new();
        for part in [0.2, 0.86] {
            solid::arc(&mut grooves, LEFT + part * (self.face - LEFT), self.radius, 0.0, PI);
        }
        drawing.path(grooves, Look::HAIR.faint(0.5));
        drawing.within(group::JAWS_FAR, |drawing| {
            drawing.path(String::new(), Look::fill(Paint::Black).thin(Paint::DarkLight, 0.8)).id = Some(node::KEYS);
        });
        drawing.path(solid::circle(self.face, self.radius), Look::DARK_FACE);
        drawing.path(solid::circle(self.face, 0.94 * self.radius), Look::HAIR.faint(0.4));
        drawing.within(group::JAWS_FAR, |drawing| {
            drawing.path(String::new(), Look::fill(Paint::DarkShade)).id = Some(node::SLOTS);
            jaws(drawing, node::FAR);
        });
    }

    /// The jaws before the part, and the shadow that they blur to: dark, because bright rings would look like parts.
    pub(super) fn draw_near_jaws(&self, drawing: &mut Drawing) {
        drawing.within(group::JAWS_NEAR, |drawing| jaws(drawing, node::NEAR));
        let (step, base) = self.ends();
        drawing.within_hidden(group::BLUR, |drawing| {
            for (x, end) in [((0.0, BASE), base), ((BASE, STEP), step)] {
                let (from, to) = (self.face + x.0, self.face + x.1);
                drawing.path(solid::body(&[(from, end), (to, end)]), Look::fill(Paint::DarkShade));
                drawing.path(solid::ring(to, end, self.grip), Look::fill(Paint::Dark));
            }
        });
    }

    /// Paths at an angle of the spindle (turns).
    pub(in super::super) fn pose(&self, turns: f64, paths: &mut Vec<(u16, String)>) {
        let angle = 2.0 * PI * (turns - turns.floor());
        let third = 2.0 * PI / f64::from(JAWS);
        let (mut slots, mut keys) = (String::new(), String::new());
        for jaw in 0..JAWS {
            let at = angle + third * f64::from(jaw);
            let is_near = math::sin(at) > 0.0;
            let mut parts: [String; PARTS as usize] = Default::default();
            let [base, step] = self.jaw(at);
            let [base_sides, base_end, step_sides, step_end] = &mut parts;
            base.sides(base_sides);
            base.end(base_end);
            step.sides(step_sides);
            step.end(step_end);
            for (part, drawing) in (0..).zip(parts) {
                let number = PARTS * jaw + part;
                let (shown, empty) = if is_near { (node::NEAR, node::FAR) } else { (node::FAR, node::NEAR) };
                paths.push((shown + number, drawing));
                paths.push((empty + number, String::new()));
            }
            let slot = FaceBlock {
                x: (self.face, self.face),
                out: (0.3 * self.radius, 0.96 * self.radius),
                half: 0.55 * self.half(),
                angle: at,
            };
            slot.end(&mut slots);
            self.key(&mut keys, at + 0.5 * third);
        }
        paths.push((node::SLOTS, slots));
        paths.push((node::KEYS, keys));
    }

    /// The square socket of the chuck key in the rim, where the operator sees it.
    fn key(&self, out: &mut String, angle: f64) {
        if math::sin(angle) < 0.12 {
            return;
        }
        let (x, half) = (LEFT + 0.52 * (self.face - LEFT), 0.07 * self.radius);
        for (at, (along, around)) in [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].into_iter().enumerate() {
            let (x, y) = solid::corner(x + along * half, self.radius, angle + around * half / self.radius, 0.0);
            fill(out, if at == 0 { "M# #" } else { "L# #" }, &[x, y]);
        }
        out.push('Z');
    }
}

/// Nodes for the paths of the jaws.
fn jaws(drawing: &mut Drawing, first: u16) {
    for number in 0..PARTS * JAWS {
        let paint = if number % 2 == 0 { Paint::SteelShade } else { Paint::SteelFace };
        drawing.path(String::new(), Look::fill(paint).thin(Paint::Edge, 0.8)).id = Some(first + number);
    }
}
