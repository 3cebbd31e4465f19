//! A language server on standard input and output: the findings of `check` and the tables of the control, in an editor.

mod answers;
mod convert;
mod documents;
mod findings;
mod server;
mod setup;
mod wire;

use std::io::{self, BufReader, Write as _};
use std::path::Path;

use crate::input;
use crate::output::Failure;
use server::{Server, SessionPhase};
use setup::ControlSetup;
use wire::MessageRead;

/// Serves one client until it ends. Control, project, switches and silenced warnings are those of the command line.
pub(crate) fn serve(
    id: Option<&str>,
    project: Option<&Path>,
    switches: &[String],
    silenced: &[String],
) -> Result<(), Failure> {
    let mut server = Server::new(ControlSetup::asked(id, project, &input::choices(switches, silenced)?)?);
    let (mut input, mut output) = (BufReader::new(io::stdin().lock()), io::stdout().lock());
    loop {
        match wire::read(&mut input)? {
            MessageRead::Message(message) => server.take(message),
            MessageRead::Malformed(why) => wire::write_refusal(&mut output, &why)?,
            MessageRead::End => return Err(Failure::Reported),
        }
        for message in server.sends() {
            message.write(&mut output)?;
        }
        output.flush()?;
        match server.phase() {
            SessionPhase::Ended { after_shutdown: true } => return Ok(()),
            SessionPhase::Ended { after_shutdown: false } => return Err(Failure::Reported),
            _ => {}
        }
    }
}
