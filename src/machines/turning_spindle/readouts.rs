//! The results of the turning spindle as rows: what is shown, in which unit, by which formula, from which source.

use super::Lathe;
use crate::machines::verdict::Row;
use crate::text::{Citation, Grade};

const SURFACE: Citation = Citation::new("the makers' pages on S, G96 and G97", Grade::Manual);
const OUTPUT: Citation = Citation::new("turning spindle facts 1; 12 bits from a sister control", Grade::Sister);
const MECHANICS: Citation = Citation::new("mechanics", Grade::Inferred);

/// Rows in the order they are shown; the headline ones first.
#[rustfmt::skip]
pub(super) const ROWS: &[Row<Lathe>] = &[
    Row {
        id: "cutting-time", label: "turning.readout.cutting-time", unit: "s", decimals: 2, headline: true,
        formula: "60 π L d / (1000 v f), at a limit 60 L / (f n)", cite: MECHANICS, value: |d| d.cutting_time,
    },
    Row {
        id: "speed-largest", label: "turning.readout.speed-largest", unit: "r/min", decimals: 1, headline: true,
        formula: "n = 1000 v / (π D)", cite: SURFACE, value: |d| d.speed_largest,
    },
    Row {
        id: "speed-smallest", label: "turning.readout.speed-smallest", unit: "r/min", decimals: 1, headline: true,
        formula: "n = 1000 v / (π D), within the limits", cite: SURFACE, value: |d| d.speed_smallest,
    },
    Row {
        id: "limit-diameter", label: "turning.readout.limit-diameter", unit: "mm", decimals: 3, headline: true,
        formula: "D = 1000 v / (π n limit)", cite: SURFACE, value: |d| d.limit_diameter,
    },
    Row {
        id: "volts-smallest", label: "turning.readout.volts-smallest", unit: "V", decimals: 3, headline: true,
        formula: "V = c0 + (10 + c10 - c0) · n / n10, in steps", cite: OUTPUT, value: |d| d.volts_smallest,
    },
    Row {
        id: "saved", label: "turning.readout.saved", unit: "%", decimals: 1, headline: true,
        formula: "1 - t surface / t fixed", cite: MECHANICS, value: |d| d.saved,
    },
    Row {
        id: "passes", label: "turning.readout.passes", unit: "", decimals: 0, headline: false,
        formula: "allowance / depth, rounded up", cite: MECHANICS, value: |d| d.passes,
    },
    Row {
        id: "stage", label: "turning.readout.stage", unit: "", decimals: 0, headline: false,
        formula: "lowest stage that reaches the highest speed", cite: MECHANICS, value: |d| f64::from(d.stage),
    },
    Row {
        id: "stage-speed", label: "turning.readout.stage-speed", unit: "r/min", decimals: 0, headline: false,
        formula: "n10 of the stage", cite: OUTPUT, value: |d| d.stage_speed,
    },
    Row {
        id: "volts-largest", label: "turning.readout.volts-largest", unit: "V", decimals: 3, headline: false,
        formula: "V = c0 + (10 + c10 - c0) · n / n10, in steps", cite: OUTPUT, value: |d| d.volts_largest,
    },
    Row {
        id: "analog-step", label: "turning.readout.analog-step", unit: "r/min", decimals: 3, headline: false,
        formula: "n10 / 4095", cite: OUTPUT, value: |d| d.analog_step,
    },
    Row {
        id: "limited-share", label: "turning.readout.limited-share", unit: "%", decimals: 1, headline: false,
        formula: "(D limit - D small) / (D large - D small)", cite: MECHANICS, value: |d| d.limited_share * 100.0,
    },
    Row {
        id: "low-diameter", label: "turning.readout.low-diameter", unit: "mm", decimals: 3, headline: false,
        formula: "D = 1000 v / (π n low)", cite: SURFACE, value: |d| d.low_diameter,
    },
    Row {
        id: "surface-smallest", label: "turning.readout.surface-smallest", unit: "m/min", decimals: 2, headline: false,
        formula: "v = π D n / 1000", cite: SURFACE, value: |d| d.surface_smallest,
    },
    Row {
        id: "surface-time", label: "turning.readout.surface-time", unit: "s", decimals: 2, headline: false,
        formula: "60 π L d / (1000 v f), at a limit 60 L / (f n)", cite: MECHANICS, value: |d| d.surface_time,
    },
    Row {
        id: "fixed-time", label: "turning.readout.fixed-time", unit: "s", decimals: 2, headline: false,
        formula: "60 L / (f n)", cite: MECHANICS, value: |d| d.fixed_time,
    },
    Row {
        id: "fixed-surface-smallest", label: "turning.readout.fixed-surface-smallest", unit: "m/min", decimals: 2, headline: false,
        formula: "v = π D n / 1000", cite: SURFACE, value: |d| d.fixed_surface_smallest,
    },
    Row {
        id: "feed-top", label: "turning.readout.feed-top", unit: "mm/min", decimals: 1, headline: false,
        formula: "f · n", cite: MECHANICS, value: |d| d.feed_top,
    },
    Row {
        id: "acceleration-needed", label: "turning.readout.acceleration-needed", unit: "r/min/s", decimals: 1, headline: false,
        formula: "n² f s / (60 D)", cite: MECHANICS, value: |d| d.acceleration_needed,
    },
    Row {
        id: "power", label: "turning.readout.power", unit: "kW", decimals: 2, headline: false,
        formula: "F v / 60 000", cite: MECHANICS, value: |d| d.power,
    },
    Row {
        id: "torque", label: "turning.readout.torque", unit: "Nm", decimals: 1, headline: false,
        formula: "F D / 2000", cite: MECHANICS, value: |d| d.torque,
    },
];
