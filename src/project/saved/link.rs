//! A project as the fragment of a link: its file, compressed, with a checksum, in characters that an address may have.

use base64::Engine;
use base64::engine::general_purpose::URL_SAFE_NO_PAD;
use miniz_oxide::deflate::compress_to_vec;
use miniz_oxide::inflate::{decompress_to_vec_with_limit, decompress_to_vec_zlib_with_limit};

use super::super::Project;
use super::super::files::checksum::crc32;
use super::super::findings::project_file::Findings;
use super::Loaded;
use crate::msg;
use crate::text::{Diagnostic, Message};

/// Prefix of a fragment that carries a project; the number of the form follows.
const PROJECT: &str = "p";

/// Prefix of a fragment of the form that is written: CRC-32 of what follows it (4 bytes, the highest first), then the file as a deflate
/// stream (RFC 1951); both as base64url text without padding (RFC 4648, 5).
const FORM: &str = "p2.";

/// Prefix of the first form, which is still read: the file as zlib data (RFC 1950). Their checksum, Adler-32, misses some changes of one
/// character: a changed code of the compression changes the same two letters wherever they are next to each other.
const FIRST_FORM: &str = "p1.";

/// Longest fragment, in characters. Our choice: browsers take more, mail and chat programs less.
pub const MAX_LINK: usize = 8000;

/// Largest unpacked file, in bytes: short texts may unpack to very long ones.
const MAX_FILE: usize = 1_000_000;

/// The most thorough compression: a link is made once, and read often.
const LEVEL: u8 = 9;

/// Whether the fragment of an address, without its `#`, is meant as a project.
pub fn is_link(fragment: &str) -> bool {
    let number = fragment.strip_prefix(PROJECT).and_then(|rest| rest.split_once('.'));
    number.is_some_and(|(number, _)| !number.is_empty() && number.bytes().all(|byte| byte.is_ascii_digit()))
}

impl Project {
    /// The project as the fragment of a link, without its `#`. An error where it is too long for one.
    pub fn to_link(&self) -> Result<String, Message> {
        // Keys are texts and writing into a text does not fail.
        let file = serde_json::to_string(&self.saved()).unwrap_or_default();
        let link = format!("{FORM}{}", packed(&file));
        if link.len() > MAX_LINK || file.len() > MAX_FILE {
            return Err(msg!("project.link-long", count = link.len() as u32, most = MAX_LINK as u32));
        }
        Ok(link)
    }

    /// Reads the fragment of a link. Total: any text gives a project, or a diagnostic with the reason for none.
    pub fn from_link(fragment: &str) -> Loaded {
        let mut loaded = match unpacked(fragment) {
            Ok(file) => Project::from_json(&file),
            Err(message) => {
                let mut found = Findings::new("");
                found.error(message, "");
                Loaded::refused(found)
            }
        };
        // Places point into the packed file, which is never shown.
        loaded.diagnostics.iter_mut().for_each(|finding: &mut Diagnostic| finding.place = None);
        loaded
    }
}

/// A file in the form that is written, without the prefix.
fn packed(file: &str) -> String {
    let deflated = compress_to_vec(file.as_bytes(), LEVEL);
    let check_sum = crc32(&deflated).to_be_bytes();
    URL_SAFE_NO_PAD.encode([&check_sum, deflated.as_slice()].concat())
}

/// The file in a fragment.
fn unpacked(fragment: &str) -> Result<String, Message> {
    if fragment.len() > MAX_LINK {
        return Err(msg!("project.link-oversized", count = fragment.len() as u32, most = MAX_LINK as u32));
    }
    let file = if let Some(data) = fragment.strip_prefix(FORM) {
        file_of(data, inflated)
    } else if let Some(data) = fragment.strip_prefix(FIRST_FORM) {
        file_of(data, |packed| decompress_to_vec_zlib_with_limit(packed, MAX_FILE).ok())
    } else {
        return Err(msg!("project.link-newer"));
    };
    file.ok_or_else(|| msg!("project.link-broken"))
}

/// The file in the data after a prefix.
fn file_of(data: &str, unpack: impl FnOnce(&[u8]) -> Option<Vec<u8>>) -> Option<String> {
    let packed = URL_SAFE_NO_PAD.decode(data).ok()?;
    String::from_utf8(unpack(&packed)?).ok()
}

/// The bytes of a deflate stream that follows its checksum.
fn inflated(packed: &[u8]) -> Option<Vec<u8>> {
    let (check_sum, deflated) = packed.split_first_chunk()?;
    let is_whole = crc32(deflated) == u32::from_be_bytes(*check_sum);
    is_whole.then(|| decompress_to_vec_with_limit(deflated, MAX_FILE).ok())?
}
