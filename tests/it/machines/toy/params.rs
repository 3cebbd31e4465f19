//! The form of the cut-to-length feeder, and the parameters that it fills.

use macroline::machines::form::Field;
use macroline::machines::form::common::{self, LineEnds};
use macroline::machines::form::rows::{choice, number};
use macroline::{member, options};

options! {
    /// Motion between two pieces.
    pub(crate) enum Feed {
        /// At the feed of the form.
        Cutting = "cutting" "toy.feed.cutting",
        /// At rapid traverse.
        Rapid = "rapid" "toy.feed.rapid",
    }
}

/// Inputs of the feeder, within the ranges of [`FIELDS`]; units as in the form.
#[derive(Debug, Clone, Default)]
pub(crate) struct Params {
    pub length: f64,
    pub speed: f64,
    pub pieces: f64,
    pub cut_time: f64,
    pub feed: Feed,
    pub clamp: f64,
    pub time_constant: f64,
    pub position_gain: f64,
    pub block_time: f64,
    pub macro_time: f64,
    pub preread: f64,
    pub newline: LineEnds,
}

/// Every input, in the order of the form.
#[rustfmt::skip]
pub(crate) static FIELDS: &[Field<Params>] = &[
    number("length", member!(Params.length)).group("toy.group.product").label("toy.length").help("toy.length.help").symbol("#100")
        .unit("mm").range(0.1..=1000.0).default(50.0).decimals(3).step(1.0).essential(),
    number("speed", member!(Params.speed)).group("toy.group.product").label("toy.speed").help("toy.speed.help").symbol("#101")
        .unit("mm/min").range(1.0..=100000.0).default(3000.0).decimals(0).step(100.0).essential(),
    number("pieces", member!(Params.pieces)).group("toy.group.product").label("toy.pieces").help("toy.pieces.help").symbol("#102")
        .range(1.0..=10000.0).default(4.0).essential(),
    number("cut-time", member!(Params.cut_time)).group("toy.group.product").label("toy.cut-time").help("toy.cut-time.help")
        .unit("s").range(0.01..=60.0).default(0.5).decimals(3).step(0.1),
    choice("feed", member!(Params.feed: Feed)).group("toy.group.product").label("toy.feed").help("toy.feed.help"),
    number("clamp", member!(Params.clamp)).group("toy.group.axis").label("toy.clamp").help("toy.clamp.help")
        .unit("mm/min").range(1.0..=1000000.0).default(10000.0).step(500.0).fact(),
    number("time-constant", member!(Params.time_constant)).group("toy.group.axis").label("toy.time-constant").help("toy.time-constant.help").symbol("τ")
        .unit("ms").range(0.0..=5000.0).default(100.0).decimals(1).step(10.0).fact(),
    number("position-gain", member!(Params.position_gain)).group("toy.group.axis").label("toy.position-gain").help("toy.position-gain.help").symbol("K")
        .unit("1/s").range(1.0..=1000.0).default(33.0).decimals(2).fact(),
    common::block_time("toy.group.control", 5.0, member!(Params.block_time)),
    common::macro_time("toy.group.control", 1.0, member!(Params.macro_time)),
    common::preread("toy.group.control", 2.0, member!(Params.preread)),
    common::newline("toy.group.control", member!(Params.newline: LineEnds)),
];
