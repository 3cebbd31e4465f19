//! Checksum of files and links: CRC-32, as in ZIP archives and PNG pictures.

use crc::{CRC_32_ISO_HDLC, Crc, NoTable};

/// CRC-32 of bytes, computed without a table: files are short, and a table would enlarge the module.
pub(in crate::project) fn crc32(bytes: &[u8]) -> u32 {
    Crc::<u32, NoTable>::new(&CRC_32_ISO_HDLC).checksum(bytes)
}
