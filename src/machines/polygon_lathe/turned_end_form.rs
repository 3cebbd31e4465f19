//! The form of a turned end: its inputs, and its fields, alike for the end turned before the polygons and for the one turned after them.

use std::ops::{Deref, DerefMut};

use crate::controls::Control;
use crate::machines::form::Field;
use crate::machines::form::rows::{flag, number};

/// Position of a turned end in the program.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) enum TurnedEndPlace {
    /// Before the polygons.
    #[default]
    Before,
    /// After them, at the end of the program.
    After,
}

/// An end of the bar that is turned before or after the polygons, from the face. Units as in the form.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct TurnedEnd {
    pub place: TurnedEndPlace,
    pub on: bool,
    pub diameter: f64,
    pub length: f64,
    pub chamfer: f64,
    pub depth: f64,
    pub feed: f64,
    pub speed: f64,
    pub tool: f64,
    pub pitch: f64,
    pub thread_length: f64,
    pub thread_infeed: f64,
    pub thread_tool: f64,
}

/// The end turned before the polygons and the one turned after them, each with its place.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct TurnedEnds([TurnedEnd; 2]);

impl Default for TurnedEnds {
    fn default() -> TurnedEnds {
        let at = |place| TurnedEnd { place, ..TurnedEnd::default() };
        TurnedEnds([TurnedEndPlace::Before, TurnedEndPlace::After].map(at))
    }
}

impl Deref for TurnedEnds {
    type Target = [TurnedEnd; 2];

    fn deref(&self) -> &[TurnedEnd; 2] {
        &self.0
    }
}

impl DerefMut for TurnedEnds {
    fn deref_mut(&mut self) -> &mut [TurnedEnd; 2] {
        &mut self.0
    }
}

/// Ids of the fields of a turned end.
pub(super) struct TurnedEndFields {
    pub on: &'static str,
    pub diameter: &'static str,
    pub length: &'static str,
    pub chamfer: &'static str,
    pub depth: &'static str,
    pub feed: &'static str,
    pub speed: &'static str,
    pub tool: &'static str,
    pub pitch: &'static str,
    pub thread_length: &'static str,
    pub thread_infeed: &'static str,
    pub thread_tool: &'static str,
}

/// The fields of the turned end whose check mark has the id `$on`.
macro_rules! turned_end_fields {
    ($on:literal) => {
        TurnedEndFields {
            on: $on,
            diameter: concat!($on, "-diameter"),
            length: concat!($on, "-length"),
            chamfer: concat!($on, "-chamfer"),
            depth: concat!($on, "-depth"),
            feed: concat!($on, "-feed"),
            speed: concat!($on, "-speed"),
            tool: concat!($on, "-tool"),
            pitch: concat!($on, "-pitch"),
            thread_length: concat!($on, "-thread-length"),
            thread_infeed: concat!($on, "-thread-infeed"),
            thread_tool: concat!($on, "-thread-tool"),
        }
    };
}

/// Fields of the end turned before the polygons, and of the one turned after them.
pub(super) const TURNED_ENDS: [TurnedEndFields; 2] = [turned_end_fields!("before"), turned_end_fields!("after")];

/// A form with an end turned before the polygons and one turned after them.
pub(super) trait TurnedEndForm {
    fn turned_ends(&self) -> &[TurnedEnd; 2];

    fn turned_ends_mut(&mut self) -> &mut [TurnedEnd; 2];
}

/// The member of a turned end that a row fills.
macro_rules! turned_end {
    ($at:ident.$member:ident) => {
        (|p: &P| p.turned_ends()[$at].$member, |p: &mut P, value| p.turned_ends_mut()[$at].$member = value)
    };
}

/// A row for a number of a turned end, with the catalog ids of its label and its help.
macro_rules! row {
    ($at:ident.$member:ident, $label:literal, $help:literal) => {
        number(TURNED_ENDS[$at].$member, turned_end!($at.$member)).group(GROUPS[$at]).label($label).help($help)
    };
}

/// Groups of the fields, and labels and helps of the check marks.
const GROUPS: [&str; 2] = ["polygon.group.before", "polygon.group.after"];
const MARKS: [&str; 2] = ["polygon.before", "polygon.after"];
const HELPS: [&str; 2] = ["polygon.before.help", "polygon.after.help"];

/// Check mark and rows of the turned end `AT`.
#[rustfmt::skip]
pub(super) const fn rows<P: TurnedEndForm, const AT: usize>() -> [Field<P>; 12] {
    [
    flag(TURNED_ENDS[AT].on, turned_end!(AT.on)).group(GROUPS[AT]).label(MARKS[AT]).help(HELPS[AT]),
    row!(AT.diameter, "polygon.turned-end.diameter", "polygon.turned-end.diameter.help").unit("mm").range(0.5..=1000.0).default(12.0).decimals(3).step(0.5).when(turns::<P, AT>),
    row!(AT.length, "polygon.turned-end.length", "polygon.turned-end.length.help").unit("mm").range(0.1..=2000.0).default(10.0).decimals(3).step(1.0).when(turns::<P, AT>),
    row!(AT.chamfer, "polygon.turned-end.chamfer", "polygon.turned-end.chamfer.help").unit("mm").range(0.0..=50.0).default(0.0).decimals(3).step(0.5).when(turns::<P, AT>),
    row!(AT.depth, "polygon.turned-end.depth", "polygon.turned-end.depth.help").unit("mm").range(0.01..=50.0).default(2.0).decimals(3).step(0.1).when(turns::<P, AT>),
    row!(AT.feed, "polygon.turned-end.feed", "polygon.turned-end.feed.help").unit("mm/rev").range(0.001..=10.0).default(0.2).decimals(3).step(0.05).when(turns::<P, AT>),
    row!(AT.speed, "polygon.turned-end.speed", "polygon.turned-end.speed.help").symbol("S").unit("r/min").range(1.0..=9999.0).default(800.0).decimals(0).step(50.0).when(turns::<P, AT>),
    row!(AT.tool, "polygon.turned-end.tool", "polygon.turned-end.tool.help").symbol("T").range(1.0..=99.0).default(3.0).decimals(0).step(1.0).when(turns::<P, AT>),
    row!(AT.pitch, "polygon.turned-end.pitch", "polygon.turned-end.pitch.help").symbol("P").unit("mm").range(0.0..=12.0).default(0.0).decimals(3).step(0.25).when(turns::<P, AT>),
    row!(AT.thread_length, "polygon.turned-end.thread-length", "polygon.turned-end.thread-length.help").unit("mm").range(0.1..=2000.0).default(8.0).decimals(3).step(1.0).when(threads::<P, AT>),
    row!(AT.thread_infeed, "polygon.turned-end.thread-infeed", "polygon.turned-end.thread-infeed.help").unit("mm").range(0.01..=5.0).default(0.25).decimals(3).step(0.05).when(threads::<P, AT>),
    row!(AT.thread_tool, "polygon.turned-end.thread-tool", "polygon.turned-end.thread-tool.help").symbol("T").range(1.0..=99.0).default(4.0).decimals(0).step(1.0).when(threads::<P, AT>),
    ]
}

/// Whether the end is turned.
fn turns<P: TurnedEndForm, const AT: usize>(p: &P, _: &Control) -> bool {
    p.turned_ends()[AT].on
}

/// Whether the turned end has a thread.
fn threads<P: TurnedEndForm, const AT: usize>(p: &P, _: &Control) -> bool {
    p.turned_ends()[AT].on && p.turned_ends()[AT].pitch > 0.0
}
