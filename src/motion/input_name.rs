//! Names of inputs that the operator forces: a variable of a program, half of one, or a register of the PLC.

use core::fmt;

use super::plc::WordPart;

/// The name of an input.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum InputName {
    /// A variable, `#1033`, or its lower or upper half, `#1033.low`, `#1033.high`.
    Variable(u32, WordPart),
    /// A register of the PLC, `R74`, or another text, which names no input.
    Register(String),
}

impl From<&str> for InputName {
    fn from(text: &str) -> InputName {
        variable(text).unwrap_or_else(|| InputName::Register(text.to_owned()))
    }
}

impl fmt::Display for InputName {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            InputName::Variable(number, WordPart::Whole) => write!(f, "#{number}"),
            InputName::Variable(number, WordPart::Low) => write!(f, "#{number}.low"),
            InputName::Variable(number, WordPart::High) => write!(f, "#{number}.high"),
            InputName::Register(text) => f.write_str(text),
        }
    }
}

/// A name that begins with `#`.
fn variable(text: &str) -> Option<InputName> {
    let text = text.strip_prefix('#')?;
    let (number, part) = match text.split_once('.') {
        None => (text, WordPart::Whole),
        Some((number, "low")) => (number, WordPart::Low),
        Some((number, "high")) => (number, WordPart::High),
        Some(_) => return None,
    };
    Some(InputName::Variable(number.parse().ok()?, part))
}
