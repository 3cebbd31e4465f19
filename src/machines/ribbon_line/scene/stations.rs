//! Unwinder and pull rollers: plate, cabinet, driven roller with pinch roller, motor with belt, amplifier.

use super::layout::{Layout, PINCH, ROLLER, Station};
use super::parts::group::Station as Part;
use super::parts::node;
use crate::text::number::filled;
use crate::view::drawing::{barrel, polar};
use crate::view::{Anchor, Drawing, Font, Look, Paint, SceneGroup};

/// Depth of cabinets and rollers of the plain size.
pub(crate) const DEEP: (f64, f64) = (26.0, -16.0);

/// A box with its front, top and right side, in front of its group: left, top, width, height.
pub(crate) fn cabinet(drawing: &mut Drawing, [x, y, w, h]: [f64; 4], front: Paint, top: Paint, side: Paint) {
    let (dx, dy) = DEEP;
    drawing.path(filled("M# #l# #h#l# #z", &[x, y, dx, dy, w, -dx, -dy]), Look::fill(top));
    drawing.path(filled("M# #l# #v#l# #z", &[x + w, y, dx, dy, h, -dx, -dy]), Look::fill(side));
    drawing.rect([x, y, w, h, 0.0], Look::fill(front));
    drawing.path(filled("M# #V#h#", &[x + 1.0, y + h - 2.0, y + 1.0, w - 2.0]), Look::RIM.faint(0.6));
}

/// Plate behind the rollers with rounded upper corners, in front of its group.
pub(crate) fn plate(drawing: &mut Drawing, x: f64, w: f64, top: f64, bottom: f64) {
    let d = "M# #q0 -12 12 -12h#q12 0 12 12V#H#z";
    drawing.path(filled(d, &[x, top + 12.0, w - 24.0, bottom, x]), Look::fill(Paint::DarkFront));
    drawing.path(filled("M# #q0 -18 14 -18", &[x + 1.5, top + 20.0]), Look::RIM.faint(0.7));
}

/// Door, handle, name plate and feet of a cabinet `h` high, whose front is from -42 to 36.
pub(crate) fn door(drawing: &mut Drawing, h: f64, letter: &str) {
    let joint = Look::HAIR.faint(0.45);
    drawing.rect([-34.0, 8.0, 62.0, h - 18.0, 2.0], joint);
    drawing.path(filled("M-34 #h62", &[0.55 * h]), joint);
    drawing.rect([19.0, 0.6 * h, 4.0, 24.0, 2.0], Look::fill(Paint::DarkFront).thin(Paint::Edge, 0.5));
    drawing.rect([-30.0, 107.0, 24.0, 13.0, 1.5], Look::fill(Paint::SteelLight).thin(Paint::Edge, 0.5));
    drawing.text((-18.0, 117.2), Anchor::Middle, letter, Font::Engraved(10.0), Paint::Dark);
    drawing.rect([-42.0, h - 4.0, 78.0, 4.0, 0.0], Look::fill(Paint::DarkShade));
}

/// The kind of drive in the cabinet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum DriveKind {
    /// Inverter and induction motor.
    Inverter,
    /// Servo amplifier and servo motor.
    Servo,
}

/// Parts drawn behind the ribbon: plate, cabinet, bodies of the rollers.
pub(crate) fn behind(drawing: &mut Drawing, layout: &Layout, station: &Station, first: u16, letter: &str) {
    let Station { x, r, scale, cabinet: top } = *station;
    drawing.place(Part::Plate.of(first), SceneGroup { at: (x, 0.0), scale, ..SceneGroup::default() });
    drawing.place(Part::Cabinet.of(first), SceneGroup { at: (x, top), scale, ..SceneGroup::default() });
    drawing.within(Part::Plate.of(first), |drawing| {
        plate(drawing, -14.0, 80.0, -2.0 * PINCH * r / scale - 42.0, top / scale + 32.0);
    });
    let h = (layout.floor - top) / scale;
    drawing.within(Part::Cabinet.of(first), |drawing| {
        cabinet(drawing, [-42.0, 0.0, 78.0, h], Paint::CabinetFront, Paint::SteelLight, Paint::SteelShade);
        door(drawing, h, letter);
    });
    drawing.path(barrel((x, r), r, layout.depth), Look::fill(Paint::SteelBody));
}

/// Parts drawn in front of the ribbon: belt, motor, drive, rollers.
pub(crate) fn before(drawing: &mut Drawing, layout: &Layout, station: &Station, first: u16, drive: DriveKind) {
    let fields = match drive {
        DriveKind::Inverter => ["reduction-ratio", "speed-at-10v", "press-roller-diameter"],
        DriveKind::Servo => ["gear-x", "encoder-resolution-x", "x-roller-diameter"],
    };
    belt(drawing, station, drive);
    drawing.showing(fields[0], |drawing| motor(drawing, station, first, drive));
    drawing.showing(fields[1], |drawing| amplifier(drawing, first, drive));
    drawing.showing(fields[2], |drawing| driven(drawing, station, first));
    pinch(drawing, layout, station, first);
}

/// Centre of the motor in front of its cabinet.
fn motor_at(drive: DriveKind) -> (f64, f64) {
    match drive {
        DriveKind::Inverter => (-3.0, 70.0),
        DriveKind::Servo => (0.0, 72.0),
    }
}

fn belt(drawing: &mut Drawing, station: &Station, drive: DriveKind) {
    let Station { x, r, scale, cabinet } = *station;
    let (mx, my) = motor_at(drive);
    let (mx, my) = (x + mx * scale, cabinet + my * scale);
    let (above, below) = (0.44 * r, 16.0 * scale);
    let d = filled("M# #L# #M# #L# #", &[x - above, r, mx - below, my, mx + below, my, x + above, r]);
    drawing.path(d.clone(), Look::line(Paint::DarkShade, 4.0 * scale));
    let teeth = Look::line(Paint::DarkLight, 1.4 * scale).dashed(2.0 * scale, 4.0 * scale);
    drawing.path(d, teeth).id = Some(node::BELTS[usize::from(drive == DriveKind::Servo)]);
}

fn motor(drawing: &mut Drawing, station: &Station, first: u16, drive: DriveKind) {
    let Station { x, scale, cabinet, .. } = *station;
    let (mx, my) = motor_at(drive);
    let at = (x + mx * scale, cabinet + my * scale);
    drawing.place(Part::Motor.of(first), SceneGroup { at, scale, ..SceneGroup::default() });
    drawing.place(Part::Pulley.of(first), SceneGroup { parent: Part::Motor.of(first), ..SceneGroup::default() });
    drawing.within(Part::Motor.of(first), |drawing| match drive {
        DriveKind::Inverter => {
            drawing.path(barrel((0.0, 0.0), 31.0, (11.0, -6.8)), Look::fill(Paint::DarkShade));
            drawing.circle((0.0, 0.0, 31.0), Look::DARK_FACE);
            // Fins.
            drawing.circle((0.0, 0.0, 26.5), Look::line(Paint::DarkLight, 7.0).dashed(2.0, 3.55));
            drawing.path("M-26 -16A30 30 0 0 1 -8 -29", Look::RIM);
        }
        DriveKind::Servo => {
            drawing.path("M-30 -30L-19 -36.800H41V23L30 30z", Look::fill(Paint::DarkShade));
            drawing.rect([-30.0, -30.0, 60.0, 60.0, 7.0], Look::fill(Paint::DarkFront).thin(Paint::Edge, 1.0));
            for (x, y) in [(-22.0, -22.0), (22.0, -22.0), (-22.0, 22.0), (22.0, 22.0)] {
                drawing.circle((x, y, 3.2), Look::fill(Paint::DarkShade).thin(Paint::Rim, 0.5));
            }
            drawing.path("M-28 -20q0 -8 8 -8h20", Look::RIM);
        }
    });
    drawing.within(Part::Pulley.of(first), |drawing| {
        drawing.circle((0.0, 0.0, 17.0), Look::FACE);
        drawing.circle((0.0, 0.0, 10.5), Look::HOLE);
        drawing.circle((0.0, 0.0, 5.0), Look::FACE);
        drawing.path("M0 -16v8.500", Look::line(Paint::Edge, 2.0));
    });
}

/// Inverter or servo amplifier on the door: display, lamp, cooling slots.
fn amplifier(drawing: &mut Drawing, first: u16, drive: DriveKind) {
    drawing.within(Part::Cabinet.of(first), |drawing| {
        let (x, y) = (-25.0, 128.0);
        drawing.rect([x, y, 40.0, 62.0, 4.0], Look::fill(Paint::DarkFront).thin(Paint::Edge, 0.8));
        drawing.path(filled("M# #v-58q0 -2 2 -2h18", &[x + 1.2, y + 61.0]), Look::RIM.faint(0.4));
        drawing.rect([x + 5.0, y + 5.0, 30.0, 18.0, 2.0], Look::fill(Paint::Black));
        let trace = match drive {
            DriveKind::Inverter => "M# #l4 -9 4 9 4 -9 4 9 4 -9 4 9",
            DriveKind::Servo => "M# #h5v-3h5v-3h5v-3h5v-2h5",
        };
        drawing.path(filled(trace, &[x + 8.0, y + 18.5]), Look::line(Paint::Accent, 1.5).round());
        let lamp = node::LAMPS[usize::from(drive == DriveKind::Servo)];
        drawing.circle((x + 31.0, y + 29.5, 2.2), Look::fill(Paint::DarkShade).thin(Paint::Rim, 0.5)).id = Some(lamp);
        let slots = filled("M# #h29M# #h29M# #h29M# #h29", &slot_ends(x + 5.5, y + 38.0));
        drawing.path(slots, Look::line(Paint::DarkShade, 1.8).round());
    });
}

fn slot_ends(x: f64, y: f64) -> Vec<f64> {
    (0..4).flat_map(|slot| [x, y + 5.5 * f64::from(slot)]).collect()
}

/// The face of the driven roller, drawn with a radius of 50.
fn driven(drawing: &mut Drawing, station: &Station, first: u16) {
    let Station { x, r, .. } = *station;
    let (frame, marks, blur) = (Part::Roller.of(first), Part::Marks.of(first), Part::Blur.of(first));
    drawing.place(frame, SceneGroup { at: (x, r), scale: r / ROLLER, ..SceneGroup::default() });
    for group in [marks, blur] {
        drawing.place(group, SceneGroup { parent: frame, ..SceneGroup::default() });
    }
    drawing.within(frame, |drawing| {
        drawing.circle((0.0, 0.0, ROLLER), Look::FACE);
        drawing.circle((0.0, 0.0, 44.0), Look::HAIR.faint(0.35));
    });
    drawing.within_hidden(blur, |drawing| {
        drawing.circle((0.0, 0.0, 29.0), Look::line(Paint::Dark, 14.0).faint(0.6));
    });
    drawing.within(marks, |drawing| {
        for hole in 0..5 {
            let (x, y) = polar((0.0, 0.0), 72.0 * f64::from(hole) - 90.0, 30.0);
            drawing.circle((x, y, 7.0), Look::HOLE);
        }
    });
    drawing.within(frame, |drawing| {
        drawing.path("M-46 -15A48 48 0 0 1 0 -48", Look::RIM);
        drawing.circle((0.0, 0.0, 21.0), Look::DARK_FACE);
    });
    drawing.within(marks, |drawing| {
        drawing.circle((0.0, 0.0, 8.5), Look::FACE);
        drawing.path("M0 -19.500v9", Look::line(Paint::Rim, 2.4).round());
    });
}

/// Pinch roller with its cylinder, and the arrows of the nip.
fn pinch(drawing: &mut Drawing, layout: &Layout, station: &Station, first: u16) {
    let Station { x, r, scale, .. } = *station;
    let small = PINCH * r;
    let (frame, marks) = (Part::Pinch.of(first), Part::PinchMarks.of(first));
    drawing.place(frame, SceneGroup { at: (x, -small), scale: small / 30.0, ..SceneGroup::default() });
    drawing.place(marks, SceneGroup { parent: frame, ..SceneGroup::default() });
    drawing.path(barrel((x, -small), small, layout.depth), Look::fill(Paint::SteelBody));
    // Cylinder and its rod, of the size of the plate.
    drawing.within(Part::Plate.of(first), |drawing| {
        let (top, foot) = (-2.0 * small / scale - 38.0, -small / scale);
        drawing.rect([-11.0, top, 22.0, 34.0, 4.0], Look::fill(Paint::DarkFace).thin(Paint::Edge, 0.8));
        drawing.path(filled("M-7 #v26", &[top + 4.0]), Look::RIM.faint(0.8));
        drawing.rect([-4.0, top + 34.0, 8.0, foot - top - 34.0, 0.0], Look::fill(Paint::Steel));
    });
    drawing.within(frame, |drawing| {
        drawing.circle((0.0, 0.0, 30.0), Look::FACE);
        drawing.circle((0.0, 0.0, 25.0), Look::HAIR.faint(0.3));
        drawing.path("M-27 -9A28.500 28.500 0 0 1 -4 -28", Look::RIM);
    });
    drawing.within(marks, |drawing| {
        for hole in 0..4 {
            let (x, y) = polar((0.0, 0.0), 90.0 * f64::from(hole), 20.0);
            drawing.circle((x, y, 3.2), Look::HOLE);
        }
        drawing.circle((0.0, 0.0, 13.0), Look::DARK_FACE);
        drawing.circle((0.0, 0.0, 5.5), Look::FACE);
        drawing.path("M0 -12v6", Look::line(Paint::Rim, 1.8).round());
    });
    drawing.within(Part::Plate.of(first), |drawing| {
        let (above, below) = (-2.0 * small / scale - 44.0, 2.0 * r / scale + 4.0);
        drawing.path(
            filled("M0 #v16m-5 -7 5 7 5 -7M0 #v-12m-5 7 5 -7 5 7", &[above - 18.0, below + 12.0]),
            Look::hair(Paint::Accent, 2.0).round(),
        );
    });
}
