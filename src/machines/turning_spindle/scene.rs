//! The drawing of the turning spindle: chuck, part, tool and voltmeter, seen from the operator's side.
//!
//! The part is to scale with its diameters and lengths; chuck, tool and voltmeter are not.

use super::params::{Output, Params, Path};
use super::resolved::TurningSpindle;
use crate::math::{self, PI};
use crate::text::catalog::number_text as show;
use crate::text::catalog::{Language, words};
use crate::text::number::filled;
use crate::view::Scene;
use crate::view::pen::{Pen, ray};

/// Groups that poses move.
pub(super) mod group {
    pub(in super::super) const TOOL: u16 = 1;
    pub(in super::super) const NEEDLE: u16 = 2;
    pub(in super::super) const BLUR: u16 = 3;
    /// First of the jaws.
    pub(in super::super) const JAWS: u16 = 4;
}

/// Jaws of the chuck.
pub(super) const JAWS: u16 = 3;

/// Nodes whose path or text poses change; they follow the frame.
pub(super) mod node {
    /// Headstock, chuck, stock, centre line, the voltmeter's face.
    const FRAME: u16 = 5;
    pub(in super::super) const PART: u16 = FRAME;
    pub(in super::super) const SPEED: u16 = FRAME + 1;
    pub(in super::super) const SURFACE: u16 = FRAME + 2;
    pub(in super::super) const DIAMETER: u16 = FRAME + 3;
    pub(in super::super) const STAGE: u16 = FRAME + 4;
    pub(in super::super) const VOLTS: u16 = FRAME + 5;
    pub(in super::super) const PASS: u16 = FRAME + 6;
    pub(in super::super) const BOUND: u16 = FRAME + 7;
}

/// Height of the turning centre.
pub(super) const CENTRE: f64 = 168.0;
/// The chuck's face, and half its height.
const CHUCK: (f64, f64) = (150.0, 96.0);
/// Centre and radius of the voltmeter.
pub(super) const METER: (f64, f64, f64) = (660.0, 118.0, 74.0);
/// Degrees of the needle from its middle to either end.
pub(super) const SWEEP: f64 = 55.0;
/// Width and half height that the part may take.
const ROOM: (f64, f64) = (300.0, 104.0);

/// How the part lies in the drawing.
pub(super) struct View {
    /// Units of the drawing per millimetre.
    pub(super) scale: f64,
    /// Position of the finished face.
    pub(super) face: f64,
    /// Length of the part between chuck and finished face, mm.
    pub(super) behind: f64,
}

impl View {
    pub(super) fn new(p: &Params) -> View {
        let (behind, before) = match p.path {
            Path::Facing => (0.4 * p.stock_diameter + p.allowance, p.allowance),
            _ => (p.length + 0.15 * p.stock_diameter, 0.0),
        };
        let scale = (ROOM.0 / (behind + before)).min(ROOM.1 / (0.5 * p.stock_diameter));
        View { scale, face: CHUCK.0 + behind * scale, behind }
    }

    /// A point of the part: mm from the finished face, diameter in mm.
    pub(super) fn point(&self, z: f64, diameter: f64) -> (f64, f64) {
        (self.face + z * self.scale, CENTRE - 0.5 * diameter * self.scale)
    }
}

/// The drawing at rest.
pub(super) fn scene(lathe: &TurningSpindle) -> Scene {
    let p = &lathe.p;
    let mut pen = Pen::default();
    let view = View::new(p);
    let name = |id: &'static str| words(Language::English, id).to_owned();
    frame(&mut pen, p, &view);
    // Nodes that change, in the order of `node`.
    pen.path(0, String::new(), "steel", "dim", 1.0, "part");
    for (x, y, anchor, class) in [
        (84.0, 300.0, "middle", "value"),
        (560.0, 262.0, "start", "value"),
        (560.0, 280.0, "start", "value"),
        (84.0, 66.0, "middle", "value"),
        (METER.0, METER.1 + 42.0, "middle", "value"),
        (560.0, 298.0, "start", "value"),
        (METER.0, 214.0, "middle", "small"),
    ] {
        pen.text(x, y, anchor, String::new(), "ink", class);
    }
    jaws(&mut pen);
    tool(&mut pen, &view);
    meter(&mut pen, p);
    for (x, y, anchor, id) in [
        (84.0, 50.0, "middle", "turning.scene.gear"),
        (84.0, 284.0, "middle", "turning.scene.spindle"),
        (METER.0, 196.0, "middle", "turning.scene.output"),
        (552.0, 262.0, "end", "turning.scene.surface"),
        (552.0, 280.0, "end", "turning.scene.diameter"),
        (552.0, 298.0, "end", "turning.scene.pass"),
    ] {
        pen.text(x, y, anchor, name(id), "dim", "label");
    }
    Scene {
        view: [0.0, 0.0, 760.0, 312.0],
        nodes: pen.nodes,
        groups: Pen::groups(group::JAWS + JAWS),
        unit: 0.0,
        gradients: Vec::new(),
        alt: "turning.scene.alt",
        option: None,
    }
}

/// Headstock and chuck, the centre line, the stock as it was.
fn frame(pen: &mut Pen, p: &Params, view: &View) {
    let (face, half) = CHUCK;
    pen.path(0, filled("M24 #H#V#H24Z", &[CENTRE - 78.0, face - 54.0, CENTRE + 84.0]), "line", "", 0.0, "plate");
    pen.path(
        0,
        filled("M# #H#V#H#Z", &[face - 54.0, CENTRE - half, face - 14.0, CENTRE + half, face - 54.0]),
        "steel",
        "dim",
        1.0,
        "roller",
    );
    let before = if p.path == Path::Facing { p.allowance } else { 0.0 };
    let ((left, top), (right, _)) = (view.point(-view.behind, p.stock_diameter), view.point(before, 0.0));
    pen.path(0, filled("M# #H#V#H#Z", &[left, top, right, 2.0 * CENTRE - top, left]), "", "dim", 1.0, "dash");
    pen.path(0, filled("M14 #H540", &[CENTRE]), "", "dim", 0.8, "dash");
    pen.rect(METER.0 - 92.0, 34.0, 184.0, 144.0, "line", "box");
}

/// The jaws; poses lift and lower them as the chuck turns.
fn jaws(pen: &mut Pen) {
    let (face, _) = CHUCK;
    pen.rect(face - 14.0, CENTRE - 78.0, 14.0, 156.0, "line", "");
    for jaw in 0..JAWS {
        let d = filled("M# #h34v22h-34z", &[face - 20.0, CENTRE - 11.0]);
        pen.path(group::JAWS + jaw, d, "ink", "pane", 1.0, "jaw");
    }
    let blur = filled("M# #h34v156h-34z", &[face - 20.0, CENTRE - 78.0]);
    pen.path(group::BLUR, blur, "ink", "", 0.0, "blur");
}

/// The tool with its tip at the finished face on the turning centre; poses shift it.
fn tool(pen: &mut Pen, view: &View) {
    let (x, y) = (view.face, CENTRE);
    pen.path(group::TOOL, filled("M# #l7 -15l-14 -3z", &[x, y]), "accent", "pane", 0.6, "insert");
    pen.path(group::TOOL, filled("M# #l16 3v-46h-20v38z", &[x - 8.0, y - 17.0]), "dim", "", 0.0, "holder");
}

/// The voltmeter: its arc with a mark at every fifth.
fn meter(pen: &mut Pen, p: &Params) {
    let (x, y, r) = METER;
    let bipolar = p.output == Output::Bipolar;
    for mark in 0..=10 {
        let part = f64::from(mark) / 5.0 - 1.0;
        let (s, c) = math::sin_cos((part * SWEEP - 90.0) / 180.0 * PI);
        let long = mark % 5 == 0;
        pen.path(
            0,
            ray(x, y, (c, s), if long { r - 12.0 } else { r - 7.0 }, r),
            "",
            "ink",
            if long { 2.0 } else { 1.0 },
            "",
        );
        if long {
            let volts = if bipolar { 10.0 * part } else { 5.0 * (part + 1.0) };
            pen.text(x + (r - 22.0) * c, y + (r - 22.0) * s + 4.0, "middle", show(volts, 0), "dim", "small");
        }
    }
    pen.path(group::NEEDLE, ray(x, y, (0.0, -1.0), -12.0, r - 4.0), "", "bad", 2.0, "");
    pen.disc(0, x, y, 5.0, "ink", "");
}
