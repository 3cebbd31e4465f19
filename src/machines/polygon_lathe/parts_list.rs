//! The parts list of the polygon lathe: work with its drive, cutters with theirs, slides.

use super::main_spindle;
use super::resolved::PolygonLathe;
use super::scene::{Layout, group};
use crate::machines::driven::FormMotor;
use crate::machines::lathe::slides;
use crate::view::DrawnPart;

/// The motors that the form describes.
pub(super) const MOTORS: &[FormMotor] = &[
    FormMotor {
        drive: "work",
        name: "polygon.drive.work",
        is_on_inverter: false,
        figures: &[
            ("size.figure.rated-power", "work-power"),
            ("size.figure.rated-speed", "work-base"),
            ("size.figure.top-speed", "work-top"),
        ],
    },
    FormMotor {
        drive: "tool",
        name: "polygon.drive.tool",
        is_on_inverter: false,
        figures: &[
            ("size.figure.rated-power", "tool-power"),
            ("size.figure.rated-speed", "tool-base"),
            ("size.figure.top-speed", "tool-top"),
        ],
    },
    FormMotor {
        drive: "main",
        name: main_spindle::NAME,
        is_on_inverter: true,
        figures: &[
            ("size.figure.rated-power", "main-power"),
            ("size.figure.rated-speed", "main-base"),
            ("size.figure.top-speed", "main-motor-top"),
            ("size.figure.rotor", "main-rotor"),
        ],
    },
    slides::MOTORS[0],
    slides::MOTORS[1],
];

/// All parts with their places in the drawing.
pub(super) fn parts(lathe: &PolygonLathe) -> Vec<DrawnPart> {
    let layout = Layout::new(lathe);
    let part = |name: &'static str, group: u16, at: (f64, f64), data: &[(&'static str, &'static str)]| DrawnPart {
        name,
        quantity: 1,
        data: data.to_vec(),
        group,
        at,
    };
    let (chuck, stock) = (layout.chuck, 0.5 * lathe.params.stock_diameter * layout.scale);
    let mut cutters: Vec<f64> = Vec::new();
    for polygon in lathe.polygons().filter(|polygon| polygon.params.tool != lathe.params.tool) {
        if !cutters.contains(&polygon.params.tool) {
            cutters.push(polygon.params.tool);
        }
    }
    let r = lathe.params.tip_radius * layout.scale;
    let body = (lathe.params.tip_radius - lathe.params.overhang).max(0.0) * layout.scale;
    let mut parts = vec![
        part(
            "polygon.part.headstock",
            0,
            (layout.work.0 - 0.7 * chuck, layout.work.1 + chuck + 22.0),
            &[("", "work-power"), ("", "work-base"), ("", "work-limit")],
        ),
        part("polygon.part.chuck", 0, (layout.work.0 - 0.8 * chuck, layout.work.1), &[]),
        part(
            "polygon.part.work",
            0,
            (layout.work.0 - 0.3 * stock, layout.work.1 + 0.3 * stock),
            &[("Ø ", "stock-diameter"), ("AF ", "across-flats"), ("L ", "length")],
        ),
        DrawnPart {
            quantity: 1 + cutters.len() as u32,
            ..part(
                "polygon.part.cutter",
                group::DISC,
                (0.3 * body, 0.4 * body),
                &[("r ", "tip-radius"), ("h ", "overhang")],
            )
        },
        DrawnPart {
            quantity: lathe.params.inserts as u32,
            ..part("polygon.part.insert", group::INSERTS, (-0.95 * r, 0.0), &[("", "insert-width"), ("", "relief")])
        },
        part(
            "polygon.part.tool-drive",
            group::DISC,
            (0.0, 150.0),
            &[("", "tool-power"), ("", "tool-base"), ("", "tool-limit")],
        ),
        part("polygon.part.cross", 0, (layout.cutter.0, 542.0), &[("", "lead-x"), ("", "rapid-x"), ("", "motor-x")]),
        part("polygon.part.along", group::SIDE, (0.0, 88.0), &[("", "lead-z"), ("", "rapid-z"), ("", "motor-z")]),
    ];
    if lathe.has_main_spindle() {
        let data = [("", "main-power"), ("", "main-base"), ("", "main-motor-top")];
        parts.insert(1, part("polygon.part.main-motor", 0, layout.main_motor(), &data));
    }
    parts
}
