//! Sources that rows of the FANUC family share.

use crate::text::{Citation, Grade};

/// FANUC usage from memory, without a document.
pub const MEMORY: Citation = Citation::new("FANUC 0i-T usage, unverified", Grade::Open);
/// Custom macro B: calls and arguments.
pub const CALLS: Citation = Citation::new("FANUC 16i/18i-PB manual B-63684EN, p.278", Grade::Inferred);

/// Ratio of spindle and position coder.
pub const CODER: Citation = Citation::new("FANUC Power Mate i-D/H parameter manual, 3706: PG1 and PG2", Grade::Sister);

/// Arguments without a decimal point.
pub const ARGUMENTS: Citation = CALLS;
/// G codes of lathes, by a secondary source.
pub const LATHE_LIST: Citation = Citation::new("machinemfg.com, FANUC CNC lathe commands", Grade::Inferred);
/// Alarms, positions and times as variables, by a secondary source.
pub const WIKI: Citation = Citation::new("zappettiniconsulting.com, alarms and timers; position data", Grade::Inferred);
/// G codes of the series 30i, by a secondary source.
pub const CODE_LIST: Citation =
    Citation::new("cncschool.pl, G codes of the FANUC 30i, lathe, system B", Grade::Inferred);
/// Modal groups of mills, by a secondary source.
pub const MODAL_LIST: Citation = Citation::new("zappettiniconsulting.com, modal group variables", Grade::Inferred);
/// Signals of custom macros, bit by bit, by a secondary source.
pub const INPUTS: Citation = Citation::new("industrialmonitordirect.com, UI and UO of custom macro", Grade::Inferred);
/// Signals between PLC and control: names and addresses of FANUC.
pub const PLC_SIGNALS: Citation = Citation::new("GSK988TA lathe PLC manual, p.112-147", Grade::Sister);
/// The speed-reached signal.
pub const SPEED_REACHED: Citation =
    Citation::new("FANUC Power Mate connection manual B-63443EN/02, p.197", Grade::Sister);
/// Speeds of gear stages.
pub const COMMANDS: Citation =
    Citation::new("FANUC Power Mate i-D/H parameter manual, p.107: 3741 to 3744", Grade::Sister);
/// Alarms of the series 30i, whose numbers and texts the 0i-F shares.
pub const ALARM_LIST: Citation = Citation::new("FANUC 30i PS alarm list, copy in a public repository", Grade::Inferred);
/// Roll-over of rotary axes.
pub const ROLL_OVER: Citation =
    Citation::new("FANUC 16i operator's manual B-63534EN/02, p.531: roll-over of rotary axes", Grade::Sister);
/// Command multiplier.
pub const CMR: Citation = Citation::new("FANUC 30i parameter manual B-63950EN/02, p.106: CMR", Grade::Sister);
/// Motors on the serial bus of the maker.
pub const OWN_DRIVES: Citation =
    Citation::new("parts facts, section 9: motors of FANUC; list of pairs not at hand", Grade::Inferred);
