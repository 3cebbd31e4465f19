//! Tables of parts: the shipped catalogue, and parts added by the user, as CSV or JSON.

pub mod columns;
mod objects;
mod row;
mod sources;
mod table;

use std::sync::OnceLock;

pub use self::objects::write_json;
pub(in crate::project) use self::objects::{from_members, members};
pub use self::row::MAX_PARTS;
pub use self::sources::source_title;
pub use self::table::write;
use crate::controls::{Control, DriveRole};
use crate::drives::parts::{Part, PartGrade, Ratings};
use crate::msg;
use crate::text::{Diagnostic, without_byte_order_mark};

/// Bytes of a table at most.
pub const MAX_BYTES: usize = 4 << 20;

/// Reads a table of parts: JSON by the extension of the file or the first character of the text, otherwise CSV. Total: any text gives the
/// parts that are sound, and findings with their places; a row with an error is left out.
pub fn read(text: &str, name: &str) -> (Vec<Part>, Vec<Diagnostic>) {
    if text.len() > MAX_BYTES {
        let message = msg!("parts.too-large", size = (text.len() >> 20) as u32, most = (MAX_BYTES >> 20) as u32);
        return (Vec::new(), vec![Diagnostic::error(message)]);
    }
    let begin = without_byte_order_mark(text).trim_start();
    if name.to_ascii_lowercase().ends_with(".json") || begin.starts_with(['[', '{']) {
        objects::read(text)
    } else {
        table::read(text)
    }
}

/// Bytes at the beginning of a text in which a table of parts names its columns.
const HEAD: usize = 2000;

/// Whether a text is a table of parts: its first line, or the first object of its list, names kind, maker and model.
pub(in crate::project) fn is_table(text: &str) -> bool {
    let begin = without_byte_order_mark(text).trim_start();
    let head = begin.get(..HEAD).unwrap_or(begin);
    let head = if begin.starts_with('[') { head } else { head.lines().next().unwrap_or_default() };
    let head = head.to_ascii_lowercase();
    columns::REQUIRED.iter().all(|name| head.contains(name))
}

/// The catalogue of public data sheets that macroline ships. Its sources are explained in `docs/reference/parts.md`.
pub fn shipped() -> &'static [Part] {
    static SHIPPED: OnceLock<Vec<Part>> = OnceLock::new();
    SHIPPED.get_or_init(|| read(include_str!("shipped.csv"), "shipped.csv").0)
}

/// Whether a control can use a part: its series is one of the control's drive systems, it is a gear unit or an encoder, or the user has
/// entered it.
pub fn goes_with(part: &Part, control: &Control) -> bool {
    control.drives.iter().any(|row| row.series == part.series)
        || matches!(part.ratings, Ratings::Gear(_) | Ratings::Encoder(_))
        || part.evidence.grade == PartGrade::Entered
}

/// Whether this part can be used for an axis that a control commands; false for a series that positions by itself beside that control.
pub fn follows(part: &Part, control: &Control) -> bool {
    let row = control.drives.iter().find(|row| row.series == part.series);
    goes_with(part, control) && row.is_none_or(|row| row.role == DriveRole::Axis)
}
