//! Positions and sizes in the drawing of the ribbon line, in mm from the nip of the unwinder: x to the right, y down, the ribbon at height 0.
//!
//! Rollers, pitch, loop and supply reel are in true proportion. Plates, cabinets and the take-up reel are no inputs of the form: they
//! follow the rollers.

use super::slack_loop::SlackLoop;
use super::web::Web;
use crate::drives::reel;
use crate::math;
use crate::view::letters::LETTER_BOX;
use crate::view::scene::{LETTER, LINE};

use super::super::params::Params;

/// Radius of a driven roller for which plates and cabinets have their plain size, mm.
pub(crate) const ROLLER: f64 = 50.0;
/// Radius of the print roller over its heads, mm.
pub(crate) const PRINT_ROLLER: f64 = 60.0;
/// Radius (mm) of a full supply reel up to which all other parts keep at least their plain size.
const REEL: f64 = 224.0;
/// Radii for the plain size, mm: of the core of the take-up reel, which is also the size of hubs, and of that reel at the start.
pub(crate) const CORE: f64 = 34.0;
pub(crate) const TAKE_UP: f64 = 66.0;
/// Greatest take-up reel for the plain size, mm.
const TAKE_UP_FULL: f64 = 84.0;
/// Radius of a pinch roller over that of its driven roller.
pub(crate) const PINCH: f64 = 0.6;
/// Radius of the lens in its own drawing, before scaling.
pub(crate) const LENS: f64 = 80.0;

/// Angle (rad) over which the ribbon is drawn on a reel before it merges with the winding.
const ON_REEL: f64 = 0.9;

/// Pixels of the stage for which the labels are laid out.
const STAGE: (f64, f64) = (770.0, 480.0);
/// Widest value below a name, in letters.
const VALUE: usize = 16;

/// A driven roller with its pinch roller, motor and cabinet.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Station {
    /// The nip.
    pub(crate) x: f64,
    /// Radius of the roller.
    pub(crate) r: f64,
    /// Size of plate, motor and cabinet over the plain one.
    pub(crate) scale: f64,
    /// Top of the cabinet.
    pub(crate) cabinet: f64,
}

/// A reel.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct DrawnReel {
    pub(crate) x: f64,
    pub(crate) y: f64,
    /// Radius at the start of the run.
    pub(crate) r: f64,
    /// Radius of the core.
    pub(crate) core: f64,
    /// Least and greatest radius.
    pub(crate) range: (f64, f64),
}

impl DrawnReel {
    /// Radius after a length of ribbon left (negative) or came.
    pub(crate) fn radius(&self, thickness: f64, length: f64) -> f64 {
        math::clamp(reel::radius_after(self.r, thickness, length), self.range.0, self.range.1)
    }

    /// Turns since the start.
    pub(crate) fn turns(&self, thickness: f64, length: f64) -> f64 {
        reel::turns((self.r, self.radius(thickness, length)), length)
    }
}

/// Positions and sizes, mm.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Layout {
    /// View box.
    pub(crate) view: [f64; 4],
    /// Drawing units per pixel for which the labels are laid out.
    pub(crate) unit: f64,
    /// Scale, relative to the plain size, of parts whose size is no input.
    pub(crate) scale: f64,
    pub(crate) unwinder: Station,
    pub(crate) pull: Station,
    /// Print roller: point of contact, radius over the heads, top of the cabinet.
    pub(crate) print: Station,
    /// Centre and radius of the deflection roller.
    pub(crate) deflector: (f64, f64, f64),
    pub(crate) supply: DrawnReel,
    pub(crate) take_up: DrawnReel,
    pub(crate) slack: SlackLoop,
    /// Depth of the full loop, as drawn.
    pub(crate) full: f64,
    /// Slack of a loop that reaches the floor, mm.
    pub(crate) on_floor: f64,
    pub(crate) floor: f64,
    /// From the near edge to the far edge of a roller.
    pub(crate) depth: (f64, f64),
    /// Thickness of the ribbon as drawn.
    pub(crate) thickness: f64,
    /// Centre and radius of the lens.
    pub(crate) lens: (f64, f64, f64),
    /// Magnification of the lens.
    pub(crate) magnified: f64,
    /// Left ends of the names of unwinder, pull rollers and print roller, and their base line.
    pub(crate) names: ([f64; 3], f64),
    /// Left end of the text of the take-up reel, and its first base line.
    pub(crate) take_up_text: (f64, f64),
}

/// Radius of the core and of the full supply reel, mm; a core that is not smaller carries a thin winding.
fn supply(p: &Params) -> (f64, f64) {
    let core = 0.5 * p.unwinding.core_diameter;
    (core, (0.5 * p.unwinding.reel_diameter).max(1.02 * core))
}

impl Layout {
    /// Layout for names of these numbers of letters above unwinder, pull rollers and print roller, and beside the take-up reel.
    pub(crate) fn new(p: &Params, letters: [usize; 4]) -> Layout {
        let (r1, r2, r3) = (0.5 * p.press_roller_diameter, 0.5 * p.x_roller_diameter, 0.5 * p.print_roller_diameter);
        let scale = (r1.max(r2) / ROLLER).max(r3 / PRINT_ROLLER).max(supply(p).1 / REEL);
        // Labels have their size in pixels, and the view grows with their room.
        let mut layout = Layout::with(p, letters, scale, 1.3 * scale);
        for _ in 0..24 {
            layout = Layout::with(p, letters, scale, layout.fitted());
        }
        Layout::with(p, letters, scale, 1.005 * layout.fitted())
    }

    /// Drawing units per pixel where the view fits the stage.
    fn fitted(&self) -> f64 {
        (self.view[2] / STAGE.0).max(self.view[3] / STAGE.1)
    }

    fn with(p: &Params, letters: [usize; 4], s: f64, unit: f64) -> Layout {
        let station = |x: f64, r: f64| {
            let scale = (r / ROLLER).max(0.45 * s);
            Station { x, r, scale, cabinet: 2.0 * r + 18.0 * scale }
        };
        let line = LINE * LETTER * unit;
        let unwinder = station(0.0, 0.5 * p.press_roller_diameter);
        let radius = 0.5 * p.x_roller_diameter;
        let gap = (160.0 * s).max(120.0 * unit);
        let slack = SlackLoop::new((unwinder.r, radius), gap, p.loop_capacity, 400.0 * s);
        let pull = station(slack.distance, radius);
        let r = 0.5 * p.print_roller_diameter;
        let scale = (r / PRINT_ROLLER).max(0.45 * s);
        let x = pull.x + pull.r.max(40.0 * pull.scale) + 75.0 * s + r.max(42.0 * scale);
        let print = Station { x, r, scale, cabinet: 88.0 * scale };
        let full = slack.depth(p.loop_capacity);
        let low = |station: &Station| station.cabinet + 226.0 * station.scale;
        let (core, wound) = supply(p);
        let floor = [low(&unwinder), low(&pull), low(&print), 300.0 * s, full + 38.0 * s, 2.0 * wound + 38.0 * s];
        let floor = floor.into_iter().fold(0.0, f64::max);
        let width = p.ribbon_width / (20.0 * s);
        let deep = s * math::clamp(0.7 + 0.3 * width, 0.75, 1.4);
        let depth = (26.0 * deep, -16.0 * deep);

        // A small reel gets the room of one of plain size, because names are above it.
        let beside = wound.max(0.5 * REEL * s);
        let supply = DrawnReel {
            x: -unwinder.r.max(50.0 * unwinder.scale) - 16.0 * s - beside,
            y: wound - 6.0 * s,
            r: wound,
            core,
            range: (core, wound),
        };
        let x = print.x + print.r.max(69.0 * print.scale) + 66.0 * s;
        let deflector = (x, 18.0 * s, 18.0 * s);
        let take_up = DrawnReel {
            x: x + 25.0 * s,
            y: 192.0 * s,
            r: TAKE_UP * s,
            core: CORE * s,
            range: (TAKE_UP * s, TAKE_UP_FULL * s),
        };

        // Names are above the machine, except the names of the reels, which are beside the reels.
        let top = |station: &Station| -2.0 * PINCH * station.r - 42.0 * station.scale;
        let plates = top(&unwinder).min(top(&pull)).min(-2.0 * print.r - 16.0 * print.scale);
        let reel_name = -6.0 * s - 44.0 * unit - 2.0 * line;
        let base = (plates - 14.0 * unit).min(reel_name - 8.0 * unit) - 2.0 * line;
        let left = supply.x - beside - 16.0 * s;
        let rho = (LENS * s).max(72.0 * unit);
        let lens_y = -rho - 24.0 * s;
        let lens_x = print.x + print.r.max(50.0 * print.scale) + depth.0 + 30.0 * s + rho;
        let [w1, w2, w3, w4] = letters.map(|letters| letters.max(VALUE) as f64 * LETTER_BOX.width * LETTER * unit);
        let wide = [w1, w2, w3];
        let names = in_row([unwinder.x, pull.x, print.x], wide, (left + 8.0 * unit, lens_x - rho), 10.0 * unit);
        let lens_x = lens_x.max(names[2] + wide[2] + 10.0 * unit + rho);

        let text_y = lens_y + rho + 20.0 * unit;
        let beside = deflector.0 + 18.0 * s + ((text_y + 3.0 * line) / (150.0 * s)).max(0.2) * 76.0 * s + depth.0;
        let text_x = beside + 12.0 * unit;
        let right = [
            lens_x + rho + 10.0 * unit,
            take_up.x + take_up.range.1 + 8.0 * s + depth.0 + 8.0 * unit,
            text_x + w4 + 4.0 * unit,
        ];
        let right = right.into_iter().fold(0.0, f64::max);
        let top = (base - 12.0 * unit).min(lens_y - rho) - 8.0 * unit;
        let view = [left, top, right - left, floor + 62.0 * unit - top];
        let magnified = math::step_at_most(15.0 * rho / LENS / p.contact_length.max(1e-3));
        let thickness = math::clamp(6.0 * p.ribbon_thickness, 1.2 * s, 4.5 * s);
        Layout {
            view,
            unit,
            scale: s,
            unwinder,
            pull,
            print,
            deflector,
            supply,
            take_up,
            slack,
            full,
            on_floor: slack.slack_at_depth(floor - 8.0 * s),
            floor,
            depth,
            thickness,
            lens: (lens_x, lens_y, rho),
            magnified,
            names: (names, base),
            take_up_text: (text_x, text_y),
        }
    }

    /// The ribbon from the supply reel of this radius to the unwinder: the tangent from the nip to the top of the reel.
    pub(crate) fn supply_web(&self, radius: f64) -> Web {
        let DrawnReel { x, y, .. } = self.supply;
        let (dx, dy) = (self.unwinder.x - x, -y);
        let distance = math::hypot(dx, dy).max(radius * 1.001);
        let angle = math::atan2(dy, dx) - math::acos(radius / distance);
        let at = |angle: f64| {
            let (s, c) = math::sin_cos(angle);
            (x + radius * c, y + radius * s)
        };
        let mut web = Web::from(at(angle - ON_REEL));
        web.clockwise(at(angle), radius);
        web.line((self.unwinder.x, 0.0));
        web
    }

    /// The ribbon from the pull rollers to the point of contact with the print roller, and on to the top of the deflection roller.
    pub(crate) fn level_web(&self) -> Web {
        let mut web = Web::from((self.pull.x, 0.0));
        web.line((self.deflector.0, 0.0));
        web
    }

    /// The ribbon from the top of the deflection roller to the take-up reel of this radius.
    pub(crate) fn take_up_web(&self, radius: f64) -> Web {
        let mut web = Web::from((self.deflector.0, 0.0));
        self.to_take_up(&mut web, radius);
        web
    }

    /// The ribbon from the point of contact to the take-up reel of this radius: the way of the dots.
    pub(crate) fn printed_web(&self, radius: f64) -> Web {
        let mut web = Web::from((self.print.x, 0.0));
        web.line((self.deflector.0, 0.0));
        self.to_take_up(&mut web, radius);
        web
    }

    /// Over the deflection roller, and along the tangent that both circles have at their right.
    fn to_take_up(&self, web: &mut Web, radius: f64) {
        let (x, y, r) = self.deflector;
        let (dx, dy) = (self.take_up.x - x, self.take_up.y - y);
        let distance = math::hypot(dx, dy);
        // Direction of both radii: at right angles to the tangent.
        let angle = math::atan2(dy, dx) - math::acos(math::clamp((r - radius) / distance, -1.0, 1.0));
        let at = |x: f64, y: f64, r: f64, angle: f64| {
            let (s, c) = math::sin_cos(angle);
            (x + r * c, y + r * s)
        };
        let DrawnReel { x: to_x, y: to_y, .. } = self.take_up;
        web.clockwise(at(x, y, r, angle), r);
        web.line(at(to_x, to_y, radius, angle));
        web.clockwise(at(to_x, to_y, radius, angle + ON_REEL), radius);
    }
}

/// Left ends of three names in one row, each near its part, none over another; the last ends before `room.1` where that is possible.
fn in_row(parts: [f64; 3], wide: [f64; 3], room: (f64, f64), gap: f64) -> [f64; 3] {
    let mut at = [0.0; 3];
    let mut end = room.1;
    for i in (0..3).rev() {
        at[i] = (parts[i] - 0.75 * wide[i]).min(end - gap - wide[i]);
        end = at[i];
    }
    let mut begin = room.0;
    for i in 0..3 {
        at[i] = at[i].max(begin);
        begin = at[i] + wide[i] + gap;
    }
    at
}
