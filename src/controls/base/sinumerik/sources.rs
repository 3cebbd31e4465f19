//! Sources that rows of the SINUMERIK family share.

use crate::text::{Citation, Grade};

/// Arithmetic operators, their precedence, and comparison for equality.
pub const ARITHMETIC: Citation = Citation::new("840D sl NC programming 12/2019, p.392 and 444", Grade::Sister);
/// Usage of Siemens controls from memory, without a document.
pub const MEMORY: Citation = Citation::new("usage of Siemens controls, unverified", Grade::Open);

/// Signals of channel and mode group.
pub const PLC_SIGNALS: Citation = Citation::new("SINUMERIK 802S/C start-up, 6.2", Grade::Sister);
/// Signals of axes and spindle.
pub const PLC_AXES: Citation = Citation::new("SINUMERIK 802S/C start-up, 6.2: axes and spindle", Grade::Sister);
/// Signals inferred from the bits of the 840D.
pub const PLC_RULE: Citation =
    Citation::new("840D DB10 to DB31 by the address rule of the 802 family", Grade::Inferred);
/// Motors of the maker's drives.
pub const OWN_DRIVES: Citation =
    Citation::new("parts facts, section 9: motors of Siemens; list of pairs not at hand", Grade::Inferred);
/// Motors of another drive of the maker.
pub const OTHER_DRIVES: Citation = Citation::new(
    "parts facts, section 9: 1FK2 is a motor of the S210, no axis of the control's own drive",
    Grade::Open,
);
