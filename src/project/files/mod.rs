//! Contents of files: bytes in the encoding of a control, JSON with places, checksums; and names of files.

mod json_reason;

pub(super) mod json;

mod file_names;

pub(super) mod checksum;

pub mod encode;

pub mod decode;
