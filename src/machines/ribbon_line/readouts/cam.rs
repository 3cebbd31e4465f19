//! The results about the electronic cam of the print roller, if a law is chosen.

use crate::machines::ribbon_line::cam::{Cam, now};
use crate::machines::ribbon_line::resolved::RibbonLine;
use crate::machines::verdict::ReadoutRow;
use crate::text::{Citation, Grade};

/// Source of the formulas.
const CAM: Citation = Citation::new("sizing facts 3.3", Grade::Inferred);

/// Source of the rules of short blocks.
const BLOCKS: Citation = Citation::new("sizing facts 3.5", Grade::Inferred);

/// Rows in the order they are shown, after the rows of the drives; only if a law is chosen.
#[rustfmt::skip]
pub(super) const ROWS: &[ReadoutRow<RibbonLine>] = &[
    ReadoutRow {
        id: "cam-travel", label: "ribbon.readout.cam-travel", unit: "mm", decimals: 4,
        formula: "h = π · #111 / #109 - #107", cite: CAM, value: |line| now(line, Cam::travel), ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "cam-peak-speed", label: "ribbon.readout.cam-peak-speed", unit: "mm/min", decimals: 1,
        formula: "v + Cv · h / T, T = (#107 - c) / v", cite: CAM,
        value: |line| now(line, Cam::peak_correction), ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "cam-peak-acceleration", label: "ribbon.readout.cam-peak-acceleration", unit: "m/s²", decimals: 3,
        formula: "Ca · |h| / T²", cite: CAM,
        value: |line| now(line, Cam::peak_acceleration), ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "cam-motor-speed", label: "ribbon.readout.cam-motor-speed", unit: "r/min", decimals: 1,
        formula: "max(v, |v + Cv · h / T|) / (π · #111) · iy", cite: CAM, value: |line| now(line, Cam::motor_speed), ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "cam-peak-torque", label: "ribbon.readout.cam-peak-torque", unit: "Nm", decimals: 3,
        formula: "(JL / η + JM) · a · iy / R + load torque", cite: CAM, value: |line| now(line, Cam::peak_torque), ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "cam-start-torque", label: "ribbon.readout.cam-start-torque", unit: "Nm", decimals: 3,
        formula: "(JL / η + JM) · (a + v max / τ) · iy / R + load torque", cite: CAM, value: |line| now(line, Cam::start_torque), ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "cam-effective-torque", label: "ribbon.readout.cam-effective-torque", unit: "Nm", decimals: 3,
        formula: "SQRT[((JL / η + JM) · a eff · iy / R)² + load torque²]", cite: CAM, value: |line| now(line, Cam::effective_torque), ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "cam-longest-lag", label: "ribbon.readout.cam-longest-lag", unit: "mm", decimals: 3,
        formula: "(#107 - c) / Cv", cite: CAM, value: |line| now(line, Cam::longest_lag), ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "cam-speed-by-peak", label: "ribbon.readout.cam-speed-by-peak", unit: "mm/min", decimals: 0,
        formula: "(#107 - c) · SQRT[a / (Ca · |h|)], a of the peak torque allowed", cite: CAM, value: |line| now(line, Cam::speed_by_peak), ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "cam-speed-by-heat", label: "ribbon.readout.cam-speed-by-heat", unit: "mm/min", decimals: 0,
        formula: "the same with the effective torque allowed", cite: CAM, value: |line| now(line, Cam::speed_by_heat), ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "cam-blocks", label: "ribbon.readout.cam-blocks", unit: "", decimals: 0,
        formula: "SQRT[Ca · |h| / (8 · tolerance of a dot)], rounded up", cite: BLOCKS, value: |line| now(line, Cam::blocks), ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "cam-block-time", label: "ribbon.readout.cam-block-time", unit: "ms", decimals: 3,
        formula: "T / blocks", cite: BLOCKS, value: |line| now(line, Cam::block_time), ..ReadoutRow::BASE
    },
    ReadoutRow {
        id: "cam-blocks-smear", label: "ribbon.readout.cam-blocks-smear", unit: "mm", decimals: 3,
        formula: "smear · (1 - |sin x| / x · K / SQRT[K² + ω²]), x = ω τ / 2, ω = 2π · v / #107", cite: BLOCKS,
        value: |line| now(line, Cam::smear_of_blocks), ..ReadoutRow::BASE
    },
];
