//! The parts list of the turning spindle, from the headstock to the tailstock.

use super::resolved::TurningSpindle;
use super::scene::{Layout, group};
use crate::machines::driven::FormMotor;
use crate::machines::lathe::slides;
use crate::view::DrawnPart;

/// The motors that the form describes.
pub(super) const MOTORS: &[FormMotor] = &[
    FormMotor {
        drive: "spindle",
        name: "turning.drive.spindle",
        is_on_inverter: true,
        figures: &[
            ("size.figure.rated-power", "motor-power"),
            ("size.figure.rated-speed", "motor-base"),
            ("size.figure.top-speed", "motor-top"),
            ("size.figure.rotor", "rotor-inertia"),
        ],
    },
    slides::MOTORS[0],
    slides::MOTORS[1],
];

/// All parts with their places in the drawing.
pub(super) fn parts(lathe: &TurningSpindle) -> Vec<DrawnPart> {
    let layout = Layout::new(&lathe.params);
    let part = |name: &'static str, group: u16, at: (f64, f64), data: &[(&'static str, &'static str)]| DrawnPart {
        name,
        quantity: 1,
        data: data.to_vec(),
        group,
        at,
    };
    let work = layout.tip(0.28 * lathe.params.stock_diameter, -0.5 * layout.part_length);
    let mut all = vec![
        part(
            "turning.part.headstock",
            0,
            (150.0, 440.0),
            &[("", "motor-power"), ("", "motor-base"), ("", "motor-top")],
        ),
        part("turning.part.gear", 0, (76.0, 380.0), &[("", "gear")]),
        part("turning.part.speed", 0, (30.0, 150.0), &[]),
        part("turning.part.output", 0, (180.0, 150.0), &[("", "output")]),
        part("turning.part.chuck", 0, (layout.chuck.face() - 20.0, 460.0), &[("", "chuck-limit")]),
        part("turning.part.work", 0, work, &[("Ø ", "stock-diameter"), ("L ", "work-length")]),
        part("turning.part.tool", group::TURRET, (14.0, -30.0), &[("T ", "tool"), ("", "edge-angle"), ("", "rake")]),
        part("turning.part.turret", group::TURRET, (78.0, -110.0), &[]),
        part(
            "turning.part.cross",
            group::CROSS_SLIDE,
            (160.0, -28.0),
            &[("", "lead-x"), ("", "rapid-x"), ("", "motor-x")],
        ),
        part("turning.part.bed", 0, (700.0, 518.0), &[("", "lead-z"), ("", "rapid-z"), ("", "motor-z")]),
    ];
    if layout.holds_work {
        all.push(part("turning.part.tailstock", 0, (980.0, 420.0), &[]));
    }
    all
}
