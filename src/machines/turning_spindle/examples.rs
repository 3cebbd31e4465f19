//! Examples of the turning spindle. Its source documents describe words and parameters, and have no worked example.

use crate::machines::machine::Example;

/// All examples, the first that of a new project.
///
/// An upper limit of 1800 r/min keeps the spindle's ramp ahead of the surface speed, of a face with the feed override at its highest position,
/// too: `dn/dt ~ f n³ / v`. The motor turns at 3000 r/min with
/// 10 V, twice its base speed. With forced cooling it has the torque for a cut of C45 at the ends of both override knobs.
pub(super) const EXAMPLES: &[Example] = &[
    Example {
        id: "facing",
        name: "turning.example.facing",
        about: "turning.example.facing.about",
        entries: &[
            ("upper-limit", "1800"),
            ("spindle-ramp", "2.5"),
            ("material", "c45"),
            ("motor-top", "3000"),
            ("motor-forced-cooling", "true"),
        ],
        faults: &[],
    },
    Example {
        id: "shaft",
        name: "turning.example.shaft",
        about: "turning.example.shaft.about",
        entries: &[
            ("path", "turning"),
            ("stock-diameter", "60"),
            ("finished-diameter", "50"),
            ("length", "80"),
            ("depth", "2"),
            ("upper-limit", "1800"),
            ("material", "c45"),
            ("motor-power", "11"),
            ("motor-top", "3000"),
            ("motor-forced-cooling", "true"),
        ],
        faults: &[],
    },
    Example {
        id: "keyway",
        name: "turning.example.keyway",
        about: "turning.example.keyway.about",
        entries: &[
            ("path", "turning"),
            ("stock-diameter", "60"),
            ("finished-diameter", "50"),
            ("length", "80"),
            ("depth", "2"),
            ("upper-limit", "1800"),
            ("material", "c45"),
            ("motor-power", "11"),
            ("motor-top", "3000"),
            ("motor-forced-cooling", "true"),
            ("output", "+-10"),
            ("keyway", "true"),
            ("keyway-angle", "90"),
            ("lock-code", "81"),
            ("release-code", "82"),
            ("driven-tool", "true"),
            ("keyway-width", "14"),
            ("keyway-depth", "5.5"),
            ("keyway-start", "10"),
            ("keyway-length", "50"),
        ],
        faults: &[],
    },
    Example {
        id: "taper",
        name: "turning.example.taper",
        about: "turning.example.taper.about",
        entries: &[
            ("path", "taper"),
            ("stock-diameter", "60"),
            ("finished-diameter", "40"),
            ("large-diameter", "50"),
            ("length", "50"),
            ("depth", "2"),
            ("upper-limit", "1800"),
            ("material", "c45"),
            ("motor-power", "11"),
            ("motor-top", "3000"),
            ("motor-forced-cooling", "true"),
        ],
        faults: &[],
    },
];
