//! The form of a further polygon: its inputs, and its fields, alike for the second and for the third polygon of a part.

use super::shape::Shape;
use crate::controls::Control;
use crate::machines::form::Field;
use crate::machines::form::rows::{choice, flag, number};

/// A second or third polygon of the part. Units as in the form.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Further {
    pub on: bool,
    pub shape: Shape,
    pub sides: f64,
    pub across_flats: f64,
    pub from_face: f64,
    pub length: f64,
    pub angle: f64,
    pub inserts: f64,
    pub work_ratio: f64,
    pub tool_ratio: f64,
    pub work_start: f64,
    pub tool_start: f64,
    pub tool: f64,
    /// Tip radius of its cutter, mm; 0: that of the first polygon's cutter.
    pub tip_radius: f64,
}

/// Ids of the fields of a further polygon.
pub(super) struct FurtherFields {
    pub on: &'static str,
    pub shape: &'static str,
    pub sides: &'static str,
    pub across_flats: &'static str,
    pub from_face: &'static str,
    pub length: &'static str,
    pub angle: &'static str,
    pub inserts: &'static str,
    pub work_ratio: &'static str,
    pub tool_ratio: &'static str,
    pub work_start: &'static str,
    pub tool_start: &'static str,
    pub tool: &'static str,
    pub tip_radius: &'static str,
}

/// The fields of the further polygon whose check mark has the id `$on`.
macro_rules! further_fields {
    ($on:literal) => {
        FurtherFields {
            on: $on,
            shape: concat!($on, "-shape"),
            sides: concat!($on, "-sides"),
            across_flats: concat!($on, "-across-flats"),
            from_face: concat!($on, "-from-face"),
            length: concat!($on, "-length"),
            angle: concat!($on, "-angle"),
            inserts: concat!($on, "-inserts"),
            work_ratio: concat!($on, "-work-ratio"),
            tool_ratio: concat!($on, "-tool-ratio"),
            work_start: concat!($on, "-work-start"),
            tool_start: concat!($on, "-tool-start"),
            tool: concat!($on, "-tool"),
            tip_radius: concat!($on, "-tip-radius"),
        }
    };
}

/// Fields of the second and of the third polygon.
pub(super) const FURTHER: [FurtherFields; 2] = [further_fields!("second"), further_fields!("third")];

impl FurtherFields {
    /// The field that corresponds to one of the first polygon; none where all polygons share the first one's.
    pub(super) fn counterpart(&self, first: &str) -> Option<&'static str> {
        Some(match first {
            "shape" => self.shape,
            "sides" => self.sides,
            "across-flats" => self.across_flats,
            "from-face" => self.from_face,
            "length" => self.length,
            "inserts" => self.inserts,
            "work-ratio" => self.work_ratio,
            "tool-ratio" => self.tool_ratio,
            "work-start" => self.work_start,
            "tool-start" => self.tool_start,
            "tip-radius" => self.tip_radius,
            // One overhang for all cutters.
            "overhang" => "overhang",
            _ => return None,
        })
    }
}

/// A form with a second and a third polygon.
pub(super) trait FurtherForm {
    fn further_polygons(&self) -> &[Further; 2];

    fn further_polygons_mut(&mut self) -> &mut [Further; 2];
}

/// The member of a further polygon that a row fills.
macro_rules! further {
    ($at:ident.$member:ident) => {
        (|p: &P| p.further_polygons()[$at].$member, |p: &mut P, value| p.further_polygons_mut()[$at].$member = value)
    };
    ($at:ident.$member:ident: $choice:ident) => {
        (
            $choice::OPTIONS,
            (
                |p: &P| p.further_polygons()[$at].$member as usize,
                |p: &mut P, at| p.further_polygons_mut()[$at].$member = $choice::at(at),
            ),
        )
    };
}

/// A row for a number of a further polygon, with the catalog ids of its label and its help.
macro_rules! row {
    ($at:ident.$member:ident, $label:literal, $help:literal) => {
        number(FURTHER[$at].$member, further!($at.$member)).group(GROUPS[$at]).label($label).help($help)
    };
}

/// Groups of the fields, labels and helps of the check marks, and default distances from the face (mm).
const GROUPS: [&str; 2] = ["polygon.group.second", "polygon.group.third"];
const MARKS: [&str; 2] = ["polygon.second", "polygon.third"];
const HELPS: [&str; 2] = ["polygon.second.help", "polygon.third.help"];
const FROM_FACE: [f64; 2] = [30.0, 60.0];

/// Check mark and rows of the further polygon `AT`.
#[rustfmt::skip]
pub(super) const fn rows<P: FurtherForm, const AT: usize>() -> [Field<P>; 14] {
    [
    flag(FURTHER[AT].on, further!(AT.on)).group(GROUPS[AT]).label(MARKS[AT]).help(HELPS[AT]).when(is_offered::<P, AT>),
    choice(FURTHER[AT].shape, further!(AT.shape: Shape)).group(GROUPS[AT]).label("polygon.shape").help("polygon.shape.help").when(is_on::<P, AT>),
    row!(AT.sides, "polygon.sides", "polygon.sides.help").symbol("N").range(1.0..=100.0).default(6.0).decimals(0).step(1.0).when(is_own::<P, AT>),
    row!(AT.across_flats, "polygon.across-flats", "polygon.across-flats.help").symbol("AF").unit("mm").range(0.5..=500.0).default(20.0).decimals(3).step(0.5).when(is_on::<P, AT>),
    row!(AT.from_face, "polygon.from-face", "polygon.from-face.help").symbol("Z").unit("mm").range(0.0..=2000.0).default(FROM_FACE[AT]).decimals(3).step(1.0).when(is_on::<P, AT>),
    row!(AT.length, "polygon.length", "polygon.length.help").unit("mm").range(0.1..=2000.0).default(15.0).decimals(3).step(1.0).when(is_on::<P, AT>),
    row!(AT.angle, "polygon.angle", "polygon.angle.help").symbol("ψ").unit("°").range(-359.999..=359.999).default(0.0).decimals(3).step(5.0).when(is_on::<P, AT>),
    row!(AT.inserts, "polygon.inserts", "polygon.inserts.help").symbol("n").range(1.0..=50.0).default(2.0).decimals(0).step(1.0).when(is_own::<P, AT>),
    row!(AT.work_ratio, "polygon.work-ratio", "polygon.work-ratio.help").symbol("D").range(-99.0..=99.0).default(1.0).decimals(0).step(1.0).when(is_own::<P, AT>),
    row!(AT.tool_ratio, "polygon.tool-ratio", "polygon.tool-ratio.help").symbol("Q").range(-99.0..=99.0).default(3.0).decimals(0).step(1.0).when(is_own::<P, AT>),
    row!(AT.work_start, "polygon.work-start", "polygon.work-start.help").symbol("A").unit("°").range(-359.999..=359.999).default(0.0).decimals(3).step(5.0).when(is_on::<P, AT>),
    row!(AT.tool_start, "polygon.tool-start", "polygon.tool-start.help").symbol("E").unit("°").range(-359.999..=359.999).default(0.0).decimals(3).step(5.0).when(is_on::<P, AT>),
    row!(AT.tool, "polygon.tool", "polygon.tool.help").symbol("T").range(1.0..=99.0).default(1.0).decimals(0).step(1.0).when(is_on::<P, AT>),
    row!(AT.tip_radius, "polygon.tip-radius", "polygon.other-tip-radius.help").symbol("r").unit("mm").range(0.0..=1000.0).default(0.0).decimals(3).step(1.0).when(is_on::<P, AT>),
    ]
}

/// Whether the part has the polygons before this one.
fn is_offered<P: FurtherForm, const AT: usize>(p: &P, _: &Control) -> bool {
    p.further_polygons().iter().take(AT).all(|further| further.on)
}

/// Whether the part has this polygon.
fn is_on<P: FurtherForm, const AT: usize>(p: &P, _: &Control) -> bool {
    p.further_polygons().iter().take(AT + 1).all(|further| further.on)
}

/// Whether inserts and ratio of this polygon are typed in the form.
fn is_own<P: FurtherForm, const AT: usize>(p: &P, control: &Control) -> bool {
    is_on::<P, AT>(p, control) && p.further_polygons()[AT].shape == Shape::Own
}
