//! Answers of a machine (results, program, files, variables, panel), and the control that they apply to.

use crate::controls::{Control, Dialect, Switches};
use crate::nc::{Deck, File, Newline};
use crate::text::Diagnostic;
use crate::view::Readout;

/// The control of a machine, with the settings of its open points.
#[derive(Debug, Clone, Copy)]
pub struct ControlContext<'a> {
    /// The control.
    pub control: &'static Control,
    /// Settings of its open points.
    pub switches: &'a Switches,
}

impl ControlContext<'_> {
    /// The rows of the control under these settings.
    pub fn dialect(&self) -> Dialect {
        Dialect::resolve(self.control, self.switches)
    }
}

/// Results of a machine's formulas, and findings about its values.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Design {
    /// Results with verdicts, in the order they are shown.
    pub readouts: Vec<Readout>,
    /// Invalid fields (errors) and remarks.
    pub diagnostics: Vec<Diagnostic>,
}

/// The program of a machine, before it is written.
#[derive(Debug, Clone, Default)]
pub struct MachineProgram {
    /// Programs, one per file.
    pub deck: Deck,
    /// Number of the program that sets the project's values, run once before the first start; none where the main
    /// program sets them.
    pub setup: Option<u32>,
    /// Number of the program that runs the machine.
    pub main: u32,
    /// Line end of the files.
    pub newline: Newline,
}

/// A file of an export beside programs and sheets.
#[derive(Debug, Clone, PartialEq)]
pub struct MachineFile {
    /// Its name and text.
    pub file: File,
    /// Catalog id of its description.
    pub meaning: &'static str,
}

/// A variable that the operator reads and sets.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct MachineVariable {
    /// Its number.
    pub number: u32,
    /// Catalog id of its meaning.
    pub label: &'static str,
    /// Its unit, or empty.
    pub unit: &'static str,
}

impl MachineVariable {
    /// A variable with the catalog id of its meaning and its unit.
    pub const fn new(number: u32, label: &'static str, unit: &'static str) -> MachineVariable {
        MachineVariable { number, label, unit }
    }
}

/// State of the operator's panel at the start of a run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PanelSetup {
    /// Spindle override (%) at the start of a run; without one the knob is at 100 %.
    pub spindle_override: Option<f64>,
    /// Step (%) of the spindle override's knob.
    pub override_step: f64,
}

impl Default for PanelSetup {
    fn default() -> PanelSetup {
        PanelSetup { spindle_override: None, override_step: 10.0 }
    }
}
