//! Files in and out: header, opening, saving, the browser's store, export, large files.

mod export;

mod gallery;

pub(crate) mod header;

mod large;

pub(crate) mod open;

mod parts;

mod set_aside;

pub(crate) mod share;

pub(crate) mod store;

pub(crate) use export::ExportDialog;
pub(crate) use gallery::GalleryDialog;
pub(crate) use header::Header;
pub(crate) use large::{LargeFile, LargeFileDialog};
pub(crate) use set_aside::EarlierDialog;
pub(crate) use share::ShareDialog;
