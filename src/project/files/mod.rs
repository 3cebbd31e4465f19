//! Contents of files: bytes in the encoding of a control, JSON with places, checksums; and names of files.

pub(super) mod checksum;
pub mod decode;
pub mod encode;
mod file_names;
pub(super) mod json;
mod json_reason;
