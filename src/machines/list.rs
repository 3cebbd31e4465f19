//! The machines, in the order they are listed: adding a machine is one folder and one line here.

use super::machine::{AnyMachine, Erased};
use super::polygon_lathe::PolygonLathe;
use super::ribbon_line::RibbonLine;
use super::turning_spindle::TurningSpindle;

/// All machines.
pub static ALL: &[&dyn AnyMachine] =
    &[&Erased::<RibbonLine>::new(), &Erased::<TurningSpindle>::new(), &Erased::<PolygonLathe>::new()];

/// The machine of an id.
pub fn find(id: &str) -> Option<&'static dyn AnyMachine> {
    ALL.iter().copied().find(|machine| machine.id() == id)
}
