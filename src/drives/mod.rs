//! Engineering shared by machines: analog output, web (strip), a servo's block, induction drive.

pub mod analog;

pub mod web;

pub mod block;

pub mod induction;

pub use analog::Analog;
