//! Tabs with everything that follows from the project: results, sizing, explorer, variables, parameters, PLC.

mod explore;
mod parameters;
mod readouts;
mod repair;
mod sizing;
mod take;
mod variables;
mod variants;

pub(crate) use explore::ExploreTab;
pub(crate) use parameters::{ParametersTab, PlcTab};
pub(crate) use readouts::ResultsTab;
pub(crate) use sizing::SizingTab;
pub(crate) use variables::VariablesTab;
