//! The results of the polygon lathe as rows: label, unit, formula, source.

use super::axes::PolygonAxis;
use super::citations::{OURS, PAPER, RUN_IN, RUN_OUT};
use super::demand::DemandKind;
use super::main_spindle;
use super::resolved::PolygonLathe;
use crate::machines::driven::scaling;
use crate::machines::verdict::ReadoutRow;
use crate::text::{Citation, Grade};

const CUTTING: Citation = Citation::new("polygon turning facts 3.9", Grade::Inferred);
const GEOMETRY: Citation =
    Citation::new("polygon turning facts 3, derived and checked by two methods", Grade::Inferred);
const MECHANICS: Citation = Citation::new("mechanics", Grade::Inferred);
const BENDING: Citation = Citation::new("polygon turning facts 3.13", Grade::Open);
const OUTPUT: Citation = Citation::new("turning spindle facts, 1", Grade::Inferred);
const MAIN_TORQUE: Citation = Citation::new("turning spindle facts, 4", Grade::Inferred);
const RUN_UP: Citation = Citation::new("turning spindle facts, 5", Grade::Inferred);
const INERTIA: Citation = Citation::new("sizing facts 2.1", Grade::Inferred);
const COASTING: Citation = Citation::new("sizing facts 2.2", Grade::Inferred);

const SCALING: Citation = Citation::new("ribbon line facts, 10", Grade::Inferred);

macro_rules! row {
    ($id:literal, $label:literal, $unit:literal, $decimals:literal, $headline:literal, $formula:literal, $cite:ident, $value:expr $(, $shown:expr)?) => {
        ReadoutRow {
            id: $id,
            label: $label,
            unit: $unit,
            decimals: $decimals,
            formula: $formula,
            cite: $cite,
            headline: $headline,
            value: $value,
            $(shown: $shown,)?
            ..ReadoutRow::BASE
        }
    };
}

/// Whether the inserts cut flats.
fn cuts(lathe: &PolygonLathe) -> bool {
    lathe.derived.cuts
}

/// Whether a cutting force is known for the flats.
fn cuts_by_force(lathe: &PolygonLathe) -> bool {
    lathe.derived.cuts && lathe.params.specific().unit_force > 0.0
}

/// Whether the sides of the flats differ.
fn cuts_unevenly(lathe: &PolygonLathe) -> bool {
    lathe.derived.cuts && !lathe.derived.section.even
}

/// Whether a polygon has passes before its last one.
fn roughs(lathe: &PolygonLathe) -> bool {
    lathe.derived.cuts && lathe.polygons().any(|lathe| lathe.sizes.len() > 1)
}

/// Whether each corner has one opposite it: an even number of sides.
fn cuts_opposite_corners(lathe: &PolygonLathe) -> bool {
    lathe.derived.cuts && lathe.derived.section.sides % 2.0 == 0.0
}

/// Whether each flat has a corner opposite it: an odd number of sides.
fn cuts_opposite_flats_to_corners(lathe: &PolygonLathe) -> bool {
    lathe.derived.cuts && !cuts_opposite_corners(lathe)
}

/// Whether the path of an insert is an ellipse.
fn cuts_on_an_ellipse(lathe: &PolygonLathe) -> bool {
    lathe.derived.cuts && lathe.derived.speeds.ratio == 2.0
}

/// Whether the flats are twisted along the work.
fn cuts_a_twist(lathe: &PolygonLathe) -> bool {
    lathe.derived.cuts && lathe.params.lead != 0.0
}

/// Rows in the order they are shown; the headline ones first.
#[rustfmt::skip]
pub(super) const ROWS: &[ReadoutRow<PolygonLathe>] = &[
    row!("sides", "polygon.readout.sides", "", 0, true, "N = n |Q| / gcd(n, D), in lowest terms", GEOMETRY, |lathe| lathe.derived.section.sides, cuts),
    row!("flatness", "polygon.readout.flatness", "mm", 4, true, "highest less lowest point of a side", GEOMETRY, |lathe| lathe.derived.section.flatness, cuts),
    row!("across-flats", "polygon.readout.across-flats", "mm", 3, true, "2 (a - r), over the highest points", GEOMETRY, |lathe| lathe.derived.section.across_flats, cuts),
    row!("relief", "polygon.readout.relief", "°", 2, true, "atan[a sin σ / (a cos σ + (k - 1) r)], of all passes, each up to the corners that it meets", GEOMETRY, |lathe| lathe.derived.inserts.relief, cuts),
    row!("tool-speed", "polygon.readout.tool-speed", "r/min", 0, true, "B · Q", PAPER, |lathe| lathe.derived.speeds.tool),
    row!("orientation", "polygon.readout.orientation", "°", 3, true, "E/k - A", GEOMETRY, |lathe| lathe.derived.angles.orientation, cuts),
    row!("work-speed", "polygon.readout.work-speed", "r/min", 0, false, "B · D", PAPER, |lathe| lathe.derived.speeds.work),
    row!("ratio", "polygon.readout.ratio", "", 4, false, "k = Q / D", PAPER, |lathe| lathe.derived.speeds.ratio),
    row!("curvature", "polygon.readout.curvature", "1/mm", 6, false, "[a - r (k - 1)²] / [a + r (k - 1)]²", GEOMETRY, |lathe| lathe.derived.section.curvature, cuts),
    row!("deviation-low", "polygon.readout.deviation-low", "mm", 4, false, "lowest point of the sides", GEOMETRY, |lathe| lathe.derived.section.deviation.0, cuts),
    row!("deviation-high", "polygon.readout.deviation-high", "mm", 4, false, "highest point of the sides", GEOMETRY, |lathe| lathe.derived.section.deviation.1, cuts),
    row!("corner", "polygon.readout.corner", "mm", 3, false, "distance of the corners from the centre", GEOMETRY, |lathe| lathe.derived.section.corner, cuts),
    row!("across-corners", "polygon.readout.across-corners", "mm", 3, false, "over opposite corners", GEOMETRY, |lathe| lathe.derived.section.across_corners, cuts_opposite_corners),
    row!("flat-to-corner", "polygon.readout.flat-to-corner", "mm", 3, false, "from a flat to the corner opposite it, as a caliper measures", GEOMETRY, |lathe| 0.5 * lathe.derived.section.across_flats + lathe.derived.section.corner, cuts_opposite_flats_to_corners),
    row!("area", "polygon.readout.area", "mm²", 2, false, "½ ∫ ρ² dφ", GEOMETRY, |lathe| lathe.derived.section.area, cuts),
    row!("slowest-cut", "polygon.readout.slowest-cut", "m/min", 1, false, "2 π n √[a² + m² + 2 a m cos σ] / 1000, m = (k - 1) r, of all passes", GEOMETRY, |lathe| lathe.derived.inserts.slowest_cut, cuts),
    row!("fastest-cut", "polygon.readout.fastest-cut", "m/min", 1, false, "2 π n √[a² + m² + 2 a m cos σ] / 1000, m = (k - 1) r, of all passes", GEOMETRY, |lathe| lathe.derived.inserts.fastest_cut, cuts),
    row!("end-fastest-cut", "polygon.readout.end-fastest-cut", "m/min", 1, false, "π d n / 1000, d the stock of the end", MECHANICS, |lathe| lathe.params.fastest_end_cut(), PolygonLathe::has_main_spindle),
    row!("distance", "polygon.readout.distance", "mm", 3, false, "a = AF/2 + r", GEOMETRY, |lathe| lathe.derived.place.distance),
    row!("reach", "polygon.readout.reach", "mm", 3, false, "(stock - AF) / 2", MECHANICS, |lathe| lathe.derived.place.reach),
    row!("offset", "polygon.readout.offset", "mm", 3, false, "-2 r, where X counts diameters", GEOMETRY, |lathe| lathe.derived.place.offset),
    row!("half-axis-near", "polygon.readout.half-axis-near", "mm", 3, false, "R - r, R the distance of the axes", PAPER, |lathe| lathe.derived.place.distance - lathe.params.tip_radius, cuts_on_an_ellipse),
    row!("half-axis-far", "polygon.readout.half-axis-far", "mm", 3, false, "R + r, R the distance of the axes", PAPER, |lathe| lathe.derived.place.distance + lathe.params.tip_radius, cuts_on_an_ellipse),
    row!("orientation-error", "polygon.readout.orientation-error", "°", 3, false, "E/k - A + phase/k - ψ", GEOMETRY, |lathe| lathe.derived.angles.orientation_error, cuts),
    row!("phase", "polygon.readout.phase", "°", 3, false, "6 n [(τ/2 + 1/K) work - (τ/2 + 1/K) tool]", MECHANICS, |lathe| lathe.derived.angles.phase, cuts),
    row!("coast-phase", "polygon.readout.coast-phase", "°", 0, false, "3 (n² / slowing tool - k n² / slowing work)", MECHANICS, |lathe| lathe.derived.angles.coast_phase, cuts),
    row!("least-across-flats", "polygon.readout.least-across-flats", "mm", 4, false, "over the lowest of the highest points", GEOMETRY, |lathe| lathe.derived.section.least_across_flats, cuts_unevenly),
    row!("insert-depth", "polygon.readout.insert-depth", "mm", 4, false, "Δr", GEOMETRY, |lathe| lathe.derived.inserts.depth.error, cuts_unevenly),
    row!("insert-turn", "polygon.readout.insert-turn", "°", 3, false, "Δφ / k", GEOMETRY, |lathe| lathe.derived.inserts.turn.error, cuts_unevenly),
    row!("twist", "polygon.readout.twist", "°", 3, false, "360 L / K", GEOMETRY, |lathe| lathe.derived.twist.angle, cuts_a_twist),
    row!("twist-speed", "polygon.readout.twist-speed", "r/min", 3, false, "k (n work - F / K)", GEOMETRY, |lathe| lathe.derived.twist.tool_speed, cuts_a_twist),
    row!("passes", "polygon.readout.passes", "", 0, false, "(stock - AF - 2 allowance) / (2 depth), rounded up, and one", MECHANICS, |lathe| lathe.derived.times.passes),
    row!("feed", "polygon.readout.feed", "mm/min", 1, false, "f · n work", MECHANICS, |lathe| lathe.derived.feeds.rough),
    row!("finish-feed", "polygon.readout.finish-feed", "mm/min", 1, false, "f · n work", MECHANICS, |lathe| lathe.derived.feeds.finish),
    row!("infeed", "polygon.readout.infeed", "mm/min", 1, false, "f · n work", MECHANICS, |lathe| lathe.derived.feeds.infeed, |lathe| lathe.params.is_behind_face()),
    row!("free-length", "polygon.readout.free-length", "mm", 3, false, "far end + insert width + clearance", MECHANICS, PolygonLathe::length_to_jaws),
    row!("mark-pitch", "polygon.readout.mark-pitch", "mm", 3, false, "f D / gcd(n, D), in the last pass", GEOMETRY, |lathe| lathe.mark_pitches()[1], cuts),
    row!("rough-mark-pitch", "polygon.readout.rough-mark-pitch", "mm", 3, false, "f D / gcd(n, D)", GEOMETRY, |lathe| lathe.mark_pitches()[0], roughs),
    row!("ready", "polygon.readout.ready", "s", 2, false, "at most a turn to A and E, 60 / n index, and twice (τ + 8/K)", MECHANICS, |lathe| lathe.derived.times.ready),
    row!("cutting-time", "polygon.readout.cutting-time", "s", 2, false, "60 way / F, of all motions at feed", MECHANICS, |lathe| lathe.polygons().map(|lathe| lathe.derived.times.cutting).sum(), cuts),
    row!("turning-time", "polygon.readout.turning-time", "s", 2, false, "60 way / F, threads 60 way / (P S)", MECHANICS, |lathe| {
        lathe.params.turned_ends.iter().filter(|end| end.on).map(|end| end.time(&lathe.params)).sum()
    }, PolygonLathe::has_main_spindle),
    row!("before-run-in", "polygon.readout.before-run-in", "mm", 2, false, "V (t - τ/2 - 0.99/K), t = τ + ln(100 (1 - e^(-Kτ)) / (Kτ)) / K", RUN_IN, |lathe| lathe.params.turned_ends[0].run_in(&lathe.params), |lathe| lathe.params.turned_ends[0].threads()),
    row!("after-run-in", "polygon.readout.after-run-in", "mm", 2, false, "V (t - τ/2 - 0.99/K), t = τ + ln(100 (1 - e^(-Kτ)) / (Kτ)) / K", RUN_IN, |lathe| lathe.params.turned_ends[1].run_in(&lathe.params), |lathe| lathe.params.turned_ends[1].threads()),
    row!("before-run-out", "polygon.readout.before-run-out", "mm", 2, false, "2 P, at least V (τ/2 + 1/K)", RUN_OUT, |lathe| lathe.params.turned_ends[0].run_out(&lathe.params), |lathe| lathe.params.turned_ends[0].threads()),
    row!("after-run-out", "polygon.readout.after-run-out", "mm", 2, false, "2 P, at least V (τ/2 + 1/K)", RUN_OUT, |lathe| lathe.params.turned_ends[1].run_out(&lathe.params), |lathe| lathe.params.turned_ends[1].threads()),
    row!("after-reached", "polygon.readout.after-reached", "mm", 3, false, "the diameter, at most that of the end turned before under it", MECHANICS, |lathe| lathe.params.turned_ends[1].reached(&lathe.params), |lathe| lathe.params.turned_ends.iter().all(|end| end.on)),
    row!("main-top-speed", "polygon.readout.main-top-speed", "r/min", 0, false, "S · highest override, up to the clamp", OUTPUT, main_spindle::greatest_speed, PolygonLathe::has_main_spindle),
    row!("main-torque", "polygon.readout.main-torque", "Nm", 1, false, "F D / 2000 + friction", MAIN_TORQUE, main_spindle::torque, PolygonLathe::has_main_spindle),
    row!("main-cutting-power", "polygon.readout.main-power", "kW", 2, false, "M n / 9549.3", MAIN_TORQUE, main_spindle::power, PolygonLathe::has_main_spindle),
    row!("main-volts", "polygon.readout.main-volts", "V", 3, false, "10 V · n / n10, in steps", OUTPUT, main_spindle::volts, PolygonLathe::has_main_spindle),
    row!("main-least-volts", "polygon.readout.main-least-volts", "V", 3, false, "10 V · n / n10, at the slowest turned end", OUTPUT, main_spindle::least_volts, PolygonLathe::has_main_spindle),
    row!("main-inertia", "polygon.readout.main-inertia", "kg m²", 4, false, "J work + J rotor · (n m / n10)²", INERTIA, |lathe| lathe.params.main_spindle().load_at_spindle.inertia, PolygonLathe::has_main_spindle),
    row!("main-shortest-ramp", "polygon.readout.main-shortest-ramp", "s", 2, false, "J · 2π n10 / 60 / (short-time torque at the highest speed - friction); braking with that + friction", RUN_UP, |lathe| lathe.params.main_spindle().shortest_ramp(main_spindle::programmed_speed(lathe)), PolygonLathe::has_main_spindle),
    row!("main-run-up-time", "polygon.readout.main-run-up-time", "s", 2, false, "J ω b / (M - M f) + J ∫ ω / (P - M f ω) dω from base speed to the highest", RUN_UP, |lathe| lathe.params.main_spindle().run_up_time(main_spindle::programmed_speed(lathe)), PolygonLathe::has_main_spindle),
    row!("main-braking-time", "polygon.readout.main-braking-time", "s", 2, false, "J ω b / (M + M f) + J ∫ ω / (P + M f ω) dω from base speed to the highest", RUN_UP, |lathe| lathe.params.main_spindle().braking(main_spindle::programmed_speed(lathe)), PolygonLathe::has_main_spindle),
    row!("main-coasting-time", "polygon.readout.main-coasting-time", "s", 1, false, "J · 2π n / 60 / friction, from the highest speed", COASTING, |lathe| lathe.params.main_spindle().coasting(main_spindle::programmed_speed(lathe)), PolygonLathe::has_main_spindle),
    row!("milling-time", "polygon.readout.milling-time", "s", 1, false, "60 ⌈L / depth⌉ · 2 N (AF/2 + D/2) tan(π/N) / F", OURS, |lathe| lathe.polygons().map(|lathe| lathe.params.milling_time()).sum(), cuts),
    row!("milling-ratio", "polygon.readout.milling-ratio", "", 2, false, "milling time / (time until ready + cutting time)", OURS, |lathe| {
        let turning: f64 = lathe.polygons().map(|lathe| lathe.derived.times.ready + lathe.derived.times.cutting).sum();
        lathe.polygons().map(|lathe| lathe.params.milling_time()).sum::<f64>() / turning
    }, cuts),
    row!("cutting-force", "polygon.readout.cutting-force", "N", 0, false, "kc1.1 · b · h^(1 - mc) · (1 - γ / 100), h the marks apart", CUTTING, |lathe| lathe.force(), cuts_by_force),
    row!("bending", "polygon.readout.bending", "mm", 3, false, "u → c (d + u) / (1 + c) per pass; c d = F / 3E · Σ (b³ - a³) / I, I = π D⁴ / 64, from the cut to the jaws", BENDING, PolygonLathe::bending, cuts_by_force),
    row!("at-once", "polygon.readout.at-once", "", 0, false, "1 + ⌊n σ / π⌋", GEOMETRY, |lathe| lathe.polygons().map(|lathe| lathe.derived.load.at_once).fold(0.0, f64::max), cuts_by_force),
    row!("tool-torque", "polygon.readout.tool-torque", "Nm", 1, false, "F r (m + a cos σ) / V · inserts at once", CUTTING, |lathe| lathe.demand(PolygonAxis::Tool, DemandKind::Peak).0, cuts_by_force),
    row!("tool-torque-mean", "polygon.readout.tool-torque-mean", "Nm", 2, false, "n / 2π · ∫ M dσ", CUTTING, |lathe| lathe.demand(PolygonAxis::Tool, DemandKind::Mean).0, cuts_by_force),
    row!("tool-torque-effective", "polygon.readout.tool-torque-effective", "Nm", 2, false, "√(peak torque · mean torque)", CUTTING, |lathe| lathe.demand(PolygonAxis::Tool, DemandKind::Effective).0, cuts_by_force),
    row!("tool-power", "polygon.readout.tool-power", "kW", 3, false, "M n / 9549.3", CUTTING, |lathe| lathe.demand(PolygonAxis::Tool, DemandKind::Power).0, cuts_by_force),
    row!("tool-run-up", "polygon.readout.tool-run-up", "Nm", 1, false, "J · 2π n / (60 τ)", MECHANICS, |lathe| lathe.demand(PolygonAxis::Tool, DemandKind::RunUp).0),
    row!("work-torque", "polygon.readout.work-torque", "Nm", 1, false, "F [a (a + (m - r) cos σ) - r m] / V · inserts at once", CUTTING, |lathe| lathe.demand(PolygonAxis::Work, DemandKind::Peak).0, cuts_by_force),
    row!("work-torque-mean", "polygon.readout.work-torque-mean", "Nm", 2, false, "n / 2π · ∫ M dσ", CUTTING, |lathe| lathe.demand(PolygonAxis::Work, DemandKind::Mean).0, cuts_by_force),
    row!("work-torque-effective", "polygon.readout.work-torque-effective", "Nm", 2, false, "√(peak torque · mean torque)", CUTTING, |lathe| lathe.demand(PolygonAxis::Work, DemandKind::Effective).0, cuts_by_force),
    row!("work-power", "polygon.readout.work-power", "kW", 3, false, "M n / 9549.3", CUTTING, |lathe| lathe.demand(PolygonAxis::Work, DemandKind::Power).0, cuts_by_force),
    row!("work-run-up", "polygon.readout.work-run-up", "Nm", 1, false, "J · 2π n / (60 τ)", MECHANICS, |lathe| lathe.demand(PolygonAxis::Work, DemandKind::RunUp).0),
    row!("shortest-ramp", "polygon.readout.shortest-ramp", "s", 3, false, "J · 2π n / (60 M), of both the longer", MECHANICS, |lathe| lathe.ramp()),
    row!("x-scaling-drift", "scaling.x-drift", "µm/m", 4, false, "10⁶ · (travel of the motor / travel by the parameters - 1)", SCALING, |lathe| scaling::parts_per_million(lathe.control, &lathe.drives()[0]), cuts),
    row!("z-scaling-drift", "scaling.z-drift", "µm/m", 4, false, "10⁶ · (travel of the motor / travel by the parameters - 1)", SCALING, |lathe| scaling::parts_per_million(lathe.control, &lathe.drives()[1]), cuts),
    row!("work-scaling-drift", "scaling.work-drift", "µ°/°", 4, false, "10⁶ · (travel of the motor / travel by the parameters - 1)", SCALING, |lathe| scaling::parts_per_million(lathe.control, &lathe.turning_drives()[0]), cuts),
    row!("tool-scaling-drift", "scaling.tool-drift", "µ°/°", 4, false, "10⁶ · (travel of the motor / travel by the parameters - 1)", SCALING, |lathe| scaling::parts_per_million(lathe.control, &lathe.turning_drives()[1]), cuts),
];
