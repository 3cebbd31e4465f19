//! Messages of JSON-RPC with their headers, from an input that need not follow the protocol.

use std::io::{self, BufRead, Read as _, Write};

use lsp_server::Message;
use macroline::msg;
use macroline::text::catalog::sentence;

/// Bytes of a message at most; the text of a file is one of its parts.
pub(super) const MOST: u64 = 64 << 20;

/// Bytes of a line of a header at most.
const HEADER: u64 = 4096;

/// Name of the header with the length of a message in bytes.
const LENGTH: &str = "content-length:";

/// Outcome of reading the next message.
pub(super) enum MessageRead {
    /// A message.
    Message(Message),
    /// Not a message of the protocol, and the reason; later messages may be valid.
    Malformed(String),
    /// Nothing more.
    End,
}

/// Reads the next message. Lines that are not headers are skipped, so that a wrong length loses only the messages around it.
pub(super) fn read(input: &mut impl BufRead) -> io::Result<MessageRead> {
    let mut length = None;
    let mut line = Vec::new();
    loop {
        line.clear();
        if input.by_ref().take(HEADER).read_until(b'\n', &mut line)? == 0 {
            return Ok(MessageRead::End);
        }
        let header = String::from_utf8_lossy(&line).trim().to_ascii_lowercase();
        match (header.as_str(), length) {
            ("", Some(length)) => return body(input, length),
            (header, _) => {
                let bytes = header.strip_prefix(LENGTH).and_then(|digits| digits.trim().parse::<u64>().ok());
                length = bytes.or(length);
            }
        }
    }
}

/// Reads a message of a length.
fn body(input: &mut impl BufRead, length: u64) -> io::Result<MessageRead> {
    let mut part = input.take(length);
    if length > MOST {
        io::copy(&mut part, &mut io::sink())?;
        return Ok(MessageRead::Malformed(sentence(&msg!("lsp.too-long", most = MOST as u32))));
    }
    let mut bytes = Vec::new();
    part.read_to_end(&mut bytes)?;
    if (bytes.len() as u64) < length {
        return Ok(MessageRead::End);
    }
    Ok(match serde_json::from_slice(&bytes) {
        Ok(message) => MessageRead::Message(message),
        Err(error) => MessageRead::Malformed(sentence(&msg!("lsp.not-a-message", reason = error.to_string()))),
    })
}

/// Writes the error for input that is not a message; it has no request number.
pub(super) fn write_refusal(output: &mut impl Write, why: &str) -> io::Result<()> {
    let error = serde_json::json!({ "code": lsp_server::ErrorCode::ParseError as i32, "message": why });
    let text = serde_json::json!({ "jsonrpc": "2.0", "id": null, "error": error }).to_string();
    write!(output, "Content-Length: {}\r\n\r\n{text}", text.len())?;
    output.flush()
}
