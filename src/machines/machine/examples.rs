//! Named examples of a machine, as data: entries that differ from the defaults of the form, and the verdicts that fail.

/// A named example. The first one of a machine starts a new project: no verdict of it fails on any control of the machine.
#[derive(Debug)]
pub struct Example {
    /// Id, for instance `paper`.
    pub id: &'static str,
    /// Catalog id of the name.
    pub name: &'static str,
    /// Catalog id of the explanation, one or two sentences.
    pub about: &'static str,
    /// Entries that differ from the defaults of the form, as typed: id of each field and its text.
    pub entries: &'static [(&'static str, &'static str)],
    /// Verdicts that fail on a control of the machine, each with its reason.
    pub faults: &'static [KnownFault],
}

/// A verdict of an example that fails.
#[derive(Debug)]
pub struct KnownFault {
    /// Id of the result.
    pub result: &'static str,
    /// Catalog id of the reason.
    pub reason: &'static str,
    /// Whether the verdict fails on every control; otherwise only on slower ones.
    pub everywhere: bool,
}

impl KnownFault {
    /// A fault of the machine itself.
    pub const fn everywhere(result: &'static str, reason: &'static str) -> KnownFault {
        KnownFault { result, reason, everywhere: true }
    }

    /// A fault on controls that are too slow or whose ranges are too small.
    pub const fn on_slow_controls(result: &'static str, reason: &'static str) -> KnownFault {
        KnownFault { result, reason, everywhere: false }
    }
}
