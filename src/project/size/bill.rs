//! The bill of materials of the drives: for each axis the motor that the form names or the smallest that passes, best with a known amplifier, and the control.

use super::choice::{SizedAxis, name, named};
use crate::drives::parts::{Part, PartGrade};
use crate::project::Project;
use crate::text::catalog::number_text;

/// A row of the bill.
#[derive(Debug, Clone, PartialEq)]
pub struct BillRow {
    /// Catalog id of what it is: a motor, an amplifier.
    pub item: &'static str,
    /// Catalog id of the axis that it is for; none of the control.
    pub axis: Option<&'static str>,
    /// Maker and model.
    pub part: String,
    /// How many.
    pub quantity: u32,
    /// How well it is known; none of the control, which the project names.
    pub grade: PartGrade,
}

/// The rows. An axis without a motor that passes has none; the list of its motors says why.
pub(super) fn bill(project: &Project, axes: &[SizedAxis]) -> Vec<BillRow> {
    let control = BillRow {
        item: "size.item.control",
        axis: None,
        part: project.control.name.to_owned(),
        quantity: 1,
        grade: PartGrade::Entered,
    };
    let drives = axes.iter().flat_map(|axis| of_axis(project, axis).into_iter().chain(brake(axis)));
    core::iter::once(control).chain(drives).collect()
}

/// The brake at the motor of an axis.
fn brake(axis: &SizedAxis) -> Option<BillRow> {
    let part = format!("{} Nm", number_text(axis.brake, 2));
    let row = BillRow { item: "size.item.brake", axis: Some(axis.name), part, quantity: 1, grade: PartGrade::Entered };
    (axis.brake > 0.0).then_some(row)
}

fn of_axis(project: &Project, axis: &SizedAxis) -> Vec<BillRow> {
    let row = |item, part: String, grade| BillRow { item, axis: Some(axis.name), part, quantity: 1, grade };
    let of = |item, part: &Part| row(item, part.name(), part.evidence.grade);
    let is_servo = axis.work.is_some();
    let amplifier = if is_servo { "size.item.amplifier" } else { "size.item.inverter" };
    let typed = axis.field.and_then(|field| named(project, field));
    let known = axis.candidates.iter().find(|candidate| Some(name(&candidate.part)) == typed);
    match (known, typed) {
        // The motor of the form is not in the catalogue.
        (None, Some(typed)) => vec![row("size.item.motor", typed, PartGrade::Entered)],
        (chosen, _) => {
            let Some(chosen) = chosen.or_else(|| axis.ordered()) else { return Vec::new() };
            let motor = of("size.item.motor", &chosen.part);
            [motor].into_iter().chain(chosen.amplifier.as_ref().map(|part| of(amplifier, part))).collect()
        }
    }
}
