//! The results of the turning spindle as rows: label, unit, formula, source.

use super::bending;
use super::gears;
use super::keyway;
use super::resolved::TurningSpindle;
use super::run_up::{engaged, greatest_speed, positioning_torque, programmed_speed};
use super::travel;
use super::worst_cut::worst_cut_point;
use crate::machines::driven::scaling;
use crate::machines::verdict::ReadoutRow;
use crate::text::{Citation, Grade};

const SURFACE: Citation = Citation::new("the makers' pages on S, G96 and G97", Grade::Manual);
const OUTPUT: Citation = Citation::new("turning spindle facts 1; 12 bits from a similar control", Grade::Sister);
const MECHANICS: Citation = Citation::new("mechanics", Grade::Inferred);
const MOTOR: Citation = Citation::new("data sheet of the motor; curve by base speed", Grade::Inferred);
const KIENZLE: Citation = Citation::new("ISCAR turning catalogue 2017, p.558, groups by their order", Grade::Inferred);
const BENDING: Citation = Citation::new("polygon turning facts 3.13", Grade::Open);
const INERTIA: Citation = Citation::new("sizing facts 2.1", Grade::Inferred);
const TORQUE: Citation = Citation::new("sizing facts 2.2", Grade::Inferred);
const ENERGY: Citation = Citation::new("sizing facts 2.4", Grade::Inferred);
const DEMAND: Citation = Citation::new("turning spindle facts, 4", Grade::Inferred);
const RUN_UP: Citation = Citation::new("turning spindle facts, 5", Grade::Inferred);

const GEARS: Citation = Citation::new("turning spindle facts, 2", Grade::Inferred);
const SCALING: Citation = Citation::new("ribbon line facts, 10", Grade::Inferred);

/// Whether a cutting force is known.
fn cuts_by_force(lathe: &TurningSpindle) -> bool {
    lathe.params.cutting_force > 0.0
}

/// Rows in the order they are shown; the headline ones first.
#[rustfmt::skip]
pub(super) const ROWS: &[ReadoutRow<TurningSpindle>] = &[
    ReadoutRow {
        id: "cutting-time", label: "turning.readout.cutting-time", unit: "s", decimals: 2, headline: true,
        formula: "60 π L d / (1000 v f), at a limit 60 L / (f n)", cite: MECHANICS, value: |lathe| lathe.derived.times.cutting, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "speed-largest", label: "turning.readout.speed-largest", unit: "r/min", decimals: 1, headline: true,
        formula: "n = 1000 v / (π D)", cite: SURFACE, value: |lathe| lathe.derived.speeds.largest, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "speed-smallest", label: "turning.readout.speed-smallest", unit: "r/min", decimals: 1, headline: true,
        formula: "n = 1000 v / (π D), within the limits", cite: SURFACE, value: |lathe| lathe.derived.speeds.smallest, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "speed-greatest", label: "turning.readout.speed-greatest", unit: "r/min", decimals: 1,
        formula: "the greater of both, the knob at its highest position", cite: SURFACE, value: greatest_speed, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "limit-diameter", label: "turning.readout.limit-diameter", unit: "mm", decimals: 3, headline: true,
        formula: "D = 1000 v / (π n limit)", cite: SURFACE, value: |lathe| lathe.derived.limits.high, shown: TurningSpindle::surface, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "volts-smallest", label: "turning.readout.volts-smallest", unit: "V", decimals: 3, headline: true,
        formula: "V = c0 + (10 + c10 - c0) · n / n10, in steps", cite: OUTPUT, value: |lathe| lathe.derived.output.volts_smallest, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "saved", label: "turning.readout.saved", unit: "%", decimals: 1, headline: true,
        formula: "1 - t surface / t fixed", cite: MECHANICS, value: |lathe| lathe.derived.times.saved, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "passes", label: "turning.readout.passes", unit: "", decimals: 0,
        formula: "allowance / depth, rounded up", cite: MECHANICS, value: |lathe| lathe.derived.cut.passes, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "stage", label: "turning.readout.stage", unit: "", decimals: 0,
        formula: "lowest stage that reaches the highest speed", cite: MECHANICS, value: |lathe| f64::from(lathe.derived.stage.number), ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "stage-speed", label: "turning.readout.stage-speed", unit: "r/min", decimals: 0,
        formula: "n10 of the stage", cite: OUTPUT, value: |lathe| lathe.derived.stage.speed, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "gear-delay", label: "turning.readout.gear-delay", unit: "s", decimals: 2,
        formula: "t · n / n10", cite: GEARS, value: gears::slowing, shown: |lathe| lathe.params.has_several_stages() && lathe.params.spindle.ramp > 0.0, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "volts-largest", label: "turning.readout.volts-largest", unit: "V", decimals: 3,
        formula: "V = c0 + (10 + c10 - c0) · n / n10, in steps", cite: OUTPUT, value: |lathe| lathe.derived.output.volts_largest, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "analog-step", label: "turning.readout.analog-step", unit: "r/min", decimals: 3,
        formula: "n10 / steps of the output", cite: OUTPUT, value: |lathe| lathe.derived.output.step, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "limited-share", label: "turning.readout.limited-share", unit: "%", decimals: 1,
        formula: "(D limit - D small) / (D large - D small)", cite: MECHANICS, value: |lathe| lathe.derived.limits.limited_share * 100.0, shown: TurningSpindle::surface, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "low-diameter", label: "turning.readout.low-diameter", unit: "mm", decimals: 3,
        formula: "D = 1000 v / (π n low)", cite: SURFACE, value: |lathe| lathe.derived.limits.low, shown: |lathe| lathe.surface() && lathe.params.lower_limit > 0.0, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "surface-smallest", label: "turning.readout.surface-smallest", unit: "m/min", decimals: 2,
        formula: "v = π D n / 1000", cite: SURFACE, value: |lathe| lathe.derived.speeds.surface_smallest, shown: TurningSpindle::surface, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "surface-time", label: "turning.readout.surface-time", unit: "s", decimals: 2,
        formula: "60 π L d / (1000 v f), at a limit 60 L / (f n)", cite: MECHANICS, value: |lathe| lathe.derived.times.surface, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "fixed-time", label: "turning.readout.fixed-time", unit: "s", decimals: 2,
        formula: "60 L / (f n)", cite: MECHANICS, value: |lathe| lathe.derived.times.fixed, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "fixed-surface-smallest", label: "turning.readout.fixed-surface-smallest", unit: "m/min", decimals: 2,
        formula: "v = π D n / 1000", cite: SURFACE, value: |lathe| lathe.derived.speeds.fixed_surface_smallest, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "feed-top", label: "turning.readout.feed-top", unit: "mm/min", decimals: 1,
        formula: "f · n", cite: MECHANICS, value: |lathe| lathe.derived.speeds.feed_top, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "acceleration-needed", label: "turning.readout.acceleration-needed", unit: "r/min/s", decimals: 1,
        formula: "n² f s / (60 D)", cite: MECHANICS, value: |lathe| lathe.derived.acceleration.needed, shown: TurningSpindle::surface, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "power", label: "turning.readout.power", unit: "kW", decimals: 2,
        formula: "F v / 60 000 + friction · n / 9549", cite: MECHANICS, value: |lathe| lathe.derived.load.power, shown: cuts_by_force, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "torque", label: "turning.readout.torque", unit: "Nm", decimals: 1,
        formula: "F D / 2000 + friction", cite: MECHANICS, value: |lathe| lathe.derived.load.torque, shown: cuts_by_force, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "peak-torque", label: "turning.readout.peak-torque", unit: "Nm", decimals: 1,
        formula: "F D / 2000 + friction + J · 2π / 60 · dn/dt", cite: DEMAND, value: |lathe| worst_cut_point(&lathe.params, &lathe.derived).torque,
        shown: cuts_by_force, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "torque-available", label: "turning.readout.torque-available", unit: "Nm", decimals: 1,
        formula: "9549 P η x / max(n, n b · n10 / n m), with a shaft fan · (0.5 + 0.5 n motor / n b)", cite: MOTOR, value: |lathe| lathe.derived.load.torque_available, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "force", label: "turning.readout.force", unit: "N", decimals: 0,
        formula: "kc1.1 · b · h^(1 - mc) · (1 - γ / 100)", cite: KIENZLE, value: |lathe| lathe.params.cutting_force, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "bending", label: "turning.readout.bending", unit: "mm", decimals: 3,
        formula: "F / 3E · Σ (b³ - a³) / I, with the tailstock F L³ / (102 E I), a taper by slices, I = π D⁴ / 64", cite: BENDING, value: |lathe| bending::of(&lathe.params), shown: cuts_by_force, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "work-inertia", label: "turning.readout.work-inertia", unit: "kg m²", decimals: 4,
        formula: "π ρ L D⁴ / 32", cite: INERTIA, value: |lathe| lathe.params.work_inertia(), ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "inertia", label: "turning.readout.inertia", unit: "kg m²", decimals: 4,
        formula: "J spindle + J work + J rotor · (n m / n10)²", cite: INERTIA, value: |lathe| engaged(lathe).load_at_spindle.inertia, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "run-up-torque", label: "turning.readout.run-up-torque", unit: "Nm", decimals: 1,
        formula: "J · 2π n10 / (60 t) + friction", cite: RUN_UP, value: |lathe| engaged(lathe).ramp_torque(), shown: |lathe| lathe.params.spindle.ramp > 0.0, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "positioning-torque", label: "turning.readout.positioning-torque", unit: "Nm", decimals: 1,
        formula: "J · α + friction",
        cite: Citation::new("turning spindle facts, 5", Grade::Inferred), value: positioning_torque, shown: TurningSpindle::positions, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "shortest-ramp", label: "turning.readout.shortest-ramp", unit: "s", decimals: 2,
        formula: "J · 2π n10 / 60 / (short-time torque at the highest speed - friction); braking with that + friction", cite: RUN_UP, value: |lathe| engaged(lathe).shortest_ramp(programmed_speed(lathe)), ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "run-up-time", label: "turning.readout.run-up-time", unit: "s", decimals: 2,
        formula: "J ω b / (M - M f) + J ∫ ω / (P - M f ω) dω from base speed to the highest", cite: RUN_UP, value: |lathe| engaged(lathe).run_up_time(programmed_speed(lathe)), ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "braking-time", label: "turning.readout.braking-time", unit: "s", decimals: 2,
        formula: "J ω b / (M + M f) + J ∫ ω / (P + M f ω) dω from base speed to the highest", cite: RUN_UP, value: |lathe| engaged(lathe).braking(programmed_speed(lathe)), ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "coasting-time", label: "turning.readout.coasting-time", unit: "s", decimals: 1,
        formula: "J · 2π n / 60 / friction, from the highest speed", cite: TORQUE, value: |lathe| engaged(lathe).coasting(programmed_speed(lathe)), ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "stop-energy", label: "turning.readout.stop-energy", unit: "J", decimals: 0,
        formula: "½ J ω² - ½ friction · ω t", cite: ENERGY, value: |lathe| engaged(lathe).stop_energy(programmed_speed(lathe)), ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "keyway-time", label: "turning.readout.keyway-time", unit: "s", decimals: 2,
        formula: "60 · ((c + t) / f x + (L - w) / f z)", cite: MECHANICS, value: |lathe| keyway::time(&lathe.params), shown: |lathe| lathe.keyway().is_some(), ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "driven-cutting-speed", label: "turning.readout.driven-cutting-speed", unit: "m/min", decimals: 1,
        formula: "v = π w n / 1000", cite: MECHANICS, value: |lathe| keyway::cutting_speed(&lathe.params), shown: |lathe| lathe.keyway().is_some(), ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "driven-feed", label: "turning.readout.driven-feed", unit: "mm/rev", decimals: 3,
        formula: "F / n, the greater of both feeds", cite: MECHANICS, value: |lathe| keyway::feed_per_turn(&lathe.params), shown: |lathe| lathe.keyway().is_some(), ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "x-travel", label: "turning.readout.x-travel", unit: "mm", decimals: 1,
        formula: "(start or farthest way out - smallest diameter) / 2", cite: MECHANICS, value: |lathe| travel::needed(lathe)[0], ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "z-travel", label: "turning.readout.z-travel", unit: "mm", decimals: 1,
        formula: "start + length", cite: MECHANICS, value: |lathe| travel::needed(lathe)[1], ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "x-scaling-drift", label: "scaling.x-drift", unit: "µm/m", decimals: 4,
        formula: "10⁶ · (travel of the motor / travel by the parameters - 1)", cite: SCALING, value: |lathe| scaling::parts_per_million(lathe.control, &lathe.drives()[0]), ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "z-scaling-drift", label: "scaling.z-drift", unit: "µm/m", decimals: 4,
        formula: "10⁶ · (travel of the motor / travel by the parameters - 1)", cite: SCALING, value: |lathe| scaling::parts_per_million(lathe.control, &lathe.drives()[1]), ..ReadoutRow::BASE
    },
];
