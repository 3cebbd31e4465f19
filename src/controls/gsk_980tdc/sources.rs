//! Sources that rows of the 980TDc share.

use crate::text::{Citation, Grade};

/// The 980T family from memory, without a document.
pub(super) const MEMORY: Citation = Citation::new("GSK 980T usage, unverified", Grade::Open);
/// Macro variables, G65, calls.
pub(super) const MACRO: Citation = Citation::new("GSK980TDi manual, 3.28", Grade::Sister);
/// Macro statements.
pub(super) const STATEMENT: Citation = Citation::new("GSK980TDi manual, 3.29", Grade::Sister);
/// Additional axes.
pub(super) const AXES: Citation = Citation::new("GSK980TDi manual, 3.27 and 3.28", Grade::Sister);
/// Pages about S, G96, G97 and G50 S in the 980TDc's own manual.
pub(super) const SPINDLE: Citation = Citation::new("GSK980TDc manual, 2.2.2 and 2.2.3", Grade::Manual);
/// Parameter file.
pub(super) const PARAMETERS: Citation = Citation::new("GSK980TDi parameter list", Grade::Sister);
/// The mode "program zero return"; its motion is not documented here.
pub(super) const RETURN: Citation =
    Citation::new("GSK928TD manual, notes: return to the program reference point; how it moves: memory", Grade::Open);

/// Codes of the spindle override, which differ between models: no page of the 980TDc has them.
pub(super) const OVERRIDE: Citation = Citation::new("GSK980MDi manual, p.460, and 988TA", Grade::Sister);
