//! Files in and out: header, opening, saving, the browser's store, export, large files.

mod export;
mod gallery;
pub(crate) mod header;
mod large;
mod latest;
pub(crate) mod offline;
pub(crate) mod open;
mod parts;
mod print;
mod projects;
mod set_aside;
pub(crate) mod share;
mod shelf;
pub(crate) mod store;
mod title_block;

pub(crate) use export::ExportDialog;
pub(crate) use gallery::GalleryDialog;
pub(crate) use header::Header;
pub(crate) use large::{LargeFile, LargeFileDialog};
pub(crate) use projects::ProjectsDialog;
pub(crate) use share::ShareDialog;
