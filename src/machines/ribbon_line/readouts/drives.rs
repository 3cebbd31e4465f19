//! The results about the ribbon line's drives as rows: label, unit, formula, source.

use crate::drives::inertia::{self, CM2};
use crate::machines::ribbon_line::resolved::RibbonLine;
use crate::machines::ribbon_line::rules::drives::rapid_torques;
use crate::machines::verdict::ReadoutRow;
use crate::text::{Citation, Grade};

/// Rows in the order they are shown, after the rows of the line.
#[rustfmt::skip]
pub(super) const ROWS: &[ReadoutRow<RibbonLine>] = &[
    ReadoutRow {
        id: "x-load-inertia", label: "ribbon.readout.x-load-inertia", unit: "kg cm²", decimals: 4,
        formula: "(roller + pinch roller · (Dx / d)² + ribbon · (Dx / 2)²) / ix² + gear",
        cite: Citation::new("sizing facts 2.1", Grade::Inferred), value: |line| line.mechanics.axes.pull.load.inertia / CM2, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "x-inertia-ratio", label: "ribbon.readout.x-inertia-ratio", unit: ": 1", decimals: 2,
        formula: "load inertia / rotor inertia",
        cite: Citation::new("sizing facts 2.3", Grade::Inferred), value: |line| line.mechanics.axes.pull.shares().inertia_ratio, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "x-load-torque", label: "ribbon.readout.x-load-torque", unit: "Nm", decimals: 4,
        formula: "((T1 - T2) · Dx / 2 + friction) / (ix · η)",
        cite: Citation::new("sizing facts 2.2", Grade::Inferred), value: |line| line.mechanics.axes.pull.load.torque, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "x-ramp-torque", label: "ribbon.readout.x-ramp-torque", unit: "Nm", decimals: 4,
        formula: "(JL / η + JM) · 2π n / (60 · τ)",
        cite: Citation::new("sizing facts 2.2", Grade::Inferred), value: |line| line.mechanics.axes.pull.rise, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "x-peak-torque", label: "ribbon.readout.x-peak-torque", unit: "Nm", decimals: 3,
        formula: "load torque + ramp torque; where more: |load torque - (JL · η + JM) · 2π n / (60 · τ)|, torque at rest, torque of the tautest ribbon",
        cite: Citation::new("sizing facts 2.2", Grade::Inferred), value: |line| line.mechanics.axes.pull.demand.peak, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "x-rapid-torque", label: "ribbon.readout.x-rapid-torque", unit: "Nm", decimals: 3,
        formula: "load torque + (JL / η + JM) · 2π n / (60 · τ) at rapid traverse; where more: |load torque - (JL · η + JM) · 2π n / (60 · τ)|",
        cite: Citation::new("sizing facts 2.2", Grade::Inferred), value: |line| rapid_torques(line).pull, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "x-effective-torque", label: "ribbon.readout.x-effective-torque", unit: "Nm", decimals: 3,
        formula: "SQRT[Σ T² t / Σ t] over a product, or a block with exact stop",
        cite: Citation::new("sizing facts 2.2", Grade::Inferred), value: |line| line.mechanics.axes.pull.demand.effective, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "x-shortest-ramp", label: "ribbon.readout.x-shortest-ramp", unit: "ms", decimals: 1,
        formula: "(JL / η + JM) · 2π n / 60 / (0.8 · peak torque - load torque)",
        cite: Citation::new("sizing facts 2.2", Grade::Inferred), value: |line| line.mechanics.axes.pull.shortest_ramp() * 1e3, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "nip-use", label: "ribbon.readout.nip-use", unit: "%", decimals: 1,
        formula: "greater of |T1 - T2| + mass of ribbon · v / τ and |T - T2|, over μ · N; T of the tautest ribbon",
        cite: Citation::new("sizing facts 2.2", Grade::Inferred), value: |line| 100.0 * line.mechanics.nip_use, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "y-load-inertia", label: "ribbon.readout.y-load-inertia", unit: "kg cm²", decimals: 4,
        formula: "(roller + #109 · mass · R²) / iy² + gear",
        cite: Citation::new("sizing facts 2.1", Grade::Inferred), value: |line| line.mechanics.axes.print.load.inertia / CM2, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "y-inertia-ratio", label: "ribbon.readout.y-inertia-ratio", unit: ": 1", decimals: 2,
        formula: "load inertia / rotor inertia",
        cite: Citation::new("sizing facts 2.3", Grade::Inferred), value: |line| line.mechanics.axes.print.shares().inertia_ratio, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "y-load-torque", label: "ribbon.readout.y-load-torque", unit: "Nm", decimals: 4,
        formula: "(force · R + friction) / (iy · η)",
        cite: Citation::new("sizing facts 2.2", Grade::Inferred), value: |line| line.mechanics.axes.print.load.torque, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "y-ramp-torque", label: "ribbon.readout.y-ramp-torque", unit: "Nm", decimals: 4,
        formula: "(JL / η + JM) · 2π n / (60 · τ)",
        cite: Citation::new("sizing facts 2.2", Grade::Inferred), value: |line| line.mechanics.axes.print.rise, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "y-peak-torque", label: "ribbon.readout.y-peak-torque", unit: "Nm", decimals: 3,
        formula: "load torque + ramp torque; where more: |load torque - (JL · η + JM) · 2π n / (60 · τ)|, torque at rest",
        cite: Citation::new("sizing facts 2.2", Grade::Inferred), value: |line| line.mechanics.axes.print.demand.peak, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "y-rapid-torque", label: "ribbon.readout.y-rapid-torque", unit: "Nm", decimals: 3,
        formula: "load torque + (JL / η + JM) · 2π n / (60 · τ) at rapid traverse; where more: |load torque - (JL · η + JM) · 2π n / (60 · τ)|",
        cite: Citation::new("sizing facts 2.2", Grade::Inferred), value: |line| rapid_torques(line).print, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "y-effective-torque", label: "ribbon.readout.y-effective-torque", unit: "Nm", decimals: 3,
        formula: "SQRT[Σ T² t / Σ t] over a product, or a block with exact stop",
        cite: Citation::new("sizing facts 2.2", Grade::Inferred), value: |line| line.mechanics.axes.print.demand.effective, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "y-shortest-ramp", label: "ribbon.readout.y-shortest-ramp", unit: "ms", decimals: 1,
        formula: "(JL / η + JM) · 2π n / 60 / (0.8 · peak torque - load torque)",
        cite: Citation::new("sizing facts 2.2", Grade::Inferred), value: |line| line.mechanics.axes.print.shortest_ramp() * 1e3, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "y-stop-energy", label: "ribbon.readout.y-stop-energy", unit: "J", decimals: 2,
        formula: "(JL · η + JM) · ω² / 2 - load torque · ω · τ / 2",
        cite: Citation::new("sizing facts 2.4", Grade::Inferred), value: |line| line.mechanics.axes.print.stop_energy(), ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "y-best-gear", label: "ribbon.readout.y-best-gear", unit: ": 1", decimals: 2,
        formula: "SQRT[J roller / (JM + gear)]",
        cite: Citation::new("sizing facts 2.1", Grade::Inferred),
        value: |line| {
            let axis = &line.mechanics.axes.print;
            inertia::best_ratio(axis.output.inertia, axis.fitted.motor.rotor + line.params.axes.print.gear_inertia * CM2)
        }, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "site-share", label: "ribbon.readout.site-share", unit: "%", decimals: 1,
        formula: "table of height and temperature, at most 100 %",
        cite: Citation::new("SIMOTICS S-1FL2 operating instructions, p.628: derating by height and temperature", Grade::Inferred),
        value: |line| 100.0 * line.params.site().share(), ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "dot-length", label: "ribbon.readout.dot-length", unit: "mm", decimals: 3,
        formula: "l / r + |1 - 1/r| · c",
        cite: Citation::new("sizing facts 3.2", Grade::Inferred),
        value: RibbonLine::dot_length, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "unwinder-torque", label: "ribbon.readout.unwinder-torque", unit: "Nm", decimals: 4,
        formula: "(brake · #102 / 2 + friction) / (#101 · η)",
        cite: Citation::new("sizing facts D1", Grade::Inferred), value: |line| line.mechanics.unwinder, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "unwinder-ramp-torque", label: "ribbon.readout.unwinder-ramp-torque", unit: "Nm", decimals: 3,
        formula: "torque + J · 2π n10 / (60 · ramp)",
        cite: Citation::new("sizing facts 2.2", Grade::Inferred), value: |line| line.mechanics.unwinder_ramp, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "unwinder-braking-torque", label: "ribbon.readout.unwinder-braking-torque", unit: "Nm", decimals: 3,
        formula: "J · 2π n10 / (60 · ramp) - torque",
        cite: Citation::new("sizing facts 2.2", Grade::Inferred), value: |line| line.mechanics.unwinder_braking, ..ReadoutRow::BASE
    },
];
