//! Sentences about projects, files, links and the command line.

/// `(id, sentence)`.
pub(super) const ROWS: &[(&str, &str)] = &[
    ("project.form-restored", "{0} was written by macroline: the form is as it was then."),
    (
        "project.form-restored-edited",
        "{0} was written by macroline and edited since: the form is as it was then, the edited text is kept.",
    ),
    ("project.newer", "The file has version {0}; this macroline reads up to version {1}. Take a newer macroline."),
    ("project.no-control", "The file names no control that this machine goes with. Possible: {0}."),
    ("project.no-machine", "The file names no machine that is known. Possible: {0}."),
    ("project.no-version", "The file has no version of a macroline project."),
    ("project.not-a-project", "This is not a macroline project."),
    ("project.not-json", "Line {0}, column {1}: this is not JSON ({2})."),
    ("project.panel-no-time", "Panel entry {0} has no time: { \"t\": seconds, … } with 0 or more seconds."),
    ("project.panel-not-a-list", "A panel is a list: [ { \"t\": 0, \"spindle_override\": 80 }, … ]."),
    ("project.panel-too-long", "A panel has at most {0} entries; the others were left out."),
    ("project.panel-unknown", "Panel entry {0}: “{1}” is no action of the panel, or its value does not fit."),
    (
        "project.program-too-large",
        "The program has {0} MB; a project takes programs up to {1} MB. It can be looked at, not edited.",
    ),
    ("project.too-large", "The file has {0} MB; a project has at most {1} MB."),
    ("project.unknown-field", "The machine has no field “{0}”; it was left out."),
    ("project.unknown-switch", "The control has no switch “{0}” with this setting; it was left out."),
    ("project.wrong-kind", "Field “{0}”: {1} is not what belongs there; the default is taken."),
];
