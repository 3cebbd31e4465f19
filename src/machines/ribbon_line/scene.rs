//! The drawing of the ribbon line: supply reel, unwinder, slack loop, pull roller, print roller with its heads, and the dots.
//!
//! The ribbon runs at height 118 from left to right. Nothing is to scale but the angles, the pitch of the dots (26 units) and their
//! smear; the loop hangs as deep as the slack is long.

use super::params::Params;
use super::resolved::RibbonLine;
use crate::math::{self, PI};
use crate::text::catalog::number_text as show;
use crate::text::catalog::{Language, words};
use crate::text::number::filled;
use crate::view::Scene;
use crate::view::pen::{Pen, ray};

/// Groups that poses move.
pub(super) mod group {
    pub(in super::super) const REEL: u16 = 1;
    pub(in super::super) const UNWINDER: u16 = 2;
    pub(in super::super) const UNWINDER_PRESS: u16 = 3;
    pub(in super::super) const PULL: u16 = 4;
    pub(in super::super) const PULL_PRESS: u16 = 5;
    pub(in super::super) const PRINT: u16 = 6;
    pub(in super::super) const PRINT_BLUR: u16 = 7;
    pub(in super::super) const UNWINDER_BLUR: u16 = 8;
    pub(in super::super) const PULL_BLUR: u16 = 9;
    pub(in super::super) const DOTS_BLUR: u16 = 10;
    /// First of the dots, newest first.
    pub(in super::super) const DOTS: u16 = 11;
}

/// Nodes whose path or text poses change; they follow the frame.
pub(super) mod node {
    /// Plates, the reel's stand, the floor.
    const FRAME: u16 = 5;
    pub(in super::super) const LOOP: u16 = FRAME;
    pub(in super::super) const UNWINDER_SPEED: u16 = FRAME + 1;
    pub(in super::super) const UNWINDER_VOLTS: u16 = FRAME + 2;
    pub(in super::super) const SLACK: u16 = FRAME + 3;
    pub(in super::super) const LOOP_STATE: u16 = FRAME + 4;
    pub(in super::super) const PULL_FEED: u16 = FRAME + 5;
    pub(in super::super) const PULL_POSITION: u16 = FRAME + 6;
    pub(in super::super) const PRINT_SPEED: u16 = FRAME + 7;
    pub(in super::super) const PRINT_HEAD: u16 = FRAME + 8;
    pub(in super::super) const DOT_COUNT: u16 = FRAME + 9;
}

/// Height of the ribbon's middle.
pub(super) const WEB: f64 = 118.0;
/// Centre and radius of the supply reel.
pub(super) const REEL: (f64, f64, f64) = (80.0, 186.0, 62.0);
/// Centre and radius of the unwinder's driven roller, below the ribbon.
pub(super) const UNWINDER: (f64, f64, f64) = (222.0, 150.5, 30.0);
/// Centre and radius of the roller that presses the ribbon on it.
pub(super) const UNWINDER_PRESS: (f64, f64, f64) = (222.0, 97.5, 18.0);
/// Centre and radius of the pull roller.
pub(super) const PULL: (f64, f64, f64) = (430.0, 150.5, 30.0);
/// Centre and radius of its press roller.
pub(super) const PULL_PRESS: (f64, f64, f64) = (430.0, 97.5, 18.0);
/// Centre of the print roller and radius over its heads.
pub(super) const PRINT: (f64, f64, f64) = (576.0, 74.0, 41.0);
/// Units of the drawing from dot to dot.
pub(super) const PITCH: f64 = 26.0;
/// Dots that fit behind the print roller.
pub(super) const DOTS: u16 = 8;
/// Depth of the loop with neither slack nor lack.
const LOOP_DEPTH: f64 = 66.0;
/// Greatest number of heads in the drawing.
const HEADS: f64 = 60.0;

/// The drawing at rest.
pub(super) fn scene(line: &RibbonLine) -> Scene {
    let p = &line.p;
    let mut pen = Pen::default();
    let language = Language::English;
    let name = |id: &'static str| words(language, id).to_owned();
    frame(&mut pen);
    // Nodes that change, in the order of `node`.
    pen.path(0, loop_path(0.0, p.loop_capacity), "", "ribbon", 5.0, "web");
    for (x, y, anchor, class) in [
        (222.0, 216.0, "middle", "value"),
        (222.0, 232.0, "middle", "value"),
        (326.0, 58.0, "middle", "value"),
        (326.0, 74.0, "middle", "label"),
        (430.0, 216.0, "middle", "value"),
        (430.0, 232.0, "middle", "value"),
        (640.0, 62.0, "start", "value"),
        (640.0, 78.0, "start", "value"),
        (752.0, 102.0, "end", "value"),
    ] {
        pen.text(x, y, anchor, String::new(), "ink", class);
    }
    reel(&mut pen);
    web(&mut pen, p);
    unwinder(&mut pen);
    pull(&mut pen);
    print(&mut pen, p);
    for (x, y, anchor, id) in [
        (80.0, 303.0, "middle", "ribbon.scene.reel"),
        (222.0, 199.0, "middle", "ribbon.scene.unwinder"),
        (326.0, 42.0, "middle", "ribbon.scene.loop"),
        (430.0, 199.0, "middle", "ribbon.scene.pull"),
        (640.0, 46.0, "start", "ribbon.scene.print"),
        (576.0, 303.0, "middle", "ribbon.scene.anvil"),
        (222.0, 303.0, "middle", "ribbon.scene.inverter"),
        (430.0, 303.0, "middle", "ribbon.scene.servo"),
    ] {
        let mut text = name(id);
        if id == "ribbon.scene.print" {
            text.push(' ');
            text.push_str(&p.print_axis.address().to_string());
        }
        pen.text(x, y, anchor, text, "dim", "label");
    }
    Scene {
        view: [0.0, 0.0, 760.0, 312.0],
        nodes: pen.nodes,
        groups: Pen::groups(group::DOTS + DOTS),
        unit: 0.0,
        gradients: Vec::new(),
        alt: "ribbon.scene.alt",
        option: Some("ribbon.scene.strobe"),
    }
}

/// The loop between unwinder and pull roller: its depth shows the slack, down to the capacity and up to a straight ribbon.
pub(super) fn loop_path(slack: f64, capacity: f64) -> String {
    let share = if capacity > 0.0 { math::clamp(slack / capacity, -1.0, 1.0) } else { 0.0 };
    let low = WEB + LOOP_DEPTH * (1.0 + share);
    let (from, to) = (UNWINDER.0, PULL.0);
    let middle = (from + to) / 2.0;
    let (first, last) = ([from + 52.0, middle - 46.0], [middle + 46.0, to - 52.0]);
    filled(
        "M# #C# # # # # #C# # # # # #",
        &[from, WEB, first[0], WEB, first[1], low, middle, low, last[0], low, last[1], WEB, to, WEB],
    )
}

/// The machine's plates behind the stations, and the floor.
fn frame(pen: &mut Pen) {
    for (x, top, w) in [(UNWINDER.0, 66.0, 108.0), (PULL.0, 66.0, 108.0), (PRINT.0, 18.0, 108.0)] {
        let (left, right) = (x - w / 2.0, x + w / 2.0);
        let low = top + 10.0;
        let d = filled(
            "M# 286V#Q# # # #H#Q# # # #V286Z",
            &[left, low, left, top, left + 10.0, top, right - 10.0, right, top, right, low],
        );
        pen.path(0, d, "line", "", 0.0, "plate");
    }
    let (x, y, _) = REEL;
    pen.path(0, filled("M# #L# 286H#L# #Z", &[x - 7.0, y, x - 24.0, x + 24.0, x + 7.0, y]), "line", "", 0.0, "plate");
    pen.line(0, "M16 287H744", "dim", 1.0);
}

fn reel(pen: &mut Pen) {
    let (x, y, r) = REEL;
    pen.disc(0, x, y, r, "ribbon", "wound");
    for turn in 1..6 {
        pen.ring(0, (x, y, 22.0 + 8.0 * f64::from(turn) - 2.0), "ribbon", 1.0, "winding");
    }
    pen.ring(0, (x, y, r), "ribbon", 2.0, "");
    pen.disc(0, x, y, 19.0, "steel", "roller");
    for spoke in 0..3 {
        let (s, c) = math::sin_cos(2.0 * PI * f64::from(spoke) / 3.0);
        pen.path(group::REEL, ray(x, y, (c, s), 7.0, 17.0), "", "pane", 4.0, "mark");
        // A mark on the outermost winding, to see the reel turn.
        pen.path(group::REEL, ray(x, y, (c, s), 52.0, 59.0), "", "ribbon", 2.0, "");
    }
    pen.disc(0, x, y, 5.0, "pane", "");
    pen.ring(0, (x, y, 5.0), "dim", 1.0, "");
}

/// The ribbon but for its loop, the anvil, the capacity of the loop, and the direction.
fn web(pen: &mut Pen, p: &Params) {
    // From the reel's top, tangent, into the nip.
    let tangent = filled("M# #L# #", &[REEL.0 + 30.0, REEL.1 - 54.4, UNWINDER.0, WEB]);
    for d in [tangent, filled("M# #H760", &[PULL.0, WEB])] {
        pen.path(0, d, "", "ribbon", 5.0, "web");
    }
    // How deep the loop may hang, and a straight ribbon.
    let full = WEB + 2.0 * LOOP_DEPTH + 6.0;
    pen.path(0, filled("M290 #H362", &[full]), "", "dim", 1.0, "dash");
    pen.text(326.0, full + 14.0, "middle", format!("{} mm", show(p.loop_capacity, 0)), "dim", "small");
    pen.rect(546.0, WEB + 3.5, 60.0, 9.0, "steel", "roller");
    pen.path(0, filled("M560 #V286H592V#Z", &[WEB + 12.5, WEB + 12.5]), "steel", "", 0.0, "soft");
    pen.path(0, "M738 136H752M748 132L753 136L748 140".to_owned(), "", "dim", 1.2, "");
    pen.path(0, "M640 136V144M666 136V144M640 140H666".to_owned(), "", "dim", 1.0, "");
    pen.text(653.0, 157.0, "middle", format!("{} mm", show(p.pitch, 3)), "dim", "small");
    pen.text(653.0, 170.0, "middle", words(Language::English, "ribbon.scene.pitch").to_owned(), "dim", "small");
}

fn unwinder(pen: &mut Pen) {
    pen.roller(UNWINDER, group::UNWINDER, Some(group::UNWINDER_BLUR), 3);
    pen.roller(UNWINDER_PRESS, group::UNWINDER_PRESS, None, 3);
    // Inverter with its analog input, and the motor.
    pen.rect(196.0, 242.0, 52.0, 36.0, "steel", "box");
    pen.path(0, "M206 266C212 246 218 246 222 259S232 272 238 252".to_owned(), "", "accent", 1.6, "");
}

fn pull(pen: &mut Pen) {
    pen.roller(PULL, group::PULL, Some(group::PULL_BLUR), 3);
    pen.roller(PULL_PRESS, group::PULL_PRESS, None, 3);
    pen.rect(404.0, 242.0, 52.0, 36.0, "steel", "box");
    pen.path(0, "M414 268H422V260H430V252H438V246H446".to_owned(), "", "accent", 1.6, "");
}

fn print(pen: &mut Pen, p: &Params) {
    let (x, y, r) = PRINT;
    let body = r - 6.0;
    pen.disc(0, x, y, body, "steel", "roller");
    pen.ring(0, (x, y, body - 1.0), "dim", 0.8, "soft");
    let heads = math::clamp(p.heads, 1.0, HEADS);
    // A head is as wide as the rest of the circumference allows, and never wider than a dot.
    let width = (0.6 * 2.0 * PI * body / heads).min(7.0);
    for head in 0..heads as u32 {
        // Head 0 points down, at the ribbon; the roller turns against the clock.
        let (s, c) = math::sin_cos(PI / 2.0 + 2.0 * PI * f64::from(head) / heads);
        let d = ray(x, y, (c, s), body - 1.0, r + 0.5);
        let fill = if head == 0 { "bad" } else { "accent" };
        pen.path(group::PRINT, d, "", fill, width, "head");
        if heads <= 12.0 {
            pen.path(group::PRINT, ray(x, y, (c, s), 14.0, 29.0), "", "pane", 3.0, "mark");
        }
    }
    pen.ring(group::PRINT_BLUR, (x, y, r - 2.5), "accent", 6.0, "blur");
    pen.disc(0, x, y, 9.0, "pane", "");
    pen.ring(0, (x, y, 9.0), "dim", 1.0, "");
    dots(pen, p);
}

/// The dots, each a group of its own, and the streak that replaces them at high speed.
fn dots(pen: &mut Pen, p: &Params) {
    let ratio = PI * p.print_roller_diameter / p.heads / p.pitch;
    let smear = (crate::drives::web::smear(ratio, p.contact_length) / p.pitch * PITCH).min(PITCH - 6.0);
    pen.path(group::DOTS_BLUR, filled("M# #H760", &[PRINT.0, WEB]), "", "ink", 4.4, "blur");
    for dot in 0..DOTS {
        let d = filled("M# #h#", &[PRINT.0 - smear / 2.0, WEB, smear.max(0.01)]);
        pen.path(group::DOTS + dot, d, "", "ink", 4.4, "dot");
    }
}
