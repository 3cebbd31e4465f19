//! Output of the command line: text without characters that a terminal interprets, and JSON as data.

use std::io::{self, BufWriter, StdoutLock, Write};
use std::process::ExitCode;

use macroline::msg;
use macroline::project::findings::file_findings::{FileFindings, has_errors, list_json, list_sarif};
use macroline::project::findings::render::summary;
use macroline::project::requests::check_request::Refused;
use macroline::text::Message;
use macroline::text::catalog::{sentence, words};
use macroline::text::escape::terminal;
use serde_json::{Value as Json, json};

use crate::args::Format;

/// Reason why a command stops early.
pub(crate) enum Failure {
    /// Wrong usage: exit 2.
    Usage(String),
    /// Something outside failed: exit 1.
    Outside(String),
    /// Errors have been printed: exit 1.
    Reported,
    /// The budget of blocks or seconds ended the run, which is already reported: exit 3.
    Exhausted,
    /// The run waits for the operator, which is already reported: exit 4.
    Waits,
    /// The reader of the output has closed it: end without a message.
    Closed,
}

impl Failure {
    /// Wrong usage, with this message.
    pub(crate) fn usage(message: &Message) -> Failure {
        Failure::Usage(sentence(message))
    }
}

impl From<io::Error> for Failure {
    fn from(error: io::Error) -> Failure {
        match error.kind() {
            io::ErrorKind::BrokenPipe => Failure::Closed,
            _ => Failure::Outside(reason(&error)),
        }
    }
}

/// Why a file or folder could not be read or written, in the language in use; rare reasons in the words of the system.
pub(crate) fn reason(error: &io::Error) -> String {
    let common = match error.kind() {
        io::ErrorKind::NotFound => "cli.io.not-found",
        io::ErrorKind::PermissionDenied => "cli.io.no-access",
        io::ErrorKind::AlreadyExists => "cli.io.exists",
        io::ErrorKind::IsADirectory => "cli.io.folder",
        io::ErrorKind::NotADirectory => "cli.io.no-folder",
        io::ErrorKind::StorageFull => "cli.io.full",
        io::ErrorKind::ReadOnlyFilesystem => "cli.io.read-only",
        _ => return error.to_string(),
    };
    words(common).to_owned()
}

/// The exit status of a command, after the reason for its failure is printed.
pub(crate) fn status(done: Result<(), Failure>) -> ExitCode {
    let (message, status) = match done {
        Ok(()) | Err(Failure::Closed) => return ExitCode::SUCCESS,
        Err(Failure::Reported) => return ExitCode::from(1),
        Err(Failure::Exhausted) => return ExitCode::from(3),
        Err(Failure::Waits) => return ExitCode::from(4),
        Err(Failure::Outside(message)) => (message, 1),
        Err(Failure::Usage(message)) => (message, 2),
    };
    // A closed standard error leaves only the exit status to report the error.
    let _ = print_error(&format!("macroline: {message}\n"));
    ExitCode::from(status)
}

/// Prints text to standard error.
pub(crate) fn print_error(text: &str) -> Result<(), Failure> {
    Ok(io::stderr().write_all(terminal(text).as_bytes())?)
}

/// Standard output, buffered until [`Printer::flush`].
pub(crate) struct Printer(BufWriter<StdoutLock<'static>>);

impl Printer {
    pub(crate) fn new() -> Printer {
        Printer(BufWriter::with_capacity(1 << 16, io::stdout().lock()))
    }

    /// Prints text.
    pub(crate) fn text(&mut self, text: &str) -> Result<(), Failure> {
        Ok(self.0.write_all(terminal(text).as_bytes())?)
    }

    /// Prints JSON.
    pub(crate) fn json(&mut self, json: &Json) -> Result<(), Failure> {
        Ok(writeln!(self.0, "{json:#}")?)
    }

    pub(crate) fn flush(&mut self) -> Result<(), Failure> {
        Ok(self.0.flush()?)
    }
}

/// Prints text to standard output.
pub(crate) fn print(text: &str) -> Result<(), Failure> {
    let mut out = Printer::new();
    out.text(text)?;
    out.flush()
}

/// Prints JSON to standard output.
pub(crate) fn print_json(json: &Json) -> Result<(), Failure> {
    let mut out = Printer::new();
    out.json(json)?;
    out.flush()
}

/// Fails if one of the diagnostics is an error.
pub(crate) fn fail_on_errors(all: &[FileFindings]) -> Result<(), Failure> {
    if has_errors(all) { Err(Failure::Reported) } else { Ok(()) }
}

/// Prints diagnostics and their number to standard error; nothing where there are none.
pub(crate) fn print_findings(all: &[FileFindings]) -> Result<(), Failure> {
    let mut list = Vec::new();
    for findings in all.iter().filter(|findings| !findings.list.is_empty()) {
        let renderer = findings.sources.renderer();
        for finding in &findings.list {
            print_error(&(renderer.text(finding) + "\n"))?;
        }
        list.extend(findings.list.iter().cloned());
    }
    if list.is_empty() { Ok(()) } else { print_error(&(summary(&list) + "\n")) }
}

/// Prints diagnostics.
pub(crate) fn print_diagnostics(format: Format, all: &[FileFindings]) -> Result<(), Failure> {
    match format {
        Format::Text => print_findings(all),
        Format::Json => print_json(&json!({ "diagnostics": list_json(all) })),
        Format::Sarif => print_json(&list_sarif(all)),
    }
}

/// Prints the errors that keep a command from doing anything.
pub(crate) fn refuse(all: &[FileFindings], format: impl Into<Format>) -> Failure {
    print_diagnostics(format.into(), all).err().unwrap_or(Failure::Reported)
}

/// Prints the reason for which a request is refused.
pub(crate) fn refused(why: Refused, format: impl Into<Format>) -> Failure {
    match why {
        Refused::Choice(message) => Failure::usage(&message),
        Refused::Files(all) => refuse(&all, format),
    }
}

/// Prints the number of warnings that were left out.
pub(crate) fn tell_silenced(count: usize) -> Result<(), Failure> {
    if count > 0 { print_error(&(sentence(&msg!("cli.silenced", count = count as u32)) + "\n")) } else { Ok(()) }
}

/// Prints a text that is JSON already.
pub(crate) fn print_data(json: &str) -> Result<(), Failure> {
    let mut out = Printer::new();
    out.0.write_all(json.as_bytes())?;
    out.flush()
}
