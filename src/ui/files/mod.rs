//! Files in and out: header, opening, saving, the browser's store, export, large files.

mod export;

pub(crate) mod header;

mod large;

pub(crate) mod open;

pub(crate) mod store;

pub(crate) use export::ExportDialog;
pub(crate) use header::Header;
pub(crate) use large::{LargeFile, LargeFileDialog};
