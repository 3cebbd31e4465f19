//! The machines: their results against the independent calculation of `docs/reference/sizing.md`, their verdicts, programs and drawings.

mod adding;
mod every_machine;
mod ladder;
mod lathe_stops;
mod polygon;
mod ribbon;
mod slides;
mod spindle_keys;
mod toy;
mod turning;
