//! A report: title block, drawing, verdicts, results with formulas, inputs with their origin, run, programs, sheets, and open points.

mod document;

mod cells;

mod conclusion;

mod references;

mod markdown;

mod html;

pub use document::{
    Figure, Input, ListedPart, OpenFacts, OpenPoints, OpenSetting, PrintedProgram, Report, RunReport, SizingReport,
    TitleBlock,
};
pub use html::{html, summary};
pub use markdown::markdown;
