//! The machines: their numbers against the independent oracle (`sizing_check.py`), their verdicts, their programs.

mod adding;
mod drawn;
mod examples;
mod look;
mod polygon;
mod polygon_drawing;
mod polygon_sheets;
mod remedy;
mod ribbon_controls;
mod ribbon_endless;
mod ribbon_knob;
mod ribbon_line;
mod ribbon_program;
mod ribbon_stops;
mod ribbon_synchronism;
mod scenes;
mod sensitivity;
mod standstill;
mod sweep;
mod toy;
mod turning;
mod turning_controls;
mod turning_drawing;
mod turning_restart;
mod verdicts;
mod written;
