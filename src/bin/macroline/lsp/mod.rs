//! A language server on standard input and output: what `check` says, and the tables of the control, in an editor.

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
use server::{Server, State};
use setup::Setup;
use wire::Frame;

/// Serves one client until it ends. Control, project, switches and silenced warnings are those of the command line.
pub(crate) fn serve(
    id: Option<&str>,
    project: Option<&Path>,
    switches: &[String],
    silenced: &[String],
) -> Result<(), Failure> {
    let mut server = Server::new(Setup::asked(id, project, &input::choices(switches, silenced)?)?);
    let (mut input, mut output) = (BufReader::new(io::stdin().lock()), io::stdout().lock());
    loop {
        match wire::read(&mut input)? {
            Frame::Message(message) => server.take(message),
            Frame::Malformed(why) => wire::write_refusal(&mut output, &why)?,
            Frame::End => return Err(Failure::Told),
        }
        for message in server.sends() {
            message.write(&mut output)?;
        }
        output.flush()?;
        match server.state() {
            State::Ended { after_shutdown: true } => return Ok(()),
            State::Ended { after_shutdown: false } => return Err(Failure::Told),
            _ => {}
        }
    }
}
