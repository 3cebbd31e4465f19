//! English.

mod form;
mod interp;
mod lint;
mod motion;
mod nc;
mod page;
mod project;
mod ribbon;

/// All areas, each a file of rows.
pub(super) const AREAS: &[&[(&str, &str)]] =
    &[nc::ROWS, lint::ROWS, interp::ROWS, motion::ROWS, form::ROWS, ribbon::ROWS, project::ROWS, page::ROWS];
