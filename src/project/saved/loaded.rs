//! The project that a file gives, with the findings about it, and how large files may be.

use crate::project::Project;
use crate::project::findings::project_file::Findings;
use crate::text::Diagnostic;

/// Bytes of a project file at most. [`MAX_PROGRAM`] bytes of edited programs fit, with each byte escaped.
pub const MAX_BYTES: usize = 16 << 20;

/// Bytes of the edited programs of a project at most.
pub const MAX_PROGRAM: usize = 2_000_000;

/// Edited program files of a project at most.
pub const MAX_PROGRAMS: usize = 64;

/// A project file that was read.
pub struct Loaded {
    /// The project; `None` where the file describes none.
    pub project: Option<Project>,
    /// Findings about the file. Errors with a project: the project has its defaults there.
    pub diagnostics: Vec<Diagnostic>,
}

impl Loaded {
    pub(super) fn refused(found: Findings) -> Loaded {
        Loaded { project: None, diagnostics: found.into_diagnostics() }
    }
}
