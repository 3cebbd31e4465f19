//! Families of controls as consts: a control takes the rows of its family and states the differences.
//!
//! A family has no entry in the list of controls. Its rows carry a citation of their own; a control that cannot vouch for them
//! takes them under its own citation.

pub mod fanuc;

pub mod sinumerik;

pub mod drives;
