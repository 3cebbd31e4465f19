//! Families of controls as consts: a control takes the rows of its family and states the differences.
//!
//! A family is not in the list of controls. Its rows have their own citations; a control without evidence for them uses the rows under its
//! own citation.

pub mod fanuc;

pub mod sinumerik;

pub mod drives;
