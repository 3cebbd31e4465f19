//! macroline sizes special CNC machines, writes the macro program for their control and **runs that very text**.
//!
//! # The arrow
//!
//! ```text
//! form values → Design → Deck (neutral AST) → files (text) → Parsed → Canon → Timeline → Scene / Chart / Report
//! ```
//!
//! A **control** understands an **NC** program; the **interp**reter turns it into **canon**ical commands; **motion** turns
//! commands into a **timeline** of a **machine** built from **drives**; **view**s show it; the **project** is the interface to all of them;
//! the **ui** and the command line are thin shells.
//!
//! Only [`nc::parse`] makes a [`nc::Parsed`], and the interpreter takes nothing else: a generated program reaches the animation
//! only as text that was emitted and parsed again. A pasted or edited program enters the same arrow at `parse`.
//!
//! Two things flow back, both explicit: [`interp::World`] (the program reads positions, PLC inputs, overrides) and places (a time maps to a
//! block, a block to a text range). The modules below are in the order of the flow; each uses only earlier ones.

pub mod math;

pub mod text;

pub mod drives;

pub mod controls;

pub mod nc;

pub mod interp;

pub mod motion;

pub mod view;

pub mod machines;

pub mod project;

#[cfg(feature = "web")]
pub mod ui;
