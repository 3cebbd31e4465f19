//! Drive systems of the E60: the maker's motors for axes, inverters for the analog spindle.

use crate::controls::DriveSystem;
use crate::controls::base::drives::INDUCTION;
use crate::controls::schema::table::joined;
use crate::text::{Citation, Grade};

const OF_CONTROLS: Citation =
    Citation::new("MELDAS HC series manual, p.13 to 15; the E60's list of pairs not at hand", Grade::Inferred);
const OF_MAKER: Citation =
    Citation::new("parts facts, section 9: drives of the control's maker; list of pairs not at hand", Grade::Open);

/// All rows.
pub(super) const DRIVES: &[DriveSystem] = joined![
    DriveSystem: &DriveSystem::axes(["MELDAS HC"], OF_CONTROLS),
    &DriveSystem::axes(["HG-KN", "HG-KR", "HG-MR", "HG-SR", "HG-JR", "HG-RR", "HG-UR"], OF_MAKER),
    &DriveSystem::axes(["MR-J4 200 V", "MR-J4 400 V"], OF_MAKER),
    &DriveSystem::axes(["FREQROL-E800 3AC 200 V", "FREQROL-E800 3AC 400 V", "FREQROL-E800 1AC 200 V"], OF_MAKER),
    &INDUCTION,
];
