//! A machine with its values on a control: results, program, plant, PLC and sheets.

use super::design::{Design, MachineFile, MachineProgram, MachineVariable, PanelSetup};

use super::drawn::DrawnMachine;
use super::driven::DrivenMachine;
use crate::machines::ladder::Ladder;
use crate::motion::{Plant, Plc};
use crate::text::Message;
use crate::view::{Explorer, Sheet};

/// A machine with its values on a control: results, program, and the plant and PLC that run it. All functions are
/// total.
pub trait Prepared: DrawnMachine + DrivenMachine + Send + Sync {
    /// Results with verdicts, and the machine's own findings.
    fn results(&self) -> Design;
    /// Opening sentence of the report: the machine's work with these results; none if it cannot work with these values.
    fn summary(&self) -> Option<Message> {
        None
    }
    /// The program.
    fn program(&self) -> MachineProgram;
    /// The plant that runs the program.
    fn plant(&self) -> Plant;
    /// The builder's PLC.
    fn plc(&self) -> Box<dyn Plc>;
    /// Names of the axes that the PLC moves, in the order of [`Plant::pmc`].
    fn turned_axes(&self) -> &'static [&'static str] {
        &[]
    }
    /// The ladder of the builder's PLC, if there is one.
    fn ladder(&self) -> Option<Ladder> {
        None
    }
    /// State of the operator's panel at the start of a run.
    fn panel(&self) -> PanelSetup {
        PanelSetup::default()
    }
    /// Variables that the operator reads and sets.
    fn variables(&self) -> Vec<MachineVariable>;
    /// Parameter sheet, interface, ladder list.
    fn sheets(&self) -> Vec<Sheet>;
    /// Files of an export beside programs and sheets: drawings, programs in other codes.
    fn files(&self) -> Vec<MachineFile> {
        Vec::new()
    }
    /// Catalog ids of the names of the shapes that can be explored; see [`MachineInfo::explores`].
    fn explored(&self) -> Vec<&'static str> {
        Vec::new()
    }
    /// Sliders with their drawing for the shape at this index of [`explored`](Prepared::explored).
    fn explorer(&self, _shape: usize) -> Option<Explorer> {
        None
    }
}
