//! Findings about the cut: diameters, passes and start position compared with the stock, and a falling cone compared with the insert.

use crate::machines::form::entry::at_least;
use crate::machines::lathe::turret::{self, SlideStart, StockEnd};
use crate::machines::turning_spindle::derive::PASSES;
use crate::machines::turning_spindle::params::{FIELDS, Params, Path};
use crate::math;
use crate::msg;
use crate::text::Diagnostic;

/// Finished diameters and start position against the stock, and the number of passes.
pub(super) fn check_diameters(p: &Params, found: &mut Vec<Diagnostic>) {
    let largest = if p.path == Path::Taper { p.finished_diameter.max(p.large_diameter) } else { p.finished_diameter };
    let field = if p.path == Path::Taper && p.large_diameter > p.finished_diameter {
        "large-diameter"
    } else {
        "finished-diameter"
    };
    if largest >= p.stock_diameter {
        let message = msg!("turning.nothing-to-cut", diameter = (largest, 3), stock = (p.stock_diameter, 3));
        found.push(Diagnostic::error(message).about(field));
    }
    if p.path == Path::Turning && p.finished_diameter <= 0.0 || largest <= 0.0 && p.path == Path::Taper {
        found.push(Diagnostic::error(msg!("turning.nothing-left")).about("finished-diameter"));
    } else if p.tailstock && p.finished_diameter <= 0.0 {
        found.push(Diagnostic::error(msg!("turning.cone-in-tailstock")).about("finished-diameter"));
    }
    if p.passes() >= PASSES {
        found.push(Diagnostic::error(msg!("turning.too-many-passes", count = PASSES)).about("depth"));
    }
    if p.cut_length() > p.reach() {
        let field = if p.path == Path::Facing { "allowance" } else { "length" };
        found.push(
            Diagnostic::error(msg!("turning.cut-in-chuck", end = (p.cut_length(), 3), reach = (p.reach(), 3)))
                .about(field),
        );
    }
    found.extend(falling_cone(p));
    let end = if p.path == Path::Facing { p.allowance } else { 0.0 };
    let stock = StockEnd { diameter: p.stock_diameter, z: end };
    found.extend(if p.tailstock {
        turret::hits_tailstock(p.start_x, p.stock_diameter, p.turret_room)
    } else {
        turret::hits_work(SlideStart { x: p.start_x, z: p.start_z }, stock, p.turret_room)
    });
    if p.start_x <= p.stock_diameter + 2.0 * p.clearance {
        let least = p.stock_diameter + 2.0 * p.clearance;
        found.push(
            Diagnostic::error(msg!("turning.start-in-stock", start = (p.start_x, 3), least = (least, 3)))
                .about("start-x")
                .mended_by(least.floor() + 2.0),
        );
    }
}

/// Point angles (°) of inserts: the slimmest and the stoutest that turn outlines, V and C of ISO 1832. Source: memory.
const INSERTS: (f64, f64) = (35.0, 80.0);

/// Judges a cone that falls towards the chuck against the trailing edge of the insert, which clears an angle of
/// `180° - κ - ε`, with the edge angle κ and the point angle ε of the insert. An error, with a sufficient length, if
/// even the slimmest insert does not clear the cone.
fn falling_cone(p: &Params) -> Option<Diagnostic> {
    let depth = 0.5 * (p.finished_diameter - p.large_diameter);
    if p.path != Path::Taper || depth <= 0.0 {
        return None;
    }
    let (slim, stout) = INSERTS;
    let fall = math::atan2_degrees(depth, p.length);
    let clear = 180.0 - p.edge_angle;
    let angle = (fall, 1);
    let edge = (p.edge_angle, 1);
    if fall > clear - slim {
        let most = ((clear - slim).max(0.0), 1);
        let message = msg!("turning.cone-falls-too-steep", angle, edge, slim = (slim, 0), most);
        let found = Diagnostic::error(message).about("length");
        let slope = math::tan_degrees(clear - slim).filter(|slope| *slope > 0.0);
        let longer =
            slope.map(|slope| at_least(FIELDS, "length", depth / slope).value).filter(|length| *length <= p.reach());
        return Some(longer.into_iter().fold(found, Diagnostic::mended_by));
    }
    let message =
        msg!("turning.cone-needs-slim-insert", angle, edge, stout = (stout, 0), most = ((clear - fall).floor(), 0));
    (fall > clear - stout).then(|| Diagnostic::warning(message).about("length"))
}
