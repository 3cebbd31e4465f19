//! Examples of the polygon lathe: the parts that the paper names.

use crate::machines::machine::{Example, KnownFault};

/// All examples, the first that of a new project.
pub(super) const EXAMPLES: &[Example] = &[
    Example {
        id: "square",
        name: "polygon.example.square",
        about: "polygon.example.square.about",
        entries: &[],
        faults: &[],
    },
    Example {
        id: "knob",
        name: "polygon.example.knob",
        about: "polygon.example.knob.about",
        entries: &[("shape", "knob"), ("across-flats", "8"), ("stock-diameter", "12")],
        faults: &[],
    },
    // The sides of a triangle at 3 : 2 deviate by more than 0.1 mm from about 13 mm across flats on; keys of locks are smaller.
    Example {
        id: "triangle-lock",
        name: "polygon.example.triangle",
        about: "polygon.example.triangle.about",
        entries: &[("shape", "triangle"), ("across-flats", "8"), ("stock-diameter", "11")],
        faults: &[],
    },
    Example {
        id: "hexagon-key",
        name: "polygon.example.hexagon",
        about: "polygon.example.hexagon.about",
        entries: &[("shape", "hexagon"), ("across-flats", "10"), ("stock-diameter", "12"), ("length", "30")],
        faults: &[],
    },
    // The paper's own case: a polygon in the middle of a long shaft, in the same clamping.
    Example {
        id: "shaft",
        name: "polygon.example.shaft",
        about: "polygon.example.shaft.about",
        entries: &[("from-face", "40"), ("length", "20"), ("free-length", "80")],
        faults: &[],
    },
    // Another cutter for the other number of sides: three inserts on T2.
    Example {
        id: "square-and-hexagon",
        name: "polygon.example.two",
        about: "polygon.example.two.about",
        entries: &[
            ("second", "true"),
            ("second-shape", "hexagon"),
            ("second-across-flats", "21"),
            ("second-angle", "15"),
            ("second-work-start", "-15"),
            ("second-tool", "2"),
        ],
        faults: &[],
    },
    // Turned, threaded and squared in one clamping, as the paper describes its lathe.
    Example {
        id: "threaded-shaft",
        name: "polygon.example.thread",
        about: "polygon.example.thread.about",
        entries: &[
            ("from-face", "30"),
            ("free-length", "60"),
            // The run-in of the thread.
            ("clearance", "3"),
            ("before", "true"),
            ("before-length", "20"),
            ("before-chamfer", "1"),
            ("before-pitch", "1.75"),
            ("before-thread-length", "16"),
        ],
        faults: &[],
    },
    // O3000 of the paper: G512 B200 D1 Q2 A0. E0., then X20. at F200 in a single pass, which is 1 mm per turn of the work.
    Example {
        id: "paper",
        name: "polygon.example.paper",
        about: "polygon.example.paper.about",
        entries: &[("depth", "2.5"), ("allowance", "0"), ("feed", "1"), ("finish-feed", "1")],
        faults: &[KnownFault::everywhere("tool-torque", "polygon.example.paper.torque")],
    },
];
