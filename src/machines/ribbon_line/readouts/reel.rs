//! The results about the supply reel: ribbon on it, pull on the ribbon at start and stop, and brake, over its changing diameter.

use crate::drives::inertia::CM2;
use crate::drives::reel;
use crate::machines::ribbon_line::reel::wound;
use crate::machines::ribbon_line::reel_demand::{coasting_pull, products, ramp_pull, time};
use crate::machines::ribbon_line::resolved::RibbonLine;
use crate::machines::verdict::ReadoutRow;
use crate::math::RPM;
use crate::text::{Citation, Grade};

const FACTS: Citation = Citation::new("sizing facts 2.9", Grade::Inferred);

/// Rows in the order they are shown.
#[rustfmt::skip]
pub(super) const ROWS: &[ReadoutRow<RibbonLine>] = &[
    ReadoutRow {
        id: "reel-length", label: "ribbon.readout.reel-length", unit: "m", decimals: 2,
        formula: "π · (D² - d²) / (4 · thickness)", cite: FACTS, value: |line| wound(&line.params).length(), ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "reel-time", label: "ribbon.readout.reel-time", unit: "s", decimals: 1,
        formula: "length / line speed", cite: FACTS, value: time, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "reel-products", label: "ribbon.readout.reel-products", unit: "", decimals: 0,
        formula: "whole products in the length, less the ribbon in the loop and what the stop at the reel’s end takes", cite: FACTS, value: products, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "reel-inertia-full", label: "ribbon.readout.reel-inertia-full", unit: "kg cm²", decimals: 2,
        formula: "m (D² + d²) / 8 + core", cite: FACTS,
        value: |line| wound(&line.params).inertia(wound(&line.params).full) / CM2, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "reel-inertia-empty", label: "ribbon.readout.reel-inertia-empty", unit: "kg cm²", decimals: 2,
        formula: "core", cite: FACTS, value: |line| wound(&line.params).inertia(wound(&line.params).core) / CM2, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "reel-speed-empty", label: "ribbon.readout.reel-speed-empty", unit: "r/min", decimals: 1,
        formula: "line speed / (π · d)", cite: FACTS,
        value: |line| reel::speed(wound(&line.params).core, line.line_speed() / 60e3) / RPM, ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "reel-brake-torque-full", label: "ribbon.readout.reel-brake-torque-full", unit: "Nm", decimals: 3,
        formula: "brake · D / 2", cite: FACTS,
        value: |line| reel::torque(wound(&line.params).full, line.params.unwinding.brake), ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "reel-brake-torque-empty", label: "ribbon.readout.reel-brake-torque-empty", unit: "Nm", decimals: 3,
        formula: "brake · d / 2", cite: FACTS,
        value: |line| reel::torque(wound(&line.params).core, line.params.unwinding.brake), ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "reel-pull", label: "ribbon.readout.reel-pull", unit: "N", decimals: 2,
        formula: "brake + J · α / r over the inverter’s ramp, of the full reel or at the core, whichever is more", cite: FACTS,
        value: |line| line.params.unwinding.brake + ramp_pull(&line.params), ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "reel-brake-needed", label: "ribbon.readout.reel-brake-needed", unit: "N", decimals: 2,
        formula: "J · α / r of the fastest stop, over the ramp or without current, of the full reel or at the core, whichever is more", cite: FACTS,
        value: |line| ramp_pull(&line.params).max(coasting_pull(line)), ..ReadoutRow::BASE
    },
];
