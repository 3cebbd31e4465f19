//! The command line for tests: in English, with any locale of the computer.

use std::process::Command;

/// Path of the program.
pub(crate) const MACROLINE: &str = env!("CARGO_BIN_EXE_macroline");

/// A call of the program.
pub(crate) fn macroline() -> Command {
    in_english(MACROLINE)
}

/// A call of a program with an English locale.
pub(crate) fn in_english(program: &str) -> Command {
    let mut command = Command::new(program);
    command.env("LC_ALL", "C").env("LANGUAGE", "");
    command
}
