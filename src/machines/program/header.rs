//! A machine's settings as comment lines of its program: a program dropped on the page restores the form from them.
//!
//! The first line names machine and format (`MACROLINE RIBBON-LINE 1`), the next the control where it is not the machine's first
//! (`CONTROL=…`), each further one a field (`PITCH=8`): the essential ones always, the others where they differ from the default.

use crate::controls::Control;
use crate::machines::form::{Field, FieldKind};
use crate::machines::machine::Machine;
use crate::text::catalog::number_text;
use crate::text::catalog::programs::chinese;

/// First word of the first line.
pub(in crate::machines) const MARK: &str = "MACROLINE";
/// Format of the lines.
const VERSION: &str = "1";
/// Key of the control's line.
pub(in crate::machines) const CONTROL: &str = "control";

/// Comment, without brackets, that names the version of macroline by which a program was written.
pub(super) fn version_comment(version: &str) -> String {
    format!("WRITTEN BY {MARK} {version}")
}

/// Whether a line of a program is macroline's comment with its version, of any version and in each language of comments.
pub fn is_version_line(line: &str) -> bool {
    const PLACE: &str = "{version}";
    if !line.contains(MARK) {
        return false;
    }
    let comment = line.trim().trim_start_matches(['(', ';']).trim_end_matches(')').trim();
    let english = version_comment(PLACE);
    let written = [chinese(&english), Some(english)];
    written.iter().flatten().filter_map(|pattern| pattern.split_once(PLACE)).any(|(before, after)| {
        let version = comment.strip_prefix(before).and_then(|rest| rest.strip_suffix(after));
        version.is_some_and(|version| !version.is_empty() && !version.contains(' '))
    })
}

/// Comment lines, without brackets, that hold the parameters of a machine on a control.
pub fn lines<M: Machine>(params: &M::Params, control: &Control) -> Vec<String> {
    let mut lines = vec![format!("{MARK} {} {VERSION}", M::INFO.id).to_ascii_uppercase()];
    if M::INFO.controls.first() != Some(&control.id) {
        lines.push(format!("{CONTROL}={}", control.id).to_ascii_uppercase());
    }
    let fields: &[Field<M::Params>] = M::fields();
    for field in fields {
        let text = match &field.kind {
            FieldKind::Number { get, default, decimals, .. } => {
                let number = get(params);
                (field.essential || number != *default).then(|| number_text(number, *decimals))
            }
            FieldKind::Flag { get, default, .. } => (get(params) != *default).then(|| get(params).to_string()),
            FieldKind::Choice { options, get, .. } => {
                options.get(get(params)).filter(|_| get(params) != 0).map(|(option, _)| (*option).to_owned())
            }
            FieldKind::Text { get, .. } => Some(plain(get(params))).filter(|text| !text.is_empty()),
        };
        lines.extend(text.map(|text| format!("{}={}", field.id, text).to_ascii_uppercase()));
    }
    lines
}

/// Text for a comment: printable ASCII without brackets and per cent signs.
fn plain(text: &str) -> String {
    let keep = |c: char| if c.is_ascii_graphic() && !matches!(c, '(' | ')' | '%') { c } else { ' ' };
    text.chars().map(keep).collect::<String>().split_whitespace().collect::<Vec<_>>().join(" ")
}
