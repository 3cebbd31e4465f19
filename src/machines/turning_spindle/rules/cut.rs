//! Findings about the cut: diameters, passes and start position compared with the stock, and a cone compared with edge and insert.

use crate::machines::form::entry::{at_least, at_most};
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
    } else {
        found.extend(leading_edge(p));
    }
    found.extend(rising_cone(p));
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

/// Error of an edge that cuts into the chuck ahead of its tip, with the greatest length that keeps it out.
fn leading_edge(p: &Params) -> Option<Diagnostic> {
    let (edge, lead, reach) = ((p.edge_angle, 1), (p.edge_lead(), 3), (p.reach(), 3));
    let message = msg!("turning.edge-in-chuck", edge, lead, end = (p.length + p.edge_lead(), 3), reach);
    let found = || Diagnostic::error(message).about("length");
    let set = at_most(FIELDS, "length", p.cut_reach());
    let shorter = (set.value <= p.cut_reach()).then_some(set.value);
    let cuts_chuck = p.path != Path::Facing && p.length > p.cut_reach();
    cuts_chuck.then(|| shorter.into_iter().fold(found(), Diagnostic::mended_by))
}

/// Error of a cone that rises towards the chuck steeper than the edge, which would cut it away behind the tip; with a sufficient length.
fn rising_cone(p: &Params) -> Option<Diagnostic> {
    let depth = 0.5 * (p.large_diameter - p.finished_diameter);
    let slope = math::tan_degrees(p.edge_angle).filter(|slope| p.edge_angle < 90.0 && *slope > 0.0)?;
    if p.path != Path::Taper || depth <= slope * p.length {
        return None;
    }
    let (angle, edge) = ((math::atan2_degrees(depth, p.length), 1), (p.edge_angle, 1));
    let found = Diagnostic::error(msg!("turning.cone-rises-too-steep", angle, edge)).about("length");
    let longer = Some(at_least(FIELDS, "length", depth / slope).value).filter(|length| *length <= p.cut_reach());
    Some(longer.into_iter().fold(found, Diagnostic::mended_by))
}

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
        let longer = slope
            .map(|slope| at_least(FIELDS, "length", depth / slope).value)
            .filter(|length| *length <= p.cut_reach());
        return Some(longer.into_iter().fold(found, Diagnostic::mended_by));
    }
    let message =
        msg!("turning.cone-needs-slim-insert", angle, edge, stout = (stout, 0), most = ((clear - fall).floor(), 0));
    (fall > clear - stout).then(|| Diagnostic::warning(message).about("length"))
}
