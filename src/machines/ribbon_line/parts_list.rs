//! The parts list of the ribbon line, along the ribbon.

use super::resolved::RibbonLine;
use super::scene::layout::Station;
use super::scene::parts::group;
use crate::machines::driven::FormMotor;
use crate::view::DrawnPart;

/// The motors that the form describes.
pub(super) const MOTORS: &[FormMotor] = &[
    FormMotor {
        drive: "x",
        name: "ribbon.drive.pull",
        is_on_inverter: false,
        figures: &[
            ("size.figure.stall-torque", "motor-stall-x"),
            ("size.figure.peak-torque", "motor-peak-x"),
            ("size.figure.rotor", "motor-rotor-x"),
            ("size.figure.rated-speed", "motor-rated-x"),
        ],
    },
    FormMotor {
        drive: "y",
        name: "ribbon.drive.print",
        is_on_inverter: false,
        figures: &[
            ("size.figure.stall-torque", "motor-stall-y"),
            ("size.figure.peak-torque", "motor-peak-y"),
            ("size.figure.rotor", "motor-rotor-y"),
            ("size.figure.rated-speed", "motor-rated-y"),
        ],
    },
    FormMotor {
        drive: "unwinder",
        name: "ribbon.drive.unwinder",
        is_on_inverter: true,
        figures: &[("size.figure.rated-torque", "unwinder-torque-rated")],
    },
];

/// All parts with their places in the drawing.
pub(super) fn parts(line: &RibbonLine) -> Vec<DrawnPart> {
    let layout = line.layout();
    let part = |name: &'static str, at: (f64, f64), data: &[(&'static str, &'static str)]| DrawnPart {
        name,
        quantity: 1,
        data: data.to_vec(),
        group: 0,
        at,
    };
    let door = |station: &Station, x: f64, y: f64| (station.x + x * station.scale, station.cabinet + y * station.scale);
    let (supply, take_up, print) = (&layout.supply, &layout.take_up, &layout.print);
    let hangs = 0.5 * (layout.unwinder.x + layout.unwinder.r + layout.pull.x - layout.pull.r);
    let heads = DrawnPart {
        quantity: line.params.heads as u32,
        ..part("ribbon.part.head", (print.x + 0.7 * print.r, -1.7 * print.r), &[("", "head-mass"), ("", "head-length")])
    };
    let dancer = DrawnPart { group: group::DANCER, ..part("ribbon.part.dancer", (0.0, 0.0), &[("", "loop-capacity")]) };
    let to_the_loop = [
        part(
            "ribbon.part.supply",
            (supply.x - 0.55 * supply.r, supply.y + 0.4 * supply.r),
            &[("Ø ", "reel-diameter"), ("", "ribbon-thickness"), ("× ", "ribbon-width")],
        ),
        part(
            "ribbon.part.unwinder",
            (layout.unwinder.x, layout.unwinder.r),
            &[("Ø ", "press-roller-diameter"), ("", "reduction-ratio")],
        ),
        part(
            "ribbon.part.motor",
            door(&layout.unwinder, -3.0, 70.0),
            &[("", "unwinder-motor"), ("", "unwinder-torque-rated"), ("", "no-load-speed")],
        ),
        part(
            "ribbon.part.inverter",
            door(&layout.unwinder, -5.0, 165.0),
            &[("", "frequency-at-10v"), ("", "inverter-ramp")],
        ),
        part("ribbon.part.loop", (hangs, layout.full), &[("", "loop-capacity")]),
    ];
    let from_the_nip = [
        part(
            "ribbon.part.pull",
            (layout.pull.x, layout.pull.r),
            &[("Ø ", "x-roller-diameter"), ("× ", "x-roller-length"), ("", "gear-x")],
        ),
        part(
            "ribbon.part.servo",
            door(&layout.pull, 0.0, 72.0),
            &[("", "motor-x"), ("", "motor-stall-x"), ("", "motor-max-x")],
        ),
        part("ribbon.part.amplifier", door(&layout.pull, -5.0, 165.0), &[]),
        part(
            "ribbon.part.print",
            (print.x, -print.r),
            &[("Ø ", "print-roller-diameter"), ("× ", "print-roller-length"), ("", "gear-y")],
        ),
        heads,
        part("ribbon.part.anvil", (print.x, 40.0 * print.scale), &[("", "contact-length")]),
        part(
            "ribbon.part.print-servo",
            door(print, 0.0, 90.0),
            &[("", "motor-y"), ("", "motor-stall-y"), ("", "motor-max-y")],
        ),
        part("ribbon.part.deflector", (layout.deflector.0, layout.deflector.1), &[]),
        part("ribbon.part.take-up", (take_up.x - 0.4 * take_up.r, take_up.y + 0.3 * take_up.r), &[]),
    ];
    // The dancer lies in the loop.
    to_the_loop.into_iter().chain(line.params.is_regulated().then_some(dancer)).chain(from_the_nip).collect()
}
