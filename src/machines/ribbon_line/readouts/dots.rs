//! The results of a dot: its error budget, and the room between heads and between dots.

use crate::machines::ribbon_line::dot_error::{DotError, start_stretches, strain};
use crate::machines::ribbon_line::resolved::RibbonLine;
use crate::machines::verdict::ReadoutRow;
use crate::text::{Citation, Grade};

const BUDGET: Citation = Citation::new("sizing facts 2.5, error budget", Grade::Inferred);

/// Rows in the order they are shown.
pub(super) const ROWS: &[ReadoutRow<RibbonLine>] = &[
    ReadoutRow {
        id: "dot-error",
        label: "ribbon.readout.dot-error",
        unit: "mm",
        decimals: 3,
        formula: "lag + strain + SQRT[encoders² + run-out² + backlash²]",
        cite: BUDGET,
        value: |line| DotError::of(line).total(),
        ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "dot-encoders",
        label: "ribbon.readout.dot-encoders",
        unit: "mm",
        decimals: 4,
        formula: "SQRT[(pulse of X / 2)² + (pulse of Y / 2)²]",
        cite: BUDGET,
        value: |line| DotError::of(line).encoders,
        ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "dot-run-out",
        label: "ribbon.readout.dot-run-out",
        unit: "mm",
        decimals: 4,
        formula: "run-out / SQRT[2]: half of it at each roller",
        cite: BUDGET,
        value: |line| DotError::of(line).run_out,
        ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "dot-backlash",
        label: "ribbon.readout.dot-backlash",
        unit: "mm",
        decimals: 4,
        formula: "β · R where the torque at the teeth changes its sign, else 0",
        cite: BUDGET,
        value: |line| DotError::of(line).backlash,
        ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "dot-strain",
        label: "ribbon.readout.dot-strain",
        unit: "mm",
        decimals: 4,
        formula: "#107 · T1 / (E · width · thickness)",
        cite: BUDGET,
        value: |line| DotError::of(line).strain,
        ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "start-dot-error",
        label: "ribbon.readout.start-dot-error",
        unit: "mm",
        decimals: 3,
        formula: "error of a dot with the strain at the tension of a start that misses ribbon, at the worst position of the knob",
        cite: Citation::new("sizing facts 2.6", Grade::Inferred),
        value: |line| DotError::after_start(line).total(),
        shown: start_stretches,
        ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "strain-per-metre",
        label: "ribbon.readout.strain-per-metre",
        unit: "mm/m",
        decimals: 3,
        formula: "1000 · T1 / (E · width · thickness)",
        cite: BUDGET,
        value: |line| 1e3 * strain(line),
        ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "dot-gap",
        label: "ribbon.readout.dot-gap",
        unit: "mm",
        decimals: 3,
        formula: "#107 - length of a dot",
        cite: Citation::new("sizing facts 3.2", Grade::Inferred),
        value: RibbonLine::dot_gap,
        ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "head-gap",
        label: "ribbon.readout.head-gap",
        unit: "mm",
        decimals: 3,
        formula: "π · #111 / #109 - l",
        cite: Citation::new("sizing facts 3.1", Grade::Inferred),
        value: |line| line.params.head_gap(),
        ..ReadoutRow::BASE
    },
];
