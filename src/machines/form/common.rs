//! Entries that the form of every machine has: times of the control, line ends and names of its program, and the pause between two runs.

use super::Field;
use super::rows::{ChoiceMember, Member, TextMember, choice, number, text};
use crate::nc::Newline;
use crate::options;

options! {
    /// Line ends of the program files.
    pub enum LineEnds {
        /// LF.
        Lf = "lf" "form.newline.lf",
        /// CR LF.
        CrLf = "crlf" "form.newline.crlf",
    }
}

impl From<LineEnds> for Newline {
    fn from(ends: LineEnds) -> Newline {
        match ends {
            LineEnds::Lf => Newline::Lf,
            LineEnds::CrLf => Newline::CrLf,
        }
    }
}

/// Greatest length of a name in the header of a program.
const NAME: usize = 22;

/// A field for the time (ms) of a block. The default is that of the machine's usual control.
pub const fn block_time<P>(group: &'static str, default: f64, member: Member<P, f64>) -> Field<P> {
    let row = number("block-time", member).group(group).label("form.block-time").help("form.block-time.help");
    row.unit("ms").range(0.1..=1000.0).default(default).decimals(3).step(0.1).fact()
}

/// A field for the time (ms) of a macro block. The default is that of the machine's usual control.
pub const fn macro_time<P>(group: &'static str, default: f64, member: Member<P, f64>) -> Field<P> {
    let row = number("macro-time", member).group(group).label("form.macro-time").help("form.macro-time.help");
    row.unit("ms").range(0.1..=1000.0).default(default).decimals(3).step(0.1).fact()
}

/// A field for the number of blocks that the control reads ahead. The default is that of the machine's usual control.
pub const fn preread<P>(group: &'static str, default: f64, member: Member<P, f64>) -> Field<P> {
    let row = number("preread", member).group(group).label("form.preread").help("form.preread.help");
    row.range(1.0..=100.0).default(default).decimals(0).step(1.0).fact()
}

/// A field for the line ends of the program files.
pub const fn newline<P>(group: &'static str, member: ChoiceMember<P>) -> Field<P> {
    choice("newline", member).group(group).label("form.newline").help("form.newline.help")
}

/// A field for the customer, named in the header of the program.
pub const fn customer<P>(group: &'static str, member: TextMember<P>) -> Field<P> {
    text("customer", member).group(group).label("form.customer").help("form.customer.help").characters(NAME)
}

/// A field for the product, named in the header of the program.
pub const fn product<P>(group: &'static str, member: TextMember<P>) -> Field<P> {
    text("product", member).group(group).label("form.product").help("form.product.help").characters(NAME)
}

/// A field for the pause (s) from the end of a run to the next start, in which the drives hold at standstill.
pub const fn pause<P>(group: &'static str, member: Member<P, f64>) -> Field<P> {
    let row = number("pause", member).group(group).label("form.pause").help("form.pause.help");
    row.unit("s").range(0.0..=36000.0).default(0.0).decimals(1).step(1.0)
}
