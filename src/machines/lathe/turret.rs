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

/// Start point of the slide, mm.
#[derive(Debug, Clone, Copy)]
pub(in crate::machines) struct SlideStart {
    /// As a diameter.
    pub x: f64,
    pub z: f64,
}

/// The stock in front of the jaws, mm.
#[derive(Debug, Clone, Copy)]
pub(in crate::machines) struct StockEnd {
    pub diameter: f64,
    /// Z of its face.
    pub z: f64,
}

/// Error of a turret that turns into the work: at `start` its other tools reach `room` (mm) beyond the tip of the tool.
/// `None` if the turret has room beside the stock or in front of it.
pub(in crate::machines) fn hits_work(start: SlideStart, stock: StockEnd, room: f64) -> Option<Diagnostic> {
    let hits = start.x < beside(stock.diameter, room) && start.z < stock.z + room;
    let message = msg!("lathe.turret-hits-work", x = (start.x, 3), z = (start.z, 3), room = (room, 1));
    hits.then(|| Diagnostic::error(message).about("start-z").mended_by((stock.z + room).ceil()))
}
