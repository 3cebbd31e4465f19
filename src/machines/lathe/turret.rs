//! Room of a lathe's turret to turn at the start point of the slide.

use crate::msg;
use crate::text::Diagnostic;

/// Least start point in X (diameter, mm) at which the turret clears work of this diameter (mm) while it turns: its
/// other tools reach `room` (mm) beyond the tip of the tool.
pub(in crate::machines) fn beside(diameter: f64, room: f64) -> f64 {
    diameter + 2.0 * room
}

/// Error of a turret that turns in front of work held by a tailstock, where the tailstock is.
pub(in crate::machines) fn hits_tailstock(start_x: f64, diameter: f64, room: f64) -> Option<Diagnostic> {
    let least = beside(diameter, room);
    let message = msg!("lathe.turret-hits-tailstock", x = (start_x, 3), least = (least, 3));
    (start_x < least).then(|| Diagnostic::error(message).about("start-x").mended_by(least.ceil()))
}

/// Error of a turret that turns into the work: at `start` (X as a diameter, and Z, mm) its other tools reach `room`
/// (mm) beyond the tip of the tool; the stock has this diameter (mm) and ends at this Z (mm). `None` if the turret has
/// room beside the work or in front of it.
pub(in crate::machines) fn hits_work(start: (f64, f64), (diameter, end): (f64, f64), room: f64) -> Option<Diagnostic> {
    let (x, z) = start;
    let hits = x < beside(diameter, room) && z < end + room;
    let message = msg!("lathe.turret-hits-work", x = (x, 3), z = (z, 3), room = (room, 1));
    hits.then(|| Diagnostic::error(message).about("start-z").mended_by((end + room).ceil()))
}
