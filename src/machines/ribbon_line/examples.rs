//! Examples of the ribbon line. The defaults of the form are the values of the paper where it has them.

use crate::machines::machine::{Example, KnownFault};

/// A print roller whose heads are a pitch apart, and rollers, gears and speeds that every control of the list can drive.
///
/// The unwinder's gear 50 : 1 keeps F below 15 000 mm/min, the least range of the controls, with the knob at its highest position. The
/// roller of 36 heads at 10 mm has a circumference of 360 mm. The dwell of 0.7 s leaves the least slack after a start.
macro_rules! matched {
    ($($own:expr),* $(,)?) => {
        &[
            ("reduction-ratio", "50"),
            // A roller of 100 mm, and half of the ribbon on each side.
            ("press-roller-diameter", "100.5"),
            ("effective-diameter", "true"),
            ("pitch", "10"),
            ("heads", "36"),
            ("print-roller-diameter", "114.6"),
            ("clamp-y", "20000"),
            ("rapid-y", "20000"),
            ("gear-x", "50"),
            ("gear-y", "50"),
            ("motor-max-y", "5000"),
            // A soft ribbon is drawn with the strain of its tension, and the dots stand closer by it.
            ("tension-before", "0.5"),
            // Without current the unwinder stops about as fast as over its ramp.
            ("unwinder-motor-brake", "0.5"),
            $($own),*
        ]
    };
}

/// Faults of the paper's machine: it has no dancer, one speed for all controls, and a print roller far too large for
/// its number of heads.
const PAPER: &[KnownFault] = &[
    KnownFault::on_slow_controls("vector-feed", "ribbon.example.paper.feed"),
    KnownFault::on_slow_controls("block-time", "ribbon.example.paper.blocks"),
    KnownFault::everywhere("surface-ratio", "ribbon.example.paper.roller"),
    KnownFault::everywhere("smear", "ribbon.example.paper.smear"),
    KnownFault::everywhere("slack-rate", "ribbon.example.paper.slip"),
    KnownFault::everywhere("slack-rate-rated", "ribbon.example.paper.slip-rated"),
    KnownFault::everywhere("loop-needed", "ribbon.example.paper.loop"),
    KnownFault::on_slow_controls("loop-turned", "ribbon.example.paper.turned"),
    KnownFault::everywhere("tension", "ribbon.example.paper.tension"),
    KnownFault::everywhere("loop-coasting", "ribbon.example.paper.coasting"),
];

/// All examples, the first that of a new project.
pub(super) const EXAMPLES: &[Example] = &[
    Example {
        id: "matched",
        name: "ribbon.example.matched",
        about: "ribbon.example.matched.about",
        // The blocks read ahead lay 88 mm when the knob goes from 50 % to its highest position.
        // A turn back takes 36 mm, which the ribbon stretches before the nip has half of what it holds.
        entries: matched![("dancer", "true"), ("dwell", "0.9"), ("loop-capacity", "600"), ("pinch-force", "200")],
        faults: &[],
    },
    Example {
        id: "encoder",
        name: "ribbon.example.encoder",
        about: "ribbon.example.encoder.about",
        entries: matched![("spindle-encoder", "true"), ("feed-form", "per-revolution"), ("dwell", "0")],
        faults: &[],
    },
    Example {
        id: "paper",
        name: "ribbon.example.paper",
        about: "ribbon.example.paper.about",
        entries: &[("pi", "3.14")],
        faults: PAPER,
    },
];
