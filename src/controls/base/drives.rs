//! Drive systems for controls of several families: commanded by pulses, by an analog speed, or by inputs and outputs.

use crate::controls::DriveSystem;
use crate::controls::schema::table::joined;
use crate::text::{Citation, Grade};

const JUDGED: Citation =
    Citation::new("parts facts, section 9: engineering judgement, no statement of a maker", Grade::Open);

/// Servo drives for axes commanded by pulses or by an analog speed.
pub const PULSE: [DriveSystem; 18] = DriveSystem::axes(
    [
        "Sigma-7 SGD7S",
        "SGM7J",
        "SGM7A",
        "SGM7P",
        "SGM7G",
        "MR-J4 200 V",
        "MR-J4 400 V",
        "HG-KR",
        "HG-MR",
        "HG-SR",
        "HG-JR",
        "HG-RR",
        "HG-UR",
        "MINAS A6 MSMF",
        "MINAS A6 MQMF",
        "MINAS A6 MHMF",
        "MINAS A6 MDMF",
        "G5 R88M-K",
    ],
    JUDGED,
);

/// Drives of auxiliary axes started by the control's inputs and outputs.
pub const AUXILIARY: [DriveSystem; 6] =
    DriveSystem::auxiliary(["Sigma-7 SGD7S", "SGM7J", "SGM7A", "SGM7P", "SGM7G", "G5 R88M-K"], JUDGED);

/// Drives of auxiliary axes on a field bus.
pub const FIELD_BUS: [DriveSystem; 2] = DriveSystem::auxiliary(["ctrlX MC20", "ctrlX XC20"], JUDGED);

/// Inverters for an analog spindle, with a speed input of 0 to 10 V.
const INVERTERS: [DriveSystem; 3] =
    DriveSystem::axes(["FREQROL-E800 3AC 200 V", "FREQROL-E800 3AC 400 V", "FREQROL-E800 1AC 200 V"], JUDGED);

/// Induction motors on an inverter.
pub const INDUCTION: [DriveSystem; 3] = DriveSystem::axes(["MT3 IE3 2-pole", "MT3 IE3 4-pole", "IE3 4-pole"], JUDGED);

/// Drive systems for an analog spindle: inverters, and induction motors fed by them.
pub const ANALOG_SPINDLE: &[DriveSystem] = joined![DriveSystem: &INVERTERS, &INDUCTION];
